// Labels of faces: files that have no groups by themselves may have a number for each face, and faces with one
// number are a group. Only numbers that are called so count: a file may as well have an area, a quality or a
// number of its own for each face.
#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <string_view>
#include <variant>

namespace cnrg {

/// Groups of faces by their labels, numbered from 0 in the order in which labels come up.
class MeshLabels {
 public:
  static bool is_label(std::string_view name) {
    for (const std::string_view label : {"label", "group", "patch", "face_label", "face_type", "material_index"}) {
      if (name == label) return true;
    }
    return false;
  }

  std::uint32_t group(double label) { return number(std::isnan(label) ? 0.0 : label); }
  std::uint32_t group(std::int64_t label) { return number(label); }
  std::uint32_t group_without_label() { return number(std::monostate()); }
  std::size_t size() const { return groups_.size(); }

 private:
  using Label = std::variant<std::monostate, double, std::int64_t>;
  std::map<Label, std::uint32_t> groups_;

  std::uint32_t number(Label label) {
    return groups_.try_emplace(label, static_cast<std::uint32_t>(groups_.size())).first->second;
  }
};

}  // namespace cnrg
