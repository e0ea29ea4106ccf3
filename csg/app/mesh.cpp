// `cnrg mesh`: tetrahedra that fill a result, made once and written to every file, and a row per region.
#include <cstdio>
#include <iostream>
#include <optional>

#include "csg/app/commands.h"
#include "csg/app/evaluation.h"
#include "csg/app/exit_status.h"
#include "csg/app/output.h"
#include "csg/app/progress_bar.h"
#include "csg/evaluate/evaluate.h"
#include "csg/formats/mesh_file.h"
#include "csg/formats/result_file.h"
#include "csg/text/table.h"

namespace cnrg::app {
namespace {

/// A row per region and one for all. `bent`: of a mesh of second order.
std::string table_of(const TetrahedralMesh& made, const CurvedReport* bent) {
  Table table;
  table.add_column("region", Table::Align::left);
  table.add_column("tetrahedra");
  if (bent != nullptr) {
    table.add_column("curved");
    table.add_column("straight");
  }
  table.add_column("volume", Table::Align::left);
  const auto row = [&](const std::string& name, std::size_t all, std::size_t curved, std::size_t straight,
                       const Rational& volume) {
    std::vector<std::string> cells{name, std::to_string(all)};
    if (bent != nullptr) {
      cells.push_back(std::to_string(curved));
      cells.push_back(std::to_string(straight));
    }
    cells.push_back(to_decimal(volume));
    table.add_row(std::move(cells));
  };
  std::size_t tetrahedra = 0, curved = 0, straight = 0;
  Rational volume = 0;
  for (std::size_t i = 0; i < made.regions.size(); ++i) {
    const RegionTetrahedra& region = made.regions[i];
    const std::size_t of_curved = bent != nullptr ? bent->curved[i] : 0;
    const std::size_t of_straight = bent != nullptr ? bent->straight[i] : 0;
    row(region.name, region.tetrahedra, of_curved, of_straight, region.volume);
    tetrahedra += region.tetrahedra;
    curved += of_curved;
    straight += of_straight;
    volume += region.volume;
  }
  row("all", tetrahedra, curved, straight, volume);
  const Mesh& mesh = made.mesh;
  return table.text() + std::to_string(mesh.points.size()) + " points, " + std::to_string(mesh.triangles.size()) +
         " triangles on faces, " + std::to_string(mesh.segments.size()) + " segments on edges\n";
}

std::string text_of(const CurvedReport& bent) {
  std::string text = std::to_string(bent.moved) + " points moved to the surfaces";
  if (bent.moved > 0) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.3g", bent.farthest);
    text += std::string(", by ") + buffer + " at most";
  }
  text += "; " + std::to_string(bent.middles) + " edges bent";
  if (bent.left > 0) text += "; " + std::to_string(bent.left) + " points and middles left where they were";
  return text + "\n";
}

}  // namespace

int run_mesh(const MeshArguments& arguments) {
  require_distinct(arguments.files);
  for (const std::string& path : arguments.files) {  // before the work, not after it
    if (arguments.curved || arguments.options.order == 2) check_second_order_file_name(path);
    else check_mesh_file_name(path);
  }
  const Tree tree = tree_of(arguments);
  require_writable(arguments.files, tree);
  const NodeId node = node_of(tree, arguments.node);
  print(unused_nodes(tree, {tree.result, node}), arguments.quiet);
  EvaluateOptions options;
  options.threads = arguments.threads;
  options.rows = Rows::none;
  options.nodes = {node};
  const Evaluation evaluation = evaluate_in_view(tree, options, arguments.quiet);
  if (arguments.certify) require_certain(tree, evaluation, arguments.quiet);
  else tell_uncertain(tree, evaluation, arguments.quiet);
  TetrahedralMesh made;
  Result result = evaluation.result(node);
  SnapReport snapped;
  std::optional<CurvedReport> bent;
  {
    ProgressBar bar(arguments.quiet);
    bar.show("mesh");
    TetrahedraOptions asked = arguments.options;
    asked.watch.progress = bar.progress();
    if (arguments.curved) asked.order = 1;  // bent afterwards
    if (arguments.curved && asked.quality == 0) asked.quality = kCurvedQuality;
    const bool snaps = !arguments.no_snap && !arguments.curved;  // curved surfaces are of the exact result
    made = at_node(tree, node,
                   [&] { return snaps ? snapped_tetrahedra(result, asked, snapped) : tetrahedra(result, asked); });
    if (arguments.curved) {
      bar.show("bend");
      bent = at_node(tree, node, [&] { return curve(result, made); });
    }
  }
  if (!arguments.quiet) {
    std::cout << table_of(made, bent ? &*bent : nullptr);
    if (bent) std::cout << text_of(*bent);
    std::cout << std::flush;
  }
  for (const std::string& path : arguments.files) {
    {
      ProgressBar bar(arguments.quiet);
      bar.show("write " + path);
      write(path, result, made.mesh);
    }
    if (arguments.quiet) continue;
    if (!made.notice.empty()) tell(path + ": notice: " + made.notice);
    if (snapped.rounds > 0) tell(path + ": notice: " + snapped.text());
    if (made.rounding.moved == 0) continue;
    tell(path + ": notice: rounding moved " + std::to_string(made.rounding.moved) +
         " vertices; the facets still meet as they should");
  }
  return kDone;
}

}  // namespace cnrg::app
