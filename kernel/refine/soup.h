// What refinement takes: points, planar faces with holes, segments and points of any number of leaves.
//
// Semantics of the input (also the degenerate one):
//   * Points with equal coordinates are one point, within a leaf and across leaves.
//   * A face is a planar polygon: one outer loop and any number of holes, given as loops of points in any
//     direction. Its *front* is the side from which the first loop is seen counter-clockwise.
//     All points of a face must lie on one plane exactly (`refine` throws InputError otherwise).
//     A face of zero area is dropped and reported. The interior is what the loops enclose an odd number of
//     times, so holes may be given in either direction.
//   * Faces may cross, overlap, repeat, within a leaf and across leaves.
//   * `front` and `back` are regions of the leaf (0: none) on the two sides, for Fill::sides and Fill::solids.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/exact/rational.h"

namespace cnrg {

/// How the regions of a leaf follow from its faces.
enum class Fill : std::uint8_t {
  none,     ///< a surface only: no regions
  sides,    ///< each face names the region on its front and on its back
  winding,  ///< region 1 where the winding number is not zero; the back of each face is inside
  parity,   ///< region 1 where a ray crosses the faces an odd number of times
  cells,    ///< every bounded cavity of the faces is a region, numbered from 1 by where it is (own_axes)
  /// Each face names the solid on its front and on its back; region r where the winding number of the faces of
  /// solid r is not zero. Solids may touch, also where their faces lie on each other; InputError if two overlap.
  solids,
};

/// Three linear functions of a point, independent: coordinates up to a shift.
using LeafAxes = std::array<RationalPoint, 3>;

class Soup {
 public:
  /// A new leaf; its faces, wires and points are added to it by id. `curved_sides`: it is a sheet of which
  /// add_curve_end tells all corners, so that each side of its patches is one curve.
  LeafId add_leaf(Fill fill, bool curved_sides = false);
  /// The coordinates in which a leaf was made, before it was moved: in these its cavities are numbered. Without
  /// them it is where it was made.
  void set_own_axes(LeafId leaf, const LeafAxes& axes) { own_axes_.emplace_back(leaf, axes); }

  PointId add_point(double x, double y, double z);  ///< finite; InputError otherwise
  PointId add_point(const RationalPoint& p);

  /// Adds a face of `leaf`. `leaf_face` numbers the leaf's own faces (the triangles of one planar face share
  /// one number), `patch` its patches (a plane, a cylinder, ...): facets of one curved patch share a number and
  /// are one face for people. Loops have at least three points; they do not repeat the first at the end.
  SourceId add_face(LeafId leaf, std::span<const std::vector<PointId>> loops, std::uint32_t leaf_face,
                    std::uint32_t patch, std::uint32_t front = 0, std::uint32_t back = 0);
  SourceId add_triangle(LeafId leaf, PointId a, PointId b, PointId c, std::uint32_t leaf_face, std::uint32_t patch,
                        std::uint32_t front = 0, std::uint32_t back = 0);
  /// Says on which plane the last face lies: the one through three points of the soup that are not collinear, seen
  /// counter-clockwise from its front. For a face cut out of an input face, which keeps the plane of that: its own
  /// corners may be constructed points, and a plane through these has longer numbers. Nobody checks the corners.
  void set_plane(const std::array<PointId, 3>& points);
  /// A wire from a to b; `leaf_edge` numbers the leaf's curves (the pieces of one tessellated curve share one).
  WireId add_wire(LeafId leaf, PointId a, PointId b, std::uint32_t leaf_edge);
  /// An isolated vertex of the leaf.
  void add_isolated(LeafId leaf, PointId p);
  /// Declares a corner of a curved surface, where curves of the leaf end: edges that meet there are not pieces of
  /// one curve. A corner is an attribute of the point, not a cell.
  void add_curve_end(LeafId leaf, PointId p);
  /// Says which curved surfaces the patches of the last leaf lie on, by numbers from 1 that mean the same in all
  /// leaves; 0: none is known.
  void number_surfaces(const std::function<std::uint32_t(std::uint32_t patch)>& surface_of);

  /// Declares a leaf as the frame: a closed convex box, oriented outward, that cuts off what is unbounded. Points
  /// of other leaves are strictly inside, except where faces of unbounded leaves are cut off on it. Cells on and
  /// outside of it are never active. `seed_regions`: the regions of leaves (Fill::sides) at the frame's corner
  /// `seed`, which no face but the frame's touches; 0 for leaves that are not listed.
  void set_frame(LeafId frame, PointId seed, std::vector<std::pair<LeafId, std::uint32_t>> seed_regions);

  // --- reading
  struct Face {
    LeafId leaf;
    std::uint32_t leaf_face = 0, patch = 0, front = 0, back = 0;
    std::uint32_t surface = 0;  ///< the number of the curved surface that it lies on; 0: none is known
    bool curved_sides = false;  ///< as its leaf
  };
  struct Wire {
    LeafId leaf;
    std::uint32_t leaf_edge = 0;
    PointId a, b;
  };
  struct Isolated {
    LeafId leaf;
    PointId point;
  };
  std::size_t point_count() const { return xyz_.size() / 3; }
  std::size_t face_count() const { return faces_.size(); }
  std::size_t leaf_count() const { return fills_.size(); }
  Fill fill(LeafId leaf) const { return fills_[leaf.index()]; }
  bool curved_sides(LeafId leaf) const { return curved_sides_[leaf.index()] != 0; }
  /// The first point that was added after the leaf.
  PointId first_point(LeafId leaf) const { return first_points_[leaf.index()]; }
  /// nullptr: x, y and z.
  const LeafAxes* own_axes(LeafId leaf) const;
  const Face& face(SourceId f) const { return faces_[f.index()]; }
  /// Corners of the face, loop after loop, with `PointId::none()` between two loops.
  std::span<const PointId> corners(SourceId f) const {
    return {corners_.data() + offsets_[f.index()], corners_.data() + offsets_[f.index() + 1]};
  }
  /// The plane that was said of a face; nullptr: it is that of its corners.
  const std::array<PointId, 3>* plane(SourceId f) const;
  std::span<const Wire> wires() const { return wires_; }
  std::span<const Isolated> isolated() const { return isolated_; }
  std::span<const Isolated> curve_ends() const { return curve_ends_; }
  const double* xyz(PointId p) const { return xyz_.data() + 3 * p.index(); }
  /// The exact value of a point that is not three doubles, or nullptr.
  const RationalPoint* rational(PointId p) const;
  LeafId frame() const { return frame_; }
  PointId frame_seed() const { return seed_; }
  const std::vector<std::pair<LeafId, std::uint32_t>>& seed_regions() const { return seed_regions_; }

 private:
  SourceId end_face(const Face& face);

  std::vector<double> xyz_;                                   // nearest doubles
  std::vector<std::pair<PointId, RationalPoint>> rationals_;  // sorted by id: the points that are no doubles
  std::vector<Fill> fills_;
  std::vector<char> curved_sides_;     // by leaf
  std::vector<PointId> first_points_;  // by leaf
  std::vector<std::pair<LeafId, LeafAxes>> own_axes_;
  std::vector<Face> faces_;
  std::vector<std::uint32_t> offsets_{0};
  std::vector<PointId> corners_;
  std::vector<std::pair<SourceId, std::array<PointId, 3>>> planes_;  // sorted by face
  std::vector<Wire> wires_;
  std::vector<Isolated> isolated_, curve_ends_;
  LeafId frame_;
  PointId seed_;
  std::vector<std::pair<LeafId, std::uint32_t>> seed_regions_;
};

/// One soup face that covers a face of the complex; `same`: its front is the face's front.
struct Cover {
  SourceId source;
  bool same = true;
  friend auto operator<=>(const Cover&, const Cover&) = default;
};

}  // namespace cnrg
