// Object File Format (Geomview, "OFF"): a header word, three counts, one line for each vertex and each face.
// [ST][C][N]OFF add texture, colour and normal to a vertex's line, which are skipped, as are colours of faces.
#include <algorithm>
#include <string_view>

#include "csg/imports/text_cursor.h"

namespace cnrg {
namespace {

/// Takes the header word off the front of the first token: what is left of it may hold the first count.
std::string_view after_header(TextCursor& cursor, std::string_view token) {
  const std::size_t at = token.find("OFF");
  if (at == std::string_view::npos) {
    if (!token.empty() && token[0] >= '0' && token[0] <= '9') return token;  // the word is optional
    cursor.fail(in_quotes(token) + " is no OFF header: the file must start with OFF");
  }
  std::string_view prefix = token.substr(0, at);
  for (std::string_view part : {"ST", "C", "N"}) {
    if (prefix.substr(0, part.size()) == part) prefix.remove_prefix(part.size());
  }
  if (prefix == "4" || prefix == "n" || prefix == "4n") {
    cursor.fail(in_quotes(token) + " has points of another dimension than 3: convert it to OFF");
  }
  if (!prefix.empty()) cursor.fail(in_quotes(token) + " is no OFF header: the file must start with OFF");
  return token.substr(at + 3);
}

std::uint32_t count(TextCursor& cursor, long long value, const char* what) {
  if (value < 0 || value > 1000000000) {
    cursor.fail("the number of " + std::string(what) + " is " + std::to_string(value) +
                ", but must be between 0 and 10^9: correct it");
  }
  return static_cast<std::uint32_t>(value);
}

}  // namespace

MeshData read_off(const std::string& path, const std::string& text, bool decimal) {
  TextCursor cursor(path, text, '#');
  const std::string_view rest = after_header(cursor, cursor.token("the word OFF"));
  long long first = -1;
  if (rest.empty()) {
    const std::string_view next = cursor.token("the number of vertices");
    if (next == "BINARY") cursor.fail("binary OFF is not read: convert it to text, or to PLY or STL");
    first = cursor.integer(next, "the number of vertices");
  } else {
    first = cursor.integer(rest, "the number of vertices");
  }
  const std::uint32_t vertices = count(cursor, first, "vertices");
  const std::uint32_t faces = count(cursor, cursor.integer("the number of faces"), "faces");
  cursor.next_line();  // with the number of edges, which nobody needs

  MeshData mesh;
  const std::size_t plausible = text.size();  // counts of a damaged file must not reserve more than it can hold
  mesh.xyz.reserve(3 * std::min<std::size_t>(vertices, plausible));
  mesh.offsets.reserve(1 + std::min<std::size_t>(faces, plausible));
  mesh.corners.reserve(3 * std::min<std::size_t>(faces, plausible));
  const std::string vertex_end = std::to_string(vertices) + " vertices";
  for (std::uint32_t i = 0; i < vertices; ++i) {
    if (!cursor.more()) {
      cursor.fail_at_end("the file ends after " + std::to_string(i) + " of " + vertex_end);
    }
    cursor.coordinates(mesh, decimal);
    cursor.next_line();
  }
  for (std::uint32_t i = 0; i < faces; ++i) {
    if (!cursor.more()) {
      cursor.fail_at_end("the file ends after " + std::to_string(i) + " of " + std::to_string(faces) + " faces");
    }
    const long long corners = cursor.integer("the number of corners of a face");
    if (corners < 1)
      cursor.fail("a face with " + std::to_string(corners) + " corners: give at least 3, or correct the counts");
    for (long long k = 0; k < corners; ++k) {
      const long long index = cursor.integer("the index of a corner");
      if (index < 0 || index >= vertices) {
        cursor.fail("face " + std::to_string(i) + " has the vertex " + std::to_string(index) + ", but there are " +
                    vertex_end + ", numbered from 0: correct the index or the count");
      }
      mesh.corners.push_back(static_cast<std::uint32_t>(index));
    }
    mesh.end_face();
    cursor.next_line();
  }
  if (cursor.more()) {
    cursor.fail("there is more data (" + in_quotes(cursor.token_in_line()) + ") after " + vertex_end + " and " +
                std::to_string(faces) + " faces: correct the counts");
  }
  return mesh;
}

}  // namespace cnrg
