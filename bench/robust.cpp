// Evaluates mesh files, each in a process of its own with limits, and says what became of them.
//
//   bench_robust [--seconds N] [--gigabytes N] [--fill FILL] [--pairs | --together] PATH...
//
// PATH is a mesh file or a folder (searched through). With --pairs the files of the command line are united two
// by two: first and second, third and fourth, and so on. A line per case: `ok` with volume and counts,
// `error` with the message, or CRASH, TIMEOUT, OOM, INVALID, BUG (a broken invariant). Exit status 1 if any of
// those.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <sstream>

#include "bench/cases/child.h"
#include "csg/leaves/leaf.h"
#include "csg/operators/boolean.h"
#include "csg/operators/leaf_group.h"
#include "kernel/base/error.h"
#include "kernel/selection/measure.h"
#include "kernel/selection/simplify.h"

namespace cnrg::bench {
namespace {

namespace fs = std::filesystem;

struct Options {
  Limits limits{120, std::size_t{4} << 30};
  std::optional<Fill> fill;
  bool pairs = false, together = false;
};

std::string evaluate(const std::vector<std::string>& files, const Options& options) {
  try {
    std::vector<std::unique_ptr<PreparedLeaf>> leaves;
    std::vector<LeafInstance> instances;
    std::string notices;
    for (const std::string& file : files) {
      leaves.push_back(prepare(MeshShape{file, options.fill, false}));
      instances.push_back({leaves.back().get(), {}});
      for (const std::string& notice : leaves.back()->notices()) notices += "; " + notice;
    }
    RefineReport report;
    const Complex complex = build_complex(make_soup(instances), {}, &report);
    if (const std::string invalid = validate(complex); !invalid.empty()) return "INVALID " + invalid;
    const std::vector<Group> groups = leaf_groups(complex);
    Group group = groups[0];
    for (std::size_t i = 1; i < groups.size(); ++i)
      group = apply(complex, BooleanOp::unite, Dominance::equal, group, groups[i]).group;
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
  } catch (const InvariantError& error) {
    return std::string("BUG ") + error.what();
  } catch (const InputError& error) {
    return std::string("error ") + error.what();
  } catch (const FileError& error) {
    return std::string("error ") + error.what();
  }
}

bool is_mesh(const fs::path& path) {
  const std::string e = path.extension().string();
  return e == ".off" || e == ".obj" || e == ".stl" || e == ".ply";
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
  std::vector<std::vector<std::string>> cases;
  if (options.pairs) {
    for (std::size_t i = 0; i + 1 < paths.size(); i += 2) cases.push_back({paths[i], paths[i + 1]});
  } else {
    std::vector<std::string> files;
    for (const std::string& path : paths) {
      if (!fs::is_directory(path)) {
        files.push_back(path);
        continue;
      }
      for (const auto& entry : fs::recursive_directory_iterator(path))
        if (entry.is_regular_file() && is_mesh(entry.path())) files.push_back(entry.path().string());
    }
    std::sort(files.begin(), files.end());
    if (options.together)
      cases.push_back(files);
    else
      for (const std::string& file : files) cases.push_back({file});
  }
  std::map<std::string, int> totals;
  for (const auto& files : cases) {
    const ChildResult child = run_child([&] { return evaluate(files, options); }, options.limits);
    std::string text = child.text;
    switch (child.end) {
      case ChildResult::End::done: break;
      case ChildResult::End::crash: text = "CRASH signal " + std::to_string(child.signal); break;
      case ChildResult::End::timeout: text = "TIMEOUT"; break;
      case ChildResult::End::out_of_memory: text = "OOM"; break;
    }
    ++totals[text.substr(0, text.find(' '))];
    std::string names = files[0];
    if (files.size() > 3)
      names += " and " + std::to_string(files.size() - 1) + " more";
    else
      for (std::size_t i = 1; i < files.size(); ++i) names += " + " + files[i];
    std::printf("%s: %.2f s, %.0f MB: %s\n", names.c_str(), child.seconds,
                static_cast<double>(child.peak_bytes) / 1e6, text.c_str());
    std::fflush(stdout);
  }
  int bad = 0;
  for (const auto& [kind, count] : totals) {
    std::printf("%s %d\n", kind.c_str(), count);
    if (kind != "ok" && kind != "error") bad += count;
  }
  return bad == 0 ? 0 : 1;
}

}  // namespace
}  // namespace cnrg::bench

int main(int argc, char** argv) {
  try {
    return cnrg::bench::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_robust: %s\n", error.what());
    return 2;
  }
}
