// Random leaves on a coarse lattice, so that most of what can coincide or touch does: how fine they are drawn,
// where the scene lies and in which order its leaves come changes no count. CNRG_SEEDS and CNRG_FIRST_SEED as for
// cubical pairs.
#include <cstdlib>
#include <random>
#include <string>

#include "csg/evaluate/evaluate.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

std::uint64_t from_environment(const char* variable, std::uint64_t otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

class Scene {
 public:
  explicit Scene(std::uint64_t seed) : random_(seed) {}

  int among(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  std::string half(int low, int high) {
    const int twice = among(2 * low, 2 * high);
    return std::to_string(twice / 2) + (twice % 2 == 0 ? "" : twice > 0 ? ".5" : ".5");
  }
  /// Fine enough for what the lattice keeps apart.
  std::string fineness() { return "segments: " + std::to_string(among(25, 44)); }

  /// A leaf about the z axis; its fineness is drawn from another generator, so that it alone may differ.
  std::string coaxial(Scene& fine) {
    const int z = among(0, 4), height = among(1, 3), r = among(1, 3), kind = among(0, 4);
    const auto at = [](int t) { return "[0, 0, " + std::to_string(t) + "]"; };
    const bool down = among(0, 1) == 1;
    const std::string ends = "from: " + at(down ? z + height : z) + ", to: " + at(down ? z : z + height);
    const std::string radius = ", radius: " + std::to_string(r) + ", ";
    if (kind == 0) return "cylinder: {" + ends + radius + fine.fineness() + "}";
    if (kind == 1)
      return "cone: {" + ends + radius + "top: " + std::to_string((r + among(1, 2)) % 4) + ", " + fine.fineness() +
             "}";
    if (kind == 2)
      return "torus: {center: " + at(z) + ", axis: [0, 0, " + (down ? "-1" : "2") +
             "], radius: " + std::to_string(r + 1) + ", tube: " + std::to_string(among(1, r)) + ", " +
             fine.fineness() + ", rings: " + std::to_string(fine.among(25, 36)) + "}";
    return "sphere: {center: " + at(z) + radius + fine.fineness() + "}";
  }

  /// A leaf anywhere on the lattice, along an axis of coordinates.
  std::string anywhere(Scene& fine) {
    const auto point = [&] { return std::array<int, 3>{among(0, 3), among(0, 3), among(0, 3)}; };
    const auto text = [](const std::array<int, 3>& p) {
      return "[" + std::to_string(p[0]) + ", " + std::to_string(p[1]) + ", " + std::to_string(p[2]) + "]";
    };
    const std::array<int, 3> p = point();
    const int kind = among(0, 3);
    std::array<int, 3> q = p;
    q[static_cast<std::size_t>(among(0, 2))] += among(1, 3);
    if (kind == 0)
      return "box: {min: " + text(p) +
             ", max: " + text({p[0] + among(1, 2), p[1] + among(1, 2), p[2] + among(1, 2)}) + "}";
    if (kind == 1)
      return "cylinder: {from: " + text(p) + ", to: " + text(q) + ", radius: 1, " + fine.fineness() + "}";
    return "sphere: {center: " + text(p) + ", radius: 1, " + fine.fineness() + "}";
  }

  std::string nodes(int leaves, bool one_axis, Scene& fine, const std::string& at, const std::vector<int>& order) {
    std::vector<std::string> lines;
    for (int i = 0; i < leaves; ++i) {
      lines.push_back("  n" + std::to_string(i) + ": {" + (one_axis ? coaxial(fine) : anywhere(fine)) + at +
                      "}\n");
    }
    std::string text;
    for (const int i : order) text += lines[static_cast<std::size_t>(i)];
    std::string last = "n0";
    for (int i = 1; i < leaves; ++i) {
      const char* const operators[] = {"union", "union", "difference", "intersection"};
      const std::string name = "m" + std::to_string(i);
      text += "  " + name + ": {" + operators[among(0, 3)] + ": [" + last + ", n" + std::to_string(i) + "]}\n";
      last = name;
    }
    return "cnrg: 1\nnodes:\n" + text + "result: " + last + "\n";
  }

 private:
  std::mt19937_64 random_;
};

std::vector<std::array<std::size_t, 4>> counts(const std::string& text, std::size_t leaves) {
  EvaluateOptions options;
  options.validate = true;
  std::vector<std::array<std::size_t, 4>> result;
  for (const NodeRow& row : evaluate(parse_tree(text, "random.yaml"), options).rows) {
    if (row.name[0] == 'm') result.push_back(row.cells);
  }
  REQUIRE(result.size() + 1 == leaves);
  return result;
}

void check_scenes(std::uint64_t count, bool one_axis) {
  const std::uint64_t first = from_environment("CNRG_FIRST_SEED", 0);
  count = from_environment("CNRG_SEEDS", count);
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const int leaves = one_axis ? 2 + static_cast<int>(seed % 3) : 2;
    std::vector<int> order(static_cast<std::size_t>(leaves));
    for (int i = 0; i < leaves; ++i) order[static_cast<std::size_t>(i)] = i;
    Scene first_fine(seed + 1'000'000), other_fine(seed + 2'000'000);
    const std::string one = Scene(seed).nodes(leaves, one_axis, first_fine, "", order);
    std::reverse(order.begin(), order.end());
    const std::string place =
        ", rotate: {axis: [1, 2, 3], degrees: " + std::to_string(seed % 360) + "}, translate: [0.1, 0.2, 0.3]";
    const std::string other = Scene(seed).nodes(leaves, one_axis, other_fine, place, order);
    INFO("seed " << seed << "\n" << one << other);
    REQUIRE(counts(one, order.size()) == counts(other, order.size()));
  }
}

TEST_CASE("random leaves about one axis have counts that no fineness and no place changes", "[random]") {
  check_scenes(150, true);
}

TEST_CASE("random pairs of leaves on a lattice have counts that no fineness and no place changes", "[random]") {
  check_scenes(200, false);
}

}  // namespace
}  // namespace cnrg
