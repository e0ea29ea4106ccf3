// Faces laid out, edges cut, loops of pieces; see the header.
#include "csg/exports/occt_layout.h"

#include <Standard_Failure.hxx>
#include <algorithm>

#include "kernel/base/error.h"
#include "kernel/base/sorted.h"

namespace cnrg::occt {
namespace {

using Index = CadParts::Index;

template <class T>
void add_once(std::vector<T>& list, const T& value) {
  if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(value);
}

std::string words_of(const Standard_Failure& failure) {
  const std::string words = failure.GetMessageString() != nullptr ? failure.GetMessageString() : "";
  return std::string("OpenCASCADE fails with ") + failure.DynamicType()->Name() +
         (words.empty() ? "" : ", " + words);
}

/// True if the three points are on a line, but for what doubles round.
bool straight(const CadPoint& a, const CadPoint& b, const CadPoint& c) {
  double ab = 0, bc = 0, dot = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    ab += (b[k] - a[k]) * (b[k] - a[k]);
    bc += (c[k] - b[k]) * (c[k] - b[k]);
    dot += (b[k] - a[k]) * (c[k] - b[k]);
  }
  return dot > 0 && ab * bc - dot * dot <= 1e-22 * ab * bc;
}

}  // namespace

CadLayout::CadLayout(const CadParts& parts, const Faceted& faceted, Faceted& failed)
    : parts_(parts), faceted_(faceted), failed_(failed), vertex_(parts.points.size(), 0) {
  for (const FlatComplex::Vertex& vertex : parts.flat.vertices) vertex_[vertex.point] = 1;
  add_edges();
  for (Index f = 0; f < parts.faces.size(); ++f) {
    if (faceted.count(f) != 0 || (!parts.faces[f].surface && !parts.faces[f].flat)) lay_facets(f);
    else lay_face(f);
  }
  if (!failed_.empty()) return;
  add_seams();
  cut_chains();
  for (std::size_t i = 0; i < faces_.size(); ++i) add_uses(i);
  if (failed_.empty()) find_charts();
}

std::optional<CadParameters> CadLayout::near(const Chart* chart, Index point) const {
  const auto it = near_.find({chart, point});
  return it == near_.end() ? std::nullopt : std::optional(it->second);
}

const Chart* CadLayout::chart_of_surface(Index surface) {
  const auto known = chart_of_.find(surface);
  if (known != chart_of_.end()) return known->second;
  return chart_of_[surface] = &charts_.emplace_back(parts_.surfaces[surface], parts_.size);
}

void CadLayout::lay_face(Index source) {
  const CadParts::Face& face = parts_.faces[source];
  std::vector<const CadParts::Facet*> facets;
  for (const CadParts::Facet& facet : face.facets) facets.push_back(&facet);
  try {
    const Chart* chart =
        face.surface ? chart_of_surface(*face.surface) : &charts_.emplace_back(face.facets[0].plane, parts_.size);
    add_face(source, chart, facets, parts_.flat.faces[source].isolated);
  } catch (const Standard_Failure& failure) {
    failed_[source] = words_of(failure);
  } catch (const InputError& error) {
    failed_[source] = error.what();
  }
}

/// Each facet is a face, and each corner a vertex.
void CadLayout::lay_facets(Index source) {
  const FlatComplex::Face& flat = parts_.flat.faces[source];
  const std::vector<CadParts::Facet>& facets = parts_.faces[source].facets;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    for (const FlatComplex::Loop& loop : facets[i].loops) {
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const Index a = loop[k], b = loop[(k + 1) % loop.size()];
        vertex_[a] = 1;
        if (sides_.count({a, b}) != 0) continue;
        chains_.push_back({{a, b}, std::nullopt, false});
        sides_.insert({a, b});
        sides_.insert({b, a});
      }
    }
    add_face(source, &charts_.emplace_back(facets[i].plane, parts_.size), {&facets[i]},
             flat.facets.empty() ? flat.isolated : flat.facets[i].isolated);
  }
}

void CadLayout::add_face(Index source, const Chart* chart, std::vector<const CadParts::Facet*> facets,
                         std::span<const Index> isolated) {
  std::vector<UnrollFacet> unroll_facets;
  std::optional<CadParameters> last;
  for (const CadParts::Facet* facet : facets) {
    UnrollFacet& to = unroll_facets.emplace_back();
    for (const FlatComplex::Loop& loop : facet->loops) {
      to.emplace_back();
      for (const Index p : loop) {
        const auto given = facet->near.find(p);
        const auto at = chart->place(parts_.points[p], given != facet->near.end() ? given->second : last);
        if (!at) {
          failed_[source] = "no place on its surface was found for one of its points";
          return;
        }
        last = at;
        to.back().push_back({p, *at, {chart->is_free(0, *at), chart->is_free(1, *at)}});
        if (to.back().back().free[0] || to.back().back().free[1]) vertex_[p] = 1;
        near_.try_emplace({chart, p}, *at);
      }
    }
  }
  std::optional<Unrolled> unrolled = unroll(unroll_facets, chart->period(), chart->slack());
  if (!unrolled) {
    failed_[source] = "its facets cannot be laid out in the parameters of its surface";
    return;
  }
  LaidFace& face = faces_.emplace_back();
  face.source = source;
  face.chart = chart;
  face.same = unrolled->area > 0;
  face.isolated.assign(isolated.begin(), isolated.end());
  unrolled_.push_back(std::move(*unrolled));
}

void CadLayout::add_edges() {
  for (Index e = 0; e < parts_.flat.edges.size(); ++e) {
    const FlatComplex::Edge& edge = parts_.flat.edges[e];
    std::vector<Index> points(edge.points.begin(), edge.points.end());
    if (edge.closed) points.push_back(points.front());
    else vertex_[points.front()] = vertex_[points.back()] = 1;
    const CadParts::Edge& of = parts_.edges[e];
    const bool bends = of.surfaces.empty() && !of.curve;
    for (std::size_t i = 1; i < points.size(); ++i) {
      sides_.insert({points[i - 1], points[i]});
      sides_.insert({points[i], points[i - 1]});
      if (!bends) continue;
      const Index next = i + 1 < points.size() ? points[i + 1] : edge.closed ? points[1] : points[i];
      if (next != points[i] &&
          !straight(parts_.points[points[i - 1]], parts_.points[points[i]], parts_.points[next]))
        vertex_[points[i]] = 1;
    }
    chains_.push_back({std::move(points), e, false});
  }
}

/// Sides of a seam, joined to lines from vertex to vertex.
void CadLayout::add_seams() {
  std::vector<char> on_edge(parts_.points.size(), 0);
  for (const auto& [a, b] : sides_) on_edge[a] = 1;
  for (const Unrolled& unrolled : unrolled_) {
    std::map<Index, std::vector<Index>> next;
    for (const auto& [a, b] : unrolled.seams) {
      if (sides_.count({a, b}) != 0) continue;
      next[a].push_back(b);
      next[b].push_back(a);
    }
    for (const auto& [p, others] : next) {
      if (others.size() != 2 || on_edge[p]) vertex_[p] = 1;
    }
    std::set<std::array<Index, 2>> done;
    const auto follow = [&](Index from, Index to) {
      Chain chain{{from}, std::nullopt, true};
      while (done.insert({from, to}).second) {
        done.insert({to, from});
        chain.points.push_back(to);
        if (vertex_[to]) break;
        const auto& others = next.at(to);
        const Index after = others[0] == from ? others[1] : others[0];
        from = to, to = after;
      }
      if (chain.points.size() > 1) chains_.push_back(std::move(chain));
    };
    for (const bool from_vertex : {true, false}) {
      for (const auto& [p, others] : next) {
        if (from_vertex && !vertex_[p]) continue;
        for (const Index q : others) {
          if (done.count({p, q}) == 0) follow(p, q);
        }
      }
    }
  }
}

void CadLayout::cut_chains() {
  pieces_of_.resize(parts_.flat.edges.size());
  for (Chain& chain : chains_) {
    std::vector<Index>& points = chain.points;
    std::vector<double> at;
    if (chain.edge && parts_.edges[*chain.edge].curve) at = parts_.edges[*chain.edge].at;
    if (points.front() == points.back()) {
      points.pop_back();
      auto first = std::find_if(points.begin(), points.end(), [&](Index p) { return vertex_[p] != 0; });
      if (first == points.end()) first = points.begin();
      vertex_[*first] = 1;
      if (!at.empty()) {
        // The curve closes where its parameter jumps.
        const auto k = first - points.begin();
        std::rotate(at.begin(), at.begin() + k, at.end());
      }
      std::rotate(points.begin(), first, points.end());
      points.push_back(points.front());
      if (!at.empty()) at.push_back(at.front());
    }
    for (std::size_t i = 0; i + 1 < points.size();) {
      Piece piece;
      piece.points = {points[i]};
      if (!at.empty()) piece.at = {at[i]};
      do {
        ++i;
        piece.points.push_back(points[i]);
        if (!at.empty()) piece.at.push_back(at[i]);
      } while (!vertex_[points[i]]);
      piece.seam = chain.seam;
      piece.edge = chain.edge;
      const Index number = Index(pieces_.size());
      for (std::size_t k = 1; k < piece.points.size(); ++k) {
        piece_at_[{piece.points[k - 1], piece.points[k]}] = {number, true};
        piece_at_[{piece.points[k], piece.points[k - 1]}] = {number, false};
      }
      if (chain.edge) pieces_of_[*chain.edge].push_back(number);
      pieces_.push_back(std::move(piece));
    }
  }
}

void CadLayout::add_uses(std::size_t number) {
  LaidFace& face = faces_[number];
  const auto fail = [&] { failed_[face.source] = "its boundary is no chain of edges"; };
  for (std::vector<Unrolled::Step> steps : unrolled_[number].loops) {
    const auto first =
        std::find_if(steps.begin(), steps.end(), [&](const auto& s) { return vertex_[s.from.point]; });
    if (first == steps.end()) return fail();
    std::rotate(steps.begin(), first, steps.end());
    std::vector<PieceUse>& loop = face.loops.emplace_back();
    for (const Unrolled::Step& step : steps) {
      const auto found = piece_at_.find({step.from.point, step.to.point});
      if (found == piece_at_.end()) return fail();
      const auto& [piece, forward] = found->second;
      if (vertex_[step.from.point]) loop.push_back({piece, forward, {step.from}});
      if (loop.back().piece != piece) return fail();
      loop.back().corners.push_back(step.to);
    }
  }
  std::map<Index, std::map<Index, UnrollCorner>> inner;  // corners by piece and point
  for (const Unrolled::Step& step : unrolled_[number].inner) {
    const auto found = piece_at_.find({step.from.point, step.to.point});
    if (found == piece_at_.end()) continue;
    auto& corners = inner[found->second.first];
    corners.try_emplace(step.from.point, step.from);
    corners.try_emplace(step.to.point, step.to);
  }
  for (const auto& [piece, corners] : inner) {
    PieceUse& use = face.inner.emplace_back(PieceUse{piece, true, {}});
    for (const Index p : pieces_[piece].points) {
      if (corners.count(p) == 0) return fail();
      use.corners.push_back(corners.at(p));
    }
  }
}

void CadLayout::find_charts() {
  std::vector<std::set<Index>> not_on(pieces_.size());  // surfaces that faces there do not have
  for (const LaidFace& face : faces_) {
    const auto add = [&](Index piece) {
      add_once(pieces_[piece].charts, face.chart);
      const auto& surface = parts_.faces[face.source].surface;
      if (surface && faceted_.count(face.source) != 0) not_on[piece].insert(*surface);
    };
    for (const auto& loop : face.loops) {
      for (const PieceUse& use : loop) add(use.piece);
    }
    for (const PieceUse& use : face.inner) add(use.piece);
  }
  for (Index i = 0; i < pieces_.size(); ++i) {
    if (!pieces_[i].edge || !not_on[i].empty()) continue;
    for (const Index surface : parts_.edges[*pieces_[i].edge].surfaces) {
      try {
        add_once(pieces_[i].charts, chart_of_surface(surface));
      } catch (const Standard_Failure&) {  // what no face is on need not be there
      } catch (const InputError&) {
      }
    }
  }
  charts_at_.resize(parts_.points.size());
  for (const Piece& piece : pieces_) {
    for (const Index end : {piece.points.front(), piece.points.back()}) {
      for (const Chart* chart : piece.charts) add_once(charts_at_[end], chart);
    }
  }
  for (const LaidFace& face : faces_) {
    for (const Index p : face.isolated) add_once(charts_at_[p], face.chart);
  }
}

}  // namespace cnrg::occt
