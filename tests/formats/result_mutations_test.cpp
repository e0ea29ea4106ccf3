// Nothing that a result file says goes unchecked: every value of small results is changed, taken out, or doubled,
// one at a time. Then reading either refuses the file, with the line and column of the fault, or the result that
// was read, written again, says what the changed file said.
//
// What is not compared is what csg/FORMATS.md says is not kept: the names of the node and of leaves, colors,
// materials of no component, and where cells came from. Which of these name things that do not exist is checked by
// the refusals alone.
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "csg/evaluate/evaluate.h"
#include "csg/formats/result_file.h"
#include "csg/leaves/leaf.h"
#include "csg/tree/tree.h"
#include "kernel/base/error.h"
#include "tests/catch.h"
#include "tests/formats/cases.h"

using namespace cnrg;
using namespace cnrg::test;
using OrderedJson = nlohmann::ordered_json;
using Pointer = OrderedJson::json_pointer;

namespace {

struct MutatedModel {
  const char* what;
  const char* nodes;  ///< the last one is the result
  bool parameters, raw;
};

const MutatedModel kModels[] = {
    {"two regions, a graded one and a plain one; sheets, wires and points inside, outside, on faces", R"(
  left:   {box: {min: [0, 0, 0], max: [4, 4, 4]}, material: mix}
  right:  {box: {min: [4, 0, 0], max: [6, 4, 4/3]}, material: far}
  sheet:  {polygon: [[1, 1, 1], [3, 1, 1], [3, 3, 1], [1, 3, 1]]}
  flap:   {polygon: [[0, 1, 0], [0, 3, 0], [-2, 3, 0], [-2, 1, 1/3]]}
  flat:   {polygon: [[0, 1, 1], [0, 3, 1], [-2, 3, 1]]}
  wire:   {polyline: [[2, 2, 2], [3, 3, 3], [3, 3, 9]]}
  slit:   {polyline: [[1, 1, 0], [2, 2, 0]]}
  points: {points: [[2, 2, 3], [5, 2, 0], [9, 9, 9]]}
  all:    {union: [left, right, sheet, flat, wire, slit, points]})",
     false, false},
    {"the same as the refinement has it", R"(
  left:   {box: {min: [0, 0, 0], max: [4, 4, 4]}}
  right:  {box: {min: [2, 0, 0], max: [6, 4, 4/3]}}
  wire:   {polyline: [[2, 2, 2], [3, 3, 3], [3, 3, 9]]}
  all:    {union: [left, right, wire], dominance: right})",
     false, true},
    {"a cavity with a solid in it", R"(
  block:  {box: {min: [0, 0, 0], max: [9, 9, 9]}}
  hole:   {box: {min: [1, 1, 1], max: [8, 8, 8]}}
  core:   {tetrahedron: [[2, 2, 2], [3, 2, 2], [2, 3, 2], [2, 2, 3]]}
  shell:  {difference: [block, hole]}
  all:    {union: [shell, core]})",
     false, false},
    {"components: open, closed, neither, of all dimensions, with dominance", R"(
  box:    {box: {min: [0, 0, 0], max: [2, 2, 2]}, material: rock, dominance: 1/3}
  open:   {interior: box}
  sheet:  {polygon: [[1, -1, -1], [1, 3, -1], [1, 3, 3], [1, -1, 3]]}
  wire:   {polyline: [[0, 0, 0], [-1, -1, -1]], dominance: -2}
  point:  {points: [[1, 1, 5]]}
  all:    {sum: [open, sheet, wire, point]})",
     false, false},
    {"a complement", R"(
  box:    {box: {min: [0, 0, 0], max: [1, 1, 1]}}
  all:    {complement: box})",
     false, false},
    {"all of space", R"(
  box:    {box: {min: [0, 0, 0], max: [1, 1, 1]}}
  out:    {complement: box}
  sum:    {sum: [box, out]}
  all:    {unify: sum})",
     false, false},
    {"curved faces with parameters, closed edges, a point on a curved face", R"(
  drum:   {cylinder: {from: [0, 0, 0], to: [0, 0, 2], radius: 1, segments: 4}}
  cone:   {cone: {from: [5, 0, 0], to: [5, 0, 1], radius: 1, segments: 3}}
  patch:  {bezier: {patch: [[[8, 0, 0], [9, 0, 1]], [[8, 1, 0], [9, 1, 0]]], segments: 2}}
  point:  {points: [[9, 1, 0], [17/2, 1/2, 1/4]]}
  all:    {union: [drum, cone, patch, point]})",
     true, false},
};

std::string tree_of(const MutatedModel& model) {
  std::string text = "cnrg: 1\nmaterials:\n  rock: {color: \"#998877\"}\n  ore: {}\n";
  if (std::string(model.nodes).find("mix") != std::string::npos) {
    text +=
        "  mix: {linear: {from: [0, 0, 0], to: [4, 0, 1/2], stops: [[0, rock], [1, {rock: 1/3, ore: 2/3}]]}}\n"
        "  far: {distance: {to: wire, stops: [[0, ore], [2, rock]]}}\n";
  }
  return text + "nodes:" + model.nodes + "\nresult: all\n";
}

/// What is kept when a result is read back and written again.
OrderedJson kept(OrderedJson json) {
  json.erase("node"), json.erase("leaves");
  std::set<std::string> used;
  for (auto& c : json["components"]) {
    c.erase("leaves");
    used.insert(c["material"].get<std::string>());
  }
  std::set<std::string> materials;
  for (const auto& m : json["materials"]) {
    if (used.count(m["name"])) materials.insert(m["name"].get<std::string>());
  }
  json["materials"] = materials;
  if (json.contains("patches")) {
    for (auto& p : json["patches"]) p.erase("leaf");
  }
  for (const char* kind : {"vertices", "edges", "faces", "regions"}) {
    for (auto& cell : json[kind]) cell.erase("origin");
  }
  return OrderedJson(nlohmann::json(json));  // members in the order of their names
}

/// Vertices, steps of edges, facets and regions with what is said of each, by coordinates: of a file that unites
/// cells the same as of one that does not.
std::set<std::string> broken_up(const OrderedJson& json) {
  std::set<std::string> all;
  const auto at = [&](const OrderedJson& point) { return json["points"].at(point.get<std::size_t>()).dump(); };
  const auto add = [&](const std::string& place, const OrderedJson& cell,
                       std::initializer_list<const char*> keys) {
    std::string text = place;
    for (const char* key : keys) text += std::string(" ") + key + cell[key].dump();
    all.insert(text);
  };
  for (const auto& v : json["vertices"]) add(at(v["point"]), v, {"component", "entity", "feature"});
  for (const auto& e : json["edges"]) {
    const auto& p = e["points"];
    for (std::size_t i = 0; i + (e["closed"] ? 0 : 1) < p.size(); ++i) {
      std::string a = at(p[i]), b = at(p[(i + 1) % p.size()]);
      add(std::min(a, b) + std::max(a, b), e, {"component", "entity", "feature", "wire"});
    }
  }
  for (const auto& f : json["faces"]) {
    const auto facets = f.contains("facets") ? f["facets"] : OrderedJson::array({f});
    for (const auto& facet : facets) {
      std::set<std::string> points;
      for (const auto& loop : facet["loops"]) {
        for (const auto& p : loop) points.insert(at(p));
      }
      std::string place;
      for (const auto& p : points) place += p;
      add(place, f, {"component", "entity"});
    }
  }
  for (const auto& r : json["regions"]) add("region", r, {"component", "name", "material", "bounded", "volume"});
  return all;
}

class Mutations {
 public:
  explicit Mutations(const MutatedModel& model) : model_(model) {
    write(dir_ / "good.json", value_of(tree_of(model), model.raw), {.parameters = model.parameters});
    good_ = OrderedJson::parse(text_of(dir_ / "good.json"));
  }

  /// Of each kind of place in the file (its path without numbers) at most `most`, spread over the file.
  void run(std::size_t most) {
    CAPTURE(model_.what);
    REQUIRE(read(good_, "") == "accepted");
    std::map<std::string, std::vector<Pointer>> kinds;
    collect(good_, Pointer(), "", kinds);
    for (const auto& [kind, places] : kinds) {
      const std::size_t count = std::min(most, places.size());
      for (std::size_t i = 0; i < count; ++i) change(places[i * places.size() / count]);
    }
  }
  std::size_t tried() const { return tried_; }
  std::size_t refused() const { return refused_; }

 private:
  Result value_of(const std::string& text, bool raw) const {
    EvaluateOptions options;
    options.raw = raw;
    return evaluate(parse_tree(text, dir_ / "t.yaml"), options).result();
  }

  static void collect(const OrderedJson& json, const Pointer& at, const std::string& kind,
                      std::map<std::string, std::vector<Pointer>>& out) {
    out[kind].push_back(at);
    if (json.is_object()) {
      for (const auto& [key, value] : json.items()) collect(value, at / key, kind + "/" + key, out);
    }
    if (json.is_array()) {
      for (std::size_t i = 0; i < json.size(); ++i) collect(json[i], at / i, kind + "/*", out);
    }
  }

  void change(const Pointer& at) {
    const OrderedJson& value = good_[at];
    const auto put = [&](const OrderedJson& other) {
      if (other == value) return;
      OrderedJson json = good_;
      json[at] = other;
      judge(json, at.to_string() + " = " + other.dump());
    };
    if (value.is_number()) {
      const auto n = value.get<long>();
      for (const long other : {n + 1, n - 1, n + 2, 0L, 1000L, 4294967296L + n}) put(other);
      put(double(n)), put(std::to_string(n)), put(nullptr);
    }
    if (value.is_boolean()) put(!value.get<bool>()), put(1);
    if (value.is_null()) put(0), put("1"), put(false);
    if (value.is_string()) change_text(value.get<std::string>(), put);
    if (value.is_array()) change_list(value, put);
    if (value.is_object()) change_object(value, put);
  }

  template <class Put>
  void change_text(const std::string& text, Put put) {
    put(text + "x"), put(7);
    if (const auto number = parse_rational(text)) {
      for (const Rational& other :
           {Rational(*number + 1), Rational(-*number), Rational(*number / 2), Rational(*number * 3)}) {
        put(to_string(other));
      }
      put(text + "/1"), put("+" + text), put("0" + text), put(text + "/0");
    }
    if (text == "front") put("back");
    if (text == "back") put("front");
  }

  template <class Put>
  void change_list(const OrderedJson& list, Put put) {
    for (std::size_t i = 0; i < list.size(); i += std::max<std::size_t>(1, list.size() / 3)) {
      OrderedJson without = list, doubled = list, twice = list;
      without.erase(i);
      doubled.insert(doubled.begin() + std::ptrdiff_t(i), list[i]);
      twice.push_back(list[i]);
      put(without), put(doubled), put(twice);
      if (i + 1 < list.size()) {
        OrderedJson swapped = list;
        std::swap(swapped[i], swapped[i + 1]);
        put(swapped);
      }
    }
    OrderedJson turned = list;
    std::reverse(turned.begin(), turned.end());
    put(turned), put(OrderedJson::array()), put(OrderedJson::object());
  }

  template <class Put>
  void change_object(const OrderedJson& object, Put put) {
    for (const auto& [key, value] : object.items()) {
      OrderedJson without = object;
      without.erase(key);
      put(without);
    }
    OrderedJson more = object;
    more["colour"] = 1;
    put(more), put(OrderedJson::array());
  }

  void judge(const OrderedJson& json, const std::string& what) {
    CAPTURE(what);
    ++tried_;
    const std::string outcome = read(json, what);
    CHECK(outcome == "accepted");
  }

  /// "accepted" for a file that is refused as it should be, too.
  std::string read(const OrderedJson& json, const std::string& what) {
    const std::string file = dir_ / "changed.json";
    std::ofstream(file) << json.dump();
    try {
      prepare(ResultShape{file});
    } catch (const LeafFileError& error) {
      static const std::regex kPlace(":[0-9]+:[0-9]+: error: [^]+");
      ++refused_;
      const std::string text = std::string(error.what()).substr(file.size());
      return std::regex_match(text, kPlace) && text.find("leaf 0,") == std::string::npos ? "accepted" : text;
    } catch (const std::exception& error) {
      return std::string("another error: ") + error.what();
    }
    const std::string tree = "cnrg: 1\nnodes:\n  r: {cnrg: changed.json}\nresult: r\n";
    // Triangles that were Delaunay cover a face that has another form now as well. A bound is believed, and
    // written with three digits.
    const auto compared = [&](const OrderedJson& all) {
      OrderedJson out = kept(all);
      if (what.starts_with("/volume_bound")) out.erase("volume_bound");
      for (auto& face : out["faces"]) {
        if (what.starts_with("/points")) face["triangles"] = face["triangles"].size();
      }
      return out;
    };
    const OrderedJson said = compared(json);
    const auto again = [&](bool raw) {
      write(dir_ / "again.json", value_of(tree, raw), {.parameters = model_.parameters});
      return compared(OrderedJson::parse(text_of(dir_ / "again.json")));
    };
    try {
      if (again(false) == said) return "accepted";
      const OrderedJson as_it_is = again(true);
      if (as_it_is == said) return "accepted";
      // Without a feature, or with a patch in common, cells unite when the result is written simplified.
      if (what.find("/feature") == std::string::npos && what.find("/patch") == std::string::npos) {
        return "says something else";
      }
      const std::set<std::string> wanted = broken_up(said), made = broken_up(as_it_is);
      for (const std::string& one : wanted) {
        if (!made.contains(one)) return "does not say: " + one;
      }
      return "accepted";
    } catch (const std::exception& error) {
      return std::string("read, then: ") + error.what();
    }
  }

  const MutatedModel& model_;
  const ScratchFolder dir_;
  OrderedJson good_;
  std::size_t tried_ = 0, refused_ = 0;
};

}  // namespace

TEST_CASE("result files with one change are refused, or read as what they say") {
  const char* const wanted = std::getenv("CNRG_MUTATIONS");
  const std::size_t most = wanted == nullptr ? 3 : std::strtoul(wanted, nullptr, 10);
  for (const MutatedModel& model : kModels) {
    Mutations mutations(model);
    mutations.run(most);
    CAPTURE(model.what, mutations.tried());
    CHECK(mutations.tried() > 100);
    CHECK(mutations.refused() > mutations.tried() / 2);
  }
}

TEST_CASE("a member that stands twice is refused") {
  const ScratchFolder dir;
  const Tree tree = parse_tree("cnrg: 1\nnodes: {a: {points: [[1, 2, 3]]}}\nresult: a\n", dir / "t.yaml");
  write(dir / "a.json", evaluate(tree).result());
  const std::string text = text_of(dir / "a.json");
  const std::size_t at = text.find("\"feature\":true");
  REQUIRE(at != std::string::npos);
  for (const char* again : {"\"feature\":true,", "\"f\\u0065ature\":true,"}) {
    std::ofstream(dir / "b.json") << std::string(text).insert(at, again);
    CHECK_THROWS_WITH(prepare(ResultShape{dir / "b.json"}), Catch::Contains("the object has this member twice"));
  }
}
