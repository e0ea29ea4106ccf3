// Triangles are turned as their facet is, begin with their least point, and cover it once: their sides cancel but
// for its walks.
#include "csg/transfer/result_triangles.h"

#include <algorithm>
#include <map>

#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/predicates.h"

namespace cnrg::result {
namespace {

using Loop = FlatComplex::Loop;
using Triangle = FlatComplex::Triangle;

Triangle read_triangle(const Complex& c, const PlacedFacet& facet, const Cursor& at) {
  at.array_of(3, "a triangle has three points");
  Triangle p{};
  for (std::size_t k = 0; k < 3; ++k) p[k] = at.at(k).number(c.points.size(), "point");
  const Projection axes = c.sheet_projection[c.face_sheet[facet.cell]];
  const bool turned =
      p[0] != p[1] && p[1] != p[2] && p[2] != p[0] &&
      orient2d(c.points, axes, VertexId(p[0]), VertexId(p[1]), VertexId(p[2])) == (facet.same ? 1 : -1);
  if (!turned) at.refuse("a triangle goes counter-clockwise as seen from the front of its face");
  if (p[0] > p[1] || p[0] > p[2]) at.refuse("a triangle begins at its point of the least number");
  return p;
}

bool cover(const std::vector<Triangle>& triangles, const std::vector<Loop>& walks,
           const ShortList<Index, 2>& isolated) {
  std::map<std::pair<Index, Index>, int> sides;  // how often, less how often the walks go there
  std::map<Index, int> corners;
  const auto add = [&](const auto& walk, int n) {
    for (std::size_t i = 0; i < walk.size(); ++i) sides[{walk[i], walk[(i + 1) % walk.size()]}] += n;
  };
  for (const Triangle& t : triangles) {
    add(t, 1);
    for (const Index p : t) ++corners[p];
  }
  for (const Loop& walk : walks) add(walk, -1);
  const auto cancels = [&](const auto& side) {
    const auto& [step, n] = side;
    const auto back = sides.find({step.second, step.first});
    return n == 0 || (n > 0 && back != sides.end() && back->second == n);
  };
  return std::all_of(sides.begin(), sides.end(), cancels) &&
         std::all_of(isolated.begin(), isolated.end(), [&](Index p) { return corners.contains(p); });
}

bool in_plane(const std::vector<PatchCorner>& cell, const RationalPoint& p) {
  const auto flat = [&](std::size_t i, std::size_t k) {
    return volume6(cell[0].point, cell[i].point, cell[k].point, p) == 0;
  };
  return flat(1, 2) && (cell.size() == 3 || flat(2, 3));
}

}  // namespace

void require_triangles(const Complex& complex, const FlatComplex::Face& face, const PlacedFacet* placed,
                       const Cursor& at) {
  const Cursor list = at.member("triangles").array();
  std::size_t t = 0;
  for_each_facet(face, [&](const std::vector<Loop>& walks, const auto& isolated, auto&&...) {
    std::size_t wanted = 2 * walks.size() + 2 * isolated.size();
    for (const Loop& walk : walks) wanted += walk.size();
    wanted -= 4;  // by Euler's formula: each corner is one of some triangle
    std::vector<Triangle> triangles;
    for (; triangles.size() < wanted; ++t) {
      if (t == list.size()) list.refuse("triangles are missing: they do not cover the face");
      triangles.push_back(read_triangle(complex, *placed, list.at(t)));
      if (triangles.size() > 1 && triangles.back() < triangles[triangles.size() - 2])
        list.at(t).refuse("the triangles of a facet are in the order of their points");
    }
    ++placed;
    const bool is_triangle = walks.size() == 1 && wanted == 1 && std::ranges::equal(triangles[0], walks[0]);
    if (!is_triangle && !cover(triangles, walks, isolated))
      list.refuse("the triangles do not cover the face from edge to edge, once");
  });
  if (t < list.size()) list.at(t).refuse("there are more triangles than cover the face");
}

void require_cells(const std::vector<RationalPoint>& points, const FlatComplex::Face& face, const Cursor& at) {
  if (face.cells.empty()) return;
  std::size_t facet = 0;
  for_each_facet(face, [&](const std::vector<Loop>& walks, auto&&...) {
    const auto& cells = face.cells[facet];
    const Cursor list = at.member("cells").at(facet++);
    for (const Loop& walk : walks) {
      for (const Index p : walk) {
        for (std::size_t i = 0; i < cells.size(); ++i) {
          if (!in_plane(cells[i], points[p]))
            list.at(i).refuse("the facet does not lie in the plane of this cell");
        }
        if (std::none_of(cells.begin(), cells.end(), [&](const auto& cell) { return holds(cell, points[p]); }))
          list.refuse("point " + std::to_string(p) + " of the facet is in none of these cells");
      }
    }
  });
}

}  // namespace cnrg::result
