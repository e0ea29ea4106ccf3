// Corners of tetrahedra are joined twice: through all sides, which gives the stars of nodes, and through those
// that are not split, which gives their sectors. The first sector of a star keeps the node.
#include "csg/mesh/split.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "csg/mesh/second_order.h"
#include "csg/mesh/straight_order.h"
#include "csg/text/escape.h"
#include "kernel/base/counts.h"
#include "kernel/base/error.h"
#include "kernel/base/limits.h"
#include "kernel/base/sorted.h"
#include "kernel/base/union_find.h"

namespace cnrg {
namespace {

using Index = Mesh::Index;
using Corners = std::array<Index, 3>;

/// A side of a tetrahedron that has a node of a face to split.
struct OwnSide {
  Corners corners;    ///< ascending
  Index tetrahedron;  ///< its place among those near such faces
  bool odd;           ///< seen from outside the corners are clockwise
  auto operator<=>(const OwnSide&) const = default;
};

/// A triangle to split, and the tetrahedra there.
struct PartedTriangle {
  Index triangle, back, front;
};

Index add_twin(Mesh& mesh, Index of) {
  const Index twin = next_number(mesh.points.size(), "points");
  mesh.points.push_back(mesh.points[of]);
  mesh.twins.push_back(mesh.twins[of]);
  return twin;
}

/// From 1.
Index group_of_faces(const std::vector<std::string>& groups, const std::string& name) {
  for (const char* const before : {"", "from "}) {
    const auto it = std::ranges::find(groups, before + shown_in_quotes(name));
    if (it != groups.end()) return Index(it - groups.begin()) + 1;
  }
  std::string all;  // those by leaves are the last ones
  for (auto it = groups.rbegin(); it != groups.rend() && all.size() < 300; ++it)
    all += (all.empty() ? " `" : ", `") + *it + "`";
  throw InputError("--split: neither a group of faces nor a leaf with faces is called `" + shown(name) +
                   "`; there are" + (all.empty() ? " none" : all));
}

/// The tetrahedra around triangles to split, and the node of each of their sectors.
class Sectors {
 public:
  /// `asked`: by entity of faces, whether it is to be split.
  Sectors(Mesh& mesh, const std::vector<char>& asked) : mesh_(mesh), asked_(asked) {
    find_sides();
    find_sectors();
    place_nodes();
  }
  /// Triangles between two tetrahedra, ascending.
  const std::vector<PartedTriangle>& parted() const { return parted_; }
  const std::vector<Index>& near() const { return near_; }
  bool is_marked(Index point) const { return marked_[point] != 0; }
  auto sides_at(const Corners& corners) const {
    return std::ranges::equal_range(sides_, sorted(corners), {}, &OwnSide::corners);
  }
  /// What points are in a tetrahedron, by its place in `near`, while it still has its old ones.
  template <std::size_t N>
  std::array<Index, N> nodes_at(Index tetrahedron, std::array<Index, N> points) {
    for (Index& p : points) {
      if (marked_[p]) p = node_[sectors_.find(corner(tetrahedron, p))];
    }
    return points;
  }

 private:
  Mesh& mesh_;
  const std::vector<char>& asked_;
  std::vector<char> marked_;    // points: of a triangle to split
  std::vector<Index> near_;     // tetrahedra with such points
  std::vector<OwnSide> sides_;  // ascending
  std::vector<PartedTriangle> parted_;
  UnionFind stars_, sectors_;  // of corners, four for each of `near_`
  std::vector<Index> node_;    // by the first corner of a sector

  void find_sides() {
    marked_.assign(mesh_.points.size(), 0);
    for (const auto& t : mesh_.triangles) {
      if (!asked_[t.entity]) continue;
      for (const Index p : t.points) marked_[p] = 1;
    }
    for (Index t = 0; t < mesh_.tetrahedra.size(); ++t) {
      const auto& points = mesh_.tetrahedra[t].points;
      if (std::ranges::none_of(points, [&](Index p) { return marked_[p] != 0; })) continue;
      const Index place = Index(near_.size());
      near_.push_back(t);
      for (const auto& [a, b, c] : kOutsides) {
        const Corners corners{points[a], points[b], points[c]};
        if (std::ranges::any_of(corners, [&](Index p) { return marked_[p] != 0; }))
          sides_.push_back({sorted(corners), place, is_odd(corners)});
      }
    }
    std::ranges::sort(sides_);
  }
  /// Of a place in `near_` and one of its points.
  Index corner(Index tetrahedron, Index point) const {
    const auto& points = mesh_.tetrahedra[near_[tetrahedron]].points;
    return 4 * tetrahedron + Index(std::find(points.begin(), points.end(), point) - points.begin());
  }
  void find_sectors() {
    std::vector<char> parts(sides_.size(), 0);
    for (Index i = 0; i < mesh_.triangles.size(); ++i) {
      if (!asked_[mesh_.triangles[i].entity]) continue;
      const auto at = sides_at(mesh_.triangles[i].points);
      if (at.size() != 2) continue;
      parts[std::size_t(at.begin() - sides_.begin())] = 1;
      // From outside of the tetrahedron behind it a triangle runs as it does from its front.
      const bool first_behind = at[0].odd == is_odd(mesh_.triangles[i].points);
      parted_.push_back({i, at[first_behind ? 0 : 1].tetrahedron, at[first_behind ? 1 : 0].tetrahedron});
    }
    stars_ = UnionFind(4 * near_.size());
    sectors_ = UnionFind(4 * near_.size());
    for (std::size_t i = 0; i + 1 < sides_.size(); ++i) {
      if (sides_[i].corners != sides_[i + 1].corners) continue;
      for (const Index p : sides_[i].corners) {
        const Index a = corner(sides_[i].tetrahedron, p), b = corner(sides_[i + 1].tetrahedron, p);
        stars_.unite(a, b);
        if (parts[i] == 0) sectors_.unite(a, b);
      }
    }
  }

  /// Sectors behind a triangle come first.
  void place_nodes() {
    mesh_.twins.resize(mesh_.points.size());
    std::iota(mesh_.twins.begin(), mesh_.twins.end(), 0U);
    node_.assign(4 * near_.size(), kNone);
    std::vector<char> kept(4 * near_.size(), 0);  // by the first corner of a star
    const auto place = [&](Index corner) {
      const Index p = mesh_.tetrahedra[near_[corner / 4]].points[corner % 4];
      Index& node = node_[sectors_.find(corner)];
      if (node != kNone || marked_[p] == 0) return;
      char& has = kept[stars_.find(corner)];
      node = has ? add_twin(mesh_, p) : p;
      has = 1;
    };
    for (const PartedTriangle& t : parted_) {
      for (const Index p : mesh_.triangles[t.triangle].points) place(corner(t.back, p));
    }
    for (Index c = 0; c < node_.size(); ++c) place(c);
  }
};

class Splitter {
 public:
  explicit Splitter(Mesh& mesh) : mesh_(mesh) {}

  SplitReport run(const std::vector<std::string>& names, bool interfaces) {
    const std::size_t before = mesh_.points.size();
    find_groups(names);
    std::vector<char> asked;
    for (Index face = 0; face < mesh_.entities[2].size(); ++face) asked.push_back(!asked_of(face).empty());
    Sectors sectors(mesh_, asked);
    require_parted(sectors);
    move_triangles(sectors);
    move_segments(sectors);
    add_groups(interfaces);
    add_fronts(sectors, interfaces);
    for (Index i = 0; i < sectors.near().size(); ++i) {
      auto& points = mesh_.tetrahedra[sectors.near()[i]].points;
      points = sectors.nodes_at(i, points);
    }
    part_middles();
    return {mesh_.points.size() - before, mesh_.wedges.size()};
  }

 private:
  Mesh& mesh_;
  std::vector<Index> asked_;  // groups of faces, from 1
  std::vector<std::string> asked_names_;
  std::map<Index, Index> front_;            // by a face behind: the one in front
  Index first_side_ = 0, first_joint_ = 0;  // of the groups that are added, in the order of `asked_`

  void find_groups(const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      const Index group = group_of_faces(mesh_.groups[2], name);
      if (std::ranges::find(asked_, group) != asked_.end()) continue;
      asked_.push_back(group);
      asked_names_.push_back(shown_in_quotes(name));
    }
  }
  /// Places in `asked_` of the groups of a face.
  std::vector<Index> asked_of(Index face) const {
    std::vector<Index> places;
    for (Index k = 0; k < asked_.size(); ++k)
      if (std::ranges::find(mesh_.entities[2][face].groups, asked_[k]) != mesh_.entities[2][face].groups.end())
        places.push_back(k);
    return places;
  }

  void require_parted(const Sectors& sectors) const {
    std::vector<char> parted(asked_.size(), 0);
    for (const PartedTriangle& t : sectors.parted())
      for (const Index k : asked_of(mesh_.triangles[t.triangle].entity)) parted[k] = 1;
    const auto whole = std::ranges::find(parted, 0);
    if (whole == parted.end()) return;
    throw InputError("--split: no face of `" + asked_names_[std::size_t(whole - parted.begin())] +
                     "` lies between tetrahedra, so that nothing is parted there; leave it out");
  }

  void move_triangles(Sectors& sectors) {
    auto next = sectors.parted().begin();
    for (Index i = 0; i < mesh_.triangles.size(); ++i) {
      if (next != sectors.parted().end() && next->triangle == i) {
        ++next;
        continue;
      }
      auto& points = mesh_.triangles[i].points;
      const auto at = sectors.sides_at(points);
      if (!at.empty()) points = sectors.nodes_at(at[0].tetrahedron, points);
    }
  }
  void move_segments(Sectors& sectors) {
    std::map<std::uint64_t, Index> tetrahedron;  // by edge
    for (const auto& s : mesh_.segments) {
      if (sectors.is_marked(s.points[0]) || sectors.is_marked(s.points[1]))
        tetrahedron[edge_key(s.points[0], s.points[1])] = kNone;
    }
    const auto claim = [&](Index place, const auto& points, const auto& edges) {
      for (const auto& [a, b] : edges) {
        const auto it = tetrahedron.find(edge_key(points[a], points[b]));
        if (it != tetrahedron.end() && it->second == kNone) it->second = place;
      }
    };
    for (const PartedTriangle& t : sectors.parted())
      claim(t.back, mesh_.triangles[t.triangle].points, kSecondOrderTriangle);
    for (Index i = 0; i < sectors.near().size(); ++i)
      claim(i, mesh_.tetrahedra[sectors.near()[i]].points, kSecondOrderEdges);
    for (auto& s : mesh_.segments) {
      const auto it = tetrahedron.find(edge_key(s.points[0], s.points[1]));
      if (it != tetrahedron.end() && it->second != kNone) s.points = sectors.nodes_at(it->second, s.points);
    }
  }

  /// Before the groups by leaves, whose numbers grow.
  void add_groups(bool interfaces) {
    std::vector<std::string>& names = mesh_.groups[2];
    const auto named = Index(names.size() - mesh_.sources), more = Index(2 * asked_.size());
    std::vector<std::string> added;
    for (const std::string& name : asked_names_) {
      for (const char* const side : {"back of ", "front of "}) added.push_back(unused_name(2, side + name));
    }
    names.insert(names.begin() + named, added.begin(), added.end());
    for (Mesh::Entity& face : mesh_.entities[2]) {
      for (Index& g : face.groups) g += g > named ? more : 0;
    }
    for (Index& g : asked_) g += g > named ? more : 0;
    first_side_ = named + 1;
    first_joint_ = Index(mesh_.groups[3].size()) + 1;
    for (const std::string& name : asked_names_)
      if (interfaces) mesh_.groups[3].push_back(unused_name(3, "interface " + name));
  }
  std::string unused_name(std::size_t dimension, std::string name) const {
    const std::vector<std::string>& known = mesh_.groups[dimension];
    while (std::ranges::find(known, name) != known.end()) name += "'";
    return name;
  }

  /// The entity in front of a face, made when it is first asked for.
  Index front_of(Index face, Index back_region, Index front_region) {
    const auto [it, fresh] = front_.try_emplace(face, Index(mesh_.entities[2].size()));
    if (!fresh) return it->second;
    Mesh::Entity front = mesh_.entities[2][face];
    const std::vector<Index> asked = asked_of(face);
    for (const Index side : {0U, 1U}) {
      Mesh::Entity& of = side == 0 ? mesh_.entities[2][face] : front;
      of.side = true;
      std::vector<Index> groups(of.groups.begin(), of.groups.end());
      for (const Index k : asked) groups.insert(groups.begin(), first_side_ + 2 * k + side);
      of.groups = {groups.begin(), groups.end()};
    }
    mesh_.entities[2].push_back(std::move(front));
    for (Mesh::Property& property : mesh_.properties) property.values[2].push_back(property.values[2][face]);
    const auto behind = std::int32_t(face + 1), before = std::int32_t(it->second + 1);
    for (const Index region : {back_region, front_region}) {
      auto& list = mesh_.entities[3][region].boundary;
      list = {list.begin(),
              std::remove_if(list.begin(), list.end(), [&](std::int32_t b) { return std::abs(b) == behind; })};
    }
    mesh_.entities[3][back_region].boundary.push_back(behind);
    mesh_.entities[3][front_region].boundary.push_back(-before);
    return it->second;
  }
  void add_fronts(Sectors& sectors, bool interfaces) {
    std::map<Index, Index> joints;  // by a face behind: the entity of its wedges
    const auto region = [&](Index place) { return mesh_.tetrahedra[sectors.near()[place]].entity; };
    for (const PartedTriangle& at : sectors.parted()) {
      const Corners points = mesh_.triangles[at.triangle].points;
      const Corners back_points = sectors.nodes_at(at.back, points),
                    front_points = sectors.nodes_at(at.front, points);
      mesh_.triangles[at.triangle].points = back_points;
      if (back_points == front_points) continue;
      const Index face = mesh_.triangles[at.triangle].entity,
                  front = front_of(face, region(at.back), region(at.front));
      mesh_.triangles.push_back({front_points, front});
      if (!interfaces) continue;
      const auto [joint, fresh] = joints.try_emplace(face, Index(mesh_.entities[3].size()));
      if (fresh) add_joint(face, front);
      const auto& [a, b, c] = back_points;
      mesh_.wedges.push_back({{a, b, c, front_points[0], front_points[1], front_points[2]}, joint->second});
    }
  }
  void add_joint(Index face, Index front) {
    Mesh::Entity joint;
    joint.tags = mesh_.entities[2][face].tags;
    joint.boundary = {-std::int32_t(face + 1), std::int32_t(front + 1)};
    for (const Index k : asked_of(face)) joint.groups.push_back(first_joint_ + k);
    mesh_.entities[3].push_back(std::move(joint));
    for (Mesh::Property& property : mesh_.properties) property.values[3].push_back(property.values[2][face]);
  }

  void part_middles() {
    if (mesh_.middles.empty()) return;
    const auto old = std::exchange(mesh_.middles, {});  // by ends that were not split yet
    std::vector<char> used(mesh_.points.size(), 0);
    for (const std::array<Index, 2>& edge : edges_of(mesh_)) {
      const std::array<Index, 2> ends{mesh_.twins[edge[0]], mesh_.twins[edge[1]]};
      const auto it =
          std::ranges::lower_bound(old, std::array{std::min(ends[0], ends[1]), std::max(ends[0], ends[1])}, {},
                                   &std::pair<std::array<Index, 2>, Index>::first);
      mesh_.middles.emplace_back(edge, used[it->second] ? add_twin(mesh_, it->second) : it->second);
      used[it->second] = 1;
    }
  }
};

}  // namespace

void require_groups(const std::vector<std::string>& groups, const std::vector<std::string>& names) {
  for (const std::string& name : names) group_of_faces(groups, name);
}

Mesh joined_again(Mesh mesh) {
  const auto join = [&](auto& simplices) {
    for (auto& s : simplices) {
      for (Index& p : s.points) p = mesh.twins[p];
    }
  };
  if (!mesh.twins.empty()) join(mesh.vertices), join(mesh.segments), join(mesh.triangles), join(mesh.tetrahedra);
  return mesh;
}

SplitReport split(Mesh& mesh, const std::vector<std::string>& names, bool interfaces) {
  if (interfaces && !mesh.middles.empty())
    throw InputError("--interfaces: wedges are of first order; leave out --order 2 and --curved");
  return Splitter(mesh).run(names, interfaces);
}

}  // namespace cnrg
