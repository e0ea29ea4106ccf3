#include "bench/cases/chain_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <sstream>
#include <vector>

#include "bench/cases/random.h"

namespace cnrg::bench {
namespace {

std::string corner_text(double x, double y, double z) {
  std::ostringstream text;
  text << "[" << x << ", " << y << ", " << z << "]";
  return text.str();
}

std::string node(const std::string& name, const std::string& left, const std::string& right) {
  return "  " + name + ": {union: [" + left + ", " + right + "]}\n";
}

std::string solids(const ScatteredSolids& s) {
  std::mt19937 engine(s.seed);
  const auto number = [&](int low, int high) { return low + static_cast<int>(engine() % (high - low + 1)); };
  const int side = static_cast<int>(std::ceil(std::cbrt(s.nodes + 1)));
  std::vector<int> places(static_cast<std::size_t>(side * side * side));
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = static_cast<int>(i);
  std::shuffle(places.begin(), places.end(), engine);
  std::string text;
  for (int i = 0; i <= s.nodes; ++i) {
    const int at = places[static_cast<std::size_t>(i % 10 == 9 ? i - 1 : i)], shift = i % 10 == 9 ? 3 : 0;
    const double x = 20 * (at % side) + shift, y = 20 * (at / side % side) + shift, z = 20 * (at / side / side);
    text += "  s" + std::to_string(i) + ": ";
    if (i % 2 == 0) {
      text += "{box: {min: " + corner_text(x, y, z) +
              ", max: " + corner_text(x + number(5, 10), y + number(5, 10), z + number(5, 10)) + "}}\n";
    } else {
      text += "{tetrahedron: [" + corner_text(x, y, z) + ", " + corner_text(x + number(6, 12), y, z + 1) + ", " +
              corner_text(x, y + number(6, 12), z + 2) + ", " + corner_text(x + 1, y + 2, z + number(6, 12)) +
              "]}\n";
    }
  }
  return text;
}

/// The i-th place of a way through a lattice of 10 x 10 x 10 places; the next one is always its neighbour.
std::array<int, 3> winding_place(int i) {
  const int z = i / 100, row = i / 10 % 10, column = i % 10;
  const int y = z % 2 == 0 ? row : 9 - row;
  return {(row + 10 * z) % 2 == 0 ? column : 9 - column, y, z};
}

/// A solid reaches beyond the faces of its place, 10 wide, into the next ones.
std::string winding_solid(int i, Random& random) {
  const auto [cx, cy, cz] = winding_place(i);
  const int x = 10 * cx, y = 10 * cy, z = 10 * cz;
  const auto high = [&] { return random.integer(13, 18); };
  const auto low = [&] { return random.integer(0, 3); };
  if (i % 2 == 0) {
    return "{box: {min: " + corner_text(x + low(), y + low(), z + low()) +
           ", max: " + corner_text(x + high(), y + high(), z + high()) + "}}\n";
  }
  return "{tetrahedron: [" + corner_text(x + low(), y + low(), z + low()) + ", " +
         corner_text(x + high(), y + high(), z + low()) + ", " + corner_text(x + high(), y + low(), z + high()) +
         ", " + corner_text(x + low(), y + high(), z + high()) + "]}\n";
}

}  // namespace

std::string scattered_chain(const ScatteredSolids& s) {
  std::string text = "cnrg: 1\nnodes:\n" + solids(s);
  for (int i = 1; i <= s.nodes; ++i) {
    const std::string left = i == 1 ? "s0" : "u" + std::to_string(i - 1);
    text += node("u" + std::to_string(i), left, "s" + std::to_string(i));
  }
  // Volumes by region are made for the result alone: it is a node of its own.
  return text + "  all: {simplify: u" + std::to_string(s.nodes) + "}\nresult: all\n";
}

std::string scattered_pairs(const ScatteredSolids& s) {
  std::string text = "cnrg: 1\nnodes:\n" + solids(s);
  for (int i = 1; i <= s.nodes; ++i) {
    text += node("u" + std::to_string(i), "s" + std::to_string(i - 1), "s" + std::to_string(i));
  }
  return text + "result: u1\n";
}

std::string winding_chain(int depth, unsigned seed) {
  Random random(seed);
  std::string text = "cnrg: 1\nnodes:\n";
  // From the far end, so that the largest coordinates are in every chain.
  for (int i = 0; i <= depth; ++i)
    text += "  s" + std::to_string(i) + ": " + winding_solid(999 - i % 1000, random);
  for (int i = 1; i <= depth; ++i) {
    const std::string left = i == 1 ? "s0" : "u" + std::to_string(i - 1);
    text += node("u" + std::to_string(i), left, "s" + std::to_string(i));
  }
  return text + "result: u" + std::to_string(depth) + "\n";
}

std::string shared_layers(int layers, unsigned seed) {
  Random random(seed);
  const auto name = [](int layer, int j) {
    return layer == 0 ? "s" + std::to_string(j) : "n" + std::to_string(layer) + "_" + std::to_string(j);
  };
  std::string text = "cnrg: 1\nnodes:\n";
  for (int j = 0; j <= layers; ++j) text += "  " + name(0, j) + ": " + winding_solid(j, random);
  for (int layer = 1; layer <= layers; ++layer) {
    for (int j = 0; j <= layers - layer; ++j)
      text += node(name(layer, j), name(layer - 1, j), name(layer - 1, j + 1));
  }
  return text + "result: " + name(layers, 0) + "\n";
}

}  // namespace cnrg::bench
