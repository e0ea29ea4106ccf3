// Set algebra and topology of sparse cell sets: sorted merges for the algebra, incidence lists and marks for
// star and closure. Nothing here looks at a cell that is not in a set or next to one.
#include "kernel/selection/selection.h"

#include <algorithm>
#include <iterator>
#include <type_traits>

#include "kernel/base/sorted.h"
#include "kernel/complex/by_dimension.h"
#include "kernel/selection/scratch.h"

namespace cnrg {
namespace {

template <class IdT>
std::vector<IdT> ids(const std::vector<std::pair<IdT, Component>>& list) {
  std::vector<IdT> out;
  out.reserve(list.size());
  for (const auto& [id, component] : list) out.push_back(id);
  return out;
}

template <class IdT>
std::vector<IdT> ids(const std::vector<std::pair<IdT, Component>>& list, Component wanted) {
  std::vector<IdT> out;
  for (const auto& [id, component] : list) {
    if (component == wanted) out.push_back(id);
  }
  return out;
}

/// An operation on the cells of each dimension of some sets.
template <class Out, class Operation, class... Sets>
Out by_dimension(const Operation& operation, const Sets&... of) {
  return {operation(of.vertices...), operation(of.edges...), operation(of.faces...), operation(of.regions...)};
}

template <class Operation>
CellSet merged(const CellSet& a, const CellSet& b, const Operation& operation) {
  return by_dimension<CellSet>(
      [&](const auto& x, const auto& y) {
        std::remove_cvref_t<decltype(x)> out;
        operation(x.begin(), x.end(), y.begin(), y.end(), std::back_inserter(out));
        return out;
      },
      a, b);
}

template <class IdT>
std::vector<std::pair<IdT, Component>> restricted(const std::vector<std::pair<IdT, Component>>& list,
                                                  const std::vector<IdT>& set) {
  std::vector<std::pair<IdT, Component>> out;
  auto it = set.begin();
  for (const auto& entry : list) {
    while (it != set.end() && *it < entry.first) ++it;
    if (it != set.end() && *it == entry.first) out.push_back(entry);
  }
  return out;
}

template <class IdT>
std::vector<std::pair<IdT, Component>> extended(const std::vector<std::pair<IdT, Component>>& list,
                                                const std::vector<IdT>& set, Component component) {
  std::vector<std::pair<IdT, Component>> out;
  out.reserve(list.size() + set.size());
  auto it = list.begin();
  for (IdT id : set) {
    while (it != list.end() && it->first < id) out.push_back(*it++);
    if (it == list.end() || it->first != id) out.push_back({id, component});
  }
  out.insert(out.end(), it, list.end());
  return out;
}

// The cells of a set as marks, for tests of membership.
struct MarkedSet : OfCells<Marks> {
  MarkedSet(const Complex& complex, const CellSet& set) : OfCells(complex) {
    const auto mark = [](auto& marks, const auto& cells) {
      for (const auto cell : cells) marks[cell] = 1;
    };
    for_each_dimension(mark, *this, set);
  }
};

// Calls `see` for the cells of the open star of a cell, but for those on the frame.
template <class See>
class StarWalk {
 public:
  StarWalk(const Complex& complex, See see) : complex_(complex), see_(see) {}
  template <class IdT>
  void of(IdT cell) {
    if constexpr (std::is_same_v<IdT, VertexId>) visit(complex_.vertex_edges[cell]);
    if constexpr (!std::is_same_v<IdT, FaceId>) {
      complex_.star_faces(cell, faces_);
      visit(faces_);
    }
    complex_.star_regions(cell, regions_);
    for (RegionId r : regions_) {
      if (!complex_.outside_frame(r)) see_(r);
    }
  }

 private:
  void visit(const auto& cells) {
    for (auto cell : cells) {
      if (!complex_.on_frame(cell)) see_(cell);
    }
  }
  const Complex& complex_;
  See see_;
  std::vector<FaceId> faces_;
  std::vector<RegionId> regions_;
};

}  // namespace

CellSet support(const Selection& s) {
  return by_dimension<CellSet>([](const auto& list) { return ids(list); }, s);
}

CellSet support(const Selection& s, Component c) {
  return by_dimension<CellSet>([c](const auto& list) { return ids(list, c); }, s);
}

CellSet all_cells(const Complex& complex) {
  CellSet out;
  const auto take = [&](const auto& all, auto& to) {
    for (const auto id : all) {
      if (!complex.on_frame(id)) to.push_back(id);
    }
  };
  take(complex.vertices, out.vertices);
  take(IdRange<EdgeId>(complex.edge_count()), out.edges);
  take(IdRange<FaceId>(complex.face_count()), out.faces);
  for (RegionId r : IdRange<RegionId>(complex.region_count)) {
    if (!complex.outside_frame(r)) out.regions.push_back(r);
  }
  return out;
}

CellSet unite(const CellSet& a, const CellSet& b) {
  return merged(a, b, [](auto... of) { std::set_union(of...); });
}

CellSet intersect(const CellSet& a, const CellSet& b) {
  return merged(a, b, [](auto... of) { std::set_intersection(of...); });
}

CellSet subtract(const CellSet& a, const CellSet& b) {
  return merged(a, b, [](auto... of) { std::set_difference(of...); });
}

CellSet star(const Complex& complex, const CellSet& set) {
  CellSet out = set;
  StarWalk walk(complex, [&](auto cell) { list_for(out, cell).push_back(cell); });
  const auto walk_all = [&](const auto& cells) {
    for (const auto cell : cells) walk.of(cell);
  };
  for_each_entity(walk_all, set);
  for_each_dimension([](auto& cells) { sort_unique(cells); }, out);
  return out;
}

CellSet closure(const Complex& complex, const CellSet& set) {
  CellSet out = set;
  const auto add = [&](auto cell) {
    if (!complex.on_frame(cell)) list_for(out, cell).push_back(cell);
  };
  for (RegionId r : set.regions) for_each_bounding(complex, r, add);
  sort_unique(out.faces);
  for (FaceId f : out.faces) {
    for (const HalfEdge h : complex.half_edges(f)) add(h.edge());
    for (VertexId v : complex.face_vertices[f]) add(v);
  }
  sort_unique(out.edges);
  for (EdgeId e : out.edges) for_each_bounding(complex, e, add);
  sort_unique(out.vertices);
  return out;
}

CellSet interior(const Complex& complex, const CellSet& set) {
  const MarkedSet marked(complex, set);
  bool whole = true;
  StarWalk walk(complex, [&](auto cell) { whole = whole && list_for(marked, cell)[cell]; });
  const auto keep = [&](const auto& from, auto& to) {
    for (auto id : from) {
      whole = true;
      walk.of(id);
      if (whole) to.push_back(id);
    }
  };
  CellSet out;
  for_each_entity(keep, set, out);
  out.regions = set.regions;
  return out;
}

CellSet boundary(const Complex& complex, const CellSet& set) {
  return subtract(closure(complex, set), interior(complex, set));
}

Selection restrict_to(const Selection& s, const CellSet& set) {
  return by_dimension<Selection>([](const auto& list, const auto& of) { return restricted(list, of); }, s, set);
}

Selection add_component(const Selection& s, const CellSet& set, Component component) {
  return by_dimension<Selection>([&](const auto& list, const auto& of) { return extended(list, of, component); },
                                 s, set);
}

}  // namespace cnrg
