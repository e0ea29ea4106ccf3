// Numbers are exact: fractions stand in quotes.
#include "bench/cases/model_text.h"

#include <array>
#include <cstdint>
#include <map>

#include "csg/text/escape.h"
#include "csg/text/json_text.h"

namespace cnrg::bench {
namespace {

template <class List, class Text>
std::string list_text(const List& list, Text text) {
  std::string out;
  for (const auto& item : list) out += (out.empty() ? "" : ", ") + text(item);
  return "[" + out + "]";
}

std::string place_text(const RationalPoint& p) {
  return list_text(p, [](const Rational& x) {
    const std::string text = cnrg::to_string(x);
    return text.find('/') == std::string::npos ? text : '"' + text + '"';
  });
}

/// The points of some places, and the numbers of all places among them.
struct Numbered {
  std::vector<RationalPoint> points;
  std::map<std::uint32_t, std::size_t> number;
  void use(const Model& model, std::uint32_t p) {
    if (number.emplace(p, points.size()).second) points.push_back(model.points[p]);
  }
};

void faces_text(const Model& model, bool solid, std::vector<std::string>& leaves) {
  Numbered used;
  std::vector<std::vector<std::uint32_t>> loops;
  for (const Model::Face& face : model.faces)
    if (face.solid == solid)
      for (const auto& loop : face.loops) {
        loops.push_back(loop);
        for (const std::uint32_t p : loop) used.use(model, p);
      }
  if (loops.empty()) return;
  leaves.push_back("{mesh: {points: " + list_text(used.points, place_text) + ", faces: " +
                   list_text(loops,
                             [&](const auto& loop) {
                               return list_text(
                                   loop, [&](std::uint32_t p) { return std::to_string(used.number.at(p)); });
                             }) +
                   ", fill: " + (solid ? "winding" : "none") + "}}");
}

/// Wires that hang together as one walk, which comes back along those that it went.
std::vector<std::vector<std::uint32_t>> walks(const std::vector<std::array<std::uint32_t, 2>>& wires) {
  std::map<std::uint32_t, std::vector<std::size_t>> at;
  for (std::size_t w = 0; w < wires.size(); ++w)
    for (const std::uint32_t p : wires[w]) at[p].push_back(w);
  std::vector<bool> used(wires.size(), false);
  std::vector<std::vector<std::uint32_t>> found;
  for (std::size_t w = 0; w < wires.size(); ++w) {
    if (used[w]) continue;
    std::vector<std::uint32_t> way = {wires[w][0]}, walk = way;
    std::size_t end = 0;  // of the walk when the last wire was new
    while (!way.empty()) {
      std::vector<std::size_t>& left = at[way.back()];
      while (!left.empty() && used[left.back()]) left.pop_back();
      if (left.empty()) {
        way.pop_back();
        if (!way.empty()) walk.push_back(way.back());
        continue;
      }
      const auto& [a, b] = wires[left.back()];
      used[left.back()] = true;
      way.push_back(a == way.back() ? b : a);
      walk.push_back(way.back());
      end = walk.size();
    }
    walk.resize(end);
    found.push_back(std::move(walk));
  }
  return found;
}

}  // namespace

std::string node_text(const Model& model, const std::string& attributes) {
  std::vector<std::string> leaves;
  faces_text(model, true, leaves);
  faces_text(model, false, leaves);
  for (const std::vector<std::uint32_t>& walk : walks(model.wires)) {
    std::vector<RationalPoint> places;
    for (const std::uint32_t p : walk) places.push_back(model.points[p]);
    leaves.push_back("{polyline: " + list_text(places, place_text) + "}");
  }
  std::vector<RationalPoint> isolated;
  for (const std::uint32_t p : model.isolated) isolated.push_back(model.points[p]);
  if (!isolated.empty()) leaves.push_back("{points: " + list_text(isolated, place_text) + "}");
  if (leaves.empty()) return "{intersection: [{points: [[0, 0, 0]]}, {points: [[1, 0, 0]]}]}";
  std::string text =
      leaves.size() == 1 ? leaves[0] : "{union: " + list_text(leaves, [](const auto& leaf) { return leaf; }) + "}";
  if (!attributes.empty()) text.insert(text.size() - 1, ", " + attributes);
  return text;
}

std::string quoted_text(const std::string& text) {
  std::string quoted;
  append_json(quoted, shown(text));
  return quoted;
}

}  // namespace cnrg::bench
