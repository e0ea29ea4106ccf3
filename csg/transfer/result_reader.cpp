// The tables of a result file. What can be said without geometry is checked here: types, ranges, members that no
// result has, things that are named and do not exist, things that exist and are not named. What the cells are is
// known only once they are made (result_check.cpp).
#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "csg/imports/read_grades.h"
#include "csg/text/number.h"
#include "csg/transfer/stored_value.h"
#include "kernel/base/counts.h"
#include "kernel/base/limits.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg::result {
namespace {

using Loop = FlatComplex::Loop;

/// Things that are listed and have to be named somewhere.
class Named {
 public:
  void resize(std::size_t count) { named_.assign(count, 0); }
  std::size_t size() const { return named_.size(); }
  Index name(Index number) { return named_[number] = 1, number; }
  void require_all(const Cursor& list, const std::string& what) const {
    const auto idle = std::find(named_.begin(), named_.end(), 0);
    if (idle != named_.end()) list.at(std::size_t(idle - named_.begin())).refuse(what);
  }

 private:
  std::vector<char> named_;
};

class Reader {
 public:
  explicit Reader(const Cursor& root) : root_(root) {}

  StoredValue read() {
    if (!root_.has("format") || root_.member("format").text() != "cnrg result") {
      root_.refuse("this is no result of cnrg: `\"format\": \"cnrg result\"` is missing");
    }
    if (root_.member("version").number(1u << 30, "version") != 1) {
      root_.member("version").fail("only version 1 can be read; use a newer cnrg");
    }
    root_.only({"format", "version", "node", "group", "dominance", "leaves", "materials", "grades", "components",
                "attributes", "points", "frame", "vertices", "edges", "patches", "cells", "faces", "regions",
                "volume_bound"});
    root_.member("node").text();
    if (root_.has("volume_bound")) value_.volume_bound = read_bound(root_.member("volume_bound"));
    value_.group = root_.member("group").boolean();
    read_leaves();
    read_materials();
    read_components();
    read_attributes();
    read_points();
    read_regions();
    read_vertices();
    read_edges();
    read_patches();
    read_faces();
    for (FlatComplex::Edge& edge : cells_.edges) edge.wire = edge.around.empty();
    require_all();
    return std::move(value_);
  }

 private:
  const Cursor root_;
  StoredValue value_;
  FlatComplex& cells_ = value_.cells;
  std::vector<char> frame_, on_edge_;                 // by point
  std::map<Index, Index> vertex_at_;                  // by point
  std::map<std::pair<Index, Index>, Index> edge_at_;  // by segment, the smaller point first
  std::map<std::string, Rational> materials_;         // with their dominance
  std::vector<std::shared_ptr<const PlacedGrade>> made_grades_;
  Index next_said_ = 0;
  Named points_, leaves_, components_, grades_, said_, patch_cells_, patches_;
  std::vector<const Attributes*> said_at_;  // by number
  std::vector<std::vector<PatchCorner>> cells_of_patches_;
  std::vector<Index> patch_numbers_;      // of those with parameters
  Index next_patch_ = 0, next_cell_ = 0;  // patches and cells are numbered as faces name them

  template <class F>
  void each(const char* key, F f) {
    const Cursor list = root_.member(key).array();
    for (std::size_t i = 0; i < list.size(); ++i) f(list.at(i));
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

  /// Numbers that are strictly ascending.
  template <class See>
  void ascending(const Cursor& list, std::size_t limit, const char* what, See see) const {
    Index last = 0;
    for (std::size_t i = 0; i < list.array().size(); ++i) {
      const Index number = list.at(i).number(limit, what);
      if (i > 0 && number <= last) list.at(i).refuse("numbers are ascending here, and each stands once");
      see(last = number);
    }
  }

  static std::optional<double> read_bound(const Cursor& at) {
    if (at.is_null()) return std::nullopt;
    const std::optional<Rational> bound = read_number(at.text()).value;
    if (!bound || *bound <= 0) at.refuse("a bound is a number above 0, or null where nobody knows it");
    return to_double(*bound);
  }

  void read_leaves() {
    each("leaves", [&](const Cursor& leaf) { leaf.only({"name"}).member("name").text(); });
    leaves_.resize(root_.member("leaves").size());
  }

  void read_materials() {
    each("materials", [&](const Cursor& m) {
      m.only({"name", "color", "dominance"});
      const std::string name = m.member("name").text(), color = m.member("color").text();
      if (name.empty()) m.refuse("a material has a name");
      const Rational dominance = m.has("dominance") ? m.member("dominance").rational() : Rational(0);
      if (m.has("dominance") && dominance == 0) m.member("dominance").refuse("a dominance of 0 is left out");
      if (!materials_.emplace(name, dominance).second) m.refuse("two materials have this name");
      const bool hex = color.size() == 7 && color[0] == '#' &&
                       color.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
      if (!color.empty() && !hex) m.member("color").refuse("a color is \"#rrggbb\" or empty");
    });
  }

  std::string material(const Cursor& at) const {
    std::string name = at.text();
    if (!name.empty()) require_material(name, at);
    return name;
  }
  void require_material(const std::string& name, const Cursor& at) const {
    if (!materials_.contains(name)) at.refuse("`materials` has none of this name");
  }

  /// A dominance is that of a group or, in other values, of each component.
  Rational dominance(const Cursor& of, bool wanted) const {
    if (!wanted && of.has("dominance")) {
      of.member("dominance")
          .refuse(value_.group ? "a group has one dominance, and its components have none"
                               : "only a group has one dominance; here each component has one");
    }
    return wanted ? of.member("dominance").rational() : Rational(0);
  }

  /// Files of older releases have the text alone.
  static Name name(const Cursor& of) {
    const std::string text = of.member("name").text();
    if (!of.has("called")) return text.empty() ? Name() : Name(std::vector{NamePart{text, 0, NameOrigin::file}});
    std::vector<NamePart> parts;
    const Cursor list = of.member("called").array();
    for (std::size_t i = 0; i < list.size(); ++i) parts.push_back(part_of_name(list.at(i)));
    Name made(std::move(parts));
    if (made.text() != text) list.refuse("these parts make the name \"" + made.text() + "\"");
    return made;
  }

  static NamePart part_of_name(const Cursor& of) {
    if (!of.has("name")) return {of.text()};
    NamePart part{of.only({"name", "ordinal", "by"}).member("name").text()};
    if (of.has("ordinal")) part.ordinal = of.member("ordinal").number(kNone, "ordinal");
    if (of.has("by")) {
      const auto it = std::find(std::begin(kNameOrigins), std::end(kNameOrigins), of.member("by").text());
      if (it == std::end(kNameOrigins)) of.member("by").refuse("nobody of that kind gives names");
      part.origin = static_cast<NameOrigin>(it - std::begin(kNameOrigins));
    }
    if (part.ordinal == 0 && of.has("ordinal")) of.member("ordinal").refuse("ordinals begin at 1");
    if (part.origin != NameOrigin::given) return part;
    if (of.has("by")) of.member("by").refuse("`given` is left out");
    if (part.ordinal == 0) of.refuse("a given name without an ordinal is a text");
    return part;
  }

  Attributes attributes(const Cursor& of) {
    RegionMaterial made(material(of.member("material")));
    if (of.has("grade")) {
      const Index grade = grades_.name(of.member("grade").number(made_grades_.size(), "grade"));
      const std::string of_grade = root_.member("grades").at(grade).member("material").text();
      if (of_grade != made.name())
        of.member("grade").refuse("this grade is of another material, `" + of_grade + "`");
      made = {made.name(), made_grades_[grade]};
    }
    if (!made.empty()) made.set_dominance(materials_.at(made.name()));
    Attributes out{name(of), std::move(made), {}};
    if (!of.has("properties")) return out;
    const Cursor properties = of.member("properties");
    properties.each_member([&](const std::string& key, const Cursor& value) {
      if (!out.properties.empty() && key <= out.properties.rbegin()->first) {
        value.refuse("properties are in the order of their keys, and each stands once");
      }
      if (value.has("number")) out.properties[key] = value.only({"number"}).member("number").rational();
      else out.properties[key] = value.text();
    });
    if (out.properties.empty()) properties.refuse("what is empty is left out");
    return out;
  }

  /// What is said of faces, edges and vertices.
  void read_attributes() {
    if (!root_.has("attributes")) return;
    each("attributes", [&](const Cursor& a) {
      a.only({"name", "called", "material", "grade", "properties"});
      said_at_.push_back(&*value_.said.insert(attributes(a)).first);
      if (said_at_.back()->empty()) a.refuse("what says nothing is left out");
    });
    if (said_at_.empty()) root_.member("attributes").refuse("what is empty is left out");
    said_.resize(said_at_.size());
  }

  /// What is said of a cell; attributes are numbered as cells name them.
  const Attributes* said_of(const Cursor& cell, Index component) {
    if (!cell.has("attributes")) return nullptr;
    const Cursor at = cell.member("attributes");
    if (component == 0) at.refuse("nothing is said of a cell that is no part of the result");
    const Index number = at.number(said_at_.size(), "attributes");
    if (number > next_said_) {
      at.refuse("attributes are numbered as cells name them; " + std::to_string(next_said_) + " is next");
    }
    next_said_ = std::max(next_said_, number + 1);
    return said_at_[said_.name(number)];
  }

  void read_components() {
    const Rational of_group = dominance(root_, value_.group);
    if (value_.group) value_.dominances.push_back(of_group);
    if (root_.has("grades")) grades_.resize(root_.member("grades").array().size());
    made_grades_ = read_grades(
        root_, [&](const std::string& name, const Cursor& at) { require_material(name, at); },
        [&](Index inner) { grades_.name(inner); });
    each("components", [&](const Cursor& c) {
      c.only({"name", "called", "material", "leaves", "dominance", "grade", "properties"});
      value_.components.push_back(attributes(c));
      const Rational own = dominance(c, !value_.group);
      if (!value_.group) value_.dominances.push_back(own);
      ascending(c.member("leaves"), leaves_.size(), "leaf", [&](Index leaf) { leaves_.name(leaf); });
    });
    components_.resize(value_.components.size());
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
    points_.resize(points.size());
    ascending(root_.member("frame"), points.size(), "point", [&](Index p) { frame_[p] = 1; });
  }

  /// The entities of a group have the number after its last component.
  Index component_of(const Cursor& cell, bool is_region = false) {
    const std::size_t count = value_.components.size() + 1;
    const Index c = cell.member("component").number(count + (value_.group && !is_region), "component");
    if (c != 0 && c < count) components_.name(c - 1);
    read_origin(cell, c, is_region);
    return c;
  }

  void read_origin(const Cursor& cell, Index component, bool is_region) {
    if (!cell.has("origin")) return;
    const Cursor list = cell.member("origin").array();
    if (component == 0) list.refuse("a cell that is no part of the result came from no leaf");
    const bool is_vertex = cell.has("point"), is_edge = cell.has("closed");
    for (std::size_t i = 0, last = 0; i < list.size(); ++i) {
      const Cursor one = list.at(i).only({"leaf", "point", "edges", "faces", "regions"});
      const Index leaf = leaves_.name(one.member("leaf").number(leaves_.size(), "leaf"));
      if (i > 0 && leaf <= last) one.refuse("leaves are ascending here, and each stands once");
      last = leaf;
      const auto numbers = [&](const char* key, bool may_be, Index least) {
        if (!one.has(key)) return;
        const Cursor of = one.member(key).array();
        if (!may_be) of.refuse("what holds a cell is not of less dimension than it");
        if (of.size() == 0) of.refuse("what is empty is left out");
        ascending(of, kNone, "cell", [&](Index number) {
          if (number < least) of.refuse("regions of leaves count from 1");
        });
      };
      if (one.has("point") && (!one.member("point").boolean() || !is_vertex)) {
        one.member("point").refuse("only a vertex came from a point, and then it is true");
      }
      numbers("edges", is_vertex || is_edge, 0);
      numbers("faces", !is_region, 0);
      numbers("regions", true, 1);
    }
  }

  void read_regions() {
    bool unbounded = false;
    each("regions", [&](const Cursor& r) {
      r.only({"component", "name", "material", "bounded", "volume", "shells", "origin"});
      FlatComplex::Region& region = cells_.regions.emplace_back();
      region.component = component_of(r, true);
      region.bounded = r.member("bounded").boolean();
      const Attributes none, &own = region.component == 0 ? none : value_.components[region.component - 1];
      const auto same = [&](const char* key, const std::string& wanted) {
        if (r.member(key).text() != wanted) r.member(key).refuse("its component says \"" + wanted + "\"");
      };
      same("name", own.name);
      same("material", own.material.name());
      if (!region.bounded && unbounded) not_bounded(r, "what parts this region from another one");
      unbounded = unbounded || !region.bounded;
    });
  }

  void use(Index point, const Cursor& at, const char* what) {
    if (frame_[point]) not_bounded(at, what);
    points_.name(point);
  }

  Loop read_loop(const Cursor& list, std::size_t least) const {
    Loop loop;
    if (list.array().size() < least) {
      list.refuse("at least " + std::to_string(least) + " points are needed here");
    }
    for (std::size_t i = 0; i < list.size(); ++i) {
      loop.push_back(list.at(i).number(value_.points.size(), "point"));
      if (i > 0 && loop[i] == loop[i - 1]) list.at(i).refuse("the same point twice in a row");
    }
    return loop;
  }

  void read_vertices() {
    each("vertices", [&](const Cursor& v) {
      v.only({"point", "component", "entity", "feature", "region", "attributes", "origin"});
      const Index point = v.member("point").number(value_.points.size(), "point");
      use(point, v, "this vertex");
      FlatComplex::Vertex vertex;
      vertex.point = point;
      read_cell(v, vertex);
      if (!cells_.vertices.empty() && cells_.vertices.back().point >= point) {
        v.refuse("vertices are in the order of their points, and no two have the same");
      }
      vertex_at_.emplace_hint(vertex_at_.end(), point, Index(cells_.vertices.size()));
      cells_.vertices.push_back(std::move(vertex));
    });
  }
  template <class Cell>
  void read_cell(const Cursor& at, Cell& cell) {
    cell.component = component_of(at);
    cell.feature = at.member("feature").boolean();
    cell.origin.said = said_of(at, cell.component);
  }

  void read_edges() {
    each("edges", [&](const Cursor& e) {
      e.only({"points", "closed", "component", "entity", "feature", "wire", "region", "attributes", "origin"});
      FlatComplex::Edge edge;
      edge.closed = e.member("closed").boolean();
      edge.points = read_loop(e.member("points"), edge.closed ? 3 : 2);
      read_cell(e, edge);
      for (const Index p : edge.points) {
        use(p, e, "this edge");
        on_edge_[p] = 1;
      }
      for (const Index p : {edge.points.front(), edge.points.back()}) {
        if (edge.closed) break;
        const auto vertex = vertex_at_.find(p);
        if (vertex == vertex_at_.end()) e.refuse("no vertex at its end, point " + std::to_string(p));
        if (!value_.group || edge.component == 0 || cells_.vertices[vertex->second].component != 0) continue;
        not_closed(e, "its end, point " + std::to_string(p) + ", is missing");
      }
      for_each_segment(edge, [&](Index a, Index b) {
        if (!edge_at_.try_emplace(std::minmax(a, b), next_number(cells_.edges.size(), "edges")).second) {
          e.refuse("two edges between the same points");
        }
      });
      cells_.edges.push_back(std::move(edge));
    });
    for (FlatComplex::Vertex& vertex : cells_.vertices) vertex.free = !on_edge_[vertex.point];
  }

  void read_faces() {
    each("faces", [&](const Cursor& f) {
      f.only({"loops", "isolated", "component", "entity", "regions", "patch", "facets", "triangles", "cells",
              "attributes", "origin"});
      const Index number = next_number(cells_.faces.size(), "faces");
      FlatComplex::Face& face = cells_.faces.emplace_back();
      face.component = component_of(f);
      face.origin.said = said_of(f, face.component);
      const Cursor sides = f.member("regions").array_of(2, "two regions are needed here: in front and behind");
      for (std::size_t i = 0; i < 2; ++i) {
        if (sides.at(i).is_null()) not_bounded(f, "this face");
        face.regions[i] = sides.at(i).number(cells_.regions.size(), "region");
        if (value_.group && face.component == 0 && cells_.active(face.regions[i])) {
          not_closed(f, "this face of a region is missing");
        }
      }
      const Index patch = f.member("patch").number(kNone, "patch");
      if (patch > next_patch_) {
        f.member("patch").refuse("patches are numbered as faces name them; " + std::to_string(next_patch_) +
                                 " is next");
      }
      next_patch_ = std::max(next_patch_, patch + 1);
      face.patch = {LeafId(0), patch};
      const bool flat = !f.has("facets");
      face.loops = read_walks(f, flat);
      walk_boundary(f, face, number);
      face.isolated = read_isolated(f);
      if (flat) {
        require_area(f, face.loops);
      } else {
        const Cursor facets = f.member("facets").array();
        if (facets.size() == 0) facets.refuse("a face that is not flat has facets");
        for (std::size_t i = 0; i < facets.size(); ++i) face.facets.push_back(read_facet(facets.at(i)));
      }
      if (f.has("cells")) choose_cells(f.member("cells"), face);
    });
  }

  void read_patches() {
    if (root_.has("cells") != root_.has("patches")) {
      root_.refuse("`patches` and `cells` come together");
    }
    if (!root_.has("cells")) return;
    each("patches", [&](const Cursor& p) {
      p.only({"patch", "leaf", "name"});
      const Index patch = p.member("patch").number(kNone, "patch");
      if (!patch_numbers_.empty() && patch <= patch_numbers_.back()) p.refuse("patches are ascending");
      patch_numbers_.push_back(patch);
      leaves_.name(p.member("leaf").number(leaves_.size(), "leaf"));
      value_.patches[patch] = p.member("name").text();
    });
    each("cells", [&](const Cursor& c) {
      if (c.array().size() != 3 && c.size() != 4) c.refuse("a cell has three corners or four");
      auto& cell = cells_of_patches_.emplace_back();
      for (std::size_t i = 0; i < c.size(); ++i) {
        const Cursor corner = c.at(i).array_of(5, "x, y, z, u and v are needed here");
        const auto number = [&](std::size_t k) { return corner.at(k).rational(); };
        cell.push_back({{number(0), number(1), number(2)}, {number(3), number(4)}});
      }
      if (!is_cell(cell)) c.refuse("the corners of a cell lie in a plane and not on a line");
    });
    require_distinct_cells();
    patch_cells_.resize(cells_of_patches_.size());
    patches_.resize(patch_numbers_.size());
  }

  void require_distinct_cells() const {
    std::vector<std::size_t> order(cells_of_patches_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return cells_of_patches_[a] != cells_of_patches_[b] ? cells_of_patches_[a] < cells_of_patches_[b] : a < b;
    });
    for (std::size_t i = 1; i < order.size(); ++i) {
      if (cells_of_patches_[order[i]] != cells_of_patches_[order[i - 1]]) continue;
      root_.member("cells").at(order[i]).refuse("this cell stands twice, at " + std::to_string(order[i - 1]) +
                                                ", too");
    }
  }

  /// The cells of patches for the facets of a face.
  void choose_cells(const Cursor& lists, FlatComplex::Face& face) {
    if (face.component == 0) lists.refuse("a face that is no part of the result has no parameters");
    const Index number = face.patch->second;
    const auto patch = std::lower_bound(patch_numbers_.begin(), patch_numbers_.end(), number);
    if (patch == patch_numbers_.end() || *patch != number) lists.refuse("its patch is not among `patches`");
    patches_.name(Index(patch - patch_numbers_.begin()));
    lists.array_of(std::max<std::size_t>(face.facets.size(), 1), "one list for each facet is needed here");
    for (std::size_t i = 0; i < lists.size(); ++i) {
      const Cursor list = lists.at(i).array();
      if (list.size() == 0) list.refuse("a facet of a patch with parameters lies in a cell");
      auto& cells = face.cells.emplace_back();
      for (std::size_t k = 0; k < list.size(); ++k) {
        const Index cell = patch_cells_.name(list.at(k).number(patch_cells_.size(), "cell"));
        if (cell > next_cell_)
          list.at(k).refuse("cells are numbered as faces name them; cell " + std::to_string(next_cell_) +
                            " is next");
        next_cell_ = std::max(next_cell_, cell + 1);
        cells.push_back(cells_of_patches_[cell]);
        if (k > 0 && !(cells[k - 1] < cells[k])) {
          list.at(k).refuse("cells are in the order of their corners, and each stands once");
        }
      }
    }
  }

  FlatComplex::Facet read_facet(const Cursor& at) {
    at.only({"loops", "isolated"});
    FlatComplex::Facet facet{read_walks(at, true), {}};
    for (const Loop& walk : facet.loops) {
      for (const Index p : walk) use(p, at, "this face");
    }
    facet.isolated = read_isolated(at);
    require_area(at, facet.loops);
    return facet;
  }

  std::vector<Loop> read_walks(const Cursor& face, bool needed) const {
    const Cursor loops = face.member("loops").array();
    if (loops.size() == 0 && needed) loops.refuse("a face needs a loop");
    std::vector<Loop> walks;
    for (std::size_t i = 0; i < loops.size(); ++i) {
      walks.push_back(read_loop(loops.at(i), 2));
      if (walks.back().front() == walks.back().back())
        loops.at(i).refuse("a loop does not repeat its first point");
    }
    return walks;
  }

  /// Checks that each step of a face is along an edge of the file (an active one if the face is active in a
  /// group), and notes at the edges that it walks them.
  void walk_boundary(const Cursor& at, const FlatComplex::Face& face, Index number) {
    std::map<Index, std::pair<Index, Index>> first;  // edge -> the segment where the face walks it first
    for (const Loop& walk : face.loops) {
      for (std::size_t i = 0; i < walk.size(); ++i) {
        const Index a = walk[i], b = walk[(i + 1) % walk.size()];
        if (frame_[a]) not_bounded(at, "this face");
        const auto found = edge_at_.find(std::minmax(a, b));
        const auto between = [&] { return " points " + std::to_string(a) + " and " + std::to_string(b); };
        if (found == edge_at_.end()) at.refuse("no edge joins" + between());
        FlatComplex::Edge& edge = cells_.edges[found->second];
        if (value_.group && face.component != 0 && edge.component == 0) {
          not_closed(at, "its edge between" + between() + " is missing");
        }
        const auto [entry, fresh] = first.try_emplace(found->second, a, b);
        const auto& segment = entry->second;
        if (fresh) edge.around.push_back(2 * number);
        else if (std::minmax(a, b) == std::minmax(segment.first, segment.second)) edge.slit = true;
      }
    }
  }

  ShortList<Index, 2> read_isolated(const Cursor& at) const {
    ShortList<Index, 2> isolated;
    if (!at.has("isolated")) return isolated;
    const Cursor list = at.member("isolated").array();
    if (list.size() == 0) list.refuse("what is empty is left out");
    ascending(list, value_.points.size(), "point", [&](Index p) { isolated.push_back(p); });
    return isolated;
  }

  void require_area(const Cursor& at, const std::vector<Loop>& walks) const {
    const auto loops = without_slits(value_.points, walks);
    if (loops && loops->empty()) at.refuse("a face without area");
  }

  void require_all() const {
    points_.require_all(root_.member("points"), "no cell has this point");
    components_.require_all(root_.member("components"), "no cell is of this component");
    leaves_.require_all(root_.member("leaves"), "nothing came from this leaf");
    if (grades_.size() > 0) grades_.require_all(root_.member("grades"), "nothing has this grade");
    if (said_.size() > 0) said_.require_all(root_.member("attributes"), "no cell has these attributes");
    if (!root_.has("cells")) return;
    patch_cells_.require_all(root_.member("cells"), "no face lies in this cell");
    patches_.require_all(root_.member("patches"), "no face of this patch has parameters");
  }
};

}  // namespace

StoredValue read_value(const Cursor& root) { return Reader(root).read(); }

}  // namespace cnrg::result
