// orient3d where each of its stages decides. The counters say which stage did.
#include <vector>

#include "bench/cases/random.h"
#include "bench/stages.h"
#include "kernel/exact/points.h"
#include "kernel/exact/predicates.h"

namespace cnrg::bench {
namespace {

constexpr int kPoints = 4096;

/// In general position, doubles: the filter decides.
VertexId add_general(PointTable& table, Random& random) {
  return table.add(random.real(-1, 1), random.real(-1, 1), random.real(-1, 1));
}

/// In general position, thirds: no doubles; the filter allows for that.
VertexId add_thirds(PointTable& table, Random& random) {
  RationalPoint p;
  for (Rational& x : p) {
    x = Rational(random.integer(-100000, 100000), 3);
    x.canonicalize();
  }
  return table.add(p);
}

/// On the plane x + y + z = 0, small integers: intervals are exact there and find the zero.
VertexId add_lattice(PointTable& table, Random& random) {
  const int x = random.integer(-1000, 1000), y = random.integer(-1000, 1000);
  return table.add(x, y, -x - y);
}

/// On the plane x + y + z = 1 (doubles): nothing but exact arithmetic finds the zero.
VertexId add_coplanar(PointTable& table, Random& random) {
  const double unit = 1.0 / (1 << 20);
  const double x = random.integer(-1000000, 1000000) * unit, y = random.integer(-1000000, 1000000) * unit;
  return table.add(x, y, 1 - x - y);
}

template <VertexId (*Add)(PointTable&, Random&)>
void orientation(benchmark::State& state) {
  PointTable table;
  Random random(1);
  std::vector<VertexId> points(kPoints);
  for (VertexId& v : points) v = Add(table, random);
  const StageCounts before = stage_counts();
  std::size_t i = 0;
  int sum = 0;
  for (auto _ : state) {
    sum += orient3d(table, points[i % kPoints], points[(i + 1) % kPoints], points[(i + 2) % kPoints],
                    points[(i + 3) % kPoints]);
    ++i;
  }
  benchmark::DoNotOptimize(sum);
  const StageCounts after = stage_counts();
  const auto share = [&](std::uint64_t a, std::uint64_t b) {
    return static_cast<double>(b - a) / static_cast<double>(state.iterations());
  };
  state.counters["filter"] = share(before.filter, after.filter);
  state.counters["interval"] = share(before.interval, after.interval);
  state.counters["exact"] = share(before.exact, after.exact);
}

}  // namespace

void add_predicates() {
  benchmark::RegisterBenchmark("orient3d/filter", orientation<add_general>);
  benchmark::RegisterBenchmark("orient3d/filter_of_rationals", orientation<add_thirds>);
  benchmark::RegisterBenchmark("orient3d/interval", orientation<add_lattice>);
  benchmark::RegisterBenchmark("orient3d/exact", orientation<add_coplanar>);
}

}  // namespace cnrg::bench
