// `cnrg compare`: do two trees mean the same, and if not, what differs.
#include "csg/compare/compare.h"

#include <iostream>

#include "csg/app/commands.h"
#include "csg/app/evaluation.h"
#include "csg/app/exit_status.h"
#include "csg/app/progress_bar.h"
#include "csg/text/escape.h"
#include "csg/text/input_file.h"

namespace cnrg::app {
namespace {

struct Input {
  Tree tree;
  NodeId node;
};

/// `unknown`: parameters that it has not.
Input read_input(const std::string& path, const std::string& node, const char* option,
                 const CompareArguments& arguments, std::set<std::string>& unknown) {
  ReadOptions reading = arguments.reading;
  reading.unknown = &unknown;
  Input input{tree_of(path, reading, arguments.finer), {}};
  input.node = node_of(input.tree, node, option);
  return input;
}

}  // namespace

int run_compare(const CompareArguments& arguments) {
  if (arguments.a == kStandardInputWord && arguments.b == kStandardInputWord) {
    throw InputError(
        "cnrg: error: only one of A and B can be read from standard input; give a file for the other");
  }
  std::set<std::string> not_in_a, not_in_b;
  const Input a = read_input(arguments.a, arguments.node_a, "--node-a", arguments, not_in_a);
  const Input b = read_input(arguments.b, arguments.node_b, "--node-b", arguments, not_in_b);
  for (const std::string& name : not_in_a) {
    if (not_in_b.contains(name)) throw InputError("the parameter `" + name + "`: neither A nor B has it");
  }
  limit_threads(arguments.threads);
  CompareOptions options;
  options.threads = arguments.threads;
  for (const std::string& what : arguments.ignored) {
    if (what == "components") options.components = false;
    else if (what == "materials") options.materials = false;
    else if (what == "names") options.names = false;
    else if (what == "attributes") options.attributes = false;
    else options.features = false;
  }
  ProgressBar bar(arguments.quiet);
  options.watch.progress = bar.progress();
  const Comparison comparison = compare(a.tree, a.node, b.tree, b.node, options);
  bar.clear();
  const bool same = comparison.same();
  if (!arguments.quiet) {
    std::string text;
    for (const auto& [letter, input] : {std::pair("A", &a), std::pair("B", &b)}) {
      append_line(text, std::string(letter) + ": `" + shown(input->tree.nodes[input->node].name) + "` of " +
                            shown(input->tree.file));
    }
    std::cout << text << (same ? "the same\n" : "different\n") << comparison_text(comparison);
  }
  return same ? kDone : kDifferent;
}

}  // namespace cnrg::app
