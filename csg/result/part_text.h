// Parts of a result in words: cells, the leaves that they came from, coordinates and distances.
#pragma once

#include <string>

#include "csg/result/near.h"

namespace cnrg {

/// `bolt`, or `bolt, fault`: the leaves that a cell came from; `nothing active` if there are none.
std::string names_of_leaves(const ResultView& view, const FlatComplex::Provenance& origin);
/// `v3`, `e0`, `f2`: the cell as `cnrg locate` names it.
std::string name_of(const Parts::Cell& cell);
const FlatComplex::Provenance& origin_of(const FlatComplex& flat, const Parts::Cell& cell);
/// The cells that a pair is of.
std::array<Parts::Cell, 2> cells_of(const Parts& parts, Near kind, Parts::Index a, Parts::Index b);
/// `point v3 of bolt and face f2 of fault`; without `numbered`, `point of bolt and face of fault`.
std::string text_of(const ResultView& view, const Parts& parts, Near kind, Parts::Index a, Parts::Index b,
                    bool numbered);

/// `(0.5, 1/3, ~1.23456789012)`: decimals or fractions that are the coordinates, where these are no longer than 17
/// characters; else a decimal that is near, behind a `~`.
std::string coordinates(const RationalPoint& p);
/// The double nearest to a distance, by its square.
std::string distance_text(const Rational& squared);

}  // namespace cnrg
