// OpenSCAD as a program: polyhedra and operators as its text in, its Nef polyhedron out.
//
// OpenSCAD 2021.01 cuts coordinates off to multiples of 2^-20, whatever their size, and computes exactly from
// there. Results come as `nef3`, which is exact; its OFF, STL and AMF have six digits.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "bench/peers/built_in.h"
#include "bench/peers/nef_file.h"
#include "bench/peers/program.h"
#include "bench/peers/triangles.h"

namespace cnrg::bench {
namespace {

void write_polyhedron(std::ostream& out, const TriangleMesh& mesh) {
  char line[96];
  out << "polyhedron(points=[";
  for (const auto& [x, y, z] : mesh.points) {
    std::snprintf(line, sizeof line, "[%.17g,%.17g,%.17g],\n", x, y, z);
    out << line;
  }
  out << "],faces=[";
  for (const auto& [a, b, c] : mesh.triangles) out << '[' << a << ',' << c << ',' << b << "],\n";  // clockwise
  out << "]);\n";
}

/// Runs of one operation are one operator with many children.
void write_program(const std::string& path, const Problem& problem, const std::vector<TriangleMesh>& operands) {
  std::ofstream out(path);
  const auto& steps = problem.steps;
  for (std::size_t i = steps.size(); i-- > 0;)
    if (i + 1 == steps.size() || steps[i] != steps[i + 1]) out << to_string(steps[i]) << "() {\n";
  write_polyhedron(out, operands[0]);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    write_polyhedron(out, operands[i + 1]);
    if (i + 1 == steps.size() || steps[i] != steps[i + 1]) out << "}\n";
  }
  out.close();
  if (!out) throw std::runtime_error(path + ": cannot be written; is there room?");
}

/// The first line with one of these words; an empty text if there is none. OpenSCAD goes on without the object
/// that it could not make and ends with status 0, so its words count.
std::string line_with(const ProgramRun& run, std::initializer_list<const char*> words) {
  for (const std::string& line : run.errors)
    for (const char* word : words)
      if (line.find(word) != std::string::npos) return line;
  return {};
}

Answer answer_of_openscad(const Problem& problem) {
  std::vector<TriangleMesh> operands;
  for (const Model& operand : problem.operands) operands.push_back(rounded_triangles(operand));
  const TemporaryFolder folder;
  const std::string in = folder.file("in.scad"), out = folder.file("out.nef3");
  Measurement measurement;
  write_program(in, problem, operands);
  measurement.lap("writing");
  const ProgramRun run = run_program({"openscad", "-o", out, in}, folder);
  const std::string fault = line_with(run, {"ERROR", "CGAL error"});
  const bool empty = !line_with(run, {"Current top level object is empty"}).empty();
  if (!fault.empty()) throw Refusal("program", fault);
  if (!empty && !run.succeeded()) throw Refusal("program", run.reason());
  measurement.lap("program");
  Answer answer;
  if (!empty) {
    std::error_code error;
    if (std::filesystem::file_size(out, error) == 0 || error) throw Refusal("output", run.reason());
    answer.model = read_nef(out);
  }
  measurement.lap("reading");
  answer.measures = measurement.stop();
  answer.measures.peak_bytes = std::max(answer.measures.peak_bytes, answer.measures.base_bytes + run.peak_bytes);
  return answer;
}

}  // namespace

System openscad_system() {
  return {.name = "openscad",
          .title = "OpenSCAD",
          .guarantee =
              "closed 2-manifolds, coordinates cut off to multiples of 2^-20, exact from there; "
              "a program: its process is in time and memory",
          .version =
              [] {
                const TemporaryFolder folder;
                const ProgramRun run = run_program({"openscad", "--version"}, folder);
                return run.errors.empty() ? std::string() : run.errors.back();
              },
          .rounding = 0x1p-20,
          .regularized = false,
          .absent = on_path("openscad") ? "" : "there is no program openscad; install the package openscad",
          .evaluate = answer_of_openscad};
}

}  // namespace cnrg::bench
