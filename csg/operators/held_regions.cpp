// See the header for the idea. A step collects `pieces_`, which 3-cell was of which region, before sets change;
// these and the cells of next tell what regions a region of the result came from, and so its attributes.
#include "csg/operators/held_regions.h"

#include <algorithm>

#include "csg/operators/detect_regions.h"
#include "kernel/base/sorted.h"

namespace cnrg {

// One region of an operand in a region of the result.
struct HeldRegions::Source {
  RegionId result;
  bool second;     // not of the operand that comes first
  RegionId first;  // the smallest cell of the source
  bool held;
  std::uint32_t attributes;             // index into the pool, or into those of next
  std::vector<std::uint32_t> leaves{};  // their places in the order, where these decide
  auto key() const { return std::tuple(result, second, first); }
};

HeldRegions::HeldRegions(const Complex& complex, BooleanOp op, const EntityMarks<FaceId>& faces,
                         const LeafOrder& order)
    : complex_(complex),
      op_(op),
      faces_(faces),
      leaf_order_(order),
      inside_(complex.region_count),
      sets_(complex.region_count),
      ring_(complex.region_count),
      attributes_(complex.region_count),
      next_region_(complex.region_count) {}

void HeldRegions::load(std::span<const Group* const> parts) {
  for (const Group* part : parts) {
    std::vector<RegionId> first(part->regions.size()), last(part->regions.size());
    for (const auto& [cell, region] : part->cells) {
      inside_[cell] = 1;
      held_cells_.push_back(cell);
      if (!first[region - 1].valid()) {
        first[region - 1] = last[region - 1] = cell;
        set_attributes(cell, part->regions[region - 1]);
        continue;
      }
      sets_.unite(first[region - 1], cell);
      ring_[last[region - 1]] = cell.value() + 1;
      last[region - 1] = cell;
    }
    for (std::size_t i = 0; i < first.size(); ++i) {
      if (first[i] != last[i]) ring_[last[i]] = first[i].value() + 1;
    }
  }
}

void HeldRegions::take_in(std::span<const Group* const> parts) {
  next_cells_.clear(), next_first_.clear(), next_attributes_.clear();
  for (const Group* part : parts) {
    const auto base = static_cast<std::uint32_t>(next_attributes_.size());
    for (const RegionAttributes& region : part->regions) next_attributes_.push_back(&region);
    next_first_.resize(next_attributes_.size());
    for (const auto& [cell, region] : part->cells) {
      next_region_[cell] = base + region;
      RegionId& first = next_first_[base + region - 1];
      if (!first.valid()) first = cell;
      next_cells_.push_back(cell);
    }
  }
}

bool HeldRegions::same_in_held(RegionId a, RegionId b) {
  if (op_ != BooleanOp::subtract) return find(a) == find(b);
  if (find(a) != find(b)) return false;
  if (told_apart_.empty()) {
    std::vector<FaceId> walls;
    for (const FaceId f : faces_.listed) {
      if (faces_.has(f, kHeld)) walls.push_back(f);
    }
    merge_runs(walls);
    told_apart_ = detect_regions(complex_, cells(), walls);
  }
  return *value_of_key(told_apart_, a) == *value_of_key(told_apart_, b);
}

void HeldRegions::update(Roles roles, std::span<const Group* const> next, Conflicts& conflicts) {
  switch (op_) {
    case BooleanOp::unite: unite(roles, next, conflicts); break;
    case BooleanOp::intersect: intersect(roles, conflicts); break;
    case BooleanOp::subtract:
      for (const RegionId c : next_cells_) inside_[c] = 0;
      told_apart_.clear();
      break;
  }
  for (const RegionId c : next_cells_) next_region_[c] = 0;
}

void HeldRegions::unite(Roles roles, std::span<const Group* const> next, Conflicts& conflicts) {
  pieces_.clear();
  for (const RegionId c : next_cells_) {
    if (in_held(c)) pieces_.emplace_back(c, find(c));
    for_each_neighbour(c, [&](RegionId other) {
      if (in_held(other) && !in_next(other)) pieces_.emplace_back(other, find(other));
    });
  }
  split(next);
  for (const RegionId c : next_cells_) {
    for_each_neighbour(c, [&](RegionId other) {
      if (in_next(other) ? c < other : in_held(other)) join(c, other);
    });
  }
  for (const RegionId c : next_cells_) {
    if (in_held(c)) continue;
    inside_[c] = 1;
    held_cells_.push_back(c);
  }
  combine(roles, next_cells_, conflicts);
  link_joined();
}

// Regions of held in which a wall of next comes to stand fall into cells, which are joined anew.
void HeldRegions::split(std::span<const Group* const> next) {
  split_.clear();
  for (const Group* part : next) {
    for (const FaceId f : part->faces) {
      if (faces_.has(f, kHeld | kRemoved)) continue;
      const auto& [front, back] = complex_.face_regions[f];
      if (in_held(front) && in_held(back) && find(front) == find(back)) split_.push_back(find(front));
    }
  }
  sort_unique(split_);
  std::vector<RegionId> cells;
  for (const RegionId region : split_) {
    for_each_member(region, [&](RegionId c) {
      cells.push_back(c);
      pieces_.emplace_back(c, region);
    });
  }
  for (const RegionId c : cells) sets_.reset(c), ring_[c] = 0;
  for (const RegionId c : cells) {
    for_each_neighbour(c, [&](RegionId other) {
      if (in_held(other)) join(c, other);
    });
  }
}

void HeldRegions::intersect(Roles roles, Conflicts& conflicts) {
  pieces_.clear(), split_.clear();
  std::vector<RegionId> both;
  for (const RegionId c : next_cells_) {
    if (!in_held(c)) continue;
    both.push_back(c);
    pieces_.emplace_back(c, find(c));
    split_.push_back(pieces_.back().second);
  }
  sort_unique(split_);
  for (const RegionId c : held_cells_) {
    if (attributes_[c] != 0 && !std::binary_search(split_.begin(), split_.end(), c)) drop_attributes(c);
  }
  for (const RegionId c : held_cells_) inside_[c] = 0, sets_.reset(c);
  for (const RegionId c : both) inside_[c] = 1;
  outside_next_.clear();
  for (const RegionId c : held_cells_) {
    if (!in_held(c)) outside_next_.push_back(c);
  }
  held_cells_ = both;
  for (const RegionId c : both) {
    for_each_neighbour(c, [&](RegionId other) {
      if (in_held(other)) sets_.unite(c, other);
    });
  }
  combine(roles, both, conflicts);
}

// Gives the regions that came of a step their attributes; `next_cells` are those of next in the result.
void HeldRegions::combine(Roles roles, const std::vector<RegionId>& next_cells, Conflicts& conflicts) {
  const bool next_first = roles.swapped && roles.dominant;
  const auto same = [](const Source& a, const Source& b) { return a.key() == b.key(); };
  std::vector<Source> sources;
  const auto add = [&](const Source& source) {
    if (sources.empty() || !same(sources.back(), source)) sources.push_back(source);
  };
  for (const auto& [cell, region] : pieces_) {
    add({find(cell), next_first, region, true, attributes_.get(region) - 1});
  }
  for (const RegionId cell : next_cells) {
    const std::uint32_t i = next_region_.get(cell) - 1;
    add({find(cell), !next_first, next_first_[i], false, i});
  }
  std::sort(sources.begin(), sources.end(), [](const Source& a, const Source& b) { return a.key() < b.key(); });
  sources.erase(std::unique(sources.begin(), sources.end(), same), sources.end());
  put_in_order_of_leaves(sources);

  std::vector<std::pair<RegionId, RegionAttributes>> made;
  std::vector<const RegionAttributes*> of_region;
  std::vector<Yielded> yielded;
  for (auto begin = sources.begin(); begin != sources.end();) {
    const RegionId result = begin->result;
    const auto end = std::find_if(begin, sources.end(), [&](const Source& s) { return s.result != result; });
    of_region.clear();
    for (auto it = begin; it != end; ++it) of_region.push_back(&attributes_of(*it));
    made.emplace_back(result, combined(of_region, roles.dominant, yielded));
    made.back().second.leaves = leaves_of(std::span(begin, end));
    for (const Yielded& other : yielded) {
      CellSet cells;
      cells.regions = cells_of(std::span(begin, end), other, next_cells);
      conflicts.emplace_back(result, conflict(made.back().second, other, std::move(cells)));
    }
    begin = end;
  }
  for (const Source& source : sources) {
    if (source.held) drop_attributes(source.first);
  }
  for (auto& [region, attributes] : made) set_attributes(region, std::move(attributes));
}

// Of several regions of one operand in one region of the result the leaves decide which goes first.
void HeldRegions::put_in_order_of_leaves(std::vector<Source>& sources) const {
  const auto order = [&](const Source& source) {
    const RegionAttributes& a = attributes_of(source);
    return std::tie(source.leaves, a.name, a.material.name(), a.properties);
  };
  for (auto begin = sources.begin(); begin != sources.end();) {
    const auto end = std::find_if(begin, sources.end(), [&](const Source& s) {
      return s.result != begin->result || s.second != begin->second;
    });
    if (end - begin > 1) {
      for (auto it = begin; it != end; ++it) it->leaves = leaf_order_.places(attributes_of(*it).leaves);
    }
    std::stable_sort(begin, end, [&](const Source& a, const Source& b) { return order(a) < order(b); });
    begin = end;
  }
}

// The leaves of one region of the result. A region of held that was not split goes into this result alone, so its
// list is taken, not copied: a region that grows in n steps would be copied n times.
std::vector<LeafId> HeldRegions::leaves_of(std::span<const Source> sources) {
  const auto longest = std::max_element(sources.begin(), sources.end(), [&](const Source& a, const Source& b) {
    return attributes_of(a).leaves.size() < attributes_of(b).leaves.size();
  });
  const bool whole = longest->held && !std::binary_search(split_.begin(), split_.end(), longest->first);
  std::vector<LeafId> leaves;
  if (whole) leaves = std::move(pool_[longest->attributes]->leaves);
  else leaves = attributes_of(*longest).leaves;
  for (auto source = sources.begin(); source != sources.end(); ++source) {
    if (source != longest) add_leaves(leaves, attributes_of(*source).leaves);
  }
  return leaves;
}

// The 3-cells of one region of the result, that of `sources`, where an operand says what gave way.
std::vector<RegionId> HeldRegions::cells_of(std::span<const Source> sources, const Yielded& what,
                                            const std::vector<RegionId>& next_cells) {
  std::vector<RegionId> out;
  const RegionId result = sources.front().result;
  const auto add = [&](RegionId cell) {
    if (find(cell) == result) out.push_back(cell);
  };
  for (const Source& source : sources) {
    if (!what.is_in(attributes_of(source))) continue;
    if (!source.held) {
      for (const RegionId cell : next_cells) {
        if (next_region_.get(cell) == source.attributes + 1) add(cell);
      }
    } else if (std::binary_search(split_.begin(), split_.end(), source.first)) {
      for (const auto& [cell, region] : pieces_) {
        if (region == source.first) add(cell);
      }
    } else {
      for_each_member(source.first, add);
    }
  }
  sort_unique(out);
  return out;
}

const RegionAttributes& HeldRegions::attributes_of(const Source& source) const {
  return source.held ? *pool_[source.attributes] : *next_attributes_[source.attributes];
}

void HeldRegions::write(Group& out) {
  if (op_ == BooleanOp::subtract) {
    out.cells = detect_regions(complex_, cells(), out.faces);
    for (const auto& [cell, region] : out.cells) {
      if (region > out.regions.size()) out.regions.push_back(*pool_[attributes_.get(find(cell)) - 1]);
    }
    return;
  }
  Scratch<RegionId, std::uint32_t> number(complex_.region_count);  // of a set's smallest cell
  for (const RegionId cell : cells()) {
    const RegionId region = find(cell);
    if (region == cell) {
      out.regions.push_back(*pool_[attributes_.get(cell) - 1]);
      number[cell] = static_cast<std::uint32_t>(out.regions.size());
    }
    out.cells.emplace_back(cell, number.get(region));
  }
}

// All 3-cells of held, ascending.
std::vector<RegionId> HeldRegions::cells() const {
  std::vector<RegionId> out;
  out.reserve(held_cells_.size());
  for (const RegionId cell : held_cells_) {
    if (in_held(cell)) out.push_back(cell);
  }
  merge_runs(out);
  return out;
}

void HeldRegions::join(RegionId a, RegionId b) {
  a = find(a), b = find(b);
  if (a == b) return;
  sets_.unite(a, b);
  joined_.emplace_back(std::minmax(a, b));
}

// Rings are joined at the end of a step: until then they are those of the regions before it.
void HeldRegions::link_joined() {
  for (const auto& [a, b] : joined_) {
    const RegionId after_a = after(a), after_b = after(b);
    ring_[a] = after_b.value() + 1, ring_[b] = after_a.value() + 1;
  }
  joined_.clear();
}

void HeldRegions::set_attributes(RegionId region, RegionAttributes attributes) {
  pool_.push_back(std::make_unique<RegionAttributes>(std::move(attributes)));
  attributes_[region] = static_cast<std::uint32_t>(pool_.size());
}

void HeldRegions::drop_attributes(RegionId region) {
  std::uint32_t& place = attributes_[region];
  if (place != 0) pool_[place - 1].reset();
  place = 0;
}

template <class F>
void HeldRegions::for_each_member(RegionId region, F f) const {
  RegionId cell = region;
  do {
    f(cell);
    cell = after(cell);
  } while (cell != region);
}

// f(3-cell) for the neighbours across faces that are no walls once the step is done.
template <class F>
void HeldRegions::for_each_neighbour(RegionId cell, F f) const {
  for (const HalfFace h : complex_.region_faces[cell]) {
    if (!faces_.kept(h.face())) f(complex_.region(h.opposite()));
  }
}

}  // namespace cnrg
