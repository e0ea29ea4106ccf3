#include "csg/result/file_numbers.h"

#include <algorithm>

namespace cnrg {

std::map<LeafId, std::size_t> leaf_numbers(const ResultView& view, const FlatComplex& flat) {
  std::map<LeafId, std::size_t> numbers;
  const auto see = [&](std::span<const LeafId> leaves) {
    for (const LeafId leaf : leaves) numbers.try_emplace(leaf, 0);
  };
  const auto see_all = [&](const auto& cells) {
    for (const auto& cell : cells) see(cell.origin.leaves);
  };
  see_all(flat.vertices), see_all(flat.edges), see_all(flat.faces), see_all(flat.regions);
  for (const FlatComplex::Face& face : flat.faces) {
    if (!face.cells.empty()) see({&face.patch->first, 1});  // its parameters name it
  }
  for (Component i = 1; i <= view.value->component_count(); ++i) see(view.value->attributes(i).leaves);
  std::vector<LeafId> order;
  for (const auto& [leaf, number] : numbers) order.push_back(leaf);
  std::sort(order.begin(), order.end(), [&](LeafId a, LeafId b) { return view.place(a) < view.place(b); });
  for (std::size_t i = 0; i < order.size(); ++i) numbers[order[i]] = i;
  return numbers;
}

std::vector<LeafId> in_order(const std::map<LeafId, std::size_t>& numbers) {
  std::vector<LeafId> leaves(numbers.size());
  for (const auto& [leaf, number] : numbers) leaves[number] = leaf;
  return leaves;
}

std::vector<std::size_t> numbers_of(const std::vector<LeafId>& leaves,
                                    const std::map<LeafId, std::size_t>& numbers) {
  std::vector<std::size_t> out;
  out.reserve(leaves.size());
  for (const LeafId leaf : leaves) out.push_back(numbers.at(leaf));
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<LeafId> in_order_of_place(const std::vector<LeafInfo>& leaves) {
  std::vector<LeafId> out;
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    if (leaves[i].place != LeafInfo::kNoPlace) out.emplace_back(i);
  }
  std::sort(out.begin(), out.end(),
            [&](LeafId a, LeafId b) { return leaves[a.index()].place < leaves[b.index()].place; });
  return out;
}

std::vector<std::string> leaf_names(const std::vector<LeafInfo>& leaves) {
  std::vector<std::string> out;
  for (const LeafId leaf : in_order_of_place(leaves)) out.push_back(leaves[leaf.index()].name);
  return out;
}

std::string leaf_name(const ResultView& view, LeafId leaf) {
  const bool named = view.leaves != nullptr && leaf.index() < view.leaves->size();
  return named ? (*view.leaves)[leaf.index()].name : std::string();
}

std::vector<std::size_t> patch_numbers(const FlatComplex& flat) {
  std::map<FlatComplex::Patch, std::size_t> known;
  std::vector<std::size_t> numbers;
  std::size_t next = 0;
  for (const FlatComplex::Face& face : flat.faces) {
    if (!face.patch) {
      numbers.push_back(next++);
      continue;
    }
    const auto [it, fresh] = known.try_emplace(*face.patch, next);
    next += fresh;
    numbers.push_back(it->second);
  }
  return numbers;
}

}  // namespace cnrg
