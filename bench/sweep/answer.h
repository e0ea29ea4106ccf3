// What a process that runs a system is given, and what it says: texts, so that the process can be another program.
#pragma once

#include <functional>
#include <iosfwd>
#include <nlohmann/json.hpp>
#include <string>

#include "bench/peers/system.h"
#include "bench/sweep/row.h"

namespace cnrg::bench {

/// A head in one line, then a model or nothing.
struct Reply {
  nlohmann::json head;
  std::string rest;
};
/// Of a text that ends in the head: nothing.
Reply reply_of(const std::string& text);

/// What `work` returns, or a reply with the stage and message of what it threw; `std::bad_alloc` goes on.
std::string guarded_reply(const std::function<std::string()>& work);

/// Evaluates once, and again up to `warm_runs` times while that ends within `seconds`.
std::string reply_text(const Problem& problem, const System& system, int warm_runs, double seconds);

/// The reply of a system that compares a node: verdict, and what is wrong at which stage.
std::string comparison_text(Verdict verdict, const std::string& stage, const std::string& message,
                            const Measures& measures);
std::string comparison_text(const SetProblem& problem, const System& system);

/// Operands and steps; `read_problem` throws std::runtime_error for a text that is none.
void write_problem(std::ostream& out, const Problem& problem);
Problem read_problem(std::istream& in);

}  // namespace cnrg::bench
