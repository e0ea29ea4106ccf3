#include "csg/mesh/cell_groups.h"

#include "csg/mesh/mesh.h"
#include "csg/result/result_data.h"

namespace cnrg {

std::array<std::vector<CellGroup>, 4> cell_groups(const Result& result) {
  const ResultView view = result.data().view();
  const MeshGroups groups = mesh_groups(view, flatten(view));
  std::array<std::vector<CellGroup>, 4> out;
  for (std::size_t d = 0; d < 4; ++d) {
    for (const std::string& name : groups.names[d]) out[d].push_back({name, {}});
    for (std::size_t i = 0; i < groups.of[d].size(); ++i) {
      for (const Mesh::Index group : groups.of[d][i])
        out[d][group - 1].cells.push_back(static_cast<std::int32_t>(i));
    }
  }
  return out;
}

}  // namespace cnrg
