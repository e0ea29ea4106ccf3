// Surfaces that nothing holds, found without rays. A model of many bodies has mostly such surfaces, and a ray from
// each to infinity would pass all the bodies in its way.
//
// What a surface shuts off from infinity is inside of the box around it. Surfaces meet at most in points, and sets
// that do so shut off no more together than one by one (Mayer-Vietoris: points have no first cohomology). So if a
// surface reaches out of the box of each other one, one of its shells is at infinity: its only shell, or of two
// the one that looks away from what they enclose, which the sign of the volume tells.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/complex/builder.h"
#include "kernel/refine/box_tree.h"

namespace cnrg {

namespace {

/// A surface as it is collected from its faces.
struct Surface {
  Box box;                        // around it
  Box sure;                       // it reaches from at most `lo` to at least `hi`, which may cross
  std::array<ShellId, 2> shells;  // the first two
  bool has_more = false;          // shells than these
  std::array<double, 3> origin{};
  double volume = 0;  // six times what the first shell encloses, from `origin`
  double off = 0;     // how far a coordinate is from the middle of its bounds at most
  std::size_t terms = 0;

  std::array<double, 3> add(const PointView& p) {
    const bool first = terms == 0 && box.lo[0] > box.hi[0];
    box.extend(p.lo, p.hi);
    sure.extend(p.hi, p.lo);
    std::array<double, 3> v;
    for (std::size_t k = 0; k < 3; ++k) {
      v[k] = p.lo[k] + (p.hi[k] - p.lo[k]) / 2;
      off = std::max(off, p.hi[k] - p.lo[k]);
      if (first) origin[k] = v[k];
      v[k] -= origin[k];
    }
    return v;
  }

  void add(ShellId s) {
    for (ShellId& known : shells) {
      if (!known.valid()) known = s;
      if (known == s) return;
    }
    has_more = true;
  }

  void add(const std::array<double, 3>& a, const std::array<double, 3>& b, const std::array<double, 3>& c,
           double sign) {
    ++terms;
    volume += sign * (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                      a[2] * (b[0] * c[1] - b[1] * c[0]));
  }

  /// How far `volume` may be off. A determinant is six products of three coordinates of at most `size`, each of
  /// which is off by `off` and some roundings; adding n of them rounds n times what they are together at most.
  /// Where numbers underflow a rounding is no part of them, but less than the least normal number.
  double error() const {
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k) size = std::max(size, box.hi[k] - box.lo[k]);
    const auto n = static_cast<double>(terms);
    return 6 * n * size * size * (size * (n + 20) * std::numeric_limits<double>::epsilon() + 4 * off) +
           n * std::numeric_limits<double>::min();
  }

  /// The shell at infinity, if that is certain, given that the surface reaches out of all others.
  ShellId outer() const {
    if (!shells[1].valid()) return shells[0];
    if (has_more || !(std::fabs(volume) > error())) return ShellId::none();
    return shells[volume > 0 ? 0 : 1];
  }
};

}  // namespace

/// Joins to infinity the outer shells of surfaces that nothing holds. `starts`: a face of each surface; returns
/// those of the other surfaces. `surfaces` joins the shells of each surface.
std::vector<FaceId> ComplexBuilder::join_outermost(std::vector<FaceId> starts, UnionFind& surfaces) {
  std::vector<std::uint32_t> number(shell_count_);
  const auto surface_of = [&](FaceId f) { return surfaces.find(shell(HalfFace(f, 0)).value()); };
  for (std::uint32_t i = 0; i < starts.size(); ++i) number[surface_of(starts[i])] = i;
  std::vector<Surface> list(starts.size());
  for (const FaceId f : IdRange<FaceId>(c_.face_count())) {
    Surface& s = list[number[surface_of(f)]];
    const ShellId front = shell(HalfFace(f, 0)), back = shell(HalfFace(f, 1));
    s.add(front);
    s.add(back);
    const double sign = (front == s.shells[0] ? 1.0 : 0.0) - (back == s.shells[0] ? 1.0 : 0.0);
    for (const LoopId loop : std::as_const(c_.face_loops)[f]) {
      const auto walk = std::as_const(c_.loop)[loop];
      const auto corner = [&](std::size_t i) { return s.add(c_.points.view(c_.origin(walk[i]))); };
      const auto first = corner(0);
      auto last = corner(1);
      for (std::size_t i = 2; i < walk.size(); ++i) {
        const auto next = corner(i);
        s.add(first, last, next, sign);
        last = next;
      }
    }
  }
  std::vector<Box> boxes;
  boxes.reserve(list.size());
  for (const Surface& s : list) boxes.push_back(s.box);
  const BoxTree tree(std::move(boxes));
  std::vector<ShellId> outer(list.size());
  tbb::parallel_for(std::size_t{0}, list.size(), [&](std::size_t i) {
    bool may_be_held = false;
    const auto may_hold = [&](const Box& box) { return !may_be_held && list[i].sure.inside(box); };
    tree.query(may_hold, [&](std::uint32_t other) { may_be_held = may_be_held || other != i; });
    if (!may_be_held) outer[i] = list[i].outer();
  });
  std::size_t left = 0;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    if (outer[i].valid()) space_.unite(outer[i].value(), static_cast<std::uint32_t>(shell_count_));
    else starts[left++] = starts[i];
  }
  starts.resize(left);
  return starts;
}

}  // namespace cnrg
