// Files that leaves read. Each is written and read by its name, as a user's file is, in a tree of that one leaf.
// The last byte also chooses among the leaf's options: it is mostly a line end or one of many numbers, and the
// file that makes a fault is then all that is needed to see it again.
#include "tests/campaign/fuzz/targets.h"
#include "tests/campaign/fuzz/targets/small.h"

namespace cnrg::fuzz {
namespace {

unsigned choice(std::string_view bytes, unsigned n) {
  return bytes.empty() ? 0 : static_cast<unsigned char>(bytes.back()) % n;
}

/// Evaluates a tree of one leaf `kind: {file: NAME, OPTIONS}` on a file of that name with these bytes.
void run_file(const std::string& kind, const std::string& name, const std::string& options,
              std::string_view bytes) {
  accept_errors([&] {
    folder().write(name, bytes);
    const std::string leaf = kind == "cnrg" ? name : "{file: " + name + options + "}";
    Tree tree =
        parse_tree("cnrg: 1\nnodes:\n  a: {" + kind + ": " + leaf + "}\nresult: a\n", folder().path("tree.yaml"));
    make_coarse(tree);
    evaluate_small(tree);
  });
}

void run_mesh(const char* name, std::string_view bytes) {
  constexpr const char* kOptions[] = {"",
                                      "",
                                      ", coordinates: decimal",
                                      ", fill: winding",
                                      ", fill: parity",
                                      ", fill: cells",
                                      ", fill: none, coordinates: decimal"};
  run_file("mesh", name, kOptions[choice(bytes, std::size(kOptions))], bytes);
}

}  // namespace

void run_off(std::string_view bytes) { run_mesh("mesh.off", bytes); }
void run_obj(std::string_view bytes) { run_mesh("mesh.obj", bytes); }
void run_ply(std::string_view bytes) { run_mesh("mesh.ply", bytes); }
void run_stl(std::string_view bytes) { run_mesh("mesh.stl", bytes); }
void run_vtp(std::string_view bytes) { run_mesh("mesh.vtp", bytes); }
void run_vtk(std::string_view bytes) { run_mesh("mesh.vtk", bytes); }
void run_msh(std::string_view bytes) { run_mesh("mesh.msh", bytes); }
void run_glb(std::string_view bytes) { run_mesh("mesh.glb", bytes); }
void run_3mf(std::string_view bytes) { run_mesh("mesh.3mf", bytes); }
void run_gocad(std::string_view bytes) { run_mesh("mesh.ts", bytes); }

void run_csg(std::string_view bytes) {
  accept_errors([&] {
    folder().write("model.csg", bytes);
    Tree tree = parse_tree("cnrg: 1\nnodes:\n  a: {csg: model.csg}\nresult: a\n", folder().path("tree.yaml"));
    evaluate_small(tree);
  });
}

void run_grid(std::string_view bytes) {
  run_file("heightfield", "grid.asc", choice(bytes, 2) == 0 ? "" : ", base: -3", bytes);
}

void run_points(std::string_view bytes) {
  run_file("heightfield", "points.xyz", choice(bytes, 2) == 0 ? "" : ", base: -3", bytes);
}

void run_json(std::string_view bytes) { run_file("cnrg", "in.json", "", bytes); }

void run_step(std::string_view bytes) {
  run_file("step", "part.step", choice(bytes, 3) == 0 ? ", unit: m, seams: true" : "", bytes);
}

void run_brep(std::string_view bytes) {
  run_file("brep", "part.brep", choice(bytes, 3) == 0 ? ", seams: true" : "", bytes);
}

}  // namespace cnrg::fuzz
