// The kernel on small soups: bytes become points of a small grid with halves and thirds, and triangles,
// parallelograms, boxes, faces with holes, wires and points between them, in up to four leaves. On such a grid
// everything touches everything. Any bytes are a soup, so that the fuzzer wastes nothing on syntax.
//
// Checked are the invariants of the complex, the identities of Booleans and operators on components of one pair of
// leaves, and laws of sets of cells that follow from the definitions alone. The first bytes choose which pair and
// which dominance: a run that tried them all would be too slow to be worth it.
#include <array>
#include <cstdint>
#include <vector>

#include "csg/operators/identities.h"
#include "kernel/selection/homology.h"
#include "kernel/selection/measure.h"
#include "kernel/selection/simplify.h"
#include "tests/campaign/fuzz/targets.h"
#include "tests/campaign/fuzz/targets/small.h"

namespace cnrg::fuzz {
namespace {

constexpr int kMostPartsOfLeaves = 12;

class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : bytes_(bytes) {}
  bool more() const { return at_ < bytes_.size(); }
  /// Zeros after the end.
  unsigned next() { return more() ? static_cast<unsigned char>(bytes_[at_++]) : 0; }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

Rational coordinate(unsigned byte) {
  const int whole = static_cast<int>(byte % 4);
  switch (byte / 4 % 8) {
    case 0: return {2 * whole + 1, 2};
    case 1: return {3 * whole + 1, 3};
    default: return whole;
  }
}

class SoupMaker {
 public:
  explicit SoupMaker(std::string_view bytes) : bytes_(bytes) {}

  Soup make() {
    const unsigned head = bytes_.next();
    choice_ = bytes_.next();
    turned_ = head / 4 % 4 == 3;
    constexpr Fill kFills[] = {Fill::none, Fill::cells, Fill::parity, Fill::winding, Fill::sides, Fill::solids};
    for (unsigned i = 0; i <= head % 4; ++i) leaves_.push_back(soup_.add_leaf(kFills[bytes_.next() % 6]));
    for (int i = 0; i < kMostPartsOfLeaves && bytes_.more(); ++i) add_part();
    return std::move(soup_);
  }
  /// Of what is checked.
  unsigned choice() const { return choice_; }

 private:
  using Corners = std::vector<RationalPoint>;
  Bytes bytes_;
  Soup soup_;
  std::vector<LeafId> leaves_;
  bool turned_ = false;
  unsigned choice_ = 0;
  std::uint32_t faces_ = 0;

  RationalPoint point() {
    RationalPoint p;
    for (Rational& x : p) x = coordinate(bytes_.next());
    return p;
  }
  /// The point of the soup: where it is, or turned by the quaternion 3 + i + 2 j - k.
  PointId add(const RationalPoint& p) {
    if (!turned_) return soup_.add_point(p);
    const auto& [x, y, z] = p;
    return soup_.add_point(
        {(5 * x + 10 * y + 10 * z) / 15, (-2 * x + 11 * y - 10 * z) / 15, (-14 * x + 2 * y + 5 * z) / 15});
  }
  std::vector<PointId> add(const Corners& corners) {
    std::vector<PointId> ids;
    for (const RationalPoint& p : corners) ids.push_back(add(p));
    return ids;
  }
  void add_face(LeafId leaf, const std::vector<Corners>& loops, std::uint32_t front, std::uint32_t back) {
    std::vector<std::vector<PointId>> ids;
    for (const Corners& loop : loops) ids.push_back(add(loop));
    soup_.add_face(leaf, ids, faces_, faces_, front, back);
    ++faces_;
  }

  static RationalPoint fourth(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
    return {a[0] + c[0] - b[0], a[1] + c[1] - b[1], a[2] + c[2] - b[2]};
  }
  static RationalPoint between(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c,
                               const Rational& u, const Rational& v) {
    RationalPoint p;
    for (int k = 0; k < 3; ++k) p[k] = b[k] + u * (a[k] - b[k]) + v * (c[k] - b[k]);
    return p;
  }

  void add_part() {
    const unsigned code = bytes_.next();
    const LeafId leaf = leaves_[code / 8 % leaves_.size()];
    const std::uint32_t front = code / 32 % 3, back = code / 96 % 3;
    const RationalPoint a = point();
    switch (code % 8) {
      case 0: return soup_.add_isolated(leaf, add(a));
      case 1: return add_wire(leaf, a, point());
      case 2: return add_box(leaf, a, point(), back);
      case 3: return add_tetrahedron(leaf, {a, point(), point(), point()}, back);
      default: break;
    }
    const RationalPoint b = point(), c = point();
    switch (code % 8) {
      case 4: return add_face(leaf, {{a, b, c, fourth(a, b, c)}}, front, back);
      case 5: {  // with a hole, of which three corners are given by the grid of the parallelogram
        const Rational low(1, 4), high(3, 4);
        return add_face(leaf,
                        {{a, b, c, fourth(a, b, c)},
                         {between(a, b, c, low, low), between(a, b, c, high, low), between(a, b, c, high, high)}},
                        front, back);
      }
      case 6: return add_face(leaf, {{a, b, c, point()}}, front, back);  // planar or refused
      default: return add_face(leaf, {{a, b, c}}, front, back);
    }
  }

  void add_wire(LeafId leaf, const RationalPoint& a, const RationalPoint& b) {
    if (a != b) soup_.add_wire(leaf, add(a), add(b), faces_++);
  }

  void add_box(LeafId leaf, const RationalPoint& a, const RationalPoint& b, std::uint32_t region) {
    Corners corners;
    for (unsigned i = 0; i < 8; ++i) {
      RationalPoint& p = corners.emplace_back();
      for (unsigned k = 0; k < 3; ++k) p[k] = (i >> k & 1) != 0 ? std::max(a[k], b[k]) : std::min(a[k], b[k]);
    }
    constexpr unsigned kSides[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                       {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (const auto& [p, q, r, s] : kSides)
      add_face(leaf, {{corners[p], corners[q], corners[r], corners[s]}}, 0, region);
  }

  void add_tetrahedron(LeafId leaf, const std::array<RationalPoint, 4>& p, std::uint32_t region) {
    add_face(leaf, {{p[0], p[2], p[1]}}, 0, region);
    add_face(leaf, {{p[0], p[1], p[3]}}, 0, region);
    add_face(leaf, {{p[1], p[2], p[3]}}, 0, region);
    add_face(leaf, {{p[2], p[0], p[3]}}, 0, region);
  }
};

void hold(const std::string& violation) {
  if (!violation.empty()) fault(violation);
}
void hold(bool law, const char* words) {
  if (!law) fault(words);
}

void check_sets(const Complex& complex, const CellSet& a, const CellSet& b) {
  const CellSet all = all_cells(complex), closed = closure(complex, a), open = interior(complex, a);
  hold(closure(complex, closed) == closed, "cl cl A is not cl A");
  hold(interior(complex, open) == open, "int int A is not int A");
  hold(unite(closed, a) == closed, "A is not in cl A");
  hold(unite(open, a) == a, "int A is not in A");
  hold(subtract(all, closure(complex, subtract(all, a))) == open, "int A is not what the closure outside leaves");
  hold(subtract(closed, open) == boundary(complex, a), "the boundary is not cl A - int A");
  hold(closure(complex, unite(a, b)) == unite(closed, closure(complex, b)), "cl (A or B) is not cl A or cl B");
  hold(interior(complex, intersect(a, b)) == intersect(open, interior(complex, b)),
       "int (A and B) is not int A and int B");
  hold(unite(subtract(a, b), intersect(a, b)) == a, "A is not A - B or A and B");
  hold(intersect(star(complex, a), a) == a, "A is not in its star");
  const BettiNumbers betti = betti_numbers(complex, a);
  hold(betti.z2[0] >= 0 && betti.z2[1] >= 0 && betti.z2[2] >= 0, "a Betti number is negative");
}

void check_simplified(const Complex& complex, const Group& group) {
  const Selection selection = selection_of(complex, group);
  for (const SimplifyMode mode : {SimplifyMode::features, SimplifyMode::points, SimplifyMode::raw}) {
    const SimplifiedComplex simple = simplify(complex, selection, group.features, mode);
    hold(active_counts(simple) == simplified_counts(complex, selection, group.features, mode),
         "simplified cells are not as many as were counted");
  }
}

void check_pair(const Complex& complex, Dominance dominance, const Group& a, const Group& b) {
  for (const BooleanOp op : {BooleanOp::unite, BooleanOp::intersect, BooleanOp::subtract}) {
    const Group result = boolean_operation(complex, op, dominance, a, b).group;
    hold(check_boolean(complex, op, a, b, result));
    check_simplified(complex, result);
  }
  const Components x = components_of(complex, a), y = components_of(complex, b);
  hold(check_overlay(OverlayLaw::sum, complex, x, y, sum(complex, x, y, dominance).value));
  hold(check_overlay(OverlayLaw::product, complex, x, y, product(complex, x, y, dominance).value));
  hold(check_overlay(OverlayLaw::subtract, complex, x, y, subtract(complex, x, y).value));
  check_sets(complex, support(x.selection), support(y.selection));
}

void check_leaf(const Complex& complex, Topological op, const Group& group) {
  hold(check_complement(complex, group, complement(complex, group)));
  const Components x = components_of(complex, group);
  hold(check_components(complex, x));
  hold(check_topological(complex, op, false, x, topological_operation(complex, op, x).value));
  hold(check_topological(complex, op, true, x, topological_operation_of_each(complex, op, x).value));
  check_simplified(complex, group);
}

}  // namespace

void run_soup(std::string_view bytes) {
  accept_errors([&] {
    SoupMaker maker(bytes);
    const auto complex = build_complex(maker.make());
    hold(validate(*complex));
    const std::vector<Group> leaves = leaf_groups(*complex);
    for (const Group& leaf : leaves) hold(check_group(*complex, leaf));
    const unsigned choice = maker.choice();
    const Group& a = leaves[choice % leaves.size()];
    const Group& b = leaves[choice / 4 % leaves.size()];
    check_leaf(*complex, static_cast<Topological>(choice / 16 % 4), a);
    check_pair(*complex, static_cast<Dominance>(choice / 64 % 3), a, b);
  });
}

}  // namespace cnrg::fuzz
