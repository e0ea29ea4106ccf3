// Which curved surface each soup face lies on: the given numbers, and for patches that have none new ones.
//
// That a patch is curved shows in its facets: they lie in more than one sheet.
#include <algorithm>
#include <utility>
#include <vector>

#include "kernel/base/sorted.h"
#include "kernel/complex/builder.h"

namespace cnrg {
namespace {

using Patch = std::pair<LeafId, std::uint32_t>;

/// Those without a number whose facets lie in several sheets, ascending. Facets of one patch mostly come one after
/// the other, so one of each run is listed.
std::vector<Patch> curved_patches(const Complex& c) {
  IdVector<SourceId, SheetId> sheet_of(c.sources.size());
  for (const FaceId f : IdRange<FaceId>(c.face_count())) {
    for (const Cover& cover : c.cover(f)) sheet_of[cover.source] = c.face_sheet[f];
  }
  std::vector<Patch> curved;
  std::vector<std::pair<Patch, SheetId>> runs;
  for (const SourceId s : IdRange<SourceId>(c.sources.size())) {
    const Soup::Face& face = c.sources[s];
    if (face.surface != 0 || !sheet_of[s].valid()) continue;
    const Patch patch(face.leaf, face.patch);
    if (runs.empty() || runs.back().first != patch) runs.emplace_back(patch, sheet_of[s]);
    else if (runs.back().second != sheet_of[s] && (curved.empty() || curved.back() != patch))
      curved.push_back(patch);
  }
  if (!std::is_sorted(runs.begin(), runs.end())) std::sort(runs.begin(), runs.end());
  for (std::size_t i = 1; i < runs.size(); ++i) {
    if (runs[i].first == runs[i - 1].first && runs[i].second != runs[i - 1].second)
      curved.push_back(runs[i].first);
  }
  sort_unique(curved);
  return curved;
}

}  // namespace

void number_surfaces(Complex& c) {
  c.surface_count = 0;
  for (const Soup::Face& face : c.sources) c.surface_count = std::max(c.surface_count, face.surface);
  for (const RemovedFacet& facet : c.removed_facets)
    c.surface_count = std::max(c.surface_count, facet.source.surface);
  const std::vector<Patch> curved = curved_patches(c);
  if (curved.empty()) return;
  check_count(c.surface_count + std::uint64_t{curved.size()}, "curved surfaces", kMostPlaces);
  for (Soup::Face& face : c.sources) {
    const Patch patch(face.leaf, face.patch);
    const auto at = std::lower_bound(curved.begin(), curved.end(), patch);
    if (face.surface != 0 || at == curved.end() || *at != patch) continue;
    face.surface = c.surface_count + 1 + static_cast<std::uint32_t>(at - curved.begin());
  }
  c.surface_count += static_cast<std::uint32_t>(curved.size());
}

}  // namespace cnrg
