// Work on a problem in a process with limits: what it answers, or why it does not.
#pragma once

#include <functional>
#include <new>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>

#include "bench/cases/child.h"
#include "bench/sweep/answer.h"
#include "bench/sweep/json_fields.h"
#include "bench/sweep/row.h"

namespace cnrg::bench {

/// The problem itself cannot be made, such as one of a mesh file that is broken.
class ProblemError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Of a run, where nobody says anything 60 s and 4 GiB.
Limits run_limits(std::optional<double> seconds, std::optional<double> gigabytes);

/// Of what is not timed, from those of a run.
Limits judging_limits(const Limits& limits);

struct Run {
  Limits limits;
  ChildResult child;
  Reply reply;
  bool answered() const {
    return child.end == ChildResult::End::done && reply.head.is_object() && reply.head.value("answered", false);
  }
};

/// The reply of a child. Throws ProblemError if it says that the problem could not be made.
Run run_of(const std::string& name, const Limits& limits, ChildResult child);

/// What `work` says of what `make` makes, both in a process with limits. Throws ProblemError if `make` throws.
template <class Made>
Run run_made(const std::string& name, const Limits& limits, const std::function<Made()>& make,
             const std::function<std::string(const Made&)>& work) {
  return run_of(name, limits,
                run_child(
                    [&] {
                      std::optional<Made> made;
                      try {
                        made.emplace(make());
                      } catch (const std::bad_alloc&) {
                        throw;
                      } catch (const std::exception& error) {
                        return json_text(nlohmann::json{{"answered", false}, {"problem", error.what()}}) + "\n";
                      }
                      return work(*made);
                    },
                    limits));
}

/// Verdict, stage and message of a run without an answer.
void no_answer(const Run& run, SweepRow& row);

/// What a process says, or why it says nothing.
struct Told {
  Reply reply;
  std::string reason;
};

/// `work` gives the head and writes what follows it.
Told told(const Limits& limits, const std::function<nlohmann::json(std::ostream&)>& work);

/// What the program says that has CGAL's assertions on (bench/asserted.cpp). Throws std::runtime_error.
std::string asserted_text(const std::string& program, const char* work, const std::string& system,
                          const std::string& problem);

}  // namespace cnrg::bench
