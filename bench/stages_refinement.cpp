// Stages of refinement, and from there to the complex.
#include <algorithm>

#include "bench/stages.h"
#include "kernel/complex/draft.h"
#include "kernel/refine/box_pairs.h"
#include "kernel/refine/box_tree.h"
#include "kernel/refine/contacts.h"
#include "kernel/refine/keyed_points.h"
#include "kernel/refine/refine.h"
#include "kernel/refine/subdivision.h"

namespace cnrg::bench {
namespace {

RefineInput prepared(const std::string& name) {
  RefineReport report;
  return prepare_input(stage_soup(name), report);
}

void prepare(benchmark::State& state, const std::string& name) {
  const Soup& soup = stage_soup(name);
  for (auto _ : state) {
    RefineReport report;
    benchmark::DoNotOptimize(prepare_input(soup, report));
  }
  count_items(state, soup.face_count());
}

std::vector<Box> face_boxes(const Soup& soup) {
  std::vector<Box> boxes(soup.face_count());
  for (std::size_t f = 0; f < boxes.size(); ++f) {
    for (const PointId p : soup.corners(SourceId(f))) {
      if (!p.valid()) continue;
      const double* x = soup.xyz(p);
      boxes[f].extend({x[0], x[1], x[2]}, {x[0], x[1], x[2]});
    }
  }
  return boxes;
}

void build_box_tree(benchmark::State& state, const std::string& name) {
  const std::vector<Box> boxes = face_boxes(stage_soup(name));
  for (auto _ : state) benchmark::DoNotOptimize(BoxTree(boxes));
  count_items(state, boxes.size());
}

/// On one thread, the sorting included.
void pair_boxes(benchmark::State& state, const std::string& name) {
  const std::vector<Box> boxes = face_boxes(stage_soup(name));
  std::size_t found = 0;
  for (auto _ : state) {
    found = 0;
    const BoxPairs pairs(boxes);
    for (std::size_t part = 0; part < pairs.part_count(); ++part)
      pairs.find(part, [&](std::uint32_t, std::uint32_t) { ++found; });
    benchmark::DoNotOptimize(found);
  }
  count_items(state, found);
}

void contacts(benchmark::State& state, const std::string& name) {
  const RefineInput input = prepared(name);
  std::uint64_t candidates = 0;
  for (auto _ : state) candidates = find_contacts(input).candidates;
  count_items(state, candidates);
}

/// The points where faces meet, as refinement adds them.
std::size_t add_contact_points(RefineInput& input) {
  std::vector<PointKey> keys;
  const ContactList found = find_contacts(input);
  for (const ContactList::Trace& t : found.traces) keys.insert(keys.end(), {t.a, t.b});
  for (const ContactList::OnFace& p : found.on_face) keys.push_back(p.point);
  std::erase_if(keys, [](const PointKey& k) { return k.kind == PointKey::Kind::vertex; });
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  for (const PointKey& key : keys) input.points.add(definition_of(key, input));
  return keys.size();
}

void identity(benchmark::State& state, const std::string& name) {
  RefineInput input = prepared(name);
  const VertexId first(input.points.size());
  const std::size_t added = add_contact_points(input);
  for (auto _ : state) {
    UnionFind sets(input.points.size());
    unite_coincident(input.points, first, sets);
  }
  count_items(state, added);
}

void whole_refinement(benchmark::State& state, const std::string& name) {
  const Soup& soup = stage_soup(name);
  for (auto _ : state) {
    RefineReport report;
    benchmark::DoNotOptimize(refine(soup, report));
  }
  count_items(state, soup.face_count());
}

/// The segments of each sheet with more than three half-edges: those with all their edges on its faces.
std::vector<std::pair<SheetId, std::vector<SegmentId>>> cut_sheets(const Refinement& r) {
  std::vector<std::vector<EdgeId>> edges(r.sheet_plane.size());
  for (const FaceId f : IdRange<FaceId>(r.face_sheet.size())) {
    for (const LoopId loop : r.face_loops[f]) {
      for (const HalfEdge h : r.loops[loop]) edges[r.face_sheet[f].index()].push_back(h.edge());
    }
  }
  std::vector<std::pair<SheetId, std::vector<SegmentId>>> sheets;
  for (std::size_t s = 0; s < edges.size(); ++s) {
    std::vector<EdgeId>& own = edges[s];
    if (own.size() <= 3) continue;
    std::sort(own.begin(), own.end());
    own.erase(std::unique(own.begin(), own.end()), own.end());
    std::vector<SegmentId> segments;
    for (const EdgeId e : own) {
      const auto on = r.edges.segments[e];
      segments.insert(segments.end(), on.begin(), on.end());
    }
    std::sort(segments.begin(), segments.end());
    segments.erase(std::unique(segments.begin(), segments.end()), segments.end());
    std::erase_if(segments, [&](SegmentId segment) {
      const auto chain = r.edges.chain[segment];
      return !std::all_of(chain.begin(), chain.end(),
                          [&](EdgeId e) { return std::binary_search(own.begin(), own.end(), e); });
    });
    sheets.emplace_back(SheetId(s), std::move(segments));
  }
  return sheets;
}

/// Every sheet that is cut, on one thread.
void subdivide(benchmark::State& state, const std::string& name) {
  RefineReport report;
  const Refinement r = refine(stage_soup(name), report);
  const auto sheets = cut_sheets(r);
  Subdivider subdivider({r.input, r.segments, r.edges, r.segment_faces, r.sheet_of});
  for (auto _ : state) {
    for (const auto& [sheet, segments] : sheets) {
      benchmark::DoNotOptimize(subdivider.subdivide(
          {sheet, r.sheet_plane[sheet], r.sheet_projection[sheet], r.sheet_faces[sheet], segments, {}}));
    }
  }
  count_items(state, sheets.size());
}

void whole_complex(benchmark::State& state, const std::string& name) {
  const Soup& soup = stage_soup(name);
  for (auto _ : state) benchmark::DoNotOptimize(build_complex(soup));
  count_items(state, soup.face_count());
}

void labels(benchmark::State& state, const std::string& name) {
  const Soup& soup = stage_soup(name);
  ComplexDraft complex(soup);
  for (auto _ : state) complex.label(soup);
  count_items(state, complex->region_count);
}

}  // namespace

void add_refinement_stages() {
  add_stage("prepare_input", prepare);
  add_stage("box_tree", build_box_tree);
  add_stage("self_pairs", pair_boxes);
  add_stage("find_contacts", contacts);
  add_stage("unite_coincident", identity);
  add_stage("subdivide", subdivide);
  add_stage("refine", whole_refinement);
  add_stage("build_complex", whole_complex);
  add_stage("label_regions", labels);
}

}  // namespace cnrg::bench
