// A group as a set of independent parts, so that an operator touches only the parts that meet.
//
// The tables decide about an entity by what lies around it. An entity of a part that shares no point with the
// other operand is outside of all its regions (AoutB, BoutA), whose rows keep always or remove always: such a part
// is carried over or dropped as a whole, and never read (fold.h). A chain of unions of solids scattered in space
// so costs per node what one union costs, and pointers.
//
// Parts are immutable and shared between values.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "csg/operators/group.h"
#include "kernel/selection/simplify.h"

namespace cnrg {

/// A closed axis-parallel box, rounded outward; it may be infinite.
struct PartBox {
  std::array<float, 3> low, high;
  bool meets(const PartBox& other) const {
    return low[0] <= other.high[0] && other.low[0] <= high[0] && low[1] <= other.high[1] &&
           other.low[1] <= high[1] && low[2] <= other.high[2] && other.low[2] <= high[2];
  }
};

struct PartVolume {
  Rational bounded;
  std::size_t unbounded = 0;
};

/// A closed piece of a group that shares no point with the other parts of the same value; not empty. Its own
/// `dominance` means nothing, that of the value counts.
class Part {
 public:
  Part(const Complex& complex, Group group);
  const Group& group() const { return group_; }
  /// Holds the part; infinite if that is unbounded or reaches the frame.
  const PartBox& box() const { return box_; }
  /// The smallest 3-cell of each region: ascending, but for regions of a result read back, which keep the numbers
  /// of their file.
  const std::vector<RegionId>& first_cells() const { return first_cells_; }
  /// All three are computed when they are first asked for; `complex` is that of the constructor. Thread-safe.
  const CellCounts& counts(const Complex& complex) const;
  /// How many of its regions have no bounds, and the exact volume of all others together: one sum over their outer
  /// boundary. Volumes of regions have denominators of their own, and their sum by and by that of all of them.
  const PartVolume& volume(const Complex& complex) const;
  /// Exact volumes by region, from region 1; nothing for an unbounded one.
  const std::vector<std::optional<Rational>>& volumes(const Complex& complex) const;

 private:
  Group group_;
  PartBox box_;
  std::vector<RegionId> first_cells_;
  mutable std::once_flag counted_, summed_, measured_;
  mutable CellCounts counts_;
  mutable PartVolume volume_;
  mutable std::vector<std::optional<Rational>> volumes_;
};

/// What an operator adds to the sums over a value and takes off them.
struct TotalsChange {
  std::array<std::int64_t, 4> raw{}, simplified{};
  std::int64_t regions = 0;
  Rational volume = 0;
};

/// Sums over parts: their counts of cells, their regions and volumes.
struct Totals {
  std::array<std::size_t, 4> raw{}, simplified{};
  std::size_t regions = 0, unbounded = 0;  ///< all of them; those without a volume
  Rational bounded_volume = 0;
  /// Of all regions; nothing when one is unbounded.
  std::optional<Rational> volume() const { return unbounded == 0 ? std::optional(bounded_volume) : std::nullopt; }
  void add(const Complex& complex, const Part& part);
  void remove(const Complex& complex, const Part& part);
  void add(const TotalsChange& change);
};

/// A part in a list, with its box at hand: most parts are passed over by their boxes.
class PartRef {
 public:
  PartRef() = default;
  PartRef(std::shared_ptr<const Part> part) : box_(part->box()), part_(std::move(part)) {}
  const Part* operator->() const { return part_.get(); }
  const Part* get() const { return part_.get(); }
  const PartBox& box() const { return box_; }
  /// One and the same part.
  friend bool operator==(const PartRef& a, const PartRef& b) { return a.part_ == b.part_; }

 private:
  PartBox box_{};
  std::shared_ptr<const Part> part_;
};

/// The order of the parts of a value: by their smallest 3-cells, those without any at the end, by vertices, edges,
/// then faces.
bool before(const PartRef& a, const PartRef& b);

/// Parts in the order of `before`.
struct PartedGroup {
  std::vector<PartRef> parts;
  Rational dominance = 0;
  /// The sums over all parts but those in `fresh`; nothing when they are not known. An operator passes them on, so
  /// that they cost what is new in a value.
  std::optional<Totals> totals;
  std::vector<PartRef> fresh;
  /// A material in it may have a dominance of its own, or may have had one: an operator that need not ask does
  /// not.
  bool ranked = false;
};

/// The sums over all parts, kept in the value.
const Totals& totals_of(const Complex& complex, PartedGroup& value);

/// The group as one part, or none if it is empty.
PartedGroup parted(const Complex& complex, Group group);

/// Each part changed by `change(Group&)`, which must leave it a part: it may drop entities, not add any.
template <class Change>
PartedGroup changed(const Complex& complex, const PartedGroup& value, Change change) {
  PartedGroup out;
  out.dominance = value.dominance;
  for (const auto& part : value.parts) {
    Group group = part->group();
    change(group);
    PartedGroup one = parted(complex, std::move(group));
    out.parts.insert(out.parts.end(), one.parts.begin(), one.parts.end());
    out.ranked = out.ranked || one.ranked;
  }
  return out;
}

/// The group of all parts: lists sorted, regions of several parts in the order of their smallest 3-cells, of one
/// part as it has them.
Group whole(const PartedGroup& value);

/// Region i + 1 of `whole(value)` as (index of the part, region of its group).
std::vector<std::pair<std::uint32_t, std::uint32_t>> region_order(const PartedGroup& value);

/// Exact volumes by region of `whole(value)`, from region 1; nothing for an unbounded one.
std::vector<std::optional<Rational>> volumes(const Complex& complex, const PartedGroup& value);

}  // namespace cnrg
