// Members are named as the fields of explain.h, words as in the text. What does not apply is left out.
#include "csg/explain/story.h"

#include <nlohmann/json.hpp>

#include "csg/explain/explain.h"
#include "csg/operators/paper_terms.h"

namespace cnrg {
namespace {

using Json = nlohmann::ordered_json;

const char* const kCellKinds[] = {"point", "wire", "face", "region"};

Json json_of(const RationalPoint& p) { return {to_string(p[0]), to_string(p[1]), to_string(p[2])}; }

Json json_of(const CellState& s) {
  Json out{{"component", s.component}, {"name", s.name}, {"group", s.group}, {"entity", s.entity}};
  return out;
}

Json json_of(const OperandFacts& o, int dimension) {
  Json out{{"name", o.name}, {"closed_complement", o.closed_complement}, {"state", json_of(o.state)}};
  if (!o.state.entity) return out;
  if (dimension == 2) {
    out["sides"] = {json_of(o.sides[0]), json_of(o.sides[1])};
    out["regions"] = o.regions;
  } else {
    out["bounds"] = o.bounds;
    out["within"] = o.within;
    out["free"] = o.free;
    out["walls"] = o.walls;
    Json around = Json::array();
    for (const CellState& s : o.around) around.push_back(json_of(s));
    out["around"] = around;
  }
  return out;
}

Json json_of(const BooleanFacts& f) {
  Json out{{"operator", name(f.op)},         {"dominant", f.dominant},         {"dimension", f.dimension},
           {"a", json_of(f.a, f.dimension)}, {"b", json_of(f.b, f.dimension)}, {"result", json_of(f.result)}};
  if (f.rule == StepRule::blend) out["rule"] = "blend";
  if (f.rule == StepRule::materials) {
    out["rule"] = "materials";
    out["levels"] = {f.level_a, f.level_b};
  }
  if (!f.verdict.entity) return out;
  out["relation"] = name(f.verdict.relation);
  out["row"] = f.verdict.row->id;
  out["condition"] = condition_words(*f.verdict.row);
  out["asked"] = !f.verdict.bounds_kept;
  out["kept_around"] = f.kept_around;
  out["removed"] = f.verdict.removed;
  return out;
}

Json json_of(const StarFacts& s) {
  Json out;
  if (s.component != 0) out = {{"component", s.component}, {"name", s.name}};
  out["in_set"] = s.in_set;
  out["whole"] = s.whole;
  out["touched"] = s.touched;
  out["solid"] = s.solid;
  out["inside"] = s.inside;
  out["outside"] = s.outside;
  out["named_inside"] = s.named_inside;
  out["named_outside"] = s.named_outside;
  return out;
}

template <class List, class Make>
Json list_of(const List& list, Make make) {
  Json out = Json::array();
  for (const auto& item : list) out.push_back(make(item));
  return out;
}

class Teller {
 public:
  Teller(const Tree& tree, const Evaluation& evaluation) : tree_(tree), evaluation_(evaluation) {}

  Json of(const Explanation& e) const {
    Json out{{"node", e.node_name}, {"cell", e.cell == "-" ? Json() : Json(e.cell)}};
    out["dimension"] = e.asked ? e.classes.front().example.dimension : e.dimension;
    out["state"] = json_of(e.state);
    out["pieces"] = e.pieces;
    if (e.asked) out["point"] = json_of(*e.asked);
    out["lives"] = list_of(e.classes, [&](const LifeClass& c) { return of(c); });
    out["lives_left_out"] = e.classes_left_out;
    out["pieces_left_out"] = e.pieces_left_out;
    return out;
  }

 private:
  const Tree& tree_;
  const Evaluation& evaluation_;

  const std::string& leaf_name(LeafId leaf) const { return evaluation_.leaf_names[leaf.index()]; }

  Json of(const LeafCell& cell) const {
    Json out{{"leaf", leaf_name(cell.leaf)}, {"kind", kCellKinds[cell.dimension]}};
    if (cell.dimension != 0) out["number"] = cell.number;
    return out;
  }

  Json of(const LifeClass& c) const {
    Json out{{"pieces", c.pieces}, {"point", json_of(c.point)}};
    if (c.normal) {
      out["normal"] = list_of(*c.normal, [](const Integer& n) { return n.get_str(); });
    }
    out["origins"] = list_of(c.origins, [&](const LeafCell& cell) { return of(cell); });
    if (!c.mixture.empty()) {
      Json mixture = Json::object();
      for (const auto& [material, fraction] : c.mixture) mixture[material] = to_string(fraction);
      out["mixture"] = mixture;
    }
    const SurfaceParameters& parameters = *evaluation_.parameters;
    out["patches"] = list_of(c.patches, [&](const PatchPoint& p) {
      return Json{{"leaf", leaf_name(p.leaf)},
                  {"patch", parameters.patch_name(p.leaf, p.patch)},
                  {"u", to_string(p.at[0])},
                  {"v", to_string(p.at[1])}};
    });
    out["curves"] = list_of(c.curves, [&](const CurvePoint& p) {
      return Json{
          {"leaf", leaf_name(p.leaf)}, {"curve", parameters.curve_name(p.leaf, p.curve)}, {"t", to_string(p.at)}};
    });
    const int dimension = c.example.dimension;
    out["steps"] = list_of(c.life, [&](const LifeStep& step) { return of(step, dimension); });
    return out;
  }

  Json of(const LifeStep& step, int dimension) const {
    const Node& node = tree_.nodes[step.node];
    Json out{{"node", step.name}, {"operator", node.operator_name}, {"line", node.operator_at.line}};
    out["state"] = json_of(step.state);
    if (!step.said.empty()) {
      out["said"] = list_of(step.said, [](const Word& word) {
        return Json{{"key", word.key},
                    {"value", word.value},
                    {"given", word.given},
                    {"from", word.from},
                    {"gave_way", list_of(word.gave_way, [](const auto& other) {
                       return Json{{"name", other.first}, {"value", other.second}};
                     })}};
      });
    }
    if (step.operands.empty()) {
      out["leaf_cells"] = list_of(step.leaf_cells, [&](const LeafCell& cell) { return of(cell); });
      return out;
    }
    out["operands"] = list_of(step.operands, [&](const auto& operand) {
      return Json{{"name", operand.first}, {"state", json_of(operand.second)}};
    });
    if (!step.booleans.empty()) {
      out["booleans"] = list_of(step.booleans, [&](const BooleanFacts& f) { return json_of(f); });
    }
    if (!step.stars.empty()) out["stars"] = list_of(step.stars, [](const StarFacts& s) { return json_of(s); });
    if (step.regularized) out["regularized"] = json_of(*step.regularized, dimension);
    if (step.attribute) {
      Json attribute{{"before", json_of(step.attribute->before)}};
      if (step.attribute->group) attribute["group"] = json_of(*step.attribute->group, dimension);
      attribute["stars"] = list_of(step.attribute->stars, [](const StarFacts& s) { return json_of(s); });
      out["attribute"] = attribute;
    }
    return out;
  }
};

Story told(const Tree& tree, const Evaluation& evaluation, const Explanation& e) {
  const Json json = Teller(tree, evaluation).of(e);
  return {explanation_text(tree, evaluation, e), json.dump(-1, ' ', false, Json::error_handler_t::replace)};
}

}  // namespace

Story story(const Tree& tree, const Evaluation& evaluation, NodeId node, const std::string& cell) {
  return told(tree, evaluation, explain(tree, evaluation, node, cell));
}

Story story(const Tree& tree, const Evaluation& evaluation, NodeId node, const RationalPoint& point) {
  return told(tree, evaluation, explain(tree, evaluation, node, point));
}

}  // namespace cnrg
