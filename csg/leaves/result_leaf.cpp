// Reading has three parts: a cursor on the JSON document that knows its path, so that each fault names its
// place; the tables of the file with every number checked; and the leaf made from them. A face is handed to
// the soup without its slits, which are wires of their own: loops of the soup enclose by parity.
#include "csg/leaves/result_leaf.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "csg/leaves/mesh_file.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

using Json = nlohmann::json;
using Index = std::uint32_t;
using Loop = std::vector<Index>;

[[noreturn]] void refuse(const std::string& file, const std::string& path, const std::string& what) {
  throw LeafFileError(file + ": error: " + (path.empty() ? "" : path + ": ") + what);
}
constexpr const char* kAgain = "; write the file again with `cnrg eval -o`";

/// A value of the document and the way to it.
class Cursor {
 public:
  Cursor(const std::string& file, const Json& value, std::string path = "")
      : file_(&file), value_(&value), path_(std::move(path)) {}

  [[noreturn]] void fail(const std::string& what) const { refuse(*file_, path_, what); }
  const std::string& path() const { return path_; }
  bool is_null() const { return value_->is_null(); }
  std::size_t size() const { return value_->size(); }

  Cursor member(const char* key) const {
    if (!value_->is_object()) fail(std::string("an object is needed here") + kAgain);
    const auto found = value_->find(key);
    if (found == value_->end()) fail("`" + std::string(key) + "` is missing" + kAgain);
    return {*file_, *found, path_ + "/" + key};
  }
  bool has(const char* key) const { return value_->is_object() && value_->contains(key); }
  Cursor at(std::size_t i) const { return {*file_, (*value_)[i], path_ + "/" + std::to_string(i)}; }
  /// The value must be an array.
  const Cursor& array() const {
    if (!value_->is_array()) fail(std::string("a list is needed here") + kAgain);
    return *this;
  }
  /// A whole number below `limit`; `what` it counts.
  Index number(std::size_t limit, const char* what) const {
    if (!value_->is_number_unsigned()) fail(std::string("the number of a ") + what + " is needed here" + kAgain);
    const auto n = value_->get<std::uint64_t>();
    if (n >= limit) {
      fail(std::string(what) + " " + std::to_string(n) + " does not exist: there are " + std::to_string(limit) +
           kAgain);
    }
    return Index(n);
  }
  bool boolean() const {
    if (!value_->is_boolean()) fail(std::string("true or false is needed here") + kAgain);
    return value_->get<bool>();
  }
  std::string text() const {
    if (!value_->is_string()) fail(std::string("a text is needed here") + kAgain);
    return value_->get<std::string>();
  }
  Rational rational() const {
    if (value_->is_number_integer()) return *parse_rational(value_->dump());
    if (value_->is_string()) {
      if (auto number = parse_rational(value_->get_ref<const std::string&>())) return *number;
    }
    fail("an exact number is needed here, such as \"3\", \"0.25\" or \"121/3\"");
  }

 private:
  const std::string* file_;
  const Json* value_;
  std::string path_;
};

struct Facet {
  std::vector<Loop> loops;     ///< without slits, the outer one first, counter-clockwise seen from the front
  Index surface = 0, patch = 0;
  Index front = 0, back = 0;
};

struct Edge {
  Loop points;                 ///< a closed chain repeats its first point
  Index component = 0;
  bool entity = false, feature = false;
  Index uses = 0;              ///< how often faces walk it
  bool slit = false;           ///< one face walks it twice
  Index surface = 0, patch = 0;  ///< of the first face
  bool parts = false;          ///< another face is of another surface and patch
  /// True if the faces alone make it a feature: a free border, a border between two faces, or one of many.
  bool implied() const { return uses != 0 && !slit && (uses != 2 || parts); }
};

struct Content {
  std::vector<RationalPoint> points;
  std::vector<Facet> facets;
  std::vector<Loop> wires;
  std::vector<Index> isolated;
  std::vector<LeafRegion> regions;
};

RationalPoint minus(const RationalPoint& a, const RationalPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Rational dot(const RationalPoint& a, const RationalPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

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
    read_points();
    read_regions();
    read_vertices();
    read_edges();
    read_faces();
    make_wires();
    return std::move(content_);
  }

 private:
  const std::string& file_;
  Cursor root_;
  Content content_;
  std::vector<char> frame_;                      // by point
  std::vector<Index> region_component_;
  std::vector<Edge> edges_;
  std::map<std::pair<Index, Index>, Index> edge_at_;  // by segment, smaller point first
  struct Vertex {
    Index component = 0;
    bool entity = false, feature = false;
  };
  std::map<Index, Vertex> vertices_;             // by point

  template <class F>
  void each(const char* key, F f) {
    const Cursor list = root_.member(key).array();
    for (std::size_t i = 0; i < list.size(); ++i) f(list.at(i));
  }

  [[noreturn]] void not_closed(const Cursor& at, const std::string& what) const {
    at.fail(what + ": the result is not closed and so can not be a leaf; write `closure` of the node, or read its "
            "operands back and apply the operator in the tree");
  }
  [[noreturn]] void not_bounded(const Cursor& at, const std::string& what) const {
    at.fail(what + " has no bounds, and a leaf must have some; intersect the node with a box before it is "
            "written, or read its operands back and apply the operator in the tree");
  }

  void read_points() {
    each("points", [&](const Cursor& p) {
      if (p.array().size() != 3) p.fail(std::string("a point has three coordinates") + kAgain);
      content_.points.push_back({p.at(0).rational(), p.at(1).rational(), p.at(2).rational()});
    });
    frame_.assign(content_.points.size(), 0);
    each("frame", [&](const Cursor& p) { frame_[p.number(frame_.size(), "point")] = 1; });
  }

  void read_regions() {
    Index most = 0;
    each("regions", [&](const Cursor& r) {
      const Index component = r.member("component").number(1u << 31, "component");
      if (component != 0 && !r.member("bounded").boolean()) not_bounded(r, "this region");
      region_component_.push_back(component);
      most = std::max(most, component);
    });
    if (most > 2 * region_component_.size() + root_.member("components").array().size()) {
      root_.member("regions").fail(std::string("a component number is too large") + kAgain);
    }
    content_.regions.resize(most);
    const Cursor components = root_.member("components");
    for (std::size_t i = 0; i < std::min<std::size_t>(most, components.size()); ++i) {
      content_.regions[i] = {components.at(i).member("name").text(), components.at(i).member("material").text()};
    }
  }

  Loop read_loop(const Cursor& list, std::size_t least) const {
    Loop loop;
    if (list.array().size() < least) {
      list.fail("at least " + std::to_string(least) + " points are needed here" + kAgain);
    }
    for (std::size_t i = 0; i < list.size(); ++i) {
      loop.push_back(list.at(i).number(content_.points.size(), "point"));
      if (i > 0 && loop[i] == loop[i - 1]) list.at(i).fail(std::string("the same point twice in a row") + kAgain);
    }
    return loop;
  }

  void read_vertices() {
    each("vertices", [&](const Cursor& v) {
      const Index point = v.member("point").number(content_.points.size(), "point");
      if (!vertices_.try_emplace(point, Vertex{component_of(v), v.member("entity").boolean(),
                                               v.member("feature").boolean()}).second) {
        v.fail(std::string("two vertices at one point") + kAgain);
      }
    });
  }
  static Index component_of(const Cursor& cell) { return cell.member("component").number(1u << 31, "component"); }

  void read_edges() {
    each("edges", [&](const Cursor& e) {
      Edge edge;
      const bool closed = e.member("closed").boolean();
      edge.points = read_loop(e.member("points"), closed ? 3 : 2);
      edge.component = component_of(e);
      edge.entity = e.member("entity").boolean();
      edge.feature = e.member("feature").boolean();
      if (closed) edge.points.push_back(edge.points[0]);
      if (edge.component != 0) {
        for (const Index p : edge.points) {
          if (frame_[p]) not_bounded(e, "this edge");
        }
        if (!closed) {
          for (const Index p : {edge.points.front(), edge.points.back()}) {
            const auto vertex = vertices_.find(p);
            if (vertex == vertices_.end()) e.fail("no vertex at its end, point " + std::to_string(p) + kAgain);
            if (vertex->second.component != 0) continue;
            not_closed(e, "its end, point " + std::to_string(p) + ", is missing");
          }
        }
      }
      for (std::size_t i = 1; i < edge.points.size(); ++i) {
        if (!edge_at_.try_emplace(std::minmax(edge.points[i - 1], edge.points[i]), Index(edges_.size())).second) {
          e.fail(std::string("two edges between the same points") + kAgain);
        }
      }
      edges_.push_back(std::move(edge));
    });
  }

  void read_faces() {
    Index next = 0;
    each("faces", [&](const Cursor& f) {
      const Index number = next++;
      const Index component = component_of(f);
      const bool entity = f.member("entity").boolean();
      const Cursor sides = f.member("regions");
      if (sides.array().size() != 2) {
        sides.fail(std::string("two regions are needed here: in front and behind") + kAgain);
      }
      std::array<Index, 2> labels{};
      for (std::size_t i = 0; i < 2; ++i) {
        if (!sides.at(i).is_null()) {
          labels[i] = region_component_[sides.at(i).number(region_component_.size(), "region")];
        }
      }
      if (component == 0 && (labels[0] != 0 || labels[1] != 0)) {
        not_closed(f, "this face of a region is missing");
      }
      Facet facet;
      facet.front = labels[0];
      facet.back = labels[1];
      facet.patch = f.has("patch") ? f.member("patch").number(1u << 31, "patch") : number;
      facet.surface = f.has("surface") ? f.member("surface").number(1u << 31, "surface") : number;
      const std::vector<Loop> walks = read_walks(f);
      if (component == 0) return;
      check_boundary(f, walks, entity ? &facet : nullptr);
      if (!entity) return;
      if (!f.has("facets")) {
        add_facet(f, walks, facet);
        return;
      }
      const Cursor facets = f.member("facets").array();
      for (std::size_t i = 0; i < facets.size(); ++i) add_facet(facets.at(i), read_walks(facets.at(i)), facet);
    });
  }

  std::vector<Loop> read_walks(const Cursor& face) const {
    const Cursor loops = face.member("loops");
    if (loops.array().size() == 0 && !face.has("facets")) loops.fail(std::string("a face needs a loop") + kAgain);
    std::vector<Loop> walks;
    for (std::size_t i = 0; i < loops.size(); ++i) walks.push_back(read_loop(loops.at(i), 2));
    return walks;
  }

  /// The edges of a face must be there and be active; `entity` (or null) is told to them.
  void check_boundary(const Cursor& face, const std::vector<Loop>& walks, const Facet* entity) {
    std::map<Index, std::pair<Index, Index>> first;  // edge -> the segment where the face walks it first
    for (const Loop& walk : walks) {
      for (std::size_t i = 0; i < walk.size(); ++i) {
        const Index a = walk[i], b = walk[(i + 1) % walk.size()];
        if (frame_[a]) not_bounded(face, "this face");
        const auto found = edge_at_.find(std::minmax(a, b));
        const auto between = [&] { return " points " + std::to_string(a) + " and " + std::to_string(b); };
        if (found == edge_at_.end()) face.fail("no edge joins" + between() + kAgain);
        Edge& edge = edges_[found->second];
        if (edge.component == 0) not_closed(face, "its edge between" + between() + " is missing");
        const auto [entry, fresh] = first.try_emplace(found->second, a, b);
        const auto& segment = entry->second;
        if (!fresh && std::minmax(a, b) == std::minmax(segment.first, segment.second)) edge.slit = true;
        if (entity != nullptr && (fresh || edge.slit)) use(edge, *entity);
      }
    }
  }

  static void use(Edge& edge, const Facet& face) {
    if (edge.uses++ == 0) {
      edge.surface = face.surface;
      edge.patch = face.patch;
    } else if (edge.surface != face.surface && edge.patch != face.patch) {
      edge.parts = true;
    }
  }

  void add_facet(const Cursor& at, const std::vector<Loop>& walks, Facet facet) {
    RationalPoint normal{0, 0, 0};
    for (const Loop& walk : walks) {
      const RationalPoint part = area(content_.points, walk);
      for (int k = 0; k < 3; ++k) normal[k] += part[k];
      split_at_slits(walk, facet.loops);
    }
    if (sgn(dot(normal, normal)) == 0 || facet.loops.empty()) at.fail(std::string("a face without area") + kAgain);
    const RationalPoint& origin = content_.points[facet.loops[0][0]];
    for (const Loop& loop : facet.loops) {
      for (const Index p : loop) {
        if (sgn(dot(normal, minus(content_.points[p], origin))) != 0) {
          at.fail("point " + std::to_string(p) + " is not in the plane of the face" + kAgain);
        }
      }
    }
    std::size_t outer = 0;
    Rational most = 0;
    for (std::size_t i = 0; i < facet.loops.size(); ++i) {
      const Rational extent = dot(normal, area(content_.points, facet.loops[i]));
      if (extent > most) {
        most = extent;
        outer = i;
      }
    }
    std::swap(facet.loops[0], facet.loops[outer]);
    content_.facets.push_back(std::move(facet));
  }

  void make_wires() {
    std::vector<Index> at(content_.points.size(), 0), features(content_.points.size(), 0);  // edges at a point
    std::map<Index, Index> facets_of;  // by patch
    for (const Facet& facet : content_.facets) ++facets_of[facet.patch];
    for (Edge& edge : edges_) {
      for (const Index p : edge.points) ++at[p];
      for (const Index p : {edge.points.front(), edge.points.back()}) features[p] += edge.feature;
      // The bent rim of a flat face is one curve that no curved patch beside it tells of: a wire does.
      const bool rim = edge.uses == 1 && edge.points.size() > 2 && facets_of[edge.patch] == 1;
      if (edge.entity && (edge.uses == 0 || edge.slit || rim || (edge.feature && !edge.implied()))) {
        content_.wires.push_back(std::move(edge.points));
      }
    }
    // Where one feature edge ends, or three or more meet, their vertex is a feature without being told.
    for (const auto& [point, vertex] : vertices_) {
      const bool implied = features[point] == 1 || features[point] > 2;
      if (vertex.entity && (at[point] == 0 || (vertex.feature && !implied))) content_.isolated.push_back(point);
    }
  }
};

class ResultLeaf : public PreparedLeaf {
 public:
  explicit ResultLeaf(Content content) : content_(std::move(content)) {}

  LeafId add_to(Soup& soup, const Transform& transform) const override {
    const LeafId leaf = soup.add_leaf(Fill::sides);
    const bool mirrored = sgn(transform.determinant()) < 0;
    std::vector<PointId> ids(content_.points.size());
    const auto id = [&](Index p) {
      if (!ids[p].valid()) ids[p] = soup.add_point(transform.apply(content_.points[p]));
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
      soup.add_face(leaf, loops, facet.surface, facet.patch, facet.front, facet.back);
    }
    Index number = 0;
    for (const Loop& wire : content_.wires) {
      for (std::size_t i = 1; i < wire.size(); ++i) soup.add_wire(leaf, id(wire[i - 1]), id(wire[i]), number);
      ++number;
    }
    for (const Index p : content_.isolated) soup.add_isolated(leaf, id(p));
    return leaf;
  }
  std::vector<LeafRegion> regions() const override { return content_.regions; }

 private:
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
  const std::string text = read_file(shape.file);
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
