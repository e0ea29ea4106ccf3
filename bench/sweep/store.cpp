#include "bench/sweep/store.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "bench/sweep/machine.h"
#include "csg/text/escape.h"

namespace cnrg::bench {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  throw std::runtime_error(path + ": " + what + ": " + std::strerror(errno));
}

void make_folder(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) throw std::runtime_error(path.string() + ": cannot be made a folder: " + error.message());
}

std::string read(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error(path + ": cannot be read");
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

nlohmann::json settings_of(const Setup& setup) {
  nlohmann::json programs = nlohmann::json::object();
  for (const System& system : setup.systems)
    if (!system.executable.empty())
      programs[system.name] = {{"program", system.executable}, {"rounding", system.rounding}};
  nlohmann::json experiments = nlohmann::json::object();
  for (const Experiment& e : setup.experiments) experiments[e.name] = e.is_folder() ? e.path : e.text;
  const auto limit = [](const std::optional<double>& given) {
    return given ? nlohmann::json(*given) : nlohmann::json();
  };
  return {{"commit", setup.commit},
          {"seconds", limit(setup.seconds)},
          {"gigabytes", limit(setup.gigabytes)},
          {"experiments", experiments},
          {"programs", programs}};
}

}  // namespace

Store::Store(const std::string& folder) : folder_(folder) {
  make_folder(fs::path(folder) / "truth");
  make_folder(fs::path(folder) / "rows");
}

Store::~Store() {
  if (lock_ >= 0) close(lock_);
}

void Store::settle(const Setup& setup) {
  const std::string path = folder_ + "/settings.json";
  const nlohmann::json wanted = settings_of(setup);
  if (!fs::exists(path)) {
    write_whole(path, wanted.dump(1) + "\n");
    return;
  }
  nlohmann::json there;
  try {
    there = nlohmann::json::parse(read(path));
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(path + ": is broken (" + error.what() + "); remove this file and sweep again");
  }
  const auto compare = [&](const std::string& what, const nlohmann::json& old, const nlohmann::json& now) {
    if (old != now)
      throw std::runtime_error(path + ": the sweep in this folder has " + what + " " + excerpt(old.dump()) +
                               ", this command " + excerpt(now.dump()) +
                               "; give the same, or another folder by --out");
  };
  for (const char* key : {"commit", "seconds", "gigabytes"})
    compare(key, there.value(key, nlohmann::json()), wanted[key]);
  const nlohmann::json before = there;
  for (const char* key : {"experiments", "programs"})  // new ones may come
    for (const auto& [name, one] : wanted[key].items())
      compare(std::string("another ") + (key[0] == 'e' ? "experiment " : "program ") + name,
              there[key].emplace(name, one).first.value(), one);
  if (there != before) write_whole(path, there.dump(1) + "\n");
}

void Store::describe(const Setup& setup, const std::string& command, const LeftOut& left_out) const {
  const std::string rows = folder_ + "/rows/";
  std::vector<SystemInfo> systems;
  for (const System& s : setup.systems) {
    const std::string version = s.absent.empty() ? s.version() : "";
    systems.push_back({s.name, s.title, s.guarantee, version, s.rounding, s.regularized, s.absent, s.varies});
  }
  if (fs::exists(rows + kSystemsFile))  // programs of earlier commands
    for (const SystemInfo& old : systems_of_json(read(rows + kSystemsFile)))
      if (std::none_of(systems.begin(), systems.end(), [&](const SystemInfo& s) { return s.name == old.name; }))
        systems.push_back(old);
  std::vector<FamilyInfo> all;
  for (const Experiment& e : setup.experiments) {
    const auto means = [&](const char* name, const char* otherwise) {
      const Parameter* const p = e.parameter(name);
      return p == nullptr || p->means.empty() ? std::string(otherwise) : p->means;
    };
    all.push_back({e.name, e.title, means("size", e.parameter("size") == nullptr ? "triangles" : "size"),
                   means("k", "distance to the degenerate position, as a part of the operands' size"), e.growth});
  }
  if (fs::exists(rows + kFamiliesFile))  // experiments of earlier commands
    for (const FamilyInfo& old : families_of_json(read(rows + kFamiliesFile)))
      if (std::none_of(all.begin(), all.end(), [&](const FamilyInfo& f) { return f.name == old.name; }))
        all.push_back(old);
  MachineInfo machine = this_machine();
  if (fs::exists(rows + kMachineFile)) machine = machine_of_json(read(rows + kMachineFile));
  machine.commit = setup.commit;
  if (machine.command.find(command) == std::string::npos)
    machine.command += (machine.command.empty() ? "" : "; ") + command;
  machine.left_out = left_out;
  write_whole(rows + kSystemsFile, to_json(systems));
  write_whole(rows + kFamiliesFile, to_json(all));
  write_whole(rows + kMachineFile, to_json(machine));
}

void Store::lock() {
  const std::string path = folder_ + "/lock";
  lock_ = open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644);
  if (lock_ < 0) fail(path, "cannot be opened");
  if (flock(lock_, LOCK_EX | LOCK_NB) != 0)
    throw std::runtime_error(folder_ +
                             ": another sweep is at work here; wait for it, or give another folder by --out");
}

std::string Store::truth_path(const std::string& problem) const { return folder_ + "/truth/" + problem + ".json"; }

std::string Store::row_path(const std::string& problem, const std::string& system) const {
  return folder_ + "/rows/" + problem + "/" + system + ".json";
}

std::optional<Truth> Store::truth(const std::string& problem, const std::string& of) const {
  const std::string path = truth_path(problem);
  if (!fs::exists(path)) return {};
  Truth truth;
  try {
    truth = truth_of_json(read(path));
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ": " + error.what() + "; remove it and sweep again");
  }
  if (truth.experiment != of)
    throw std::runtime_error(folder_ + " has the problem " + problem + " of " + truth.experiment +
                             "; give another folder by --out");
  return truth;
}

bool Store::has_row(const std::string& problem, const std::string& system) const {
  return fs::exists(row_path(problem, system));
}

void Store::write_truth(const std::string& problem, const Truth& truth) const {
  write_whole(truth_path(problem), to_json(truth));
}

void Store::write_row(const SweepRow& row) const {
  const std::string path = row_path(row.problem, row.system);
  make_folder(fs::path(path).parent_path());
  write_whole(path, to_json(row));
}

void write_whole(const std::string& path, const std::string& text) {
  // Units of one sweep never write the same file, but its settings may be made by several jobs at once.
  const std::string beside = path + "." + std::to_string(getpid()) + ".part";
  const int file = open(beside.c_str(), O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, 0644);
  if (file < 0) fail(beside, "cannot be written");
  const auto give_up = [&](const char* what) {
    const int reason = errno;
    close(file);
    unlink(beside.c_str());
    errno = reason;
    fail(path, what);
  };
  for (std::size_t at = 0; at < text.size();) {
    const ssize_t n = write(file, text.data() + at, text.size() - at);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) give_up("cannot be written");
    at += static_cast<std::size_t>(n);
  }
  if (fsync(file) != 0) give_up("cannot be written");
  close(file);
  if (std::rename(beside.c_str(), path.c_str()) != 0) {
    const int reason = errno;
    unlink(beside.c_str());
    errno = reason;
    fail(path, "cannot be written");
  }
}

}  // namespace cnrg::bench
