#include "tests/oracles/dag_nef.h"

#include "tests/oracles/dag_reference.h"
#include "tests/oracles/dag_values.h"
#include "tests/oracles/evaluation.h"
#include "tests/oracles/nef_oracle.h"
#include "tests/scenes/measure.h"

namespace cnrg::properties {
namespace {

/// A failed comparison: what and where, in words; empty when all is well.
using Failure = std::string;

/// With `each`, Nef gets the operand's components one by one; nodes of more are compared by definition only.
constexpr std::size_t kMostComponents = 8;

class Comparison {
 public:
  explicit Comparison(const RandomDag& dag)
      : dag_(dag),
        values_(evaluate(dag)),
        complex_(values_.complex()),
        standings_(standings(dag)),
        incidence_(complex_) {}

  Failure run() {
    for (const RegionId r : IdRange<RegionId>(complex_.region_count))
      volumes_.push_back(complex_.unbounded(r) ? Rational(0) : scenes::volume(complex_, r));
    for (std::size_t i = 0; i < dag_.nodes.size(); ++i) {
      const DagNode& node = dag_.nodes[i];
      const NodeValue& value = *values_.values[i];
      const std::vector<const NodeValue*> operands = values_.operands(node);
      if (Failure f = compare_by_definition(complex_, incidence_, node, operands, value); !f.empty())
        return words(i) + f;
      if (Failure f = value.is_group() ? validate(complex_, value.group()) : ""; !f.empty())
        return words(i) + "no group: " + f;
      nefs_.push_back(nef_of(node, nefs_, i));
      if (Failure f = compare(i); !f.empty()) {
        if (contradicted(node, i)) throw OracleFailure("Nef contradicts itself");
        return words(i) + f;
      }
    }
    const Selection root = point_set(dag_.nodes.size() - 1);
    if (!(to_nef(complex_, root) == nefs_.back())) return "the result as a Nef polyhedron is another one";
    return cells(root);
  }

 private:
  std::string words(std::size_t i) const { return name_of(dag_, i) + " (" + operator_name(dag_.nodes[i]) + "): "; }

  Selection point_set(std::size_t i) const { return joined(selection_of(complex_, *values_.values[i])); }

  using Nefs = std::vector<NefSet>;

  NefSet nef_of(const DagNode& node, const Nefs& nefs, std::size_t i) const {
    if (node.op == Operator::leaf) return NefSet::leaf(dag_.leaves[node.leaf]);
    NefSet result = node.each ? each(node, i) : applied(node, nefs);
    return node.regularize ? result.regularization() : result;
  }

  /// Nef gives our value when it gets the same operands, by its own equality, in another form: operations
  /// of CGAL 5.5.1 now and then give a broken structure without an assertion.
  bool contradicted(const DagNode& node, std::size_t i) {
    if (node.op == Operator::leaf || node.each) return false;
    Nefs again = nefs_;
    for (const std::size_t k : node.operands) {
      again[k] = to_nef(complex_, point_set(k));
      if (!(again[k] == nefs_[k])) return false;
    }
    nefs_[i] = nef_of(node, again, i);
    return compare(i).empty();
  }

  /// An operand of a group Boolean: a complement stands for its closure.
  NefSet group_operand(const Nefs& nefs, std::size_t i) const {
    return standings_[i] == Standing::complement ? nefs[i].closure() : nefs[i];
  }

  NefSet applied(const DagNode& node, const Nefs& nefs) const {
    const NefSet& x = nefs[node.operands[0]];
    const auto fold = [&](bool groups, auto op) {
      NefSet all = groups ? group_operand(nefs, node.operands[0]) : x;
      for (std::size_t k = 1; k < node.operands.size(); ++k)
        all = op(all, groups ? group_operand(nefs, node.operands[k]) : nefs[node.operands[k]]);
      return all;
    };
    const auto unite = [](const NefSet& a, const NefSet& b) { return a.unite(b); };
    const auto intersect = [](const NefSet& a, const NefSet& b) { return a.intersect(b); };
    switch (node.op) {
      case Operator::unite: return fold(true, unite);
      case Operator::intersect: return fold(true, intersect);
      case Operator::subtract: return fold(true, [](const NefSet& a, const NefSet& b) { return a.subtract(b); });
      case Operator::aggregate:
      case Operator::sum: return fold(false, unite);
      case Operator::product: return fold(false, intersect);
      case Operator::cnrg_subtract:
        return fold(false, [](const NefSet& a, const NefSet& b) { return a.without(b); });
      case Operator::complement: return x.complement();
      case Operator::unify:
      case Operator::simplify: return x;
      default: return topological(node.op, x);
    }
  }

  static NefSet topological(Operator op, const NefSet& x) {
    switch (op) {
      case Operator::interior: return x.interior();
      case Operator::closure: return x.closure();
      case Operator::boundary: return x.boundary();
      default: return x.regularization();
    }
  }

  NefSet each(const DagNode& node, std::size_t i) const {
    const NodeValue& operand = *values_.values[node.operands[0]];
    const Selection selection = selection_of(complex_, operand);
    if (operand.component_count() > kMostComponents) return to_nef(complex_, point_set(i));
    std::vector<NefSet> parts;
    for (Component c = 1; c <= operand.component_count(); ++c)
      parts.push_back(
          topological(node.op, to_nef(complex_, joined(restrict_to(selection, support(selection, c))))));
    return NefSet::unite_all(std::move(parts));
  }

  Failure compare(std::size_t i) const {
    const Selection set = point_set(i);
    const NefSet& nef = nefs_[i];
    const Skeleton ours = skeleton(complex_, set), theirs = nef.skeleton();
    if (Failure f = difference(ours, theirs); !f.empty()) return "ours first, then Nef's:\n" + f;
    const bool unbounded = !set.regions.empty() && set.regions.front().first == RegionId(0);
    if (unbounded != nef.unbounded()) return "the mark of the unbounded region differs";
    if (volume(set) != nef.volume()) return "volumes differ";
    return {};
  }

  /// Of the bounded regions after simplification: cells of other leaves in the unbounded one are no volumes.
  Rational volume(const Selection& set) const {
    Rational sum = 0;
    for (const auto& region : simplify(complex_, set, {}, SimplifyMode::points).regions)
      if (region.component != 0 && region.bounded)
        for (const RegionId cell : region.cells) sum += volumes_[cell.index()];
    return sum;
  }

  /// A point in every cell of the common refinement is in both sets or in none (no symmetric difference), and is
  /// located in its cell.
  Failure cells(const Selection& set) {
    const CellIncidence::Labels active = incidence_.labels(set);
    const NefSet& nef = nefs_.back();
    const Locator locator(complex_);
    std::size_t i = 0;
    const auto check = [&](const RationalPoint& p) -> Failure {
      const bool ours = active[i] != 0;
      if (ours != nef.contains(p)) {
        // CGAL 5.5.1 finds (1, 3, 4) in a set that ends at z = 3 but for one wire.
        if (ours != (nef.intersect(NefSet::point(p)) == NefSet()))
          throw OracleFailure("Nef locates a point elsewhere than it intersects it");
        return incidence_.name(i) + (ours ? " is" : " is not") + " in the result, Nef disagrees";
      }
      const std::size_t at = incidence_.number(locator.locate(p));
      if (at != i) return "a point of " + incidence_.name(i) + " is located in " + incidence_.name(at);
      ++i;
      return {};
    };
    Failure f;
    for (const VertexId v : complex_.vertices)
      if (f = check(complex_.points.rational(v)); !f.empty()) return f;
    for (const EdgeId e : IdRange<EdgeId>(complex_.edge_count()))
      if (f = check(scenes::point_in(complex_, e)); !f.empty()) return f;
    for (const FaceId x : IdRange<FaceId>(complex_.face_count()))
      if (f = check(scenes::point_in(complex_, x)); !f.empty()) return f;
    for (const RegionId r : IdRange<RegionId>(complex_.region_count))
      if (f = check(scenes::point_in(complex_, r)); !f.empty()) return f;
    return {};
  }

  const RandomDag& dag_;
  const DagValues values_;
  const Complex& complex_;
  std::vector<Standing> standings_;
  CellIncidence incidence_;
  std::vector<Rational> volumes_;
  Nefs nefs_;
};

}  // namespace

std::string compare_with_nef(const RandomDag& dag) { return Comparison(dag).run(); }

}  // namespace cnrg::properties
