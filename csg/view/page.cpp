// The data of all nodes, and the page that it makes with the template.
#include "csg/view/page.h"

#include <algorithm>
#include <numeric>

#include "csg/certify/certificate.h"
#include "csg/explain/fates.h"
#include "csg/operators/node_value.h"
#include "csg/result/palette.h"
#include "csg/result/result_data.h"
#include "csg/text/escape.h"
#include "csg/text/xml.h"
#include "csg/tree/dag.h"
#include "csg/view/node_data.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

using Json = nlohmann::ordered_json;

/// Coordinates rounded, for drawing; and exactly, of the points that no doubles are.
void add_points(const PageTables& tables, Json& out) {
  const PointTable& points = tables.complex.points;
  std::vector<double> rounded;
  Json exact = Json::array();
  for (std::size_t i = 0; i < tables.points.size(); ++i) {
    const VertexId v = tables.points[i];
    const RationalPoint p = points.rational(v);
    bool is_rounded = false;
    for (const Rational& x : p) {
      const double nearest = to_double(x);
      rounded.push_back(nearest);
      is_rounded = is_rounded || from_double(nearest) != x;
    }
    if (is_rounded) exact.push_back({i, to_string(p[0]), to_string(p[1]), to_string(p[2])});
  }
  out["points"] = packed(rounded);
  out["exact"] = exact;
}

/// Each origin as lists of the leaf, the dimension and the numbers of its cells: `[[0, 2, 4, 5]]`.
Json origins_of(const PageTables& tables) {
  std::vector<Json> out(tables.origins.size());
  for (const auto& [cells, number] : tables.origins) {
    Json lists = Json::array();
    for (const LeafCell& cell : cells) {
      if (lists.empty() || lists.back()[0] != cell.leaf.value() || lists.back()[1] != cell.dimension) {
        lists.push_back({cell.leaf.value(), cell.dimension});
      }
      lists.back().push_back(cell.number);
    }
    out[number] = std::move(lists);
  }
  return out;
}

/// The colors of origins, by number, in all nodes those of the result; of no origin at 0.
std::string source_colors(const Evaluation& evaluation, PageTables& tables) {
  const Result result = evaluation.result();
  std::vector<LeafInfo> infos = *result.data().view().leaves;
  std::uint32_t places = static_cast<std::uint32_t>(in_order_of_place(infos).size());
  for (LeafInfo& leaf : infos) {
    if (leaf.place == LeafInfo::kNoPlace) leaf.place = places++;
  }
  const LeafColors colors(infos);
  std::vector<std::uint32_t> out(tables.origins.size() + 1);
  const auto number = [&](const std::vector<LeafId>& leaves) {
    return number_in(tables.colors, hex(colors.of(leaves).color));
  };
  out[0] = number({});
  for (const auto& [cells, i] : tables.origins) {
    std::vector<LeafId> leaves;
    for (const LeafCell& cell : cells) leaves.push_back(cell.leaf);
    out[i + 1] = number(leaves);
  }
  return packed(out);
}

/// Places of which it is not proven that surfaces meet there as facets do, in words, each with the nodes that have
/// all leaves which meet there.
Json doubts_of(const Evaluation& evaluation, const std::vector<std::pair<InstanceId, const KeptValue*>>& nodes) {
  Json out = Json::array();
  const Certificate all = certificate_of(evaluation);
  for (const UncertainPlace& place : all.places) {
    Json of = Json::array();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (is_below(evaluation, *nodes[i].second, place)) of.push_back(i);
    }
    out.push_back({{"at", place.at}, {"text", shown(place.text())}, {"nodes", of}});
  }
  return out;
}

/// Colors that mean the same on all pages.
Json fixed_colors() {
  Json out{{"sheet", hex(sheet_color())},
           {"wire", hex(wire_color())},
           {"point", hex(point_color())},
           {"none", hex(no_color())}};
  for (std::size_t r = 0; r < kRelations; ++r) {
    const auto relation = static_cast<Relation>(r);
    out["relations"][name(relation)] = hex(relation_color(relation));
  }
  return out;
}

/// The instance of each kept value, by instance; the value of a node asked for is that of its last instance.
std::vector<std::pair<InstanceId, const KeptValue*>> shown_nodes(const Evaluation& evaluation) {
  std::map<InstanceId, const KeptValue*> found;
  for (const KeptValue& kept : evaluation.kept) {
    found.emplace(instance_of(evaluation, kept), &kept);
  }
  return {found.begin(), found.end()};
}

/// What is told of each node, within the limits: of the result first, then of nodes of few cells.
std::vector<Told> told_of(const Evaluation& evaluation,
                          const std::vector<std::pair<InstanceId, const KeptValue*>>& nodes, PageLimits left) {
  std::vector<PageCosts> costs;
  for (const auto& [id, kept] : nodes) costs.push_back(page_costs(evaluation, *kept, id));
  std::vector<std::size_t> order(nodes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const NodeId result = evaluation.kept.front().node;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const bool first = nodes[a].second->node == result, second = nodes[b].second->node == result;
    return first != second ? first : costs[a].stories < costs[b].stories;
  });
  const auto take = [](std::size_t cost, std::size_t& from) {
    if (cost > from) return false;
    from -= cost;
    return true;
  };
  std::vector<Told> out(nodes.size());
  for (const std::size_t i : order) {
    out[i] = {take(costs[i].stories, left.stories), take(costs[i].topology, left.topology),
              take(costs[i].classes, left.classes)};
  }
  return out;
}

/// How many instances each node has below another one's.
std::map<NodeId, std::size_t> instances_below(const Evaluation& evaluation, InstanceId root) {
  std::vector<char> below(evaluation.instances.size(), 0);
  below[root.index()] = 1;
  std::map<NodeId, std::size_t> out;
  for (std::size_t i = root.index() + 1; i-- > 0;) {
    if (!below[i]) continue;
    const Instance& instance = evaluation.instances[InstanceId(i)];
    ++out[instance.node];
    for (const InstanceId operand : instance.operands) below[operand.index()] = 1;
  }
  return out;
}

}  // namespace

std::string page_data(const Tree& tree, const Evaluation& evaluation, const PageLimits& limits) {
  PageTables tables(*evaluation.complex);
  Json out{{"format", "cnrg page"}, {"version", 1}, {"tree", shown(tree.file)}};
  const auto nodes = shown_nodes(evaluation);
  std::map<NodeId, std::size_t> place;
  for (const auto& [id, kept] : nodes) place.emplace(kept->node, place.size());
  Json list = Json::array();
  const std::vector<Told> told = told_of(evaluation, nodes, limits);
  const std::size_t of_result = place.at(evaluation.kept.front().node);
  std::map<NodeId, std::size_t> instances = instances_below(evaluation, nodes[of_result].first);
  // The result is told first: what others leave for it would depend on them.
  std::vector<std::size_t> order(nodes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto first = order.begin() + static_cast<std::ptrdiff_t>(of_result);
  std::rotate(order.begin(), first, first + 1);
  list.get_ref<Json::array_t&>().resize(nodes.size());
  std::size_t removed_left = limits.removed;
  for (const std::size_t i : order) {
    const auto& [id, kept] = nodes[i];
    Json node = node_data(tree, evaluation, *kept, id, told[i], removed_left, tables);
    Json operands = Json::array();
    for (const NodeId operand : tree.operands(kept->node)) {
      if (const auto at = place.find(operand); at != place.end()) operands.push_back(at->second);
    }
    node["operands"] = operands;
    node["instances"] = instances[kept->node];
    list[i] = std::move(node);
  }
  out["result"] = of_result;
  // True if some node is not below the result: then it is refined with others than alone.
  const std::vector<char> below = tree.dag->reachable({tree.result});
  out["several"] =
      std::any_of(nodes.begin(), nodes.end(), [&](const auto& n) { return !below[n.second->node.index()]; });
  const Result result = evaluation.result(evaluation.kept.front().node);
  switch (default_colors(result.data().view())) {
    case ColorBy::material: out["color_by"] = "material"; break;
    case ColorBy::region: out["color_by"] = "region"; break;
    default: out["color_by"] = "component";
  }
  out["doubts"] = doubts_of(evaluation, nodes);
  out["fixed_colors"] = fixed_colors();
  out["source_colors"] = source_colors(evaluation, tables);
  out["colors"] = in_order(tables.colors);
  Json leaves = Json::array();
  for (const std::string& leaf : evaluation.leaf_names) leaves.push_back(shown(leaf));
  out["leaves"] = leaves;
  add_points(tables, out);
  out["origins"] = origins_of(tables);
  out["words"] = in_order(tables.words);
  out["lines"] = in_order(tables.lines);
  out["nodes"] = std::move(list);
  return out.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string page_text(const std::string& page_template, const std::string& title, const std::string& data,
                      const std::string& stamp) {
  std::string out = page_template;
  const auto put = [&](const std::string& place, const std::string& text) {
    const std::size_t at = out.find(place);
    if (at == std::string::npos) throw InputError("the template of the page has no place `" + place + "`");
    out.replace(at, place.size(), text);
  };
  put("<!--cnrg:title-->", in_xml(title));
  put("<!--cnrg:stamp-->", in_xml(stamp));
  put("<!--cnrg:data-->", compressed(data));  // in base64, so that no text of a tree can end the element
  return out;
}

}  // namespace cnrg
