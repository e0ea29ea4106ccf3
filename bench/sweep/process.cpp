#include "bench/sweep/process.h"

#include <cstring>
#include <fstream>
#include <sstream>

#include "bench/peers/program.h"

namespace cnrg::bench {

using End = ChildResult::End;
using Json = nlohmann::json;

Limits run_limits(std::optional<double> seconds, std::optional<double> gigabytes) {
  return {seconds.value_or(60), static_cast<std::size_t>(gigabytes.value_or(4) * (1 << 30))};
}

Limits judging_limits(const Limits& limits) { return {5 * limits.seconds, 3 * limits.bytes}; }

namespace {

std::string why(const ChildResult& child, double limit) {
  switch (child.end) {
    case End::timeout: return "no result in " + to_decimal(from_double(limit)) + " s";
    case End::out_of_memory: return "memory ran out";
    case End::crash: return "crashed: " + std::string(strsignal(child.signal));
    case End::done: break;
  }
  return "ended without a result";
}

}  // namespace

Run run_of(const std::string& name, const Limits& limits, ChildResult child) {
  Run run{limits, std::move(child), {}};
  if (run.child.end == End::done) run.reply = reply_of(run.child.text);
  if (run.reply.head.is_object() && run.reply.head.contains("problem"))
    throw ProblemError(name + " could not be made: " + run.reply.head["problem"].get<std::string>());
  return run;
}

void no_answer(const Run& run, SweepRow& row) {
  row.seconds = run.child.seconds;
  row.message = why(run.child, run.limits.seconds);
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

Told told(const Limits& limits, const std::function<Json(std::ostream&)>& work) {
  const ChildResult child = run_child(
      [&] {
        std::ostringstream rest;
        try {
          const Json head = work(rest);
          return json_text(head) + "\n" + rest.str();
        } catch (const std::bad_alloc&) {
          throw;
        } catch (const std::exception& error) {
          return json_text(Json{{"error", error.what()}}) + "\n";
        }
      },
      limits);
  Told told;
  if (child.end == End::done) told.reply = reply_of(child.text);
  const Json& head = told.reply.head;
  if (head.is_null()) told.reason = why(child, limits.seconds);
  else if (head.contains("error")) told.reason = head["error"].get<std::string>();
  return told;
}

std::string asserted_text(const std::string& program, const char* work, const std::string& system,
                          const std::string& problem) {
  const TemporaryFolder folder;
  std::ofstream out(folder.file("problem"));
  out << problem;
  out.close();
  const std::string answer = folder.file("answer");
  const ProgramRun run = run_program({program, work, system, folder.file("problem")}, folder, answer.c_str());
  if (!out || !run.succeeded()) throw std::runtime_error(out ? run.reason() : "a file could not be written");
  std::ostringstream text;
  text << std::ifstream(answer).rdbuf();
  return text.str();
}

}  // namespace cnrg::bench
