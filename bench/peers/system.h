// The systems that a sweep compares, behind one interface. Each run is a process of its own: a system may crash.
#pragma once

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bench/cases/family.h"
#include "bench/cases/measurement.h"
#include "bench/cases/node_problem.h"

namespace cnrg::bench {

/// What a system gives back.
struct Answer {
  Model model;
  Measures measures;  ///< from operands in memory, in the system's own form or not, to its result in memory
  double exact_share =
      -1;            ///< of predicate calls that went to exact arithmetic; negative: the system does not say
  std::string note;  ///< a few words, or empty
};

/// How the value of a node differs from the system's own.
struct SetComparison {
  std::string difference;  ///< in words; empty: they are the same set
  Measures measures;       ///< from operands in memory to the system's value
};

/// The system itself says that it has no result, or stops at what it cannot do: a verdict, no fault of ours.
class Refusal : public std::runtime_error {
 public:
  Refusal(std::string stage, const std::string& what) : std::runtime_error(what), stage_(std::move(stage)) {}
  const std::string& stage() const { return stage_; }  ///< such as `input`, `connecting`, `output`

 private:
  std::string stage_;
};

/// The program that is the system ended by a signal.
class Crash : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// How a system differs from another one: by one rule, which it has or has not.
struct Variation {
  std::string of;  ///< the other one's name; empty: it differs from none
  std::string rule;
  bool on = false;
};

struct System {
  std::string name;       ///< in options, rows and file names, such as `mantyla-double`
  std::string title;      ///< for people
  std::string guarantee;  ///< what it takes and promises, in one line: named beside the numbers
  std::function<std::string()> version;
  /// How far the coordinates of results may be from the exact ones, as a part of the largest coordinate; 0: exact.
  double rounding = 0;
  bool regularized = true;  ///< by its own contract results are closed solids and nothing else
  std::string absent;       ///< why it cannot run here and what to install; empty: it can
  /// Throws Refusal and Crash; whatever else it throws counts as a failure of the system at stage `unknown`.
  std::function<Answer(const Problem&)> evaluate;
  bool if_named = false;  ///< it is given problems only where somebody names it
  /// Whether a model is the exact result, by code of the system alone; empty: it has none. Throws as `evaluate`.
  std::function<bool(const Problem&, const Model&)> agrees{};
  // Of nodes of any operator; empty: it has nothing of the kind. They throw as `evaluate`.
  std::function<SetComparison(const SetProblem&)> compare_sets{};  ///< by itself
  std::function<Arrangement(const std::vector<ParcelledOperand>&)>
      arrange{};          ///< of as many operands as there are
  bool asserted = false;  ///< of CGAL: verdicts are those of bench_asserted, which has it with CGAL's assertions
  std::string executable{};  ///< of one that the command line names
  Variation varies{};
};

/// Those built in, ours first: ours, ours-tree, mantyla-double, mantyla-exact, nef, corefinement, occt, openscad,
/// mantyla-published, mantyla-published-exact.
/// They do nothing to operands, but for occt-rescaled and openscad-rescaled, whose `guarantee` says what.
std::vector<System> systems();

/// `mantyla-double:1e-8`: that baseline with another epsilon, which is its rounding, too; `mantyla-double-arcs` or
/// `mantyla-exact-arcs`: without that departure (bench/baseline/departures.h); `mantyla-published` and
/// `mantyla-published-exact`: without all of them; `mantyla-published:1e-6+arcs+checks`. Nothing for other names.
/// Throws std::runtime_error for what is no epsilon, and rules that are none or change nothing.
std::optional<System> mantyla_variant(const std::string& name);

/// The system with operands multiplied by a power of two that makes their largest coordinate 2^exponent or more;
/// its results are divided by it, and its time is that of the system alone. Its title says so.
System rescaled(System system, int exponent, double rounding);

/// Any program: `PROGRAM... OPERATION A.off B.off OUT.off` for each step, status 0 when OUT.off is written;
/// another status is a refusal with the last line that it wrote to standard error, a signal a crash. `rounding` as
/// above.
System external_system(const std::string& name, const std::vector<std::string>& program, double rounding);

}  // namespace cnrg::bench
