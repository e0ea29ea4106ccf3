// Any program that takes and writes OFF files, a process for each step.
#include <algorithm>
#include <filesystem>

#include "bench/cases/face_loops.h"
#include "bench/peers/program.h"
#include "bench/peers/system.h"
#include "bench/peers/triangles.h"
#include "csg/imports/mesh_file.h"
#include "kernel/base/error.h"

namespace cnrg::bench {
namespace {

/// Polygons that are not planar, since coordinates were rounded, become triangles.
void add_polygon(Model& model, PointLoop polygon) {
  const RationalPoint normal = doubled_area(model.points, polygon);
  const Rational level = dot(normal, model.points[polygon[0]]);
  const auto in_plane = [&](std::uint32_t p) { return dot(normal, model.points[p]) == level; };
  Model::Face face{{std::move(polygon)}, true};
  if (std::all_of(face.loops[0].begin(), face.loops[0].end(), in_plane)) {
    model.faces.push_back(std::move(face));
    return;
  }
  for (const auto& [a, b, c] : triangles_of(model.points, face)) model.faces.push_back({{{a, b, c}}, true});
}

/// All faces are taken for those of a solid. Points stay as many as the file has.
Model read_result(const std::string& path) {
  const MeshData file = cnrg::read_mesh(path, false);
  Model model;
  for (std::size_t i = 0; i < file.point_count(); ++i)
    model.points.push_back(
        {from_double(file.xyz[3 * i]), from_double(file.xyz[3 * i + 1]), from_double(file.xyz[3 * i + 2])});
  for (std::size_t f = 0; f < file.face_count(); ++f)
    add_polygon(model, {file.corners.begin() + file.offsets[f], file.corners.begin() + file.offsets[f + 1]});
  return model;
}

Answer answer_of_external(const std::vector<std::string>& program, const Problem& problem) {
  std::vector<TriangleMesh> operands;
  for (const Model& operand : problem.operands) operands.push_back(rounded_triangles(operand));
  const TemporaryFolder folder;
  Measurement measurement;
  std::vector<std::string> files;
  for (const TriangleMesh& operand : operands) {
    files.push_back(folder.file("operand" + std::to_string(files.size()) + ".off"));
    write_off(files.back(), operand);
  }
  measurement.lap("writing");
  std::string left = files[0];
  std::size_t peak_bytes = 0;
  for (std::size_t i = 0; i < problem.steps.size(); ++i) {
    const std::string out = folder.file("result" + std::to_string(i + 1) + ".off");
    const std::string step = "step " + std::to_string(i + 1) + ": ";
    std::vector<std::string> words = program;
    words.insert(words.end(), {to_string(problem.steps[i]), left, files[i + 1], out});
    const ProgramRun run = run_program(words, folder);
    if (run.status == 127) throw std::runtime_error(run.reason());
    if (!run.succeeded()) throw Refusal("program", step + run.reason());
    if (!std::filesystem::exists(out)) throw Refusal("program", step + "status 0, but no result is written");
    peak_bytes = std::max(peak_bytes, run.peak_bytes);
    left = out;
  }
  measurement.lap("program");
  Answer answer;
  try {
    answer.model = read_result(left);
  } catch (const InputError& error) {
    throw Refusal("output", error.what());
  } catch (const InvariantError&) {
    throw Refusal("output", "a polygon of the result crosses itself");
  }
  measurement.lap("reading");
  answer.measures = measurement.stop();
  answer.measures.peak_bytes = std::max(answer.measures.peak_bytes, answer.measures.base_bytes + peak_bytes);
  return answer;
}

}  // namespace

System external_system(const std::string& name, const std::vector<std::string>& program, double rounding) {
  return {.name = name,
          .title = name,
          .guarantee = "a program that takes and writes OFF files; doubles; its process is in time and memory",
          .version = [] { return std::string(); },
          .rounding = rounding,
          .regularized = true,
          .absent = "",
          .evaluate = [program](const Problem& problem) { return answer_of_external(program, problem); }};
}

}  // namespace cnrg::bench
