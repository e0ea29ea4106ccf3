// From edges of the complex to pairs of facets, from these to boxes of parameters; see the header.
#include "csg/evaluate/transversality.h"

#include <algorithm>
#include <map>
#include <memory>
#include <tuple>

#include "csg/curves/surface_placed.h"
#include "kernel/base/parallel.h"
#include "kernel/base/union_find.h"

namespace cnrg {
namespace {

using namespace surface_math;

constexpr int kHalvings = 8;
constexpr int kMostFiner = 10;  // powers of two
constexpr std::size_t kMostPairs = 4096;

using PatchKey = std::pair<LeafId, std::uint32_t>;
using PatchPair = std::array<PatchKey, 2>;

/// An edge on which facets of two leaves cross.
struct Contact {
  EdgeId edge;
  std::array<SourceId, 2> facets;
};

/// Surfaces of patches, made when they are first asked for; not by threads.
class Surfaces {
 public:
  explicit Surfaces(const SurfaceParameters& parameters) : parameters_(parameters) {}
  /// Null for what is flat.
  const PlacedSurface* of(const Soup::Face& face) {
    const auto [it, is_new] = known_.try_emplace({face.leaf, face.patch});
    if (is_new) {
      it->second = std::make_unique<const PlacedSurface>(parameters_.surfaces(face.leaf), face.patch,
                                                         parameters_.transform(face.leaf));
    }
    return it->second->flat() ? nullptr : it->second.get();
  }

 private:
  const SurfaceParameters& parameters_;
  std::map<PatchKey, std::unique_ptr<const PlacedSurface>> known_;
};

/// A facet as far as it is asked about.
struct Facet {
  const PlacedSurface* surface = nullptr;
  Vector3<Interval> point{}, normal{};  ///< of a flat one
  std::vector<std::array<Interval, 2>> boxes;
};

std::vector<SurfacePart> parts_of(const Facet& facet) {
  if (facet.surface == nullptr) return {{nullptr, 0, 0, facet.point, facet.normal}};
  std::vector<SurfacePart> parts;
  for (const auto& [u, v] : facet.boxes) parts.push_back(SurfacePart::of(*facet.surface, u, v));
  return parts;
}

bool cross_everywhere(const Facet& a, const Facet& b) {
  for (const SurfacePart& x : parts_of(a)) {
    for (const SurfacePart& y : parts_of(b)) {
      if (!nowhere_parallel(x, y, kHalvings)) return false;
    }
  }
  return true;
}

class Examination {
 public:
  Examination(const Complex& complex, const SurfaceParameters& parameters,
              const std::function<bool(EdgeId)>& asked, bool at_vertices)
      : complex_(complex),
        parameters_(parameters),
        asked_(asked),
        at_vertices_(at_vertices),
        surfaces_(parameters) {}

  Transversality run(std::size_t described) {
    collect();
    Transversality result;
    result.edges = crossing_edges_;
    examine();
    if (!at_vertices_) {
      std::erase_if(contacts_, [&](const Contact& contact) { return only_at_a_vertex(contact); });
    }
    result.places = places();
    for (std::size_t i = 0; i < std::min(described, result.places.size()); ++i) describe(result.places[i]);
    return result;
  }

 private:
  /// A facet around an edge, and whether it covers the faces on both sides of it.
  struct Around {
    PatchKey patch;
    SourceId facet;
    FaceId face;
  };

  bool on_boundary(EdgeId e, SourceId facet) const {
    for (const SegmentId s : complex_.edge_segments[e]) {
      const auto faces = complex_.segment_faces[s];
      if (std::find(faces.begin(), faces.end(), facet) != faces.end()) return true;
    }
    return false;
  }

  void collect() {
    std::vector<char> curved(complex_.leaf_count);
    for (std::size_t i = 0; i < curved.size(); ++i) {
      const std::shared_ptr<const LeafSurfaces> surfaces = parameters_.surfaces(LeafId(i));
      curved[i] = surfaces != nullptr && !surfaces->patches().empty();
    }
    if (std::find(curved.begin(), curved.end(), 1) == curved.end()) return;
    std::vector<Around> around;
    for (const EdgeId e : IdRange<EdgeId>(complex_.edge_count())) {
      around.clear();
      bool any = false, several = false;
      for (const FaceUse& use : complex_.edge_uses[e]) {
        for (const Cover& cover : complex_.cover(use.face)) {
          const Soup::Face& of = complex_.sources[cover.source];
          if (of.leaf == complex_.frame) continue;
          any = any || curved[of.leaf.index()];
          several = several || (!around.empty() && around[0].patch.first != of.leaf);
          around.push_back({{of.leaf, of.patch}, cover.source, use.face});
        }
      }
      if (any && several && asked_(e)) add_contacts(e, around);
    }
    std::sort(contacts_.begin(), contacts_.end(), [](const Contact& a, const Contact& b) {
      return std::tie(a.facets, a.edge) < std::tie(b.facets, b.edge);
    });
  }

  /// The pairs of patches of different leaves at an edge, unless both contain it.
  void add_contacts(EdgeId e, std::vector<Around>& around) {
    std::sort(around.begin(), around.end(), [](const Around& a, const Around& b) {
      return std::tie(a.patch, a.facet, a.face) < std::tie(b.patch, b.facet, b.face);
    });
    struct Patch {
      std::size_t first, last;
      bool flat, contains;
      std::uint32_t surface;
    };
    std::vector<Patch> patches;
    for (std::size_t i = 0, j; i < around.size(); i = j) {
      bool contains = true;
      for (j = i; j < around.size() && around[j].patch == around[i].patch; ++j)
        contains = contains && on_boundary(e, around[j].facet);
      const bool flat = surfaces_.of(complex_.sources[around[i].facet]) == nullptr;
      patches.push_back({i, j, flat, contains, complex_.sources[around[i].facet].surface});
    }
    bool crossing = false;
    for (std::size_t i = 0; i < patches.size(); ++i) {
      for (std::size_t j = i + 1; j < patches.size(); ++j) {
        const Patch &a = patches[i], &b = patches[j];
        if (around[a.first].patch.first == around[b.first].patch.first || (a.flat && b.flat)) continue;
        crossing = true;
        const bool overlap = share_a_face(around, a, b);
        const bool both = (a.flat || a.contains) && (b.flat || b.contains);
        // Surfaces that are one and drawn alike overlap or end in each other; where their facets cross, they are
        // not.
        const bool one_surface = a.surface != 0 && a.surface == b.surface;
        if (overlap && (one_surface || (!a.flat && !b.flat && same_facets(around, a, b)))) continue;
        if (!overlap && both) continue;
        if (!overlap && (a.contains || b.contains) &&
            touch(e, around[a.first].patch.first, around[b.first].patch.first)) {
          continue;
        }
        for (std::size_t x = a.first; x < a.last; ++x) {
          for (std::size_t y = b.first; y < b.last; ++y) {
            if (x > a.first && around[x].facet == around[x - 1].facet) continue;
            if (y > b.first && around[y].facet == around[y - 1].facet) continue;
            contacts_.push_back({e, {around[x].facet, around[y].facet}});
          }
        }
      }
    }
    crossing_edges_ += crossing ? 1 : 0;
  }

  /// True if all faces of one leaf about the edge are on one side of those of the other.
  bool touch(EdgeId e, LeafId a, LeafId b) const {
    std::vector<bool> order;  // radial; true for a
    for (const FaceUse& use : complex_.edge_uses[e]) {
      bool of_a = false, of_b = false;
      for (const Cover& cover : complex_.cover(use.face)) {
        of_a = of_a || complex_.sources[cover.source].leaf == a;
        of_b = of_b || complex_.sources[cover.source].leaf == b;
      }
      if (of_a && of_b) return false;
      if (of_a || of_b) order.push_back(of_a);
    }
    std::size_t changes = 0;
    for (std::size_t i = 0; i < order.size(); ++i) changes += order[i] != order[(i + 1) % order.size()];
    return changes <= 2;
  }

  /// Of curved patches with a face in common, whose surfaces are not known to be one: true if the facets that have
  /// faces in common are the same. Else it is a chord that two surfaces have in common.
  template <class Patch>
  bool same_facets(const std::vector<Around>& around, const Patch& a, const Patch& b) {
    for (std::size_t x = a.first; x < a.last; ++x) {
      for (std::size_t y = b.first; y < b.last; ++y) {
        if (around[x].face == around[y].face && faces_of(around[x].facet) != faces_of(around[y].facet))
          return false;
      }
    }
    return true;
  }

  /// The faces that cover a facet, ascending.
  const std::vector<FaceId>& faces_of(SourceId facet) {
    if (faces_.size() == 0) {
      faces_.resize(complex_.sources.size());
      for (const FaceId f : IdRange<FaceId>(complex_.face_count())) {
        for (const Cover& cover : complex_.cover(f)) faces_[cover.source].push_back(f);
      }
    }
    return faces_[facet];
  }

  template <class Patch>
  static bool share_a_face(const std::vector<Around>& around, const Patch& a, const Patch& b) {
    for (std::size_t x = a.first; x < a.last; ++x) {
      for (std::size_t y = b.first; y < b.last; ++y) {
        if (around[x].face == around[y].face) return true;
      }
    }
    return false;
  }

  /// Leaves of `contacts_` those that are uncertain.
  void examine() {
    for (const Contact& contact : contacts_) {
      for (const SourceId s : contact.facets) facets_.try_emplace(s);
    }
    std::vector<std::pair<SourceId, Facet*>> all;
    for (auto& [s, facet] : facets_) {
      facet.surface = surfaces_.of(complex_.sources[s]);
      all.emplace_back(s, &facet);
    }
    for_each_index(
        all.size(),
        [&](std::size_t i) {
          const auto& [s, facet] = all[i];
          if (facet->surface == nullptr) return;
          for (const auto& [u, v] : parameters_.boxes(s))
            facet->boxes.push_back({Interval(u[0], u[1]), Interval(v[0], v[1])});
        },
        64);
    set_planes();
    std::vector<std::size_t> first;  // of the contacts of each pair of facets
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      if (i == 0 || contacts_[i].facets != contacts_[i - 1].facets) first.push_back(i);
    }
    std::vector<char> certain(first.size());
    for_each_index(
        first.size(),
        [&](std::size_t k) {
          const auto& [a, b] = contacts_[first[k]].facets;
          certain[k] = cross_everywhere(facets_.at(a), facets_.at(b));
        },
        64);
    std::vector<Contact> uncertain;
    for (std::size_t k = 0; k < first.size(); ++k) {
      const std::size_t end = k + 1 < first.size() ? first[k + 1] : contacts_.size();
      if (!certain[k])
        uncertain.insert(uncertain.end(), contacts_.begin() + static_cast<std::ptrdiff_t>(first[k]),
                         contacts_.begin() + static_cast<std::ptrdiff_t>(end));
    }
    contacts_ = std::move(uncertain);
  }

  /// The normals of flat facets: those of the faces of the complex in them.
  void set_planes() {
    for (const Contact& contact : contacts_) {
      for (const FaceUse& use : complex_.edge_uses[contact.edge]) {
        for (const Cover& cover : complex_.cover(use.face)) {
          const auto it = facets_.find(cover.source);
          if (it == facets_.end() || it->second.surface != nullptr) continue;
          std::array<double, 3> low, high;
          complex_.points.normal(complex_.plane(use.face), low, high);
          const VertexId v = complex_.points.plane_points(complex_.plane(use.face))[0];
          for (std::size_t k = 0; k < 3; ++k) {
            it->second.normal[k] = Interval(low[k], high[k]);
            it->second.point[k] =
                Interval(complex_.points.lower(v)[k], complex_.points.upper(v, static_cast<int>(k)));
          }
        }
      }
    }
  }

  PatchPair patches_of(const Contact& contact) const {
    const auto key = [&](SourceId s) { return PatchKey(complex_.sources[s].leaf, complex_.sources[s].patch); };
    return {key(contact.facets[0]), key(contact.facets[1])};
  }

  std::vector<UncertainPlace> places() {
    std::map<PatchPair, std::vector<EdgeId>> by_patches;
    for (const Contact& contact : contacts_) by_patches[patches_of(contact)].push_back(contact.edge);
    std::vector<UncertainPlace> result;
    for (auto& [patches, edges] : by_patches) {
      std::sort(edges.begin(), edges.end());
      edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
      UnionFind sets(edges.size());
      std::map<VertexId, std::uint32_t> met;
      for (std::uint32_t i = 0; i < edges.size(); ++i) {
        for (const VertexId v : complex_.edge_ends[edges[i]]) sets.unite(i, met.try_emplace(v, i).first->second);
      }
      std::map<std::uint32_t, std::vector<EdgeId>> parts;
      for (std::uint32_t i = 0; i < edges.size(); ++i) parts[sets.find(i)].push_back(edges[i]);
      for (auto& [root, part] : parts) {
        result.push_back({{patches[0].first, patches[1].first},
                          {patches[0].second, patches[1].second},
                          std::move(part),
                          {},
                          0});
      }
    }
    return result;
  }

  struct Pair {
    SurfacePart a, b;
  };
  /// How far the part's box reaches; a plane has no end.
  static double size_of(const SurfacePart& part) {
    if (part.surface == nullptr) return HUGE_VAL;
    double size = 0;
    for (const Interval& x : part.point) size += x.sup() - x.inf();
    return size;
  }
  std::vector<Pair> pairs_of(const Contact& contact) const {
    std::vector<Pair> pairs;
    for (const SurfacePart& a : parts_of(facets_.at(contact.facets[0]))) {
      for (const SurfacePart& b : parts_of(facets_.at(contact.facets[1]))) pairs.push_back({a, b});
    }
    return pairs;
  }
  static std::vector<Pair> uncertain_quarters(const std::vector<Pair>& pairs) {
    std::vector<Pair> open;
    for (const Pair& pair : pairs) {
      const std::vector<SurfacePart> of_b = quarters(pair.b);
      for (const SurfacePart& a : quarters(pair.a)) {
        for (const SurfacePart& b : of_b) {
          if (may_meet(a, b) && !nowhere_parallel(a, b, 2)) open.push_back({a, b});
        }
      }
    }
    return open;
  }

  /// True if both facets have an end of the edge on their boundaries, and the surfaces are transversal but there:
  /// of quarters of quarters, five times, all that stay uncertain are at most their own size away from it.
  bool only_at_a_vertex(const Contact& contact) const {
    constexpr int kTimes = 5;
    std::vector<VertexId> common;
    for (const VertexId v : complex_.edge_ends[contact.edge]) {
      const auto edges = complex_.vertex_edges[v];
      const auto has = [&](SourceId facet) {
        return std::any_of(edges.begin(), edges.end(), [&](EdgeId e) { return on_boundary(e, facet); });
      };
      if (has(contact.facets[0]) && has(contact.facets[1])) common.push_back(v);
    }
    if (common.empty()) return false;
    std::vector<Pair> pairs = pairs_of(contact);
    for (int k = 0; k < kTimes && pairs.size() < kMostPairs; ++k) pairs = uncertain_quarters(pairs);
    const auto near = [&](const SurfacePart& part, VertexId v) {
      if (part.surface == nullptr) return true;
      const double* p = complex_.points.lower(v);
      for (std::size_t i = 0; i < 3; ++i) {
        const double size = part.point[i].sup() - part.point[i].inf();
        if (p[i] < part.point[i].inf() - size || p[i] > part.point[i].sup() + size) return false;
      }
      return true;
    };
    return std::all_of(pairs.begin(), pairs.end(), [&](const Pair& pair) {
      return std::any_of(common.begin(), common.end(),
                         [&](VertexId v) { return near(pair.a, v) && near(pair.b, v); });
    });
  }

  /// The least k for which facets 2^k times finer prove a contact transversal; kMostFiner + 1 if none does. Cells
  /// are quartered, and pairs of them that are apart or nowhere parallel are done with; `at` is where the last
  /// ones are.
  int needed(const Contact& contact, Vector3<double>& at) const {
    std::vector<Pair> pairs = pairs_of(contact);
    for (int k = 1; k <= kMostFiner && pairs.size() < kMostPairs; ++k) {
      std::vector<Pair> open = uncertain_quarters(pairs);
      pairs.swap(open);
      const std::vector<Pair>& last = pairs.empty() ? open : pairs;
      const Pair& one = last[last.size() / 2];
      const SurfacePart& small = size_of(one.a) < size_of(one.b) ? one.a : one.b;
      for (std::size_t i = 0; i < 3; ++i) at[i] = constant(small.point[i]).value;
      if (pairs.empty()) return k;
    }
    return kMostFiner + 1;
  }

  void describe(UncertainPlace& place) const {
    int most = 0;
    for (const Contact& contact : contacts_) {
      if (patches_of(contact) != PatchPair{PatchKey(place.leaves[0], place.patches[0]),
                                           PatchKey(place.leaves[1], place.patches[1])} ||
          !std::binary_search(place.edges.begin(), place.edges.end(), contact.edge)) {
        continue;
      }
      Vector3<double> at;
      const int k = needed(contact, at);
      if (k > most) most = k, place.at = at;
      if (k > kMostFiner) break;
    }
    place.finer = most > kMostFiner ? 0 : 1 << most;
  }

  const Complex& complex_;
  const SurfaceParameters& parameters_;
  const std::function<bool(EdgeId)>& asked_;
  const bool at_vertices_;
  Surfaces surfaces_;
  std::vector<Contact> contacts_;  // by facets, then edges
  std::map<SourceId, Facet> facets_;
  std::size_t crossing_edges_ = 0;
  IdVector<SourceId, std::vector<FaceId>> faces_;  // once they are asked for
};

}  // namespace

Transversality transversality(const Complex& complex, const SurfaceParameters& parameters, std::size_t described,
                              const std::function<bool(EdgeId)>& asked, bool at_vertices) {
  return Examination(complex, parameters, asked, at_vertices).run(described);
}

}  // namespace cnrg
