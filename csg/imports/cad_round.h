// Where the round faces of a CAD model lie, exactly: by the doubles of its file, or by what these agree on.
//
// A file that was written by a program which turned its parts in doubles has a hole of radius 1 about one axis and
// its bolt of radius 1.0000000000000002 about another. With `weld` the axes, centres and radii that are meant to
// be one are one (csg/weld/round_carriers.h); from there on the faces are compared as if the file had said so.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "csg/carriers/axes.h"
#include "csg/imports/cad_model.h"

namespace cnrg {

inline bool is_round(CadSurface::Kind kind) {
  using enum CadSurface::Kind;
  return kind == cylinder || kind == cone || kind == sphere || kind == torus;
}

/// A face on a cylinder, cone, sphere or torus.
struct RoundFace {
  AxisLine axis;
  RationalPoint origin;  ///< of the surface; of a sphere or torus its centre
  Rational radius, minor_radius;
};

struct CadRound {
  std::vector<std::optional<RoundFace>> faces;  ///< of each face of the model
  Rational moved = 0;                           ///< no point of a surface farther
  double slack = 0;    ///< how far corners may be from their surfaces for that, and for what else was welded
  std::string notice;  ///< empty: nothing was joined, and nothing is near
};

CadRound round_faces(const CadModel& model);
/// `face_name` as for `weld_cad`. Of cones the axes alone are joined: their circles are in the file by themselves.
CadRound welded_round_faces(const CadModel& model, const Rational& d,
                            const std::function<std::string(std::uint32_t)>& face_name);

}  // namespace cnrg
