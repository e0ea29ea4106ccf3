// A value that stands by itself, to go on as a leaf: read from a file (result_reader.cpp) and held against its own
// cells (result_check.cpp), or taken from a result at hand.
//
// All its cells go to the soup, active or not: what each of them is stands here (leaf_value.h).
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "csg/imports/json_cursor.h"
#include "csg/leaves/leaf.h"
#include "csg/result/flat.h"
#include "kernel/exact/rational.h"

namespace cnrg {

struct StoredValue {
  using Index = FlatComplex::Index;

  StoredValue() = default;
  StoredValue(StoredValue&&) = default;

  /// Points, faces, edges, vertices and regions have the numbers that they have as cells of the leaf; regions are
  /// labels from 1, but for the unbounded one, which is 0. Of a file without triangles, shells and origins, and
  /// `around` an edge are the faces that walk it, each by its front. Origins are those of a run: leaf i of it is
  /// the (i + 1)-th one after the leaf that has this value.
  FlatComplex cells;
  std::vector<RationalPoint> points;  ///< ascending, before the transform
  bool group = true;                  ///< then the component after the last one is its entities
  std::vector<Attributes> components;
  std::vector<Rational> dominances;            ///< of each component; of a group: one
  std::set<Attributes, AttributesOrder> said;  ///< what `cells` refer to; a grade is in the leaf's coordinates
  std::map<Index, std::string> patches;        ///< names of those with parameters
  std::optional<double> volume_bound = 0.0;    ///< as of PreparedLeaf

  Index label(Index region) const { return cells.regions[region].bounded ? region + 1 : 0; }
};

/// The value as a leaf.
std::unique_ptr<PreparedLeaf> leaf_of(StoredValue value);
/// That of a result, as a file of it would have it, but with origins; all of it must have bounds.
StoredValue store(const ResultView& view, FlatComplex cells);
/// For a value whose leaves are not at hand.
void forget_origins(FlatComplex& cells);
/// A result as a leaf, without a file. InputError for what has no bounds.
std::shared_ptr<const PreparedLeaf> leaf_of(const Result& result);

namespace result {

/// What a file says: the value with origins of the leaves that the file names, and what it names.
struct ResultFile {
  StoredValue value;
  ResultNames names;
  std::vector<std::vector<LeafId>> leaves_of;  ///< by component
};

/// Throws LeafFileError for what is missing, of another type or out of range.
ResultFile read_file(const Cursor& root);

/// Adds the cells as a leaf; point i of the value is point i of the leaf, and facets are its faces in their order.
/// `fill` is `sides`, or `none` for a leaf without regions.
LeafId add_to(Soup& soup, const StoredValue& value, const Transform& transform, Fill fill);

}  // namespace result
}  // namespace cnrg
