// A node means the same wherever it stands: the same node alone and in random contexts (tests/oracles/contexts.h).
#include "tests/oracles/contexts.h"

#include <array>
#include <iostream>
#include <utility>

#include "csg/evaluate/evaluate.h"
#include "csg/tree/tree.h"
#include "tests/catch.h"
#include "tests/scenes/seeds.h"

namespace cnrg::properties {
namespace {

/// The smallest case that `smaller` leads to that still fails, and how it fails.
template <class FailureOf>
std::pair<ContextCase, std::string> shrunk(ContextCase drawn, std::string failure, const FailureOf& failure_of) {
  for (bool progress = true; progress;) {
    progress = false;
    for (ContextCase& less : smaller(drawn)) {
      std::string why;
      try {
        why = failure_of(less);
      } catch (const std::exception&) {
        continue;
      }
      if (why.empty()) continue;
      drawn = std::move(less), failure = std::move(why);
      progress = true;
      break;
    }
  }
  return {drawn, failure};
}

TEST_CASE("A node is the same in every context", "[contexts]") {
  const auto [first, last] = scenes::seeds(400);
  // Boundaries of blends, warnings of what was moved, a block partly under its surface, points that removed leaves
  // leave on faces, a curve that runs in a plane for a part of its way, a border that another leaf has, too, lines
  // that depend on which leaf is asked first, lines in common that were moved.
  std::vector<std::uint64_t> drawn_seeds{200892, 301096,  301487,  304324,  304377,  304769,  210434,
                                         303314, 413068,  428121,  407239,  415500,  425159,  809603,
                                         822555, 1202016, 1200823, 1302314, 1202594, 1201315, 1300155};
  for (std::uint64_t seed = first; seed < last; ++seed) drawn_seeds.push_back(seed);
  for (const std::uint64_t seed : drawn_seeds) {
    const ContextCase drawn = random_context_case(seed);
    INFO("seed " << seed);
    const std::string failure = context_failure(drawn);
    if (failure.empty()) {
      SUCCEED();
      continue;
    }
    const auto [least, why] = shrunk(drawn, failure, context_failure);
    FAIL_CHECK(failure << "\nshrunk: " << why << "\n" << text_of(least));
  }
}

/// Of the result of a tree with these nodes: its cells and exact volume.
std::pair<std::array<std::size_t, 4>, Rational> told_of(const std::string& nodes, const std::string& result) {
  const Evaluation evaluation =
      evaluate(parse_tree("cnrg: 1\nnodes:\n" + nodes + "result: " + result + "\n", "t"));
  for (const NodeRow* const row : evaluation.all_rows())
    if (row->name == result) return {row->cells, row->total.value()};
  throw InputError("no row of " + result);
}

TEST_CASE("Curved leaves that were moved and scaled together are drawn and proven as before", "[contexts]") {
  // Much of it is not proven within the budget: where the steps end must not depend on the place.
  const std::string ring =
      "  a: {torus: {center: [1, 0, 0], axis: [0, 1, 0], radius: 2, tube: 1/2, segments: 6, rings: 6}}\n"
      "  b: {cylinder: {from: [1, 0, 0], to: [1, 1, 0], radius: 2, segments: 6}}\n"
      "  c: {cylinder: {from: [1, -1, 0], to: [1, 0, 0], radius: 5/2, segments: 8}}\n"
      "  n: {difference: [c, a, b]}\n";
  const std::string balls =
      "  a: {sphere: {center: [1/3, 0, 1], radius: 1, segments: 7}}\n"
      "  b: {sphere: {center: [1/3, 0, 1/2], radius: 1/2, segments: 5}}\n"
      "  c: {cylinder: {from: [0, 0, 0], to: [3, 0, 0], radius: 1, segments: 9}, translate: [0, 0, 1]}\n"
      "  n: {union: [{difference: [a, b]}, c]}\n";
  const std::pair<const char*, int> moves[] = {
      {"mirror: {normal: [1, 2, -1], point: [0, 1, 0]}, scale: 3", 3},
      {"rotate: {axis: [1, 2, 3], degrees: 37}, translate: [50, 1/3, 0]", 1},
      {"scale: -1, mirror: {normal: [1, 1, 0]}", 1},
      {"scale: 2, rotate: {axis: [0, 0, 1], degrees: 90}", 2},
  };
  for (const std::string& nodes : {ring, balls}) {
    const auto [cells, volume] = told_of(nodes, "n");
    for (const auto& [move, scale] : moves) {
      INFO(nodes << move);
      const auto [there, moved] = told_of(nodes + "  m: {simplify: n, " + move + "}\n", "m");
      CHECK(there == cells);
      CHECK(moved == scale * scale * scale * volume);
    }
  }
}

}  // namespace

// CNRG_SEEDS and CNRG_FIRST_SEED say how many; known disagreements count, too.
TEST_CASE("Aspects in contexts, counted", "[.hunt]") {
  const auto [first, last] = scenes::seeds(200);
  const char* const least_of = std::getenv("CNRG_SHRINK");
  std::map<std::string, std::size_t> refused, contexts;
  std::map<std::string, std::map<std::string, std::vector<std::uint64_t>>> failures;  // by aspect, by setting
  for (std::uint64_t seed = first; seed < last; ++seed) {
    const ContextCase drawn = random_context_case(seed);
    std::map<std::size_t, Disagreements> all;
    try {
      all = disagreements(drawn);
    } catch (const InputError& error) {
      std::string why = error.what();
      why = why.substr(why.find("error: ") + 7, 60);
      ++refused[why];
      continue;
    } catch (const std::exception& error) {
      std::cout << "seed " << seed << " thrown: " << error.what() << "\n" << text_of(drawn) << std::endl;
      continue;
    }
    for (std::size_t i = 0; i < drawn.contexts.size(); ++i) {
      const std::string setting = kSettings[std::size_t(drawn.contexts[i].setting)];
      if (!all.contains(i)) {
        ++refused["context " + setting];
        continue;
      }
      ++contexts[setting];
      const std::string alone = text_alone(drawn);
      std::string kind;
      for (const char* const word :
           {"sphere", "cylinder", "cone:", "torus", "revolve", "extrude", "bezier", "bspline", "coons"})
        if (alone.find(word) != std::string::npos) kind = " CURVED";
      for (const char* const word : {"halfspace", "plane:", "complement"})
        if (alone.find(word) != std::string::npos) kind += " UNBOUNDED", kind = kind.substr(0, 17);
      for (const auto& disagreement : all[i]) {
        const std::string &aspect = disagreement.first, &words = disagreement.second;
        auto& seeds = failures[aspect + kind][setting];
        if (std::getenv("CNRG_FLAT") && !kind.empty()) continue;
        seeds.push_back(seed);
        if (least_of != nullptr && aspect.starts_with(least_of)) {
          const auto failure_of = [&](const ContextCase& c) -> std::string {
            for (const auto& [k, found] : disagreements(c))
              if (const auto it = found.find(aspect); it != found.end()) return it->second;
            return {};
          };
          const auto [least, why] = shrunk(drawn, words, failure_of);
          std::cout << "---- seed " << seed << " " << setting << " " << aspect << ": " << why << "\n"
                    << text_of(least) << std::endl;
        }
      }
    }
  }
  std::cout << "refused:\n";
  for (const auto& [why, count] : refused) std::cout << "  " << count << " " << why << "\n";
  std::cout << "contexts:\n";
  for (const auto& [setting, count] : contexts) std::cout << "  " << count << " " << setting << "\n";
  for (const auto& [aspect, by] : failures) {
    std::cout << aspect << ":";
    for (const auto& [setting, seeds] : by) {
      std::cout << " " << setting << " " << seeds.size() << " (";
      for (std::size_t i = 0; i < std::min<std::size_t>(seeds.size(), 4); ++i)
        std::cout << (i ? " " : "") << seeds[i];
      std::cout << ")";
    }
    std::cout << "\n";
  }
}

}  // namespace cnrg::properties
