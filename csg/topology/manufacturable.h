// Can the value be made as it is? (magalhaes2000; pereira2012 3 and 4.2, of regularization)
//
// What is made has a volume, and a skin that is a surface. So two things must hold: nothing is there but solids
// and their walls, that is, the value is regular; and each component by itself is a solid whose boundary is a
// 2-manifold. The local shapes of the whole set (kernel/selection/manifold.h) do not tell: a sheet between two
// parts is lost in them, and so is a part that touches itself along an edge around which other parts fill the
// rest.
#pragma once

#include <string>
#include <vector>

#include "kernel/selection/manifold.h"
#include "kernel/selection/simplify.h"

namespace cnrg {

struct Manufacturability {
  struct Touch {
    Component component = 0;
    std::string reason;              ///< such as `2 solid cones touch`
    std::vector<std::string> cells;  ///< where, as `cnrg locate` names them
  };
  std::size_t solids = 0;  ///< components with a volume
  /// Active cells in no wall of a region, by what they are: faces, edges that bound none of these, vertices in
  /// which none of both end.
  std::vector<std::string> dangling_faces, wires, loose_points;
  std::vector<Touch> touches;        ///< where the boundary of a component is no 2-manifold, by component
  std::vector<Component> unbounded;  ///< ascending
  bool yes() const;
};

/// Judged is the closure: what an open set lacks of its skin is no obstacle. `simplified` is that of `selection`.
Manufacturability manufacturability(const Complex& complex, const Selection& selection,
                                    const SimplifiedComplex& simplified, Neighbourhoods& neighbourhoods);

}  // namespace cnrg
