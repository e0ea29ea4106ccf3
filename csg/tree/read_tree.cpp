// The tree file's reader: names first, then nodes, then the graph.
//
// All names of `nodes` are known before the first node is read, so an operand resolves where it stands, forwards
// and backwards, and the position of a fault is that of the mention. Nodes that stand inline are read on the way
// and remembered by identity: a YAML alias of an inline node is the same node, however often it is repeated, and
// an alias that contains itself becomes a cycle of the graph, which is found there. yaml-cpp bounds how deep
// values nest, so the one recursion here (an inline node in an inline node) is bounded too; names may chain
// without limit.
#include <algorithm>
#include <array>
#include <filesystem>
#include <unordered_map>
#include <utility>

#include "csg/openscad/openscad_tree.h"
#include "csg/text/escape.h"
#include "csg/text/input_file.h"
#include "csg/text/table.h"
#include "csg/tree/check_tree.h"
#include "csg/tree/dag.h"
#include "csg/tree/operator_names.h"
#include "csg/tree/read_attribute.h"
#include "csg/tree/read_leaf.h"
#include "csg/tree/read_material.h"
#include "csg/tree/read_parameters.h"
#include "csg/tree/read_selector.h"
#include "csg/tree/selector.h"
#include "csg/tree/suggest.h"
#include "csg/tree/tree.h"
#include "csg/tree/tree_of_file.h"
#include "csg/tree/yaml_value.h"

namespace cnrg {
namespace {

template <class Range>
bool contains(const Range& range, std::string_view name) {
  return std::find(range.begin(), range.end(), name) != range.end();
}

class TreeReader {
 public:
  TreeReader(Document& document, Tree& tree, const ReadOptions& options)
      : document_(document), tree_(tree), options_(options) {
    if (!options.inside.empty()) context_.inside = folder_of_inputs(options.inside);
    context_.folder = std::filesystem::path(document.file).parent_path().string();
    context_.check_material = [this](const Value& value) { check_material(value); };
  }

  void read(const YAML::Node& root) {
    const Value top(document_, root, {});
    check_no_result(top);
    read_parameters(document_, top, options_);
    tree_.parameters = document_.parameters;
    Faults faults;
    read_parts(Fields(top, form("a tree file"), {}, &faults), faults);
    faults.raise();
    check_graph(tree_, dag_);
    check_selectors(tree_, dag_);
    check_distances(tree_);
    tree_.dag = std::make_shared<const Dag>(std::move(dag_));
  }

  /// As of `add_selection` (selector.h), on a tree that was read.
  NodeId add_selection(NodeId of, const YAML::Node& root) {
    const IdRange<NodeId> known(tree_.nodes.size());
    for (std::size_t i = 0; i < tree_.nodes.size(); ++i) dag_.add_node();
    for (const NodeId id : known) {
      for (const NodeId operand : tree_.operands(id)) dag_.add_operand(id, operand, tree_.nodes[id].at);
    }
    const Value criteria(document_, root, {1, 1});
    const NodeId id = add_node(tree_.nodes[of].name + "/select", true, criteria.at());
    Node& node = tree_.nodes[id];
    node.op = Operator::select;
    node.operator_name = "select";
    node.operator_at = criteria.at();
    read_selection(id, criteria, of);
    check_selectors(tree_, dag_);
    tree_.dag = std::make_shared<const Dag>(std::move(dag_));
    return id;
  }

 private:
  void read_parts(const Fields& fields, Faults& faults) {
    const auto part = [&](const char* key, auto read) {
      if (const Value* value = fields.find(key)) faults.attempt([&] { read(*value); });
    };
    part("cnrg", [](const Value& version) {
      if (version.number("`cnrg`") != 1)
        version.fail("this program reads version 1 of tree files; write `cnrg: 1`");
    });
    part("materials", [&](const Value& materials) { tree_.materials = read_materials(materials); });
    if (const Value::Entry* nodes = fields.entry("nodes")) tree_.nodes_at = nodes->key_at;
    part("nodes", [&](const Value& nodes) { read_nodes(nodes); });
    if (!tree_.names.empty()) part("result", [&](const Value& node) { tree_.result = named(node, "`result`"); });
    part("weld", [&](const Value& weld) {
      fields.read("weld", tree_.weld);
      check_weld(fields);
      tree_.weld_at = weld.at();
    });
    part("$schema", [&](const Value&) {
      std::string for_editors;
      fields.read("$schema", for_editors);
    });
  }

  /// An exact result is JSON, and so YAML.
  void check_no_result(const Value& top) const {
    if (!top.is_map()) return;
    const YAML::Node format = top.node()["format"];
    if (!format.IsDefined() || !format.IsScalar() || format.Scalar() != "cnrg result") return;
    const bool named = document_.file != kStandardInput;
    const std::string name = named ? std::filesystem::path(document_.file).filename().string() : "FILE.json";
    top.fail("this is a result, not a tree; to read it back, write a tree with the leaf `part: {cnrg: " + name +
             "}`");
  }

  void check_material(const Value& value) {
    std::vector<std::string_view> names;
    for (const Material& m : tree_.materials) {
      if (m.name == value.raw()) return;
      names.push_back(m.name);
    }
    const std::string hint = did_you_mean(value.raw(), names);
    value.fail("the material `" + value.raw() + "` is not declared" +
               (hint.empty() ? "; add `" + value.raw() + ": {}` to `materials`" : hint));
  }

  NodeId add_node(std::string name, bool is_inline, Position at) {
    const NodeId id = dag_.add_node();
    Node node;
    node.name = std::move(name);
    node.is_inline = is_inline;
    node.at = at;
    tree_.nodes.push_back(std::move(node));
    return id;
  }

  void read_nodes(const Value& value) {
    const std::vector<Value::Entry> entries = value.entries("`nodes`");
    if (entries.empty())
      value.fail("`nodes` is empty; add a node such as `a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}`");
    for (const Value::Entry& e : entries) {
      if (e.key.empty()) document_.fail(e.key_at, "a node needs a name");
      const NodeId id = add_node(e.key, false, e.key_at);
      tree_.names.emplace(e.key, id);
      remember(e.value, id);
    }
    Faults faults;
    for (std::size_t i = 0; i < entries.size(); ++i) {
      top_ = entries[i].key;
      faults.attempt([&] { read_node(NodeId(i), entries[i].value); });
    }
    top_.clear();
    faults.raise();
  }

  /// The node that a text names.
  NodeId named(const Value& value, const std::string& what) {
    const std::string name = value.text(what);
    const auto it = tree_.names.find(name);
    if (it != tree_.names.end()) return it->second;
    std::vector<std::string_view> names;
    for (const auto& [known, id] : tree_.names) {
      if (known != top_) names.push_back(known);  // it cannot use itself
    }
    const std::string hint = did_you_mean(name, names);
    value.fail("there is no node called `" + name + "`" +
               (hint.empty() ? "; add it to `nodes` or use another name" : hint));
  }

  /// Copy k of a node is turned k times, then moved k times.
  void read_steps(NodeId id, const Fields& f) {
    const Value& of = f.at("of");
    int copies = 0;
    f.read("count", copies);
    for (int copy = 0; copy < copies; ++copy) {
      const NodeId moved = add_node(tree_.nodes[id].name + "/" + std::to_string(copy + 1), true, of.at());
      dag_.add_operand(id, moved, of.at());
      tree_.nodes[moved].op = Operator::simplify;
      read_operand(moved, of, 1);
      for (const char* key : {"rotate", "translate"})
        if (copy > 0 && f.has(key)) move(tree_.nodes[moved], *f.entry(key), copy);
    }
  }

  /// With an index the node is read anew for each copy, and may name the number of that.
  void read_repeat(NodeId id, const Value& value) {
    const Fields f(value, form("repeat"));
    if (!f.has("index")) return read_steps(id, f);
    const Value& of = f.at("of");
    if (!of.is_map())
      of.fail_type(f.name("of"), "a node {...}, such as {simplify: NODE, translate: [\"${i}\", 0, 0]}");
    std::string name;
    int copies = 0;
    f.read("index", name, "count", copies);
    if (!is_parameter_name(name) || document_.parameters.contains(name))
      f.at("index").fail_type(f.name("index"), "a name of letters, digits and `_` that no parameter has");
    const CopyScope scope(*this, name);
    for (int copy = 0; copy < copies; ++copy) {
      const NodeId copied = add_node(tree_.nodes[id].name + "/" + std::to_string(copy + 1), true, of.at());
      dag_.add_operand(id, copied, of.at());
      document_.parameters[name] = Rational(copy);
      places_.back().clear();  // what is inline in another copy is another node
      read_node(copied, Value(document_, of.node(), of.at()));
    }
  }

  /// While copies of a `repeat` are read, and a fault in one of them is on its way.
  class CopyScope {
   public:
    CopyScope(TreeReader& reader, const std::string& index) : reader_(reader), index_(index) {
      reader.places_.emplace_back();
    }
    ~CopyScope() {
      reader_.places_.pop_back();
      reader_.document_.parameters.erase(index_);
    }
    CopyScope(const CopyScope&) = delete;
    CopyScope& operator=(const CopyScope&) = delete;

   private:
    TreeReader& reader_;
    const std::string& index_;
  };

  /// All nodes of a `.csg` file, called `NODE/NAME`, and its result as the only operand.
  void read_csg(NodeId id, const Value& value) {
    const std::string file = path_in_folder(value.text("`csg`, an OpenSCAD file,"), context_);
    if (!is_openscad_file(file)) value.fail_type("`csg`", "a file that ends as .csg");
    const Tree tree = parse_openscad(read_file(file, context_.inside, kMostTreeBytes), file, {options_.inside});
    tree_.warnings.insert(tree_.warnings.end(), tree.warnings.begin(), tree.warnings.end());
    tree_.inputs.push_back(file);
    tree_.inputs.insert(tree_.inputs.end(), tree.inputs.begin(), tree.inputs.end());
    const auto here = [first = tree_.nodes.size()](NodeId of) { return NodeId(first + of.index()); };
    for (const Node& node : tree.nodes) {
      Node& copy = tree_.nodes[add_node(tree_.nodes[id].name + "/" + node.name, true, value.at())];
      std::string name = std::move(copy.name);
      copy = node;
      copy.name = std::move(name);
      copy.is_inline = true;
      copy.at = copy.operator_at = value.at();
    }
    for (const NodeId of : IdRange<NodeId>(tree.nodes.size())) {
      for (const NodeId operand : tree.operands(of)) dag_.add_operand(here(of), here(operand), value.at());
    }
    dag_.add_operand(id, here(tree.result), value.at());
  }

  /// The operand of which the result is a part, or another form: written inline, it has no name but that of its
  /// user.
  static bool is_subject(Operator op, std::size_t number) {
    switch (op) {
      case Operator::unite:
      case Operator::intersect:
      case Operator::sum:
      case Operator::product:
      case Operator::aggregate: return false;
      case Operator::below:
      case Operator::above: return number == 2;
      default: return number == 1;
    }
  }

  /// An operand by name or inline.
  void read_operand(NodeId user, const Value& value, std::size_t number) {
    dag_.add_operand(user, operand(user, value, number), value.at());
  }
  NodeId operand(NodeId user, const Value& value, std::size_t number) {
    if (!value.is_map()) {
      if (!value.is_text())
        value.fail_type("an operand of `" + tree_.nodes[user].name + "`", "the name of a node or a node {...}");
      return named(value, "an operand");
    }
    if (const NodeId known = recall(value); known.valid()) return known;
    const NodeId id = add_node(tree_.nodes[user].name + "/" + std::to_string(number), true, value.at());
    if (is_subject(tree_.nodes[user].op, number)) tree_.nodes[id].called = tree_.nodes[user].regions_called();
    remember(value, id);
    read_node(id, value);
    return id;
  }

  /// `{within: SOLID, surfaces: [...]}`: a layer is below its surface in what the layers before it leave, the last
  /// one all that is left. Nodes are numbered as if all were operands: the solid, surfaces, then layers and rests.
  void read_layers(NodeId id, const Value& value) {
    const Fields f(value, form("layers"));
    const std::vector<Value> surfaces =
        f.at("surfaces").list(f.name("surfaces"), "a list of nodes [a, b], from the lowest up");
    if (surfaces.empty()) f.at("surfaces").fail_type(f.name("surfaces"), "a list of one node or more");
    const std::vector<Value> names = words_of_layers(f, "names", surfaces.size() + 1),
                             materials = words_of_layers(f, "materials", surfaces.size() + 1);
    for (const Value& material : materials) check_material(material);
    tree_.nodes[id].dominant = DominantOperand::left;
    std::size_t number = 0;
    NodeId rest = operand(id, f.at("within"), ++number);
    std::vector<NodeId> parting;
    for (const Value& surface : surfaces) parting.push_back(operand(id, surface, ++number));
    const auto add_part = [&](Operator op, const char* name, Position at) {
      const NodeId part = add_node(tree_.nodes[id].name + "/" + std::to_string(++number), true, at);
      Node& node = tree_.nodes[part];
      node.op = op;
      node.operator_name = name;
      node.operator_at = at;
      node.is_layer = true;
      return part;
    };
    for (std::size_t i = 0; i <= surfaces.size(); ++i) {
      const bool last = i == surfaces.size();
      const Position at = last ? f.at("within").at() : surfaces[i].at();
      const NodeId layer = add_part(last ? Operator::simplify : Operator::below, last ? "simplify" : "below", at);
      if (!names.empty()) tree_.nodes[layer].label = names[i].text(f.name("names"));
      if (!materials.empty()) tree_.nodes[layer].material = materials[i].raw();
      dag_.add_operand(id, layer, at);
      if (!last) dag_.add_operand(layer, parting[i], at);
      dag_.add_operand(layer, rest, at);
      if (last) return;
      const NodeId above = add_part(Operator::above, "above", at);
      dag_.add_operand(above, parting[i], at);
      dag_.add_operand(above, std::exchange(rest, above), at);
    }
  }

  static std::vector<Value> words_of_layers(const Fields& f, const char* key, std::size_t count) {
    const Value* const list = f.find(key);
    if (list == nullptr) return {};
    const std::vector<Value> words = list->list(f.name(key), "a list of texts");
    if (words.size() != count)
      list->fail_type(f.name(key), "a list of " + std::to_string(count) + ", one more than surfaces");
    return words;
  }

  // Nodes by the identity of their YAML node: equal nodes stand at one place.
  static std::size_t place_of(const Value& value) { return static_cast<std::size_t>(value.node().Mark().pos); }
  void remember(const Value& value, NodeId id) {
    places_.back().emplace(place_of(value), std::pair(value.node(), id));
  }
  NodeId recall(const Value& value) const {
    for (const auto& places : places_) {
      const auto [first, last] = places.equal_range(place_of(value));
      for (auto it = first; it != last; ++it) {
        if (it->second.first.is(value.node())) return it->second.second;
      }
    }
    return {};
  }

  /// True for `regularize: true` and for `simplify: points` beside another operator.
  static bool is_attribute(const Value::Entry& e, bool has_operator) {
    if (is_of_others(e.key)) return true;
    if (e.key == "regularize") return e.value.as_bool().has_value();
    if (e.key == "simplify")
      return has_operator && e.value.is_text() && (e.value.raw() == "points" || e.value.raw() == "features");
    return form("attribute").find(e.key) != nullptr;
  }

  /// `yes` is a text in YAML 1.2, and so the name of a node.
  void check_boolean(const Value::Entry& e) const {
    constexpr std::array<std::string_view, 6> kWords{"true", "yes", "on", "false", "no", "off"};
    if (e.key != "regularize" || !e.value.is_text() || e.value.as_bool() || tree_.names.count(e.value.raw()) != 0)
      return;
    std::string word = e.value.raw();
    for (char& c : word) c = char(std::tolower(static_cast<unsigned char>(c)));
    const auto at = std::find(kWords.begin(), kWords.end(), word);
    if (at == kWords.end()) return;
    e.value.fail_type("`regularize`", "true, false or the name of a node");
  }

  void read_node(NodeId id, const Value& value) {
    const std::string what = "the node `" + tree_.nodes[id].name + "`";
    if (!value.is_map()) value.fail_type(what, "a map {OPERATOR: ..., ATTRIBUTE: ...}");
    const std::vector<Value::Entry> entries = value.entries(what);
    Faults faults;
    for (const Value::Entry& e : entries) faults.attempt([&] { check_boolean(e); });
    const bool has_operator = std::any_of(entries.begin(), entries.end(), [](const Value::Entry& e) {
      return e.key != "simplify" && (contains(leaf_names(), e.key) || find_operator(e.key)) &&
             !is_attribute(e, false);
    });
    const Value::Entry* operation = nullptr;
    for (const Value::Entry& e : entries) {
      if (is_attribute(e, has_operator)) continue;
      faults.attempt([&] { check_operator_name(e, what); });
      if (operation && faults.empty()) {
        const bool first = find_operator(operation->key) != nullptr, second = find_operator(e.key) != nullptr;
        const char* const kinds = first && second ? " has two operators, `"
                                  : first         ? " has an operator and a leaf, `"
                                  : second        ? " has a leaf and an operator, `"
                                                  : " has two leaves, `";
        document_.fail(
            e.key_at, what + kinds + operation->key + "` and `" + e.key + "`; make one of them a node of its own");
      }
      operation = &e;
    }
    faults.raise();
    if (!operation) {
      document_.fail(tree_.nodes[id].at, what + " has no leaf and no operator; add one, such as `box` or `union`");
    }
    tree_.nodes[id].operator_at = operation->key_at;
    tree_.nodes[id].operator_name = operation->key;
    faults.attempt([&] { read_operation(id, *operation); });
    faults.attempt([&] { read_within(id, *operation, entries); });
    for (const Value::Entry& e : entries) {
      if (&e != operation && e.key != "within")
        faults.attempt([&] { read_attribute(tree_.nodes[id], e, context_); });
    }
    faults.raise();
    check_blend(tree_.nodes[id], entries);
  }

  /// The second operand of `below` and `above`.
  void read_within(NodeId id, const Value::Entry& operation, const std::vector<Value::Entry>& entries) {
    const Operator op = tree_.nodes[id].op;
    const bool wanted = op == Operator::below || op == Operator::above;
    const auto within =
        std::find_if(entries.begin(), entries.end(), [](const Value::Entry& e) { return e.key == "within"; });
    if (within != entries.end() && !wanted) {
      document_.fail(within->key_at, "`within` is for below and above; " +
                                         (op == Operator::simplify
                                              ? "to join what is near write {simplify: {of: NODE, within: 0.001}}"
                                              : "remove it from `" + operation.key + "`"));
    }
    if (!wanted) return;
    if (within == entries.end()) {
      document_.fail(operation.key_at, "`" + operation.key + "` needs the solid that it is in: {" + operation.key +
                                           ": SURFACE, within: SOLID}");
    }
    if (within->value.is_list()) within->value.fail_type("`within`", "one node, by name or {...}");
    read_operand(id, within->value, 2);
  }

  void check_operator_name(const Value::Entry& e, const std::string& what) {
    if (find_operator(e.key) || contains(leaf_names(), e.key)) return;
    if (e.key == "of") {
      document_.fail(e.key_at,
                     "`of` stands in the map of `select` or `simplify`; a node that is moved or gets "
                     "attributes is written {simplify: NODE, translate: [1, 0, 0]}");
    }
    if (form("criteria").find(e.key)) {
      document_.fail(e.key_at, "`" + e.key +
                                   "` is a criterion of `select`; write it in its map, {select: {of: NODE, " +
                                   e.key + ": ...}}");
    }
    std::vector<std::string_view> known(leaf_names().begin(), leaf_names().end());
    for (const OperatorName& o : kOperators) known.push_back(o.name);
    for (const Key& attribute : form("attribute").keys) known.push_back(attribute.name);
    const std::string hint = did_you_mean(e.key, known);
    document_.fail(e.key_at, "unknown key `" + e.key + "` in " + what + ": neither an operator nor an attribute" +
                                 (hint.empty() ? "; remove it or write the one that is meant" : hint));
  }

  void read_operation(NodeId id, const Value::Entry& e) {
    const OperatorName* known = find_operator(e.key);
    if (!known) {
      tree_.nodes[id].values = places_of_values(e.value);
      tree_.nodes[id].shape = read_leaf(e.key, e.value, context_);
      return;
    }
    tree_.nodes[id].op = known->op;
    if (known->name == "repeat") return read_repeat(id, e.value);
    if (known->name == "csg") return read_csg(id, e.value);
    if (known->name == "layers") return read_layers(id, e.value);
    if (takes_a_list(known->op)) {
      const std::vector<Value> operands = e.value.list("`" + e.key + "`", "a list of two or more nodes [a, b]");
      const std::size_t least = known->op == Operator::aggregate ? 1 : 2;
      if (operands.size() < least) e.value.fail_type("`" + e.key + "`", "a list of two or more nodes [a, b]");
      Faults faults;
      for (std::size_t i = 0; i < operands.size(); ++i)
        faults.attempt([&] { read_operand(id, operands[i], i + 1); });
      return faults.raise();
    }
    if (known->op == Operator::select) return read_selection(id, e.value);
    if (e.value.is_list()) e.value.fail_type("`" + e.key + "`", "one node, by name or {...}");
    if (known->op == Operator::simplify && e.value.is_map()) {
      const std::vector<Value::Entry> entries = e.value.entries("`simplify`");
      const auto is_option = [](const auto& o) { return o.key == "of" || o.key == "mode" || o.key == "within"; };
      // A node of a side has `within`, too.
      const auto is_side = [](const auto& o) { return o.key == "above" || o.key == "below"; };
      const bool is_node = std::any_of(entries.begin(), entries.end(), is_side);
      if (entries.empty() || (!is_node && std::any_of(entries.begin(), entries.end(), is_option))) {
        return read_simplify(id, Fields(e.value, form("simplify")));
      }
    }
    read_operand(id, e.value, 1);
  }

  void read_simplify(NodeId id, const Fields& f) {
    read_operand(id, f.at("of"), 1);
    std::string mode;
    std::optional<Rational> within;
    f.read("mode", mode, "within", within);
    if (within && *within <= 0) {
      f.at("within").fail(
          f.name("within") +
          " must be above 0: give the length below which what does not touch is joined, such as 0.001");
    }
    tree_.nodes[id].forget_features = mode == "points";
    tree_.nodes[id].within = within;
  }

  /// `{of: NODE, CRITERION: ..., ...}`; without `of` where that is given.
  void read_selection(NodeId id, const Value& value, NodeId of = {}) {
    if (!value.is_map()) {
      value.fail_type("`select`", of.valid() ? "a map of what is picked, such as {dimension: 2}"
                                             : "a map {of: NODE, ...} with what is picked, such as {of: model, "
                                               "dimension: 2}");
    }
    const Fields f(value, form(of.valid() ? "criteria" : "select"), "select");
    if (of.valid()) dag_.add_operand(id, of, value.at());
    else read_operand(id, f.at("of"), 1);
    auto selector = std::make_shared<Selector>();
    selector->file = document_.file;
    Criteria& criteria = selector->criteria = read_criteria(f);
    if (const Value* material = f.find("material")) {
      for (const Value& v : one_or_more(*material, f.name("material"))) {
        criteria.materials.push_back(v.text(f.name("material")));
        check_material(v);
      }
    }
    if (const Value* from = f.find("from")) {
      selector->from_at = from->at();
      for (const Value& v : one_or_more(*from, f.name("from"))) selector->from.push_back(named(v, f.name("from")));
    }
    for (const char* const key : {"front of", "behind"}) {
      const Value* const sides = f.find(key);
      if (sides == nullptr) continue;
      for (const Value& v : one_or_more(*sides, f.name(key))) {
        const NodeId node = named(v, f.name(key));
        selector->sides.push_back({node, tree_.nodes[node].name, key == std::string_view("front of"), v.at()});
      }
    }
    if (const Value::Entry* face = f.entry("source face"); face != nullptr && selector->from.size() != 1) {
      document_.fail(face->key_at,
                     "`source face` is a face of one leaf; name that: {from: LEAF, source face: 0, ...}");
    }
    std::size_t number = 1;
    const auto add_places = [&](const char* key) {
      if (const Value* places = f.find(key)) {
        for (const Value& v : one_or_more(*places, f.name(key))) read_operand(id, v, ++number);
      }
    };
    add_places("inside");
    selector->inside = number - 1;
    add_places("touching");
    tree_.nodes[id].selector = std::move(selector);
  }

  Document& document_;
  Tree& tree_;
  const ReadOptions& options_;
  Dag dag_;
  LeafContext context_;
  std::string top_;  ///< of `nodes`, what is being read, inline nodes in it included
  /// Of the file, and of each copy of `repeat` that is being read.
  std::vector<std::unordered_multimap<std::size_t, std::pair<YAML::Node, NodeId>>> places_{1};
};

}  // namespace

Tree parse_tree(const std::string& text, const std::string& file, const ReadOptions& options) {
  constexpr std::size_t kHonestAliases = 1'000'000;
  if (text.size() > kMostTreeBytes) {
    throw TreeError(file, {},
                    "this text has " + grouped(text.size()) + " bytes, and at most " + grouped(kMostTreeBytes) +
                        " are read" + kSmallerTree);
  }
  Document document{file, text.size() + kHonestAliases};
  Tree tree;
  tree.file = file;
  TreeReader(document, tree, options).read(load_yaml(document, text));
  return tree;
}

namespace {

YAML::Node load_criteria(const Document& document, const std::string& criteria) {
  try {
    return load_yaml(document, criteria);
  } catch (const TreeError&) {
    const std::size_t first = criteria.find_first_not_of(" \t\r\n");
    if (first == std::string::npos || criteria[first] == '{') throw;
    document.fail(
        {}, "criteria stand in braces, such as {dimension: 2, from: NODE}; write {" + excerpt(criteria) + "}");
  }
}

}  // namespace

NodeId add_selection(Tree& tree, NodeId of, const std::string& criteria, const std::string& file) {
  Document document{file, criteria.size() + 1'000'000, tree.parameters};
  const std::size_t before = tree.nodes.size();
  try {
    return TreeReader(document, tree, {}).add_selection(of, load_criteria(document, criteria));
  } catch (...) {
    tree.nodes.resize(before);
    throw;
  }
}

}  // namespace cnrg
