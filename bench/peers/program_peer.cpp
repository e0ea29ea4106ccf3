#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "bench/peers/peer.h"
#include "bench/peers/program.h"

namespace cnrg::bench {
namespace {

double rounded_volume(const TriangleMesh& mesh) {
  const auto& origin = mesh.points[mesh.triangles[0][0]];
  long double sum = 0;
  for (const auto& t : mesh.triangles) {
    long double v[3][3];
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) v[i][k] = static_cast<long double>(mesh.points[t[i]][k]) - origin[k];
    sum += v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) - v[0][1] * (v[1][0] * v[2][2] - v[1][2] * v[2][0]) +
           v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]);
  }
  return static_cast<double>(sum / 6);
}

/// What the program says of itself; false if it says nothing.
bool read_measures(const ProgramRun& run, Measures& measures) {
  for (const std::string& line : run.errors) {
    std::istringstream words(line);
    std::string word;
    double seconds = 0;
    if (words >> word && word == "measured" && words >> seconds >> measures.base_bytes >> measures.peak_bytes) {
      measures.stages = {{"Boolean", seconds}};
      return true;
    }
  }
  return false;
}

}  // namespace

Outcome evaluate_program(const std::string& executable, const Case& c, const Checks& checks, int threads) {
  using Clock = std::chrono::steady_clock;
  const TemporaryFolder folder;
  std::vector<std::string> words{executable, to_string(c.operation)};
  for (const TriangleMesh& leaf : c.leaves) {
    words.push_back(folder.file(std::to_string(words.size() - 1) + ".off"));
    write_off(words.back(), leaf);
  }
  const std::string out = folder.file("out.off");
  words.push_back(out);
  setenv("CNRG_THREADS", std::to_string(threads).c_str(), 1);
  const auto begin = Clock::now();
  const ProgramRun run = run_program(words, folder);
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  if (!run.succeeded()) throw std::runtime_error(run.reason());
  if (!std::filesystem::exists(out)) throw std::runtime_error("status 0, but no result is written");
  Outcome outcome;
  if (!read_measures(run, outcome.measures)) {
    outcome.measures = {{{"process", seconds}}, 0, run.peak_bytes};
    outcome.note = "whole process; ";
  }
  outcome.note += "doubles";
  const TriangleMesh result = read_mesh(out);
  outcome.vertices = result.points.size();
  outcome.faces = result.triangles.size();
  if (checks.volume) outcome.volume = rounded_volume(result);
  return outcome;
}

}  // namespace cnrg::bench
