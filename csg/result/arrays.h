// A result as flat arrays of numbers: what programs take that compute with arrays (numpy, solvers, graphics).
//
// The obvious way is an object per cell. A result of a million cells is then a million objects with lists in them,
// and who wants the components of all faces walks over all of it. Here each thing that is known of a kind of cells
// is one array, by number of the cell, and lists of different lengths lie end to end with an array of offsets.
// Numbers are those of all files (csg/FORMATS.md#numbering): cells from 0, components from 1 (0: the cell is no
// part of the result but bounds a part of it); kNone stands for "none".
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "csg/materials/attributes.h"
#include "csg/result/result.h"

namespace cnrg {

/// List i is what `offsets[i]` to `offsets[i + 1]` count in what the lists are of: in `values`, or in other lists.
struct ListOffsets {
  std::vector<std::int64_t> offsets{0};
  std::size_t size() const { return offsets.size() - 1; }
};
struct NumberLists : ListOffsets {
  std::vector<std::int32_t> values;
};

/// What is said of cells of a result: each different thing once, and this again as columns of numbers, which are
/// the cell data of a .vtu.
struct SaidTable {
  std::vector<Attributes> said;
  struct Column {
    std::string array;  ///< its name in a .vtu: `name`, which only cells of dimension < 3 have there, or a key
    std::vector<std::string> texts;    ///< ascending; empty if all values are numbers
    std::vector<double> numbers;       ///< of each of `said`; not a number (NaN) where it has none
    std::vector<std::int32_t> places;  ///< instead, where there are texts: the place of each, from 1; 0: none
  };
  std::vector<Column> columns;
};

struct ResultArrays {
  static constexpr std::int32_t kNone = -1;
  using Numbers = std::vector<std::int32_t>;
  using Flags = std::vector<std::uint8_t>;  ///< 0 or 1

  /// Where cells came from, as `origin` of a .json: the leaves of each cell (places in `leaves`), and the cells of
  /// leaves that hold it, three numbers each: leaf; dimension (0 isolated point, 1 wire, 2 face, 3 region); number
  /// in the leaf (regions from 1, a point has 0).
  struct Origins {
    NumberLists leaves;
    NumberLists cells;  ///< offsets count triples
  };
  struct Common {
    Numbers component;
    Flags entity;  ///< active, and not just the interior of a region of its component
    Origins origin;
    Numbers holder;  ///< the component of the region that it is, that is behind it, in front or around; 0: none
    /// Of a sheet, a wire or a point its own, if it has one; else of an entity of a group that of `holder`, else
    /// of its component; a place in `materials`.
    Numbers material;
    Numbers said;       ///< what is said of it (CellTags::said), a place in `said`; kNone: nothing
    Numbers leaf;       ///< the first leaf with a face that it came from, else the first leaf; a place in `leaves`
    Numbers leaf_face;  ///< the number of that face; kNone: from no face
  };
  struct Vertices : Common {
    Numbers point;
    Flags feature;
    Flags free;         ///< no listed edge ends there
    Numbers region;     ///< around a vertex on no edge and no face
    NumberLists edges;  ///< that end there, ascending; one that begins and ends there twice
  };
  struct Edges : Common {
    NumberLists points;  ///< from end to end; a closed chain does not repeat the first
    Numbers vertices;    ///< two per edge: its ends; kNone of a closed one, and on the frame
    Flags closed, feature;
    Flags wire;      ///< no listed face has it on its boundary
    Flags slit;      ///< a face walks it twice
    Numbers region;  ///< around a wire
    /// The faces about it in radial order, counter-clockwise as seen with the edge pointing towards the viewer;
    /// each by the side that is seen first: face * 2 + side, side 0: the front. A slit twice.
    NumberLists around;
  };
  struct Faces : Common {
    ListOffsets loops;  ///< of each face in `loop_points` and `loop_edges`; of a flat face the outer one first
    NumberLists loop_points;  ///< boundary walks, the face to the left as seen from its front
    NumberLists
        loop_edges;         ///< the same by edges: edge * 2 + 1 if walked from its end to its start, else edge * 2
    NumberLists isolated;   ///< points in the interior that are vertices
    Numbers regions;        ///< two per face: in front, behind
    Numbers patch;          ///< faces with one number are of one patch of a leaf
    Flags flat;             ///< lies in one plane
    NumberLists triangles;  ///< offsets count triples of points, counter-clockwise as seen from the front
    ListOffsets facets;     ///< planar pieces of each face that is not flat
    ListOffsets facet_loops;  ///< of each facet, in `facet_points`
    NumberLists facet_points;
    NumberLists facet_isolated;
    Numbers facet_triangles;  ///< how many triangles each facet has; they stand facet by facet
  };
  struct Regions : Common {
    Flags bounded;
    ListOffsets shells;       ///< of each region, in `shell_sides`
    NumberLists shell_sides;  ///< face * 2 + side
  };

  std::vector<double> points;  ///< x, y, z of each, the nearest doubles; ascending by exact coordinates
  std::vector<VertexId>
      ids;                 ///< of the points in the complex: `result.complex().points.rational(ids[i])` is exact
  Numbers frame_points;    ///< those that stand for infinity
  Numbers point_vertices;  ///< the vertex at each point, or kNone
  Vertices vertices;
  Edges edges;
  Faces faces;
  Regions regions;

  std::vector<std::string> leaves;  ///< names of those that the result names, as in a .json
  struct Component {
    std::string name, material;
    Properties properties;
    Numbers leaves;
  };
  std::vector<Component> components;             ///< of component i at i - 1
  std::vector<ResultNames::Material> materials;  ///< those of the tree, and others that components have
  SaidTable said;
  bool group = false;  ///< a group; its entities are the last component, if it has any
};

/// Throws InputError when a coordinate is beyond the range of doubles.
ResultArrays result_arrays(const Result& result);

}  // namespace cnrg
