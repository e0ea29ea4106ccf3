// Trials of the campaign's families as tests: each family has its seeds from 0 on, or those of CNRG_SEEDS.
#pragma once

#include <algorithm>
#include <map>
#include <string>

#include "tests/campaign/families/families.h"
#include "tests/catch.h"
#include "tests/scenes/seeds.h"

namespace cnrg::campaign {

using Trials = std::map<std::string, std::uint64_t>;  ///< by family

/// How many, by the file that has them.
inline const std::map<std::string, Trials> kTrials{
    {"brute force",
     {{"cubes", 1900},
      {"cubes-mapped", 400},
      {"cube-trees", 360},
      {"cube-trees-mapped", 90},
      {"betti-grids", 30},
      {"betti-scenes", 30}}},
    {"Nef", {{"nef-booleans", 400}, {"nef-soups", 108}, {"nef-trees", 160}, {"nef-curved", 30}}},
    {"trees",
     {{"laws", 600},
      {"permuted", 100},
      {"moved", 100},
      {"folded", 30},
      {"transforms", 30},
      {"joined", 50},
      {"snapped", 40},
      {"joined-dags", 60}}},
    {"curved trees", {{"curved-trees", 550}}},
    {"contexts", {{"contexts", 400}}},
    {"places and volumes",
     {{"places", 30},
      {"echoes-places", 30},
      {"places-planes", 30},
      {"volumes-boxes", 30},
      {"echoes-boxes", 30},
      {"volumes-solids", 30},
      {"echoes-nested", 30}}}};

/// Trials of one family up to the first that fails, which is made smaller.
inline void check_trials(const Family& family, std::uint64_t usual) {
  const auto [first, last] = scenes::seeds(usual);
  std::uint64_t unknown = 0;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    const Outcome outcome = family.trial(seed);
    if (outcome.verdict == Verdict::unknown) ++unknown;
    if (outcome.verdict == Verdict::right || outcome.verdict == Verdict::unknown) {
      SUCCEED();
      continue;
    }
    const Shrunk least = family.shrink(seed, judge, [](const Shrunk&) {});
    FAIL_CHECK("tests/campaign/run --family " << family.name() << " --seed " << seed << ": " << outcome.message
                                              << "\nshrunk: " << least.outcome.message << "\n"
                                              << least.text);
    return;  // making cases smaller takes long
  }
  INFO(family.name() << ": the oracle itself failed");
  CHECK(unknown <= 1 + (last - first) / 50);
}

/// Those of all families of a file.
inline void check_trials(const std::string& file) {
  const Families families = every_family();
  for (const auto& [name, count] : kTrials.at(file)) {
    const auto family =
        std::find_if(families.begin(), families.end(), [&](const auto& f) { return f->name() == name; });
    REQUIRE(family != families.end());
    check_trials(**family, count);
  }
}

}  // namespace cnrg::campaign
