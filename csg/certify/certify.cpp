// Proofs of drawings, and uncertain places in words.
#include "csg/certify/certify.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "csg/certify/proof.h"
#include "csg/evaluate/diagnostics.h"
#include "csg/evaluate/drawings.h"
#include "csg/evaluate/leaf_numbers.h"
#include "csg/leaves/surface_parameters.h"
#include "kernel/base/union_find.h"

namespace cnrg {
namespace {

std::string decimals(double x) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", x);
  return buffer;
}
std::string coordinates(const std::array<double, 3>& p) {
  std::string text;
  for (const double x : p) text += (text.empty() ? "" : ", ") + decimals(std::abs(x) < 1e-9 ? 0.0 : x);
  return "[" + text + "]";
}

using Patches = std::vector<std::pair<LeafId, std::uint32_t>>;

Patches patches_of(const std::vector<Piece>& pieces, const OpenPlace& open) {
  Patches result;
  for (const std::uint32_t i : open.pieces) result.emplace_back(pieces[i].leaf, pieces[i].patch);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/// Open places of the same patches whose pieces meet are one.
std::vector<UncertainPlace> places_of(const Evaluation& evaluation, const std::vector<Piece>& pieces,
                                      const std::vector<OpenPlace>& open) {
  std::map<Patches, std::vector<const OpenPlace*>> by_patches;
  for (const OpenPlace& one : open) by_patches[patches_of(pieces, one)].push_back(&one);
  std::vector<UncertainPlace> result;
  for (const auto& [patches, ones] : by_patches) {
    UnionFind sets(ones.size());
    std::vector<Box> boxes;
    for (const OpenPlace* one : ones) boxes.push_back(pieces[one->pieces[0]].box);
    for (std::uint32_t i = 0; i < ones.size(); ++i) {
      for (std::uint32_t j = 0; j < i; ++j) {
        if (boxes[i].meets(boxes[j])) sets.unite(i, j);
      }
    }
    std::map<std::uint32_t, std::vector<const OpenPlace*>> parts;
    for (std::uint32_t i = 0; i < ones.size(); ++i) parts[sets.find(i)].push_back(ones[i]);
    for (const auto& [root, part] : parts) {
      UncertainPlace place;
      for (const auto& [leaf, patch] : patches) {
        const std::string name = evaluation.parameters->patch_name(leaf, patch);
        place.names.push_back("`" + evaluation.leaf_names[leaf.index()] + "`" +
                              (name.empty() ? "" : " (" + name + ")"));
        place.nodes.push_back(evaluation.leaves->node_of(leaf));
      }
      // What finer facets do not tell comes first.
      const auto last = std::ranges::find_if(part, [](const OpenPlace* one) { return !one->by_facets; });
      const OpenPlace& told = last == part.end() ? *part.front() : **last;
      place.at = told.at;
      place.size = told.size;
      place.by_facets = told.by_facets;
      result.push_back(std::move(place));
    }
  }
  return result;
}

void add(Certificate& all, const Evaluation& evaluation) {
  if (!evaluation.placed) return;
  Pieces pieces(*evaluation.placed, evaluation.reach);
  if (pieces.curved() == 0) return;
  std::vector<std::vector<char>> below;
  for (const KeptValue& kept : evaluation.kept) {
    below.emplace_back(evaluation.placed->instances.size());
    for (const LeafId leaf : kept.leaves) below.back()[leaf.index()] = 1;
  }
  const Proof proof = prove(pieces, [&](LeafId a, LeafId b) {
    return std::ranges::any_of(below, [&](const auto& in) { return in[a.index()] && in[b.index()]; });
  });
  all.asked += proof.asked;
  all.apart += proof.apart;
  all.crossing += proof.crossing;
  all.contacts += proof.contacts;
  for (UncertainPlace& place : places_of(evaluation, pieces.all(), proof.open)) all.places.push_back(std::move(place));
}

}  // namespace

Certificate certify(const Evaluation& evaluation) {
  Certificate result;
  add(result, evaluation);
  for (const Evaluation& other : evaluation.others) add(result, other);
  return result;
}

std::vector<Diagnostic> Certificate::notices(const Tree& tree, std::size_t most) const {
  std::vector<Diagnostic> result;
  for (std::size_t i = 0; i < std::min(most, places.size()); ++i) {
    const UncertainPlace& place = places[i];
    std::string text;
    for (std::size_t k = 0; k < place.names.size(); ++k)
      text += (k == 0 ? "" : k + 1 == place.names.size() ? " and " : ", ") + place.names[k];
    text += " near " + coordinates(place.at) + ": ";
    text += place.by_facets ? "these facets do not tell how they meet"
                            : "they touch, or nothing within " + decimals(place.size) + " of it tells how they meet";
    result.push_back({tree.file, tree.nodes[place.nodes[0]].operator_at, Diagnostic::Level::notice, text});
  }
  return result;
}

}  // namespace cnrg
