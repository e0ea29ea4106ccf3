// What a CAD file holds once it is tessellated: the faces, edges and vertices of its boundary representation, each
// with facets, segments and points that share their corners. Nothing judged, and no type of the library that read
// it: cad.cpp makes a leaf of it, whichever library that was.
//
// Numbers count from 0 in the order of the file's shape: solids, faces, edges and vertices as a walk through the
// shape, from its parts to theirs, first meets them (OpenCASCADE: TopExp::MapShapes, whose numbers are one more).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "csg/geometry/cad_surfaces.h"
#include "csg/leaves/shapes.h"

namespace cnrg {

struct CadModel {
  /// (u, v) of a triangle's corners. Where one side of the patch shrinks to a point (a pole) one
  /// parameter may have any value there: `free` (0: u, 1: v) of corner `pole`, if that is below 3.
  struct Place {
    std::array<std::array<double, 2>, 3> at;
    std::uint8_t pole = 3, free = 0;
  };
  /// A face of the model and who has it.
  struct Face {
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< of points, counter-clockwise from the front
    std::vector<Place> places;                            ///< of these
    /// Its edges, run through with the face on the left as seen from the front: the number, and if it is forward.
    /// An edge inside of the face, or a seam, at which the face meets itself, is run through in both directions.
    std::vector<std::pair<std::uint32_t, bool>> border;
    std::vector<std::uint32_t> behind, before;  ///< solids that lie on its back, on its front
    bool outside = false;                       ///< (also) used outside of all solids: by a shell, or alone
    CadSurface surface;                         ///< what carries it
  };
  struct Edge {
    std::vector<std::uint32_t> points;  ///< along the curve, equal ends where it closes; one point: no length
    std::vector<double> parameters;     ///< of these
    bool seam = false;                  ///< where one face meets itself, and no other
    CadCurve curve;                     ///< what carries it; points go from its first to its last parameter
  };
  struct Vertex {
    std::uint32_t point = 0;
    bool seam = false;  ///< an end of seams and of edges without length only
  };
  std::vector<std::array<double, 3>> points;
  std::vector<Face> faces;
  std::vector<Edge> edges;
  std::vector<Vertex> vertices;
  std::vector<std::string> solids;  ///< their names; empty: the file has none
  std::vector<std::string> notices;
};

/// Reads and tessellates. Throws InputError without a position where the file does not exist, holds no shape, or
/// cannot be transferred or tessellated; LeafFileError `file: error: ...` where the file is of another format;
/// FileError if it cannot be read. What OpenCASCADE does to the process that reads is an InputError, too: a crash,
/// no end in its time, memory that runs out (cad_occt_child.cpp). Without OpenCASCADE always InputError, which
/// says how to get it.
CadModel read_cad(const CadShape& shape);

/// `step: 'part.step': `, before what is wrong with it.
std::string cad_subject(const CadShape& shape);

}  // namespace cnrg

// Of the plug-in `cad`. From the content of a file to its facets, to be called in a child: OpenCASCADE prints, may
// crash or not end, and leaves its settings changed. Errors as at read_cad.
extern "C" {
void cnrg_cad_read(const cnrg::CadShape& shape, const std::string& content, cnrg::CadModel& model);
const char* cnrg_cad_version();
}
