// Evaluates mesh files, each in a process of its own with limits, and says what became of them.
//
//   bench_robust [--seconds N] [--gigabytes N] [--fill FILL] [--pairs | --together] PATH...
//
// PATH is a mesh file or a folder (searched through). With --pairs the files of the command line are united two
// by two: first and second, third and fourth, and so on. A line per case: `ok` with volume and counts,
// `error` with the message, or CRASH, TIMEOUT, OOM, INVALID, BUG (a broken invariant). Exit status 1 if any of
// those.
#include <cstdio>
#include <map>
#include <sstream>

#include "bench/cases/mesh_cases.h"
#include "csg/leaves/leaf.h"
#include "csg/operators/boolean.h"
#include "csg/operators/group.h"
#include "kernel/selection/measure.h"
#include "kernel/selection/simplify.h"

namespace cnrg::bench {
namespace {

struct Options {
  Limits limits{120, std::size_t{4} << 30};
  std::optional<Fill> fill;
  bool pairs = false, together = false;
};

std::string evaluate(const std::vector<std::string>& files, const Options& options) {
  std::vector<std::shared_ptr<const PreparedLeaf>> leaves;
  std::vector<LeafInstance> instances;
  std::string notices;
  for (const std::string& file : files) {
    leaves.push_back(prepare(MeshShape{file, options.fill, false}));
    instances.push_back({leaves.back(), {}});
    for (const std::string& notice : leaves.back()->notices()) notices += "; " + notice;
  }
  RefineReport report;
  const auto built_complex = build_complex(make_soup(instances), {}, &report);
  const Complex& complex = *built_complex;
  if (const std::string invalid = validate(complex); !invalid.empty()) return "INVALID " + invalid;
  const std::vector<Group> groups = leaf_groups(complex);
  Group group = groups[0];
  for (std::size_t i = 1; i < groups.size(); ++i)
    group = boolean_operation(complex, BooleanOp::unite, Dominance::equal, group, groups[i]).group;
  const SimplifiedComplex s = simplify(complex, selection_of(complex, group), group.features);
  const auto counts = active_counts(s);
  std::vector<RegionId> cells;
  for (const auto& [cell, region] : group.cells) cells.push_back(cell);
  const std::optional<Rational> volume = cnrg::volume(complex, cells);
  std::ostringstream out;
  out << "ok volume " << (volume ? to_decimal(*volume) : "unbounded") << ", cells " << complex.vertex_count()
      << " " << complex.edge_count() << " " << complex.face_count() << " " << complex.region_count << ", result "
      << counts[0] << " " << counts[1] << " " << counts[2] << " " << group.regions.size() << ", constructed "
      << report.constructed << ", zero area " << report.zero_area.size() << notices;
  return out.str();
}

std::string name_of(const std::vector<std::string>& files) {
  std::string names = files[0];
  if (files.size() > 3) return names + " and " + std::to_string(files.size() - 1) + " more";
  for (std::size_t i = 1; i < files.size(); ++i) names += " + " + files[i];
  return names;
}

int run(int argc, char** argv) {
  Options options;
  std::vector<std::string> paths;
  for (int i = 1; i < argc; ++i) {
    const std::string arg = argv[i];
    const auto value = [&] {
      if (++i >= argc) throw std::runtime_error(arg + " needs a value");
      return std::string(argv[i]);
    };
    if (arg == "--seconds") {
      options.limits.seconds = std::stod(value());
    } else if (arg == "--gigabytes") {
      options.limits.bytes = static_cast<std::size_t>(std::stod(value()) * (1 << 30));
    } else if (arg == "--fill") {
      const std::map<std::string, Fill> fills{
          {"none", Fill::none}, {"winding", Fill::winding}, {"parity", Fill::parity}, {"cells", Fill::cells}};
      options.fill = fills.at(value());
    } else if (arg == "--pairs") {
      options.pairs = true;
    } else if (arg == "--together") {
      options.together = true;
    } else {
      paths.push_back(arg);
    }
  }
  std::vector<std::vector<std::string>> groups;
  if (options.pairs) {
    for (std::size_t i = 0; i + 1 < paths.size(); i += 2) groups.push_back({paths[i], paths[i + 1]});
  } else if (const std::vector<std::string> files = mesh_files(paths); options.together) {
    groups.push_back(files);
  } else {
    for (const std::string& file : files) groups.push_back({file});
  }
  std::vector<MeshCase> cases;
  for (const auto& files : groups) cases.push_back({name_of(files), [&] { return evaluate(files, options); }});
  return run_cases(cases, options.limits, {"ok"});
}

}  // namespace
}  // namespace cnrg::bench

int main(int argc, char** argv) {
  try {
    return cnrg::bench::run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::fputs("bench_robust: error: memory ran out\n", stderr);
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_robust: error: %s\n", error.what());
    return 2;
  }
}
