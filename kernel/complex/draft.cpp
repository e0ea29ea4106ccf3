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
  Refinement refinement = refine(soup, out, options.watch);
  if (options.vertices) out.vertex_of = refinement.input.vertex_of;
  complex_ = ComplexBuilder(soup, std::move(refinement), options.watch).build();
  const StageCounts after = stage_counts();
  out.stages = {after.filter - before.filter, after.interval - before.interval, after.exact - before.exact};
  const Complex& complex = *complex_;
  for (const VertexId v : complex.vertices) out.constructed += complex.points.is_constructed(v) ? 1 : 0;
}

namespace {

template <class IdT, class T>
SparseLists<IdT, T> lists_of(std::vector<std::pair<IdT, T>> pairs) {
  sort_unique(pairs);
  return SparseLists(pairs);
}

template <class IdT>
void add(SparseLists<IdT, LeafCell>& lists, std::vector<std::pair<IdT, LeafCell>> more) {
  if (more.empty()) return;
  lists.for_each([&](IdT id, const LeafCell& cell) { more.emplace_back(id, cell); });
  lists = lists_of(std::move(more));
}

}  // namespace

void ComplexDraft::set_sources(ComplexSources sources) {
  Complex& c = *complex_;
  c.face_cover = std::move(sources.face_cover);
  c.covers = std::move(sources.covers);
  c.sources = std::move(sources.sources);
  c.edge_segments = std::move(sources.edge_segments);
  c.segment_ends = std::move(sources.segment_ends);
  c.segment_faces = std::move(sources.segment_faces);
  c.segment_wires = lists_of(std::move(sources.segment_wires));
  c.wires = std::move(sources.wires);
  c.isolated_leaves = lists_of(std::move(sources.isolated_leaves));
  c.curve_ends = lists_of(std::move(sources.curve_ends));
  c.leaf_count = sources.leaf_count;
  c.fills = std::move(sources.fills);
  c.fills.resize(c.leaf_count);
  c.leaf_regions = std::move(sources.leaf_regions);
  c.leaf_regions.resize(c.leaf_count);
  if (!sources.region_labels.empty()) {
    c.region_labels = std::move(sources.region_labels);
    c.label_sets = std::move(sources.label_sets);
  }
  c.face_leaf_cells = {}, c.edge_leaf_cells = {}, c.vertex_leaf_cells = {};
  hold(std::move(sources.held));
  c.removed_facets = std::move(sources.removed_facets);
  c.edge_removed_facets = lists_of(std::move(sources.edge_removed_facets));
  number_surfaces(c);
}

void ComplexDraft::hold(HeldCells held) {
  add(complex_->face_leaf_cells, std::move(held.faces));
  add(complex_->edge_leaf_cells, std::move(held.edges));
  add(complex_->vertex_leaf_cells, std::move(held.vertices));
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
