// Experiments: files, their problems, what is claimed of them, and sweeps of them.
#include "bench/sweep/experiment.h"

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "bench/cases/tree_problem.h"
#include "bench/sweep/judge.h"
#include "bench/sweep/keep.h"
#include "csg/evaluate/evaluate.h"
#include "kernel/base/error.h"
#include "tests/app/program.h"
#include "tests/catch.h"
#include "tests/oracles/dag.h"
#include "tests/scenes/seeds.h"
#include "tests/sweep/models.h"

namespace cnrg::bench {
namespace {

namespace fs = std::filesystem;
using Catch::Contains;
using Json = nlohmann::json;

const std::string kTree =
    "cnrg: 1\nparameters: {n: 2, k: 0, d: 10^-k}\nnodes:\n  block: {box: {min: [0, 0, 0], max: [4, 4, 1]}}\n"
    "  pegs: {repeat: {of: {box: {min: [\"${2*i}\", 0, \"${1 - d}\"], max: [\"${2*i + 1}\", 1, 2]}}, count: "
    "\"${n}\", "
    "index: i}}\n  model: {union: [block, pegs]}\n  less: {difference: [model, {union: [pegs, pegs]}]}\n"
    "  moved: {union: [block, pegs], translate: [1, 0, 0]}\n  other: {intersection: [{difference: [{union: "
    "[block, "
    "pegs]}, block]}, model]}\nresult: model\n";

std::vector<Experiment> read_all(const Workshop& w, const std::string& text,
                                 const std::vector<std::string>& given = {}) {
  w.write("mine.yaml", text);
  std::vector<GivenValues> values;
  for (const std::string& one : given) values.push_back(given_values(one));
  std::set<std::string> used;
  return read_experiments(w.path("mine.yaml").string(), values, used);
}

Experiment read(const Workshop& w, const std::string& text, const std::vector<std::string>& given = {}) {
  return read_all(w, text, given).at(0);
}

std::string fault(const std::string& text) {
  const Workshop w;
  try {
    for (const Experiment& e : read_all(w, text))
      for (const Experiment::Named& problem : e.problems()) e.check(problem);
  } catch (const std::runtime_error& error) {
    const std::string said = error.what(), folder = w.path("").string();
    return said.starts_with(folder) ? said.substr(folder.size()) : said;
  }
  return {};
}

std::vector<std::string> names_of(const Experiment& e) {
  std::vector<std::string> names;
  for (const Experiment::Named& problem : e.problems()) names.push_back(problem.name);
  return names;
}

}  // namespace

TEST_CASE("problems are nodes by values of parameters", "[experiments]") {
  const Workshop w;
  const std::string head = kTree + "x-experiment:\n  title: pegs\n  nodes: [model, less]\n";
  const Experiment e = read(w, head + "  values: {n: [1, 3..4], k: {values: [1/2, -1], means: how far}}\n");
  const std::vector<std::string> names = names_of(e);
  REQUIRE(names.size() == 12);
  CHECK(names[0] == "mine-model-n1-k1_2");
  CHECK(names[11] == "mine-less-n4-k-1");
  CHECK(e.parameter("k")->means == "how far");
  CHECK(names_of(read(w, head + "  values: {n: 1..3, k: 0}\n", {"n=7,1e1"})) ==
        std::vector<std::string>{"mine-model-n7-k0", "mine-model-n10-k0", "mine-less-n7-k0", "mine-less-n10-k0"});
  // A tree alone: each of its Booleans that other systems have.
  CHECK(names_of(read(w, kTree)) ==
        std::vector<std::string>{"mine-pegs", "mine-model", "mine-less", "mine-other"});
}

TEST_CASE("nodes of any operator are compared as sets and by regions", "[experiments]") {
  const Workshop w;
  const std::string tree =
      "cnrg: 1\nnodes:\n  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n  open: {interior: a}\n"
      "  m: {union: [a, {closure: open}]}\nresult: m\n";
  const auto names = [&](const std::string& more) {
    std::vector<std::string> all;
    for (const Experiment& e : read_all(w, tree + more))
      for (const std::string& name : names_of(e)) all.push_back(name);
    return all;
  };
  using Names = std::vector<std::string>;
  CHECK(names("") == Names{"mine-m", "mine.sets-open", "mine.sets-m", "mine.sets-m+2", "mine.regions-open",
                           "mine.regions-m", "mine.regions-m+2"});
  const std::string head = "x-experiment: {title: t, nodes: ";
  CHECK(names(head + "all}\n") == Names{"mine-m"});
  CHECK(names(head + "open, compare: sets}\n") == Names{"mine.sets-open"});
  CHECK(names(head + "m, compare: [regions, results]}\n") == Names{"mine.regions-m", "mine-m"});
  const auto faults = [&](const std::string& experiment) { return fault(tree + head + experiment); };
  CHECK_THAT(faults("open}"), Contains("`open` is no union, intersection or difference alone"));
  CHECK_THAT(faults("a, compare: sets}"), Contains("`a` is a leaf, which systems are given"));
  CHECK_THAT(faults("m, compare: marks}"), Contains("results, sets, regions or several of them"));
  CHECK_THAT(faults("m, compare: [sets, sets]}"), Contains("has sets twice"));
  CHECK_THAT(faults("m, compare: sets, truth: {m: {volume: 1}}}"), Contains("a truth is one of results"));
  CHECK_THAT(fault("cnrg: 1\nx-experiment: {title: t, family: face, compare: sets}\n"),
             Contains("of a family results are compared"));
}

TEST_CASE("a node is a fold: inline operands are steps of it", "[experiments]") {
  const Workshop w;
  const Experiment e = read(w, kTree);
  const auto steps = [&](std::size_t i) {
    std::string text;
    for (const Operation step : e.make(e.problems()[i]).steps) text += std::string(to_string(step)) + " ";
    return text;
  };
  CHECK(steps(1) == "union ");
  CHECK(steps(2) == "difference difference ");          // a union behind is more operands
  CHECK(steps(3) == "union difference intersection ");  // a Boolean before is the beginning
  CHECK(e.make(e.problems()[2]).operands.size() == 3);
  CHECK(e.roles(e.problems()[0]).size == -1);
}

TEST_CASE("a node of any random tree is the fold of its operands", "[experiments]") {
  int compared = 0, open = 0;
  const auto [first, last] = scenes::seeds(60);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    const auto position = seed % 2 == 0 ? scenes::Position::degenerate : scenes::Position::general;
    const std::string text = properties::tree_file(properties::random_dag(seed, position));
    const Tree tree = parse_tree(text, "random.yaml");
    for (const NodeId id : IdRange<NodeId>(tree.nodes.size())) {
      if (!is_tree_problem(tree, id)) continue;
      INFO("seed " << seed << ", node " << tree.nodes[id].name << "\n" << text);
      Problem problem;
      try {
        problem = tree_problem(tree, id);
      } catch (const InputError& error) {
        CHECK_THAT(error.what(), Contains("is open or unbounded"));
        CHECK_THROWS_AS(check_tree_problem(tree, id), InputError);
        ++open;
        continue;
      }
      const Verdict verdict = judge(problem, tree_model(tree, id, id), 0).verdict;
      CHECK((verdict == Verdict::same || verdict == Verdict::contact_duplicated));
      ++compared;
    }
  }
  CHECK(compared > 40);
  CHECK(open > 0);
}

TEST_CASE("operands have the surfaces that leaves have in common", "[experiments]") {
  // A shaft of other facets in its bore: alone each would be drawn otherwise, and gaps would stay.
  const Tree tree = parse_tree(
      "cnrg: 1\nnodes:\n  rock: {box: {min: [-2, -2, 0], max: [2, 2, 4]}}\n"
      "  bore: {cylinder: {from: [0, 0, 0], to: [0, 0, 4], radius: 1, segments: 32}}\n  plate: {difference: "
      "[rock, bore]}\n"
      "  shaft: {cylinder: {from: [0, 0, 0], to: [0, 0, 4], radius: 1, segments: 24}}\n  m: {union: [plate, "
      "shaft]}\n"
      "  open: {interior: rock}\nresult: m\n",
      "shaft.yaml");
  const Problem problem = tree_problem(tree, tree.find("m"));
  CHECK(exact_facts(problem).volume == "64");
  CHECK(judge(problem, tree_model(tree, tree.find("rock"), tree.find("m")), 0).verdict == Verdict::same);
  CHECK_THROWS_WITH(tree_model(tree, tree.find("open"), tree.find("m")), Contains("`open` is open or unbounded"));
  // Two boxes that overlap as one mesh, whose faces cross: a claim is about its point set.
  const Tree mesh = parse_tree(
      "cnrg: 1\nnodes:\n  a: {box: {min: [0, 0, 0], max: [2, 1, 1]}}\n  b: {box: {min: [1, 0, 0], max: [3, 1, "
      "1]}}\n"
      "  m: {union: [a, b]}\n  holed: {difference: [{box: {min: [0, 0, 0], max: [3, 3, 3]}}, {box: {min: [1, 1, "
      "-1], max: "
      "[2, 2, 4]}}]}\n  more: {union: [holed, a]}\nresult: m\n",
      "mesh.yaml");
  CHECK(exact_facts(tree_problem(mesh, mesh.find("more"))).volume == "24");
}

TEST_CASE("a notch that is deeper than rounding is wrong, however small its volume", "[sweep]") {
  const Rational depth = Rational(1) / 10000;
  const Model block = box({-1, -1, -1}, {1, 1, 0}),
              cut = box({-depth / 100, -depth / 100, -depth}, {depth / 100, depth / 100, 1});
  Problem problem;
  problem.operands = {block, cut};
  problem.steps = {Operation::subtract};
  const Judgement j = judge(problem, block, 1e-12);
  CHECK(j.verdict == Verdict::wrong);
  CHECK_THAT(j.message, Contains("thicker than rounding explains"));
  problem.operands[1] = box({-1, -1, -Rational(1) / 1'000'000'000'000}, {1, 1, 1});
  CHECK(judge(problem, block, 1e-12).verdict == Verdict::same);
}

TEST_CASE("faults of experiments have a place and a remedy", "[experiments]") {
  const auto with = [](const std::string& own) {
    return fault(kTree + "x-experiment: {title: t, " + own + "}\n");
  };
  CHECK(with("values: {n: 1..3}") == "");
  CHECK_THAT(with("nodes: modl"),
             Contains("mine.yaml:11:33") && Contains("no node called `modl`; did you mean `model`?"));
  CHECK_THAT(with("values: {m: 1}"), Contains("the parameter `m`: ") && Contains("has no such one"));
  CHECK_THAT(with("values: {n: [1, 2/2]}"), Contains("mine.yaml:11:") && Contains("has 1 twice"));
  CHECK_THAT(with("values: {n: 3..1}"), Contains("mine.yaml:11:") && Contains("is no range"));
  CHECK_THAT(with("values: {n: 1..k}"), Contains("mine.yaml:11:") && Contains("there is no parameter `k`"));
  CHECK_THAT(with("values: {n: 1-3}"), Contains("`1-3` is -2; a range is written 1..3"));
  CHECK_THAT(with("values: {n: word}"), Contains("there is no parameter `word`"));
  CHECK_THAT(with("nodes: moved"), Contains("is no union, intersection or difference alone"));
  CHECK_THAT(with("family: turned"), Contains("give one of them"));
  CHECK_THAT(with("runs: 0"), Contains("`runs` of x-experiment must be a whole number from 1 to 1000"));
  CHECK_THAT(with("seconds: 0"), Contains("is from 0.01"));
  CHECK_THAT(with("growth: size"), Contains("where there is a parameter `size`"));
  CHECK_THAT(with("truth: {other: {volume: 1}}"), Contains("`other` is no node of this experiment"));
  CHECK_THAT(with("truth: {model: {}}"), Contains("one of them"));
  CHECK_THAT(with("truth: {model: {volume: 2*m}}"),
             Contains("mine.yaml:11:") && Contains("there is no parameter `m`"));
  CHECK_THAT(with("truth: {model: {node: mdl}}"), Contains("no node called `mdl`"));
  CHECK_THAT(with("systems: [{name: me, program: ./none}]"), Contains("there is no such program"));
  CHECK_THAT(with("systems: [{name: a/b, program: /bin/true}]"), Contains("is no name of a system"));
  CHECK_THAT(with("sizes: 3"), Contains("unknown key `sizes`"));
  CHECK_THAT(fault("x-experiment: {title: t}\n"), Contains("give one of them"));
  CHECK_THAT(fault("x-experiment: {title: t, family: turnd}\n"),
             Contains("mine.yaml: no family of problems is called 'turnd'"));
  CHECK_THAT(fault("x-experiment: {title: t, family: turned, values: {n: 3}}\n"), Contains("and no `n`"));
  CHECK_THAT(fault("cnrg: 1\nnodes: {a: {points: [[0, 0, 0]]}}\nresult: a\n"),
             Contains("this tree has no operator"));
  CHECK_THAT(fault("x-experiment: {title: t, program: /bin/false, nodes: a}\n"),
             Contains("/bin/false: ended with status 1"));
  CHECK_THAT(fault("weld: 1/10\n" + kTree), Contains("mine.yaml:1:7") && Contains("other systems do not weld"));
  CHECK_THAT(fault("not yaml: ["), Contains("mine.yaml:1"));
  CHECK_THAT(fault(kTree + "x-experimnt: {title: t}\n"),
             Contains("mine.yaml:11:1") && Contains("did you mean `x-experiment`"));
  for (const char* empty : {"values: {n: []}", "program: []", "systems: [{name: a, program: []}]", "nodes: []"})
    CHECK_THAT(with(empty), Contains("is an empty list"));
  CHECK_THAT(with("values: {n: 0}"), Contains("`count` of repeat must be a whole number from 1"));
  CHECK_THAT(fault(kTree + "x-experiment: {title: t, truth: {model: {node: open}}}\n"),
             Contains("no node called `open`"));
}

TEST_CASE("a sweep of a tree: claims, warm runs, programs of the file", "[sweep]") {
  const Workshop w;
  w.write("first", "#!/bin/sh\n[ \"$1\" = --quick ] && cp \"$3\" \"$5\"\n");
  fs::permissions(w.path("first"), fs::perms::owner_all);
  w.write("mine.yaml", kTree +
                           "x-experiment:\n  title: pegs\n  nodes: [model, less, other]\n"
                           "  values: {k: [0, 20], n: 2}\n  runs: 3\n  seconds: 30\n"
                           "  systems: [ours, ours-tree, {name: first, program: [./first, --quick]}]\n"
                           "  truth: {model: {volume: 16 + n}, less: {volume: 15}, other: {node: model}}\n");
  const Outcome o = w.run("mine.yaml --out out --quiet");
  INFO(o.err);
  CHECK(o.status == 0);
  CHECK(o.out.find("6 problems: 0 of 18 rows are there") != std::string::npos);
  const auto row = [&](const std::string& problem, const std::string& system) {
    return row_of_json(w.read("out/rows/" + problem + "/" + system + ".json"));
  };
  const SweepRow ours = row("mine-model-k20-n2", "ours");
  CHECK(ours.verdict == Verdict::same);
  CHECK(ours.warm.size() == 2);
  for (const char* problem : {"mine-model-k0-n2", "mine-less-k20-n2", "mine-other-k20-n2"})
    CHECK(row(problem, "ours-tree").facts->volume == row(problem, "ours").facts->volume);
  CHECK(row("mine-other-k0-n2", "ours-tree").verdict == Verdict::same);
  CHECK(ours.values == Values{{"k", "20"}, {"n", "2"}, {"node", "model"}});
  CHECK(ours.limit_seconds == 30);
  CHECK(ours.truth.confirmed == "Nef");
  CHECK(ours.command ==
        "bench/run " + fs::canonical(w.path("mine.yaml")).string() + " --one mine-model-k20-n2 ours");
  CHECK(row("mine-model-k20-n2", "first").verdict == Verdict::wrong);  // the first operand, without the pegs
  CHECK(row("mine-model-k0-n2", "first").verdict == Verdict::wrong);
  const SweepRow less = row("mine-less-k0-n2", "ours");  // pegs from z = 0: 14 is left
  CHECK(less.truth.confirmed == "DISAGREES");
  CHECK_THAT(less.truth.reason, Contains("mine.yaml claims: the volume is 15, ours 14"));
  CHECK_THAT(row("mine-other-k20-n2", "ours").truth.reason, Contains("mine.yaml claims: too much"));
  // A program that prints trees makes the same problems.
  w.write("print", "#!/bin/sh\n[ \"$1 $2\" = \"k=20 n=2\" ] && sed 's/k: 0/k: 20/' '" +
                       w.path("mine.yaml").string() + "'\n");
  fs::permissions(w.path("print"), fs::perms::owner_all);
  w.write("printed.yaml", "x-experiment: {title: t, program: ./print, nodes: model, values: {n: 2, k: 20}}\n");
  const Outcome printed = w.run("printed.yaml --one printed-model-n2-k20 ours --keep kept");
  INFO(printed.err);
  REQUIRE(printed.status == 0);
  CHECK(Json::parse(printed.out).at("facts") == Json::parse(to_json(*ours.facts)));
  // What is kept is a tree of its own, and nothing differs.
  const Tree kept = read_tree(w.path("kept/problem.yaml").string());
  const Evaluation evaluation = evaluate(kept);
  CHECK(evaluation.rows.back().name == "differs");
  CHECK(evaluation.rows.back().cells == std::array<std::size_t, 4>{});
  for (const NodeRow& r : evaluation.rows)
    if (r.name == "exact" || r.name == "given") CHECK(cnrg::to_string(r.volume().value()) == ours.facts->volume);
}

TEST_CASE("a sweep of all nodes of random trees: sets and regions as others have them", "[sweep]") {
  const Workshop w;
  std::map<std::pair<std::string, Verdict>, int> counts;
  const auto [first, last] = scenes::seeds(2);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    const std::string name = "t" + std::to_string(seed);
    w.write(name + ".yaml", properties::tree_file(properties::random_dag(seed, scenes::Position::degenerate)) +
                                "\nx-experiment: {title: random, nodes: all, compare: [sets, regions]}\n");
    const Outcome o = w.run(name + ".yaml --out out --quiet --jobs 2 --seconds 20");
    INFO(o.err);
    REQUIRE(o.status == 0);
  }
  for (const auto& entry : fs::recursive_directory_iterator(w.path("out/rows"))) {
    if (!entry.is_regular_file() || entry.path().parent_path().filename() == "rows") continue;
    const SweepRow row = row_of_json(w.read(fs::relative(entry.path(), w.path("")).string()));
    INFO(row.command << ": " << row.message);
    CHECK(row.verdict != Verdict::wrong);
    CHECK(row.size == 0);
    ++counts[{row.family.substr(row.family.find('.')), row.verdict}];
  }
  for (const char* kind : {".sets", ".regions"}) {
    const int same = counts[{kind, Verdict::same}], refused = counts[{kind, Verdict::refused}];
    INFO(kind);
    CHECK(same > 2 * refused);
  }
  // What nobody compares is no sweep.
  CHECK_THAT(w.run("t" + std::to_string(first) + ".yaml --systems openscad --out none --quiet").err,
             Contains("none of these systems compares what the experiment asks for"));
}

TEST_CASE("what is kept can be read: holes, many steps, nothing", "[sweep]") {
  const Workshop w;
  w.write("mine.yaml",
          "cnrg: 1\nnodes:\n  holed: {difference: [{box: {min: [0, 0, 0], max: [3, 3, 3]}}, {repeat: {of: {box: "
          "{min: "
          "[\"${i + 1/4}\", 1, -1], max: [\"${i + 3/4}\", 2, 4]}}, count: 2, index: i}}]}\n"
          "  none: {intersection: [{box: {min: [0, 0, 0], max: [1, 1, 1]}}, {box: {min: [5, 0, 0], max: [6, 1, "
          "1]}}]}\n"
          "  both: {union: [none, holed]}\nresult: both\n");
  for (const std::string node : {"holed", "both", "none"}) {
    REQUIRE(w.run("mine.yaml --one mine-" + node + " ours --keep kept").status == 0);
    const Evaluation evaluation = evaluate(read_tree(w.path("kept/problem.yaml").string()));
    CHECK(evaluation.rows.back().cells == std::array<std::size_t, 4>{});
  }
  // As many steps as nothing may nest.
  Problem many;
  many.operands.assign(600, box({0, 0, 0}, {1, 1, 1}));
  many.steps.assign(599, Operation::unite);
  keep_tree(w.path("many").string(), many, std::nullopt, {});
  CHECK(read_tree(w.path("many/problem.yaml").string()).nodes.size() == 600 + 599);
}

TEST_CASE("a folder keeps apart what is not of one experiment, or has changed", "[sweep]") {
  const Workshop w;
  const auto tree = [](const std::string& node, int size) {
    return "cnrg: 1\nnodes:\n  cube: {mesh: {file: cube.off}}\n  " + node +
           ": {union: [cube, {box: {min: [0, 0, 0], max: [1, 1, " + std::to_string(size) +
           "]}}]}\nresult: " + node + "\nx-experiment: {title: t, systems: ours}\n";
  };
  const auto cube = [](const std::string& far) {
    return "OFF\n4 4 0\n0 0 0\n" + far + " 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
  };
  w.write("cube.off", cube("1"));
  w.write("a.yaml", tree("b-c", 2));
  w.write("a-b.yaml", tree("c", 11));
  CHECK_THAT(w.run("a.yaml a-b.yaml --out both").err, Contains("two experiments have a problem a-b-c"));
  REQUIRE(w.run("a.yaml --out one --quiet").status == 0);
  CHECK_THAT(w.run("a-b.yaml --out one --quiet").err,
             Contains("has the problem a-b-c of ") && Contains("by --out"));
  fs::remove(w.path("one/rows/a-b-c/ours.json"));
  w.write("cube.off", cube("2"));
  const Outcome changed = w.run("a.yaml --out one --quiet");
  CHECK(changed.status == 1);
  CHECK_THAT(changed.err, Contains("has other operands than when this sweep began"));
}

TEST_CASE("programs that say nothing readable, too much, or never end", "[sweep]") {
  const Workshop w;
  const auto program = [&](const std::string& name, const std::string& text) {
    w.write(name, "#!/bin/sh\n" + text + "\n");
    fs::permissions(w.path(name), fs::perms::owner_all);
  };
  program("latin", "printf 'Fehler: \\374bel\\n' >&2; exit 3");
  program("long", "head -c 5000000 /dev/zero | tr '\\0' x >&2; exit 3");
  program("big",
          "printf 'OFF\\n4 4 0\\n0 0 0\\n1e308 0 0\\n0 1e308 0\\n0 0 1e308\\n3 0 2 1\\n3 0 1 3\\n3 1 2 3\\n3 2 0 "
          "3\\n' > \"$4\"");
  program("hang", "sleep 50");
  std::string systems;
  for (const char* name : {"latin", "long", "big"})
    systems += std::string(", {name: ") + name + ", program: " + name + "}";
  w.write("mine.yaml", kTree + "x-experiment: {title: t, systems: [ours" + systems + "]}\n");
  const Outcome o = w.run("mine.yaml --out out --quiet");
  INFO(o.err);
  REQUIRE(o.status == 0);
  const auto row = [&](const char* system) {
    return row_of_json(w.read(std::string("out/rows/mine-model/") + system + ".json"));
  };
  CHECK(row("latin").verdict == Verdict::refused);
  CHECK(row("long").message.size() < 1100);
  CHECK(row("big").verdict == Verdict::wrong);
  w.write("hang.yaml", "x-experiment: {title: t, program: hang, nodes: model, seconds: 1, systems: ours}\n");
  CHECK_THAT(w.run("hang.yaml --out hung").err, Contains("ended without a tree"));
}

TEST_CASE("all experiments of this source can be made", "[experiments]") {
  std::set<std::string> used;
  std::size_t count = 0;
  for (const std::string& name : experiment_names()) {
    const Experiment e = read_experiments(name, {}, used).at(0);
    for (const Experiment::Named& problem : e.problems()) {
      INFO(problem.name);
      CHECK_NOTHROW(e.check(problem));
      ++count;
    }
  }
  CHECK(count > 2000);
}

}  // namespace cnrg::bench
