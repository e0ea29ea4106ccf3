#include "bench/sweep/unit.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "bench/sweep/confirm.h"
#include "bench/sweep/judged.h"
#include "bench/sweep/node_unit.h"
#include "csg/text/number.h"
#include "csg/tree/suggest.h"

namespace cnrg::bench {
namespace {

using Json = nlohmann::json;
using End = ChildResult::End;

/// What `work` says of a problem, in a process with limits. Throws ProblemError.
Run run_by(const Setup& setup, const std::string& name, const Limits& limits,
           const std::function<std::string(const Problem&)>& work) {
  return run_made<Problem>(
      name, limits, [&] { return setup.make(name); }, work);
}

/// What a process says within the limits of judging.
Told told_of(const Setup& setup, const std::string& problem, const std::function<Json(std::ostream&)>& work) {
  return told(judging_limits(setup.limits(problem)), work);
}

Judged judged_of(const Setup& setup, const std::string& name, double rounding, const std::string& model) {
  return judged([&] { return setup.make(name); }, judging_limits(setup.limits(name)), rounding, model);
}

std::string asserted_reply(const Setup& setup, const char* work, const std::string& system, const Problem& problem,
                           const std::string& model = {}) {
  std::ostringstream text;
  write_problem(text, problem);
  return asserted_text(setup.asserted, work, system, text.str() + model);
}

Run run_plainly(const Setup& setup, const std::string& problem, const System& system) {
  return run_by(setup, problem, setup.limits(problem), [&](const Problem& made) {
    return reply_text(made, system, setup.experiment_of(problem).warm_runs, setup.limits(problem).seconds);
  });
}

Run run_asserted(const Setup& setup, const std::string& problem, const System& system) {
  return run_by(setup, problem, judging_limits(setup.limits(problem)), [&](const Problem& made) {
    return guarded_reply([&] { return asserted_reply(setup, "evaluate", system.name, made); });
  });
}

/// What verdicts are made of: with assertions, where the system has them.
Run run(const Setup& setup, const std::string& problem, const System& system) {
  return system.asserted ? run_asserted(setup, problem, system) : run_plainly(setup, problem, system);
}

double seconds_of(const Run& run) {
  double seconds = 0;
  for (const Json& stage : run.reply.head.at("stages")) seconds += stage.at(1).get<double>();
  return seconds;
}

/// As many points and faces, and of exact systems the same points: their order depends on addresses, and rounded
/// ones on which numbers an assertion had evaluated exactly before.
bool is_same_model(const std::string& a, const std::string& b, bool exact) {
  if (a == b) return true;
  std::istringstream in_a(a), in_b(b);
  Model first = read_model(in_a), second = read_model(in_b);
  std::sort(first.points.begin(), first.points.end());
  std::sort(second.points.begin(), second.points.end());
  return first.points.size() == second.points.size() && first.faces.size() == second.faces.size() &&
         (!exact || first.points == second.points);
}

/// And once more without them, for time and memory, within the limits of a run. `asserted_seconds` is set if both
/// have the same result; else a note says that they do not, and all is of the run with assertions.
Run run_and_time(const Setup& setup, const std::string& problem, const System& system,
                 std::optional<double>& asserted_seconds) {
  Run asserted = run(setup, problem, system);
  if (!system.asserted || !asserted.answered()) return asserted;
  Run plain = run_plainly(setup, problem, system);
  if (plain.answered() && is_same_model(plain.reply.rest, asserted.reply.rest, system.rounding == 0)) {
    asserted_seconds = seconds_of(asserted);
    return plain;
  }
  if (plain.child.end == End::timeout || plain.child.end == End::out_of_memory) return plain;
  asserted.reply.head["note"] = plain.answered() ? "without CGAL's assertions the result is another one"
                                                 : "without CGAL's assertions there is no result";
  return asserted;
}

/// Sizes of a problem, by a process of its own: this one stays small.
Json described(const Setup& setup, const std::string& name) {
  const auto [reply, reason] = told_of(setup, name, [&](std::ostream&) {
    if (setup.experiment_of(name).compared != Compared::results) return described_node(setup, name);
    const Problem problem = setup.make(name);
    std::ostringstream operands;
    for (const Model& operand : problem.operands) write_model(operands, operand);
    const auto& steps = problem.steps;
    const bool mixed = std::any_of(steps.begin(), steps.end(), [&](Operation o) { return o != steps[0]; });
    return Json{{"operands", problem.operands.size()},
                {"digest", digest(operands.str())},
                {"triangles", problem.triangle_count()},
                {"operation", mixed ? "fold" : to_string(steps.at(0))}};
  });
  if (!reason.empty()) throw ProblemError(name + " could not be made: " + reason);
  return reply.head;
}

void describe(const Setup& setup, SweepRow& row) {
  const Json head = described(setup, row.problem);
  if (!row.truth.digest.empty() && row.truth.digest != head.at("digest"))
    throw ProblemError(row.problem +
                       " has other operands than when this sweep began: a file that it reads, or a "
                       "program, has changed; give another folder by --out");
  head.at("operands").get_to(row.operands);
  head.at("triangles").get_to(row.triangles);
  const Setup::Planned& planned = setup.planned(row.problem);
  const Experiment& experiment = setup.experiments[planned.experiment];
  const ProblemId id = experiment.roles(planned.problem);
  row.family = experiment.name;
  row.values = planned.problem.values;
  row.operation = id.operation.empty() ? head.at("operation").get<std::string>() : id.operation;
  const bool grows = experiment.compared == Compared::results;  // else times have assertions, too
  row.size = id.size >= 0 ? id.size : grows ? static_cast<long>(row.triangles) : 0;
  row.distance = id.distance;
  row.seed = id.seed;
  row.has_distance = planned.problem.values.contains("k");
}

}  // namespace

const Setup::Planned& Setup::planned(const std::string& problem) const {
  for (const Planned& planned : problems)
    if (planned.problem.name == problem) return planned;
  throw std::runtime_error("there is no problem '" + problem + "'; `--dry-run` lists those of an experiment");
}

const Experiment& Setup::experiment_of(const std::string& problem) const {
  return experiments[planned(problem).experiment];
}

Problem Setup::make(const std::string& problem) const {
  return experiment_of(problem).make(planned(problem).problem);
}

Limits Setup::limits(const std::string& problem) const {
  const Experiment& experiment = experiment_of(problem);
  return run_limits(seconds ? seconds : experiment.seconds, gigabytes ? gigabytes : experiment.gigabytes);
}

const System& Setup::system(const std::string& name) const {
  std::string known;
  for (const System& system : systems) {
    if (system.name == name) return system;
    known += (known.empty() ? "" : ", ") + system.name;
  }
  std::vector<std::string_view> names;
  for (const System& system : systems) names.push_back(system.name);
  const std::string hint = did_you_mean(name, names);
  throw std::runtime_error(
      "there is no system '" + name + "'" +
      (hint.empty() ? "; there are " + known + ", and any program by `--system NAME=PROGRAM`" : hint));
}

namespace {

/// What the experiment claims of a problem: a judgement of the point set of another node, or a volume.
struct ClaimedTruth {
  std::optional<Judgement> node;
  std::string volume;  ///< empty: none
  std::string reason;  ///< why there is nothing that was to be there
};

ClaimedTruth claimed_truth(const Setup& setup, const std::string& problem) {
  const auto [reply, reason] = told_of(setup, problem, [&](std::ostream& out) {
    const Claimed claimed = setup.experiment_of(problem).claimed(setup.planned(problem).problem);
    if (claimed.result) write_model(out, *claimed.result);
    return Json{{"node", claimed.result.has_value()},
                {"volume", claimed.volume ? cnrg::to_string(*claimed.volume) : ""}};
  });
  if (!reason.empty()) return {{}, {}, reason};
  ClaimedTruth claim{{}, reply.head["volume"], {}};
  if (!reply.head["node"].get<bool>()) return claim;
  const Judged judgement = judged_of(setup, problem, 0, reply.rest);
  claim.node = judgement.judgement;
  claim.reason = judgement.reason;
  return claim;
}

/// Of the exact result; of nothing, with an empty volume, if they cannot be had within the limits.
Facts exact_facts_of(const Setup& setup, const std::string& problem) {
  const auto [reply, reason] = told_of(
      setup, problem, [&](std::ostream&) { return Json::parse(to_json(exact_facts(setup.make(problem)))); });
  if (reason.empty()) return facts_of_json(reply.head.dump());
  Facts none;
  none.volume.clear();
  return none;
}

/// Whether Nef polyhedra have this result, compared by themselves. Nothing, with the reason, if they cannot say.
std::optional<bool> agrees_with_nef(const Setup& setup, const std::string& problem, const std::string& model,
                                    std::string& why_not) {
  const auto [reply, reason] = told_of(setup, problem, [&](std::ostream&) {
    return Json::parse(asserted_reply(setup, "agrees", "nef", setup.make(problem), model));
  });
  why_not = reason;
  return reason.empty() ? std::optional<bool>(reply.head["agrees"].get<bool>()) : std::nullopt;
}

std::optional<bool> ours_agrees_with_nef(const Setup& setup, const std::string& problem, std::string& why_not) {
  const Run ours = run(setup, problem, setup.system("ours"));
  if (ours.answered()) return agrees_with_nef(setup, problem, ours.reply.rest, why_not);
  why_not = "ours has no result";
  return {};
}

bool is_same(Verdict verdict) { return verdict == Verdict::same || verdict == Verdict::contact_duplicated; }

/// By Nef polyhedra where they know the exact result, the system is exact, and a witness could not say all.
Confirmation confirmed_by_nef(const Setup& setup, const SweepRow& row, const std::string& model) {
  if ((row.system == "ours" || row.system == "nef") && is_same(row.verdict))
    return {"Nef", ""};  // they are what was compared
  std::string reason;
  const std::optional<bool> agrees = agrees_with_nef(setup, row.problem, model, reason);
  if (!agrees) return {"none", "nef: " + reason};
  if (*agrees == is_same(row.verdict)) return {"Nef", ""};
  return {"DISPUTED", std::string("Nef: the result is ") + (*agrees ? "the same set" : "another set")};
}

Confirmation confirmed(const Setup& setup, const SweepRow& row, const System& system, const std::string& model) {
  const bool nef = row.truth.confirmed == "Nef" && system.rounding == 0;
  const Facts& exact = row.truth.facts;
  const bool loose = exact.dangling_faces + exact.dangling_edges + exact.dangling_vertices > 0;
  const bool compared = (row.system == "ours" || row.system == "nef") && is_same(row.verdict);
  if (nef && (loose || compared)) return confirmed_by_nef(setup, row, model);
  const auto witnessed = [&](bool integrals) {
    return told_of(setup, row.problem, [&](std::ostream&) {
      std::istringstream in(model);
      const Confirmation c = confirm_by_witness(setup.make(row.problem), read_model(in), system.rounding,
                                                row.verdict, row.stage, integrals);
      return Json{{"by", c.by}, {"reason", c.reason}};
    });
  };
  Told witness = witnessed(true);
  if (!witness.reason.empty()) witness = witnessed(false);
  if (!witness.reason.empty()) return {"none", "confirming: " + witness.reason};
  const Json& head = witness.reply.head;
  if (nef && head["by"] == "none") return confirmed_by_nef(setup, row, model);
  return {head["by"], head["reason"]};
}

}  // namespace

Truth establish_truth(const Setup& setup, const std::string& problem) {
  Truth truth;
  truth.experiment = setup.experiment_of(problem).path;
  truth.digest = described(setup, problem).at("digest");
  if (setup.experiment_of(problem).compared != Compared::results) {
    truth.facts.volume.clear();
    truth.reason = "the value of a node is what its rows compare";
    return truth;
  }
  const auto add_reason = [&](const std::string& who, const std::string& reason) {
    truth.reason += (truth.reason.empty() ? "" : "; ") + who + ": " + reason;
  };
  const auto disagrees = [&](const std::string& who, const std::string& reason) {
    truth.confirmed = "DISAGREES";
    add_reason(who, reason);
    return truth;
  };
  /// A judged answer of a system, or nothing.
  const auto asked = [&](const char* name) -> std::optional<Judgement> {
    const Run r = run(setup, problem, setup.system(name));
    if (!r.answered()) {
      SweepRow row;
      no_answer(r, row);
      add_reason(name, row.message);
      return {};
    }
    const Judged j = judged_of(setup, problem, setup.system(name).rounding, r.reply.rest);
    if (!j.judgement) add_reason(name, j.reason);
    else truth.facts = j.judgement->truth;
    return j.judgement;
  };
  std::string reason;
  const std::optional<bool> nef = ours_agrees_with_nef(setup, problem, reason);
  if (nef) {
    truth.facts = exact_facts_of(setup, problem);
    if (!*nef) return disagrees("nef", "its result is another set than ours");
    truth.confirmed = "Nef";
  } else if (const std::optional<Judgement> compared = asked("nef")) {
    if (!is_same(compared->verdict)) return disagrees("nef", compared->message);
    truth.confirmed = "Nef-by-us";
    add_reason("nef", "did not compare by itself: " + reason);
  }
  const ClaimedTruth claim = claimed_truth(setup, problem);
  const std::string who = "the truth that " + setup.experiment_of(problem).path + " claims";
  if (!claim.reason.empty()) return disagrees(who, claim.reason);
  if (claim.node && !is_same(claim.node->verdict)) return disagrees(who, claim.node->message);
  if (!claim.volume.empty()) {
    if (truth.confirmed == "none") truth.facts = exact_facts_of(setup, problem);
    const std::string& exact = truth.facts.volume;
    if (exact.empty()) add_reason(who, "our own volume could not be had within the limits");
    else if (exact != claim.volume)
      return disagrees(who, "the volume is " + number_text(*parse_rational(claim.volume), "") + ", ours " +
                                number_text(*parse_rational(exact), ""));
  }
  if (truth.confirmed == "none" && claim.node) {
    truth.facts = claim.node->truth;
    truth.confirmed = "node";
  } else if (truth.confirmed == "none" && !claim.volume.empty() && !truth.facts.volume.empty()) {
    truth.confirmed = "formula";
  }
  if (truth.confirmed != "none") return truth;
  const std::optional<Judgement> corefinement = asked("corefinement");
  if (corefinement && is_failure(corefinement->verdict)) add_reason("corefinement", corefinement->message);
  else if (corefinement) truth.confirmed = "volume";
  return truth;
}

std::string quoted(const std::string& word) {
  if (word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./=:,+") ==
      std::string::npos)
    return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::string reproducing_command(const Setup& setup, const std::string& problem, const System& system) {
  const Setup::Planned& planned = setup.planned(problem);
  const Experiment& experiment = setup.experiments[planned.experiment];
  std::ostringstream text;
  text << "bench/run ";
  if (!experiment.is_own()) text << quoted(experiment.path) << ' ';
  text << "--one " << quoted(problem) << ' ' << quoted(system.name);
  for (const Parameter& p : experiment.parameters) {
    const std::string& value = planned.problem.values.at(p.name);
    if (std::find(p.usual.begin(), p.usual.end(), value) == p.usual.end())
      text << " -D " << quoted(p.name + "=" + value);
  }
  if (!system.executable.empty())
    text << " --system " << quoted(system.name + "=" + system.executable) << ':' << system.rounding;
  if (setup.seconds) text << " --seconds " << *setup.seconds;
  if (setup.gigabytes) text << " --gigabytes " << *setup.gigabytes;
  return text.str();
}

SweepRow run_unit(const Setup& setup, const std::string& problem, const std::string& name, const Truth& truth,
                  std::optional<Model>* result) {
  const System& system = setup.system(name);
  SweepRow row;
  row.problem = problem;
  row.system = name;
  row.truth = truth;
  row.limit_seconds = setup.limits(problem).seconds;
  row.limit_bytes = setup.limits(problem).bytes;
  if (getloadavg(&row.load, 1) != 1) row.load = 0;
  row.command = reproducing_command(setup, problem, system);
  describe(setup, row);
  if (setup.experiment_of(problem).compared != Compared::results) {
    compare_node(setup, system, row);
    return row;
  }

  const Run r = run_and_time(setup, problem, system, row.asserted_seconds);
  row.peak_bytes = r.child.peak_bytes;
  if (!r.answered()) {
    no_answer(r, row);
    return row;
  }
  for (const Json& stage : r.reply.head.at("stages")) {
    row.stages.emplace_back(stage.at(0).get<std::string>(), stage.at(1).get<double>());
    row.seconds += row.stages.back().second;
  }
  r.reply.head.at("warm").get_to(row.warm);
  r.reply.head.at("own_bytes").get_to(row.own_bytes);
  r.reply.head.at("exact_share").get_to(row.exact_share);
  r.reply.head.at("note").get_to(row.note);

  if (result != nullptr) {
    std::istringstream in(r.reply.rest);
    *result = read_model(in);
  }
  const Judged j = judged_of(setup, problem, system.rounding, r.reply.rest);
  if (!j.judgement) {
    row.verdict = Verdict::unjudged;
    row.message = j.reason;
    return row;
  }
  row.verdict = j.judgement->verdict;
  row.message = j.judgement->message;
  row.stage = j.judgement->stage;
  row.facts = j.judgement->facts;
  row.excess = j.judgement->excess;
  row.missing = j.judgement->missing;
  row.duplicates = j.judgement->duplicates;
  row.truth.facts = j.judgement->truth;
  row.confirmation = confirmed(setup, row, system, r.reply.rest);
  return row;
}

}  // namespace cnrg::bench
