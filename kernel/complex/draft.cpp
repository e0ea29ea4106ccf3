// Refinement and building, with the number of threads set and the calls of predicates counted around both.
#include "kernel/complex/draft.h"

#include <tbb/global_control.h>

#include <optional>

#include "kernel/complex/builder.h"
#include "kernel/exact/predicates.h"

namespace cnrg {

ComplexDraft::ComplexDraft(const Soup& soup, const RefineOptions& options, RefineReport* report) {
  RefineReport local;
  RefineReport& out = report != nullptr ? *report : local;
  std::optional<tbb::global_control> limit;
  if (options.threads > 0) {
    limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(options.threads));
  }
  const StageCounts before = stage_counts();
  complex_ = ComplexBuilder(soup, refine(soup, out, options.watch), options.watch).build();
  const StageCounts after = stage_counts();
  out.stages = {after.filter - before.filter, after.interval - before.interval, after.exact - before.exact};
  const Complex& complex = *complex_;
  for (const VertexId v : complex.vertices) out.constructed += complex.points.is_constructed(v) ? 1 : 0;
}

void ComplexDraft::set_sources(ComplexSources sources) {
  Complex& c = *complex_;
  c.face_cover = std::move(sources.face_cover);
  c.covers = std::move(sources.covers);
  c.sources = std::move(sources.sources);
  c.edge_segments = std::move(sources.edge_segments);
  c.segment_ends = std::move(sources.segment_ends);
  c.segment_faces = std::move(sources.segment_faces);
  c.segment_wires = std::move(sources.segment_wires);
  c.wires = std::move(sources.wires);
  c.isolated_leaves = std::move(sources.isolated_leaves);
  c.leaf_count = sources.leaf_count;
  c.fills.assign(c.leaf_count, Fill::none);
  c.leaf_regions.assign(c.leaf_count, 0);
  number_surfaces(c);
}

void ComplexDraft::label(const Soup& soup) {
  complex_->region_labels = {};
  complex_->label_sets = {};
  complex_->leaf_regions = {};
  label_regions(soup, *complex_);
}

std::shared_ptr<const Complex> build_complex(const Soup& soup, const RefineOptions& options,
                                             RefineReport* report) {
  return ComplexDraft(soup, options, report).finish();
}

}  // namespace cnrg
