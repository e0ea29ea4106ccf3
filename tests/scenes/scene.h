// Leaves of mixed dimension, as tests make, print and shrink them.
//
// A leaf knows its geometry twice: as faces for the soup and, for oracles that share no code with the kernel,
// as closed solids, sheets, wires and points whose union is the leaf's point set.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "kernel/exact/rational.h"
#include "kernel/refine/soup.h"

namespace cnrg::scenes {

using Polygon = std::vector<RationalPoint>;

/// A planar face; the front is the side from which the first loop is seen counter-clockwise.
struct Face {
  std::vector<Polygon> loops;
  std::uint32_t front = 0, back = 0;
  bool sheet = false;  ///< bounds none of the leaf's solids
};

/// A closed solid by its facets: simple planar polygons, counter-clockwise from outside.
using Solid = std::vector<Polygon>;

struct Leaf {
  Fill fill = Fill::sides;
  std::vector<Face> faces;
  std::vector<std::array<RationalPoint, 2>> wires;
  std::vector<RationalPoint> points;
  std::vector<Solid> solids;
};

// --- solids and sheets as leaves
/// The facets of a box, outward.
Solid box_solid(const RationalPoint& min, const RationalPoint& max);
/// The facets of a tetrahedron, outward whatever the order of its corners; they are not coplanar.
Solid tetrahedron_solid(const std::array<RationalPoint, 4>& corners);
/// A simple planar polygon swept along `vector`.
Solid prism_solid(const Polygon& base, const RationalPoint& vector);
/// Adds a solid and its faces, with `region` behind them.
void add_solid(Leaf& leaf, const Solid& solid, std::uint32_t region);
void add_sheet(Leaf& leaf, std::vector<Polygon> loops);
Leaf solid_leaf(const Solid& solid, Fill fill = Fill::sides);
/// A column of boxes of one base, regions 1, 2, ... from below, with one wall between neighbours.
Leaf layered_leaf(const RationalPoint& min, const RationalPoint& max, const std::vector<Rational>& levels);

/// An exact map p -> A p + b.
struct Motion {
  std::array<std::array<Rational, 3>, 3> matrix{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  RationalPoint offset{0, 0, 0};
  RationalPoint operator()(const RationalPoint& p) const;
  /// The rotation of the unit quaternion (w, x, y, z) / |.|: rational and orthogonal exactly.
  static Motion rotation(int w, int x, int y, int z);
  static Motion scaling(const Rational& factor);
  Rational determinant() const;
};
/// One after the other.
Motion after(const Motion& first, const Motion& second);
void apply(const Motion& motion, Leaf& leaf);
void apply_to_all(const Motion& motion, std::vector<Leaf>& leaves);

/// How leaves become a soup.
struct SoupOptions {
  bool share_points = true;        ///< one point per position of a leaf, else every corner its own
  std::vector<std::size_t> order;  ///< permutation of the leaves; empty: as they are
  bool reverse_faces = false;      ///< faces of each leaf from the last to the first
};
Soup make_soup(const std::vector<Leaf>& leaves, const SoupOptions& options = {});

/// As the tree file has it.
const char* name(Fill fill);
/// The fields of a `group` leaf that is this one, each line indented by six.
std::string group_text(const Leaf& leaf);
/// The union of the leaves as a tree file.
std::string tree_file(const std::vector<Leaf>& leaves);

// --- random leaves
/// A small generator with the same numbers on every platform (splitmix64).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15u + 0x1234567u) {}
  std::uint64_t next();
  int below(int n) { return static_cast<int>(next() % static_cast<std::uint64_t>(n)); }
  int between(int low, int high) { return low + below(high - low + 1); }
  bool one_in(int n) { return below(n) == 0; }

 private:
  std::uint64_t state_;
};

enum class Position : std::uint8_t {
  general,     ///< each leaf rotated on its own, coordinates 0 to 20
  degenerate,  ///< on a small grid: coplanar, collinear and coincident parts everywhere
  tilted,      ///< degenerate, all leaves rotated by one rational rotation
};
/// Solids, layers, sheets with holes, wires, points, and mixtures.
std::vector<Leaf> random_leaves(std::uint64_t seed, int count, Position position);

/// Leaves with less in one of them, to try when they fail: without its solids, one of its solids alone, without a
/// wire, a point, a sheet or the hole of one.
std::vector<std::vector<Leaf>> smaller(const std::vector<Leaf>& leaves);

/// The list without its element `i`.
template <class List>
List without(List list, std::size_t i) {
  list.erase(list.begin() + static_cast<std::ptrdiff_t>(i));
  return list;
}

}  // namespace cnrg::scenes
