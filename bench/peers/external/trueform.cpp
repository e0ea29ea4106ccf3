// trueform: Booleans of two meshes, here in doubles.
#include <stdexcept>
#include <trueform/trueform.hpp>

#include "bench/peers/external/measured.h"

namespace {

using namespace cnrg::bench;
using Mesh = tf::polygons_buffer<int, double, 3, 3>;

Mesh mesh_of(const TriangleMesh& in) {
  Mesh mesh;
  for (const auto& [x, y, z] : in.points) mesh.points_buffer().emplace_back(x, y, z);
  for (const auto& [a, b, c] : in.triangles)
    mesh.faces_buffer().emplace_back(static_cast<int>(a), static_cast<int>(b), static_cast<int>(c));
  return mesh;
}

/// Faces of more than three corners, if there are any, as fans.
template <class Result>
TriangleMesh triangles_of(const Result& in) {
  TriangleMesh mesh;
  for (const auto& p : in.points()) mesh.points.push_back({p[0], p[1], p[2]});
  for (const auto& face : in.faces()) {
    for (std::size_t i = 2; i < face.size(); ++i)
      mesh.triangles.push_back({static_cast<std::uint32_t>(face[0]), static_cast<std::uint32_t>(face[i - 1]),
                                static_cast<std::uint32_t>(face[i])});
  }
  return mesh;
}

Measured boolean(const std::string& operation, const std::vector<TriangleMesh>& operands) {
  if (operands.size() != 2) throw std::runtime_error("two operands only");
  const tf::boolean_op type = operation == "union"        ? tf::boolean_op::merge
                              : operation == "difference" ? tf::boolean_op::left_difference
                                                          : tf::boolean_op::intersection;
  const Mesh first = mesh_of(operands[0]), second = mesh_of(operands[1]);
  Measurement measurement;
  const auto [result, labels] = tf::make_boolean(first.polygons(), second.polygons(), type);
  measurement.lap("Boolean");
  const Measures measures = measurement.stop();
  return {triangles_of(result), measures};
}

}  // namespace

int main(int argc, char** argv) { return measured_main(argc, argv, boolean); }
