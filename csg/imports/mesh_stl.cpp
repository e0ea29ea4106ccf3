// STL, text and binary. Both may start with "solid"; a file is binary if its size is what a binary file with its
// count of triangles has, and text if it starts with "solid" otherwise.
#include <bit>
#include <cmath>
#include <string_view>

#include "csg/imports/little_endian.h"
#include "csg/imports/text_cursor.h"
#include "csg/leaves/leaf.h"

namespace cnrg {
namespace {

constexpr std::size_t kHeader = 84, kTriangle = 50;

void add_triangle(MeshData& mesh) {
  const std::uint32_t last = static_cast<std::uint32_t>(mesh.point_count());
  mesh.corners.insert(mesh.corners.end(), {last - 3, last - 2, last - 1});
  mesh.end_face();
}

MeshData read_binary(const std::string& path, const std::string& data) {
  const auto fail = [&](std::size_t byte, const std::string& text) {
    throw LeafFileError(path, 0, 0, "byte " + std::to_string(byte) + ": " + text);
  };
  if (data.size() < kHeader)
    fail(data.size(), "the file ends within the header of a binary STL: it is truncated, or no STL");
  const std::size_t count = little_endian(data, 80);
  const std::size_t expected = kHeader + kTriangle * count;
  if (data.size() < expected) {
    fail(data.size(), "the file ends within triangle " + std::to_string((data.size() - kHeader) / kTriangle + 1) +
                          " of " + std::to_string(count) + ": it is truncated, or no STL");
  }
  if (data.size() > expected) {
    fail(expected,
         "more data follows after the " + std::to_string(count) + " triangles of the header: correct the count");
  }
  MeshData mesh;
  mesh.xyz.reserve(9 * count);
  mesh.corners.reserve(3 * count);
  mesh.offsets.reserve(count + 1);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t start = kHeader + kTriangle * i + 12;  // after the normal, which the corners say better
    for (std::size_t k = 0; k < 9; ++k) {
      const double x = std::bit_cast<float>(little_endian(data, start + 4 * k));
      if (!std::isfinite(x)) {
        fail(start + 4 * k,
             "triangle " + std::to_string(i + 1) + " has a coordinate that is no finite number: correct the file");
      }
      mesh.xyz.push_back(x);
    }
    add_triangle(mesh);
  }
  return mesh;
}

MeshData read_text(const std::string& path, const std::string& text, bool decimal) {
  TextCursor cursor(path, text, 0);
  MeshData mesh;
  const auto expect = [&](const char* word) {
    const std::string_view token = cursor.token(word);
    if (lower(token) != word)
      cursor.fail(in_quotes(token) + " is found where '" + std::string(word) + "' is expected: correct the file");
  };
  std::uint32_t solid = 0;
  while (cursor.more()) {
    expect("solid");
    cursor.next_line();
    for (;;) {
      const std::string_view token = cursor.token("'facet' or 'endsolid'");
      if (lower(token) == "endsolid") break;
      if (lower(token) != "facet")
        cursor.fail(in_quotes(token) + " is found where 'facet' or 'endsolid' is expected: correct the file");
      cursor.next_line();  // with the normal, which the corners say better
      expect("outer");
      expect("loop");
      for (int k = 0; k < 3; ++k) {
        expect("vertex");
        cursor.coordinates(mesh, decimal);
      }
      expect("endloop");
      expect("endfacet");
      add_triangle(mesh);
      mesh.groups.push_back(solid);
    }
    cursor.next_line();
    ++solid;
  }
  if (solid < 2) mesh.groups.clear();
  return mesh;
}

}  // namespace

MeshData read_stl(const std::string& path, const std::string& text, bool decimal) {
  if (text.size() >= kHeader && text.size() == kHeader + kTriangle * little_endian(text, 80)) {
    return read_binary(path, text);
  }
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool solid = first != std::string::npos && lower(std::string_view(text).substr(first, 5)) == "solid";
  const bool printable = std::string_view(text).substr(0, 512).find('\0') == std::string_view::npos;
  return solid && printable ? read_text(path, text, decimal) : read_binary(path, text);
}

}  // namespace cnrg
