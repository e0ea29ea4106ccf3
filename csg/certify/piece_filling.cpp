// A leaf has no piece in a box, or none on the side of planes where the parts are: what is there is in one of its
// regions, or outside of it. So is a point of the place.
#include "csg/certify/piece_filling.h"

#include "kernel/complex/complex.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/refine/box_tree.h"

namespace cnrg {

using namespace surface_math;

namespace {

/// On which side of the plane of a flat piece a part is, for all t: -1 or 1; 0 where nobody knows.
int side_of(const Piece& flat, const PiecePart& part, Between between) {
  const Interval3 normal = normalized(flat.normal);
  const auto d = direction(middle_of(normal));
  if (!d) return 0;
  const Interval off = extents(part, *d, between).all() - dot(thin(*d), flat.point) +
                       dot(difference(normal, thin(*d)), difference(part.box, flat.point));
  return holds_zero(off) ? 0 : off.inf() > 0 ? 1 : -1;
}

}  // namespace

/// A leaf by itself.
struct PieceFilling::Space {
  std::vector<std::uint32_t> pieces;
  BoxTree boxes;  // of the pieces
  std::shared_ptr<const Complex> complex;
  Locator locator;
};

const PieceFilling::Space& PieceFilling::space_of(LeafId leaf) {
  std::shared_ptr<const Space>& known = spaces_[leaf];
  if (known) return *known;
  const enclosure::RoundNearest nearest;
  const LeafInstance& instance = leaves_[leaf.index()];
  std::vector<std::uint32_t> pieces;
  std::vector<Box> boxes;
  std::vector<RationalPoint> reach;  // of the frame of planes
  for (std::uint32_t i = 0; i < pieces_.all().size(); ++i) {
    const Piece& piece = pieces_.all()[i];
    if (piece.leaf == leaf) pieces.push_back(i), boxes.push_back(piece.box);
    if (instance.leaf->unbounded())
      reach.insert(reach.end(), {from_doubles(piece.box.lo), from_doubles(piece.box.hi)});
  }
  const auto complex = build_complex(make_soup({instance}, reach));
  known.reset(new Space{std::move(pieces), BoxTree(std::move(boxes)), complex, Locator(*complex)});
  return *known;
}

Filling PieceFilling::of(LeafId leaf, std::span<const PiecePart> parts, const Interval3& common, Between between,
                         std::uint32_t beyond, int on_side) {
  if (leaves_[leaf.index()].leaf->stored() != nullptr || pieces_.unknown().contains(leaf)) return Filling::part;
  const Space& space = space_of(leaf);
  std::vector<std::pair<const Piece*, int>> sides;
  space.boxes.query([box = box_of(common)](const Box& other) { return other.meets(box); },
                    [&](std::uint32_t i) {
                      const Piece& piece = pieces_.all()[space.pieces[i]];
                      const bool flat = piece.kind == Piece::Kind::flat;
                      if (flat && misses(piece, common)) return;
                      int side = 0;
                      if (flat && piece.sheet == beyond) {
                        const auto& [x, y, z, w] = pieces_.plane_of(beyond);
                        side = dot(piece.normal, enclose3({x, y, z})).inf() > 0 ? on_side : -on_side;
                      }
                      for (std::size_t k = 0; flat && side == 0 && k < parts.size(); ++k)
                        side = side_of(piece, parts[k], between);
                      sides.emplace_back(&piece, side);
                    });
  // The middle of the box, or a corner, on the same sides.
  for (int k = -1; k < 8; ++k) {
    std::array<double, 3> p{};
    for (std::size_t i = 0; i < 3; ++i)
      p[i] = k < 0 ? middle_of(common[i]) : (k >> i & 1) != 0 ? common[i].sup() : common[i].inf();
    const bool there = std::ranges::all_of(sides, [&](const auto& at) {
      const Interval off = dot(at.first->normal, difference(Interval3{p[0], p[1], p[2]}, at.first->point));
      return at.second > 0 ? off.inf() > 0 : at.second < 0 && off.sup() < 0;
    });
    if (!there) continue;
    const enclosure::RoundNearest nearest;
    const Location location = space.locator.locate(from_doubles(p));
    if (location.dimension < 3) return Filling::part;
    return space.complex->labels(location.region).empty() ? Filling::none : Filling::all;
  }
  return Filling::part;
}

}  // namespace cnrg
