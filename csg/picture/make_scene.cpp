#include "csg/picture/make_scene.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>

#include "csg/picture/loops.h"
#include "csg/text/escape.h"
#include "kernel/base/counts.h"
#include "kernel/base/limits.h"
#include "kernel/base/sorted.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/integers.h"
#include "kernel/exact/trigonometry.h"

namespace cnrg {
namespace {

/// Cosine and sine of an angle as fractions over one denominator: `c`, `s`, `size` with c^2 + s^2 = size^2.
struct Turn {
  Integer c, s, size;
};

Turn turn_by(double degrees) {
  const double quarters = std::nearbyint(degrees / 90);
  const std::int64_t p = std::llround(rounded::tangent((degrees - 90 * quarters) * M_PI / 360) * 512);
  Turn turn{to_integer(512 * 512 - p * p), to_integer(2 * 512 * p), to_integer(512 * 512 + p * p)};
  if (p == 0) turn = {1, 0, 1};
  for (int k = static_cast<int>(std::fmod(quarters, 4)); k != 0; k += k < 0 ? 1 : -1) {
    const Integer c = turn.c;
    turn.c = k < 0 ? turn.s : Integer(-turn.s);
    turn.s = k < 0 ? Integer(-c) : c;
  }
  return turn;
}

using Index = Scene::Index;

class SceneBuilder {
 public:
  SceneBuilder(const ResultView& view, const FlatComplex& flat, const PictureCells& cells,
               const DrawOptions& options, const Camera& camera)
      : view_(view),
        flat_(flat),
        cells_(cells),
        options_(options),
        camera_(camera),
        colors_(view, flat, options.leaf_names),
        by_(colors_by(view, options.colors)),
        whole_(options.apart == 0 && options.opacity >= 1) {}

  Scene run() {
    find_shifts();
    for (const PictureCells::Face& face : cells_.faces) {
      if (face.regions[0] == face.regions[1]) add_sheet(face);
      else add_skins(face);
    }
    find_surroundings();
    for (const PictureCells::Edge& edge : cells_.edges) add_edge(edge);
    add_vertices();
    return std::move(scene_);
  }

 private:
  const ResultView& view_;
  const FlatComplex& flat_;
  const PictureCells& cells_;
  const DrawOptions& options_;
  const Camera& camera_;
  const CellColors colors_;
  const ColorBy by_;
  const bool whole_;                  ///< closed and not seen through: what is inside of regions is not seen
  std::vector<RationalPoint> shift_;  // by region, in the camera's space
  std::vector<std::map<Index, Index>> copies_;  // by point: those at the shift of a region (kNone: none)
  std::map<std::pair<std::string, Index>, Index> label_numbers_;
  std::set<std::string> known_keys_;
  // By edge and by point: active regions about it, kNone for what is not active.
  std::vector<std::vector<Index>> about_edge_;
  std::map<Index, std::vector<Index>> about_point_;
  Scene scene_;

  bool active(Index region) const { return flat_.active(region); }
  /// Its skin hides what is in it.
  bool closed(Index region) const { return whole_ && active(region) && flat_.regions[region].bounded; }
  /// Nothing in it can be seen. In the plane of a cut, what lies in a region can.
  bool unseen(Index region) const { return closed(region) && options_.cuts.empty(); }

  // --- places

  void find_shifts() {
    copies_.resize(cells_.points.size());
    shift_.assign(flat_.regions.size(), {0, 0, 0});
    if (options_.apart == 0) return;
    struct Box {
      RationalPoint low, high;
      bool empty = true;
      void add(const RationalPoint& p) {
        if (empty) low = high = p;
        empty = false;
        for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
      }
      RationalPoint middle() const { return Rational(1, 2) * (low + high); }
    };
    std::vector<Box> boxes(flat_.regions.size());
    Box whole;
    for (const PictureCells::Face& face : cells_.faces) {
      for (const Index r : face.regions) {
        if (!active(r)) continue;
        for (const auto& facet : face.facets) {
          for (const auto& loop : facet) {
            for (const Index p : loop) boxes[r].add(cells_.points[p]), whole.add(cells_.points[p]);
          }
        }
      }
    }
    const Rational share = from_double(options_.apart);
    for (std::size_t r = 0; r < boxes.size(); ++r) {
      if (boxes[r].empty) continue;
      shift_[r] = camera_.view(share * (boxes[r].middle() - whole.middle()));
    }
  }

  /// A point as it moves with a region.
  Index point(Index p, Index region) {
    if (!active(region) || options_.apart == 0) region = kNone;
    const auto [entry, fresh] = copies_[p].try_emplace(region, next_number(scene_.points.size(), "points"));
    if (fresh) {
      RationalPoint at = camera_.view(cells_.points[p]);
      if (region != kNone) at = at + shift_[region];
      scene_.points.push_back(std::move(at));
    }
    return entry->second;
  }

  void add_facets(const PictureCells::Face& face, Index surface, Index region, bool turned) {
    for (const auto& facet : face.facets) {
      Scene::Facet& out = scene_.facets.emplace_back();
      out.surface = surface;
      for (const FlatComplex::Loop& loop : facet) {
        Scene::Loop& corners = out.loops.emplace_back();
        for (const Index p : loop) corners.push_back(point(p, region));
        if (turned) std::reverse(corners.begin(), corners.end());
      }
    }
  }

  // --- looks

  /// A text that stands once in the picture; of a region once for each.
  Index label(const std::string& text, Index region = kNone) {
    const auto [entry, fresh] =
        label_numbers_.try_emplace({text, region}, static_cast<Index>(scene_.labels.size()));
    if (fresh) scene_.labels.push_back(text);
    return entry->second;
  }
  void add_number(std::vector<Index>& labels, int dimension, Index cell, bool wanted) {
    if (wanted && cell != kNone) labels.push_back(label(cell_name(dimension, cell)));
  }
  /// A region's material where that is its color, else its name.
  void add_name_of_region(std::vector<Index>& labels, Index region) {
    if (!options_.labels.names) return;
    const RegionAttributes& a = attributes_of(view_, flat_.regions[region].component);
    const std::string& material = a.material.name();
    const bool by_material = a.name.empty() || (by_ == ColorBy::material && !material.empty());
    const std::string& text = by_material ? material : a.name.text();
    if (!text.empty()) labels.push_back(label(shown(text), region));
  }
  /// The one leaf that a sheet, a wire or a point came from.
  void add_name_of_leaf(std::vector<Index>& labels, const FlatComplex::Provenance& origin) {
    if (!options_.labels.names) return;
    std::set<std::string> names;
    for (const LeafId leaf : origin.leaves) names.insert((*view_.leaves)[leaf.index()].name);
    if (names.size() == 1 && !names.begin()->empty()) labels.push_back(label(shown(*names.begin())));
  }
  Rgb painted(const CellColor& color) {
    if (!color.text.empty() && known_keys_.insert(color.text).second) {
      scene_.keys.push_back({color.color, shown(color.text)});
    }
    return color.color;
  }

  void add_skins(const PictureCells::Face& face) {
    for (const unsigned side : {0U, 1U}) {
      const Index r = face.regions[side], beyond = face.regions[1 - side];
      if (!active(r) || (active(beyond) && closed(beyond))) continue;
      Scene::Surface s;
      const bool own = face.face != kNone && flat_.faces[face.face].component != 0;
      s.missing = face.face != kNone && !own;
      // A sheet that lies in the plane of a cut.
      s.sheet = own && flat_.faces[face.face].regions[0] == flat_.faces[face.face].regions[1];
      s.color = painted(face.face == kNone ? colors_.of(by_, 3, r)
                        : s.sheet          ? colors_.of(by_, 2, face.face)
                                           : colors_.skin(by_, r, face.face));
      s.opacity = options_.opacity;
      s.two_sided =
          !flat_.regions[r].bounded || (options_.opacity < 1 && (!active(beyond) || options_.apart != 0));
      add_number(s.labels, 2, face.face, options_.labels.faces);
      add_number(s.labels, 3, r, options_.labels.regions);
      add_name_of_region(s.labels, r);
      scene_.surfaces.push_back(s);
      add_facets(face, static_cast<Index>(scene_.surfaces.size() - 1), r, side == 0);
    }
  }

  void add_sheet(const PictureCells::Face& face) {
    const FlatComplex::Face& cell = flat_.faces[face.face];
    const Index r = face.regions[0];
    const bool own = cell.component != 0;
    if (unseen(r) || (!own && !active(r))) return;
    Scene::Surface s;
    s.sheet = own;
    s.missing = !own;
    s.color = own ? painted(colors_.of(by_, 2, face.face)) : no_color();
    s.opacity = options_.opacity;
    s.two_sided = true;
    add_number(s.labels, 2, face.face, options_.labels.faces);
    if (own) add_name_of_leaf(s.labels, cell.origin);
    scene_.surfaces.push_back(s);
    add_facets(face, static_cast<Index>(scene_.surfaces.size() - 1), r, false);
  }

  // --- lines and dots

  /// Which regions are about edges and vertices, from the faces that they bound.
  void find_surroundings() {
    about_edge_.resize(flat_.edges.size());
    for (Index e = 0; e < flat_.edges.size(); ++e) {
      const FlatComplex::Edge& edge = flat_.edges[e];
      std::vector<Index>& about = about_edge_[e];
      if (edge.around.empty()) about.push_back(edge.region);
      for (const Index code : edge.around) {
        for (const Index r : flat_.faces[code / 2].regions) about.push_back(r);
      }
      for (Index& r : about) r = active(r) ? r : kNone;
      sort_unique(about);
      const auto add = [&](Index p) {
        std::vector<Index>& all = about_point_[p];
        all.insert(all.end(), about.begin(), about.end());
      };
      if (!edge.closed) add(edge.points.front()), add(edge.points.back());
    }
    for (const FlatComplex::Face& face : flat_.faces) {
      for (const Index p : face.isolated) {
        for (const Index r : face.regions) about_point_[p].push_back(active(r) ? r : kNone);
      }
    }
    for (auto& [p, about] : about_point_) sort_unique(about);
  }

  /// All around is of regions that nobody looks into.
  bool enclosed(const std::vector<Index>& about) const {
    return std::all_of(about.begin(), about.end(), [&](Index r) { return unseen(r); });
  }
  /// The copies of what lies between these regions: one for each, or one that does not move.
  std::vector<Index> movers(const std::vector<Index>& about) const {
    if (options_.apart == 0) return {kNone};
    std::vector<Index> out;
    for (const Index r : about) {
      if (r != kNone) out.push_back(r);
    }
    if (out.empty()) out.push_back(kNone);
    return out;
  }

  void add_edge(const PictureCells::Edge& edge) {
    Scene::Line line;
    line.color = kInk;
    std::vector<Index> about = edge.regions;
    if (edge.edge != kNone) {
      const FlatComplex::Edge& cell = flat_.edges[edge.edge];
      const bool own = cell.component != 0;
      about = about_edge_[edge.edge];
      if (enclosed(about)) return;
      const bool bounds = std::any_of(cell.around.begin(), cell.around.end(), [&](Index code) {
        const FlatComplex::Face& face = flat_.faces[code / 2];
        return face.component != 0 || active(face.regions[0]) || active(face.regions[1]);
      });
      if (!own && !bounds) return;
      line.missing = !own;
      if (cell.wire && own) {
        line.look = Figure::Line::wire;
        line.color = painted(colors_.of(by_, 1, edge.edge));
        add_name_of_leaf(line.labels, cell.origin);
      } else if (cell.around.size() == 1) {
        line.look = Figure::Line::border;
      }
      add_number(line.labels, 1, edge.edge, options_.labels.edges);
    }
    scene_.lines.push_back(line);
    for (const Index r : movers(about)) {
      for (const auto& [a, b] : edge.segments) {
        scene_.segments.push_back({static_cast<Index>(scene_.lines.size() - 1), {point(a, r), point(b, r)}});
      }
    }
  }

  void add_vertices() {
    std::map<Index, char> ends;  // 1: of edges, 2: of wires
    for (const FlatComplex::Edge& edge : flat_.edges) {
      if (edge.closed) continue;
      for (const Index p : {edge.points.front(), edge.points.back()}) {
        ends[p] = std::max<char>(ends[p], edge.wire && edge.component != 0 ? 2 : 1);
      }
    }
    for (const PictureCells::Vertex& v : cells_.vertices) {
      const FlatComplex::Vertex& cell = flat_.vertices[v.vertex];
      const bool own = cell.component != 0;
      const auto end = ends.find(cell.point);
      Scene::Dot dot;
      std::vector<Index> about{active(cell.region) ? cell.region : kNone};
      const auto known = about_point_.find(cell.point);
      if (known != about_point_.end()) about = known->second;
      if (enclosed(about)) continue;
      dot.missing = !own;
      dot.color = kInk;
      if (end == ends.end() && own) {
        dot.mark = Figure::Mark::isolated;
        dot.color = painted(colors_.of(by_, 0, v.vertex));
        add_name_of_leaf(dot.labels, cell.origin);
      }
      dot.drawn = !own || end == ends.end() || end->second == 2 || options_.labels.vertices;
      add_number(dot.labels, 0, v.vertex, options_.labels.vertices);
      if (!dot.drawn) continue;
      for (const Index r : movers(about)) {
        dot.point = point(v.point, r);
        scene_.dots.push_back(dot);
      }
    }
  }
};

}  // namespace

Camera::Camera(const DrawOptions::Camera& angles) {
  const Turn a = turn_by(angles.azimuth), e = turn_by(angles.elevation);
  // Right is (cos a, sin a, 0); the way to who looks is (sin a cos e, -cos a cos e, sin e); up is at right angles.
  turn_.linear = {{{Rational(a.c * e.size), Rational(a.s * e.size), Rational(0)},
                   {Rational(-a.s * e.s), Rational(a.c * e.s), Rational(a.size * e.c)},
                   {Rational(a.s * e.c), Rational(-a.c * e.c), Rational(a.size * e.s)}}};
  towards_ = turn_.linear[2];
  scale_ = Rational(a.size * e.size);
}

ColorBy colors_by(const ResultView& view, const std::optional<ColorBy>& asked) {
  const ColorBy by = asked.value_or(default_colors(view));
  const bool group = view.value->is_group() || view.of_group;
  return group && by == ColorBy::component ? ColorBy::region : by;
}

Scene make_scene(const ResultView& view, const FlatComplex& flat, const PictureCells& cells,
                 const DrawOptions& options, const Camera& camera) {
  return SceneBuilder(view, flat, cells, options, camera).run();
}

void add_ghosts(const Complex& complex, const FlatComplex& flat, const Camera& camera, Scene& scene) {
  const PictureCells cells = picture_cells(complex, flat);
  // Points of ghosts that are points of the scene, too: facets and lines that meet there then share them.
  std::map<RationalPoint, Index> known;
  for (Index i = 0; i < scene.points.size(); ++i) known.emplace(scene.points[i], i);
  const auto point = [&](Index p) {
    RationalPoint at = camera.view(cells.points[p]);
    const auto [entry, fresh] = known.try_emplace(at, static_cast<Index>(scene.points.size()));
    if (fresh) scene.points.push_back(std::move(at));
    return entry->second;
  };
  for (const PictureCells::Face& face : cells.faces) {
    if (flat.faces[face.face].component == 0) continue;
    Scene::Surface s;
    s.color = no_color();
    s.opacity = 0.2;
    s.ghost = s.two_sided = true;
    scene.surfaces.push_back(s);
    for (const auto& facet : face.facets) {
      Scene::Facet& out = scene.facets.emplace_back();
      out.surface = static_cast<Index>(scene.surfaces.size() - 1);
      for (const FlatComplex::Loop& loop : facet) {
        Scene::Loop& corners = out.loops.emplace_back();
        for (const Index p : loop) corners.push_back(point(p));
      }
    }
  }
  for (const PictureCells::Edge& edge : cells.edges) {
    Scene::Line line;
    line.look = Figure::Line::ghost;
    line.color = kInk;
    scene.lines.push_back(line);
    for (const auto& [a, b] : edge.segments) {
      scene.segments.push_back({static_cast<Index>(scene.lines.size() - 1), {point(a), point(b)}});
    }
  }
}

Scene without_crossings(const Scene& scene, int threads) {
  Soup soup;
  const LeafId leaf = soup.add_leaf(Fill::none);
  std::vector<PointId> points;
  for (const RationalPoint& p : scene.points) points.push_back(soup.add_point(p));
  for (Index i = 0; i < scene.facets.size(); ++i) {
    soup.add_face(leaf, soup_loops(scene.facets[i].loops, [&](Index p) { return points[p]; }), i, i);
  }
  for (Index i = 0; i < scene.segments.size(); ++i) {
    soup.add_wire(leaf, points[scene.segments[i].ends[0]], points[scene.segments[i].ends[1]], i);
  }
  const std::shared_ptr<const Complex> complex = build_complex(soup, {threads});
  Scene out = scene;
  out.facets.clear();
  out.segments.clear();
  std::vector<Index> numbers(complex->points.size(), kNone);
  const auto number = [&](VertexId v) {
    Index& n = numbers[v.index()];
    if (n == kNone) {
      n = static_cast<Index>(out.points.size());
      out.points.push_back(complex->points.rational(v));
    }
    return n;
  };
  for (const FaceId f : IdRange<FaceId>(complex->face_count())) {
    const auto loops = facet_loops<Scene::Loop>(*complex, f, number);
    for (const Cover& cover : complex->cover(f)) {
      Scene::Facet facet{scene.facets[complex->sources[cover.source].leaf_face].surface, loops};
      if (!cover.same) turn(facet.loops);
      out.facets.push_back(std::move(facet));
    }
  }
  for (const EdgeId e : IdRange<EdgeId>(complex->edge_count())) {
    for (const SegmentId s : complex->edge_segments[e]) {
      for (const WireId w : complex->segment_wires[s]) {
        const Index line = scene.segments[complex->wires[w].leaf_edge].line;
        out.segments.push_back({line, {number(complex->edge_ends[e][0]), number(complex->edge_ends[e][1])}});
      }
    }
  }
  return out;
}

}  // namespace cnrg
