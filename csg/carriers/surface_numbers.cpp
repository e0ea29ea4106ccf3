// Equations and nets as keys; see the header.
#include "csg/carriers/surface_numbers.h"

#include <algorithm>
#include <optional>
#include <set>

#include "csg/carriers/axes.h"
#include "csg/carriers/bands.h"
#include "csg/carriers/extruded_arcs.h"
#include "csg/carriers/net_carriers.h"
#include "csg/carriers/placed_nets.h"
#include "csg/geometry/circle.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {

void divide_by_first(std::span<Rational> equation) {
  const auto it = std::ranges::find_if(equation, [](const Rational& x) { return x != 0; });
  if (it == equation.end() || *it == 1) return;
  const Rational first = *it;
  for (Rational& x : equation) x /= first;
}

namespace {

/// What kind of surface, then the numbers that it is.
enum SurfaceKind : int { kQuadric, kTorus, kTurned, kSwept, kNet };
using Key = std::vector<Rational>;

/// How lengths and planes of a leaf look where a transform put it.
struct Placed {
  explicit Placed(const Transform& transform) : transform(transform), back(transform.inverse()) {}
  /// The covector n of the leaf: n . x is the same number for the image of x.
  RationalPoint covector(const RationalPoint& n) const {
    RationalPoint result{0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) result = result + n[i] * back.linear[i];
    return result;
  }
  /// The square of the leaf's lengths: entries 00 01 02 11 12 22 of a symmetric matrix.
  std::array<Rational, 6> metric() const {
    std::array<RationalPoint, 3> columns;
    for (std::size_t i = 0; i < 3; ++i) columns[i] = {back.linear[0][i], back.linear[1][i], back.linear[2][i]};
    std::array<Rational, 6> result;
    std::size_t k = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = i; j < 3; ++j) result[k++] = dot(columns[i], columns[j]);
    }
    return result;
  }
  const Transform& transform;
  Transform back;
};

/// m(w) + h (a . w)^2 + 2 l (a . w) + k = 0 with w = x - center, by its coefficients as a polynomial in x; the
/// first one that is not zero becomes 1.
Key quadric(std::array<Rational, 6> m, const RationalPoint& a, const Rational& h, const Rational& l,
            const Rational& k, const RationalPoint& center) {
  if (h != 0) {
    std::size_t e = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = i; j < 3; ++j) m[e++] += h * a[i] * a[j];
    }
  }
  const auto times = [&](const RationalPoint& x) {
    return RationalPoint{m[0] * x[0] + m[1] * x[1] + m[2] * x[2], m[1] * x[0] + m[3] * x[1] + m[4] * x[2],
                         m[2] * x[0] + m[4] * x[1] + m[5] * x[2]};
  };
  const RationalPoint at_center = times(center), linear = l * a - at_center;
  Key key{kQuadric};
  key.insert(key.end(), m.begin(), m.end());
  key.insert(key.end(), linear.begin(), linear.end());
  key.push_back(dot(center, at_center) - 2 * l * dot(a, center) + k);
  divide_by_first(std::span(key).subspan(1));
  return key;
}

/// What a straight piece or an arc sweeps; `center` and `axis` are those of the leaf.
Key round_key(const MeridianPiece& piece, const RationalPoint& center, const RationalPoint& axis,
              const Placed& placed) {
  const Rational square = dot(axis, axis);
  if (piece.kind == MeridianPiece::Kind::line) {
    // |w|^2 - (n . w)^2 / n.n = r^2 with r = r0 + slope t and t = n . w / n.n.
    const Rational slope = (piece.to.r - piece.from.r) / (piece.to.t - piece.from.t),
                   r = piece.from.r - slope * piece.from.t;
    return quadric(placed.metric(), placed.covector(axis), -(1 + slope * slope / square) / square,
                   -r * slope / square, -r * r, placed.transform.apply(center));
  }
  const RationalPoint middle = placed.transform.apply(center + piece.middle.t * axis);
  if (piece.middle.r == 0) return quadric(placed.metric(), {0, 0, 0}, 0, 0, -piece.radius * piece.radius, middle);
  // The inner part of a torus that crosses its axis has the other sign of r.
  const std::array<Rational, 6> metric = placed.metric();
  const RationalPoint along = axis_line({0, 0, 0}, placed.transform.apply_to_vector(axis)).direction;
  Key key{kTorus, Rational(sgn(piece.middle.r))};
  key.insert(key.end(), along.begin(), along.end());
  key.insert(key.end(), middle.begin(), middle.end());
  for (const Rational& x : metric) key.push_back(x / metric[0]);
  key.push_back(piece.middle.r * piece.middle.r / metric[0]);
  key.push_back(piece.radius * piece.radius / metric[0]);
  return key;
}

/// Of a curve of degree 2 in a half-plane, the coefficients of r r, r t, t t, r, t and 1 in its equation.
std::optional<std::array<Rational, 6>> conic_of(const ControlRow& row) {
  if (row.size() != 3) return std::nullopt;
  std::array<RationalPoint, 3> p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = {row[i][0], row[i][2], row[i][3]};
  const RationalPoint a = cross(p[1], p[2]), b = cross(p[2], p[0]), c = cross(p[0], p[1]);
  if (dot(a, p[0]) == 0) return std::nullopt;
  const auto at = [&](std::size_t i, std::size_t j) -> Rational {  // b b = 4 a c
    return (i == j ? 1 : 2) * (b[i] * b[j] - 2 * (a[i] * c[j] + a[j] * c[i]));
  };
  std::array<Rational, 6> conic{at(0, 0), at(0, 1), at(1, 1), at(0, 2), at(1, 2), at(2, 2)};
  divide_by_first(conic);
  return conic;
}

class Numbers {
 public:
  void add_equations(SurfaceEquations& out) const {
    for (const auto& [keys, number] : known_) {
      const Key& key = *keys.begin();
      if (keys.size() != 1) continue;
      if (key[0] == kTorus) {
        if (const auto torus = torus_of(key)) out.tori[number] = *torus;
      }
      if (key[0] != kQuadric) continue;
      Quadric& q = out.quadrics[number];
      std::size_t next = 1;
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = i; j < 3; ++j) q[i][j] = q[j][i] = key[next++];
      }
      for (std::size_t i = 0; i < 3; ++i) q[i][3] = q[3][i] = key[next++];
      q[3][3] = key[next];
    }
  }

  std::vector<std::uint32_t> of(const LeafInstance& instance) {
    keys_.clear();
    unknown_.clear();
    const CurvedForm* const form = instance.leaf->form().get();
    if (const auto* revolved = dynamic_cast<const RevolvedForm*>(form)) {
      add(*revolved, instance.transform, nullptr);
    } else if (const auto* banded = dynamic_cast<const BandedForm*>(form)) {
      if (!banded->obstacle.empty()) return {};
      for (const Band& band : banded->bands) add(band.form, instance.transform, &band.face);
    } else if (PlacedNets::has_nets(instance)) {
      add_nets(instance);
    }
    std::vector<std::uint32_t> numbers(keys_.empty() ? 0 : keys_.rbegin()->first + 1);
    for (const auto& [patch, keys] : keys_) {
      if (unknown_.contains(patch)) continue;
      const auto [it, fresh] = known_.try_emplace(keys, known_.size() + 1);
      numbers[patch] = it->second;
    }
    return numbers;
  }

 private:
  static std::optional<Torus> torus_of(const Key& key) {
    const auto point = [&](std::size_t i) { return RationalPoint{key[i], key[i + 1], key[i + 2]}; };
    const auto radius = rational_root(key[14]), tube = rational_root(key[15]);
    const bool round = point(8) == RationalPoint{1, 0, 0} && point(11) == RationalPoint{1, 0, 1};
    if (key[1] <= 0 || !round || !radius || !tube || *radius <= *tube) return std::nullopt;
    return Torus{point(5), point(2), *radius, *tube};
  }

  void add(const RevolvedForm& form, const Transform& transform, const std::uint32_t* patch) {
    const Placed placed(transform);
    std::optional<PlacedForm> meridians;
    for (std::size_t l = 0; l < form.lines.size(); ++l) {
      for (std::size_t k = 0; k < form.lines[l].size(); ++k) {
        const MeridianPiece& piece = form.lines[l][k];
        const std::uint32_t number = patch != nullptr ? *patch : piece.patch;
        if (piece.kind == MeridianPiece::Kind::line && piece.from.r == 0 && piece.to.r == 0) continue;  // the axis
        if (piece.flat()) {
          unknown_.insert(number);
          continue;
        }
        if (piece.kind != MeridianPiece::Kind::net) {
          keys_[number].insert(round_key(piece, form.center, form.axis, placed));
          continue;
        }
        // An ellipse about the axis turns to a quadric. So do hyperbolas, but contacts want convex ones.
        const auto own = conic_of(reduced(piece.net.net));
        if (own && (*own)[0] * (*own)[2] > 0 && (*own)[1] == 0 && (*own)[3] == 0) {
          const Rational square = dot(form.axis, form.axis);
          keys_[number].insert(quadric(placed.metric(), placed.covector(form.axis),
                                       ((*own)[2] / square - 1) / square, (*own)[4] / (2 * square), (*own)[5],
                                       transform.apply(form.center)));
          continue;
        }
        if (!meridians) {
          const std::optional<Rational> scale = stretch(transform);
          if (!scale) {  // polynomials of such leaves are not compared
            unknown_.insert(number);
            continue;
          }
          meridians = place(form, transform, *scale);
        }
        const AxisLine& axis = meridians->axis;
        const ControlRow net = reduced(meridians->lines[l][k].net.net);
        Key key{kTurned};
        if (const auto conic = conic_of(net)) key.insert(key.end(), conic->begin(), conic->end());
        else if (const auto on = meridians_[axis].place(net)) key.emplace_back(on->carrier);
        if (key.size() == 1) {
          unknown_.insert(number);
          continue;
        }
        key.insert(key.end(), axis.direction.begin(), axis.direction.end());
        key.insert(key.end(), axis.foot.begin(), axis.foot.end());
        keys_[number].insert(std::move(key));
      }
    }
  }

  void add_nets(const LeafInstance& instance) {
    PlacedNets nets(instance, {}, 0);
    nets.place();
    std::set<std::pair<std::size_t, std::size_t>> round;  // segments and pieces that are arcs
    if (const auto* extrusion = dynamic_cast<const ExtrudeForm*>(instance.leaf->form().get())) {
      const std::uint32_t first = extrusion->shape.profile.closed ? 2 : 0;
      const Placed placed(instance.transform);
      for (const ExtrudedArc& arc : arcs_of(*extrusion, {})) {
        const AxisLine& axis = arc.placed.axis;
        keys_[first + arc.segment].insert(round_key(arc.placed.lines[0][0], axis.foot, axis.direction, placed));
        round.insert({arc.segment, arc.piece});
      }
      std::size_t piece = 0;
      for (std::size_t i = 0; i < nets.curves.size(); ++i) {
        const PlacedCurve& curve = nets.curves[i];
        piece = i > 0 && nets.curves[i - 1].number == curve.number ? piece + 1 : 0;
        if (!round.contains({curve.number, piece}))
          add_swept(first + std::uint32_t(curve.number), curve.net, *nets.sweep());
      }
    }
    for (const PlacedPiece& piece : nets.pieces) {
      const auto number = static_cast<std::uint32_t>(piece.number);
      if (plane_normal(points_of(piece.patch.net))) {
        unknown_.insert(number);
        continue;
      }
      std::optional<Sweep> sweep = sweep_of(piece.patch);
      const BezierPatch turned = transposed(piece.patch);
      const BezierPatch& way = sweep ? piece.patch : turned;
      if (!sweep) sweep = sweep_of(turned);
      if (sweep) {
        add_swept(number, way.net[0], *sweep);
      } else if (const auto on = surfaces_.place(piece.patch)) {
        keys_[number].insert({kNet, Rational(on->carrier)});
      } else {
        unknown_.insert(number);
      }
    }
  }

  void add_swept(std::uint32_t patch, const ControlRow& net, const Sweep& sweep) {
    const ControlRow across = reduced(sweep.projected(net));
    const auto on = on_one_line(points_of({across})) ? std::nullopt : swept_.place(across, sweep.direction);
    if (on) keys_[patch].insert({kSwept, Rational(on->carrier)});
    else unknown_.insert(patch);
  }

  std::map<std::uint32_t, std::set<Key>> keys_;  // of the instance, by patch
  std::set<std::uint32_t> unknown_;              // patches that are flat, or lie on something else, too
  std::map<std::set<Key>, std::uint32_t> known_;
  std::map<AxisLine, CurveCarriers> meridians_;
  CurveCarriers swept_;
  SurfaceCarriers surfaces_;
};

}  // namespace

std::vector<std::vector<std::uint32_t>> surface_numbers(const std::vector<LeafInstance>& instances,
                                                        SurfaceEquations* equations) {
  Numbers numbers;
  std::vector<std::vector<std::uint32_t>> result;
  for (const LeafInstance& instance : instances) {
    if (instance.leaf->form() != nullptr && instance.transform->determinant() != 0)
      result.push_back(numbers.of(instance));
    else result.emplace_back();
  }
  if (equations != nullptr) numbers.add_equations(*equations);
  return result;
}

}  // namespace cnrg
