#include "bench/sweep/plan.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <stdexcept>

#include "bench/cases/family.h"

namespace cnrg::bench {
namespace {

constexpr int kMostDistance = 16;

std::optional<int> distance_of(const std::string& text) {
  if (text == "exact") return {};
  const bool number =
      !text.empty() && text.size() <= 2 && text.find_first_not_of("0123456789") == std::string::npos;
  if (!number || std::stoi(text) > kMostDistance)
    throw std::runtime_error("'" + text + "' is no distance; a distance is `exact` or k from 0 to 16, for 10^-k");
  return std::stoi(text);
}

std::vector<std::optional<int>> distances_of(const Family& family, const Choice& choice) {
  if (!family.has_distance) return {std::nullopt};
  std::vector<std::optional<int>> distances;
  if (choice.distances.empty()) {
    for (int k = 0; k <= kMostDistance; ++k) distances.push_back(k);
    distances.push_back(std::nullopt);
  }
  for (const std::string& text : choice.distances) distances.push_back(distance_of(text));
  return distances;
}

/// Throws as `make_problem` does if the family has no such size.
void check_size(const Family& family, long size) {
  make_problem({family.name, family.operations[0], size, {}, 1});
}

void add_family(const Family& family, const Choice& choice, std::vector<std::string>& problems) {
  const int first = choice.first_seed.value_or(1), seeds = choice.seeds.value_or(family.seeds);
  for (const long size : choice.sizes) check_size(family, size);
  for (const long size : choice.sizes.empty() ? family.sizes : choice.sizes)
    for (const std::string& operation : family.operations) {
      const auto& wanted = choice.operations;
      if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), operation) == wanted.end()) continue;
      for (const std::optional<int>& distance : distances_of(family, choice))
        for (int seed = first; seed < first + seeds; ++seed)
          problems.push_back(
              ProblemId{family.name, operation, size, distance, static_cast<unsigned>(seed)}.name());
    }
}

/// Every n-th, so that the first and all kinds stay.
void thin_out(std::vector<std::string>& problems, std::size_t limit) {
  if (limit == 0 || problems.size() <= limit) return;
  std::vector<std::string> some;
  for (std::size_t i = 0; i < limit; ++i) some.push_back(problems[i * problems.size() / limit]);
  problems = std::move(some);
}

/// What is chosen has to mean something for one of the families at least, or for the folder.
void require_meaning(const Choice& choice, const std::vector<const Family*>& chosen, bool folder) {
  const auto require = [&](bool given, const char* option, bool applies) {
    if (given && !applies)
      throw std::runtime_error(std::string("--") + option + " means nothing for " +
                               (folder           ? "a folder of meshes"
                                : chosen.empty() ? "problems that are named one by one"
                                                 : "these families") +
                               ": leave it out");
  };
  require(!choice.sizes.empty(), "sizes", !chosen.empty());
  require(choice.seeds.has_value(), "seeds", !chosen.empty());
  require(choice.first_seed.has_value(), "first-seed", !chosen.empty());
  require(!choice.distances.empty(), "distances",
          std::any_of(chosen.begin(), chosen.end(), [](const Family* f) { return f->has_distance; }));
  require(!choice.operations.empty(), "operations", folder || !chosen.empty());
  for (const std::string& operation : choice.operations) {
    const auto has = [&](const std::vector<std::string>& all) {
      return std::find(all.begin(), all.end(), operation) != all.end();
    };
    if (folder ? has(folder_operations())
               : std::any_of(chosen.begin(), chosen.end(), [&](const Family* f) { return has(f->operations); }))
      continue;
    std::set<std::string> all;
    if (folder) all = {folder_operations().begin(), folder_operations().end()};
    for (const Family* f : chosen) all.insert(f->operations.begin(), f->operations.end());
    std::string known;
    for (const std::string& name : all) known += (known.empty() ? "" : ", ") + name;
    throw std::runtime_error("'" + operation + "' is no operation here; there are " + known);
  }
}

bool is_problem(const std::string& name) {
  try {
    const ProblemId id = ProblemId::parse(name);
    return std::any_of(families().begin(), families().end(), [&](const Family& f) { return f.name == id.family; });
  } catch (const std::runtime_error&) {
    return false;
  }
}

}  // namespace

Plan plan_of(const Choice& choice) {
  namespace fs = std::filesystem;
  Plan plan;
  if (choice.names.empty())
    throw std::runtime_error("name families or a folder of meshes; `--list` lists families");
  std::vector<const Family*> chosen;
  for (const std::string& name : choice.names) {
    const auto family =
        std::find_if(families().begin(), families().end(), [&](const Family& f) { return f.name == name; });
    if (family != families().end()) {
      chosen.push_back(&*family);
      add_family(*family, choice, plan.problems);
    } else if (name == "all") {
      for (const Family& each : families()) {
        chosen.push_back(&each);
        add_family(each, choice, plan.problems);
      }
    } else if (is_problem(name)) {
      make_problem(ProblemId::parse(name));  // throws for an operation, size or distance that there is not
      plan.problems.push_back(name);
    } else if (fs::is_directory(name)) {
      if (choice.names.size() > 1) throw std::runtime_error("a folder makes a sweep by itself; name it alone");
      plan.folder = fs::canonical(name).string();
      plan.problems = folder_problems(plan.folder, choice.operations);
      if (plan.problems.empty()) throw std::runtime_error(name + ": holds no OFF, OBJ, STL or PLY file");
    } else {
      std::string known;
      for (const Family& each : families()) known += (known.empty() ? "" : ", ") + each.name;
      throw std::runtime_error("'" + name + "' is no family, no problem and no folder; families are " + known +
                               " (`all`: all of them); the benchmarks of speed are `bench/run speed NAME`");
    }
  }
  require_meaning(choice, chosen, !plan.folder.empty());
  std::vector<std::string> sorted = plan.problems;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
    throw std::runtime_error("a family, a problem, a size or a distance is named twice");
  thin_out(plan.problems, choice.limit);
  return plan;
}

}  // namespace cnrg::bench
