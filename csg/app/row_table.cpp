// Rows as a table of text; the exact volume, which may be long, is its last column.
#include "csg/app/row_table.h"

#include <cstdio>
#include <sstream>

#include "csg/text/escape.h"
#include "csg/text/table.h"

namespace cnrg::app {
namespace {

std::string seconds_text(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", seconds);
  return text;
}

/// The exact value, and a decimal after one that is too long to be read; of a fraction that would fill the screen
/// the decimal and how long it is.
std::string volume_text(const std::optional<Rational>& volume) {
  if (!volume) return "unbounded";
  constexpr std::size_t kReadable = 24, kPrinted = 160;
  const std::string exact = to_string(*volume);
  if (exact.size() <= kReadable) return exact;
  if (exact.size() <= kPrinted) return exact + " (" + to_decimal(*volume) + ")";
  return to_decimal(*volume) + " (the fraction has " + std::to_string(exact.size() - 1) + " digits; -o FILE.json)";
}

std::string details(const NodeRow& row) {
  std::string text;
  for (const auto& [number, count] : row.removals) {
    text += std::string("    ") + table_rows()[number].id + ": " + std::to_string(count) + "\n";
  }
  if (row.volumes.size() < 2) return text;
  for (std::size_t i = 0; i < row.volumes.size(); ++i) {
    const auto& [component, name] = row.named[i];
    text += "    " + std::string(row.is_group ? "region " : "component ") + std::to_string(component) +
            (name.empty() ? "" : " `" + shown(name) + "`") + ": volume " + volume_text(row.volumes[i]) + "\n";
  }
  return text;
}

}  // namespace

std::string row_table(const std::vector<NodeRow>& rows, bool raw, bool trace) {
  Table table;
  table.add_column("node", Table::Align::left);
  table.add_column("operator", Table::Align::left);
  for (const char* title :
       {"vertices", "edges", "faces", "3-cells", "removed", "regions", "components", "seconds"}) {
    table.add_column(title);
  }
  table.add_column("volume", Table::Align::left);
  for (const NodeRow& row : rows) {
    const auto& cells = raw ? row.raw_cells : row.cells;
    table.add_row({row.name, row.operator_name, std::to_string(cells[0]), std::to_string(cells[1]),
                   std::to_string(cells[2]), std::to_string(cells[3]), std::to_string(row.removed()),
                   std::to_string(row.regions), row.is_group ? "" : std::to_string(row.components),
                   seconds_text(row.seconds), volume_text(row.volume())});
  }
  if (!trace) return table.text();
  std::istringstream lines(table.text());
  std::string text, line;
  std::getline(lines, line);
  text += line + "\n";
  for (const NodeRow& row : rows) {
    std::getline(lines, line);
    text += line + "\n" + details(row);
  }
  return text;
}

std::string refinement_summary(const Evaluation& evaluation) {
  const Complex& complex = *evaluation.complex;
  const RefineReport& report = evaluation.refine;
  constexpr const char* kContacts[] = {"face-face", "face-edge",   "face-vertex",
                                       "edge-edge", "edge-vertex", "vertex-vertex"};
  std::ostringstream text;
  text << "\nrefinement: " << complex.vertex_count() << " vertices (" << report.constructed << " constructed), "
       << complex.edge_count() << " edges, " << complex.face_count() << " faces, " << complex.region_count
       << " 3-cells; " << seconds_text(evaluation.refine_seconds) << " s\ncontacts: ";
  for (std::size_t k = 0; k < report.contacts.size(); ++k) {
    text << (k == 0 ? "" : ", ") << report.contacts[k] << " " << kContacts[k];
  }
  text << "; of " << report.candidates << " candidates\npredicates: " << report.stages.filter << " by filter, "
       << report.stages.interval << " by interval, " << report.stages.exact << " exact\n";
  return text.str();
}

}  // namespace cnrg::app
