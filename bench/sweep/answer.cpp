#include "bench/sweep/answer.h"

#include <algorithm>
#include <chrono>
#include <istream>
#include <new>
#include <sstream>

#include "bench/sweep/json_fields.h"

namespace cnrg::bench {
namespace {

nlohmann::json no_reply(const std::string& stage, const char* message, bool thrown) {
  nlohmann::json head{{"answered", false}, {"stage", stage}, {"message", message}};
  if (thrown) head["thrown"] = true;
  return head;
}

nlohmann::json measured(const Measures& measures) {
  nlohmann::json stages = nlohmann::json::array();
  for (const auto& [stage, part] : measures.stages) stages.push_back({stage, part});
  return {{"answered", true}, {"stages", stages}, {"own_bytes", measures.own_bytes()}};
}

std::string evaluated_text(const Problem& problem, const System& system, int warm_runs, double seconds) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
  Answer answer = system.evaluate(problem);
  nlohmann::json warm = nlohmann::json::array();  // as many as there is time for
  double longest = elapsed();
  for (int i = 0; i < warm_runs; ++i) {
    const double before = elapsed();
    if (before + 2 * longest > seconds) break;
    const Answer again = system.evaluate(problem);
    warm.push_back(again.measures.seconds());
    longest = std::max(longest, elapsed() - before);
    if (again.model.points == answer.model.points && again.model.faces.size() == answer.model.faces.size())
      continue;
    answer.note = "run " + std::to_string(i + 2) + " has another result than the first";
    break;
  }
  std::ostringstream out;
  nlohmann::json head = measured(answer.measures);
  head.update({{"warm", warm}, {"exact_share", answer.exact_share}, {"note", answer.note}});
  out << json_text(head) << '\n';
  write_model(out, answer.model);
  return out.str();
}

}  // namespace

Reply reply_of(const std::string& text) {
  const std::size_t end = text.find('\n');
  if (end == std::string::npos) return {};
  return {nlohmann::json::parse(text.substr(0, end)), text.substr(end + 1)};
}

std::string guarded_reply(const std::function<std::string()>& work) {
  nlohmann::json head;
  try {
    return work();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const Crash& crash) {
    head = no_reply("signal", crash.what(), true);
  } catch (const Refusal& refusal) {
    head = no_reply(refusal.stage(), refusal.what(), false);
  } catch (const std::exception& error) {
    head = no_reply("unknown", error.what(), true);
  }
  return json_text(head) + "\n";
}

std::string reply_text(const Problem& problem, const System& system, int warm_runs, double seconds) {
  return guarded_reply([&] { return evaluated_text(problem, system, warm_runs, seconds); });
}

std::string comparison_text(Verdict verdict, const std::string& stage, const std::string& message,
                            const Measures& measures) {
  nlohmann::json head = measured(measures);
  head.update({{"verdict", to_string(verdict)}, {"stage", stage}, {"message", message}});
  return json_text(head) + "\n";
}

std::string comparison_text(const SetProblem& problem, const System& system) {
  return guarded_reply([&] {
    const SetComparison found = system.compare_sets(problem);
    const bool same = found.difference.empty();
    return comparison_text(same ? Verdict::same : Verdict::wrong, same ? "" : "set", found.difference,
                           found.measures);
  });
}

void write_problem(std::ostream& out, const Problem& problem) {
  out << "steps";
  for (const Operation step : problem.steps) out << ' ' << to_string(step);
  out << '\n';
  for (const Model& operand : problem.operands) write_model(out, operand);
}

Problem read_problem(std::istream& in) {
  std::string line, word;
  std::getline(in, line);
  std::istringstream words(line);
  if (!(words >> word) || word != "steps") throw std::runtime_error("a problem does not start with `steps`");
  Problem problem;
  while (words >> word) {
    const std::optional<Operation> step = parse_operation(word);
    if (!step) throw std::runtime_error("'" + word + "' is no operation");
    problem.steps.push_back(*step);
  }
  for (std::size_t i = 0; i <= problem.steps.size(); ++i) problem.operands.push_back(read_model(in));
  return problem;
}

}  // namespace cnrg::bench
