#include "csg/imports/cad_weld.h"

#include "kernel/exact/exact_vectors.h"

namespace cnrg {

Weld weld_cad(const CadModel& model, const Rational& d, const std::string& subject,
              const std::function<std::string(std::uint32_t)>& face_name,
              const std::function<std::string(std::uint32_t)>& solid_name) {
  WeldModel all;
  for (const auto& p : model.points) all.points.push_back(from_doubles(p));
  for (std::uint32_t s = 0; s < model.solids.size(); ++s) all.solids.push_back({solid_name(s), {}});
  for (std::uint32_t f = 0; f < model.faces.size(); ++f) {
    const CadModel::Face& face = model.faces[f];
    all.faces.push_back({.curved = face.surface.kind != CadSurface::Kind::plane});
    for (const auto& triangle : face.triangles) {
      const auto facet = static_cast<std::uint32_t>(all.facets.size());
      all.facets.push_back({f, {{triangle.begin(), triangle.end()}}});
      for (const std::uint32_t s : face.behind) all.solids[s].facets.emplace_back(facet, true);
      for (const std::uint32_t s : face.before) all.solids[s].facets.emplace_back(facet, false);
    }
  }
  all.subject = subject;
  all.face_name = face_name;
  return weld(all, d);
}

}  // namespace cnrg
