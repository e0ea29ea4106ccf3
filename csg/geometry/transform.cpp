// Exact affine maps. A matrix made of any rational quaternion is orthogonal exactly, so only the angle of a
// rotation is ever rounded, by the choice of the quaternion (kernel/exact/trigonometry.h).
#include "csg/geometry/transform.h"

#include <utility>

#include "kernel/base/error.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/trigonometry.h"

namespace cnrg {
namespace {

RationalPoint image(const std::array<std::array<Rational, 3>, 3>& m, const RationalPoint& p) {
  RationalPoint result{0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (m[i][j] == 1) result[i] += p[j];
      else if (m[i][j] != 0) result[i] += m[i][j] * p[j];
    }
  }
  return result;
}

/// The map with the given linear part that leaves `center` where it is.
Transform about(Transform map, const RationalPoint& center) {
  map.offset = center - image(map.linear, center);
  return map;
}

}  // namespace

Transform Transform::translation(const RationalPoint& by) {
  Transform t;
  t.offset = by;
  return t;
}

Transform Transform::scaling(const RationalPoint& factors) {
  Transform t;
  for (std::size_t k = 0; k < 3; ++k) {
    if (factors[k] == 0)
      throw InputError("scale: a factor is 0, which flattens the shape: give factors other than 0");
    t.linear[k][k] = factors[k];
  }
  return t;
}

Transform Transform::rotation(const RationalPoint& axis, const Rational& degrees, const RationalPoint& center) {
  if (is_zero(axis)) throw InputError("rotate: the axis is [0, 0, 0]: give a direction");
  const auto [w, x, y, z] = rotation_quaternion(axis, degrees);
  const Rational square = w * w + x * x + y * y + z * z;
  Transform t;
  t.linear = {{{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
               {2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)},
               {2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z}}};
  for (auto& row : t.linear) {
    for (Rational& entry : row) entry /= square;
  }
  return about(std::move(t), center);
}

Transform Transform::reflection(const RationalPoint& normal, const RationalPoint& point) {
  if (is_zero(normal)) throw InputError("mirror: the normal is [0, 0, 0]: give a direction");
  const Rational square = dot(normal, normal);
  Transform t;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) t.linear[i][j] -= 2 * normal[i] * normal[j] / square;
  }
  return about(std::move(t), point);
}

bool Transform::identity() const {
  for (std::size_t i = 0; i < 3; ++i) {
    if (offset[i] != 0) return false;
    for (std::size_t j = 0; j < 3; ++j) {
      if (linear[i][j] != (i == j ? 1 : 0)) return false;
    }
  }
  return true;
}

Rational Transform::determinant() const { return dot(linear[0], cross(linear[1], linear[2])); }

// The rows of the inverse are the cross products of the columns, over the determinant.
Transform Transform::inverse() const {
  const auto column = [&](std::size_t k) { return RationalPoint{linear[0][k], linear[1][k], linear[2][k]}; };
  const Rational scale = 1 / determinant();
  Transform t;
  for (std::size_t k = 0; k < 3; ++k) t.linear[k] = scale * cross(column((k + 1) % 3), column((k + 2) % 3));
  t.offset = Rational(-1) * image(t.linear, offset);
  return t;
}

RationalPoint Transform::apply(const RationalPoint& p) const { return image(linear, p) + offset; }

RationalPoint Transform::apply_to_vector(const RationalPoint& v) const { return image(linear, v); }

Transform Transform::operator*(const Transform& inner) const {
  Transform t;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      t.linear[i][j] = linear[i][0] * inner.linear[0][j] + linear[i][1] * inner.linear[1][j] +
                       linear[i][2] * inner.linear[2][j];
    }
  }
  t.offset = apply(inner.offset);
  return t;
}

const Transform& SharedTransform::operator*() const {
  static const Transform kIdentity;
  return shared_ ? *shared_ : kIdentity;
}

}  // namespace cnrg
