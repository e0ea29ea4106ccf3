// Whether the complex of facets has the incidence of the arrangement of the true surfaces: a proof, or the places
// where there is none.
//
// H moves facets into surfaces (pieces.h). While all strata of all leaves are in general position for every t, the
// arrangement at t = 1 is that at t = 0 up to a homeomorphism of space (siebenmann1972, Corollary 6.14: what is
// locally a product over t, and proper, is a product). General position is asked of generalized normals
// (clarke1976), for H has kinks where facets meet:
//   two sheets      no normals of one are parallel to one of the other, where they meet;
//   three           no normals of them lie in a plane;
//   four            have no point in common;
//   curve, sheet    the tangent is not at right angles to the normal; with two sheets: no point in common;
//   two curves      no common point, but on a sheet in which both lie, where they cross at an angle.
// Two sheets may also touch where it is known how (contact.h), with facets that do the same; two cylinders may
// cross as well where they touch (Pieces::cross_in_rulings). Then what they have in common is at an angle to a
// third sheet, and to what this has in common with one of them if they touch as well; or it lies in the third, a
// plane that crosses both. Where a curve of a leaf is where two of its sheets cross, it is no stratum of its own:
// the sheets decide. A plane and two sheets may cross by twos in one curve. Two sheets that end in a plane, on its
// two sides or where the rest dies, have no more in common than such a curve (Pieces::rim); others are asked about
// one of them and the plane. Sheets that are one surface in truth are asked whether they are drawn alike. Cells
// about one axis are asked in a half-plane (coaxial.h). What dies is not asked (relevance.h). On request leaves
// are asked whether they meet themselves, but for what is side by side at a pole: patches that are no quadrics or
// tori, and wires (piece_self.cpp), and what is beside each other (piece_beside.cpp).
//
// All is decided by intervals on parts of pieces, which are halved until it is, or a number of steps is reached.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

#include "csg/certify/certificate.h"
#include "csg/certify/pieces.h"
#include "csg/certify/relevance.h"
#include "kernel/base/limits.h"

namespace cnrg {

/// Up to four pieces, ascending; kNone after them.
using PieceTuple = std::array<std::uint32_t, 4>;
inline PieceTuple key_of(std::vector<std::uint32_t> pieces) {
  std::sort(pieces.begin(), pieces.end());
  PieceTuple key{kNone, kNone, kNone, kNone};
  std::ranges::copy(pieces, key.begin());
  return key;
}
struct PieceTupleHash {
  std::size_t operator()(const PieceTuple& tuple) const {
    std::uint64_t hash = 0;
    for (const std::uint32_t i : tuple) hash = (hash ^ i) * 0x9e3779b97f4a7c15u, hash ^= hash >> 29;
    return hash;
  }
};

/// Of pieces, ascending, each as often as it has one.
using PiecePatches = std::vector<std::pair<LeafId, std::uint32_t>>;
inline PiecePatches patches_of(const std::vector<Piece>& all, const std::vector<std::uint32_t>& pieces) {
  PiecePatches patches;
  for (const std::uint32_t i : pieces) patches.emplace_back(all[i].leaf, all[i].patch);
  std::sort(patches.begin(), patches.end());
  return patches;
}
/// True if one of the sets is a part of them.
inline bool hold_any(const PiecePatches& patches, const std::set<PiecePatches>& sets) {
  return std::ranges::any_of(sets, [&](const PiecePatches& set) { return std::ranges::includes(patches, set); });
}

/// Pieces of which it is not proven that they are in general position.
struct OpenPlace {
  std::vector<std::uint32_t> pieces;
  std::array<double, 3> at{};
  double size = 0;  ///< of what was left undecided there, a length
  /// `facets`: the surfaces alone are in general position there, so finer facets would do. `budget`: of a set of
  /// leaves the first one.
  UncertainPlace::Why why = UncertainPlace::Why::near;
  bool coaxial = false;  ///< of two cells that finer meridians would tell (coaxial.h)
};

struct Proof {
  std::size_t asked = 0;     ///< pairs of pieces whose boxes meet
  std::size_t apart = 0;     ///< of them: proven to have no point in common
  std::size_t crossing = 0;  ///< proven to cross at an angle, if they do
  std::size_t contacts = 0;  ///< proven to touch as their surfaces do (contact.h)
  std::size_t steps = 0;     ///< how often a part was halved
  /// By sets of leaves, ascending: steps, those of earlier proofs included, and questions that were not answered
  /// for want of steps.
  std::map<std::vector<LeafId>, std::size_t> spent, left;
  std::map<LeafId, std::size_t> spent_on_own;  ///< likewise, whether leaves meet themselves
  std::vector<OpenPlace> open;
  /// By pieces: how questions about them were answered, but for those that are left.
  struct Answer {
    enum class Kind : std::uint8_t { apart, crossing, contact, open } kind;
    std::uint32_t place = 0;  ///< in `open`
  };
  std::unordered_map<PieceTuple, Answer, PieceTupleHash> answers;
  std::set<std::vector<LeafId>> dead;  ///< leaves, ascending, some of whose places were not asked: they die
};

/// A drawing and its proof: of a later one only that is asked which has other pieces.
struct EarlierProof {
  const Pieces& pieces;
  const Proof& proof;
};

/// `relevance`: of the nodes that matter. `leaves`: of which the pieces are.
/// `most_steps`: of a set of leaves; what is asked of it after them is left.
/// `earlier`: of the same leaves in the same places, with other lines; null for none.
Proof prove(Pieces& pieces, const std::vector<LeafInstance>& leaves, const Relevance& relevance,
            std::size_t most_steps, const EarlierProof* earlier = nullptr);

}  // namespace cnrg
