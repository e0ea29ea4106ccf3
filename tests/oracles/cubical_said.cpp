#include "tests/oracles/cubical_said.h"

#include <algorithm>
#include <map>

namespace cubical {
namespace {

using cnrg::DominantOperand;
using cnrg::Operator;
using cnrg::properties::DagNode;
using cnrg::properties::is_group_boolean;
using cnrg::properties::RandomDag;

/// What `kept` does not say is taken from `other`; what both say differently is noted.
void take(Attributes& kept, const Attributes& other, std::set<Warning>* warnings) {
  if (kept.name.empty()) kept.name = other.name;
  if (kept.material.empty()) kept.material = other.material;
  else if (!other.material.empty() && kept.material.name() != other.material.name() && warnings != nullptr)
    warnings->insert({"", kept.material.name(), other.material.name()});
  for (const auto& [key, value] : other.properties) {
    const auto [it, fresh] = kept.properties.emplace(key, value);
    if (!fresh && it->second != value && warnings != nullptr)
      warnings->insert({key, cnrg::to_text(it->second), cnrg::to_text(value)});
  }
}

class Sayings {
 public:
  Sayings(const Grid& grid, const RandomDag& dag, const std::vector<Value>& values)
      : grid_(grid), dag_(dag), values_(values) {}

  std::vector<Saying> run() {
    for (std::size_t i = 0; i < dag_.nodes.size(); ++i) {
      Saying s = of_node(i);
      s.owners = values_[i].is_group ? owners_in_group(values_[i], s) : owners(i);
      out_.push_back(std::move(s));
    }
    return out_;
  }

 private:
  static bool is_region(const Group& g, Cell c) { return g.region[static_cast<std::size_t>(c)] > 0; }
  bool is_active(const Value& v, Cell c) const { return v.labels[static_cast<std::size_t>(c)] != 0; }

  /// Adds a sheet, wire or point to all cells in the closure of a cell. The thing of lower dimension counts.
  void put(Said& said, Cell c, const Thing& thing) const {
    auto& at = said[static_cast<std::size_t>(c)];
    if (!at || at->dimension > thing.dimension) at = thing;
    for (const Cell b : grid_.boundary(c)) put(said, b, thing);
  }

  /// What was the border of a sheet and is all that is left is a wire now.
  static void lower(std::optional<Thing>& at, const std::optional<Thing>& fresh) {
    if (!fresh) return;
    if (!at) at = fresh;
    at->dimension = std::min(at->dimension, fresh->dimension);
  }

  /// Sheets, wires and points of a group.
  void put_all(const Group& g, Said& said) const {
    Said fresh(said.size());
    for (Cell c = 0; c < grid_.cells(); ++c) {
      if (grid_.dimension(c) == 3 || !g.entity[c]) continue;
      const auto& up = grid_.around(c);
      if (grid_.dimension(c) == 2 ? g.region[up[0]] == g.region[up.back()]
                                  : std::none_of(up.begin(), up.end(), [&](Cell d) { return g.entity[d] != 0; }))
        put(fresh, c, {{}, grid_.dimension(c)});
    }
    put_closures(said, fresh);
    for (std::size_t i = 0; i < said.size(); ++i) lower(said[i], fresh[i]);
  }

  /// What lies in the closure of a sheet is the sheet's, though the sheet lost it once and it came back.
  void put_closures(const Said& said, Said& fresh) const {
    for (Cell c = 0; c < grid_.cells(); ++c)
      if (grid_.dimension(c) == 2 && said[static_cast<std::size_t>(c)]) put(fresh, c, {{}, 2});
  }

  /// How many of the 3-cells around a cell are of its own component, and how many there are.
  std::pair<std::size_t, std::size_t> own_around(const Value& v, Cell c) const {
    const auto label = [&](Cell d) { return v.labels[static_cast<std::size_t>(d)]; };
    const auto& cubes = grid_.cubes(c);
    const auto own = std::count_if(cubes.begin(), cubes.end(), [&](Cell d) { return label(d) == label(c); });
    return {static_cast<std::size_t>(own), cubes.size()};
  }

  /// A face with one component, or none, on both sides and of another one itself; an edge or a vertex that bounds
  /// no other such cell and no wall. Next to its own component a cell is inside of it, or where it ends.
  bool stands_for_itself(const Value& v, Cell c) const {
    if (!is_active(v, c) || own_around(v, c).first != 0) return false;
    const auto& cubes = grid_.cubes(c);
    if (grid_.dimension(c) == 2) {
      return v.labels[static_cast<std::size_t>(cubes[0])] == v.labels[static_cast<std::size_t>(cubes[1])];
    }
    std::vector<Cell> up = grid_.around(c);
    for (int d = grid_.dimension(c) + 1; d < 3; ++d) {
      std::vector<Cell> higher;
      for (const Cell y : up) {
        const auto [own, all] = own_around(v, y);
        if (is_active(v, y) && (d == 2 ? own < all : own == 0)) return false;
        higher.insert(higher.end(), grid_.around(y).begin(), grid_.around(y).end());
      }
      up = std::move(higher);
    }
    return true;
  }

  /// The same of a value of either kind.
  void put_all(const Value& v, Said& said) const {
    if (v.is_group) {
      put_all(v.group, said);
      return;
    }
    Said fresh(said.size());
    for (Cell c = 0; c < grid_.cells(); ++c) {
      if (grid_.dimension(c) == 3 || !is_active(v, c)) continue;
      if (stands_for_itself(v, c)) put(fresh, c, {{}, grid_.dimension(c)});
    }
    put_closures(said, fresh);
    for (std::size_t i = 0; i < said.size(); ++i)
      if (is_active(v, static_cast<Cell>(i))) lower(said[i], fresh[i]);
  }

  /// What operand `k` of a node says, as a group.
  Saying as_group(std::size_t node, const Group& g) const {
    const Value& v = values_[node];
    Saying s = out_[node];
    if (v.complement) s.said = s.stands_for;
    for (Cell c = 0; c < grid_.cells(); ++c)
      if (grid_.dimension(c) == 3 || !g.entity[c]) s.said[static_cast<std::size_t>(c)].reset();
    if (!v.is_group) s.regions.assign(static_cast<std::size_t>(g.region_count), std::nullopt);
    return s;
  }

  /// Of a cell that two operands have.
  std::optional<Thing> merged(const std::optional<Thing>& left, const std::optional<Thing>& right,
                              DominantOperand dominant, Cell c, std::set<Warning>* warnings) const {
    if (!left || !right) return left ? left : right;
    if (!left->known || !right->known) return left->known ? right : left;
    if (left->dimension != right->dimension) return left->dimension < right->dimension ? left : right;
    if (dominant != DominantOperand::equal) return dominant == DominantOperand::left ? left : right;
    Thing out = *left;
    take(out.attributes, right->attributes, left->dimension == grid_.dimension(c) ? warnings : nullptr);
    return out;
  }

  Saying step(const Saying& a, const Group& ga, const Saying& b, const Group& gb, const Step& how,
              const Group& last) const {
    Saying out;
    out.warnings = a.warnings;
    out.warnings_known = a.warnings_known;
    out.said.resize(a.said.size());
    for (Cell c = 0; c < grid_.cells(); ++c) {
      const auto i = static_cast<std::size_t>(c);
      if (grid_.dimension(c) == 3 || !how.result.entity[i]) continue;
      const bool in_a = ga.entity[i] != 0, in_b = gb.entity[i] != 0;
      if (in_a && in_b && how.op != Op::subtract)
        // Cells that go in a later step are not told.
        out.said[i] = merged(a.said[i], b.said[i], how.dominant, c, last.entity[i] != 0 ? &out.warnings : nullptr);
      else out.said[i] = in_a ? a.said[i] : b.said[i];
    }
    out.regions.resize(static_cast<std::size_t>(how.result.region_count));
    for (int r = 1; r <= how.result.region_count; ++r)
      out.regions[static_cast<std::size_t>(r - 1)] = region(a, ga, b, gb, how, r, out);
    return out;
  }

  std::optional<Attributes> region(const Saying& a, const Group& ga, const Saying& b, const Group& gb,
                                   const Step& how, int r, Saying& out) const {
    std::set<int> of_a, of_b;
    for (Cell c = 0; c < grid_.cells(); ++c) {
      if (grid_.dimension(c) != 3 || how.result.region[static_cast<std::size_t>(c)] != r) continue;
      if (is_region(ga, c)) of_a.insert(ga.region[static_cast<std::size_t>(c)]);
      if (is_region(gb, c) && how.op != Op::subtract) of_b.insert(gb.region[static_cast<std::size_t>(c)]);
    }
    // One of several regions of one operand counts; the page does not say which.
    const auto one = [&](const std::set<int>& numbers, const Saying& s) -> std::optional<Attributes> {
      std::optional<Attributes> first;
      for (const int k : numbers) {
        const auto& next = s.regions[static_cast<std::size_t>(k - 1)];
        if (!next || (first && !(*first == *next))) return std::nullopt;
        first = next;
      }
      return first;
    };
    const auto left = one(of_a, a), right = one(of_b, b);
    if (how.dominant == DominantOperand::left && !of_a.empty()) return left;
    if (how.op == Op::subtract) return left;
    if (how.dominant == DominantOperand::right && !of_b.empty()) return right;
    if (of_a.empty()) return right;
    if (of_b.empty()) return left;
    if (!left || !right) {
      out.warnings_known = false;
      return std::nullopt;
    }
    Attributes both = *left;
    take(both, *right, &out.warnings);
    return both;
  }

  Saying of_node(std::size_t i) {
    const DagNode& node = dag_.nodes[i];
    const Value& value = values_[i];
    Saying s;
    s.said.resize(static_cast<std::size_t>(grid_.cells()));
    if (node.op == Operator::leaf) {
      s.regions.resize(static_cast<std::size_t>(value.group.region_count));
      put_all(value.group, s.said);
      for (auto& at : s.said)
        if (at) say(at->attributes, node.said);
      for (std::size_t r = 0; r < s.regions.size(); ++r) {
        // For what has none of its own; names of several regions are numbered.
        s.regions[r] = node.said;
        auto& name = s.regions[r]->name;
        const std::uint32_t ordinal = s.regions.size() > 1 ? static_cast<std::uint32_t>(r + 1) : 0;
        name = name.empty() ? one_part(cnrg::properties::name_of(dag_, i), NameOrigin::node, ordinal)
                            : one_part(name.text(), NameOrigin::given, ordinal);
        const auto own = node.parts.find(static_cast<std::uint32_t>(r + 1));
        if (own != node.parts.end()) say(*s.regions[r], own->second);
      }
      return s;
    }
    if (is_group_boolean(node.op)) {
      Saying a = as_group(node.operands[0], value.operands[0]);
      a.warnings.clear();
      a.warnings_known = true;
      for (std::size_t k = 0; k < value.steps.size(); ++k) {
        const Group& ga = k == 0 ? value.operands[0] : value.steps[k - 1].result;
        const Saying b = as_group(node.operands[k + 1], value.operands[k + 1]);
        a = step(a, ga, b, value.operands[k + 1], value.steps[k], value.steps.back().result);
      }
      // Equal values of operands of a fold may be met in other steps than these.
      if (value.steps.size() > 1) a.warnings_known = false;
      s = std::move(a);
      if (node.regularize) s = kept(s, value);
    } else {
      s = of_components(node, value);
    }
    if (!node.said.empty()) {
      put_all(value, s.said);
      if (value.complement) {
        for (Cell c = 0; c < grid_.cells(); ++c)
          if (grid_.dimension(c) == 3 || !value.group.entity[c]) s.stands_for[static_cast<std::size_t>(c)].reset();
        put_all(value.group, s.stands_for);
        for (auto& at : s.stands_for)
          if (at) say(at->attributes, node.said);
      }
      for (auto& at : s.said)
        if (at) say(at->attributes, node.said);
      for (auto& region : s.regions)
        if (region) say(*region, node.said);
    }
    return s;
  }

  /// What a value keeps of what is said: that of its active cells. Regions of a group that it has as they were.
  Saying kept(Saying s, const Value& value) const {
    for (Cell c = 0; c < grid_.cells(); ++c) {
      const auto i = static_cast<std::size_t>(c);
      if (grid_.dimension(c) == 3 || !(value.is_group ? value.group.entity[i] != 0 : is_active(value, c)))
        s.said[i].reset();
    }
    s.regions.assign(value.is_group ? static_cast<std::size_t>(value.group.region_count) : 0, std::nullopt);
    s.warnings_known = false;
    return s;
  }

  /// Where `closure` and its like add cells to what was a sheet or wire, these are in the closure of it; of which,
  /// where there are several, the page does not say.
  void add_closure(const Value& value, const DagNode& node, Said& said) const {
    const Said before = said;
    const auto fresh = [&](Cell c) {
      const auto i = static_cast<std::size_t>(c);
      if (!value.first_labels.empty() && value.first_labels[i] == 0) return true;
      return std::none_of(node.operands.begin(), node.operands.end(),
                          [&](std::size_t k) { return values_[k].labels[i] != 0; });
    };
    const auto visit = [&](const auto& self, Cell above, Cell c) -> void {
      for (const Cell b : grid_.boundary(c)) {
        const auto i = static_cast<std::size_t>(b);
        if (is_active(value, b) && fresh(b)) said[i] = Thing{{}, grid_.dimension(above), false};
        self(self, above, b);
      }
    };
    for (Cell c = 0; c < grid_.cells(); ++c)
      if (grid_.dimension(c) < 3 && before[static_cast<std::size_t>(c)]) visit(visit, c, c);
  }

  Saying of_components(const DagNode& node, const Value& value) const {
    const bool dominant_given = node.dominant && *node.dominant != DominantOperand::equal;
    Saying s = out_[node.operands[0]];
    const std::size_t count = node.op == Operator::cnrg_subtract ? 1 : node.operands.size();
    for (std::size_t k = 1; k < count; ++k) {
      const Saying& b = out_[node.operands[k]];
      for (Cell c = 0; c < grid_.cells(); ++c) {
        const auto i = static_cast<std::size_t>(c);
        s.said[i] =
            merged(s.said[i], b.said[i], dominant_given ? *node.dominant : DominantOperand::equal, c, nullptr);
      }
    }
    // What an operator takes off and `regularize` puts back has lost what was said of it.
    for (std::size_t i = 0; i < value.first_labels.size(); ++i)
      if (value.first_labels[i] == 0) s.said[i].reset();
    add_closure(value, node, s.said);
    // `simplify` hands on what a complement stands for.
    if (value.complement)
      s.stands_for =
          node.op == Operator::complement ? out_[node.operands[0]].said : out_[node.operands[0]].stands_for;
    const bool same = value.is_group && node.op == Operator::simplify && !node.regularize;
    const auto regions = s.regions;
    s = kept(std::move(s), value);
    if (same) s.regions = regions;
    return s;
  }

  // What is said of the component of each cell.

  using Owners = std::vector<std::optional<Attributes>>;

  static Owners owners_in_group(const Value& v, const Saying& s) {
    Owners out(v.labels.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
      if (v.labels[i] == 0) continue;
      const bool is_region = v.labels[i] <= static_cast<std::uint32_t>(v.group.region_count);
      if (is_region) out[i] = s.regions[v.labels[i] - 1];
      else out[i] = Attributes{cnrg::Name::of_entities(), {}, {}};
    }
    return out;
  }

  Owners owners(std::size_t node_number) const {
    const DagNode& node = dag_.nodes[node_number];
    const Value& value = values_[node_number];
    const Value& x = values_[node.operands[0]];
    const std::string operator_name = cnrg::properties::operator_name(node);
    Owners out(value.labels.size());
    if (node.each) return out;  // components that share cells: the page does not say in which order
    Owners before = out_[node.operands[0]].owners;
    std::vector<bool> in_x(out.size());
    for (std::size_t i = 0; i < in_x.size(); ++i) in_x[i] = x.labels[i] != 0;
    for (std::size_t k = 1; k < node.operands.size(); ++k) meet(node, k, before, in_x);
    if (node.op == Operator::unify || node.op == Operator::complement) {
      std::optional<Attributes> one = node.op == Operator::unify ? of_all(before, in_x) : Attributes();
      if (one && (one->name.parts().size() != 1 || is_of_entities(one->name.parts()[0])))
        one->name = one_part(cnrg::properties::name_of(dag_, node_number), NameOrigin::node);
      before.assign(out.size(), one);
      if (node.op == Operator::complement)
        for (std::size_t i = 0; i < in_x.size(); ++i) in_x[i] = !in_x[i];
    }
    for (std::size_t i = 0; i < out.size(); ++i) {
      if (value.labels[i] == 0) continue;
      // What an operator adds is called after it, what the attribute `regularize` adds as by that operator.
      const bool there = value.first_labels.empty() || value.first_labels[i] != 0;
      if (!there) out[i] = Attributes{one_part("regularize", NameOrigin::operation), {}, {}};
      else out[i] = in_x[i] ? before[i] : Attributes{one_part(operator_name, NameOrigin::operation), {}, {}};
      if (out[i]) say(*out[i], node.said);
    }
    return out;
  }

  /// A step of `aggregate`, `sum`, `product` or `subtract`.
  void meet(const DagNode& node, std::size_t k, Owners& owners, std::vector<bool>& in_x) const {
    const Value& y = values_[node.operands[k]];
    const Owners& others = out_[node.operands[k]].owners;
    const DominantOperand dominant = node.dominant.value_or(DominantOperand::equal);
    for (std::size_t i = 0; i < owners.size(); ++i) {
      const bool in_y = y.labels[i] != 0;
      if (node.op == Operator::cnrg_subtract) {
        if (in_y) in_x[i] = false;
        continue;
      }
      if (in_x[i] && in_y) {
        if (dominant == DominantOperand::right) owners[i] = others[i];
        else if (dominant == DominantOperand::equal)
          owners[i] = owners[i] && others[i] ? std::optional(joined(*owners[i], *others[i])) : std::nullopt;
      } else if (in_y) {
        owners[i] = others[i];
      }
      in_x[i] = node.op == Operator::product ? in_x[i] && in_y : in_x[i] || in_y;
    }
  }

  using NamePart = cnrg::NamePart;
  using NameOrigin = cnrg::NameOrigin;
  static cnrg::Name one_part(const std::string& text, NameOrigin origin, std::uint32_t ordinal = 0) {
    return cnrg::Name(std::vector{NamePart{text, ordinal, origin}});
  }
  static bool is_of_entities(const NamePart& part) { return part.origin == NameOrigin::entities; }

  /// Of two equal components: names part by part, the rest of the left one, what it lacks of the other.
  static Attributes joined(const Attributes& a, const Attributes& b) {
    Attributes out = a;
    take(out, b, nullptr);
    std::map<std::pair<std::string, std::uint32_t>, NameOrigin> strongest;
    std::vector<NamePart> parts;
    for (const cnrg::Name* name : {&a.name, &b.name}) {
      for (const NamePart& part : name->parts()) {
        const auto [it, fresh] = strongest.try_emplace({part.text, part.ordinal}, part.origin);
        if (fresh) parts.push_back(part);
        it->second = std::max(it->second, part.origin);
      }
    }
    for (NamePart& part : parts) part.origin = strongest.at({part.text, part.ordinal});
    // That entities are entities goes without saying where the other one has a name.
    if (parts.size() > 1) std::erase_if(parts, is_of_entities);
    out.name = cnrg::Name(std::move(parts));
    return out;
  }

  /// Of all cells together; nothing where two say different things, since the page does not say whose counts.
  static std::optional<Attributes> of_all(const Owners& owners, const std::vector<bool>& active) {
    std::optional<Attributes> all;
    for (std::size_t i = 0; i < owners.size(); ++i) {
      if (!active[i]) continue;
      if (!owners[i]) return std::nullopt;
      if (!all) all = owners[i];
      std::set<Warning> odds;
      take(*all, *owners[i], &odds);
      if (!odds.empty()) return std::nullopt;
      *all = joined(*all, *owners[i]);
    }
    return all ? all : Attributes();
  }

  const Grid& grid_;
  const RandomDag& dag_;
  const std::vector<Value>& values_;
  std::vector<Saying> out_;
};

}  // namespace

std::string text(const Attributes& a) {
  std::string out = "[" + a.name.text() + "|" + a.material.name();
  for (const auto& [key, value] : a.properties) {
    const char* const quote = std::holds_alternative<std::string>(value) ? "'" : "";
    out += "|" + key + "=" + quote + cnrg::to_text(value) + quote;
  }
  return out + "]";
}

void say(Attributes& a, const Attributes& stronger) {
  if (!stronger.name.empty()) a.name = stronger.name;
  if (!stronger.material.empty()) a.material = stronger.material;
  for (const auto& [key, value] : stronger.properties) a.properties[key] = value;
}

std::vector<Saying> sayings(const Grid& grid, const RandomDag& dag, const std::vector<Value>& values) {
  return Sayings(grid, dag, values).run();
}

}  // namespace cubical
