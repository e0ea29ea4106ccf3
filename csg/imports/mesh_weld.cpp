#include "csg/imports/mesh_weld.h"

#include <algorithm>

namespace cnrg {

MeshWeld weld_mesh(MeshData& data, const std::string& name, const Rational& d, bool only_planes) {
  MeshWeld result;
  WeldModel& model = result.model;
  model.only_planes = only_planes;
  auto next_exact = data.exact.begin();
  for (std::uint32_t i = 0; i < data.point_count(); ++i) {
    const double* const p = data.xyz.data() + 3 * std::size_t{i};
    if (next_exact != data.exact.end() && next_exact->first == i) model.points.push_back((next_exact++)->second);
    else model.points.push_back({from_double(p[0]), from_double(p[1]), from_double(p[2])});
  }
  for (std::uint32_t f = 0; f < data.face_count(); ++f) {
    model.faces.push_back({.may_vanish = true});
    model.facets.push_back(
        {f, {{data.corners.begin() + data.offsets[f], data.corners.begin() + data.offsets[f + 1]}}});
  }
  model.subject = name + ": ";
  model.face_name = [](std::uint32_t f) { return "face " + std::to_string(f); };
  result.made = weld(model, d);
  if (!result.made.changed()) return result;
  data.exact.clear();
  for (std::uint32_t i = 0; i < data.point_count(); ++i) {
    const RationalPoint& p = result.made.points[i];
    for (std::size_t k = 0; k < 3; ++k) data.xyz[3 * std::size_t{i} + k] = to_double(p[k]);
    if (!std::all_of(p.begin(), p.end(), [](const Rational& x) { return is_double(x); }))
      data.exact.emplace_back(i, p);
  }
  return result;
}

void check_volume(const MeshWeld& weld, const Rational& d) {
  WeldModel::Solid solid{"the solid", {}};
  for (std::uint32_t f = 0; f < weld.model.facets.size(); ++f) solid.facets.emplace_back(f, true);
  check_solid(weld.model, solid, weld.made.points, d);
}

}  // namespace cnrg
