// Measures of a part, and the union of parts in one group.
#include "csg/operators/parts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

#include "csg/operators/cell_sources.h"
#include "kernel/base/error.h"
#include "kernel/complex/by_dimension.h"
#include "kernel/selection/measure.h"

namespace cnrg {
namespace {

using Parts = std::vector<PartRef>;
using SetMap = LeafSetMap<LeafSets, LeafSets>;
constexpr float kFloatInfinity = std::numeric_limits<float>::infinity();

// A plane has no vertex but those on the frame, which are no entities.
bool empty(const Group& g) { return g.cells.empty() && !g.has_entities(); }

bool reaches_frame(const Complex& complex, const Group& g) {
  if (!complex.frame.valid()) return false;
  const auto on_frame = [&](VertexId v) { return complex.on_frame(v); };
  return std::ranges::any_of(g.faces,
                             [&](FaceId f) {
                               return std::ranges::any_of(complex.half_edges(f), on_frame,
                                                          [&](HalfEdge h) { return complex.origin(h); });
                             }) ||
         std::ranges::any_of(g.edges,
                             [&](EdgeId e) { return std::ranges::any_of(complex.edge_ends[e], on_frame); });
}

float rounded_down(double x) {
  const auto f = static_cast<float>(x);  // infinite when it is out of range
  return f <= x ? f : std::nextafter(f, -kFloatInfinity);
}
float rounded_up(double x) {
  const auto f = static_cast<float>(x);
  return f >= x ? f : std::nextafter(f, kFloatInfinity);
}

// Entities and bounded regions lie in the hull of the vertices.
PartBox box_of(const Complex& complex, const Group& g) {
  const bool unbounded =
      std::any_of(g.cells.begin(), g.cells.end(), [&](const auto& cell) { return complex.unbounded(cell.first); });
  if (unbounded || reaches_frame(complex, g)) {
    return {{-kFloatInfinity, -kFloatInfinity, -kFloatInfinity}, {kFloatInfinity, kFloatInfinity, kFloatInfinity}};
  }
  PartBox box{{kFloatInfinity, kFloatInfinity, kFloatInfinity},
              {-kFloatInfinity, -kFloatInfinity, -kFloatInfinity}};
  for (VertexId v : g.vertices) {
    const PointView p = complex.points.view(v);
    for (int k = 0; k < 3; ++k) {
      box.low[k] = std::min(box.low[k], rounded_down(p.lo[k]));
      box.high[k] = std::max(box.high[k], rounded_up(p.hi[k]));
    }
  }
  return box;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> order_regions(const std::vector<const Part*>& parts) {
  std::vector<std::tuple<RegionId, std::uint32_t, std::uint32_t>> regions;
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    std::uint32_t number = 0;
    for (RegionId cell : parts[i]->first_cells()) regions.emplace_back(cell, i, ++number);
  }
  if (parts.size() > 1 && !std::is_sorted(regions.begin(), regions.end()))
    std::sort(regions.begin(), regions.end());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> out;
  out.reserve(regions.size());
  for (const auto& [cell, part, number] : regions) out.emplace_back(part, number);
  return out;
}

// The merge of one list of ids over several parts: which part the next element is of. `gather` merges any list
// that runs parallel to the ids. `list(group)` is the list of a group.
class MergeOrder {
 public:
  template <class List>
  MergeOrder(const std::vector<const Part*>& parts, List list) : parts_(parts) {
    using Ids = std::decay_t<decltype(list(parts[0]->group()))>;
    using Entry = std::pair<typename Ids::value_type, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> next;
    std::vector<std::size_t> place(parts.size(), 0);
    std::size_t size = 0;
    const auto push = [&](std::uint32_t i) {
      const Ids& ids = list(parts[i]->group());
      if (place[i] < ids.size()) next.emplace(ids[place[i]], i);
    };
    for (std::uint32_t i = 0; i < parts.size(); ++i) {
      size += list(parts[i]->group()).size();
      push(i);
    }
    order_.reserve(size);
    while (!next.empty()) {
      const std::uint32_t i = next.top().second;
      next.pop();
      order_.push_back(i);
      ++place[i];
      push(i);
    }
  }

  template <class List>
  auto gather(List list) const {
    std::decay_t<decltype(list(parts_[0]->group()))> out;
    out.reserve(order_.size());
    std::vector<std::size_t> place(parts_.size(), 0);
    for (std::uint32_t i : order_) out.push_back(list(parts_[i]->group())[place[i]++]);
    return out;
  }

  std::uint32_t part(std::size_t i) const { return order_[i]; }

 private:
  const std::vector<const Part*>& parts_;
  std::vector<std::uint32_t> order_;
};

template <class List>
auto merged_lists(const std::vector<const Part*>& parts, List list) {
  return MergeOrder(parts, list).gather(list);
}

// One kind of entities with their origins, whose sets are each part's own.
template <class IdT>
void merge_entities(const std::vector<const Part*>& parts, std::vector<SetMap>& sets, Group& out) {
  const auto list = [](const Group& g) -> const auto& { return list_for(g, IdT()); };
  const MergeOrder order(parts, list);
  list_for(out, IdT()) = order.gather(list);
  auto& origins = list_for(out.origins, IdT());
  origins = order.gather([](const Group& g) -> const auto& { return list_for(g.origins, IdT()); });
  for (std::size_t i = 0; i < origins.size(); ++i) origins[i] = sets[order.part(i)](origins[i]);
}

// One group of parts that share no point; two parts at least.
Group merge(const std::vector<const Part*>& parts) {
  Group out;
  const auto cells = [](const Group& g) -> const auto& { return g.cells; };
  const MergeOrder cell_order(parts, cells);
  out.cells = cell_order.gather(cells);
  std::vector<std::vector<std::uint32_t>> number(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) number[i].resize(parts[i]->group().regions.size());
  for (const auto& [part, region] : order_regions(parts)) {
    out.regions.push_back(parts[part]->group().regions[region - 1]);
    number[part][region - 1] = static_cast<std::uint32_t>(out.regions.size());
  }
  for (std::size_t i = 0; i < out.cells.size(); ++i) {
    std::uint32_t& region = out.cells[i].second;
    region = number[cell_order.part(i)][region - 1];
  }
  std::vector<SetMap> sets;
  sets.reserve(parts.size());
  for (const Part* part : parts) sets.emplace_back(part->group().origins.sets, out.origins.sets);
  merge_entities<FaceId>(parts, sets, out);
  merge_entities<EdgeId>(parts, sets, out);
  merge_entities<VertexId>(parts, sets, out);
  out.features.edges = merged_lists(
      parts, [](const Group& g) -> const auto& { return g.features.edges; });
  out.features.vertices = merged_lists(
      parts, [](const Group& g) -> const auto& { return g.features.vertices; });
  return out;
}

std::vector<const Part*> pointers(const Parts& parts) {
  std::vector<const Part*> out;
  out.reserve(parts.size());
  for (const auto& part : parts) out.push_back(part.get());
  return out;
}

}  // namespace

bool before(const PartRef& a, const PartRef& b) {
  const auto first = []<class IdT>(const std::vector<IdT>& list) { return list.empty() ? IdT() : list.front(); };
  const auto key = [&](const Part& part) {
    const Group& g = part.group();
    const RegionId cell = g.cells.empty() ? RegionId() : g.cells.front().first;
    return std::tuple(cell, first(g.vertices), first(g.edges), first(g.faces));
  };
  return key(*a.get()) < key(*b.get());
}

Part::Part(const Complex& complex, Group group) : group_(std::move(group)), box_(box_of(complex, group_)) {
  first_cells_.resize(group_.regions.size());
  for (const auto& [cell, region] : group_.cells) {
    RegionId& first = first_cells_.at(region - 1);
    if (!first.valid()) first = cell;
  }
  require(std::all_of(first_cells_.begin(), first_cells_.end(), [](RegionId cell) { return cell.valid(); }),
          "parts: a region without cells");
}

const CellCounts& Part::counts(const Complex& complex) const {
  std::call_once(counted_, [&] {
    const Selection selection = selection_of(complex, group_);
    const GroupSources sources(complex, group_);
    counts_.raw = {selection.vertices.size(), selection.edges.size(), selection.faces.size(),
                   selection.regions.size()};
    counts_.simplified = simplified_counts(complex, selection, group_.features, SimplifyMode::features, &sources);
  });
  return counts_;
}

const PartVolume& Part::volume(const Complex& complex) const {
  std::call_once(summed_, [&] {
    std::vector<char> bounded(group_.regions.size() + 1, 1);
    for (const auto& [cell, region] : group_.cells) {
      if (complex.unbounded(cell)) bounded[region] = 0;
    }
    volume_.unbounded = static_cast<std::size_t>(std::count(bounded.begin(), bounded.end(), 0));
    std::vector<RegionId> cells;
    for (const auto& [cell, region] : group_.cells) {
      if (bounded[region]) cells.push_back(cell);
    }
    volume_.bounded = cnrg::volume(complex, cells).value();
  });
  return volume_;
}

const std::vector<std::optional<Rational>>& Part::volumes(const Complex& complex) const {
  std::call_once(measured_, [&] {
    std::vector<std::vector<RegionId>> cells(group_.regions.size());
    for (const auto& [cell, region] : group_.cells) cells[region - 1].push_back(cell);
    for (const auto& region : cells) volumes_.push_back(cnrg::volume(complex, region));
  });
  return volumes_;
}

namespace {

/// Some region, sheet, wire or point is of a material with a dominance of its own.
bool ranked(const Group& group) {
  for (const RegionAttributes& region : group.regions) {
    if (region.material.has_dominance()) return true;
  }
  const LeafSets& sets = group.origins.sets;
  if (!sets.says_anything()) return false;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const SaidPointer& said = sets.said(LeafSetId(i));
    if (said != nullptr && said->attributes.material.has_dominance()) return true;
  }
  return false;
}

}  // namespace

PartedGroup parted(const Complex& complex, Group group) {
  PartedGroup out;
  out.dominance = group.dominance;
  out.ranked = ranked(group);
  if (!empty(group)) out.parts.push_back(std::make_shared<const Part>(complex, std::move(group)));
  return out;
}

Group whole(const PartedGroup& value) {
  Group out;
  if (value.parts.size() == 1) out = value.parts.front()->group();
  else if (!value.parts.empty()) out = merge(pointers(value.parts));
  out.dominance = value.dominance;
  return out;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> region_order(const PartedGroup& value) {
  return order_regions(pointers(value.parts));
}

void Totals::add(const Complex& complex, const Part& part) {
  const CellCounts& counts = part.counts(complex);
  for (std::size_t d = 0; d < 4; ++d) {
    raw[d] += counts.raw[d];
    simplified[d] += counts.simplified[d];
  }
  regions += part.group().regions.size();
  unbounded += part.volume(complex).unbounded;
  bounded_volume += part.volume(complex).bounded;
}

void Totals::remove(const Complex& complex, const Part& part) {
  const CellCounts& counts = part.counts(complex);
  for (std::size_t d = 0; d < 4; ++d) {
    raw[d] -= counts.raw[d];
    simplified[d] -= counts.simplified[d];
  }
  regions -= part.group().regions.size();
  unbounded -= part.volume(complex).unbounded;
  bounded_volume -= part.volume(complex).bounded;
}

void Totals::add(const TotalsChange& change) {
  const auto added = [](std::size_t& n, std::int64_t more) {
    n = static_cast<std::size_t>(static_cast<std::int64_t>(n) + more);
  };
  for (std::size_t d = 0; d < 4; ++d) {
    added(raw[d], change.raw[d]);
    added(simplified[d], change.simplified[d]);
  }
  added(regions, change.regions);
  bounded_volume += change.volume;
}

const Totals& totals_of(const Complex& complex, PartedGroup& value) {
  if (!value.totals) {
    value.totals.emplace();
    value.fresh = value.parts;
  }
  for (const auto& part : value.fresh) value.totals->add(complex, *part.get());
  value.fresh.clear();
  return *value.totals;
}

std::vector<std::optional<Rational>> volumes(const Complex& complex, const PartedGroup& value) {
  std::vector<std::optional<Rational>> out;
  for (const auto& [part, region] : region_order(value)) {
    out.push_back(value.parts[part]->volumes(complex)[region - 1]);
  }
  return out;
}

}  // namespace cnrg
