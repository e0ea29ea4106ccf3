#include "csg/tree/read_transform.h"

#include "kernel/exact/exact_vectors.h"

namespace cnrg {

namespace {

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

}  // namespace

Transform read_transform(const Value::Entry& e) {
  if (e.key == "translate") return Transform::translation(e.value.point("`translate`"));
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
    return Transform::rotation(along, degrees, through);
  }
  if (!e.value.is_map()) e.value.fail_type("`mirror`", "a map, such as {normal: [1, 0, 0], point: [0, 0, 0]}");
  const Fields f(e.value, form("mirror"));
  f.read("normal", along, "point", through);
  if (is_zero(along)) f.at("normal").fail("`normal` of mirror has no direction; write one such as [1, 0, 0]");
  return Transform::reflection(along, through);
}

}  // namespace cnrg
