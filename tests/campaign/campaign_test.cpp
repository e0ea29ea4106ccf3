// A fixed small part of the campaign, and the campaign itself: what crashes, hangs or is wrong is found, counted,
// made smaller, and a run that is killed goes on where it was.
#include <catch2/catch.hpp>

#include "tests/campaign/families/families.h"

namespace cnrg::campaign {
TEST_CASE("The first trials of every family are right", "[campaign]") {
  for (const auto& family : every_family()) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      INFO("tests/campaign/run --family " << family->name() << " --seed " << seed);
      const Outcome outcome = family->trial(seed);
      CHECK(outcome.message == "");
      CHECK(outcome.verdict == Verdict::right);
    }
  }
}
}  // namespace cnrg::campaign
