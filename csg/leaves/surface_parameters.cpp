// From cells of the complex by their covers to faces and wires of a leaf, and from there to cells of patches.
#include "csg/leaves/surface_parameters.h"

#include <algorithm>
#include <tuple>

#include "kernel/base/error.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {

struct SurfaceParameters::Leaf {
  PlacedParameters placed;
  std::size_t first_face = 0, first_wire = 0;  // those of a leaf follow each other in the soup
  std::size_t faces = 0, wires = 0;
  std::once_flag once, once_surfaces;
  std::shared_ptr<const LeafParameters> made;
  std::shared_ptr<const LeafSurfaces> made_surfaces;
};

namespace {

bool among(std::span<const LeafId> leaves, LeafId leaf) {
  return std::binary_search(leaves.begin(), leaves.end(), leaf);
}

bool before(const PatchPoint& a, const PatchPoint& b) {
  return std::tie(a.leaf, a.patch, a.at) < std::tie(b.leaf, b.patch, b.at);
}
bool before(const CurvePoint& a, const CurvePoint& b) {
  return std::tie(a.leaf, a.curve, a.at) < std::tie(b.leaf, b.curve, b.at);
}

template <class T>
std::vector<T> unique(std::vector<T> points) {
  std::sort(points.begin(), points.end(), [](const T& a, const T& b) { return before(a, b); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

/// The faces of the complex whose closures hold the cell.
std::vector<FaceId> faces_around(const Complex& complex, const Location& cell) {
  std::vector<FaceId> faces;
  if (cell.dimension == 0) complex.star_faces(cell.vertex, faces);
  if (cell.dimension == 1) complex.star_faces(cell.edge, faces);
  if (cell.dimension == 2) faces.push_back(cell.face);
  return faces;
}

/// The wires of the soup whose closures hold the cell.
std::vector<WireId> wires_around(const Complex& complex, const Location& cell) {
  std::vector<WireId> wires;
  const auto add = [&](EdgeId e) {
    for (const SegmentId s : complex.edge_segments[e]) {
      for (const WireId w : complex.segment_wires[s]) wires.push_back(w);
    }
  };
  if (cell.dimension == 1) add(cell.edge);
  if (cell.dimension == 0) {
    for (const EdgeId e : complex.vertex_edges[cell.vertex]) add(e);
  }
  return wires;
}

/// The place of p between a and b, 0 at a and 1 at b.
Rational place_between(const RationalPoint& a, const RationalPoint& b, const RationalPoint& p) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (a[k] != b[k]) return (p[k] - a[k]) / (b[k] - a[k]);
  }
  throw InvariantError("parameters: a wire of one point");
}

}  // namespace

LeafPlaces::LeafPlaces(const Complex& complex) {
  std::vector<std::uint32_t> next(complex.leaf_count, 0);
  for (const Soup::Face& face : complex.sources) faces.push_back(next[face.leaf.index()]++);
  next.assign(complex.leaf_count, 0);
  for (const Soup::Wire& wire : complex.wires) wires.push_back(next[wire.leaf.index()]++);
}

SurfaceParameters::SurfaceParameters(const Complex& complex, std::vector<PlacedParameters> leaves,
                                     std::optional<LeafPlaces> places)
    : complex_(complex), places_(std::move(places)) {
  for (PlacedParameters& placed : leaves) {
    leaves_.push_back(std::make_unique<Leaf>());
    leaves_.back()->placed = std::move(placed);
  }
  if (places_) return;
  const auto count = [&](LeafId leaf, std::size_t number, std::size_t Leaf::*first, std::size_t Leaf::*all) {
    if (leaf.index() >= leaves_.size()) return;
    Leaf& of = *leaves_[leaf.index()];
    if (of.*all == 0) of.*first = number;
    require(of.*first + of.*all == number, "parameters: the faces of a leaf are apart in the soup");
    ++(of.*all);
  };
  for (const SourceId s : IdRange<SourceId>(complex.sources.size())) {
    count(complex.sources[s].leaf, s.index(), &Leaf::first_face, &Leaf::faces);
  }
  for (const WireId w : IdRange<WireId>(complex.wires.size())) {
    count(complex.wires[w].leaf, w.index(), &Leaf::first_wire, &Leaf::wires);
  }
}

SurfaceParameters::~SurfaceParameters() = default;

bool SurfaceParameters::has(LeafId leaf) const {
  return leaf.index() < leaves_.size() && leaves_[leaf.index()]->placed.source;
}

const LeafParameters& SurfaceParameters::parameters(LeafId leaf) const {
  Leaf& of = *leaves_[leaf.index()];
  std::call_once(of.once, [&] {
    of.made = of.placed.source();
    require(places_ || (of.made->facet_count() == of.faces && of.made->wire_count() == of.wires),
            "parameters: a leaf has other faces than its soup");
  });
  return *of.made;
}

std::string SurfaceParameters::patch_name(LeafId leaf, std::uint32_t patch) const {
  return has(leaf) ? parameters(leaf).patch_name(patch) : "";
}
std::string SurfaceParameters::curve_name(LeafId leaf, std::uint32_t curve) const {
  return has(leaf) ? parameters(leaf).curve_name(curve) : "";
}

std::shared_ptr<const LeafSurfaces> SurfaceParameters::surfaces(LeafId leaf) const {
  if (leaf.index() >= leaves_.size() || !leaves_[leaf.index()]->placed.surfaces) return nullptr;
  Leaf& of = *leaves_[leaf.index()];
  std::call_once(of.once_surfaces, [&] { of.made_surfaces = of.placed.surfaces(); });
  return of.made_surfaces;
}

const Transform& SurfaceParameters::transform(LeafId leaf) const {
  static const Transform kIdentity;
  return leaf.index() < leaves_.size() ? *leaves_[leaf.index()]->placed.transform : kIdentity;
}

std::vector<std::vector<PatchCorner>> SurfaceParameters::cells(SourceId source) const {
  const LeafId leaf = complex_.sources[source].leaf;
  if (!has(leaf)) return {};
  return parameters(leaf).cells(facet_of(source));
}

std::size_t SurfaceParameters::facet_of(SourceId source) const {
  if (places_) return places_->faces[source];
  return source.index() - leaves_[complex_.sources[source].leaf.index()]->first_face;
}

std::size_t SurfaceParameters::wire_of(WireId wire) const {
  if (places_) return places_->wires[wire];
  return wire.index() - leaves_[complex_.wires[wire].leaf.index()]->first_wire;
}

std::vector<PlacedCell> SurfaceParameters::cells(FaceId f, std::span<const LeafId> leaves) const {
  std::vector<PlacedCell> result;
  for (const Cover& cover : complex_.cover(f)) {
    const Soup::Face& face = complex_.sources[cover.source];
    if (!has(face.leaf) || !among(leaves, face.leaf)) continue;
    const Transform& placed = leaves_[face.leaf.index()]->placed.transform;
    const bool moved = !placed.identity();
    for (auto& corners : cells(cover.source)) {
      if (moved) {
        for (PatchCorner& corner : corners) corner.point = placed.apply(corner.point);
      }
      result.push_back({face.leaf, face.patch, std::move(corners)});
    }
  }
  return result;
}

std::vector<PatchPoint> SurfaceParameters::on_patches(const Location& cell, const RationalPoint& p,
                                                      std::span<const LeafId> leaves) const {
  std::vector<PatchPoint> result;
  for (const FaceId f : faces_around(complex_, cell)) {
    for (const PlacedCell& of : cells(f, leaves)) {
      // A face that unites parts of many cells lies in one of them at p, or in two that meet there.
      if (holds(of.corners, p)) result.push_back({of.leaf, of.patch, parameters_in(of.corners, p)});
    }
  }
  return unique(std::move(result));
}

std::vector<CurvePoint> SurfaceParameters::on_curves(const Location& cell, const RationalPoint& p,
                                                     std::span<const LeafId> leaves) const {
  std::vector<CurvePoint> result;
  for (const WireId w : wires_around(complex_, cell)) {
    const Soup::Wire& wire = complex_.wires[w];
    if (!has(wire.leaf) || !among(leaves, wire.leaf)) continue;
    const Leaf& leaf = *leaves_[wire.leaf.index()];
    const LeafParameters::Wire of = parameters(wire.leaf).wire(wire_of(w));
    if (of.at[0] == of.at[1]) continue;  // it has none
    const RationalPoint a = leaf.placed.transform->apply(of.ends[0]), b = leaf.placed.transform->apply(of.ends[1]);
    const Rational t = of.at[0] + place_between(a, b, p) * (of.at[1] - of.at[0]);
    result.push_back({wire.leaf, wire.leaf_edge, t});
  }
  return unique(std::move(result));
}

std::vector<PatchPoint> first_of_each(std::vector<PatchPoint> points) {
  const auto same = [](const PatchPoint& p, const PatchPoint& q) {
    return p.leaf == q.leaf && p.patch == q.patch;
  };
  points.erase(std::unique(points.begin(), points.end(), same), points.end());
  return points;
}

std::vector<CurvePoint> first_of_each(std::vector<CurvePoint> points) {
  const auto same = [](const CurvePoint& p, const CurvePoint& q) {
    return p.leaf == q.leaf && p.curve == q.curve;
  };
  points.erase(std::unique(points.begin(), points.end(), same), points.end());
  return points;
}

}  // namespace cnrg
