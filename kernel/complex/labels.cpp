// Labels by propagation: crossing a face changes the region of the leaves that cover it, and of no other.
//
// A label set is a sorted list of (leaf, solid, value): the region for Fill::sides, the winding number (for
// Fill::solids one for each solid, else solid is 0), the parity. Sets and changes are interned, and the result of
// each change on each set is remembered, so that a large mesh costs one look-up per face, mostly in a small table
// of the latest. Every face is checked in the end, not only those of the spanning tree.
#include <algorithm>
#include <map>
#include <numeric>

#include "kernel/base/leaf_words.h"
#include "kernel/base/union_find.h"
#include "kernel/complex/builder.h"
#include "kernel/complex/region_order.h"

namespace cnrg {

namespace {

struct Value {
  LeafId leaf;
  std::uint32_t solid;  // Fill::solids; 0 otherwise
  std::int32_t number;
  bool is_of(LeafId other, std::uint32_t other_solid) const { return leaf == other && solid == other_solid; }
  friend auto operator<=>(const Value&, const Value&) = default;
};
using Values = std::vector<Value>;

/// What crossing a face from one side does to one leaf, or to one of its solids.
struct Change {
  LeafId leaf;
  Fill fill;
  std::uint32_t solid;
  // Fill::sides: regions named on both sides; winding and solids: `to` is added; parity: `to` is 0 or 1.
  std::int32_t from, to;
  friend auto operator<=>(const Change&, const Change&) = default;
};

class Labelling {
 public:
  Labelling(const Soup& soup, Complex& complex) : soup_(soup), c_(complex) {
    latest_.fill({{~std::uint64_t{0}, false}, kUnset});
  }

  void run() {
    seed();
    number_changes();
    spread();
    check();
    detect_cavities();
    store();
  }

 private:
  static constexpr std::uint32_t kUnset = 0xffffffffu;
  static constexpr std::uint32_t kConflict = 0xfffffffeu;

  std::uint32_t intern(Values values) {
    const auto [it, fresh] = numbers_.try_emplace(std::move(values), static_cast<std::uint32_t>(sets_.size()));
    if (fresh) sets_.push_back(&it->first);
    return it->second;
  }

  /// The changes when crossing a face with these covers from its front to its back, per leaf; throws if two covers
  /// contradict.
  void changes_of(std::span<const Cover> covers, std::vector<Change>& list) const {
    list.clear();
    for (const Cover& cover : covers) {
      const Soup::Face& source = c_.sources[cover.source];
      const Fill fill = c_.fills[source.leaf];
      const auto front = static_cast<std::int32_t>(cover.same ? source.front : source.back);
      const auto back = static_cast<std::int32_t>(cover.same ? source.back : source.front);
      if (fill == Fill::sides) list.push_back({source.leaf, fill, 0, front, back});
      if (fill == Fill::winding) list.push_back({source.leaf, fill, 0, 0, cover.same ? 1 : -1});
      if (fill == Fill::parity) list.push_back({source.leaf, fill, 0, 0, 1});
      if (fill != Fill::solids || front == back) continue;
      if (front != 0) list.push_back({source.leaf, fill, static_cast<std::uint32_t>(front), 0, -1});
      if (back != 0) list.push_back({source.leaf, fill, static_cast<std::uint32_t>(back), 0, 1});
    }
    if (list.size() < 2) return;
    std::sort(list.begin(), list.end());
    auto last = list.begin();
    for (auto x = last + 1; x != list.end(); ++x) {
      if (last->leaf != x->leaf || last->solid != x->solid) {
        *++last = *x;
      } else if (x->fill == Fill::winding || x->fill == Fill::solids) {
        last->to += x->to;
      } else if (x->fill == Fill::parity) {
        last->to ^= 1;
      } else if (*last != *x) {
        throw LeafError(face_names(covers, x->leaf) +
                        ": two faces lie on each other and name different regions "
                        "on one side; remove one or make their sides agree");
      }
    }
    list.erase(last + 1, list.end());
    std::erase_if(list, [](const Change& x) { return x.fill != Fill::sides && x.to == 0; });
  }

  /// Equal changes are one; neighbours among the covers of a leaf mostly are.
  void number_changes() {
    struct Latest {
      Change change{};
      std::uint32_t number = kUnset;
    };
    IdVector<LeafId, Latest> latest(c_.leaf_count);
    std::vector<Change> list;
    set_change_.resize(c_.covers.size());
    for (const SourceSetId set : IdRange<SourceSetId>(c_.covers.size())) {
      changes_of(std::as_const(c_.covers)[set], list);
      Latest* const memo = list.size() == 1 ? &latest[list[0].leaf] : nullptr;
      if (memo != nullptr && memo->number != kUnset && memo->change == list[0]) {
        set_change_[set] = memo->number;
        continue;
      }
      const auto [it, fresh] = change_numbers_.try_emplace(list, static_cast<std::uint32_t>(changes_.size()));
      if (fresh) changes_.push_back(&it->first);
      set_change_[set] = it->second;
      if (memo != nullptr) *memo = {list[0], it->second};
    }
  }

  std::uint32_t change(FaceId f) const { return set_change_[c_.face_cover[f]]; }

  /// The set after crossing with change `change`; kConflict if a leaf is not in the region that its face names.
  std::uint32_t cross(std::uint32_t set, std::uint32_t change, bool backwards) {
    const CrossingKey key(std::uint64_t{set} << 32 | change, backwards);
    Crossing& latest = latest_[((set * 31 + change) * 2 + (backwards ? 1 : 0)) % latest_.size()];
    if (latest.first != key) {
      auto it = crossed_.find(key);
      if (it == crossed_.end()) it = crossed_.emplace(key, crossing(set, change, backwards)).first;
      latest = *it;
    }
    return latest.second;
  }

  std::uint32_t crossing(std::uint32_t set, std::uint32_t change, bool backwards) {
    Values values = *sets_[set];
    bool conflict = false;
    for (const Change& x : *changes_[change]) {
      auto place = std::lower_bound(values.begin(), values.end(), x, [](const Value& v, const Change& change) {
        return v.leaf != change.leaf ? v.leaf < change.leaf : v.solid < change.solid;
      });
      const bool there = place != values.end() && place->is_of(x.leaf, x.solid);
      const std::int32_t now = there ? place->number : 0;
      std::int32_t then = 0;
      switch (x.fill) {
        case Fill::sides:
          conflict = conflict || now != (backwards ? x.to : x.from);
          then = backwards ? x.from : x.to;
          break;
        case Fill::winding:
        case Fill::solids: then = now + (backwards ? -x.to : x.to); break;
        case Fill::parity: then = now ^ x.to; break;
        case Fill::none:
        case Fill::cells: break;
      }
      if (there && then == 0) {
        values.erase(place);
      } else if (there) {
        place->number = then;
      } else if (then != 0) {
        values.insert(place, {x.leaf, x.solid, then});
      }
    }
    return conflict ? kConflict : intern(std::move(values));
  }

  void seed() {
    set_of_.assign(c_.region_count, kUnset);
    const std::uint32_t empty = intern({});
    set_of_[RegionId(0)] = empty;
    start_ = RegionId(0);
    if (c_.frame.valid()) {
      // The region inside the frame at its seed corner.
      Values values;
      for (const auto& [leaf, region] : soup_.seed_regions()) {
        if (region != 0) values.push_back({leaf, 0, static_cast<std::int32_t>(region)});
      }
      std::sort(values.begin(), values.end());
      const std::array<double, 3> corner{soup_.xyz(soup_.frame_seed())[0], soup_.xyz(soup_.frame_seed())[1],
                                         soup_.xyz(soup_.frame_seed())[2]};
      for (const VertexId v : c_.vertices) {
        const double* at = c_.points.doubles(v);
        if (at == nullptr || corner != std::array<double, 3>{at[0], at[1], at[2]}) continue;
        for (const EdgeId e : std::as_const(c_.vertex_edges)[v]) {
          for (const FaceUse& u : std::as_const(c_.edge_uses)[e]) {
            if (!c_.on_frame(u.face)) continue;
            const auto& regions = c_.face_regions[u.face];
            start_ = regions[0] == RegionId(0) ? regions[1] : regions[0];
          }
        }
      }
      require(start_ != RegionId(0), "the seed corner of the frame was not found; it must be three doubles");
      set_of_[start_] = intern(std::move(values));
    }
  }

  void spread() {
    std::vector<RegionId> queue{start_};
    const std::size_t all = c_.region_count - (c_.frame.valid() ? 1 : 0);  // nothing leads out of a frame
    for (std::size_t q = 0; q < queue.size() && queue.size() < all; ++q) {
      for (const HalfFace h : std::as_const(c_.region_faces)[queue[q]]) {
        if (c_.on_frame(h.face())) continue;
        const RegionId other = c_.region(h.opposite());
        if (set_of_[other] != kUnset) continue;
        const std::uint32_t set = cross(set_of_[queue[q]], change(h.face()), h.side() == 1);
        if (set == kConflict) conflict(h);
        set_of_[other] = set;
        queue.push_back(other);
      }
    }
    for (const std::uint32_t s : set_of_) require(s != kUnset, "a region was not reached by labels");
  }

  void check() {
    for (const FaceId f : IdRange<FaceId>(c_.face_count())) {
      if (c_.on_frame(f)) continue;
      const std::uint32_t front = set_of_[c_.face_regions[f][0]], back = set_of_[c_.face_regions[f][1]];
      if (cross(front, change(f), false) != back) conflict(HalfFace(f, 0));
    }
  }

  LeafWords face_names(std::span<const Cover> covers, LeafId leaf) const {
    LeafPlace place{leaf.value()};
    for (const Cover& cover : covers) {
      const Soup::Face& source = c_.sources[cover.source];
      if (source.leaf == leaf) place.faces.push_back(source.leaf_face);
    }
    return place;
  }

  std::int32_t value(std::uint32_t set, LeafId leaf, std::uint32_t solid = 0) const {
    for (const Value& v : *sets_[set]) {
      if (v.is_of(leaf, solid)) return v.number;
    }
    return 0;
  }

  static std::string region_name(std::int32_t region) {
    return region == 0 ? std::string("no region (0)") : "region " + std::to_string(region);
  }

  /// Says which faces contradict each other in the region before h.
  [[noreturn]] void conflict(HalfFace h) {
    const RegionId here = c_.region(h), there = c_.region(h.opposite());
    for (const HalfFace side : {h, h.opposite()}) {
      const RegionId r = side == h ? here : there;
      for (const Change& x : *changes_[change(h.face())]) {
        if (x.fill != Fill::sides) continue;
        const std::int32_t named = side.side() == 0 ? x.from : x.to;
        if (set_of_[r] == kUnset || value(set_of_[r], x.leaf) == named) continue;
        // Another face of the leaf that bounds the same cavity and names what propagation brought.
        for (const HalfFace g : std::as_const(c_.region_faces)[r]) {
          for (const Change& y : *changes_[change(g.face())]) {
            const std::int32_t other = g.side() == 0 ? y.from : y.to;
            if (y.leaf == x.leaf && y.fill == Fill::sides && other != named) {
              throw LeafError(face_names(c_.cover(h.face()), x.leaf) + ": its side names " + region_name(named) +
                              ", but " + face_names(c_.cover(g.face()), x.leaf) +
                              ", which bounds the same cavity, names " + region_name(other) +
                              "; correct the sides, or close the faces between the two");
            }
          }
        }
        throw LeafError(face_names(c_.cover(h.face()), x.leaf) + ": its side names " + region_name(named) +
                        ", but " + region_name(value(set_of_[r], x.leaf)) + " reaches it" +
                        (c_.unbounded(r) ? " from outside" : "") +
                        "; correct the sides, or close the faces between");
      }
    }
    // Not a face that names sides: some leaf that should be closed is open.
    if (set_of_[there] != kUnset) {
      const std::uint32_t expected = cross(set_of_[here], change(h.face()), h.side() == 1);
      for (const Value& v : *sets_[expected]) {
        if (v.number != value(set_of_[there], v.leaf, v.solid)) open_leaf(v.leaf);
      }
      for (const Value& v : *sets_[set_of_[there]]) {
        if (v.number != value(expected, v.leaf, v.solid)) open_leaf(v.leaf);
      }
    }
    throw InvariantError("labels differ across a face for no reason");
  }

  [[noreturn]] void open_leaf(LeafId leaf) const {
    throw LeafError(
        LeafWords(LeafPlace{leaf.value()}) +
        ": its faces do not close, so it has no inside; close the surface, or use fill: none or cells");
  }

  [[noreturn]] static void fail_overlap(LeafId leaf, std::uint32_t first, std::uint32_t second) {
    throw LeafError(LeafWords(LeafPlace{leaf.value(), {}, {first, second}}) +
                    ": these solids overlap; take them as leaves of their own and let one "
                    "dominate, or use fill: winding, which makes what they have in common a region");
  }

  /// Fill::cells: bounded cavities of the leaf's own faces, by where they are in its own coordinates: so what else
  /// is there and how the leaf was moved change no number.
  void detect_cavities() {
    for (std::size_t l = 0; l < c_.leaf_count; ++l) {
      const LeafId leaf(l);
      if (c_.fills[leaf] != Fill::cells) continue;
      UnionFind space(c_.region_count);
      std::vector<FaceId> walls;
      for (const FaceId f : IdRange<FaceId>(c_.face_count())) {
        bool wall = false;
        for (const Cover& x : c_.cover(f)) wall = wall || c_.sources[x.source].leaf == leaf;
        if (wall) walls.push_back(f);
        else space.unite(c_.face_regions[f][0].value(), c_.face_regions[f][1].value());
      }
      IdVector<RegionId, std::uint32_t> cavity(c_.region_count);  // 0: outside
      std::map<std::uint32_t, std::uint32_t> number{{space.find(0), 0}};
      for (const RegionId r : IdRange<RegionId>(c_.region_count)) {
        const auto fresh = static_cast<std::uint32_t>(number.size());
        cavity[r] = number.try_emplace(space.find(r.value()), fresh).first->second;
      }
      const std::vector<std::uint32_t> place = places_of_cavities(leaf, std::move(walls), cavity, number.size());
      for (const RegionId r : IdRange<RegionId>(c_.region_count)) {
        if (cavity[r] == 0) continue;
        Values values = *sets_[set_of_[r]];
        values.insert(std::lower_bound(values.begin(), values.end(), Value{leaf, 0, 0}),
                      {leaf, 0, static_cast<std::int32_t>(place[cavity[r]])});
        set_of_[r] = intern(std::move(values));
      }
    }
  }

  /// Cavities come numbered by their first regions, which is their order in x, y and z.
  std::vector<std::uint32_t> places_of_cavities(LeafId leaf, std::vector<FaceId> walls,
                                                const IdVector<RegionId, std::uint32_t>& cavity,
                                                std::size_t count) const {
    std::vector<std::uint32_t> place(count);
    std::iota(place.begin(), place.end(), 0u);
    const LeafAxes* const axes = soup_.own_axes(leaf);
    if (axes == nullptr || count <= 2) return place;
    const BodiesOfSpace bodies{std::move(walls), [&](HalfFace h) { return cavity[c_.region(h)]; },
                               static_cast<std::uint32_t>(count)};
    std::uint32_t next = 0;
    for (const std::uint32_t body : in_order_of_place(c_, bodies, axes)) place[body] = ++next;
    return place;
  }

  void store() {
    c_.leaf_regions.assign(c_.leaf_count, 0);
    c_.region_labels.resize(c_.region_count);
    std::map<std::vector<Label>, LabelSetId> stored;
    std::vector<LabelSetId> by_set(sets_.size());
    for (const RegionId r : IdRange<RegionId>(c_.region_count)) {
      LabelSetId& id = by_set[set_of_[r]];
      if (!id.valid()) {
        std::vector<Label> labels;
        for (const auto& [leaf, solid, number] : *sets_[set_of_[r]]) {
          const bool numbered = c_.fills[leaf] == Fill::sides || c_.fills[leaf] == Fill::cells;
          const std::uint32_t region = solid != 0 ? solid : numbered ? static_cast<std::uint32_t>(number) : 1u;
          if (!labels.empty() && labels.back().leaf == leaf) fail_overlap(leaf, labels.back().region, region);
          labels.push_back({leaf, region});
        }
        const auto [it, fresh] = stored.try_emplace(labels, LabelSetId());
        if (fresh) it->second = c_.label_sets.push_back(labels);
        id = it->second;
        for (const Label& label : labels) {
          c_.leaf_regions[label.leaf] = std::max(c_.leaf_regions[label.leaf], label.region);
        }
      }
      c_.region_labels[r] = id;
    }
  }

  const Soup& soup_;
  Complex& c_;
  std::map<Values, std::uint32_t> numbers_;
  std::vector<const Values*> sets_;
  std::map<std::vector<Change>, std::uint32_t> change_numbers_;
  std::vector<const std::vector<Change>*> changes_;
  IdVector<SourceSetId, std::uint32_t> set_change_;
  using CrossingKey = std::pair<std::uint64_t, bool>;  // set and change; backwards
  using Crossing = std::pair<CrossingKey, std::uint32_t>;
  std::map<CrossingKey, std::uint32_t> crossed_;
  std::array<Crossing, 256> latest_;  // of crossed_
  IdVector<RegionId, std::uint32_t> set_of_;
  RegionId start_;
};

}  // namespace

void label_regions(const Soup& soup, Complex& complex) { Labelling(soup, complex).run(); }

}  // namespace cnrg
