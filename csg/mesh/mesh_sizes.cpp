#include "csg/mesh/mesh_sizes.h"

#include <cmath>

#include "csg/mesh/reach.h"
#include "csg/result/flat.h"
#include "csg/result/sizes.h"
#include "kernel/base/limits.h"
#include "kernel/base/vectors.h"

namespace cnrg {
namespace {

using Index = FlatComplex::Index;
using Vector = SizeField::Vector;

constexpr double kLeastShare = 1e-3;  // of the model's diagonal, that a piece or a facet asks for by itself
constexpr double kNarrow = 64;        // so many times as long as wide is what is narrow

class SizeCollector {
 public:
  SizeCollector(const ResultView& view, const FlatComplex& flat, const RoundedPoints& points,
                const SizeOptions& options)
      : view_(view),
        flat_(flat),
        xyz_(points.xyz),
        overall_(options.size > 0 ? options.size : kInfinity),
        growth_(options.growth),
        least_(least_asked(points)) {}

  MeshSizes run(const SizeOptions& options) {
    add_said();
    const bool said = !sources_.empty() || overall_ < kInfinity;
    if (!said && !options.always) return {};
    if (!options.said) {
      least_narrow_ = options.wide ? kInfinity : least_;
      add_facets();
      add_pieces();
    }
    return {SizeField(std::move(sources_), growth_, overall_), std::move(regions_)};
  }

 private:
  const ResultView& view_;
  const FlatComplex& flat_;
  const std::vector<Vector>& xyz_;
  const double overall_, growth_, least_;
  double least_narrow_ = 0;  // narrower ones do not ask
  std::vector<SizeField::Source> sources_;
  std::vector<double> regions_;
  std::vector<char> wide_;  // of each face: has it a facet that asks, however small it is?

  /// One that is not below the overall size asks for nothing.
  void add(Index a, Index b, Index c, double size) {
    if (size > 0 && size < overall_) sources_.push_back({{xyz_[a], xyz_[b], xyz_[c]}, size});
  }

  void add_said() {
    regions_ = region_sizes(view_, flat_);
    for (Index f = 0; f < flat_.faces.size(); ++f) {
      const FlatComplex::Face& face = flat_.faces[f];
      double size = size_of(view_, face.origin);
      for (const Index region : face.regions) {
        const double inside = region < regions_.size() ? regions_[region] : 0;
        if (inside > 0 && (size == 0 || inside < size)) size = inside;
      }
      for (const auto& t : face.triangles) add(t[0], t[1], t[2], size);
    }
    for (const FlatComplex::Edge& edge : flat_.edges) {
      const double size = size_of(view_, edge.origin);
      if (size > 0) for_each_segment(edge, [&](Index a, Index b) { add(a, b, b, size); });
    }
    for (const FlatComplex::Vertex& vertex : flat_.vertices) {
      if (vertex.free) add(vertex.point, vertex.point, vertex.point, size_of(view_, vertex.origin));
    }
    for (double& size : regions_) size = size == 0 ? kInfinity : size;
  }

  double length(Index a, Index b) const { return distance(xyz_[a], xyz_[b]); }

  void add_pieces() {
    std::vector<Index> face_of(xyz_.size(), FlatComplex::kNone);  // that a point is inside of
    for (Index f = 0; f < flat_.faces.size(); ++f)
      for (const Index p : flat_.faces[f].isolated) face_of[p] = f;
    for (const FlatComplex::Edge& edge : flat_.edges) {
      const bool across = !edge.around.empty() && std::none_of(edge.around.begin(), edge.around.end(),
                                                               [&](Index side) { return wide_[side >> 1] != 0; });
      for_each_segment(edge, [&](Index a, Index b) {
        const double size = length(a, b);
        const bool through = edge.wire && face_of[a] != face_of[b] && face_of[a] != FlatComplex::kNone &&
                             face_of[b] != FlatComplex::kNone;
        if (size >= least_narrow_ || !(across || through)) add(a, b, b, std::max(size, least_));
      });
    }
  }

  void add_facets() {
    wide_.assign(flat_.faces.size(), 0);
    for (Index f = 0; f < flat_.faces.size(); ++f) {
      const FlatComplex::Face& face = flat_.faces[f];
      for_each_facet(face, [&](const auto& loops, const auto&, Index begin, Index end) {
        if (add_facet(face, loops, begin, end)) wide_[f] = 1;
      });
    }
  }

  /// False if it is too narrow to ask.
  bool add_facet(const FlatComplex::Face& face, const std::vector<FlatComplex::Loop>& loops, std::size_t begin,
                 std::size_t end) {
    double perimeter = 0, area = 0;
    for (const FlatComplex::Loop& loop : loops) {
      for (std::size_t k = 0; k < loop.size(); ++k) perimeter += length(loop[k], loop[(k + 1) % loop.size()]);
    }
    for (std::size_t t = begin; t < end; ++t) {
      const auto& [a, b, c] = face.triangles[t];
      area += cnrg::length(cross(minus(xyz_[b], xyz_[a]), minus(xyz_[c], xyz_[a]))) / 2;
    }
    const bool triangle = loops.size() == 1 && loops[0].size() == 3;
    double width = perimeter > 0 ? 4 * area / perimeter * (triangle ? std::sqrt(3.0) : 1) : 0;
    // (Of a strip that is twice its width, and the perimeter is twice its length.)
    if (!(perimeter > 0) || (width < least_narrow_ && perimeter > kNarrow * width)) return false;
    width = std::max(width, least_);
    for (std::size_t t = begin; t < end; ++t) {
      const auto& [a, b, c] = face.triangles[t];
      add(a, b, c, width);
    }
    return true;
  }
};

}  // namespace

double least_asked(const RoundedPoints& points) {
  if (points.xyz.empty()) return 0;
  const Box box = Reach(points.xyz).box;
  return kLeastShare * distance(box.hi, box.lo);
}

MeshSizes mesh_sizes(const ResultView& view, const FlatComplex& flat, const RoundedPoints& points,
                     const SizeOptions& options) {
  return SizeCollector(view, flat, points, options).run(options);
}

}  // namespace cnrg
