// The plug-in's part: TetGen itself, in the child.
//
// TetGen is given a box around the complex and fills all of it, cavities too. So nothing has to be carved away
// before the mesh is refined, which its version 1.5 often fails at, and faces, wires and points outside of all
// regions are as good as others.
//
// It tells nobody how far it is but where it refines, and now and then walks in circles. All its walks ask on
// which side of a plane a point lies, by `orient3d`, which is a function of its own library: ours comes before it,
// counts and asks it. So work is bounded by a number that is the same on every machine.
#include <dlfcn.h>

#define TETLIBRARY
#include <tetgen.h>

#include "csg/mesh/reach.h"
#include "csg/mesh/tetgen_run.h"
#include "csg/text/child.h"
#include "csg/text/plugin.h"

namespace cnrg {
namespace {

void set_polygon(tetgenio::polygon& polygon, const auto& points) {
  polygon.numberofvertices = int(points.size());
  polygon.vertexlist = new int[points.size()];
  for (std::size_t k = 0; k < points.size(); ++k) polygon.vertexlist[k] = int(points[k]);
}

/// A box around the complex, half its size away from it, or on each side a little further than on the one before.
void add_frame(TetgenFrame frame, std::vector<std::array<double, 3>>& points, std::vector<Plc::Facet>& facets) {
  const Reach reach(points);
  const double margin = reach.longest_side() / 2;
  const double more = frame == TetgenFrame::uneven ? margin / 16 : 0;
  const auto first = Plc::Index(points.size());
  for (unsigned corner = 0; corner < 8; ++corner) {
    auto& p = points.emplace_back();
    for (unsigned k = 0; k < 3; ++k) {
      p[k] = corner >> k & 1 ? reach.box.hi[k] + (margin + (k + 4) * more)
                             : reach.box.lo[k] - (margin + (k + 1) * more);
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

/// Thrown through TetGen, which lets numbers of its own out in the same way.
struct OutOfSteps {};

/// What is left of the work.
struct Budget {
  std::size_t looks = 0;        ///< how often it may look at tetrahedra; 0: no bound
  std::size_t most = SIZE_MAX;  ///< steps
  std::size_t idle = SIZE_MAX;  ///< of these until the next look
  std::size_t steps = 0, since_look = 0;

  void step() {
    if (++steps > most || ++since_look > idle) throw OutOfSteps();
  }
  void look() {
    looked->add();
    since_look = 0;
    if (looks > 0 && looked->value() > looks) throw OutOfSteps();
  }
  const SharedCount* looked = nullptr;
} budget;

bool has_to_be_split(REAL* a, REAL* b, REAL* c, REAL* d, REAL*, REAL) {
  budget.look();
  if (!*asked_of_all) return false;
  const auto at = [](const REAL* p) { return std::array<double, 3>{p[0], p[1], p[2]}; };
  return (*asked_of_all)({at(a), at(b), at(c), at(d)});
}

}  // namespace
}  // namespace cnrg

CNRG_PLUGIN_EXPORT int cnrg_tetgen_mesh(const cnrg::Plc& plc, const cnrg::TetgenWork& work,
                                        const cnrg::MemoryFile& result) {
  using namespace cnrg;
  try {
    tetgenio in, out;
    fill(plc, work.frame, in);
    asked_of_all = work.too_large;
    const auto bound = [](std::size_t n) { return n == 0 ? SIZE_MAX : n; };
    budget = {.looks = work.most_looks,
              .most = bound(work.bounds.steps),
              .idle = bound(work.bounds.idle),
              .looked = work.looked};
    in.tetunsuitable = &has_to_be_split;
    std::string switches = work.switches;
    tetrahedralize(switches.data(), &in, &out);
    write_result(result, out);
    return 0;
  } catch (const int number) {
    return number;
  } catch (const OutOfSteps&) {
    return kTetgenOutOfSteps;
  }
}

#ifdef CNRG_TETGEN_STATIC  // the linker gives the name to ours
#define CNRG_ORIENT3D __wrap__Z8orient3dPdS_S_S_
extern "C" double __real__Z8orient3dPdS_S_S_(double*, double*, double*, double*);
#else  // the loader finds ours first
#define CNRG_ORIENT3D _Z8orient3dPdS_S_S_
#endif
CNRG_PLUGIN_EXPORT double CNRG_ORIENT3D(double* a, double* b, double* c, double* d) {
#ifdef CNRG_TETGEN_STATIC
  constexpr auto kAsked = __real__Z8orient3dPdS_S_S_;
#else
  using Orient3d = double (*)(double*, double*, double*, double*);
  static const auto kAsked = reinterpret_cast<Orient3d>(dlsym(RTLD_NEXT, "_Z8orient3dPdS_S_S_"));
#endif
  cnrg::budget.step();
  return kAsked(a, b, c, d);
}

CNRG_PLUGIN_EXPORT const char* cnrg_tetgen_version() { return "TetGen " CNRG_TETGEN_VERSION; }
