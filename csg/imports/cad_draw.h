// A CAD model drawn anew by the bands of its curved faces.
#pragma once

#include "csg/imports/cad_bands.h"

namespace cnrg {

struct DrawnCad {
  CadModel model;
  std::vector<RationalPoint> points;  ///< those of the model, whose own ones are the nearest doubles
  std::string obstacle;               ///< if there is one, nothing else counts
  bool finer = false;                 ///< there is none for finer grids, perhaps
};

/// `welded`: as of `bands_of`. A grid for each of the bands. `seams`: they are edges, too. `slack`: corners may go
/// that far, beyond what doubles round, to be on their surfaces.
DrawnCad draw_by_bands(const CadModel& model, const std::vector<RationalPoint>& welded, const CadBands& bands,
                       const std::vector<BandGrid>& grids, bool seams, double slack);

}  // namespace cnrg
