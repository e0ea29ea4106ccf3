// Cases: meshes and the one n-ary Boolean on them, or trees, by name. A case is made again by each process that
// runs it.
//
// Groups:
//   pairs       unions of two meshes of people, one of them turned; they need a folder of meshes
//   nary        one node with many operands: spheres on a lattice, random integer boxes (as polygons and as mere
//               triangles), Menger sponges, a plate with holes
//   growth      unions of two bumpy spheres in general position, 10,000 to 1,000,000 triangles each
//   degenerate  operands that share faces, planes, edges or vertices exactly
//   trees       whole trees (tree_cases.h)
//   long        what runs for minutes
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/cases/operation.h"
#include "bench/cases/shapes.h"

namespace cnrg::bench {

struct Case {
  std::string name;
  std::vector<TriangleMesh> leaves;
  Operation operation = Operation::unite;
  /// The volume of the result where arithmetic on integers gives it.
  std::optional<long long> volume;
  /// What is evaluated instead, one tree after the other: texts of tree files. Then there are no leaves.
  std::vector<std::string> trees{};
  std::size_t triangles() const;
};

/// How a case is made.
struct Recipe {
  std::string name, group;
  std::string missing;  ///< the mesh file that was not found; then `make` is empty
  std::function<Case()> make;
};

/// All cases in the order of the groups. Mesh files are looked for by name below `meshes`, which may be empty.
/// Throws std::runtime_error if it is given and no folder.
std::vector<Recipe> recipes(const std::string& meshes);

/// Two bumpy spheres of about `triangles` each, their union.
Case sphere_pair(std::size_t triangles);
struct BoxSizes {
  int spacing = 4;  ///< a box per cube of this side
  int least = 1, most = 8;
};
/// `count` boxes, as many per volume whatever the count; many faces are coplanar, the more the smaller the
/// numbers.
std::vector<IntegerBox> random_boxes(int count, unsigned seed, const BoxSizes& sizes = {});
/// Boxes of the same place in the lattice as meshes, their union; its volume by counting unit cubes.
Case union_of(const std::string& name, const std::vector<IntegerBox>& boxes);
/// The cube [0, 3^level]^3 without its prisms, one difference.
Case menger(int level);
/// A plate without 24-sided prisms, one difference of triangles; its volume by integers.
Case plate(int holes);
/// A case that needs no files, by its name. Throws std::runtime_error if there is none.
Case case_of(const std::string& name);

}  // namespace cnrg::bench
