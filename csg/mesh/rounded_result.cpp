// That rounded facets do not cross is not enough: a shell, a wire or a point may have moved through a wall as a
// whole. So the rounded facets are refined to a complex, and each of its regions must have the sides of faces that
// the region of the exact result has; each wire and point must lie in its old region.
//
// Seeds are proposed in doubles, by rays across a region, and proven by exact location in that complex.
#include "csg/mesh/rounded_result.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "csg/mesh/mesh.h"
#include "kernel/base/counts.h"
#include "kernel/base/error.h"
#include "kernel/base/limits.h"
#include "kernel/base/vectors.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

using Index = FlatComplex::Index;
using Vector = DoubleVector;

/// Where the ray from p along d meets the triangle, as a multiple of d; infinite if it does not. It only proposes
/// points, which are proven afterwards.
double distance_along(const Vector& p, const Vector& d, const Vector& a, const Vector& b, const Vector& c) {
  const Vector u = minus(b, a), v = minus(c, a), n = cross(d, v), w = minus(p, a), q = cross(w, u);
  const double det = dot(u, n);
  if (det == 0) return HUGE_VAL;
  const double s = dot(w, n) / det, t = dot(d, q) / det, at = dot(v, q) / det;
  constexpr double kSlack = 1e-9;  // rays through an edge must not pass between two triangles
  return s >= -kSlack && t >= -kSlack && s + t <= 1 + kSlack && at > 0 ? at : HUGE_VAL;
}

}  // namespace

struct RoundedResult::Data {
  Redrawing drawn;
  Locator locator;
  std::vector<Index> first_triangle;  // in the drawing, of each face
  std::vector<HalfFace> front;        // of each triangle of the drawing
  std::vector<RegionId> region;       // of the rounded complex, for each region of the result
  explicit Data(Redrawing redrawing) : drawn(std::move(redrawing)), locator(*drawn.complex) {}
};

RoundedResult::RoundedResult(const ResultView& view, const FlatComplex& flat, const std::string& format,
                             const std::stop_token& stop)
    : flat_(flat), format_(format), points_(round_points(view, flat)) {
  data_ = std::make_unique<Data>(redraw(points_, drawing_of(flat), stop));
  if (!data_->drawn.is_embedded()) {
    fail("makes facets cross (" + std::to_string(points_.moved) + " vertices move)");
  }
  match_regions();
  match_wires_and_points();
}

RoundedResult::~RoundedResult() = default;

void refuse_rounding(const std::string& format, const std::string& what) {
  throw RoundingFault(
      format + " holds doubles, and rounding to them " + what +
      "; snap the result first (`cnrg` does so by itself, without --no-snap and --curved; in programs " +
      "`snap`), or write .json, which is exact");
}

void RoundedResult::fail(const std::string& what) const { refuse_rounding(format_, what); }

void RoundedResult::match_regions() {
  const Complex& complex = *data_->drawn.complex;
  auto& first = data_->first_triangle;
  Index n = 0;
  for (const auto& face : flat_.faces) {
    first.push_back(n);
    n = place32(n + std::uint64_t{face.triangles.size()}, "triangles");
  }
  first.push_back(n);
  data_->front.resize(n);
  for (const FaceId f : IdRange<FaceId>(complex.face_count())) {
    const Cover& cover = complex.cover(f)[0];
    data_->front[complex.sources[cover.source].leaf_face] = HalfFace(f, cover.same ? 0 : 1);
  }
  std::map<RegionId, Index> owner;
  data_->region.assign(flat_.regions.size(), RegionId::none());
  for (Index i = 0; i < flat_.regions.size(); ++i) {
    RegionId& region = data_->region[i];
    bool same = true;
    for (const auto& shell : flat_.regions[i].shells) {
      for (const Index side : shell) {
        for (Index t = first[side >> 1]; t < first[(side >> 1) + 1]; ++t) {
          const HalfFace front = data_->front[t];
          const RegionId here = complex.region((side & 1) == 0 ? front : front.opposite());
          if (!region.valid()) region = here;
          same = same && here == region;
        }
      }
    }
    if (!region.valid()) continue;
    same = same && owner.try_emplace(region, i).second && (region == RegionId(0)) == !flat_.regions[i].bounded;
    if (!same) {
      fail("moves a part of the result through a wall");
    }
  }
}

void RoundedResult::match_wires_and_points() const {
  const Complex& complex = *data_->drawn.complex;
  const auto check = [&](RegionId found, Index region) {
    if (region == kNone || !data_->region[region].valid() || found == data_->region[region]) return;
    fail("moves a wire or a point through a wall");
  };
  for (const auto& edge : flat_.edges) {
    if (!edge.wire) continue;
    for_each_segment(edge, [&](Index from, Index to) {
      const RationalPoint a = from_doubles(points_.xyz[from]), b = from_doubles(points_.xyz[to]);
      const Location at = data_->locator.locate({(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2});
      require(at.dimension == 1, "rounded result: the middle of a wire is not on it");
      check(complex.some_region(at.edge), edge.region);
    });
  }
  for (const auto& vertex : flat_.vertices) {
    if (vertex.region == kNone) continue;
    const Location at = data_->locator.locate(from_doubles(points_.xyz[vertex.point]));
    require(at.dimension == 0, "rounded result: a point is not where it is");
    check(complex.some_region(at.vertex), vertex.region);
  }
}

Vector RoundedResult::seed(Index region) const {
  struct Triangle {
    Vector a, b, c, inward;
    double area;
  };
  std::vector<Triangle> triangles;
  for (const auto& shell : flat_.regions[region].shells) {
    for (const Index side : shell) {
      for (const auto& t : flat_.faces[side >> 1].triangles) {
        const Vector &a = points_.xyz[t[0]], &b = points_.xyz[t[1]], &c = points_.xyz[t[2]];
        Vector n = cross(minus(b, a), minus(c, a));
        const double area = std::sqrt(dot(n, n));
        for (double& x : n) x = (side & 1) == 0 ? x / area : -x / area;
        triangles.push_back({a, b, c, n, area});
      }
    }
  }
  std::stable_sort(triangles.begin(), triangles.end(),
                   [](const Triangle& s, const Triangle& t) { return s.area > t.area; });
  // From the middle of a large triangle half-way to what is opposite; of several such points the roomiest.
  constexpr std::size_t kAtOnce = 16, kAtMost = 1024;
  std::vector<std::pair<double, Vector>> proposals;
  for (std::size_t i = 0; i < std::min(triangles.size(), kAtMost); ++i) {
    const Triangle& from = triangles[i];
    Vector middle;
    for (std::size_t k = 0; k < 3; ++k) middle[k] = (from.a[k] + from.b[k] + from.c[k]) / 3;
    double gap = HUGE_VAL;
    for (std::size_t j = 0; j < triangles.size(); ++j) {
      if (j != i)
        gap = std::min(gap, distance_along(middle, from.inward, triangles[j].a, triangles[j].b, triangles[j].c));
    }
    if (std::isfinite(gap)) {
      for (std::size_t k = 0; k < 3; ++k) middle[k] += from.inward[k] * gap / 2;
      proposals.emplace_back(gap, middle);
    }
    if (i + 1 < std::min(triangles.size(), kAtMost) && (i + 1) % kAtOnce != 0) continue;
    std::stable_sort(proposals.begin(), proposals.end(),
                     [](const auto& s, const auto& t) { return s.first > t.first; });
    for (const auto& [distance, point] : proposals) {
      const Location at = data_->locator.locate(from_doubles(point));
      if (at.dimension == 3 && at.region == data_->region[region]) return point;
    }
    proposals.clear();
  }
  throw InputError(format_ +
                   " needs a point of doubles inside of every region, and one region is too thin for "
                   "that; make it thicker, let it vanish by --join, or move the model nearer to the origin");
}

}  // namespace cnrg
