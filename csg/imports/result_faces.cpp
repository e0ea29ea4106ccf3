// A face of a result file against its place. Loops are read off the complex and put in the order of files;
// triangles are checked and not made again, since which diagonal halves a rectangle may depend on roundings.
#include <algorithm>
#include <map>

#include "csg/geometry/canonical_loop.h"
#include "csg/imports/result_placing.h"
#include "kernel/base/sorted.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/predicates.h"

namespace cnrg::result {
namespace {

class FaceCheck {
 public:
  explicit FaceCheck(const PlacedCells& placed)
      : placed_(placed), content_(placed.content), table_(placed.table), c_(placed.complex) {}

  void run(const Face& face, const Cursor& at) const {
    Loop before;
    for (std::size_t k = face.first; k < face.first + face.facets; ++k) {
      const Cursor here = face.flat ? at : at.member("facets").at(k - face.first);
      check_facet(here, content_.facets[k], placed_.cell_of[k]);
      Loop points;
      for (const Loop& walk : content_.facets[k].walks) points.insert(points.end(), walk.begin(), walk.end());
      std::sort(points.begin(), points.end());
      if (points < before) here.refuse("facets are in the order of their points");
      before = std::move(points);
    }
    if (!face.flat) check_curved(at, face);
    check_front(at, face);
    check_triangles(at, face);
    check_cells(at, face);
  }

 private:
  /// The loops of a facet are those of the face of the complex, and so are the vertices inside of it.
  void check_facet(const Cursor& at, const Facet& facet, FaceId f) const {
    std::vector<Loop> loops;
    for (const LoopId l : c_.face_loops[f]) {
      Loop& loop = loops.emplace_back();
      for (const HalfEdge h : c_.loop[l]) loop.push_back(point(c_.origin(h)));
      if (!placed_.same(f)) std::reverse(loop.begin(), loop.end());
    }
    put_in_order(loops);
    if (loops != facet.walks)
      at.member("loops").refuse("the loops that these points and edges make are " + words(loops));
    Loop isolated;
    for (const VertexId v : c_.face_vertices[f]) isolated.push_back(point(v));
    std::sort(isolated.begin(), isolated.end());
    if (isolated != facet.isolated) {
      (at.has("isolated") ? at.member("isolated") : at)
          .refuse("the vertices isolated in this face are " + words(isolated));
    }
  }

  /// The loops of a face that is not flat, from those of its facets: where a walk comes to a side between two
  /// facets it goes on in the other one. A face that meets itself may pass an edge several times the same way.
  void check_curved(const Cursor& at, const Face& face) const {
    std::vector<Step> steps;         // of all walks of all facets
    std::vector<std::size_t> after;  // by step: the next one in its walk
    std::map<Step, std::size_t> between;
    std::vector<Index> isolated, boundary;
    for (std::size_t k = face.first; k < face.first + face.facets; ++k) {
      const Facet& facet = content_.facets[k];
      for (const Loop& walk : facet.walks) {
        const std::size_t first = steps.size();
        for (std::size_t i = 0; i < walk.size(); ++i) {
          const Step step(walk[i], walk[(i + 1) % walk.size()]);
          if (!placed_.on_edge(step) && !between.try_emplace(step, steps.size()).second) {
            at.member("facets").at(k - face.first).refuse("the facets of a face agree which side is the front");
          }
          if (table_.vertices.contains(step.first)) isolated.push_back(step.first);
          if (placed_.on_edge(step)) boundary.insert(boundary.end(), {step.first, step.second});
          after.push_back(first + (i + 1) % walk.size());
          steps.push_back(step);
        }
      }
      isolated.insert(isolated.end(), facet.isolated.begin(), facet.isolated.end());
    }
    std::vector<Loop> loops;
    std::vector<char> walked(steps.size(), 0);
    for (std::size_t start = 0; start < steps.size(); ++start) {
      if (!placed_.on_edge(steps[start]) || walked[start]) continue;
      Loop& loop = loops.emplace_back();
      for (std::size_t i = start; !walked[i];) {
        walked[i] = 1;
        loop.push_back(steps[i].first);
        i = after[i];
        while (!placed_.on_edge(steps[i])) i = after[between.at({steps[i].second, steps[i].first})];
      }
    }
    put_in_order(loops);
    if (loops != face.walks) at.member("loops").refuse("the loops that its facets make are " + words(loops));
    sort_unique(isolated), sort_unique(boundary);
    std::erase_if(isolated, [&](Index p) { return std::binary_search(boundary.begin(), boundary.end(), p); });
    std::vector<Index> stated;
    if (at.has("isolated")) {
      const Cursor list = at.member("isolated").array();
      for (std::size_t i = 0; i < list.size(); ++i)
        stated.push_back(list.at(i).number(table_.points.size(), "point"));
      if (stated.empty()) list.refuse("what is empty is left out");
    }
    if (stated != isolated) {
      (at.has("isolated") ? at.member("isolated") : at)
          .refuse("the vertices isolated in this face are " + words(isolated));
    }
  }

  bool active(Index region) const { return content_.regions[region].component != 0; }

  /// The front is the outside, where exactly one side is active; else where the positive normal of the first facet
  /// points.
  void check_front(const Cursor& at, const Face& face) const {
    const bool front = active(face.regions[0]), back = active(face.regions[1]);
    if (front != back) {
      if (front) at.member("regions").refuse("the front of a face is the side that is no part of the result");
      return;
    }
    const FaceId f = placed_.cell_of[face.first];
    for (int k = 0; k < 3; ++k) {
      const int s = normal_sign(c_.points, c_.plane(f), k);
      if (s == 0) continue;
      if ((s > 0) != placed_.same(f)) at.member("loops").refuse("the front of this face is its other side");
      return;
    }
  }

  /// Triangles are turned as their facet is, and their sides cancel but for its walks: so they cover it, once.
  void check_triangles(const Cursor& at, const Face& face) const {
    const Cursor list = at.member("triangles").array();
    std::size_t t = 0;
    std::vector<std::array<Index, 3>> triangles;
    for (std::size_t k = face.first; k < face.first + face.facets; ++k) {
      const Facet& facet = content_.facets[k];
      std::size_t wanted = 2 * facet.walks.size() + 2 * facet.isolated.size();
      for (const Loop& walk : facet.walks) wanted += walk.size();
      wanted -= 4;  // by Euler's formula: each corner is one of some triangle
      triangles.clear();
      for (; triangles.size() < wanted && t < list.size(); ++t) {
        triangles.push_back(triangle(list.at(t), placed_.cell_of[k]));
        if (triangles.size() > 1 && triangles.back() < triangles[triangles.size() - 2]) {
          list.at(t).refuse("the triangles of a facet are in the order of their points");
        }
      }
      if (triangles.size() < wanted) list.refuse("triangles are missing: they do not cover the face");
      if (face.flat && facet.walks.size() == 1 && wanted == 1 &&
          triangles[0] == std::array{facet.walks[0][0], facet.walks[0][1], facet.walks[0][2]})
        continue;
      require_covered(list, facet, triangles);
    }
    if (t < list.size()) list.at(t).refuse("there are more triangles than cover the face");
  }

  std::array<Index, 3> triangle(const Cursor& at, FaceId f) const {
    at.array_of(3, "a triangle has three points");
    std::array<Index, 3> p{};
    for (std::size_t k = 0; k < 3; ++k) p[k] = at.at(k).number(table_.points.size(), "point");
    const Projection axes = c_.sheet_projection[c_.face_sheet[f]];
    const bool turned =
        p[0] != p[1] && p[1] != p[2] && p[2] != p[0] &&
        orient2d(c_.points, axes, vertex(p[0]), vertex(p[1]), vertex(p[2])) == (placed_.same(f) ? 1 : -1);
    if (!turned) at.refuse("a triangle goes counter-clockwise as seen from the front of its face");
    if (p[0] > p[1] || p[0] > p[2]) at.refuse("a triangle begins at its point of the least number");
    return p;
  }

  void require_covered(const Cursor& list, const Facet& facet,
                       const std::vector<std::array<Index, 3>>& triangles) const {
    std::vector<Step> sides, wanted;
    std::vector<Index> corners;
    for (const auto& p : triangles) {
      for (std::size_t k = 0; k < 3; ++k) sides.emplace_back(p[k], p[(k + 1) % 3]);
      corners.insert(corners.end(), p.begin(), p.end());
    }
    std::sort(sides.begin(), sides.end());
    sort_unique(corners);
    for_each_step(facet.walks, [&](const Step& step) { wanted.push_back(step); });
    std::sort(wanted.begin(), wanted.end());
    std::vector<Step> inner;
    std::set_difference(sides.begin(), sides.end(), wanted.begin(), wanted.end(), std::back_inserter(inner));
    std::vector<Step> opposite;
    opposite.reserve(inner.size());
    for (const auto& [a, b] : inner) opposite.emplace_back(b, a);
    std::sort(opposite.begin(), opposite.end());
    if (!std::includes(sides.begin(), sides.end(), wanted.begin(), wanted.end()) || opposite != inner ||
        !std::includes(corners.begin(), corners.end(), facet.isolated.begin(), facet.isolated.end())) {
      list.refuse("the triangles do not cover the face from edge to edge, once");
    }
  }

  /// Each facet lies in the cells of its patch.
  void check_cells(const Cursor& at, const Face& face) const {
    if (!at.has("cells")) return;
    for (std::size_t k = face.first; k < face.first + face.facets; ++k) {
      const Facet& facet = content_.facets[k];
      const Cursor list = at.member("cells").at(k - face.first);
      for (const Loop& walk : facet.walks) {
        for (const Index p : walk) {
          bool held = false;
          for (std::size_t i = 0; i < facet.cells.size(); ++i) {
            const auto& cell = content_.cells[facet.cells[i]];
            if (!in_plane(cell, table_.points[p]))
              list.at(i).refuse("the facet does not lie in the plane of this cell");
            held = held || holds(cell, table_.points[p]);
          }
          if (!held) list.refuse(words("point", p) + " of the facet is in none of these cells");
        }
      }
    }
  }
  static bool in_plane(const std::vector<PatchCorner>& cell, const RationalPoint& p) {
    const auto flat = [&](std::size_t i, std::size_t k) {
      return volume6(cell[0].point, cell[i].point, cell[k].point, p) == 0;
    };
    return flat(1, 2) && (cell.size() == 3 || flat(2, 3));
  }

  const PlacedCells& placed_;
  const Content& content_;
  const CellTable& table_;
  const Complex& c_;
};

}  // namespace

void check_face(const PlacedCells& placed, const Face& face, const Cursor& at) { FaceCheck(placed).run(face, at); }

}  // namespace cnrg::result
