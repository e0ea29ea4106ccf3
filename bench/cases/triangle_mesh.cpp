#include "bench/cases/triangle_mesh.h"

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace cnrg::bench {
namespace {

void add_fan(TriangleMesh& mesh, const std::vector<long>& corners, const std::string& path) {
  for (const long c : corners)
    if (c < 0 || c >= static_cast<long>(mesh.points.size())) throw std::runtime_error(path + ": index out of range");
  for (std::size_t i = 2; i < corners.size(); ++i)
    mesh.triangles.push_back({static_cast<std::uint32_t>(corners[0]), static_cast<std::uint32_t>(corners[i - 1]),
                              static_cast<std::uint32_t>(corners[i])});
}

TriangleMesh read_obj(std::istream& in, const std::string& path) {
  TriangleMesh mesh;
  std::string line;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    std::string key, word;
    words >> key;
    if (key == "v") {
      std::array<double, 3> p;
      if (!(words >> p[0] >> p[1] >> p[2])) throw std::runtime_error(path + ": a vertex without three numbers");
      mesh.points.push_back(p);
    } else if (key == "f") {
      std::vector<long> corners;
      while (words >> word) {
        const long i = std::stol(word);  // up to the first slash
        corners.push_back(i > 0 ? i - 1 : static_cast<long>(mesh.points.size()) + i);
      }
      add_fan(mesh, corners, path);
    }
  }
  return mesh;
}

TriangleMesh read_off(std::istream& in, const std::string& path) {
  // Without comments it is a list of numbers after the word OFF.
  std::string all, line;
  while (std::getline(in, line)) all += line.substr(0, line.find('#')) + "\n";
  std::istringstream words(all);
  std::string key;
  std::size_t points = 0, faces = 0, edges = 0;
  if (!(words >> key >> points >> faces >> edges) || key != "OFF") throw std::runtime_error(path + ": no OFF file");
  TriangleMesh mesh;
  mesh.points.resize(points);
  for (auto& p : mesh.points) words >> p[0] >> p[1] >> p[2];
  for (std::size_t f = 0; f < faces; ++f) {
    std::size_t n = 0;
    words >> n;
    std::vector<long> corners(words ? n : 0);
    for (long& c : corners) words >> c;
    add_fan(mesh, corners, path);
    std::getline(words, line);  // colours
  }
  if (!words && !words.eof()) throw std::runtime_error(path + ": ends too early");
  return mesh;
}

}  // namespace

TriangleMesh read_mesh(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error(path + ": can not be read");
  TriangleMesh mesh = path.ends_with(".obj") ? read_obj(in, path) : read_off(in, path);
  if (mesh.triangles.empty()) throw std::runtime_error(path + ": has no faces");
  return mesh;
}

TriangleMesh turned(const TriangleMesh& mesh, double angle, const std::array<double, 3>& move) {
  const double c = std::cos(angle), s = std::sin(angle);
  TriangleMesh result = mesh;
  for (auto& [x, y, z] : result.points) {
    const double u = c * x + s * z, v = c * z - s * x;
    x = u + move[0];
    y += move[1];
    z = v + move[2];
  }
  return result;
}

}  // namespace cnrg::bench
