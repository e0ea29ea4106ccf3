// Links are set algebra on stars and closures, radial order is an array of the complex.
#include "kernel/selection/incidence.h"

namespace cnrg {

CellSet link(const Complex& complex, const CellSet& set) {
  const CellSet closed = closure(complex, set);
  return subtract(closure(complex, star(complex, set)), star(complex, closed));
}

std::vector<RadialStep> radial_order(const Complex& complex, EdgeId e) {
  std::vector<RadialStep> out;
  for (const FaceUse& use : complex.edge_uses[e]) {
    const unsigned ahead = use.half_edge.direction();  // the side that looks counter-clockwise
    out.push_back({HalfFace(use.face, 1 - ahead), complex.face_regions[use.face][ahead]});
  }
  return out;
}

}  // namespace cnrg
