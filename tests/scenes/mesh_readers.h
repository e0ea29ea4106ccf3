// Readers of what meshers read, small and strict: they look at every number of a file, and know nothing of ours.
#pragma once

#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "kernel/exact/rational.h"

namespace cnrg::test {

/// A mesh as a file says it. Entities, groups and nodes have the numbers of the file.
struct MeshFile {
  struct Element {
    int dimension = 0, entity = 0;  ///< of MEDIT: the reference
    std::vector<int> nodes;
  };
  struct Entity {
    std::vector<int> groups, boundary;
  };
  std::map<int, std::array<double, 3>> nodes;
  std::vector<Element> elements;
  std::map<std::pair<int, int>, std::string> names;  ///< by dimension and number of a group
  std::map<std::pair<int, int>, Entity> entities;    ///< by dimension and number
  std::map<std::string, std::set<int>> lists;        ///< of MEDIT: Corners, Ridges, ...

  std::size_t count(int dimension) const;
  std::set<std::string> names_of(int dimension) const;
  /// The elements of the entities of a group.
  std::vector<Element> in_group(int dimension, const std::string& name) const;
  /// Six times the signed volume of a tetrahedron, exactly.
  Rational six_volumes(const Element& tetrahedron) const;
  Rational volume(int dimension_3_entity) const;
  Rational volume(const std::string& group) const;
  /// Sum of areas of triangles, or of lengths of segments, in doubles.
  double measure(const std::vector<Element>& elements) const;
  /// Number of elements of a dimension that are not a face of a tetrahedron, or an edge or corner of one.
  std::size_t loose(int dimension) const;
};

/// Throw std::runtime_error where the text is not of the format.
MeshFile read_msh(const std::string& text);
MeshFile read_medit(const std::string& text);

/// TetGen's input.
struct TetgenFile {
  struct Facet {
    std::vector<std::vector<int>> polygons;
    std::vector<std::array<double, 3>> holes;
    int marker = 0;
  };
  struct Region {
    std::array<double, 3> point;
    int attribute = 0;
  };
  std::map<int, std::array<double, 3>> nodes;
  std::map<int, int> node_marker;
  std::vector<Facet> facets;
  std::vector<std::array<double, 3>> holes;
  std::vector<Region> regions;
};
TetgenFile read_tetgen(const std::string& text, bool poly);

/// Volumes by attribute of the .node and .ele files that tetgen writes.
std::map<int, double> tetgen_volumes(const std::string& node_text, const std::string& ele_text);

/// True if the shell finds the program.
bool installed(const std::string& program);

}  // namespace cnrg::test
