#include "tests/scenes/scene.h"

#include <map>
#include <numeric>

namespace cnrg::scenes {
namespace {

RationalPoint operator+(const RationalPoint& p, const RationalPoint& q) {
  return {p[0] + q[0], p[1] + q[1], p[2] + q[2]};
}

RationalPoint operator-(const RationalPoint& p, const RationalPoint& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

Rational determinant(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// Twice the vector area of a closed polygon.
RationalPoint polygon_area(const Polygon& polygon) {
  RationalPoint sum{0, 0, 0};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const RationalPoint& p = polygon[i];
    const RationalPoint& q = polygon[(i + 1) % polygon.size()];
    sum = sum + RationalPoint{p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
  }
  return sum;
}

template <class Visit>
void for_each_point(Leaf& leaf, Visit visit) {
  for (Face& face : leaf.faces)
    for (Polygon& loop : face.loops)
      for (RationalPoint& p : loop) visit(p);
  for (auto& wire : leaf.wires)
    for (RationalPoint& p : wire) visit(p);
  for (RationalPoint& p : leaf.points) visit(p);
  for (Solid& solid : leaf.solids)
    for (Polygon& facet : solid)
      for (RationalPoint& p : facet) visit(p);
}

}  // namespace

Solid box_solid(const RationalPoint& a, const RationalPoint& b) {
  const auto corner = [&](int x, int y, int z) {
    return RationalPoint{x ? b[0] : a[0], y ? b[1] : a[1], z ? b[2] : a[2]};
  };
  return {{corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0), corner(1, 0, 0)},
          {corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1)},
          {corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1)},
          {corner(0, 1, 0), corner(0, 1, 1), corner(1, 1, 1), corner(1, 1, 0)},
          {corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), corner(0, 1, 0)},
          {corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1), corner(1, 0, 1)}};
}

Solid tetrahedron_solid(const std::array<RationalPoint, 4>& corners) {
  auto [a, b, c, d] = corners;
  if (determinant(b - a, c - a, d - a) > 0) std::swap(b, c);
  // d lies behind (a, b, c) now, so (a, b, c) is seen counter-clockwise from outside.
  return {{a, b, c}, {a, d, b}, {b, d, c}, {c, d, a}};
}

Solid prism_solid(const Polygon& base, const RationalPoint& vector) {
  const RationalPoint area = polygon_area(base);
  Polygon bottom = base;
  if (area[0] * vector[0] + area[1] * vector[1] + area[2] * vector[2] < 0)
    bottom.assign(base.rbegin(), base.rend());
  Solid solid;
  Polygon top;
  for (const RationalPoint& p : bottom) top.push_back(p + vector);
  for (std::size_t i = 0; i < bottom.size(); ++i) {
    const std::size_t j = (i + 1) % bottom.size();
    solid.push_back({bottom[i], bottom[j], top[j], top[i]});
  }
  solid.push_back(top);
  solid.emplace_back(bottom.rbegin(), bottom.rend());
  return solid;
}

void add_solid(Leaf& leaf, const Solid& solid, std::uint32_t region) {
  for (const Polygon& facet : solid) leaf.faces.push_back({{facet}, 0, region, false});
  leaf.solids.push_back(solid);
}

void add_sheet(Leaf& leaf, std::vector<Polygon> loops) { leaf.faces.push_back({std::move(loops), 0, 0, true}); }

Leaf solid_leaf(const Solid& solid, Fill fill) {
  Leaf leaf;
  leaf.fill = fill;
  add_solid(leaf, solid, fill == Fill::sides ? 1 : 0);
  return leaf;
}

Leaf layered_leaf(const RationalPoint& min, const RationalPoint& max, const std::vector<Rational>& levels) {
  Leaf leaf;
  std::vector<Rational> all{min[2]};
  all.insert(all.end(), levels.begin(), levels.end());
  all.push_back(max[2]);
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    const Solid box = box_solid({min[0], min[1], all[i]}, {max[0], max[1], all[i + 1]});
    const auto region = static_cast<std::uint32_t>(i + 1);
    leaf.solids.push_back(box);
    for (std::size_t f = 2; f < 6; ++f) leaf.faces.push_back({{box[f]}, 0, region, false});
    if (i == 0) leaf.faces.push_back({{box[0]}, 0, region, false});
    leaf.faces.push_back({{box[1]}, i + 2 < all.size() ? region + 1 : 0, region, false});
  }
  return leaf;
}

RationalPoint Motion::operator()(const RationalPoint& p) const {
  RationalPoint q = offset;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) q[i] += matrix[i][k] * p[k];
  return q;
}

Motion Motion::rotation(int w, int x, int y, int z) {
  const Rational n = w * w + x * x + y * y + z * z;
  const int m[3][3] = {{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
                       {2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)},
                       {2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z}};
  Motion motion;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) motion.matrix[i][k] = Rational(m[i][k]) / n;
  return motion;
}

Motion Motion::scaling(const Rational& factor) {
  Motion motion;
  for (int i = 0; i < 3; ++i) motion.matrix[i][i] = factor;
  return motion;
}

Rational Motion::determinant() const { return scenes::determinant(matrix[0], matrix[1], matrix[2]); }

Motion after(const Motion& first, const Motion& second) {
  Motion both;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      both.matrix[i][j] = 0;
      for (int k = 0; k < 3; ++k) both.matrix[i][j] += second.matrix[i][k] * first.matrix[k][j];
    }
  }
  both.offset = second(first.offset);
  return both;
}

void apply(const Motion& motion, Leaf& leaf) {
  for_each_point(leaf, [&](RationalPoint& p) { p = motion(p); });
}

void apply_to_all(const Motion& motion, std::vector<Leaf>& leaves) {
  for (Leaf& leaf : leaves) apply(motion, leaf);
}

Soup make_soup(const std::vector<Leaf>& leaves, const SoupOptions& options) {
  Soup soup;
  std::vector<std::size_t> order = options.order;
  if (order.empty()) {
    order.resize(leaves.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
  }
  std::uint32_t patch = 0;
  for (const std::size_t index : order) {
    const Leaf& leaf = leaves[index];
    const LeafId id = soup.add_leaf(leaf.fill);
    std::map<RationalPoint, PointId> known;
    const auto point = [&](const RationalPoint& p) {
      if (options.share_points) {
        if (const auto it = known.find(p); it != known.end()) return it->second;
      }
      const PointId added = soup.add_point(p);
      known.emplace(p, added);
      return added;
    };
    for (std::size_t k = 0; k < leaf.faces.size(); ++k) {
      const std::size_t number = options.reverse_faces ? leaf.faces.size() - 1 - k : k;
      const Face& face = leaf.faces[number];
      std::vector<std::vector<PointId>> loops;
      for (const Polygon& loop : face.loops) {
        loops.emplace_back();
        for (const RationalPoint& p : loop) loops.back().push_back(point(p));
      }
      soup.add_face(id, loops, static_cast<std::uint32_t>(number), patch + static_cast<std::uint32_t>(number),
                    face.front, face.back);
    }
    patch += static_cast<std::uint32_t>(leaf.faces.size());
    for (std::size_t k = 0; k < leaf.wires.size(); ++k)
      soup.add_wire(id, point(leaf.wires[k][0]), point(leaf.wires[k][1]), static_cast<std::uint32_t>(k));
    for (const RationalPoint& p : leaf.points) soup.add_isolated(id, point(p));
  }
  return soup;
}

}  // namespace cnrg::scenes
