#include "bench/peers/triangles.h"

#include "bench/cases/face_loops.h"
#include "bench/peers/system.h"
#include "kernel/base/error.h"

namespace cnrg::bench {

TriangleMesh rounded_triangles(const Model& model) {
  if (!model.solid()) throw Refusal("input", "an operand is no solid");
  TriangleMesh mesh;
  for (const auto& [x, y, z] : model.points) mesh.points.push_back({to_double(x), to_double(y), to_double(z)});
  try {
    for (const Model::Face& face : model.faces) {
      const auto triangles = triangles_of(model.points, face);
      mesh.triangles.insert(mesh.triangles.end(), triangles.begin(), triangles.end());
    }
  } catch (const InvariantError&) {
    throw Refusal("input", "a face of an operand crosses or touches itself");
  }
  return mesh;
}

}  // namespace cnrg::bench
