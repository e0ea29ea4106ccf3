#include "csg/mesh/improved.h"

#include <algorithm>

#include "kernel/exact/predicates.h"

namespace cnrg {

bool has_outside(const FlatComplex& flat) {
  return std::any_of(flat.faces.begin(), flat.faces.end(),
                     [&](const auto& f) { return !flat.active(f.regions[0]) && !flat.active(f.regions[1]); }) ||
         std::any_of(flat.edges.begin(), flat.edges.end(),
                     [&](const auto& e) { return e.wire && !flat.active(e.region); }) ||
         std::any_of(flat.vertices.begin(), flat.vertices.end(),
                     [&](const auto& v) { return v.region != FlatComplex::kNone && !flat.active(v.region); });
}

PlcMesh improved(const Plc& plc, const FlatComplex& flat, const PlcMesh& mesh, ImproveOptions options,
                 const Watch& watch, Improved* end) {
  watch.begin("mesh: shapes");
  ConformingTetrahedra work;
  work.points = mesh.points;
  const bool outside = has_outside(flat);
  for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i) {
    const std::int32_t a = mesh.attribute[i];
    const bool inside = a >= 1 && a <= static_cast<std::int32_t>(plc.regions.size());
    if (!inside && !outside) continue;
    auto t = mesh.tetrahedra[i];
    const auto& p = mesh.points;
    if (orient3d(p[t[0]].data(), p[t[1]].data(), p[t[2]].data(), p[t[3]].data()) < 0) std::swap(t[2], t[3]);
    work.tetrahedra.push_back(t);
    work.region.push_back(inside ? a - 1 : -1);
  }
  // Facets of the complex may be the triangles of one planar piece.
  std::vector<std::int32_t> of_piece;  // a facet of it
  for (std::size_t i = 0; i < plc.facets.size(); ++i) {
    const std::size_t piece = plc.facets[i].piece;
    if (piece >= of_piece.size()) of_piece.resize(piece + 1, -1);
    of_piece[piece] = static_cast<std::int32_t>(i);
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto f = static_cast<std::size_t>(mesh.facet[i]);
    if (f >= plc.facets.size()) continue;
    work.triangles.push_back(mesh.triangles[i]);
    work.facet.push_back(static_cast<std::int32_t>(plc.facets[f].piece));
  }
  for (std::size_t i = 0; i < mesh.segments.size(); ++i) {
    if (mesh.edge[i] < 0) continue;
    work.segments.push_back(mesh.segments[i]);
    work.line.push_back(mesh.edge[i]);
  }
  options.fixed = static_cast<ConformingTetrahedra::Index>(plc.points.size());
  const Improved how = improve(work, options, watch);
  if (end != nullptr) *end = how;
  PlcMesh out;
  out.points = std::move(work.points);
  out.tetrahedra = std::move(work.tetrahedra);
  for (const std::int32_t r : work.region) out.attribute.push_back(r + 1);
  out.triangles = std::move(work.triangles);
  for (const std::int32_t piece : work.facet) out.facet.push_back(of_piece[static_cast<std::size_t>(piece)]);
  out.segments = std::move(work.segments);
  out.edge = std::move(work.line);
  return out;
}

std::string unfinished_text(const ImproveOptions& asked, Improved end) {
  std::string missed;
  if (asked.size) missed += "sizes, ";
  if (asked.volume > 0) missed += "--max-volume, ";
  if (asked.radius_edge > 0) missed += "--quality, ";
  if (end == Improved::too_many) {
    return "the mesh had many times the tetrahedra that were expected, as where regions are far thinner than "
           "edges are to be long; it was refined no further, and what is missed may be " +
           missed + "good shapes";
  }
  const bool late = end == Improved::time_over;
  return std::string(late ? "time was" : "the steps of improving were") +
         " over before the mesh was improved to the end, and what is missed may be " + missed +
         "good shapes; give " + (late ? "more --seconds" : "it time by --seconds 0");
}

}  // namespace cnrg
