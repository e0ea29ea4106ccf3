// The pictures of the stages: counts beside those of the exact complex, the result beside that of the plain run,
// the program as its users have it.
#include "bench/baseline/steps.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>

#include "bench/baseline/scene.h"
#include "bench/baseline/steps_tree.h"
#include "bench/cases/soup_of.h"
#include "bench/cases/tree_problem.h"
#include "kernel/refine/refine.h"
#include "tests/app/program.h"
#include "tests/baseline/oracle.h"
#include "tests/baseline/shapes.h"
#include "tests/catch.h"
#include "tests/scenes/seeds.h"

namespace cnrg::bench::baseline_test {
namespace {

using Catch::Contains;
using mantyla::Drawing;
using mantyla::Stage;
using mantyla::Steps;

const Operation kOperations[] = {Operation::unite, Operation::intersect, Operation::subtract};

Steps steps_by(const std::string& system, const Model& a, const Model& b, Operation operation) {
  return mantyla::steps_of(a, b, operation, mantyla::parse_variant(system).value());
}

/// Where two boundaries in general position cross, by their common refinement: its edges with four faces.
struct Meeting {
  std::set<RationalPoint> vertices;
  std::size_t loops = 0;
};

Meeting meeting_of(const Model& a, const Model& b) {
  Soup soup;
  add_model(soup, a);
  add_model(soup, b);
  const auto built = build_complex(soup, {.threads = 1}, nullptr);
  const Complex& complex = *built;
  std::map<RationalPoint, RationalPoint> parent;
  const auto root = [&](RationalPoint p) {
    while (parent.emplace(p, p).first->second != p) p = parent[p];
    return p;
  };
  Meeting meeting;
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    const cnrg::EdgeId edge(e);
    if (complex.edge_uses[edge].size() != 4) continue;
    const auto [v, w] = complex.edge_ends[edge];
    const RationalPoint p = complex.points.rational(v), q = complex.points.rational(w);
    meeting.vertices.insert({p, q});
    parent[root(p)] = root(q);
  }
  for (const RationalPoint& p : meeting.vertices) meeting.loops += root(p) == p;
  return meeting;
}

std::set<RationalPoint> points_of(const mantyla::Step& step, const std::string& prefix = "") {
  std::set<RationalPoint> points;
  for (const Drawing& drawing : step.drawings)
    if (drawing.name.starts_with(prefix))
      for (const std::uint32_t p : drawing.model.isolated) points.insert(drawing.model.points[p]);
  return points;
}

const mantyla::Step& step_called(const Steps& steps, const std::string& name) {
  const auto found =
      std::find_if(steps.steps.begin(), steps.steps.end(), [&](const auto& step) { return step.name == name; });
  REQUIRE(found != steps.steps.end());
  return *found;
}

std::size_t lines_of(const mantyla::Step& step) {
  std::size_t count = 0;
  for (const Drawing& drawing : step.drawings) count += drawing.model.wires.size();
  return count;
}

mantyla::Boundary<Rational> boundary_of(const Model& model) {
  const auto scene = mantyla::read_operands<Rational>(model, model, Operation::unite, 0, {});
  return scene.boundaries[0];
}

bool same_models(const Model& a, const Model& b) {
  if (a.points != b.points || a.faces.size() != b.faces.size()) return false;
  for (std::size_t f = 0; f < a.faces.size(); ++f)
    if (a.faces[f].loops != b.faces[f].loops) return false;
  return true;
}

NodeId node_with(const Tree& tree, const std::string& part) {
  for (std::size_t i = 0; i < tree.nodes.size(); ++i)
    if (tree.nodes[NodeId(i)].name.find(part) != std::string::npos) return NodeId(i);
  FAIL("no node with " << part);
  return NodeId();
}

}  // namespace

TEST_CASE("contacts, null edges and loops of random pairs are those of the exact complex") {
  const auto [first, last] = scenes::seeds(60);
  int meet = 0;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    Random random(static_cast<unsigned>(seed));
    const Model a = random_solid(random), b = random_solid(random);
    const Meeting meeting = meeting_of(a, b);
    meet += meeting.loops > 0;
    for (const Operation operation : kOperations) {
      INFO("seed " << seed << ", " << to_string(operation));
      const Steps steps = steps_by("mantyla-exact", a, b, operation);
      REQUIRE_FALSE(steps.failure);
      CHECK(steps.counts.contacts == meeting.vertices.size());
      CHECK(steps.counts.crossings == meeting.vertices.size());
      CHECK(steps.counts.null_pairs == meeting.vertices.size());
      CHECK(steps.counts.loops == meeting.loops);
      CHECK(points_of(step_called(steps, "reduction")) == meeting.vertices);
      CHECK(points_of(step_called(steps, "null edges"), "pair") == meeting.vertices);
      CHECK(lines_of(step_called(steps, "loops")) == meeting.vertices.size());
      CHECK(same_models(steps.result, mantyla::boolean_exact(a, b, operation)));
      const Steps rounded = steps_by("mantyla-double", a, b, operation);
      CHECK(rounded.counts.null_pairs == meeting.vertices.size());
      CHECK(rounded.counts.loops == meeting.loops);
      CHECK(same_models(rounded.result, mantyla::boolean_double(a, b, operation)));
    }
  }
  if (last - first >= 60) CHECK(meet > 20);
}

TEST_CASE("the sides of sectors are those of the exact sets") {
  // A sample of each triangle of A, pushed nowhere: it is on A's boundary, and inside of B, outside of it or on
  // it.
  const auto [first, last] = scenes::seeds(40);
  int on = 0, in = 0;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    Random random(static_cast<unsigned>(seed));
    const bool touching = seed % 2 == 0;
    const Model a = touching ? random_grid_solid(random) : random_solid(random);
    const Model b = touching ? random_grid_solid(random) : random_solid(random);
    INFO("seed " << seed);
    const Steps steps = steps_by("mantyla-exact", a, b, Operation::unite);
    REQUIRE_FALSE(steps.failure);
    for (const bool of_a : {true, false}) {
      const auto boundary = boundary_of(of_a ? b : a);
      for (const Drawing& drawing : step_called(steps, of_a ? "sectors of A" : "sectors of B").drawings)
        for (const Model::Face& face : drawing.model.faces) {
          RationalPoint middle = {0, 0, 0};
          for (const std::uint32_t p : face.loops[0])
            for (int k = 0; k < 3; ++k) middle[k] += drawing.model.points[p][k] / 3;
          // Towards the contact, the first corner, where only the neighbourhood counts.
          for (int k = 0; k < 3; ++k)
            middle[k] = drawing.model.points[face.loops[0][0]][k] +
                        (middle[k] - drawing.model.points[face.loops[0][0]][k]) / 1000;
          mantyla::Vec<Rational> normal;
          const mantyla::Side side = mantyla::locate_point(mantyla::Metric<Rational>(), boundary,
                                                           {middle[0], middle[1], middle[2]}, normal);
          INFO(drawing.name);
          if (drawing.name.starts_with("on")) CHECK(side == mantyla::Side::on);
          else if (drawing.name.starts_with("in")) CHECK(side == mantyla::Side::in);
          else if (drawing.name.starts_with("out")) CHECK(side == mantyla::Side::out);
          else CHECK(side != mantyla::Side::on);
          on += side == mantyla::Side::on;
          in += side == mantyla::Side::in;
        }
    }
  }
  CHECK(on > 0);
  CHECK(in > 0);
}

TEST_CASE("the tree of the steps has the result and the exact one") {
  const Model a = box({0, 0, 0}, {2, 2, 2});
  for (const Model& b : {box({1, 1, 1}, {3, 3, 3}), box({1, 0, 0}, {3, 1, 2}), box({5, 0, 0}, {6, 1, 1})})
    for (const Operation operation : kOperations) {
      const Steps steps = steps_by("mantyla-exact", a, b, operation);
      REQUIRE_FALSE(steps.failure);
      const Tree tree = parse_tree(
          mantyla::steps_tree(a, b, operation, steps, {"mantyla-exact", "same", true, false}), "steps.yaml");
      for (const char* node : {"8 result", "9 exact"}) {
        const NodeId id = node_with(tree, node);
        CHECK(truth_of(a, b, operation, tree_model(tree, id, id)).same_set);
      }
    }
}

TEST_CASE("where a stage fails is a contact of the operands") {
  const auto [first, last] = scenes::seeds(150);
  std::map<Stage, int> failures;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    Random random(static_cast<unsigned>(seed));
    const Model a = random_grid_solid(random), b = random_grid_solid(random);
    for (const char* system : {"mantyla-published-exact+shells", "mantyla-published-exact+shells+checks"})
      for (const Operation operation : kOperations) {
        const Steps steps = steps_by(system, a, b, operation);
        if (!steps.failure) continue;
        INFO("seed " << seed << ", " << system << ": " << steps.failure->what());
        ++failures[steps.failure->stage()];
        if (steps.failure->stage() != Stage::output) CHECK_FALSE(steps.failure->places().empty());
        const std::set<RationalPoint> contacts = points_of(step_called(steps, "reduction"));
        if (steps.failure->stage() < Stage::output)
          for (const RationalPoint& p : steps.failure->places()) CHECK(contacts.contains(p));
        const std::string text = mantyla::steps_tree(a, b, operation, steps, {system, "refused", false, false});
        const Tree tree = parse_tree(text, "steps.yaml");
        node_with(tree, std::string("failed in ") + to_string(steps.failure->stage()));
        CHECK_THAT(text, Contains(steps.failure->what()));
      }
  }
  for (const Stage stage : {Stage::classification, Stage::connecting, Stage::finishing}) {
    INFO(to_string(stage));
    CHECK(failures[stage] > 0);
  }
}

TEST_CASE("a vertex that crosses a boundary where that touches itself is the place of the failure") {
  const Model pair =
      mantyla::boolean_exact(box({0, 0, 0}, {2, 2, 2}), box({2, 2, 2}, {4, 4, 4}), Operation::unite);
  const Steps steps = steps_by("mantyla-exact", pair, box({0, 0, 2}, {2, 3, 3}), Operation::unite);
  REQUIRE(steps.failure);
  CHECK(steps.failure->stage() == Stage::null_edges);
  CHECK(steps.failure->places() == std::vector<RationalPoint>{{2, 2, 2}});
}

TEST_CASE("an operand that is no solid fails in its stage") {
  Model open = box({0, 0, 0}, {1, 1, 1});
  open.faces.pop_back();
  const Steps steps = steps_by("mantyla-published", open, box({0, 0, 0}, {1, 1, 1}), Operation::unite);
  REQUIRE(steps.failure);
  CHECK(steps.failure->stage() == Stage::input);
  CHECK(steps.steps.empty());
}

TEST_CASE("the program shows the table of lesson 10, and refuses what it cannot read") {
  const Workshop w;
  const std::filesystem::path lesson =
      std::filesystem::path(CNRG_SOURCES) / "papers" / "lessons" / "10-manifold-booleans";
  std::ifstream stream(lesson / "README.md");
  const std::string page{std::istreambuf_iterator<char>(stream), {}};
  const std::string notches = (lesson / "notches.yaml").string();
  for (const char* system : {"mantyla-published", "mantyla-exact"}) {
    const Outcome o = w.run("'" + notches + "' --system " + system + " --tree steps.yaml");
    CHECK(o.status == 0);
    CHECK(o.err == "");
    const bool published = std::string(system) == "mantyla-published";
    CHECK_THAT(published ? page : o.out, Contains(published ? o.out : "verdict         contact-duplicated\n"));
    CHECK_THAT(w.read("steps.yaml"), Contains("9 exact: {difference: [A, B]"));
  }
  const std::map<std::string, std::string> refused = {
      {"none.off '" + notches + "'", "there is no file 'none.off'"},
      {"'" + notches + "' --operation union", "--operation is for two files"},
      {"'" + notches + "' '" + notches + "' --operation sum", "'sum' is no operation"},
      {"'" + notches + "' '" + notches + "' --node rest", "--node is for one tree"},
      {"'" + notches + "' --node none", "has no node called `none`"},
      {"'" + (lesson / "near.yaml").string() + "' --node edge", "has 3 operands"},
      {"'" + notches + "' --system mantyla", "'mantyla' is no variant"},
      {"'" + notches + "' --tree none/steps.yaml", "cannot be written"},
      {"", "FILES is required"}};
  for (const auto& [words, message] : refused) {
    const Outcome o = w.run(words);
    INFO(words << ": " << o.err);
    CHECK(o.status == 2);
    CHECK_THAT(o.err, Catch::StartsWith("bench/run mantyla: error: ") && Contains(message));
    CHECK(std::count(o.err.begin(), o.err.end(), '\n') == 1);
  }
}

TEST_CASE("bad meshes are refused, and operands that take too long are given up") {
  const Workshop w;
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n", sides = "3 0 2 1\n3 0 1 3\n3 1 2 3\n";
  const auto tetrahedron = [&](const std::string& at, const std::string& faces, int count) {
    return "OFF\n4 " + std::to_string(count) + " 0\n" + at + faces;
  };
  const auto scaled = [&](const std::string& unit) {
    return tetrahedron(std::regex_replace(points, std::regex("1"), unit), sides + "3 2 0 3\n", 4);
  };
  w.write("good.off", scaled("1"));
  w.write("open.off", tetrahedron(points, sides, 3));
  w.write("turned.off", tetrahedron(points, sides + "3 0 2 3\n", 4));
  w.write("thrice.off", tetrahedron(points, sides + sides + sides + "3 2 0 3\n", 10));
  w.write("huge.off", scaled("1e300"));
  w.write("tiny.off", scaled("1e-300"));
  w.write("none.off", tetrahedron("nan 0 0\n1 0 0\n0 1 0\n0 0 1\n", sides, 3));
  for (const std::string name : {"open", "turned", "thrice", "huge"})
    for (const char* system : {"mantyla-published", "mantyla-double", "mantyla-exact"}) {
      const Outcome o = w.run(name + ".off good.off --system " + system + " --tree steps.yaml");
      INFO(name << ", " << system << ": " << o.out << o.err);
      CHECK(o.status == 0);
      CHECK_THAT(o.out, Contains("verdict         refused in input: "));
    }
  const Outcome tiny = w.run("tiny.off good.off --system mantyla-exact --tree steps.yaml");
  CHECK_THAT(tiny.out, Contains("verdict         same\n"));
  CHECK(w.run("none.off good.off").err.find("none.off:3: error: 'nan' is no finite number") != std::string::npos);

  w.write("balls.yaml",
          "cnrg: 1\nnodes:\n  a: {sphere: {center: [0, 0, 0], radius: 1, segments: 512}}\n"
          "  b: {sphere: {center: [1/2, 1/3, 1/5], radius: 1, segments: 512}}\n  m: {union: [a, b]}\nresult: m\n");
  const std::string more = ": --seconds and --gigabytes give it more, or take smaller operands\n";
  const Outcome slow = w.run("balls.yaml --seconds 0.1 --tree balls-steps.yaml");
  CHECK(slow.err == "bench/run mantyla: error: no result in 0.1 s" + more);
  const Outcome large = w.run("balls.yaml --gigabytes 0.1 --tree balls-steps.yaml");
  CHECK(large.err == "bench/run mantyla: error: memory ran out" + more);
  for (const Outcome* o : {&slow, &large}) {
    CHECK(o->status == 2);
    CHECK(o->out.empty());
  }
  CHECK_FALSE(std::filesystem::exists(w.path("balls-steps.yaml")));
}

}  // namespace cnrg::bench::baseline_test
