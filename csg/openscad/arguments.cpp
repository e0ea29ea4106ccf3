// Typed reading of arguments: what is wanted or an error at the statement.
#include "csg/openscad/arguments.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "csg/leaves/leaf.h"
#include "csg/text/escape.h"

namespace cnrg::openscad {

void fail(const std::string& path, const Statement& at, const std::string& fault) {
  throw LeafFileError(path, at.line, at.column, "`" + excerpt(at.name) + "` " + fault);
}

Arguments::Arguments(const std::string& path, const Statement& statement,
                     std::initializer_list<std::string_view> known)
    : path_(path), statement_(statement), first_(known.size() == 0 ? std::string_view() : *known.begin()) {
  constexpr std::array<std::string_view, 4> kAlways{"$fn", "$fa", "$fs", "convexity"};
  std::set<std::string_view> seen;
  for (const Argument& argument : statement.arguments) {
    const bool named = !argument.name.empty();
    const bool is_first = !named && !first_.empty() && &argument == &statement.arguments.front();
    const std::string_view name = is_first ? first_ : argument.name;
    if ((named || is_first) && !seen.insert(name).second)
      fail(path, statement, "has the argument `" + excerpt(name) + "` twice; remove one");
    if (is_first) continue;
    const auto is_it = [&](std::string_view name) { return name == argument.name; };
    if (named &&
        (std::any_of(known.begin(), known.end(), is_it) || std::any_of(kAlways.begin(), kAlways.end(), is_it)))
      continue;
    fail(path, statement,
         (named ? "has the argument `" + excerpt(argument.name) + "`"
                : std::string("has an argument without a name")) +
             ", which is not read; give it the arguments that OpenSCAD writes into .csg files");
  }
}

void Arguments::fail_wanted(std::string_view name, const std::string& wanted) const {
  fail(path_, statement_, "needs `" + std::string(name) + "`, " + wanted);
}

const Literal* Arguments::find(std::string_view name) const {
  for (const Argument& argument : statement_.arguments) {
    if (argument.name == name || (argument.name.empty() && name == first_)) return &argument.value;
  }
  return nullptr;
}

double Arguments::number(std::string_view name, double otherwise) const {
  const Literal* value = find(name);
  if (value == nullptr) return otherwise;
  if (value->kind != Literal::Kind::number || !std::isfinite(value->number)) fail_wanted(name, "a finite number");
  return value->number;
}

bool Arguments::boolean(std::string_view name) const {
  const Literal* value = find(name);
  if (value == nullptr) return false;
  if (value->kind != Literal::Kind::boolean) fail_wanted(name, "true or false");
  return value->number != 0;
}

std::string Arguments::text(std::string_view name) const {
  const Literal* value = find(name);
  if (value == nullptr || value->kind != Literal::Kind::text) fail_wanted(name, "a text");
  return value->text;
}

std::vector<double> Arguments::list(std::string_view name, const Literal& value, std::size_t count,
                                    const std::string& wanted) const {
  std::vector<double> out;
  for (const Literal& item : value.items) {
    if (item.kind != Literal::Kind::number) fail_wanted(name, wanted);
    out.push_back(item.number);
  }
  if (value.kind != Literal::Kind::list || (count > 0 && out.size() != count)) fail_wanted(name, wanted);
  return out;
}

std::vector<double> Arguments::numbers(std::string_view name, std::size_t count, double otherwise) const {
  const Literal* value = find(name);
  const std::string wanted = "a finite number or a list of " + std::to_string(count);
  std::vector<double> out(count, otherwise);
  if (value != nullptr && value->kind == Literal::Kind::number) out.assign(count, value->number);
  else if (value != nullptr) out = list(name, *value, count, wanted);
  if (!std::all_of(out.begin(), out.end(), [](double x) { return std::isfinite(x); })) fail_wanted(name, wanted);
  return out;
}

std::vector<std::vector<double>> Arguments::points(std::string_view name, std::size_t count) const {
  const Literal* value = find(name);
  const std::string wanted = "a list of points of " + std::to_string(count) + " finite numbers";
  if (value == nullptr || value->kind != Literal::Kind::list) fail_wanted(name, wanted);
  std::vector<std::vector<double>> out;
  for (const Literal& item : value->items) {
    out.push_back(list(name, item, count, wanted));
    for (const double x : out.back()) {
      if (!std::isfinite(x)) fail_wanted(name, wanted);
    }
  }
  return out;
}

std::vector<Face> Arguments::indices(std::string_view name, std::size_t points) const {
  const Literal* value = find(name);
  std::vector<Face> out;
  if (value == nullptr || value->kind == Literal::Kind::undefined) return out;
  const std::string wanted = "a list of lists of numbers of points, below " + std::to_string(points);
  if (value->kind != Literal::Kind::list) fail_wanted(name, wanted);
  for (const Literal& item : value->items) {
    Face& face = out.emplace_back();
    for (const double x : list(name, item, 0, wanted)) {
      if (!(x >= 0 && x < static_cast<double>(points) && x == std::floor(x))) fail_wanted(name, wanted);
      face.push_back(static_cast<std::uint32_t>(x));
    }
  }
  return out;
}

Matrix Arguments::matrix(std::string_view name) const {
  const Literal* value = find(name);
  const std::string wanted = "four rows of four numbers, the last [0, 0, 0, 1]";
  if (value == nullptr || value->kind != Literal::Kind::list || value->items.size() != 4)
    fail_wanted(name, wanted);
  Matrix out{};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::vector<double> row = list(name, value->items[i], 4, wanted);
    if (i < 3) std::copy(row.begin(), row.end(), out[i].begin());
    else if (row != std::vector<double>{0, 0, 0, 1}) fail_wanted(name, wanted);
  }
  return out;
}

Fineness fineness_of(const std::string& path, const Statement& statement, const Fineness& parent) {
  const Arguments a(path, statement);
  const Fineness out{a.number("$fn", parent.fn), a.number("$fa", parent.fa), a.number("$fs", parent.fs)};
  if (out.fa <= 0 || out.fs <= 0) fail(path, statement, "needs `$fa` and `$fs` above 0");
  return out;
}

}  // namespace cnrg::openscad
