// Mesh files as they are written: points, polygons, lines; nothing merged, nothing judged.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "kernel/exact/rational.h"

namespace cnrg {

/// What a mesh file says. Indices count from 0 and are in range, coordinates are finite.
struct MeshData {
  std::vector<double> xyz;                                     ///< nearest doubles, three for each point
  std::vector<std::pair<std::uint32_t, RationalPoint>> exact;  ///< points that are no doubles, by rising index
  std::vector<std::uint32_t> corners, offsets{0};  ///< polygon i: corners[offsets[i] .. offsets[i + 1]]
  std::vector<std::uint32_t> groups;               ///< of each polygon; empty: the file has none
  std::vector<std::array<std::uint32_t, 2>> wires;
  std::vector<std::uint32_t> points;  ///< isolated ones

  std::size_t point_count() const { return xyz.size() / 3; }
  std::size_t face_count() const { return offsets.size() - 1; }
  void end_face() { offsets.push_back(static_cast<std::uint32_t>(corners.size())); }
};

/// Reads a mesh by the extension of `path` (.off .obj .stl .ply, in any case). Coordinates are the doubles that
/// the text rounds to; with `decimal` exactly the decimals of a text file.
/// Throws LeafFileError (`path:line: error: ...`, for binary data `path: byte N: error: ...`) for a fault in the
/// file, InputError if the extension is unknown; else as `read_file` (csg/text/input_file.h).
MeshData read_mesh(const std::string& path, bool decimal, const std::string& inside = {});

// One reader each. `text` is the file's content, `path` is for messages.
MeshData read_off(const std::string& path, const std::string& text, bool decimal);
MeshData read_obj(const std::string& path, const std::string& text, bool decimal);
MeshData read_stl(const std::string& path, const std::string& text, bool decimal);
MeshData read_ply(const std::string& path, const std::string& text, bool decimal);

}  // namespace cnrg
