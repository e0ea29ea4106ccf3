// The aggregates by name: places of systems and families are replaced by their names.
#include <map>

#include "bench/report/report.h"
#include "bench/sweep/json_fields.h"

namespace cnrg::bench {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Tally& tally) {
  Json verdicts = Json::object();
  for (std::size_t i = 0; i < kVerdicts; ++i) verdicts[to_string(static_cast<Verdict>(i))] = tally.counts[i];
  return {{"runs", tally.runs()},
          {"judged", tally.judged()},
          {"failures", tally.failures()},
          {"failure_rate", tally.failure_rate()},
          {"verdicts", verdicts}};
}

Json json_of(const Spread& s) {
  if (s.count == 0) return nullptr;
  return {{"count", s.count},          {"min", s.least}, {"lower_quartile", s.lower}, {"median", s.median},
          {"upper_quartile", s.upper}, {"max", s.most}};
}

Json json_of(const std::optional<PowerLaw>& law) {
  if (!law) return nullptr;
  return {{"points", law->points},
          {"exponent", law->exponent},
          {"standard_error", law->error},
          {"factor", law->factor},
          {"r_squared", law->r_squared}};
}

Json distance_of(const DistancePoint& point) { return point.k ? Json(*point.k) : Json("exact"); }

class Names {
 public:
  explicit Names(const Experiment& experiment) : experiment_(experiment) {}
  const std::string& system(std::size_t place) const { return experiment_.systems[place].name; }
  const std::string& family(std::size_t place) const { return experiment_.families[place].name; }

 private:
  const Experiment& experiment_;
};

Json json_of(const DistanceStudy& study, const Names& names) {
  Json systems = Json::array();
  for (const DistanceCurve& curve : study.curves) {
    Json points = Json::array();
    for (const DistancePoint& point : curve.points) {
      Json entry = {{"distance", distance_of(point)}};
      entry.update(json_of(point.tally));
      points.push_back(std::move(entry));
    }
    systems.push_back({{"system", names.system(curve.system)},
                       {"fails_from", curve.onset ? distance_of(curve.points[*curve.onset]) : Json()},
                       {"worst_at", distance_of(curve.points[curve.worst])},
                       {"points", points}});
  }
  return {{"family", study.family ? Json(names.family(*study.family)) : Json()}, {"systems", systems}};
}

Json json_of(const GrowthStudy& study, const Names& names) {
  Json systems = Json::array();
  for (const GrowthCurve& curve : study.curves) {
    Json points = Json::array();
    for (const GrowthPoint& p : curve.points) {
      points.push_back({{"size", p.size},
                        {"runs", p.runs},
                        {"right", p.right},
                        {"triangles", p.triangles},
                        {"seconds", p.seconds},
                        {"own_bytes", p.own_bytes}});
    }
    systems.push_back({{"system", names.system(curve.system)},
                       {"time", json_of(curve.time)},
                       {"memory", json_of(curve.memory)},
                       {"points", points}});
  }
  return {{"family", names.family(study.family)}, {"systems", systems}};
}

Json tallies(const std::vector<Tally>& tallies, const Names& names) {
  Json out = Json::object();
  for (std::size_t s = 0; s < tallies.size(); ++s) {
    if (tallies[s].runs() > 0) out[names.system(s)] = json_of(tallies[s]);
  }
  return out;
}

Json json_of(const ExactShare& share) {
  return {{"runs", share.runs}, {"median", share.median}, {"max", share.most}};
}

Json facts_json(const Experiment& experiment, const Summary& summary, const Names& names) {
  Json out = Json::array();
  for (const MainFact& fact : main_facts(experiment, summary)) {
    Json lines = Json::array();
    for (const FactLine& line : fact.lines) {
      Json entry = {{"system", names.system(line.system)}};
      for (std::size_t i = 0; i < line.cells.size(); ++i) entry[fact.columns[i]] = line.cells[i];
      lines.push_back(std::move(entry));
    }
    out.push_back({{"question", fact.question},
                   {"headline", fact.headline},
                   {"sentence", fact.sentence},
                   {"note", fact.note},
                   {"systems", lines}});
  }
  return out;
}

Json aggregates(const Summary& summary, const Names& names) {
  Json out = {{"problems", summary.problems}, {"totals", tallies(summary.totals, names)}};
  out["families"] = Json::array();
  for (const FamilyTally& family : summary.families) {
    out["families"].push_back({{"family", names.family(family.family)},
                               {"problems", family.problems},
                               {"has_distance", family.has_distance},
                               {"systems", tallies(family.systems, names)}});
  }
  out["stages"] = Json::array();
  for (const StageTally& stage : summary.stages) {
    Json entry = {{"system", names.system(stage.system)}, {"stage", stage.stage}};
    entry.update(json_of(stage.tally));
    entry["example"] = stage.problem;
    entry["message"] = stage.message;
    out["stages"].push_back(std::move(entry));
  }
  out["distances"] = {{"all", json_of(summary.all_distances, names)}, {"families", Json::array()}};
  for (const DistanceStudy& study : summary.distances) {
    out["distances"]["families"].push_back(json_of(study, names));
  }
  out["growth"] = Json::array();
  for (const GrowthStudy& study : summary.growth) out["growth"].push_back(json_of(study, names));
  out["ratios"] = Json::array();
  for (const Ratio& ratio : summary.ratios) {
    out["ratios"].push_back({{"system", names.system(ratio.system)},
                             {"time", json_of(ratio.time)},
                             {"memory", json_of(ratio.memory)}});
  }
  out["exact_share"] = summary.exact_share ? json_of(*summary.exact_share) : Json();
  out["exact_shares"] = Json::array();
  for (const ExactShare& share : summary.exact_shares) {
    Json entry = {{"family", names.family(share.family)}};
    entry.update(json_of(share));
    out["exact_shares"].push_back(std::move(entry));
  }
  out["truth"] = Json::object();
  for (const TruthCount& truth : summary.truths) out["truth"][truth.confirmed] = truth.problems;
  out["disagreements"] = Json::array();
  for (const Disagreement& d : summary.disagreements) {
    out["disagreements"].push_back({{"problem", d.problem}, {"reason", d.reason}});
  }
  return out;
}

}  // namespace

std::string report_json(const Experiment& experiment, const Summary& summary, const std::string& title) {
  const Names names(experiment);
  Json out = {{"schema", kReportSchema}, {"title", title}};
  out["machine"] = experiment.machine ? Json::parse(to_json(*experiment.machine)) : Json();
  out["systems"] = Json::parse(to_json(experiment.systems));
  out["families"] = Json::parse(to_json(experiment.families));
  out["facts"] = facts_json(experiment, summary, names);
  out["aggregates"] = aggregates(summary, names);
  std::string text = json_text(out);
  text.pop_back();
  // The exact results once, by problem; a row per line, as in its file but for them. Facts that are those of the
  // exact result are the word `exact`.
  std::map<std::string, std::string> truths;
  for (const SweepRow& row : experiment.rows) truths.emplace(row.problem, to_json(row.truth));
  text += ",\"truths\":{";
  for (auto it = truths.begin(); it != truths.end(); ++it)
    text += (it == truths.begin() ? "\n" : ",\n") + Json(it->first).dump() + ":" + it->second;
  text += "\n},\"rows\":[";
  for (std::size_t i = 0; i < experiment.rows.size(); ++i) {
    Json row = Json::parse(to_json(experiment.rows[i]));
    if (row["facts"] == row["truth"]["facts"]) row["facts"] = "exact";
    row.erase("truth");
    text += (i == 0 ? "\n" : ",\n") + json_text(row);
  }
  return text + "\n]}\n";
}

}  // namespace cnrg::bench
