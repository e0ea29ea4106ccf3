// The child gets the complex by the fork and writes what TetGen returns to a file in memory that the parent reads.
#include "csg/mesh/tetgen_run.h"

#include <atomic>
#include <charconv>
#include <new>

#include "csg/mesh/deadline.h"
#include "csg/text/child.h"
#include "csg/text/plugin.h"

namespace cnrg {
namespace {

using Index = PlcMesh::Index;

/// How often it may look; 0: no bound.
std::atomic<std::size_t> most_looks = 0;

[[noreturn]] void fail_late(const std::string& how, const std::string& more) {
  throw TetgenLate("TetGen " + how + "; " + more +
                   "or a larger --quality or --max-volume, remove slivers, join what nearly touches by --join, or "
                   "leave out --keep-boundary");
}

/// What follows a `;` is for --keep-boundary: without it there is another way to a mesh, and nobody reads this.
void require_done(const ChildEnd& end) {
  using Kind = ChildEnd::Kind;
  constexpr int kNoMemory = 1;  // TetGen's own number for it
  constexpr const char* kCoarser =
      "; features of the model are too small beside its size: join what nearly touches by --join, remove slivers, "
      "or leave out --keep-boundary";
  const std::string words = end.said.empty() ? "" : ": `" + end.said + "`";
  if (end.kind == Kind::done && end.number == 0) return;
  if (end.kind == Kind::memory || (end.kind == Kind::done && end.number == kNoMemory)) throw std::bad_alloc();
  if (end.kind == Kind::done && end.number == kTetgenOutOfSteps)
    fail_late("did not come to an end", "give it time by --seconds 0, ");
  if (end.kind == Kind::signal) {
    throw InputError("TetGen was stopped by a fault of its own (signal " + std::to_string(end.number) + ")" +
                     words + kCoarser + ", or other --quality and --max-volume");
  }
  switch (end.number) {
    case 2: throw InputError("TetGen met an error of its own (2)" + words + kCoarser);
    case 3: throw InputError("TetGen finds that facets cross (3)" + words + kCoarser);
    case 4: throw InputError("TetGen finds a feature too small for doubles (4)" + words + kCoarser);
    case 5: throw InputError("TetGen finds two facets too close to each other (5)" + words + kCoarser);
    default: throw InputError("TetGen gave up (" + std::to_string(end.number) + ")" + words + kCoarser);
  }
}

/// As TetGen's manual has them.
std::string letters(const TetgenSwitches& switches) {
  std::string text = "pAQMJ";
  if (switches.keep_boundary) text += "Y";
  if (switches.quality > 0) {
    char buffer[32];
    text += "q";
    text.append(buffer,
                std::to_chars(buffer, buffer + sizeof buffer, switches.quality, std::chars_format::fixed).ptr);
  }
  if (switches.volumes) text += "a";
  return text;
}

template <std::size_t N>
void read_tuples(const MemoryFile& file, std::vector<std::array<Index, N>>& tuples) {
  std::vector<std::int32_t> numbers;
  file.read_list(numbers);
  tuples.resize(numbers.size() / N);
  for (std::size_t i = 0; i < numbers.size(); ++i) tuples[i / N][i % N] = Index(numbers[i]);
}

PlcMesh read_result(const MemoryFile& file) {
  file.rewind();
  PlcMesh result;
  std::vector<double> coordinates, attributes;
  file.read_list(coordinates);
  result.points.resize(coordinates.size() / 3);
  for (std::size_t i = 0; i < coordinates.size(); ++i) result.points[i / 3][i % 3] = coordinates[i];
  read_tuples(file, result.tetrahedra);
  file.read_list(attributes);
  for (const double a : attributes) result.attribute.push_back(std::int32_t(a));
  read_tuples(file, result.triangles);
  file.read_list(result.facet);
  for (std::int32_t& marker : result.facet) marker -= 1;
  read_tuples(file, result.segments);
  file.read_list(result.edge);
  for (std::int32_t& marker : result.edge) marker -= 2;
  return result;
}

}  // namespace

TetgenLooksAtMost::TetgenLooksAtMost(std::size_t looks) { most_looks = looks; }
TetgenLooksAtMost::~TetgenLooksAtMost() { most_looks = 0; }

PlcMesh run_tetgen(const Plc& plc, const TetgenSwitches& switches, TetgenFrame frame, const TetgenBounds& bounds,
                   const TooLarge& too_large, const std::stop_token& stop, const LookedAt& looked_at) {
  const auto mesh = CNRG_PLUGIN_FUNCTION(kTetgenPlugin, cnrg_tetgen_mesh);
  const MemoryFile result("TetGen");
  const SharedCount looked;
  const TetgenWork asked{letters(switches), frame, bounds, most_looks, &too_large, &looked};
  const auto work = [&] { return mesh(plc, asked, result); };
  const Deadline deadline(Watch{{}, stop}, bounds.clock);
  std::function<void()> meanwhile;
  if (looked_at) meanwhile = [&] { looked_at(looked.value()); };
  try {
    require_done(run_in_child("TetGen", {}, work, deadline.watch().stop, meanwhile));
  } catch (const Stopped&) {
    if (stop.stop_requested()) throw;
    fail_late("did not end in its part of --seconds", "give more --seconds, ");
  }
  return read_result(result);
}

}  // namespace cnrg
