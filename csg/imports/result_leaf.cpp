// A result in .json as a leaf. Reading it has three parts: a cursor on the JSON document (json_cursor.h); the
// tables of the file with every number checked; and the leaf made from them. All cells of the file go to the soup,
// active or not; the cell table says which are active.
//
// Edges are wires where the faces alone would not give the same edge again:
//   * A face is handed to the soup without its slits (edges that it walks in both directions): loops of the soup
//     enclose by parity.
//   * A bent chain is one edge because it is one curve (kernel/selection/curve.h), and a wire is one.
//   * Two edges that meet in a corner of curved faces might become one curve: a wire along one of them parts them.
#include <algorithm>
#include <map>
#include <utility>

#include "csg/imports/json_cursor.h"
#include "csg/imports/read_grades.h"
#include "csg/leaves/cell_table.h"
#include "csg/leaves/parameters.h"
#include "csg/leaves/prepare_shapes.h"
#include "csg/text/input_file.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

using result::Cursor;
using result::Index;
using result::Json;
using result::kAgain;
using result::refuse;
using Loop = std::vector<Index>;

struct Facet {
  std::vector<Loop> loops;  ///< without slits, the outer one first, counter-clockwise seen from the front
  Index face = 0, patch = 0;
  Index front = 0, back = 0;                    ///< labels
  std::vector<std::vector<PatchCorner>> cells;  ///< of its patch, that it lies in
};

struct Edge {
  Loop points;  ///< a closed chain repeats its first point
  bool closed = false;
  Index uses = 0;       ///< how often faces walk it
  bool slit = false;    ///< one face walks it twice
  bool curved = false;  ///< on a face that is not flat
  bool wire = false;
};

struct Content {
  CellTable table;
  std::vector<Facet> facets;
  std::vector<Edge> edges;
  std::vector<Index> isolated;
  std::vector<LeafRegion> components;
  std::map<Index, std::string> patches;  ///< names of those with parameters
};

RationalPoint minus(const RationalPoint& a, const RationalPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Rational dot(const RationalPoint& a, const RationalPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

bool collinear(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
  const RationalPoint u = minus(b, a), v = minus(c, b);
  return u[1] * v[2] == u[2] * v[1] && u[2] * v[0] == u[0] * v[2] && u[0] * v[1] == u[1] * v[0];
}

/// Twice the vector area of a loop: along the normal of the side from which it is counter-clockwise.
RationalPoint area(const std::vector<RationalPoint>& points, const Loop& loop) {
  RationalPoint sum{0, 0, 0};
  const RationalPoint& o = points[loop[0]];
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    const RationalPoint a = minus(points[loop[i]], o), b = minus(points[loop[i + 1]], o);
    for (int k = 0; k < 3; ++k) {
      sum[k] += a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
    }
  }
  return sum;
}

/// Splits a walk at edges that it walks in both directions: they nest like parentheses, since the face is
/// planar, and each closed part between them is a loop of its own.
void split_at_slits(const Loop& walk, std::vector<Loop>& loops) {
  using Step = std::pair<Index, Index>;
  const std::size_t n = walk.size();
  std::map<Step, int> steps;
  for (std::size_t i = 0; i < n; ++i) ++steps[{walk[i], walk[(i + 1) % n]}];
  std::vector<std::pair<Step, Loop>> open{{Step{}, {}}};
  for (std::size_t i = 0; i < n; ++i) {
    const Step step{walk[i], walk[(i + 1) % n]};
    if (!steps.contains({step.second, step.first})) {
      open.back().second.push_back(step.first);
    } else if (open.size() > 1 && open.back().first == Step{step.second, step.first}) {
      if (open.back().second.size() >= 3) loops.push_back(std::move(open.back().second));
      open.pop_back();
    } else {
      open.push_back({step, {}});
    }
  }
  for (auto& [step, loop] : open) {
    if (loop.size() >= 3) loops.push_back(std::move(loop));
  }
}

class Reader {
 public:
  Reader(const std::string& file, const Json& document) : file_(file), root_(file, document) {}

  Content read() {
    if (!root_.has("format") || root_.member("format").text() != "cnrg result") {
      root_.fail("this is no result of cnrg: `\"format\": \"cnrg result\"` is missing" + std::string(kAgain));
    }
    if (root_.member("version").number(1u << 30, "version") != 1) {
      root_.member("version").fail("only version 1 can be read; use a newer cnrg");
    }
    table_.group = root_.member("group").boolean();
    read_points();
    read_components();
    read_regions();
    read_vertices();
    read_edges();
    if (root_.has("cells")) read_cells();
    read_faces();
    choose_wires();
    require_all_points();
    return std::move(content_);
  }

 private:
  const std::string& file_;
  Cursor root_;
  Content content_;
  CellTable& table_ = content_.table;
  std::vector<Edge>& edges_ = content_.edges;
  std::vector<char> frame_, used_;               // by point
  std::vector<Index> labels_;                    // by region; 0: unbounded
  std::vector<std::vector<PatchCorner>> cells_;  // of patches

  template <class F>
  void each(const char* key, F f) {
    const Cursor list = root_.member(key).array();
    for (std::size_t i = 0; i < list.size(); ++i) f(list.at(i));
  }

  [[noreturn]] void not_closed(const Cursor& at, const std::string& what) const {
    at.fail(what + ", but the file says that it is a group, which is closed" + kAgain);
  }
  [[noreturn]] void not_bounded(const Cursor& at, const std::string& what) const {
    at.fail(what +
            " has no bounds, and those of a leaf must have some; cut the node with a box before it is "
            "written (`intersection`, or `product` where it is not closed), or read its operands back and apply "
            "the operator in the tree");
  }

  void read_points() {
    auto& points = table_.points;
    each("points", [&](const Cursor& p) {
      points.push_back(p.point());
      if (points.size() > 1 && !(points[points.size() - 2] < points.back())) {
        p.fail(std::string("points are sorted by their coordinates, and no two are equal") + kAgain);
      }
    });
    frame_.assign(points.size(), 0);
    used_.assign(points.size(), 0);
    each("frame", [&](const Cursor& p) { frame_[p.number(frame_.size(), "point")] = 1; });
  }

  void read_components() {
    if (table_.group) table_.dominances.push_back(root_.member("dominance").rational());
    const auto grades = result::read_grades(root_);
    each("components", [&](const Cursor& c) {
      RegionMaterial material(c.member("material").text());
      if (c.has("grade")) material = {material.name(), grades[c.member("grade").number(grades.size(), "grade")]};
      content_.components.push_back({c.member("name").text(), std::move(material)});
      if (!table_.group) table_.dominances.push_back(c.member("dominance").rational());
    });
  }
  /// The entities of a group have the number after its last component.
  Index component_of(const Cursor& cell) const {
    return cell.member("component").number(content_.components.size() + 1 + table_.group, "component");
  }

  void read_regions() {
    table_.regions.assign(1, 0);
    bool unbounded = false;
    each("regions", [&](const Cursor& r) {
      const Index component = component_of(r);
      table_.regions.push_back(component);
      if (r.member("bounded").boolean()) {
        labels_.push_back(Index(table_.regions.size() - 1));
        return;
      }
      if (unbounded) not_bounded(r, "what parts this region from another one");
      unbounded = true;
      labels_.push_back(0);
      table_.regions[0] = component;
    });
  }

  void use(Index point, const Cursor& at, const char* what) {
    if (frame_[point]) not_bounded(at, what);
    used_[point] = 1;
  }

  Loop read_loop(const Cursor& list, std::size_t least) const {
    Loop loop;
    if (list.array().size() < least) {
      list.fail("at least " + std::to_string(least) + " points are needed here" + kAgain);
    }
    for (std::size_t i = 0; i < list.size(); ++i) {
      loop.push_back(list.at(i).number(table_.points.size(), "point"));
      if (i > 0 && loop[i] == loop[i - 1]) list.at(i).fail(std::string("the same point twice in a row") + kAgain);
    }
    return loop;
  }

  void read_vertices() {
    each("vertices", [&](const Cursor& v) {
      const Index point = v.member("point").number(table_.points.size(), "point");
      use(point, v, "this vertex");
      const CellTable::Cell cell{component_of(v), v.member("feature").boolean()};
      if (!table_.vertices.try_emplace(point, cell).second) {
        v.fail(std::string("two vertices at one point") + kAgain);
      }
    });
  }

  void read_edges() {
    each("edges", [&](const Cursor& e) {
      Edge edge;
      edge.closed = e.member("closed").boolean();
      edge.points = read_loop(e.member("points"), edge.closed ? 3 : 2);
      const CellTable::Cell cell{component_of(e), e.member("feature").boolean()};
      for (const Index p : edge.points) use(p, e, "this edge");
      if (edge.closed) {
        edge.points.push_back(edge.points[0]);
      } else {
        for (const Index p : {edge.points.front(), edge.points.back()}) {
          const auto vertex = table_.vertices.find(p);
          if (vertex == table_.vertices.end()) e.fail("no vertex at its end, point " + std::to_string(p) + kAgain);
          if (!table_.group || cell.component == 0 || vertex->second.component != 0) continue;
          not_closed(e, "its end, point " + std::to_string(p) + ", is missing");
        }
      }
      for (std::size_t i = 1; i < edge.points.size(); ++i) {
        const auto segment = std::minmax(edge.points[i - 1], edge.points[i]);
        if (!table_.segments.try_emplace(segment, Index(edges_.size())).second) {
          e.fail(std::string("two edges between the same points") + kAgain);
        }
      }
      table_.edges.push_back(cell);
      edges_.push_back(std::move(edge));
    });
  }

  void read_faces() {
    each("faces", [&](const Cursor& f) {
      const Index component = component_of(f);
      const Cursor sides = f.member("regions");
      if (sides.array().size() != 2) {
        sides.fail(std::string("two regions are needed here: in front and behind") + kAgain);
      }
      std::array<Index, 2> labels{};
      for (std::size_t i = 0; i < 2; ++i) {
        if (sides.at(i).is_null()) not_bounded(f, "this face");
        labels[i] = labels_[sides.at(i).number(labels_.size(), "region")];
        if (table_.group && component == 0 && table_.regions[labels[i]] != 0) {
          not_closed(f, "this face of a region is missing");
        }
      }
      Facet facet;
      facet.face = Index(table_.faces.size());
      facet.patch = f.member("patch").number(1u << 31, "patch");
      facet.front = labels[0];
      facet.back = labels[1];
      table_.faces.push_back(component);
      const std::vector<Loop> walks = read_walks(f);
      const bool flat = !f.has("facets");
      walk_boundary(f, walks, component, flat);
      const std::size_t first = content_.facets.size();
      if (flat) {
        add_facet(f, walks, facet);
      } else {
        const Cursor facets = f.member("facets").array();
        for (std::size_t i = 0; i < facets.size(); ++i) add_curved(facets.at(i), facet);
      }
      if (f.has("cells")) choose_cells(f.member("cells"), first);
    });
  }

  void read_cells() {
    each("patches", [&](const Cursor& p) {
      content_.patches[p.member("patch").number(1u << 31, "patch")] = p.member("name").text();
    });
    each("cells", [&](const Cursor& c) {
      if (c.array().size() != 3 && c.size() != 4) c.fail(std::string("a cell has three corners or four") + kAgain);
      auto& cell = cells_.emplace_back();
      for (std::size_t i = 0; i < c.size(); ++i) {
        const Cursor corner = c.at(i).array();
        if (corner.size() != 5) corner.fail(std::string("x, y, z, u and v are needed here") + kAgain);
        const auto number = [&](std::size_t k) { return corner.at(k).rational(); };
        cell.push_back({{number(0), number(1), number(2)}, {number(3), number(4)}});
      }
      if (!is_cell(cell)) c.fail(std::string("the corners of a cell lie in a plane and not on a line") + kAgain);
    });
  }

  /// The cells of patches for the facets of a face, which are those from number `first` on.
  void choose_cells(const Cursor& lists, std::size_t first) {
    if (lists.array().size() != content_.facets.size() - first) {
      lists.fail(std::string("one list for each facet is needed here") + kAgain);
    }
    for (std::size_t i = 0; i < lists.size(); ++i) {
      const Cursor list = lists.at(i).array();
      for (std::size_t k = 0; k < list.size(); ++k) {
        content_.facets[first + i].cells.push_back(cells_[list.at(k).number(cells_.size(), "cell")]);
      }
    }
  }

  void add_curved(const Cursor& at, const Facet& facet) {
    const std::vector<Loop> walks = read_walks(at);
    for (const Loop& walk : walks) {
      for (const Index p : walk) use(p, at, "this face");
    }
    add_facet(at, walks, facet);
  }

  std::vector<Loop> read_walks(const Cursor& face) const {
    const Cursor loops = face.member("loops");
    if (loops.array().size() == 0 && !face.has("facets")) loops.fail(std::string("a face needs a loop") + kAgain);
    std::vector<Loop> walks;
    for (std::size_t i = 0; i < loops.size(); ++i) walks.push_back(read_loop(loops.at(i), 2));
    return walks;
  }

  /// Checks that each step of a face is along an edge of the file (an active one if the face is active in a
  /// group), and counts how often faces use each edge.
  void walk_boundary(const Cursor& face, const std::vector<Loop>& walks, Index component, bool flat) {
    std::map<Index, std::pair<Index, Index>> first;  // edge -> the segment where the face walks it first
    for (const Loop& walk : walks) {
      for (std::size_t i = 0; i < walk.size(); ++i) {
        const Index a = walk[i], b = walk[(i + 1) % walk.size()];
        if (frame_[a]) not_bounded(face, "this face");
        const auto found = table_.segments.find(std::minmax(a, b));
        const auto between = [&] { return " points " + std::to_string(a) + " and " + std::to_string(b); };
        if (found == table_.segments.end()) face.fail("no edge joins" + between() + kAgain);
        Edge& edge = edges_[found->second];
        if (table_.group && component != 0 && table_.edges[found->second].component == 0) {
          not_closed(face, "its edge between" + between() + " is missing");
        }
        const auto [entry, fresh] = first.try_emplace(found->second, a, b);
        const auto& segment = entry->second;
        if (!fresh && std::minmax(a, b) == std::minmax(segment.first, segment.second)) edge.slit = true;
        if (fresh || edge.slit) ++edge.uses;
        edge.curved = edge.curved || !flat;
      }
    }
  }

  void add_facet(const Cursor& at, const std::vector<Loop>& walks, Facet facet) {
    RationalPoint normal{0, 0, 0};
    for (const Loop& walk : walks) {
      const RationalPoint part = area(table_.points, walk);
      for (int k = 0; k < 3; ++k) normal[k] += part[k];
      split_at_slits(walk, facet.loops);
    }
    if (sgn(dot(normal, normal)) == 0 || facet.loops.empty()) at.fail(std::string("a face without area") + kAgain);
    const RationalPoint& origin = table_.points[facet.loops[0][0]];
    for (const Loop& loop : facet.loops) {
      for (const Index p : loop) {
        if (sgn(dot(normal, minus(table_.points[p], origin))) != 0) {
          at.fail("point " + std::to_string(p) + " is not in the plane of the face" + kAgain);
        }
      }
    }
    std::size_t outer = 0;
    Rational most = 0;
    for (std::size_t i = 0; i < facet.loops.size(); ++i) {
      const Rational extent = dot(normal, area(table_.points, facet.loops[i]));
      if (extent > most) {
        most = extent;
        outer = i;
      }
    }
    std::swap(facet.loops[0], facet.loops[outer]);
    content_.facets.push_back(std::move(facet));
  }

  bool straight(Index a, Index b, Index c) const {
    return collinear(table_.points[a], table_.points[b], table_.points[c]);
  }
  bool bent(const Edge& edge) const {
    const Loop& p = edge.points;
    for (std::size_t i = 1; i + 1 < p.size(); ++i) {
      if (!straight(p[i - 1], p[i], p[i + 1])) return true;
    }
    return edge.closed;
  }

  void choose_wires() {
    std::map<Index, std::vector<std::pair<Index, Index>>> ends;  // point -> edges that end there, next point
    std::vector<char> on_edge(table_.points.size(), 0);
    for (Index i = 0; i < edges_.size(); ++i) {
      Edge& edge = edges_[i];
      const Loop& p = edge.points;
      for (const Index point : p) on_edge[point] = 1;
      edge.wire = edge.uses == 0 || edge.slit || bent(edge);
      if (edge.closed) continue;
      ends[p.front()].emplace_back(i, p[1]);
      ends[p.back()].emplace_back(i, p[p.size() - 2]);
    }
    for (const auto& [point, list] : ends) {
      if (list.size() != 2 || straight(list[0].second, point, list[1].second)) continue;
      Edge &a = edges_[list[0].first], &b = edges_[list[1].first];
      a.wire = a.wire || (a.curved && b.curved);
    }
    for (const auto& [point, vertex] : table_.vertices) {
      if (!on_edge[point]) content_.isolated.push_back(point);
    }
  }

  void require_all_points() const {
    const auto idle = std::find(used_.begin(), used_.end(), 0);
    if (idle == used_.end()) return;
    const auto point = std::size_t(idle - used_.begin());
    root_.member("points").at(point).fail(std::string("no cell has this point") + kAgain);
  }
};

class ResultLeaf : public PreparedLeaf {
 public:
  explicit ResultLeaf(Content content) : content_(std::move(content)) {
    if (content_.patches.empty()) return;
    set_parameters([made = parameters_of(content_)] { return made; });
  }

  LeafId add_to(Soup& soup, const Transform& transform) const override {
    const LeafId leaf = soup.add_leaf(Fill::sides);
    const bool mirrored = sgn(transform.determinant()) < 0;
    std::vector<PointId> ids(content_.table.points.size());
    const auto id = [&](Index p) {
      if (!ids[p].valid()) ids[p] = soup.add_point(transform.apply(content_.table.points[p]));
      return ids[p];
    };
    std::vector<std::vector<PointId>> loops;
    for (const Facet& facet : content_.facets) {
      loops.clear();
      for (const Loop& loop : facet.loops) {
        auto& ring = loops.emplace_back();
        for (const Index p : loop) ring.push_back(id(p));
        if (mirrored) std::reverse(ring.begin(), ring.end());
      }
      soup.add_face(leaf, loops, facet.face, facet.patch, facet.front, facet.back);
    }
    for (Index number = 0; number < content_.edges.size(); ++number) {
      const Edge& edge = content_.edges[number];
      if (!edge.wire) continue;
      const Loop& p = edge.points;
      for (std::size_t i = 1; i < p.size(); ++i) soup.add_wire(leaf, id(p[i - 1]), id(p[i]), number);
    }
    for (const Index p : content_.isolated) soup.add_isolated(leaf, id(p));
    return leaf;
  }
  std::vector<LeafRegion> regions() const override { return content_.components; }
  const CellTable* cells() const override { return &content_.table; }

 private:
  /// Faces and wires as `add_to` adds them; curves have no parameters in files.
  static std::shared_ptr<const LeafParameters> parameters_of(Content& content) {
    auto parameters = std::make_shared<LeafParameters>();
    for (const auto& [patch, name] : content.patches) parameters->name_patch(patch, name);
    for (Facet& facet : content.facets) parameters->add_facet(std::exchange(facet.cells, {}));
    for (const Edge& edge : content.edges) {
      if (!edge.wire) continue;
      const auto& points = content.table.points;
      for (std::size_t i = 1; i < edge.points.size(); ++i) {
        parameters->add_wire({{points[edge.points[i - 1]], points[edge.points[i]]}, {0, 0}});
      }
    }
    return parameters;
  }

  Content content_;
};

/// Where in the text a byte is, as `line:column`.
std::string position(const std::string& text, std::size_t byte) {
  byte = std::min(byte == 0 ? 0 : byte - 1, text.size());
  const auto end = text.begin() + std::ptrdiff_t(byte);
  const auto line = 1 + std::count(text.begin(), end, '\n');
  const std::size_t start = byte == 0 ? std::string::npos : text.rfind('\n', byte - 1);
  return std::to_string(line) + ":" + std::to_string(start == std::string::npos ? byte + 1 : byte - start);
}

}  // namespace

std::unique_ptr<PreparedLeaf> prepare_result(const ResultShape& shape) {
  const std::string text = read_file(shape.file, shape.inside);
  Json document;
  try {
    document = Json::parse(text);
  } catch (const Json::parse_error& error) {
    throw LeafFileError(shape.file + ":" + position(text, error.byte) +
                        ": error: this is no JSON text from here on; is the file cut short?" + kAgain);
  } catch (const Json::exception&) {
    throw LeafFileError(shape.file + ":1:1: error: a number in this file is beyond the range of double" + kAgain);
  }
  return std::make_unique<ResultLeaf>(Reader(shape.file, document).read());
}

}  // namespace cnrg
