// A result: one value on a complex, with all that files say of it.
//
// It comes from an evaluation, or from a group, components or a selection made by hand. It shares the ownership of
// everything that it shows, so that it may be kept, copied (as a pointer is) and written when the tree, the
// evaluation and the groups that it was made of are gone. It never changes; several threads may read it at once.
// References that its members return live as long as the result or any copy of it.
//
//   write("model.vtu", evaluation.result("model"));                    csg/formats/result_file.h
//   write("both.json", Result(complex, unite(...), {.result = "both"}));
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "csg/operators/components.h"
#include "kernel/base/progress.h"
#include "kernel/selection/simplify.h"

namespace cnrg {

/// What a result and what it was made of are called in files; all of it may stay empty.
struct ResultNames {
  struct Material {
    std::string name, color{};  ///< color `#rrggbb`, or empty
  };
  std::string result{};               ///< of the result itself; of an evaluation its node's
  std::vector<std::string> leaves{};  ///< by LeafId
  std::vector<Material> materials{};  ///< in the order that files list them; others that regions have come after
};

class Result {
 public:
  /// The cells are simplified by `mode`. The lists of the value must be as operators make them: sorted, and
  /// closed if it is a group.
  Result(std::shared_ptr<const Complex> complex, Group group, ResultNames names = {},
         SimplifyMode mode = SimplifyMode::features);
  Result(std::shared_ptr<const Complex> complex, Components components, ResultNames names = {},
         SimplifyMode mode = SimplifyMode::features);
  /// Components without names and materials; a cell comes from all leaves that hold it.
  Result(std::shared_ptr<const Complex> complex, Selection selection, ResultNames names = {},
         SimplifyMode mode = SimplifyMode::features);

  const std::string& name() const;
  const Complex& complex() const;
  /// The cells that files list, numbered as there.
  const SimplifiedComplex& cells() const;
  /// The regions of a group, and its entities as one more, the last, if it has any; or the components.
  std::size_t component_count() const;
  /// Name, material and leaves of component i, from 1.
  const RegionAttributes& attributes(Component i) const;
  /// The cells of the complex in it, by component.
  Selection selection() const;
  /// The exact volume of component i; nothing if it is unbounded.
  std::optional<Rational> volume(Component i) const;
  /// The cell of the result in which a point lies that a Locator of `complex()` has found.
  SimplifiedComplex::Place place(const Location& location) const;
  /// The component at a place; 0 outside of all.
  Component component(const SimplifiedComplex::Place& place) const { return component_of(cells(), place); }

  /// What it holds, for the rooms that make results and write them (result_data.h).
  struct Data;
  explicit Result(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
  const Data& data() const { return *data_; }

 private:
  std::shared_ptr<const Data> data_;
};

/// What rounding to doubles did to a written file.
struct RoundingReport {
  std::size_t moved = 0;  ///< vertices whose doubles differ from their exact coordinates
  bool embedded = true;   ///< the rounded facets still meet only in shared vertices and edges
  std::vector<std::string>
      notices{};  ///< of .step and .brep: how near it is to the surfaces, what is faceted and why
};

/// What `snap` did.
struct SnapReport {
  std::size_t points = 0;   ///< of the result
  std::size_t moved = 0;    ///< of these: those that are elsewhere now, or nowhere
  std::size_t added = 0;    ///< vertices where there was none
  std::size_t faces = 0;    ///< of the result: faces that vanished
  std::size_t regions = 0;  ///< of the result: active regions that vanished
  std::size_t wires = 0;    ///< of the result: wires that vanished
  int rounds = 0;           ///< refinements; 0: nothing had to be snapped, and all of this is 0
  double displacement = 0;  ///< no point of the result moved farther (units of the model)
  /// The regions that vanished, a line for each component: `dust, r2, at (1, 2, 3)` (csg/result/vanished.h).
  std::vector<std::string> lost_regions{};
  /// Those of which what is left is in more pieces than before, a line each: `the region rock is in 3 pieces now
  /// and was in one, the smallest at (1, 2, 3)`.
  std::vector<std::string> parted_regions{};
  /// `snapped 3 of 20 vertices, by 1e-16 at most, ...`: one line without its end.
  std::string text() const;
  /// What nobody may miss, a line each: regions that vanished, and that were parted.
  std::vector<std::string> warnings() const;
};

/// The result on doubles: every vertex is three doubles, and nothing crosses (csg/result/snap.h says how). The
/// same result where rounding alone is right. Throws InputError for a result with faces or lines that reach the
/// frame of unbounded leaves, for one that does not become stable, and beyond the range of doubles; Stopped, as
/// the watch asks. Components of which nothing is left are gone; the others keep their order.
Result snap(const Result& result, SnapReport* report = nullptr, const Watch& watch = {});

/// A mesh as it is expected to be.
struct MeshForecast {
  double tetrahedra = 0;
  double least = 0, most = 0;  ///< of tetrahedra: what nearly all meshes lie between that were made to find out
  double bytes = 0;            ///< of memory that making it takes
  double seconds = 0;          ///< that making it takes
  /// Good shapes everywhere would take so many, but points that nobody asks for are rationed; 0: they need no
  /// more.
  double for_shapes = 0;
};

/// Some of x, y, z.
using PeriodicAxes = std::array<bool, 3>;

/// What is asked of the tetrahedra that fill a result.
struct TetrahedraOptions {
  double max_volume = 0;       ///< no tetrahedron is larger (cubic units); 0: no bound
  double quality = 0;          ///< largest ratio of circumradius to shortest edge, at least 1; 0: no bound
  bool keep_boundary = false;  ///< no new points on faces and edges, but inside of regions only
  bool constrained = false;    ///< not by TetGen: constrained tetrahedra; not with `keep_boundary`
  /// By the clock, for all of the work, 0: no bound. A mesh that is there when they are over is kept as it is, and
  /// the notice says so; where there is none it is an InputError. Not given: steps are counted of each way in
  /// which TetGen is asked, and of improving shapes, and what else makes a mesh has no bound; the mesh is the same
  /// on every machine.
  std::optional<int> seconds{};
  int order = 1;        ///< of the elements; 2: with a node in the middle of each edge
  double size = 0;      ///< how long edges are to be where nothing asks for shorter ones; 0: no bound
  double growth = 0.3;  ///< how much longer they may be per unit of distance from where they are to be short
  /// Faces and edges are meshed as surfaces first (csg/mesh/surface_triangles.h), and those triangles are the
  /// boundary; not with `keep_boundary` or `constrained`.
  bool surface_first = false;
  bool curved = false;  ///< brought to the true surfaces, of second order (csg/mesh/curved_mesh.h)
  /// Groups of faces whose sides get nodes of their own (csg/mesh/split.h), with wedges between them.
  std::vector<std::string> split{};
  bool interfaces = false;
  PeriodicAxes periodic{};  ///< opposite sides are alike (csg/mesh/periodic.h), as with `surface_first`
  /// Told what the mesh will be, before it is made, where that can be told.
  std::function<void(const MeshForecast&)> foretold{};
  Watch watch{};  ///< told of the stages, and may stop them (throws Stopped)
};

/// What was made of one region.
struct RegionTetrahedra {
  std::string name;  ///< of its group in the mesh
  std::size_t tetrahedra = 0;
  Rational volume;  ///< of the tetrahedra, exactly
};

/// No side is longer than this in its middle; infinite where nothing is said. Empty: nowhere anything.
using SizeAt = std::function<double(const std::array<double, 3>&)>;

/// What is asked of the triangles on the faces of a result.
struct SurfaceOptions {
  SizeAt size{};
  /// Sides are as long as these say, which mean what they mean for tetrahedra, and as the result asks for, unless
  /// `size` is given.
  double overall = 0, growth = 0.3;
  std::size_t max_points = 1'000'000;  ///< no points are added beyond these
  int seconds = 0;                     ///< by the clock, for all of the work; 0: no bound
  int order = 1;            ///< of the elements; 2: with a node in the middle of each side, not with quads
  bool quads = false;       ///< triangles are merged by pairs where these are good
  PeriodicAxes periodic{};  ///< opposite sides get the same triangles (csg/mesh/periodic.h)
  Watch watch{};
};

/// Triangles of all faces whose first group is the same.
struct FaceTriangles {
  std::string name;  ///< of the group
  std::size_t triangles = 0;
  double area = 0;
  double least_angle = 180;          ///< degrees
  std::array<double, 3> where{};     ///< a corner with that angle
  std::array<std::size_t, 4> why{};  ///< triangles by SmallAngle (csg/mesh/refine_surface.h)
  std::size_t quads = 0;             ///< in place of two triangles each, which are not counted
  double least_quad = 1;             ///< of a rectangle 1
};

}  // namespace cnrg
