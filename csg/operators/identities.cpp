// Point sets are compared as cell sets of the complex: the support of each group's selection, the algebra of
// selection.h. Volumes compare two ways to the same number: the faces of the result that bound its regions, and
// the 3-cells of the operands.
#include "csg/operators/identities.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>

#include "csg/operators/component_lists.h"
#include "csg/operators/detect_regions.h"
#include "kernel/base/sorted.h"
#include "kernel/selection/measure.h"
#include "kernel/selection/scratch.h"
#include "kernel/selection/selection.h"

namespace cnrg {
namespace {

template <class IdT>
std::string kind_and_number(const char* kind, IdT id) {
  return std::string(kind) + ' ' + std::to_string(id.value());
}

template <class List>
bool ascending(const List& list) {
  return std::adjacent_find(list.begin(), list.end(), [](const auto& x, const auto& y) { return !(x < y); }) ==
         list.end();
}

// The first cell in which two sets differ.
std::string first_difference(const CellSet& want, const CellSet& have) {
  const auto compare = [](const char* kind, const auto& w, const auto& h) -> std::string {
    auto it = w.begin();
    auto jt = h.begin();
    while (it != w.end() && jt != h.end() && *it == *jt) ++it, ++jt;
    if (it == w.end() && jt == h.end()) return "";
    const bool missing = jt == h.end() || (it != w.end() && *it < *jt);
    return kind_and_number(kind, missing ? *it : *jt) + (missing ? " is missing" : " is too much");
  };
  std::string out = compare("region", want.regions, have.regions);
  if (out.empty()) out = compare("face", want.faces, have.faces);
  if (out.empty()) out = compare("edge", want.edges, have.edges);
  if (out.empty()) out = compare("vertex", want.vertices, have.vertices);
  return out;
}

std::vector<RegionId> cells_of(const Group& g) {
  std::vector<RegionId> out;
  for (const auto& cell : g.cells) out.push_back(cell.first);
  return out;
}

/// The regions of 3-cells, numbered as they come. A result that was read back keeps the numbers that it has.
std::vector<std::pair<RegionId, std::uint32_t>> numbered_as_detected(const Group& g) {
  std::map<std::uint32_t, std::uint32_t> number;
  std::vector<std::pair<RegionId, std::uint32_t>> cells = g.cells;
  for (auto& [cell, region] : cells)
    region = number.try_emplace(region, static_cast<std::uint32_t>(number.size() + 1)).first->second;
  return cells;
}

CellSet points_of(const Complex& complex, const Group& g) { return support(selection_of(complex, g)); }

}  // namespace

std::string check_group(const Complex& complex, const Group& g) {
  if (!ascending(g.cells) || !ascending(g.faces) || !ascending(g.edges) || !ascending(g.vertices) ||
      !ascending(g.features.edges) || !ascending(g.features.vertices)) {
    return "a list of the group is not ascending";
  }
  const auto includes = [](const auto& set, const auto& part) {
    return std::includes(set.begin(), set.end(), part.begin(), part.end());
  };
  if (!includes(g.edges, g.features.edges) || !includes(g.vertices, g.features.vertices)) {
    return "a feature is no entity";
  }
  for (FaceId f : g.faces) {
    if (complex.on_frame(f)) return kind_and_number("face", f) + " lies on the frame";
  }
  const CellSet entities{g.vertices, g.edges, g.faces, {}};
  if (const std::string d = first_difference(closure(complex, entities), entities); !d.empty()) {
    return "entities are not closed under boundary: " + d;
  }
  // Walls, and regions that are maximal: across a face that is no entity the region is the same.
  Scratch<RegionId, std::uint32_t> region(complex.region_count);
  for (const auto& [cell, number] : g.cells) {
    if (complex.outside_frame(cell)) return "a region reaches beyond the frame";
    if (number == 0 || number > g.regions.size())
      return kind_and_number("region", cell) + " has a number out of range";
    region[cell] = number;
  }
  for (FaceId f : IdRange<FaceId>(complex.face_count())) {
    const auto& [front, back] = complex.face_regions[f];
    if (!complex.on_frame(f) && region[front] != region[back] && !g.has(f)) {
      return kind_and_number("face", f) + " parts regions and is no entity";
    }
  }
  if (detect_regions(complex, cells_of(g), g.faces) != numbered_as_detected(g)) {
    return "the regions are not the detected ones";
  }
  // Around a lower cell that is no entity.
  std::vector<RegionId> around;
  const auto one_region = [&](auto cell) {
    complex.star_regions(cell, around);
    return std::all_of(around.begin(), around.end(), [&](RegionId r) { return region[r] == region[around[0]]; });
  };
  for (EdgeId e : IdRange<EdgeId>(complex.edge_count())) {
    if (!complex.on_frame(e) && !g.has(e) && !one_region(e)) {
      return kind_and_number("edge", e) + " is no entity and not inside one region";
    }
  }
  for (VertexId v : complex.vertices) {
    if (!complex.on_frame(v) && !g.has(v) && !one_region(v)) {
      return kind_and_number("vertex", v) + " is no entity and not inside one region";
    }
  }
  return "";
}

std::string check_point_set(const Complex& complex, BooleanOp op, const Group& a, const Group& b,
                            const Group& result) {
  const CellSet in_a = points_of(complex, a), in_b = points_of(complex, b);
  CellSet want;
  switch (op) {
    case BooleanOp::unite: want = unite(in_a, in_b); break;
    case BooleanOp::intersect: want = intersect(in_a, in_b); break;
    case BooleanOp::subtract: want = closure(complex, subtract(in_a, in_b)); break;
  }
  const std::string d = first_difference(want, points_of(complex, result));
  return d.empty() ? "" : std::string("the point set is not that of the ") + name(op) + ": " + d;
}

std::string check_volumes(const Complex& complex, BooleanOp op, const Group& a, const Group& b,
                          const Group& result) {
  const std::vector<RegionId> in_a = cells_of(a), in_b = cells_of(b);
  const auto volume_a = volume(complex, in_a), volume_b = volume(complex, in_b);
  const auto volume_common = volume(complex, in_common(in_a, in_b));
  if (!volume_a || !volume_b || !volume_common) return "";
  // The result region by region.
  std::map<std::uint32_t, std::vector<RegionId>> regions;
  for (const auto& [cell, number] : result.cells) regions[number].push_back(cell);
  Rational total = 0;
  for (const auto& [number, cells] : regions) {
    const auto one = volume(complex, cells);
    if (!one) return "a bounded group has an unbounded result";
    if (*one <= 0) return "region " + std::to_string(number) + " of the result has no volume";
    total += *one;
  }
  Rational want = *volume_common;
  if (op == BooleanOp::unite) want = *volume_a + *volume_b - *volume_common;
  if (op == BooleanOp::subtract) want = *volume_a - *volume_common;
  if (total == want) return "";
  return std::string("the volume of the ") + name(op) + " is " + to_string(total) + ", not " + to_string(want);
}

std::string check_boolean(const Complex& complex, BooleanOp op, const Group& a, const Group& b,
                          const Group& result) {
  std::string out = check_group(complex, result);
  if (out.empty()) out = check_point_set(complex, op, a, b, result);
  if (out.empty()) out = check_volumes(complex, op, a, b, result);
  if (out.empty()) {
    const bool bounded = std::none_of(result.cells.begin(), result.cells.end(),
                                      [&](const auto& cell) { return complex.unbounded(cell.first); });
    if (bounded && !complex.frame.valid()) out = check_euler(complex, points_of(complex, result));
  }
  return out;
}

std::string check_complement(const Complex& complex, const Group& g, const Group& result) {
  std::string out = check_group(complex, result);
  if (!out.empty()) return out;
  CellSet held;
  held.regions = cells_of(g);
  CellSet rest;
  rest.regions = subtract(all_cells(complex), held).regions;
  const CellSet want = closure(complex, rest);
  const std::string d = first_difference(want, points_of(complex, result));
  return d.empty() ? "" : "the point set is not that of the complement: " + d;
}

std::string check_components(const Complex& complex, const Components& x) {
  std::vector<char> used(x.attributes.size(), 0);
  std::string out;
  const auto see = [&](const auto& list, const auto& origins) {
    if (list.size() != origins.size()) out = "origins are not parallel to the cells";
    for (std::size_t k = 0; k < list.size(); ++k) {
      if (k > 0 && !(list[k - 1].first < list[k].first)) out = "a list of components is not ascending";
      const Component c = list[k].second;
      if (c == 0 || c > used.size()) out = "a component has no attributes";
      else used[c - 1] = 1;
    }
  };
  for_each_dimension(see, x.selection, x.origins);
  if (!out.empty()) return out;
  if (std::find(used.begin(), used.end(), 0) != used.end()) return "a component has no cells";
  for (const auto& [face, component] : x.selection.faces) {
    if (complex.on_frame(face)) return kind_and_number("face", face) + " lies on the frame";
  }
  const Features features = active(x.selection, x.features);
  if (features.edges != x.features.edges || features.vertices != x.features.vertices) {
    return "a feature is not active";
  }
  return "";
}

std::string check_overlay(OverlayLaw law, const Complex& complex, const Components& x, const Components& y,
                          const Components& result) {
  std::string out = check_components(complex, result);
  if (!out.empty()) return out;
  const CellSet a = support(x.selection), b = support(y.selection);
  const CellSet want = law == OverlayLaw::sum       ? unite(a, b)
                       : law == OverlayLaw::product ? intersect(a, b)
                                                    : subtract(a, b);
  out = first_difference(want, support(result.selection));
  if (!out.empty()) return "the point set is not that of the operator: " + out;
  // All cells of a component have one component of X and one of Y.
  std::vector<std::optional<std::pair<Component, Component>>> seen(result.attributes.size());
  const auto check = [&](const auto& list, const auto& in_x, const auto& in_y) {
    for (const auto& [id, component] : list) {
      const std::size_t i = place_in(in_x, id), j = place_in(in_y, id);
      const std::pair pair(i == in_x.size() ? 0 : in_x[i].second, j == in_y.size() ? 0 : in_y[j].second);
      auto& known = seen[component - 1];
      if (known && *known != pair) out = "a component holds cells of two components of an operand";
      known = pair;
    }
  };
  for_each_dimension(check, result.selection, x.selection, y.selection);
  std::sort(seen.begin(), seen.end());
  if (out.empty() && std::adjacent_find(seen.begin(), seen.end()) != seen.end()) {
    out = "two components of the result are one pair of components of the operands";
  }
  return out;
}

std::string check_topological(const Complex& complex, Topological op, bool each, const Components& x,
                              const Components& result) {
  std::string out = check_components(complex, result);
  if (!out.empty()) return out;
  CellSet want;
  if (each) {
    for (const CellSet& one : supports(x)) want = unite(want, topological_operation(complex, op, one));
  } else {
    want = topological_operation(complex, op, support(x.selection));
  }
  const std::string d = first_difference(want, support(result.selection));
  return d.empty() ? "" : std::string("the point set is not that of ") + name(op) + ": " + d;
}

}  // namespace cnrg
