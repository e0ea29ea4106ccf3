#include "csg/result/sizes.h"

#include <algorithm>

#include "csg/operators/origins.h"
#include "kernel/base/sorted.h"

namespace cnrg {
namespace {

/// The shorter one of two lengths, of which 0 says nothing.
double shorter(double a, double b) { return a == 0 || b == 0 ? std::max(a, b) : std::min(a, b); }

double size_of_leaf(const ResultView& view, LeafId leaf) {
  return leaf.index() < view.leaves->size() ? (*view.leaves)[leaf.index()].size : 0;
}

/// Each part of one list with each part of the other.
LeafParts together(const LeafParts& a, const LeafParts& b) {
  LeafParts all;
  for (const std::vector<LeafId>& x : a) {
    for (const std::vector<LeafId>& y : b) {
      std::vector<LeafId>& both = all.emplace_back(x);
      both.insert(both.end(), y.begin(), y.end());
      sort_unique(both);
    }
  }
  return all;
}

std::vector<LeafId> joined_leaves(const ResultView& view) {
  std::vector<LeafId> joined;
  for (LeafId::Value i = 0; i < view.leaves->size(); ++i) {
    if ((*view.leaves)[i].makers > 0) joined.emplace_back(i);
  }
  return joined;
}

/// Where a joined leaf holds a 3-cell, one or another part of its region lies.
LeafParts parts_in(const ResultView& view, const FlatComplex::Region& region, const std::vector<LeafId>& joined,
                   std::vector<LeafCell>& on) {
  const auto& leaves = region.origin.leaves;
  std::vector<LeafId> telling;
  for (const LeafId leaf : leaves) {
    if (leaf.index() < view.leaves->size() && (*view.leaves)[leaf.index()].may_say_size()) telling.push_back(leaf);
  }
  LeafParts all;
  if (telling.empty()) return all;
  telling.insert(telling.end(), joined.begin(), joined.end());
  sort_unique(telling);
  for (const RegionId cell : region.cells) {
    on.clear();
    append_leaf_cells(*view.complex, cell, telling, on);
    LeafParts here(1);
    for (const LeafCell& in : on) {
      const LeafInfo& leaf = (*view.leaves)[in.leaf.index()];
      if (leaf.makers == 0) {
        here = together(here, {{in.leaf}});
      } else if (const LeafParts& parts = leaf.regions->at(in.number); !parts.empty()) {
        here = together(here, parts);
      }
    }
    if (here.front().empty()) return {};
    all.insert(all.end(), here.begin(), here.end());
  }
  sort_unique(all);
  return all;
}

/// In all of a region.
double size_in(const ResultView& view, const LeafParts& parts) {
  double longest = 0;
  for (const std::vector<LeafId>& part : parts) {
    double here = 0;
    for (const LeafId leaf : part) here = shorter(here, size_of_leaf(view, leaf));
    if (here == 0) return 0;
    longest = std::max(longest, here);
  }
  return longest;
}

}  // namespace

double size_of(const ResultView& view, const FlatComplex::Provenance& origin) {
  double size = 0;
  for (const LeafId leaf : origin.leaves) size = shorter(size, size_of_leaf(view, leaf));
  return size;
}

std::vector<LeafParts> region_parts(const ResultView& view, const FlatComplex& flat) {
  std::vector<LeafParts> parts(flat.regions.size());
  const std::vector<LeafId> joined = joined_leaves(view);
  std::vector<LeafCell> on;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const FlatComplex::Region& region = flat.regions[i];
    if (region.component == 0) continue;
    if (view.region_parts == nullptr) {
      parts[i] = parts_in(view, region, joined, on);
    } else if (!view.region_parts->empty()) {
      for (const RegionId cell : region.cells) {
        const LeafParts& of_cell = (*view.region_parts)[cell.index()];
        parts[i].insert(parts[i].end(), of_cell.begin(), of_cell.end());
      }
      sort_unique(parts[i]);
    }
  }
  if (std::all_of(parts.begin(), parts.end(), [](const LeafParts& of) { return of.empty(); })) parts.clear();
  return parts;
}

std::vector<double> region_sizes(const ResultView& view, const FlatComplex& flat) {
  std::vector<double> sizes;
  for (const LeafParts& parts : region_parts(view, flat)) sizes.push_back(size_in(view, parts));
  if (std::all_of(sizes.begin(), sizes.end(), [](double size) { return size == 0; })) sizes.clear();
  return sizes;
}

}  // namespace cnrg
