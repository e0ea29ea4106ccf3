// The curved faces of a CAD model as bands of surfaces of revolution, where all of them are.
//
// Numbers of a file are doubles: a corner of a cylinder's face is next to the cylinder, the circle of a cone next
// to the cone. What carries the faces is decided without a tolerance; a corner is then put on its surface, which
// moves it by what doubles round and by no more, else the face is told to be something else.
#pragma once

#include <array>
#include <numbers>
#include <string>
#include <vector>

#include "csg/carriers/bands.h"
#include "csg/curves/boundary_curves.h"
#include "csg/imports/cad_model.h"
#include "csg/imports/cad_round.h"

namespace cnrg {

inline constexpr double kTurn = 2 * std::numbers::pi;
/// What doubles round, and what files do to their decimals, relative to the size of a face.
inline constexpr double kRounding = 1e-9;

/// Why a model cannot be drawn by bands: what its making throws.
struct NotDrawn {
  std::string words;
  bool finer = false;  ///< it can, if it is drawn finer
};

/// How a face of the model lies on its band; columns and rows are those of the band's grid.
struct BandBorder {
  struct Corner {
    std::uint32_t point = 0;  ///< of the model
    std::size_t mark = 0;     ///< of the band
    bool last = false;        ///< in the last row, else in the first one
  };
  enum class Side : std::uint8_t { first_row, last_row, start, end };
  std::vector<Corner> corners;
  std::vector<std::pair<std::uint32_t, Side>> edges;
  std::array<std::int64_t, 2> poles{-1, -1};  ///< points in which the first and the last row end, if they do
  bool outward = true;                        ///< the front is away from the axis, or the middle of the arc
  bool turns_up = true, ahead = true;         ///< u and v grow along columns and rows
  std::array<double, 2> low{}, high{};        ///< of its parameters
};

struct CadBands {
  std::vector<Band> bands;
  std::vector<BandBorder> borders;  ///< of these
  std::string obstacle;             ///< as of BandedForm
  double slack = 0;                 ///< as of BandedForm
};

/// `round`: of each face of the model. `welded`: the model's points where they were moved to, empty: they were
/// not. `fineness`: of the leaf. `seams`: they are edges, too.
CadBands bands_of(const CadModel& model, const CadRound& round, const std::vector<RationalPoint>& welded,
                  const Fineness& fineness, bool seams);

/// u and v of a point of the surface, angles between -180 and 180 degrees.
std::array<double, 2> parameters_at(const CadSurface& surface, const std::array<double, 3>& p);

}  // namespace cnrg
