// Problems of meshes that people made, from a folder. Nothing of the meshes is repaired but what a model cannot
// say: of equal points one stays, triangles with a corner twice are left out, and polygons that are not planar, or
// have a corner twice, become fans of triangles.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>
#include <string_view>

#include "bench/cases/family.h"
#include "csg/imports/mesh_file.h"
#include "csg/imports/mesh_points.h"

namespace cnrg::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPrefix = "files-";

// --- files that belong together

/// Paths of operands: two files, or one, beside its copy.
using Files = std::vector<std::string>;

bool is_mesh_of_any_case(const fs::path& path) {
  std::string extension = path.extension().string();
  for (char& letter : extension) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return extension == ".off" || extension == ".obj" || extension == ".stl" || extension == ".ply";
}

/// Names of files of pairs: the first one, and how the second one differs in its beginning or end.
struct PairRule {
  const char *first_begin, *first_end, *second_begin, *second_end;
};
constexpr PairRule kPairRules[] = {{"", "_left", "", "_right"}, {"src-", "", "cut-", ""}, {"", "A", "", "B"}};

/// The second file of a pair whose first one is called so; empty when it is no first one by this rule.
fs::path partner_of(const fs::path& path, const PairRule& rule) {
  const std::string stem = path.stem().string(), begin = rule.first_begin, end = rule.first_end;
  if (stem.size() <= begin.size() + end.size() || !stem.starts_with(begin) || !stem.ends_with(end)) return {};
  const std::string middle = stem.substr(begin.size(), stem.size() - begin.size() - end.size());
  return path.parent_path() / (rule.second_begin + middle + rule.second_end + path.extension().string());
}

/// Letters, digits, dots and hyphens of a path below the folder; folders are parted by `+`, all else becomes `_`.
std::string word_of(const fs::path& path) {
  std::string word = path.generic_string();
  for (char& letter : word) {
    if (letter == '/') letter = '+';
    else if (!std::isalnum(static_cast<unsigned char>(letter)) && letter != '.' && letter != '-') letter = '_';
  }
  return word;
}

/// By names of problems, without what comes before those of files.
std::map<std::string, Files> problem_files(const std::string& folder) {
  if (!fs::is_directory(folder))
    throw std::runtime_error("'" + folder + "' is no folder; give the folder of the meshes");
  std::set<fs::path> meshes;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && is_mesh_of_any_case(entry.path())) meshes.insert(entry.path());
  std::map<std::string, Files> problems;
  const auto add = [&](const std::string& word, Files files) {
    std::string name = word;
    for (int i = 2; problems.contains(name); ++i) name = word + '_' + std::to_string(i);
    problems.emplace(std::move(name), std::move(files));
  };
  std::set<fs::path> paired;
  for (const PairRule& rule : kPairRules) {
    for (const fs::path& path : meshes) {
      const fs::path other = partner_of(path, rule);
      if (!meshes.contains(other) || paired.contains(path) || paired.contains(other)) continue;
      paired.insert({path, other});
      const std::string word = word_of(path.lexically_relative(folder)) + "-" + word_of(other.filename());
      add(word, {path.string(), other.string()});
    }
  }
  for (const fs::path& path : meshes)
    if (!paired.contains(path)) add(word_of(path.lexically_relative(folder)), {path.string()});
  return problems;
}

// --- a model of a mesh

using Loop = std::vector<std::uint32_t>;

bool planar(const MeshPoints& points, const Loop& loop) {
  std::size_t corner = 2;
  while (corner < loop.size() && points.collinear(loop[0], loop[1], loop[corner])) ++corner;
  if (corner == loop.size()) return false;
  return std::all_of(loop.begin(), loop.end(),
                     [&](std::uint32_t p) { return points.coplanar(loop[0], loop[1], loop[corner], p); });
}

/// The polygon itself, or its fan without triangles that have a corner twice.
void add_polygon(Model& model, const MeshPoints& points, const Loop& loop) {
  const bool distinct = std::set(loop.begin(), loop.end()).size() == loop.size();
  if (loop.size() > 3 && distinct && planar(points, loop)) {
    model.faces.push_back({{loop}, true});
    return;
  }
  for (std::size_t k = 2; k < loop.size(); ++k) {
    const std::uint32_t a = loop[0], b = loop[k - 1], c = loop[k];
    if (a != b && b != c && c != a) model.faces.push_back({{{a, b, c}}, true});
  }
}

/// Each side of a face has its opposite as often.
bool closed(const Model& model) {
  std::map<std::array<std::uint32_t, 2>, long> sides;
  for (const Model::Face& face : model.faces) {
    const Loop& loop = face.loops[0];
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const std::uint32_t a = loop[k], b = loop[(k + 1) % loop.size()];
      sides[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  }
  return std::all_of(sides.begin(), sides.end(), [](const auto& side) { return side.second == 0; });
}

/// A closed mesh is a solid, its faces turned over when they look inside; one without volume, such as a plate
/// that is there from both sides, is a surface as an open one is.
Model model_of_mesh(const MeshData& mesh) {
  const MeshPoints points(mesh);
  Model model;
  for (std::uint32_t p = 0; p < points.size(); ++p) model.points.push_back(points.value(p));
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    Loop loop;
    for (std::size_t i = mesh.offsets[f]; i < mesh.offsets[f + 1]; ++i) {
      const std::uint32_t p = points.number(mesh.corners[i]);
      if (loop.empty() || loop.back() != p) loop.push_back(p);
    }
    while (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
    add_polygon(model, points, loop);
  }
  const int side = closed(model) ? sgn(signed_volume(model)) : 0;
  for (Model::Face& face : model.faces) {
    face.solid = side != 0;
    if (side < 0) std::reverse(face.loops[0].begin(), face.loops[0].end());
  }
  for (const auto& [a, b] : mesh.wires)
    if (points.number(a) != points.number(b)) model.wires.push_back({points.number(a), points.number(b)});
  std::set<std::uint32_t> isolated;
  for (const std::uint32_t p : mesh.points) isolated.insert(points.number(p));
  model.isolated.assign(isolated.begin(), isolated.end());
  return model;
}

/// Numbers the points anew, those that nothing uses left out.
void drop_unused(Model& model) {
  std::vector<char> used(model.points.size());
  const auto each = [&](auto visit) {
    for (Model::Face& face : model.faces)
      for (auto& loop : face.loops) std::for_each(loop.begin(), loop.end(), visit);
    for (auto& wire : model.wires) std::for_each(wire.begin(), wire.end(), visit);
    std::for_each(model.isolated.begin(), model.isolated.end(), visit);
  };
  each([&](std::uint32_t& p) { used[p] = 1; });
  std::vector<std::uint32_t> number(model.points.size());
  std::uint32_t next = 0;
  for (std::uint32_t p = 0; p < model.points.size(); ++p) {
    if (!used[p]) continue;
    number[p] = next;
    if (next != p) model.points[next] = std::move(model.points[p]);
    ++next;
  }
  model.points.resize(next);
  each([&](std::uint32_t& p) { p = number[p]; });
}

Model operand(const std::string& path, const MeshData& mesh) {
  Model model = model_of_mesh(mesh);
  drop_unused(model);
  if (model.points.empty()) throw std::runtime_error(path + ": has no faces");
  return model;
}

/// Coordinates turned and rounded; polygons are planar no more, but by accident.
MeshData turned_copy(MeshData mesh) {
  TriangleMesh points;
  for (std::size_t i = 0; i < mesh.point_count(); ++i)
    points.points.push_back({mesh.xyz[3 * i], mesh.xyz[3 * i + 1], mesh.xyz[3 * i + 2]});
  points = turned_about_middle(points);
  for (std::size_t i = 0; i < mesh.point_count(); ++i)
    std::copy(points.points[i].begin(), points.points[i].end(), mesh.xyz.begin() + static_cast<long>(3 * i));
  return mesh;
}

}  // namespace

std::vector<std::string> folder_problems(const std::string& folder, const std::string& operation) {
  if (!parse_operation(operation))
    throw std::runtime_error("'" + operation + "' is no operation; there are union, difference, intersection");
  std::vector<std::string> names;
  for (const auto& [name, files] : problem_files(folder))
    names.push_back(std::string(kPrefix) + operation + "-" + name);
  return names;
}

Problem make_folder_problem(const std::string& folder, const std::string& name) {
  const std::map<std::string, Files> problems = problem_files(folder);
  auto found = problems.end();
  Problem problem;
  problem.name = name;
  if (name.starts_with(kPrefix)) {
    const std::string rest = name.substr(kPrefix.size());
    const std::size_t dash = rest.find('-');
    const auto operation = parse_operation(rest.substr(0, dash));
    if (operation && dash != std::string::npos) {
      problem.steps = {*operation};
      found = problems.find(rest.substr(dash + 1));
    }
  }
  if (found == problems.end())
    throw std::runtime_error("folder '" + folder + "' has no problem '" + name + "'; it has " +
                             std::to_string(problems.size()) + " for each operation");
  for (const std::string& path : found->second) {
    const MeshData mesh = cnrg::read_mesh(path, false);
    problem.operands.push_back(operand(path, mesh));
    if (found->second.size() == 2) continue;
    Model copy = operand(path, turned_copy(mesh));
    // Rounding gives a plate without volume some.
    const auto& faces = problem.operands[0].faces;
    if (!faces.empty() && !faces[0].solid)
      for (Model::Face& face : copy.faces) face.solid = false;
    problem.operands.push_back(std::move(copy));
  }
  return problem;
}

}  // namespace cnrg::bench
