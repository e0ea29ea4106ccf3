// The true surfaces of bezier, bspline and coons, and of extrude: S = c + s(t) R(t) (p(u) - c) + t v.
//
// Of an extrusion S_u = s R p' and S_t = s' R q + s w R (n x q) + v with q = p - c, the unit vector n along v and
// w the twist in radians. R keeps v and commutes with products, so the normal is s R (p' x (s' q + s w n x q +
// v)).
#include "csg/curves/skin.h"
#include "csg/curves/surface_forms.h"
#include "csg/curves/surface_spline.h"
#include "csg/leaves/prepare_shapes.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

using namespace surface_math;

class SweptSurface final : public SurfaceByJet<SweptSurface> {
 public:
  /// `center` is in the plane of the profile where that is turned or scaled.
  SweptSurface(const ExtrudeShape& shape, const RationalPoint& center, const CurveNet& net)
      : profile_(curve_pieces(net, "extrude"), curve_spans(net)),
        center_(constants(center)),
        vector_(constants(shape.vector)),
        axis_(unit(shape.vector)),
        turns_(constant(Rational(shape.twist / 360))),
        growth_(constant(Rational(shape.scale - 1))),
        twisted_(shape.twist != 0),
        scaled_(shape.scale != 1) {}

 private:
  friend class SurfaceByJet<SweptSurface>;
  template <class N>
  SurfaceJet<N> jet(const N& u, const N& t) const {
    const CurveJet<N> p = profile_.jet(u);
    const Vector3<N> center = as<N>(center_), v = as<N>(vector_), n = as<N>(axis_);
    if (!twisted_ && !scaled_) return {sum(p.point, scaled(t, v)), p.along, v, cross(p.along, v)};
    const N size = N(1) + as<N>(growth_) * t, turns = as<N>(turns_) * t;
    const N c = twisted_ ? cosine(turns) : N(1), s = twisted_ ? sine(turns) : N(0);
    const auto turned = [&](const Vector3<N>& x) {
      if (!twisted_) return x;
      return sum(sum(scaled(c, x), scaled(s, cross(n, x))), scaled(N((N(1) - c) * dot(n, x)), n));
    };
    const Vector3<N> q = difference(p.point, center), spin = cross(n, q);
    const N speed = turn<N>() * as<N>(turns_) * size;
    const Vector3<N> across = sum(sum(scaled(as<N>(growth_), q), scaled(speed, spin)), v);  // R^-1 S_t
    const Vector3<N> along = turned(p.along), over = turned(across);
    return {sum(center, sum(scaled(size, turned(q)), scaled(t, v))),
            scaled(size, along),
            over,
            turned(cross(p.along, across)),
            along,
            over};
  }

  SplineCurve profile_;
  Vector3<Constant> center_, vector_, axis_;
  Constant turns_, growth_;
  bool twisted_, scaled_;
};

/// S(u, v) = p(u) + v q(u).
class RuledSurface final : public SurfaceByJet<RuledSurface> {
 public:
  RuledSurface(const BezierCurve& first, const BezierCurve& ways)
      : first_({first}, {{0, 1}}), ways_({ways}, {{0, 1}}) {}

 private:
  friend class SurfaceByJet<RuledSurface>;
  template <class N>
  SurfaceJet<N> jet(const N& u, const N& v) const {
    const CurveJet<N> p = first_.jet(u), q = ways_.jet(u);
    const Vector3<N> along = sum(p.along, scaled(v, q.along));
    return {sum(p.point, scaled(v, q.point)), along, q.point, cross(along, q.point)};
  }

  SplineCurve first_, ways_;
};

/// True if it is proven that a flat patch is nowhere folded.
bool keeps_front(const Surface& surface, const Vector3<Interval>& normal, const std::array<Interval, 2>& at,
                 int halved) {
  const SurfaceJet<Interval> jet = surface.over(at[0], at[1]);
  const Interval front = dot(cross(jet.way_u, jet.way_v), normal);  // also in a pole
  if (front.inf() > 0 || front.sup() < 0) return true;
  if (halved == 0) return false;
  const std::size_t k = halved % 2;
  std::array<Interval, 2> low = at, high = at;
  low[k] = Interval(at[k].inf(), enclosure::middle_of(at[k]));
  high[k] = Interval(enclosure::middle_of(at[k]), at[k].sup());
  return keeps_front(surface, normal, low, halved - 1) && keeps_front(surface, normal, high, halved - 1);
}

/// Of a flat patch facets are all that there is to know, but in a sheet of folds and of curves that are its rim.
void add_net(LeafSurfaces& surfaces, std::uint32_t number, const std::vector<BezierPatch>& pieces,
             const std::vector<std::array<Span, 2>>& spans, const PatchNet& net, bool sheet) {
  std::vector<RationalPoint> points;
  bool curved = false;
  for (const BezierPatch& piece : pieces) {
    std::ranges::copy(points_of(piece.net), std::back_inserter(points));
    for (std::size_t k = 0; k < 4; ++k) curved = curved || !runs_straight(points_of({piece.side(k).net}));
  }
  const auto normal = plane_normal(points);
  if (normal && !sheet) return;
  const auto surface = std::make_shared<const SplinePatch>(pieces, spans);
  const enclosure::RoundOutward outward;
  const auto unfolded = [&](const std::array<Span, 2>& span) {
    const auto whole = [](const Span& s) {
      return hull(surface_math::enclose(s[0]), surface_math::enclose(s[1]));
    };
    return keeps_front(*surface, as<Interval>(constants(*normal)), {whole(span[0]), whole(span[1])}, 8);
  };
  if (normal && !curved && std::ranges::all_of(spans, unfolded)) return;
  surfaces.add_patch(number, surface);
  if (!normal) surfaces.add_form(number, net_form(net));
}

/// What a segment of an extrusion sweeps.
void add_segment(LeafSurfaces& surfaces, std::uint32_t patch, const ExtrudeShape& shape,
                 const RationalPoint& center, const CurveNet& net) {
  const bool flat = shape.twist == 0 &&
                    (on_one_line(net.points) || (shape.scale == 1 && plane_normal(net.points, shape.vector)));
  if (flat && runs_straight(net.points)) return;
  surfaces.add_patch(patch, std::make_shared<const SweptSurface>(shape, center, net));
  if (flat) return;
  if (std::optional<SurfaceForm> form = extruded_form(shape, center, net))
    surfaces.add_form(patch, std::move(*form));
}

/// The extrusion of a curve that a patch is, if its second row is the first one moved.
std::optional<ExtrudeShape> translation_of(const BezierPatch& patch) {
  if (patch.net.size() != 2) return std::nullopt;
  ExtrudeShape shape{{{{{{}}}}, false}, project(patch.net[1][0]) - project(patch.net[0][0])};
  CurveNet& net = shape.profile.lines[0].segments[0];
  for (std::size_t i = 0; i < patch.net[0].size(); ++i) {
    const Homogeneous &from = patch.net[0][i], &to = patch.net[1][i];
    if (from[3] != to[3] || project(to) - project(from) != shape.vector) return std::nullopt;
    net.points.push_back(project(from));
    net.weights.push_back(from[3]);
  }
  return shape;
}

/// A patch of two rows of equal weights, which bounds the ways between them better than its net.
std::shared_ptr<const Surface> ruled(const BezierPatch& patch) {
  if (patch.net.size() != 2) return nullptr;
  const ControlRow &first = patch.net[0], &second = patch.net[1];
  BezierCurve ways;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i][3] != second[i][3]) return nullptr;
    ways.net.push_back(homogeneous(project(second[i]) - project(first[i]), first[i][3]));
  }
  return std::make_shared<const RuledSurface>(BezierCurve{first}, ways);
}

PatchNet net_of(const BezierPatch& patch) {
  PatchNet net;
  for (const ControlRow& row : patch.net) {
    net.points.emplace_back();
    net.weights.emplace_back();
    for (const Homogeneous& h : row) {
      net.points.back().push_back(project(h));
      net.weights.back().push_back(h[3]);
    }
  }
  return net;
}

}  // namespace

std::shared_ptr<const LeafSurfaces> true_surfaces(const BezierShape& shape) {
  auto surfaces = std::make_shared<LeafSurfaces>();
  std::uint32_t number = 0;
  for (const PatchNet& net : shape.patches)
    add_net(*surfaces, number++, patch_pieces(net, "bezier"), patch_spans(net), net, shape.fill == Fill::none);
  number = 0;
  for (const CurveNet& net : shape.curves) {
    surfaces->add_form(number, curve_form(net));
    surfaces->add_curve(number++,
                        std::make_shared<const SplineCurve>(curve_pieces(net, "bezier"), curve_spans(net)));
  }
  return surfaces;
}

std::shared_ptr<const LeafSurfaces> skin_surfaces(const NetForm& skin) {
  auto surfaces = std::make_shared<LeafSurfaces>();
  std::uint32_t number = 0;
  for (const NetForm::Patch& patch : skin.patches) {
    const NetPiece& piece = patch.pieces[0];
    if (const std::optional<ExtrudeShape> moved = translation_of(piece.patch)) {
      add_segment(*surfaces, number++, *moved, {0, 0, 0}, moved->profile.lines[0].segments[0]);
      continue;
    }
    add_net(*surfaces, number, {piece.patch}, {piece.span}, net_of(piece.patch), false);
    if (surfaces->forms().contains(number)) {
      if (std::shared_ptr<const Surface> lines = ruled(piece.patch)) surfaces->add_patch(number, std::move(lines));
    }
    ++number;
  }
  return surfaces;
}

std::shared_ptr<const LeafSurfaces> true_surfaces(const CoonsShape& shape) {
  auto surfaces = std::make_shared<LeafSurfaces>();
  std::uint32_t number = 0;
  for (const auto& round : shape.patches) {
    std::array<BezierCurve, 4> curves;
    for (std::size_t k = 0; k < 4; ++k) curves[k] = curve_pieces(round[k], "coons")[0];
    const BezierPatch patch = coons_patch(curves);
    add_net(*surfaces, number++, {patch}, {{{{0, 1}, {0, 1}}}}, net_of(patch), shape.fill == Fill::none);
  }
  return surfaces;
}

std::shared_ptr<const LeafSurfaces> true_surfaces(const ExtrudeShape& shape) {
  auto surfaces = std::make_shared<LeafSurfaces>();
  std::uint32_t number = shape.profile.closed ? 2 : 0;
  const RationalPoint center = axis_point(shape);
  for (const ProfileLine& line : shape.profile.lines) {
    for (const CurveNet& net : line.segments) add_segment(*surfaces, number++, shape, center, net);
  }
  return surfaces;
}

}  // namespace cnrg
