// The explanation for people: a head per class of pieces, a line per node with its outcome, below it what decided.
//
// Words are the paper's (pereira2012 3): numReg, nA, inside, outside, numFace, numEdge, dangOrLoose, loose, AinB
// ... INTERS; n is the normal of the face that is told about, so that nA is n or -n.
#include <algorithm>

#include "csg/explain/explain.h"
#include "csg/materials/sampler.h"
#include "csg/operators/paper_terms.h"
#include "csg/text/escape.h"
#include "csg/text/table.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

const char* const kKinds[] = {"vertex", "edge", "face", "3-cell"};
const char* const kArticles[] = {"a vertex", "an edge", "a face", "a 3-cell"};
const char* const kManyKinds[] = {"vertices", "edges", "faces", "3-cells"};

std::string counted_cells(std::size_t n, int dimension) {
  return counted(n, kKinds[dimension], kManyKinds[dimension]);
}

std::string quoted(const std::string& name) { return name.empty() ? "" : " `" + name + "`"; }

/// A region of a group, or what is outside of all.
std::string region_words(const CellState& s) {
  return s.component == 0 ? "outside" : "region " + std::to_string(s.component) + quoted(s.name);
}

std::string state_words(const CellState& s, int dimension) {
  if (!s.group) {
    return s.component == 0 ? "in no component" : "component " + std::to_string(s.component) + quoted(s.name);
  }
  if (s.entity) return "entity";
  return (s.component == 0 || dimension == 3 ? "" : "inside ") + region_words(s);
}

std::string point_words(const RationalPoint& p) {
  return to_string(p[0]) + "," + to_string(p[1]) + "," + to_string(p[2]);
}
std::string decimal_words(const RationalPoint& p) {
  return to_decimal(p[0], 6) + "," + to_decimal(p[1], 6) + "," + to_decimal(p[2], 6);
}

std::string normal_words(const std::array<Integer, 3>& n) {
  const Integer largest = std::max({Integer(abs(n[0])), Integer(abs(n[1])), Integer(abs(n[2]))});
  std::string out;
  for (std::size_t k = 0; k < 3; ++k) {
    out += (k == 0 ? "" : ", ") + (largest < 1000000 ? n[k].get_str() : to_decimal(Rational(n[k], largest), 6));
  }
  return "(" + out + ")" + (largest < 1000000 ? "" : " in decimals");
}

/// Numbers of one kind of cells of a leaf: `face 2`, `faces 0 and 2`, `region 1`.
std::string numbers_words(const std::vector<LeafCell>& cells, std::uint8_t dimension) {
  static const char* const kOne[] = {"an isolated point", "wire ", "face ", "region "};
  static const char* const kMany[] = {"", "wires ", "faces ", "regions "};
  std::vector<std::string> numbers;
  for (const LeafCell& cell : cells) {
    if (cell.dimension == dimension) numbers.push_back(std::to_string(cell.number));
  }
  if (numbers.empty()) return "";
  if (dimension == 0) return kOne[0];
  constexpr std::size_t kListed = 6;
  if (numbers.size() > kListed) {
    const std::size_t more = numbers.size() - kListed;
    numbers.resize(kListed);
    numbers.push_back(std::to_string(more) + " more");
  }
  return (numbers.size() == 1 ? kOne : kMany)[dimension] + listed(numbers);
}

std::string leaf_cells_words(const std::vector<LeafCell>& cells, bool regions) {
  std::vector<std::string> words;
  for (std::uint8_t dimension : {2, 1, 0, 3}) {
    const std::string some = dimension == 3 && !regions ? "" : numbers_words(cells, dimension);
    if (!some.empty()) words.push_back(some);
  }
  return listed(words);
}

struct Line {
  std::string label, text;
};

// --- group Booleans

/// `A` in `numRegA`, `nA`.
std::string face_words(const OperandFacts& o, char operand) {
  const std::string letter(1, operand);
  const std::string n = std::to_string(o.regions);
  if (o.regions == 0) {
    const bool inside = o.sides[0].component != 0;
    return "face, " + region_words(o.sides[0]) + " on both sides: numReg" + letter + " = 0, dangling, " +
           (inside ? "inside" : "outside") + letter;
  }
  std::string out = "face, " + region_words(o.sides[0]) + " where n points, " + region_words(o.sides[1]) +
                    " behind: numReg" + letter + " = " + n;
  if (o.regions == 1) out += ", n" + letter + (o.sides[0].component != 0 ? " = -n" : " = n");
  return out;
}

std::string operand_words(const OperandFacts& o, char operand, int dimension) {
  const std::string letter(1, operand);
  const std::string made = o.closed_complement ? "; " + letter + " is the closed complement" : "";
  if (!o.state.entity) return state_words(o.state, dimension) + made;
  if (dimension == 2) return face_words(o, operand) + made;
  const std::string count =
      std::string(dimension == 1 ? "numFace" : "numEdge") + letter + " = " + std::to_string(o.bounds);
  return std::string(kKinds[dimension]) + ": " + count + (o.within > 0 ? ", in the interior of a face" : "") +
         (o.free ? ", free" : ", not free") + made;
}

/// Why an edge or a vertex that is not free in an operand has gone, in the paper's terms.
std::string gone_words(const OperandFacts& o, char operand, int dimension) {
  const std::string of = std::string(" of ") + operand;
  const std::string n = o.bounds == 1 ? "" : std::to_string(o.bounds) + " ";
  const bool one = o.bounds == 1, edge = dimension == 1;
  std::vector<std::string> out;
  if (o.bounds > 0 && edge) out.push_back("the " + n + (one ? "face" : "faces") + of + " that it bounds went");
  if (o.bounds > 0 && !edge) {
    out.push_back("the " + n + (one ? "edge" : "edges") + of +
                  (one ? " that ends in it went" : " that end in it went"));
  }
  if (o.within > 0) out.push_back((edge ? "dangOrLoose" : "loose") + (", in the interior of a removed face" + of));
  return listed(out);
}

/// The facts of a condition that the operands' lines do not tell.
std::string reason_words(const BooleanFacts& f, int dimension) {
  const Condition condition = f.verdict.row->condition;
  if (f.verdict.removed) {
    if (condition == Condition::not_free_a) return gone_words(f.a, 'A', dimension);
    if (condition == Condition::not_free_b) return gone_words(f.b, 'B', dimension);
    if (condition == Condition::free_in_neither)
      return gone_words(f.a, 'A', dimension) + "; " + gone_words(f.b, 'B', dimension);
  }
  if (condition == Condition::no_side_survives) {
    std::vector<std::string> sides;
    for (const std::size_t s : {0u, 1u}) {
      if (f.a.sides[s].component != 0 && f.b.sides[s].component == 0)
        sides.push_back(s == 0 ? "where n points" : "behind");
    }
    return "in A and out of B: " + (sides.empty() ? "no side" : listed(sides));
  }
  if (condition == Condition::inside_region_b) {
    std::vector<std::string> around;
    for (const CellState& s : f.b.around) around.push_back(region_words(s));
    const bool cut = f.verdict.removed && around.size() > 1;
    return "around it in B: " + listed(around) + (cut ? "; a mere cut of their wall, no feature of B" : "");
  }
  return "";
}

std::string row_words(const BooleanFacts& f, int dimension) {
  const TableRow& row = *f.verdict.row;
  const std::string id = row.id;
  if (f.verdict.bounds_kept) {
    const std::string kind = dimension == 1 ? "face" : "edge";
    const std::string what = f.kept_around == 0
                                 ? "lies in a kept face"
                                 : "bounds " + counted(f.kept_around, "kept " + kind, "kept " + kind + "s");
    return "kept, since it " + what + "; " + id + " is not asked";
  }
  std::string out = (f.verdict.removed ? "removed by " : "kept by ") + id + ", which ";
  switch (row.condition) {
    case Condition::never: return out + "never removes";
    case Condition::always: return out + "always removes";
    default: out += (f.verdict.removed ? "removes when " : "removes only when ") + condition_words(row);
  }
  return out;
}

/// Where a cell that is an entity of neither operand ends up, and why.
std::string point_set_words(const BooleanFacts& f) {
  const bool a = f.a.state.component != 0, b = f.b.state.component != 0;
  switch (f.op) {
    case BooleanOp::unite:
      return a || b ? std::string("inside, since it is in ") + (a && b ? "both"
                                                                : a    ? "A"
                                                                       : "B")
                    : "outside, since it is in neither";
    case BooleanOp::intersect:
      return a && b ? "inside, since it is in both"
                    : std::string("outside, since it is not in ") + (a   ? "B"
                                                                     : b ? "A"
                                                                         : "A and not in B");
    case BooleanOp::subtract:
      return a && !b ? "inside, since it is in A and not in B"
                     : std::string("outside, since it is ") + (a && b ? "in B" : "not in A");
  }
  throw InvariantError("explain: unknown operator");
}

std::string standing_words(const BooleanFacts& f) {
  if (f.rule == StepRule::blend) return "blend";
  return f.op == BooleanOp::subtract ? "A - B" : f.dominant ? "A > B" : "A = B";
}

/// Who decided, where it was not one operand for all cells.
void add_rule(const BooleanFacts& f, std::vector<Line>& lines) {
  const bool both = f.a.state.component != 0 && f.b.state.component != 0;
  if (f.rule == StepRule::blend) {
    lines.push_back({"blend", f.verdict.entity ? "the walls of both operands stay"
                              : both           ? "in both: their materials are mixed"
                                               : "in one of them: its own material"});
  }
  if (f.rule != StepRule::materials || !both) return;
  lines.push_back({"materials", "their dominance here is " + f.level_a + " in A and " + f.level_b +
                                    " in B: " + (f.dominant ? "A > B" : "A = B")});
}

void add_boolean(const BooleanFacts& f, int of_piece, std::vector<Line>& lines) {
  const int dimension = f.dimension;
  if (dimension != of_piece) {
    lines.push_back({"", std::string("A and B have no ") + kKinds[of_piece] + " here: it is inside of " +
                             kArticles[dimension] + (f.normal ? ", n = " + normal_words(*f.normal) : "")});
  }
  lines.push_back({"A = " + f.a.name, operand_words(f.a, 'A', dimension)});
  lines.push_back({"B = " + f.b.name, operand_words(f.b, 'B', dimension)});
  add_rule(f, lines);
  if (!f.verdict.entity) {
    lines.push_back({dimension == 3 ? "3-cell" : "no entity", point_set_words(f)});
    return;
  }
  lines.push_back({name(f.verdict.relation), row_words(f, dimension)});
  const std::string reason = f.verdict.bounds_kept ? "" : reason_words(f, dimension);
  if (!reason.empty()) lines.push_back({"", reason});
}

// --- CNRG operators

std::string star_part(const std::array<std::size_t, 4>& count, const std::vector<std::string>& names) {
  std::vector<std::string> kinds;
  for (int dimension : {3, 2, 1, 0}) {
    if (const std::size_t n = count[static_cast<std::size_t>(dimension)])
      kinds.push_back(counted_cells(n, dimension));
  }
  if (kinds.empty()) return "nothing";
  constexpr std::size_t kListed = 5;
  std::string some;
  for (std::size_t i = 0; i < std::min(names.size(), kListed); ++i) some += (i == 0 ? "" : ", ") + names[i];
  if (names.size() > kListed) some += ", ...";
  return listed(kinds) + (some.empty() ? "" : " (" + some + ")");
}

std::size_t total(const std::array<std::size_t, 4>& count) { return count[0] + count[1] + count[2] + count[3]; }

std::string decision_words(Operator op, const StarFacts& s, int dimension, const std::string& set) {
  const std::size_t in = total(s.inside), out = total(s.outside);
  const std::string star = std::to_string(out) + " of the " + std::to_string(in + out) + " cells of its star " +
                           (out == 1 ? "is" : "are") + " not in " + set;
  const std::string all =
      dimension == 3 ? "a 3-cell of " + set + " is interior"
                     : "all " + std::to_string(in + out) + " cells of its star are in " + set + ": interior";
  const std::string touching = "in the closure of " +
                               std::string(s.inside[3]   ? "a 3-cell"
                                           : s.inside[2] ? "a face"
                                                         : "an edge") +
                               " of " + set;
  const std::string far = "nothing of its star is in " + set;
  switch (op) {
    case Operator::interior:
      if (!s.in_set) return "not in " + set + ", so not in its interior";
      return s.whole ? "kept: " + all : "removed: " + star;
    case Operator::closure:
      if (s.in_set) return "kept: it is in " + set;
      return s.touched ? "added: " + touching : far;
    case Operator::boundary:
      if (!s.touched) return far;
      if (s.whole) return "removed: " + all;
      return s.in_set ? "kept: in " + set + ", and " + star : "added: not in " + set + ", and " + touching;
    default:
      if (s.solid)
        return std::string(s.in_set ? "kept" : "added") + ": in the closure of the interior, by a 3-cell of " +
               set;
      return s.in_set ? "removed: no 3-cell of " + set + " is in its star"
                      : "not in " + set + ", and no 3-cell of its star is";
  }
}

void add_stars(Operator op, const std::vector<StarFacts>& stars, int dimension, std::vector<Line>& lines) {
  for (const StarFacts& s : stars) {
    const std::string set = s.component == 0 ? "X" : "component " + std::to_string(s.component) + quoted(s.name);
    if (dimension < 3 && s.touched) {
      lines.push_back({"star", star_part(s.inside, s.named_inside) + " in " + set + "; " +
                                   star_part(s.outside, s.named_outside) + " not"});
    }
    lines.push_back({"", decision_words(op, s, dimension, set)});
  }
}

std::string regularized_words(const OperandFacts& o, int dimension) {
  if (!o.state.entity) return "kept: regions stay as they are";
  if (dimension == 2) {
    return face_words(o, 'X') + (o.regions == 0 ? ": removed" : ": kept, it bounds a region");
  }
  return o.walls == 0 ? "removed: it bounds no face that bounds a region"
                      : "kept: it bounds " + counted(o.walls, "face", "faces") + " with numRegX > 0";
}

std::vector<std::string> names_where(const LifeStep& step, bool active) {
  std::vector<std::string> names;
  for (const auto& [name, state] : step.operands) {
    if ((state.component != 0) == active) names.push_back(name);
  }
  return names;
}

/// sum, product and subtract: which pair of components, or none.
std::string overlay_words(Operator op, const LifeStep& step) {
  const std::vector<std::string> in = names_where(step, true), out = names_where(step, false);
  const bool first = step.operands.front().second.component != 0, two = step.operands.size() == 2;
  const bool last = step.operands.back().second.component != 0;
  if (op == Operator::product)
    return out.empty() ? (two ? "kept: Xi and Yj" : "kept: in all") : "left out: not in " + listed(out);
  if (op == Operator::cnrg_subtract) {
    if (!first) return "left out: not in X";
    return in.size() > 1 ? "removed: it is in " + listed({in.begin() + 1, in.end()})
           : two         ? "kept: Xi - |Y|"
                         : "kept: in no other";
  }
  if (in.empty()) return "left out: in no operand";
  if (two) return first && last ? "kept: Xi and Yj" : first ? "kept: Xi - |Y|" : "kept: Yj - |X|";
  return "kept: in " + listed(in) + (out.empty() ? "" : ", not in " + listed(out));
}

std::string cnrg_words(const Node& node, const LifeStep& step) {
  const bool in = step.operands.front().second.component != 0;
  switch (node.op) {
    case Operator::aggregate: return names_where(step, true).empty() ? "left out: in no operand" : "kept as it is";
    case Operator::unify: return in ? "kept: |X| is one component" : "left out: not in X";
    case Operator::complement: return in ? "left out: it is in X" : "kept: space - |X|";
    case Operator::closure: return "a group is closed: it stays as it is";
    case Operator::simplify:
      return node.forget_features ? "the same cells; features are forgotten" : "the same cells";
    case Operator::select:
      if (!in) return "left out: not in X";
      return step.state.component != 0 ? "kept: it is picked, or bounds what is" : "left out: it is not picked";
    default: return overlay_words(node.op, step);
  }
}

void add_cnrg(const Node& node, const LifeStep& step, int dimension, std::vector<Line>& lines) {
  for (std::size_t k = 0; k < step.operands.size(); ++k) {
    const auto& [name, state] = step.operands[k];
    const std::string letter = step.operands.size() > 2 ? "X" + std::to_string(k + 1) : k == 0 ? "X" : "Y";
    const std::string kind = state.entity ? std::string(", ") + kArticles[dimension] : "";
    lines.push_back({letter + " = " + name, state_words(state, dimension) + kind});
  }
  if (step.regularized) {
    lines.push_back({"", regularized_words(*step.regularized, dimension)});
  } else if (!step.stars.empty()) {
    add_stars(node.op, step.stars, dimension, lines);
  } else {
    lines.push_back({"", cnrg_words(node, step)});
  }
}

// --- a step

/// `steel`, given here; `rock` of ground gave way
std::string word_text(const Word& word) {
  const auto quoted = [](const std::string& value) { return "`" + shown(value) + "`"; };
  std::string out = word.value.empty() ? "nothing any more" : quoted(word.value);
  if (word.given) out += ", given here";
  else if (!word.from.empty()) out += ", as " + listed(word.from) + " says";
  for (const auto& [name, value] : word.gave_way) {
    out += "; " + quoted(value) + " of " + shown(name) +
           (word.given           ? " is replaced"
            : word.value.empty() ? " is gone"
                                 : " gave way");
  }
  return out;
}

/// What the operator made of it.
std::vector<Line> details(const Node& node, const LifeStep& step, int dimension) {
  std::vector<Line> lines;
  if (step.operands.empty()) return lines;
  for (std::size_t k = 0; k < step.booleans.size(); ++k) {
    const BooleanFacts& f = step.booleans[k];
    if (f.a.state.component == 0 && f.b.state.component == 0) continue;
    if (step.booleans.size() > 1) {
      lines.push_back(
          {"step " + std::to_string(k + 1), standing_words(f) + "; result: " + state_words(f.result, dimension)});
    }
    add_boolean(f, dimension, lines);
  }
  const bool dull =
      step.state.component == 0 && names_where(step, true).empty() &&
      std::none_of(step.stars.begin(), step.stars.end(), [](const StarFacts& x) { return x.touched; });
  if (step.booleans.empty() && !dull) add_cnrg(node, step, dimension, lines);
  if (step.attribute && !dull) {
    const Regularization& r = *step.attribute;
    lines.push_back({"regularize", "before: " + state_words(r.before, dimension)});
    if (r.group) lines.push_back({"", regularized_words(*r.group, dimension)});
    add_stars(Operator::regularize, r.stars, dimension, lines);
  }
  return lines;
}

std::string outcome(const LifeStep& step, int dimension) {
  const std::string state = state_words(step.state, dimension);
  if (step.operands.empty()) {
    const std::string where = leaf_cells_words(step.leaf_cells, false);
    return step.state.entity && !where.empty() ? state + ": " + where : state;
  }
  if (step.booleans.empty() || !step.booleans.back().verdict.entity) return state;
  // The attribute `regularize` may take what the tables kept.
  const bool gone = step.booleans.back().verdict.removed || !step.state.entity;
  return gone ? "removed; " + state : "kept: " + state;
}

std::string operator_words(const Node& node, const LifeStep& step) {
  std::string out = node.operator_name;
  if (step.booleans.size() == 1 && node.op != Operator::subtract)
    out += ", " + standing_words(step.booleans.front());
  if (node.each) out += ", each";
  if (node.regularize) out += ", regularized";
  return out;
}

void add_life(const Tree& tree, const Life& life, int dimension, std::string& out) {
  std::size_t names = 0, operators = 0, places = 0;
  const auto place = [&](const LifeStep& s) {
    return "line " + std::to_string(tree.nodes[s.node].operator_at.line);
  };
  for (const LifeStep& step : life) {
    names = std::max(names, width_of(shown(step.name)));
    operators = std::max(operators, width_of(operator_words(tree.nodes[step.node], step)));
    places = std::max(places, width_of(place(step)));
  }
  for (const LifeStep& step : life) {
    const Node& node = tree.nodes[step.node];
    append_line(out, padded(shown(step.name), names) + "  " + padded(operator_words(node, step), operators) +
                         "  " + padded(place(step), places) + "  " + outcome(step, dimension));
    std::vector<Line> lines = details(node, step, dimension);
    if (step.state.component != 0) {
      for (const Word& word : step.said) lines.push_back({word.key, word_text(word)});
    }
    std::size_t labels = 0;
    for (const Line& line : lines) labels = std::max(labels, width_of(shown(line.label)));
    for (const Line& line : lines) append_line(out, "    " + padded(shown(line.label), labels) + "  " + line.text);
  }
}

std::string origins_words(const Evaluation& evaluation, const std::vector<LeafCell>& origins) {
  std::string out;
  for (std::size_t i = 0; i < origins.size();) {
    std::size_t j = i;
    while (j < origins.size() && origins[j].leaf == origins[i].leaf) ++j;
    const std::vector<LeafCell> of_leaf(origins.begin() + static_cast<std::ptrdiff_t>(i),
                                        origins.begin() + static_cast<std::ptrdiff_t>(j));
    out += (out.empty() ? "" : "; ") + evaluation.leaf_names[origins[i].leaf.index()] + ": " +
           leaf_cells_words(of_leaf, true);
    i = j;
  }
  return out;
}

/// `u = 1/8`; decimals where the fraction is long.
std::string parameter_words(const char* name, const Rational& value) {
  const std::string exact = to_string(value);
  constexpr std::size_t kShort = 30;
  return std::string(name) + (exact.size() > kShort ? " = about " + to_decimal(value, 12) : " = " + exact);
}

/// A line for each patch and curve of a leaf that the point lies on.
std::string places_words(const Evaluation& evaluation, const LifeClass& c) {
  const SurfaceParameters& parameters = *evaluation.parameters;
  std::string out;
  const auto add = [&](LeafId leaf, const std::string& surface, const std::string& at) {
    append_line(out, "on      " + evaluation.leaf_names[leaf.index()] + ": " + surface + " at " + at);
  };
  for (const PatchPoint& p : c.patches) {
    add(p.leaf, parameters.patch_name(p.leaf, p.patch),
        parameter_words("u", p.at[0]) + ", " + parameter_words("v", p.at[1]));
  }
  for (const CurvePoint& p : c.curves) {
    add(p.leaf, parameters.curve_name(p.leaf, p.curve), parameter_words("t", p.at));
  }
  return out;
}

void add_class(const Tree& tree, const Evaluation& evaluation, const Explanation& e, const LifeClass& c,
               std::string& out) {
  const int dimension = c.example.dimension;
  const bool asked = e.asked.has_value();
  out += "\n";
  if (!asked && e.pieces > 1) {
    out += (c.pieces == e.pieces ? "All " : std::to_string(c.pieces) + " of the ") +
           counted_cells(e.pieces, dimension) + (c.pieces > 1 ? " live alike; one of them:\n" : ":\n");
  }
  const std::string exact = point_words(c.point);
  constexpr std::size_t kShort = 60;
  if (!asked) {
    out +=
        "at      " + (exact.size() > kShort ? decimal_words(c.point) + ", rounded; exactly " : "") + exact + "\n";
  }
  if (c.normal) out += "normal  n = " + normal_words(*c.normal) + "\n";
  if (!c.origins.empty()) append_line(out, "from    " + origins_words(evaluation, c.origins));
  if (!c.mixture.empty()) append_line(out, "made of " + to_text(c.mixture));
  out += places_words(evaluation, c);
  if (!asked || c.normal || !c.origins.empty() || !c.mixture.empty()) out += "\n";
  add_life(tree, c.life, dimension, out);
}

bool asks_tables(const Explanation& e) {
  for (const LifeClass& c : e.classes) {
    for (const LifeStep& step : c.life) {
      for (const BooleanFacts& f : step.booleans) {
        if (f.verdict.entity) return true;
      }
    }
  }
  return false;
}

}  // namespace

std::string explanation_text(const Tree& tree, const Evaluation& evaluation, const Explanation& e) {
  std::string out;
  if (e.asked) {
    const int dimension = e.classes.front().example.dimension;
    const std::string part = e.cell == "-" ? "" : "part of " + e.cell + " of ";
    append_line(out, point_words(*e.asked) + ": " + kArticles[dimension] + " of the refinement; " + part + "`" +
                         e.node_name + "`: " + state_words(e.state, dimension));
  } else {
    append_line(
        out, e.cell + " of `" + e.node_name + "`: " + (e.dimension == 3 ? "region" : kKinds[e.dimension]) + ", " +
                 state_words(e.state, e.dimension) +
                 (e.pieces > 1 ? "; unites " + counted_cells(e.pieces, e.dimension) + " of the refinement" : ""));
  }
  for (const LifeClass& c : e.classes) add_class(tree, evaluation, e, c, out);
  if (e.classes_left_out > 0) {
    out += "\n" + counted_cells(e.pieces_left_out, e.dimension) + " with " +
           counted(e.classes_left_out, "other life", "other lives") + " left out; ask for one by `--point`\n";
  }
  if (asks_tables(e)) {
    out +=
        "\nThe rows are our reading of Fig. 3 of Pereira et al. (2012), whose cells its text does not carry: see "
        "`cnrg tables`.\n";
  }
  return out;
}

}  // namespace cnrg
