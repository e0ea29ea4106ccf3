#include "csg/imports/cad_round.h"

#include <algorithm>
#include <cmath>

#include "csg/text/table.h"
#include "csg/weld/planes.h"
#include "csg/weld/round_carriers.h"
#include "kernel/base/vectors.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

using Index = std::uint32_t;
using Kind = CadSurface::Kind;

welding::RoundPart part_of(const CadModel& model, const CadModel::Face& face, const RoundFace& round) {
  welding::RoundPart part;
  part.axis = round.axis;
  part.radii = {round.radius};
  part.reach = round.radius + round.minor_radius;
  if (face.surface.kind == Kind::sphere) {
    part.ball = true;
    part.center = round.origin;
    return part;
  }
  if (face.surface.kind == Kind::torus) {
    part.radii.push_back(round.minor_radius);
    part.places = {round.axis.place_of(round.origin)};
  }
  if (face.surface.kind == Kind::cone) part.radii.clear();
  // How far it goes, by its corners: along the axis in doubles is enough to see what is near.
  const auto direction = to_doubles(round.axis.direction), foot = to_doubles(round.axis.foot);
  const double square = dot(direction, direction);
  double low = 0, high = 0, reach = 0;
  bool first = true;
  for (const auto& triangle : face.triangles) {
    for (const Index p : triangle) {
      double along = 0;
      DoubleVector off;
      for (std::size_t k = 0; k < 3; ++k) along += (model.points[p][k] - foot[k]) * direction[k] / square;
      for (std::size_t k = 0; k < 3; ++k) off[k] = model.points[p][k] - foot[k] - along * direction[k];
      low = first ? along : std::min(low, along);
      high = first ? along : std::max(high, along);
      reach = std::max(reach, length(off));
      first = false;
    }
  }
  part.ends = {from_double(low), from_double(high)};
  part.reach = std::max(part.reach, from_double(reach * (1 + 1e-9)));
  return part;
}

}  // namespace

CadRound round_faces(const CadModel& model) {
  CadRound result;
  for (const CadModel::Face& face : model.faces) {
    const CadSurface& of = face.surface;
    std::optional<RoundFace>& round = result.faces.emplace_back();
    if (!is_round(of.kind) || face.triangles.empty()) continue;
    const RationalPoint origin = from_doubles(of.axes.origin);
    round = {axis_line(origin, from_doubles(of.axes.z)), origin, from_double(of.radius),
             from_double(of.minor_radius)};
  }
  return result;
}

CadRound welded_round_faces(const CadModel& model, const Rational& d,
                            const std::function<std::string(std::uint32_t)>& face_name) {
  CadRound result = round_faces(model);
  std::vector<welding::RoundPart> parts;
  std::vector<Index> of;
  for (Index f = 0; f < model.faces.size(); ++f) {
    if (!result.faces[f]) continue;
    parts.push_back(part_of(model, model.faces[f], *result.faces[f]));
    of.push_back(f);
  }
  const welding::RoundWeld made = welding::weld_round(parts, d);
  std::size_t joined = 0;
  for (Index k = 0; k < parts.size(); ++k) {
    const welding::RoundPart& was = parts[k];
    const welding::RoundPlace& is = made.parts[k];
    if (is.moved == 0) continue;
    RoundFace& face = *result.faces[of[k]];
    if (was.ball) {
      // Its poles stay where the file has them, nearly: an axis of that direction through the new centre.
      face.axis = axis_line(is.center, face.axis.direction);
      face.origin = is.center;
    } else {
      face.axis = is.axis;
      const Rational at = was.places.empty() ? is.axis.place_of(face.origin) : is.places.at(was.places[0]);
      face.origin = is.axis.foot + at * is.axis.direction;
    }
    if (!was.radii.empty()) face.radius = is.radii.at(face.radius);
    if (was.radii.size() > 1) {
      face.minor_radius = is.radii.at(face.minor_radius);
      if (face.minor_radius >= face.radius) refuse_weld("", face_name(of[k]) + " would vanish", d);
    }
    result.moved = std::max(result.moved, is.moved);
    ++joined;
  }
  if (joined > 0) {
    result.notice = "weld " + to_decimal(d, 6) + ": " + counted(joined, "round face", "round faces") +
                    " joined with others, moved by " +
                    decimal(std::min(welding::rounded_up(result.moved), to_double(d)), "%.3g") + " at most";
  }
  if (!made.left.empty()) {
    const auto& [a, b] = made.left[0];
    result.notice += (result.notice.empty() ? "weld " + to_decimal(d, 6) + ": " : "; ") +
                     counted(made.left.size(), "pair of round faces is", "pairs of round faces are") +
                     " near but not joined, since all that is joined has to lie within the length, such as " +
                     face_name(of[a]) + (a == b ? "" : " and " + face_name(of[b]));
  }
  return result;
}

}  // namespace cnrg
