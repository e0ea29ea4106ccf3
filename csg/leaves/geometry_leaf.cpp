// Copying a leaf's soup. Most transforms of most leaves stay in doubles: a coordinate is computed in doubles
// with the error of every step, and only where an error is not zero by rationals.
#include "csg/leaves/geometry_leaf.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kernel/base/error.h"
#include "kernel/base/limits.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/predicates.h"

namespace cnrg {
namespace {

/// A transform whose entries are doubles, for points that are doubles.
class DoubleTransform {
 public:
  explicit DoubleTransform(const Transform& t) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        const Rational& entry = j < 3 ? t.linear[i][j] : t.offset[i];
        usable_ = usable_ && is_double(entry);
        m_[i][j] = to_double(entry);
      }
    }
  }

  /// The image of p if it and every step to it are exact in doubles.
  bool apply(const double* p, double* image) const {
    if (!usable_) return false;
    for (std::size_t i = 0; i < 3; ++i) {
      double sum = m_[i][3];
      for (std::size_t j = 0; j < 3; ++j) {
        if (m_[i][j] == 0 || p[j] == 0) continue;
        const double product = m_[i][j] * p[j];
        // Below 1e-280 the error of the product may vanish though it is not zero.
        if (!(std::abs(product) > 1e-280) || std::fma(m_[i][j], p[j], -product) != 0) return false;
        const double next = sum + product;
        const double part = next - sum;  // two-sum (Knuth): the exact error of the addition
        if ((sum - (next - part)) + (product - part) != 0) return false;
        sum = next;
      }
      if (!std::isfinite(sum)) return false;
      image[i] = sum;
    }
    return true;
  }

 private:
  double m_[3][4];
  bool usable_ = true;
};

}  // namespace

std::optional<LeafAxes> moved_axes(const LeafAxes* axes, const Transform& transform) {
  const LeafAxes own = axes != nullptr ? *axes : LeafAxes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const auto& back = transform.inverse().linear;
  LeafAxes there;
  bool same = true;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      there[i][j] = own[i][0] * back[0][j] + own[i][1] * back[1][j] + own[i][2] * back[2][j];
      same = same && (i == j ? there[i][j] > 0 : there[i][j] == 0);
    }
  }
  return same ? std::nullopt : std::optional(there);
}

RationalPoint exact_value(const Soup& soup, PointId p) {
  if (const RationalPoint* value = soup.rational(p)) return *value;
  const double* xyz = soup.xyz(p);
  return {from_double(xyz[0]), from_double(xyz[1]), from_double(xyz[2])};
}

GeometryLeaf::GeometryLeaf(Soup geometry, std::vector<Attributes> regions, std::vector<std::string> notices)
    : geometry_(std::move(geometry)), regions_(std::move(regions)), notices_(std::move(notices)) {
  require(geometry_.leaf_count() == 1 && !geometry_.frame().valid(), "a leaf's geometry is a soup of one leaf");
}

const std::shared_ptr<const PreparedLeaf>& no_geometry() {
  static const std::shared_ptr<const PreparedLeaf> leaf = [] {
    Soup none;
    none.add_leaf(Fill::none);
    return std::make_shared<const GeometryLeaf>(std::move(none), std::vector<Attributes>());
  }();
  return leaf;
}

LeafId GeometryLeaf::add_to(Soup& soup, const Transform& transform) const {
  const Soup& from = geometry_;
  const LeafId leaf = soup.add_leaf(from.fill(LeafId(0)), from.curved_sides(LeafId(0)));
  const bool identity = transform.identity();
  if (from.fill(LeafId(0)) == Fill::cells) {
    if (const auto axes = moved_axes(from.own_axes(LeafId(0)), transform)) soup.set_own_axes(leaf, *axes);
  }
  const bool mirrored = transform.determinant() < 0;
  const DoubleTransform in_doubles(transform);

  const std::size_t first = soup.point_count();
  for (PointId p : IdRange<PointId>(from.point_count())) {
    LeafStop::check();
    const double* xyz = from.xyz(p);
    const RationalPoint* value = from.rational(p);
    double image[3];
    if (identity) {
      value ? soup.add_point(*value) : soup.add_point(xyz[0], xyz[1], xyz[2]);
    } else if (!value && in_doubles.apply(xyz, image)) {
      soup.add_point(image[0], image[1], image[2]);
    } else {
      soup.add_point(transform.apply(exact_value(from, p)));
    }
  }
  const auto moved = [first](PointId p) { return PointId(p.index() + first); };

  std::vector<std::vector<PointId>> loops;
  for (SourceId f : IdRange<SourceId>(from.face_count())) {
    LeafStop::check();
    const Soup::Face& face = from.face(f);
    const std::span<const PointId> corners = from.corners(f);
    const std::array<PointId, 3>* const plane = from.plane(f);
    if (corners.size() == 3 && plane == nullptr) {
      const PointId a = moved(corners[0]), b = moved(corners[1]), c = moved(corners[2]);
      soup.add_triangle(leaf, a, mirrored ? c : b, mirrored ? b : c, face.leaf_face, face.patch, face.front,
                        face.back);
      continue;
    }
    loops.assign(1, {});
    for (PointId p : corners) {
      if (p.valid()) loops.back().push_back(moved(p));
      else loops.emplace_back();
    }
    if (mirrored) {
      for (auto& loop : loops) std::reverse(loop.begin(), loop.end());
    }
    soup.add_face(leaf, loops, face.leaf_face, face.patch, face.front, face.back);
    if (plane == nullptr) continue;
    const auto& [a, b, c] = *plane;
    soup.set_plane({moved(a), moved(mirrored ? c : b), moved(mirrored ? b : c)});
  }
  for (const Soup::Wire& wire : from.wires()) soup.add_wire(leaf, moved(wire.a), moved(wire.b), wire.leaf_edge);
  for (const Soup::Isolated& isolated : from.isolated()) soup.add_isolated(leaf, moved(isolated.point));
  for (const Soup::Isolated& end : from.curve_ends()) soup.add_curve_end(leaf, moved(end.point));
  return leaf;
}

void LeafBuilder::face(const std::vector<PointId>& loop, std::uint32_t leaf_face) {
  LeafStop::check();
  soup_.add_face(leaf_, std::span(&loop, 1), leaf_face, leaf_face);
  note_flat();
}

void LeafBuilder::face(const std::vector<std::vector<PointId>>& loops, std::uint32_t leaf_face) {
  LeafStop::check();
  soup_.add_face(leaf_, loops, leaf_face, leaf_face);
  note_flat();
}

void LeafBuilder::triangle(PointId a, PointId b, PointId c, std::uint32_t leaf_face) {
  LeafStop::check();
  soup_.add_triangle(leaf_, a, b, c, leaf_face, leaf_face);
  note_flat();
}

void LeafBuilder::facet(PointId a, PointId b, PointId c, PointId d, std::uint32_t leaf_face,
                        const CornerParameters& at) {
  LeafStop::check();
  const std::array<PointId, 4> all{a, b, c, d};
  const auto add = [&](std::initializer_list<std::size_t> polygon, std::initializer_list<std::size_t> cell) {
    const std::size_t* const k = polygon.begin();
    if (polygon.size() == 3) {
      soup_.add_triangle(leaf_, all[k[0]], all[k[1]], all[k[2]], leaf_face, leaf_face);
    } else {
      const std::vector<PointId> loop(all.begin(), all.end());
      soup_.add_face(leaf_, std::span(&loop, 1), leaf_face, leaf_face);
    }
    if (record_ == nullptr) return;
    std::vector<LeafParameters::Corner> corners;
    for (const std::size_t i : cell) corners.push_back(corner(all[i], at[i]));
    record_->add_facet(corners);
  };
  if (a == b) return add({0, 2, 3}, {0, 1, 2, 3});
  if (b == c || c == d) return add({0, 1, 3}, {0, 1, 2, 3});
  if (d == a) return add({0, 1, 2}, {0, 1, 2, 3});
  if (coplanar(a, b, c, d)) return add({0, 1, 2, 3}, {0, 1, 2, 3});
  add({0, 1, 2}, {0, 1, 2});
  add({0, 2, 3}, {0, 2, 3});
}

void LeafBuilder::facet(PointId a, PointId b, PointId c, std::uint32_t leaf_face,
                        const std::array<std::array<const Rational*, 2>, 3>& at) {
  LeafStop::check();
  soup_.add_triangle(leaf_, a, b, c, leaf_face, leaf_face);
  if (record_ == nullptr) return;
  std::vector<LeafParameters::Corner> corners;
  for (const PointId p : {a, b, c}) corners.push_back(corner(p, at[corners.size()]));
  record_->add_facet(corners);
}

LeafParameters::Corner LeafBuilder::corner(PointId p, const std::array<const Rational*, 2>& at) {
  if (recorded_.size() <= p.index()) recorded_.resize(soup_.point_count(), kNone);
  std::uint32_t& number = recorded_[p.index()];
  if (number == kNone) number = record_->number_of(value(p));
  return {number, record_->number_of(*at[0]), record_->number_of(*at[1])};
}

bool LeafBuilder::coplanar(PointId a, PointId b, PointId c, PointId d) const {
  const std::array<PointId, 4> all{a, b, c, d};
  if (std::ranges::none_of(all, [&](PointId p) { return soup_.rational(p) != nullptr; }))
    return orient3d(soup_.xyz(a), soup_.xyz(b), soup_.xyz(c), soup_.xyz(d)) == 0;
  return volume6(value(a), value(b), value(c), value(d)) == 0;
}

void LeafBuilder::end_curves(const std::vector<PointId>& line) {
  if (value(line.front()) == value(line.back())) return;
  for (const PointId end : {line.front(), line.back()}) soup_.add_curve_end(leaf_, end);
}

RationalPoint LeafBuilder::value(PointId p) const { return exact_value(soup_, p); }

std::unique_ptr<PreparedLeaf> LeafBuilder::finish(std::vector<std::string> notices) {
  std::vector<Attributes> regions;
  if (fill_ == Fill::winding || fill_ == Fill::parity) regions.emplace_back();
  return std::make_unique<GeometryLeaf>(std::move(soup_), std::move(regions), std::move(notices));
}

}  // namespace cnrg
