// The value that a leaf brings along: which component each of its cells has.
//
// The faces, wires and points of most leaves say everything. A result read back is any set of cells: its soup has
// the boundaries of all cells of the file, active or not, and this table says what each of them is.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "csg/materials/attributes.h"
#include "kernel/complex/complex.h"
#include "kernel/exact/rational.h"

namespace cnrg {

/// What the cells of a value that was joined came from (csg/evaluate/joined_nodes.h): leaves of the run that made
/// it, by their numbers there, and what of these holds the cell. Empty for inactive cells.
struct CellMakers {
  struct Made {
    std::vector<LeafId> leaves;
    std::vector<LeafCell> cells;
  };
  std::vector<Made> faces, edges;          ///< by number
  std::vector<Made> regions;               ///< by label
  std::map<std::uint32_t, Made> vertices;  ///< by point
};

struct CellTable {
  struct Cell {
    std::uint32_t component = 0;  ///< from 1, as PreparedLeaf::regions() has them; 0: inactive
    bool feature = false;
    std::uint32_t said = kSilent;  ///< place in the list `said`
  };
  static constexpr std::uint32_t kSilent = 0xffffffffu;  ///< nothing is said of the cell
  bool group = true;                                     ///< then the component after the last one is its entities
  std::vector<Rational> dominances;                      ///< of each component; of a group: one
  std::vector<std::uint32_t> faces;                      ///< component, by Soup::Face::leaf_face
  std::vector<std::uint32_t> said_of_faces;              ///< places in `said`, by Soup::Face::leaf_face
  std::vector<Attributes> said;        ///< of faces, edges and vertices; a grade is in the file's coordinates
  std::vector<Cell> edges;             ///< by number, which is Soup::Wire::leaf_edge where it is a wire
  std::vector<std::uint32_t> regions;  ///< component, by label; at 0: outside of all faces
  /// All points of the soup, lexicographically ascending, before the transform.
  std::vector<RationalPoint> points;
  /// The number of the edge that has the segment between two points, the smaller one first.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> segments;
  std::map<std::uint32_t, Cell> vertices;  ///< by point
  /// Leaf i of that run is the (i + 1)-th one after the leaf that has this table. nullptr: cells come from the
  /// leaf itself.
  std::shared_ptr<const CellMakers> makers;
  /// How far volumes may be from those between true surfaces, before the transform; nothing: nobody knows.
  std::optional<double> volume_bound = 0.0;
};

}  // namespace cnrg
