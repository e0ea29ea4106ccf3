#include "csg/tree/read_selector.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "csg/text/number.h"
#include "csg/tree/read_attribute.h"

namespace cnrg {
namespace {

constexpr std::int64_t kMostNumber = std::numeric_limits<std::int32_t>::max();
constexpr const char* kSides =
    "two names of regions or materials, one of them perhaps null for no region: [rock, clay], [rock, null]";

std::array<SideName, 2> read_sides(const Value& value, const std::string& what) {
  const std::vector<Value> sides = value.list(what, kSides);
  if (sides.size() != 2) value.fail_type(what, kSides);
  if (sides[0].is_empty() && sides[1].is_empty()) {
    value.fail(what + ": null is no region, and on both sides it is no wall; name a region or a material");
  }
  std::array<SideName, 2> out;
  for (std::size_t k = 0; k < 2; ++k) {
    if (!sides[k].is_empty()) out[k] = sides[k].text(what);
  }
  return out;
}

/// A name or a number; a number in quotes is a name.
void read_region(const Value& value, const std::string& what, Criteria& criteria) {
  if (!value.is_text()) value.fail_type(what, "a name or a number, from 1");
  const std::string text = value.text(what);
  if (value.is_quoted() || !read_number(text).value) {
    criteria.regions.push_back(text);
  } else {
    criteria.region_numbers.push_back(static_cast<Component>(value.integer(what, 1, kMostNumber)));
  }
}

void read_wanted_properties(const Value& value, const std::string& what, Criteria& criteria) {
  if (!value.is_map()) value.fail_type(what, "a map of keys with values, such as {diameter: 25}");
  for (const Value::Entry& e : value.entries(what)) {
    const std::string name = "the attribute `" + e.key + "`";
    if (e.key.empty()) value.document().fail(e.key_at, "an attribute has a name; write the one that is meant");
    for (const Value& v : one_or_more(e.value, name)) {
      criteria.properties.emplace_back(e.key, read_property(v, name));
    }
  }
}

void read_between(const Value& value, const std::string& what, Criteria& criteria) {
  const std::vector<Value> list = value.list(what, kSides);
  const auto is_list = [](const Value& v) { return v.is_list(); };
  if (list.empty() || !std::all_of(list.begin(), list.end(), is_list)) {
    criteria.between.push_back(read_sides(value, what));
    return;
  }
  for (const Value& sides : list) criteria.between.push_back(read_sides(sides, what));
}

}  // namespace

Criteria read_criteria(const Fields& fields) {
  Criteria criteria;
  const auto each = [&](const char* key, auto read) {
    const Value* const value = fields.find(key);
    if (value == nullptr) return;
    const std::string what = fields.name(key);
    for (const Value& v : one_or_more(*value, what)) read(v, what);
  };
  each("dimension", [&](const Value& v, const std::string& what) {
    criteria.dimensions.push_back(static_cast<int>(v.integer(what, 0, 3)));
  });
  each("name", [&](const Value& v, const std::string& what) { criteria.names.push_back(v.text(what)); });
  each("region", [&](const Value& v, const std::string& what) { read_region(v, what, criteria); });
  each("source face", [&](const Value& v, const std::string& what) {
    criteria.source_faces.push_back(static_cast<std::uint32_t>(v.integer(what, 0, kMostNumber)));
  });
  if (const Value* attributes = fields.find("attributes")) {
    read_wanted_properties(*attributes, fields.name("attributes"), criteria);
  }
  if (const Value* between = fields.find("between")) {
    read_between(*between, fields.name("between"), criteria);
  }
  return criteria;
}

std::vector<Value> one_or_more(const Value& value, const std::string& what) {
  if (!value.is_list()) return {value};
  std::vector<Value> values = value.list(what);
  if (values.empty()) value.fail(what + " is an empty list; give a value, or leave it out");
  return values;
}

}  // namespace cnrg
