// What all commands share: a tree read at the fineness asked for, an evaluation behind a progress bar, and the
// printing of its diagnostics.
#include "csg/app/evaluation.h"

#include <tbb/global_control.h>

#include <filesystem>
#include <set>

#include "csg/app/output.h"
#include "csg/app/progress_bar.h"
#include "csg/evaluate/certify.h"
#include "csg/evaluate/prepared_leaves.h"

namespace cnrg::app {
namespace {

std::string count(std::size_t n, const std::string& what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

}  // namespace

// So that files are made with no more, too. It is never undone: where a limit of oneTBB goes, threads that waited
// for it are started, and if the system gives none the program ends in the middle of a destructor.
void limit_threads(int threads) {
  static const tbb::global_control* limit = nullptr;
  if (threads > 0 && limit == nullptr) {
    limit =
        new tbb::global_control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  }
}

NodeId node_of(const Tree& tree, const std::string& name, const char* option) {
  try {
    return name.empty() ? tree.result : tree.find(name);
  } catch (const InputError& e) {
    throw InputError(std::string(option) + ": " + e.what());
  }
}

Evaluation evaluate_in_view(const Tree& tree, EvaluateOptions options, bool quiet) {
  limit_threads(options.threads);
  ProgressBar bar(quiet);
  options.watch.progress = [&](std::string_view stage, std::size_t done, std::size_t total) {
    bar.show(stage, done, total);
  };
  Evaluation evaluation = evaluate(tree, options);
  bar.clear();
  print(evaluation.diagnostics, quiet);
  return evaluation;
}

void tell_uncertain(const Tree& tree, const Evaluation& evaluation, bool quiet) {
  if (quiet) return;
  constexpr std::size_t kTold = 3;
  const Certificate certificate = certify(tree, evaluation, kTold, false);
  print(certificate.notices, quiet);
  if (certificate.places <= kTold) return;
  tell(tree.file + ": notice: " + count(certificate.places - kTold, "more place") +
       " where curved surfaces may not cross as their facets do; --certify tells of ten");
}

void require_certain(const Tree& tree, const Evaluation& evaluation, bool quiet) {
  const Certificate certificate = certify(tree, evaluation);
  if (certificate.places == 0) {
    if (quiet) return;
    tell(tree.file + ": notice: certified: " +
         (certificate.edges == 0 ? std::string("no curved patch meets a patch of another leaf")
                                 : "where curved patches meet others, along " + count(certificate.edges, "edge") +
                                       ", the surfaces cross as their facets do"));
    return;
  }
  for (std::size_t i = 1; i < certificate.notices.size(); ++i) print({certificate.notices[i]}, quiet);
  const Diagnostic& first = certificate.notices.front();
  throw TreeError(first.file, first.at,
                  first.message + "; --certify found " + count(certificate.places, "such place") +
                      ": make the leaves finer, move them apart or together, or leave it out");
}

void require_distinct(const std::vector<std::string>& files) {
  std::set<std::filesystem::path> seen;
  for (const std::string& file : files) {
    std::error_code code;
    const std::filesystem::path place = std::filesystem::weakly_canonical(std::filesystem::absolute(file), code);
    if (seen.insert(code ? std::filesystem::path(file) : place).second) continue;
    throw InputError("cnrg: error: the file " + file + " is given by two -o; give each its own name");
  }
}

void require_writable(const std::vector<std::string>& files, const Tree& tree) {
  const auto require = [&](const std::string& input, const std::string& what) {
    for (const std::string& file : files) {
      std::error_code code;  // of what is not there
      if (!std::filesystem::equivalent(file, input, code)) continue;
      throw InputError("cnrg: error: -o " + file + " would replace " + what + "; give another name");
    }
  };
  if (files.empty()) return;
  for (const std::string& file : files) {
    std::error_code code;  // of what is not there
    const std::filesystem::path folder = std::filesystem::path(file).parent_path();
    if (folder.empty() || std::filesystem::is_directory(folder, code)) continue;
    throw FileError(file + ": cannot be written: there is no folder '" + folder.string() + "'; make it first");
  }
  require(tree.file, "the tree itself");
  for (const Node& node : tree.nodes) {
    const std::string* const file = node.shape ? file_of(*node.shape) : nullptr;
    if (file != nullptr) require(*file, "a file that the node " + node.name + " reads");
  }
}

void print(const std::vector<Diagnostic>& diagnostics, bool quiet) {
  for (const Diagnostic& d : diagnostics) {
    if (!quiet || d.level == Diagnostic::Level::warning) tell(d.text());
  }
}

}  // namespace cnrg::app
