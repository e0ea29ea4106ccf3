// bench_report: the page and the JSON of a sweep's rows.
#include "bench/report/report.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "bench/command.h"
#include "csg/text/file.h"

namespace cnrg::bench {
namespace {

struct Settings {
  std::string folder, page, json, machine;
  std::string title = "Where Booleans end: systems at and near degeneracy";
};

/// A report among the rows would be taken for a row the next time.
void check_place(const std::string& folder, const std::string& json) {
  namespace fs = std::filesystem;
  // `weakly_canonical` leaves a relative path as it is when its first part does not exist.
  const auto canonical = [](const std::string& path) { return fs::weakly_canonical(fs::absolute(path)); };
  const fs::path relative = canonical(json).lexically_relative(canonical(folder));
  if (relative.empty() || *relative.begin() != "..") {
    throw std::runtime_error(json + ": is in the folder of the rows; write the report's JSON outside of it");
  }
}

int run(const Settings& s) {
  if (!s.json.empty()) check_place(s.folder, s.json);
  const Experiment experiment = read_experiment(s.folder, s.machine);
  const Summary summary = summarize(experiment);
  const std::string page = report_html(experiment, summary, s.title);
  if (!s.json.empty()) replace_file(s.json, report_json(experiment, summary, s.title));
  replace_file(s.page, page);
  return 0;
}

}  // namespace
}  // namespace cnrg::bench

int main(int argc, char** argv) {
  cnrg::bench::Settings settings;
  CLI::App program{"One HTML page, and its JSON, of the rows of a sweep.", "bench_report"};
  program.add_option("ROWS_FOLDER", settings.folder, "Folder of rows, searched through for *.json")->required();
  program.add_option("-o,--output", settings.page, "The page")->required();
  program.add_option("--json", settings.json, "The same as JSON");
  program.add_option("--title", settings.title, "Of the page");
  program.add_option("--machine", settings.machine, "JSON of the machine (ROWS_FOLDER/machine.json)");
  return cnrg::bench::command(program, argc, argv, [&] { return cnrg::bench::run(settings); });
}
