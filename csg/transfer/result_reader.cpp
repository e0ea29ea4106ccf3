// The tables of a result file. What would lead nowhere is an error here: a value of another type, a number of
// something that does not exist, cells that have no bounds. Nothing else is asked: whatever is not as it is
// written is found once the value is written again (result_check.cpp).
#include <algorithm>
#include <iterator>
#include <map>

#include "csg/imports/read_grades.h"
#include "csg/text/number.h"
#include "csg/transfer/stored_value.h"
#include "kernel/base/counts.h"
#include "kernel/base/sorted.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg::result {
namespace {

using Loop = FlatComplex::Loop;

class Reader {
 public:
  explicit Reader(const Cursor& root) : root_(root) {}

  ResultFile read() {
    if (!root_.has("format") || root_.member("format").text() != "cnrg result") {
      root_.refuse("this is no result of cnrg: `\"format\": \"cnrg result\"` is missing");
    }
    if (root_.member("version").number(1u << 30, "version") != 1) {
      root_.member("version").fail("only version 1 can be read; use a newer cnrg");
    }
    file_.names.result = root_.member("node").text();
    if (root_.has("volume_bound")) value_.volume_bound = read_bound(root_.member("volume_bound"));
    value_.group = root_.member("group").boolean();
    each("leaves", [&](const Cursor& leaf) { file_.names.leaves.push_back(leaf.member("name").text()); });
    read_materials();
    read_components();
    read_attributes();
    read_points();
    read_regions();
    read_vertices();
    read_edges();
    if (root_.has("patches")) read_patches();
    read_faces();
    for (FlatComplex::Edge& edge : cells_.edges) edge.wire = edge.around.empty();
    const auto idle = std::find(is_used_.begin(), is_used_.end(), 0);
    if (idle != is_used_.end())
      root_.member("components").at(std::size_t(idle - is_used_.begin())).refuse("no cell is of this component");
    return std::move(file_);
  }

 private:
  const Cursor root_;
  ResultFile file_;
  StoredValue& value_ = file_.value;
  FlatComplex& cells_ = value_.cells;
  std::vector<char> frame_, on_edge_;                 // by point
  std::map<Index, Index> vertex_at_;                  // by point
  std::map<std::pair<Index, Index>, Index> edge_at_;  // by segment, the smaller point first
  std::map<std::string, Rational> materials_;         // with their dominance
  std::vector<std::shared_ptr<const PlacedGrade>> grades_;
  std::vector<const Attributes*> said_;  // by number
  std::vector<char> is_used_;            // by component
  std::vector<std::vector<PatchCorner>> patch_cells_;
  std::map<Index, LeafId> leaf_of_patch_;

  template <class See>
  static void each(const Cursor& list, See see) {
    for (std::size_t i = 0; i < list.array().size(); ++i) see(list.at(i));
  }
  template <class See>
  void each(const char* key, See see) const {
    each(root_.member(key), see);
  }

  [[noreturn]] static void not_closed(const Cursor& at, const std::string& what) {
    at.refuse(what + ", but the file says that it is a group, which is closed");
  }
  [[noreturn]] static void not_bounded(const Cursor& at, const std::string& what) {
    at.fail(what +
            " has no bounds, and those of a leaf must have some; cut the node with a box before it is "
            "written (`intersection`, or `product` where it is not closed), or read its operands back and apply "
            "the operator in the tree");
  }

  static std::optional<double> read_bound(const Cursor& at) {
    if (at.is_null()) return std::nullopt;
    const std::optional<Rational> bound = read_number(at.text()).value;
    if (!bound || *bound <= 0) at.refuse("a bound is a number above 0, or null where nobody knows it");
    return to_double(*bound);
  }

  void read_materials() {
    each("materials", [&](const Cursor& m) {
      const std::string name = m.member("name").text(), color = m.member("color").text();
      if (name.empty()) m.refuse("a material has a name");
      const Rational dominance = m.has("dominance") ? m.member("dominance").rational() : Rational(0);
      if (!materials_.emplace(name, dominance).second) m.refuse("two materials have this name");
      const bool hex = color.size() == 7 && color[0] == '#' &&
                       color.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
      if (!color.empty() && !hex) m.member("color").refuse("a color is \"#rrggbb\" or empty");
      file_.names.materials.push_back({name, color});
    });
  }

  void require_material(const std::string& name, const Cursor& at) const {
    if (!materials_.contains(name)) at.refuse("`materials` has none of this name");
  }

  /// Files of older releases have the text alone.
  static Name name(const Cursor& of) {
    const std::string text = of.member("name").text();
    if (!of.has("called")) return text.empty() ? Name() : Name(std::vector{NamePart{text, 0, NameOrigin::file}});
    std::vector<NamePart> parts;
    each(of.member("called"), [&](const Cursor& part) { parts.push_back(part_of_name(part)); });
    return Name(std::move(parts));
  }

  static NamePart part_of_name(const Cursor& of) {
    if (!of.has("name")) return {of.text()};
    NamePart part{of.member("name").text()};
    if (of.has("ordinal")) part.ordinal = of.member("ordinal").number(FlatComplex::kNone, "ordinal");
    if (!of.has("by")) return part;
    const auto it = std::find(std::begin(kNameOrigins), std::end(kNameOrigins), of.member("by").text());
    if (it == std::end(kNameOrigins)) of.member("by").refuse("nobody of that kind gives names");
    part.origin = static_cast<NameOrigin>(it - std::begin(kNameOrigins));
    return part;
  }

  Attributes attributes(const Cursor& of) const {
    const std::string material = of.member("material").text();
    if (!material.empty()) require_material(material, of.member("material"));
    RegionMaterial made(material);
    if (of.has("grade")) {
      const Index grade = of.member("grade").number(grades_.size(), "grade");
      const std::string of_grade = root_.member("grades").at(grade).member("material").text();
      if (of_grade != material) of.member("grade").refuse("this grade is of another material, `" + of_grade + "`");
      made = {material, grades_[grade]};
    }
    if (!made.empty()) made.set_dominance(materials_.at(material));
    Attributes out{name(of), std::move(made), {}};
    if (!of.has("properties")) return out;
    of.member("properties").each_member([&](const std::string& key, const Cursor& value) {
      if (value.has("number")) out.properties[key] = value.member("number").rational();
      else out.properties[key] = value.text();
    });
    return out;
  }

  /// A dominance is that of a group or, in other values, of each component.
  void read_components() {
    if (value_.group) value_.dominances.push_back(root_.member("dominance").rational());
    grades_ = read_grades(root_, [&](const std::string& name, const Cursor& at) { require_material(name, at); });
    each("components", [&](const Cursor& c) {
      value_.components.push_back(attributes(c));
      if (!value_.group) value_.dominances.push_back(c.member("dominance").rational());
      auto& leaves = file_.leaves_of.emplace_back();
      each(c.member("leaves"), [&](const Cursor& leaf) { leaves.push_back(leaf_at(leaf)); });
      sort_unique(leaves);
    });
    is_used_.assign(value_.components.size(), 0);
  }
  LeafId leaf_at(const Cursor& at) const { return LeafId(at.number(file_.names.leaves.size(), "leaf")); }

  /// What is said of faces, edges and vertices.
  void read_attributes() {
    if (!root_.has("attributes")) return;
    each("attributes", [&](const Cursor& a) { said_.push_back(&*value_.said.insert(attributes(a)).first); });
  }

  void read_points() {
    auto& points = value_.points;
    each("points", [&](const Cursor& p) {
      points.push_back(p.point());
      if (points.size() > 1 && !(points[points.size() - 2] < points.back())) {
        p.refuse("points are sorted by their coordinates, and no two are equal");
      }
    });
    frame_.assign(points.size(), 0);
    on_edge_.assign(points.size(), 0);
    each("frame", [&](const Cursor& p) { frame_[p.number(points.size(), "point")] = 1; });
  }

  /// What cells of all dimensions have; the entities of a group have the number after its last component. A cell
  /// that is no part of the result has neither origin nor attributes.
  template <class Cell>
  void read_cell(const Cursor& at, int dimension, Cell& cell) {
    const std::size_t count = value_.components.size() + 1;
    cell.component = at.member("component").number(count + (value_.group && dimension < 3), "component");
    if constexpr (requires { cell.feature; }) cell.feature = at.member("feature").boolean();
    if (cell.component == 0) return;
    if (cell.component < count) is_used_[cell.component - 1] = 1;
    if (at.has("attributes")) {
      const Attributes& said = *said_[at.member("attributes").number(said_.size(), "attributes")];
      if (!said.empty()) cell.origin.said = &said;
    }
    if (at.has("origin")) read_origin(at.member("origin"), dimension, cell.origin);
  }

  /// What holds a cell is not of less dimension than it.
  void read_origin(const Cursor& list, int dimension, FlatComplex::Provenance& origin) const {
    static constexpr const char* kKeys[] = {"point", "edges", "faces", "regions"};
    std::vector<LeafId> leaves;
    std::vector<LeafCell> cells;
    each(list, [&](const Cursor& one) {
      const LeafId leaf = leaf_at(one.member("leaf"));
      leaves.push_back(leaf);
      if (dimension == 0 && one.has("point")) cells.push_back({leaf, 0, 0});
      for (int d = std::max(1, dimension); d <= 3; ++d) {
        if (!one.has(kKeys[d])) continue;
        each(one.member(kKeys[d]), [&](const Cursor& at) {
          const Index number = at.number(FlatComplex::kNone, "cell");
          if (d == 3 && number == 0) at.refuse("regions of leaves count from 1");
          cells.push_back({leaf, static_cast<std::uint8_t>(d), number});
        });
      }
    });
    sort_unique(leaves), sort_unique(cells);
    origin.leaves = {leaves.begin(), leaves.end()};
    origin.cells = {cells.begin(), cells.end()};
  }

  void read_regions() {
    bool unbounded = false;
    each("regions", [&](const Cursor& r) {
      FlatComplex::Region& region = cells_.regions.emplace_back();
      read_cell(r, 3, region);
      region.bounded = r.member("bounded").boolean();
      if (!region.bounded && unbounded) not_bounded(r, "what parts this region from another one");
      unbounded = unbounded || !region.bounded;
    });
  }

  Loop read_loop(const Cursor& list, std::size_t least, const char* what) const {
    Loop loop;
    if (list.array().size() < least) list.refuse("at least " + std::to_string(least) + " points are needed here");
    each(list, [&](const Cursor& at) {
      const Index p = at.number(value_.points.size(), "point");
      if (frame_[p]) not_bounded(list, what);
      if (!loop.empty() && p == loop.back()) at.refuse("the same point twice in a row");
      loop.push_back(p);
    });
    return loop;
  }

  void read_vertices() {
    each("vertices", [&](const Cursor& v) {
      FlatComplex::Vertex vertex;
      vertex.point = v.member("point").number(value_.points.size(), "point");
      if (frame_[vertex.point]) not_bounded(v, "this vertex");
      read_cell(v, 0, vertex);
      vertex_at_.emplace(vertex.point, next_number(cells_.vertices.size(), "vertices"));
      cells_.vertices.push_back(std::move(vertex));
    });
  }

  void read_edges() {
    each("edges", [&](const Cursor& e) {
      FlatComplex::Edge edge;
      edge.closed = e.member("closed").boolean();
      edge.points = read_loop(e.member("points"), edge.closed ? 3 : 2, "this edge");
      read_cell(e, 1, edge);
      for (const Index p : edge.points) on_edge_[p] = 1;
      for (const Index p : {edge.points.front(), edge.points.back()}) {
        if (edge.closed) break;
        const auto vertex = vertex_at_.find(p);
        if (vertex == vertex_at_.end()) e.refuse("no vertex at its end, point " + std::to_string(p));
        if (value_.group && edge.component != 0 && cells_.vertices[vertex->second].component == 0)
          not_closed(e, "its end, point " + std::to_string(p) + ", is missing");
      }
      for_each_segment(edge, [&](Index a, Index b) {
        if (!edge_at_.try_emplace(std::minmax(a, b), next_number(cells_.edges.size(), "edges")).second)
          e.refuse("two edges between the same points");
      });
      cells_.edges.push_back(std::move(edge));
    });
    for (FlatComplex::Vertex& vertex : cells_.vertices) vertex.free = !on_edge_[vertex.point];
  }

  void read_faces() {
    each("faces", [&](const Cursor& f) {
      const Index number = next_number(cells_.faces.size(), "faces");
      FlatComplex::Face& face = cells_.faces.emplace_back();
      read_cell(f, 2, face);
      const Cursor sides = f.member("regions").array_of(2, "two regions are needed here: in front and behind");
      for (std::size_t i = 0; i < 2; ++i) {
        if (sides.at(i).is_null()) not_bounded(f, "this face");
        face.regions[i] = sides.at(i).number(cells_.regions.size(), "region");
        if (value_.group && face.component == 0 && cells_.active(face.regions[i]))
          not_closed(f, "this face of a region is missing");
      }
      const Index patch = f.member("patch").number(FlatComplex::kNone, "patch");
      const auto leaf = leaf_of_patch_.find(patch);
      face.patch = {leaf == leaf_of_patch_.end() ? LeafId(0) : leaf->second, patch};
      face.loops = read_walks(f, !f.has("facets"));
      walk_boundary(f, face, number);
      if (f.has("facets")) {
        each(f.member("facets"), [&](const Cursor& at) { face.facets.push_back({read_walks(at, true), {}}); });
        if (face.facets.empty()) f.member("facets").refuse("a face that is not flat has facets");
      }
      if (f.has("cells") && face.component != 0) choose_cells(f.member("cells"), face);
    });
  }

  void read_patches() {
    each("patches", [&](const Cursor& p) {
      const Index patch = p.member("patch").number(FlatComplex::kNone, "patch");
      leaf_of_patch_[patch] = leaf_at(p.member("leaf"));
      value_.patches[patch] = p.member("name").text();
    });
    each("cells", [&](const Cursor& c) {
      if (c.array().size() != 3 && c.size() != 4) c.refuse("a cell has three corners or four");
      auto& cell = patch_cells_.emplace_back();
      each(c, [&](const Cursor& at) {
        at.array_of(5, "x, y, z, u and v are needed here");
        const auto number = [&](std::size_t k) { return at.at(k).rational(); };
        cell.push_back({{number(0), number(1), number(2)}, {number(3), number(4)}});
      });
      if (!is_cell(cell)) c.refuse("the corners of a cell lie in a plane and not on a line");
    });
  }

  /// The cells of patches for the facets of a face.
  void choose_cells(const Cursor& lists, FlatComplex::Face& face) {
    lists.array_of(std::max<std::size_t>(face.facets.size(), 1), "one list for each facet is needed here");
    each(lists, [&](const Cursor& list) {
      if (list.array().size() == 0) list.refuse("a facet of a patch with parameters lies in a cell");
      auto& cells = face.cells.emplace_back();
      each(list, [&](const Cursor& at) { cells.push_back(patch_cells_[at.number(patch_cells_.size(), "cell")]); });
      sort_unique(cells);
    });
  }

  std::vector<Loop> read_walks(const Cursor& face, bool needed) const {
    std::vector<Loop> walks;
    each(face.member("loops"), [&](const Cursor& loop) {
      walks.push_back(read_loop(loop, 2, "this face"));
      if (walks.back().front() == walks.back().back()) loop.refuse("a loop does not repeat its first point");
    });
    if (needed && std::none_of(walks.begin(), walks.end(), [](const Loop& walk) { return walk.size() > 2; }))
      face.member("loops").refuse("a face without area");
    return walks;
  }

  /// Checks that each step of a face is along an edge of the file (an active one if the face is active in a
  /// group), and notes at the edges that it walks them.
  void walk_boundary(const Cursor& at, const FlatComplex::Face& face, Index number) {
    std::map<Index, std::pair<Index, Index>> first;  // edge -> the segment where the face walks it first
    for (const Loop& walk : face.loops) {
      for (std::size_t i = 0; i < walk.size(); ++i) {
        const Index a = walk[i], b = walk[(i + 1) % walk.size()];
        const auto found = edge_at_.find(std::minmax(a, b));
        const auto between = [&] { return " points " + std::to_string(a) + " and " + std::to_string(b); };
        if (found == edge_at_.end()) at.refuse("no edge joins" + between());
        FlatComplex::Edge& edge = cells_.edges[found->second];
        if (value_.group && face.component != 0 && edge.component == 0)
          not_closed(at, "its edge between" + between() + " is missing");
        const auto [entry, fresh] = first.try_emplace(found->second, a, b);
        const auto& segment = entry->second;
        if (fresh) edge.around.push_back(2 * number);
        else if (std::minmax(a, b) == std::minmax(segment.first, segment.second)) edge.slit = true;
      }
    }
  }
};

}  // namespace

ResultFile read_file(const Cursor& root) { return Reader(root).read(); }

}  // namespace cnrg::result
