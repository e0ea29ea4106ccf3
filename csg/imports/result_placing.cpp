// Each kind of cell in turn: vertices that the file does not have, then edges, facets, and the regions on their
// sides. Where several cells are cut the first one of the file is told.
#include "csg/imports/result_placing.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "kernel/base/sorted.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg::result {
namespace {

std::string between(const Step& step) {
  return "points " + std::to_string(step.first) + " and " + std::to_string(step.second);
}

}  // namespace

std::string words(const char* kind, Index number) { return std::string(kind) + " " + std::to_string(number); }
std::string words(const std::vector<Index>& list) {
  std::string text = "[";
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (i == 12) return text + ", ...]";
    text += (i == 0 ? "" : ", ") + std::to_string(list[i]);
  }
  return text + "]";
}
std::string words(const std::vector<Loop>& loops) {
  std::string text = "[";
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (i == 4) return text + ", ...]";
    text += (i == 0 ? "" : ", ") + words(loops[i]);
  }
  return text + "]";
}

/// A contradiction at a cell: edges come before faces.
struct PlacedCells::Fault {
  int dimension = 3;
  Index number = kNone;
  std::string what;
  friend bool operator<(const Fault& a, const Fault& b) {
    return std::tie(a.dimension, a.number) < std::tie(b.dimension, b.number);
  }
  void note(Fault other) {
    if (other < *this) *this = std::move(other);
  }
};

PlacedCells::PlacedCells(const Cursor& root_, const Content& content_, const Complex& complex_)
    : root(root_),
      content(content_),
      table(content_.table),
      complex(complex_),
      edge_of(complex_.edge_count(), kNone),
      facet_of(complex_.face_count(), kNone),
      cell_of(content_.facets.size()),
      region_of(complex_.region_count, kNone),
      place_of(content_.regions.size()),
      segments_at(content_.table.points.size(), 0) {
  require_no_crossing();
  place_edges();
  place_facets();
  place_regions();
}

void PlacedCells::tell(const Fault& first) const {
  if (first.number == kNone) return;
  (first.dimension == 1 ? edge_at(first.number) : face_at(first.number)).refuse(first.what);
}

Index PlacedCells::component(RegionId r) const {
  return region_of[r] == kNone ? 0 : content.regions[region_of[r]].component;
}
Index PlacedCells::component(EdgeId e) const {
  return edge_of[e] != kNone ? table.edges[edge_of[e]].component : component(complex.edge_uses[e][0].face);
}

/// A vertex that is none of the file is inside of an edge or of a face that is not flat.
Index PlacedCells::component(VertexId v) const {
  const auto stated = table.vertices.find(point(v));
  if (stated != table.vertices.end()) return stated->second.component;
  const auto edges = complex.vertex_edges[v];
  const auto chain = std::find_if(edges.begin(), edges.end(), [&](EdgeId e) { return edge_of[e] != kNone; });
  return component(chain == edges.end() ? edges.front() : *chain);
}

/// The edges of the file that have an edge of the complex on one of their steps.
void PlacedCells::edges_on(EdgeId e, std::vector<Index>& out) const {
  for (const SegmentId s : complex.edge_segments[e]) {
    const auto& [a, b] = complex.segment_ends[s];
    const auto found = table.segments.find(std::minmax(point(a), point(b)));
    if (found != table.segments.end()) out.push_back(found->second);
  }
}
void PlacedCells::faces_on(FaceId f, std::vector<Index>& out) const {
  for (const Cover& cover : complex.cover(f)) out.push_back(complex.sources[cover.source].leaf_face);
}

/// Every vertex is a point of the file.
void PlacedCells::require_no_crossing() const {
  Fault first;
  std::vector<FaceId> star;
  for (const VertexId v : complex.vertices) {
    if (v.index() < table.points.size()) continue;
    std::vector<Index> edges, faces;
    for (const EdgeId e : complex.vertex_edges[v]) edges_on(e, edges);
    complex.star_faces(v, star);
    for (const FaceId f : star) faces_on(f, faces);
    sort_unique(edges), sort_unique(faces);
    const std::string meets = "in " + describe(complex.points.rational(v)) + ", where the file has no point";
    if (edges.size() > 1) {
      first.note({1, edges[0], "this edge meets " + words("edge", edges[1]) + " " + meets});
    } else if (edges.size() == 1) {
      const auto through =
          std::find_if(faces.begin(), faces.end(), [&](Index f) { return !walks_along(f, edges[0]); });
      const Index face = through == faces.end() ? faces.at(0) : *through;
      first.note({1, edges[0], "this edge meets " + words("face", face) + " " + meets});
    } else {
      const std::string other = faces.size() > 1 ? words("face", faces[1]) : "itself";
      first.note({2, faces.at(0), "this face meets " + other + " " + meets});
    }
  }
  tell(first);
}

bool PlacedCells::walks_along(Index face, Index edge) const {
  bool found = false;
  for_each_step(content.walks(content.faces[face]), [&](const Step& step) {
    found = found || table.segments.at(std::minmax(step.first, step.second)) == edge;
  });
  return found;
}

/// Every edge is a step of an edge of the file or a side between facets of one face, and every step is there.
void PlacedCells::place_edges() {
  Fault first;
  std::map<Step, char> missing;
  std::size_t steps = 0;
  for (const EdgeId e : IdRange<EdgeId>(complex.edge_count())) {
    const Index a = point(complex.edge_ends[e][0]), b = point(complex.edge_ends[e][1]);
    const auto found = table.segments.find(std::minmax(a, b));
    if (found != table.segments.end()) {
      edge_of[e] = found->second;
      ++segments_at[a], ++segments_at[b];
      ++steps;
    } else {
      place_inner_side(e, a, b, first);
    }
  }
  tell(first);
  if (steps == table.segments.size()) return;
  std::map<Step, char> there;
  for (const auto& [v, w] : complex.edge_ends) there[std::minmax(point(v), point(w))] = 1;
  for (const auto& [step, edge] : table.segments) {
    if (!there.contains(step)) first.note({1, edge, "this edge lies on others between " + between(step)});
  }
  tell(first);
}

void PlacedCells::place_inner_side(EdgeId e, Index a, Index b, Fault& first) const {
  std::vector<Index> edges, faces;
  edges_on(e, edges);
  for (const FaceUse& use : complex.edge_uses[e]) faces_on(use.face, faces);
  sort_unique(edges), sort_unique(faces);
  if (!edges.empty()) {
    const auto& p = content.edges[edges[0]].points;
    const Index inside = std::find(p.begin(), p.end(), a) == p.end() ? a : b;
    first.note({1, edges[0], words("point", inside) + " lies on this edge and is none of its points"});
    return;
  }
  const auto ends = std::array{vertex(std::min(a, b)), vertex(std::max(a, b))};
  const auto is_whole = [&](SegmentId s) {
    const auto& [v, w] = complex.segment_ends[s];
    return std::minmax(v, w) == std::minmax(ends[0], ends[1]) && !complex.segment_faces[s].empty();
  };
  const auto segments = complex.edge_segments[e];
  const bool side = std::any_of(segments.begin(), segments.end(), is_whole);
  if (side && faces.size() == 1 && complex.edge_uses[e].size() == 2) return;
  const std::string at = "between " + between({a, b});
  if (faces.size() > 1) {
    first.note(
        {2, faces[0], "this face meets " + words("face", faces[1]) + " " + at + ", where the file has no edge"});
  } else {
    first.note({2, faces.at(0), "the facets of this face do not meet side by side " + at});
  }
}

/// Every facet is one face.
void PlacedCells::place_facets() {
  Fault first;
  for (const FaceId f : IdRange<FaceId>(complex.face_count())) {
    std::vector<Index> faces;
    faces_on(f, faces);
    if (faces.size() > 1) {
      sort_unique(faces);
      first.note({2, faces[0],
                  faces.size() == 1 ? "facets of this face lie on each other"
                                    : "this face and " + words("face", faces[1]) + " lie on each other"});
      continue;
    }
    const Index facet = complex.cover(f)[0].source.value();
    facet_of[f] = facet;
    if (cell_of[facet].valid()) first.note({2, faces[0], "this face falls into several pieces"});
    cell_of[facet] = f;
  }
  for (const Facet& facet : content.facets) {
    const bool there = cell_of[std::size_t(&facet - content.facets.data())].valid();
    if (!there) first.note({2, facet.face, "a face without area"});
  }
  tell(first);
}

/// Sides of faces that look into one region of the complex name one region of the file, and no other does.
void PlacedCells::place_regions() {
  if (content.faces.empty() && !place_of.empty()) {  // all of space is one region
    region_of[RegionId(0)] = 0;
    place_of[0] = RegionId(0);
  }
  std::vector<Index> first_face(complex.region_count, kNone);
  for (const Facet& facet : content.facets) {
    const FaceId f = cell_of[std::size_t(&facet - content.facets.data())];
    for (unsigned side = 0; side < 2; ++side) {
      const RegionId r = complex.region(half_face(f, side));
      const Index stated = content.faces[facet.face].regions[side];
      const auto here = [&] { return face_at(facet.face).member("regions").at(side); };
      if (region_of[r] == kNone && !place_of[stated].valid()) {
        region_of[r] = stated;
        place_of[stated] = r;
        first_face[r.index()] = facet.face;
      } else if (region_of[r] == kNone) {
        here().refuse("this side does not look into the region that " +
                      words("face", first_face[place_of[stated].index()]) + " names " + std::to_string(stated) +
                      ", too");
      } else if (region_of[r] != stated) {
        here().refuse("this side looks into the region that " + words("face", first_face[r.index()]) + " names " +
                      std::to_string(region_of[r]));
      }
    }
  }
}

}  // namespace cnrg::result
