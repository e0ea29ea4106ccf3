// Materials of regions: one all over, or a mixture that changes with position (qian2003, kou2006).
//
// A *grade* is a function of position, t, and a mixture at some values of t, its *stops*: between two stops the
// fractions are linear in t, before the first and after the last they are constant. t is
//   linear    0 at `from`, 1 at `to`, and constant on planes at right angles to the way between them;
//   distance  the Euclidean distance, in units of the model, to the faces, wires and points of a node.
//
// The coordinates are those of the place where the material is put on a node: the node's own transforms are done,
// those of nodes above move material and shape together. So a grade has a placement.
//
// t is exact when linear; a distance is a root, rounded to the nearest double. All else is exact: fractions of a
// mixture are rationals of sum 1.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "csg/geometry/transform.h"

namespace cnrg {

class DistanceTo;

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

struct LinearGrade {
  RationalPoint from, to;  ///< different
  friend bool operator==(const LinearGrade&, const LinearGrade&) = default;
};

struct DistanceGrade {
  std::string to;                                  ///< name of the node
  std::shared_ptr<const DistanceTarget> target{};  ///< nullptr until the node is evaluated
  friend bool operator==(const DistanceGrade& a, const DistanceGrade& b) {
    return a.to == b.to && (a.target == b.target || (a.target && b.target && *a.target == *b.target));
  }
};

struct Grade {
  struct Stop {
    Rational at;
    Mixture mixture;
    friend bool operator==(const Stop&, const Stop&) = default;
  };
  std::variant<LinearGrade, DistanceGrade> along;
  std::vector<Stop> stops;  ///< ascending by `at`, one at least
  friend bool operator==(const Grade&, const Grade&) = default;
};

struct PlacedGrade {
  Grade grade;
  Transform placement;
  friend bool operator==(const PlacedGrade&, const PlacedGrade&) = default;
};

/// What a region is made of. Two are equal when names and functions of position are.
class RegionMaterial {
 public:
  RegionMaterial() = default;
  RegionMaterial(std::string name, std::shared_ptr<const PlacedGrade> grade = nullptr)
      : name_(std::move(name)), grade_(std::move(grade)) {}
  RegionMaterial(const char* name) : name_(name) {}
  bool empty() const { return name_.empty(); }  ///< none is given
  const std::string& name() const { return name_; }
  const PlacedGrade* grade() const { return grade_.get(); }  ///< nullptr: one material all over
  friend bool operator==(const RegionMaterial& a, const RegionMaterial& b) {
    return a.name_ == b.name_ && (a.grade_ == b.grade_ || (a.grade_ && b.grade_ && *a.grade_ == *b.grade_));
  }

 private:
  std::string name_;
  std::shared_ptr<const PlacedGrade> grade_;
};

/// The mixture of materials at any position, of one region. Keeps what a distance needs; not for several threads
/// at a time. `material` must outlive it.
class MaterialSampler {
 public:
  explicit MaterialSampler(const RegionMaterial& material);
  ~MaterialSampler();
  MaterialSampler(MaterialSampler&&) noexcept;
  /// Empty for the empty material. Throws InputError when the distance is beyond the range of double.
  Mixture at(const RationalPoint& p) const;
  /// All materials that it may hold, ascending.
  std::vector<std::string> names() const;

 private:
  const RegionMaterial& material_;
  Transform back_;  // the inverse of the placement
  std::unique_ptr<DistanceTo> distance_;
  Rational parameter(const RationalPoint& p) const;
};

/// `steel 3/4, ceramic 1/4`, for people: largest fraction first; one material alone has no number, long fractions
/// are decimals.
std::string to_text(const Mixture& mixture);

}  // namespace cnrg
