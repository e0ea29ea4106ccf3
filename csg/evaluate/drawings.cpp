#include "csg/evaluate/drawings.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "csg/carriers/axes.h"
#include "csg/carriers/common_lines.h"
#include "csg/carriers/sharing.h"
#include "csg/carriers/surface_numbers.h"
#include "csg/evaluate/diagnostics.h"
#include "csg/leaves/geometry_leaf.h"
#include "csg/weld/weld_leaves.h"
#include "csg/weld/weld_surfaces.h"
#include "kernel/base/sorted.h"

namespace cnrg {
namespace {

/// What comes of drawing some leaves together.
struct Drawing {
  PlacedLeaves placed;
  std::vector<NearSurfaces> near;  // that are nearly one, and not welded
  std::vector<LeafWords> refused;  // leaves that share something and yet stay as they are
  std::vector<LeafWords> welded;
};

/// LeafError names leaves by their places in `instances`. Equations are those before `motion`.
Drawing draw(std::vector<LeafInstance> instances, const std::optional<Rational>& weld,
             const ExtraOfInstances& lines, DrawnLeaves& known, const Transform& motion) {
  Drawing out;
  WeldedSurfaces round;
  if (weld) {
    round = weld_surfaces(instances, *weld);
    instances = round.instances;
    if (!round.notice.empty()) out.welded.push_back(round.notice);
  }
  out.placed.surfaces = surface_numbers(before(motion, instances), &out.placed.equations);
  instances = with_common_lines(std::move(instances), &out.near, &out.refused, round.anew, lines, nullptr, &known);
  if (weld) {
    WeldedLeaves welded = weld_leaves(instances, *weld, round.farthest);
    instances = std::move(welded.instances);
    if (!welded.notice.empty()) out.welded.push_back(welded.notice);
    std::erase_if(out.near, [&](const NearSurfaces& pair) { return pair.apart <= to_double(*weld); });
  }
  out.placed.instances = std::move(instances);
  return out;
}

bool same_points(const Soup& a, const Soup& b) {
  if (a.point_count() != b.point_count()) return false;
  for (std::uint32_t i = 0; i < a.point_count(); ++i) {
    if (!std::equal(a.xyz(PointId(i)), a.xyz(PointId(i)) + 3, b.xyz(PointId(i)))) return false;
    if (exact_value(a, PointId(i)) != exact_value(b, PointId(i))) return false;
  }
  return true;
}

bool same_faces(const Soup& a, const Soup& b) {
  if (a.face_count() != b.face_count()) return false;
  for (std::uint32_t i = 0; i < a.face_count(); ++i) {
    const Soup::Face &f = a.face(SourceId(i)), &g = b.face(SourceId(i));
    if (f.leaf_face != g.leaf_face || f.patch != g.patch || f.front != g.front || f.back != g.back) return false;
    if (!std::ranges::equal(a.corners(SourceId(i)), b.corners(SourceId(i)))) return false;
  }
  return true;
}

bool same_wires_and_points(const Soup& a, const Soup& b) {
  const auto same_wire = [](const Soup::Wire& w, const Soup::Wire& v) {
    return w.leaf_edge == v.leaf_edge && w.a == v.a && w.b == v.b;
  };
  const auto same_point = [](const Soup::Isolated& p, const Soup::Isolated& q) { return p.point == q.point; };
  return std::ranges::equal(a.wires(), b.wires(), same_wire) &&
         std::ranges::equal(a.isolated(), b.isolated(), same_point) &&
         std::ranges::equal(a.curve_ends(), b.curve_ends(), same_point);
}

/// True if two drawings of one leaf have the same facets.
bool drawn_alike(const LeafInstance& one, const LeafInstance& other) {
  if (one.leaf == other.leaf && *one.transform == *other.transform) return true;
  Soup a, b;
  one.leaf->add_to(a, *one.transform);
  other.leaf->add_to(b, *other.transform);
  return same_points(a, b) && same_faces(a, b) && same_wires_and_points(a, b);
}

}  // namespace

Drawings::Drawings(const Tree& tree, const Unfolding& unfolding, const PreparedLeaves& leaves,
                   const EvaluateOptions& options, std::vector<Diagnostic>& diagnostics)
    : tree_(tree), unfolding_(unfolding), leaves_(leaves), options_(options) {
  Drawing drawing;
  Leaves all;
  for (const LeafId leaf : IdRange<LeafId>(leaves.instances().size())) all.push_back(leaf);
  motion_ = motion_of(all);
  const auto draw_all = [&](const ExtraOfInstances& lines) -> const PlacedLeaves& {
    leaves.locate_errors([&] { drawing = draw(leaves.instances(), tree.weld, lines, drawn_leaves_, motion_); });
    if (lines.empty()) first_ = drawing.placed;
    return drawing.placed;
  };
  proven_ = std::make_unique<const ProvenLines>(
      draw_all, [&] { return relevance_for(unfolding.roots); }, options, moulds_, motion_);
  for (const LeafWords& notice : drawing.welded)
    diagnostics.push_back({tree.file, tree.weld_at, Diagnostic::Level::notice, leaves.in_words(notice)});
  append(diagnostics, leaves.near_notices(drawing.near));
  append(diagnostics, leaves.located_notices(drawing.refused));
  whole_ = std::move(drawing.placed);
  find_affected(!drawing.refused.empty());
  find_representatives();
}

Relevance Drawings::relevance_for(const std::vector<InstanceId>& roots) const {
  // Of a result read back only facets are known; most of them are those of a surface beside it, which is no fault.
  std::vector<Relevance::Root> all;
  for (const InstanceId root : roots) {
    all.push_back({instances_below(unfolding_.instances, root), std::vector<char>(leaves_.instances().size())});
    for (const LeafId leaf : leaves_.below(unfolding_, root)) {
      all.back().asked[leaf.index()] =
          options_.proof == AskedProof::to_the_end || leaves_.instances()[leaf.index()].leaf->stored() == nullptr;
    }
  }
  return {tree_steps(tree_, unfolding_, leaves_.numbers().by_instance()), std::move(all)};
}

// In a space without bounds the frame depends on where leaves stand.
Transform Drawings::motion_of(const Leaves& leaves) const {
  const std::vector<LeafInstance>& instances = leaves_.instances();
  std::vector<std::uint32_t> curved;
  bool moved = false;
  for (const LeafId leaf : leaves) {
    const LeafInstance& instance = instances[leaf.index()];
    if (instance.leaf->unbounded()) return {};
    if (instance.leaf->form() == nullptr) continue;
    curved.push_back(static_cast<std::uint32_t>(leaf.index()));
    moved = moved || !instance.above->identity();
  }
  if (!moved || !options_.reach.empty()) return {};
  Transform motion = space_of(curved, instances);
  return stretch(motion) ? motion : Transform();
}

void Drawings::find_affected(bool any_refused) {
  const std::vector<LeafInstance>& before = leaves_.instances();
  if (tree_.weld) group_.assign(before.size(), 0);
  else group_ = sharing_groups(before);
  size_.resize(before.size());
  affected_.resize(before.size());
  for (const std::uint32_t group : group_) ++size_[group];
  for (std::uint32_t i = 0; i < before.size(); ++i) {
    const std::uint32_t group = group_[i];
    if (size_[group] == 1 || affected_[group] != 0) continue;
    const LeafInstance& after = first_.instances[i];
    affected_[group] = any_refused || before[i].leaf != after.leaf || !(*before[i].transform == *after.transform);
  }
  for (const auto* sets : {&proven_->undecided(), &proven_->dead()}) {
    for (const Leaves& set : *sets) {
      for (const LeafId leaf : set) affected_[group_[leaf.index()]] = 1;
    }
  }
}

void Drawings::find_representatives() {
  for (const InstanceId id : IdRange<InstanceId>(unfolding_.instances.size())) {
    const LeafId leaf = leaves_.leaf_of(id);
    std::vector<InstanceId> below;
    bool all = true;
    for (const InstanceId operand : unfolding_.instances[id].operands) {
      if (representative_[operand].valid()) below.push_back(representative_[operand]);
      else all = false;
    }
    sort_unique(below);
    if (below.size() == 1 && all) representative_.push_back(below.front());
    else if (!below.empty() || (leaf.valid() && affected_[group_[leaf.index()]])) representative_.push_back(id);
    else representative_.push_back(InstanceId::none());
  }
}

PlacedLeaves Drawings::draw_only(const Leaves& leaves, const ExtraOfInstances& lines) {
  std::vector<LeafInstance> instances(whole_.instances.size(), LeafInstance{no_geometry(), {}});
  for (const LeafId leaf : leaves) instances[leaf.index()] = leaves_.instances()[leaf.index()];
  PlacedLeaves placed;
  leaves_.locate_errors(
      [&] { placed = draw(std::move(instances), tree_.weld, lines, drawn_leaves_, motion_of(leaves)).placed; });
  return placed;
}

const std::vector<LeafInstance>& Drawings::drawn(const Leaves& leaves, const ExtraOfInstances& lines) {
  ExtraOfInstances own;
  for (const LeafId leaf : leaves) {
    const auto it = lines.find(static_cast<std::uint32_t>(leaf.index()));
    if (it != lines.end()) own.insert(*it);
  }
  const auto [it, is_new] = drawn_.try_emplace({leaves, own});
  if (!is_new) return it->second;
  PlacedLeaves placed = draw_only(leaves, own);
  for (const LeafId leaf : leaves) it->second.push_back(std::move(placed.instances[leaf.index()]));
  return it->second;
}

bool Drawings::first_alike(const Leaves& below) {
  std::map<std::uint32_t, Leaves> groups;
  for (const LeafId leaf : below) groups[group_[leaf.index()]].push_back(leaf);
  return std::ranges::all_of(groups, [&](const auto& one) {
    const auto& [group, list] = one;
    if (!affected_[group] || list.size() == size_[group]) return true;
    const std::vector<LeafInstance>& alone = drawn(list, {});
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (!drawn_alike(alone[i], first_.instances[list[i].index()])) return false;
    }
    return true;
  });
}

// Sets of leaves that were undecided tell what a proof of those below alone would be: the same, as long as no leaf
// has further lines for the sake of one that is not below.
ExtraOfInstances Drawings::lines_alone(InstanceId id) {
  const Leaves below = leaves_.below(unfolding_, id);
  const auto [it, is_new] = lines_alone_.try_emplace(below);
  if (!is_new || options_.proof == AskedProof::none) return it->second;
  const auto in = [&](LeafId leaf) { return std::ranges::binary_search(below, leaf); };
  bool any_inside = false, any_across = false;
  for (const Leaves& undecided : proven_->undecided()) {
    const auto count = static_cast<std::size_t>(std::ranges::count_if(undecided, in));
    if (count == undecided.size()) any_inside = true;
    else if (count > 0) any_across = true;
  }
  // What dies for the roots is asked of a node below them.
  const bool any_dead =
      std::ranges::any_of(proven_->dead(), [&](const Leaves& dead) { return std::ranges::all_of(dead, in); });
  const bool is_root = unfolding_.roots.size() == 1 && representative_[unfolding_.roots[0]] == id;
  const Transform motion = motion_of(below);
  if (first_alike(below) && (!any_dead || is_root) && (!any_inside || (!any_across && motion == motion_))) {
    for (const auto& [leaf, lines] : proven_->lines()) {
      if (any_inside && in(LeafId(leaf))) it->second.emplace(leaf, lines);
    }
    return it->second;
  }
  PlacedLeaves placed;
  const auto draw_them = [&](const ExtraOfInstances& lines) -> const PlacedLeaves& {
    return placed = draw_only(below, lines);
  };
  return it->second = ProvenLines(
                          draw_them, [&] { return relevance_for({id}); }, options_, moulds_, motion)
                          .lines();
}

const Drawings::Drawn& Drawings::drawn_alone(InstanceId representative) {
  const auto [it, is_new] = alone_.try_emplace(representative);
  if (!is_new) return it->second;
  const ExtraOfInstances lines = lines_alone(representative);
  std::map<std::uint32_t, Leaves> groups;
  for (const LeafId leaf : leaves_.below(unfolding_, representative)) {
    if (affected_[group_[leaf.index()]]) groups[group_[leaf.index()]].push_back(leaf);
  }
  const auto lines_of = [](const ExtraOfInstances& all, LeafId leaf) {
    const auto found = all.find(static_cast<std::uint32_t>(leaf.index()));
    return found == all.end() ? ExtraLines() : found->second;
  };
  for (const auto& [group, list] : groups) {
    const bool same = list.size() == size_[group] && std::ranges::all_of(list, [&](LeafId leaf) {
                        return lines_of(lines, leaf) == lines_of(proven_->lines(), leaf);
                      });
    const std::vector<LeafInstance>* const fewer = same ? nullptr : &drawn(list, lines);
    for (std::size_t i = 0; i < list.size(); ++i)
      it->second.emplace(list[i], fewer == nullptr ? whole_.instances[list[i].index()] : (*fewer)[i]);
  }
  return it->second;
}

PlacedLeaves Drawings::alone(InstanceId id) {
  const Leaves below = leaves_.below(unfolding_, id);
  if (tree_.weld) return draw_only(below, lines_alone(id));  // surfaces are welded, too
  PlacedLeaves placed{std::vector<LeafInstance>(whole_.instances.size(), LeafInstance{no_geometry(), {}}),
                      whole_.surfaces, whole_.equations};
  for (const LeafId leaf : below) placed.instances[leaf.index()] = whole_.instances[leaf.index()];
  if (!representative_[id].valid()) return placed;
  for (const auto& [leaf, instance] : drawn_alone(representative_[id])) placed.instances[leaf.index()] = instance;
  return placed;
}

bool Drawings::as_alone(InstanceId id, const PlacedLeaves& placed) {
  if (!representative_[id].valid()) return true;
  const Drawn& drawn = drawn_alone(representative_[id]);
  return std::all_of(drawn.begin(), drawn.end(), [&](const auto& one) {
    return drawn_alike(one.second, placed.instances[one.first.index()]);
  });
}

bool Drawings::framed_as_alone(InstanceId root) const {
  const std::vector<LeafInstance>& all = whole_.instances;
  return leaves_.below(unfolding_, root).size() == all.size() ||
         std::ranges::none_of(all, [](const LeafInstance& one) { return one.leaf->unbounded(); });
}

std::vector<InstanceId> Drawings::otherwise_below(InstanceId root, const PlacedLeaves& placed) {
  std::vector<InstanceId> found, stack{root};
  std::vector<char> seen(unfolding_.instances.size(), 0);
  while (!stack.empty()) {
    const InstanceId id = stack.back();
    stack.pop_back();
    if (id != root && !as_alone(id, placed)) {
      found.push_back(id);
      continue;
    }
    for (const InstanceId operand : unfolding_.instances[id].operands) {
      if (!std::exchange(seen[operand.index()], 1)) stack.push_back(operand);
    }
  }
  return found;
}

}  // namespace cnrg
