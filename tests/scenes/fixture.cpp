#include "tests/scenes/fixture.h"

#include <sstream>
#include <stdexcept>

namespace cnrg::scenes {
namespace {

Rational number(const std::string& word) {
  if (word.find("0x") != std::string::npos) return from_double(std::stod(word));
  const auto value = parse_rational(word);
  if (!value) throw std::invalid_argument("no number: " + word);
  return *value;
}

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, at);) parts.push_back(part);
  return parts;
}

Polygon points(const std::string& text) {
  Polygon result;
  for (const std::string& part : split(text, ',')) {
    std::istringstream in(part);
    std::vector<Rational> xyz;
    for (std::string word; in >> word;) xyz.push_back(number(word));
    if (xyz.size() != 3) throw std::invalid_argument("a point has three numbers: " + part);
    result.push_back({xyz[0], xyz[1], xyz[2]});
  }
  return result;
}

Fill fill(const std::string& word) {
  if (word == "sides") return Fill::sides;
  if (word == "winding") return Fill::winding;
  if (word == "parity") return Fill::parity;
  if (word == "cells") return Fill::cells;
  if (word == "none") return Fill::none;
  throw std::invalid_argument("no fill: " + word);
}

void parse_face(Leaf& leaf, std::string text) {
  Face face;
  face.sheet = true;
  if (const std::size_t colon = text.find(':'); colon != std::string::npos) {
    std::istringstream sides(text.substr(0, colon));
    if (!(sides >> face.front >> face.back)) throw std::invalid_argument("sides are two numbers: " + text);
    face.sheet = face.front == face.back;
    text = text.substr(colon + 1);
  }
  for (const std::string& loop : split(text, '|')) face.loops.push_back(points(loop));
  leaf.faces.push_back(std::move(face));
}

void parse_line(std::vector<Leaf>& leaves, const std::string& key, const std::string& rest) {
  if (key == "leaf") {
    std::istringstream in(rest);
    std::string word;
    in >> word;
    leaves.emplace_back();
    leaves.back().fill = fill(word);
    return;
  }
  if (leaves.empty()) throw std::invalid_argument("a fixture starts with a leaf");
  Leaf& leaf = leaves.back();
  const std::uint32_t region = leaf.fill == Fill::sides ? 1 : 0;
  if (key == "box") {
    const Polygon p = points(rest);
    add_solid(leaf, box_solid(p.at(0), p.at(1)), region);
  } else if (key == "tetrahedron") {
    const Polygon p = points(rest);
    add_solid(leaf, tetrahedron_solid({p.at(0), p.at(1), p.at(2), p.at(3)}), region);
  } else if (key == "prism") {
    const auto parts = split(rest, '|');
    add_solid(leaf, prism_solid(points(parts.at(1)), points(parts.at(0)).at(0)), region);
  } else if (key == "face") {
    parse_face(leaf, rest);
  } else if (key == "wire") {
    const Polygon p = points(rest);
    for (std::size_t i = 1; i < p.size(); ++i) leaf.wires.push_back({p[i - 1], p[i]});
  } else if (key == "point") {
    leaf.points.push_back(points(rest).at(0));
  } else {
    throw std::invalid_argument("no part of a fixture: " + key);
  }
}

}  // namespace

std::vector<Leaf> parse_fixture(const std::string& text) {
  std::vector<Leaf> leaves;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    line = line.substr(0, line.find('#'));
    std::istringstream words(line);
    std::string key, rest;
    if (!(words >> key)) continue;
    std::getline(words, rest);
    try {
      parse_line(leaves, key, rest);
    } catch (const std::exception& error) {
      throw std::invalid_argument(std::string(error.what()) + " in: " + line);
    }
  }
  return leaves;
}

}  // namespace cnrg::scenes
