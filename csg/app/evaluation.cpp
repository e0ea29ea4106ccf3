// What all commands share: a tree read at the fineness asked for, an evaluation behind a progress bar, and the
// printing of its diagnostics.
#include "csg/app/evaluation.h"

#include <tbb/global_control.h>

#include <array>
#include <filesystem>
#include <set>
#include <string_view>

#include "csg/app/output.h"
#include "csg/app/progress_bar.h"
#include "csg/certify/certificate.h"
#include "csg/evaluate/prepared_leaves.h"
#include "csg/text/input_file.h"
#include "csg/text/table.h"
#include "csg/tree/read_from_input.h"
#include "csg/tree/tree_of_file.h"

namespace cnrg::app {
namespace {

/// The rows of time, each with the stage of the evaluation at which it begins.
struct Stage {
  std::string_view begin, row;
};
constexpr std::array<Stage, 4> kStages{
    {{"leaves", "leaves"}, {"crossings", "crossings"}, {"refine", "refinement"}, {"nodes", "nodes"}}};

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

Tree tree_of(const std::string& path, const ReadOptions& reading, int finer) {
  Tree tree = path == kStandardInputWord ? read_tree_from_input(reading) : tree_of_file(path, reading);
  make_finer(tree, finer);
  return tree;
}

NodeId node_of(const Tree& tree, const std::string& name, const char* option) {
  try {
    return name.empty() ? tree.result : tree.find(name);
  } catch (const InputError& e) {
    throw InputError(std::string(option) + ": " + e.what());
  }
}

Evaluation evaluate_in_view(const Tree& tree, EvaluateOptions options, bool quiet, StageClock* clock) {
  limit_threads(options.threads);
  ProgressBar bar(quiet);
  // Stages of evaluations within this one, of nodes that a material is graded to, are part of the stage that it is
  // in.
  std::size_t reached = 0;
  options.watch.progress = [&](std::string_view stage, std::size_t done, std::size_t total) {
    bar.show(stage, done, total);
    if (clock == nullptr) return;
    for (std::size_t i = reached; i < kStages.size(); ++i) {
      if (!stage.starts_with(kStages[i].begin)) continue;
      clock->begin(kStages[i].row);
      reached = i + 1;
    }
  };
  Evaluation evaluation = evaluate(tree, options);
  bar.clear();
  print(evaluation.diagnostics, quiet);
  return evaluation;
}

bool tell_uncertain(const Tree& tree, const Evaluation& evaluation, bool quiet) {
  if (quiet) return false;
  if (!evaluation.certificate) {
    for (std::uint32_t i = 0; i < evaluation.leaf_names.size(); ++i) {
      if (!evaluation.parameters->surfaces(LeafId(i))) continue;
      tell(tree.file + ": notice: it was not asked whether curved surfaces meet as their facets do");
      break;
    }
    return false;
  }
  const Certificate certificate = certificate_of(evaluation);
  print(certificate.told(tree), quiet);
  return certificate.asked > 0;
}

bool require_certain(const Tree& tree, const Evaluation& evaluation, bool quiet) {
  constexpr std::size_t kTold = 10;
  const Certificate certificate = certificate_of(evaluation);
  if (!certificate.unknown.empty()) {
    const Node& node = tree.nodes[certificate.unknown.front()];
    throw TreeError(
        tree.file, node.operator_at,
        "--certify: of curved faces of `" + node.name +
            "` only the facets are known, which do not decide how they meet: it is a CAD model, a result, "
            "`weld` or `within` moved it, or facets without area are missing: build it of shapes, "
            "make it finer, or leave --certify out");
  }
  if (certificate.places.empty()) {
    if (!quiet) {
      tell(tree.file + ": notice: certified: surfaces meet as their facets do: " +
           (certificate.asked == 0
                ? "no curved face is near another one"
                : "of " + counted(certificate.asked, "pair", "pairs") + " of facets near each other " +
                      std::to_string(certificate.apart) + " are apart, " + std::to_string(certificate.crossing) +
                      " cross and " + std::to_string(certificate.contacts) + " touch"));
    }
    return certificate.asked > 0;
  }
  const std::vector<Diagnostic> notices = certificate.notices(tree, kTold);
  for (std::size_t i = 1; i < notices.size(); ++i) print({notices[i]}, quiet);
  const Diagnostic& first = notices.front();
  throw TreeError(first.file, first.at,
                  first.message + "; --certify found " +
                      counted(certificate.places.size(), "such place", "such places") +
                      ": move leaves apart or together, make them finer, or leave it out");
}

void require_distinct(const std::vector<std::string>& files) {
  std::set<std::filesystem::path> seen;
  for (const std::string& file : files) {
    std::error_code code;
    const std::filesystem::path place = std::filesystem::weakly_canonical(std::filesystem::absolute(file), code);
    if (seen.insert(code ? std::filesystem::path(file) : place).second) continue;
    throw InputError("the file " + file + " is given by two -o; give each its own name");
  }
}

void require_writable(const std::vector<std::string>& files, const Tree& tree) {
  const auto require = [&](const std::string& input, const std::string& what) {
    for (const std::string& file : files) {
      std::error_code code;  // of what is not there
      if (!std::filesystem::equivalent(file, input, code)) continue;
      throw InputError("-o " + file + " would replace " + what + "; give another name");
    }
  };
  if (files.empty()) return;
  for (const std::string& file : files) {
    std::error_code code;  // of what is not there
    const std::filesystem::path folder = std::filesystem::path(file).parent_path();
    if (folder.empty() || std::filesystem::is_directory(folder, code)) continue;
    throw FileError(file + ": cannot be written: there is no folder '" + folder.string() + "'; make it first");
  }
  require(tree.file == kStandardInput ? "/dev/stdin" : tree.file, "the tree itself");
  for (const std::string& input : tree.inputs) require(input, "a file that the tree reads");
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
