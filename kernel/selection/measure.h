// Exact lengths, areas and volumes of cells, and Euler's formula.
//
// Volumes are rational. Lengths and areas are square roots of rationals: the squares are exact, `square_root`
// gives as many digits as asked for. Nothing is cached and nothing is computed before it is asked for.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "kernel/selection/selection.h"

namespace cnrg {

/// The square of an edge's length.
Rational squared_length(const Complex& complex, EdgeId e);
/// The vector along the front normal of the face whose length is the face's area (holes taken off).
RationalPoint area_vector(const Complex& complex, FaceId f);
/// The square of the face's area.
Rational squared_area(const Complex& complex, FaceId f);
/// A rational whose relative distance to the root of `square` >= 0 is below 10^-digits.
Rational square_root(const Rational& square, int digits = 20);

/// The volume of the union of 3-cells (ascending, all bounded): one sweep over the faces that bound it. Corners
/// that are doubles cost integer products; the fractions of constructed ones are summed by binary splitting.
/// Nothing if one of the cells is unbounded.
std::optional<Rational> volume(const Complex& complex, std::span<const RegionId> cells);
std::optional<Rational> volume(const Complex& complex, RegionId cell);

/// The terms of the Euler-Poincare formula of non-manifold models, cell by cell (masuda1993 3):
///   v - e + (f - r) - (V - Vh + Vc) = C - Ch + Cc
/// v, e, f: vertices, edges, faces; r: rings (inner boundaries of faces); V: volumes (3-cells), Vh: handles of
/// volumes, Vc: cavities of volumes; C: connected pieces, Ch: holes (independent loops), Cc: cavities.
struct EulerTerms {
  std::int64_t v = 0, e = 0, f = 0, r = 0, volumes = 0, volume_holes = 0, volume_cavities = 0;
  std::int64_t pieces = 0, holes = 0, cavities = 0;
  std::int64_t left() const { return v - e + (f - r) - (volumes - volume_holes + volume_cavities); }
  std::int64_t right() const { return pieces - holes + cavities; }
};

/// The terms of a closed set of bounded cells (closed: `closure(set) == set`). Pieces and cavities are counted by
/// incidence in the set and in its complement, handles and cavities of each volume on its boundary; Ch follows
/// from the formula.
EulerTerms euler_terms(const Complex& complex, const CellSet& set);

/// Checks a set of bounded cells: it is closed; d d = 0 over its faces and volumes; Ch is possible; the cycles of
/// its faces (the kernel of d over Z/2, by elimination) are as many as the cavities that they enclose. The
/// elimination is left out above `max_faces`. Returns the first violation in words, or an empty string.
std::string check_euler(const Complex& complex, const CellSet& set, std::size_t max_faces = 20000);

}  // namespace cnrg
