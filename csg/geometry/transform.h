// Exact affine maps: the transforms of a tree.
#pragma once

#include <array>
#include <memory>

#include "kernel/exact/rational.h"

namespace cnrg {

/// An exact affine map: p -> A p + b.
struct Transform {
  std::array<std::array<Rational, 3>, 3> linear{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  RationalPoint offset{0, 0, 0};
  static Transform translation(const RationalPoint& by);
  static Transform scaling(const RationalPoint& factors);  ///< no factor is zero
  /// By `degrees` about an axis through `center`: multiples of 90 degrees about a coordinate axis are exact;
  /// else a rational rotation, exactly orthogonal, whose angle is off by less than 1e-15.
  static Transform rotation(const RationalPoint& axis, const Rational& degrees, const RationalPoint& center);
  /// The plane through `point` with `normal` as mirror.
  static Transform reflection(const RationalPoint& normal, const RationalPoint& point);
  bool identity() const;
  Rational determinant() const;
  Transform inverse() const;
  RationalPoint apply(const RationalPoint& p) const;
  /// A v: of a vector, which has no place.
  RationalPoint apply_to_vector(const RationalPoint& v) const;
  /// First `inner`, then this.
  Transform operator*(const Transform& inner) const;
  friend bool operator==(const Transform&, const Transform&) = default;
};

/// A transform that its copies share, since it is a thousand bytes long: the identity, if not said otherwise.
class SharedTransform {
 public:
  SharedTransform() = default;
  SharedTransform(Transform transform) : shared_(std::make_shared<const Transform>(std::move(transform))) {}
  SharedTransform(std::shared_ptr<const Transform> shared) : shared_(std::move(shared)) {}
  operator const Transform&() const { return **this; }
  const Transform& operator*() const;
  const Transform* operator->() const { return &**this; }

 private:
  std::shared_ptr<const Transform> shared_;  // empty: the identity
};

}  // namespace cnrg
