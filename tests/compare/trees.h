// Trees as texts, compared.
#pragma once

#include <string>

#include "csg/compare/compare.h"

namespace cnrg::test {

inline const char* const kMaterials = "cnrg: 1\nmaterials: {rock: {}, clay: {}}\n";

/// Nodes, one a line, of which the last one is the result, as a tree.
inline Tree tree(const std::string& nodes) {
  std::string text = kMaterials, last;
  text += "nodes:\n";
  for (std::size_t begin = 0; begin < nodes.size();) {
    const std::size_t end = std::min(nodes.find('\n', begin), nodes.size());
    const std::string line = nodes.substr(begin, end - begin);
    text += "  " + line + "\n";
    last = line.substr(0, line.find(':'));
    begin = end + 1;
  }
  return parse_tree(text + "result: " + last + "\n", "test.yaml");
}

inline Comparison compared(const std::string& a, const std::string& b, const CompareOptions& options = {}) {
  const Tree tree_a = tree(a), tree_b = tree(b);
  return compare(tree_a, tree_a.result, tree_b, tree_b.result, options);
}

/// What is printed, with `/` between the lines.
inline std::string text(const std::string& a, const std::string& b, const CompareOptions& options = {}) {
  std::string lines = comparison_text(compared(a, b, options));
  if (!lines.empty()) lines.pop_back();
  for (char& c : lines) c = c == '\n' ? '/' : c;
  return lines;
}

}  // namespace cnrg::test
