// A mixture may name a material that the file declares further down. So each mention is noted with its place, and
// all are checked when every material is known: that it is declared, and that no material is made of itself.
#include "csg/tree/read_material.h"

#include <algorithm>
#include <functional>
#include <map>

#include "csg/tree/suggest.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

/// `#` and six hexadecimal digits.
bool is_color(const std::string& text) {
  return text.size() == 7 && text[0] == '#' &&
         text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
}

/// A material in the mixture of another one, with the place.
struct MaterialMention {
  std::size_t by;  ///< which material of the file
  std::string name;
  Value at;
};

/// What mixtures are of: checked when all materials are known.
struct Mentions {
  std::vector<MaterialMention> all{};
  std::size_t by = 0;  ///< the material that is read
  void add(const std::string& name, const Value& at) { all.push_back({by, name, at}); }
};

Mixture read_mixture(const Value& value, const std::string& what, Mentions& mentions) {
  if (!value.is_map()) {
    mentions.add(value.text(what), value);
    return {{mentions.all.back().name, 1}};
  }
  Mixture mixture;
  Rational sum = 0;
  for (const Value::Entry& e : value.entries(what)) {
    const Rational fraction = e.value.number("the fraction of `" + e.key + "`");
    if (fraction < 0) e.value.fail("the fraction of `" + e.key + "` is negative; give 0 or more");
    sum += fraction;
    mentions.add(e.key, e.value);
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
  const Fields f(value, form("linear"), what);
  LinearGrade linear;
  f.read("from", linear.from, "to", linear.to);
  if (linear.from == linear.to) {
    f.at("to").fail("`from` and `to` of " + what + " are one point; let them differ, they say the way to go");
  }
  return {linear, read_stops(f.at("stops"), f.name("stops"), mentions)};
}

Grade read_distance(const Value& value, const std::string& what, Mentions& mentions) {
  const Fields f(value, form("distance"), what);
  DistanceGrade distance;
  f.read("to", distance.to);
  Grade grade{distance, read_stops(f.at("stops"), f.name("stops"), mentions)};
  if (grade.stops.front().at < 0) f.at("stops").fail("a stop of a distance is negative; give 0 or more");
  return grade;
}

/// The material that each mention names, by its place in the file.
std::vector<std::size_t> mentioned_materials(const std::vector<Material>& materials, const Mentions& mentions) {
  std::map<std::string, std::size_t, std::less<>> places;
  for (std::size_t i = 0; i < materials.size(); ++i) places.emplace(materials[i].name, i);
  std::vector<std::size_t> out;
  for (const MaterialMention& mention : mentions.all) {
    const auto it = places.find(mention.name);
    if (it == places.end()) {
      std::vector<std::string_view> known;
      for (const Material& m : materials) known.push_back(m.name);
      const std::string hint = did_you_mean(mention.name, known);
      mention.at.fail("the material `" + mention.name + "` is not declared" +
                      (hint.empty() ? "; add `" + mention.name + ": {}` to `materials`" : hint));
    }
    out.push_back(it->second);
  }
  return out;
}

/// A walk from material to material along mentions, without recursion: they may nest to any depth.
class CycleSearch {
 public:
  CycleSearch(const std::vector<Material>& materials, const Mentions& mentions)
      : materials_(materials),
        mentions_(mentions),
        named_(mentioned_materials(materials, mentions)),
        of_(materials.size()) {
    for (std::size_t k = 0; k < mentions.all.size(); ++k) of_[mentions.all[k].by].push_back(k);
  }

  /// Fails at a mention that closes a cycle.
  void run() {
    enum : char { fresh, open, done };
    std::vector<char> state(materials_.size(), fresh);
    std::vector<std::size_t> next(materials_.size(), 0), way;
    for (std::size_t start = 0; start < materials_.size(); ++start) {
      if (state[start] != fresh) continue;
      way.push_back(start), state[start] = open;
      while (!way.empty()) {
        const std::size_t at = way.back();
        if (next[at] == of_[at].size()) {
          state[at] = done, way.pop_back();
          continue;
        }
        const std::size_t mention = of_[at][next[at]++], to = named_[mention];
        if (state[to] == open) refuse(way, to, mentions_.all[mention].at);
        if (state[to] == fresh) way.push_back(to), state[to] = open;
      }
    }
  }

 private:
  [[noreturn]] void refuse(const std::vector<std::size_t>& way, std::size_t to, const Value& at) const {
    constexpr std::size_t kListed = 20;
    const auto first = std::find(way.begin(), way.end(), to);
    const auto length = static_cast<std::size_t>(way.end() - first);
    std::string words;
    for (std::size_t i = 0; i < std::min(length, kListed); ++i)
      words += "`" + materials_[first[static_cast<std::ptrdiff_t>(i)]].name + "` -> ";
    if (length > kListed) words += std::to_string(length - kListed) + " more -> ";
    at.fail("the material `" + materials_[to].name + "` is made of itself: " + words + "`" + materials_[to].name +
            "`; remove one of the mentions");
  }

  const std::vector<Material>& materials_;
  const Mentions& mentions_;
  const std::vector<std::size_t> named_;      // by mention
  std::vector<std::vector<std::size_t>> of_;  // mentions by material
};

}  // namespace

std::vector<Material> read_materials(const Value& value) {
  std::vector<Material> materials;
  if (value.is_empty()) return materials;
  Mentions mentions;
  for (const Value::Entry& e : value.entries("`materials`")) {
    Material material{.name = e.key, .at = e.key_at};
    mentions.by = materials.size();
    if (!e.value.is_empty()) {
      const std::string what = "material `" + e.key + "`";
      const Fields f(e.value, form("material"), what);
      f.read("color", material.color, "dominance", material.dominance);
      if (f.has("color") && !is_color(material.color))
        f.at("color").fail_type(f.name("color"), "a text such as \"#998877\"");
      if (const Value* linear = f.find("linear"))
        material.grade = read_linear(*linear, f.name("linear"), mentions);
      if (const Value* distance = f.find("distance")) {
        material.grade = read_distance(*distance, f.name("distance"), mentions);
        material.to_at = Fields(*distance, form("distance")).at("to").at();
      }
    }
    materials.push_back(std::move(material));
  }
  CycleSearch(materials, mentions).run();
  return materials;
}

}  // namespace cnrg
