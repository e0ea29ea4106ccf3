// The child gets the complex by the fork and writes what TetGen returns to a file in memory that the parent reads.
// It never returns to the caller's code: it ends by _exit, whatever happens.
//
// TetGen is given a box around the complex and fills all of it, cavities too. So nothing has to be carved away
// before the mesh is refined, which its version 1.5 often fails at, and faces, wires and points outside of all
// regions are as good as others.
#include "csg/mesh/tetgen_run.h"

#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <new>
#include <sstream>

#define TETLIBRARY
#include <tetgen.h>

#include "kernel/base/error.h"

namespace cnrg {
namespace {

using Index = TetgenResult::Index;

// How the child ends, besides the numbers that TetGen throws.
constexpr int kDone = 0, kNoMemory = 1, kUnknown = 99;

/// A nameless file in memory.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(memfd_create("cnrg", MFD_CLOEXEC)) {
    if (descriptor_ < 0) throw FileError(std::string("no file in memory: ") + std::strerror(errno));
  }
  ~MemoryFile() { close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  int descriptor() const { return descriptor_; }

  void write(const void* data, std::size_t size) const {
    for (const char* at = static_cast<const char*>(data); size > 0;) {
      const ssize_t n = ::write(descriptor_, at, size);
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) throw std::bad_alloc();
      at += n;
      size -= std::size_t(n);
    }
  }
  void rewind() const { lseek(descriptor_, 0, SEEK_SET); }
  void read(void* data, std::size_t size) const {
    for (char* at = static_cast<char*>(data); size > 0;) {
      const ssize_t n = ::read(descriptor_, at, size);
      if (n < 0 && errno == EINTR) continue;
      require(n > 0, "TetGen's result is cut short");
      at += n;
      size -= std::size_t(n);
    }
  }
  std::string text() const {
    std::string result(std::size_t(lseek(descriptor_, 0, SEEK_END)), ' ');
    rewind();
    read(result.data(), result.size());
    return result;
  }

 private:
  int descriptor_;
};

template <class T>
void write_list(const MemoryFile& file, const T* data, std::size_t n) {
  const std::uint64_t count = n;
  file.write(&count, sizeof count);
  if (n > 0) file.write(data, n * sizeof(T));
}
template <class T>
void read_list(const MemoryFile& file, std::vector<T>& list) {
  std::uint64_t count;
  file.read(&count, sizeof count);
  list.resize(count);
  file.read(list.data(), count * sizeof(T));
}

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

/// Facet markers are places from 1, edge markers edges from 2 (1 is TetGen's own), attributes regions from 1.
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
    in.regionlist[5 * i + 4] = -1;
  }
}

void write_result(const MemoryFile& file, const tetgenio& out) {
  write_list(file, out.pointlist, 3 * std::size_t(out.numberofpoints));
  write_list(file, out.tetrahedronlist, 4 * std::size_t(out.numberoftetrahedra));
  write_list(file, out.tetrahedronattributelist, std::size_t(out.numberoftetrahedra));
  write_list(file, out.trifacelist, 3 * std::size_t(out.numberoftrifaces));
  write_list(file, out.trifacemarkerlist, std::size_t(out.numberoftrifaces));
  write_list(file, out.edgelist, 2 * std::size_t(out.numberofedges));
  write_list(file, out.edgemarkerlist, std::size_t(out.numberofedges));
}

[[noreturn]] void run_child(const Plc& plc, std::string switches, TetgenFrame frame, int seconds,
                            const MemoryFile& result, const MemoryFile& said) {
  int status = kUnknown;
  try {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (seconds > 0) {
      const rlimit limit{static_cast<rlim_t>(seconds), static_cast<rlim_t>(seconds) + 1};
      setrlimit(RLIMIT_CPU, &limit);
    }
    dup2(said.descriptor(), STDOUT_FILENO);
    dup2(said.descriptor(), STDERR_FILENO);
    tetgenio in, out;
    fill(plc, frame, in);
    tetrahedralize(switches.data(), &in, &out);
    write_result(result, out);
    status = kDone;
  } catch (const std::bad_alloc&) {
    status = kNoMemory;
  } catch (const int number) {
    status = number;
  } catch (...) {
  }
  std::fflush(stdout);
  _exit(status);
}

/// The last line, without the program's name in front of a failed assertion.
std::string last_line(const std::string& text) {
  std::istringstream lines(text);
  std::string line, last;
  while (std::getline(lines, line)) {
    if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
  }
  const auto assertion = last.find("Assertion");
  return assertion == std::string::npos ? last : last.substr(assertion);
}

[[noreturn]] void fail(int status, const std::string& said) {
  constexpr const char* kCoarser =
      "; features of the model are too small beside its size: remove slivers, move nearly touching parts apart or "
      "together, or try --keep-boundary";
  const std::string words = said.empty() ? "" : ": `" + said + "`";
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) {
    throw InputError(
        "TetGen did not end in its time; give it more by --seconds, or a larger --quality or --max-volume, try "
        "--keep-boundary, or remove slivers and move nearly touching parts apart or together");
  }
  if (!WIFEXITED(status)) {
    throw InputError("TetGen was stopped by a fault of its own (signal " + std::to_string(WTERMSIG(status)) + ")" +
                     words + kCoarser + ", or other --quality and --max-volume");
  }
  switch (WEXITSTATUS(status)) {
    case kNoMemory: throw std::bad_alloc();
    case 2: throw InputError("TetGen met an error of its own (2)" + words + kCoarser);
    case 3: throw InputError("TetGen finds that facets cross (3)" + words + kCoarser);
    case 4: throw InputError("TetGen finds a feature too small for doubles (4)" + words + kCoarser);
    case 5: throw InputError("TetGen finds two facets too close to each other (5)" + words + kCoarser);
    default: throw InputError("TetGen gave up (" + std::to_string(WEXITSTATUS(status)) + ")" + words + kCoarser);
  }
}

template <std::size_t N>
void read_tuples(const MemoryFile& file, std::vector<std::array<Index, N>>& tuples) {
  std::vector<std::int32_t> numbers;
  read_list(file, numbers);
  tuples.resize(numbers.size() / N);
  for (std::size_t i = 0; i < numbers.size(); ++i) tuples[i / N][i % N] = Index(numbers[i]);
}

TetgenResult read_result(const MemoryFile& file) {
  file.rewind();
  TetgenResult result;
  std::vector<double> coordinates, attributes;
  read_list(file, coordinates);
  result.points.resize(coordinates.size() / 3);
  for (std::size_t i = 0; i < coordinates.size(); ++i) result.points[i / 3][i % 3] = coordinates[i];
  read_tuples(file, result.tetrahedra);
  read_list(file, attributes);
  for (const double a : attributes) result.attribute.push_back(std::int32_t(a));
  read_tuples(file, result.triangles);
  read_list(file, result.facet);
  for (std::int32_t& marker : result.facet) marker -= 1;
  read_tuples(file, result.segments);
  read_list(file, result.edge);
  for (std::int32_t& marker : result.edge) marker -= 2;
  return result;
}

}  // namespace

TetgenResult run_tetgen(const Plc& plc, const std::string& switches, TetgenFrame frame, int seconds) {
  const MemoryFile result, said;
  std::fflush(stdout);  // so that the child has nothing of the caller's to print
  const pid_t child = fork();
  if (child < 0) throw FileError(std::string("TetGen could not be started: ") + std::strerror(errno));
  if (child == 0) run_child(plc, "pAQMJ" + switches, frame, seconds, result, said);
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw FileError(std::string("TetGen was lost: ") + std::strerror(errno));
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != kDone) fail(status, last_line(said.text()));
  return read_result(result);
}

}  // namespace cnrg
