// Interpolation in cells, and the tables of a leaf; see the header.
#include "csg/leaves/parameters.h"

#include <mutex>
#include <tuple>

#include "csg/leaves/leaf.h"
#include "kernel/base/counts.h"
#include "kernel/base/error.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

Parameters mix(const Parameters& a, const Parameters& b, const Rational& t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
}

/// A triangle or quadrilateral in the projection along the largest component of its normal.
class Cell {
 public:
  explicit Cell(std::span<const PatchCorner> corners) : corners_(corners) {
    require(corners.size() == 3 || corners.size() == 4, "parameters: a cell has three corners or four");
    RationalPoint normal = cross(point(1) - point(0), point(2) - point(0));
    if (is_zero(normal)) normal = cross(point(2) - point(0), point(corners.size() - 1) - point(0));
    const std::size_t axis = steepest_axis(normal);
    require(normal[axis] != 0, "parameters: the corners of a cell lie on one line");
    x_ = (axis + 1) % 3;
    y_ = (axis + 2) % 3;
  }

  const RationalPoint& point(std::size_t i) const { return corners_[i].point; }
  const Parameters& at(std::size_t i) const { return corners_[i].at; }

  /// The component along the axis of projection of (b - a) x (d - c).
  Rational wedge(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c,
                 const RationalPoint& d) const {
    return (b[x_] - a[x_]) * (d[y_] - c[y_]) - (b[y_] - a[y_]) * (d[x_] - c[x_]);
  }
  /// Twice the signed area of a b c.
  Rational area(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) const {
    return wedge(a, b, a, c);
  }
  /// The place of p on the line from a to b, 0 at a and 1 at b; nothing where they are one point.
  std::optional<Rational> place(const RationalPoint& a, const RationalPoint& b, const RationalPoint& p) const {
    for (const std::size_t k : {x_, y_}) {
      if (a[k] != b[k]) return (p[k] - a[k]) / (b[k] - a[k]);
    }
    return std::nullopt;
  }

  Parameters in_triangle(std::size_t a, std::size_t b, std::size_t c, const RationalPoint& p) const {
    const Rational whole = area(point(a), point(b), point(c));
    const Rational s = area(point(a), p, point(c)) / whole, t = area(point(a), point(b), p) / whole;
    Parameters result;
    for (std::size_t k = 0; k < 2; ++k)
      result[k] = at(a)[k] + s * (at(b)[k] - at(a)[k]) + t * (at(c)[k] - at(a)[k]);
    return result;
  }

  /// For sides a b and d c that are parallel.
  Parameters in_trapezoid(std::size_t a, std::size_t b, std::size_t c, std::size_t d,
                          const RationalPoint& p) const {
    // t grows across, by the signed distance from a b (where that is one point, in the direction of d c).
    const bool lower = point(a) != point(b);
    const RationalPoint &from = point(lower ? a : d), &to = point(lower ? b : c);
    const Rational t = wedge(from, to, point(a), p) / wedge(from, to, point(a), point(d));
    const auto across = [&](std::size_t low, std::size_t high) -> RationalPoint {
      return point(low) + t * (point(high) - point(low));
    };
    const Rational s = place(across(a, d), across(b, c), p).value_or(Rational(1, 2));
    return mix(mix(at(a), at(b), s), mix(at(d), at(c), s), t);
  }

 private:
  std::span<const PatchCorner> corners_;
  std::size_t x_ = 0, y_ = 1;
};

}  // namespace

Parameters parameters_in(std::span<const PatchCorner> corners, const RationalPoint& p) {
  const Cell cell(corners);
  if (corners.size() == 3) return cell.in_triangle(0, 1, 2, p);
  const auto parallel = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    return cell.wedge(cell.point(a), cell.point(b), cell.point(d), cell.point(c)) == 0;
  };
  if (parallel(0, 1, 2, 3)) return cell.in_trapezoid(0, 1, 2, 3, p);
  if (parallel(1, 2, 3, 0)) return cell.in_trapezoid(1, 2, 3, 0, p);
  const Rational side = cell.area(cell.point(0), cell.point(2), p);
  const bool first = side == 0 || (side > 0) == (cell.area(cell.point(0), cell.point(2), cell.point(1)) > 0);
  return first ? cell.in_triangle(0, 1, 2, p) : cell.in_triangle(0, 2, 3, p);
}

bool is_cell(std::span<const PatchCorner> corners) {
  if (corners.size() < 3 || corners.size() > 4) return false;
  const auto& [a, b, c] = std::tie(corners[0].point, corners[1].point, corners[2].point);
  if (corners.size() == 3) return !collinear(a, b, c);
  const RationalPoint& d = corners[3].point;
  return volume6(a, b, c, d) == 0 && !(collinear(a, b, c) && collinear(a, c, d));
}

bool holds(std::span<const PatchCorner> corners, const RationalPoint& p) {
  const Cell cell(corners);
  bool left = false, right = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const int side = sgn(cell.area(cell.point(i), cell.point((i + 1) % corners.size()), p));
    left = left || side > 0;
    right = right || side < 0;
  }
  return !(left && right);
}

void LeafParameters::add_facet(std::span<const PatchCorner> corners) {
  const std::vector<PatchCorner> cell(corners.begin(), corners.end());
  add_facet(std::span(&cell, 1));
}

void LeafParameters::add_facet(std::span<const Corner> corners) {
  corners_.insert(corners_.end(), corners.begin(), corners.end());
  end_cell();
  facets_.push_back(static_cast<Index>(cells_.size() - 1));
}

void LeafParameters::add_facet(std::span<const std::vector<PatchCorner>> cells) {
  for (const std::vector<PatchCorner>& cell : cells) {
    for (const PatchCorner& corner : cell)
      corners_.push_back({number_of(corner.point), number_of(corner.at[0]), number_of(corner.at[1])});
    end_cell();
  }
  facets_.push_back(static_cast<Index>(cells_.size() - 1));
}

void LeafParameters::end_cell() { cells_.push_back(place32(corners_.size(), "corners of facets")); }

void LeafParameters::add_wire(const Wire& wire) {
  wires_.push_back(
      {number_of(wire.ends[0]), number_of(wire.ends[1]), number_of(wire.at[0]), number_of(wire.at[1])});
}

LeafParameters::Wire LeafParameters::wire(std::size_t i) const {
  require(i < wire_count(), "parameters: a leaf has fewer wires than its soup");
  const auto& [a, b, from, to] = wires_[i];
  return {{points_[a], points_[b]}, {values_[from], values_[to]}};
}

const std::string& LeafParameters::patch_name(std::uint32_t patch) const {
  static const std::string kNone;
  const auto it = patches_.find(patch);
  return it == patches_.end() ? kNone : it->second;
}

const std::string& LeafParameters::curve_name(std::uint32_t curve) const {
  static const std::string kNone;
  const auto it = curves_.find(curve);
  return it == curves_.end() ? kNone : it->second;
}

std::vector<std::span<const LeafParameters::Corner>> LeafParameters::cells_by_number(std::size_t facet) const {
  require(facet < facet_count(), "parameters: a leaf has fewer facets than its soup");
  std::vector<std::span<const Corner>> result;
  for (Index c = facets_[facet]; c < facets_[facet + 1]; ++c)
    result.push_back(std::span(corners_).subspan(cells_[c], cells_[c + 1] - cells_[c]));
  return result;
}

std::vector<std::vector<PatchCorner>> LeafParameters::cells(std::size_t facet) const {
  std::vector<std::vector<PatchCorner>> result;
  for (const std::span<const Corner> cell : cells_by_number(facet)) {
    result.emplace_back();
    for (const Corner& corner : cell)
      result.back().push_back({points_[corner.point], {values_[corner.u], values_[corner.v]}});
  }
  return result;
}

void PreparedLeaf::set_parameters(ParameterSource source) {
  struct Made {
    std::mutex mutex;
    std::shared_ptr<const LeafParameters> parameters;
  };
  if (!source) return;
  parameters_ = [source = std::move(source), made = std::make_shared<Made>()] {
    {
      const std::lock_guard lock(made->mutex);
      if (made->parameters) return made->parameters;
    }
    std::shared_ptr<const LeafParameters> anew = source();  // not under the lock: it runs in parallel
    const std::lock_guard lock(made->mutex);
    if (!made->parameters) made->parameters = std::move(anew);
    return made->parameters;
  };
}

}  // namespace cnrg
