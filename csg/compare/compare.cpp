// One evaluation of both trees, then sets of cells: what is active in one value alone; what is in both, by pair of
// components; which components are partners; and of what has the same place in both, which cells simplification
// keeps.
#include "csg/compare/compare.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "csg/compare/pieces.h"
#include "csg/compare/same_material.h"
#include "csg/compare/together.h"
#include "csg/evaluate/evaluate.h"
#include "csg/formats/formats.h"
#include "csg/leaves/leaf.h"
#include "csg/operators/cell_sources.h"
#include "csg/operators/node_value.h"
#include "csg/result/result_data.h"
#include "csg/text/child.h"
#include "csg/text/escape.h"
#include "csg/tree/tree_of_file.h"
#include "kernel/base/union_find.h"
#include "kernel/complex/by_dimension.h"
#include "kernel/selection/measure.h"
#include "kernel/selection/selection.h"

namespace cnrg {
namespace {

// Which components of two values correspond.
//
// Families are connected parts of the graph between the components of A and those of B with an edge where two
// share a cell. A wall that only one value has makes one region of two: a family of two and one, which people
// understand. Where many meet many, one partner each is what tells the least differences, and the largest shares
// decide.

/// The cells that two selections share, by pair of components.
using Shared = std::map<std::pair<Component, Component>, CellSet>;

struct Partners {
  std::set<std::pair<Component, Component>> pairs;  ///< that correspond
  /// Families that are not one and one.
  std::vector<std::array<std::vector<Component>, 2>> families;
};

/// How much two components share, larger in every case than what is less. Lengths and areas are rounded: where
/// they tie, they only decide which of two partners is told.
struct Weight {
  std::optional<Rational> volume;
  Rational area, length;
  std::size_t points;
};
Weight weight_of(const Complex& complex, const CellSet& cells) {
  Weight weight{volume(complex, cells.regions), 0, 0, cells.vertices.size()};
  for (const FaceId f : cells.faces) weight.area += square_root(squared_area(complex, f));
  for (const EdgeId e : cells.edges) weight.length += square_root(squared_length(complex, e));
  return weight;
}
bool heavier(const Weight& a, const Weight& b) {
  if (a.volume.has_value() != b.volume.has_value()) return !a.volume;
  if (a.volume != b.volume) return *a.volume > *b.volume;
  if (a.area != b.area) return a.area > b.area;
  if (a.length != b.length) return a.length > b.length;
  return a.points > b.points;
}

Shared shared_cells(const Selection& a, const Selection& b) {
  Shared out;
  const auto share = [&](const auto& of_a, const auto& of_b) {
    auto it = of_b.begin();
    for (const auto& [cell, component] : of_a) {
      while (it != of_b.end() && it->first < cell) ++it;
      if (it == of_b.end()) return;
      if (it->first == cell) list_for(out[{component, it->second}], cell).push_back(cell);
    }
  };
  for_each_dimension(share, a, b);
  return out;
}

/// Components that share cells are of one family. In a family of one and one, one and several or several and one
/// all that share correspond; in any other each component has one partner at most, pairs that share most first: by
/// volume, then area, length and number of points. `entities`: of two groups the components that their entities
/// are (0: none), which correspond to each other and to nothing else. `count`: how many components there are.
Partners partners(const Complex& complex, const Shared& shared, const std::array<Component, 2>& entities,
                  const std::array<std::size_t, 2>& count) {
  const auto is_entities = [&](Component a, Component b) { return a == entities[0] || b == entities[1]; };
  Partners out;
  if (entities[0] != 0 && entities[1] != 0) out.pairs.emplace(entities[0], entities[1]);
  UnionFind sets(count[0] + count[1]);
  for (const auto& [pair, cells] : shared) {
    if (!is_entities(pair.first, pair.second))
      sets.unite(pair.first - 1, static_cast<std::uint32_t>(count[0] + pair.second - 1));
  }
  std::map<std::uint32_t, std::array<std::vector<Component>, 2>> families;
  for (int side = 0; side < 2; ++side) {
    for (Component i = 1; i <= count[side]; ++i) {
      if (i == entities[side]) continue;  // of groups
      const auto place = static_cast<std::uint32_t>((side == 0 ? 0 : count[0]) + i - 1);
      families[sets.find(place)][side].push_back(i);
    }
  }
  for (const auto& [root, family] : families) {
    const auto& [of_a, of_b] = family;
    if (of_a.size() != 1 || of_b.size() != 1) out.families.push_back(family);
    const bool many = of_a.size() > 1 && of_b.size() > 1;
    std::vector<std::pair<Weight, std::pair<Component, Component>>> ranking;
    for (const Component a : of_a) {
      for (const Component b : of_b) {
        const auto it = shared.find({a, b});
        if (it == shared.end()) continue;
        if (many) ranking.emplace_back(weight_of(complex, it->second), it->first);
        else out.pairs.insert(it->first);
      }
    }
    // Ties go by the smaller number, then by the larger: the same whichever value comes first.
    std::sort(ranking.begin(), ranking.end(), [](const auto& x, const auto& y) {
      if (heavier(x.first, y.first)) return true;
      if (heavier(y.first, x.first)) return false;
      return std::minmax(x.second.first, x.second.second) < std::minmax(y.second.first, y.second.second);
    });
    std::set<Component> taken_a, taken_b;
    for (const auto& [weight, pair] : ranking) {
      if (taken_a.contains(pair.first) || taken_b.contains(pair.second)) continue;
      taken_a.insert(pair.first), taken_b.insert(pair.second);
      out.pairs.insert(pair);
    }
  }
  return out;
}

/// The strongest origin of a part of `name` that `other` has not.
NameOrigin strongest(const Name& name, const Name& other) {
  NameOrigin most = NameOrigin::entities;
  for (const NamePart& part : name.parts()) {
    const auto& all = other.parts();
    const auto says = [&](const NamePart& p) { return p.shown() == part.shown(); };
    if (std::none_of(all.begin(), all.end(), says)) most = std::max(most, part.origin);
  }
  return most;
}

/// Two names differ where one of them has a part that the other one has not and that somebody gave: by `name`, in
/// a group, in a CAD model. A region that nobody named is called after its node; the nodes of an answer to an
/// exercise may be called anything. Parts of a result that was read back and does not tell may be either; they
/// differ from given ones and from each other, not from those of nodes.
bool names_differ(const Name& a, const Name& b) {
  const NameOrigin of_a = strongest(a, b), of_b = strongest(b, a);
  return std::max(of_a, of_b) == NameOrigin::given || (of_a == NameOrigin::file && of_b == NameOrigin::file);
}

/// A tree with `weld`, compared. What is near is joined among the leaves of that tree alone, before anything cuts
/// anything. Among the leaves of two trees more would be near, and differences would go with it. So such a tree is
/// evaluated by itself, and what is compared is its result, exact as a `.json` holds it, in a file without a name.
class Settled {
 public:
  /// Evaluates the node. InputError if the result reaches infinity, which no `.json` can give back.
  Settled(const Tree& tree, NodeId node, int threads) : file_("cnrg compare") {
    EvaluateOptions options;
    options.threads = threads;
    options.rows = Rows::none;
    options.result = node;
    const Result result = evaluate(tree, options).result();
    const std::string text = json_text(result.data().view()).text;
    file_.write(text.data(), text.size());
    const ResultShape shape{"/proc/self/fd/" + std::to_string(file_.descriptor())};
    try {
      prepare(shape);
    } catch (const InputError&) {
      throw TreeError(tree.file, tree.weld_at,
                      "a result of a tree with `weld` is compared as it is in a `.json`, and `" +
                          tree.nodes[node].name +
                          "` has faces or lines without bounds, which cannot be read back; "
                          "cut it with a box");
    }
    tree_ = tree_of_leaf(tree.file, tree.nodes[node].name, "cnrg", shape);
  }
  /// One leaf, the result; of use as long as this lives.
  const Tree& tree() const { return tree_; }

 private:
  MemoryFile file_;
  Tree tree_;
};

/// One of the two values on the complex.
struct ComparedSide {
  const KeptValue* kept;
  Selection selection;
  CellSet cells;
  std::unique_ptr<const ValueSources> sources;
};

class Comparer {
 public:
  Comparer(const Together& together, const std::string& mark, const Evaluation& evaluation,
           const CompareOptions& options)
      : mark_(mark), complex_(*evaluation.complex), options_(options) {
    for (std::size_t side = 0; side < 2; ++side) {
      const KeptValue& kept = evaluation.value(together.nodes[side]);
      sides_[side].kept = &kept;
      sides_[side].selection = selection_of(complex_, *kept.value);
      sides_[side].cells = support(sides_[side].selection);
      sides_[side].sources = sources_of(complex_, *kept.value);
    }
  }

  Comparison run() {
    const CellSet &a = sides_[0].cells, &b = sides_[1].cells;
    const std::array<CellSet, 2> only{subtract(a, b), subtract(b, a)};
    sets_ = {only[0], only[1]};
    if (options_.components) compare_components(only);
    // All at once: to find and to measure pieces takes passes over the complex.
    std::vector<std::vector<SetPiece>> pieces = pieces_of(complex_, sets_);
    for (std::size_t side = 0; side < 2; ++side) out_.only[side] = std::move(pieces[side]);
    for (std::size_t i = 0; i < out_.moved.size(); ++i) out_.moved[i].pieces = std::move(pieces[2 + i]);
    for (std::size_t i = 0; i < out_.said.size(); ++i) out_.said[i].pieces = std::move(pieces[said_at_ + i]);
    for (std::size_t side = 0; side < 2 && features_at_ != 0; ++side) {
      out_.features[side] = std::move(pieces[features_at_ + side]);
    }
    return std::move(out_);
  }

 private:
  const NodeValue& value(std::size_t side) const { return *sides_[side].kept->value; }

  void compare_components(const std::array<CellSet, 2>& only) {
    label();
    const Shared shared = shared_cells(sides_[0].selection, sides_[1].selection);
    const bool groups = value(0).is_group() && value(1).is_group();
    std::array<Component, 2> entities{};
    for (std::size_t side = 0; groups && side < 2; ++side) {
      if (value(side).group().has_entities())
        entities[side] = static_cast<Component>(value(side).component_count());
    }
    const Partners found =
        partners(complex_, shared, entities, {value(0).component_count(), value(1).component_count()});
    for (const auto& family : found.families) {
      if (family[0].size() < 2 || family[1].size() < 2) {
        out_.regrouped.push_back({family});
        continue;
      }
      for (const Component in_a : family[0]) {
        for (const Component in_b : family[1]) {
          if (found.pairs.contains({in_a, in_b})) out_.mostly.push_back({in_a, in_b});
        }
      }
    }
    CellSet changed = unite(only[0], only[1]), alike;
    const CellSet beside = closure(complex_, changed);
    for (const auto& [pair, cells] : shared) {
      if (found.pairs.contains(pair)) {
        alike = unite(alike, cells);
        continue;
      }
      changed = unite(changed, cells);
      // Where a region goes on in one value, what bounds it in the other is an entity: that goes without saying.
      const bool entity = groups && (pair.first == entities[0]) != (pair.second == entities[1]);
      CellSet told = entity ? subtract(cells, beside) : cells;
      if (told.empty()) continue;
      out_.moved.push_back({{pair.first, pair.second}, {}});
      sets_.push_back(std::move(told));
    }
    for (const auto& [in_a, in_b] : found.pairs) {
      if (!groups || in_a != entities[0]) compare_attributes(in_a, in_b);
    }
    compare_said(alike, changed);
    if (!options_.features) return;
    // Between components that became one no cell is kept, of a group none but entities, which are compared above.
    if (!groups) {
      for (const auto& family : found.families) {
        for (const Component in_a : family[0]) {
          for (const Component in_b : family[1]) {
            if (const auto it = shared.find({in_a, in_b}); it != shared.end())
              changed = unite(changed, it->second);
          }
        }
      }
    }
    features_at_ = sets_.size();
    compare_features(subtract(alike, closure(complex_, changed)));
  }

  void label() {
    for (std::size_t side = 0; side < 2; ++side) {
      const std::size_t regions =
          value(side).is_group() ? value(side).group().regions.size() : value(side).component_count();
      for (Component i = 1; i <= value(side).component_count(); ++i) {
        if (i > regions) {
          out_.components[side].push_back(kEntitiesLabel);
          continue;
        }
        const std::string name = shown(value(side).attributes(i).name.text());
        out_.components[side].push_back((value(side).is_group() ? "region " : "component ") + std::to_string(i) +
                                        (name.empty() ? "" : " `" + name + "`"));
      }
    }
  }

  void compare_attributes(Component in_a, Component in_b) {
    for (Comparison::Word& word : differing(value(0).attributes(in_a), value(1).attributes(in_b))) {
      out_.attributes.push_back({{in_a, in_b}, std::move(word)});
    }
  }

  /// What is said otherwise in `a`, of A, and `b`, of B.
  std::vector<Comparison::Word> differing(const Attributes& a, const Attributes& b) const {
    std::vector<Comparison::Word> out;
    if (options_.names && names_differ(a.name, b.name)) {
      out.push_back({"name", false, {a.name.text(), b.name.text()}});
    }
    if (options_.materials) {
      const std::string word_a = a.material.name();
      const std::string word_b = without_mark(b.material.name(), mark_);
      const PlacedGrade *grade_a = a.material.grade(), *grade_b = b.material.grade();
      const bool same_grades =
          grade_a == nullptr || grade_b == nullptr ? grade_a == grade_b : same_grade(*grade_a, *grade_b, mark_);
      if (word_a != word_b || !same_grades) out.push_back({"material", false, {word_a, word_b}, word_a == word_b});
    }
    if (!options_.attributes) return out;
    std::set<std::string> keys;
    for (const Attributes* const one : {&a, &b}) {
      for (const auto& [key, said] : one->properties) keys.insert(key);
    }
    for (const std::string& key : keys) {
      const auto in_a = a.properties.find(key), in_b = b.properties.find(key);
      const bool both = in_a != a.properties.end() && in_b != b.properties.end();
      if (both && in_a->second == in_b->second) continue;
      const auto text = [&](const auto& it, const Properties& all) {
        return it == all.end() ? std::string() : said_text(it->second);
      };
      out.push_back({key, true, {text(in_a, a.properties), text(in_b, b.properties)}});
    }
    return out;
  }

  /// A number as it is, a text in quotes, as in a tree: so the text 25 is not the number.
  static std::string said_text(const Property& value) {
    if (const auto* const text = std::get_if<std::string>(&value)) return '"' + *text + '"';
    return to_text(value);
  }

  /// Of cells that speak for themselves (cell_sources.h); those that differ are `changed`.
  void compare_said(const CellSet& cells, CellSet& changed) {
    const ValueSources &a = *sides_[0].sources, &b = *sides_[1].sources;
    if (!a.marks_anything() && !b.marks_anything()) return;
    static const Attributes kNothing;
    std::map<std::vector<Comparison::Word>, CellSet> found;
    const auto ask = [&](const auto& list) {
      for (const auto cell : list) {
        const Attributes *in_a = a.said(cell), *in_b = b.said(cell);
        if (in_a == nullptr && in_b == nullptr) continue;
        std::vector<Comparison::Word> words = differing(in_a ? *in_a : kNothing, in_b ? *in_b : kNothing);
        if (!words.empty()) list_for(found[std::move(words)], cell).push_back(cell);
      }
    };
    for_each_entity(ask, cells);
    said_at_ = sets_.size();
    for (auto& [words, set] : found) {
      changed = unite(changed, set);
      out_.said.push_back({words, {}});
      sets_.push_back(std::move(set));
    }
  }

  /// Cells that are a cell of their own in one simplified value, and within a larger one in the other.
  void compare_features(const CellSet& cells) {
    const SimplifiedComplex &a = *sides_[0].kept->simplified, &b = *sides_[1].kept->simplified;
    for (std::size_t side = 0; side < 2; ++side) {
      const SimplifiedComplex &here = side == 0 ? a : b, &there = side == 0 ? b : a;
      CellSet kept;
      const auto keep = [](const auto& list, auto& out, const auto& place_here, const auto& place_there,
                           int dimension) {
        std::copy_if(list.begin(), list.end(), std::back_inserter(out), [&](auto cell) {
          return place_here[cell.index()].dimension == dimension &&
                 place_there[cell.index()].dimension != dimension;
        });
      };
      keep(cells.vertices, kept.vertices, here.vertex_place, there.vertex_place, 0);
      keep(cells.edges, kept.edges, here.edge_place, there.edge_place, 1);
      keep(cells.faces, kept.faces, here.face_place, there.face_place, 2);
      sets_.push_back(std::move(kept));
    }
  }

  const std::string& mark_;
  const Complex& complex_;
  const CompareOptions& options_;
  std::array<ComparedSide, 2> sides_;
  std::vector<CellSet> sets_;    // only in A, only in B, those of `moved`, of `said`, features of A and of B
  std::size_t said_at_ = 0;      // where those of `said` begin
  std::size_t features_at_ = 0;  // where the latter begin; 0: nobody asked
  Comparison out_;
};

Evaluation evaluated(const Tree& tree, NodeId node, const std::vector<NodeId>& more,
                     const CompareOptions& options) {
  EvaluateOptions all;
  all.threads = options.threads;
  all.rows = Rows::none;
  all.result = node;
  all.nodes = more;
  all.drawn_together = true;
  all.watch = options.watch;
  return evaluate(tree, all);
}

}  // namespace

bool Comparison::same() const {
  return only[0].empty() && only[1].empty() && regrouped.empty() && moved.empty() && attributes.empty() &&
         said.empty() && features[0].empty() && features[1].empty();
}

Comparison compare(const Tree& a, NodeId node_a, const Tree& b, NodeId node_b, const CompareOptions& options) {
  const std::array<const Tree*, 2> trees{&a, &b};
  std::array<NodeId, 2> nodes{node_a, node_b};
  const std::string mark = unused_mark(a, b);
  // A fault of one of the trees is told in its own words, without the mark and in the file that it is in.
  const auto told_alone = [&](const std::vector<std::size_t>& sides, const auto& work) {
    const auto alone = [&] {
      for (const std::size_t side : sides) evaluated(*trees[side], side == 0 ? node_a : node_b, {}, options);
    };
    try {
      return work();
    } catch (const InputError&) {
      alone();
      throw;
    } catch (const FileError&) {
      alone();
      throw;
    }
  };
  std::array<std::optional<Settled>, 2> settled;
  std::array<Tree, 2> ready{a, b};
  for (const std::size_t side : {0, 1}) {
    if (trees[side]->weld) {
      told_alone({side}, [&] { settled[side].emplace(*trees[side], nodes[side], options.threads); });
      ready[side] = settled[side]->tree();
      nodes[side] = ready[side].result;
    }
  }
  const Together both = together(ready[0], nodes[0], ready[1], nodes[1], mark);
  const Evaluation evaluation = told_alone({0, 1}, [&] {
    try {
      return evaluated(both.tree, both.nodes[0], {both.nodes[1]}, options);
    } catch (const TreeError& e) {
      if (e.file() != a.file && e.file() != b.file) throw;  // a file that a leaf reads
      throw InputError(a.file + " and " + b.file + " cannot be refined together: " + e.message());
    }
  });
  return Comparer(both, mark, evaluation, options).run();
}

}  // namespace cnrg
