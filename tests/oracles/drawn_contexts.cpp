// Random cases of nodes in contexts, their text, and how a failing one is made smaller.
#include <algorithm>
#include <map>
#include <set>

#include "tests/oracles/contexts.h"
#include "tests/oracles/drawn_leaves.h"

namespace cnrg::properties {
namespace {

using scenes::Random;
using Names = std::vector<std::string>;

/// What a group Boolean makes of a value, as far as the operators alone tell (csg/SEMANTICS.md).
enum class Taken : std::uint8_t { group, complement, closed, open };

bool is_word(const std::string& op, const Names& words) {
  return std::find(words.begin(), words.end(), op) != words.end();
}
bool is_boolean(const std::string& op) {
  return is_word(op, {"union", "intersection", "difference", "below", "above"});
}

std::string comma_list(const Names& items) {
  std::string out;
  for (const std::string& item : items) out += (out.empty() ? "" : ", ") + item;
  return out;
}

/// Draws nodes one after the other over those that are there.
class Drawer {
 public:
  Drawer(Random& random, LeafKinds kinds, bool graded) : random_(random), kinds_(kinds), graded_(graded) {}

  std::vector<DrawnNode> nodes;

  std::string leaf(const std::pair<std::string, std::string>& words) {
    DrawnNode node{name("a"), words.first, words.second, {}, {}, false};
    if (random_.one_in(2)) node.keys.push_back(material());
    if (random_.one_in(5)) node.keys.push_back(label());
    if (random_.one_in(3)) node.keys.push_back("attributes: {k: " + std::to_string(random_.below(3)) + "}");
    if (random_.one_in(8)) node.keys.push_back("size: " + std::to_string(random_.between(1, 2)));
    if (random_.one_in(8)) node.keys.push_back("dominance: " + std::to_string(random_.between(-1, 2)));
    if (words.second.find("translate") == std::string::npos && random_.one_in(6)) add_transforms(node);
    return push(std::move(node), Taken::group);
  }
  std::string leaf() { return leaf(drawn_leaf(random_, kinds_)); }

  /// An operator over nodes that are there, the latest unused ones rather.
  std::string operation() {
    const int kind = random_.below(16);
    if (kind < 5) return many(word({"union", "union", "union", "intersection", "difference", "difference"}));
    if (kind < 7) return many(word({"sum", "product", "subtract"}));
    if (kind == 7) return aggregate();
    if (kind == 8) return layer();
    if (kind < 11) return select(pick());
    if (kind == 11 || (kind == 12 && random_.one_in(2))) return fold();
    return one(pick());
  }

  std::string one(const std::string& operand) {
    const std::string op =
        word({"unify", "complement", "interior", "closure", "boundary", "regularize", "simplify"});
    DrawnNode node{name("n"), op, "", {operand}, {}, false};
    if (op == "simplify") {
      const int kind = random_.below(3);
      if (kind == 1) node.value = "{of: @0, mode: points}";
      if (kind == 2) node.value = "{of: @0, within: 1/1000}";
    }
    if (is_word(op, {"interior", "closure", "boundary", "regularize"}) && random_.one_in(3))
      node.keys.push_back("each: true");
    return attributed(std::move(node));
  }

  std::string many(const std::string& op, Names operands = {}) {
    const std::size_t count = operands.size() + (random_.one_in(4) ? 2 : 1);
    while (operands.size() < std::max<std::size_t>(count, 2)) {
      const std::string operand = pick();
      operands.push_back(is_boolean(op) ? closed(operand) : operand);
      used_.insert(operand);
    }
    DrawnNode node{name("n"), op, "", operands, {}, false};
    if (op == "union" && random_.one_in(8)) node.keys.push_back("blend: linear");
    else if (!is_word(op, {"difference", "subtract"}) && random_.one_in(2))
      node.keys.push_back("dominance: " + word({"left", "right", "equal"}));
    return attributed(std::move(node));
  }

  std::string closed(const std::string& operand) {
    if (taken_.at(operand) != Taken::open) return operand;
    return push({name("n"), "closure", "", {operand}, {}, false}, Taken::closed);
  }

  /// Three nodes or more with one operator, each the first operand of the next.
  std::string fold(std::string last = {}) {
    const std::string op = word({"union", "difference", "intersection"});
    const std::string dominance = word({"", "left", "right", "equal"});
    if (last.empty()) last = closed(pick());
    for (int k = random_.between(3, 4); k > 0; --k) {
      DrawnNode node{name("n"), op, "", {last, leaf()}, {}, false};
      if (!dominance.empty() && op != "difference") node.keys.push_back("dominance: " + dominance);
      last = push(std::move(node), Taken::group);
    }
    return last;
  }

  std::string select(const std::string& operand) {
    DrawnNode node{name("n"), "select", "{of: @0", {operand}, {}, false};
    const auto with = [&](const std::string& key, const std::string& other) {
      node.value += ", " + key + ": @" + std::to_string(node.operands.size());
      node.operands.push_back(other);
    };
    if (random_.one_in(2)) node.value += ", dimension: " + word({"3", "2", "2", "1", "[2, 3]"});
    const std::string below = leaf_below(operand);
    switch (random_.below(11)) {
      case 0:
      case 1: node.value += ", region: " + word({"1", "2"}); break;
      case 9:
      case 10:
        if (const std::string surface = surface_below(operand); !surface.empty()) {
          with(word({"front of", "behind"}), surface);
          break;
        }
        [[fallthrough]];
      case 2: node.value += ", region: " + word({"upper", below}); break;
      case 3: node.value += ", material: " + word({"rock", "clay"}); break;
      case 4: with("from", below); break;
      case 5:
        with("from", below);
        node.value += ", source face: " + std::to_string(random_.below(3));
        break;
      case 6: node.value += ", between: " + word({"[rock, null]", "[rock, clay]", "[" + below + ", null]"}); break;
      case 7: with(word({"inside", "touching"}), pick()); break;
      default: node.value += ", attributes: {k: " + std::to_string(random_.below(3)) + "}";
    }
    node.value += "}";
    return attributed(std::move(node));
  }

  /// A node that is there; nobody else's operand rather, and rather a late one.
  std::string pick() {
    if (!random_.one_in(3))
      for (std::size_t i = nodes.size(); i-- > 0;)
        if (!nodes[i].in_place && !used_.contains(nodes[i].name) && !random_.one_in(3)) return nodes[i].name;
    for (;;) {
      const DrawnNode& node = nodes[static_cast<std::size_t>(random_.below(static_cast<int>(nodes.size())))];
      if (!node.in_place) return node.name;
    }
  }

  std::string push(DrawnNode node, Taken taken) {
    for (const std::string& operand : node.operands) used_.insert(operand);
    taken_[node.name] = taken;
    nodes.push_back(std::move(node));
    return nodes.back().name;
  }
  Taken taken(const std::string& node) const { return taken_.at(node); }
  std::string name(const char* kind) { return prefix + kind + std::to_string(number_++); }
  std::string word(const Names& words) {
    return words[static_cast<std::size_t>(random_.below(static_cast<int>(words.size())))];
  }

  std::string prefix;

 private:
  std::string material() {
    return "material: " + word(graded_ ? Names{"rock", "clay", "ore", "steel", "slope", "skin"}
                                       : Names{"rock", "clay", "ore", "steel"});
  }
  std::string label() { return "name: " + word({"body", "core", "the layer"}); }

  void add_transforms(DrawnNode& node) {
    const Names moves{"translate: [1, 0, 0]", "translate: [0, -1, 1/2]", "scale: 2", "scale: [1, 2, 1]"};
    const Names turns{"rotate: {axis: [0, 0, 1], degrees: 90, center: [1, 1, 1]}",
                      "rotate: {axis: [1, 1, 0], degrees: 37}", "mirror: {normal: [1, 0, 0], point: [1, 0, 0]}"};
    node.keys.push_back(word(moves));
    if (random_.one_in(2)) node.keys.insert(node.keys.end() - random_.below(2), word(turns));
  }

  std::string attributed(DrawnNode node) {
    if (random_.one_in(8)) node.keys.push_back(material());
    if (random_.one_in(10)) node.keys.push_back(label());
    if (random_.one_in(10)) node.keys.push_back("attributes: {k: 7}");
    if (random_.one_in(12)) node.keys.push_back("size: 1");
    const bool regularized = node.op != "regularize" && random_.one_in(15);
    if (regularized) node.keys.push_back("regularize: true");
    if (node.op != "simplify" && random_.one_in(12)) node.keys.push_back("simplify: points");
    const auto is_dominance = [](const std::string& k) {
      return k.starts_with("dominance") || k.starts_with("blend");
    };
    if (random_.one_in(12) && std::none_of(node.keys.begin(), node.keys.end(), is_dominance))
      node.keys.push_back("dominance: 1");
    const Taken taken = result_of(node, regularized);
    return push(std::move(node), taken);
  }

  Taken result_of(const DrawnNode& node, bool regularized) const {
    const auto has = [&](const char* key) {
      return std::find(node.keys.begin(), node.keys.end(), key) != node.keys.end();
    };
    const Taken first = taken_.at(node.operands[0]);
    const bool all_closed = std::all_of(node.operands.begin(), node.operands.end(), [&](const std::string& o) {
      return taken_.at(o) == Taken::group || taken_.at(o) == Taken::closed;
    });
    Taken out = Taken::open;
    if (is_boolean(node.op)) out = Taken::group;
    if (node.op == "simplify")
      out = first == Taken::complement && node.value.find("within") != std::string::npos ? Taken::open : first;
    if (node.op == "select" && first == Taken::group) out = first;
    if (is_word(node.op, {"closure", "regularize"}))
      out = first == Taken::group && !has("each: true") ? Taken::group : Taken::closed;
    if (node.op == "boundary") out = Taken::closed;
    if (is_word(node.op, {"aggregate", "unify", "sum", "product"}) && all_closed) out = Taken::closed;
    if (node.op == "complement" && first == Taken::group) out = Taken::complement;
    return regularized && out != Taken::group ? Taken::closed : out;
  }

  std::string aggregate() {
    const std::string x = pick(), y = pick();
    const auto node = [&](const char* op, const Names& operands) {
      return push({name("n"), op, "", operands, {}, false}, Taken::open);
    };
    switch (random_.below(3)) {
      case 0: {
        const std::string less = node("subtract", {x, y});
        return node("aggregate", {less, y});
      }
      case 1: {
        const std::string inner = node("interior", {x}), skin = node("boundary", {x});
        return node("aggregate", {inner, skin});
      }
      default: {
        const std::string rest = node("subtract", {x, y}), both = node("product", {y, x});
        return node("aggregate", {rest, both});
      }
    }
  }

  std::string layer() {
    const std::string horizon = leaf(drawn_horizon(random_));
    const std::string within = random_.one_in(2) ? leaf(drawn_box(random_)) : closed(pick());
    const std::string side = word({"below", "above"});
    return attributed({name("n"), side, "@0, within: @1", {horizon, within}, {}, false});
  }

  std::string leaf_below(std::string at) const {
    for (;;) {
      const DrawnNode& node = *named(at);
      if (node.operands.empty()) return at;
      const std::string& below = node.operands[static_cast<std::size_t>(random_.below(int(node.operands.size())))];
      if (named(below)->in_place) return at;
      at = below;
    }
  }

  /// Empty, if none is found.
  std::string surface_below(const std::string& at) const {
    for (int tries = 8; tries > 0; --tries)
      if (const std::string leaf = leaf_below(at); named(leaf)->op == "polygon") return leaf;
    return {};
  }

  std::vector<DrawnNode>::const_iterator named(const std::string& name) const {
    return std::find_if(nodes.begin(), nodes.end(), [&](const DrawnNode& n) { return n.name == name; });
  }

  Random& random_;
  LeafKinds kinds_;
  bool graded_;
  std::map<std::string, Taken> taken_;
  std::set<std::string> used_;
  int number_ = 0;
};

/// Only what the last node is made of.
void keep_reached(std::vector<DrawnNode>& nodes, const Names& roots) {
  std::set<std::string> reached(roots.begin(), roots.end());
  std::vector<DrawnNode> out;
  for (std::size_t i = nodes.size(); i-- > 0;) {
    if (!reached.contains(nodes[i].name)) continue;
    reached.insert(nodes[i].operands.begin(), nodes[i].operands.end());
    out.insert(out.begin(), nodes[i]);
  }
  nodes = std::move(out);
}

/// Some leaves with one user stand where they are used.
void put_in_place(Random& random, std::vector<DrawnNode>& nodes, const std::string& materials) {
  std::map<std::string, int> uses;
  std::set<std::string> mentioned;  // elsewhere than in a list of operands
  for (const DrawnNode& node : nodes)
    for (const std::string& operand : node.operands) {
      ++uses[operand];
      if (!node.value.empty()) mentioned.insert(operand);
    }
  for (DrawnNode& node : nodes) {
    const bool named = mentioned.contains(node.name) ||
                       materials.find(" " + node.name + ",") != std::string::npos ||
                       std::any_of(nodes.begin(), nodes.end(), [&](const DrawnNode& other) {
                         return !other.operands.empty() && other.value.find(node.name) != std::string::npos;
                       });
    if (node.operands.empty() && uses[node.name] == 1 && !named && random.one_in(5)) node.in_place = true;
  }
}

NodeContext drawn_context(Random& random, Drawer drawer, const std::vector<DrawnNode>& subtree, Setting setting) {
  NodeContext out;
  out.setting = setting;
  drawer.nodes = subtree;
  drawer.prefix = "c";
  const std::string node = subtree.back().name;
  Names parts;  // of the result
  const bool mixed = setting == Setting::mixed;
  const auto is = [&](Setting s) { return setting == s || (mixed && random.one_in(3)); };
  const auto copy_of = [&](const std::string& of) {
    const std::string move = drawer.word({"translate: [1, 0, 0]", "translate: [0, 1, 0]", "translate: [0, 0, -2]",
                                          "translate: [50, 0, 0]", "rotate: {axis: [0, 0, 1], degrees: 90}",
                                          "mirror: {normal: [1, 0, 0]}"});
    return drawer.push({drawer.name("m"), "simplify", "", {of}, {move}, false}, drawer.taken(of));
  };
  if (is(Setting::others)) {
    const bool far = random.one_in(4);
    for (int k = random.between(1, 3); k > 0; --k) {
      parts.push_back(drawer.leaf());
      if (far) drawer.nodes.back().keys = {"translate: [-40, 0, 0]"};
    }
  }
  if (is(Setting::twins)) {
    Names leaves;
    for (const DrawnNode& n : subtree)
      if (n.operands.empty()) leaves.push_back(n.name);
    const std::string of = drawer.word(leaves);
    DrawnNode twin =
        *std::find_if(subtree.begin(), subtree.end(), [&](const DrawnNode& n) { return n.name == of; });
    twin.name = drawer.name("t");
    twin.in_place = false;
    std::erase_if(twin.keys, [](const std::string& k) { return k.starts_with("translate"); });
    if (twin.value.find("translate") == std::string::npos && random.one_in(2))
      twin.keys.push_back("translate: " + drawer.word({"[1, 0, 0]", "[0, 1, 0]", "[0, 0, 1]"}));
    parts.push_back(drawer.push(std::move(twin), Taken::group));
  }
  if (is(Setting::shares)) {
    for (int k = random.between(1, 2); k > 0; --k) {
      drawer.leaf();
      parts.push_back(random.one_in(2) ? drawer.many("sum", {drawer.pick()}) : drawer.operation());
    }
  }
  if (is(Setting::copies)) {
    std::string of = node;
    if (random.one_in(3)) of = drawer.pick();
    parts.push_back(copy_of(of));
  }
  if (setting == Setting::chain) {
    parts.push_back(drawer.fold(drawer.closed(node)));
    out.kept = random.one_in(2);
    if (!out.kept) parts = {parts.back()};
  } else if (is(Setting::wrapped)) {
    std::string top = drawer.word({"sum", "product", "subtract"});
    drawer.leaf();
    top = drawer.many(top, {node});
    for (int k = random.between(1, 3); k > 0; --k) top = random.one_in(3) ? drawer.select(top) : drawer.one(top);
    parts.push_back(top);
    out.kept = !random.one_in(4);
  } else if (!parts.empty()) {
    if (!random.one_in(4)) parts.insert(random.one_in(2) ? parts.begin() : parts.end(), node);
  }
  if (parts.size() > 1) drawer.push({drawer.name("r"), "sum", "", parts, {}, false}, Taken::open);
  if (is(Setting::asked)) {
    for (const DrawnNode& n : subtree)
      if (!n.in_place && random.one_in(2)) out.asked.push_back(n.name);
    out.one_by_one = random.one_in(2);
  }
  if (is(Setting::apart)) out.refining = Refining::apart;
  if (is(Setting::threads)) out.threads = 2;
  if (is(Setting::order) || random.one_in(3)) out.order = random.next() | 1;
  if (setting == Setting::read_back) {  // beside a box its cells are cut
    out.raw = random.one_in(3);
    if (!out.raw && random.one_in(2))
      drawer.push({drawer.name("b"), "box", drawn_box(random).second, {}, {}, false}, Taken::group);
  }
  out.nodes.assign(drawer.nodes.begin() + std::ptrdiff_t(subtree.size()), drawer.nodes.end());
  if (!out.nodes.empty()) keep_reached(out.nodes, {out.nodes.back().name});
  return out;
}

// --- text

/// The keys of a node, shuffled but for the order of transforms, which means something.
Names keys_of(const DrawnNode& node, const std::string& first, Random* random) {
  Names transforms, others{first};
  for (const std::string& key : node.keys) {
    const bool moves = is_word(key.substr(0, key.find(':')), {"translate", "rotate", "scale", "mirror"});
    (moves ? transforms : others).push_back(key);
  }
  Names out;
  std::size_t t = 0;
  while (!others.empty() || t < transforms.size()) {
    const std::size_t left = others.size() + transforms.size() - t;
    const std::size_t at = random ? static_cast<std::size_t>(random->below(static_cast<int>(left))) : 0;
    if (at < others.size()) {
      out.push_back(others[at]);
      others.erase(others.begin() + std::ptrdiff_t(at));
    } else {
      out.push_back(transforms[t++]);
    }
  }
  return out;
}

std::string body(const DrawnNode& node, const std::vector<DrawnNode>& all, Random* random) {
  Names operands;
  for (const std::string& operand : node.operands) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const DrawnNode& n) { return n.name == operand; });
    operands.push_back(found != all.end() && found->in_place ? body(*found, all, random) : operand);
  }
  std::string value = node.value;
  if (value.empty()) {
    const bool list = is_boolean(node.op) || is_word(node.op, {"sum", "product", "subtract", "aggregate"});
    value = list ? "[" + comma_list(operands) + "]" : operands[0];
  } else {
    for (std::size_t i = 0; i < operands.size(); ++i) {
      const std::string mark = "@" + std::to_string(i);
      if (const std::size_t at = value.find(mark); at != std::string::npos)
        value.replace(at, mark.size(), operands[i]);
    }
  }
  return "{" + comma_list(keys_of(node, node.op + ": " + value, random)) + "}";
}

std::string tree_text(const std::vector<std::string>& materials, const std::vector<DrawnNode>& nodes,
                      std::uint64_t order) {
  Random random(order);
  std::vector<const DrawnNode*> lines;
  for (const DrawnNode& node : nodes)
    if (!node.in_place) lines.push_back(&node);
  for (std::size_t i = lines.size(); order != 0 && i > 1; --i)
    std::swap(lines[i - 1], lines[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
  std::string out = "cnrg: 1\nmaterials: {" + comma_list(materials) + "}\nnodes:\n";
  for (const DrawnNode* line : lines)
    out += "  " + line->name + ": " + body(*line, nodes, order == 0 ? nullptr : &random) + "\n";
  return out + "result: " + nodes.back().name + "\n";
}

// --- less

/// Without node `i`: its users take one of its operands in place of it, or do without.
bool taken_out(std::vector<DrawnNode>& nodes, std::size_t i, const std::string& instead) {
  const std::string gone = nodes[i].name;
  nodes.erase(nodes.begin() + std::ptrdiff_t(i));
  for (DrawnNode& user : nodes) {
    if (!instead.empty()) {
      std::replace(user.operands.begin(), user.operands.end(), gone, instead);
    } else if (std::find(user.operands.begin(), user.operands.end(), gone) != user.operands.end()) {
      if (!user.value.empty()) return false;
      std::erase(user.operands, gone);
      if (user.operands.empty()) return false;
    }
  }
  return true;
}

class Smaller {
 public:
  explicit Smaller(const ContextCase& drawn) : drawn_(drawn) {}

  std::vector<ContextCase> all() {
    if (drawn_.contexts.size() > 1)
      for (const NodeContext& context : drawn_.contexts) offer([&](ContextCase& c) { c.contexts = {context}; });
    if (drawn_.contexts.size() != 1) return std::move(out_);
    of_context();
    of_subtree();
    return std::move(out_);
  }

 private:
  template <class Change>
  void offer(const Change& change) {
    ContextCase less = drawn_;
    change(less);
    if (less.subtree.empty()) return;
    NodeContext& context = less.contexts[0];
    Names roots = context.asked;
    roots.push_back(less.subtree.back().name);
    keep_reached(less.subtree, roots);
    std::set<std::string> there;
    for (const auto* list : {&less.subtree, &context.nodes})
      for (const DrawnNode& node : *list) there.insert(node.name);
    std::erase_if(context.asked, [&](const std::string& n) { return !there.contains(n); });
    for (const DrawnNode& node : context.nodes)
      for (const std::string& operand : node.operands)
        if (!there.contains(operand)) return;
    if (!context.nodes.empty()) keep_reached(context.nodes, {context.nodes.back().name});
    out_.push_back(std::move(less));
  }

  void of_context() {
    const NodeContext& context = drawn_.contexts[0];
    if (!context.nodes.empty()) offer([](ContextCase& c) { c.contexts[0].nodes.clear(); });
    if (context.order != 0) offer([](ContextCase& c) { c.contexts[0].order = 0; });
    if (!context.asked.empty()) offer([](ContextCase& c) { c.contexts[0].asked.clear(); });
    if (context.refining != Refining::chosen)
      offer([](ContextCase& c) { c.contexts[0].refining = Refining::chosen; });
    if (context.threads != 1) offer([](ContextCase& c) { c.contexts[0].threads = 1; });
    if (context.one_by_one) offer([](ContextCase& c) { c.contexts[0].one_by_one = false; });
    of_nodes([](ContextCase& c) -> std::vector<DrawnNode>& { return c.contexts[0].nodes; });
  }

  void of_subtree() {
    const std::vector<DrawnNode>& nodes = drawn_.subtree;
    for (const std::string& operand : nodes.back().operands)  // an inner node is the one in question
      offer([&](ContextCase& c) {
        taken_out(c.subtree, nodes.size() - 1, operand), rename(c, nodes.back().name, operand);
      });
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (nodes[i].in_place) offer([&](ContextCase& c) { c.subtree[i].in_place = false; });
    of_nodes([](ContextCase& c) -> std::vector<DrawnNode>& { return c.subtree; });
  }

  static void rename(ContextCase& c, const std::string& from, const std::string& to) {
    for (DrawnNode& node : c.contexts[0].nodes) std::replace(node.operands.begin(), node.operands.end(), from, to);
    const auto at = std::find_if(c.subtree.begin(), c.subtree.end(), [&](const auto& n) { return n.name == to; });
    std::rotate(at, at + 1, c.subtree.end());
    c.subtree.back().in_place = false;
  }

  template <class NodesOf>
  void of_nodes(const NodesOf& nodes_of) {
    ContextCase here = drawn_;
    const std::vector<DrawnNode> nodes = nodes_of(here);
    for (std::size_t i = nodes.size(); i-- > 0;) {
      const DrawnNode& node = nodes[i];
      Names instead = node.operands;
      instead.push_back("");
      for (const std::string& other : instead) {
        ContextCase less = drawn_;
        if (i + 1 == nodes.size() && (other.empty() || &nodes_of(less) == &less.subtree)) continue;
        if (!taken_out(nodes_of(less), i, other)) continue;
        if (&nodes_of(less) == &less.subtree && !other.empty())
          for (DrawnNode& n : less.contexts[0].nodes)
            std::replace(n.operands.begin(), n.operands.end(), node.name, other);
        offer([&](ContextCase& c) { c = less; });
      }
      for (std::size_t k = 0; k < node.operands.size() && node.operands.size() > 1 && node.value.empty(); ++k)
        offer([&](ContextCase& c) {
          Names& operands = nodes_of(c)[i].operands;
          operands.erase(operands.begin() + std::ptrdiff_t(k));
        });
      for (std::size_t k = 0; k < node.keys.size(); ++k)
        offer([&](ContextCase& c) {
          Names& keys = nodes_of(c)[i].keys;
          keys.erase(keys.begin() + std::ptrdiff_t(k));
        });
    }
  }

  const ContextCase& drawn_;
  std::vector<ContextCase> out_;
};

}  // namespace

ContextCase random_context_case(std::uint64_t seed) {
  Random random(seed * 29 + 11);
  const LeafKinds kinds{random.one_in(4), random.one_in(8)};
  const bool graded = random.one_in(8);
  ContextCase out;
  Drawer drawer(random, kinds, graded);
  for (int k = random.between(2, 4); k > 0; --k) drawer.leaf();
  for (int k = random.between(1, 5); k > 0; --k) drawer.operation();
  std::vector<DrawnNode> nodes = drawer.nodes;
  keep_reached(nodes, {nodes.back().name});
  out.materials = {"rock: {color: \"#998877\"}", "clay: {}", "ore: {}", "steel: {dominance: 1}"};
  if (graded) {
    out.materials.push_back("slope: {linear: {from: [0, 0, 0], to: [0, 1, 3], stops: [[0, rock], [1, ore]]}}");
    out.materials.push_back("skin: {distance: {to: " + nodes.front().name + ", stops: [[0, ore], [2, rock]]}}");
  }
  put_in_place(random, nodes, comma_list(out.materials));
  out.subtree = nodes;
  const char* const formats[] = {".off", ".obj", ".vtu", ".msh", ".ply", ".stl", ".inp", ".glb"};
  out.format = formats[random.below(8)];
  for (int k = 0; k < 3; ++k)
    out.contexts.push_back(
        drawn_context(random, drawer, nodes, static_cast<Setting>(random.below(int(kSettings.size())))));
  return out;
}

std::string text_alone(const ContextCase& drawn) { return tree_text(drawn.materials, drawn.subtree, 0); }

std::string text_in(const ContextCase& drawn, const NodeContext& context) {
  std::vector<DrawnNode> nodes = drawn.subtree;
  nodes.insert(nodes.end(), context.nodes.begin(), context.nodes.end());
  return tree_text(drawn.materials, nodes, context.order);
}

std::vector<ContextCase> smaller(const ContextCase& drawn) { return Smaller(drawn).all(); }

}  // namespace cnrg::properties
