// Local shapes and Betti numbers are asked of the cells of the complex, and reported by the cells that
// simplification leaves: a chain of edges has one shape all along.
#include "csg/topology/topology.h"

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "csg/operators/component_lists.h"
#include "csg/text/escape.h"
#include "csg/text/table.h"
#include "csg/topology/around.h"
#include "csg/topology/manufacturable.h"
#include "csg/topology/region_graph.h"
#include "kernel/base/error.h"
#include "kernel/base/sorted.h"
#include "kernel/selection/canonical.h"
#include "kernel/selection/homology.h"
#include "kernel/selection/manifold.h"

namespace cnrg {
namespace {

using Index = std::uint32_t;
constexpr std::size_t kNamesPerReason = 12;

/// True if a cell of a closed set reaches infinity (the frame).
bool unbounded(const Complex& complex, const CellSet& set) {
  const auto reaches = [&](EdgeId e) {
    const auto& [a, b] = complex.edge_ends[e];
    return complex.on_frame(a) || complex.on_frame(b);
  };
  const auto any = [](const auto& cells, auto test) { return std::any_of(cells.begin(), cells.end(), test); };
  return any(set.regions, [&](RegionId r) { return complex.unbounded(r); }) || any(set.edges, reaches) ||
         any(set.faces,
             [&](FaceId f) { return any(complex.half_edges(f), [&](HalfEdge h) { return reaches(h.edge()); }); });
}

template <class IdT>
bool has(const std::vector<IdT>& list, IdT id) {
  return std::binary_search(list.begin(), list.end(), id);
}

/// The cells that each simplified face and region unites.
struct United {
  std::vector<CellSet> faces, regions;

  United(const Complex& complex, const SimplifiedComplex& simplified)
      : faces(simplified.faces.size()), regions(simplified.regions.size()) {
    const auto deal = [&](const SimplifiedComplex::Place& place, auto cell, auto member) {
      if (place.dimension < 2 || place.index == SimplifiedComplex::kNowhere) return;
      ((place.dimension == 2 ? faces : regions)[place.index].*member).push_back(cell);
    };
    for (VertexId v : complex.vertices) deal(simplified.vertex_place[v.index()], v, &CellSet::vertices);
    for (EdgeId e : IdRange<EdgeId>(complex.edge_count())) {
      deal(simplified.edge_place[e.index()], e, &CellSet::edges);
    }
    for (FaceId f : IdRange<FaceId>(complex.face_count())) {
      deal(simplified.face_place[f.index()], f, &CellSet::faces);
    }
    for (RegionId r : IdRange<RegionId>(complex.region_count)) {
      deal(simplified.region_place[r.index()], r, &CellSet::regions);
    }
  }
};

SimplifiedEuler euler_of(const Complex& complex, const CellSet& closed, const SimplifiedComplex& simplified,
                         BettiCounter& counter) {
  const United united(complex, simplified);
  SimplifiedEuler t;
  for (const auto& vertex : simplified.vertices) t.v += has(closed.vertices, vertex.cell);
  for (const auto& edge : simplified.edges) {
    if (!has(closed.edges, edge.chain.front().edge())) continue;
    ++t.e;
    t.edge_loops += edge.closed;
  }
  for (std::size_t i = 0; i < simplified.faces.size(); ++i) {
    if (!has(closed.faces, simplified.faces[i].cells.front().face())) continue;
    const auto& face = simplified.faces[i];
    ++t.f;
    if (is_flat(complex, face)) {
      t.r += static_cast<std::int64_t>(face.loops.size() - 1 + face.isolated.size());
      continue;
    }
    const auto b = counter.of(united.faces[i]).z2;
    t.r += b[1];
    t.closed_faces += b[2];
  }
  for (std::size_t i = 0; i < simplified.regions.size(); ++i) {
    if (!has(closed.regions, simplified.regions[i].cells.front())) continue;
    const auto b = counter.of(united.regions[i]).z2;
    ++t.volumes;
    t.volume_holes += b[1];
    t.volume_cavities += b[2];
  }
  const auto b = counter.of(closed).z2;
  t.pieces = b[0], t.holes = b[1], t.cavities = b[2];
  return t;
}

std::string euler_text(const SimplifiedEuler& t, bool closed) {
  const bool patches = t.edge_loops != 0 || t.closed_faces != 0;
  const auto side = [](const char* sign, std::int64_t value) { return sign + std::to_string(value); };
  std::string left = std::to_string(t.v);
  left += patches ? side(" - (", t.e) + side(" - ", t.edge_loops) + ")" : side(" - ", t.e);
  left += side(" + (", t.f) + side(" - ", t.r) + (patches ? side(" + ", t.closed_faces) : "") + ")";
  left += side(" - (", t.volumes) + side(" - ", t.volume_holes) + side(" + ", t.volume_cavities) + ")";
  const std::string right = std::to_string(t.pieces) + side(" - ", t.holes) + side(" + ", t.cavities);
  std::string out = closed ? "Euler-Poincaré (Masuda 1993)\n" : "Euler-Poincaré (Masuda 1993), of the closure\n";
  out += patches ? "  v - (e - eh) + (f - r + fc) - (V - Vh + Vc) = C - Ch + Cc\n"
                 : "  v - e + (f - r) - (V - Vh + Vc) = C - Ch + Cc\n";
  out += "  " + left + " = " + right + side("   (", t.left()) + side(" = ", t.right()) + ")\n";
  out +=
      "  vertices v, edges e, faces f, rings of faces r; volumes V, their handles Vh and cavities Vc;\n"
      "  pieces C, holes through the whole Ch, cavities Cc";
  out += patches ? "; edges that close without a vertex eh, faces without boundary fc\n" : "\n";
  return out;
}

std::string betti_text(const std::vector<BettiNumbers>& numbers, const std::vector<Component>& components,
                       std::span<const RegionAttributes> attributes) {
  Table table({"<Betti numbers", "b0(Z/2)", "b1(Z/2)", "b2(Z/2)", "b0(Q)", "b1(Q)", "b2(Q)"});
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::string name = i == 0 ? "point set" : component_name(attributes, components[i - 1]);
    std::vector<std::string> row{"  " + name};
    for (std::int64_t b : numbers[i].z2) row.push_back(std::to_string(b));
    for (std::int64_t b : numbers[i].q) row.push_back(std::to_string(b));
    table.add_row(std::move(row));
  }
  return table.text() + "  b0: pieces, b1: independent loops, b2: enclosed cavities\n";
}

constexpr std::size_t kMissing = 8;  ///< after the last LocalForm: of the closure, not of the set

std::string form_name(std::size_t i) { return i == kMissing ? "missing" : to_string(static_cast<LocalForm>(i)); }

/// Shapes of the simplified cells: how many cells of the set have each form, and the names by reason, also of
/// cells that the set misses.
struct Shapes {
  using Counts = std::array<std::size_t, kMissing + 1>;
  Counts vertices{}, edges{};
  std::map<std::pair<int, std::string>, std::vector<std::string>> reasons;  // by dimension, edges first
  std::vector<Index> odd_edges, odd_vertices;                               // not manifold

  Shapes(const Complex& complex, const CellSet& set, const SimplifiedComplex& simplified,
         Neighbourhoods& neighbourhoods) {
    const Manifoldness m = manifoldness(complex, set, neighbourhoods);
    for (Index i = 0; i < simplified.edges.size(); ++i) {
      const EdgeId e = simplified.edges[i].chain.front().edge();
      if (count(m.edges, e, edges, -1, cell_name(1, i), simplified.edges[i].component != 0))
        odd_edges.push_back(i);
    }
    for (Index i = 0; i < simplified.vertices.size(); ++i) {
      const auto& [cell, component] = simplified.vertices[i];
      if (count(m.vertices, cell, vertices, 0, cell_name(0, i), component != 0)) odd_vertices.push_back(i);
    }
  }

 private:
  // True for a cell that is not manifold.
  template <class IdT>
  bool count(const std::vector<std::pair<IdT, LocalShape>>& shapes, IdT cell, Counts& counts, int order,
             const std::string& name, bool of_the_set) {
    const LocalShape* const shape = value_of_key(shapes, cell);
    if (shape == nullptr) return false;  // not in the closure of the set
    ++counts[of_the_set ? static_cast<std::size_t>(shape->form) : kMissing];
    if (shape->reason.empty()) return false;
    reasons[{order, shape->reason}].push_back(name);
    return true;
  }
};

/// The first names, and how many more.
std::string some_of(const std::vector<std::string>& names) {
  std::string out;
  for (std::size_t i = 0; i < std::min(names.size(), kNamesPerReason); ++i) out += (i == 0 ? "" : ", ") + names[i];
  if (names.size() > kNamesPerReason) out += " and " + grouped(names.size() - kNamesPerReason) + " more";
  return out;
}

std::string shapes_text(const Shapes& shapes) {
  Table table({"<local shape", "vertices", "edges"});
  for (std::size_t i = 0; i < shapes.vertices.size(); ++i) {
    if (shapes.vertices[i] + shapes.edges[i] == 0) continue;
    table.add_row({"  " + form_name(i), grouped(shapes.vertices[i]), grouped(shapes.edges[i])});
  }
  std::string out = table.text();
  out += "  manifold: one half-ball of solid; surface, surface border: one sheet without solid; wire: no face\n";
  for (const auto& [key, names] : shapes.reasons) out += "  " + key.second + ": " + some_of(names) + "\n";
  return out;
}

std::string manufacturable_text(const Manufacturability& m, std::span<const RegionAttributes> components) {
  if (m.yes()) return "manufacturable: yes, " + grouped(m.solids) + (m.solids == 1 ? " solid\n" : " solids\n");
  std::string out = "manufacturable: no\n";
  if (m.solids == 0) out += "  there is no solid\n";
  const auto add = [&](const char* what, const std::vector<std::string>& names) {
    if (!names.empty()) out += std::string("  ") + what + ": " + some_of(names) + "\n";
  };
  add("faces without thickness", m.dangling_faces);
  add("wires", m.wires);
  add("loose points", m.loose_points);
  for (const auto& t : m.touches) {
    append_line(out, "  " + component_name(components, t.component) + ", " + t.reason + ": " + some_of(t.cells));
  }
  for (const Component c : m.unbounded) append_line(out, "  " + component_name(components, c) + " is unbounded");
  return out;
}

std::string sheets_text(const std::vector<Sheet>& sheets) {
  if (sheets.empty()) return "";
  const auto closed = std::count_if(sheets.begin(), sheets.end(), [](const Sheet& s) { return s.closed; });
  const auto one_sided = std::count_if(sheets.begin(), sheets.end(), [](const Sheet& s) { return !s.orientable; });
  return "sheets without solid: " + grouped(sheets.size()) + ", closed " + std::to_string(closed) +
         ", one-sided (not orientable) " + std::to_string(one_sided) + "\n";
}

std::string adjacency_text(const RegionGraph& graph) {
  if (graph.edges.empty()) return "";
  std::string out = "adjacent regions\n";
  for (const RegionGraph::Edge& e : graph.edges) {
    append_line(out, "  " + graph.nodes[e.nodes[0]].name + " - " + graph.nodes[e.nodes[1]].name + ": " +
                         grouped(e.faces) + (e.faces == 1 ? " face" : " faces"));
  }
  return out;
}

/// All that is told, each counted once.
struct Facts {
  CellSet set;
  bool closed = true;                    ///< the set is
  std::optional<SimplifiedEuler> euler;  ///< nothing of an unbounded set
  std::vector<Component> components;
  std::vector<BettiNumbers> betti;  ///< of the point set, then of each component
  Shapes shapes;
  std::vector<Sheet> sheets;
  RegionGraph graph;
  Manufacturability manufacturability;
};

/// Nothing of the empty set.
std::optional<Facts> facts_of(const Complex& complex, const Selection& selection,
                              const SimplifiedComplex& simplified, std::span<const RegionAttributes> components,
                              Neighbourhoods& neighbourhoods) {
  CellSet set = support(selection);
  if (set.empty()) return {};
  BettiCounter counter(neighbourhoods);
  const CellSet closed = closure(complex, set);
  std::optional<SimplifiedEuler> euler;
  if (!unbounded(complex, closed)) euler = euler_of(complex, closed, simplified, counter);
  std::vector<Component> active = components_in(selection);
  std::vector<BettiNumbers> betti = betti_numbers(selection, active, counter);
  Shapes shapes(complex, set, simplified, neighbourhoods);
  std::vector<Sheet> found = sheets(complex, set);
  const bool is_closed = subtract(closed, set).empty();
  return Facts{std::move(set),
               is_closed,
               euler,
               std::move(active),
               std::move(betti),
               std::move(shapes),
               std::move(found),
               region_graph(simplified, components),
               cnrg::manufacturability(complex, selection, simplified, neighbourhoods)};
}

std::string text_of_facts(const std::optional<Facts>& facts, const Complex& complex,
                          const SimplifiedComplex& simplified, std::span<const RegionAttributes> components,
                          Neighbourhoods& neighbourhoods) {
  if (!facts) return "the point set is empty\n";
  std::string out;
  if (facts->euler) out += euler_text(*facts->euler, facts->closed);
  else out += "Euler-Poincaré: not stated, the point set is unbounded\n";
  out += betti_text(facts->betti, facts->components, components);
  out += shapes_text(facts->shapes);
  out += radial_orders_text(complex, simplified, components, facts->shapes.odd_edges);
  out += neighbourhoods_text(simplified, neighbourhoods, facts->shapes.odd_vertices);
  out += sheets_text(facts->sheets);
  out += shells_text(simplified, components);
  out += adjacency_text(facts->graph);
  return out + manufacturable_text(facts->manufacturability, components);
}

using Json = nlohmann::ordered_json;

Json json_of(const SimplifiedEuler& euler) {
  Json out;
  for (std::size_t i = 0; i < euler.kTerms.size(); ++i) out[euler.kTerms[i]] = euler.terms()[i];
  return out;
}

Json json_of(const std::optional<Facts>& facts) {
  if (!facts) return {{"empty", true}};
  Json out{{"empty", false}, {"closed", facts->closed}, {"bounded", facts->euler.has_value()}};
  out["euler"] = facts->euler ? json_of(*facts->euler) : Json();
  Json betti = Json::array();
  for (std::size_t i = 0; i < facts->betti.size(); ++i) {
    betti.push_back({{"component", i == 0 ? 0 : facts->components[i - 1]},
                     {"z2", facts->betti[i].z2},
                     {"q", facts->betti[i].q}});
  }
  out["betti"] = betti;
  Json shapes = Json::object();
  for (std::size_t i = 0; i < facts->shapes.vertices.size(); ++i) {
    shapes[form_name(i)] = {{"vertices", facts->shapes.vertices[i]}, {"edges", facts->shapes.edges[i]}};
  }
  out["shapes"] = shapes;
  out["manifold"] = facts->shapes.reasons.empty();
  Json reasons = Json::array();
  for (const auto& [key, names] : facts->shapes.reasons)
    reasons.push_back({{"reason", key.second}, {"cells", names}});
  out["reasons"] = reasons;
  Json sheets = Json::array();
  for (const Sheet& sheet : facts->sheets) {
    sheets.push_back({{"closed", sheet.closed}, {"orientable", sheet.orientable}});
  }
  out["sheets"] = sheets;
  Json adjacent = Json::array();
  for (const RegionGraph::Edge& e : facts->graph.edges) {
    const auto component = [&](std::size_t side) { return facts->graph.nodes[e.nodes[side]].component; };
    adjacent.push_back({{"components", {component(0), component(1)}}, {"faces", e.faces}});
  }
  out["adjacent"] = adjacent;
  const Manufacturability& m = facts->manufacturability;
  Json touches = Json::array();
  for (const auto& t : m.touches)
    touches.push_back({{"component", t.component}, {"reason", t.reason}, {"cells", t.cells}});
  out["manufacturable"] = {{"yes", m.yes()},          {"solids", m.solids},       {"faces", m.dangling_faces},
                           {"wires", m.wires},        {"points", m.loose_points}, {"touches", touches},
                           {"unbounded", m.unbounded}};
  return out;
}

}  // namespace

SimplifiedEuler simplified_euler(const Complex& complex, const Selection& selection,
                                 const SimplifiedComplex& simplified) {
  const CellSet closed = closure(complex, support(selection));
  require(!unbounded(complex, closed), "simplified_euler: the set is not bounded");
  Neighbourhoods neighbourhoods(complex);
  BettiCounter counter(neighbourhoods);
  return euler_of(complex, closed, simplified, counter);
}

std::string topology_text(const Complex& complex, const Selection& selection, const SimplifiedComplex& simplified,
                          std::span<const RegionAttributes> components) {
  Neighbourhoods neighbourhoods(complex);
  const std::optional<Facts> facts = facts_of(complex, selection, simplified, components, neighbourhoods);
  return text_of_facts(facts, complex, simplified, components, neighbourhoods);
}

TopologyReport topology_report(const Result& result) {
  const Complex& complex = result.complex();
  std::vector<RegionAttributes> components;
  for (Component i = 1; i <= result.component_count(); ++i) components.push_back(result.attributes(i));
  Neighbourhoods neighbourhoods(complex);
  const std::optional<Facts> facts =
      facts_of(complex, result.selection(), result.cells(), components, neighbourhoods);
  return {text_of_facts(facts, complex, result.cells(), components, neighbourhoods),
          json_of(facts).dump(-1, ' ', false, Json::error_handler_t::replace)};
}

}  // namespace cnrg
