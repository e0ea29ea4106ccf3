// The child gets the complex by the fork and writes what TetGen returns to a file in memory that the parent reads.
//
// TetGen is given a box around the complex and fills all of it, cavities too. So nothing has to be carved away
// before the mesh is refined, which its version 1.5 often fails at, and faces, wires and points outside of all
// regions are as good as others.
#include "csg/mesh/tetgen_run.h"

#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <csignal>
#include <ctime>
#include <new>

#define TETLIBRARY
#include <tetgen.h>

#include "csg/mesh/deadline.h"
#include "csg/text/child.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

using Index = PlcMesh::Index;

void set_polygon(tetgenio::polygon& polygon, const auto& points) {
  polygon.numberofvertices = int(points.size());
  polygon.vertexlist = new int[points.size()];
  for (std::size_t k = 0; k < points.size(); ++k) polygon.vertexlist[k] = int(points[k]);
}

/// A box around the complex, half its size away from it, or on each side a little further than on the one before.
void add_frame(TetgenFrame frame, std::vector<std::array<double, 3>>& points, std::vector<Plc::Facet>& facets) {
  auto low = points[0], high = points[0];
  for (const auto& p : points) {
    for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
  }
  const double margin = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]}) / 2;
  const double more = frame == TetgenFrame::uneven ? margin / 16 : 0;
  const auto first = Plc::Index(points.size());
  for (unsigned corner = 0; corner < 8; ++corner) {
    auto& p = points.emplace_back();
    for (unsigned k = 0; k < 3; ++k) {
      p[k] = corner >> k & 1 ? high[k] + (margin + (k + 4) * more) : low[k] - (margin + (k + 1) * more);
    }
  }
  constexpr Plc::Index kSides[6][4] = {{0, 2, 6, 4}, {1, 5, 7, 3}, {0, 4, 5, 1},
                                       {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 6, 7, 5}};
  for (const auto& side : kSides) {
    auto& polygon = facets.emplace_back().polygons.emplace_back();
    for (const Plc::Index corner : side) polygon.push_back(first + corner);
  }
}

/// Facet markers are places from 1, edge markers edges from 2 (1 is TetGen's own), attributes regions from 1. The
/// bound of volumes is one of regions, for the box around them has many times their volume.
void fill(const Plc& plc, TetgenFrame frame, tetgenio& in) {
  auto points = plc.points;
  auto facets = plc.facets;
  add_frame(frame, points, facets);
  in.firstnumber = 0;
  in.numberofpoints = int(points.size());
  in.pointlist = new REAL[3 * points.size()];
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) in.pointlist[3 * i + k] = points[i][k];
  }
  in.numberoffacets = int(facets.size());
  in.facetlist = new tetgenio::facet[facets.size()];
  in.facetmarkerlist = new int[facets.size()];
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const Plc::Facet& from = facets[i];
    tetgenio::facet& facet = in.facetlist[i];
    tetgenio::init(&facet);
    facet.numberofpolygons = int(from.polygons.size());
    facet.polygonlist = new tetgenio::polygon[from.polygons.size()];
    for (std::size_t k = 0; k < from.polygons.size(); ++k) set_polygon(facet.polygonlist[k], from.polygons[k]);
    facet.numberofholes = int(from.holes.size());
    if (!from.holes.empty()) facet.holelist = new REAL[3 * from.holes.size()];
    for (std::size_t k = 0; k < 3 * from.holes.size(); ++k) facet.holelist[k] = from.holes[k / 3][k % 3];
    in.facetmarkerlist[i] = int(i) + 1;
  }
  in.numberofedges = int(plc.segments.size());
  in.edgelist = new int[2 * plc.segments.size()];
  in.edgemarkerlist = new int[plc.segments.size()];
  for (std::size_t i = 0; i < plc.segments.size(); ++i) {
    for (std::size_t k = 0; k < 2; ++k) in.edgelist[2 * i + k] = int(plc.segments[i].ends[k]);
    in.edgemarkerlist[i] = int(plc.segments[i].edge) + 2;
  }
  in.numberofregions = int(plc.regions.size());
  in.regionlist = new REAL[5 * plc.regions.size()];
  for (std::size_t i = 0; i < plc.regions.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) in.regionlist[5 * i + k] = plc.regions[i].point[k];
    in.regionlist[5 * i + 3] = double(i + 1);
    in.regionlist[5 * i + 4] = plc.max_volume > 0 ? plc.max_volume : -1;
  }
}

void write_result(const MemoryFile& file, const tetgenio& out) {
  file.write_list(out.pointlist, 3 * std::size_t(out.numberofpoints));
  file.write_list(out.tetrahedronlist, 4 * std::size_t(out.numberoftetrahedra));
  file.write_list(out.tetrahedronattributelist, std::size_t(out.numberoftetrahedra));
  file.write_list(out.trifacelist, 3 * std::size_t(out.numberoftrifaces));
  file.write_list(out.trifacemarkerlist, std::size_t(out.numberoftrifaces));
  file.write_list(out.edgelist, 2 * std::size_t(out.numberofedges));
  file.write_list(out.edgemarkerlist, std::size_t(out.numberofedges));
}

/// TetGen's callback has no argument of ours. Only the child, which has one thread, sets these.
const TooLarge* asked_of_all = nullptr;
const SharedCount* looks = nullptr;

/// How often it may look; 0: no bound. The child has it by the fork.
std::atomic<std::size_t> most_looks = 0;

/// The child's own bound of processor time, raised with each step that it takes: a walk through a facet may turn
/// in a circle, where it looks at nothing any more.
class TimeOfStep {
 public:
  void begin(int seconds) {
    if (seconds <= 0 || getrlimit(RLIMIT_CPU, &all_) != 0) return;
    step_ = rlim_t(seconds);
    raise_bound();
  }
  void next() {
    constexpr unsigned kLooks = 256;  // to ask the system costs as much as to look
    if (step_ > 0 && ++looks_ % kLooks == 0) raise_bound();
  }

 private:
  rlimit all_{};
  rlim_t step_ = 0;  // 0: no bound
  unsigned looks_ = 0;

  void raise_bound() {
    timespec used;
    if (clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used) != 0) return;
    const rlimit bound{std::min(all_.rlim_cur, rlim_t(used.tv_sec) + 1 + step_), all_.rlim_max};
    setrlimit(RLIMIT_CPU, &bound);
  }
} time_of_step;

bool has_to_be_split(REAL* a, REAL* b, REAL* c, REAL* d, REAL*, REAL) {
  time_of_step.next();
  looks->add();
  if (most_looks > 0 && looks->value() > most_looks) std::raise(SIGXCPU);
  if (!*asked_of_all) return false;
  const auto at = [](const REAL* p) { return std::array<double, 3>{p[0], p[1], p[2]}; };
  return (*asked_of_all)({at(a), at(b), at(c), at(d)});
}

/// In the child: 0, or the number that TetGen throws.
int mesh(const Plc& plc, std::string switches, TetgenFrame frame, int step, const TooLarge& too_large,
         const SharedCount& looked, const MemoryFile& result) {
  try {
    time_of_step.begin(step);
    tetgenio in, out;
    fill(plc, frame, in);
    asked_of_all = &too_large;
    looks = &looked;
    in.tetunsuitable = &has_to_be_split;
    tetrahedralize(switches.data(), &in, &out);
    write_result(result, out);
    return 0;
  } catch (const int number) {
    return number;
  }
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
  if (end.kind == Kind::time) {
    throw TetgenLate(
        "TetGen did not end in its time; give it more by --seconds, or a larger --quality or --max-volume, "
        "remove slivers, join what nearly touches by --join, or leave out --keep-boundary");
  }
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

PlcMesh run_tetgen(const Plc& plc, const TetgenSwitches& switches, TetgenFrame frame, const TetgenTime& time,
                   const TooLarge& too_large, const std::stop_token& stop, const LookedAt& looked_at) {
  const MemoryFile result("TetGen");
  const SharedCount looked;
  const ChildLimits limits{.seconds = std::size_t(std::max(time.seconds, 0))};
  const auto work = [&] { return mesh(plc, letters(switches), frame, time.step, too_large, looked, result); };
  const Deadline deadline(Watch{{}, stop}, time.clock);
  std::function<void()> meanwhile;
  if (looked_at) meanwhile = [&] { looked_at(looked.value()); };
  try {
    require_done(run_in_child("TetGen", limits, work, deadline.watch().stop, meanwhile));
  } catch (const Stopped&) {
    if (stop.stop_requested()) throw;
    require_done({.kind = ChildEnd::Kind::time});
  }
  return read_result(result);
}

}  // namespace cnrg
