// Bézier, B-spline and Coons patches as surfaces or solids, and curves as wires.
//
// All become Bézier pieces. The pieces of one patch of the tree share its number, the wires of one curve the
// curve's; so people see the patches and curves that were given.
#include <algorithm>
#include <map>
#include <utility>

#include "csg/curves/control_nets.h"
#include "csg/curves/patch_mesh.h"
#include "csg/geometry/exact_vectors.h"
#include "csg/leaves/geometry_leaf.h"
#include "csg/leaves/prepare_shapes.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

class ParametricLeaf {
 public:
  ParametricLeaf(const char* shape, const Tessellation& tessellation, Fill fill, LeafParameters* record)
      : fineness_(shape, tessellation), boundary_(fineness_), fill_(fill), builder_(fill), record_(record) {}

  /// `spans`: of the pieces, along u and v.
  void add_patch(const std::vector<BezierPatch>& pieces, const std::vector<std::array<Span, 2>>& spans,
                 std::uint32_t number, const std::string& name) {
    for (const BezierPatch& piece : pieces) {
      constexpr const char* kSides[] = {"v = 0", "u = 1", "v = 1", "u = 0"};
      for (std::size_t k = 0; k < 4; ++k)
        boundary_.use(piece.side(k), std::string("side ") + kSides[k] + " of " + name);
    }
    pieces_.insert(pieces_.end(), pieces.begin(), pieces.end());
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const PatchMesh mesh = mesh_patch(pieces[k], fineness_, boundary_);
      for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& t = mesh.triangles[i];
        const RationalPoint &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
        if (collinear(a, b, c)) continue;
        facets_.push_back({point(a), point(b), point(c), number});
        volumes_.push_back(dot(a, cross(b, c)));
        if (record_ != nullptr) record_cell(cell_of(mesh, i, pieces[k]), spans[k]);
      }
    }
    if (record_ != nullptr) record_->name_patch(number, label(name));
    if (facets_.empty() || facets_.back().number != number) {
      throw InputError(fineness_.shape() + ": " + name + " has no area: move its control points apart");
    }
  }

  void add_curve(const std::vector<BezierCurve>& pieces, const std::vector<Span>& spans, std::uint32_t number,
                 const std::string& name) {
    bool any = false;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const int n = boundary_.steps(pieces[k]);
      PointId last = point(pieces[k].at(0));
      Rational from = spans[k][0];
      for (int i = 1; i <= n; ++i) {
        const Rational t = fraction(i, n), to = in_span(spans[k], t);
        const PointId next = point(pieces[k].at(t));
        if (next == last) continue;
        builder_.soup().add_wire(builder_.leaf(), last, next, number);
        if (record_ != nullptr) record_->add_wire({{builder_.value(last), builder_.value(next)}, {from, to}});
        last = next;
        from = to;
        any = true;
      }
    }
    if (record_ != nullptr) record_->name_curve(number, label(name));
    if (!any) throw InputError(fineness_.shape() + ": " + name + " is one point: give it as `points`");
  }

  std::unique_ptr<PreparedLeaf> finish() {
    if (fill_ != Fill::none && facets_.empty()) {
      throw InputError(fineness_.shape() + ": fill is given, but there are no patches: leave it out");
    }
    boundary_.check_closed(fill_);
    // Of a solid whose patches all face inward the facets are turned round.
    const bool turn = fill_ == Fill::winding && sum(std::move(volumes_)) < 0;
    for (const Facet& f : facets_) builder_.triangle(f.a, turn ? f.c : f.b, turn ? f.b : f.c, f.number);
    add_corners();
    return builder_.finish();
  }

 private:
  struct Facet {
    PointId a, b, c;
    std::uint32_t number;
  };

  /// Corners of sheets: where two sides meet that no other patch has. Of the two, one may be a single point.
  void add_corners() {
    for (const BezierPatch& piece : pieces_) {
      for (std::size_t k = 0; k < 4; ++k) {
        const BezierCurve side = piece.side(k);
        if (std::max(boundary_.uses(side), boundary_.uses(piece.side((k + 3) % 4))) != 1) continue;
        const auto at = ids_.find(side.at(0));  // without facets there it is no corner of the sheet
        if (at != ids_.end()) builder_.soup().add_curve_end(builder_.leaf(), at->second);
      }
    }
  }

  /// "the patch" becomes "bezier patch", "patch 2" becomes "bezier patch 2".
  std::string label(const std::string& name) const {
    return fineness_.shape() + " " + (name.starts_with("the ") ? name.substr(4) : name);
  }

  void record_cell(std::vector<PatchCorner> cell, const std::array<Span, 2>& span) {
    for (PatchCorner& corner : cell) {
      for (std::size_t d = 0; d < 2; ++d) corner.at[d] = in_span(span[d], corner.at[d]);
    }
    record_->add_facet(cell);
  }

  PointId point(const RationalPoint& p) {
    const auto [it, is_new] = ids_.try_emplace(p);
    if (is_new) it->second = builder_.point(p);
    return it->second;
  }

  Fineness fineness_;
  BoundaryCurves boundary_;
  Fill fill_;
  LeafBuilder builder_;  // of the geometry alone
  LeafParameters* record_;
  std::map<RationalPoint, PointId> ids_;
  std::vector<BezierPatch> pieces_;
  std::vector<Facet> facets_;
  std::vector<Rational> volumes_;  // six times, of the facets' tetrahedra with the origin
};

std::string name_of(const char* kind, std::size_t index, std::size_t count) {
  return count == 1 ? std::string("the ") + kind : std::string(kind) + " " + std::to_string(index + 1);
}

}  // namespace

std::unique_ptr<PreparedLeaf> prepare_bezier(const BezierShape& shape, LeafParameters* record) {
  const char* name = shape.is_spline ? "bspline" : "bezier";
  const std::string prefix = std::string(name) + ": ";
  if (shape.patches.empty() && shape.curves.empty())
    throw InputError(prefix + "it has no patches or curves: give one");
  ParametricLeaf leaf(name, shape.tessellation, shape.fill, record);
  for (std::size_t i = 0; i < shape.patches.size(); ++i) {
    const std::string patch = name_of("patch", i, shape.patches.size());
    const std::vector<BezierPatch> pieces = patch_pieces(shape.patches[i], prefix + patch);
    leaf.add_patch(pieces, patch_spans(shape.patches[i]), static_cast<std::uint32_t>(i), patch);
  }
  for (std::size_t i = 0; i < shape.curves.size(); ++i) {
    const std::string curve = name_of("curve", i, shape.curves.size());
    const std::vector<BezierCurve> pieces = curve_pieces(shape.curves[i], prefix + curve);
    leaf.add_curve(pieces, curve_spans(shape.curves[i]), static_cast<std::uint32_t>(i), curve);
  }
  return leaf.finish();
}

std::unique_ptr<PreparedLeaf> prepare_coons(const CoonsShape& shape, LeafParameters* record) {
  if (shape.patches.empty()) throw InputError("coons: it has no patches: give one");
  ParametricLeaf leaf("coons", shape.tessellation, shape.fill, record);
  for (std::size_t i = 0; i < shape.patches.size(); ++i) {
    const std::string patch = name_of("patch", i, shape.patches.size());
    std::array<BezierCurve, 4> round;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::string curve = "coons: curve " + std::to_string(k + 1) + " of " + patch;
      if (shape.patches[i][k].degree != 0) throw InputError(curve + " is a B-spline: give its Bézier pieces");
      round[k] = curve_pieces(shape.patches[i][k], curve)[0];
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const RationalPoint end = shape.patches[i][k].points.back(), next = shape.patches[i][(k + 1) % 4].points[0];
      if (end == next) continue;
      throw InputError("coons: curve " + std::to_string(k + 1) + " of " + patch + " ends in " + describe(end) +
                       ", but the next one begins in " + describe(next) + ": let the four curves go round");
    }
    leaf.add_patch({coons_patch(round)}, {{{{0, 1}, {0, 1}}}}, static_cast<std::uint32_t>(i), patch);
  }
  return leaf.finish();
}

}  // namespace cnrg
