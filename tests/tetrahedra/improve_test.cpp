// Improved tetrahedra against what they were: the same box, the same regions, facets and segments in other pieces.
#include "kernel/tetrahedra/improve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <map>
#include <random>
#include <set>
#include <vector>

#include "kernel/exact/predicates.h"
#include "kernel/tetrahedra/moves.h"
#include "kernel/tetrahedra/shapes.h"
#include "tests/catch.h"
#include "tests/scenes/seeds.h"
#include "tests/tetrahedra/random_triangles.h"

namespace cnrg {
namespace {

using Mesh = ConformingTetrahedra;
using Index = Mesh::Index;
using MeshTriangle = std::array<Index, 3>;
using Vector = Mesh::Point;

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double length(const Vector& a) { return std::sqrt(dot(a, a)); }

template <std::size_t N>
std::array<Index, N> sorted(std::array<Index, N> corners) {
  std::sort(corners.begin(), corners.end());
  return corners;
}

bool turned_right(const Mesh& mesh) {
  const auto& p = mesh.points;
  return std::all_of(mesh.tetrahedra.begin(), mesh.tetrahedra.end(), [&](const auto& t) {
    return orient3d(p[t[0]].data(), p[t[1]].data(), p[t[2]].data(), p[t[3]].data()) > 0;
  });
}

/// What stays the same: volumes of regions, areas of facets, lengths of lines.
struct Measures {
  std::map<std::int32_t, double> volumes, areas, lengths;
};
Measures measures(const Mesh& mesh) {
  Measures out;
  const auto& p = mesh.points;
  for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i) {
    const auto& [a, b, c, d] = mesh.tetrahedra[i];
    out.volumes[mesh.region[i]] += dot(minus(p[b], p[a]), cross(minus(p[c], p[a]), minus(p[d], p[a]))) / 6;
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    out.areas[mesh.facet[i]] += length(cross(minus(p[b], p[a]), minus(p[c], p[a]))) / 2;
  }
  for (std::size_t i = 0; i < mesh.segments.size(); ++i)
    out.lengths[mesh.line[i]] += length(minus(p[mesh.segments[i][0]], p[mesh.segments[i][1]]));
  return out;
}

void require_near(const std::map<std::int32_t, double>& a, const std::map<std::int32_t, double>& b, double room) {
  REQUIRE(a.size() == b.size());
  for (const auto& [key, value] : a) {
    INFO("number " << key);
    REQUIRE(b.contains(key));
    REQUIRE(std::fabs(value - b.at(key)) <= room);
  }
}

/// Face to face; regions part at facets only; triangles are faces, segments edges; facets are planar.
void require_conforming(const Mesh& mesh, double extent) {
  std::map<MeshTriangle, std::vector<std::int32_t>> faces;
  std::set<std::array<Index, 2>> edges;
  for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i) {
    const auto& t = mesh.tetrahedra[i];
    for (std::size_t k = 0; k < 4; ++k) {
      faces[sorted(MeshTriangle{t[(k + 1) % 4], t[(k + 2) % 4], t[(k + 3) % 4]})].push_back(mesh.region[i]);
      for (std::size_t l = 0; l < k; ++l) edges.insert(sorted(std::array{t[k], t[l]}));
    }
  }
  std::set<MeshTriangle> walls;
  std::map<std::int32_t, std::vector<MeshTriangle>> of_facet;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const MeshTriangle f = sorted(mesh.triangles[i]);
    REQUIRE(faces.contains(f));
    REQUIRE(walls.insert(f).second);
    of_facet[mesh.facet[i]].push_back(f);
  }
  for (const auto& [f, regions] : faces) {
    REQUIRE(regions.size() <= 2);
    if (regions.size() == 2 && regions[0] != regions[1]) REQUIRE(walls.contains(f));
  }
  for (const auto& s : mesh.segments) REQUIRE(edges.contains(sorted(s)));
  for (const auto& [facet, triangles] : of_facet) {
    const auto& p = mesh.points;
    Vector n{};
    for (const MeshTriangle& f : triangles) {
      const Vector m = cross(minus(p[f[1]], p[f[0]]), minus(p[f[2]], p[f[0]]));
      if (length(m) > length(n)) n = m;
    }
    for (const MeshTriangle& f : triangles) {
      for (const Index v : f)
        REQUIRE(std::fabs(dot(minus(p[v], p[triangles[0][0]]), n)) <= 1e-9 * length(n) * extent);
    }
  }
}

/// The tetrahedra of random triangles in doubles, parted into regions by the triangles. Empty where rounding turns
/// one.
Mesh random_mesh(std::uint64_t seed, Index& fixed) {
  std::mt19937_64 random(seed);
  PointTable t;
  const Constraints constraints = random_triangles(random, t);
  const ConstrainedTetrahedra made = constrained_tetrahedra(t, constraints, {});
  Mesh mesh;
  for (std::size_t i = 0; i < t.size(); ++i) mesh.points.push_back(t.nearest(VertexId(i)));
  fixed = static_cast<Index>(t.size());
  for (const auto& c : made.tetrahedra)
    mesh.tetrahedra.push_back(
        {Index(c[0].index()), Index(c[1].index()), Index(c[2].index()), Index(c[3].index())});
  if (!turned_right(mesh)) return {};
  std::set<MeshTriangle> walls;
  for (const auto& [corners, of] : made.triangles) {
    mesh.triangles.push_back({Index(corners[0].index()), Index(corners[1].index()), Index(corners[2].index())});
    mesh.facet.push_back(std::int32_t(of));
    walls.insert(sorted(mesh.triangles.back()));
  }
  for (const auto& [ends, of] : made.segments) {
    mesh.segments.push_back({Index(ends[0].index()), Index(ends[1].index())});
    mesh.line.push_back(std::int32_t(of));
  }
  std::map<MeshTriangle, std::vector<std::size_t>> faces;
  for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i) {
    const auto& c = mesh.tetrahedra[i];
    for (std::size_t k = 0; k < 4; ++k)
      faces[sorted(MeshTriangle{c[(k + 1) % 4], c[(k + 2) % 4], c[(k + 3) % 4]})].push_back(i);
  }
  mesh.region.assign(mesh.tetrahedra.size(), -1);
  std::int32_t count = 0;
  for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i) {
    if (mesh.region[i] >= 0) continue;
    std::vector<std::size_t> list{i};
    mesh.region[i] = count;
    for (std::size_t at = 0; at < list.size(); ++at) {
      const auto& c = mesh.tetrahedra[list[at]];
      for (std::size_t k = 0; k < 4; ++k) {
        const MeshTriangle f = sorted(MeshTriangle{c[(k + 1) % 4], c[(k + 2) % 4], c[(k + 3) % 4]});
        if (walls.contains(f)) continue;
        for (const std::size_t u : faces[f]) {
          if (mesh.region[u] >= 0) continue;
          mesh.region[u] = count;
          list.push_back(u);
        }
      }
    }
    ++count;
  }
  return mesh;
}

std::size_t bad(const Mesh& mesh) {
  return std::size_t(std::count_if(mesh.tetrahedra.begin(), mesh.tetrahedra.end(), [&](const auto& t) {
    return shape_of(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]) < 0.1;
  }));
}
double extent(const Mesh& mesh) {
  double most = 0;
  for (const auto& p : mesh.points) most = std::max(most, length(minus(p, mesh.points[0])));
  return most;
}

void require_same(const Mesh& before, const Mesh& after) {
  const double size = extent(before);
  REQUIRE(turned_right(after));
  require_conforming(after, size);
  const Measures a = measures(before), b = measures(after);
  require_near(a.volumes, b.volumes, 1e-9 * size * size * size);
  require_near(a.areas, b.areas, 1e-9 * size * size);
  require_near(a.lengths, b.lengths, 1e-9 * size);
}

TEST_CASE("improved tetrahedra have the regions, facets and lines that they had", "[tetrahedra]") {
  const auto [begin, end] = scenes::seeds(30);
  std::size_t made = 0, share_before = 0, share_after = 0;
  for (std::uint64_t seed = begin; seed < end; ++seed) {
    INFO("seed " << seed);
    Index fixed = 0;
    const Mesh before = random_mesh(seed, fixed);
    if (before.tetrahedra.empty()) continue;
    ++made;
    ImproveOptions options;
    options.fixed = fixed;
    options.points = 2000;
    options.keep_boundary = seed % 4 == 3;
    Mesh after = before;
    improve(after, options, {});
    require_same(before, after);
    share_before += 1000 * bad(before) / before.tetrahedra.size();
    share_after += 1000 * bad(after) / after.tetrahedra.size();
    for (Index v = 0; v < fixed; ++v) REQUIRE(after.points[v] == before.points[v]);
    if (options.keep_boundary) {
      REQUIRE(after.segments.size() == before.segments.size());
      REQUIRE(after.triangles.size() == before.triangles.size());
    }
  }
  CHECK(made * 10 > (end - begin) * 9);
  CHECK(share_after * 2 < share_before);
}

// A hundred short pieces in a box a hundred times as wide: each is an edge of tetrahedra to its far corners.
TEST_CASE("a fine wire in a wide box gets good tetrahedra, not many", "[tetrahedra]") {
  PointTable t;
  Constraints constraints;
  constexpr int kPieces = 100;
  for (int i = 0; i <= kPieces; ++i) {
    t.add(std::cos(0.3 * i), std::sin(0.3 * i), 0.1 * i);
    if (i > 0) constraints.segments.push_back({VertexId(std::size_t(i) - 1), VertexId(std::size_t(i))});
  }
  for (int i = 0; i < 8; ++i) t.add((i & 1) != 0 ? 99 : -101, (i & 2) != 0 ? 99 : -101, (i & 4) != 0 ? 99 : -101);
  const auto fixed = static_cast<Index>(t.size());
  const ConstrainedTetrahedra made = constrained_tetrahedra(t, constraints, {});
  Mesh mesh;
  for (std::size_t i = 0; i < t.size(); ++i) mesh.points.push_back(t.nearest(VertexId(i)));
  for (const auto& c : made.tetrahedra)
    mesh.tetrahedra.push_back(
        {Index(c[0].index()), Index(c[1].index()), Index(c[2].index()), Index(c[3].index())});
  mesh.region.assign(mesh.tetrahedra.size(), 0);
  for (const auto& [ends, of] : made.segments) {
    mesh.segments.push_back({Index(ends[0].index()), Index(ends[1].index())});
    mesh.line.push_back(std::int32_t(of));
  }
  REQUIRE(turned_right(mesh));
  const Mesh before = mesh;
  CHECK(bad(before) * 2 > before.tetrahedra.size());
  ImproveOptions options;
  options.fixed = fixed;
  options.points = 5000;
  improve(mesh, options, {});
  require_same(before, mesh);
  CHECK(bad(mesh) * 100 < mesh.tetrahedra.size());
  CHECK(mesh.tetrahedra.size() < 100 * kPieces);
}

TEST_CASE("tetrahedra get the lengths that are wanted", "[tetrahedra]") {
  for (std::uint64_t seed = 1; seed < 4; ++seed) {
    INFO("seed " << seed);
    Index fixed = 0;
    const Mesh before = random_mesh(seed, fixed);
    if (before.tetrahedra.empty()) continue;
    const double h = extent(before) / 12;
    ImproveOptions options;
    options.fixed = fixed;
    options.points = 2000;
    options.size = [&](const Vector&) { return h; };
    Mesh after = before;
    improve(after, options, {});
    require_same(before, after);
    std::size_t longer = 0, all = 0;
    for (const auto& t : after.tetrahedra) {
      for (std::size_t k = 0; k < 4; ++k) {
        for (std::size_t l = 0; l < k; ++l, ++all)
          longer += length(minus(after.points[t[k]], after.points[t[l]])) > 1.6 * h;
      }
    }
    CHECK(longer * 50 < all);
  }
}

TEST_CASE("no edge is longer in the end than somebody wants", "[tetrahedra]") {
  for (std::uint64_t seed = 1; seed < 6; ++seed) {
    INFO("seed " << seed);
    Index fixed = 0;
    const Mesh before = random_mesh(seed, fixed);
    if (before.tetrahedra.empty()) continue;
    // In odd regions half as long; and as a mesher leaves it, or as the improver makes it to other lengths.
    const double h = extent(before) / 6;
    const auto wanted = [h](std::int32_t region) { return region % 2 == 1 ? h / 2 : h; };
    for (const bool to_lengths : {false, true}) {
      ImproveOptions options;
      options.fixed = fixed;
      options.points = 2000;
      options.longest = [&](const Vector&, std::int32_t region) { return wanted(region); };
      if (to_lengths) options.size = [&](const Vector&) { return h / 2; };
      Mesh after = before;
      improve(after, options, {});
      require_same(before, after);
      std::size_t longer = 0;
      for (std::size_t i = 0; i < after.tetrahedra.size(); ++i) {
        const auto& t = after.tetrahedra[i];
        const auto& p = after.points;
        longer +=
            longest_edge_of(p[t[0]], p[t[1]], p[t[2]], p[t[3]]).length > kLongestEdge * wanted(after.region[i]);
      }
      CHECK(longer == 0);
    }
  }
}

TEST_CASE("where costs count no move makes them more, and what does not help is taken back", "[tetrahedra]") {
  const auto [begin, end] = scenes::seeds(10);
  const Bounds bounds{.shape = 0.1 * 0.1 * 0.1, .radius_edge = 3};
  std::size_t fewer = 0, divided = 0, taken_back = 0;
  for (std::uint64_t seed = begin; seed < end; ++seed) {
    INFO("seed " << seed);
    Index fixed = 0;
    const Mesh before = random_mesh(seed, fixed);
    if (before.tetrahedra.empty()) continue;
    Stars stars(before);
    Moves moves(stars, fixed, seed % 4 == 3);
    moves.aim_at(bounds);
    const auto cost = [&] {
      double all = 0;
      for (Index t = 0; t < stars.size(); ++t)
        if (stars.alive(t)) all += bounds.cost(stars, stars.at(t));
      return all;
    };
    double least = cost();
    const double first = least;
    const auto count = [&](bool done) {
      const double now = cost();
      REQUIRE(now <= (done ? least - 0.04 : least + 1e-6));
      REQUIRE(std::fabs(done ? 0 : now - least) <= 1e-6 * first);
      least = now;
      return done;
    };
    const auto all = Index(stars.size());
    for (Index t = 0; t < all; ++t) {
      if (!stars.alive(t) || bounds.keeps(stars, stars.at(t))) continue;
      const auto corners = stars.at(t).corners;
      const Index a = corners[seed % 4], b = corners[(seed + 1) % 4];
      if (count(moves.remove_edge(a, b)) || count(moves.swap_face(t, 0)) || count(moves.smooth(a, 1))) continue;
      if (count(moves.collapse(a, b, 1, 1e30))) continue;
      const Mesh same = stars.mesh();
      if (count(moves.divide(a, b))) {
        ++divided;
        continue;
      }
      ++taken_back;
      REQUIRE(stars.mesh().tetrahedra.size() == same.tetrahedra.size());
      REQUIRE(stars.mesh().segments == same.segments);
      REQUIRE(stars.mesh().points == same.points);
    }
    fewer += least < first;
    require_same(before, stars.mesh());
  }
  CHECK(fewer * 2 > end - begin);
  CHECK(divided > 0);
  CHECK(taken_back > 0);
}

TEST_CASE("a flat tetrahedron over two triangles of a facet is peeled off", "[tetrahedra]") {
  // Between the triangles abc, abd of a facet, which are the floor of an upper region, and the edge cd above it.
  constexpr Index a = 0, b = 1, c = 2, d = 3, top = 4, bottom = 5;
  Mesh mesh;
  mesh.points = {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 1e-15}, {0.1, 0, 1}, {0, 0.1, -1}};
  mesh.tetrahedra = {{a, b, c, d}, {a, c, d, top}, {b, c, d, top}, {a, b, c, bottom}, {a, b, d, bottom}};
  mesh.region = {1, 1, 1, 0, 0};
  for (auto& t : mesh.tetrahedra) {
    const auto& p = mesh.points;
    if (orient3d(p[t[0]].data(), p[t[1]].data(), p[t[2]].data(), p[t[3]].data()) < 0) std::swap(t[2], t[3]);
  }
  mesh.triangles = {{a, b, c}, {a, d, b}};
  mesh.facet = {0, 0};
  Stars stars(mesh);
  CHECK_FALSE(Moves(stars, 6, true).remove_edge(a, b));
  REQUIRE(Moves(stars, 6, false).remove_edge(a, b));
  mesh = stars.mesh();
  REQUIRE(mesh.tetrahedra.size() == 4);
  CHECK(std::ranges::count(mesh.region, 0) == 2);
  for (const auto& t : mesh.tetrahedra) {
    const auto& p = mesh.points;
    CHECK(shape_of(p[t[0]], p[t[1]], p[t[2]], p[t[3]]) > 0.3);
    CHECK(std::ranges::count(t, c) + std::ranges::count(t, d) == 2);
  }
  REQUIRE(mesh.triangles.size() == 2);
  for (const auto& t : mesh.triangles) CHECK(std::ranges::count(t, c) + std::ranges::count(t, d) == 2);
  CHECK(mesh.facet == std::vector<std::int32_t>{0, 0});
}

TEST_CASE("what no move makes better is tried again when something near it has changed", "[tetrahedra]") {
  Index fixed = 0;
  const Mesh mesh = random_mesh(2, fixed);
  REQUIRE(!mesh.tetrahedra.empty());
  Stars stars(mesh);
  Moves moves(stars, fixed, false);
  for (Index t = 0; t < stars.size(); ++t) {
    CHECK(!stars.is_settled(t));
    stars.settle(t);
    CHECK(stars.is_settled(t));
  }
  const Index a = stars.at(0).corners[0], b = stars.at(0).corners[1];
  std::set<Index> near;  // corners of what is halved
  for (const Index t : moves.at_edge(a, b)) near.insert(stars.at(t).corners.begin(), stars.at(t).corners.end());
  REQUIRE(moves.split(a, b) != Stars::kNoTetrahedron);
  std::size_t settled = 0;
  for (Index t = 0; t < stars.size(); ++t) {
    const auto& corners = stars.at(t).corners;
    const bool touched = std::any_of(corners.begin(), corners.end(),
                                     [&](Index v) { return near.contains(v) || v + 1 == stars.point_count(); });
    CHECK(stars.is_settled(t) != touched);
    settled += stars.is_settled(t);
  }
  CHECK(settled > 0);
}

Mesh cube() {
  Mesh box;
  for (int i = 0; i < 8; ++i) box.points.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2)});
  // Around the diagonal from 0 to 7.
  const Index way[] = {1, 3, 2, 6, 4, 5};
  for (std::size_t i = 0; i < 6; ++i) box.tetrahedra.push_back({0, 7, way[i], way[(i + 1) % 6]});
  if (!turned_right(box))
    for (auto& t : box.tetrahedra) std::swap(t[2], t[3]);
  REQUIRE(turned_right(box));
  box.region.assign(6, 0);
  return box;
}

TEST_CASE("a bound that halves do not reach costs no more than the mesh is worth", "[tetrahedra]") {
  const Mesh box = cube();
  ImproveOptions options;
  options.fixed = 8;
  options.points = 3'000'000;
  options.size = [](const Vector&) { return 0.08; };
  const auto seconds = [&](double radius_edge) {
    options.radius_edge = radius_edge;
    Mesh mesh = box;
    const std::clock_t begin = std::clock();
    improve(mesh, options, {});
    const std::clock_t end = std::clock();
    require_same(box, mesh);
    CHECK(mesh.tetrahedra.size() < 50'000);
    return double(end - begin) / CLOCKS_PER_SEC;
  };
  const double plain = seconds(0);
  CHECK(seconds(1.1) < 20 * plain);
}

TEST_CASE("refinement of a flat box ends at a number of tetrahedra", "[tetrahedra]") {
  Mesh plate = cube();
  for (Vector& p : plate.points) p[2] /= 1000;
  ImproveOptions options;
  options.fixed = 8;
  options.points = 100'000;
  options.most = 2000;
  options.size = [](const Vector&) { return 0.02; };
  Mesh mesh = plate;
  CHECK(improve(mesh, options, {}) == Improved::too_many);
  require_same(plate, mesh);
  CHECK(mesh.tetrahedra.size() < 2 * options.most);
  // One that has room for its lengths is done before.
  const Mesh box = cube();
  options.size = [](const Vector&) { return 0.3; };
  mesh = box;
  CHECK(improve(mesh, options, {}) == Improved::done);
  require_same(box, mesh);
}

TEST_CASE("a volume that is bounded, and time that is over", "[tetrahedra]") {
  const Mesh box = cube();
  ImproveOptions options;
  options.fixed = 8;
  options.volume = 1e-3;
  options.points = 100'000;
  Mesh fine = box;
  improve(fine, options, {});
  require_same(box, fine);
  CHECK(fine.tetrahedra.size() > 1000);
  for (const auto& t : fine.tetrahedra) {
    const auto& p = fine.points;
    CHECK(dot(minus(p[t[1]], p[t[0]]), cross(minus(p[t[2]], p[t[0]]), minus(p[t[3]], p[t[0]]))) / 6 <= 1e-3);
  }
  options.volume = 1e-12;
  options.points = 100'000'000;
  options.seconds = 0.2;
  Mesh cut = box;
  CHECK(improve(cut, options, {}) == Improved::time_over);
  require_same(box, cut);
  std::stop_source stop;
  stop.request_stop();
  options.seconds = 0;
  CHECK_THROWS_AS(improve(cut, options, Watch{{}, stop.get_token()}), Stopped);
}

TEST_CASE("steps that are over leave the same valid mesh, however long they take", "[tetrahedra]") {
  const Mesh box = cube();
  ImproveOptions options;
  options.fixed = 8;
  options.volume = 1e-5;
  options.points = 100'000;
  std::vector<std::size_t> sizes;
  for (const std::size_t steps : {20'000, 40'000}) {
    options.steps = steps;
    Mesh quick = box, slow = box;
    CHECK(improve(quick, options, {}) == Improved::steps_over);
    const Watch slowly{[](std::string_view, std::size_t, std::size_t) {
      for (const std::clock_t end = std::clock() + CLOCKS_PER_SEC / 1000; std::clock() < end;) {
      }
    }};
    CHECK(improve(slow, options, slowly) == Improved::steps_over);
    CHECK(slow.points == quick.points);
    CHECK(slow.tetrahedra == quick.tetrahedra);
    require_same(box, quick);
    sizes.push_back(quick.tetrahedra.size());
  }
  CHECK(sizes[0] < sizes[1]);
}

TEST_CASE("shape and radius-edge ratio of a regular tetrahedron and a flat one", "[tetrahedra]") {
  const Vector a{1, 1, 1}, b{1, -1, -1}, c{-1, 1, -1}, d{-1, -1, 1};
  CHECK(shape_of(a, b, c, d) == Approx(1));
  CHECK(radius_edge_of(a, b, c, d) == Approx(std::sqrt(6) / 4));
  CHECK(shape_of({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}) == 0);
}

}  // namespace
}  // namespace cnrg
