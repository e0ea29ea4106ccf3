// The exact volume, which may be long, comes last.
#include "csg/app/row_table.h"

#include <cstdio>
#include <sstream>

#include "csg/output/table.h"

namespace cnrg::app {
namespace {

std::string seconds_text(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", seconds);
  return text;
}

std::string volume_text(const std::optional<Rational>& volume) { return volume ? to_string(*volume) : "unbounded"; }

std::string details(const NodeRow& row) {
  std::string text;
  for (const auto& [id, count] : row.removals) text += "    " + id + ": " + std::to_string(count) + "\n";
  if (row.volumes.size() < 2) return text;
  for (std::size_t i = 0; i < row.volumes.size(); ++i) {
    text += "    region " + std::to_string(i + 1) + ": volume " + volume_text(row.volumes[i]) + "\n";
  }
  return text;
}

}  // namespace

std::string row_table(const std::vector<NodeRow>& rows, bool raw, bool trace) {
  Table table;
  table.add_column("node", Table::Align::left);
  table.add_column("operator", Table::Align::left);
  for (const char* title : {"vertices", "edges", "faces", "3-cells", "removed", "regions", "seconds"}) {
    table.add_column(title);
  }
  table.add_column("volume", Table::Align::left);
  for (const NodeRow& row : rows) {
    const auto& cells = raw ? row.raw_cells : row.cells;
    table.add_row({row.name, row.operator_name, std::to_string(cells[0]), std::to_string(cells[1]),
                   std::to_string(cells[2]), std::to_string(cells[3]), std::to_string(row.removed()),
                   std::to_string(row.volumes.size()), seconds_text(row.seconds), volume_text(row.volume())});
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

}  // namespace cnrg::app
