#include "tests/families/model_checks.h"

#include <algorithm>
#include <map>
#include <set>

#include "bench/cases/soup_of.h"
#include "kernel/selection/measure.h"

namespace cnrg::bench {
namespace {

RationalPoint difference(const RationalPoint& p, const RationalPoint& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}
RationalPoint cross(const RationalPoint& a, const RationalPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Rational dot(const RationalPoint& a, const RationalPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Twice the area, along the normal.
RationalPoint area_of(const Model& model, const std::vector<std::uint32_t>& loop) {
  RationalPoint sum{0, 0, 0};
  const RationalPoint& origin = model.points[loop[0]];
  for (std::size_t k = 2; k < loop.size(); ++k) {
    const RationalPoint part =
        cross(difference(model.points[loop[k - 1]], origin), difference(model.points[loop[k]], origin));
    for (int i = 0; i < 3; ++i) sum[i] += part[i];
  }
  return sum;
}

std::string loop_fault(const Model& model, const std::vector<std::uint32_t>& loop) {
  if (loop.size() < 3) return "a face has less than three corners";
  if (std::set(loop.begin(), loop.end()).size() != loop.size()) return "a face has a corner twice";
  const RationalPoint area = area_of(model, loop);
  if (dot(area, area) == 0) return "a face has no area";
  for (const std::uint32_t p : loop)
    if (dot(area, difference(model.points[p], model.points[loop[0]])) != 0) return "a face is not planar";
  return {};
}

std::string solid_fault(const Model& model) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  for (const Model::Face& face : model.faces) {
    const auto& loop = face.loops[0];
    for (std::size_t k = 0; k < loop.size(); ++k) ++sides[{loop[k], loop[(k + 1) % loop.size()]}];
  }
  for (const auto& [side, count] : sides)
    if (count != 1 || !sides.contains({side.second, side.first})) return "a side has not its opposite once";
  const Rational expected = volume_of(model);
  if (expected <= 0) return "the volume is not positive";
  Soup soup;
  add_model(soup, model);
  const auto built_complex = build_complex(soup, {.threads = 1});
  const Complex& complex = *built_complex;
  if (complex.region_count != 2) return "the faces cut space into " + std::to_string(complex.region_count);
  if (volume(complex, RegionId(1)) != expected) return "the faces cross each other";
  return {};
}

bool covers(const Complex& complex, FaceId f, LeafId leaf) {
  const auto cover = complex.cover(f);
  return std::any_of(cover.begin(), cover.end(),
                     [&](const Cover& c) { return complex.sources[c.source].leaf == leaf; });
}

/// An edge of a model lies on the edge.
bool on_edge(const Complex& complex, EdgeId e, LeafId leaf) {
  for (const SegmentId s : complex.edge_segments[e]) {
    for (const SourceId f : complex.segment_faces[s])
      if (complex.sources[f].leaf == leaf) return true;
    for (const WireId w : complex.segment_wires[s])
      if (complex.wires[w].leaf == leaf) return true;
  }
  return false;
}

}  // namespace

bool operator==(const Model::Face& a, const Model::Face& b) { return a.loops == b.loops && a.solid == b.solid; }
bool operator==(const Model& a, const Model& b) {
  return a.points == b.points && a.faces == b.faces && a.wires == b.wires && a.isolated == b.isolated;
}

Rational volume_of(const Model& model) {
  Rational six = 0;
  for (const Model::Face& face : model.faces)
    for (const auto& loop : face.loops)
      for (std::size_t k = 2; k < loop.size(); ++k)
        six += dot(model.points[loop[0]], cross(model.points[loop[k - 1]], model.points[loop[k]]));
  return six / 6;
}

std::string fault_of(const Model& model) {
  if (std::set(model.points.begin(), model.points.end()).size() != model.points.size()) return "points are equal";
  std::set<std::uint32_t> used(model.isolated.begin(), model.isolated.end());
  for (const Model::Face& face : model.faces) {
    if (face.loops.size() != 1) return "a face has not one loop";
    used.insert(face.loops[0].begin(), face.loops[0].end());
    if (std::string fault = loop_fault(model, face.loops[0]); !fault.empty()) return fault;
  }
  for (const auto& [a, b] : model.wires) {
    used.insert({a, b});
    if (a == b) return "a wire has no length";
  }
  if (used.size() != model.points.size()) return "a point is not used";
  if (model.faces.empty() || !model.solid()) return {};
  return solid_fault(model);
}

Meeting meeting(const Model& a, const Model& b) {
  Soup soup;
  const LeafId first = add_model(soup, a).front(), second = add_model(soup, b).front();
  const auto built_complex = build_complex(soup, {.threads = 1});
  const Complex& complex = *built_complex;
  Meeting m;
  for (std::uint32_t i = 0; i < complex.face_count(); ++i) {
    const FaceId f(i);
    if (covers(complex, f, first) && covers(complex, f, second)) ++m.faces;
  }
  for (std::uint32_t i = 0; i < complex.edge_count(); ++i)
    if (on_edge(complex, EdgeId(i), first) && on_edge(complex, EdgeId(i), second)) ++m.edges;
  std::set<RationalPoint> corners[2] = {{a.points.begin(), a.points.end()}, {b.points.begin(), b.points.end()}};
  for (const VertexId v : complex.vertices) {
    const auto edges = complex.vertex_edges[v];
    std::vector<FaceId> faces;
    complex.star_faces(v, faces);
    bool edge[2], corner[2], face[2];
    for (const int side : {0, 1}) {
      const LeafId leaf = side == 0 ? first : second;
      edge[side] = std::any_of(edges.begin(), edges.end(), [&](EdgeId e) { return on_edge(complex, e, leaf); });
      face[side] = std::any_of(faces.begin(), faces.end(), [&](FaceId f) { return covers(complex, f, leaf); });
      corner[side] = corners[side].contains(complex.points.rational(v));
    }
    if (edge[0] && edge[1] && !corner[0] && !corner[1]) ++m.crossings;
    if ((edge[0] && edge[1]) || (corner[0] && face[1]) || (corner[1] && face[0])) ++m.vertices;
  }
  for (std::uint32_t r = 1; r < complex.region_count; ++r) {
    bool in[2] = {false, false};
    for (const Label& label : complex.labels(RegionId(r))) in[label.leaf == first ? 0 : 1] = true;
    const Rational size = volume(complex, RegionId(r)).value();
    if (in[0]) m.first += size;
    if (in[1]) m.second += size;
    if (in[0] && in[1]) m.both += size;
  }
  return m;
}

}  // namespace cnrg::bench
