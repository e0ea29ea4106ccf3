// Rows as JSON: nothing is lost, and what is no row is named.
#include "bench/sweep/row.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/catch.h"

namespace cnrg::bench {
namespace {

/// Every member has a value of its own.
SweepRow full_row() {
  SweepRow row;
  row.problem = "edge-union-s4-k7-r3";
  row.family = "edge";
  row.operation = "union";
  row.size = 4;
  row.values = {{"k", "7"}, {"node", "a b"}};
  row.warm = {0.5, 0.25};
  row.distance = 7;
  row.has_distance = true;
  row.seed = 3;
  row.operands = 5;
  row.triangles = 60;
  row.system = "mantyla-double";
  row.verdict = Verdict::contact_duplicated;
  row.stage = "connecting";
  row.message = "\"loose\" ends: <2> & ä";
  row.stages = {{"read", 0.1}, {"Boolean", 1.0 / 3}};
  row.seconds = 0.1 + 1.0 / 3;
  row.peak_bytes = 5000000001;
  row.own_bytes = 77;
  row.exact_share = 1e-5;
  row.note = "a note";
  row.facts = Facts{"-7/3", 8, 12, 6, 2, 3, -1, 4, 5, 9, 10, 11};
  row.excess = 0.25;
  row.missing = 1e-17;
  row.duplicates = 13;
  row.truth = {Facts{"22/7", 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}, "volume", "Nef ran out of memory"};
  row.confirmation = {"points", "256 points"};
  row.asserted_seconds = 0.75;
  row.limit_seconds = 60;
  row.limit_bytes = 4000000000;
  row.command = "bench_sweep one edge-union-s4-k7-r3";
  return row;
}

std::string without(const char* member) {
  nlohmann::json object = nlohmann::json::parse(to_json(full_row()));
  object.erase(member);
  return object.dump();
}

std::string with(const char* member, const nlohmann::json& value) {
  nlohmann::json object = nlohmann::json::parse(to_json(full_row()));
  object[member] = value;
  return object.dump();
}

std::string error_of(const std::string& text) {
  try {
    row_of_json(text);
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("a row comes back as it was") {
  const SweepRow row = full_row();
  const std::string text = to_json(row);
  CHECK(text.find('\n') == std::string::npos);
  const SweepRow back = row_of_json(text);
  CHECK(to_json(back) == text);
  CHECK(back.problem == row.problem);
  CHECK(back.values == row.values);
  CHECK(back.warm == row.warm);
  CHECK(back.distance == 7);
  CHECK(back.has_distance);
  CHECK(back.verdict == Verdict::contact_duplicated);
  CHECK(back.message == row.message);
  CHECK(back.stages == row.stages);
  CHECK(back.seconds == row.seconds);
  CHECK(back.peak_bytes == 5000000001);
  REQUIRE(back.facts);
  CHECK(back.facts->volume == "-7/3");
  CHECK(back.facts->genus == -1);
  CHECK(back.facts->dangling_vertices == 11);
  CHECK(back.truth.facts.regions == 4);
  CHECK(back.truth.confirmed == "volume");
  CHECK(back.confirmation.by == "points");
  CHECK(back.confirmation.reason == "256 points");
  CHECK(back.asserted_seconds == 0.75);
  CHECK(back.missing == 1e-17);
  CHECK(back.limit_bytes == 4000000000);
  CHECK(back.command == row.command);
}

TEST_CASE("a row without distance and facts comes back without them") {
  SweepRow row = full_row();
  row.distance.reset();
  row.facts.reset();
  row.asserted_seconds.reset();
  row.excess = std::numeric_limits<double>::infinity();
  row.message = "cut off \xC3";  // no UTF-8
  const SweepRow back = row_of_json(to_json(row));
  CHECK_FALSE(back.distance);
  CHECK(back.has_distance);
  CHECK_FALSE(back.facts);
  CHECK_FALSE(back.asserted_seconds);
  CHECK(std::isnan(back.excess));
  CHECK(back.message == "cut off \xEF\xBF\xBD");
}

TEST_CASE("verdicts have names, and some are failures") {
  std::set<std::string> names;
  std::set<std::string> failures;
  for (std::size_t i = 0; i < kVerdicts; ++i) {
    const auto verdict = static_cast<Verdict>(i);
    names.insert(to_string(verdict));
    CHECK(parse_verdict(to_string(verdict)) == verdict);
    if (is_failure(verdict)) failures.insert(to_string(verdict));
  }
  CHECK(names == std::set<std::string>{"same", "same-regularized", "contact-duplicated", "contact-lost",
                                       "dangling-lost", "within-rounding", "wrong", "refused", "crashed",
                                       "timed-out", "out-of-memory", "unjudged"});
  CHECK(failures == std::set<std::string>{"wrong", "refused", "crashed", "timed-out", "out-of-memory"});
  CHECK_FALSE(parse_verdict("Same"));
}

TEST_CASE("what is no row is named") {
  CHECK(error_of("{\"problem\": ").find("no JSON: parse error at line 1, column 13") == 0);
  CHECK(error_of("[]") == "the row is no JSON object");
  const nlohmann::json members = nlohmann::json::parse(to_json(full_row()));
  for (const auto& [member, value] : members.items()) {
    CHECK(error_of(without(member.c_str())) == "the row has no member `" + member + "`");
    if (member != "asserted_seconds" && member != "facts" && member != "excess" && member != "missing" &&
        member != "distance") {
      CHECK(error_of(with(member.c_str(), nullptr)) != "no error");
    }
  }
  CHECK(error_of(with("verdict", "fine")) == "member `verdict` of the row is not a known verdict");
  CHECK(error_of(with("confirmation", {{"by", "me"}, {"reason", ""}})) ==
        "member `by` of the confirmation is not one of Nef, integrals, points, none, DISPUTED, no-verdict");
  CHECK(error_of(with("seconds", -1)) == "member `seconds` of the row is not a number from 0");
  CHECK(error_of(with("seed", -1)) == "member `seed` of the row is not a number in its range");
  CHECK(error_of(with("seed", 5000000000)) == "member `seed` of the row is not a number in its range");
  CHECK(error_of(with("size", 1.5)) == "member `size` of the row is not a whole number");
  CHECK(error_of(with("distance", 301)).find("member `distance` of the row is not null or") == 0);
  CHECK(error_of(with("has_distance", false)).find("member `distance` of the row is not null or") == 0);
  CHECK(error_of(with("stages", {{{"name", "x"}}})) == "a stage has no member `seconds`");
}

}  // namespace cnrg::bench
