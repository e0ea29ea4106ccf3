// Bézier, B-spline and Coons patches as surfaces or solids, and curves as wires; see the header.
#include "csg/curves/parametric.h"

#include <algorithm>
#include <map>
#include <utility>

#include "csg/geometry/planar_polygon.h"
#include "csg/leaves/geometry_leaf.h"
#include "csg/leaves/prepare_shapes.h"
#include "kernel/base/error.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

class ParametricLeaf {
 public:
  ParametricLeaf(const NetForm& form, const CommonNets* common, LeafParameters* record)
      : form_(form),
        common_(common),
        boundary_(form.fineness, common == nullptr ? nullptr : common->steps.get()),
        builder_(form.fill, nullptr, true),
        record_(record) {}

  std::unique_ptr<PreparedLeaf> run() {
    for (std::size_t i = 0; i < form_.patches.size(); ++i) add_patch(i);
    for (std::size_t i = 0; i < form_.curves.size(); ++i) add_curve(i);
    for (const NetForm::Flat& flat : form_.flats) add_flat(flat);
    if (form_.fill != Fill::none && facets_.empty() && flats_.empty()) {
      throw InputError(shape() + ": fill is given, but there are no patches: leave it out");
    }
    boundary_.check_closed(form_.fill);
    // Of a solid whose patches all face inward the facets are turned round. The front of a surface is that of its
    // patches as they were given: a reflection, which takes S_u x S_v to the other side, does not change it.
    bool turn = common_ != nullptr && common_->transform.determinant() < 0;
    if (form_.fill == Fill::winding) {
      const Rational volume = sum(std::move(volumes_));
      if (volume != 0) turn = volume < 0;
    }
    for (const Facet& f : facets_) builder_.triangle(f.a, turn ? f.c : f.b, turn ? f.b : f.c, f.number);
    place_flats(turn);
    add_corners();
    return builder_.finish();
  }

 private:
  struct Facet {
    PointId a, b, c;
    std::uint32_t number;
  };

  const std::string& shape() const { return form_.fineness.shape(); }

  void add_patch(std::size_t i) {
    const NetForm::Patch& patch = form_.patches[i];
    const auto number = static_cast<std::uint32_t>(i);
    for (const NetPiece& piece : patch.pieces) {
      constexpr const char* kSides[] = {"v = 0", "u = 1", "v = 1", "u = 0"};
      for (std::size_t k = 0; k < 4; ++k)
        boundary_.use(piece.patch.side(k), std::string("side ") + kSides[k] + " of " + patch.name);
    }
    if (common_ == nullptr) {
      for (const NetPiece& piece : patch.pieces) add_piece(piece, form_.fineness, {}, number);
    } else {
      for (const CommonNets::Piece& piece : common_->patches[i])
        add_piece(piece.net, piece.fineness, piece.lines, number);
    }
    if (record_ != nullptr) record_->name_patch(number, label(patch.name));
    if (facets_.empty() || facets_.back().number != number) {
      throw InputError(shape() + ": " + patch.name + " has no area: move its control points apart");
    }
  }

  void add_piece(const NetPiece& piece, const Fineness& fineness, const PatchLines& lines, std::uint32_t number) {
    const PatchMesh mesh = mesh_patch(piece.patch, fineness, boundary_, lines);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const auto& t = mesh.triangles[i];
      const RationalPoint &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
      if (collinear(a, b, c)) continue;
      facets_.push_back({point(a), point(b), point(c), number});
      volumes_.push_back(dot(a, cross(b, c)));
      if (record_ != nullptr) record_cell(cell_of(mesh, i, piece.patch), piece.span);
    }
  }

  void add_flat(const NetForm::Flat& flat) {
    const auto use = [&](BezierCurve side) {
      if (flat.turned) std::reverse(side.net.begin(), side.net.end());
      boundary_.use(side, flat.name);
    };
    auto& loops = flats_.emplace_back();
    for (const auto& sides : flat.loops) {
      std::vector<RationalPoint>& loop = loops.emplace_back();
      for (std::size_t i = 0; i < sides.size(); ++i) {
        const NetForm::Flat::Side& side = sides[i];
        loop.push_back(placed(side.corner));
        if (side.patch) {
          use(rim(*side.patch, side.last_row));
          append_inside(loop, *side.patch, side.last_row);
        } else {
          const RationalPoint& next = sides[(i + 1) % sides.size()].corner;
          use({{homogeneous(side.corner), homogeneous(next)}});
        }
      }
      if (flat.turned) std::reverse(loop.begin(), loop.end());
      for (std::size_t i = 1; i + 1 < loop.size(); ++i)
        volumes_.push_back(dot(loop[0], cross(loop[i], loop[i + 1])));
    }
    check_polygon(loops, {.polygon = "the face `" + label(flat.name) + "`"});
  }

  void place_flats(bool turn) {
    auto number = static_cast<std::uint32_t>(form_.patches.size());
    for (std::size_t i = 0; i < flats_.size(); ++i, ++number) {
      std::vector<std::vector<PointId>> face;
      for (const auto& loop : flats_[i]) {
        auto& ids = face.emplace_back();
        for (const RationalPoint& p : loop) ids.push_back(point(p));
        if (turn) std::reverse(ids.begin(), ids.end());
      }
      builder_.face(face, number);
      if (record_ == nullptr) continue;
      record_->name_patch(number, label(form_.flats[i].name));
      record_->add_flat_facet();
    }
  }

  RationalPoint placed(const RationalPoint& p) const {
    return common_ == nullptr ? p : common_->transform.apply(p);
  }

  BezierCurve rim(std::size_t patch, bool last_row) const {
    const BezierPatch& net = form_.patches[patch].pieces[0].patch;
    return {last_row ? net.net.back() : net.net.front()};
  }

  /// The points between the ends of the first or last row of a patch of one piece, which others may have cut.
  void append_inside(std::vector<RationalPoint>& loop, std::size_t patch, bool last_row) {
    std::map<Rational, BezierCurve> parts;  // by where they begin
    if (common_ == nullptr) {
      parts.emplace(0, rim(patch, last_row));
    } else {
      for (const CommonNets::Piece& piece : common_->patches[patch]) {
        if (piece.net.span[1][last_row ? 1 : 0] != (last_row ? 1 : 0)) continue;
        parts.emplace(piece.net.span[0][0],
                      BezierCurve{last_row ? piece.net.patch.net.back() : piece.net.patch.net.front()});
      }
    }
    for (auto part = parts.begin(); part != parts.end(); ++part) {
      if (part != parts.begin()) loop.push_back(part->second.at(0));
      for (const Rational& t : boundary_.inside(part->second)) loop.push_back(part->second.at(t));
    }
  }

  void add_curve(std::size_t i) {
    const NetForm::Curve& curve = form_.curves[i];
    const auto number = static_cast<std::uint32_t>(i);
    bool any = false;
    for (const CurvePiece& piece : common_ == nullptr ? curve.pieces : common_->curves[i]) {
      std::vector<Rational> steps = boundary_.inside(piece.curve);
      steps.push_back(1);
      PointId last = point(piece.curve.at(0));
      Rational from = piece.span[0];
      for (const Rational& t : steps) {
        const Rational to = in_span(piece.span, t);
        const PointId next = point(piece.curve.at(t));
        if (next == last) continue;
        builder_.soup().add_wire(builder_.leaf(), last, next, number);
        if (record_ != nullptr) record_->add_wire({{builder_.value(last), builder_.value(next)}, {from, to}});
        last = next;
        from = to;
        any = true;
      }
    }
    if (record_ != nullptr) record_->name_curve(number, label(curve.name));
    if (!any) throw InputError(shape() + ": " + curve.name + " is one point: give it as `points`");
  }

  /// Corners of sheets: where two sides meet that no other patch has; and sides that are one point. They are
  /// corners of what was given: where pieces are cut further, no corner comes about.
  void add_corners() {
    for (const NetForm::Patch& patch : form_.patches) {
      for (const NetPiece& piece : patch.pieces) {
        for (std::size_t k = 0; k < 4; ++k) {
          const BezierCurve side = piece.patch.side(k);
          if (!side.is_point() &&
              std::max(boundary_.uses(side), boundary_.uses(piece.patch.side((k + 3) % 4))) != 1)
            continue;
          const RationalPoint corner = side.at(0);
          const auto at = ids_.find(common_ == nullptr ? corner : common_->transform.apply(corner));
          // Without facets there it is no corner of the sheet.
          if (at != ids_.end()) builder_.soup().add_curve_end(builder_.leaf(), at->second);
        }
      }
    }
  }

  /// "the patch" becomes "bezier patch", "patch 2" becomes "bezier patch 2".
  std::string label(const std::string& name) const {
    return shape() + " " + (name.starts_with("the ") ? name.substr(4) : name);
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

  const NetForm& form_;
  const CommonNets* common_;
  BoundaryCurves boundary_;
  LeafBuilder builder_;  // of the geometry alone
  LeafParameters* record_;
  std::map<RationalPoint, PointId> ids_;
  std::vector<Facet> facets_;
  std::vector<std::vector<std::vector<RationalPoint>>> flats_;  // loops of each
  std::vector<Rational> volumes_;  // six times, of the tetrahedra of facets and flats with the origin
};

std::string name_of(const char* kind, std::size_t index, std::size_t count) {
  return count == 1 ? std::string("the ") + kind : std::string(kind) + " " + std::to_string(index + 1);
}

template <class Shape>
std::unique_ptr<PreparedLeaf> prepare_nets(const Shape& shape, LeafParameters* record) {
  std::shared_ptr<const NetForm> form = net_form(shape);
  std::unique_ptr<PreparedLeaf> leaf = tessellate(*form, nullptr, record);
  leaf->set_form(std::move(form));
  return leaf;
}

}  // namespace

std::unique_ptr<PreparedLeaf> tessellate(const NetForm& form, const CommonNets* common, LeafParameters* record) {
  return ParametricLeaf(form, common, record).run();
}

std::shared_ptr<const NetForm> net_form(const BezierShape& shape) {
  const char* name = shape.is_spline ? "bspline" : "bezier";
  const std::string prefix = std::string(name) + ": ";
  if (shape.patches.empty() && shape.curves.empty())
    throw InputError(prefix + "it has no patches or curves: give one");
  auto form = std::make_shared<NetForm>(name, shape.tessellation, shape.fill);
  const auto take = [&](const char* word, const auto& nets, const auto& pieces_of, const auto& spans_of,
                        auto& out) {
    for (std::size_t i = 0; i < nets.size(); ++i) {
      auto& to = out.emplace_back();
      to.name = name_of(word, i, nets.size());
      auto pieces = pieces_of(nets[i], prefix + to.name);
      const auto spans = spans_of(nets[i]);
      for (std::size_t k = 0; k < pieces.size(); ++k) to.pieces.push_back({std::move(pieces[k]), spans[k]});
    }
  };
  take("patch", shape.patches, patch_pieces, patch_spans, form->patches);
  take("curve", shape.curves, curve_pieces, curve_spans, form->curves);
  return form;
}

std::shared_ptr<const NetForm> net_form(const CoonsShape& shape) {
  if (shape.patches.empty()) throw InputError("coons: it has no patches: give one");
  auto form = std::make_shared<NetForm>("coons", shape.tessellation, shape.fill);
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
    form->patches.push_back({patch, {{coons_patch(round), {{{0, 1}, {0, 1}}}}}});
  }
  return form;
}

std::unique_ptr<PreparedLeaf> prepare_leaf(const BezierShape& shape, LeafParameters* record) {
  return prepare_nets(shape, record);
}

std::unique_ptr<PreparedLeaf> prepare_leaf(const CoonsShape& shape, LeafParameters* record) {
  return prepare_nets(shape, record);
}

}  // namespace cnrg
