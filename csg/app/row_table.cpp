// Rows as a table of text; the exact volume, which may be long, is its last column.
#include "csg/app/row_table.h"

#include <algorithm>
#include <array>
#include <ios>
#include <sstream>

#include "csg/text/digits.h"
#include "csg/text/escape.h"
#include "csg/text/json_text.h"
#include "csg/text/number.h"
#include "csg/text/table.h"

namespace cnrg::app {
namespace {

std::string seconds_text(double seconds) { return decimal(seconds, "%.3f"); }

std::string volume_text(const std::optional<Rational>& volume) {
  return volume ? number_text(*volume, "; -o FILE.json") : "unbounded";
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

StageRows stage_rows(const StageClock& clock, const Evaluation& evaluation, bool crosses, bool whole) {
  double of_rows = 0;
  for (const NodeRow& row : evaluation.rows) of_rows += row.seconds + row.totals_seconds;
  // Nodes below joined ones are evaluated before the leaves of the others are prepared.
  double below = 0;
  for (const JoinedNode& joined : evaluation.joined) {
    for (const NodeRow& row : joined.rows) below += row.seconds + row.totals_seconds;
  }
  StageRows out;
  out.leaves = std::max(0.0, clock.seconds("leaves") - below);
  out.refinement = clock.seconds("refinement") + (crosses ? 0 : clock.seconds("crossings"));
  if (crosses) out.crossings = clock.seconds("crossings");
  // The cells of what is shown are simplified among the nodes.
  if (whole) {
    out.results = clock.seconds("results") + std::max(0.0, clock.seconds("nodes") - of_rows);
  }
  return out;
}

namespace {

/// Not as a number of seconds looks.
std::string within(const NodeRow& row) {
  const std::string bound = bound_text(row.volume_bound());
  return bound.empty() || bound == "unknown" ? bound : "±" + bound;
}

}  // namespace

std::string row_table(const Evaluation& evaluation, const StageRows& stages, bool raw, bool trace) {
  const std::vector<const NodeRow*> rows = evaluation.all_rows();
  Table table({"<node", "<operator", "vertices", "edges", "faces", "3-cells", "removed", "regions", "components",
               "seconds", "within", "<volume"});
  const auto add_stage = [&](const char* name, const std::optional<double>& seconds,
                             std::array<std::string, 4> cells = {}) {
    if (!seconds) return;
    table.add_row(
        {"", name, cells[0], cells[1], cells[2], cells[3], "", "", "", seconds_text(std::max(0.0, *seconds))});
  };
  add_stage("leaves", stages.leaves);
  const Complex& complex = *evaluation.complex;
  add_stage("refinement", stages.refinement,
            {std::to_string(complex.vertex_count()), std::to_string(complex.edge_count()),
             std::to_string(complex.face_count()), std::to_string(complex.region_count)});
  for (const NodeRow* const shown : rows) {
    const NodeRow& row = *shown;
    const auto& cells = raw ? row.raw_cells : row.cells;
    table.add_row({row.name, row.operator_name, std::to_string(cells[0]), std::to_string(cells[1]),
                   std::to_string(cells[2]), std::to_string(cells[3]), std::to_string(row.removed()),
                   std::to_string(row.regions), row.is_group ? "" : std::to_string(row.components),
                   seconds_text(row.seconds + row.totals_seconds), row.volume() ? within(row) : "",
                   volume_text(row.volume())});
  }
  add_stage("crossings", stages.crossings);
  add_stage("results", stages.results);
  if (!trace) return table.text();
  const std::string lines = table.text();
  std::string text;
  std::size_t at = 0;
  const auto take_line = [&] {
    const std::size_t end = lines.find('\n', at) + 1;
    text.append(lines, at, end - at);
    at = end;
  };
  constexpr std::size_t kBefore = 3;  // the head and two stages
  for (std::size_t i = 0; i < kBefore; ++i) take_line();
  for (const NodeRow* const row : rows) {
    take_line();
    text += details(*row);
  }
  return text + lines.substr(at);
}

std::string rows_json(const Evaluation& evaluation, const StageRows& stages, bool raw) {
  static constexpr const char* kCells[] = {"vertices", "edges", "faces", "3-cells"};
  const auto add_number = [](JsonObject& object, const char* key, const std::optional<double>& number) {
    std::string& text = object.key(key);
    text += number ? double_text(*number) : "null";
  };
  std::string text;
  {
    JsonObject document(text);
    {
      JsonObject seconds(document.key("seconds"));
      add_number(seconds, "leaves", stages.leaves);
      add_number(seconds, "refinement", stages.refinement);
      add_number(seconds, "crossings", stages.crossings);
      add_number(seconds, "results", stages.results);
    }
    append_json(document.key("rows"), evaluation.all_rows(), [&](const NodeRow* row) {
      JsonObject object(text);
      object.add("node", row->name).add("operator", row->operator_name);
      const auto& cells = raw ? row->raw_cells : row->cells;
      for (std::size_t i = 0; i < 4; ++i) object.add(kCells[i], cells[i]);
      object.add("removed", row->removed()).add("regions", row->regions);
      if (!row->is_group) object.add("components", row->components);
      add_number(object, "seconds", row->seconds + row->totals_seconds);
      if (const std::optional<Rational> volume = row->volume()) {
        object.add("volume", to_string(*volume));
        add_number(object, "within", row->volume_bound());
      } else {
        object.key("volume") += "null";
      }
    });
  }
  return text + "\n";
}

std::string refinement_summary(const Evaluation& evaluation) {
  const Complex& complex = *evaluation.complex;
  const RefineReport& report = evaluation.refine;
  constexpr const char* kContacts[] = {"face-face", "face-edge",   "face-vertex",
                                       "edge-edge", "edge-vertex", "vertex-vertex"};
  std::ostringstream text;
  text.exceptions(std::ios::badbit);  // without memory it would end in the middle
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
