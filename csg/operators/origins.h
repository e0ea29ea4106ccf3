// Origins: the leaves that each cell of a value came from, and what is said of it (Said), through any depth of
// the DAG.
//
// Values have few distinct sets of leaves and many cells: sets are interned in the value's own table, each with
// what is said of the cells that have it, and a cell carries a 4-byte id. A cell that two operands have came from
// both. Which cells of these leaves it lies in is read off the complex (`leaf_cells`).
#pragma once

#include <map>
#include <memory>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "csg/materials/attributes.h"
#include "csg/operators/dominance.h"
#include "kernel/complex/complex.h"
#include "kernel/selection/selection.h"

namespace cnrg {

// What is said of cells of lower dimension: of faces, edges and vertices.
//
// A group has regions, and each has its attributes. Of entities one cannot say "this face is of leaf a, so it has
// what is said of a": where `a` is rock, its faces are where rock ends, and no sheet of rock. What has attributes
// is what *stands for itself*: a sheet, which is a face that bounds no region, a wire, an isolated point. It has
// them wherever it goes: a fault stays what it is when it becomes the wall between two blocks of rock.
//
// A sheet is said of all cells in its closure. So what two sheets have in common, an edge in the interior of both,
// knows what it is of.

/// What is said of a cell that stands for itself, or lies in the closure of such cells.
struct Said {
  Attributes attributes{};
  int dimension = 2;  ///< of what it is said of: 2 a sheet, 1 a wire, 0 a point
  friend bool operator==(const Said&, const Said&) = default;
};
/// nullptr: the cell is but a wall of solids, or lies in one. Sheets, wires and points of which nobody has said
/// anything have empty attributes.
using SaidPointer = std::shared_ptr<const Said>;

/// What is said of a cell that two operands have. One that says nothing yields; at a place where a wire lies in a
/// sheet it is the wire, the thing of lower dimension; else the dominant one counts, and of two equals the left
/// one is filled in from the right one.
SaidPointer merged(const SaidPointer& left, const SaidPointer& right, Dominance dominance);

/// What of `right` gives way to `left` at a cell of a dimension without being dominated: only where both are
/// things of this dimension. Wires that cross in a point are not at odds.
std::vector<Yielded> at_odds(const SaidPointer& left, const SaidPointer& right, int dimension);

using LeafSetId = Id<struct LeafSetTag>;  ///< an interned set of leaves with what is said

/// Sets of leaves with what is said, each stored once. LeafSetId(0) is the empty set, of which nothing is said.
class LeafSets {
 public:
  LeafSets();
  /// The id of a set of leaves (ascending, unique) with what is said.
  LeafSetId intern(std::span<const LeafId> leaves, const SaidPointer& said = nullptr);
  LeafSetId intern(LeafId leaf) { return intern(std::span(&leaf, 1)); }
  /// The union of two sets of this table, with what is said of both merged; pairs are remembered.
  LeafSetId unite(LeafSetId a, LeafSetId b, Dominance dominance = Dominance::equal);
  std::span<const LeafId> operator[](LeafSetId set) const { return sets_[set]; }
  const SaidPointer& said(LeafSetId set) const { return said_[set.index()]; }
  std::size_t size() const { return sets_.size(); }
  /// Something other than empty attributes is said in some set.
  bool says_anything() const { return says_anything_; }

 private:
  Csr<LeafSetId, LeafId> sets_;
  std::vector<SaidPointer> said_;  // by id
  bool says_anything_ = false;
  std::map<std::vector<LeafId>, std::vector<LeafSetId>> known_;
  std::map<std::tuple<LeafSetId, LeafSetId, Dominance>, LeafSetId> united_;
};

/// Sets of leaves that grow from operand to operand of a fold. A cell that n operands share has n sets on its way,
/// of n^2 / 2 leaves together; so a union is kept as the two sets that it is of, and its leaves are listed when
/// somebody asks. LeafSetId(0) is the empty set.
class LeafUnions {
 public:
  LeafUnions();
  LeafSetId intern(std::span<const LeafId> leaves, const SaidPointer& said = nullptr);
  /// Sets with the same leaves that were united in other orders may have several ids.
  LeafSetId unite(LeafSetId a, LeafSetId b, Dominance dominance = Dominance::equal);
  /// Ascending, unique.
  std::vector<LeafId> operator[](LeafSetId set) const;
  const SaidPointer& said(LeafSetId set) const { return said_[set.index()]; }
  std::size_t size() const { return made_of_.size(); }

 private:
  LeafSets sets_;
  std::vector<LeafSetId> of_set_;  // by id in sets_
  // Two unions; or none() and an id in sets_.
  std::vector<std::pair<LeafSetId, LeafSetId>> made_of_;
  std::vector<SaidPointer> said_;  // by id here
  std::map<std::tuple<LeafSetId, LeafSetId, Dominance>, LeafSetId> united_;
};

/// Brings sets of one table, which may grow, into another, each when it is first met: tables hold no more than
/// their values need.
template <class From, class To>
class LeafSetMap {
 public:
  LeafSetMap(const From& from, To& to) : from_(from), to_(to), known_(from.size(), LeafSetId::none()) {}
  LeafSetId operator()(LeafSetId set) {
    if (set.index() >= known_.size()) known_.resize(from_.size(), LeafSetId::none());
    LeafSetId& id = known_[set.index()];
    if (!id.valid()) id = to_.intern(from_[set], from_.said(set));
    return id;
  }

 private:
  const From& from_;
  To& to_;
  std::vector<LeafSetId> known_;
};

/// The set of each listed cell of a value: parallel to its lists of vertices, edges, faces and 3-cells.
struct Origins {
  LeafSets sets;
  std::vector<LeafSetId> vertices, edges, faces, regions;
};

/// Appends the cells of the given leaves (ascending) whose point sets, boundaries included, hold the cell; in no
/// order, and some more than once.
void append_leaf_cells(const Complex& complex, VertexId v, std::span<const LeafId> leaves,
                       std::vector<LeafCell>& out);
void append_leaf_cells(const Complex& complex, EdgeId e, std::span<const LeafId> leaves,
                       std::vector<LeafCell>& out);
void append_leaf_cells(const Complex& complex, FaceId f, std::span<const LeafId> leaves,
                       std::vector<LeafCell>& out);
void append_leaf_cells(const Complex& complex, RegionId r, std::span<const LeafId> leaves,
                       std::vector<LeafCell>& out);

/// The same as a list by itself: ascending, each once.
template <class IdT>
std::vector<LeafCell> leaf_cells(const Complex& complex, IdT cell, std::span<const LeafId> leaves);

}  // namespace cnrg
