// `cnrg mesh`: tetrahedra that fill a result, made once and written to every file, and a row per region.
#include <algorithm>
#include <functional>
#include <iostream>
#include <optional>

#include "csg/app/commands.h"
#include "csg/app/evaluation.h"
#include "csg/app/exit_status.h"
#include "csg/app/joined.h"
#include "csg/app/output.h"
#include "csg/app/progress_bar.h"
#include "csg/certify/certificate.h"
#include "csg/evaluate/evaluate.h"
#include "csg/formats/mesh_file.h"
#include "csg/formats/result_file.h"
#include "csg/mesh/coarsen.h"
#include "csg/mesh/forecast.h"
#include "csg/text/file.h"
#include "csg/text/input_file.h"
#include "csg/text/plugin.h"
#include "csg/text/table.h"
#include "csg/topology/features.h"
#include "csg/view/mesh_page.h"

namespace cnrg::app {
namespace {

std::string shape_text(double x) { return decimal(x, x < 0.01 ? "%.2g" : "%.2f"); }

/// A histogram in one line: a block for each bar, as high as it is beside the highest; blank where there is none.
template <std::size_t N>
std::string bars(const std::array<std::size_t, N>& counts) {
  static constexpr const char* kBlocks[] = {"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
  const std::size_t most = *std::max_element(counts.begin(), counts.end());
  std::string out;
  for (const std::size_t n : counts) out += n == 0 ? " " : kBlocks[n * 7 / most];
  return out;
}

/// Of histograms.
constexpr const char* kLegend = "(a block is as high as its count beside the highest of the line; blank: none)\n";

/// How shapes are spread.
std::string spread_of(const MeshQuality& q) {
  Table table({"<", "from", "<tetrahedra", "<to"});
  table.add_row({"shape", "0", bars(q.shapes), "1"});
  table.add_row({"smallest dihedral angle", "0", bars(q.dihedrals), "90 degrees"});
  table.add_row({"circumradius to shortest edge", "0.6", bars(q.ratios), "3.6 and more"});
  return table.text() + kLegend;
}

/// Where shapes are bad, and why.
std::string bad_ones(const MeshQuality& quality, const PlaceText& place) {
  if (quality.worst_ones.empty()) return {};
  Table table({"shape", "angle", "<at", "<nodes", "<why"});
  for (const MeshQuality::Bad& bad : quality.worst_ones) {
    std::string nodes;
    for (const std::string& name : bad.nodes) nodes += (nodes.empty() ? "" : ", ") + name;
    table.add_row(
        {shape_text(bad.measures.shape), decimal(bad.measures.dihedral, "%.2g"), place(bad.at), nodes, bad.why});
  }
  std::string text = "the worst shapes of " + std::to_string(quality.bad) + " below 0.1:\n" + table.text();
  for (const std::string& more : {forced_text(quality), joining_text(quality)})
    if (!more.empty()) text += more + "\n";
  return text;
}

/// `; 24 are in slab, 3 in rock`: where shapes are beyond what was asked for, if there are several regions.
std::string where_beyond(const TetrahedralMesh& made) {
  constexpr std::size_t kShown = 5;
  if (made.regions.size() < 2) return {};
  std::vector<std::pair<std::size_t, std::size_t>> counts;  // and the region
  for (std::size_t i = 0; i < made.regions.size(); ++i)
    if (made.quality.regions[i].beyond > 0) counts.emplace_back(made.quality.regions[i].beyond, i);
  std::stable_sort(counts.begin(), counts.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::string text;
  for (std::size_t i = 0; i < std::min(counts.size(), kShown); ++i) {
    const auto& [n, region] = counts[i];
    text += (i == 0 ? "; " : ", ") + std::to_string(n) +
            (i > 0    ? ""
             : n == 1 ? " is"
                      : " are") +
            " in " + made.regions[region].name;
  }
  if (counts.size() > kShown)
    text += ", and some in " + counted(counts.size() - kShown, "more region", "more regions");
  return text;
}

/// A row per region and one for all.
std::string table_of(const TetrahedralMesh& made) {
  const std::optional<CurvedReport>& bent = made.bent;
  std::vector<std::string> columns{"<region", "tetrahedra"};
  if (bent) columns.insert(columns.end(), {"curved", "straight"});
  columns.insert(columns.end(), {"worst", "median", "below 0.1", "<volume"});
  Table table(columns);
  const auto row = [&](const std::string& name, std::size_t all, std::size_t curved, std::size_t straight,
                       const MeshQuality::Region& shapes, const Rational& volume) {
    std::vector<std::string> cells{name, std::to_string(all)};
    if (bent) cells.insert(cells.end(), {std::to_string(curved), std::to_string(straight)});
    cells.insert(cells.end(), {shape_text(shapes.worst), shape_text(shapes.median), std::to_string(shapes.bad),
                               to_decimal(volume)});
    table.add_row(std::move(cells));
  };
  std::size_t tetrahedra = 0, curved = 0, straight = 0;
  Rational volume = 0;
  for (const std::size_t i : listed_regions(made)) {
    const RegionTetrahedra& region = made.regions[i];
    const std::size_t of_curved = bent ? bent->curved[i] : 0;
    const std::size_t of_straight = bent ? bent->straight[i] : 0;
    row(region.name, region.tetrahedra, of_curved, of_straight, made.quality.regions[i], region.volume);
    tetrahedra += region.tetrahedra;
    curved += of_curved;
    straight += of_straight;
    volume += region.volume;
  }
  const MeshQuality& q = made.quality;
  row("all", tetrahedra, curved, straight, {q.bad, q.beyond, q.worst, q.median}, volume);
  const Mesh& mesh = made.mesh;
  std::string beyond;
  if (q.beyond > 0) {
    beyond = std::to_string(q.beyond) +
             " tetrahedra have a larger ratio of circumradius to shortest edge than asked for; " +
             "the largest is " + decimal(q.largest_radius_edge, "%.3g") + where_beyond(made) + "\n";
  }
  return table.text() + spread_of(q) + bad_ones(q, PlaceText(mesh)) + beyond + std::to_string(mesh.points.size()) +
         " points, " + std::to_string(mesh.triangles.size()) + " triangles on faces, " +
         std::to_string(mesh.segments.size()) + " segments on edges\n";
}

std::string text_of(const CurvedReport& bent) {
  std::string text = std::to_string(bent.moved) + " points moved to the surfaces";
  if (bent.moved > 0) text += ", by " + decimal(bent.farthest, "%.3g") + " at most";
  text += "; " + std::to_string(bent.middles) + " edges bent";
  if (bent.left > 0) text += "; " + std::to_string(bent.left) + " points and middles left where they were";
  return text + "\n";
}

std::string text_of(const SplitReport& parted) {
  return "split: " + counted(parted.twins, "node", "nodes") + " more, " +
         counted(parted.wedges, "wedge", "wedges") + "\n";
}

std::string short_number(double value) { return decimal(value, "%.6g"); }

/// A row per group of faces and one for all. `quads`: these were asked for.
std::string table_of(const SurfaceTriangles& made, bool quads) {
  std::vector<std::string> columns{"<faces"};
  if (quads) columns.insert(columns.end(), {"quads", "least quality"});
  columns.insert(columns.end(), {"triangles", "<area", "least angle", "<at", "below 25", "<since"});
  Table table(columns);
  const PlaceText place(made.mesh);
  const auto row = [&](const FaceTriangles& of) {
    static constexpr const char* kWhy[] = {"", "input angle", "digits", "--max-points"};
    std::size_t below = 0;
    std::string since;
    for (std::size_t i = 1; i < of.why.size(); ++i) {
      if (of.why[i] == 0) continue;
      below += of.why[i];
      since += (since.empty() ? "" : ", ") + std::string(kWhy[i]) + " " + std::to_string(of.why[i]);
    }
    std::string at, angle;
    if (of.triangles > 0) {
      at = place(of.where);
      angle = decimal(of.least_angle, of.least_angle < 0.1 ? "%.3g" : "%.2f");
    }
    std::vector<std::string> cells{of.name};
    if (quads)
      cells.insert(cells.end(), {std::to_string(of.quads), of.quads == 0 ? "" : decimal(of.least_quad, "%.2f")});
    cells.insert(cells.end(),
                 {std::to_string(of.triangles), short_number(of.area), angle, at, std::to_string(below), since});
    table.add_row(std::move(cells));
  };
  for (const FaceTriangles& of : made.groups) row(of);
  if (!made.groups.empty()) row(all_groups(made));
  const Mesh& mesh = made.mesh;
  std::string rows;
  if (!made.groups.empty()) {
    Table spread({"<", "from", "<triangles", "<to"});
    spread.add_row({"smallest angle", "0", bars(triangle_quality_of(mesh, {}).angles), "60 degrees"});
    rows = table.text() + spread.text() + kLegend;
  }
  return rows + std::to_string(mesh.points.size()) + " points, " +
         (quads ? std::to_string(mesh.quads.size()) + " quadrilaterals and " : "") +
         std::to_string(mesh.triangles.size()) + " triangles on faces, " + std::to_string(mesh.segments.size()) +
         " segments on edges\n";
}

/// A mesh of fewer that nothing is asked of is made before somebody has read what it will be.
constexpr double kWorthTelling = 10'000;

/// Do the options say how many tetrahedra there will be?
bool bounds(const TetrahedraOptions& options) {
  return options.size > 0 || options.quality > 0 || options.max_volume > 0;
}

/// The page that tells of a mesh.
using Page = std::function<std::string(const MeshPageOptions&)>;

/// That a file holds a part of the mesh, unless others that are asked for hold the rest.
void tell_left_out(const std::string& path, const std::vector<std::string>& asked, const Mesh& mesh) {
  std::string names, held;
  for (const FurtherFile& file : further_files(path, mesh)) {
    if (std::find(asked.begin(), asked.end(), file.path) != asked.end()) continue;
    names += " -o " + file.path;
    held += (held.empty() ? "" : ", ") + file.holds;
  }
  if (!names.empty())
    tell(path + ": notice: a grid has elements of one dimension; ask for" + names + ", too, which hold " + held);
}

/// What is so near that it was probably meant to touch, since the mesh is parted there.
void tell_nearly_touching(const MeshArguments& arguments, const Tree& tree, NodeId node, const Result& result) {
  if (arguments.quiet || !arguments.join.empty()) return;
  ProgressBar bar(false);
  bar.show("near features");
  const std::string text = at_node(tree, node, [&] { return nearly_touching_text(result, {bar.progress(), {}}); });
  bar.clear();
  if (!text.empty()) tell(tree.file + ": notice: `" + tree.nodes[node].name + "`: " + text);
}

/// Writes a mesh to all files, with what is to be said of each; the warnings even if nothing else is.
void write_files(const MeshArguments& arguments, const Result& result, const Mesh& mesh,
                 const RoundingReport& rounding, const SnapReport& snapped, const std::string& notice,
                 std::vector<std::string> warnings, const Page& page) {
  std::vector<std::string> notices;
  if (!notice.empty()) notices.push_back(notice);
  if (snapped.rounds > 0) notices.push_back(snapped.text());
  for (std::string& warning : snapped.warnings()) warnings.push_back(std::move(warning));
  if (rounding.moved > 0) {
    notices.push_back("rounding moved " + counted(rounding.moved, "vertex", "vertices") +
                      "; the facets still meet as they should");
  }
  std::vector<std::string> told = notices;
  told.insert(told.end(), warnings.begin(), warnings.end());
  write_each(arguments.files, [&](const std::string& path) {
    {
      ProgressBar bar(arguments.quiet);
      bar.show("write " + path);
      if (is_page(path)) {
        replace_file(path, page({arguments.tree, mesh.node, arguments.options.quality, told, arguments.threads}));
      } else {
        write(path, result, mesh);
      }
    }
    if (!arguments.quiet && !is_page(path)) {
      for (const std::string& text : notices) tell(path + ": notice: " + text);
    }
    for (const std::string& text : warnings) tell(path + ": warning: " + text);
    if (!arguments.quiet) tell_left_out(path, arguments.files, mesh);
  });
}

int mesh_surface(const MeshArguments& arguments, const Tree& tree, NodeId node, Result result) {
  SurfaceTriangles made;
  SnapReport snapped;
  {
    ProgressBar bar(arguments.quiet);
    bar.show("mesh");
    SurfaceOptions asked;
    asked.overall = arguments.options.size;
    asked.growth = arguments.options.growth;
    asked.max_points = arguments.max_points;
    asked.quads = arguments.quads;
    asked.order = arguments.options.order;
    asked.periodic = arguments.options.periodic;
    asked.seconds = arguments.options.seconds.value_or(0);
    asked.watch.progress = bar.progress();
    made = at_node(tree, node, [&] {
      return arguments.no_snap ? surface_triangles(result, asked)
                               : snapped_surface_triangles(result, asked, snapped);
    });
  }
  made.mesh.one_group = arguments.one_group;
  if (!arguments.quiet) std::cout << table_of(made, arguments.quads) << std::flush;
  tell_nearly_touching(arguments, tree, node, result);
  std::string notice = made.notice;
  if (made.kept > 0) {
    notice += (notice.empty() ? "" : "; ") + std::to_string(made.kept) +
              (made.kept == 1 ? " facet keeps its" : " facets keep their") +
              " own triangles: with smaller ones doubles would cross what is near";
  }
  std::size_t rationed = 0;
  for (const FaceTriangles& of : made.groups) rationed += of.why[std::size_t(SmallAngle::bound)];
  if (rationed > 0 && made.mesh.points.size() < arguments.max_points) {
    notice += (notice.empty() ? "" : "; ") + counted(rationed, "triangle stays", "triangles stay") +
              " thin in parts that are very narrow, which get a fiftieth of the points of --max-points; a greater "
              "one than " +
              std::to_string(arguments.max_points) + " mends more of them";
  }
  write_files(arguments, result, made.mesh, made.rounding, snapped, notice, made.warnings,
              [&](const MeshPageOptions& options) { return mesh_page(result, made, options); });
  return kDone;
}

/// `--chord`.
Result coarser(const MeshArguments& arguments, const Tree& tree, NodeId node, const Result& result) {
  CoarsenReport report;
  ProgressBar bar(arguments.quiet);
  const double within = to_double(*parse_rational(arguments.chord));
  const SizeOptions sizes{arguments.options.size, arguments.options.growth};
  Result out = at_node(tree, node, [&] { return coarsen(result, within, sizes, report, {bar.progress(), {}}); });
  bar.clear();
  if (!arguments.quiet) tell("notice: " + report.text(within));
  return out;
}

}  // namespace

int run_mesh(const MeshArguments& arguments) {
  constexpr const char* kPage = " .html";  // is written besides
  require_distinct(arguments.files);
  for (const std::string& path : arguments.files) {  // before the work, not after it
    if (is_page(path)) {
      require_no_directory(path);
      require_plugin(kPaperPlugin, path, "leave the page out");
      continue;
    }
    if (arguments.one_group) check_one_group_file_name(path);
    if (arguments.options.curved || arguments.options.order == 2) check_second_order_file_name(path, kPage);
    else if (arguments.options.interfaces) check_interfaces_file_name(path, kPage);
    else if (arguments.quads) check_quads_file_name(path, kPage);
    else check_mesh_file_name(path, kPage);
  }
  const Tree tree = tree_of(arguments);
  require_writable(arguments.files, tree);
  const NodeId node = node_of(tree, arguments.node);
  print(reading_warnings(tree, {tree.result, node}), arguments.quiet);
  EvaluateOptions options;
  options.threads = arguments.threads;
  options.rows = Rows::none;
  options.result = node;
  options.proof = asked_proof(arguments.certify, arguments.no_certify);
  const Evaluation evaluation = evaluate_in_view(tree, options, arguments.quiet);
  if (arguments.certify) require_certain(tree, evaluation, arguments.quiet);
  else tell_uncertain(tree, evaluation, arguments.quiet);
  if (const std::string doubt = certificate_of(evaluation, node).doubt(tree);
      arguments.options.curved && !doubt.empty()) {
    for (const std::string& path : arguments.files) tell(path + ": warning: " + doubt);
  }
  Result result = evaluation.result(node);
  if (!arguments.join.empty()) result = joined(tree, node, result, arguments.join, arguments.quiet);
  if (!arguments.chord.empty()) result = coarser(arguments, tree, node, result);
  if (arguments.surface) return mesh_surface(arguments, tree, node, std::move(result));
  TetrahedralMesh made;
  SnapReport snapped;
  {
    ProgressBar bar(arguments.quiet);
    bar.show("mesh");
    TetrahedraOptions asked = arguments.options;
    asked.watch.progress = bar.progress();
    bool again = false;
    if (!arguments.quiet) {
      asked.foretold = [&](const MeshForecast& mesh) {
        const char* why = again ? "TetGen has made no mesh to these bounds, so others are made: " : "";
        again = true;
        bar.foretell("the mesh", mesh.seconds);
        if (!bounds(asked) && mesh.tetrahedra < kWorthTelling) return;
        bar.clear();
        tell("notice: " + (why + forecast_text(mesh)));
        if (const double free = double(memory_available()); free > 0 && mesh.bytes > free) {
          tell(
              "notice: that is more memory than is free now; where it runs out, ask for a larger --size, "
              "--max-volume or --quality, or end other programs");
        }
      };
    }
    made = at_node(tree, node, [&] {
      return arguments.no_snap ? tetrahedra(result, asked) : snapped_tetrahedra(result, asked, snapped);
    });
  }
  made.mesh.one_group = arguments.one_group;
  if (!arguments.quiet) {
    std::cout << table_of(made);
    if (made.bent) std::cout << text_of(*made.bent);
    if (made.parted) std::cout << text_of(*made.parted);
    std::cout << std::flush;
  }
  tell_nearly_touching(arguments, tree, node, result);
  write_files(arguments, result, made.mesh, made.rounding, snapped, made.notice, made.warnings,
              [&](const MeshPageOptions& options) { return mesh_page(result, made, options); });
  return kDone;
}

}  // namespace cnrg::app
