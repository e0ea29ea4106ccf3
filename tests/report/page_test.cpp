// The page and its JSON as a whole.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "bench/report/html.h"
#include "bench/report/plot.h"
#include "bench/report/report.h"
#include "tests/report/markup.h"
#include "tests/report/plausible.h"

namespace cnrg::bench {
namespace {

Experiment experiment_of(const PlausibleSweep& sweep) {
  return make_experiment(sweep.rows, sweep.systems, sweep.families, sweep.machine);
}

std::string page_of(const Experiment& experiment) {
  return report_html(experiment, summarize(experiment), "A <title> & more");
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// What the page holds for its script.
nlohmann::json runs_data(const std::string& page) {
  const std::string begin = "id=\"runs-data\">";
  const std::size_t at = page.find(begin) + begin.size();
  return nlohmann::json::parse(page.substr(at, page.find("</script>", at) - at));
}

constexpr const char* kHostile =
    "</script><script>alert(\"1\")</script> & 'x' <img src=\"http://a.b/c\"> ]]> \x01 \xFF";

}  // namespace

TEST_CASE("the check of markup finds faults") {
  CHECK(markup_fault("<a><b c=\"d\"/>e &amp; f</a>").empty());
  for (const char* broken : {"<a>", "<a></b>", "<a b=c></a>", "<a>&</a>", "<a>&nbsp;</a>", "<a><</a>",
                             "<a></a><b></b>", "<a b=\"<\"></a>", "<a><br></a>", "x<a></a>"}) {
    CHECK_FALSE(markup_fault(broken).empty());
  }
}

TEST_CASE("the page is well-formed and needs nothing else") {
  const std::string page = page_of(experiment_of(plausible_sweep(15, 7, 1)));
  CHECK(markup_fault(page) == "");
  CHECK(contains(page, "<h1>A &lt;title&gt; &amp; more</h1>"));
  // Names of namespaces are no addresses to load.
  std::string rest = page;
  for (const std::string name : {"http://www.w3.org/1999/xhtml", "http://www.w3.org/2000/svg"}) {
    for (std::size_t at; (at = rest.find(name)) != std::string::npos;) rest.erase(at, name.size());
  }
  for (const char* load : {"http:", "https:", "//www", "url(", "@import", " src=", "<link", "<iframe", "fetch("}) {
    CHECK_FALSE(contains(rest, load));
  }
  for (const std::string& href : attribute_values(page, "href")) CHECK(href.substr(0, 1) == "#");
  const std::vector<std::string> ids = attribute_values(page, "id");
  const std::set<std::string> distinct(ids.begin(), ids.end());
  CHECK(distinct.size() == ids.size());
  for (const std::string& href : attribute_values(page, "href")) CHECK(distinct.count(href.substr(1)) == 1);
  // One for all distances, seven families with distances, seven families in three sizes twice, two of ratios.
  CHECK(count_of(page, "<svg ") == 1 + 7 + 2 * 7 + 2);
  CHECK_FALSE(contains(page, "rgb(25"));
  CHECK_FALSE(contains(page, "PAGEFONT"));
}

TEST_CASE("the page of a small sweep has its facts and says what is missing") {
  PlausibleSweep sweep = plausible_sweep(1, 2, 1);
  const Experiment experiment = make_experiment(sweep.rows, sweep.systems, {}, std::nullopt);
  const Summary summary = summarize(experiment);
  const std::string page = report_html(experiment, summary, "t");
  CHECK(markup_fault(page) == "");
  for (const MainFact& fact : main_facts(experiment, summary)) {
    CHECK(contains(page, escaped(fact.headline)));
    CHECK(contains(page, escaped(fact.sentence)));
  }
  CHECK(contains(page, "2 systems were given 54 Boolean problems of 1 family"));
  CHECK(contains(page, "not recorded: there was no machine.json"));
  CHECK(contains(page, "no family was run in more than one size"));
  CHECK_FALSE(contains(page, "class=\"alarm\""));
}

TEST_CASE("hostile texts stay texts") {
  PlausibleSweep sweep = plausible_sweep(8, 3, 1);
  for (SweepRow& row : sweep.rows) {
    if (row.system == kOurs) continue;
    row.verdict = Verdict::refused;
    row.stage = row.message = row.command = kHostile;
  }
  // Right somewhere, so that the system's name is in plots of all kinds.
  for (SweepRow& row : sweep.rows) {
    if (row.family == "menger" || row.seed == 1) row.verdict = Verdict::same;
  }
  sweep.rows.back().truth.confirmed = "DISAGREES";
  sweep.rows.back().truth.reason = kHostile;
  sweep.systems[1].title = "<b>&'x'\"{}^_@%";
  sweep.systems[2].guarantee = sweep.systems[2].version = sweep.systems[2].absent = kHostile;
  sweep.families[0].title = sweep.machine.cpu = kHostile;
  const Experiment experiment = experiment_of(sweep);
  const std::string page = page_of(experiment);
  CHECK(markup_fault(page) == "");
  CHECK(count_of(page, "<script") == 2);
  CHECK(count_of(page, "alert(\"1\")") == 0);
  CHECK_FALSE(contains(page, "<img"));
  CHECK(contains(page, "&lt;b&gt;&amp;"));
  CHECK(contains(page, "The truth is disputed for 1 problem"));
  const nlohmann::json data = runs_data(page);
  REQUIRE(data.at("rows").size() == experiment.rows.size());
  const std::string valid = std::string(kHostile).substr(0, std::string(kHostile).size() - 1) + "\xEF\xBF\xBD";
  bool found = false;
  for (const nlohmann::json& row : data.at("rows")) found |= row.at(8) == valid;
  CHECK(found);
}

TEST_CASE("all runs are in the page, each with its command") {
  const Experiment experiment = experiment_of(plausible_sweep(2, 3, 1));
  const nlohmann::json data = runs_data(page_of(experiment));
  REQUIRE(data.at("rows").size() == experiment.rows.size());
  for (std::size_t i = 0; i < experiment.rows.size(); ++i) {
    const nlohmann::json& row = data.at("rows").at(i);
    CHECK(row.at(0) == experiment.rows[i].problem);
    CHECK(experiment.systems[row.at(1)].name == experiment.rows[i].system);
    CHECK(data.at("verdicts").at(row.at(2).get<std::size_t>()) == to_string(experiment.rows[i].verdict));
    CHECK(row.at(8) == experiment.rows[i].command);
  }
}

TEST_CASE("the JSON holds the aggregates and all rows") {
  std::vector<SweepRow> rows;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    for (const int k : {2, 9}) {
      rows.push_back(at_distance(right_row("ours", "edge", 1, seed), k, Verdict::same));
      SweepRow other = at_distance(right_row("nef", "edge", 1, seed), k, Verdict::same);
      other.seconds = 2 * seed;
      if (k == 9 && seed == 1) other.verdict = Verdict::wrong, other.stage = "finishing", other.message = "twice";
      rows.push_back(other);
    }
  }
  for (const long size : {1, 10, 100}) {
    SweepRow row = right_row("ours", "boxes", size);
    row.seconds = 0.01 * static_cast<double>(size * size);
    row.own_bytes = static_cast<std::size_t>(5000 * size);
    row.exact_share = 0.01;
    rows.push_back(row);
  }
  const Experiment experiment =
      make_experiment(rows, {}, {}, MachineInfo{"cpu", 2, 8, "s", "c", "a1", "today", 1, 2, "x"});
  const nlohmann::json json = nlohmann::json::parse(report_json(experiment, summarize(experiment), "t"));
  CHECK(json.at("schema") == 1);
  CHECK(json.at("title") == "t");
  CHECK(json.at("machine").at("commit") == "a1");
  CHECK(json.at("systems").at(0).at("name") == "ours");
  CHECK(json.at("facts").at(0).at("headline") == "11 of 11");
  const nlohmann::json& all = json.at("aggregates");
  CHECK(all.at("problems") == 11);
  CHECK(all.at("totals").at("nef").at("failures") == 1);
  CHECK(all.at("totals").at("nef").at("failure_rate") == Approx(0.125));
  CHECK(all.at("totals").at("nef").at("verdicts").at("wrong") == 1);
  CHECK(all.at("families").at(0).at("systems").at("ours").at("verdicts").at("same") == 8);
  const nlohmann::json& stage = all.at("stages").at(0);
  CHECK(stage.at("stage") == "finishing");
  CHECK(stage.at("example") == "edge-union-s1-k9-r1");
  CHECK(stage.at("message") == "twice");
  const nlohmann::json& nef = all.at("distances").at("all").at("systems").at(1);
  CHECK(nef.at("system") == "nef");
  CHECK(nef.at("fails_from") == 9);
  CHECK(nef.at("points").at(1).at("failure_rate") == Approx(0.25));
  const nlohmann::json& growth = all.at("growth").at(0);
  CHECK(growth.at("family") == "boxes");
  CHECK(growth.at("systems").at(0).at("time").at("exponent") == Approx(2));
  CHECK(growth.at("systems").at(0).at("memory").at("exponent") == Approx(1));
  // Ratios 2, 4, 6, 8 and, without the wrong one, 4, 6, 8: sorted 2, 4, 4, 6, 6, 8, 8.
  const nlohmann::json& time = all.at("ratios").at(0).at("time");
  CHECK(time.at("count") == 7);
  CHECK(time.at("lower_quartile") == Approx(4));
  CHECK(time.at("median") == Approx(6));
  CHECK(time.at("upper_quartile") == Approx(7));
  CHECK(all.at("exact_share").at("median") == Approx(0.01));
  CHECK(all.at("truth").at("Nef") == 11);
  REQUIRE(json.at("rows").size() == rows.size());
  nlohmann::json row = json.at("rows").at(0), expected = nlohmann::json::parse(to_json(experiment.rows[0]));
  const nlohmann::json truth = json.at("truths").at(experiment.rows[0].problem);
  CHECK(truth == expected.at("truth"));
  if (row.at("facts") == "exact") row["facts"] = truth.at("facts");
  expected.erase("truth");
  CHECK(row == expected);
}

TEST_CASE("gnuplot draws every tick, the ends of logarithmic axes too") {
  Gallery gallery;
  for (int low = -9; low <= 9; ++low) {
    LinePlot plot;
    plot.x = plot.y = decades("", {1.5 * std::pow(10, low), 500 * std::pow(10, low)});
    plot.series = {{"a & b", 0, true, {{2 * std::pow(10, low), 3 * std::pow(10, low)}}}};
    gallery.add(plot);
  }
  const std::vector<std::string> drawings = gallery.draw();
  REQUIRE(drawings.size() == 19);
  for (const std::string& svg : drawings) {
    CHECK(markup_fault(svg) == "");
    CHECK(count_of(svg, "<text>") == 2 * 4 + 1);  // and the name
    CHECK(contains(svg, "<text>a &amp; b</text>"));
  }
}

TEST_CASE("axes have whole decades") {
  const Axis axis = decades("x", {0.02, 30});
  CHECK(axis.low == Approx(0.01));
  CHECK(axis.high == Approx(100));
  std::vector<std::string> texts;
  for (const Tick& tick : axis.ticks) texts.push_back(tick.text);
  CHECK(texts == std::vector<std::string>{"0.01", "0.1", "1", "10", "100"});
  CHECK(decades("x", {1}).high == Approx(10));
  CHECK(decades("x", {2e4, 3e5}).ticks.back().text == "10⁶");
}

}  // namespace cnrg::bench
