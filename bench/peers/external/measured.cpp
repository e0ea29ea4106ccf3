#include "bench/peers/external/measured.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace cnrg::bench {
namespace {

/// As `write_off` writes them.
TriangleMesh read_off(const std::string& path) {
  std::ifstream in(path);
  std::string word;
  std::size_t points = 0, triangles = 0, edges = 0, corners = 0;
  if (!(in >> word >> points >> triangles >> edges) || word != "OFF")
    throw std::runtime_error(path + ": no file OFF");
  TriangleMesh mesh;
  mesh.points.resize(points);
  mesh.triangles.resize(triangles);
  for (auto& [x, y, z] : mesh.points) in >> x >> y >> z;
  for (auto& [a, b, c] : mesh.triangles) {
    if (in >> corners >> a >> b >> c && (corners != 3 || std::max({a, b, c}) >= points))
      throw std::runtime_error(path + ": a face is no triangle of its points");
  }
  if (!in) throw std::runtime_error(path + ": ends early");
  return mesh;
}

std::size_t threads() {
  const char* const text = std::getenv("CNRG_THREADS");
  return text == nullptr ? 1 : std::max(1ul, std::strtoul(text, nullptr, 10));
}

}  // namespace

int measured_main(int argc, char** argv, Boolean boolean) {
  if (argc < 5) {
    std::fprintf(stderr, "usage: %s OPERATION A.off B.off... OUT.off\n", argv[0]);
    return 2;
  }
  try {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads());
    std::vector<TriangleMesh> operands;
    for (int i = 2; i + 1 < argc; ++i) operands.push_back(read_off(argv[i]));
    const Measured measured = boolean(argv[1], operands);
    write_off(argv[argc - 1], measured.result);
    std::fprintf(stderr, "measured %.6f %zu %zu\n", measured.measures.seconds(), measured.measures.base_bytes,
                 measured.measures.peak_bytes);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

}  // namespace cnrg::bench
