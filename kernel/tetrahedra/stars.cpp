#include "kernel/tetrahedra/stars.h"

#include <cmath>

#include "kernel/base/error.h"
#include "kernel/base/per_thread.h"
#include "kernel/base/sorted.h"
#include "kernel/exact/predicates.h"
#include "kernel/tetrahedra/tetrahedra.h"

namespace cnrg {
namespace {

using Index = Stars::Index;
using Point = Stars::Point;

/// The shape of what is in no region counts so many times, and as so much (of 0.02) at least: nobody cares for it,
/// but what is nearly flat there lets no vertex on the boundary move, and is to be mended where that spoils
/// nothing inside.
constexpr double kOutside = 1e12, kFlatOutside = 0.02 * 0.02 * 0.02;

/// The two other places, so that (i, j, first, second) is an even permutation.
struct Others {
  std::array<std::array<std::array<int, 2>, 4>, 4> of{};
  constexpr Others() {
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        if (i == j) continue;
        int rest[2] = {-1, -1}, n = 0;
        for (int k = 0; k < 4; ++k)
          if (k != i && k != j) rest[n++] = k;
        const int p[4] = {i, j, rest[0], rest[1]};
        int inversions = 0;
        for (int x = 0; x < 4; ++x)
          for (int y = x + 1; y < 4; ++y) inversions += p[x] > p[y];
        const bool even = inversions % 2 == 0;
        of[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = {even ? rest[0] : rest[1],
                                                                        even ? rest[1] : rest[0]};
      }
    }
  }
};
constexpr Others kOthers;

}  // namespace

Stars::Stars(const ConformingTetrahedra& mesh, const Watch& watch)
    : points_(mesh.points),
      stars_(mesh.points.size()),
      lines_(mesh.points.size()),
      facet_of_(mesh.points.size(), kNone),
      last_change_(mesh.points.size(), changes_) {
  double extent = 0;
  for (const Point& p : points_) {
    for (std::size_t k = 0; k < 3; ++k) extent = std::max(extent, std::fabs(p[k] - points_[0][k]));
  }
  if (extent > 0 && std::isfinite(extent)) scale_ = std::ldexp(1.0, -std::ilogb(extent));
  tetrahedra_.reserve(mesh.tetrahedra.size());
  for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i) {
    watch.check();
    Tetrahedron t{mesh.tetrahedra[i], {kNone, kNone, kNone, kNone}, mesh.region[i], 0};
    t.shape = measure(t.corners, t.region);
    require(t.shape >= 0, "tetrahedra: one is turned wrong");
    add(t);
  }
  const ConformingTetrahedra bordered = with_border(mesh, watch);
  set_facets(bordered, watch);
  set_lines(bordered);
}

/// The same triangles, and those of the border that are on no facet, each as a facet of its own: what is on them
/// may not leave them either.
ConformingTetrahedra Stars::with_border(const ConformingTetrahedra& mesh, const Watch& watch) {
  ConformingTetrahedra out;
  out.triangles = mesh.triangles, out.facet = mesh.facet;
  out.segments = mesh.segments, out.line = mesh.line;
  for (const std::int32_t f : mesh.facet) named_ = std::max(named_, f + 1);
  std::vector<std::array<Index, 3>> once, walls;
  for (const auto& t : mesh.triangles) walls.push_back(sorted(t));
  std::sort(walls.begin(), walls.end());
  for (const auto& t : mesh.tetrahedra) {
    for (std::size_t k = 0; k < 4; ++k)
      once.push_back(sorted(std::array{t[(k + 1) % 4], t[(k + 2) % 4], t[(k + 3) % 4]}));
  }
  watch.check();
  std::sort(once.begin(), once.end());
  watch.check();
  std::int32_t facet = named_;
  for (std::size_t i = 0; i < once.size(); ++i) {
    if (i + 1 < once.size() && once[i + 1] == once[i]) {
      ++i;
      continue;
    }
    if (std::binary_search(walls.begin(), walls.end(), once[i])) continue;
    out.triangles.push_back(once[i]);
    out.facet.push_back(facet++);
  }
  return out;
}

void Stars::set_facets(const ConformingTetrahedra& mesh, const Watch& watch) {
  struct Side {
    std::array<Index, 3> corners;
    Index triangle;
  };
  std::vector<Side> walls;
  std::int32_t count = 0;
  std::vector<double> areas;
  for (Index i = 0; i < mesh.triangles.size(); ++i) {
    walls.push_back({sorted(mesh.triangles[i]), i});
    count = std::max(count, mesh.facet[i] + 1);
  }
  normals_.resize(static_cast<std::size_t>(count)), origins_.resize(static_cast<std::size_t>(count));
  areas.resize(static_cast<std::size_t>(count), -1);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto f = static_cast<std::size_t>(mesh.facet[i]);
    const auto& [a, b, c] = mesh.triangles[i];
    Point u, v, n;
    for (std::size_t k = 0; k < 3; ++k) {
      u[k] = (points_[b][k] - points_[a][k]) * scale_;
      v[k] = (points_[c][k] - points_[a][k]) * scale_;
    }
    for (std::size_t k = 0; k < 3; ++k) n[k] = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
    const double area = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (area <= areas[f]) continue;
    areas[f] = area;
    for (std::size_t k = 0; k < 3; ++k) normals_[f][k] = area > 0 ? n[k] / area : 0;
    origins_[f] = points_[a];
  }
  std::sort(walls.begin(), walls.end(), [](const Side& a, const Side& b) { return a.corners < b.corners; });
  for (auto& t : tetrahedra_) {
    watch.check();
    for (std::size_t k = 0; k < 4; ++k) {
      const auto f = sorted(std::array{t.corners[(k + 1) % 4], t.corners[(k + 2) % 4], t.corners[(k + 3) % 4]});
      const auto at = std::lower_bound(walls.begin(), walls.end(), f,
                                       [](const Side& s, const auto& corners) { return s.corners < corners; });
      if (at != walls.end() && at->corners == f) t.facets[k] = mesh.facet[at->triangle];
    }
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const Index v : mesh.triangles[i]) {
      std::int32_t& of = facet_of_[v];
      of = of == kNone || of == mesh.facet[i] ? mesh.facet[i] : kMany;
    }
  }
}

void Stars::set_lines(const ConformingTetrahedra& mesh) {
  for (std::size_t i = 0; i < mesh.segments.size(); ++i) {
    const auto& [a, b] = mesh.segments[i];
    if (line(a, b) == kNone) add_line(a, b, mesh.line[i]);
  }
  struct Side {
    std::array<Index, 2> ends;
    std::int32_t facet;
  };
  std::vector<Side> sides;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      sides.push_back({sorted(std::array{mesh.triangles[i][k], mesh.triangles[i][(k + 1) % 3]}), mesh.facet[i]});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.ends < b.ends; });
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    while (end < sides.size() && sides[end].ends == sides[i].ends) ++end;
    const bool inside = end - i == 2 && sides[i].facet == sides[i + 1].facet;
    const auto& [a, b] = sides[i].ends;
    if (!inside && line(a, b) == kNone) add_line(a, b, kRidge);
  }
  for (Index v = 0; v < lines_.size(); ++v) {
    if (!lines_[v].empty()) facet_of_[v] = kMany;
  }
}

ConformingTetrahedra Stars::mesh() const {
  ConformingTetrahedra out;
  out.points = points_;
  struct Wall {
    std::array<Index, 3> corners;
    std::int32_t facet;
    auto operator<=>(const Wall&) const = default;
  };
  std::vector<Wall> walls;
  for (const auto& t : tetrahedra_) {
    if (t.shape < 0) continue;
    out.tetrahedra.push_back(t.corners);
    out.region.push_back(t.region);
    for (std::size_t k = 0; k < 4; ++k) {
      if (t.facets[k] == kNone || t.facets[k] >= named_) continue;
      walls.push_back({sorted(std::array{t.corners[(k + 1) % 4], t.corners[(k + 2) % 4], t.corners[(k + 3) % 4]}),
                       t.facets[k]});
    }
  }
  sort_unique(walls);
  for (const Wall& wall : walls) {
    out.triangles.push_back(wall.corners);
    out.facet.push_back(wall.facet);
  }
  for (Index v = 0; v < lines_.size(); ++v) {
    for (const Line& line : lines_[v]) {
      if (line.to < v || line.line < 0) continue;
      out.segments.push_back({v, line.to});
      out.line.push_back(line.line);
    }
  }
  return out;
}

std::array<Index, 3> Stars::Tetrahedron::face(int k) const {
  std::array<Index, 3> out;
  for (std::size_t i = 0; i < 3; ++i)
    out[i] = corners[static_cast<std::size_t>(Tetrahedra::kFace[static_cast<std::size_t>(k)][i])];
  return out;
}

Index Stars::add_point(const Point& p, std::int32_t facet) {
  check_count(points_.size() + 1, "points");
  points_.push_back(p);
  stars_.emplace_back();
  lines_.emplace_back();
  facet_of_.push_back(facet);
  last_change_.push_back(changes_);
  return static_cast<Index>(points_.size() - 1);
}

void Stars::drop_point() {
  points_.pop_back(), stars_.pop_back(), lines_.pop_back(), facet_of_.pop_back(), last_change_.pop_back();
}

Index Stars::add(const Tetrahedron& t) {
  Index i;
  if (free_.empty()) {
    check_count(tetrahedra_.size() + 1, "tetrahedra");
    i = static_cast<Index>(tetrahedra_.size());
    tetrahedra_.push_back(t);
    settled_.push_back(0);
  } else {
    i = free_.back();
    free_.pop_back();
    tetrahedra_[i] = t;
  }
  for (const Index v : t.corners) {
    stars_[v].push_back(i);
    last_change_[v] = changes_;
  }
  return i;
}

void Stars::replace(std::span<const Index> old, std::span<const Tetrahedron> fresh) {
  ++changes_;
  for (const Index t : old) {
    for (const Index v : tetrahedra_[t].corners) {
      last_change_[v] = changes_;
      auto& star = stars_[v];
      *std::find(star.begin(), star.end(), t) = star.back();
      star.pop_back();
    }
    tetrahedra_[t].shape = -1;
    free_.push_back(t);
  }
  for (const Tetrahedron& t : fresh) add(t);
}

void Stars::set_shapes(Index v, std::span<const double> shapes) {
  ++changes_;
  std::size_t n = 0;
  for (const Index t : stars_[v]) {
    tetrahedra_[t].shape = shapes[n++];
    for (const Index w : tetrahedra_[t].corners) last_change_[w] = changes_;
  }
}

double Stars::measure(const std::array<Index, 4>& corners, std::int32_t region, double bar) const {
  const Point &a = points_[corners[0]], &b = points_[corners[1]], &c = points_[corners[2]],
              &d = points_[corners[3]];
  double u[3], v[3], w[3], squares = 0, box = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    u[k] = (b[k] - a[k]) * scale_, v[k] = (c[k] - a[k]) * scale_, w[k] = (d[k] - a[k]) * scale_;
    const double p = v[k] - u[k], q = w[k] - u[k], r = w[k] - v[k];
    squares += u[k] * u[k] + v[k] * v[k] + w[k] * w[k] + p * p + q * q + r * r;
    box *= std::max({std::fabs(u[k]), std::fabs(v[k]), std::fabs(w[k])});
  }
  const double det =
      w[0] * (u[1] * v[2] - u[2] * v[1]) + w[1] * (u[2] * v[0] - u[0] * v[2]) + w[2] * (u[0] * v[1] - u[1] * v[0]);
  // The bound of the filter of orient3d (kernel/exact/predicates.cpp); what underflows is left to the exact stage.
  const double bound = 6e-15 * box;
  const auto cubed = [&] {
    const double shape = 432 * det * det / (squares * squares * squares);
    return region < 0 ? std::max(kFlatOutside, kOutside * shape) : shape;
  };
  if (!(det > bound && box > 1e-200)) {
    if (det < -bound && box > 1e-200) return -1;
    if (cubed() <= bar) return -1;
    if (orient3d(a.data(), b.data(), c.data(), d.data()) <= 0) return -1;
  }
  const double shape = cubed();
  return std::isfinite(shape) ? shape : 0;
}

bool Stars::ring(Index a, Index b, Ring& out) const {
  struct Link {
    Index from, to, tetrahedron;
  };
  struct Links {
    std::vector<Link> list;
  };
  auto& links = PerThread<Links>::own().list;
  links.clear();
  for (const Index t : stars_[a]) {
    const Tetrahedron& tet = tetrahedra_[t];
    const int j = tet.place(b);
    if (j < 0) continue;
    const auto& [c, d] = kOthers.of[static_cast<std::size_t>(tet.place(a))][static_cast<std::size_t>(j)];
    links.push_back({tet.corners[static_cast<std::size_t>(c)], tet.corners[static_cast<std::size_t>(d)], t});
  }
  out.around.clear(), out.tetrahedra.clear();
  if (links.empty()) return false;
  // From where nothing comes before, if there is such a place.
  std::size_t first = 0;
  out.closed = true;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const bool begins =
        std::none_of(links.begin(), links.end(), [&](const Link& l) { return l.to == links[i].from; });
    if (begins) first = i, out.closed = false;
  }
  std::swap(links[0], links[first]);
  for (std::size_t i = 0; i < links.size(); ++i) {
    out.around.push_back(links[i].from);
    out.tetrahedra.push_back(links[i].tetrahedron);
    const auto next = std::find_if(links.begin() + static_cast<std::ptrdiff_t>(i) + 1, links.end(),
                                   [&](const Link& l) { return l.from == links[i].to; });
    if (next != links.end()) std::swap(links[i + 1], *next);
    else if (i + 1 < links.size()) return false;
  }
  if (!out.closed) out.around.push_back(links.back().to);
  return true;
}

Index Stars::across(Index t, int k) const {
  const auto& c = tetrahedra_[t].corners;
  Index p = c[static_cast<std::size_t>((k + 1) % 4)], q = c[static_cast<std::size_t>((k + 2) % 4)],
        r = c[static_cast<std::size_t>((k + 3) % 4)];
  if (stars_[q].size() < stars_[p].size()) std::swap(p, q);
  if (stars_[r].size() < stars_[p].size()) std::swap(p, r);
  for (const Index u : stars_[p]) {
    if (u != t && tetrahedra_[u].has(q) && tetrahedra_[u].has(r)) return u;
  }
  return kNoTetrahedron;
}

std::int32_t Stars::line(Index a, Index b) const {
  for (const Line& l : lines_[a])
    if (l.to == b) return l.line;
  return kNone;
}

void Stars::add_line(Index a, Index b, std::int32_t line) {
  lines_[a].push_back({b, line});
  lines_[b].push_back({a, line});
}

void Stars::remove_line(Index a, Index b) {
  std::erase_if(lines_[a], [&](const Line& l) { return l.to == b; });
  std::erase_if(lines_[b], [&](const Line& l) { return l.to == a; });
}

}  // namespace cnrg
