// Triangles are turned as their facet is, begin with their least point, and cover it once: their sides cancel but
// for its walks.
#include "csg/transfer/result_triangles.h"

#include <algorithm>

#include "kernel/base/sorted.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/predicates.h"

namespace cnrg::result {
namespace {

using Loop = FlatComplex::Loop;
using Step = std::pair<Index, Index>;  // from point to point

class TriangleCheck {
 public:
  TriangleCheck(const Complex& complex, const std::vector<RationalPoint>& points, const FlatComplex::Face& face)
      : c_(complex), points_(points), face_(face) {}

  /// Triangles are turned as their facet is, and their sides cancel but for its walks: so they cover it, once.
  void check_triangles(const Cursor& at, const PlacedFacet* placed) const {
    const Cursor list = at.member("triangles").array();
    std::size_t t = 0;
    std::vector<std::array<Index, 3>> triangles;
    for_each_facet(face_, [&](const std::vector<Loop>& walks, const auto& isolated, auto&&...) {
      std::size_t wanted = 2 * walks.size() + 2 * isolated.size();
      for (const Loop& walk : walks) wanted += walk.size();
      wanted -= 4;  // by Euler's formula: each corner is one of some triangle
      triangles.clear();
      for (; triangles.size() < wanted && t < list.size(); ++t) {
        triangles.push_back(triangle(list.at(t), *placed));
        if (triangles.size() > 1 && triangles.back() < triangles[triangles.size() - 2]) {
          list.at(t).refuse("the triangles of a facet are in the order of their points");
        }
      }
      ++placed;
      if (triangles.size() < wanted) list.refuse("triangles are missing: they do not cover the face");
      const bool is_triangle =
          face_.facets.empty() && walks.size() == 1 && wanted == 1 && std::ranges::equal(triangles[0], walks[0]);
      if (!is_triangle) require_covered(list, walks, isolated, triangles);
    });
    if (t < list.size()) list.at(t).refuse("there are more triangles than cover the face");
  }

  /// Each facet lies in the cells of its patch.
  void check_cells(const Cursor& at) const {
    if (!at.has("cells")) return;
    std::size_t facet = 0;
    for_each_facet(face_, [&](const std::vector<Loop>& walks, auto&&...) {
      const auto& cells = face_.cells[facet];
      const Cursor list = at.member("cells").at(facet++);
      for (const Loop& walk : walks) {
        for (const Index p : walk) {
          bool held = false;
          for (std::size_t i = 0; i < cells.size(); ++i) {
            if (!in_plane(cells[i], points_[p]))
              list.at(i).refuse("the facet does not lie in the plane of this cell");
            held = held || holds(cells[i], points_[p]);
          }
          if (!held) list.refuse("point " + std::to_string(p) + " of the facet is in none of these cells");
        }
      }
    });
  }

 private:
  std::array<Index, 3> triangle(const Cursor& at, const PlacedFacet& facet) const {
    at.array_of(3, "a triangle has three points");
    std::array<Index, 3> p{};
    for (std::size_t k = 0; k < 3; ++k) p[k] = at.at(k).number(points_.size(), "point");
    const Projection axes = c_.sheet_projection[c_.face_sheet[facet.cell]];
    const bool turned =
        p[0] != p[1] && p[1] != p[2] && p[2] != p[0] &&
        orient2d(c_.points, axes, VertexId(p[0]), VertexId(p[1]), VertexId(p[2])) == (facet.same ? 1 : -1);
    if (!turned) at.refuse("a triangle goes counter-clockwise as seen from the front of its face");
    if (p[0] > p[1] || p[0] > p[2]) at.refuse("a triangle begins at its point of the least number");
    return p;
  }

  static void require_covered(const Cursor& list, const std::vector<Loop>& walks,
                              const ShortList<Index, 2>& isolated,
                              const std::vector<std::array<Index, 3>>& triangles) {
    std::vector<Step> sides, wanted;
    std::vector<Index> corners;
    for (const auto& p : triangles) {
      for (std::size_t k = 0; k < 3; ++k) sides.emplace_back(p[k], p[(k + 1) % 3]);
      corners.insert(corners.end(), p.begin(), p.end());
    }
    std::sort(sides.begin(), sides.end());
    sort_unique(corners);
    for (const Loop& walk : walks) {
      for (std::size_t i = 0; i < walk.size(); ++i) wanted.emplace_back(walk[i], walk[(i + 1) % walk.size()]);
    }
    std::sort(wanted.begin(), wanted.end());
    std::vector<Step> inner;
    std::set_difference(sides.begin(), sides.end(), wanted.begin(), wanted.end(), std::back_inserter(inner));
    std::vector<Step> opposite;
    opposite.reserve(inner.size());
    for (const auto& [a, b] : inner) opposite.emplace_back(b, a);
    std::sort(opposite.begin(), opposite.end());
    if (!std::includes(sides.begin(), sides.end(), wanted.begin(), wanted.end()) || opposite != inner ||
        !std::includes(corners.begin(), corners.end(), isolated.begin(), isolated.end())) {
      list.refuse("the triangles do not cover the face from edge to edge, once");
    }
  }

  static bool in_plane(const std::vector<PatchCorner>& cell, const RationalPoint& p) {
    const auto flat = [&](std::size_t i, std::size_t k) {
      return volume6(cell[0].point, cell[i].point, cell[k].point, p) == 0;
    };
    return flat(1, 2) && (cell.size() == 3 || flat(2, 3));
  }

  const Complex& c_;
  const std::vector<RationalPoint>& points_;
  const FlatComplex::Face& face_;
};

}  // namespace

void require_triangles(const Complex& complex, const std::vector<RationalPoint>& points,
                       const FlatComplex::Face& face, const PlacedFacet* placed, const Cursor& at) {
  const TriangleCheck check(complex, points, face);
  check.check_triangles(at, placed);
  check.check_cells(at);
}

}  // namespace cnrg::result
