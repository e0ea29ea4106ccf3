// Lists that belong together are columns: `vertices.point[3]` and `vertices.component[3]` are of v3. A column that
// may have nothing in a place counts from 1 there, and 0 is nothing. Lists of lists are two columns, how many in
// each and all of them.
#include "csg/view/node_data.h"

#include <algorithm>
#include <cmath>

#include "csg/explain/explain.h"
#include "csg/explain/fates.h"
#include "csg/operators/component_lists.h"
#include "csg/operators/node_value.h"
#include "csg/operators/paper_terms.h"
#include "csg/result/palette.h"
#include "csg/result/result_data.h"
#include "csg/text/escape.h"
#include "csg/text/number.h"
#include "csg/topology/around.h"
#include "csg/topology/topology.h"
#include "kernel/base/sorted.h"
#include "kernel/base/vectors.h"
#include "kernel/exact/trigonometry.h"
#include "kernel/selection/homology.h"
#include "kernel/selection/manifold.h"
#include "kernel/selection/measure.h"

namespace cnrg {
namespace {

using Json = nlohmann::ordered_json;
using Numbers = std::vector<std::uint32_t>;
using Index = FlatComplex::Index;

/// From 1; 0: none.
std::uint32_t optional(Index index) { return index == FlatComplex::kNone ? 0 : index + 1; }

/// Lists of numbers as two columns.
struct Lists {
  Numbers counts, all;
  template <class List>
  void add(const List& list) {
    counts.push_back(static_cast<std::uint32_t>(list.size()));
    all.insert(all.end(), list.begin(), list.end());
  }
  void into(Json& json, const std::string& name) const {
    json[name + "_counts"] = packed(counts);
    json[name] = packed(all);
  }
};

/// What is said of faces, edges and vertices by themselves, each thing once, with the color that pictures by
/// material give it.
class SaidList {
 public:
  SaidList(const CellColors& colors, PageTables& tables) : colors_(colors), tables_(tables) {}

  /// From 1; 0: nothing is said.
  std::uint32_t number(int dimension, Index i, const Attributes* said) {
    if (said == nullptr) return 0;
    const auto [it, fresh] = numbers_.try_emplace(*said, static_cast<std::uint32_t>(numbers_.size()) + 1);
    if (fresh) {
      Json entry = json_of(*said);
      if (!said->material.empty()) {
        entry["color"] = number_in(tables_.colors, hex(colors_.of(ColorBy::material, dimension, i).color));
      }
      list_.push_back(std::move(entry));
    }
    return it->second;
  }
  Json take() { return std::move(list_); }

  static Json json_of(const Attributes& said) {
    Json properties = Json::array();
    for (const auto& [key, value] : said.properties) properties.push_back({shown(key), shown(to_text(value))});
    return {
        {"name", shown(said.name.text())}, {"material", shown(said.material.name())}, {"attributes", properties}};
  }

 private:
  const CellColors& colors_;
  PageTables& tables_;
  std::map<Attributes, std::uint32_t, AttributesOrder> numbers_;
  Json list_ = Json::array();
};

/// The cells of a flattened value as columns.
class Cells {
 public:
  /// With `said`, what is said of cells is listed there.
  Cells(const FlatComplex& flat, PageTables& tables, SaidList* said = nullptr)
      : flat_(flat), tables_(tables), said_(said) {}

  /// `origins`: also where cells came from, and what only cells of a result have.
  Json json(bool origins) {
    Numbers points;
    for (const VertexId v : flat_.points) points.push_back(tables_.point(v));
    Json out;
    out["points"] = packed(points);
    out["vertices"] = vertices(origins);
    out["edges"] = edges(origins);
    out["faces"] = faces(origins);
    if (origins) out["regions"] = regions();
    return out;
  }

 private:
  const FlatComplex& flat_;
  PageTables& tables_;
  SaidList* const said_;

  std::uint32_t origin(const FlatComplex::Provenance& from) const {
    return from.cells.empty() ? 0
                              : number_in(tables_.origins, std::vector(from.cells.begin(), from.cells.end())) + 1;
  }

  /// A column: a number of each cell.
  template <class List, class Of>
  static std::string column(const List& cells, Of of) {
    Numbers numbers;
    for (const auto& cell : cells) numbers.push_back(static_cast<std::uint32_t>(of(cell)));
    return packed(numbers);
  }
  template <class List>
  void add_common(Json& out, int dimension, const List& cells, bool origins) const {
    out["component"] = column(cells, [](const auto& c) { return c.component; });
    if (origins) out["origin"] = column(cells, [&](const auto& c) { return origin(c.origin); });
    if (said_ == nullptr || dimension == 3) return;
    Index i = 0;
    out["said"] = column(cells, [&](const auto& c) { return said_->number(dimension, i++, c.origin.said); });
  }

  Json vertices(bool origins) const {
    Json out;
    out["point"] = column(flat_.vertices, [](const auto& v) { return v.point; });
    out["flags"] = column(flat_.vertices, [](const auto& v) { return v.entity | v.feature << 1 | v.free << 2; });
    out["region"] = column(flat_.vertices, [](const auto& v) { return optional(v.region); });
    add_common(out, 0, flat_.vertices, origins);
    return out;
  }

  Json edges(bool origins) const {
    Json out;
    Lists points;
    for (const auto& e : flat_.edges) points.add(e.points);
    points.into(out, "points");
    out["flags"] = column(flat_.edges, [](const auto& e) {
      return e.closed | e.entity << 1 | e.feature << 2 | e.wire << 3 | e.slit << 4;
    });
    out["region"] = column(flat_.edges, [](const auto& e) { return optional(e.region); });
    add_common(out, 1, flat_.edges, origins);
    return out;
  }

  Json faces(bool origins) const {
    Json out;
    Lists loops, walks, isolated, triangles;
    for (const auto& f : flat_.faces) {
      Numbers lengths, corners;
      for (const auto& loop : f.loops) {
        lengths.push_back(static_cast<std::uint32_t>(loop.size()));
        walks.all.insert(walks.all.end(), loop.begin(), loop.end());
      }
      loops.add(lengths);
      isolated.add(f.isolated);
      for (const auto& t : f.triangles) corners.insert(corners.end(), t.begin(), t.end());
      triangles.add(corners);
    }
    loops.into(out, "loops");
    out["walks"] = packed(walks.all);
    isolated.into(out, "isolated");
    triangles.into(out, "triangles");
    out["flags"] = column(flat_.faces, [](const auto& f) { return f.entity | !f.facets.empty() << 1; });
    add_common(out, 2, flat_.faces, origins);
    if (!origins) return out;
    out["front"] = column(flat_.faces, [](const auto& f) { return optional(f.regions[0]); });
    out["back"] = column(flat_.faces, [](const auto& f) { return optional(f.regions[1]); });
    std::map<FlatComplex::Patch, std::uint32_t> patches;
    out["patch"] =
        column(flat_.faces, [&](const auto& f) { return f.patch ? number_in(patches, *f.patch) + 1 : 0; });
    return out;
  }

  Json regions() const {
    Json out;
    Lists shells;
    Numbers sides;
    Json volumes = Json::array();
    for (const auto& r : flat_.regions) {
      Numbers lengths;
      for (const auto& shell : r.shells) {
        lengths.push_back(static_cast<std::uint32_t>(shell.size()));
        sides.insert(sides.end(), shell.begin(), shell.end());
      }
      shells.add(lengths);
      const std::optional<Rational> size =
          r.bounded && r.component != 0 ? volume(tables_.complex, r.cells) : std::nullopt;
      volumes.push_back(size ? Json{to_string(*size), to_decimal(*size)} : Json());
    }
    shells.into(out, "shells");
    out["sides"] = packed(sides);
    out["bounded"] = column(flat_.regions, [](const auto& r) { return r.bounded; });
    out["volume"] = volumes;
    add_common(out, 3, flat_.regions, true);
    return out;
  }
};

/// How many cells of the refinement the cells that are shown unite.
std::size_t pieces_of(const SimplifiedComplex& s) {
  std::size_t count = s.vertices.size();
  for (const auto& e : s.edges) count += e.chain.size();
  for (const auto& f : s.faces) count += f.cells.size();
  for (const auto& r : s.regions) count += r.cells.size();
  return count;
}

/// The faces around each edge of the node, and the region behind each (csg/topology/around.h); at the edge of the
/// refinement where they were asked for, and at what angle from the first.
Json radial_orders(const Complex& complex, const SimplifiedComplex& s, PageTables& tables) {
  Json out;
  Numbers from, to, counts, faces, regions;
  std::vector<float> angles;
  for (const SimplifiedComplex::Edge& edge : s.edges) {
    const EdgeAbout about = faces_about(complex, s, edge);
    const std::array<VertexId, 2> ends{complex.origin(about.way), complex.target(about.way)};
    from.push_back(tables.point(ends[0]));
    to.push_back(tables.point(ends[1]));
    const DoubleVector d = minus(complex.points.approx(ends[1]), complex.points.approx(ends[0]));
    DoubleVector first{}, across{};
    double before = 0;
    for (const FaceAbout& face : about.faces) {
      const bool is_first = &face == &about.faces.front();
      // Into the face: its normal times the direction in which it is to the left.
      const ExactPlane& plane = complex.points.exact_plane(complex.plane(face.use.face));
      const Integer size = abs(plane.a) + abs(plane.b) + abs(plane.c);
      const double sign = face.use.half_edge.direction() == about.way.direction() ? 1 : -1;
      const DoubleVector n{sign * to_double(Rational(plane.a, size)), sign * to_double(Rational(plane.b, size)),
                           sign * to_double(Rational(plane.c, size))};
      const DoubleVector into = cross(n, d);
      if (is_first) {
        first = into;
        across = cross(d, into);
      }
      double angle =
          is_first ? 0 : rounded::arc_tangent(dot(into, across) / std::sqrt(dot(d, d)), dot(into, first));
      if (angle < 0) angle += 2 * M_PI;
      angle = std::max(angle, before);  // the order is exact, the angle is rounded
      before = angle;
      faces.push_back(face.face);
      regions.push_back(face.region);
      angles.push_back(static_cast<float>(angle));
    }
    counts.push_back(static_cast<std::uint32_t>(about.faces.size()));
  }
  out["from"] = packed(from);
  out["to"] = packed(to);
  out["counts"] = packed(counts);
  out["faces"] = packed(faces);
  out["regions"] = packed(regions);
  out["angles"] = packed(angles);
  return out;
}

/// Numbers of colors: by material and by component for each component, from 0; by region for each region. By
/// source a color is of an origin, and the page has it once.
Json color_numbers(const ResultView& view, const FlatComplex& flat, const CellColors& colors, PageTables& tables) {
  const auto number = [&](const CellColor& c) { return number_in(tables.colors, hex(c.color)); };
  Json out;
  Numbers material, component, region;
  std::array<Numbers, 3> lower;
  for (Component c = 0; c <= view.value->component_count(); ++c) {
    component.push_back(number(colors.of_component(c)));
    material.push_back(number(colors.of_material(3, c)));
    for (int d = 0; d < 3; ++d) lower[static_cast<std::size_t>(d)].push_back(number(colors.of_material(d, c)));
  }
  for (Index r = 0; r < flat.regions.size(); ++r) region.push_back(number(colors.of_region(r)));
  out["material"] = {
      {"v", packed(lower[0])}, {"e", packed(lower[1])}, {"f", packed(lower[2])}, {"r", packed(material)}};
  out["component"] = packed(component);
  out["region"] = packed(region);
  return out;
}

bool is_bounded(const FlatComplex& flat) {
  return flat.frame_points.empty() && std::all_of(flat.regions.begin(), flat.regions.end(),
                                                  [](const auto& r) { return r.component == 0 || r.bounded; });
}

/// Euler-Poincare term by term, Betti numbers, and what the set looks like around vertices and edges.
void add_topology(const Evaluation& evaluation, const KeptValue& kept, const FlatComplex& flat, PageTables& tables,
                  Json& out) {
  const Complex& complex = *evaluation.complex;
  const Selection selection = selection_of(complex, *kept.value);
  const CellSet set = support(selection);
  if (set.empty()) return;
  Neighbourhoods neighbourhoods(complex);
  if (is_bounded(flat)) {
    const SimplifiedEuler euler = simplified_euler(complex, selection, *kept.simplified);
    for (std::size_t i = 0; i < euler.kTerms.size(); ++i) out["euler"][euler.kTerms[i]] = euler.terms()[i];
    out["euler"]["closed"] = subtract(closure(complex, set), set).empty();
  }
  BettiCounter counter(neighbourhoods);
  const std::vector<Component> components = components_in(selection);
  const std::vector<BettiNumbers> numbers = betti_numbers(selection, components, counter);
  Json betti = Json::array();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto& [z2, q] = numbers[i];
    betti.push_back({i == 0 ? 0 : components[i - 1], z2[0], z2[1], z2[2], q[0], q[1], q[2]});
  }
  out["betti"] = betti;
  const Manifoldness shapes = manifoldness(complex, set, neighbourhoods);
  const auto word = [&](const LocalShape* shape) -> std::uint32_t {
    if (shape == nullptr) return 0;
    const std::string form = to_string(shape->form);
    return number_in(tables.words, shape->reason.empty() ? form : form + ": " + shape->reason) + 1;
  };
  Numbers vertices, edges;
  for (const auto& v : kept.simplified->vertices) vertices.push_back(word(value_of_key(shapes.vertices, v.cell)));
  for (const auto& e : kept.simplified->edges) {
    edges.push_back(word(value_of_key(shapes.edges, e.chain.front().edge())));
  }
  out["shapes"] = {{"vertices", packed(vertices)}, {"edges", packed(edges)}};
}

/// The lines of a text by their numbers.
Numbers lines_of(const std::string& text, PageTables& tables) {
  Numbers lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(number_in(tables.lines, text.substr(at, end - at)));
    at = end + 1;
  }
  return lines;
}

/// Texts as `cnrg explain` prints them, in lines that all texts share.
Json stories(const Tree& tree, const Evaluation& evaluation, const KeptValue& kept, PageTables& tables) {
  const SimplifiedComplex& s = *kept.simplified;
  std::vector<SimplifiedComplex::Place> cells;
  const std::size_t sizes[] = {s.vertices.size(), s.edges.size(), s.faces.size(), s.regions.size()};
  for (int dimension = 0; dimension < 4; ++dimension) {
    for (std::uint32_t i = 0; i < sizes[dimension]; ++i) cells.push_back({dimension, i});
  }
  Lists lists;
  for (const Explanation& e : explain(tree, evaluation, kept.node, cells)) {
    lists.add(lines_of(explanation_text(tree, evaluation, e), tables));
  }
  Json out;
  lists.into(out, "lines");
  return out;
}

std::size_t instances_under(const Evaluation& evaluation, InstanceId id) {
  std::vector<char> below(evaluation.instances.size(), 0);
  below[id.index()] = 1;
  std::size_t count = 0;
  for (std::size_t i = id.index() + 1; i-- > 0;) {
    if (!below[i]) continue;
    ++count;
    for (const InstanceId operand : evaluation.instances[InstanceId(i)].operands) below[operand.index()] = 1;
  }
  return count;
}

/// What `cnrg explain --point` says of each entity that went, at a point in it, and that point; vertices, then
/// edges, then faces.
void add_removed(const Tree& tree, const Evaluation& evaluation, const KeptValue& kept, InstanceId id,
                 const SimplifiedComplex& s, std::size_t& left, PageTables& tables, Json& out) {
  std::vector<Location> cells;
  std::vector<char> removed;
  const auto see = [&](const auto& entities, auto location) {
    for (const auto& entity : entities) {
      removed.push_back(entity.component != 0 && Fate::of(entity.component).removed);
      if (removed.back()) cells.push_back(location(entity));
    }
  };
  see(s.vertices, [](const auto& v) { return Location{0, v.cell, {}, {}, {}}; });
  see(s.edges, [](const auto& e) { return Location{1, {}, e.chain.front().edge(), {}, {}}; });
  see(s.faces, [](const auto& f) { return Location{2, {}, {}, f.cells.front().face(), {}}; });
  const std::size_t cost = cells.size() * instances_under(evaluation, id);
  if (cells.empty() || cost > left) return;
  left -= cost;
  const std::vector<Explanation> told = explain(tree, evaluation, kept.node, cells);
  Lists lists;
  Json points = Json::array();
  std::size_t next = 0;
  for (const char is_removed : removed) {
    if (is_removed == 0) {
      lists.add(Numbers{});
      points.push_back("");
      continue;
    }
    const Explanation& e = told[next++];
    lists.add(lines_of(explanation_text(tree, evaluation, e), tables));
    const RationalPoint& p = *e.asked;
    points.push_back(to_string(p[0]) + "," + to_string(p[1]) + "," + to_string(p[2]));
  }
  lists.into(out, "lines");
  out["told_at"] = points;
}

/// The rows of a Boolean, also those that were asked of nothing, and which operand is A in each step.
Json rows_data(const AskedRows& asked) {
  Json rows = Json::array();
  for (const auto& [number, cells] : asked.cells) {
    const TableRow& row = table_rows()[number];
    rows.push_back({row.id, row.dimension, name(row.relation), condition_words(row), cells[0], cells[1]});
  }
  Json steps = Json::array();
  for (const AskedRows::Step& step : asked.steps) {
    const char* const rules[] = {"operands", "materials", "blend"};
    steps.push_back(
        {step.operand, step.roles.swapped, step.roles.dominant, rules[static_cast<std::size_t>(step.rule)]});
  }
  return {{"rows", rows}, {"steps", steps}};
}

/// The region of the result on either side of each face, and for the vertices, edges and faces of the result the
/// fates of their pieces.
void join_classes(const Complex& complex, const SimplifiedComplex& classes, const Selection& fates,
                  const SimplifiedComplex& result, Json& out) {
  Numbers sides[2];
  for (const auto& face : classes.faces) {
    for (unsigned k = 0; k < 2; ++k) {
      const HalfFace half = k == 0 ? face.cells.front() : face.cells.front().opposite();
      sides[k].push_back(optional(result.place(complex, {3, {}, {}, {}, complex.region(half)}).index));
    }
  }
  out["faces"]["front"] = packed(sides[0]);
  out["faces"]["back"] = packed(sides[1]);
  const auto fate_of = [](const auto& list, auto cell, Numbers& into) {
    if (const Component* const fate = value_of_key(list, cell)) into.push_back(*fate);
  };
  const auto add = [&](const char* kind, const auto& cells, auto pieces) {
    Lists lists;
    for (const auto& cell : cells) {
      Numbers found;
      pieces(cell, found);
      sort_unique(found);
      lists.add(found);
    }
    lists.into(out["of"], kind);
  };
  add("v", result.vertices, [&](const auto& v, Numbers& found) { fate_of(fates.vertices, v.cell, found); });
  add("e", result.edges, [&](const auto& e, Numbers& found) {
    for (const HalfEdge h : e.chain) fate_of(fates.edges, h.edge(), found);
  });
  add("f", result.faces, [&](const auto& f, Numbers& found) {
    for (const HalfFace h : f.cells) fate_of(fates.faces, h.face(), found);
  });
}

/// The fates of the operands' entities, drawn, and which row decided on each.
Json classes_data(const Tree& tree, const Evaluation& evaluation, const KeptValue& kept, InstanceId id,
                  const Selection& selection, std::size_t& removed_left, PageTables& tables) {
  const Result result(evaluation.complex, selection);
  const ResultView view = result.data().view();
  const FlatComplex flat = flatten(view);
  Json out = Cells(flat, tables).json(false);
  join_classes(*evaluation.complex, *view.simplified, selection, *kept.simplified, out);
  const Operator op = tree.nodes[evaluation.instances[id].node].op;
  std::map<Component, std::array<bool, 3>> met;
  const auto see = [&](const auto& cells, std::size_t dimension) {
    for (const auto& cell : cells) {
      if (cell.component != 0) met[cell.component][dimension] = true;
    }
  };
  see(flat.vertices, 0), see(flat.edges, 1), see(flat.faces, 2);
  Json list = Json::object();
  for (const auto& [component, dimensions] : met) {
    const Fate fate = Fate::of(component);
    Json entry{{"removed", fate.removed}};
    if (fate.table) {
      entry["relation"] = name(fate.relation);
      const BooleanOp boolean = op == Operator::unite       ? BooleanOp::unite
                                : op == Operator::intersect ? BooleanOp::intersect
                                                            : BooleanOp::subtract;
      for (int d = 0; d < 3; ++d) {
        if (!dimensions[static_cast<std::size_t>(d)]) continue;
        const TableRow& row = table_rows()[table_row(boolean, fate.dominant, d, fate.relation)];
        entry["rows"][std::to_string(d)] = {row.id, condition_words(row)};
      }
    }
    list[std::to_string(component)] = entry;
  }
  out["fates"] = list;
  add_removed(tree, evaluation, kept, id, *view.simplified, removed_left, tables, out);
  return out;
}

}  // namespace

std::vector<std::string> in_order(const std::map<std::string, std::uint32_t>& table) {
  std::vector<std::string> out(table.size());
  for (const auto& [text, number] : table) out[number] = text;
  return out;
}

PageCosts page_costs(const Evaluation& evaluation, const KeptValue& kept, InstanceId id) {
  PageCosts out;
  out.topology = pieces_of(*kept.simplified);
  out.stories = out.topology * instances_under(evaluation, id);
  const std::vector<InstanceId>& operands = evaluation.instances[id].operands;
  for (const InstanceId operand : operands) {
    const auto& [v, e, f, r] = evaluation.rows[operand.index()].raw_cells;
    out.classes += (v + e + f) * operands.size();
  }
  return out;
}

Json node_data(const Tree& tree, const Evaluation& evaluation, const KeptValue& kept, InstanceId id,
               const Told& told, std::size_t& removed_left, PageTables& tables) {
  const Complex& complex = *evaluation.complex;
  const NodeRow& row = evaluation.rows[id.index()];
  const Result result = evaluation.result(kept.node);
  const ResultView view = result.data().view();
  const FlatComplex flat = flatten(view);

  Json out{{"name", shown(kept.name)}, {"operator", row.operator_name}, {"group", row.is_group}};
  Json components = Json::array();
  for (Component c = 1; c <= kept.value->component_count(); ++c) {
    const RegionAttributes& a = kept.value->attributes(c);
    Numbers leaves;
    for (const LeafId leaf : a.leaves) leaves.push_back(leaf.value());
    components.push_back(SaidList::json_of(a));
    components.back()["leaves"] = leaves;
  }
  out["components"] = components;
  out["counts"] = row.cells;
  out["raw"] = row.raw_cells;
  out["regions"] = row.regions;
  out["volume"] = row.total ? Json{to_string(*row.total), to_decimal(*row.total)} : Json();
  out["within"] = row.total ? bound_text(row.volume_bound()) : "";
  Json removals = Json::array();
  for (const auto& [number, count] : row.removals) {
    const TableRow& rule = table_rows()[number];
    removals.push_back({rule.id, condition_words(rule), count});
  }
  out["removed"] = removals;
  const CellColors colors(view, flat);
  SaidList said(colors, tables);
  out["cells"] = Cells(flat, tables, &said).json(true);
  out["said"] = said.take();
  out["colors"] = color_numbers(view, flat, colors, tables);
  out["radial"] = radial_orders(complex, *kept.simplified, tables);

  if (told.topology) add_topology(evaluation, kept, flat, tables, out);
  if (told.stories) out["stories"] = stories(tree, evaluation, kept, tables);
  if (told.classes) {
    if (const AskedRows asked = asked_rows(tree, evaluation, id); !asked.steps.empty())
      out["asked"] = rows_data(asked);
    if (std::optional<Selection> all = fates(tree, evaluation, id)) {
      out["classes"] = classes_data(tree, evaluation, kept, id, *all, removed_left, tables);
    }
  }
  if (!told.topology) out["left_out"].push_back("topology");
  if (!told.stories) out["left_out"].push_back("stories");
  if (!told.classes) out["left_out"].push_back("classes");
  return out;
}

}  // namespace cnrg
