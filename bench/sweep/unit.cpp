#include "bench/sweep/unit.h"

#include <csignal>
#include <cstring>
#include <new>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "bench/sweep/judge.h"

namespace cnrg::bench {
namespace {

using Json = nlohmann::json;
using End = ChildResult::End;

/// What a process says of itself: a head in one line, then a model or nothing.
struct Reply {
  Json head;
  std::string rest;
};
Reply reply_of(const std::string& text) {
  const std::size_t end = text.find('\n');
  if (end == std::string::npos) return {};  // it ended in the middle of its work
  return {Json::parse(text.substr(0, end)), text.substr(end + 1)};
}

struct Run {
  ChildResult child;
  Reply reply;
  bool answered() const { return child.end == End::done && reply.head.value("answered", false); }
};

/// The work of the process that runs a system.
std::string answer_text(const Setup& setup, const std::string& name, const System& system) {
  Problem problem;
  try {
    problem = setup.make(name);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    return Json{{"answered", false}, {"problem", error.what()}}.dump() + "\n";
  }
  try {
    const Answer answer = system.evaluate(problem);
    Json stages = Json::array();
    for (const auto& [stage, seconds] : answer.measures.stages) stages.push_back({stage, seconds});
    std::ostringstream out;
    out << Json{{"answered", true},
                {"stages", stages},
                {"own_bytes", answer.measures.own_bytes()},
                {"exact_share", answer.exact_share},
                {"note", answer.note}}
               .dump()
        << '\n';
    write_model(out, answer.model);
    return out.str();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const Crash& crash) {
    return Json{{"answered", false}, {"stage", "signal"}, {"message", crash.what()}, {"thrown", true}}.dump() +
           "\n";
  } catch (const Refusal& refusal) {
    return Json{{"answered", false}, {"stage", refusal.stage()}, {"message", refusal.what()}}.dump() + "\n";
  } catch (const std::exception& error) {
    return Json{{"answered", false}, {"stage", "unknown"}, {"message", error.what()}, {"thrown", true}}.dump() +
           "\n";
  }
}

Run run(const Setup& setup, const std::string& problem, const System& system) {
  Run result;
  result.child = run_child([&] { return answer_text(setup, problem, system); }, setup.limits);
  if (result.child.end == End::done) result.reply = reply_of(result.child.text);
  if (result.reply.head.contains("problem"))
    throw ProblemError(problem + " could not be made: " + result.reply.head["problem"].get<std::string>());
  return result;
}

Limits judging_limits(const Limits& limits) { return {5 * limits.seconds, 3 * limits.bytes}; }

/// A judgement from another process, or why there is none.
struct Judged {
  std::optional<Judgement> judgement;
  std::string reason;
};

std::string why(const ChildResult& child, double limit) {
  switch (child.end) {
    case End::timeout: return "no result in " + std::to_string(static_cast<long>(limit)) + " s";
    case End::out_of_memory: return "memory ran out";
    case End::crash: return "crashed: " + std::string(strsignal(child.signal));
    case End::done: break;
  }
  return "ended without a result";
}

using Judge = Judgement(const Problem&, const Model&, double);

Judged judged_by(Judge* judge, const Setup& setup, const std::string& name, const System& system,
                 const std::string& model) {
  const Limits limits = judging_limits(setup.limits);
  const ChildResult child = run_child(
      [&] {
        try {
          std::istringstream in(model);
          const Judgement j = judge(setup.make(name), read_model(in), system.rounding);
          Json out{{"verdict", to_string(j.verdict)}, {"stage", j.stage},   {"message", j.message},
                   {"truth", to_json(j.truth)},       {"excess", j.excess}, {"missing", j.missing},
                   {"duplicates", j.duplicates}};
          if (j.facts) out["facts"] = to_json(*j.facts);
          return out.dump() + "\n";
        } catch (const std::bad_alloc&) {
          throw;
        } catch (const std::exception& error) {
          return Json{{"error", error.what()}}.dump() + "\n";
        }
      },
      limits);
  const Json head = child.end == End::done ? reply_of(child.text).head : Json();
  if (head.is_null()) return {{}, "judging: " + why(child, limits.seconds)};
  if (head.contains("error")) return {{}, "judging: " + head["error"].get<std::string>()};
  Judgement j;
  j.verdict = parse_verdict(head.at("verdict").get<std::string>()).value();
  head.at("stage").get_to(j.stage);
  head.at("message").get_to(j.message);
  head.at("excess").get_to(j.excess);
  head.at("missing").get_to(j.missing);
  head.at("duplicates").get_to(j.duplicates);
  j.truth = facts_of_json(head.at("truth").get<std::string>());
  if (head.contains("facts")) j.facts = facts_of_json(head["facts"].get<std::string>());
  return {j, {}};
}

Judged judged(const Setup& setup, const std::string& name, const System& system, const std::string& model) {
  const Judged compared = judged_by(judge, setup, name, system, model);
  if (compared.judgement) return compared;
  const Judged by_volume = judged_by(judge_by_volume, setup, name, system, model);
  return by_volume.judgement && by_volume.judgement->verdict == Verdict::wrong ? by_volume : compared;
}

/// Names and sizes of the problem, by a process of its own: this one stays small.
void describe(const Setup& setup, SweepRow& row) {
  const ChildResult child = run_child(
      [&] {
        try {
          const Problem problem = setup.make(row.problem);
          return Json{{"operands", problem.operands.size()},
                      {"triangles", problem.triangle_count()},
                      {"operation", to_string(problem.steps.at(0))}}
                     .dump() +
                 "\n";
        } catch (const std::exception& error) {
          return Json{{"error", error.what()}}.dump() + "\n";
        }
      },
      judging_limits(setup.limits));
  const Json head = child.end == End::done ? reply_of(child.text).head : Json();
  if (head.is_null())
    throw ProblemError(row.problem + " could not be made: " + why(child, judging_limits(setup.limits).seconds));
  if (head.contains("error"))
    throw ProblemError(row.problem + " could not be made: " + head["error"].get<std::string>());
  head.at("operands").get_to(row.operands);
  head.at("triangles").get_to(row.triangles);
  if (!setup.folder.empty()) {
    row.family = kFilesFamily;
    head.at("operation").get_to(row.operation);
    row.size = static_cast<long>(row.triangles);
    return;
  }
  const ProblemId id = ProblemId::parse(row.problem);
  row.family = id.family;
  row.operation = id.operation;
  row.size = id.size;
  row.distance = id.distance;
  row.seed = id.seed;
  for (const Family& family : families())
    if (family.name == id.family) row.has_distance = family.has_distance;
}

void no_answer(const Run& run, double limit, SweepRow& row) {
  row.seconds = run.child.seconds;
  row.message = why(run.child, limit);
  switch (run.child.end) {
    case End::timeout: row.verdict = Verdict::timed_out, row.stage = "time"; return;
    case End::out_of_memory: row.verdict = Verdict::out_of_memory, row.stage = "memory"; return;
    case End::crash: row.verdict = Verdict::crashed, row.stage = "signal"; return;
    case End::done: break;
  }
  if (run.reply.head.is_null()) {
    row.verdict = Verdict::crashed;
    return;
  }
  row.verdict = run.reply.head.value("thrown", false) ? Verdict::crashed : Verdict::refused;
  run.reply.head.at("stage").get_to(row.stage);
  run.reply.head.at("message").get_to(row.message);
}

}  // namespace

Problem Setup::make(const std::string& problem) const {
  return folder.empty() ? make_problem(ProblemId::parse(problem)) : make_folder_problem(folder, problem);
}

const System& Setup::system(const std::string& name) const {
  std::string known;
  for (const System& system : systems) {
    if (system.name == name) return system;
    known += (known.empty() ? "" : ", ") + system.name;
  }
  throw std::runtime_error("there is no system '" + name + "'; there are " + known +
                           ", and any program by `--system NAME=PROGRAM`");
}

Truth establish_truth(const Setup& setup, const std::string& problem) {
  Truth truth;
  for (const char* const name : {"nef", "corefinement"}) {
    const System& system = setup.system(name);
    const auto add_reason = [&](const std::string& reason) {
      truth.reason += (truth.reason.empty() ? "" : "; ") + std::string(name) + ": " + reason;
    };
    const Run r = run(setup, problem, system);
    if (!r.answered()) {
      SweepRow row;
      no_answer(r, setup.limits.seconds, row);
      add_reason(row.message);
      continue;
    }
    const Judged j = judged(setup, problem, system, r.reply.rest);
    if (!j.judgement) {
      add_reason(j.reason);
      continue;
    }
    truth.facts = j.judgement->truth;
    if (system.rounding == 0) {
      const Verdict v = j.judgement->verdict;
      const bool agrees = v == Verdict::same || v == Verdict::contact_duplicated;
      truth.confirmed = agrees ? "Nef" : "DISAGREES";
      if (!agrees) add_reason(j.judgement->message);
      return truth;
    }
    if (is_failure(j.judgement->verdict)) {
      add_reason(j.judgement->message);
      continue;
    }
    truth.confirmed = "volume";
    return truth;
  }
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
  const Limits usual = Setup().limits;
  std::ostringstream text;
  text << "bench/run ";
  if (!setup.folder.empty()) text << quoted(setup.folder) << ' ';
  text << "--one " << quoted(problem) << ' ' << quoted(system.name);
  if (!system.executable.empty())
    text << " --system " << quoted(system.name + "=" + system.executable) << ':' << system.rounding;
  if (setup.limits.seconds != usual.seconds) text << " --seconds " << setup.limits.seconds;
  if (setup.limits.bytes != usual.bytes)
    text << " --gigabytes " << static_cast<double>(setup.limits.bytes) / (1 << 30);
  return text.str();
}

SweepRow run_unit(const Setup& setup, const std::string& problem, const std::string& name, const Truth& truth) {
  const System& system = setup.system(name);
  SweepRow row;
  row.problem = problem;
  row.system = name;
  row.truth = truth;
  row.limit_seconds = setup.limits.seconds;
  row.limit_bytes = setup.limits.bytes;
  row.command = reproducing_command(setup, problem, system);
  describe(setup, row);

  const Run r = run(setup, problem, system);
  row.peak_bytes = r.child.peak_bytes;
  if (!r.answered()) {
    no_answer(r, setup.limits.seconds, row);
    return row;
  }
  for (const Json& stage : r.reply.head.at("stages")) {
    row.stages.emplace_back(stage.at(0).get<std::string>(), stage.at(1).get<double>());
    row.seconds += row.stages.back().second;
  }
  r.reply.head.at("own_bytes").get_to(row.own_bytes);
  r.reply.head.at("exact_share").get_to(row.exact_share);
  r.reply.head.at("note").get_to(row.note);

  const Judged j = judged(setup, problem, system, r.reply.rest);
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
  return row;
}

}  // namespace cnrg::bench
