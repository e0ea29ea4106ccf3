// A micro-benchmark per stage, from the soup to the files. `bench_stages --help` lists Google Benchmark's options;
// those of the project: none.
#include "bench/stages.h"

#include <map>

namespace cnrg::bench {

const Soup& stage_soup(const std::string& name) {
  static std::map<std::string, Soup> soups;
  const auto it = soups.find(name);
  return it != soups.end() ? it->second : soups.emplace(name, soup_of(case_of(name))).first->second;
}

void add_stage(const std::string& label, void (*stage)(benchmark::State& state, const std::string& name)) {
  for (const std::string name : kStageCases) {
    benchmark::RegisterBenchmark((label + "/" + name).c_str(),
                                 [stage, name](benchmark::State& state) { stage(state, name); })
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
  }
}

}  // namespace cnrg::bench

int main(int argc, char** argv) {
  cnrg::bench::add_refinement_stages();
  cnrg::bench::add_value_stages();
  cnrg::bench::add_predicates();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
