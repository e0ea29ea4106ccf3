// The three main facts: each a number for us, a line for every system, and how to read it. Nothing is claimed that
// the rows do not say; the words follow the numbers.
#include <algorithm>

#include "bench/report/format.h"
#include "bench/report/summary.h"

namespace cnrg::bench {
namespace {

const std::string& title_of(const Experiment& experiment, std::size_t system) {
  return experiment.systems[system].title;
}

/// Systems that have judged runs, ours first, then by `less`.
template <class Less>
std::vector<std::size_t> ordered(const Summary& summary, const Less& less) {
  std::vector<std::size_t> systems;
  for (std::size_t s = 0; s < summary.totals.size(); ++s) {
    if (summary.totals[s].judged() > 0) systems.push_back(s);
  }
  std::stable_sort(systems.begin(), systems.end(), [&](std::size_t a, std::size_t b) {
    const bool a_ours = summary.ours == a, b_ours = summary.ours == b;
    return a_ours != b_ours ? a_ours : less(a, b);
  });
  return systems;
}

std::string part_text(std::size_t part, std::size_t all) { return grouped(part) + " of " + grouped(all); }

MainFact exact_results(const Experiment& experiment, const Summary& summary) {
  MainFact fact;
  fact.question = "Who has the right result?";
  const auto share = [&](std::size_t s, Class wanted) {
    return static_cast<double>(summary.totals[s].of(wanted)) / static_cast<double>(summary.totals[s].judged());
  };
  const std::vector<std::size_t> systems = ordered(
      summary, [&](std::size_t a, std::size_t b) { return share(a, Class::exact) > share(b, Class::exact); });
  fact.columns = {"same", "right", "wrong"};
  std::size_t unsaid = 0, systems_unsaid = 0, thin = 0;
  for (const StageTally& stage : summary.stages)
    if (stage.system != summary.ours && stage.stage == "topology") thin += stage.tally.of(Class::wrong);
  for (const std::size_t s : systems) {
    const Tally& tally = summary.totals[s];
    fact.lines.push_back(
        {s, {grouped(tally.of(Class::exact)), grouped(tally.right()), grouped(tally.of(Class::wrong))}});
    if (s == summary.ours) continue;
    unsaid += tally.of(Class::wrong);
    systems_unsaid += tally.of(Class::wrong) > 0;
  }
  fact.note =
      "Same: the exact point set, of systems that round up to the rounding that they state. Right: by some "
      "contract, "
      "the same ones included. Wrong: a wrong result and no word of it.";
  if (systems.empty() || systems[0] != summary.ours) {
    fact.headline = "–";
    fact.sentence = "There are no judged runs of ours.";
    return fact;
  }
  const Tally& ours = summary.totals[*summary.ours];
  fact.headline = part_text(ours.of(Class::exact), ours.judged());
  fact.sentence = "results of " + title_of(experiment, *summary.ours) + " are the exact ones.";
  if (ours.of(Class::wrong) > 0) fact.sentence += " " + grouped(ours.of(Class::wrong)) + " are wrong, unsaid.";
  if (ours.judged() < ours.runs()) {
    fact.sentence += " " + grouped(ours.of(Class::unjudged)) + " more could not be judged.";
  }
  if (systems.size() == 1) return fact;
  const std::size_t best = systems[1], worst = systems.back();
  const auto said = [&](std::size_t s) {
    return title_of(experiment, s) + " with " +
           part_text(summary.totals[s].of(Class::exact), summary.totals[s].judged());
  };
  fact.sentence += " Best of the others is " + said(best);
  if (worst != best) fact.sentence += ", last " + said(worst);
  fact.sentence +=
      unsaid == 0
          ? ". None of the others is wrong without saying so."
          : ". " + plural(unsaid, "result") + " of " + plural(systems_unsaid, "other system") +
                (unsaid == 1 ? " is" : " are") + " wrong without saying so" +
                (thin == 0 ? "" : ", " + grouped(thin) + " of them in parts thinner than their rounding") + ".";
  return fact;
}

const DistanceCurve* curve_of(const DistanceStudy& study, std::size_t system) {
  for (const DistanceCurve& curve : study.curves) {
    if (curve.system == system) return &curve;
  }
  return nullptr;
}

/// From far to near; those that never fail come last.
std::size_t onset_rank(const DistanceCurve& curve) {
  if (!curve.onset) return 2000;
  const std::optional<int>& k = curve.points[*curve.onset].k;
  return k ? static_cast<std::size_t>(*k) : 1000;
}

std::string onset_text(const DistanceCurve& curve) {
  return curve.onset ? distance_text(curve.points[*curve.onset].k) : "never";
}

std::size_t runs_of(const DistanceCurve& curve) {
  std::size_t runs = 0;
  for (const DistancePoint& point : curve.points) runs += point.tally.runs();
  return runs;
}

std::size_t failures_of(const DistanceCurve& curve) {
  std::size_t failures = 0;
  for (const DistancePoint& point : curve.points) failures += point.tally.failures();
  return failures;
}

std::string begin_text(const DistanceCurve& curve) {
  const std::optional<int>& k = curve.points[*curve.onset].k;
  return k ? "at " + distance_text(k) : "in the exactly degenerate position";
}

MainFact failures_near_degeneracy(const Experiment& experiment, const Summary& summary) {
  MainFact fact;
  fact.question = "Where do failures begin?";
  const std::vector<DistanceCurve>& curves = summary.all_distances.curves;
  if (curves.empty()) {
    fact.headline = "–";
    fact.sentence = "Not enough data: no family with a distance to degeneracy was run.";
    return fact;
  }
  fact.columns = {"fails from", "at most", "there"};
  std::vector<const DistanceCurve*> sorted;
  for (const DistanceCurve& curve : curves) sorted.push_back(&curve);
  std::stable_sort(sorted.begin(), sorted.end(), [&](const DistanceCurve* a, const DistanceCurve* b) {
    const bool a_ours = summary.ours == a->system, b_ours = summary.ours == b->system;
    if (a_ours != b_ours) return a_ours;
    if (onset_rank(*a) != onset_rank(*b)) return onset_rank(*a) < onset_rank(*b);
    return a->points[a->worst].tally.failure_rate() > b->points[b->worst].tally.failure_rate();
  });
  const DistanceCurve* first = nullptr;
  for (const DistanceCurve* curve : sorted) {
    const DistancePoint& worst = curve->points[curve->worst];
    const double rate = worst.tally.failure_rate();
    fact.lines.push_back(
        {curve->system, {onset_text(*curve), percent(rate), rate > 0 ? distance_text(worst.k) : "–"}});
    if (first == nullptr && curve->system != summary.ours && curve->onset) first = curve;
  }
  fact.note = "From: the farthest distance, as a part of the operands' size, at which " + percent(kOnset) +
              " of the runs or more fail. At most: the highest rate of failure, and at which distance.";
  const DistanceCurve* ours = summary.ours ? curve_of(summary.all_distances, *summary.ours) : nullptr;
  if (ours == nullptr) {
    fact.headline = "–";
    fact.sentence = "There are no runs of ours at distances.";
  } else {
    const std::string said = " of " + title_of(experiment, *summary.ours) + " in " +
                             plural(runs_of(*ours), "run") + " at all distances";
    const std::size_t failures = failures_of(*ours);
    fact.headline = ours->onset ? "from " + onset_text(*ours) : plural(failures, "failure");
    fact.sentence = (ours->onset ? plural(failures, "failure") : "") + said + ".";
    if (!ours->onset) fact.sentence.erase(0, 1);
  }
  if (first != nullptr) {
    const DistancePoint& worst = first->points[first->worst];
    fact.sentence += " First of the others, " + title_of(experiment, first->system) + " begins to fail " +
                     begin_text(*first) + " and fails in up to " + percent(worst.tally.failure_rate()) +
                     " of the runs at a distance.";
  } else if (curves.size() > (ours == nullptr ? 0 : 1)) {
    fact.sentence += " None of the others begins to fail.";
  }
  return fact;
}

std::string quartiles(const Spread& spread) {
  return three_digits(spread.lower) + "–" + three_digits(spread.upper);
}

MainFact speed(const Experiment& experiment, const Summary& summary) {
  MainFact fact;
  fact.question = "What does it cost?";
  std::vector<const Ratio*> sorted;
  for (const Ratio& ratio : summary.ratios) {
    if (ratio.time.count > 0) sorted.push_back(&ratio);
  }
  if (sorted.empty()) {
    fact.headline = "–";
    fact.sentence = "Not enough data: no problem was done right by ours and by another system.";
    return fact;
  }
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Ratio* a, const Ratio* b) { return a->time.median > b->time.median; });
  fact.columns = {"median", "quartiles", "n"};
  // The peers of the project, else the fastest: the least flattering.
  const Ratio *nef = nullptr, *corefinement = nullptr;
  for (const Ratio* ratio : sorted) {
    const std::string& name = experiment.systems[ratio->system].name;
    if (name == "nef") nef = ratio;
    if (name == "corefinement") corefinement = ratio;
    fact.lines.push_back(
        {ratio->system,
         {three_digits(ratio->time.median) + " ×", quartiles(ratio->time), grouped(ratio->time.count)}});
  }
  const Ratio* const second = nef != nullptr ? corefinement : nullptr;
  const Ratio* const shown = nef != nullptr ? nef : corefinement != nullptr ? corefinement : sorted.back();
  const auto described = [&](const Ratio& ratio) {
    return "(quartiles " + quartiles(ratio.time) + ", " + plural(ratio.time.count, "problem") + ")";
  };
  fact.headline = three_digits(shown->time.median) + " ×";
  fact.sentence = "the time of " + title_of(experiment, *summary.ours) + " is what " +
                  title_of(experiment, shown->system) + " takes, in the median " + described(*shown) + ".";
  if (second != nullptr) {
    fact.sentence += " " + title_of(experiment, second->system) + ": " + three_digits(second->time.median) +
                     " × " + described(*second) + ".";
  }
  fact.note =
      "Time of the system over ours, on the n problems that both did right, each run once; below 1 the system is "
      "faster. Most problems are small; below are times by size. Guarantees are not equal.";
  return fact;
}

}  // namespace

std::vector<MainFact> main_facts(const Experiment& experiment, const Summary& summary) {
  return {exact_results(experiment, summary), failures_near_degeneracy(experiment, summary),
          speed(experiment, summary)};
}

}  // namespace cnrg::bench
