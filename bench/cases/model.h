// A polyhedral set: what systems of a comparison get and what they give back.
//
// Points are exact, whatever the system; one that computes in doubles rounds its operands and gives doubles back.
// A model says two things at once: a point set, and how the system represents it. Two points with equal
// coordinates are one place in space but two vertices: that is how a manifold representation touches itself.
#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <vector>

#include "bench/cases/triangle_mesh.h"
#include "kernel/exact/rational.h"

namespace cnrg::bench {

struct Model {
  struct Face {
    /// Places in `points`; the outer loop first, counter-clockwise as seen from outside of the solid, then holes,
    /// clockwise. The points of a loop are in one plane exactly, unless coordinates were rounded and the loop has
    /// three.
    std::vector<std::vector<std::uint32_t>> loops;
    bool solid = true;  ///< the solid is on its inner side only; false: a surface with none on either side
  };
  std::vector<RationalPoint> points;
  std::vector<Face> faces;
  std::vector<std::array<std::uint32_t, 2>> wires;  ///< segments that bound no face
  std::vector<std::uint32_t> isolated;              ///< points by themselves

  /// Without cells, whatever points there are.
  bool empty() const { return faces.empty() && wires.empty() && isolated.empty(); }
  /// Nothing but the boundary of a solid: no surface, wire or point by itself.
  bool solid() const;
  /// Faces cut into triangles: the sum over loops, holes bridged.
  std::size_t triangle_count() const;
};

/// Each polygon a face, or each triangle when the mesh has no polygons. `solid`: see `Model::Face`.
Model model_of(const TriangleMesh& mesh, bool solid = true);

/// The volume that the faces of the solid enclose, each point counted as often as they wind around it.
Rational signed_volume(const Model& model);

/// Coordinates rounded to the nearest doubles; faces, which must have one loop, become polygons, and triangles as
/// fans of their first corner (right for convex faces). Throws std::invalid_argument for holes, surfaces, wires
/// and points by themselves.
TriangleMesh rounded_mesh(const Model& model);

/// Text that reads back exactly; `read_model` throws std::runtime_error with the line of a fault.
void write_model(std::ostream& out, const Model& model);
Model read_model(std::istream& in);

}  // namespace cnrg::bench
