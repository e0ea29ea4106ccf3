// The soup: parallel arrays, appended to; nothing is merged or decided here.
#include "kernel/refine/soup.h"

#include <algorithm>
#include <cmath>

#include "kernel/base/error.h"
#include "kernel/base/sorted.h"

namespace cnrg {

LeafId Soup::add_leaf(Fill fill, bool curved_sides) {
  check_count(leaf_count() + 1, kPlural<LeafId>);
  fills_.push_back(fill);
  curved_sides_.push_back(curved_sides ? 1 : 0);
  first_points_.emplace_back(point_count());
  return LeafId(fills_.size() - 1);
}

const LeafAxes* Soup::own_axes(LeafId leaf) const {
  const auto it =
      std::find_if(own_axes_.begin(), own_axes_.end(), [&](const auto& of) { return of.first == leaf; });
  return it == own_axes_.end() ? nullptr : &it->second;
}

PointId Soup::add_point(double x, double y, double z) {
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) {
    throw InputError("a point has a coordinate that is no finite number: give finite coordinates");
  }
  check_count(point_count() + 1, kPlural<PointId>);
  // Adding zero turns -0 into 0: equal points have equal bytes.
  xyz_.insert(xyz_.end(), {x + 0.0, y + 0.0, z + 0.0});
  return PointId(point_count() - 1);
}

PointId Soup::add_point(const RationalPoint& p) {
  const double nearest[3] = {to_double(p[0]), to_double(p[1]), to_double(p[2])};
  for (int k = 0; k < 3; ++k) {
    if (std::isinf(nearest[k])) {
      throw InputError("a coordinate is larger than 1.797e308, the largest double: use a larger unit of length");
    }
  }
  const bool exact = is_double(p[0]) && is_double(p[1]) && is_double(p[2]);
  const PointId id = add_point(nearest[0], nearest[1], nearest[2]);
  if (!exact) rationals_.emplace_back(id, p);
  return id;
}

SourceId Soup::add_face(LeafId leaf, std::span<const std::vector<PointId>> loops, std::uint32_t leaf_face,
                        std::uint32_t patch, std::uint32_t front, std::uint32_t back) {
  require(leaf.valid() && leaf.index() < fills_.size(), "soup: face of an unknown leaf");
  require(!loops.empty(), "soup: face without a loop");
  for (std::size_t i = 0; i < loops.size(); ++i) {
    require(loops[i].size() >= 3, "soup: loop of fewer than three points");
    if (i > 0) corners_.push_back(PointId::none());
    for (PointId p : loops[i]) {
      require(p.index() < point_count(), "soup: face with an unknown point");
      corners_.push_back(p);
    }
  }
  return end_face({leaf, leaf_face, patch, front, back, 0});
}

SourceId Soup::add_triangle(LeafId leaf, PointId a, PointId b, PointId c, std::uint32_t leaf_face,
                            std::uint32_t patch, std::uint32_t front, std::uint32_t back) {
  require(leaf.valid() && leaf.index() < fills_.size(), "soup: triangle of an unknown leaf");
  require(std::max({a.index(), b.index(), c.index()}) < point_count(), "soup: triangle with an unknown point");
  corners_.insert(corners_.end(), {a, b, c});
  return end_face({leaf, leaf_face, patch, front, back, 0});
}

SourceId Soup::end_face(const Face& face) {
  check_count(faces_.size() + 1, kPlural<SourceId>);
  offsets_.push_back(place32(corners_.size(), "corners of faces"));
  faces_.push_back(face);
  faces_.back().curved_sides = curved_sides(face.leaf);
  return SourceId(faces_.size() - 1);
}

void Soup::set_plane(const std::array<PointId, 3>& points) {
  require(!faces_.empty(), "soup: a plane without a face");
  for (const PointId p : points) require(p.index() < point_count(), "soup: plane through an unknown point");
  planes_.emplace_back(SourceId(faces_.size() - 1), points);
}

const std::array<PointId, 3>* Soup::plane(SourceId f) const { return value_of_key(planes_, f); }

WireId Soup::add_wire(LeafId leaf, PointId a, PointId b, std::uint32_t leaf_edge) {
  require(leaf.valid() && leaf.index() < fills_.size(), "soup: wire of an unknown leaf");
  require(std::max(a.index(), b.index()) < point_count(), "soup: wire with an unknown point");
  check_count(wires_.size() + 1, "wires");
  wires_.push_back({leaf, leaf_edge, a, b});
  return WireId(wires_.size() - 1);
}

void Soup::add_isolated(LeafId leaf, PointId p) {
  require(leaf.valid() && leaf.index() < fills_.size(), "soup: point of an unknown leaf");
  require(p.index() < point_count(), "soup: unknown isolated point");
  isolated_.push_back({leaf, p});
}

void Soup::add_curve_end(LeafId leaf, PointId p) {
  require(leaf.valid() && leaf.index() < fills_.size(), "soup: end of a curve of an unknown leaf");
  require(p.index() < point_count(), "soup: unknown end of a curve");
  curve_ends_.push_back({leaf, p});
}

void Soup::number_surfaces(const std::function<std::uint32_t(std::uint32_t patch)>& surface_of) {
  const LeafId last(leaf_count() - 1);
  for (auto face = faces_.rbegin(); face != faces_.rend() && face->leaf == last; ++face)
    face->surface = surface_of(face->patch);
}

void Soup::set_frame(LeafId frame, PointId seed, std::vector<std::pair<LeafId, std::uint32_t>> seed_regions) {
  require(!frame_.valid(), "soup: a second frame");
  require(frame.valid() && frame.index() < fills_.size(), "soup: the frame is an unknown leaf");
  require(seed.index() < point_count(), "soup: the frame's seed is an unknown point");
  frame_ = frame;
  seed_ = seed;
  seed_regions_ = std::move(seed_regions);
}

const RationalPoint* Soup::rational(PointId p) const { return value_of_key(rationals_, p); }

}  // namespace cnrg
