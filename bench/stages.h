// What the benchmarks of stages share: the inputs, each made once, and the registration for all of them.
#pragma once

#include <benchmark/benchmark.h>

#include <string>

#include "bench/cases/soup_of.h"

namespace cnrg::bench {

inline constexpr const char* kStageCases[] = {"spheres10k", "spheres100k", "boxes200"};

/// The soup of a case, made when it is first asked for.
const Soup& stage_soup(const std::string& name);

/// Registers `stage(state, case)` for every case as `label/case`; times are wall times, in milliseconds.
void add_stage(const std::string& label, void (*stage)(benchmark::State& state, const std::string& name));

/// Sets the rate of things handled, such as faces or pairs.
inline void count_items(benchmark::State& state, std::size_t per_run) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(per_run));
}

void add_refinement_stages();  ///< stages_refinement.cpp
void add_value_stages();       ///< stages_values.cpp
void add_predicates();         ///< stages_predicates.cpp

}  // namespace cnrg::bench
