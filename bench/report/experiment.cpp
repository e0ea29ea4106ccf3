#include "bench/report/experiment.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <tuple>

#include "bench/sweep/json_fields.h"

namespace cnrg::bench {
namespace {

namespace fs = std::filesystem;

std::string read_text(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) throw std::runtime_error(path.string() + ": can not be read");
  return text;
}

/// What `read` makes of the file; its errors get the file's name and a remedy.
template <class Read>
auto read_file(const fs::path& path, const char* remedy, const Read& read) {
  const std::string text = read_text(path);
  try {
    return read(text);
  } catch (const std::runtime_error& e) {
    throw std::runtime_error(path.string() + ": " + e.what() + "; " + remedy);
  }
}

bool hidden(const fs::path& path) { return path.filename().string().front() == '.'; }

std::vector<fs::path> row_files(const fs::path& folder) {
  std::vector<fs::path> files;
  for (auto i = fs::recursive_directory_iterator(folder); i != fs::recursive_directory_iterator(); ++i) {
    const fs::path path = i->path();
    if (hidden(path)) {
      if (i->is_directory()) i.disable_recursion_pending();
      continue;
    }
    if (!i->is_regular_file() || path.extension() != ".json") continue;
    const bool described =
        path.parent_path() == folder &&
        (path.filename() == kSystemsFile || path.filename() == kFamiliesFile || path.filename() == kMachineFile);
    if (!described) files.push_back(path);
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Text before numbers, numbers by value: `s10` comes after `s9`.
bool natural_less(const std::string& a, const std::string& b) {
  const auto digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (!digit(a[i]) || !digit(b[j])) {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i, ++j;
      continue;
    }
    std::size_t i_end = i, j_end = j;
    while (i_end < a.size() && digit(a[i_end])) ++i_end;
    while (j_end < b.size() && digit(b[j_end])) ++j_end;
    while (i + 1 < i_end && a[i] == '0') ++i;
    while (j + 1 < j_end && b[j] == '0') ++j;
    if (i_end - i != j_end - j) return i_end - i < j_end - j;
    const int order = a.compare(i, i_end - i, b, j, j_end - j);
    if (order != 0) return order < 0;
    i = i_end;
    j = j_end;
  }
  const std::size_t left = a.size() - i, right = b.size() - j;
  return left != right ? left < right : a < b;
}

/// Adds infos with nothing but a name for those names that have none, in the names' order.
template <class Info>
void complete(std::vector<Info>& infos, std::vector<std::string> names) {
  std::sort(names.begin(), names.end(), natural_less);
  for (const std::string& name : names) {
    if (std::none_of(infos.begin(), infos.end(), [&](const Info& info) { return info.name == name; })) {
      infos.push_back(Info{});
      infos.back().name = name;
      infos.back().title = name;
    }
  }
}

template <class Info>
std::map<std::string, std::size_t> places_of(const std::vector<Info>& infos) {
  std::map<std::string, std::size_t> places;
  for (const Info& info : infos) {
    if (!places.emplace(info.name, places.size()).second) {
      throw std::runtime_error("`" + info.name + "` is described twice; remove one of the two");
    }
  }
  return places;
}

nlohmann::json list_of(const std::string& text) {
  nlohmann::json list = parse_json(text);
  if (!list.is_array()) throw std::runtime_error("no JSON list");
  return list;
}

}  // namespace

std::string to_json(const std::vector<SystemInfo>& systems) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (const SystemInfo& s : systems) {
    out.push_back({{"name", s.name},
                   {"title", s.title},
                   {"guarantee", s.guarantee},
                   {"version", s.version},
                   {"rounding", s.rounding},
                   {"regularized", s.regularized},
                   {"absent", s.absent}});
  }
  return json_text(out, 1);
}

std::string to_json(const std::vector<FamilyInfo>& families) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (const FamilyInfo& f : families) {
    out.push_back({{"name", f.name}, {"title", f.title}, {"size_means", f.size_means}});
  }
  return json_text(out, 1);
}

std::string to_json(const MachineInfo& m) {
  const nlohmann::ordered_json out{{"cpu", m.cpu},
                                   {"cores", m.cores},
                                   {"memory_bytes", m.memory_bytes},
                                   {"system", m.system},
                                   {"compiler", m.compiler},
                                   {"commit", m.commit},
                                   {"date", m.date},
                                   {"limit_seconds", m.limit_seconds},
                                   {"limit_bytes", m.limit_bytes},
                                   {"command", m.command},
                                   {"left_out", m.left_out}};
  return json_text(out, 1);
}

std::vector<SystemInfo> systems_of_json(const std::string& text) {
  const nlohmann::json list = list_of(text);
  std::vector<SystemInfo> systems;
  for (const nlohmann::json& object : list) {
    const JsonFields in(object, "a system");
    systems.push_back({in.text("name"), in.text("title"), in.text("guarantee"), in.text("version"),
                       in.not_negative("rounding"), in.flag("regularized"), in.text("absent")});
  }
  return systems;
}

std::vector<FamilyInfo> families_of_json(const std::string& text) {
  const nlohmann::json list = list_of(text);
  std::vector<FamilyInfo> families;
  for (const nlohmann::json& object : list) {
    const JsonFields in(object, "a family");
    families.push_back({in.text("name"), in.text("title"), in.text("size_means")});
  }
  return families;
}

MachineInfo machine_of_json(const std::string& text) {
  const nlohmann::json object = parse_json(text);
  const JsonFields in(object, "the machine");
  MachineInfo m;
  m.cpu = in.text("cpu");
  m.cores = in.integer<unsigned>("cores");
  m.memory_bytes = in.integer<std::size_t>("memory_bytes");
  m.system = in.text("system");
  m.compiler = in.text("compiler");
  m.commit = in.text("commit");
  m.date = in.text("date");
  m.limit_seconds = in.not_negative("limit_seconds");
  m.limit_bytes = in.integer<std::size_t>("limit_bytes");
  m.command = in.text("command");
  for (const nlohmann::json& one : in.list("left_out")) {
    if (!one.is_array() || one.size() != 2 || !one[0].is_string() || !one[1].is_string())
      in.fail("left_out", "a list of pairs of texts");
    m.left_out.emplace_back(one[0], one[1]);
  }
  return m;
}

Experiment make_experiment(std::vector<SweepRow> rows, std::vector<SystemInfo> systems,
                           std::vector<FamilyInfo> families, std::optional<MachineInfo> machine) {
  if (rows.empty()) throw std::runtime_error("there are no rows; run a sweep first");
  std::vector<std::string> system_names, family_names;
  for (const SweepRow& row : rows) {
    system_names.push_back(row.system);
    family_names.push_back(row.family);
  }
  complete(systems, system_names);
  complete(families, family_names);
  std::stable_partition(systems.begin(), systems.end(), [](const SystemInfo& s) { return s.name == kOurs; });
  const auto system_place = places_of(systems), family_place = places_of(families);
  std::sort(rows.begin(), rows.end(), [&](const SweepRow& a, const SweepRow& b) {
    if (a.family != b.family) return family_place.at(a.family) < family_place.at(b.family);
    if (a.problem != b.problem) return natural_less(a.problem, b.problem);
    return system_place.at(a.system) < system_place.at(b.system);
  });
  const auto twice = std::adjacent_find(rows.begin(), rows.end(), [](const SweepRow& a, const SweepRow& b) {
    return a.problem == b.problem && a.system == b.system;
  });
  if (twice != rows.end()) {
    throw std::runtime_error("two rows of " + twice->system + " on " + twice->problem +
                             "; remove one of the two files");
  }
  return {std::move(systems), std::move(families), std::move(machine), std::move(rows)};
}

Experiment read_experiment(const std::string& folder, const std::string& machine_file) {
  if (!fs::is_directory(folder)) {
    throw std::runtime_error(folder + ": is no folder; give the one that a sweep wrote its rows to");
  }
  const fs::path root(folder);
  std::vector<SweepRow> rows;
  for (const fs::path& file : row_files(root)) {
    rows.push_back(read_file(file, "remove the file and let the sweep make it again", row_of_json));
  }
  if (rows.empty()) {
    throw std::runtime_error(folder +
                             ": there are no rows (*.json); give the folder that a sweep wrote its rows to");
  }
  constexpr const char* kRemedy = "correct or remove it";
  std::vector<SystemInfo> systems;
  std::vector<FamilyInfo> families;
  std::optional<MachineInfo> machine;
  if (fs::exists(root / kSystemsFile)) systems = read_file(root / kSystemsFile, kRemedy, systems_of_json);
  if (fs::exists(root / kFamiliesFile)) families = read_file(root / kFamiliesFile, kRemedy, families_of_json);
  const fs::path machine_path = machine_file.empty() ? root / kMachineFile : fs::path(machine_file);
  if (!machine_file.empty() || fs::exists(machine_path)) {
    machine = read_file(machine_path, "correct it or leave it out", machine_of_json);
  }
  return make_experiment(std::move(rows), std::move(systems), std::move(families), std::move(machine));
}

}  // namespace cnrg::bench
