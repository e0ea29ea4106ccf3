// `cnrg-eval`: the rows of a tree and its exact file, and nothing else: kernel and evaluation alone. A build has
// it long before `cnrg`, and one without other libraries has no other program.
#include <charconv>
#include <iostream>
#include <span>
#include <string_view>

#include "csg/app/evaluation.h"
#include "csg/app/exit_status.h"
#include "csg/app/row_table.h"
#include "csg/app/run_program.h"
#include "csg/app/versions.h"
#include "csg/result/result_data.h"
#include "csg/result/result_json.h"
#include "csg/text/file.h"
#include "kernel/base/error.h"

namespace cnrg::app {
namespace {

/// Leaves may be CAD models.
constexpr const Plugin* kUsed[] = {&kCadPlugin};

constexpr const char* kUsage =
    "Usage: cnrg-eval TREE [--node N]... [-o FILE.json] [--trace] [--threads N]\n"
    "Evaluates a tree: one row per node, and the exact file of the result or of one --node.\n\n"
    "  --node N      Evaluate this node, too\n"
    "  -o FILE.json  Write this file: the result, or the --node\n"
    "  --trace       Under each row: what each table row removed, volumes of regions\n"
    "  --threads N   Use N threads; 0 is one per core\n"
    "  --version     Versions of cnrg and of the libraries in it\n\n"
    "`cnrg eval` does more. Exit status: 0 done, 2 bad input, 3 a file could not be read or written or memory "
    "ran\n"
    "out, 1 a bug.\n";

struct Arguments {
  std::string tree, file;
  std::vector<std::string> nodes;
  bool trace = false;
  int threads = 0;
};

[[noreturn]] void refuse(const std::string& what) {
  throw InputError("cnrg-eval: error: " + what + "; see `cnrg-eval --help`");
}

int threads_of(const std::string& text) {
  int threads = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), threads);
  if (error != std::errc() || end != text.data() + text.size() || threads < 0 || threads > 4096)
    refuse("--threads takes a number from 0 to 4096, not " + text);
  return threads;
}

Arguments arguments_of(std::span<char*> words) {
  Arguments out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string word = words[i];
    const auto value = [&] {
      if (i + 1 == words.size()) refuse(word + " needs a value");
      std::string given = words[++i];
      if (given.empty()) refuse(word + ": the value is empty");
      return given;
    };
    if (word == "--trace") out.trace = true;
    else if (word == "--node") out.nodes.push_back(value());
    else if (word == "--threads") out.threads = threads_of(value());
    else if (word == "-o" && out.file.empty()) out.file = value();
    else if (word.size() > 1 && word[0] == '-') refuse("not expected: " + word);
    else if (!out.tree.empty()) refuse("one tree is expected, not also " + word);
    else out.tree = word;
  }
  if (out.tree.empty()) refuse("a tree is expected");
  if (!out.file.empty() && extension_of(out.file) != ".json")
    refuse("-o " + out.file + ": the extension is .json");
  if (!out.file.empty() && out.nodes.size() > 1) refuse("-o shows one node, and --node is given more than once");
  return out;
}

int evaluate_as_told(std::span<char*> words) {
  for (const std::string_view word : words) {
    if (word == "--help" || word == "-h") std::cout << kUsage;
    else if (word == "--version") std::cout << version_text("cnrg-eval", kUsed) << '\n';
    else continue;
    return kDone;
  }
  const Arguments arguments = arguments_of(words);
  StageClock clock("leaves");
  const Tree tree = tree_of(arguments.tree, {}, 1);
  if (!arguments.file.empty()) {
    require_no_directory(arguments.file);
    require_writable({arguments.file}, tree);
  }
  EvaluateOptions options;
  options.region_volumes = arguments.trace;
  options.threads = arguments.threads;
  for (const std::string& name : arguments.nodes) options.nodes.push_back(node_of(tree, name));
  const Evaluation evaluation = evaluate_in_view(tree, options, false, &clock);
  const bool crosses = tell_uncertain(tree, evaluation, false);
  clock.begin("results");
  std::cout << row_table(evaluation, stage_rows(clock, evaluation, crosses, true), false, arguments.trace);
  if (arguments.trace) std::cout << refinement_summary(evaluation);
  if (!arguments.file.empty()) {
    const Result result = evaluation.result(options.nodes.empty() ? tree.result : options.nodes.front());
    replace_file(arguments.file, result_json(result.data().view()));
  }
  return kDone;
}

}  // namespace
}  // namespace cnrg::app

int main(int argc, char** argv) {
  return cnrg::app::run_program(
      "cnrg-eval", [&] { return cnrg::app::evaluate_as_told(std::span(argv, std::size_t(argc)).subspan(1)); });
}
