#include "tests/campaign/fuzz/targets.h"

namespace cnrg::fuzz {

std::span<const Target> targets() {
  static constexpr Target kTargets[] = {
      {"tree", run_tree}, {"off", run_off},       {"obj", run_obj},     {"ply", run_ply},
      {"stl", run_stl},   {"vtp", run_vtp},       {"vtk", run_vtk},     {"msh", run_msh},
      {"glb", run_glb},   {"3mf", run_3mf},       {"gocad", run_gocad}, {"csg", run_csg},
      {"grid", run_grid}, {"points", run_points}, {"json", run_json},   {"soup", run_soup},
#ifdef CNRG_FUZZ_CAD
      {"step", run_step}, {"brep", run_brep},
#endif
  };
  return kTargets;
}

}  // namespace cnrg::fuzz
