// The formats, one file each. A format turns a result into the text of its file.
#pragma once

#include <string>

#include "csg/result/flat.h"

namespace cnrg {

struct Mesh;

struct FileText {
  std::string text;
  RoundingReport rounding;
};

/// The text of a file of that name, in the format of its extension. `binary`: in the binary form of a format that
/// has two. Throws as `write` of writer.h does, and RoundingFault (csg/result/rounding.h) for a result that
/// rounding breaks and that the format does not hold then.
FileText file_text(const std::string& path, const ResultView& view, bool binary = false);

FileText json_text(const ResultView& view);
FileText vtu_text(const ResultView& view);
FileText obj_text(const ResultView& view);
FileText off_text(const ResultView& view);
FileText stl_text(const ResultView& view);
FileText ply_text(const ResultView& view);
// Binary forms. That of STL holds numbers of 24 bits, and RoundingFault says that these break the result.
FileText stl_bytes(const ResultView& view);
FileText ply_bytes(const ResultView& view);
FileText three_mf_text(const ResultView& view);
// With ResultView::parameters on true surfaces; GLB with the normals of these.
FileText glb_text(const ResultView& view);

FileText smesh_text(const ResultView& view);
FileText poly_text(const ResultView& view);

// What meshers read.
std::string msh_text(const Mesh& mesh);
std::string msh2_text(const Mesh& mesh);
std::string medit_text(const Mesh& mesh);
std::string flac3d_text(const Mesh& mesh);
std::string abaqus_text(const Mesh& mesh);
std::string nastran_text(const Mesh& mesh);
std::string h5m_bytes(const Mesh& mesh);
std::string med_bytes(const Mesh& mesh);
/// One dimension of it, which the name says: `.points.xdmf`, `.edges.xdmf`, `.faces.xdmf`, else the highest.
/// Throws InputError for a mesh without such simplices.
std::string xdmf_text(const std::string& path, const Mesh& mesh);
std::string vtu_text(const ResultView& view, const Mesh& mesh);

}  // namespace cnrg
