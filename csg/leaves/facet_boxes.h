// Where the facets of a leaf lie on their patches, roughly: intervals that hold u and v of their corners.
//
// LeafParameters (parameters.h) has them exactly, corner by corner, and is only made when somebody asks, for the
// leaf has to be tessellated once more. What asks about all facets at every evaluation (whether surfaces cross as
// facets do) needs no more than these boxes, which cost next to nothing while the facets are made.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "kernel/exact/rational.h"

namespace cnrg {

class FacetBoxes {
 public:
  using Box = std::array<std::array<double, 2>, 2>;  ///< of u and of v: not above, not below

  /// The next facet, by the parameters of its corners.
  void add(std::span<const std::array<const Rational*, 2>> corners);
  /// The next face has no parameters.
  void add_flat() { boxes_.push_back({kNone, 0, 0, 0}); }

  /// What people call a patch.
  void name_patch(std::uint32_t patch, const char* name) { names_[patch] = name; }

  std::size_t size() const { return boxes_.size(); }
  bool empty() const;  ///< no face has parameters
  bool has(std::size_t facet) const { return boxes_[facet][0] != kNone; }
  Box of(std::size_t facet) const;
  /// Empty for a number without a name.
  std::string patch_name(std::uint32_t patch) const {
    const auto it = names_.find(patch);
    return it == names_.end() ? "" : it->second;
  }

 private:
  using Index = std::uint32_t;
  static constexpr Index kNone = 0xffffffffu;
  Index number(const Rational& value);

  std::vector<std::array<double, 2>> values_;  // below and above
  std::vector<std::array<Index, 4>> boxes_;    // numbers of the values below and above, of u and of v
  // Grids give the same objects over and over: of each place in memory the last value and its number.
  struct Known {
    Rational value;
    Index number = kNone;
  };
  std::array<Known, 64> known_;
  std::map<std::uint32_t, std::string> names_;
};

}  // namespace cnrg
