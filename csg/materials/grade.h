// Mixtures that change with position (qian2003, kou2006).
//
// A *grade* is a function of position, t, and a mixture at some values of t, its *stops*: between two stops the
// fractions are linear in t, before the first and after the last they are constant. t is
//   linear    0 at `from`, 1 at `to`, and constant on planes at right angles to the way between them;
//   distance  the Euclidean distance, in units of the model, to the faces, wires and points of a node;
//   blend     in what two regions have in common: 0 on the boundary of the second, where all is of the first, and
//   1
//             on that of the first: t = d2 / (d1 + d2) of the distances to both, and 1/2 where the two meet. It
//             has no stops: what it mixes are the materials of two regions, each at its place.
//
// A stop may be of materials that are graded themselves, and so may theirs. Nested grades stand where the outer
// one does, so they are a flat list of names beside it: a material that many stops name is there once, and nothing
// here calls itself, however deep they nest.
//
// The coordinates are those of the place where the material is put on a node: the node's own transforms are done,
// those of nodes above move material and shape together. So a grade has a placement.
//
// t is exact when linear; a distance is a root, rounded to the nearest double. All else is exact: fractions of a
// mixture are rationals of sum 1, those of nested grades products of these.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "csg/geometry/transform.h"
#include "csg/materials/material.h"

namespace cnrg {

/// Fractions by material, ascending by name, none zero, of sum 1.
using Mixture = std::vector<std::pair<std::string, Rational>>;

/// Simplices by numbers of points: what a distance is measured to.
struct DistanceTarget {
  std::vector<RationalPoint> points;
  std::vector<std::array<std::uint32_t, 1>> vertices;
  std::vector<std::array<std::uint32_t, 2>> segments;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  bool empty() const { return vertices.empty() && segments.empty() && triangles.empty(); }
  friend bool operator==(const DistanceTarget&, const DistanceTarget&) = default;
};
using SharedTarget = std::shared_ptr<const DistanceTarget>;

struct LinearGrade {
  RationalPoint from, to;  ///< different
  friend bool operator==(const LinearGrade&, const LinearGrade&) = default;
};

struct DistanceGrade {
  std::string to;         ///< name of the node
  SharedTarget target{};  ///< nullptr until the node is evaluated
  friend bool operator==(const DistanceGrade& a, const DistanceGrade& b);
};

struct BlendGrade {
  struct Side {
    RegionMaterial material;  ///< its grade is placed in the coordinates of the blend
    SharedTarget boundary;    ///< of the region
    friend bool operator==(const Side&, const Side&);
  };
  Side first, second;
  friend bool operator==(const BlendGrade&, const BlendGrade&) = default;
};

struct Grade {
  struct Stop {
    Rational at;
    Mixture mixture;
    friend bool operator==(const Stop&, const Stop&) = default;
  };
  std::variant<LinearGrade, DistanceGrade, BlendGrade> along;
  std::vector<Stop> stops;  ///< ascending by `at`; one at least, none of a blend
  friend bool operator==(const Grade&, const Grade&) = default;
};

struct PlacedGrade {
  Grade grade;
  Transform placement;
  /// The graded materials that stops name, and those that their stops name; none of them blends. No material is
  /// reached from itself.
  std::map<std::string, Grade> nested{};
  friend bool operator==(const PlacedGrade&, const PlacedGrade&) = default;
};

/// Calls `see` with each name in the stops of a grade and of those nested in it, and with the materials of blends
/// and all that these name. A name may come more than once.
void for_each_name(const PlacedGrade& grade, const std::function<void(const std::string&)>& see);

/// Names of materials joined by ` & `, each once and in the order of the alphabet: what a blend is called does not
/// depend on the order of its operands.
std::string blended_name(const RegionMaterial& a, const RegionMaterial& b);

}  // namespace cnrg
