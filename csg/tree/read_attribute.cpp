// One attribute after the other; what two of them say together is checked when all are read.
#include "csg/tree/read_attribute.h"

#include <cmath>
#include <map>

#include "csg/geometry/transform.h"
#include "csg/text/number.h"
#include "csg/tree/operator_names.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

void read_dominance(Node& node, const Value::Entry& e) {
  const std::string text = e.value.text("`dominance`");
  static const std::map<std::string, DominantOperand> kSides{
      {"left", DominantOperand::left}, {"right", DominantOperand::right}, {"equal", DominantOperand::equal}};
  if (const auto side = kSides.find(text); side != kSides.end()) {
    if (!has_sides(node.op)) {
      e.value.fail("`dominance: " + text + "` is for union, intersection, difference, sum and product; give `" +
                   node.operator_name + "` a number, such as `dominance: 2`");
    }
    node.dominant = side->second;
  } else if (read_number(text).value || text.find_first_not_of("0123456789+-.eE/") == std::string::npos) {
    node.dominance = e.value.number("`dominance`");
  } else {
    e.value.fail_type("`dominance`", has_sides(node.op) ? "left, right, equal or a number" : "a number");
  }
}

void read_blend(Node& node, const Value::Entry& e) {
  if (e.value.text("`blend`") != "linear") e.value.fail_type("`blend`", "linear");
  if (node.op != Operator::unite || node.operator_name == "layers") {
    e.value.document().fail(e.key_at, "`blend` is for union; remove it from `" + node.operator_name + "`");
  }
  node.blend = true;
}

constexpr const char *kMatrixRows = "three rows of four numbers [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]",
                     *kMatrixRow = "four numbers [1, 0, 0, 0]";

/// Three rows of four numbers: p -> A p + b.
Transform read_matrix(const Value& value) {
  const std::vector<Value> rows = value.list("`matrix`", kMatrixRows);
  if (rows.size() != 3) value.fail_type("`matrix`", kMatrixRows);
  Transform out;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::vector<Value> row = rows[i].list("a row of `matrix`", kMatrixRow);
    if (row.size() != 4) rows[i].fail_type("a row of `matrix`", kMatrixRow);
    for (std::size_t k = 0; k < 3; ++k) out.linear[i][k] = row[k].number("an entry of `matrix`");
    out.offset[i] = row[3].number("an entry of `matrix`");
  }
  if (out.determinant() == 0)
    value.fail("`matrix` makes a solid flat: its determinant is zero; use another matrix");
  return out;
}

Transform read_transform(const Value::Entry& e, const Rational& times) {
  if (e.key == "translate") return Transform::translation(times * e.value.point("`translate`"));
  if (e.key == "matrix") return read_matrix(e.value);
  if (e.key == "scale") {
    RationalPoint factors;
    if (e.value.is_text()) {
      factors.fill(e.value.number("`scale`"));
    } else {
      factors = e.value.point("`scale`");
    }
    if (factors[0] == 0 || factors[1] == 0 || factors[2] == 0) {
      e.value.fail("`scale` by zero makes a solid flat: the transform is singular; use factors that are not zero");
    }
    return Transform::scaling(factors);
  }
  RationalPoint along, through{0, 0, 0};
  if (e.key == "rotate") {
    if (!e.value.is_map()) e.value.fail_type("`rotate`", "a map, such as {axis: [0, 0, 1], degrees: 90}");
    const Fields f(e.value, form("rotate"));
    Rational degrees;
    f.read("axis", along, "degrees", degrees, "center", through);
    if (is_zero(along)) f.at("axis").fail("`axis` of rotate has no direction; write one such as [0, 0, 1]");
    return Transform::rotation(along, times * degrees, through);
  }
  if (!e.value.is_map()) e.value.fail_type("`mirror`", "a map, such as {normal: [1, 0, 0], point: [0, 0, 0]}");
  const Fields f(e.value, form("mirror"));
  f.read("normal", along, "point", through);
  if (is_zero(along)) f.at("normal").fail("`normal` of mirror has no direction; write one such as [1, 0, 0]");
  return Transform::reflection(along, through);
}

}  // namespace

Properties read_properties(const Value& value) {
  constexpr const char* kWanted = "a map of keys with numbers or texts, such as {diameter: 25, section: round}";
  if (!value.is_map()) value.fail_type("`attributes`", kWanted);
  Properties properties;
  for (const Value::Entry& e : value.entries("`attributes`")) {
    const std::string what = "the attribute `" + e.key + "`";
    if (e.key.empty()) value.document().fail(e.key_at, "an attribute needs a name, such as `diameter: 25`");
    if (e.key == "name" || e.key == "material" || e.key == "dominance") {
      value.document().fail(e.key_at, "`" + e.key + "` is a key of the node itself; write it beside `attributes`");
    }
    properties.emplace(e.key, read_property(e.value, what));
  }
  return properties;
}

Property read_property(const Value& value, const std::string& what) {
  if (!value.is_text()) value.fail_type(what, "a number or a text");
  const std::string text = value.text(what);
  if (value.is_quoted()) return text;
  if (NumberText number = read_number(text); number.value) return std::move(*number.value);
  const std::size_t sign = text.front() == '-' || text.front() == '+' ? 1 : 0;
  const std::size_t first = sign + (text.size() > sign && text[sign] == '.' ? 1 : 0);
  if (text.size() > first && text[first] >= '0' && text[first] <= '9') {
    value.fail(what + ": `" + text + "` begins like a number and is none; mend it, or write a text in quotes");
  }
  return text;
}

Rational read_size(const Value& value) {
  Rational size = value.number("`size`");
  const double rounded = to_double(size);
  if (!(rounded > 0 && std::isfinite(rounded))) {
    value.fail("`size` is how long edges of a mesh are to be, and must be above 0; write one such as 0.5");
  }
  return size;
}

void read_attribute(Node& node, const Value::Entry& e, const LeafContext& context) {
  if (is_of_others(e.key)) return;
  if (e.key == "material") {
    node.material = e.value.text("`material`");
    context.check_material(e.value);
  } else if (e.key == "name") {
    node.label = e.value.text("`name`");
  } else if (e.key == "attributes") {
    node.properties = read_properties(e.value);
  } else if (e.key == "size") {
    node.size = read_size(e.value);
  } else if (e.key == "regularize") {
    node.regularize = *e.value.as_bool();
  } else if (e.key == "each") {
    const std::optional<bool> each = e.value.as_bool();
    if (!each) e.value.fail_type("`each`", "true or false");
    if (*each && !is_topological(node.op)) {
      e.value.document().fail(
          e.key_at,
          "`each` is for interior, closure, boundary and regularize; remove it from `" + node.operator_name + "`");
    }
    node.each = *each;
  } else if (e.key == "simplify") {
    node.forget_features = e.value.raw() == "points";
  } else if (e.key == "dominance") {
    read_dominance(node, e);
  } else if (e.key == "blend") {
    read_blend(node, e);
  } else {
    move(node, e);
  }
}

void move(Node& node, const Value::Entry& e, const Rational& times) {
  const Transform step = read_transform(e, times);
  node.transform = node.transform ? step * *node.transform : step;
}

void check_blend(const Node& node, const std::vector<Value::Entry>& entries) {
  if (!node.blend || !node.dominant) return;
  for (const Value::Entry& e : entries) {
    if (e.key == "dominance") {
      e.value.document().fail(e.key_at, "`" + node.name +
                                            "` blends its operands, so none of them dominates; leave out " +
                                            "`dominance: " + e.value.raw() + "` or `blend`");
    }
  }
}

}  // namespace cnrg
