// MOAB's layout in HDF5, as DAGMC reads it: volumes, surfaces with what lies on both sides, and groups.
//
// All is numbered through, from 1: points, edges, triangles, tetrahedra, sets. A set for each face that bounds a
// region has its triangles, and by the tag GEOM_SENSE_2 the volume behind it (triangles are counter-clockwise as
// seen from the front, so they are its outward side) and the one in front. A set for each region has its surfaces
// as children, and its tetrahedra where there are any. A particle that crosses a surface knows so what it enters,
// without a search; solids with a surface each would leave gaps and overlaps there.
//
// Groups of DAGMC are sets with a name, `mat:granite` for a material, `boundary:vacuum` or `temp:300` for what an
// attribute says of regions and faces. All groups of the mesh are such sets, too. Sheets, wires and points bound
// nothing: their elements are in groups alone.
#include <array>
#include <map>

#include "csg/formats/formats.h"
#include "csg/formats/group_names.h"
#include "csg/formats/hdf5_file.h"
#include "csg/materials/attributes.h"
#include "csg/text/escape.h"
#include "kernel/base/error.h"
#include "kernel/base/sorted.h"
#include "kernel/exact/rational.h"

namespace cnrg {
namespace {

using Index = Mesh::Index;
using EntityHandle = std::uint64_t;
using Kind = Hdf5File::Kind;

constexpr std::size_t kNameSize = 32;
constexpr Hdf5File::Type kPair{Hdf5File::Kind::u64, 2};

std::string without_words_of_dagmc(std::string_view name) {
  std::string result = shown(name);
  for (char& c : result) {
    if (c == ':' || c == '/') c = '_';
  }
  return result;
}

/// `KEY:VALUE`, which DAGMC splits there.
std::string group_name(const std::string& key, const std::string& value) {
  std::string name = shown(key) + ":" + shown(value);
  if (name.size() < kNameSize) return name;
  throw InputError("H5M has 31 bytes for the name of a group, and `" + name + "` is longer; use a shorter name");
}

class H5mWriter {
 public:
  explicit H5mWriter(const Mesh& mesh) : mesh_(mesh) {}

  std::string run() {
    number_all();
    find_surfaces();
    find_groups();
    add_elements();
    add_sets();
    return file_->bytes();
  }

 private:
  struct Surface {
    Index first = 0, end = 0;              ///< of its triangles
    std::array<EntityHandle, 2> senses{};  ///< the volume behind, and the one in front; 0: none
    const Mesh::Entity* face = nullptr;
  };
  const Mesh& mesh_;
  const std::unique_ptr<Hdf5File> file_ = new_hdf5_file();
  EntityHandle first_edge_ = 0, first_triangle_ = 0, first_tetrahedron_ = 0, first_set_ = 0, end_ = 0;
  std::vector<Surface> surfaces_;
  std::vector<std::pair<std::string, std::vector<EntityHandle>>> groups_;
  std::map<std::string, std::size_t> group_at_;

  void number_all() {
    first_edge_ = 1 + mesh_.points.size();
    first_triangle_ = first_edge_ + mesh_.segments.size();
    first_tetrahedron_ = first_triangle_ + mesh_.triangles.size();
    first_set_ = first_tetrahedron_ + mesh_.tetrahedra.size();
  }
  /// Surfaces come first among sets, then volumes.
  EntityHandle volume(Index region) const { return first_set_ + surfaces_.size() + region; }

  /// The facets of one face are one surface. A face without a region on just one of its sides, or with two
  /// different ones, parts nothing.
  void find_surfaces() {
    std::vector<std::array<Index, 2>> sides(mesh_.entities[2].size(), {0, 0});  // region + 1: behind, in front
    for (Index r = 0; r < mesh_.entities[3].size(); ++r) {
      for (const std::int32_t side : mesh_.entities[3][r].boundary)
        sides[static_cast<std::size_t>(std::abs(side)) - 1][side < 0 ? 1 : 0] = r + 1;
    }
    std::vector<std::array<Index, 2>> of;
    for (Index begin = 0, end = 0; begin < mesh_.triangles.size(); begin = end) {
      const Index entity = mesh_.triangles[begin].entity;
      while (end < mesh_.triangles.size() && mesh_.triangles[end].entity == entity) ++end;
      const Mesh::Entity& face = mesh_.entities[2][entity];
      if (face.tags.bounded <= 0) continue;
      if (!surfaces_.empty() && surfaces_.back().end == begin &&
          surfaces_.back().face->tags.cell == face.tags.cell) {
        surfaces_.back().end = end;
      } else {
        surfaces_.push_back({begin, end, {}, &face});
        of.push_back(sides[entity]);
      }
    }
    for (std::size_t s = 0; s < surfaces_.size(); ++s) {
      for (std::size_t k = 0; k < 2; ++k) {
        if (of[s][k] != 0) surfaces_[s].senses[k] = volume(of[s][k] - 1);
      }
    }
  }

  void add_to_group(const std::string& name, EntityHandle member) {
    const auto [entry, fresh] = group_at_.try_emplace(name, groups_.size());
    if (fresh) groups_.push_back({name, {}});
    groups_[entry->second].second.push_back(member);
  }
  void add_what_is_said(const Mesh::Entity& entity, EntityHandle set) {
    if (entity.tags.said == nullptr) return;
    if (!entity.tags.said->material.empty())
      add_to_group(group_name("mat", entity.tags.said->material.name()), set);
    for (const auto& [key, value] : entity.tags.said->properties) {
      const auto* number = std::get_if<Rational>(&value);
      add_to_group(group_name(key, number != nullptr ? to_decimal(*number) : std::get<std::string>(value)), set);
    }
  }

  void find_groups() {
    for (Index r = 0; r < mesh_.entities[3].size(); ++r) add_what_is_said(mesh_.entities[3][r], volume(r));
    for (std::size_t s = 0; s < surfaces_.size(); ++s) add_what_is_said(*surfaces_[s].face, first_set_ + s);
    const auto names = distinct_names(mesh_, {without_words_of_dagmc, kNameSize - 1});
    std::array<std::vector<std::vector<EntityHandle>>, 4> members;
    for (std::size_t d = 0; d < 4; ++d) members[d].resize(names[d].size());
    const auto add = [&](std::size_t d, const Mesh::Entity& entity, EntityHandle member) {
      for (const Index group : entity.groups) members[d][group - 1].push_back(member);
    };
    for (Index r = 0; r < mesh_.entities[3].size(); ++r) add(3, mesh_.entities[3][r], volume(r));
    for (std::size_t s = 0; s < surfaces_.size(); ++s) add(2, *surfaces_[s].face, first_set_ + s);
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
      const Mesh::Entity& face = mesh_.entities[2][mesh_.triangles[i].entity];
      if (face.tags.bounded <= 0) add(2, face, first_triangle_ + i);
    }
    for (std::size_t i = 0; i < mesh_.segments.size(); ++i)
      add(1, mesh_.entities[1][mesh_.segments[i].entity], first_edge_ + i);
    for (const auto& v : mesh_.vertices) add(0, mesh_.entities[0][v.entity], v.points[0] + 1);
    for (std::size_t d = 4; d-- > 0;) {
      for (std::size_t g = 0; g < names[d].size(); ++g) {
        if (!members[d][g].empty()) groups_.push_back({names[d][g], std::move(members[d][g])});
      }
    }
    end_ = first_set_ + surfaces_.size() + mesh_.entities[3].size() + groups_.size();
  }

  template <class Simplices>
  void add_simplices(const std::string& kind, int type, EntityHandle first, const Simplices& simplices) {
    if (simplices.empty()) return;
    std::vector<EntityHandle> points;
    for (const auto& s : simplices) {
      for (const Index p : s.points) points.push_back(p + 1);
    }
    const std::string path = "tstt/elements/" + kind;
    file_->add(path + "/connectivity", points, {simplices.size(), points.size() / simplices.size()});
    file_->set(path + "/connectivity", "start_id", Kind::i64, static_cast<std::int64_t>(first));
    file_->set_of_type(path, "element_type", "tstt/elemtypes", type);
  }

  void add_elements() {
    file_->add_group("tstt/elements");
    file_->set("tstt", "max_id", Hdf5File::Kind::u64, static_cast<std::int64_t>(end_ - 1));
    file_->add_enumeration("tstt/elemtypes", {"Edge", "Tri", "Quad", "Polygon", "Tet", "Pyramid", "Prism", "Knife",
                                              "Hex", "Polyhedron"});
    std::vector<double> coordinates;
    for (const auto& p : mesh_.points) coordinates.insert(coordinates.end(), p.begin(), p.end());
    file_->add("tstt/nodes/coordinates", coordinates, {mesh_.points.size(), 3});
    file_->set("tstt/nodes/coordinates", "start_id", Kind::i64, 1);
    add_simplices("Edge2", 1, first_edge_, mesh_.segments);
    add_simplices("Tri3", 2, first_triangle_, mesh_.triangles);
    add_simplices("Tet4", 5, first_tetrahedron_, mesh_.tetrahedra);
  }

  // Lists of all sets one after the other; a row of a set says where its parts end, inclusive.
  std::vector<EntityHandle> contents_, children_, parents_;
  std::vector<std::int64_t> rows_;
  void end_set() {
    constexpr std::int64_t kUnordered = 2;
    for (const auto* list : {&contents_, &children_, &parents_})
      rows_.push_back(static_cast<std::int64_t>(list->size()) - 1);
    rows_.push_back(kUnordered);
  }

  void add_sets() {
    std::vector<std::vector<EntityHandle>> children(mesh_.entities[3].size());
    for (std::size_t s = 0; s < surfaces_.size(); ++s) {
      const Surface& surface = surfaces_[s];
      std::vector<EntityHandle> points;
      for (Index t = surface.first; t < surface.end; ++t) {
        for (const Index p : mesh_.triangles[t].points) points.push_back(p + 1);
      }
      sort_unique(points);
      contents_.insert(contents_.end(), points.begin(), points.end());
      for (Index t = surface.first; t < surface.end; ++t) contents_.push_back(first_triangle_ + t);
      for (const EntityHandle sense : surface.senses) {
        if (sense == 0) continue;
        parents_.push_back(sense);
        children[sense - volume(0)].push_back(first_set_ + s);
      }
      end_set();
    }
    std::size_t t = 0;
    for (Index r = 0; r < children.size(); ++r) {
      for (; t < mesh_.tetrahedra.size() && mesh_.tetrahedra[t].entity == r; ++t)
        contents_.push_back(first_tetrahedron_ + t);
      children_.insert(children_.end(), children[r].begin(), children[r].end());
      end_set();
    }
    for (const auto& [name, members] : groups_) {
      contents_.insert(contents_.end(), members.begin(), members.end());
      end_set();
    }
    const std::size_t count = rows_.size() / 4;
    if (count == 0) return;
    file_->add("tstt/sets/list", rows_, {count, 4});
    file_->set("tstt/sets/list", "start_id", Kind::i64, static_cast<std::int64_t>(first_set_));
    file_->add("tstt/sets/contents", contents_);
    if (!children_.empty()) {
      file_->add("tstt/sets/children", children_);
      file_->add("tstt/sets/parents", parents_);
    }
    add_tags(count);
  }

  /// A tag of some sets is stored with their numbers (class 1, sparse), one of all with these (2, dense).
  void begin_tag(const std::string& path, int kind) { file_->set(path, "class", Kind::i32, kind); }

  void add_tags(std::size_t count) {
    std::vector<EntityHandle> ids;
    std::vector<std::string> categories, names;
    std::vector<std::int32_t> dimensions, numbers;
    const std::array<std::size_t, 3> counts{surfaces_.size(), mesh_.entities[3].size(), groups_.size()};
    static constexpr const char* kCategories[] = {"Surface", "Volume", "Group"};
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < counts[k]; ++i) {
        ids.push_back(first_set_ + ids.size());
        categories.emplace_back(kCategories[k]);
        dimensions.push_back(static_cast<std::int32_t>(k) + 2);
        numbers.push_back(static_cast<std::int32_t>(i) + 1);
      }
    }
    file_->add("tstt/tags/CATEGORY/id_list", ids);
    file_->add("tstt/tags/CATEGORY/values", categories, {Kind::opaque, kNameSize});
    file_->add_type("tstt/tags/CATEGORY/type", {Kind::opaque, kNameSize});
    begin_tag("tstt/tags/CATEGORY", 1);
    file_->add("tstt/tags/GEOM_DIMENSION/id_list", ids);
    file_->add("tstt/tags/GEOM_DIMENSION/values", dimensions);
    file_->add_type("tstt/tags/GEOM_DIMENSION/type", {Kind::i32});
    begin_tag("tstt/tags/GEOM_DIMENSION", 1);
    file_->set("tstt/tags/GEOM_DIMENSION", "default", Kind::i32, -1);
    file_->set("tstt/tags/GEOM_DIMENSION", "global", Kind::i32, -1);
    file_->add_type("tstt/tags/GLOBAL_ID/type", {Kind::i32});
    begin_tag("tstt/tags/GLOBAL_ID", 2);
    file_->set("tstt/tags/GLOBAL_ID", "default", Kind::i32, 0);
    file_->set("tstt/tags/GLOBAL_ID", "global", Kind::i32, 0);
    file_->add("tstt/sets/tags/GLOBAL_ID", numbers);
    if (!surfaces_.empty()) {
      std::vector<EntityHandle> senses;
      for (const Surface& s : surfaces_) senses.insert(senses.end(), s.senses.begin(), s.senses.end());
      const auto end = ids.begin() + static_cast<std::ptrdiff_t>(surfaces_.size());
      file_->add("tstt/tags/GEOM_SENSE_2/id_list", std::vector<EntityHandle>(ids.begin(), end));
      file_->add("tstt/tags/GEOM_SENSE_2/values", kPair, {surfaces_.size()}, senses.data());
      file_->add_type("tstt/tags/GEOM_SENSE_2/type", kPair);
      begin_tag("tstt/tags/GEOM_SENSE_2", 1);
      file_->set("tstt/tags/GEOM_SENSE_2", "is_handle", Kind::i32, 1);
      file_->set("tstt/tags/GEOM_SENSE_2", "default", kPair, std::array<EntityHandle, 2>{}.data());
    }
    if (!groups_.empty()) {
      for (const auto& [name, members] : groups_) names.push_back(name);
      const auto begin = ids.begin() + static_cast<std::ptrdiff_t>(count - groups_.size());
      file_->add("tstt/tags/NAME/id_list", std::vector<EntityHandle>(begin, ids.end()));
      file_->add("tstt/tags/NAME/values", names, {Kind::opaque, kNameSize});
      file_->add_type("tstt/tags/NAME/type", {Kind::opaque, kNameSize});
      begin_tag("tstt/tags/NAME", 1);
    }
  }
};

}  // namespace

std::string h5m_bytes(const Mesh& mesh) {
  return hdf5_bytes("H5M", [&] { return H5mWriter(mesh).run(); });
}

}  // namespace cnrg
