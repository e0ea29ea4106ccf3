// `cnrg mesh`: tetrahedra that fill a result, made once and written to every file, and a row per region.
#include <iostream>

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

/// A row per region and one for all.
std::string table_of(const TetrahedralMesh& made) {
  Table table;
  table.add_column("region", Table::Align::left);
  table.add_column("tetrahedra");
  table.add_column("volume", Table::Align::left);
  std::size_t tetrahedra = 0;
  Rational volume = 0;
  for (const RegionTetrahedra& region : made.regions) {
    table.add_row({region.name, std::to_string(region.tetrahedra), to_decimal(region.volume)});
    tetrahedra += region.tetrahedra;
    volume += region.volume;
  }
  table.add_row({"all", std::to_string(tetrahedra), to_decimal(volume)});
  const Mesh& mesh = made.mesh;
  return table.text() + std::to_string(mesh.points.size()) + " points, " + std::to_string(mesh.triangles.size()) +
         " triangles on faces, " + std::to_string(mesh.segments.size()) + " segments on edges\n";
}

}  // namespace

int run_mesh(const MeshArguments& arguments) {
  require_distinct(arguments.files);
  for (const std::string& path : arguments.files) check_mesh_file_name(path);  // before the work, not after it
  const Tree tree = tree_of(arguments);
  require_writable(arguments.files, tree);
  const NodeId node = node_of(tree, arguments.node);
  print(unused_nodes(tree, {tree.result, node}), arguments.quiet);
  EvaluateOptions options;
  options.threads = arguments.threads;
  options.rows = false;
  options.nodes = {node};
  const Evaluation evaluation = evaluate_in_view(tree, options, arguments.quiet);
  if (arguments.certify) require_certain(tree, evaluation, arguments.quiet);
  TetrahedralMesh made;
  Result result = evaluation.result(node);
  SnapReport snapped;
  {
    ProgressBar bar(arguments.quiet);
    if (arguments.snap) {
      bar.show("snap", 0, 0);
      result = at_node(tree, node, [&] { return snap(result, &snapped); });
    }
    bar.show("mesh", 0, 0);
    made = at_node(tree, node, [&] { return tetrahedra(result, arguments.options); });
  }
  if (!arguments.quiet) std::cout << table_of(made) << std::flush;
  for (const std::string& path : arguments.files) {
    write(path, result, made.mesh);
    if (arguments.quiet) continue;
    if (snapped.rounds > 0) tell(path + ": notice: " + snapped.text());
    if (made.rounding.moved == 0) continue;
    tell(path + ": notice: rounding moved " + std::to_string(made.rounding.moved) +
         " vertices; the facets still meet as they should");
  }
  return kDone;
}

}  // namespace cnrg::app
