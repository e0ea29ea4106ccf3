#include "bench/cases/tree_cases.h"

#include <cmath>
#include <cstdio>

#include "bench/cases/random.h"

namespace cnrg::bench {
namespace {

constexpr int kSides = 24;

using Thousandths = std::array<int, 3>;

std::string tree_of(const std::string& nodes, const std::string& result) {
  return "cnrg: 1\nnodes:\n" + nodes + "result: " + result + "\n";
}

std::string list_of(const std::string& prefix, int count) {
  std::string list;
  for (int i = 0; i < count; ++i) list += (i == 0 ? "" : ", ") + prefix + std::to_string(i);
  return list;
}

std::string decimal(int thousandths) {
  char text[32];
  std::snprintf(text, sizeof text, "%s%d.%03d", thousandths < 0 ? "-" : "", std::abs(thousandths) / 1000,
                std::abs(thousandths) % 1000);
  return text;
}

std::string point_text(const Thousandths& p) {
  return "[" + decimal(p[0]) + ", " + decimal(p[1]) + ", " + decimal(p[2]) + "]";
}

/// `plate` and `c0`, `c1`, ... .
std::string plate_leaves(const PlateWithHoles& plate) {
  const std::string side = std::to_string(plate.side() * PlateWithHoles::kSpacing);
  std::string text = "  plate: {box: {min: [0, 0, 0], max: [" + side + ", " + side + ", " +
                     std::to_string(PlateWithHoles::kHeight) + "]}}\n";
  for (int k = 0; k < plate.holes; ++k) {
    text += "  c" + std::to_string(k) + ": {prism: {base: [";
    for (const auto& [x, y] : plate.section(k))
      text += "[" + std::to_string(x) + ", " + std::to_string(y) + ", -" +
              std::to_string(PlateWithHoles::kHeight) + "], ";
    text.resize(text.size() - 2);
    text += "], vector: [0, 0, " + std::to_string(3 * PlateWithHoles::kHeight) + "]}}\n";
  }
  return text;
}

/// Random in direction; of length 1 but for rounding.
std::array<double, 3> direction(Random& random) {
  const double z = random.real(-1, 1), around = random.real(0, 2 * M_PI), flat = std::sqrt(1 - z * z);
  return {flat * std::cos(around), flat * std::sin(around), z};
}

/// Its corners are its centre plus and minus two vectors, so that they lie in a plane exactly.
std::string fracture_text(Random& random) {
  const double radius = random.real(10, 40);
  const std::array<double, 3> a = direction(random), other = direction(random);
  std::array<double, 3> b{a[1] * other[2] - a[2] * other[1], a[2] * other[0] - a[0] * other[2],
                          a[0] * other[1] - a[1] * other[0]};
  const double length = std::sqrt(b[0] * b[0] + b[1] * b[1] + b[2] * b[2]);
  std::array<Thousandths, 4> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const int centre = random.integer(0, 100000);
    const int u = static_cast<int>(std::lround(1000 * radius * a[k]));
    const int v = static_cast<int>(std::lround(1000 * radius * b[k] / length));
    corners[0][k] = centre + u;
    corners[1][k] = centre + v;
    corners[2][k] = centre - u;
    corners[3][k] = centre - v;
  }
  return "{polygon: [" + point_text(corners[0]) + ", " + point_text(corners[1]) + ", " + point_text(corners[2]) +
         ", " + point_text(corners[3]) + "]}";
}

const char* const kUnitBox = "  unit: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n";

/// `s<k>` and what the unit box leaves of it, `k<k>`.
std::vector<std::string> cuts(int count, unsigned seed) {
  Random random(seed);
  std::vector<std::string> texts;
  for (int k = 0; k < count; ++k) {
    Thousandths centre{};
    for (int& x : centre) x = random.integer(-200, 1200);
    const std::string number = std::to_string(k);
    texts.push_back("  s" + number + ": {sphere: {center: " + point_text(centre) +
                    ", radius: " + decimal(random.integer(200, 600)) + ", segments: 32}}\n  k" + number +
                    ": {intersection: [s" + number + ", unit]}\n");
  }
  return texts;
}

}  // namespace

int PlateWithHoles::side() const { return static_cast<int>(std::ceil(std::sqrt(holes))); }

std::vector<std::array<int, 2>> PlateWithHoles::section(int k) const {
  const int x = k % side() * kSpacing + kSpacing / 2, y = k / side() * kSpacing + kSpacing / 2;
  std::vector<std::array<int, 2>> corners;
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2 * M_PI * i / kSides;
    corners.push_back({x + static_cast<int>(std::lround(kRadius * std::cos(angle))),
                       y + static_cast<int>(std::lround(kRadius * std::sin(angle)))});
  }
  return corners;
}

long long PlateWithHoles::volume() const {
  const long long width = 1LL * side() * kSpacing;
  long long doubled_area = 0;
  const auto corners = section(0);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto& [x, y] = corners[i];
    const auto& [u, v] = corners[(i + 1) % corners.size()];
    doubled_area += 1LL * x * v - 1LL * y * u;
  }
  return width * width * kHeight - holes * doubled_area * (kHeight / 2);
}

std::string plate_difference(int holes) {
  const std::string all = "  all: {difference: [plate, " + list_of("c", holes) + "]}\n";
  return tree_of(plate_leaves({holes}) + all, "all");
}

std::string plate_chain(int holes) {
  std::string text = plate_leaves({holes}), last = "plate";
  for (int k = 0; k < holes; ++k) {
    const std::string number = std::to_string(k);
    text += "  d" + number + ": {difference: [" + last + ", c" + number + "]}\n";
    last = "d" + number;
  }
  return tree_of(text, last);
}

std::string fractures_in_block(int count, unsigned seed) {
  Random random(seed);
  std::string text = "  block: {box: {min: [0, 0, 0], max: [100, 100, 100]}}\n";
  for (int i = 0; i < count; ++i) text += "  f" + std::to_string(i) + ": " + fracture_text(random) + "\n";
  return tree_of(text + "  fractures: {union: [" + list_of("f", count) + "]}\n" +
                     "  inside: {intersection: [fractures, block]}\n  all: {union: [block, inside]}\n",
                 "all");
}

std::string cut_spheres(int count, unsigned seed) {
  std::string text = kUnitBox;
  for (const std::string& cut : cuts(count, seed)) text += cut;
  return tree_of(text + "  all: {union: [" + list_of("k", count) + "]}\n", "all");
}

std::vector<std::string> cut_spheres_apart(int count, unsigned seed) {
  std::vector<std::string> trees = cuts(count, seed);
  for (std::size_t k = 0; k < trees.size(); ++k) trees[k] = tree_of(kUnitBox + trees[k], "k" + std::to_string(k));
  return trees;
}

std::string shared_boxes(int doublings) {
  std::string text = "  n0: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n";
  for (int i = 0; i < doublings; ++i) {
    std::array<int, 3> move{};
    move[i % 3] = 2 << (i / 3);
    const std::string number = std::to_string(i);
    text += "  t" + number + ": {simplify: n" + number + ", translate: [" + std::to_string(move[0]) + ", " +
            std::to_string(move[1]) + ", " + std::to_string(move[2]) + "]}\n  n" + std::to_string(i + 1) +
            ": {union: [n" + number + ", t" + number + "]}\n";
  }
  return tree_of(text, "n" + std::to_string(doublings));
}

}  // namespace cnrg::bench
