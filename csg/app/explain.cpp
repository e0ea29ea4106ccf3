// `cnrg explain`: the life of a cell, or of what holds a point.
#include "csg/explain/explain.h"

#include <iostream>

#include "csg/app/commands.h"
#include "csg/app/evaluation.h"
#include "csg/app/exit_status.h"
#include "csg/text/escape.h"
#include "csg/text/number.h"

namespace cnrg::app {
namespace {

RationalPoint parse_point(const std::string& text) {
  RationalPoint point;
  std::size_t begin = 0, k = 0;
  for (; k < 3 && begin <= text.size(); ++k) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    NumberText number = read_number(word);
    if (!number.value) throw InputError("--point: `" + excerpt(word) + "`" + number.fault + "; write x,y,z");
    point[k] = std::move(*number.value);
    begin = end + 1;
  }
  if (k < 3 || begin <= text.size()) {
    throw InputError("--point: `" + text + "` has not three numbers; write x,y,z, such as 1/3,0.5,2");
  }
  return point;
}

}  // namespace

int run_explain(const ExplainArguments& arguments) {
  if (arguments.cell.empty() == arguments.point.empty()) {
    throw InputError("give one of --cell and --point: a cell of the node, such as --cell f12, or --point x,y,z");
  }
  RationalPoint point;
  if (!arguments.point.empty()) point = parse_point(arguments.point);
  const Tree tree = tree_of(arguments);
  const NodeId node = node_of(tree, arguments.node);
  EvaluateOptions options;
  options.threads = arguments.threads;
  options.rows = Rows::none;
  options.keep_all = true;
  options.result = node;
  if (!arguments.point.empty()) options.reach = {point};
  const Evaluation evaluation = evaluate_in_view(tree, options, false);
  const Explanation explanation = arguments.point.empty() ? explain(tree, evaluation, node, arguments.cell)
                                                          : explain(tree, evaluation, node, point);
  std::cout << explanation_text(tree, evaluation, explanation);
  return kDone;
}

}  // namespace cnrg::app
