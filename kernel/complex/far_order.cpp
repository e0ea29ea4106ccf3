#include "kernel/complex/far_order.h"

#include <algorithm>

#include "kernel/complex/plane_cut.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/predicates.h"
#include "kernel/refine/box_faces.h"

namespace cnrg {
namespace {

/// The coordinates of the order, and the way back from them.
class Coordinates {
 public:
  explicit Coordinates(const LeafAxes* axes) {
    if (axes != nullptr) axes_ = *axes;
    const Rational determinant = dot(cross(axes_[0], axes_[1]), axes_[2]);
    for (std::size_t i = 0; i < 3; ++i)
      back_[i] = Rational(1 / determinant) * cross(axes_[(i + 1) % 3], axes_[(i + 2) % 3]);
  }
  RationalPoint of(const RationalPoint& p) const { return {dot(axes_[0], p), dot(axes_[1], p), dot(axes_[2], p)}; }
  ExactHalfspace of(const ExactPlane& plane) const {
    const RationalPoint normal{plane.a, plane.b, plane.c};
    return {{dot(back_[0], normal), dot(back_[1], normal), dot(back_[2], normal)}, Rational(-plane.d)};
  }

 private:
  LeafAxes axes_{RationalPoint{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, back_;
};

/// The planes that reach the frame, each once.
std::vector<ExactHalfspace> planes_of(const Complex& complex, const Coordinates& coordinates) {
  IdVector<PlaneId, char> known(complex.points.plane_count(), 0);
  std::vector<ExactHalfspace> planes;
  for (const FaceId f : IdRange<FaceId>(complex.face_count())) {
    if (complex.on_frame(f)) continue;
    const auto loop = complex.loop[complex.face_loops[f].front()];
    if (std::none_of(loop.begin(), loop.end(), [&](HalfEdge h) { return complex.on_frame(h.edge()); })) continue;
    if (!std::exchange(known[complex.plane(f)], 1))
      planes.push_back(coordinates.of(complex.points.exact_plane(complex.plane(f))));
  }
  return planes;
}

/// How coordinates of a point in which planes meet sides of the box depend on where these are: on a line of two
/// planes and a side, or of a plane and two sides, a coordinate is a constant and multiples of places of sides.
struct Dependence {
  std::vector<Rational> factors{0, 1, -1};
  Rational constant = 0;  ///< the largest

  void add_factor(const Rational& x) { factors.push_back(x), factors.push_back(-x); }
  void add_constant(const Rational& x) { constant = std::max(constant, Rational(abs(x))); }

  explicit Dependence(const std::vector<ExactHalfspace>& planes) {
    for (std::size_t p = 0; p < planes.size(); ++p) {
      add(planes[p]);
      for (std::size_t q = 0; q < p; ++q) add(planes[p], planes[q]);
    }
    std::sort(factors.begin(), factors.end());
    factors.erase(std::unique(factors.begin(), factors.end()), factors.end());
  }

  void add(const ExactHalfspace& p) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (p.normal[j] == 0) continue;
      add_constant(p.offset / p.normal[j]);
      for (const std::size_t k : {(j + 1) % 3, (j + 2) % 3}) add_factor(p.normal[k] / p.normal[j]);
    }
  }

  void add(const ExactHalfspace& p, const ExactHalfspace& q) {
    const RationalPoint line = cross(p.normal, q.normal);
    for (std::size_t k = 0; k < 3; ++k) {
      if (line[k] == 0) continue;
      for (const std::size_t j : {(k + 1) % 3, (k + 2) % 3}) {
        const std::size_t i = 3 - j - k;
        add_factor(line[j] / line[k]);
        add_constant((p.offset * q.normal[i] - q.offset * p.normal[i]) / line[k]);
      }
    }
  }

  /// If each side of the box is so many times as far away as the one before, the farthest one decides which of two
  /// coordinates is larger, unless they depend on it alike.
  Rational ratio() const {
    Rational least = 1;
    for (std::size_t i = 1; i < factors.size(); ++i)
      least = std::min(least, Rational(factors[i] - factors[i - 1]));
    return 24 * (factors.back() + 1) / least;
  }
};

Rational power_of_two_above(const Rational& x) {
  Rational power = 1;
  while (power <= x) power *= 2;
  return power;
}

ExactBox far_box(const Complex& complex, const Coordinates& coordinates,
                 const std::vector<ExactHalfspace>& planes) {
  Dependence dependence(planes);
  for (const VertexId v : complex.vertices) {
    if (!complex.on_frame(v)) continue;
    for (const Rational& x : coordinates.of(complex.points.rational(v))) dependence.add_constant(x);
  }
  const Rational ratio = power_of_two_above(dependence.ratio());
  Rational side = power_of_two_above(dependence.constant + 1);
  ExactBox box;
  for (std::size_t k = 3; k-- > 0;) {
    box.low[k] = -(side *= ratio);
    box.high[k] = side *= ratio;
  }
  return box;
}

Soup soup_of(const std::vector<ExactHalfspace>& planes, const ExactBox& box) {
  Soup soup;
  const LeafId leaf = soup.add_leaf(Fill::none);
  const auto add_face = [&](const std::vector<RationalPoint>& corners) {
    std::vector<PointId> loop;
    for (const RationalPoint& p : corners) loop.push_back(soup.add_point(p));
    soup.add_face(leaf, std::span(&loop, 1), 0, 0);
  };
  for (const ExactHalfspace& plane : planes) add_face(cut(plane, box));
  for (const auto& face : kBoxFaces)
    add_face({box.corner(face[0]), box.corner(face[1]), box.corner(face[2]), box.corner(face[3])});
  return soup;
}

VertexId least_vertex(const Complex& complex, RegionId r) {
  VertexId least;
  for (const HalfFace side : complex.region_faces[r]) {
    for (const HalfEdge h : complex.loop[complex.face_loops[side.face()].front()]) {
      const VertexId v = complex.origin(h);
      if (!least.valid() || compare_lex(complex.points, v, least) < 0) least = v;
    }
  }
  return least;
}

}  // namespace

struct FarOrder::Data {
  const Complex& complex;
  Coordinates coordinates;
  Rational scale;  // `far` is so many times smaller, for it may be larger than doubles
  std::shared_ptr<const Complex> far;
  Locator locator;
  std::vector<std::optional<RationalPoint>> least;  // by region of `far`: its least point, if that is on the box

  Data(const Complex& c, const Coordinates& in, const std::vector<ExactHalfspace>& planes, const ExactBox& box,
       const Rational& times)
      : complex(c), coordinates(in), scale(times), far(build_complex(soup_of(planes, box))), locator(*far) {
    for (const RegionId r : IdRange<RegionId>(far->region_count)) {
      least.emplace_back();
      if (r == RegionId(0)) continue;
      const RationalPoint p = far->points.rational(least_vertex(*far, r));
      for (std::size_t k = 0; k < 3; ++k)
        if (p[k] == box.low[k] || p[k] == box.high[k]) least.back() = p;
    }
  }
};

FarOrder::FarOrder(const Complex& complex, const LeafAxes* axes) {
  const Coordinates coordinates(axes);
  std::vector<ExactHalfspace> planes = planes_of(complex, coordinates);
  ExactBox box = far_box(complex, coordinates, planes);
  const Rational scale = box.high[0];
  for (ExactHalfspace& plane : planes) plane.offset /= scale;
  for (RationalPoint* corner : {&box.low, &box.high}) {
    for (Rational& x : *corner) x /= scale;
  }
  data_ = std::make_unique<Data>(complex, coordinates, planes, box, scale);
}
FarOrder::~FarOrder() = default;

/// Both ends of a cell that goes on in two opposite directions alone have the least point of one of them. That end
/// is the one with a face of the frame that the point is beyond.
std::uint32_t FarOrder::place(HalfFace outside) const {
  const Complex& complex = data_->complex;
  const RationalPoint inside = data_->coordinates.of(interior_point(complex, outside.face()).rational());
  const Location at = data_->locator.locate(Rational(1 / data_->scale) * inside);
  require(at.dimension == 3, "FarOrder: a face of the frame lies in a plane");
  const std::optional<RationalPoint>& least = data_->least[at.region.index()];
  if (!least) return 0;
  const ExactHalfspace side = data_->coordinates.of(complex.points.exact_plane(complex.plane(outside.face())));
  const int beyond =
      sgn(Rational(data_->scale * dot(side.normal, *least) - side.offset)) * (outside.side() == 0 ? 1 : -1);
  return beyond > 0 ? at.region.value() : 0;
}

}  // namespace cnrg
