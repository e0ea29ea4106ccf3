// What a format of closed surfaces cannot hold is counted and refused, with the operator that would take it away.
// What is left are the triangles of faces with a region on exactly one side.
#include "csg/result/solid.h"

#include <algorithm>

#include "kernel/base/error.h"

namespace cnrg {
namespace {

using Index = FlatComplex::Index;
/// Takes away what is in a region of its own component, which no other operator does.
constexpr const char* kDropOwn =
    "`regularize` with `each: true` to a `select` of `dimension: 3` (they drop what has attributes of its own in "
    "a component)";
constexpr const char* kBound =
    "; write .json, or cut the node with a box first (`intersection`, or `product` where it is not closed)";

/// `3 walls`, `1 wall`, or nothing for zero; appended with a comma.
void count(std::string& list, std::size_t n, const char* one, const char* many) {
  if (n == 0) return;
  if (!list.empty()) list += ", ";
  list += std::to_string(n) + " " + (n == 1 ? one : many);
}

/// What is no outer boundary of a solid.
struct Others {
  std::size_t walls = 0, cracks = 0, dangling = 0, wires = 0, points = 0;
  bool inner = false, outer = false;  ///< wires and points in regions, and outside
  bool own = false;                   ///< something lies in a region of its component, for what is said of it
  /// All but walls.
  std::string list() const {
    std::string list;
    count(list, cracks, "face inside of a region", "faces inside of regions");
    count(list, dangling, "face that bounds no region", "faces that bound no region");
    count(list, wires, "wire", "wires");
    count(list, points, "isolated point", "isolated points");
    return list;
  }
};

Others others_in(const FlatComplex& flat) {
  Others others;
  for (const auto& face : flat.faces) {
    if (face.component == 0 || !face.own) continue;
    const int bounded = flat.regions_bounded(face);
    if (bounded == 1) continue;
    others.own = others.own || !face.entity;
    ++(bounded == 2 ? others.walls : flat.active(face.regions[0]) ? others.cracks : others.dangling);
  }
  const auto see = [&](std::size_t& n, const auto& cell) {
    ++n;
    if (!cell.entity) others.own = true;
    else (flat.active(cell.region) ? others.inner : others.outer) = true;
  };
  for (const auto& edge : flat.edges) {
    if (edge.wire && edge.own) see(others.wires, edge);
  }
  for (const auto& vertex : flat.vertices) {
    if (vertex.own && vertex.region != FlatComplex::kNone) see(others.points, vertex);
  }
  return others;
}

}  // namespace

void require_off_frame(const FlatComplex& flat, const std::string& format) {
  const auto on_frame = [&](const FlatComplex::Loop& loop) {
    return std::any_of(loop.begin(), loop.end(), [&](Index p) {
      return std::binary_search(flat.frame_points.begin(), flat.frame_points.end(), p);
    });
  };
  for (const auto& face : flat.faces) {
    if (face.component != 0 && std::any_of(face.loops.begin(), face.loops.end(), on_frame)) {
      throw InputError(format + " cannot hold a face without bounds" + kBound);
    }
  }
  for (const auto& edge : flat.edges) {
    if (edge.component != 0 && on_frame(edge.points)) {
      throw InputError(format + " cannot hold a line without bounds" + kBound);
    }
  }
}

void require_closed(const FlatComplex& flat, const std::string& format) {
  // An inactive cell is listed because it is on the boundary of active ones.
  const auto missing = [](const auto& cells) {
    return std::size_t(std::count_if(cells.begin(), cells.end(), [](const auto& c) { return c.component == 0; }));
  };
  std::string list;
  count(list, missing(flat.faces), "boundary face", "boundary faces");
  count(list, missing(flat.edges), "boundary edge", "boundary edges");
  count(list, missing(flat.vertices), "boundary vertex", "boundary vertices");
  if (!list.empty()) {
    throw InputError(format + " holds closed sets only, and the result lacks " + list +
                     "; write .json or .vtu, or apply `closure`");
  }
}

void require_closed_and_bounded(const FlatComplex& flat, const std::string& format) {
  require_off_frame(flat, format);
  for (const auto& region : flat.regions) {
    if (region.component != 0 && !region.bounded) {
      throw InputError(format + " cannot hold a region without bounds" + kBound);
    }
  }
  require_closed(flat, format);
}

void require_regions_only(const FlatComplex& flat, const std::string& format) {
  const Others others = others_in(flat);
  if (const std::string list = others.list(); !list.empty()) {
    throw InputError(format + " holds solid regions only, and the result has " + list +
                     "; write .glb, .obj, .vtu or .json, which hold everything, or apply " +
                     (others.own ? kDropOwn : "`regularize` (it drops what bounds no region)"));
  }
}

SolidBoundary solid_boundary(const FlatComplex& flat, const std::string& format) {
  require_closed_and_bounded(flat, format);
  const Others others = others_in(flat);
  std::string list;
  count(list, others.walls, "wall between regions", "walls between regions");
  if (const std::string more = others.list(); !more.empty()) list += (list.empty() ? "" : ", ") + more;
  if (!list.empty()) {
    const bool joins = others.walls > 0 || others.cracks > 0 || others.inner;
    const bool drops = others.dangling > 0 || others.outer;
    std::string remedy = drops ? "`regularize` (it drops what bounds no region)" : "";
    if (joins && drops) remedy += " and ";
    if (joins) remedy += "`unify` (it joins regions with what is in them)";
    if (others.own) remedy = kDropOwn;
    throw InputError(format + " holds the outer boundary of solids only, and the result has " + list +
                     "; write .obj, .vtu or .json, which hold everything, or apply " + remedy);
  }
  SolidBoundary boundary;
  std::vector<Index> number(flat.points.size(), FlatComplex::kNone);
  for (const auto& face : flat.faces) {
    if (face.component == 0 || !face.own) continue;
    const bool front = flat.active(face.regions[0]);
    for (auto t : face.triangles) {
      if (front) std::swap(t[1], t[2]);
      boundary.triangles.push_back(t);
      for (const Index p : t) number[p] = 0;
    }
  }
  for (Index p = 0; p < number.size(); ++p) {
    if (number[p] == FlatComplex::kNone) continue;
    number[p] = Index(boundary.points.size());
    boundary.points.push_back(p);
  }
  for (auto& t : boundary.triangles) {
    for (Index& p : t) p = number[p];
  }
  return boundary;
}

}  // namespace cnrg
