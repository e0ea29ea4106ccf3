#include "csg/mesh/near_sizes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "csg/result/flat.h"
#include "kernel/base/limits.h"
#include "kernel/base/sorted.h"
#include "kernel/base/vectors.h"
#include "kernel/refine/box_tree.h"
#include "kernel/tetrahedra/bounds.h"

namespace cnrg {
namespace {

using Index = FlatComplex::Index;
using Vector = SizeField::Vector;
using Segment = std::array<Index, 2>;

/// Facets ask for their widths, and edges between facets in a row are half of that apart.
constexpr double kNear = 0.4;
constexpr double kPiece = 2.7;                // so many times as long as the size at its ends
constexpr std::size_t kMostPieces = 200'000;  // longer ones speak for the rest
constexpr double kLeastNearShare = 1e-3;      // of the model

/// So many times the distance to a facet, an edge, a point are edges long there.
constexpr double kToFacet = 1.25, kToEdge = 2, kToPoint = 1;

class NearSizer {
 public:
  NearSizer(const FlatComplex& flat, const RoundedPoints& points, const MeshSizes& sizes, const Watch& watch)
      : flat_(flat),
        xyz_(points.xyz),
        sizes_(sizes),
        watch_(watch),
        facets_of_(xyz_.size()),
        need_(xyz_.size(), -1) {
    Box all;
    for (const Vector& p : xyz_) all.extend(p, p);
    for (std::size_t k = 0; k < 3 && !xyz_.empty(); ++k)
      least_ = std::max(least_, kLeastNearShare * (all.hi[k] - all.lo[k]));
  }

  SizeField run() {
    add_facets();
    add_edges();
    if (segments_.empty() && free_.empty()) return {};
    std::vector<Box> boxes(items_.size());
    for (std::size_t i = 0; i < items_.size(); ++i) {
      for (const Index p : items_[i].corners) boxes[i].extend(xyz_[p], xyz_[p]);
    }
    tree_.emplace(std::move(boxes));
    for (const Index p : free_) point(p);
    for (const Segment& s : segments_) {
      watch_.check();
      const Vector &a = xyz_[s[0]], &b = xyz_[s[1]], along = minus(b, a);
      const double length = std::max(std::sqrt(dot(along, along)), least_);
      if (length < kNear * elsewhere(a)) sources_.push_back({{a, b, b}, length});
      halve(s, a, point(s[0]), b, point(s[1]));
    }
    return sources_.empty() ? SizeField() : SizeField(std::move(sources_), kGrowthOfNear, kInfinity);
  }

 private:
  /// A triangle of a facet, a piece of an edge (its last point twice), a point.
  struct Item {
    std::array<Index, 3> corners;
    double longer;  // than the distance to it
    Index facet = FlatComplex::kNone;
  };

  const FlatComplex& flat_;
  const std::vector<Vector>& xyz_;
  const MeshSizes& sizes_;
  const Watch& watch_;
  std::vector<std::vector<Index>> facets_of_;  // by points, ascending
  std::vector<double> need_;                   // by points, what is near to them; -1: not known yet
  Index facets_ = 0;
  std::vector<Item> items_;
  std::vector<Segment> segments_;
  std::vector<Index> free_;  // points on no segment
  std::optional<BoxTree> tree_;
  double least_ = 0;
  std::size_t pieces_ = 0;
  std::vector<SizeField::Source> sources_;

  void add_facets() {
    for (const FlatComplex::Face& face : flat_.faces) {
      for_each_facet(face, [&](const auto& loops, const auto& isolated, Index begin, Index end) {
        add_facet(face, loops, isolated, begin, end);
      });
    }
  }
  void add_facet(const FlatComplex::Face& face, const std::vector<FlatComplex::Loop>& loops, const auto& isolated,
                 std::size_t begin, std::size_t end) {
    const auto has = [&](Index p) {
      std::vector<Index>& of = facets_of_[p];
      if (of.empty() || of.back() != facets_) of.push_back(facets_);
    };
    for (const FlatComplex::Loop& loop : loops) {
      for (std::size_t k = 0; k < loop.size(); ++k) {
        has(loop[k]);
        add_segment(loop[k], loop[(k + 1) % loop.size()]);
      }
    }
    for (const Index p : isolated) has(p);
    for (std::size_t t = begin; t < end; ++t) items_.push_back({face.triangles[t], kToFacet, facets_});
    ++facets_;
  }

  void add_segment(Index a, Index b) { segments_.push_back({std::min(a, b), std::max(a, b)}); }
  void add_edges() {
    for (const FlatComplex::Edge& edge : flat_.edges)
      for_each_segment(edge, [&](Index a, Index b) { add_segment(a, b); });
    sort_unique(segments_);
    for (const auto& [a, b] : segments_) items_.push_back({{a, b, b}, kToEdge});
    for (const FlatComplex::Vertex& vertex : flat_.vertices) {
      if (!vertex.free) continue;
      free_.push_back(vertex.point);
      items_.push_back({{vertex.point, vertex.point, vertex.point}, kToPoint});
    }
  }

  bool is_at(const Item& item, Index p) const {
    if (std::find(item.corners.begin(), item.corners.end(), p) != item.corners.end()) return true;
    return item.facet != FlatComplex::kNone &&
           std::binary_search(facets_of_[p].begin(), facets_of_[p].end(), item.facet);
  }

  /// How long edges are where no features are near. Lengths that grow fast from what is narrow or short do not
  /// count: edges that are there do not grow faster than shapes let them.
  double elsewhere(const Vector& p) const {
    const double overall = sizes_.field.overall();
    return sizes_.field.growth() > kGrowthOfNear && overall < kInfinity ? overall : sizes_.field.at(p);
  }

  /// The size at a place on a segment, by the next feature that has none of its ends, if one is near; else
  /// infinity.
  double near(const Vector& p, const Segment& on) const { return near(p, on, kNear * elsewhere(p)); }
  double near(const Vector& p, const Segment& on, double most) const {
    double nearest = most;
    tree_->query(
        [&](const Box& box) {
          double squares = 0;
          for (std::size_t k = 0; k < 3; ++k) {
            const double d = std::max({box.lo[k] - p[k], 0.0, p[k] - box.hi[k]});
            squares += d * d;
          }
          return squares < nearest * nearest;
        },
        [&](std::uint32_t i) {
          const Item& item = items_[i];
          const auto& [a, b, c] = item.corners;
          const double size = item.longer * std::sqrt(squared_distance(p, {xyz_[a], xyz_[b], xyz_[c]}));
          if (size < nearest && size >= least_ && !is_at(item, on[0]) && !is_at(item, on[1])) nearest = size;
        });
    return nearest < most ? nearest : kInfinity;
  }

  double point(Index p) {
    if (need_[p] < 0) {
      need_[p] = near(xyz_[p], {p, p});
      add_point(xyz_[p], need_[p]);
    }
    return need_[p];
  }

  /// A piece between two points and what is near to these.
  void halve(const Segment& on, const Vector& a, double near_a, const Vector& b, double near_b) {
    const Vector along = minus(b, a), middle{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
    const double length = std::sqrt(dot(along, along));
    const double size = elsewhere(middle), need = std::min(near_a, near_b);
    // Nothing on it is near if nothing is as near to its middle.
    const double most = kNear * (size + sizes_.field.growth() * length / 2) + kToEdge * length / 2;
    if (need == kInfinity && near(middle, on, most) == kInfinity) return;
    if (pieces_ < kMostPieces && length > least_ && length > std::min(kPiece * need, kLongestEdge * size)) {
      ++pieces_;
      const double half = near(middle, on);
      add_point(middle, half);
      halve(on, a, near_a, middle, half);
      halve(on, middle, half, b, near_b);
    } else if (const double both = std::max(near_a, near_b); both < kInfinity) {
      sources_.push_back({{a, b, b}, both});
    }
  }
  void add_point(const Vector& p, double size) {
    if (size < kInfinity) sources_.push_back({{p, p, p}, size});
  }
};

}  // namespace

SizeField sizes_of_near(const FlatComplex& flat, const RoundedPoints& points, const MeshSizes& sizes,
                        const Watch& watch) {
  return NearSizer(flat, points, sizes, watch).run();
}

}  // namespace cnrg
