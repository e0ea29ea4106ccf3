// What a result says, as numbers: read from a file by result_reader.cpp and held against its own cells by
// csg/transfer/result_check.cpp, or taken from a result at hand (csg/transfer/joined_leaf.cpp); made a leaf by
// result_leaf.cpp.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "csg/imports/json_cursor.h"
#include "csg/leaves/cell_table.h"
#include "csg/leaves/leaf.h"
#include "csg/leaves/parameters.h"
#include "kernel/base/limits.h"

namespace cnrg::result {

using Loop = std::vector<Index>;  ///< points

/// A planar piece of a face; of a flat face all of it.
struct Facet {
  std::vector<Loop> walks;  ///< as the file has them: the face to the left as seen from its front
  std::vector<Loop> loops;  ///< without slits, the outer one first; empty where there are none: those of `walks`
  std::vector<Index> isolated;
  Index face = 0;
  std::vector<Index> cells;  ///< of its patch, that it lies in
  const std::vector<Loop>& outline() const { return loops.empty() ? walks : loops; }
};

struct Face {
  std::vector<Loop> walks;  ///< of a face that is not flat; those of a flat one are its facet's
  std::size_t first = 0;    ///< its facets
  std::size_t facets = 1;
  bool flat = true;
  std::array<Index, 2> regions{};  ///< in front, behind
  Index patch = 0;
};

struct Edge {
  Loop points;  ///< a closed chain repeats its first point
  bool closed = false;
  Index uses = 0;       ///< how often faces walk it
  bool slit = false;    ///< one face walks it twice
  bool curved = false;  ///< on a face that is not flat
  bool wire = false;    ///< of the soup: see result_leaf.cpp
};

struct Region {
  Index label = 0;  ///< in the soup; 0: unbounded
  Index component = 0;
};

struct Content {
  CellTable table;
  std::vector<Facet> facets;
  std::vector<Face> faces;
  std::vector<Edge> edges;
  std::vector<Region> regions;
  std::vector<Index> isolated;  ///< points of vertices on no edge
  std::vector<Attributes> components;
  std::map<Index, std::string> patches;         ///< names of those with parameters
  std::vector<std::vector<PatchCorner>> cells;  ///< of patches

  Index entities() const { return Index(components.size() + 1); }  ///< the component of a group's entities
  const std::vector<Loop>& walks(const Face& face) const {
    return face.flat ? facets[face.first].walks : face.walks;
  }
};

/// Throws LeafFileError for what is missing, of another type or out of range, and for what refers to nothing.
Content read_content(const Cursor& root);

/// Makes the loops of a facet from its walks. False if it has no area.
bool take_slits_out(const std::vector<RationalPoint>& points, Facet& facet);
/// When all cells are there: says which edges are wires, and lists the isolated points.
void choose_wires(Content& content);

/// The content as a leaf.
std::unique_ptr<PreparedLeaf> leaf_of(Content content);

/// Adds the cells as a leaf; point i of the file is point i of the leaf. `fill` is `sides`, or `none` for a leaf
/// without regions.
LeafId add_to(Soup& soup, const Content& content, const Transform& transform, Fill fill);

}  // namespace cnrg::result
