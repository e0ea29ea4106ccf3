// The aggregates of a report: everything that its tables, plots and main facts say, computed from rows.
//
// Systems are places in Experiment::systems, families in Experiment::families. A run is right when it
// was judged and its verdict is no failure; seconds and memory are looked at for right runs only. Rates are parts
// of the judged runs.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bench/report/experiment.h"
#include "bench/report/fit.h"

namespace cnrg::bench {

/// Verdicts as a reader groups them.
enum class Class { exact, right, wrong, refused, no_result, unjudged };
Class class_of(Verdict verdict);
/// Exact, or right by another contract.
bool is_right(Verdict verdict);

/// Runs by verdict.
struct Tally {
  std::array<std::size_t, kVerdicts> counts{};
  void add(Verdict verdict) { ++counts[static_cast<std::size_t>(verdict)]; }
  void add(const Tally& other);
  std::size_t of(Verdict verdict) const { return counts[static_cast<std::size_t>(verdict)]; }
  std::size_t of(Class wanted) const;
  std::size_t runs() const;
  std::size_t judged() const;
  std::size_t right() const;
  std::size_t failures() const;
  double failure_rate() const;  ///< of the judged, 0 to 1; 0 without any
};

struct FamilyTally {
  std::size_t family = 0, problems = 0;
  bool has_distance = false;
  std::vector<Tally> systems;
};

/// Failures of a system at a stage.
struct StageTally {
  std::size_t system = 0;
  std::string stage;  ///< `unknown` when the row does not say
  Tally tally;
  std::string problem, message;  ///< of the first of them
};

/// Runs at one distance. `k`: see SweepRow::distance; none: exactly degenerate.
struct DistancePoint {
  std::optional<int> k;
  Tally tally;
};

struct DistanceCurve {
  std::size_t system = 0;
  std::vector<DistancePoint> points;  ///< far to near, `exact` last; those that have judged runs
  std::optional<std::size_t> onset;   ///< the first point with a failure rate of `kOnset` or more
  std::size_t worst = 0;              ///< the first point with the highest failure rate
};
inline constexpr double kOnset = 0.01;

/// Failures against distance, in one family or in all that have distances. A system that refuses all problems of a
/// family at stage `input` takes no such operands; these runs are left out.
struct DistanceStudy {
  std::optional<std::size_t> family;
  std::vector<DistanceCurve> curves;  ///< of systems that have runs
};

/// Medians over the right runs of one size.
struct GrowthPoint {
  long size = 0;
  std::size_t runs = 0, right = 0;
  double triangles = 0, seconds = 0, own_bytes = 0;
};

struct GrowthCurve {
  std::size_t system = 0;
  std::vector<GrowthPoint> points;       ///< ascending; those with right runs
  std::optional<PowerLaw> time, memory;  ///< against triangles
};

/// A family that was run in three sizes or more.
struct GrowthStudy {
  std::size_t family = 0;
  std::vector<GrowthCurve> curves;
};

/// What a system takes as a multiple of what ours takes, over problems that both did right.
struct Ratio {
  std::size_t system = 0;
  Spread time, memory;
};

struct ExactShare {
  std::size_t family = 0, runs = 0;
  double median = 0, most = 0;  ///< parts of predicate calls
};

struct TruthCount {
  std::string confirmed;  ///< see Truth
  std::size_t problems = 0;
  std::string example, reason;  ///< the first of them
};

struct Disagreement {
  std::string problem, reason;
};

struct Summary {
  std::optional<std::size_t> ours;  ///< none: ours has no rows
  std::size_t problems = 0;
  std::vector<Tally> totals;          ///< by system
  std::vector<FamilyTally> families;  ///< those with rows: first the ones with distances, then by order
  std::vector<StageTally> stages;     ///< by system, most failures first
  DistanceStudy all_distances;
  std::vector<DistanceStudy> distances;
  std::vector<GrowthStudy> growth;
  std::vector<Ratio> ratios;              ///< of all systems but ours that have right runs in common with ours
  std::vector<ExactShare> exact_shares;   ///< of ours, by family
  std::optional<ExactShare> exact_share;  ///< of ours, all runs; `family` means nothing
  std::vector<TruthCount> truths;
  std::vector<Disagreement> disagreements;
  double least_limit_seconds = 0, most_limit_seconds = 0;
  std::size_t least_limit_bytes = 0, most_limit_bytes = 0;
};

Summary summarize(const Experiment& experiment);

/// One line of a main fact.
struct FactLine {
  std::size_t system = 0;
  std::vector<std::string> cells;
};

/// A main fact, in words made of the numbers.
struct MainFact {
  std::string question;              ///< what it answers
  std::string headline;              ///< the number
  std::string sentence;              ///< what the number is
  std::vector<std::string> columns;  ///< of the lines
  std::vector<FactLine> lines;       ///< one per system; empty when there is not enough data: `sentence` says so
  std::string note;
};

/// Exact results; where failures begin; time beside ours.
std::vector<MainFact> main_facts(const Experiment& experiment, const Summary& summary);

}  // namespace cnrg::bench
