#include "csg/picture/mesh_scene.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "csg/mesh/quality.h"
#include "csg/mesh/split.h"
#include "csg/picture/make_scene.h"
#include "csg/result/result_data.h"
#include "kernel/base/limits.h"
#include "kernel/base/sorted.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

using Index = Mesh::Index;
using Triangle = std::array<Index, 3>;

class MeshScene {
 public:
  MeshScene(const Result& result, const Mesh& mesh, const MeshDrawing& drawing)
      : view_(result.data().view()),
        flat_(flatten(view_)),
        colors_(view_, flat_),
        mesh_(mesh),
        opened_(drawing.opened),
        camera_(camera_for({result})),
        region_color_(region_colors(result, mesh)) {
    find_plane();
  }

  /// False if there is nothing to be drawn.
  bool make() {
    if (mesh_.tetrahedra.empty()) add_faces(mesh_.triangles), add_faces(mesh_.quads);
    else add_tetrahedra();
    if (scene_.facets.size() > MeshDrawing::kMostTriangles || (opened_ && (taken_ == 0 || kept_ == 0)))
      return false;
    add_lines();
    add_points();
    return true;
  }
  Figure figure(const MeshDrawing& drawing, int threads) {
    Figure out = figure_of(scene_, camera_, threads);
    const double scale = to_double(camera_.scale());
    const auto place_of = [&](const std::array<double, 3>& p) {
      const RationalPoint at = camera_.view(from_doubles(p));
      return Point2{to_double(at[0]) / scale, to_double(at[1]) / scale};
    };
    if (!opened_) {  // wires are inside mostly: they shine through
      std::vector<Figure::Stroke> wires;
      for (const auto& s : mesh_.segments) {
        if (!mesh_.entities[1][s.entity].wire) continue;
        Figure::Stroke& wire = wires.emplace_back();
        wire.line = Figure::Line::wire;
        wire.color = own_color(1, s.entity);
        wire.hidden = true;
        for (const Index p : s.points) wire.points.push_back(place_of(mesh_.points[p]));
      }
      out.strokes.insert(out.strokes.begin(), wires.begin(), wires.end());
    }
    for (std::size_t i = 0; i < drawing.marked.size(); ++i) {
      const auto& p = drawing.marked[i];
      if (opened_ && distance(p) > 0) continue;
      const Point2 place = place_of(p);
      Figure::Dot dot;
      dot.at = place;
      dot.mark = Figure::Mark::isolated;
      dot.color = alarm_color();
      out.dots.push_back(dot);
      out.labels.push_back({std::to_string(i + 1), {{place, 0}}});
    }
    return out;
  }

 private:
  const ResultView view_;
  const FlatComplex flat_;
  const CellColors colors_;
  const Mesh& mesh_;
  const bool opened_;
  const Camera camera_;
  const std::vector<Rgb> region_color_;
  std::size_t axis_ = 1;
  double sign_ = -1, middle_ = 0;
  std::size_t taken_ = 0, kept_ = 0;
  Scene scene_;
  std::vector<Scene::Index> number_;                               // by point of the mesh
  std::map<std::pair<Index, std::array<double, 3>>, Index> skin_;  // surfaces, by face and color
  std::map<std::array<Index, 2>, char> sides_;                     // edges of what is drawn

  /// Across the horizontal axis that points most towards who looks.
  void find_plane() {
    const RationalPoint& to = camera_.towards();
    axis_ = abs(to[0]) > abs(to[1]) ? 0 : 1;
    sign_ = to[axis_] < 0 ? -1 : 1;
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const auto& p : mesh_.points) low = std::min(low, p[axis_]), high = std::max(high, p[axis_]);
    middle_ = low / 2 + high / 2;
  }
  /// From the plane towards who looks.
  double distance(const std::array<double, 3>& p) const { return sign_ * (p[axis_] - middle_); }
  template <std::size_t N>
  bool stays(const std::array<Index, N>& simplex) const {
    if (!opened_) return true;
    double sum = 0;
    for (const Index p : simplex) sum += distance(mesh_.points[p]) / double(N);
    return sum <= 0;
  }

  Scene::Index point(Index p) {
    number_.resize(mesh_.points.size(), kNone);
    if (number_[p] == kNone) {
      number_[p] = Scene::Index(scene_.points.size());
      const auto& x = mesh_.points[p];
      scene_.points.push_back(camera_.view(from_doubles(x)));
    }
    return number_[p];
  }

  /// A triangle or a quadrilateral, which rounding has made two triangles.
  template <std::size_t N>
  void add_facet(const std::array<Index, N>& corners, Scene::Index surface) {
    for (std::size_t k = 1; k + 1 < N; ++k) {
      Scene::Facet& facet = scene_.facets.emplace_back();
      facet.surface = surface;
      facet.loops = {{point(corners[0]), point(corners[k]), point(corners[k + 1])}};
    }
    for (std::size_t k = 0; k < N; ++k) {
      const Index a = corners[k], b = corners[(k + 1) % N];
      sides_[{std::min(a, b), std::max(a, b)}] = 0;
    }
  }
  Scene::Index add_surface(const Rgb& color, bool sheet, bool two_sided) {
    Scene::Surface s;
    s.color = color;
    s.sheet = sheet;
    s.two_sided = two_sided;
    scene_.surfaces.push_back(s);
    return Scene::Index(scene_.surfaces.size() - 1);
  }
  /// Triangles on one face of the model are one surface, so that a curved one has a smooth light.
  Scene::Index skin(Index face, const Rgb& color, bool sheet, bool two_sided) {
    const auto [entry, fresh] = skin_.try_emplace({face, color}, 0);
    if (fresh) entry->second = add_surface(color, sheet, two_sided);
    return entry->second;
  }

  /// Of a wire or a point: that of a material or a component, else one that nobody takes for a bad tetrahedron's.
  Rgb own_color(int dimension, Index entity) const {
    const auto cell = Index(mesh_.entities[std::size_t(dimension)][entity].tags.cell);
    const Rgb color = colors_.of(colors_by(view_), dimension, cell).color;
    return color == wire_color() || color == point_color() ? rgb("#4b2e83") : color;
  }

  bool active(Index region) const { return flat_.active(region); }
  const FlatComplex::Face& face_of(Index entity) const {
    return flat_.faces[std::size_t(mesh_.entities[2][entity].tags.cell)];
  }
  bool parts_nothing(const Mesh::Simplex<3>& t) const {
    const auto& [front, back] = face_of(t.entity).regions;
    return front == back || (!active(front) && !active(back));
  }
  template <std::size_t N>
  void add_sheet(const Mesh::Simplex<N>& t) {
    const auto cell = Index(mesh_.entities[2][t.entity].tags.cell);
    add_facet(t.points, skin(t.entity, colors_.of(colors_by(view_), 2, cell).color, true, true));
  }

  /// The sides of tetrahedra that stay behind which none stays; and sheets outside of them.
  void add_tetrahedra() {
    struct Side {
      Triangle seen;  ///< counter-clockwise from outside
      std::size_t tetrahedron;
    };
    std::map<Triangle, Side> open;
    std::vector<Triangle> inside;
    for (std::size_t i = 0; i < mesh_.tetrahedra.size(); ++i) {
      const auto& t = mesh_.tetrahedra[i].points;
      if (!stays(t)) {
        ++taken_;
        continue;
      }
      ++kept_;
      for (const auto& s : kOutsides) {
        const Triangle seen{t[s[0]], t[s[1]], t[s[2]]};
        const auto [entry, fresh] = open.try_emplace(sorted(seen), Side{seen, i});
        if (fresh) continue;
        inside.push_back(entry->first);
        open.erase(entry);
      }
    }
    std::sort(inside.begin(), inside.end());
    std::map<Triangle, const Mesh::Simplex<3>*> faces;
    for (const auto& t : mesh_.triangles) {
      const Triangle key = sorted(t.points);
      if (open.count(key) != 0) faces.emplace(key, &t);
      else if (parts_nothing(t) && stays(t.points) && !std::binary_search(inside.begin(), inside.end(), key))
        add_sheet(t);
    }
    for (const auto& [key, side] : open) {
      const auto& t = mesh_.tetrahedra[side.tetrahedron];
      std::array<std::array<double, 3>, 4> corners;
      for (std::size_t k = 0; k < 4; ++k) corners[k] = mesh_.points[t.points[k]];
      const Rgb color = measures_of(corners).shape < MeshQuality::kBad ? alarm_color() : region_color_[t.entity];
      const auto face = faces.find(key);
      add_facet(side.seen, face == faces.end() ? add_surface(color, false, false)
                                               : skin(face->second->entity, color, false, false));
    }
  }

  /// Of triangles or quadrilaterals of a mesh without tetrahedra: the skins of regions, and sheets; opened, both
  /// sides of all that stays.
  template <std::size_t N>
  void add_faces(const std::vector<Mesh::Simplex<N>>& all) {
    const ColorBy by = colors_by(view_);
    for (const auto& t : all) {
      if (!stays(t.points)) {
        ++taken_;
        continue;
      }
      ++kept_;
      const FlatComplex::Face& face = face_of(t.entity);
      const bool front = active(face.regions[0]), back = active(face.regions[1]);
      if (front == back) {
        const bool wall = front && face.regions[0] != face.regions[1];
        if (wall && opened_) add_facet(t.points, skin(t.entity, no_color(), false, true));
        else if (!front || opened_) add_sheet(t);
        continue;
      }
      auto seen = t.points;
      if (front) std::reverse(seen.begin(), seen.end());
      add_facet(seen, skin(t.entity, colors_.of(by, 3, face.regions[front ? 0 : 1]).color, false, opened_));
    }
  }

  void add_lines() {
    std::map<std::array<Index, 2>, Index> segments;  // and their edges
    for (const auto& s : mesh_.segments) {
      const Mesh::Entity& edge = mesh_.entities[1][s.entity];
      const std::array<Index, 2> ends{std::min(s.points[0], s.points[1]), std::max(s.points[0], s.points[1])};
      if (edge.feature && (sides_.count(ends) != 0 || (edge.wire && stays(s.points))))
        segments.emplace(ends, s.entity);
    }
    const auto begin = [&](Figure::Line look, const Rgb& color) {
      Scene::Line line;
      line.look = look;
      line.color = color;
      scene_.lines.push_back(line);
      return Scene::Index(scene_.lines.size() - 1);
    };
    const Scene::Index between = begin(Figure::Line::mesh, mix({1, 1, 1}, kInk, 0.7));
    const Scene::Index edge = begin(Figure::Line::edge, kInk);
    std::map<Rgb, Scene::Index> wires;
    for (const auto& [ends, nothing] : sides_) {
      if (segments.count(ends) == 0) scene_.segments.push_back({between, {point(ends[0]), point(ends[1])}});
    }
    for (const auto& [ends, entity] : segments) {
      Scene::Index line = edge;
      if (mesh_.entities[1][entity].wire) {
        const Rgb color = own_color(1, entity);
        const auto [entry, fresh] = wires.try_emplace(color, 0);
        if (fresh) entry->second = begin(Figure::Line::wire, color);
        line = entry->second;
      }
      scene_.segments.push_back({line, {point(ends[0]), point(ends[1])}});
    }
  }

  /// Points on no edge.
  void add_points() {
    std::vector<char> met(mesh_.points.size(), 0);
    const auto meet = [&](const auto& simplices) {
      for (const auto& s : simplices)
        for (const Index p : s.points) met[p] = 1;
    };
    meet(mesh_.segments), meet(mesh_.triangles), meet(mesh_.quads), meet(mesh_.tetrahedra);
    for (const auto& v : mesh_.vertices) {
      if (met[v.points[0]] != 0 || !stays(v.points)) continue;
      Scene::Dot dot;
      dot.mark = Figure::Mark::isolated;
      dot.color = own_color(0, v.entity);
      dot.point = point(v.points[0]);
      scene_.dots.push_back(dot);
    }
  }
};

}  // namespace

Rgb alarm_color() { return rgb("#d1301c"); }

std::vector<Rgb> region_colors(const Result& result, const Mesh& mesh) {
  const ResultView view = result.data().view();
  const FlatComplex flat = flatten(view);
  const CellColors colors(view, flat);
  const ColorBy by = colors_by(view);
  std::vector<Rgb> out;
  for (const Mesh::Entity& region : mesh.entities[3])  // wedges are of faces
    out.push_back(colors.of(by, region.tags.dimension, FlatComplex::Index(region.tags.cell)).color);
  return out;
}

std::optional<Figure> draw_mesh(const Result& result, const Mesh& mesh, const MeshDrawing& drawing, int threads) {
  const std::optional<Mesh> whole = mesh.twins.empty() ? std::nullopt : std::optional(joined_again(mesh));
  MeshScene scene(result, whole ? *whole : mesh, drawing);
  if (!scene.make()) return std::nullopt;
  return scene.figure(drawing, threads);
}

}  // namespace cnrg
