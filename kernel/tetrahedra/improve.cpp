#include "kernel/tetrahedra/improve.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "kernel/base/error.h"
#include "kernel/tetrahedra/moves.h"

namespace cnrg {
namespace {

using Index = Stars::Index;
using Point = Stars::Point;

double cube(double x) { return x * x * x; }
constexpr double kInfinite = std::numeric_limits<double>::infinity();
/// Local moves are tried on all that is worse (cubed shape).
constexpr double kGood = 0.4 * 0.4 * 0.4;
/// Edges are as wanted between these, in lengths that are wanted.
constexpr double kLong = 1.4142, kShort = 0.7071;
/// Rounds of moves, of refinement to length, of refinement to shape.
constexpr int kMoveRounds = 6, kSizeRounds = 40, kShapeRounds = 40;
/// A tetrahedron with no edge longer than so many of its shortest one is not bad for its edges, but flat.
constexpr double kStretched = 1.5;

constexpr int kEdges[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

class Improver {
 public:
  Improver(ConformingTetrahedra& mesh, const ImproveOptions& options, const Watch& watch)
      : options_(options), watch_(watch), mesh_(mesh), moves_(mesh_, options.fixed, options.keep_boundary),
        begin_(std::chrono::steady_clock::now()) {
    if (options_.size) {
      for (Index v = 0; v < mesh_.point_count(); ++v) wanted_.push_back(options_.size(mesh_.point(v)));
    }
  }

  void run() {
    if (options_.size) to_length();
    watch_.begin("mesh: shapes");
    for (int round = 0; round < kMoveRounds && !over(); ++round) {
      if (sweep(kGood) * 200 < mesh_.size()) break;
    }
    to_shape();
    sweep(kGood);
  }

  ConformingTetrahedra result() const { return mesh_.mesh(); }

 private:
  const ImproveOptions& options_;
  const Watch& watch_;
  Stars mesh_;
  Moves moves_;
  const std::chrono::steady_clock::time_point begin_;
  std::vector<double> wanted_;  // by vertex
  std::size_t steps_ = 0;
  bool over_ = false;

  /// Asked between moves: is the time over? Throws Stopped.
  bool over() {
    if (over_ || ++steps_ % 256 != 0) return over_;
    watch_.check();
    if (options_.seconds > 0) {
      const std::chrono::duration<double> since = std::chrono::steady_clock::now() - begin_;
      over_ = since.count() > options_.seconds;
    }
    return over_;
  }

  /// One move that makes a tetrahedron better, or what comes in its place.
  bool mend(Index t) {
    const auto corners = mesh_.at(t).corners;
    for (const auto& [i, j] : kEdges)
      if (moves_.remove_edge(corners[std::size_t(i)], corners[std::size_t(j)])) return true;
    for (int k = 0; k < 4; ++k)
      if (moves_.swap_face(t, k)) return true;
    for (const Index v : corners)
      if (moves_.smooth(v)) return true;
    for (const auto& [i, j] : kEdges) {
      const Index a = corners[std::size_t(i)], b = corners[std::size_t(j)];
      const double longest = options_.size ? square(kLong * std::min(wanted(a), wanted(b))) : kInfinite;
      if (moves_.collapse(a, b, kInfinite, longest) || moves_.collapse(b, a, kInfinite, longest)) return true;
    }
    return false;
  }
  static double square(double x) { return x * x; }

  std::size_t sweep(double below) {
    std::size_t done = 0;
    for (Index t = 0; t < mesh_.size() && !over(); ++t) {
      for (int tries = 0; tries < 4 && mesh_.alive(t) && mesh_.at(t).shape < below; ++tries) {
        if (!mend(t)) break;
        ++done;
      }
    }
    return done;
  }

  double wanted(Index v) {
    while (wanted_.size() < mesh_.point_count())
      wanted_.push_back(options_.size(mesh_.point(Index(wanted_.size()))));
    return wanted_[v];
  }
  /// How many of the lengths that are wanted there an edge has.
  double length(Index a, Index b, std::int32_t region) {
    double h = (wanted(a) + wanted(b)) / 2;
    const auto r = static_cast<std::size_t>(region);
    if (region >= 0 && r < options_.region_size.size()) h = std::min(h, options_.region_size[r]);
    return std::sqrt(moves_.squared(a, b)) / h;
  }

  void to_length() {
    Steps steps(watch_, "mesh: lengths", 0);
    for (int round = 0; round < kSizeRounds && !over(); ++round) {
      std::size_t done = 0;
      const std::size_t all = mesh_.size();
      for (Index t = 0; t < all && !over(); ++t) {
        if (!mesh_.alive(t) || mesh_.at(t).region < 0) continue;
        const auto& tet = mesh_.at(t);
        double longest = kLong;
        Index a = 0, b = 0;
        for (const auto& [i, j] : kEdges) {
          const Index p = tet.corners[std::size_t(i)], q = tet.corners[std::size_t(j)];
          const double l = length(p, q, tet.region);
          if (l > longest) longest = l, a = p, b = q;
        }
        if (a != b && moves_.split(a, b) != Stars::kNoTetrahedron) ++done;
      }
      sweep(kGood / 8);
      if (done == 0) break;
    }
    for (Index t = 0; t < mesh_.size() && !over(); ++t) {
      if (!mesh_.alive(t) || mesh_.at(t).region < 0) continue;
      const auto tet = mesh_.at(t);
      for (const auto& [i, j] : kEdges) {
        const Index p = tet.corners[std::size_t(i)], q = tet.corners[std::size_t(j)];
        if (length(p, q, tet.region) >= kShort) continue;
        const double longest = square(kLong * std::min(wanted(p), wanted(q)));
        if (moves_.collapse(p, q, kGood / 8, longest) || moves_.collapse(q, p, kGood / 8, longest)) break;
      }
    }
  }

  void to_shape() {
    const double bad = cube(options_.shape);
    std::size_t added = 0;
    std::vector<Index> worst;
    for (int round = 0; round < kShapeRounds && !over(); ++round) {
      std::size_t done = 0;
      worst.clear();
      for (Index t = 0; t < mesh_.size(); ++t)
        if (mesh_.alive(t) && mesh_.at(t).shape < bad) worst.push_back(t);
      if (worst.empty()) break;
      for (const Index t : worst) {
        if (over() || added >= options_.points) break;
        if (!mesh_.alive(t) || !(mesh_.at(t).shape < bad)) continue;
        const auto corners = mesh_.at(t).corners;
        double longest = 0, shortest = kInfinite;
        Index a = 0, b = 0;
        for (const auto& [i, j] : kEdges) {
          const Index p = corners[std::size_t(i)], q = corners[std::size_t(j)];
          const double l = moves_.squared(p, q);
          shortest = std::min(shortest, l);
          if (l > longest) longest = l, a = p, b = q;
        }
        if (longest < shortest * square(kStretched)) continue;
        if (moves_.split(a, b) == Stars::kNoTetrahedron) continue;
        ++done, ++added;
      }
      if (done == 0) break;
      sweep(kGood / 8);
    }
  }
};

}  // namespace

void improve(ConformingTetrahedra& mesh, const ImproveOptions& options, const Watch& watch) {
  Improver improver(mesh, options, watch);
  improver.run();
  mesh = improver.result();
}

double shape_of(const ConformingTetrahedra::Point& a, const ConformingTetrahedra::Point& b,
                const ConformingTetrahedra::Point& c, const ConformingTetrahedra::Point& d) {
  double u[3], v[3], w[3], squares = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    u[k] = b[k] - a[k], v[k] = c[k] - a[k], w[k] = d[k] - a[k];
    const double p = v[k] - u[k], q = w[k] - u[k], r = w[k] - v[k];
    squares += u[k] * u[k] + v[k] * v[k] + w[k] * w[k] + p * p + q * q + r * r;
  }
  const double det = w[0] * (u[1] * v[2] - u[2] * v[1]) + w[1] * (u[2] * v[0] - u[0] * v[2]) +
                     w[2] * (u[0] * v[1] - u[1] * v[0]);
  return squares > 0 ? 12 * std::cbrt(det * det / 4) / squares : 0;
}

}  // namespace cnrg
