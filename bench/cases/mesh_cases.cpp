#include "bench/cases/mesh_cases.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>

#include "kernel/base/error.h"

namespace cnrg::bench {
namespace {

namespace fs = std::filesystem;

bool is_mesh(const fs::path& path) {
  const std::string e = path.extension().string();
  return e == ".off" || e == ".obj" || e == ".stl" || e == ".ply";
}

std::string told(const std::function<std::string()>& work) {
  try {
    return work();
  } catch (const InvariantError& error) {
    return std::string("BUG ") + error.what();
  } catch (const InputError& error) {
    return std::string("error ") + error.what();
  } catch (const FileError& error) {
    return std::string("error ") + error.what();
  }
}

std::string line_of(const ChildResult& child) {
  switch (child.end) {
    case ChildResult::End::crash: return "CRASH signal " + std::to_string(child.signal);
    case ChildResult::End::timeout: return "TIMEOUT";
    case ChildResult::End::out_of_memory: return "OOM";
    case ChildResult::End::done: break;
  }
  return child.text;
}

}  // namespace

std::vector<std::string> mesh_files(const std::vector<std::string>& paths) {
  std::vector<std::string> files;
  for (const std::string& path : paths) {
    if (!fs::is_directory(path)) {
      files.push_back(path);
      continue;
    }
    for (const auto& entry : fs::recursive_directory_iterator(path)) {
      if (entry.is_regular_file() && is_mesh(entry.path())) files.push_back(entry.path().string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

int run_cases(const std::vector<MeshCase>& cases, const Limits& limits, const std::set<std::string>& good) {
  std::map<std::string, int> totals;
  for (const MeshCase& c : cases) {
    const ChildResult child = run_child([&] { return told(c.work); }, limits);
    const std::string line = line_of(child);
    ++totals[line.substr(0, line.find_first_of(" :"))];
    std::printf("%s: %.2f s, %.0f MB: %s\n", c.name.c_str(), child.seconds,
                static_cast<double>(child.peak_bytes) / 1e6, line.c_str());
    std::fflush(stdout);
  }
  bool bad = false;
  for (const auto& [kind, count] : totals) {
    std::printf("%s %d\n", kind.c_str(), count);
    bad = bad || (kind != "error" && good.count(kind) == 0);
  }
  return bad ? 1 : 0;
}

}  // namespace cnrg::bench
