// At an edge: solid sectors that follow each other are one, sheets are uses without solid on either side.
//
// At a vertex: where every node looks like a manifold, what the set leaves on the sphere is a disjoint union of
// surfaces with boundary, circles, arcs and points, told apart by counting: a connected planar surface of Euler
// characteristic chi has 2 - chi boundary circles, a connected graph of degrees one and two is an arc if chi = 1
// and a circle if chi = 0.
#include "kernel/selection/manifold.h"

#include <algorithm>
#include <array>
#include <map>

#include "kernel/base/error.h"
#include "kernel/base/sorted.h"
#include "kernel/base/union_find.h"
#include "kernel/complex/by_dimension.h"
#include "kernel/selection/merging.h"

namespace cnrg {
namespace {

using Index = Neighbourhood::Index;

/// The cells of a closed set.
struct ClosedSet : OfCells<Marks> {
  ClosedSet(const Complex& complex, const CellSet& set) : OfCells(complex), cells(closure(complex, set)) {
    const auto mark = [](auto& marks, const auto& list) {
      for (const auto cell : list) marks[cell] = 1;
    };
    for_each_dimension(mark, *this, cells);
  }
  CellSet cells;
};

std::string number(std::int64_t n, const char* one, const char* many) {
  return n == 1 ? std::string(one) : std::to_string(n) + " " + many;
}

/// `a wire, 2 sheets and the solid`.
std::string listed(const std::vector<std::string>& words) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) out += i + 1 == words.size() ? " and " : ", ";
    out += words[i];
  }
  return out;
}

LocalShape shape_of(const Complex& complex, const ClosedSet& set, EdgeId e) {
  const auto uses = complex.edge_uses[e];
  if (uses.empty()) return {set.regions[complex.edge_region[e]] ? LocalForm::interior : LocalForm::wire, ""};
  const auto solid = [&](std::size_t i) {
    return set.regions[complex.face_regions[uses[i].face][uses[i].half_edge.direction()]] != 0;
  };
  std::int64_t sectors = 0, sheets = 0;
  bool all = true;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const bool before = solid((i + uses.size() - 1) % uses.size()), after = solid(i);
    all = all && after;
    sectors += !before && after;
    sheets += !before && !after && set.faces[uses[i].face];
  }
  if (all) return {LocalForm::interior, ""};
  if (sectors == 0) {
    switch (sheets) {
      case 0: return {LocalForm::wire, ""};
      case 1: return {LocalForm::surface_border, ""};
      case 2: return {LocalForm::surface, ""};
      default: return {LocalForm::non_manifold, std::to_string(sheets) + " sheets meet"};
    }
  }
  if (sectors == 1 && sheets == 0) return {LocalForm::manifold, ""};
  if (sectors == 1) {
    return {LocalForm::non_manifold, number(sheets, "a sheet hangs", "sheets hang") + " on the solid"};
  }
  std::string reason = std::to_string(2 * sectors) + " boundary faces meet: ";
  reason += std::to_string(sectors) + " solid sectors";
  if (sheets > 0) reason += ", and " + number(sheets, "a sheet", "sheets");
  return {LocalForm::non_manifold, reason};
}

/// One connected part of what the set leaves on the sphere.
struct Part {
  std::int64_t euler = 0;
  bool solid = false, line = false;
};

/// What the parts are, each a manifold with boundary.
struct Census {
  std::int64_t points = 0, arcs = 0, circles = 0, disks = 0, pierced = 0;
  std::int64_t total() const { return points + arcs + circles + disks + pierced; }
};

class VertexShape {
 public:
  VertexShape(const ClosedSet& set, const Neighbourhood& n, const std::vector<LocalShape>& edge_shapes)
      : set_(set), n_(n), shapes_(edge_shapes) {}

  LocalShape run() const {
    const auto solid = [&](const auto& germ) { return set_.regions[germ.region] != 0; };
    if (std::all_of(n_.germs.begin(), n_.germs.end(), solid)) return {LocalForm::interior, ""};
    std::int64_t bad = 0;
    for (const LocalShape& s : shapes_) bad += s.form == LocalForm::non_manifold;
    if (bad > 0) return {LocalForm::non_manifold, at_bad_edges(bad)};
    const Census c = census();
    if (c.total() == 0) return {LocalForm::isolated_point, ""};
    if (c.total() == 1 && c.pierced == 0) {
      if (c.disks > 0) return {LocalForm::manifold, ""};
      if (c.circles > 0) return {LocalForm::surface, ""};
      return {c.arcs > 0 ? LocalForm::surface_border : LocalForm::wire_end, ""};
    }
    if (c.total() == 2 && c.points == 2) return {LocalForm::wire, ""};
    return {LocalForm::non_manifold, meeting(c)};
  }

 private:
  bool has_face(const Neighbourhood::Arc& arc) const { return set_.faces[arc.face] != 0; }
  bool has_edge(const Neighbourhood::Node& node) const { return set_.edges[node.edge.edge()] != 0; }
  bool has_germ(Index g) const { return set_.regions[n_.germs[g].region] != 0; }

  /// Connected parts of the set on the sphere.
  std::vector<Part> parts() const {
    const auto arcs = static_cast<Index>(n_.nodes.size());
    const auto germs = arcs + static_cast<Index>(n_.arcs.size());
    UnionFind sets(germs + n_.germs.size());
    for (Index k = 0; k < n_.arcs.size(); ++k) {
      if (!has_face(n_.arcs[k])) continue;
      if (!n_.arcs[k].full_circle()) {
        for (Index node : n_.arcs[k].nodes) sets.unite(node, arcs + k);
      }
      for (Index g : n_.arcs[k].germs) {
        if (has_germ(g)) sets.unite(arcs + k, germs + g);
      }
    }
    for (Index i = 0; i < n_.nodes.size(); ++i) {
      if (n_.nodes[i].count == 0 && has_germ(n_.nodes[i].germ)) sets.unite(i, germs + n_.nodes[i].germ);
    }
    std::map<std::uint32_t, Part> found;
    for (Index i = 0; i < n_.nodes.size(); ++i) {
      if (has_edge(n_.nodes[i])) found[sets.find(i)].euler += 1;
    }
    for (Index k = 0; k < n_.arcs.size(); ++k) {
      if (!has_face(n_.arcs[k])) continue;
      Part& part = found[sets.find(arcs + k)];
      part.euler -= n_.arcs[k].full_circle() ? 0 : 1;
      part.line = true;
    }
    for (Index g = 0; g < n_.germs.size(); ++g) {
      if (!has_germ(g)) continue;
      Part& part = found[sets.find(germs + g)];
      part.euler += n_.germs[g].euler();
      part.solid = true;
    }
    std::vector<Part> out;
    out.reserve(found.size());
    for (const auto& [root, part] : found) out.push_back(part);
    return out;
  }

  Census census() const {
    Census c;
    for (const Part& part : parts()) {
      if (part.solid) ++(part.euler == 1 ? c.disks : c.pierced);
      else if (part.line) ++(part.euler == 0 ? c.circles : c.arcs);
      else ++c.points;
    }
    return c;
  }

  /// A solid that is neither all around nor a disk surrounds cones of the outside.
  static std::string meeting(const Census& c) {
    if (c.total() == 1) return "cones of the outside touch within the solid";
    if (c.total() == c.points) return std::to_string(c.points) + " wires meet";
    if (c.total() == c.disks) return std::to_string(c.disks) + " solid cones touch";
    if (c.total() == c.circles + c.arcs) return std::to_string(c.circles + c.arcs) + " sheets touch in a point";
    std::vector<std::string> words;
    if (c.points > 0) words.push_back(number(c.points, "a wire", "wires"));
    if (c.circles + c.arcs > 0) words.push_back(number(c.circles + c.arcs, "a sheet", "sheets"));
    if (c.disks > 0) words.push_back(number(c.disks, "a solid cone", "solid cones"));
    if (c.pierced > 0)
      words.push_back(
          number(c.pierced, "a solid around cones of the outside", "solids around cones of the outside"));
    return listed(words) + " meet in a point";
  }

  std::string at_bad_edges(std::int64_t bad) const {
    std::string out = number(bad, "a non-manifold edge ends", "non-manifold edges end") + " here";
    const auto count = parts().size();
    if (count > 1) out += ", and " + std::to_string(count) + " parts of the set touch";
    return out;
  }

  const ClosedSet& set_;
  const Neighbourhood& n_;
  const std::vector<LocalShape>& shapes_;
};

}  // namespace

const char* to_string(LocalForm form) {
  static constexpr std::array<const char*, 8> kNames{"interior", "manifold", "surface",        "surface border",
                                                     "wire",     "wire end", "isolated point", "non-manifold"};
  return kNames[static_cast<std::size_t>(form)];
}

bool Manifoldness::manifold() const {
  const auto good = [](const auto& entry) { return entry.second.form != LocalForm::non_manifold; };
  return std::all_of(edges.begin(), edges.end(), good) && std::all_of(vertices.begin(), vertices.end(), good);
}

Manifoldness manifoldness(const Complex& complex, const CellSet& set, Neighbourhoods& neighbourhoods) {
  const ClosedSet closed(complex, set);
  Manifoldness out;
  for (EdgeId e : closed.cells.edges) out.edges.emplace_back(e, shape_of(complex, closed, e));
  Neighbourhood around;
  std::vector<LocalShape> shapes;
  for (VertexId v : closed.cells.vertices) {
    neighbourhoods.at(v, around);
    shapes.clear();
    for (const auto& node : around.nodes) {
      if (!closed.edges[node.edge.edge()]) continue;
      shapes.push_back(*value_of_key(out.edges, node.edge.edge()));
    }
    out.vertices.emplace_back(v, VertexShape(closed, around, shapes).run());
  }
  return out;
}

std::vector<Sheet> sheets(const Complex& complex, const CellSet& set) {
  const ClosedSet closed(complex, set);
  std::vector<FaceId> faces;
  for (FaceId f : closed.cells.faces) {
    const auto& [front, back] = complex.face_regions[f];
    if (!closed.regions[front] && !closed.regions[back]) faces.push_back(f);
  }
  OrientedSets joined(complex.face_count());
  std::vector<FaceId> one_sided, bordered;
  for (EdgeId e : closed.cells.edges) {
    const LocalForm form = shape_of(complex, closed, e).form;
    std::vector<FaceUse> uses;
    for (const FaceUse& use : complex.edge_uses[e]) {
      if (std::binary_search(faces.begin(), faces.end(), use.face)) uses.push_back(use);
    }
    if (form != LocalForm::surface) {
      for (const FaceUse& use : uses) bordered.push_back(use.face);
      continue;
    }
    require(uses.size() == 2, "sheets: an edge inside a sheet has not two faces");
    // Faces with one orientation pass the edge in opposite directions.
    const bool turned = uses[0].half_edge == uses[1].half_edge;
    if (!joined.unite(uses[0].face, uses[1].face, turned)) one_sided.push_back(uses[0].face);
  }
  std::vector<Sheet> out;
  std::map<FaceId, std::size_t> numbers;
  for (FaceId f : faces) {
    const auto [at, fresh] = numbers.try_emplace(joined.find(f).first, out.size());
    if (fresh) out.emplace_back();
    out[at->second].faces.push_back(f);
  }
  for (FaceId f : one_sided) out[numbers[joined.find(f).first]].orientable = false;
  for (FaceId f : bordered) out[numbers[joined.find(f).first]].closed = false;
  return out;
}

}  // namespace cnrg
