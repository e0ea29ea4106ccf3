// Rows come sorted by family, problem and system, so that a problem's rows are side by side.
#include "bench/report/summary.h"

#include <algorithm>
#include <map>
#include <set>

namespace cnrg::bench {
namespace {

/// The rows again, with places instead of names.
struct Placed {
  const SweepRow* row;
  std::size_t family, system;
  bool right() const { return is_right(row->verdict); }
};

template <class Info>
std::size_t place_of(const std::vector<Info>& infos, const std::string& name) {
  const auto found = std::find_if(infos.begin(), infos.end(), [&](const Info& info) { return info.name == name; });
  return static_cast<std::size_t>(found - infos.begin());
}

std::vector<Placed> placed_rows(const Experiment& experiment) {
  std::map<std::string, std::size_t> systems, families;
  for (const SystemInfo& s : experiment.systems) systems.emplace(s.name, systems.size());
  for (const FamilyInfo& f : experiment.families) families.emplace(f.name, families.size());
  std::vector<Placed> placed;
  for (const SweepRow& row : experiment.rows) {
    placed.push_back({&row, families.at(row.family), systems.at(row.system)});
  }
  return placed;
}

/// Calls `visit` with the begin and the end of each run of rows that `same` holds for.
template <class Same, class Visit>
void for_each_run(const std::vector<Placed>& rows, const Same& same, const Visit& visit) {
  for (auto begin = rows.begin(); begin != rows.end();) {
    auto end = begin + 1;
    while (end != rows.end() && same(*begin, *end)) ++end;
    visit(begin, end);
    begin = end;
  }
}

template <class Visit>
void for_each_problem(const std::vector<Placed>& rows, const Visit& visit) {
  for_each_run(
      rows, [](const Placed& a, const Placed& b) { return a.row->problem == b.row->problem; }, visit);
}

template <class Visit>
void for_each_family(const std::vector<Placed>& rows, const Visit& visit) {
  for_each_run(
      rows, [](const Placed& a, const Placed& b) { return a.family == b.family; }, visit);
}

void tally(const std::vector<Placed>& rows, std::size_t systems, Summary& out) {
  out.totals.resize(systems);
  for_each_family(rows, [&](auto begin, auto end) {
    FamilyTally family;
    family.family = begin->family;
    family.systems.resize(systems);
    for (auto i = begin; i != end; ++i) {
      family.systems[i->system].add(i->row->verdict);
      family.has_distance |= i->row->has_distance;
      if (i == begin || i->row->problem != (i - 1)->row->problem) ++family.problems;
    }
    for (std::size_t s = 0; s < systems; ++s) out.totals[s].add(family.systems[s]);
    out.problems += family.problems;
    out.families.push_back(std::move(family));
  });
  std::stable_partition(out.families.begin(), out.families.end(),
                        [](const FamilyTally& family) { return family.has_distance; });
}

std::vector<StageTally> tally_stages(const std::vector<Placed>& rows) {
  std::map<std::pair<std::size_t, std::string>, StageTally> stages;
  for (const Placed& p : rows) {
    if (!is_failure(p.row->verdict)) continue;
    const std::string name = p.row->stage.empty() ? "unknown" : p.row->stage;
    const auto [found, fresh] = stages.try_emplace({p.system, name});
    if (fresh) found->second = {p.system, name, {}, p.row->problem, p.row->message};
    found->second.tally.add(p.row->verdict);
  }
  std::vector<StageTally> sorted;
  for (auto& [key, stage] : stages) sorted.push_back(std::move(stage));
  std::stable_sort(sorted.begin(), sorted.end(), [](const StageTally& a, const StageTally& b) {
    if (a.system != b.system) return a.system < b.system;
    return a.tally.runs() > b.tally.runs();
  });
  return sorted;
}

/// Exactly degenerate comes after all distances.
int rank_of(const std::optional<int>& k) { return k ? *k : 1000; }

/// Systems, by family, that refused all operands of it at the input: they do not take such problems at all, and a
/// rate of failures says nothing.
std::set<std::pair<std::size_t, std::size_t>> not_taken(std::vector<Placed>::const_iterator begin,
                                                        std::vector<Placed>::const_iterator end) {
  std::set<std::pair<std::size_t, std::size_t>> all, some;
  for (auto i = begin; i != end; ++i) {
    all.emplace(i->system, i->family);
    if (i->row->verdict != Verdict::refused || i->row->stage != "input") some.emplace(i->system, i->family);
  }
  std::erase_if(all, [&](const auto& pair) { return some.count(pair) != 0; });
  return all;
}

DistanceStudy study_distance(std::vector<Placed>::const_iterator begin, std::vector<Placed>::const_iterator end,
                             std::optional<std::size_t> family) {
  std::map<std::size_t, std::map<int, DistancePoint>> points;
  const auto left_out = not_taken(begin, end);
  for (auto i = begin; i != end; ++i) {
    if (!i->row->has_distance || i->row->verdict == Verdict::unjudged) continue;
    if (left_out.count({i->system, i->family}) != 0) continue;
    DistancePoint& point = points[i->system][rank_of(i->row->distance)];
    point.k = i->row->distance;
    point.tally.add(i->row->verdict);
  }
  DistanceStudy study;
  study.family = family;
  for (const auto& [system, by_rank] : points) {
    DistanceCurve curve;
    curve.system = system;
    for (const auto& [rank, point] : by_rank) {
      const double rate = point.tally.failure_rate();
      if (!curve.onset && rate >= kOnset) curve.onset = curve.points.size();
      curve.points.push_back(point);
      if (rate > curve.points[curve.worst].tally.failure_rate()) curve.worst = curve.points.size() - 1;
    }
    study.curves.push_back(std::move(curve));
  }
  return study;
}

std::vector<DistanceStudy> study_distances(const std::vector<Placed>& rows) {
  std::vector<DistanceStudy> studies;
  for_each_family(rows, [&](auto begin, auto end) {
    DistanceStudy study = study_distance(begin, end, begin->family);
    if (!study.curves.empty()) studies.push_back(std::move(study));
  });
  return studies;
}

GrowthPoint growth_point(long size, const std::vector<const SweepRow*>& rows) {
  std::vector<double> triangles, seconds, bytes;
  for (const SweepRow* row : rows) {
    if (!is_right(row->verdict)) continue;
    triangles.push_back(static_cast<double>(row->triangles));
    seconds.push_back(row->seconds);
    bytes.push_back(static_cast<double>(row->own_bytes));
  }
  return {size,
          rows.size(),
          seconds.size(),
          spread_of(triangles).median,
          spread_of(seconds).median,
          spread_of(bytes).median};
}

std::optional<PowerLaw> fit(const std::vector<GrowthPoint>& points, double GrowthPoint::*cost) {
  std::vector<std::pair<double, double>> pairs;
  for (const GrowthPoint& p : points) {
    if (p.triangles > 0 && p.*cost > 0) pairs.emplace_back(p.triangles, p.*cost);
  }
  return power_law(pairs);
}

std::vector<GrowthStudy> study_growth(const std::vector<Placed>& rows) {
  std::vector<GrowthStudy> studies;
  for_each_family(rows, [&](auto begin, auto end) {
    std::map<std::size_t, std::map<long, std::vector<const SweepRow*>>> by_size;
    std::map<long, bool> sizes;
    for (auto i = begin; i != end; ++i) {
      by_size[i->system][i->row->size].push_back(i->row);
      sizes[i->row->size] = true;
    }
    if (sizes.size() < 3) return;
    GrowthStudy study;
    study.family = begin->family;
    for (const auto& [system, of_size] : by_size) {
      GrowthCurve curve;
      curve.system = system;
      for (const auto& [size, runs] : of_size) {
        const GrowthPoint point = growth_point(size, runs);
        if (point.right > 0) curve.points.push_back(point);
      }
      curve.time = fit(curve.points, &GrowthPoint::seconds);
      curve.memory = fit(curve.points, &GrowthPoint::own_bytes);
      if (!curve.points.empty()) study.curves.push_back(std::move(curve));
    }
    studies.push_back(std::move(study));
  });
  return studies;
}

std::vector<Ratio> ratios_to(std::size_t ours, const std::vector<Placed>& rows) {
  std::map<std::size_t, std::pair<std::vector<double>, std::vector<double>>> ratios;
  for_each_problem(rows, [&](auto begin, auto end) {
    const auto reference =
        std::find_if(begin, end, [&](const Placed& p) { return p.system == ours && p.right(); });
    if (reference == end) return;
    for (auto i = begin; i != end; ++i) {
      if (i == reference || !i->right()) continue;
      const SweepRow &one = *i->row, &other = *reference->row;
      auto& [time, memory] = ratios[i->system];
      if (one.seconds > 0 && other.seconds > 0) time.push_back(one.seconds / other.seconds);
      if (one.own_bytes == 0 || other.own_bytes == 0) continue;
      memory.push_back(static_cast<double>(one.own_bytes) / static_cast<double>(other.own_bytes));
    }
  });
  std::vector<Ratio> spreads;
  for (const auto& [system, values] : ratios) {
    spreads.push_back({system, spread_of(values.first), spread_of(values.second)});
  }
  return spreads;
}

ExactShare share_of(std::size_t family, const std::vector<double>& shares) {
  const Spread spread = spread_of(shares);
  return {family, spread.count, spread.median, spread.most};
}

void study_exact_shares(std::size_t ours, const std::vector<Placed>& rows, Summary& out) {
  std::vector<double> all;
  for_each_family(rows, [&](auto begin, auto end) {
    std::vector<double> shares;
    for (auto i = begin; i != end; ++i) {
      if (i->system == ours && i->row->exact_share >= 0) shares.push_back(i->row->exact_share);
    }
    if (shares.empty()) return;
    out.exact_shares.push_back(share_of(begin->family, shares));
    all.insert(all.end(), shares.begin(), shares.end());
  });
  if (!all.empty()) out.exact_share = share_of(0, all);
}

/// A disagreement that one row of a problem has counts for the problem.
void count_truths(const std::vector<Placed>& rows, Summary& out) {
  for (const char* name : {"Nef", "volume", "none", "DISAGREES"}) out.truths.push_back({name, 0, "", ""});
  for_each_problem(rows, [&](auto begin, auto end) {
    const auto disagrees =
        std::find_if(begin, end, [](const Placed& p) { return p.row->truth.confirmed == "DISAGREES"; });
    const SweepRow& row = *(disagrees == end ? begin : disagrees)->row;
    if (disagrees != end) out.disagreements.push_back({row.problem, row.truth.reason});
    for (TruthCount& count : out.truths) {
      if (count.confirmed != row.truth.confirmed) continue;
      if (count.problems++ == 0) count.example = row.problem, count.reason = row.truth.reason;
    }
  });
}

void read_limits(const std::vector<SweepRow>& rows, Summary& out) {
  const auto by_time = [](const SweepRow& a, const SweepRow& b) { return a.limit_seconds < b.limit_seconds; };
  const auto by_bytes = [](const SweepRow& a, const SweepRow& b) { return a.limit_bytes < b.limit_bytes; };
  const auto [fast, slow] = std::minmax_element(rows.begin(), rows.end(), by_time);
  const auto [small, large] = std::minmax_element(rows.begin(), rows.end(), by_bytes);
  out.least_limit_seconds = fast->limit_seconds;
  out.most_limit_seconds = slow->limit_seconds;
  out.least_limit_bytes = small->limit_bytes;
  out.most_limit_bytes = large->limit_bytes;
}

}  // namespace

Class class_of(Verdict verdict) {
  if (verdict == Verdict::same) return Class::exact;
  if (verdict == Verdict::unjudged) return Class::unjudged;
  if (!is_failure(verdict)) return Class::right;
  if (verdict == Verdict::wrong) return Class::wrong;
  return verdict == Verdict::refused ? Class::refused : Class::no_result;
}

bool is_right(Verdict verdict) {
  const Class group = class_of(verdict);
  return group == Class::exact || group == Class::right;
}

void Tally::add(const Tally& other) {
  for (std::size_t i = 0; i < kVerdicts; ++i) counts[i] += other.counts[i];
}

std::size_t Tally::of(Class wanted) const {
  std::size_t sum = 0;
  for (std::size_t i = 0; i < kVerdicts; ++i) {
    if (class_of(static_cast<Verdict>(i)) == wanted) sum += counts[i];
  }
  return sum;
}

std::size_t Tally::runs() const {
  std::size_t sum = 0;
  for (const std::size_t count : counts) sum += count;
  return sum;
}

std::size_t Tally::judged() const { return runs() - of(Class::unjudged); }

std::size_t Tally::right() const { return of(Class::exact) + of(Class::right); }

std::size_t Tally::failures() const { return of(Class::wrong) + of(Class::refused) + of(Class::no_result); }

double Tally::failure_rate() const {
  const std::size_t all = judged();
  return all == 0 ? 0 : static_cast<double>(failures()) / static_cast<double>(all);
}

Summary summarize(const Experiment& experiment) {
  const std::vector<Placed> rows = placed_rows(experiment);
  Summary out;
  tally(rows, experiment.systems.size(), out);
  const std::size_t ours = place_of(experiment.systems, kOurs);
  if (ours < experiment.systems.size() && out.totals[ours].runs() > 0) out.ours = ours;
  out.stages = tally_stages(rows);
  out.all_distances = study_distance(rows.begin(), rows.end(), std::nullopt);
  out.distances = study_distances(rows);
  out.growth = study_growth(rows);
  if (out.ours) {
    out.ratios = ratios_to(ours, rows);
    study_exact_shares(ours, rows, out);
  }
  count_truths(rows, out);
  read_limits(experiment.rows, out);
  return out;
}

}  // namespace cnrg::bench
