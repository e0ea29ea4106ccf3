#include "csg/result/sizes.h"

#include <algorithm>

#include "csg/operators/origins.h"

namespace cnrg {
namespace {

/// The shorter one of two lengths, of which 0 says nothing.
double shorter(double a, double b) { return a == 0 || b == 0 ? std::max(a, b) : std::min(a, b); }

double size_of(const ResultView& view, LeafId leaf) {
  return leaf.index() < view.leaves->size() ? (*view.leaves)[leaf.index()].size : 0;
}

/// In all of a region.
double size_in(const ResultView& view, const FlatComplex::Region& region, std::vector<LeafCell>& on) {
  double longest = 0;
  std::vector<LeafId> telling;
  for (const LeafId leaf : region.origin.leaves) {
    if (size_of(view, leaf) > 0) telling.push_back(leaf);
  }
  if (telling.empty()) return 0;
  for (const RegionId cell : region.cells) {
    on.clear();
    append_leaf_cells(*view.complex, cell, telling, on);
    double here = 0;
    for (const LeafCell& in : on) here = shorter(here, in.dimension == 3 ? size_of(view, in.leaf) : 0);
    if (here == 0) return 0;
    longest = std::max(longest, here);
  }
  return longest;
}

}  // namespace

double size_of(const ResultView& view, const FlatComplex::Provenance& origin) {
  double size = 0;
  for (const LeafId leaf : origin.leaves) size = shorter(size, size_of(view, leaf));
  return size;
}

std::vector<double> region_sizes(const ResultView& view, const FlatComplex& flat) {
  std::vector<double> sizes(flat.regions.size(), 0);
  std::vector<LeafCell> on;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const FlatComplex::Region& region = flat.regions[i];
    if (region.component == 0) continue;
    if (view.region_sizes == nullptr) {
      sizes[i] = size_in(view, region, on);
    } else if (!view.region_sizes->empty()) {
      for (const RegionId cell : region.cells) sizes[i] = std::max(sizes[i], (*view.region_sizes)[cell.index()]);
    }
  }
  if (std::all_of(sizes.begin(), sizes.end(), [](double size) { return size == 0; })) sizes.clear();
  return sizes;
}

}  // namespace cnrg
