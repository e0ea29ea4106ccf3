// Wavefront OBJ: v, f, l, p, and the groups of g and usemtl. Normals, textures, smoothing, materials are skipped.
#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <string_view>

#include "csg/imports/text_cursor.h"

namespace cnrg {
namespace {

class ObjReader {
 public:
  ObjReader(const std::string& path, const std::string& text, bool decimal)
      : cursor_(path, text, '#'), decimal_(decimal) {}

  MeshData read() {
    while (cursor_.more()) {
      const std::string_view word = cursor_.token_in_line();
      if (word == "v") {
        read_vertex();
      } else if (word == "f") {
        read_indices(corner_list_);
        if (corner_list_.size() < 3) {
          cursor_.fail("a face with " + std::to_string(corner_list_.size()) +
                       " corners: give at least 3, or a line (l)");
        }
        mesh_.corners.insert(mesh_.corners.end(), corner_list_.begin(), corner_list_.end());
        mesh_.end_face();
        mesh_.groups.push_back(group_number());
      } else if (word == "l") {
        read_indices(corner_list_);
        if (corner_list_.size() < 2) cursor_.fail("a line with fewer than 2 points: give 2, or a point (p)");
        for (std::size_t i = 1; i < corner_list_.size(); ++i)
          mesh_.wires.push_back({corner_list_[i - 1], corner_list_[i]});
      } else if (word == "p") {
        read_indices(corner_list_);
        mesh_.points.insert(mesh_.points.end(), corner_list_.begin(), corner_list_.end());
      } else if (word == "g" || word == "usemtl") {
        std::string& name = word == "g" ? group_ : material_;
        name.clear();
        number_.reset();
        for (std::string_view token = cursor_.token_in_line(); !token.empty(); token = cursor_.token_in_line()) {
          name.append(token).append(" ");
        }
      } else if (word == "curv" || word == "curv2" || word == "surf") {
        cursor_.fail("free-form geometry (" + std::string(word) + ") is not read: export the mesh as polygons");
      }
      skip_line();
    }
    check_forward();
    if (numbers_.size() < 2) mesh_.groups.clear();
    return std::move(mesh_);
  }

 private:
  /// A line may go on after a backslash at its end.
  void skip_line() {
    bool goes_on = true;
    while (goes_on) {
      goes_on = false;
      for (std::string_view t = cursor_.token_in_line(); !t.empty(); t = cursor_.token_in_line())
        goes_on = t == "\\";
      cursor_.next_line();
    }
  }

  std::string_view next_token() {
    std::string_view token = cursor_.token_in_line();
    while (token == "\\") {
      cursor_.next_line();
      token = cursor_.token_in_line();
    }
    return token;
  }

  void read_vertex() {
    if (cursor_.tokens_left(3) < 3) cursor_.fail("a vertex with fewer than 3 coordinates: give x, y and z");
    cursor_.coordinates(mesh_, decimal_);
  }

  /// The vertex indices of the rest of the line: `7`, `7/1`, `7//3`, `7/1/3`; negative ones count back from the
  /// last vertex so far.
  void read_indices(std::vector<std::uint32_t>& list) {
    list.clear();
    for (std::string_view token = next_token(); !token.empty(); token = next_token()) {
      long long index = 0;
      const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), index);
      if (error != std::errc() || (end != token.data() + token.size() && *end != '/')) {
        cursor_.fail(in_quotes(token) + " is no vertex index, such as 7, 7/1 or 7/1/3: correct it");
      }
      const long long known = static_cast<long long>(mesh_.point_count());
      const long long absolute = index < 0 ? known + index : index - 1;
      if (index == 0) cursor_.fail("the vertex index 0, but they count from 1 (or from -1 backwards): correct it");
      if (absolute < 0) {
        cursor_.fail("the vertex index " + std::to_string(index) + ", but only " + std::to_string(known) +
                     " vertices came before: correct it");
      }
      if (absolute >= known && absolute > highest_) {
        highest_ = absolute;
        highest_line_ = cursor_.line();
      }
      list.push_back(static_cast<std::uint32_t>(std::min<long long>(absolute, 0xfffffffe)));
    }
  }

  /// Indices may name vertices that come later in the file, but they must come.
  void check_forward() const {
    if (highest_ < static_cast<long long>(mesh_.point_count())) return;
    cursor_.fail_at(highest_line_, "the vertex index " + std::to_string(highest_ + 1) + ", but the file has " +
                                       std::to_string(mesh_.point_count()) +
                                       " vertices, numbered from 1: correct it, or the file is truncated");
  }

  std::uint32_t group_number() {
    if (!number_)
      number_ =
          numbers_.try_emplace({group_, material_}, static_cast<std::uint32_t>(numbers_.size())).first->second;
    return *number_;
  }

  TextCursor cursor_;
  bool decimal_;
  MeshData mesh_;
  std::vector<std::uint32_t> corner_list_;
  std::string group_, material_;
  std::map<std::pair<std::string, std::string>, std::uint32_t> numbers_;
  std::optional<std::uint32_t> number_;  // of the group and material of now
  long long highest_ = -1;
  int highest_line_ = 0;
};

}  // namespace

MeshData read_obj(const std::string& path, const std::string& text, bool decimal) {
  return ObjReader(path, text, decimal).read();
}

}  // namespace cnrg
