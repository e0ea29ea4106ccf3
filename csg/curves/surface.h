// The true surfaces and curves of a leaf, which its facets and wires stand for.
//
// Everything else in this program computes with facets, exactly. But people mean the surface: whether two
// cylinders cross or touch is a question to the cylinders, and a mesh whose nodes lie on them needs their points.
// So a leaf offers S(u, v) of each curved patch and C(t) of each curve, in the parameters that its facets have
// (csg/leaves/parameters.h), and in two ways. As doubles a point is good for drawing, meshing, Newton's method.
// Over a box of parameters everything is an interval that holds all values there, all errors of rounding included:
// what follows from it is proven. To evaluate at some points instead and to conclude from them is the obvious way,
// and wrong between the points.
//
// Normals. `normal` is S_u x S_v up to a positive factor, for its direction is all that matters, and the factor
// (the radius of a parallel, the cube of a weight) would only make the box wider, and be 0 where a patch shrinks
// to a point. There the limits along the lines of parameters are meant: at a pole of a sphere one normal, at the
// apex of a cone those of all its rulings. A net has none at its pole: boxes that hold it hold the zero vector,
// from which nothing can be concluded.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "csg/geometry/cad_surfaces.h"
#include "csg/geometry/transform.h"
#include "kernel/exact/enclosure.h"

namespace cnrg {

using enclosure::Interval;

template <class Number>
using Vector3 = std::array<Number, 3>;

/// Of doubles: values at a point; of intervals: what holds them all over a box.
template <class Number>
struct SurfaceJet {
  Vector3<Number> point, along_u, along_v, normal;
  /// S_u and S_v up to positive factors, their limits at a pole where these are known.
  Vector3<Number> way_u = along_u, way_v = along_v;
};
/// Second derivatives.
struct SurfaceBend {
  Vector3<Interval> uu, uv, vv;
};
template <class Number>
struct CurveJet {
  Vector3<Number> point, along;
};

/// Of a surface of revolution, nearly: a point of its axis, the axis' direction of length 1, and the parameter
/// that is its angle, of so many turns from 0 to 1.
struct Revolution {
  Vector3<double> center, axis;
  std::size_t around = 0;
  double turns = 1;
};

/// One curved patch, before the leaf's transform.
class Surface {
 public:
  virtual ~Surface() = default;
  virtual SurfaceJet<double> at(double u, double v) const = 0;
  /// Who goes on with the intervals keeps an enclosure::RoundOutward alive meanwhile.
  virtual SurfaceJet<Interval> over(const Interval& u, const Interval& v) const = 0;
  /// The same of second derivatives; nothing where they are not known.
  virtual std::optional<SurfaceBend> bend_over(const Interval& /*u*/, const Interval& /*v*/) const {
    return std::nullopt;
  }
  /// Where a surface is one point at a value `pole` of a parameter: its derivative by the other one, `around`,
  /// divided by the difference of the first one from there. Nothing where that is not known.
  virtual std::optional<Vector3<Interval>> fan_over(std::size_t /*around*/, double /*pole*/, const Interval& /*u*/,
                                                    const Interval& /*v*/) const {
    return std::nullopt;
  }
  /// Nothing if it is none of revolution.
  virtual std::optional<Revolution> revolution() const { return std::nullopt; }
};

class Curve {
 public:
  virtual ~Curve() = default;
  virtual CurveJet<double> at(double t) const = 0;
  virtual CurveJet<Interval> over(const Interval& t) const = 0;
};

/// What carries a patch, by the names and in the numbers of CAD programs, for who writes it down there: S(u, v) is
/// the point of `surface` at its own parameters, where `placed` put that. Parameters correspond closely, not
/// exactly: they are where a search begins.
struct SurfaceForm {
  CadSurface surface;
  Transform placed{};
  bool swapped = false;                         ///< the first parameter of `surface` is that of v
  std::array<double, 2> zero{0, 0}, one{1, 1};  ///< of `surface`: at 0 and 1 of the patch
  std::array<double, 2> low{0, 0}, high{1, 1};  ///< of `surface`: what of it the patch has
};
/// The same of a curve, whose parameters are equal to those of `curve`.
struct CurveForm {
  CadCurve curve;
  Transform placed{};
};

/// Those of one leaf.
class LeafSurfaces {
 public:
  void add_patch(std::uint32_t patch, std::shared_ptr<const Surface> surface) {
    patches_[patch] = std::move(surface);
  }
  void add_curve(std::uint32_t curve, std::shared_ptr<const Curve> line) { curves_[curve] = std::move(line); }
  void add_form(std::uint32_t patch, SurfaceForm form) { forms_[patch] = std::move(form); }
  void add_form(std::uint32_t curve, CurveForm form) { curve_forms_[curve] = std::move(form); }
  const std::map<std::uint32_t, SurfaceForm>& forms() const { return forms_; }
  const std::map<std::uint32_t, CurveForm>& curve_forms() const { return curve_forms_; }
  const std::map<std::uint32_t, std::shared_ptr<const Surface>>& patches() const { return patches_; }
  /// Says that it has curved patches of which nothing else is known.
  void add_unknown() { has_unknown_ = true; }
  /// False if of a curved patch there is no Surface.
  bool complete() const {
    return !has_unknown_ && std::all_of(forms_.begin(), forms_.end(), [&](const auto& form) {
      return form.second.surface.kind == CadSurface::Kind::plane || patch(form.first) != nullptr;
    });
  }
  const std::map<std::uint32_t, std::shared_ptr<const Curve>>& curves() const { return curves_; }
  /// By Soup::Face::patch; null for one that is flat.
  const Surface* patch(std::uint32_t patch) const {
    const auto it = patches_.find(patch);
    return it == patches_.end() ? nullptr : it->second.get();
  }
  /// By Soup::Wire::leaf_edge; null for one that is straight.
  const Curve* curve(std::uint32_t curve) const {
    const auto it = curves_.find(curve);
    return it == curves_.end() ? nullptr : it->second.get();
  }

 private:
  std::map<std::uint32_t, std::shared_ptr<const Surface>> patches_;
  std::map<std::uint32_t, std::shared_ptr<const Curve>> curves_;
  std::map<std::uint32_t, SurfaceForm> forms_;  // of patches, some without a Surface
  std::map<std::uint32_t, CurveForm> curve_forms_;
  bool has_unknown_ = false;
};

}  // namespace cnrg
