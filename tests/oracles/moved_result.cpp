#include "tests/oracles/moved_result.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <memory>
#include <set>
#include <sstream>

#include "csg/formats/result_file.h"
#include "csg/result/flat.h"
#include "csg/result/result_data.h"
#include "kernel/exact/distance.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg::properties {
namespace {

using Index = FlatComplex::Index;
using Vector = std::array<double, 3>;

std::string attributes_text(const Attributes& a) {
  std::string out = a.name.text() + " | " + a.material.name();
  for (const auto& [key, value] : a.properties) out += " | " + key + " = " + to_text(value);
  return out;
}

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot_of(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross_of(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double length(const Vector& a) { return std::sqrt(dot_of(a, a)); }

/// A result with its points, exactly and rounded.
struct ShapeOfResult {
  ResultView view;
  FlatComplex flat;
  std::vector<RationalPoint> points;
  std::vector<Vector> xyz;
  const Result& result;

  explicit ShapeOfResult(const Result& of) : view(of.data().view()), flat(flatten(view)), result(of) {
    for (const VertexId v : flat.points) {
      points.push_back(view.complex->points.rational(v));
      xyz.push_back(to_doubles(points.back()));
    }
  }
  double area(const FlatComplex::Triangle& t) const {
    return length(cross_of(minus(xyz[t[1]], xyz[t[0]]), minus(xyz[t[2]], xyz[t[0]]))) / 2;
  }
  double rim(const FlatComplex::Triangle& t) const {
    return length(minus(xyz[t[1]], xyz[t[0]])) + length(minus(xyz[t[2]], xyz[t[1]])) +
           length(minus(xyz[t[0]], xyz[t[2]]));
  }
  RationalPoint middle(const FlatComplex::Triangle& t) const {
    RationalPoint p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = (points[t[0]][k] + points[t[1]][k] + points[t[2]][k]) / 3;
    return p;
  }
  const Attributes& attributes(Component c) const { return attributes_of(view, c); }
};

/// Squares of distances from a set of cells, made when somebody asks.
class Near {
 public:
  explicit Near(const ShapeOfResult& shape) : shape_(shape) {}
  void add_face(Index f) {
    for (const auto& t : shape_.flat.faces[f].triangles) triangles_.push_back(t);
  }
  void add_edge(Index e) {
    const auto& edge = shape_.flat.edges[e];
    const std::size_t n = edge.points.size();
    for (std::size_t k = 0; k + (edge.closed ? 0 : 1) < n; ++k)
      segments_.push_back({edge.points[k], edge.points[(k + 1) % n]});
  }
  void add_vertex(Index v) { vertices_.push_back({shape_.flat.vertices[v].point}); }
  bool empty() const { return triangles_.empty() && segments_.empty() && vertices_.empty(); }
  bool within(const RationalPoint& p, double distance) {
    if (empty()) return false;
    if (!made_) made_ = std::make_unique<DistanceTo>(shape_.points, vertices_, segments_, triangles_);
    return nearest_root(made_->squared(p)) <= distance * (1 + 1e-9);
  }

 private:
  const ShapeOfResult& shape_;
  std::vector<std::array<std::uint32_t, 1>> vertices_;
  std::vector<std::array<std::uint32_t, 2>> segments_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::unique_ptr<DistanceTo> made_;
};

class Moved {
 public:
  Moved(const Result& before, const Result& after, const ToldMove& told)
      : before_(before), after_(after), told_(told), faces_(before_) {
    for (Index f = 0; f < before_.flat.faces.size(); ++f) faces_.add_face(f);
  }

  std::string run() {
    if (std::string f = validate(*after_.view.complex); !f.empty()) return "the complex: " + f;
    for (const auto step : {&Moved::places, &Moved::volumes, &Moved::cells, &Moved::lost}) {
      if (std::string f = (this->*step)(); !f.empty()) return f;
    }
    return {};
  }

 private:
  const ShapeOfResult before_, after_;
  const ToldMove& told_;
  Near faces_;  // of the result before

  /// What is said of the region that a point lies in; of the outside that.
  static std::string region_at(const ShapeOfResult& shape, const Locator& locator, const RationalPoint& p) {
    const Location at = locator.locate(p);
    if (at.dimension != 3) return "on a cell of dimension " + std::to_string(at.dimension);
    const SimplifiedComplex::Place place = shape.result.place(at);
    const Component c = shape.result.component(place);
    return c == 0 ? "outside" : attributes_text(shape.attributes(c));
  }

  /// Points between the middles of triangles, on both sides of them, and in a grid around all.
  std::vector<RationalPoint> samples() const {
    std::vector<RationalPoint> out;
    for (const ShapeOfResult* const shape : {&before_, &after_}) {
      std::vector<RationalPoint> middles;
      for (const auto& face : shape->flat.faces)
        for (const auto& t : face.triangles) middles.push_back(shape->middle(t));
      const std::size_t step = std::max<std::size_t>(1, middles.size() / 12);
      for (std::size_t i = 0; i < middles.size(); i += step)
        for (std::size_t k = 0; k < i; k += step) out.push_back(Rational(1, 2) * (middles[i] + middles[k]));
    }
    if (before_.points.empty()) return out;
    RationalPoint low = before_.points[0], high = low;
    for (const RationalPoint& p : before_.points) {
      for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
    }
    constexpr int kSteps = 4;
    for (int i = 0; i < kSteps * kSteps * kSteps; ++i) {
      const std::array<int, 3> at{i % kSteps, i / kSteps % kSteps, i / kSteps / kSteps};
      RationalPoint p;
      for (std::size_t k = 0; k < 3; ++k)
        p[k] = low[k] + (high[k] - low[k]) * Rational(2 * at[k] + 1, 2 * kSteps) + Rational(1, 977);
      out.push_back(p);
    }
    return out;
  }

  std::string places() {
    const Locator was(*before_.view.complex), is(*after_.view.complex);
    for (const RationalPoint& p : samples()) {
      if (faces_.within(p, told_.displacement)) continue;
      const std::string a = region_at(before_, was, p), b = region_at(after_, is, p);
      // The complexes may have cells of leaves that the values do not have there.
      if (a.starts_with("on ") || b.starts_with("on ")) continue;
      if (a != b) return "at " + describe(p) + " was `" + a + "` and is `" + b + "`";
    }
    return {};
  }

  struct Measure {
    Rational volume = 0;
    bool bounded = true;
  };
  /// By what is said.
  static std::map<std::string, Measure> measures(const ShapeOfResult& shape) {
    std::map<std::string, Measure> out;
    for (Component c = 1; c <= Component(shape.result.component_count()); ++c) {
      const auto volume = shape.result.volume(c);
      Measure& m = out[attributes_text(shape.result.attributes(c))];
      if (volume) m.volume += *volume;
      else m.bounded = false;
    }
    return out;
  }
  /// What faces sweep that move by the displacement at most, with what bends at their rims.
  double swept() const {
    const double d = told_.displacement;
    double out = 0;
    for (const ShapeOfResult* const shape : {&before_, &after_}) {
      for (const auto& face : shape->flat.faces)
        for (const auto& t : face.triangles) out += d * (shape->area(t) + d * shape->rim(t) + 4 * d * d);
    }
    return 2 * out;
  }
  std::string volumes() {
    auto was = measures(before_), is = measures(after_);
    const double room = swept();
    for (auto& [said, m] : was) {
      const Measure& now = is[said];
      if (!m.bounded || !now.bounded) {
        if (m.bounded == now.bounded || (m.volume == 0 && now.volume == 0)) continue;
        return "`" + said + "` has bounds in one result and none in the other";
      }
      if (to_double(abs(m.volume - now.volume)) > room)
        return "volume of `" + said + "`: " + to_decimal(m.volume) + ", moved " + to_decimal(now.volume) +
               ", but no more than " + to_decimal(from_double(room), 6) + " can have been swept";
    }
    for (const auto& [said, m] : is) {
      if (!was.contains(said)) return "`" + said + "` is new";
    }
    return {};
  }

  /// By a name, a material, or an attribute with its value: all cells before of which that is said.
  std::map<std::string, Near> said_before() const {
    std::map<std::string, Near> out;
    const auto see = [&](const auto& cells, auto add) {
      for (Index i = 0; i < cells.size(); ++i) {
        if (cells[i].origin.said == nullptr) continue;
        for (const std::string& what : parts_of(*cells[i].origin.said))
          (out.try_emplace(what, before_).first->second.*add)(i);
      }
    };
    see(before_.flat.faces, &Near::add_face), see(before_.flat.edges, &Near::add_edge);
    see(before_.flat.vertices, &Near::add_vertex);
    return out;
  }
  static std::vector<std::string> parts_of(const Attributes& a) {
    std::vector<std::string> out;
    if (!a.name.empty()) out.push_back("name " + a.name.text());
    if (!a.material.empty()) out.push_back("material " + a.material.name());
    for (const auto& [key, value] : a.properties) out.push_back("attribute " + key + " = " + to_text(value));
    return out;
  }
  /// Of cells that speak for themselves: each part of what is said comes from a cell near by; and what a component
  /// is called that a face, an edge or a vertex has.
  std::string cells() {
    auto said = said_before();
    std::map<std::string, Near> of_component;
    const auto see = [&](const auto& cells, auto add) {
      for (Index i = 0; i < cells.size(); ++i) {
        if (cells[i].component != 0)
          (of_component.try_emplace(attributes_text(before_.attributes(cells[i].component)), before_)
               .first->second.*
           add)(i);
      }
    };
    see(before_.flat.faces, &Near::add_face), see(before_.flat.edges, &Near::add_edge);
    see(before_.flat.vertices, &Near::add_vertex);
    const auto check = [&](const auto& cells, const char* kind, auto point) -> std::string {
      for (Index i = 0; i < cells.size(); ++i) {
        if (cells[i].component == 0) continue;
        for (const RationalPoint& p : point(i)) {
          const std::string where = std::string(kind) + std::to_string(i) + " at " + describe(p);
          const auto fails = [&](std::map<std::string, Near>& known, const std::string& what) {
            const auto found = known.find(what);
            return found == known.end() || !found->second.within(p, told_.displacement);
          };
          if (cells[i].origin.said != nullptr) {
            for (const std::string& what : parts_of(*cells[i].origin.said))
              if (fails(said, what)) return where + " has `" + what + "`, which nothing near by had";
          }
          const std::string component = attributes_text(after_.attributes(cells[i].component));
          if (fails(of_component, component)) return where + " is of `" + component + "`, and nothing near by was";
        }
      }
      return {};
    };
    const auto of_face = [&](Index f) {
      std::vector<RationalPoint> out;
      for (const auto& t : after_.flat.faces[f].triangles) out.push_back(after_.middle(t));
      return out;
    };
    const auto of_edge = [&](Index e) {
      const auto& edge = after_.flat.edges[e];
      std::vector<RationalPoint> out;
      const std::size_t n = edge.points.size();
      for (std::size_t k = 0; k + (edge.closed ? 0 : 1) < n; ++k) {
        out.push_back(Rational(1, 2) * (after_.points[edge.points[k]] + after_.points[edge.points[(k + 1) % n]]));
      }
      return out;
    };
    const auto of_vertex = [&](Index v) {
      return std::vector<RationalPoint>{after_.points[after_.flat.vertices[v].point]};
    };
    if (std::string f = check(after_.flat.faces, "f", of_face); !f.empty()) return f;
    if (std::string f = check(after_.flat.edges, "e", of_edge); !f.empty()) return f;
    return check(after_.flat.vertices, "v", of_vertex);
  }

  /// Names of components with regions.
  static std::multiset<std::string> names(const ShapeOfResult& shape) {
    std::set<Component> components;
    for (const auto& region : shape.flat.regions)
      if (region.component != 0) components.insert(region.component);
    std::multiset<std::string> out;
    for (const Component c : components) out.insert(shape.attributes(c).name);
    return out;
  }
  std::string lost() {
    // A region may have been parted, so there may be more of a name.
    const std::multiset<std::string> was = names(before_), is = names(after_);
    for (const std::string& name : is) {
      if (!was.contains(name)) return "a region `" + name + "`, and there was none";
    }
    std::multiset<std::string> told;
    for (const std::string& line : told_.lost_regions) {
      if (line.find(" (a piece)") != std::string::npos) continue;
      if (const auto at = line.find(" pieces)");
          at != std::string::npos && line.find(" (all ") == std::string::npos)
        continue;
      const bool named = !line.starts_with("a region of ");  // else its leaves are told
      const auto end = std::min({line.find(", r"), line.find(", at "), line.find(" (all ")});
      told.insert(named ? line.substr(0, end) : std::string());
    }
    for (const std::string& name : std::set<std::string>(was.begin(), was.end())) {
      if (was.count(name) > is.count(name) + told.count(name))
        return "of " + std::to_string(was.count(name)) + " regions `" + name + "` there are " +
               std::to_string(is.count(name)) + ", and told is the loss of " + std::to_string(told.count(name));
    }
    for (const std::string& name : told) {
      if (told.count(name) > was.count(name)) return "more regions `" + name + "` told to be lost than there were";
    }
    return {};
  }
};

}  // namespace

std::string moved_failure(const Result& before, const Result& after, const ToldMove& told) {
  return Moved(before, after, told).run();
}

std::string near_failure(const Result& result, double within) {
  const ShapeOfResult shape(result);
  const auto& x = shape.xyz;
  const double bound = within * (1 - 1e-9);
  std::set<std::array<Index, 2>> segments;
  struct Facet {
    std::vector<FlatComplex::Triangle> triangles;
    std::set<Index> corners;
  };
  std::vector<Facet> facets;
  const auto side = [&](Index a, Index b) { segments.insert({std::min(a, b), std::max(a, b)}); };
  for (const auto& edge : shape.flat.edges) {
    const std::size_t n = edge.points.size();
    for (std::size_t k = 0; k + (edge.closed ? 0 : 1) < n; ++k) side(edge.points[k], edge.points[(k + 1) % n]);
  }
  for (const auto& face : shape.flat.faces) {
    std::size_t begin = 0;
    for (std::size_t i = 0; i < std::max<std::size_t>(1, face.facets.size()); ++i) {
      const std::size_t end = face.facets.empty() ? face.triangles.size() : face.facet_ends[i];
      Facet& facet = facets.emplace_back();
      for (; begin < end; ++begin) {
        facet.triangles.push_back(face.triangles[begin]);
        facet.corners.insert(face.triangles[begin].begin(), face.triangles[begin].end());
      }
      if (face.facets.empty()) continue;
      for (const auto& loop : face.facets[i].loops)
        for (std::size_t k = 0; k < loop.size(); ++k) side(loop[k], loop[(k + 1) % loop.size()]);
    }
  }
  const auto failure = [&](const char* what, const Vector& at, double distance) {
    std::ostringstream out;
    out << what << " at (" << at[0] << ", " << at[1] << ", " << at[2] << "), " << distance << " apart";
    return out.str();
  };
  for (Index p = 0; p < x.size(); ++p) {
    for (Index q = 0; q < p; ++q) {
      if (const double d = length(minus(x[p], x[q])); d < bound) return failure("two points", x[p], d);
    }
    for (const auto& [a, b] : segments) {
      if (a == p || b == p) continue;
      const Vector u = minus(x[b], x[a]), w = minus(x[p], x[a]);
      const double t = dot_of(u, w) / dot_of(u, u);
      if (!(t > 1e-9 && t < 1 - 1e-9)) continue;
      if (const double d = length(cross_of(u, w)) / length(u); d < bound)
        return failure("a point and an edge", x[p], d);
    }
    for (const Facet& facet : facets) {
      if (facet.corners.contains(p)) continue;
      for (const auto& t : facet.triangles) {
        const Vector u = minus(x[t[1]], x[t[0]]), v = minus(x[t[2]], x[t[0]]), w = minus(x[p], x[t[0]]);
        const Vector n = cross_of(u, v);
        const double square = dot_of(n, n), d = std::abs(dot_of(n, w)) / std::sqrt(square);
        const double s = dot_of(cross_of(w, v), n) / square, r = dot_of(cross_of(u, w), n) / square;
        if (d < bound && s > 1e-9 && r > 1e-9 && s + r < 1 - 1e-9) return failure("a point and a face", x[p], d);
      }
    }
  }
  for (const auto& [a, b] : segments) {
    for (const auto& [p, q] : segments) {
      if (std::pair(p, q) <= std::pair(a, b) || a == p || a == q || b == p || b == q) continue;
      const Vector u = minus(x[b], x[a]), v = minus(x[q], x[p]), w = minus(x[p], x[a]), n = cross_of(u, v);
      const double square = dot_of(n, n);
      if (square < 1e-18 * dot_of(u, u) * dot_of(v, v)) continue;
      const double s = dot_of(cross_of(w, v), n) / square, t = dot_of(cross_of(w, u), n) / square;
      const double d = std::abs(dot_of(n, w)) / std::sqrt(square);
      if (d < bound && s > 1e-9 && t > 1e-9 && s < 1 - 1e-9 && t < 1 - 1e-9)
        return failure("two edges", {x[a][0] + s * u[0], x[a][1] + s * u[1], x[a][2] + s * u[2]}, d);
    }
  }
  return {};
}

std::string file_failure(const Result& result, const std::string& folder) {
  const auto text_of_file = [](const std::string& path) {
    std::ostringstream out;
    out << std::ifstream(path).rdbuf();
    return out.str();
  };
  const std::string path = folder + "/moved.json";
  write(path, result);
  const Result read = read_result(path);
  if (read.component_count() != result.component_count())
    return std::to_string(result.component_count()) + " components, read back " +
           std::to_string(read.component_count());
  if (active_counts(read.cells()) != active_counts(result.cells())) return "read back, other numbers of cells";
  for (Component i = 1; i <= Component(result.component_count()); ++i) {
    const std::string words = "component " + std::to_string(i) + ", read back: ";
    if (result.volume(i) != read.volume(i)) return words + "another volume";
    if (!(attributes_text(result.attributes(i)) == attributes_text(read.attributes(i))))
      return words + attributes_text(read.attributes(i)) + " in place of " + attributes_text(result.attributes(i));
  }
  write(path, read);
  const std::string text = text_of_file(path);
  write(path, read_result(path));
  return text == text_of_file(path) ? "" : "read and written twice, the file is another one";
}

}  // namespace cnrg::properties
