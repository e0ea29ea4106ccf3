// The witness on solids whose volumes are known by hand, and on answers that are wrong by little. Linked with GMP
// and the room alone: it can share nothing with the kernel.
#include "bench/witness/points.h"
#include "tests/catch.h"

namespace cnrg::bench::witness {
namespace {

Cycle box(const Point& low, const Point& high) {
  Cycle cycle;
  for (int i = 0; i < 8; ++i)
    cycle.points.push_back({i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 4 ? high[2] : low[2]});
  const std::uint32_t sides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                     {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& s : sides) cycle.add_loop({s[0], s[1], s[2], s[3]});
  return cycle;
}

/// The corner of the positive octant below x/a + y/b + z/c = 1.
Cycle corner(const Number& a, const Number& b, const Number& c) {
  Cycle cycle{{{0, 0, 0}, {a, 0, 0}, {0, b, 0}, {0, 0, c}}, {}};
  cycle.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return cycle;
}

Cycle together(Cycle a, const Cycle& b) {
  const auto first = static_cast<std::uint32_t>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const auto& [p, q, r] : b.triangles) a.triangles.push_back({p + first, q + first, r + first});
  return a;
}

Cycle inside_out(Cycle cycle) {
  for (auto& t : cycle.triangles) std::swap(t[1], t[2]);
  return cycle;
}

/// Nothing stays vertical or level; volumes are doubled.
Cycle turned(Cycle cycle) {
  for (Point& p : cycle.points) p = {p[1] + p[0] / 3, p[2], p[0] * Number(43, 21) + p[1] / 7 - 2 * p[2]};
  return cycle;
}

Number value(const std::vector<const Cycle*>& cycles) {
  const std::optional<Fraction> found = integral(cycles, 1000000);
  REQUIRE(found);
  Number value(found->p, found->q);
  value.canonicalize();
  return value;
}

const Cycle kA = box({0, 0, 0}, {2, 2, 2}), kB = box({1, 1, 1}, {3, 3, 3});
constexpr std::size_t kMost = 1000000;
const Number kHair("1/1000000000000000000000");

}  // namespace

TEST_CASE("integrals of products are volumes of intersections") {
  CHECK(value({&kA}) == 8);
  CHECK(value({&kA, &kB}) == 1);
  CHECK(value({&kA, &kA}) == 8);
  const Cycle octant = corner(1, 1, 1), flat = corner(2, 2, Number(1, 2));
  CHECK(value({&octant}) == Number(1, 6));
  // The parts of the unit box, and of the octant below x/2 + y/2 + 2z = 1: by hand.
  const Cycle unit = box({0, 0, 0}, {1, 1, 1});
  CHECK(value({&octant, &unit}) == Number(1, 6));
  // min(1 - s, 1/2 - s/4) over the triangle s = x + y <= 1, whose slices have length s: they meet at s = 2/3.
  CHECK(value({&octant, &flat}) == Number(2, 9) * Number(1, 2) - Number(8, 81) * Number(1, 4) +
                                       (Number(1, 2) - Number(2, 9)) - (Number(1, 3) - Number(8, 81)));
  CHECK(value({&octant, &flat, &unit}) == value({&octant, &flat}));
  CHECK(value({&kA, &octant, &unit}) == Number(1, 6));
  const Cycle a = turned(kA), b = turned(kB), c = turned(box({0, 0, 0}, {Number(3, 2), 3, 3}));
  CHECK(value({&a}) == 16);
  CHECK(value({&a, &b}) == 2);
  CHECK(value({&a, &b, &c}) == 1);
  const Cycle twice = together(kA, kB), back = inside_out(kA);
  CHECK(value({&twice}) == 16);
  CHECK(value({&twice, &twice}) == 8 + 8 + 2);
  CHECK(value({&back}) == -8);
  CHECK_FALSE(integral({&kA, &kB}, 3));
}

TEST_CASE("the distance of an answer is zero for the Boolean alone") {
  struct Answer {
    Operation operation;
    Cycle right;
    Number volume;
  };
  const Cycle a = kA, b = box({1, 0, 0}, {3, 2, 2});
  const Answer answers[] = {{Operation::unite, box({0, 0, 0}, {3, 2, 2}), 12},
                            {Operation::subtract, box({0, 0, 0}, {1, 2, 2}), 4},
                            {Operation::intersect, box({1, 0, 0}, {2, 2, 2}), 4}};
  for (const auto& [operation, right, volume] : answers) {
    for (const bool turn : {false, true}) {
      const auto put = [&](const Cycle& cycle) { return turn ? turned(cycle) : cycle; };
      const Number scale = turn ? 2 : 1;
      const auto apart = [&](const Cycle& answer) {
        return distance(put(a), operation, put(b), put(answer), kMost);
      };
      const auto same = apart(right);
      REQUIRE(same);
      CHECK(same->operands_once);
      CHECK(same->zero);
      CHECK(same->value == 0);
      Cycle hair = right;
      for (Point& p : hair.points)
        if (p[2] == 2) p[2] += kHair;
      CHECK_FALSE(apart(hair)->zero);
      CHECK(apart(hair)->value == Approx(Number(volume / 2 * kHair * scale).get_d()));
      CHECK(apart(Cycle())->value == Approx(Number(volume * scale).get_d()));
      CHECK(apart(inside_out(right))->value == Approx(Number(4 * volume * scale).get_d()));
      CHECK(apart(together(right, right))->value == Approx(Number(volume * scale).get_d()));
    }
  }
  CHECK_FALSE(distance(together(a, a), Operation::unite, b, a, kMost)->operands_once);
  CHECK_FALSE(distance(a, Operation::unite, b, a, 10));
}

TEST_CASE("surfaces are closed wherever their corners are") {
  CHECK(is_closed(kA));
  CHECK(is_closed(Cycle()));
  Cycle open = kA;
  open.triangles.pop_back();
  CHECK_FALSE(is_closed(open));
  CHECK_FALSE(is_closed(turned(open)));
  // One side cut in two, with a corner in the middle of its neighbours' edges.
  Cycle cut = kA;
  cut.triangles.resize(10);
  cut.points.push_back({2, 1, 0});
  cut.points.push_back({2, 1, 2});
  cut.add_loop({1, 8, 9, 5});
  cut.add_loop({8, 3, 7, 9});
  CHECK(is_closed(cut));
  cut.points[9] = {2, 1 + kHair, 2};
  CHECK(is_closed(cut));
  cut.points[9] = {2 + kHair, 1, 2};
  CHECK_FALSE(is_closed(cut));
}

TEST_CASE("points are in, out, or nobody says") {
  const Locator locator(kA);
  CHECK(locator.winding({Number(1, 3), Number(1, 7), 1}) == 1);
  CHECK(locator.winding({Number(1, 3), Number(1, 7), 3}) == 0);
  CHECK(locator.winding({Number(1, 3), Number(1, 7), -3}) == 0);
  CHECK(locator.winding({Number(1, 3), Number(1, 7), 2 - kHair}) == 1);
  CHECK(locator.winding({Number(1, 3), Number(1, 7), 2 + kHair}) == 0);
  CHECK(locator.winding({2 - kHair, Number(1, 7), 1}) == 1);
  CHECK(locator.winding({2 + kHair, Number(1, 7), 1}) == 0);
  CHECK_FALSE(locator.winding({Number(1, 3), Number(1, 7), 2}));  // on a face
  CHECK_FALSE(locator.winding({1, 1, 1}));                        // below a diagonal
  CHECK_FALSE(locator.winding({2, 1, 1}));
  const Cycle both = together(kA, kA), back = inside_out(kA);
  CHECK(Locator(both).winding({Number(1, 3), Number(1, 7), 1}) == 2);
  CHECK(Locator(back).winding({Number(1, 3), Number(1, 7), 1}) == -1);
  CHECK(locator.may_be_near({1, 1, 3}, 1));
  CHECK_FALSE(locator.may_be_near({1, 1, 3}, Number(99, 100)));
}

TEST_CASE("points tell a wrong fold from the right one, and leave the rounding alone") {
  // A plate less two holes, and a third box on it.
  const auto hole = [](int x) { return box({x, 1, -1}, {x + 1, 2, 2}); };
  Question q;
  q.operands = {box({0, 0, 0}, {5, 3, 1}), hole(1), hole(3), box({0, 0, 1}, {1, 1, 2})};
  q.steps = {Operation::subtract, Operation::subtract, Operation::unite};
  const auto with = [&](const Cycle& less) {  // chains add: faces on each other cancel
    return together(together(together(q.operands[0], q.operands[3]), inside_out(box({1, 1, 0}, {2, 2, 1}))), less);
  };
  q.answer = with(inside_out(box({3, 1, 0}, {4, 2, 1})));
  const Points right = ask(q, 200);
  CHECK(right.asked > 150);
  CHECK_FALSE(right.differs);
  q.answer = with({});
  const Points wrong = ask(q, 200);
  REQUIRE(wrong.differs);
  CHECK(wrong.winding == 1);
  CHECK_FALSE(wrong.expected);
  CHECK(ask(q, 200).differs == wrong.differs);
  // Thinner than the rounding at a face, then thicker.
  q = {{kA, kB}, {Operation::intersect}, box({1, 1, 1}, {2, 2, 2 + Number(1, 1000)}), Number(1, 100)};
  CHECK_FALSE(ask(q, 500).differs);
  q.rounding = Number(1, 100000);
  CHECK(ask(q, 500).differs);
}

}  // namespace cnrg::bench::witness
