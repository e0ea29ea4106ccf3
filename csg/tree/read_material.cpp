// A mixture may name a material that the file declares further down. So each mention is noted with its place, and
// all are checked when every material is known.
#include "csg/tree/read_material.h"

#include <algorithm>

#include "csg/geometry/exact_vectors.h"
#include "csg/tree/suggest.h"

namespace cnrg {
namespace {

/// `#` and six hexadecimal digits.
bool is_color(const std::string& text) {
  return text.size() == 7 && text[0] == '#' &&
         text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
}

/// What mixtures are of, with the place of each mention: checked when all materials are known.
using Mentions = std::vector<std::pair<std::string, Value>>;

Mixture read_mixture(const Value& value, const std::string& what, Mentions& mentions) {
  if (!value.is_map()) {
    mentions.emplace_back(value.text(what), value);
    return {{mentions.back().first, 1}};
  }
  Mixture mixture;
  Rational sum = 0;
  for (const Value::Entry& e : value.entries(what)) {
    const Rational fraction = e.value.number("the fraction of `" + e.key + "`");
    if (fraction < 0) e.value.fail("the fraction of `" + e.key + "` is negative; give 0 or more");
    sum += fraction;
    mentions.emplace_back(e.key, e.value);
    if (fraction != 0) mixture.emplace_back(e.key, fraction);
  }
  if (sum != 1) {
    value.fail("the fractions of " + what + " add up to " + to_string(sum) +
               "; let them add up to 1, such as {steel: 1/4, ceramic: 3/4}");
  }
  std::sort(mixture.begin(), mixture.end());
  return mixture;
}

std::vector<Grade::Stop> read_stops(const Value& value, const std::string& what, Mentions& mentions) {
  const std::string wanted = "a list of two or more stops [[0, MATERIAL], [1, MATERIAL]]";
  std::vector<Grade::Stop> stops;
  const std::vector<Value> list = value.list(what, wanted);
  if (list.size() < 2) value.fail_type(what, wanted);
  for (const Value& item : list) {
    const std::vector<Value> pair = item.list("a stop", "[NUMBER, MATERIAL]");
    if (pair.size() != 2) item.fail_type("a stop", "[NUMBER, MATERIAL]");
    const Rational at = pair[0].number("a stop");
    if (!stops.empty() && at <= stops.back().at) {
      pair[0].fail("this stop, at " + to_decimal(at) + ", does not come after the one at " +
                   to_decimal(stops.back().at) + "; write the stops in ascending order");
    }
    stops.push_back({at, read_mixture(pair[1], "a stop", mentions)});
  }
  return stops;
}

Grade read_linear(const Value& value, const std::string& what, Mentions& mentions) {
  const Fields f(value, what, {"from", "to", "stops"});
  LinearGrade linear{f.at("from", "[x, y, z]").point(f.name("from")), f.at("to", "[x, y, z]").point(f.name("to"))};
  if (linear.from == linear.to) {
    f.at("to", "").fail("`from` and `to` of " + what + " are one point; let them differ, they say the way to go");
  }
  return {linear, read_stops(f.at("stops", "[[0, MATERIAL], [1, MATERIAL]]"), f.name("stops"), mentions)};
}

Grade read_distance(const Value& value, const std::string& what, Mentions& mentions) {
  const Fields f(value, what, {"to", "stops"});
  const DistanceGrade distance{f.at("to", "NAME of a node").text(f.name("to"))};
  Grade grade{distance, read_stops(f.at("stops", "[[0, MATERIAL], [5, MATERIAL]]"), f.name("stops"), mentions)};
  if (grade.stops.front().at < 0) f.at("stops", "").fail("a stop of a distance is negative; give 0 or more");
  return grade;
}

void check_mention(const std::vector<Material>& materials, const std::string& name, const Value& value) {
  std::vector<std::string_view> known;
  for (const Material& m : materials) {
    if (m.name == name) {
      if (m.grade)
        value.fail("the material `" + name + "` is graded itself; mix materials that are the same all over");
      return;
    }
    if (!m.grade) known.push_back(m.name);
  }
  const std::string hint = did_you_mean(name, known);
  value.fail("the material `" + name + "` is not declared" +
             (hint.empty() ? "; add `" + name + ": {}` to `materials`" : hint));
}

}  // namespace

std::vector<Material> read_materials(const Value& value) {
  std::vector<Material> materials;
  if (value.is_empty()) return materials;
  Mentions mentions;
  for (const Value::Entry& e : value.entries("`materials`")) {
    Material material{.name = e.key, .at = e.key_at};
    if (!e.value.is_empty()) {
      const std::string what = "material `" + e.key + "`";
      const Fields f(e.value, what, {"color", "linear", "distance"});
      if (const Value* color = f.find("color")) {
        material.color = color->text(f.name("color"));
        if (!is_color(material.color)) color->fail_type(f.name("color"), "a text such as \"#998877\"");
      }
      const Value *linear = f.find("linear"), *distance = f.find("distance");
      if (linear && distance) {
        distance->fail(what + " is both `linear` and by `distance`; leave one out");
      }
      if (linear) material.grade = read_linear(*linear, "`linear` of " + what, mentions);
      if (distance) {
        material.grade = read_distance(*distance, "`distance` of " + what, mentions);
        material.to_at = Fields(*distance, what, {"to", "stops"}).find("to")->at();
      }
    }
    materials.push_back(std::move(material));
  }
  for (const auto& [name, at] : mentions) check_mention(materials, name, at);
  return materials;
}

}  // namespace cnrg
