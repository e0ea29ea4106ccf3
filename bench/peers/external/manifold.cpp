// Manifold: meshes in doubles, all operands in one BatchBoolean.
#include <manifold/manifold.h>

#include <stdexcept>

#include "bench/peers/external/measured.h"

namespace {

using namespace cnrg::bench;
using manifold::Manifold;
using manifold::MeshGL64;
using manifold::OpType;

MeshGL64 mesh_of(const TriangleMesh& in) {
  MeshGL64 mesh;
  for (const auto& p : in.points) mesh.vertProperties.insert(mesh.vertProperties.end(), p.begin(), p.end());
  for (const auto& t : in.triangles) mesh.triVerts.insert(mesh.triVerts.end(), t.begin(), t.end());
  return mesh;
}

TriangleMesh mesh_of(const MeshGL64& in) {
  TriangleMesh mesh;
  for (std::size_t i = 0; i < in.vertProperties.size(); i += in.numProp)
    mesh.points.push_back({in.vertProperties[i], in.vertProperties[i + 1], in.vertProperties[i + 2]});
  const auto vertex = [&](std::size_t i) { return static_cast<std::uint32_t>(in.triVerts[i]); };
  for (std::size_t i = 0; i < in.triVerts.size(); i += 3)
    mesh.triangles.push_back({vertex(i), vertex(i + 1), vertex(i + 2)});
  return mesh;
}

void check(const Manifold& m, const char* what) {
  if (m.Status() != Manifold::Error::NoError)
    throw std::runtime_error(std::string(what) + " has status " + std::to_string(static_cast<int>(m.Status())));
}

Measured boolean(const std::string& operation, const std::vector<TriangleMesh>& operands) {
  const OpType type = operation == "union"        ? OpType::Add
                      : operation == "difference" ? OpType::Subtract
                                                  : OpType::Intersect;
  std::vector<MeshGL64> meshes;
  for (const TriangleMesh& operand : operands) meshes.push_back(mesh_of(operand));
  Measurement measurement;
  std::vector<Manifold> solids;
  for (const MeshGL64& mesh : meshes) {
    solids.emplace_back(mesh);
    check(solids.back(), "an operand");
  }
  const Manifold result = Manifold::BatchBoolean(solids, type);
  check(result, "the result");  // it is computed here
  measurement.lap("Boolean");
  const Measures measures = measurement.stop();
  return {mesh_of(result.GetMeshGL64()), measures};
}

}  // namespace

int main(int argc, char** argv) { return measured_main(argc, argv, boolean); }
