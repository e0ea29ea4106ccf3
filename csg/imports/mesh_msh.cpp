// Gmsh's format in text (.msh), versions 2.2 and 4.1: of a mesh the points, lines and flat elements of first
// order.
//
// Lines along faces and points on lines or faces say which edges and vertices Gmsh had, and a mesh finds these by
// itself: only others are wires and points. Tetrahedra and other elements with volume are left out, since the
// faces of their regions are elements, too. Faces are grouped by the first physical group of their surface.
#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>

#include "csg/imports/mesh_file.h"
#include "csg/imports/mesh_labels.h"
#include "csg/imports/text_cursor.h"

namespace cnrg {
namespace {

class MshReader {
 public:
  MshReader(const std::string& path, const std::string& text, bool decimal)
      : cursor_(path, text, 0), decimal_(decimal) {}

  MeshData read() {
    while (cursor_.more()) read_section(std::string(cursor_.token("a section")));
    if (version_ == 0) cursor_.fail("the file has no section $MeshFormat: it is no file of Gmsh");
    return collect();
  }

 private:
  using Pair = std::array<std::uint32_t, 2>;
  TextCursor cursor_;
  bool decimal_;
  int version_ = 0;                                                // 2 or 4
  std::unordered_map<long long, std::uint32_t> points_;            // by their numbers in the file
  std::map<std::pair<long long, long long>, long long> physical_;  // by dimension and number of an entity
  MeshLabels labels_;
  MeshData mesh_;

  void read_section(const std::string& name) {
    if (name != "$MeshFormat" && version_ == 0 && name != "$Comments")
      cursor_.fail(in_quotes(name) + " is no beginning of a file of Gmsh, which is $MeshFormat");
    cursor_.next_line();
    if (name == "$MeshFormat") read_format();
    if (name == "$Entities") read_entities();
    if (name == "$Nodes") read_nodes();
    if (name == "$Elements") read_elements();
    const std::string end = "$End" + name.substr(1);
    for (;;) {
      if (!cursor_.more()) cursor_.fail_at_end("the file ends before " + end + ": it is truncated");
      if (cursor_.token_in_line() == end) break;
      cursor_.next_line();
    }
  }

  void read_format() {
    const std::string version(cursor_.token("the version"));
    if (version != "2.2" && version != "4.1")
      cursor_.fail("the version " + in_quotes(version) +
                   " is not read: write version 4.1 or 2.2 (Gmsh: -format msh41)");
    version_ = version == "2.2" ? 2 : 4;
    if (cursor_.integer("0 for text") != 0) cursor_.fail("binary files are not read: write text");
    cursor_.next_line();
  }

  long long count(const char* what) {
    const long long n = cursor_.integer(what);
    if (n < 0) cursor_.fail(std::string(what) + " is negative: correct it");
    return n;
  }

  void read_entities() {
    std::array<long long, 4> counts{};
    for (long long& n : counts) n = count("a number of entities");
    for (long long dimension = 0; dimension < 4; ++dimension) {
      for (long long i = 0; i < counts[std::size_t(dimension)]; ++i) {
        const long long tag = cursor_.integer("the number of an entity");
        for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) cursor_.number("a coordinate");
        if (count("the number of physical groups") > 0)
          physical_[{dimension, tag}] = cursor_.integer("a physical group");
        cursor_.next_line();
      }
    }
  }

  void add_point(long long number) {
    if (!points_.emplace(number, place32(mesh_.point_count(), "points")).second)
      cursor_.fail("the node " + std::to_string(number) + " is there twice: remove one");
  }

  void read_nodes() {
    if (version_ == 2) {
      for (long long left = count("the number of nodes"); left > 0; --left) {
        add_point(cursor_.integer("the number of a node"));
        read_place();
      }
      return;
    }
    const long long blocks = count("the number of blocks");
    cursor_.next_line();
    for (long long i = 0; i < blocks; ++i) {
      for (const char* const what : {"a dimension", "an entity", "0 or 1"}) cursor_.integer(what);
      const long long n = count("the number of nodes");
      std::vector<long long> numbers;
      for (long long k = 0; k < n; ++k) numbers.push_back(cursor_.integer("the number of a node"));
      for (const long long number : numbers) {
        add_point(number);
        read_place();
      }
    }
  }
  void read_place() {
    cursor_.coordinates(mesh_, decimal_);
    cursor_.next_line();  // with parameters, where a program wrote some
  }

  void read_elements() {
    const long long n = count(version_ == 2 ? "the number of elements" : "the number of blocks");
    cursor_.next_line();
    for (long long i = 0; i < n; ++i) {
      if (version_ == 2) {
        cursor_.integer("the number of an element");
        const long long type = cursor_.integer("the type of an element");
        const long long tags = count("the number of tags");
        long long group = 0;
        for (long long k = 0; k < tags; ++k) {
          const long long tag = cursor_.integer("a tag");
          if (k == 0) group = tag;
        }
        read_element(type, group);
        continue;
      }
      const long long dimension = cursor_.integer("a dimension"), entity = cursor_.integer("an entity"),
                      type = cursor_.integer("the type of elements"), elements = count("the number of elements");
      const auto found = physical_.find({dimension, entity});
      for (long long k = 0; k < elements; ++k) {
        cursor_.integer("the number of an element");
        read_element(type, found == physical_.end() ? 0 : found->second);
      }
    }
  }

  void read_element(long long type, long long group) {
    constexpr std::pair<long long, std::size_t> kCorners[] = {{15, 1}, {1, 2}, {2, 3}, {3, 4}};
    constexpr long long kCurved[] = {8, 9, 10, 16};
    if (std::ranges::find(kCurved, type) != std::end(kCurved))
      cursor_.fail("elements of second order are not read: write the mesh with elements of first order");
    const auto kind = std::ranges::find(kCorners, type, [](const auto& k) { return k.first; });
    if (kind == std::end(kCorners)) return cursor_.next_line();
    std::vector<std::uint32_t> corners;
    for (std::size_t k = 0; k < kind->second; ++k) {
      const long long number = cursor_.integer("the number of a node");
      const auto found = points_.find(number);
      if (found == points_.end())
        cursor_.fail("there is no node " + std::to_string(number) + ": correct the element");
      corners.push_back(found->second);
    }
    cursor_.next_line();
    if (corners.size() == 1) mesh_.points.push_back(corners[0]);
    if (corners.size() == 2) mesh_.wires.push_back({corners[0], corners[1]});
    if (corners.size() < 3) return;
    mesh_.corners.insert(mesh_.corners.end(), corners.begin(), corners.end());
    mesh_.end_face();
    mesh_.groups.push_back(labels_.group(std::int64_t{group}));
  }

  MeshData collect() {
    std::set<Pair> sides;
    std::vector<char> used(mesh_.point_count(), 0);
    for (std::size_t f = 0; f < mesh_.face_count(); ++f) {
      for (std::size_t i = mesh_.offsets[f]; i < mesh_.offsets[f + 1]; ++i) {
        const std::size_t next = i + 1 < mesh_.offsets[f + 1] ? i + 1 : mesh_.offsets[f];
        const auto [a, b] = std::minmax(mesh_.corners[i], mesh_.corners[next]);
        sides.insert({a, b});
        used[a] = used[b] = 1;
      }
    }
    std::erase_if(mesh_.wires, [&](const Pair& w) {
      return sides.contains({std::min(w[0], w[1]), std::max(w[0], w[1])});
    });
    for (const Pair& w : mesh_.wires) used[w[0]] = used[w[1]] = 1;
    std::erase_if(mesh_.points, [&](std::uint32_t p) { return used[p] != 0; });
    if (labels_.size() < 2) mesh_.groups.clear();
    return std::move(mesh_);
  }
};

}  // namespace

MeshData read_msh(const std::string& path, const std::string& text, bool decimal) {
  return MshReader(path, text, decimal).read();
}

}  // namespace cnrg
