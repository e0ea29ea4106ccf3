// The stage between prepared leaves and their soup.
#include "csg/carriers/common_lines.h"

#include <algorithm>
#include <map>
#include <set>

#include "csg/carriers/axes.h"
#include "csg/carriers/bands.h"
#include "csg/carriers/boxes.h"
#include "csg/carriers/nets.h"
#include "csg/carriers/revolved_families.h"
#include "csg/carriers/round_spaces.h"
#include "csg/curves/surface_placed.h"
#include "csg/geometry/circle.h"
#include "csg/geometry/placement.h"
#include "kernel/base/sorted.h"
#include "kernel/base/union_find.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/refine/box_tree.h"

namespace cnrg {
namespace {

using Index = std::uint32_t;

// Leaves of revolution that their transform stretches along their own axis, or across it alike on all sides: they
// are leaves of revolution still, about the image of the axis. A cylinder of length 1 that is stretched to 3 is
// the cylinder of length 3, and meets others about its axis as that one does. As it stands it would be taken for
// something that is round in a stretched space of its own.

/// A leaf in the place where it was put, with the form that it has there.
class AxialLeaf final : public PreparedLeaf {
 public:
  AxialLeaf(LeafInstance from, RevolvedForm form) : from_(std::move(from)) {
    set_form(std::make_shared<const RevolvedForm>(std::move(form)));
    set_surfaces(moved(from_.leaf->surfaces(), from_.transform));
  }
  LeafId add_to(Soup& soup, const Transform& transform) const override {
    return from_.leaf->add_to(soup, transform * from_.transform);
  }
  std::vector<Attributes> regions() const override { return from_.leaf->regions(); }

 private:
  LeafInstance from_;
};

/// The form under the transform, if it is one and has arcs neither before nor after.
std::optional<RevolvedForm> stretched(const RevolvedForm& form, const Transform& transform) {
  const CircleFrame frame(form.axis);
  const RationalPoint along = transform.apply_to_vector(form.axis),
                      first = transform.apply_to_vector(frame.first()),
                      second = transform.apply_to_vector(frame.second());
  const Rational square = dot(first, first) / dot(frame.first(), frame.first());
  if (dot(along, first) != 0 || dot(along, second) != 0 || dot(first, second) != 0 ||
      dot(second, second) != square * dot(frame.second(), frame.second()))
    return std::nullopt;
  const std::optional<Rational> scale = rational_root(square);
  if (!scale) return std::nullopt;
  const CircleFrame there(along);
  const auto agree = [](const RationalPoint& a, const RationalPoint& b) {
    return is_zero(cross(a, b)) && dot(a, b) > 0;
  };
  if (!agree(first, there.first()) || !agree(second, there.second())) return std::nullopt;
  RevolvedForm result = form;
  result.center = transform.apply(form.center);
  result.axis = along;
  for (auto& line : result.lines) {
    for (MeridianPiece& piece : line) {
      if (piece.kind == MeridianPiece::Kind::arc) return std::nullopt;
      piece.from.r *= *scale;
      piece.to.r *= *scale;
      for (Homogeneous& h : piece.net.net) h[0] *= *scale;
    }
  }
  return result;
}

/// Puts leaves that are what the stretched ones become in their places, with the identity as transform; returns
/// what was there, by instance. Meridians with arcs become others, and stay; so do leaves whose turn would begin
/// elsewhere, and all that are stretched as one of these is, for with that they may share something.
std::map<Index, LeafInstance> replace_axial(std::vector<LeafInstance>& instances) {
  std::map<Index, std::pair<Metric, RevolvedForm>> forms;
  std::set<Metric> stay;
  for (Index i = 0; i < instances.size(); ++i) {
    const CurvedForm* const form = instances[i].leaf->form().get();
    const auto* revolved = dynamic_cast<const RevolvedForm*>(form);
    if ((revolved == nullptr && dynamic_cast<const BandedForm*>(form) == nullptr) ||
        stretch(instances[i].transform))
      continue;
    std::optional<RevolvedForm> there;
    if (revolved != nullptr) there = stretched(*revolved, instances[i].transform);
    Metric metric = metric_of(instances[i].transform);
    if (there) forms.emplace(i, std::pair(std::move(metric), std::move(*there)));
    else stay.insert(std::move(metric));
  }
  std::map<Index, LeafInstance> before;
  for (auto& [i, entry] : forms) {
    auto& [metric, form] = entry;
    if (stay.contains(metric)) continue;
    before.emplace(i, instances[i]);
    instances[i] = {std::make_shared<const AxialLeaf>(instances[i], std::move(form)), {}};
  }
  return before;
}

/// Puts those back that nothing else has replaced.
void restore_axial(const std::map<Index, LeafInstance>& before, std::vector<LeafInstance>& instances) {
  for (const auto& [i, instance] : before) {
    if (dynamic_cast<const AxialLeaf*>(instances[i].leaf.get()) != nullptr) instances[i] = instance;
  }
}

/// False for an axis whose numbers are too far apart for doubles, such as [1e300, 1, 0]: such a leaf stays as it
/// is.
bool in_range_of_doubles(const RationalPoint& axis, const Transform& transform) {
  const RationalPoint direction = axis_line({0, 0, 0}, transform.apply_to_vector(axis)).direction;
  return to_double(dot(direction, direction)) < 1e300 && to_double(dot(axis, axis)) < 1e300;
}

/// Leaves of revolution, arcs of extrusions and bands, and which of them are near each other.
struct RoundLeaves {
  std::vector<Index> all;
  std::vector<RevolvedInstance> revolved;
  std::vector<std::array<Index, 2>> pairs;  ///< whose boxes meet, each once
};

RoundLeaves round_leaves(const std::vector<LeafInstance>& instances) {
  RoundLeaves round;
  std::vector<Box> boxes;
  for (Index i = 0; i < instances.size(); ++i) {
    const CurvedForm* const form = instances[i].leaf->form().get();
    if (const auto* of = dynamic_cast<const RevolvedForm*>(form)) {
      if (!in_range_of_doubles(of->axis, instances[i].transform)) continue;
      boxes.push_back(box_of(*of, instances[i].transform));
      round.revolved.push_back({i, instances[i].transform, boxes.back()});
    } else if (const auto* extrusion = dynamic_cast<const ExtrudeForm*>(form)) {
      if (!in_range_of_doubles(extrusion->shape.vector, instances[i].transform)) continue;
      boxes.push_back(box_of(*extrusion, instances[i].transform));
    } else if (const auto* banded = dynamic_cast<const BandedForm*>(form)) {
      Box box;
      for (const Band& band : banded->bands) box.extend(box_of(band.form, instances[i].transform));
      boxes.push_back(box);
    } else {
      continue;
    }
    round.all.push_back(i);
  }
  const BoxTree tree(boxes);
  for (Index a = 0; a < round.all.size(); ++a) {
    tree.query([&](const Box& box) { return box.meets(boxes[a]); },
               [&](Index b) {
                 if (b < a) round.pairs.push_back({round.all[b], round.all[a]});
               });
  }
  return round;
}

/// Leaves that are drawn on lines in common, and where.
struct Moved {
  std::vector<Index> members;  ///< ascending
  Transform space;             ///< to the space of the tree
};

/// Takes those leaves out of the spaces that are to be drawn elsewhere than in the space of the tree.
std::vector<Moved> take_moved(const std::vector<LeafInstance>& instances, std::vector<RoundSpace>& spaces) {
  std::vector<Moved> moved;
  for (RoundSpace& of : spaces) {
    UnionFind sets(instances.size());
    for (const auto& [a, b] : of.near) sets.unite(a, b);
    for (const auto& [a, b] : of.contacts.nested) sets.unite(a, b);
    for (const Inside& pair : of.contacts.inside) sets.unite(pair.inner, pair.outer);
    for (const auto& [circle, all] : of.contacts.circles) {
      for (const HasCircle& one : all) sets.unite(one.instance, all.begin()->instance);
    }
    std::map<Index, std::vector<Index>> groups;
    for (const Index i : of.instances) groups[sets.find(i)].push_back(i);
    std::set<Index> gone;
    for (const auto& [first, members] : groups) {
      Transform space = space_of(members, instances);
      if (space.identity()) continue;
      gone.insert(members.begin(), members.end());
      moved.push_back({members, std::move(space)});
    }
    std::erase_if(of.instances, [&](Index i) { return gone.contains(i); });
    std::erase_if(of.contacts.circles,
                  [&](const auto& entry) { return gone.contains(entry.second.begin()->instance); });
  }
  return moved;
}

class CommonLines {
 public:
  CommonLines(const ExtraOfInstances& extra, std::set<Index>& drawn, std::vector<LeafWords>& told,
              DrawnLeaves& known)
      : extra_(extra), drawn_(drawn), told_(told), known_(known) {}

  void draw(std::vector<LeafInstance>& instances, std::vector<NearSurfaces>* near,
            const std::vector<Index>& anew) const {
    const auto is_moved = [](const LeafInstance& one) { return !one.above->identity(); };
    const bool any_moved = std::ranges::any_of(instances, is_moved);
    const std::vector<LeafInstance> given = any_moved ? instances : std::vector<LeafInstance>();
    const std::map<Index, LeafInstance> stretched = replace_axial(instances);
    const RoundLeaves round = round_leaves(instances);
    if (round.all.empty()) return;  // so none was replaced
    const std::vector<std::array<Index, 2>> about_one_axis = near_axes(instances, round.pairs);
    if (near != nullptr) *near = near_surfaces(instances, about_one_axis);
    std::vector<RoundSpace> spaces =
        round_spaces(instances, round.revolved, round.pairs, about_one_axis, anew, extra_);
    const std::vector<Moved> moved = any_moved ? take_moved(given, spaces) : std::vector<Moved>();
    share_axes(instances, spaces, extra_, drawn_, told_, known_);
    restore_axial(stretched, instances);
    if (!moved.empty()) draw_moved(moved, given, round, instances);
  }

 private:
  /// Leaves that were moved together are drawn as if they had not been, with all that they may touch, and moved
  /// then.
  void draw_moved(const std::vector<Moved>& moved, const std::vector<LeafInstance>& given,
                  const RoundLeaves& round, std::vector<LeafInstance>& instances) const {
    std::map<Index, std::vector<Index>> beside;
    for (const auto& [a, b] : round.pairs) {
      beside[a].push_back(b);
      beside[b].push_back(a);
    }
    for (const BesidePlanes& one : beside_planes(given, round.revolved, {})) {
      for (const Index i : one.revolved) beside[i].push_back(one.instance);
    }
    for (const auto& [members, space] : moved) {
      std::vector<Index> here = members;
      for (const Index i : members) here.insert(here.end(), beside[i].begin(), beside[i].end());
      sort_unique(here);
      draw_in(space, members, here, given, instances);
    }
  }

  void draw_in(const Transform& space, const std::vector<Index>& members, const std::vector<Index>& here,
               const std::vector<LeafInstance>& given, std::vector<LeafInstance>& instances) const {
    std::vector<LeafInstance> there;
    ExtraOfInstances extra;
    for (const Index i : here) {
      if (const auto lines = extra_.find(i); lines != extra_.end())
        extra.emplace(static_cast<Index>(there.size()), lines->second);
      there.push_back(given[i]);
    }
    there = before(space, there);
    std::set<Index> drawn;
    std::vector<LeafWords> told;
    CommonLines(extra, drawn, told, known_).draw(there, nullptr, {});
    const auto is_member = [&](Index k) { return std::ranges::binary_search(members, here[k]); };
    for (Index k = 0; k < here.size(); ++k) {
      if (!is_member(k) || there[k].leaf == given[here[k]].leaf) continue;
      instances[here[k]] = {there[k].leaf, space * there[k].transform};
    }
    for (const Index k : drawn) {
      if (is_member(k)) drawn_.insert(here[k]);
    }
    for (const LeafWords& words : told) {
      if (is_member(words.places().front().leaf)) told_.push_back(words.renumbered(here));
    }
  }

  const ExtraOfInstances& extra_;
  std::set<Index>& drawn_;
  std::vector<LeafWords>& told_;
  DrawnLeaves& known_;
};

}  // namespace

Transform space_of(const std::vector<Index>& members, const std::vector<LeafInstance>& instances) {
  std::map<Placement, std::pair<std::size_t, const Transform*>> moves;
  for (const Index i : members) {
    const auto it = moves.try_emplace(Placement(instances[i].above), 0, &*instances[i].above).first;
    ++it->second.first;
  }
  const auto seen_from = [&](const Transform& space) {
    const Placement back(space.inverse());
    std::vector<std::pair<Placement, std::size_t>> seen;
    for (const auto& [move, entry] : moves) seen.emplace_back(back * move, entry.first);
    std::sort(seen.begin(), seen.end());
    return seen;
  };
  const std::pair<std::size_t, const Transform*>* best = nullptr;
  for (const auto& [move, entry] : moves) {
    if (best == nullptr || entry.first > best->first ||
        (entry.first == best->first && seen_from(*entry.second) < seen_from(*best->second)))
      best = &entry;
  }
  return *best->second;
}

std::vector<LeafInstance> before(const Transform& motion, const std::vector<LeafInstance>& instances) {
  if (motion.identity()) return instances;
  const Transform back = motion.inverse();
  std::vector<LeafInstance> out;
  for (const LeafInstance& one : instances) out.push_back({one.leaf, back * one.transform, {}});
  return out;
}

std::vector<LeafInstance> with_common_lines(std::vector<LeafInstance> instances, std::vector<NearSurfaces>* near,
                                            std::vector<LeafWords>* apart, const std::vector<Index>& anew,
                                            const ExtraOfInstances& extra, std::set<Index>* drawn,
                                            DrawnLeaves* known) {
  std::set<Index> have_lines;
  std::vector<LeafWords> told;
  DrawnLeaves none_known;
  if (drawn == nullptr) drawn = &have_lines;
  instances = with_common_nets(instances, extra, drawn);
  CommonLines(extra, *drawn, told, known == nullptr ? none_known : *known).draw(instances, near, anew);
  if (apart != nullptr) *apart = std::move(told);
  return instances;
}

}  // namespace cnrg
