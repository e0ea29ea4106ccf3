// All leaves of a tree in one soup, with a frame around them if one is unbounded.
#include "csg/leaves/unbounded.h"
#include "kernel/base/error.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/refine/box_faces.h"

namespace cnrg {
namespace {

/// The box of all points of a soup, exact; false if there are none. Doubles decide except for rational points.
bool bounds(const Soup& soup, ExactBox& box) {
  double low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
  std::vector<const RationalPoint*> rationals;
  bool any_double = false;
  for (PointId p : IdRange<PointId>(soup.point_count())) {
    if (const RationalPoint* value = soup.rational(p)) {
      rationals.push_back(value);
      continue;
    }
    const double* xyz = soup.xyz(p);
    for (int k = 0; k < 3; ++k) {
      if (!any_double || xyz[k] < low[k]) low[k] = xyz[k];
      if (!any_double || xyz[k] > high[k]) high[k] = xyz[k];
    }
    any_double = true;
  }
  if (!any_double && rationals.empty()) return false;
  if (any_double) {
    box = {{from_double(low[0]), from_double(low[1]), from_double(low[2])},
           {from_double(high[0]), from_double(high[1]), from_double(high[2])}};
  } else {
    box = {*rationals[0], *rationals[0]};
  }
  for (const RationalPoint* p : rationals) {
    for (std::size_t k = 0; k < 3; ++k) {
      if ((*p)[k] < box.low[k]) box.low[k] = (*p)[k];
      if ((*p)[k] > box.high[k]) box.high[k] = (*p)[k];
    }
  }
  return true;
}

struct UnboundedInstance {
  LeafId leaf;
  const UnboundedLeaf* shape;
  ExactHalfspace plane;
};

void add_frame(Soup& soup, const std::vector<UnboundedInstance>& unbounded, std::span<const RationalPoint> reach) {
  std::vector<ExactHalfspace> planes;
  for (const UnboundedInstance& u : unbounded) planes.push_back(u.plane);
  ExactBox points;
  bool any = bounds(soup, points);
  for (const RationalPoint& p : reach) {
    if (!any) points = {p, p};
    any = true;
    for (std::size_t k = 0; k < 3; ++k) {
      if (p[k] < points.low[k]) points.low[k] = p[k];
      if (p[k] > points.high[k]) points.high[k] = p[k];
    }
  }
  const ExactBox box = frame_box(any ? &points : nullptr, planes);

  std::vector<std::pair<LeafId, std::uint32_t>> seed_regions;
  for (const UnboundedInstance& u : unbounded) {
    std::vector<PointId> loop;
    for (const RationalPoint& p : cut(u.plane, box)) loop.push_back(soup.add_point(p));
    soup.add_face(u.leaf, std::span(&loop, 1), 0, 0, 0, u.shape->solid() ? 1 : 0);
    if (u.shape->solid() && dot(u.plane.normal, box.high) < u.plane.offset) seed_regions.emplace_back(u.leaf, 1);
  }

  const LeafId frame = soup.add_leaf(Fill::winding);
  PointId corner[8];
  for (std::size_t i = 0; i < 8; ++i) corner[i] = soup.add_point(box.corner(i));
  for (std::uint32_t f = 0; f < 6; ++f) {
    const std::vector<PointId> loop{corner[kBoxFaces[f][0]], corner[kBoxFaces[f][1]], corner[kBoxFaces[f][2]],
                                    corner[kBoxFaces[f][3]]};
    soup.add_face(frame, std::span(&loop, 1), f, f);
  }
  soup.set_frame(frame, corner[7], std::move(seed_regions));
}

}  // namespace

Soup make_soup(const std::vector<LeafInstance>& instances, std::span<const RationalPoint> reach,
               std::span<const std::vector<std::uint32_t>> surfaces) {
  Soup soup;
  std::vector<UnboundedInstance> unbounded;
  for (const LeafInstance& instance : instances) {
    require(instance.leaf != nullptr, "make_soup: an instance without a leaf");
    if (instance.transform->determinant() == 0) {
      throw InputError("the transforms of a leaf flatten it (their determinant is 0): give invertible ones");
    }
    const LeafId leaf = instance.leaf->add_to(soup, instance.transform);
    if (!surfaces.empty() && !surfaces[leaf.index()].empty()) {
      const std::vector<std::uint32_t>& of = surfaces[leaf.index()];
      soup.number_surfaces([&](std::uint32_t patch) { return patch < of.size() ? of[patch] : 0; });
    }
    if (!instance.leaf->unbounded()) continue;
    const auto* shape = dynamic_cast<const UnboundedLeaf*>(instance.leaf.get());
    require(shape != nullptr, "make_soup: an unbounded leaf that is no plane");
    unbounded.push_back({leaf, shape, shape->image(instance.transform)});
  }
  if (!unbounded.empty()) add_frame(soup, unbounded, reach);
  return soup;
}

}  // namespace cnrg
