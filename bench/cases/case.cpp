#include "bench/cases/case.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "bench/cases/random.h"
#include "bench/cases/tree_cases.h"

namespace cnrg::bench {
namespace {

namespace fs = std::filesystem;

/// The volume of a union of boxes with corners in [0, side)^3.
long long union_volume(const std::vector<IntegerBox>& boxes) {
  int side = 1;
  for (const IntegerBox& box : boxes) side = std::max({side, box.max[0], box.max[1], box.max[2]});
  std::vector<char> full(static_cast<std::size_t>(side) * side * side);
  for (const IntegerBox& b : boxes) {
    for (int x = b.min[0]; x < b.max[0]; ++x)
      for (int y = b.min[1]; y < b.max[1]; ++y)
        for (int z = b.min[2]; z < b.max[2]; ++z) full[(static_cast<std::size_t>(x) * side + y) * side + z] = 1;
  }
  return std::count(full.begin(), full.end(), 1);
}

Case union_of_meshes(const std::string& name, std::vector<TriangleMesh> leaves,
                     std::optional<long long> volume = {}) {
  return {name, std::move(leaves), Operation::unite, volume};
}

Case spheres_on_lattice(int side) {
  std::vector<TriangleMesh> leaves;
  for (int i = 0; i < side * side * side; ++i) {
    const double x = 1.6 * (i % side), y = 1.6 * (i / side % side), z = 1.6 * (i / side / side);
    leaves.push_back(moved(ringed_sphere(static_cast<unsigned>(i) + 1), {x, y, z}));
  }
  return union_of_meshes("spheres" + std::to_string(leaves.size()), std::move(leaves));
}

/// Unit cubes of a lattice, those that `take(x, y, z)` takes.
template <class Take>
std::vector<IntegerBox> unit_cubes(int side, Take take) {
  std::vector<IntegerBox> boxes;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z)
        if (take(x, y, z)) boxes.push_back({{x, y, z}, {x + 1, y + 1, z + 1}});
  return boxes;
}

Case identical() {
  const TriangleMesh sphere = bumpy_sphere(10000, 1);
  return union_of_meshes("identical", {sphere, sphere});
}

/// Four sides of the copy lie in the planes of the sides of the first; the diagonals of their squares cross.
Case coplanar() {
  const int n = 28;  // 9,408 triangles
  return union_of_meshes("coplanar", {tiled_cube(n), moved(tiled_cube(n), {10.5, 0, 0})},
                         0LL + n * n * n + n * n * 21 / 2);
}

Case mirrored() {
  const TriangleMesh half = dome(50);
  return union_of_meshes("mirrored", {half, mirrored_z(half)});
}

struct MeshPair {
  const char *name, *first, *second;
};
constexpr MeshPair kMeshPairs[] = {
    {"bunny25k+cow25k", "bunny25k.obj", "cow25k.obj"},
    {"bunny100k+cow100k", "bunny100k.obj", "cow100K.obj"},
    {"armadillo", "armadillo.obj", "armadillo.obj"},
    {"cactus", "cactus100k.obj", "cactus100k.obj"},
    {"elephant", "refined_elephant.off", "refined_elephant.off"},
};

/// The union of a mesh and another one turned; a mesh and itself overlap when the turn is about its own middle.
Case mesh_pair(const std::string& name, const std::string& first, const std::string& second) {
  TriangleMesh fixed = read_mesh(first), other = read_mesh(second);
  if (first == second) {
    other = turned_about_middle(other);
  } else {
    other = turned(other, 0.7, {0.05, 0.03, 0.01});
  }
  return union_of_meshes(name, {std::move(fixed), std::move(other)});
}

/// Files below a folder by name.
std::map<std::string, std::string> files_by_name(const std::string& folder) {
  std::map<std::string, std::string> files;
  if (folder.empty()) return files;
  if (!fs::is_directory(folder))
    throw std::runtime_error("'" + folder + "' is no folder; give the folder of the meshes");
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.emplace(entry.path().filename().string(), entry.path().string());
  }
  return files;
}

/// Nobody says which triangles are one face.
Case in_triangles(Case c) {
  for (TriangleMesh& leaf : c.leaves) {
    leaf.faces.clear();
    leaf.polygons.clear();
  }
  return c;
}

Case boxes_in_triangles(int count) {
  return in_triangles(union_of("triangle-boxes-" + std::to_string(count), random_boxes(count, 1, {12, 5, 20})));
}

Case of_trees(std::vector<std::string> trees, std::optional<long long> volume = {}) {
  Case c;
  c.volume = volume;
  c.trees = std::move(trees);
  return c;
}

Case chain(int steps) { return of_trees({plate_chain(steps)}, PlateWithHoles{steps}.volume()); }

constexpr unsigned kFractures = 5, kSpheres = 9;  // seeds

struct Generated {
  const char *name, *group;
  Case (*make)();
};
/// Sizes are part of the names.
const Generated kGenerated[] = {
    {"spheres64", "nary", [] { return spheres_on_lattice(4); }},
    {"boxes200", "nary", [] { return union_of("boxes200", random_boxes(200, 1)); }},
    {"boxes2000", "nary", [] { return union_of("boxes2000", random_boxes(2000, 1)); }},
    {"triangle-boxes-200", "nary", [] { return boxes_in_triangles(200); }},
    {"triangle-boxes-2000", "nary", [] { return boxes_in_triangles(2000); }},
    {"plate1000", "nary", [] { return plate(1000); }},
    {"menger1", "nary", [] { return menger(1); }},
    {"menger2", "nary", [] { return menger(2); }},
    {"menger3", "nary", [] { return menger(3); }},
    {"spheres10k", "growth", [] { return sphere_pair(10000); }},
    {"spheres30k", "growth", [] { return sphere_pair(30000); }},
    {"spheres100k", "growth", [] { return sphere_pair(100000); }},
    {"spheres300k", "growth", [] { return sphere_pair(300000); }},
    {"spheres1M", "growth", [] { return sphere_pair(1000000); }},
    {"identical", "degenerate", identical},
    {"coplanar", "degenerate", coplanar},
    {"grid", "degenerate", [] { return union_of("grid", unit_cubes(8, [](int, int, int) { return true; })); }},
    {"touching", "degenerate",  // along edges and in vertices
     [] { return union_of("touching", unit_cubes(8, [](int x, int y, int z) { return (x + y + z) % 2 == 0; })); }},
    {"mirrored", "degenerate", mirrored},
    {"chain-2000", "trees", [] { return chain(2000); }},
    {"cut-spheres64", "trees", [] { return of_trees({cut_spheres(64, kSpheres)}); }},
    {"cut-spheres64-apart", "trees", [] { return of_trees(cut_spheres_apart(64, kSpheres)); }},
    {"plate4000", "long", [] { return plate(4000); }},
    {"chain-4000", "long", [] { return chain(4000); }},
    {"fractures1000", "long", [] { return of_trees({fractures_in_block(1000, kFractures)}, 1000000); }},
    {"shared-boxes18", "long", [] { return of_trees({shared_boxes(18)}, 1 << 18); }},
};

}  // namespace

std::size_t Case::triangles() const {
  std::size_t sum = 0;
  for (const TriangleMesh& leaf : leaves) sum += leaf.triangles.size();
  return sum;
}

Case sphere_pair(std::size_t triangles) {
  const std::string size =
      triangles < 1000000 ? std::to_string(triangles / 1000) + "k" : std::to_string(triangles / 1000000) + "M";
  return union_of_meshes(
      "spheres" + size, {bumpy_sphere(triangles, 1), moved(bumpy_sphere(triangles, 3), {0.4123, 0.3571, 0.2917})});
}

std::vector<IntegerBox> random_boxes(int count, unsigned seed, const BoxSizes& sizes) {
  Random random(seed);
  const int side = static_cast<int>(std::ceil(sizes.spacing * std::cbrt(count)));
  std::vector<IntegerBox> boxes(static_cast<std::size_t>(count));
  for (IntegerBox& box : boxes) {
    for (int k = 0; k < 3; ++k) {
      box.min[k] = random.integer(0, side - 1);
      box.max[k] = box.min[k] + random.integer(sizes.least, sizes.most);
    }
  }
  return boxes;
}

Case union_of(const std::string& name, const std::vector<IntegerBox>& boxes) {
  std::vector<TriangleMesh> leaves;
  for (const IntegerBox& box : boxes) leaves.push_back(box_mesh(box));
  return union_of_meshes(name, std::move(leaves), union_volume(boxes));
}

/// The holes of Sierpinski's carpet, each as a prism along each axis that ends on the sides of the cube.
Case menger(int level) {
  const int side = static_cast<int>(std::lround(std::pow(3, level)));
  const auto in_hole = [](int u, int v) {  // is the square in a hole of a level above?
    for (; u > 0 || v > 0; u /= 3, v /= 3)
      if (u % 3 == 1 && v % 3 == 1) return true;
    return false;
  };
  Case sponge;
  sponge.name = "menger" + std::to_string(level);
  sponge.operation = Operation::subtract;
  sponge.leaves.push_back(box_mesh({{0, 0, 0}, {side, side, side}}));
  for (int size = side / 3; size > 0; size /= 3) {
    for (int u = 1; u < side / size; u += 3) {
      for (int v = 1; v < side / size; v += 3) {
        if (in_hole(u / 3, v / 3)) continue;
        for (int axis = 0; axis < 3; ++axis) {
          IntegerBox prism;
          prism.min[axis] = 0;
          prism.max[axis] = side;
          prism.min[(axis + 1) % 3] = u * size;
          prism.max[(axis + 1) % 3] = (u + 1) * size;
          prism.min[(axis + 2) % 3] = v * size;
          prism.max[(axis + 2) % 3] = (v + 1) * size;
          sponge.leaves.push_back(box_mesh(prism));
        }
      }
    }
  }
  sponge.volume = std::llround(std::pow(20, level));
  return sponge;
}

Case plate(int holes) {
  const PlateWithHoles plate{holes};
  const int width = plate.side() * PlateWithHoles::kSpacing, height = PlateWithHoles::kHeight;
  Case c;
  c.name = "plate" + std::to_string(holes);
  c.operation = Operation::subtract;
  c.volume = plate.volume();
  c.leaves.push_back(box_mesh({{0, 0, 0}, {width, width, height}}));
  for (int k = 0; k < holes; ++k) c.leaves.push_back(prism_mesh(plate.section(k), -height, 2 * height));
  return in_triangles(std::move(c));
}

std::vector<Recipe> recipes(const std::string& meshes) {
  std::vector<Recipe> all;
  const std::map<std::string, std::string> files = files_by_name(meshes);
  for (const MeshPair& pair : kMeshPairs) {
    Recipe recipe{pair.name, "pairs", {}, {}};
    const auto first = files.find(pair.first), second = files.find(pair.second);
    if (first == files.end()) recipe.missing = pair.first;
    else if (second == files.end()) recipe.missing = pair.second;
    else
      recipe.make = [name = recipe.name, a = first->second, b = second->second] { return mesh_pair(name, a, b); };
    all.push_back(std::move(recipe));
  }
  for (const Generated& g : kGenerated) all.push_back({g.name, g.group, {}, g.make});
  return all;
}

Case case_of(const std::string& name) {
  for (const Generated& g : kGenerated) {
    if (g.name == name) return g.make();
  }
  throw std::runtime_error("no generated case is called '" + name + "'");
}

}  // namespace cnrg::bench
