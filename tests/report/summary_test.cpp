// Aggregates against numbers worked out by hand.
#include "bench/report/summary.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "bench/report/format.h"
#include "tests/report/plausible.h"

namespace cnrg::bench {
namespace {

Experiment experiment_of(std::vector<SweepRow> rows) {
  return make_experiment(std::move(rows), {}, {}, std::nullopt);
}

SweepRow with_verdict(SweepRow row, Verdict verdict, const std::string& stage = "",
                      const std::string& message = "") {
  row.verdict = verdict;
  row.stage = stage;
  row.message = message;
  return row;
}

SweepRow with_cost(SweepRow row, double seconds, std::size_t bytes) {
  row.seconds = seconds;
  row.own_bytes = bytes;
  return row;
}

std::size_t place(const Experiment& experiment, const std::string& system) {
  for (std::size_t s = 0; s < experiment.systems.size(); ++s) {
    if (experiment.systems[s].name == system) return s;
  }
  FAIL("no system " << system);
  return 0;
}

const DistanceCurve& curve_of(const Experiment& experiment, const DistanceStudy& study,
                              const std::string& system) {
  for (const DistanceCurve& curve : study.curves) {
    if (curve.system == place(experiment, system)) return curve;
  }
  FAIL("no curve of " << system);
  return study.curves.front();
}

/// Ten problems at each of the distances 0, 4, 8 and exact: `ours` never fails, `a` fails in 0, 0, 3 and 10 of
/// them.
std::vector<SweepRow> rows_at_distances(const std::string& family) {
  std::vector<SweepRow> rows;
  const std::pair<std::optional<int>, unsigned> failures[] = {{0, 0}, {4, 0}, {8, 3}, {std::nullopt, 10}};
  for (const auto& [k, failed] : failures) {
    for (unsigned seed = 1; seed <= 10; ++seed) {
      const Verdict verdict = seed > failed ? Verdict::same : seed % 2 == 0 ? Verdict::refused : Verdict::wrong;
      rows.push_back(at_distance(right_row("ours", family, 1, seed), k, Verdict::same));
      rows.push_back(at_distance(right_row("a", family, 1, seed), k, verdict));
    }
  }
  return rows;
}

}  // namespace

TEST_CASE("quartiles lie between the sorted values") {
  const Spread s = spread_of({4, 1, 3, 2});
  CHECK(s.count == 4);
  CHECK(s.least == 1);
  CHECK(s.lower == Approx(1.75));
  CHECK(s.median == Approx(2.5));
  CHECK(s.upper == Approx(3.25));
  CHECK(s.most == 4);
  CHECK(spread_of({7}).lower == 7);
  CHECK(spread_of({}).count == 0);
}

TEST_CASE("an exact power law is found") {
  const auto law = power_law({{10, 3e-3}, {100, 3e-3 * std::pow(10, 1.5)}, {1000, 3.0}});
  REQUIRE(law);
  CHECK(law->exponent == Approx(1.5));
  CHECK(law->factor == Approx(3e-3 / std::pow(10, 1.5)));
  CHECK(law->error == Approx(0).margin(1e-6));
  CHECK(law->r_squared == Approx(1));
  CHECK_FALSE(power_law({{10, 1}, {100, 2}, {100, 3}}));
}

TEST_CASE("a power law that does not fit says so") {
  // With t = ln 10: x is 0, t, 2t and y is 0, 2t, 2t, so that the slope is 1, the line t/3 + x, and the residuals
  // are -t/3, 2t/3, -t/3: their squares make 2t^2/3, the variance of y 8t^2/3, that of x 2t^2.
  const auto law = power_law({{1, 1}, {10, 100}, {100, 100}});
  REQUIRE(law);
  CHECK(law->exponent == Approx(1));
  CHECK(law->factor == Approx(std::pow(10, 1.0 / 3)));
  CHECK(law->error == Approx(std::sqrt(1.0 / 3)));
  CHECK(law->r_squared == Approx(0.75));
}

TEST_CASE("failure rates, and where failures begin") {
  const Experiment experiment = experiment_of(rows_at_distances("edge"));
  const Summary summary = summarize(experiment);
  CHECK(summary.problems == 40);
  const DistanceCurve& a = curve_of(experiment, summary.all_distances, "a");
  REQUIRE(a.points.size() == 4);
  const double rates[] = {0, 0, 0.3, 1};
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(a.points[i].tally.runs() == 10);
    CHECK(a.points[i].tally.failure_rate() == Approx(rates[i]));
  }
  CHECK(a.points[2].k == 8);
  CHECK_FALSE(a.points[3].k);
  CHECK(a.onset == 2u);
  CHECK(a.worst == 3);
  const DistanceCurve& ours = curve_of(experiment, summary.all_distances, "ours");
  CHECK_FALSE(ours.onset);
  CHECK(summary.totals[place(experiment, "a")].of(Verdict::wrong) == 7);    // 1, 3 and 1, 3, 5, 7, 9
  CHECK(summary.totals[place(experiment, "a")].of(Verdict::refused) == 6);  // 2 and 2, 4, 6, 8, 10
  CHECK(summary.totals[place(experiment, "a")].failure_rate() == Approx(13.0 / 40));
}

TEST_CASE("a system has no rate of failures in a family whose operands it does not take") {
  std::vector<SweepRow> rows = rows_at_distances("edge");
  for (SweepRow row : rows_at_distances("sheet")) {
    if (row.system == "a") {
      row.verdict = Verdict::refused;
      row.stage = "input";
    }
    rows.push_back(row);
  }
  const Experiment experiment = experiment_of(rows);
  const Summary summary = summarize(experiment);
  CHECK(curve_of(experiment, summary.all_distances, "a").points.at(0).tally.failure_rate() == 0);
  CHECK(curve_of(experiment, summary.all_distances, "ours").points.at(0).tally.runs() == 20);
  CHECK(summary.totals[place(experiment, "a")].failures() == 13 + 40);
  // One that is taken is enough: then a refusal counts.
  for (SweepRow& row : rows) {
    if (row.family != "sheet" || row.system != "a") continue;
    row.verdict = Verdict::same;
    row.stage.clear();
    break;
  }
  const Experiment other = experiment_of(rows);
  CHECK(curve_of(other, summarize(other).all_distances, "a").points.at(0).tally.failure_rate() > 0.4);
}

TEST_CASE("families are counted apart, those with distances first") {
  std::vector<SweepRow> rows = rows_at_distances("edge");
  rows.push_back(with_verdict(right_row("a", "boxes", 5), Verdict::same_regularized));
  const Experiment experiment = experiment_of(rows);
  const Summary summary = summarize(experiment);
  REQUIRE(summary.families.size() == 2);
  CHECK(experiment.families[summary.families[0].family].name == "edge");
  CHECK(summary.families[0].problems == 40);
  CHECK(summary.families[1].problems == 1);
  CHECK(summary.families[1].systems[place(experiment, "a")].of(Class::right) == 1);
  CHECK(summary.families[1].systems[place(experiment, "ours")].runs() == 0);
  CHECK(summary.distances.size() == 1);
  CHECK(summary.problems == 41);
}

TEST_CASE("failures by stage, the most frequent first, with an example") {
  const Experiment experiment = experiment_of(
      {right_row("ours", "f", 1, 1), with_verdict(right_row("a", "f", 1, 2), Verdict::refused, "input", "open"),
       with_verdict(right_row("a", "f", 1, 10), Verdict::refused, "connecting", "second"),
       with_verdict(right_row("a", "f", 1, 9), Verdict::wrong, "connecting", "first"),
       with_verdict(right_row("a", "f", 1, 4), Verdict::contact_lost, "connecting", "no failure"),
       with_verdict(right_row("b", "f", 1, 4), Verdict::crashed)});
  const Summary summary = summarize(experiment);
  REQUIRE(summary.stages.size() == 3);
  CHECK(summary.stages[0].stage == "connecting");
  CHECK(summary.stages[0].tally.runs() == 2);
  CHECK(summary.stages[0].tally.of(Verdict::wrong) == 1);
  CHECK(summary.stages[0].problem == "f-union-s1-r9");  // before r10
  CHECK(summary.stages[0].message == "first");
  CHECK(summary.stages[1].stage == "input");
  CHECK(summary.stages[2].stage == "unknown");
  CHECK(summary.stages[2].system == place(experiment, "b"));
}

TEST_CASE("growth is fitted to the medians of right runs") {
  std::vector<SweepRow> rows;
  for (const long size : {1, 10, 100}) {  // triangles: 24 size
    const double time = 1e-3 * std::pow(static_cast<double>(size), 2);
    rows.push_back(with_cost(right_row("ours", "f", size, 1), 0.5 * time, static_cast<std::size_t>(1000 * size)));
    rows.push_back(with_cost(right_row("ours", "f", size, 2), time, static_cast<std::size_t>(1000 * size)));
    rows.push_back(with_cost(right_row("ours", "f", size, 3), 9 * time, static_cast<std::size_t>(1000 * size)));
    SweepRow failed = with_cost(right_row("ours", "f", size, 4), 60, 1);
    failed.verdict = Verdict::timed_out;
    rows.push_back(failed);
    if (size < 100) rows.push_back(with_cost(right_row("a", "f", size), time, 1));
  }
  rows.push_back(right_row("ours", "g", 1));
  const Experiment experiment = experiment_of(rows);
  const Summary summary = summarize(experiment);
  REQUIRE(summary.growth.size() == 1);
  const std::vector<GrowthCurve>& curves = summary.growth[0].curves;
  REQUIRE(curves.size() == 2);
  CHECK(curves[0].system == place(experiment, "ours"));
  REQUIRE(curves[0].points.size() == 3);
  CHECK(curves[0].points[1].triangles == 240);
  CHECK(curves[0].points[1].seconds == Approx(0.1));
  CHECK(curves[0].points[1].runs == 4);
  CHECK(curves[0].points[1].right == 3);
  REQUIRE(curves[0].time);
  CHECK(curves[0].time->exponent == Approx(2));
  REQUIRE(curves[0].memory);
  CHECK(curves[0].memory->exponent == Approx(1));
  CHECK(curves[1].points.size() == 2);
  CHECK_FALSE(curves[1].time);
}

TEST_CASE("ratios on problems that both did right") {
  std::vector<SweepRow> rows;
  const double factors[] = {2, 4, 6, 8};
  for (unsigned seed = 1; seed <= 4; ++seed) {
    rows.push_back(with_cost(right_row("ours", "f", 1, seed), 0.5 * seed, 1000 * seed));
    rows.push_back(with_cost(right_row("nef", "f", 1, seed), 0.5 * seed * factors[seed - 1], 3000 * seed));
    rows.push_back(with_verdict(with_cost(right_row("a", "f", 1, seed), 0.001, 1), Verdict::wrong));
  }
  rows.push_back(with_verdict(with_cost(right_row("ours", "f", 1, 5), 1, 1), Verdict::refused));
  rows.push_back(with_cost(right_row("nef", "f", 1, 5), 100, 100));
  rows.push_back(with_cost(right_row("nef", "f", 1, 6), 100, 100));
  const Experiment experiment = experiment_of(rows);
  const Summary summary = summarize(experiment);
  REQUIRE(summary.ratios.size() == 1);
  CHECK(summary.ratios[0].system == place(experiment, "nef"));
  const Spread& time = summary.ratios[0].time;
  CHECK(time.count == 4);
  CHECK(time.least == Approx(2));
  CHECK(time.lower == Approx(3.5));
  CHECK(time.median == Approx(5));
  CHECK(time.upper == Approx(6.5));
  CHECK(time.most == Approx(8));
  CHECK(summary.ratios[0].memory.median == Approx(3));
}

TEST_CASE("exact share, truth and limits") {
  std::vector<SweepRow> rows;
  const double shares[] = {0.1, 0.3, 0.2, -1};
  const char* truths[] = {"Nef", "volume", "none", "Nef"};
  for (unsigned seed = 1; seed <= 4; ++seed) {
    SweepRow row = right_row("ours", seed < 3 ? "f" : "g", 1, seed);
    row.exact_share = shares[seed - 1];
    row.truth.confirmed = truths[seed - 1];
    row.limit_seconds = 10 * seed;
    rows.push_back(row);
    row.system = "a";
    row.exact_share = 0.9;
    if (seed == 4) row.truth.confirmed = "DISAGREES", row.truth.reason = "Nef has volume 7";
    rows.push_back(row);
  }
  const Summary summary = summarize(experiment_of(rows));
  REQUIRE(summary.exact_shares.size() == 2);
  CHECK(summary.exact_shares[0].median == Approx(0.2));
  CHECK(summary.exact_shares[0].most == Approx(0.3));
  CHECK(summary.exact_shares[1].runs == 1);
  REQUIRE(summary.exact_share);
  CHECK(summary.exact_share->runs == 3);
  CHECK(summary.exact_share->median == Approx(0.2));
  std::vector<std::size_t> counts;
  for (const TruthCount& truth : summary.truths) counts.push_back(truth.problems);
  CHECK(counts == std::vector<std::size_t>{1, 1, 1, 1});
  REQUIRE(summary.disagreements.size() == 1);
  CHECK(summary.disagreements[0].problem == "g-union-s1-r4");
  CHECK(summary.disagreements[0].reason == "Nef has volume 7");
  CHECK(summary.least_limit_seconds == 10);
  CHECK(summary.most_limit_seconds == 40);
}

TEST_CASE("what could not be judged counts nowhere") {
  std::vector<SweepRow> rows;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const Verdict verdict = seed <= 2 ? Verdict::unjudged : seed == 3 ? Verdict::wrong : Verdict::same;
    rows.push_back(at_distance(right_row("ours", "f", 1, seed), 3, Verdict::same));
    rows.push_back(at_distance(right_row("a", "f", 1, seed), 3, verdict));
    rows.push_back(at_distance(right_row("a", "f", 9, seed), 4, Verdict::unjudged));
    rows.push_back(at_distance(right_row("ours", "f", 9, seed), 4, Verdict::unjudged));
  }
  rows.push_back(at_distance(right_row("ours", "f", 20, 1), 4, Verdict::unjudged));
  const Experiment experiment = experiment_of(rows);
  const Summary summary = summarize(experiment);
  const Tally& a = summary.totals[place(experiment, "a")];
  CHECK(a.runs() == 8);
  CHECK(a.judged() == 2);
  CHECK(a.right() == 1);
  CHECK(a.failures() == 1);
  CHECK(a.failure_rate() == Approx(0.5));
  const DistanceCurve& curve = curve_of(experiment, summary.all_distances, "a");
  REQUIRE(curve.points.size() == 1);
  CHECK(curve.points[0].tally.failure_rate() == Approx(0.5));
  REQUIRE(summary.ratios.size() == 1);
  CHECK(summary.ratios[0].time.count == 1);
  REQUIRE(summary.growth.size() == 1);
  CHECK(summary.growth[0].curves.at(0).points.size() == 1);
  const MainFact fact = main_facts(experiment, summary).at(0);
  CHECK(fact.headline == "4 of 4");
  CHECK(fact.sentence.find("5 more could not be judged. Best of the others is a with 1 of 2.") !=
        std::string::npos);
}

TEST_CASE("the main facts follow from the rows") {
  std::vector<SweepRow> rows = rows_at_distances("edge");
  for (SweepRow& row : rows) {
    if (row.system == "a") row.seconds = 4;
  }
  const Experiment experiment = experiment_of(rows);
  const std::vector<MainFact> facts = main_facts(experiment, summarize(experiment));
  REQUIRE(facts.size() == 3);
  CHECK(facts[0].headline == "40 of 40");
  CHECK(facts[0].sentence ==
        "results of ours are the exact ones. Best of the others is a with 27 of 40. 7 results of 1 other "
        "system are wrong without saying so.");
  REQUIRE(facts[0].lines.size() == 2);
  CHECK(facts[0].lines[1].cells == std::vector<std::string>{"27", "27", "7"});
  CHECK(facts[1].headline == "0 failures");
  CHECK(facts[1].sentence ==
        "of ours in 40 runs at all distances. First of the others, a begins to fail at 10⁻⁸ and "
        "fails in up to 100 % of the runs at a distance.");
  CHECK(facts[1].lines[1].cells == std::vector<std::string>{"10⁻⁸", "100 %", "exact"});
  CHECK(facts[2].headline == "4.00 ×");
  CHECK(facts[2].lines[0].cells == std::vector<std::string>{"4.00 ×", "4.00–4.00", "27"});
}

TEST_CASE("the main facts do not flatter") {
  std::vector<SweepRow> rows = rows_at_distances("edge");
  for (SweepRow& row : rows) row.system = row.system == "ours" ? "a" : "ours";
  const Experiment experiment = experiment_of(rows);
  const std::vector<MainFact> facts = main_facts(experiment, summarize(experiment));
  CHECK(facts[0].headline == "27 of 40");
  CHECK(facts[0].sentence.find("7 are wrong, unsaid.") != std::string::npos);
  CHECK(facts[0].sentence.find("None of the others is wrong") != std::string::npos);
  CHECK(facts[1].headline == "from 10⁻⁸");
  CHECK(facts[1].sentence ==
        "13 failures of ours in 40 runs at all distances. None of the others begins to fail.");
}

TEST_CASE("too few data for a fact are said") {
  const Experiment alone = experiment_of({right_row("a", "f")});
  for (const MainFact& fact : main_facts(alone, summarize(alone))) CHECK(fact.headline == "–");
  const Experiment ours = experiment_of({right_row("ours", "f")});
  const std::vector<MainFact> facts = main_facts(ours, summarize(ours));
  CHECK(facts[0].sentence == "results of ours are the exact ones.");
  CHECK(facts[1].sentence.find("Not enough data") == 0);
  CHECK(facts[2].sentence.find("Not enough data") == 0);
}

TEST_CASE("numbers for people") {
  CHECK(three_digits(0.0012345) == "0.00123");
  CHECK(three_digits(9.996) == "10.0");
  CHECK(three_digits(0.09996) == "0.100");
  CHECK(three_digits(123456) == "123,000");
  CHECK(three_digits(999.6) == "1,000");
  CHECK(three_digits(0) == "0");
  CHECK(three_digits(NAN) == "–");
  CHECK(grouped(1234567) == "1,234,567");
  CHECK(grouped(123) == "123");
  CHECK(percent(0) == "0 %");
  CHECK(percent(1) == "100 %");
  CHECK(percent(0.9999999) == "99.99 %");
  CHECK(percent(0.00001) == "0.001 %");
  CHECK(percent(0.034) == "3.4 %");
  CHECK(percent(0.5) == "50 %");
  CHECK(megabytes(1234567) == "1.23");
  CHECK(distance_text(16) == "10⁻¹⁶");
  CHECK(distance_text(0) == "10⁰");
  CHECK(distance_text(std::nullopt) == "exact");
}

}  // namespace cnrg::bench
