// Stages after the complex: values of leaves, the Boolean, simplification, volume, files.
#include <map>
#include <memory>

#include "bench/cases/boolean_node.h"
#include "bench/stages.h"
#include "csg/formats/formats.h"
#include "csg/operators/group.h"
#include "kernel/selection/canonical.h"
#include "kernel/selection/measure.h"

namespace cnrg::bench {
namespace {

/// A case evaluated.
struct Evaluated {
  explicit Evaluated(const std::string& name)
      : built(build_complex(stage_soup(name))),
        leaves(values_of(complex, leaf_groups(complex))),
        value(evaluate_node(complex, Operation::unite, leaves).value),
        selection(selection_of(complex, value)),
        simplified(simplify(complex, selection, value.features())),
        names(complex.leaf_count, LeafInfo{"leaf", 0}) {
    put_in_order(complex, simplified);
  }
  ResultView view() const {
    return {.node = "all", .complex = &complex, .value = &value, .simplified = &simplified, .leaves = &names};
  }
  const std::shared_ptr<const Complex> built;
  const Complex& complex = *built;
  std::vector<NodeValue> leaves;  // given up to the Boolean
  NodeValue value;
  Selection selection;
  SimplifiedComplex simplified;
  std::vector<LeafInfo> names;
};

const Evaluated& evaluated(const std::string& name) {
  static std::map<std::string, std::unique_ptr<Evaluated>> all;
  std::unique_ptr<Evaluated>& one = all[name];
  if (!one) one = std::make_unique<Evaluated>(name);
  return *one;
}

void leaves(benchmark::State& state, const std::string& name) {
  const Complex& complex = evaluated(name).complex;
  for (auto _ : state) benchmark::DoNotOptimize(leaf_groups(complex));
  count_items(state, complex.face_count());
}

void unite(benchmark::State& state, const std::string& name) {
  const Complex& complex = evaluated(name).complex;
  for (auto _ : state) {
    state.PauseTiming();
    std::vector<NodeValue> operands = values_of(complex, leaf_groups(complex));
    state.ResumeTiming();
    benchmark::DoNotOptimize(evaluate_node(complex, Operation::unite, operands));
  }
  count_items(state, complex.face_count());
}

void simplify_union(benchmark::State& state, const std::string& name) {
  const Evaluated& e = evaluated(name);
  for (auto _ : state) benchmark::DoNotOptimize(simplify(e.complex, e.selection, e.value.features()));
  count_items(state, e.selection.faces.size());
}

void canonical_order(benchmark::State& state, const std::string& name) {
  const Evaluated& e = evaluated(name);
  for (auto _ : state) {
    state.PauseTiming();
    SimplifiedComplex simplified = simplify(e.complex, e.selection, e.value.features());
    state.ResumeTiming();
    put_in_order(e.complex, simplified);
  }
  count_items(state, e.simplified.faces.size());
}

void volume_of_union(benchmark::State& state, const std::string& name) {
  const Evaluated& e = evaluated(name);
  const std::vector<RegionId> cells = support(e.selection).regions;
  for (auto _ : state) benchmark::DoNotOptimize(volume(e.complex, cells));
  count_items(state, e.selection.faces.size());
}

template <FileText (*Format)(const ResultView&)>
void write_text(benchmark::State& state, const std::string& name) {
  const Evaluated& e = evaluated(name);
  std::size_t bytes = 0;
  for (auto _ : state) bytes = Format(e.view()).text.size();
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytes));
}

}  // namespace

void add_value_stages() {
  add_stage("leaf_groups", leaves);
  add_stage("union", unite);
  add_stage("simplify", simplify_union);
  add_stage("put_in_order", canonical_order);
  add_stage("volume", volume_of_union);
  add_stage("json", write_text<json_text>);
  add_stage("vtu", write_text<vtu_text>);
}

}  // namespace cnrg::bench
