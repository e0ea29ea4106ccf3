// Triangles are turned as their facet is, begin with their least point, and cover it once: their sides cancel but
// for its walks.
#include "csg/transfer/result_triangles.h"

#include <algorithm>

#include "kernel/base/sorted.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/predicates.h"

namespace cnrg::result {
namespace {

using Step = std::pair<Index, Index>;  // from point to point

class TriangleCheck {
 public:
  TriangleCheck(const Complex& complex, const Content& content, const std::vector<PlacedFacet>& facets)
      : content_(content), table_(content.table), c_(complex), facets_(facets) {}

  void run(const Face& face, const Cursor& at) const {
    check_triangles(at, face);
    check_cells(at, face);
  }

 private:
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
        triangles.push_back(triangle(list.at(t), facets_[k]));
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

  std::array<Index, 3> triangle(const Cursor& at, const PlacedFacet& facet) const {
    at.array_of(3, "a triangle has three points");
    std::array<Index, 3> p{};
    for (std::size_t k = 0; k < 3; ++k) p[k] = at.at(k).number(table_.points.size(), "point");
    const Projection axes = c_.sheet_projection[c_.face_sheet[facet.cell]];
    const bool turned =
        p[0] != p[1] && p[1] != p[2] && p[2] != p[0] &&
        orient2d(c_.points, axes, VertexId(p[0]), VertexId(p[1]), VertexId(p[2])) == (facet.same ? 1 : -1);
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
    for (const Loop& walk : facet.walks) {
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
          if (!held) list.refuse("point " + std::to_string(p) + " of the facet is in none of these cells");
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

  const Content& content_;
  const CellTable& table_;
  const Complex& c_;
  const std::vector<PlacedFacet>& facets_;
};

}  // namespace

void require_triangles(const Complex& complex, const Content& content, const Face& face,
                       const std::vector<PlacedFacet>& facets, const Cursor& at) {
  TriangleCheck(complex, content, facets).run(face, at);
}

}  // namespace cnrg::result
