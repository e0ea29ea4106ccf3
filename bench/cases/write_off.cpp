// By itself: programs around other libraries write OFF too (bench/peers/external).
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "bench/cases/triangle_mesh.h"

namespace cnrg::bench {

void write_off(const std::string& path, const TriangleMesh& mesh) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "w"), std::fclose);
  if (!file) throw std::runtime_error(path + ": cannot be written; is the folder there and is there room?");
  std::fprintf(file.get(), "OFF\n%zu %zu 0\n", mesh.points.size(), mesh.triangles.size());
  for (const auto& [x, y, z] : mesh.points) std::fprintf(file.get(), "%.17g %.17g %.17g\n", x, y, z);
  for (const auto& [a, b, c] : mesh.triangles) std::fprintf(file.get(), "3 %u %u %u\n", a, b, c);
  if (std::fflush(file.get()) != 0) throw std::runtime_error(path + ": cannot be written; is there room?");
}

}  // namespace cnrg::bench
