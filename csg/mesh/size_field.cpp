// A tree of boxes over the sources. What a node can bid at most is its least length and the distance to its box; a
// descent to the better child first passes over nearly all others.
#include "csg/mesh/size_field.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "kernel/base/error.h"
#include "kernel/base/limits.h"
#include "kernel/base/vectors.h"
#include "kernel/refine/box.h"

namespace cnrg {
namespace {

using Vector = SizeField::Vector;

double squared(const Vector& v) { return dot(v, v); }

/// The squared distance of p, seen from an end of a segment, to that segment.
double to_segment(const Vector& p, const Vector& along) {
  const double length = squared(along);
  const double t = length > 0 ? std::clamp(dot(p, along) / length, 0.0, 1.0) : 0.0;
  return squared({p[0] - t * along[0], p[1] - t * along[1], p[2] - t * along[2]});
}

}  // namespace

double squared_distance(const Vector& p, const std::array<Vector, 3>& corners) {
  const auto& [a, b, c] = corners;
  const Vector pa = minus(p, a), ab = minus(b, a);
  if (b == c) return to_segment(pa, ab);
  const Vector ac = minus(c, a), bc = minus(c, b), pb = minus(p, b);
  const Vector n = cross(ab, ac);
  const double area = squared(n);
  // Over the triangle where p is to the left of each side, as seen against its normal.
  if (area > 0 && dot(cross(ab, pa), n) >= 0 && dot(cross(bc, pb), n) >= 0 && dot(cross(pa, ac), n) >= 0) {
    const double height = dot(pa, n);
    return height * height / area;
  }
  return std::min({to_segment(pa, ab), to_segment(pa, ac), to_segment(pb, bc)});
}

class SizeField::Tree {
 public:
  explicit Tree(std::vector<Source> sources) : sources_(std::move(sources)) {
    for (Source& s : sources_) {
      // A point is a a a, a segment a b b.
      if (s.corners[0] == s.corners[1]) s.corners[1] = s.corners[2];
      if (s.corners[0] == s.corners[2]) s.corners[2] = s.corners[1];
    }
    nodes_.reserve(2 * (sources_.size() / kBlock + 1));
    build(0, sources_.size());
  }

  std::size_t sources() const { return sources_.size(); }

  double at(const Vector& p, double growth, double best) const {
    struct Later {
      std::uint32_t node;
      double bid;
    };
    std::array<Later, 64> stack;  // nodes are halved: the depth is below 64
    std::size_t depth = 0;
    stack[depth++] = {0, bid(nodes_[0], p, growth)};
    while (depth > 0) {
      const Later top = stack[--depth];
      if (top.bid >= best) continue;
      const Node& node = nodes_[top.node];
      if (node.second == 0) {
        for (std::size_t i = node.begin; i < node.end; ++i) {
          const Source& s = sources_[i];
          if (s.size < best) best = std::min(best, s.size + growth * std::sqrt(squared_distance(p, s.corners)));
        }
        continue;
      }
      Later near{top.node + 1, bid(nodes_[top.node + 1], p, growth)};
      Later far{node.second, bid(nodes_[node.second], p, growth)};
      if (far.bid < near.bid) std::swap(near, far);
      if (far.bid < best) stack[depth++] = far;
      if (near.bid < best) stack[depth++] = near;
    }
    return best;
  }

 private:
  static constexpr std::size_t kBlock = 4;
  struct Node {
    Box box{};
    double size = kInfinity;   // the least
    std::uint32_t second = 0;  // the second child; the first one follows its parent. 0: a leaf
    std::uint32_t begin, end;  // its sources
  };
  std::vector<Source> sources_;
  std::vector<Node> nodes_;  // in the order of a descent

  static double bid(const Node& node, const Vector& p, double growth) {
    double distance = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double d = std::max({node.box.lo[k] - p[k], 0.0, p[k] - node.box.hi[k]});
      distance += d * d;
    }
    return node.size + growth * std::sqrt(distance);
  }

  static double middle(const Source& s, std::size_t axis) {
    const auto [low, high] = std::minmax({s.corners[0][axis], s.corners[1][axis], s.corners[2][axis]});
    return low / 2 + high / 2;
  }

  void build(std::size_t begin, std::size_t end) {
    const std::size_t number = nodes_.size();
    Node node{.begin = std::uint32_t(begin), .end = std::uint32_t(end)};
    for (std::size_t i = begin; i < end; ++i) {
      node.size = std::min(node.size, sources_[i].size);
      for (const Vector& corner : sources_[i].corners) node.box.extend(corner, corner);
    }
    nodes_.push_back(node);
    if (end - begin <= kBlock) return;
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      if (node.box.hi[k] - node.box.lo[k] > node.box.hi[axis] - node.box.lo[axis]) axis = k;
    }
    const std::size_t half = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return sources_.begin() + std::ptrdiff_t(i); };
    std::nth_element(at(begin), at(half), at(end),
                     [axis](const Source& s, const Source& t) { return middle(s, axis) < middle(t, axis); });
    build(begin, half);
    nodes_[number].second = std::uint32_t(nodes_.size());
    build(half, end);
  }
};

SizeField::SizeField(std::vector<Source> sources, double growth, double overall)
    : growth_(growth), overall_(overall) {
  if (!(growth > 0 && std::isfinite(growth)))
    throw InputError("a field of sizes grows by a number above 0 per unit of distance");
  if (!(overall > 0)) throw InputError("the overall size of a mesh must be above 0");
  for (const Source& s : sources) {
    bool finite = s.size > 0 && std::isfinite(s.size);
    for (const Vector& corner : s.corners) {
      for (const double x : corner) finite = finite && std::isfinite(x);
    }
    if (!finite) throw InputError("a source of sizes has finite corners and a finite size above 0");
  }
  if (!sources.empty()) tree_ = std::make_shared<const Tree>(std::move(sources));
}

std::size_t SizeField::sources() const { return tree_ == nullptr ? 0 : tree_->sources(); }

double SizeField::at(const Vector& p) const {
  return tree_ == nullptr ? overall_ : tree_->at(p, growth_, overall_);
}

}  // namespace cnrg
