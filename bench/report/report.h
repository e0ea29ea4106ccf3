// The report: one HTML page that needs nothing but itself, and the same as JSON.
#pragma once

#include <string>

#include "bench/report/experiment.h"
#include "bench/report/summary.h"

namespace cnrg::bench {

inline constexpr int kReportSchema = 1;

/// Plots are made by gnuplot: throws std::runtime_error if it is missing.
std::string report_html(const Experiment& experiment, const Summary& summary, const std::string& title);

/// Schema version, title, machine, systems, families, main facts, all aggregates, the exact results by problem,
/// all rows.
std::string report_json(const Experiment& experiment, const Summary& summary, const std::string& title);

}  // namespace cnrg::bench
