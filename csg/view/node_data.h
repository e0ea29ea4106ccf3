// The data of one node on a page: cells, numbered as in files, and their attributes and stories.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "csg/operators/origins.h"
#include "csg/result/flat.h"
#include "csg/view/packed.h"
#include "csg/view/page.h"

namespace cnrg {

/// What nodes have in common, each thing once: points, origins, lines of stories, words.
struct PageTables {
  explicit PageTables(const Complex& complex) : complex(complex) {}
  const Complex& complex;
  std::map<VertexId, std::uint32_t> numbers;
  std::vector<VertexId> points;  ///< by number
  std::map<std::vector<LeafCell>, std::uint32_t> origins;
  std::map<std::string, std::uint32_t> lines, words, colors;

  std::uint32_t point(VertexId v) {
    const std::uint32_t number = number_in(numbers, v);
    if (number == points.size()) points.push_back(v);
    return number;
  }
};

/// The texts of a table by their numbers.
std::vector<std::string> in_order(const std::map<std::string, std::uint32_t>& table);

/// What telling all of a node costs, in the units of PageLimits.
struct PageCosts {
  std::size_t stories = 0, topology = 0, classes = 0;
};
PageCosts page_costs(const Evaluation& evaluation, const KeptValue& kept, InstanceId id);

/// What is told of a node besides its cells.
struct Told {
  bool stories = true, topology = true, classes = true;
};

/// Of a node that was asked for; `removed_left` is how much may still be told of what went, as PageLimits counts
/// it; `id` is the instance of its value.
nlohmann::ordered_json node_data(const Tree& tree, const Evaluation& evaluation, const KeptValue& kept,
                                 InstanceId id, const Told& told, std::size_t& removed_left, PageTables& tables);

}  // namespace cnrg
