// Leaves as a tree file, so that a failure can be kept as a fixture and run by hand.
#include <map>
#include <sstream>

#include "tests/scenes/scene.h"

namespace cnrg::scenes {

const char* name(Fill fill) {
  switch (fill) {
    case Fill::none: return "none";
    case Fill::winding: return "winding";
    case Fill::parity: return "parity";
    case Fill::cells: return "cells";
    case Fill::solids: return "solids";
    case Fill::sides: break;
  }
  return "sides";
}

std::string group_text(const Leaf& leaf) {
  std::ostringstream out;
  std::map<RationalPoint, std::size_t> numbers;
  std::vector<RationalPoint> vertices;
  const auto number = [&](const RationalPoint& p) {
    const auto [it, fresh] = numbers.emplace(p, vertices.size());
    if (fresh) vertices.push_back(p);
    return it->second;
  };
  std::ostringstream faces, edges, points;
  for (const Face& face : leaf.faces) {
    faces << "        - {loops: [";
    for (std::size_t l = 0; l < face.loops.size(); ++l) {
      faces << (l ? ", [" : "[");
      for (std::size_t i = 0; i < face.loops[l].size(); ++i) faces << (i ? ", " : "") << number(face.loops[l][i]);
      faces << "]";
    }
    faces << "]";
    if (leaf.fill == Fill::sides) faces << ", sides: [" << face.front << ", " << face.back << "]";
    faces << "}\n";
  }
  for (std::size_t i = 0; i < leaf.wires.size(); ++i)
    edges << (i ? ", " : "") << "[" << number(leaf.wires[i][0]) << ", " << number(leaf.wires[i][1]) << "]";
  for (std::size_t i = 0; i < leaf.points.size(); ++i) points << (i ? ", " : "") << number(leaf.points[i]);
  out << "      vertices:\n";
  for (const RationalPoint& p : vertices)
    out << "        - [\"" << to_string(p[0]) << "\", \"" << to_string(p[1]) << "\", \"" << to_string(p[2])
        << "\"]\n";
  if (!leaf.faces.empty()) out << "      faces:\n" << faces.str();
  if (!leaf.wires.empty()) out << "      edges: [" << edges.str() << "]\n";
  if (!leaf.points.empty()) out << "      points: [" << points.str() << "]\n";
  if (leaf.fill != Fill::sides) out << "      fill: " << name(leaf.fill) << "\n";
  return out.str();
}

std::string tree_file(const std::vector<Leaf>& leaves) {
  std::ostringstream out;
  out << "cnrg: 1\nnodes:\n";
  std::string all;
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    out << "  leaf" << i << ":\n    group:\n" << group_text(leaves[i]);
    all += (i == 0 ? "leaf" : ", leaf") + std::to_string(i);
  }
  out << "  all: {union: [" << all << "]}\nresult: all\n";
  return out.str();
}

}  // namespace cnrg::scenes
