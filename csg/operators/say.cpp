// Faces first: those of which something is said, or that stand for themselves. The edges and vertices in their
// closure are theirs. An edge that bounds no face is a wire, a vertex that bounds nothing is a point.
#include "csg/operators/say.h"

#include <algorithm>
#include <map>

#include "kernel/selection/scratch.h"

namespace cnrg {
namespace {

class Speaker {
 public:
  Speaker(const Complex& complex, const Attributes& what, Saying saying, LeafSets& sets)
      : complex_(complex),
        what_(what),
        saying_(saying),
        sets_(sets),
        edges_(complex.edge_count()),
        vertices_(complex.points.size()) {}

  /// `stands(i)`: cell i stands for itself, if it bounds nothing. `inside(i)`: face i is in the interior of a
  /// component, where some other leaf cuts it, and nothing bounds it.
  template <class Faces, class Stands, class Inside>
  void faces(const Faces& faces, std::vector<LeafSetId>& origins, Stands stands, Inside inside) {
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const FaceId f = faces[i];
      const bool said = stands(i) || (saying_ != Saying::replaces_standing && sets_.said(origins[i]) != nullptr);
      if (said || !inside(i)) mark(f, said ? kOfSheet : kOfWall);
      if (said) origins[i] = with(origins[i], 2);
    }
  }

  template <class Edges, class Stands>
  void edges(const Edges& edges, std::vector<LeafSetId>& origins, Stands stands) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const EdgeId e = edges[i];
      const std::uint8_t around = edges_.get(e);
      int dimension = kNone;
      if (around & kOfSheet) dimension = 2;
      else if (around == 0 && stands(i)) dimension = 1;
      if (say_of(origins[i], dimension) && dimension == 1) {
        for (const VertexId v : complex_.edge_ends[e]) vertices_[v] |= kOfWire;
      }
      if (around == 0 && stands(i)) {
        for (const VertexId v : complex_.edge_ends[e]) vertices_[v] |= kBounds;
      }
    }
  }

  template <class Vertices, class Stands>
  void vertices(const Vertices& vertices, std::vector<LeafSetId>& origins, Stands stands) {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const std::uint8_t around = vertices_.get(vertices[i]);
      int dimension = kNone;
      if (around & kOfWire) dimension = 1;
      else if (around & kOfSheet) dimension = 2;
      else if (around == 0 && stands(i)) dimension = 0;
      say_of(origins[i], dimension);
    }
  }

 private:
  static constexpr int kNone = 3;
  static constexpr std::uint8_t kOfWall = 1, kOfSheet = 2, kOfWire = 4, kBounds = 8;

  void mark(FaceId f, std::uint8_t as) {
    for_each_bounding(complex_, f, [&](auto cell) {
      if constexpr (std::is_same_v<decltype(cell), EdgeId>) edges_[cell] |= as;
      else vertices_[cell] |= as;
    });
  }

  bool say_of(LeafSetId& origin, int dimension) {
    const SaidPointer& before = sets_.said(origin);
    if (dimension == kNone && saying_ == Saying::replaces_standing) return false;
    if (before) dimension = std::min(dimension, before->dimension);
    if (dimension == kNone) return false;
    origin = with(origin, dimension);
    return true;
  }

  LeafSetId with(LeafSetId origin, int dimension) {
    const auto [it, fresh] = known_.try_emplace({origin, dimension});
    if (!fresh) return it->second;
    Said said{{}, dimension};
    if (const SaidPointer& before = sets_.said(origin)) said.attributes = before->attributes;
    if (saying_ == Saying::fills_in) fill_in(said.attributes, what_);
    else replace(said.attributes, what_);
    const std::vector<LeafId> leaves(sets_[origin].begin(), sets_[origin].end());
    return it->second = sets_.intern(leaves, std::make_shared<const Said>(std::move(said)));
  }

  const Complex& complex_;
  const Attributes& what_;
  const Saying saying_;
  LeafSets& sets_;
  Marks<EdgeId> edges_;  // what is around, of the value's faces
  Marks<VertexId> vertices_;
  std::map<std::pair<LeafSetId, int>, LeafSetId> known_;
};

}  // namespace

void say(const Complex& complex, const Attributes& what, Saying saying, Group& group) {
  Scratch<RegionId, std::uint32_t> region(complex.region_count);
  for (const auto& [cell, number] : group.cells) region[cell] = number;
  Speaker speaker(complex, what, saying, group.origins.sets);
  const auto always = [](std::size_t) { return true; };
  const auto never = [](std::size_t) { return false; };
  speaker.faces(
      group.faces, group.origins.faces,
      [&](std::size_t i) {
        const auto& [front, back] = complex.face_regions[group.faces[i]];
        return region.get(front) == region.get(back);
      },
      never);
  speaker.edges(group.edges, group.origins.edges, always);
  speaker.vertices(group.vertices, group.origins.vertices, always);
}

// A cell next to a 3-cell of its own component does not stand for itself: it is inside of that, or where it ends.
void say(const Complex& complex, const Attributes& what, Saying saying, Components& components) {
  const Selection& s = components.selection;
  Origins& o = components.origins;
  Scratch<RegionId, Component> region(complex.region_count);
  for (const auto& [cell, component] : s.regions) region[cell] = component;
  Speaker speaker(complex, what, saying, o.sets);
  const auto ids = [](const auto& list) {
    std::vector<std::decay_t<decltype(list[0].first)>> cells;
    cells.reserve(list.size());
    for (const auto& entry : list) cells.push_back(entry.first);
    return cells;
  };
  std::vector<RegionId> around;
  const auto stands_out = [&](const auto& list) {
    return [&](std::size_t i) {
      complex.star_regions(list[i].first, around);
      return std::none_of(around.begin(), around.end(),
                          [&](RegionId r) { return region.get(r) == list[i].second; });
    };
  };
  const auto alike = [&](std::size_t i, bool stands) {
    const auto& [front, back] = complex.face_regions[s.faces[i].first];
    return region.get(front) == region.get(back) && (region.get(front) != s.faces[i].second) == stands;
  };
  speaker.faces(
      ids(s.faces), o.faces, [&](std::size_t i) { return alike(i, true); },
      [&](std::size_t i) { return alike(i, false); });
  speaker.edges(ids(s.edges), o.edges, stands_out(s.edges));
  speaker.vertices(ids(s.vertices), o.vertices, stands_out(s.vertices));
}

}  // namespace cnrg
