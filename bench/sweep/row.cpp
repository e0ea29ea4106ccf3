// A row is one JSON object with a member for each of the header's, in its order.
#include "bench/sweep/row.h"

#include "bench/sweep/json_fields.h"

namespace cnrg::bench {
namespace {

constexpr std::array<const char*, kVerdicts> kNames = {"same",         "same-regularized", "contact-duplicated",
                                                       "contact-lost", "dangling-lost",    "within-rounding",
                                                       "wrong",        "refused",          "crashed",
                                                       "timed-out",    "out-of-memory",    "unjudged"};

nlohmann::ordered_json object_of(const Facts& f) {
  return {{"volume", f.volume},
          {"vertices", f.vertices},
          {"edges", f.edges},
          {"faces", f.faces},
          {"regions", f.regions},
          {"shells", f.shells},
          {"genus", f.genus},
          {"non_manifold_edges", f.non_manifold_edges},
          {"non_manifold_vertices", f.non_manifold_vertices},
          {"dangling_faces", f.dangling_faces},
          {"dangling_edges", f.dangling_edges},
          {"dangling_vertices", f.dangling_vertices}};
}

nlohmann::ordered_json object_of(const Truth& truth) {
  return {{"facts", object_of(truth.facts)}, {"confirmed", truth.confirmed}, {"reason", truth.reason}};
}

nlohmann::ordered_json object_of(const Confirmation& confirmation) {
  return {{"by", confirmation.by}, {"reason", confirmation.reason}};
}

Facts facts_in(const nlohmann::json& object, const std::string& name) {
  const JsonFields in(object, name);
  Facts f;
  f.volume = in.text("volume");
  f.vertices = in.integer<std::size_t>("vertices");
  f.edges = in.integer<std::size_t>("edges");
  f.faces = in.integer<std::size_t>("faces");
  f.regions = in.integer<std::size_t>("regions");
  f.shells = in.integer<std::size_t>("shells");
  f.genus = in.integer<long>("genus");
  f.non_manifold_edges = in.integer<std::size_t>("non_manifold_edges");
  f.non_manifold_vertices = in.integer<std::size_t>("non_manifold_vertices");
  f.dangling_faces = in.integer<std::size_t>("dangling_faces");
  f.dangling_edges = in.integer<std::size_t>("dangling_edges");
  f.dangling_vertices = in.integer<std::size_t>("dangling_vertices");
  return f;
}

Truth truth_of(const nlohmann::json& object) {
  const JsonFields in(object, "the truth");
  Truth truth;
  truth.facts = facts_in(in.at("facts"), "the truth's facts");
  truth.confirmed = in.text("confirmed");
  truth.reason = in.text("reason");
  for (const char* known : {"Nef", "Nef-by-us", "node", "formula", "volume", "none", "DISAGREES"}) {
    if (truth.confirmed == known) return truth;
  }
  in.fail("confirmed", "one of Nef, Nef-by-us, node, formula, volume, none, DISAGREES");
}

Confirmation confirmation_of(const nlohmann::json& object) {
  const JsonFields in(object, "the confirmation");
  for (const char* known : {"Nef", "integrals", "points", "none", "DISPUTED", "no-verdict"}) {
    if (in.text("by") == known) return {known, in.text("reason")};
  }
  in.fail("by", "one of Nef, integrals, points, none, DISPUTED, no-verdict");
}

Verdict verdict_of(const JsonFields& in) {
  const std::optional<Verdict> verdict = parse_verdict(in.text("verdict"));
  if (!verdict) in.fail("verdict", "a known verdict");
  return *verdict;
}

std::vector<std::pair<std::string, double>> stages_of(const JsonFields& in) {
  std::vector<std::pair<std::string, double>> stages;
  for (const nlohmann::json& stage : in.list("stages")) {
    const JsonFields fields(stage, "a stage");
    stages.emplace_back(fields.text("name"), fields.not_negative("seconds"));
  }
  return stages;
}

}  // namespace

const char* to_string(Verdict verdict) { return kNames[static_cast<std::size_t>(verdict)]; }

std::optional<Verdict> parse_verdict(const std::string& text) {
  for (std::size_t i = 0; i < kVerdicts; ++i) {
    if (text == kNames[i]) return static_cast<Verdict>(i);
  }
  return std::nullopt;
}

bool is_failure(Verdict verdict) {
  switch (verdict) {
    case Verdict::same:
    case Verdict::same_regularized:
    case Verdict::contact_duplicated:
    case Verdict::contact_lost:
    case Verdict::dangling_lost:
    case Verdict::within_rounding:
    case Verdict::unjudged: return false;
    case Verdict::wrong:
    case Verdict::refused:
    case Verdict::crashed:
    case Verdict::timed_out:
    case Verdict::out_of_memory: break;
  }
  return true;
}

std::string to_json(const SweepRow& row) {
  nlohmann::ordered_json out{{"problem", row.problem},
                             {"family", row.family},
                             {"values", row.values},
                             {"operation", row.operation},
                             {"size", row.size},
                             {"distance", nullptr},
                             {"has_distance", row.has_distance},
                             {"seed", row.seed},
                             {"operands", row.operands},
                             {"triangles", row.triangles},
                             {"system", row.system},
                             {"verdict", to_string(row.verdict)},
                             {"stage", row.stage},
                             {"message", row.message},
                             {"stages", nlohmann::ordered_json::array()},
                             {"warm", row.warm},
                             {"asserted_seconds", nullptr},
                             {"seconds", row.seconds},
                             {"peak_bytes", row.peak_bytes},
                             {"own_bytes", row.own_bytes},
                             {"exact_share", row.exact_share},
                             {"note", row.note},
                             {"facts", nullptr},
                             {"excess", row.excess},
                             {"missing", row.missing},
                             {"duplicates", row.duplicates}};
  if (row.asserted_seconds) out["asserted_seconds"] = *row.asserted_seconds;
  if (row.distance) out["distance"] = *row.distance;
  for (const auto& [name, seconds] : row.stages) out["stages"].push_back({{"name", name}, {"seconds", seconds}});
  if (row.facts) out["facts"] = object_of(*row.facts);
  out["truth"] = object_of(row.truth);
  out["confirmation"] = object_of(row.confirmation);
  out["limit_seconds"] = row.limit_seconds;
  out["limit_bytes"] = row.limit_bytes;
  out["load"] = row.load;
  out["command"] = row.command;
  return json_text(out);
}

SweepRow row_of_json(const std::string& text) {
  const nlohmann::json object = parse_json(text);
  const JsonFields in(object, "the row");
  SweepRow row;
  row.problem = in.text("problem");
  row.family = in.text("family");
  for (const auto& [name, value] : in.object("values").items()) {
    if (!value.is_string()) in.fail("values", "an object of texts");
    row.values[name] = value.get<std::string>();
  }
  row.operation = in.text("operation");
  row.size = in.integer<long>("size");
  if (!in.is_null("distance")) row.distance = in.integer<int>("distance");
  row.has_distance = in.flag("has_distance");
  if (row.distance && (!row.has_distance || *row.distance < 0 || *row.distance > 300)) {
    in.fail("distance", "null or, in a family that has distances, a whole number from 0 to 300");
  }
  row.seed = in.integer<unsigned>("seed");
  row.operands = in.integer<std::size_t>("operands");
  row.triangles = in.integer<std::size_t>("triangles");
  row.system = in.text("system");
  row.verdict = verdict_of(in);
  row.stage = in.text("stage");
  row.message = in.text("message");
  row.stages = stages_of(in);
  for (const nlohmann::json& seconds : in.list("warm")) {
    if (!seconds.is_number() || !(seconds.get<double>() >= 0)) in.fail("warm", "a list of numbers from 0");
    row.warm.push_back(seconds.get<double>());
  }
  if (!in.is_null("asserted_seconds")) row.asserted_seconds = in.not_negative("asserted_seconds");
  row.seconds = in.not_negative("seconds");
  row.peak_bytes = in.integer<std::size_t>("peak_bytes");
  row.own_bytes = in.integer<std::size_t>("own_bytes");
  row.exact_share = in.number("exact_share");
  row.note = in.text("note");
  if (!in.is_null("facts")) row.facts = facts_in(in.at("facts"), "the facts");
  row.excess = in.number_or_nan("excess");
  row.missing = in.number_or_nan("missing");
  row.duplicates = in.integer<std::size_t>("duplicates");
  row.truth = truth_of(in.at("truth"));
  row.confirmation = confirmation_of(in.at("confirmation"));
  row.limit_seconds = in.not_negative("limit_seconds");
  row.limit_bytes = in.integer<std::size_t>("limit_bytes");
  row.load = in.not_negative("load");
  row.command = in.text("command");
  return row;
}

std::string to_json(const Truth& truth) {
  nlohmann::ordered_json out = object_of(truth);
  out["experiment"] = truth.experiment;
  out["digest"] = truth.digest;
  return json_text(out);
}
Truth truth_of_json(const std::string& text) {
  const nlohmann::json object = parse_json(text);
  Truth truth = truth_of(object);
  const JsonFields in(object, "the truth");
  truth.experiment = in.text("experiment");
  truth.digest = in.text("digest");
  return truth;
}
std::string to_json(const Facts& facts) { return json_text(object_of(facts)); }
Facts facts_of_json(const std::string& text) { return facts_in(parse_json(text), "the facts"); }

}  // namespace cnrg::bench
