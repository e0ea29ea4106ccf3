// FLAC3D's grid in text: gridpoints, zones and faces, and their groups, in as few slots as can be: a zone is in
// one group of a slot. The format has neither bars nor points.
#include <algorithm>

#include "csg/formats/formats.h"
#include "csg/formats/group_names.h"
#include "csg/mesh/mesh.h"
#include "csg/text/digits.h"
#include "csg/text/escape.h"

namespace cnrg {
namespace {

using Index = Mesh::Index;

std::string quotable(std::string_view name) { return cut(shown_in_quotes(name), 120); }

/// The simplices of one dimension, and their groups.
class Flac3dSection {
 public:
  Flac3dSection(const Mesh& mesh, std::size_t dimension, std::string& text)
      : mesh_(mesh), d_(dimension), text_(text) {
    groups_.resize(mesh.groups[dimension].size());
  }
  template <class Simplices>
  void add(const char* kind, const Simplices& simplices) {
    for (const auto& s : simplices) {
      Line line(text_);
      line << kind << ' ' << ++count_;
      for (const Index p : s.points) line << ' ' << p + 1;
      line << '\n';
      for (const Index group : mesh_.entities[d_][s.entity].groups) groups_[group - 1].push_back(count_);
    }
  }
  void add_groups(const char* word, const std::vector<std::string>& names) {
    std::vector<std::vector<char>> slots;  // by element: in a group of the slot
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      if (groups_[g].empty()) continue;
      const auto slot = std::ranges::find_if(slots, [&](const std::vector<char>& taken) {
        return std::ranges::none_of(groups_[g], [&](std::size_t i) { return taken[i] != 0; });
      });
      const auto number = std::size_t(slot - slots.begin());
      if (slot == slots.end()) slots.emplace_back(count_ + 1, 0);
      for (const std::size_t i : groups_[g]) slots[number][i] = 1;
      text_ += std::string(word) + " \"" + names[g] + "\" SLOT " + std::to_string(number + 1) + "\n";
      for (std::size_t i = 0; i < groups_[g].size(); ++i) {
        const bool ends = i % 12 == 11 || i + 1 == groups_[g].size();
        Line(text_) << groups_[g][i] << (ends ? '\n' : ' ');
      }
    }
  }

 private:
  const Mesh& mesh_;
  const std::size_t d_;
  std::string& text_;
  std::size_t count_ = 0;
  std::vector<std::vector<std::size_t>> groups_;
};

}  // namespace

std::string flac3d_text(const Mesh& mesh) {
  const auto names = distinct_names(mesh, {quotable, 120, " (", ")", true});
  std::string text = "* node " + cut(shown(mesh.node), 70) + ", written by cnrg\n* GRIDPOINTS\n";
  append_lines(text, mesh.points.size(), [&](std::string& out, std::size_t p) {
    Line(out) << "G " << p + 1 << ' ' << mesh.points[p] << '\n';
  });
  text += "* ZONES\n";
  Flac3dSection zones(mesh, 3, text);
  zones.add("Z T4", mesh.tetrahedra);
  text += "* ZONE GROUPS\n";
  zones.add_groups("ZGROUP", names[3]);
  text += "* FACES\n";
  Flac3dSection faces(mesh, 2, text);
  faces.add("F T3", mesh.triangles);
  faces.add("F Q4", mesh.quads);
  text += "* FACE GROUPS\n";
  faces.add_groups("FGROUP", names[2]);
  return text;
}

}  // namespace cnrg
