#include "tests/oracles/cubical_compare.h"

#include <algorithm>
#include <map>
#include <optional>

#include "kernel/selection/simplify.h"
#include "tests/oracles/cubical_pair.h"
#include "tests/oracles/cubical_said.h"
#include "tests/oracles/cubical_values.h"
#include "tests/oracles/dag_values.h"
#include "tests/oracles/evaluation.h"

namespace cubical {
namespace {

using cnrg::Location;
using cnrg::Rational;
using cnrg::properties::component_at;
using cnrg::properties::is_group_boolean;
using cnrg::properties::RandomDag;

std::string cell_text(const Grid& grid, Cell c) {
  const auto p = grid.position(c);
  return "(" + std::to_string(p[0]) + "," + std::to_string(p[1]) + "," + std::to_string(p[2]) + ")/2";
}

/// What is said of an active cell of lower dimension; nullptr: nothing.
const cnrg::Said* said_at(const cnrg::NodeValue& value, const Location& at) {
  const auto find = [&](const auto& vertices, const auto& edges, const auto& faces, const cnrg::Origins& origins) {
    const auto said = [&](const auto& list, const auto& sets, auto id) -> const cnrg::Said* {
      const auto id_of = [](const auto& entry) {
        if constexpr (requires { entry.first; }) return entry.first;
        else return entry;
      };
      const auto it = std::ranges::lower_bound(list, id, {}, id_of);
      if (it == list.end() || id_of(*it) != id) return nullptr;
      return origins.sets.said(sets[static_cast<std::size_t>(it - list.begin())]).get();
    };
    return at.dimension == 0   ? said(vertices, origins.vertices, at.vertex)
           : at.dimension == 1 ? said(edges, origins.edges, at.edge)
                               : said(faces, origins.faces, at.face);
  };
  if (value.is_group()) {
    const cnrg::Group& g = value.group();
    return find(g.vertices, g.edges, g.faces, g.origins);
  }
  const cnrg::Components& x = value.components();
  return find(x.selection.vertices, x.selection.edges, x.selection.faces, x.origins);
}

/// The warnings of a node: "... keeps the material `a` where `b` has equal dominance", "... the attribute `k: a`
/// ...".
std::set<Warning> told_warnings(const cnrg::Evaluation& evaluation, const std::string& node) {
  std::set<Warning> out;
  for (const cnrg::Diagnostic& d : evaluation.diagnostics) {
    if (d.level != cnrg::Diagnostic::Level::warning || d.message.rfind("`" + node + "`: ", 0) != 0) continue;
    const std::string& m = d.message;
    const auto between = [&](const std::string& from, const std::string& to) {
      const std::size_t a = m.find(from) + from.size();
      return m.substr(a, m.find(to, a) - a);
    };
    const std::string other = between("` where `", "`");
    if (m.find("keeps the material `") != std::string::npos) {
      out.insert({"", between("keeps the material `", "`"), other});
    } else if (m.find("keeps the attribute `") != std::string::npos) {
      const std::string both = between("keeps the attribute `", "` where");
      const std::size_t colon = both.find(": ");
      out.insert({both.substr(0, colon), both.substr(colon + 2), other});
    }
  }
  return out;
}

/// A wire in a sheet, or a point on either, of which the same is said: the page does not say whether it is to be
/// seen.
bool says_the_same_around(const Grid& grid, const Group& g, const Said& said) {
  for (Cell c = 0; c < grid.cells(); ++c) {
    const auto& at = said[static_cast<std::size_t>(c)];
    if (grid.dimension(c) > 1 || !g.entity[c] || !at || at->dimension != grid.dimension(c)) continue;
    std::vector<Cell> above = grid.around(c);
    for (int d = grid.dimension(c) + 1; d <= 2; ++d) {
      std::vector<Cell> higher;
      for (const Cell u : above) {
        const auto& other = said[static_cast<std::size_t>(u)];
        if (g.entity[u] && other && other->attributes == at->attributes && other->dimension > at->dimension)
          return true;
        higher.insert(higher.end(), grid.around(u).begin(), grid.around(u).end());
      }
      above = std::move(higher);
    }
  }
  return false;
}

/// Components with what their cells say, as states of the canonical form. What does not speak for itself takes the
/// state of that which it is a cut in, so that it does not stand in the way.
std::vector<int> states(const Grid& grid, const Value& value, const Saying& want) {
  const Group& g = value.group;
  std::vector<std::string> says(value.labels.size());
  const auto up = [&](Cell c) {
    std::vector<Cell> out;
    for (const Cell d : grid.around(c))
      if (grid.dimension(d) < 3 && g.entity[d]) out.push_back(d);
    return out;
  };
  const auto of = [&](Cell c) -> std::string& { return says[static_cast<std::size_t>(c)]; };
  const auto axis = [&](Cell f) {
    const auto p = grid.position(f);
    return p[0] % 2 == 0 ? 0 : p[1] % 2 == 0 ? 1 : 2;
  };
  for (int d : {2, 1, 0}) {
    for (Cell c = 0; c < grid.cells(); ++c) {
      if (grid.dimension(c) != d || !g.entity[c]) continue;
      const auto& at = want.said[static_cast<std::size_t>(c)];
      const auto around = up(c);
      if (at && !at->attributes.empty() && (at->dimension == d || around.empty())) {
        of(c) = text(at->attributes);
      } else if (d == 1) {
        if (around.size() == 2 && axis(around[0]) == axis(around[1]) && of(around[0]) == of(around[1]))
          of(c) = of(around[0]);
      } else if (d == 0 && !around.empty()) {
        std::vector<Cell> wires;
        for (const Cell e : around) {
          const auto& other = want.said[static_cast<std::size_t>(e)];
          if ((other && other->dimension == 1 && !other->attributes.empty()) || up(e).empty()) wires.push_back(e);
        }
        const auto& edges = wires.empty() ? around : wires;
        if (std::all_of(edges.begin(), edges.end(), [&](Cell e) { return of(e) == of(edges[0]); }))
          of(c) = of(edges[0]);
      }
    }
  }
  std::map<std::pair<std::uint32_t, std::string>, int> numbers;
  std::vector<int> out(value.labels.size(), 0);
  for (std::size_t i = 0; i < out.size(); ++i)
    if (value.labels[i] != 0)
      out[i] = numbers.try_emplace({value.labels[i], says[i]}, static_cast<int>(numbers.size()) + 1).first->second;
  return out;
}

/// A tree's values by brute force and by the program, node by node.
class Comparison {
 public:
  Comparison(const Grid& grid, const CubicalDag& dag, std::vector<Value> values, SaidTally& met)
      : grid_(grid),
        dag_(dag.dag),
        values_(std::move(values)),
        want_(sayings(grid, dag.dag, values_)),
        have_(cnrg::properties::evaluate(placed(dag))),
        met_(met) {
    const cnrg::Locator locator(have_.complex());
    for (Cell c = 0; c < grid.cells(); ++c) {
      const auto p = grid.position(c);
      places_.push_back(locator.locate(dag.place({Rational(p[0], 2), Rational(p[1], 2), Rational(p[2], 2)})));
    }
  }

  std::string run() {
    for (std::size_t i = 0; i < values_.size(); ++i)
      if (const std::string f = node(i); !f.empty())
        return cnrg::properties::name_of(dag_, i) + " (" + cnrg::properties::operator_name(dag_.nodes[i]) +
               "): " + f;
    return {};
  }

 private:
  std::string node(std::size_t i) {
    const cnrg::NodeValue& have = *have_.values[i];
    if (have.is_group() != values_[i].is_group) return "a value of the wrong family";
    const cnrg::Selection selection = selection_of(have_.complex(), have);
    std::string f = components(values_[i], have, selection);
    if (f.empty()) f = canonical_counts_of(i, selection);
    bool all_known = true;
    if (f.empty()) f = said(i, all_known);
    if (f.empty() && have.is_group()) f = regions(i);
    if (f.empty()) f = warnings(i);
    if (f.empty()) f = owners(want_[i], have, selection);
    if (f.empty() && all_known) f = simplified(i, selection);
    ++met_.nodes;
    return f;
  }

  /// Components correspond one to one on all cells.
  std::string components(const Value& want, const cnrg::NodeValue& have, const cnrg::Selection& selection) const {
    std::map<std::uint32_t, cnrg::Component> to;
    std::map<cnrg::Component, std::uint32_t> from;
    for (std::size_t c = 0; c < places_.size(); ++c) {
      const std::uint32_t w = want.labels[c];
      const cnrg::Component h = component_at(selection, places_[c]);
      const std::string name = cell_text(grid_, static_cast<Cell>(c));
      if ((w == 0) != (h == 0)) return name + (w != 0 ? " should be active" : " should be inactive");
      if (w == 0) continue;
      if (!to.emplace(w, h).second && to[w] != h) return name + " splits a component";
      if (!from.emplace(h, w).second && from[h] != w) return name + " joins components";
    }
    const auto most = *std::max_element(want.labels.begin(), want.labels.end());
    return want.is_group || have.component_count() == most ? "" : "the number of components differs";
  }

  bool bounded(const Value& want) const {
    for (Cell c = 0; c < grid_.cells(); ++c)
      if (grid_.on_rim(c) && grid_.dimension(c) == 3 && want.labels[static_cast<std::size_t>(c)] != 0)
        return false;
    return true;
  }

  /// Of what does not reach the rim.
  std::string canonical_counts_of(std::size_t i, const cnrg::Selection& selection) const {
    const Labels& labels = values_[i].labels;
    if (!bounded(values_[i])) return {};
    const auto counts = active_counts(cnrg::simplify(have_.complex(), selection, {}, cnrg::SimplifyMode::points));
    if (counts == canonical_counts(grid_, std::vector<int>(labels.begin(), labels.end()))) return {};
    return "counts of the canonical form differ";
  }

  /// Of faces, edges and vertices.
  std::string said(std::size_t i, bool& all_known) {
    for (Cell c = 0; c < grid_.cells(); ++c) {
      if (grid_.dimension(c) == 3) continue;
      const auto& w = want_[i].said[static_cast<std::size_t>(c)];
      if (w && !w->known) {
        all_known = false;
        continue;
      }
      const cnrg::Said* h = said_at(*have_.values[i], places_[static_cast<std::size_t>(c)]);
      const Attributes expected = w ? w->attributes : Attributes{}, found = h ? h->attributes : Attributes{};
      if (!(expected == found))
        return "of " + cell_text(grid_, c) + " is said " + text(found) + ", should be " + text(expected);
      met_.said_cells += !found.empty();
    }
    return {};
  }

  std::string regions(std::size_t i) {
    const cnrg::Group& g = have_.values[i]->group();
    const Group& force = values_[i].group;
    for (Cell c = 0; c < grid_.cells(); ++c) {
      const auto k = static_cast<std::size_t>(c);
      if (grid_.dimension(c) != 3 || force.region[k] == 0) continue;
      const auto& w = want_[i].regions[static_cast<std::size_t>(force.region[k] - 1)];
      if (!w) continue;
      const Attributes& h = g.regions[g.region_of(places_[k].region) - 1];
      if (!(*w == h)) return "region at " + cell_text(grid_, c) + " is " + text(h) + ", should be " + text(*w);
      ++met_.regions;
    }
    return {};
  }

  std::string warnings(std::size_t i) {
    const cnrg::properties::DagNode& of = dag_.nodes[i];
    if (!values_[i].is_group || !is_group_boolean(of.op) || !want_[i].warnings_known || of.regularize) return {};
    const std::set<Warning> warned = told_warnings(have_.evaluation, cnrg::properties::name_of(dag_, i));
    std::string differ;
    const auto add = [&](const std::set<Warning>& all, const std::set<Warning>& but, const char* what) {
      for (const auto& [key, kept, other] : all)
        if (!but.contains({key, kept, other})) differ += what + key + " " + kept + " / " + other + ";";
    };
    add(want_[i].warnings, warned, " missing: ");
    add(warned, want_[i].warnings, " too many: ");
    met_.conflicts += warned.size();
    return differ.empty() ? "" : "warnings" + differ;
  }

  /// What is said of the component that a cell is of; nothing for an inactive cell.
  static std::optional<Attributes> attributes_at(const cnrg::NodeValue& have, const cnrg::Selection& selection,
                                                 const Location& at) {
    const cnrg::Component k = component_at(selection, at);
    if (k == 0) return std::nullopt;
    return static_cast<Attributes>(have.attributes(k));
  }

  /// Each active cell is of a component of which the right things are said.
  std::string owners(const Saying& want, const cnrg::NodeValue& have, const cnrg::Selection& selection) {
    for (Cell c = 0; c < grid_.cells(); ++c) {
      const auto& owner = want.owners[static_cast<std::size_t>(c)];
      if (!owner || grid_.on_rim(c)) continue;
      const std::optional<Attributes> found = attributes_at(have, selection, places_[static_cast<std::size_t>(c)]);
      if (!found || !(*found == *owner))
        return "the component at " + cell_text(grid_, c) + " is " + (found ? text(*found) : "none") +
               ", should be " + text(*owner);
      ++met_.owners;
    }
    return {};
  }

  /// What a cell says for itself: of a thing of its own dimension, and not what its component says already.
  Attributes speaks(Cell c, const Saying& want, const Attributes& component) const {
    const auto& at = want.said[static_cast<std::size_t>(c)];
    if (!at || at->dimension != grid_.dimension(c)) return {};
    Attributes both = component;
    say(both, at->attributes);
    return both == component ? Attributes{} : at->attributes;
  }

  /// No simplified cell holds cells that say different things, nor swallows one that speaks.
  std::string merging(std::size_t i, const cnrg::SimplifiedComplex& simplified,
                      const cnrg::Selection& selection) const {
    std::map<std::pair<int, std::uint32_t>, std::pair<Attributes, Cell>> first;
    for (int d : {3, 2, 1, 0}) {
      for (Cell c = 0; c < grid_.cells(); ++c) {
        const auto k = static_cast<std::size_t>(c);
        if (grid_.dimension(c) != d || values_[i].labels[k] == 0 || grid_.on_rim(c)) continue;
        const auto place = simplified.place(have_.complex(), places_[k]);
        const Attributes component = attributes_at(*have_.values[i], selection, places_[k]).value_or(Attributes());
        const Attributes own = speaks(c, want_[i], component);
        // What is said of a sheet is said of its edges, which speak where they are all that is left of it.
        const auto& at_all = want_[i].said[k];
        const auto [it, fresh] = first.try_emplace({place.dimension, place.index},
                                                   std::pair(at_all ? at_all->attributes : Attributes{}, c));
        if (!fresh && !(it->second.first == own) && !own.empty())
          return cell_text(grid_, c) + " says " + text(own) + " and is in one simplified cell with " +
                 cell_text(grid_, it->second.second) + ", which says " + text(it->second.first);
      }
    }
    return {};
  }

  std::string simplified(std::size_t i, const cnrg::Selection& selection) {
    const cnrg::NodeValue& have = *have_.values[i];
    for (const auto mode : {cnrg::SimplifyMode::features, cnrg::SimplifyMode::points}) {
      const cnrg::SimplifiedComplex simplified = cnrg::simplify(have_.complex(), have, selection, mode);
      if (std::string f = merging(i, simplified, selection); !f.empty()) return f;
      if (mode != cnrg::SimplifyMode::points || !bounded(values_[i]) || !have.is_group() ||
          says_the_same_around(grid_, values_[i].group, want_[i].said))
        continue;
      const auto counts = active_counts(simplified);
      const auto by_force = canonical_counts(grid_, states(grid_, values_[i], want_[i]));
      if (counts != by_force) {
        std::string f = "simplified counts";
        for (const std::size_t n : counts) f += " " + std::to_string(n);
        f += ", should be";
        for (const std::size_t n : by_force) f += " " + std::to_string(n);
        return f;
      }
      ++met_.counted;
    }
    return {};
  }

  const Grid& grid_;
  const RandomDag& dag_;
  const std::vector<Value> values_;
  const std::vector<Saying> want_;
  const cnrg::properties::DagValues have_;
  std::vector<Location> places_;
  SaidTally& met_;
};

}  // namespace

std::string compare_by_brute_force(const Grid& grid, const CubicalDag& dag, SaidTally* tally) {
  std::vector<Value> values;
  if (std::string f = values_by_brute_force(grid, dag.dag, values); !f.empty()) return f;
  SaidTally ignored;
  return Comparison(grid, dag, std::move(values), tally == nullptr ? ignored : *tally).run();
}

}  // namespace cubical
