// Prepared leaves before they are placed, as moulds of pieces (pieces.h).
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "csg/curves/surface_math.h"
#include "csg/geometry/exact_numbers.h"
#include "csg/leaves/leaf.h"
#include "csg/leaves/parameters.h"

namespace cnrg {

/// A prepared leaf, before any transform, with the numbers of its points.
struct Mould {
  struct Cell {
    std::uint32_t patch = 0;
    std::vector<std::uint32_t> points;
    std::vector<std::array<Interval, 2>> at;
    std::vector<std::uint32_t> sides;  // of each side a number, equal for parts of one curve; 0: not known
    bool bent = false;                 // Piece::bent
  };
  struct Flat {
    std::uint32_t patch = 0;
    std::vector<std::vector<std::uint32_t>> loops;
    std::vector<std::uint32_t> curves;  // numbers of its sides, of a net
    bool wall = false;                  // Piece::wall
  };
  struct Wire {
    std::uint32_t number = 0;
    std::array<std::uint32_t, 2> points{};
    std::array<Interval, 2> at{0, 0};
  };
  std::vector<Cell> cells;
  std::vector<Flat> flats;
  std::vector<Wire> wires;
  std::vector<std::uint32_t> isolated;
  std::shared_ptr<const LeafSurfaces> surfaces;
  std::optional<RationalPoint> rulings;  // of an extrusion
  bool torn = false;                     // facets of no area are missing
  bool one_round_surface = false;  // a ball, a ring, a cylinder or cone with its discs: it does not meet itself

  explicit Mould(const PreparedLeaf& leaf);
  /// Equal points have one number.
  std::size_t point_count() const { return of_cells_ + others_.all().size(); }
  const RationalPoint& point(std::uint32_t number) const {
    return number < of_cells_ ? parameters_->points()[number]
                              : others_[number - static_cast<std::uint32_t>(of_cells_)];
  }

 private:
  std::uint32_t number_of(const RationalPoint& p);
  /// Two triangles of which the sides in common are diagonals of one rectangle of parameters become one cell.
  void unite_triangles();

  std::shared_ptr<const LeafParameters> parameters_;
  std::size_t of_cells_ = 0;  // points of parameters
  ExactNumbers<RationalPoint> others_;
};

/// Of leaves, kept from one drawing to the next.
class Moulds {
 public:
  const Mould& of(const std::shared_ptr<const PreparedLeaf>& leaf);

 private:
  std::map<std::shared_ptr<const PreparedLeaf>, std::unique_ptr<const Mould>> of_;
};

}  // namespace cnrg
