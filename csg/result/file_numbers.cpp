#include "csg/result/file_numbers.h"

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
  for (Component i = 1; i <= view.value->component_count(); ++i) see(view.value->attributes(i).leaves);
  std::size_t next = 0;
  for (auto& [leaf, number] : numbers) number = next++;
  return numbers;
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
