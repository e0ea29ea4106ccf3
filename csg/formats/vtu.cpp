// VTK's unstructured grid in XML, for ParaView: vertices, lines of the edges, triangles of the faces, and every
// region as the triangles of its boundary, normals outward. Cell data tells them apart:
//
//   dimension     0 to 3; threshold by it to see one kind
//   cell          number of the cell among those of its dimension, as in .json
//   component     of the result, from 1
//   region        dimension 3: the region's component; below: of the region behind, in front or around; or 0
//   region_front, region_back     faces only: on the two sides; 0 outside
//   regions_bounded               faces only: 0 dangling, 1 boundary, 2 wall between two regions; else -1
//   material      of a sheet, wire or point that has one, else of the component, for entities of a group of that
//                 region; 0: none
//   name          of a sheet, wire or point; 0: nobody gave one. Missing if nobody gave any
//   KEY           each property of `attributes`: numbers, rounded to doubles, not a number (NaN) where nothing is
//                 said; or the number of a text, 0: nothing is said. KEY' where the key is one of these names
//   source_leaf, source_face      the first leaf with a face that the cell came from, and that face; of a cell
//                                 from no face the first leaf and -1 (.json has all)
//
// Where a material is graded, `fraction of NAME` has the part of each material at the centroid of the cell as
// drawn (a triangle, a tetrahedron), as the region that the cell belongs to has it.
//
// With parameters (leaves/parameters.h), for faces on patches of leaves:
//   parameters    of points: u and v on the patch, NaN where there are none. Points are split where triangles
//                 have different ones: between patches, at seams and poles
//   patch         of cells; 0: no parameters
// Between the corners of a triangle they are linear. A flat face that unites many facets of a patch has them only
// if they are one affine map on it; `--raw` keeps its facets apart.
//
// Names are field data, an array for each: `region rock`, `material granite`, `source_leaf fault`, `patch drum:
// side`, `name bolts`, `section round` hold the numbers that the cell data of that name has for it. Arrays of
// strings would say it more directly, but VTK alone reads these: meshio refuses the whole file for one of them.
// For meshio's sake edges are lines and no polylines, too, and an empty result has a cell without points.
//
// Arrays are base64 of little-endian numbers, doubles unrounded. Cells that bound the result without being part of
// it are not drawn: an open region has dimension 3 alone, its triangles are where it ends.
#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

#include "csg/formats/formats.h"
#include "csg/formats/vtu_grid.h"
#include "csg/result/flat.h"
#include "csg/result/rounding.h"
#include "csg/result/solid.h"
#include "kernel/base/counts.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

using Index = FlatComplex::Index;

using Cells = std::vector<std::vector<PatchCorner>>;

/// A cell whose map serves all the cells; nullptr if no one affine map does.
const std::vector<PatchCorner>* common(const Cells& cells) {
  if (cells.size() == 1) return &cells[0];
  if (cells.empty()) return nullptr;
  const std::vector<PatchCorner>& first = cells[0];
  // Three corners of the first one; the fourth is checked with the others.
  std::vector<PatchCorner> three{first[0], first[1], first[2]};
  if (!is_cell(three)) three = {first[0], first[2], first[3]};
  for (const auto& cell : cells) {
    for (const PatchCorner& corner : cell) {
      if (parameters_in(three, corner.point) != corner.at) return nullptr;
    }
  }
  return &first;
}

/// Points of a grid split so that each has one pair of parameters; see above. The corners of a triangle get their
/// parameters in the cell of its facet, exactly, and are rounded last.
class VtuSplit {
 public:
  /// For a view with parameters. `xyz`: of the flattened result's points, which keep their numbers, without
  /// parameters; split ones come after them.
  VtuSplit(const ResultView& view, const FlatComplex& flat, const std::vector<std::array<double, 3>>& xyz);

  /// Triangle k of a face on split points.
  std::array<Index, 3> triangle(Index face, std::size_t k) const { return triangles_[first_[face] + k]; }
  /// A row of the names; 0 where the face has no parameters.
  std::int32_t patch(Index face) const { return patches_[face]; }
  /// Notes the next cell of the grid.
  void add_cell(std::int32_t patch) { parameters_.patches.push_back(patch); }

  const std::vector<std::array<double, 3>>& points() const { return xyz_; }
  const VtuParameters& parameters() const { return parameters_; }

 private:
  Index split(Index point, std::int32_t patch, const Parameters& at);

  std::vector<std::array<double, 3>> xyz_;
  VtuParameters parameters_;
  std::vector<std::array<Index, 3>> triangles_;  // of all faces
  std::vector<std::size_t> first_;               // of each face among them
  std::vector<std::int32_t> patches_;            // by face
  std::map<std::tuple<Index, std::int32_t, Parameters>, Index> number_;
};

VtuSplit::VtuSplit(const ResultView& view, const FlatComplex& flat, const std::vector<std::array<double, 3>>& xyz)
    : xyz_(xyz), patches_(flat.faces.size(), 0) {
  parameters_.uv.assign(2 * xyz.size(), std::numeric_limits<double>::quiet_NaN());
  std::map<FlatComplex::Patch, std::int32_t> rows;
  for (Index i = 0; i < flat.faces.size(); ++i) {
    const FlatComplex::Face& face = flat.faces[i];
    first_.push_back(triangles_.size());
    triangles_.insert(triangles_.end(), face.triangles.begin(), face.triangles.end());
    std::vector<const std::vector<PatchCorner>*> cells;  // by facet
    for (const Cells& facet : face.cells) cells.push_back(common(facet));
    if (std::find(cells.begin(), cells.end(), nullptr) != cells.end() || cells.empty()) continue;
    const auto [row, fresh] =
        rows.try_emplace(*face.patch, static_cast<std::int32_t>(parameters_.names.size() + 1));
    if (fresh) {
      const auto& [leaf, patch] = *face.patch;
      const bool named = view.leaves != nullptr && leaf.index() < view.leaves->size();
      parameters_.names.push_back((named ? (*view.leaves)[leaf.index()].name + ": " : "") +
                                  view.parameters->patch_name(leaf, patch));
    }
    patches_[i] = row->second;
    for (std::size_t k = 0, facet = 0; k < face.triangles.size(); ++k) {
      while (!face.facet_ends.empty() && k >= face.facet_ends[facet]) ++facet;
      for (Index& p : triangles_[first_[i] + k]) {
        const RationalPoint at = view.complex->points.rational(flat.points[p]);
        p = split(p, row->second, parameters_in(*cells[facet], at));
      }
    }
  }
}

Index VtuSplit::split(Index point, std::int32_t patch, const Parameters& at) {
  const auto [it, fresh] = number_.try_emplace({point, patch, at}, next_number(xyz_.size(), "points"));
  if (fresh) {
    xyz_.push_back(std::array<double, 3>(xyz_[point]));
    for (const Rational& x : at) parameters_.uv.push_back(to_double(x));
  }
  return it->second;
}

class VtuWriter {
 public:
  explicit VtuWriter(const ResultView& view) : view_(view), flat_(flatten(view)), tagger_(view, flat_) {
    require_off_frame(flat_, "VTU");
    points_ = round_points(view, flat_);
    if (view.parameters != nullptr) split_.emplace(view, flat_, points_.xyz);
  }

  FileText run() {
    add_vertices();
    add_edges();
    add_faces();
    add_regions();
    if (grid_.empty()) add_nothing();
    if (!flat_.frame_points.empty()) drop_places();
    flat_ = {};  // the text takes as much
    if (!split_) return {grid_.text(view_, points_.xyz), report_rounding(points_, drawing_)};
    return {grid_.text(view_, split_->points(), &split_->parameters()), report_rounding(points_, drawing_)};
  }

 private:
  const ResultView& view_;
  FlatComplex flat_;
  CellTagger tagger_;
  RoundedPoints points_;
  Drawing drawing_;
  VtuGrid grid_;
  std::optional<VtuSplit> split_;

  void add(VtuCell kind, const auto& points, const CellTags& tags, std::int32_t patch = 0) {
    grid_.add(kind, points, tags);
    if (split_) split_->add_cell(patch);
  }
  /// Triangle k of a face, on the points of its patch.
  std::array<Index, 3> triangle(Index face, std::size_t k) const {
    return split_ ? split_->triangle(face, k) : flat_.faces[face].triangles[k];
  }
  std::int32_t patch(Index face) const { return split_ ? split_->patch(face) : 0; }

  /// A face that ends where infinity begins has two regions on its sides, which meet around it once it is drawn.
  void drop_places() {
    drawing_.sides.clear();
    drawing_.around_segments.clear();
    drawing_.around_points.clear();
  }

  /// A cell without points.
  void add_nothing() {
    CellTags tags;
    tags.dimension = tags.cell = -1;
    add(VtuCell::poly_vertex, std::array<Index, 0>{}, tags);
  }

  void add_vertices() {
    std::vector<char> drawn(flat_.points.size(), 0);
    for (const auto& f : flat_.faces) {
      for (const auto& t : f.triangles)
        for (const Index p : t) drawn[p] = 1;
    }
    for (const auto& e : flat_.edges)
      for (const Index p : e.points) drawn[p] = 1;
    for (Index i = 0; i < flat_.vertices.size(); ++i) {
      const auto& v = flat_.vertices[i];
      if (v.component == 0) continue;
      add(VtuCell::vertex, std::array{v.point}, tagger_.vertex(i));
      if (drawn[v.point]) continue;
      drawing_.points.push_back(v.point);
      drawing_.around_points.push_back(v.region);
    }
  }

  void add_edges() {
    for (Index i = 0; i < flat_.edges.size(); ++i) {
      const auto& e = flat_.edges[i];
      if (e.component == 0) continue;
      FlatComplex::Loop points = e.points;
      if (e.closed) points.push_back(points[0]);
      const CellTags tags = tagger_.edge(i);
      for (std::size_t k = 1; k < points.size(); ++k) {
        add(VtuCell::line, std::array{points[k - 1], points[k]}, tags);
        if (!e.wire) continue;
        drawing_.segments.push_back({points[k - 1], points[k]});
        drawing_.around_segments.push_back(e.region);
      }
    }
  }

  void add_faces() {
    for (Index i = 0; i < flat_.faces.size(); ++i) {
      const auto& f = flat_.faces[i];
      drawing_.triangles.insert(drawing_.triangles.end(), f.triangles.begin(), f.triangles.end());
      drawing_.sides.insert(drawing_.sides.end(), f.triangles.size(), f.regions);
      if (f.component == 0) continue;
      const CellTags tags = tagger_.face(i);
      for (std::size_t k = 0; k < f.triangles.size(); ++k) add(VtuCell::triangle, triangle(i, k), tags, patch(i));
    }
  }

  void add_regions() {
    for (Index i = 0; i < flat_.regions.size(); ++i) {
      const auto& r = flat_.regions[i];
      if (r.component == 0) continue;
      const CellTags tags = tagger_.region(i);
      for (const auto& shell : r.shells) {
        for (const Index side : shell) {
          const Index face = side >> 1;
          for (std::size_t k = 0; k < flat_.faces[face].triangles.size(); ++k) {
            auto t = triangle(face, k);
            if ((side & 1) == 0) std::swap(t[1], t[2]);
            add(VtuCell::triangle, t, tags, patch(face));
          }
        }
      }
    }
  }
};

}  // namespace

FileText vtu_text(const ResultView& view) { return VtuWriter(view).run(); }

}  // namespace cnrg
