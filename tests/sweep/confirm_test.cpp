// Verdicts, true ones and false ones, before the witness; and who confirms rows of a sweep.
#include "bench/sweep/confirm.h"

#include "tests/app/program.h"
#include "tests/catch.h"
#include "tests/sweep/models.h"

namespace cnrg::bench {
namespace {

constexpr double kRounding = 1e-12;
const Model kLow = box({0, 0, 0}, {2, 2, 2}), kHigh = box({1, 1, 1}, {3, 3, 3}),
            kCommon = box({1, 1, 1}, {2, 2, 2});

Model common_but(const Rational& top) { return box({1, 1, 1}, {2, 2, top}); }

std::string by(const Model& answer, double rounding, Verdict verdict, const std::string& stage = "") {
  return confirm_by_witness(problem_of(kLow, Operation::intersect, kHigh), answer, rounding, verdict, stage).by;
}

}  // namespace

TEST_CASE("true verdicts are confirmed, false ones are disputed") {
  const Model hair = common_but(2 + Rational("1/1000000000000000000"));
  for (const double rounding : {0.0, kRounding}) {
    CAPTURE(rounding);
    CHECK(by(kCommon, rounding, Verdict::same) == "integrals");
    CHECK(by(common_but(3), rounding, Verdict::wrong, "volume") == "integrals");
    CHECK(by({}, rounding, Verdict::wrong, "volume") == "integrals");
    CHECK(by(common_but(3), rounding, Verdict::same) == "DISPUTED");
    CHECK(by({}, rounding, Verdict::same) == "DISPUTED");
    Model open = kCommon;
    open.faces.pop_back();
    CHECK(by(open, rounding, Verdict::wrong, "surface") == "integrals");
    CHECK(by(open, rounding, Verdict::same) == "DISPUTED");
  }
  CHECK(by(hair, 0, Verdict::wrong, "volume") == "integrals");
  CHECK(by(hair, 0, Verdict::same) == "DISPUTED");
  CHECK(by(hair, kRounding, Verdict::same) == "integrals");
  CHECK(by(kCommon, 0, Verdict::wrong, "volume") == "DISPUTED");
  // Beside the solid, or where bounds are not equal, nothing is said.
  CHECK(by(kCommon, 0, Verdict::wrong, "dangling") == "none");
  CHECK(by(hair, kRounding, Verdict::wrong, "volume") == "none");
  const Model plate = sheet({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(confirm_by_witness(problem_of(kLow, Operation::unite, plate), kLow, 0, Verdict::same, "").by == "none");
}

TEST_CASE("folds are confirmed by points") {
  Problem problem = problem_of(kLow, Operation::subtract, box({1, 0, 0}, {2, 2, 2}));
  problem.operands.push_back(box({5, 0, 0}, {6, 1, 1}));
  problem.steps.push_back(Operation::unite);
  const Model rest = box({0, 0, 0}, {1, 2, 2}), both = together(rest, problem.operands[2]);
  for (const double rounding : {0.0, kRounding}) {
    const auto confirmed = [&](const Model& answer, Verdict verdict) {
      return confirm_by_witness(problem, answer, rounding, verdict, "volume");
    };
    CHECK(confirmed(both, Verdict::same).by == "points");
    CHECK(confirmed(rest, Verdict::wrong).by == "points");
    CHECK(confirmed(rest, Verdict::same).by == "DISPUTED");
    CHECK(confirmed(rest, Verdict::same).reason.find("in the Boolean, and the answer goes around it 0 times") !=
          std::string::npos);
    CHECK(confirmed(both, Verdict::wrong).by == "none");  // points find no small fault
  }
}

TEST_CASE("rows say who confirms them", "[sweep]") {
  const Workshop w;
  w.write("first", "#!/bin/sh\ncp \"$2\" \"$4\"\n");
  std::filesystem::permissions(w.path("first"), std::filesystem::perms::owner_all);
  const auto confirmed = [&](const std::string& problem, const std::string& system, const char* options = "") {
    const Outcome o = w.run("--one " + problem + " " + system + options);
    INFO(o.err);
    REQUIRE(o.status == 0);
    return row_of_json(o.out);
  };
  const std::string edge = "edge-union-s4-kexact-r1";
  CHECK(confirmed(edge, "ours").confirmation.by == "Nef");
  const SweepRow nef = confirmed(edge, "nef");
  CHECK(nef.confirmation.by == "Nef");
  CHECK(nef.note.empty());
  CHECK(nef.asserted_seconds.value_or(0) > 0);
  CHECK(confirmed(edge, "mantyla-exact").confirmation.by == "integrals");
  CHECK(confirmed(edge, "first", " --system first=first").confirmation.by == "integrals");
  const SweepRow refused = confirmed("sheet-union-s4-kexact-r1", "mantyla-exact");
  CHECK(refused.verdict == Verdict::refused);
  CHECK(refused.confirmation.by == "no-verdict");
  CHECK_FALSE(refused.asserted_seconds);
}

}  // namespace cnrg::bench
