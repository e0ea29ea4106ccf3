// Random leaves of tree files as text.
#include "tests/oracles/drawn_leaves.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

#include "tests/oracles/curved_trees.h"

namespace cnrg::properties {
namespace {

class LeafDrawer {
 public:
  using Words = std::pair<std::string, std::string>;
  explicit LeafDrawer(scenes::Random& random) : random_(random) {}

  Words box() {
    const Place p = place(3);
    const Place q{p[0] + random_.between(1, 3), p[1] + random_.between(1, 3), p[2] + random_.between(1, 3)};
    return {"box", "{min: " + at(p) + ", max: " + at(q) + "}"};
  }

  Words horizon() {
    const int low = random_.below(5), high = random_.below(5);
    return {"polygon", loop({{-9, -9, low}, {9, -9, low}, {9, 9, high}, {-9, 9, high}}, random_.below(2))};
  }

  Words leaf(const LeafKinds& kinds) {
    if (kinds.unbounded && random_.one_in(3)) {
      const char* const normals[] = {"[0, 0, 1]", "[1, 0, 0]", "[0, -1, 0]", "[1, 1, 0]", "[1, 2, 3]"};
      return {random_.one_in(2) ? "plane" : "halfspace",
              "{point: " + at(place()) + ", normal: " + normals[random_.below(5)] + "}"};
    }
    return kinds.curved && random_.one_in(2) ? curved() : flat();
  }

 private:
  using Place = std::array<int, 3>;

  static std::string number(int n) { return std::to_string(n); }

  static std::string listed(const std::vector<std::string>& items) {
    std::string out = "[";
    for (std::size_t i = 0; i < items.size(); ++i) out += (i == 0 ? "" : ", ") + items[i];
    return out + "]";
  }

  static std::string at(const Place& p) { return listed({number(p[0]), number(p[1]), number(p[2])}); }

  static Place plus(Place p, int axis, int by) {
    p[static_cast<std::size_t>(axis)] += by;
    return p;
  }

  /// A coordinate, mostly whole.
  std::string coordinate() {
    const int n = random_.below(5);
    if (random_.one_in(12)) return "\"" + number(2 * n + 1) + "/2\"";
    if (random_.one_in(20)) return "\"" + number(3 * n + 1) + "/3\"";
    return number(n);
  }

  std::string point() { return listed({coordinate(), coordinate(), coordinate()}); }

  Place place(int high = 4) {
    return {random_.between(0, high), random_.between(0, high), random_.between(0, high)};
  }

  std::string segments() { return "segments: " + number(random_.between(3, 8)); }

  /// `from` and `to` along an axis.
  std::string axis() {
    const Place from = place(3);
    return "from: " + at(from) + ", to: " + at(plus(from, random_.below(3), random_.between(1, 3))) +
           ", radius: " + number(random_.between(1, 2));
  }

  /// A rectangle, a triangle or an L in a plane z = const, seen from above counter-clockwise.
  std::vector<Place> outline() {
    const Place p = place(3);
    const int a = random_.between(1, 3), b = random_.between(1, 3);
    const auto q = [&](int i, int j) { return Place{p[0] + i, p[1] + j, p[2]}; };
    switch (random_.below(4)) {
      case 0: return {q(0, 0), q(a, 0), q(0, b)};
      case 1: return {q(0, 0), q(2 * a, 0), q(2 * a, b), q(a, b), q(a, 2 * b), q(0, 2 * b)};
      default: return {q(0, 0), q(a, 0), q(a, b), q(0, b)};
    }
  }

  static std::string loop(const std::vector<Place>& corners, int turn = 0) {
    std::vector<std::string> out;
    for (Place p : corners) {
      std::rotate(p.begin(), p.begin() + turn, p.end());
      out.push_back(at(p));
    }
    return listed(out);
  }

  Words prism() {
    const std::string vector = at({random_.below(2), 0, random_.between(1, 3)});
    if (!random_.one_in(3)) return {"prism", "{base: " + loop(outline()) + ", vector: " + vector + "}"};
    return {"prism",
            "{base: [[0, 0, 1], [3, 0, 1], [3, 3, 1], [0, 3, 1]], holes: [[[1, 1, 1], [2, 1, 1], [2, 2, 1], [1, "
            "2, 1]]], vector: " +
                vector + "}"};
  }

  Words polygon() {
    if (random_.one_in(4))
      return {"polygon",
              "{outer: [[0, 0, 2], [4, 0, 2], [4, 4, 2], [0, 4, 2]], holes: [[[1, 1, 2], [2, 1, 2], [2, 3, 2], "
              "[1, 3, 2]]]}"};
    return {"polygon", loop(outline(), random_.below(3))};
  }

  Words polyline() {
    Place p = place();
    std::vector<Place> points{p};
    for (int k = random_.between(1, 3); k > 0; --k) {
      const int axis = k % 3;
      p = plus(p, axis, random_.one_in(2) ? -random_.between(1, 2) : random_.between(1, 3));
      points.push_back(p);
    }
    if (points.size() == 4 && random_.one_in(2))
      return {"polyline", "{points: " + loop(points) + ", closed: true}"};
    return {"polyline", loop(points)};
  }

  /// Boxes in one mesh, apart, touching or one in the other: cavities in an order of their own.
  Words mesh() {
    std::vector<std::array<Place, 2>> boxes;
    int x = random_.below(2);
    for (int k = random_.between(1, 3); k > 0; --k) {
      const int a = random_.between(1, 2), y = random_.below(3), z = random_.below(3);
      boxes.push_back({Place{x, y, z}, Place{x + a, y + random_.between(1, 2), z + random_.between(1, 2)}});
      x += a + random_.below(2);
    }
    if (random_.one_in(3)) boxes.push_back({Place{-1, -1, -1}, Place{7, 5, 5}});
    for (std::size_t i = boxes.size(); i > 1; --i)
      std::swap(boxes[i - 1], boxes[static_cast<std::size_t>(random_.below(static_cast<int>(i)))]);
    std::vector<std::string> points, faces;
    const int sides[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (const auto& [low, high] : boxes) {
      const int first = static_cast<int>(points.size());
      for (int i = 0; i < 8; ++i)
        points.push_back(at({i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 4 ? high[2] : low[2]}));
      for (const auto& s : sides)
        faces.push_back(
            listed({number(first + s[0]), number(first + s[1]), number(first + s[2]), number(first + s[3])}));
    }
    const char* const fills[] = {"cells", "cells", "cells", "none", "parity"};
    return {"mesh", "{points: " + listed(points) + ", faces: " + listed(faces) +
                        ", fill: " + fills[random_.below(5)] + "}"};
  }

  /// A leaf of a random scene, in one line.
  Words group() {
    const scenes::Position position = random_.one_in(4) ? scenes::Position::tilted : scenes::Position::degenerate;
    const scenes::Leaf leaf = scenes::random_leaves(random_.next(), 1, position)[0];
    std::map<RationalPoint, std::size_t> numbers;
    std::vector<std::string> vertices, faces, edges, points;
    const auto vertex = [&](const RationalPoint& p) {
      const auto [it, fresh] = numbers.emplace(p, vertices.size());
      if (fresh)
        vertices.push_back(
            listed({"\"" + to_string(p[0]) + "\"", "\"" + to_string(p[1]) + "\"", "\"" + to_string(p[2]) + "\""}));
      return std::to_string(it->second);
    };
    std::set<std::uint32_t> regions;
    for (const scenes::Face& face : leaf.faces) {
      std::vector<std::string> loops;
      for (const scenes::Polygon& corners : face.loops) {
        std::vector<std::string> one;
        for (const RationalPoint& p : corners) one.push_back(vertex(p));
        loops.push_back(listed(one));
      }
      const std::string sides = ", sides: " + listed({number(int(face.front)), number(int(face.back))});
      faces.push_back("{loops: " + listed(loops) + (leaf.fill == Fill::sides ? sides : "") + "}");
      if (leaf.fill == Fill::sides) regions.insert({face.front, face.back});
    }
    for (const auto& wire : leaf.wires) {
      const std::string from = vertex(wire[0]);
      edges.push_back(listed({from, vertex(wire[1])}));
    }
    for (const RationalPoint& p : leaf.points) points.push_back(vertex(p));
    std::string out = "{vertices: " + listed(vertices);
    if (!faces.empty()) out += ", faces: " + listed(faces);
    if (!edges.empty()) out += ", edges: " + listed(edges);
    if (!points.empty()) out += ", points: " + listed(points);
    if (leaf.fill != Fill::sides) out += ", fill: " + std::string(scenes::name(leaf.fill));
    std::string said;
    for (const std::uint32_t region : regions) {
      if (region == 0 || random_.one_in(2)) continue;
      said += (said.empty() ? "" : ", ") + std::to_string(region) +
              ": {name: " + (random_.one_in(2) ? "upper" : "lower") +
              (random_.one_in(2) ? ", material: ore}" : "}");
    }
    if (!said.empty()) out += ", regions: {" + said + "}";
    return {"group", out + "}"};
  }

  Words heightfield() {
    const auto row = [&] { return listed({coordinate(), coordinate(), coordinate()}); };
    std::string out = "{origin: " + listed({number(random_.below(2)), number(random_.below(2))}) + ", heights: ";
    out += listed({row(), row()});
    return {"heightfield", out + (random_.one_in(2) ? ", base: -1}" : "}")};
  }

  Words flat() {
    const Place p = place();
    switch (random_.below(16)) {
      case 0:
      case 1: return prism();
      case 2: return polygon();
      case 3: return polygon();
      case 4: return polyline();
      case 5: return {"points", listed({point(), point()})};
      case 6: {
        Place apex = p;
        const std::vector<Place> base = outline();
        apex[2] = base[0][2] + random_.between(1, 3);
        return {"pyramid", "{base: " + loop(base) + ", apex: " + at(apex) + "}"};
      }
      case 7:
        return {"tetrahedron",
                listed({at(p), at(plus(p, 0, random_.between(1, 3))), at(plus(p, 1, random_.between(1, 3))),
                        at(plus(p, 2, random_.between(1, 3)))})};
      case 8: return heightfield();
      case 9:
      case 10: return mesh();
      case 11:
      case 12: return group();
      default: return box();
    }
  }

  Words patch() {
    std::vector<std::string> rows;
    const int count = random_.between(2, 3);
    for (int j = 0; j < count; ++j) {
      std::vector<std::string> row;
      for (int i = 0; i < 3; ++i) row.push_back(at({2 * i, 4 * j / (count - 1), random_.below(5)}));
      rows.push_back(listed(row));
    }
    return {"bezier", "{patch: " + listed(rows) + ", segments: 2}"};
  }

  Words curved() {
    const Place p = place(3);
    switch (random_.below(10)) {
      case 0:
      case 1: return {"cylinder", "{" + axis() + ", " + segments() + "}"};
      case 2: return {"cone", "{" + axis() + ", " + segments() + "}"};
      case 3:
        return {"sphere", "{center: " + at(p) + ", radius: " + number(random_.between(1, 2)) + ", " + segments() +
                              ", rings: " + number(random_.between(2, 4)) + "}"};
      case 4: return patch();
      case 5: {
        const std::string a = at(p), b = at(plus(p, 0, 2)), c = at(plus(plus(p, 0, 2), 1, 2)),
                          d = at(plus(p, 1, 2));
        const std::string bow = at(plus(plus(plus(p, 0, 3), 1, 1), 2, 1));
        return {"coons", "{patch: [[" + a + ", " + b + "], [" + b + ", " + bow + ", " + c + "], [" + c + ", " + d +
                             "], [" + d + ", " + a + "]], segments: 2}"};
      }
      case 6:
        return {"bspline",
                "{curve: {points: [" + at(p) + ", [3, 3, 3], [0, 4, 1], [4, 4, 0]], degree: 2}, segments: 2}"};
      default: {  // `sphere: {...}, translate: [...]`
        const std::string text = random_curved_solid(random_.next());
        const std::size_t colon = text.find(": ");
        return {text.substr(0, colon), text.substr(colon + 2)};
      }
    }
  }

  scenes::Random& random_;
};

}  // namespace

std::pair<std::string, std::string> drawn_box(scenes::Random& random) { return LeafDrawer(random).box(); }
std::pair<std::string, std::string> drawn_horizon(scenes::Random& random) { return LeafDrawer(random).horizon(); }
std::pair<std::string, std::string> drawn_leaf(scenes::Random& random, const LeafKinds& kinds) {
  return LeafDrawer(random).leaf(kinds);
}

}  // namespace cnrg::properties
