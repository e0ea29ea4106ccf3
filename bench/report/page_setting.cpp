// What surrounds the numbers: systems, machine, truth, and every run.
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>

#include "bench/report/format.h"
#include "bench/report/page.h"

namespace cnrg::bench {
namespace {

constexpr std::size_t kShownDisagreements = 20;

std::string definition(const std::string& name, const std::string& text) {
  return text.empty() ? "" : element("dt", escaped(name)) + element("dd", escaped(text)) + "\n";
}

std::string rounding_text(double rounding) {
  if (rounding == 0) return "exact";
  const int exponent = static_cast<int>(std::floor(std::log10(rounding) + 1e-9));
  const double factor = rounding / std::pow(10.0, exponent);
  const std::string times = std::abs(factor - 1) < 5e-3 ? "" : three_digits(factor) + " × ";
  return times + power_of_ten(exponent) + " of the largest coordinate";
}

/// Without zeros after the point: limits are round numbers.
std::string seconds_text(double seconds) {
  char text[40];
  std::snprintf(text, sizeof text, "%g s", seconds);
  return text;
}

std::string seconds_limit(double least, double most) {
  if (most == 0) return "none";
  if (least == most) return seconds_text(most) + " of wall time per run";
  return (least == 0 ? "none" : seconds_text(least)) + " to " + seconds_text(most) + " of wall time per run";
}

std::string bytes_limit(std::size_t least, std::size_t most) {
  if (most == 0) return "none";
  const std::string high = megabytes(static_cast<double>(most)) + " MB of address space per run";
  if (least == most) return high;
  return (least == 0 ? "none" : megabytes(static_cast<double>(least)) + " MB") + " to " + high;
}

/// Rows as lists, names by their places: a page of 20,000 rows stays small. The script shows them on demand.
std::string rows_json(const Page& page) {
  nlohmann::json systems = nlohmann::json::array(), verdicts = nlohmann::json::array(),
                 rows = nlohmann::json::array();
  std::map<std::string, std::size_t> places;
  for (std::size_t s = 0; s < page.experiment.systems.size(); ++s) {
    places.emplace(page.system(s).name, s);
    systems.push_back(page.label(s));
  }
  for (std::size_t v = 0; v < kVerdicts; ++v) verdicts.push_back(to_string(static_cast<Verdict>(v)));
  for (const SweepRow& row : page.experiment.rows) {
    rows.push_back({row.problem, places.at(row.system), static_cast<int>(row.verdict), row.stage,
                    three_digits(row.seconds), megabytes(static_cast<double>(row.own_bytes)),
                    megabytes(static_cast<double>(row.peak_bytes)), row.message, row.command});
  }
  const nlohmann::json all{{"systems", systems}, {"verdicts", verdicts}, {"rows", rows}};
  return script_safe(all.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

}  // namespace

std::string truth_alarm(const Page& page) {
  const std::vector<Disagreement>& all = page.summary.disagreements;
  if (all.empty()) return "";
  std::string list;
  for (std::size_t i = 0; i < std::min(all.size(), kShownDisagreements); ++i) {
    list += element("li", element("code", escaped(all[i].problem)) + " " + escaped(all[i].reason)) + "\n";
  }
  if (all.size() > kShownDisagreements) {
    list += element("li", "and " + plural(all.size() - kShownDisagreements, "other"));
  }
  const std::string heading = "The truth is disputed for " + plural(all.size(), "problem");
  return element("div",
                 element("h2", heading) +
                     element("p",
                             "An independent system has another result than the one that the verdicts of "
                             "these problems were made with. Do not rely on them before that is settled.") +
                     element("ul", "\n" + list),
                 "class=\"alarm\" role=\"alert\"") +
         "\n";
}

std::string systems_section(const Page& page) {
  std::string rows;
  for (std::size_t s = 0; s < page.experiment.systems.size(); ++s) {
    const SystemInfo& info = page.system(s);
    const std::size_t runs = page.summary.totals[s].runs();
    const std::string ran = grouped(runs) + (info.absent.empty() ? "" : "; absent: " + info.absent);
    const bool described = !info.guarantee.empty() || !info.version.empty();
    std::string name = page.mark(s);
    name += element("small", escaped(page.label(s) == info.name ? info.title : info.name));
    rows += element("tr", element("th", name, "scope=\"row\"") +
                              element("td", described ? escaped(info.guarantee) : "not recorded") +
                              element("td", escaped(info.version)) +
                              element("td", described ? rounding_text(info.rounding) : "not recorded") +
                              element("td", !described         ? "not recorded"
                                            : info.regularized ? "regularized solids"
                                                               : "point sets of all dimensions") +
                              element("td", escaped(ran))) +
            "\n";
  }
  const std::string head =
      heads({{"system"}, {"takes and promises"}, {"version"}, {"rounding of results"}, {"results"}, {"runs"}});
  return table(head, rows, "class=\"list\"");
}

std::string machine_section(const Page& page) {
  const Summary& summary = page.summary;
  std::string list;
  if (const auto& machine = page.experiment.machine) {
    list += definition("processor", machine->cpu);
    if (machine->cores > 0) list += definition("cores", grouped(machine->cores));
    if (machine->memory_bytes > 0) {
      list += definition("main memory", megabytes(static_cast<double>(machine->memory_bytes)) + " MB");
    }
    list += definition("operating system", machine->system) + definition("compiler", machine->compiler) +
            definition("commit", machine->commit) + definition("date", machine->date) +
            definition("made by", machine->command);
    for (const auto& [problem, reason] : machine->left_out)
      list += definition("left out", problem + ": " + reason);
  } else {
    list += definition("machine", "not recorded: there was no machine.json");
  }
  list += definition("limit of time", seconds_limit(summary.least_limit_seconds, summary.most_limit_seconds)) +
          definition("limit of memory", bytes_limit(summary.least_limit_bytes, summary.most_limit_bytes)) +
          definition("time",
                     "from operands in memory to the result in memory; of a run without a result the wall time "
                     "of its process") +
          definition("memory",
                     "the most that was resident during the run above what the program and its input take; "
                     "MB are 10⁶ bytes");
  return element("dl", "\n" + list);
}

std::string truth_section(const Page& page) {
  const std::map<std::string, std::string> meanings = {{"Nef", "Nef polyhedra give the same point set, exactly."},
                                                       {"volume", "The volume agrees with corefinement to 10⁻⁹."},
                                                       {"none", "Neither was possible."},
                                                       {"DISAGREES", "One of them has another result."}};
  std::string rows;
  for (const TruthCount& truth : page.summary.truths) {
    const bool alarming = truth.confirmed == "DISAGREES" && truth.problems > 0;
    std::string example;
    if (truth.problems > 0) {
      example = element("code", escaped(truth.example));
      if (!truth.reason.empty()) example += " " + element("small", escaped(truth.reason));
    }
    rows += element("tr",
                    element("th", escaped(truth.confirmed), "scope=\"row\"") +
                        element("td", grouped(truth.problems), "class=\"count\"") +
                        element("td", meanings.at(truth.confirmed)) + element("td", example, "class=\"example\""),
                    alarming ? "class=\"alarming\"" : "") +
            "\n";
  }
  const std::string head = heads({{"confirmed by"}, {"problems", "count"}, {"meaning"}, {"such as"}});
  return table(head, rows, "class=\"list\"");
}

std::string rows_section(const Page& page) {
  const std::string count = plural(page.experiment.rows.size(), "run");
  return "<details id=\"runs\">\n" +
         element("summary", "Show " + count + ", each with the command that reproduces it") +
         "\n<div id=\"runs-view\"></div>\n" +
         element("noscript", element("p",
                                     "The table is made by a script. The JSON that <code>bench_report "
                                     "--json</code> writes holds all runs as well.")) +
         "\n</details>\n<script type=\"application/json\" id=\"runs-data\">" + rows_json(page) + "</script>";
}

}  // namespace cnrg::bench
