// Who is in which family, then a tessellation per family.
//
//   instances -> those near a common axis     near_axes.cpp, in doubles; most pairs end here
//             -> one space for all of them    round_spaces.h; mostly that of the tree
//             -> families                     contacts of meridians, exactly; a sphere has every axis through its
//             centre
//             -> directions and meridians     family.h; turns.h, meridians.h; of families
//             that touch family.h, shared_balls.h
//             -> leaves
#include "csg/carriers/revolved_families.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "csg/carriers/axes.h"
#include "csg/carriers/ball_hull.h"
#include "csg/carriers/banded_leaves.h"
#include "csg/carriers/extruded_arcs.h"
#include "csg/carriers/family.h"
#include "csg/carriers/near_surfaces.h"
#include "csg/carriers/shared_balls.h"
#include "csg/curves/surface_placed.h"
#include "csg/geometry/placement.h"
#include "csg/leaves/parameters.h"
#include "csg/leaves/prepare_shapes.h"
#include "kernel/base/union_find.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

using Index = std::uint32_t;

constexpr double kNearSides = 0.05;  // of the radius

/// Families of one space.
class Space {
 public:
  /// `finer`: by how much banded leaves are drawn finer than they ask for.
  Space(std::vector<LeafInstance>& instances, const RoundSpace& of, const std::map<Index, int>& finer,
        const ExtraOfInstances& extra, std::set<Index>& drawn, std::vector<LeafWords>& notices, DrawnLeaves& known)
      : instances_(instances),
        of_(of),
        finer_(finer),
        extra_(extra),
        drawn_(drawn),
        known_(known),
        banded_(notices) {
    for (const Index i : of.instances) add(i);
  }

  /// Gives the banded leaves that could be drawn if they were finer.
  std::set<Index> run() {
    touch_leaves();
    touch_balls();
    touch_nested();
    touch_near_balls();
    touch_inside();
    touch_circles();
    build();
    return too_coarse_;
  }

 private:
  void add(Index i) {
    const Transform relative = of_.relative(instances_[i].transform);
    relative_.emplace(i, relative);
    if (const auto* extrusion = dynamic_cast<const ExtrudeForm*>(instances_[i].leaf->form().get())) {
      for (ExtrudedArc& arc : arcs_of(*extrusion, relative)) {
        add_node(i, {arc.placed, {i}, arc.segments, false, std::make_shared<const ExtrudedArc>(std::move(arc))});
      }
      return;
    }
    const std::optional<Rational> scale = stretch(relative);
    if (!scale) return;
    if (const auto banded = std::dynamic_pointer_cast<const BandedForm>(instances_[i].leaf->form())) {
      banded_.add(i, banded);
      for (std::size_t b = 0; b < banded->bands.size(); ++b) add_band(i, b, relative, *scale);
      return;
    }
    forms_.emplace(i, std::dynamic_pointer_cast<const RevolvedForm>(instances_[i].leaf->form()));
    const RevolvedForm& form = form_of(i);
    if (form.is_sphere()) {
      balls_[{relative.apply(form.center), *scale * form.lines[0][0].radius}].push_back(i);
      return;
    }
    add_node(i, {place(form, relative, *scale), {i}, form.segments, false});
  }

  const RevolvedForm& form_of(Index i) const { return *forms_.at(i); }

  /// The nodes of two balls on an axis through their centres, in one family.
  std::array<Index, 2> join_balls(const Ball& a, const Ball& b, const RationalPoint& along) {
    const AxisLine axis = axis_line(a.center, along);
    const std::array<Index, 2> nodes{ball_node(a, axis, ball_on(a, axis)), ball_node(b, axis, ball_on(b, axis))};
    edges_.push_back(nodes);
    on_axes_.insert({a, b});
    return nodes;
  }

  /// Balls that touch from inside.
  void touch_nested() {
    for (const auto& [i, j] : of_.contacts.nested) {
      if (!forms_.contains(i) || !forms_.contains(j)) continue;
      const Ball a = ball_of(i), b = ball_of(j);
      join_balls(a, b, b.center - a.center);
      shared_.nest(a.radius < b.radius ? a : b, a.radius < b.radius ? b : a);
    }
  }

  /// Balls nearly in one place, with equally many steps.
  void touch_near_balls() {
    for (const auto& [i, j] : of_.near) {
      if (of_leaf_.contains(i) || of_leaf_.contains(j) || !forms_.contains(i) || !forms_.contains(j)) continue;
      const Ball a = ball_of(i), b = ball_of(j);
      if (a == b) continue;
      const RationalPoint between = b.center - a.center;
      const double apart = std::sqrt(to_double(dot(between, between))) + std::abs(to_double(a.radius - b.radius));
      if (!(apart <= kNearBalls * to_double(a.radius + b.radius))) continue;
      const std::array<Index, 2> nodes =
          join_balls(a, b, is_zero(between) ? relative_.at(i).apply_to_vector(form_of(i).axis) : between);
      int& steps = nodes_[nodes[0]].placed.lines[0][0].steps;
      int& others = nodes_[nodes[1]].placed.lines[0][0].steps;
      steps = others = std::max(steps, others);
    }
  }

  /// Balls and tubes in tubes about parallel axes, and the like, likewise.
  void touch_inside() {
    for (const auto& [inner, outer, direction] : of_.contacts.inside) {
      const auto tube = of_leaf_.find(of_leaf_.contains(outer) ? outer : inner);
      if (tube == of_leaf_.end()) continue;
      const auto node = [&](Index i, const RationalPoint& along) {
        if (const auto leaf = of_leaf_.find(i); leaf != of_leaf_.end()) return leaf->second[0];
        const Ball ball = ball_of(i);
        const AxisLine axis = axis_line(ball.center, along);
        on_axes_.insert(ball);
        return ball_node(ball, axis, ball_on(ball, axis));
      };
      const RationalPoint along = nodes_[tube->second[0]].placed.axis.direction;
      const Index in = node(inner, along), around = node(outer, along);
      inside_.push_back({in, around, direction});
      nested_nodes_.insert({in, around});
    }
  }

  void touch_circles() {
    for (const auto& [circle, all] : of_.contacts.circles) {
      for (const auto& [i, radius, direction] : all) {
        Index node = 0;
        if (const auto leaf = of_leaf_.find(i); leaf != of_leaf_.end()) {
          node = leaf->second[0];
        } else {
          const Ball ball = ball_of(i);
          const AxisLine axis = axis_line(circle.center, circle.axis);
          node = ball_node(ball, axis, ball_on(ball, axis));
          on_axes_.insert(ball);
        }
        has_circle_.push_back({circle, node, radius, direction});
        nested_nodes_.insert(node);
      }
    }
  }

  void add_node(Index i, Member member) {
    of_leaf_[i].push_back(static_cast<Index>(nodes_.size()));
    nodes_.push_back(std::move(member));
  }

  void add_band(Index i, std::size_t b, const Transform& relative, const Rational& scale) {
    const Band& band = banded_.bands(i)[b];
    Member member{place(band.form, relative, scale), {i}, band.form.segments, false};
    const auto image = [&](const RationalPoint& d) { return (1 / scale) * relative.apply_to_vector(d); };
    member.placed.start = image(band.start);
    member.placed.end = image(band.end);
    for (const RationalPoint& d : band.marks) member.marks.push_back(image(d));
    if (const auto finer = finer_.find(i); finer != finer_.end()) {
      member.segments *= finer->second;
      member.placed.lines[0][0].steps *= finer->second;
    }
    member.band = b;
    member.whole = band.whole;
    add_node(i, std::move(member));
  }

  /// Whether two members, one of them a band, that touch as far as their meridians go shall have common lines.
  bool join_bands(const Member& a, const Member& b) {
    const auto side = [&](const Member& member) {
      const Index i = member.instances[0];
      const Band* const band = member.band ? &banded_.bands(i)[*member.band] : nullptr;
      return BandedLeaves::Side{i, band, member.placed, sector_of(member)};
    };
    return banded_.join(side(a), side(b));
  }

  /// Whole bands of one leaf: a ring between two of them, in a plane, must not be crossed by chords of the outer
  /// one.
  static bool beside_each_other(const Member& a, const Member& b) {
    return a.band && b.band && a.whole && b.whole && a.instances == b.instances;
  }

  void touch_leaves() {
    UnionFind known(nodes_.size());  // the rest of a family need not be asked
    const auto touch_two = [&](Index a, Index b) {
      const Member &p = nodes_[a], &q = nodes_[b];
      const bool same = known.find(a) == known.find(b), banded = p.band || q.band;
      if ((same && !banded) || p.placed.axis != q.placed.axis) return;
      if (touch(p.placed, q.placed)) {
        if (banded && !join_bands(p, q)) return;
      } else if (!banded && sides_near(p.placed, q.placed, kNearSides)) {
        // Only facets of one kind tell that they are apart.
      } else if (!beside_each_other(p, q)) {
        return;
      }
      if (!same) edges_.push_back({a, b});
      known.unite(a, b);
    };
    for (const auto& [i, j] : of_.near) {
      const auto first = of_leaf_.find(i), second = of_leaf_.find(j);
      if (first == of_leaf_.end() || second == of_leaf_.end()) continue;
      for (const Index a : first->second) {
        for (const Index b : second->second) touch_two(a, b);
      }
    }
    // Arcs of one extrusion that follow one another about one axis, bands of one leaf.
    for (const auto& [i, own] : of_leaf_) {
      for (std::size_t a = 0; a < own.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) touch_two(own[a], own[b]);
      }
    }
  }

  Ball ball_of(Index i) const {
    const Transform& relative = relative_.at(i);
    return {relative.apply(form_of(i).center), *stretch(relative) * form_of(i).lines[0][0].radius};
  }

  Member ball_on(const Ball& ball, const AxisLine& axis) const {
    const std::vector<Index>& of = balls_.at(ball);
    Member member{place(sphere_about(ball, axis.direction, form_of(of.front())), Transform{}, 1), of, 0, true};
    int& rings = member.placed.lines[0][0].steps;
    for (const Index i : of) {
      member.segments = std::max(member.segments, form_of(i).segments);
      rings = std::max(rings, form_of(i).lines[0][0].steps);
    }
    return member;
  }
  /// The node of a ball on an axis.
  Index ball_node(const Ball& ball, const AxisLine& axis, Member member) {
    const auto [it, fresh] = ball_nodes_.try_emplace({ball, axis}, static_cast<Index>(nodes_.size()));
    if (fresh) nodes_.push_back(std::move(member));
    return it->second;
  }

  void touch_balls() {
    for (const auto& [i, j] : of_.near) {
      const bool first = of_leaf_.contains(i);
      if (first == of_leaf_.contains(j) || !forms_.contains(first ? j : i)) continue;
      const Ball ball = ball_of(first ? j : i);
      for (const Index leaf : of_leaf_.at(first ? i : j)) {
        const AxisLine axis = nodes_[leaf].placed.axis;
        // Whether they touch or not: two balls may cross in a plane of the leaf.
        if (!axis.holds(ball.center)) continue;
        Member member = ball_on(ball, axis);
        if (nodes_[leaf].band && (!touch(nodes_[leaf].placed, member.placed) || !join_bands(nodes_[leaf], member)))
          continue;
        edges_.push_back({leaf, ball_node(ball, axis, std::move(member))});
        on_axes_.insert(ball);
      }
    }
  }

  bool needs_marks(const Member& member) const {
    return std::any_of(member.instances.begin(), member.instances.end(), [&](Index i) {
      const auto marks = of_.contacts.marks.find(i);
      return marks != of_.contacts.marks.end() && marks->second.needed;
    });
  }

  bool needs_lines(const Member& member) const {
    return member.arc == nullptr && !member.band &&
           std::any_of(member.instances.begin(), member.instances.end(),
                       [&](Index i) { return extra_.contains(i); });
  }

  /// Leaves that are drawn alike as they are.
  bool alike(const std::vector<Index>& of) const {
    const Member& first = nodes_[of[0]];
    if (std::any_of(of.begin(), of.end(), [&](Index n) { return nodes_[n].band.has_value(); })) {
      return std::none_of(of.begin(), of.end(),
                          [&](Index n) { return nodes_[n].band && banded_.is_anew(nodes_[n].instances[0]); });
    }
    if (std::all_of(of.begin(), of.end(), [&](Index n) {
          return nodes_[n].instances.size() == 1 && nodes_[n].instances[0] == first.instances[0];
        }))
      return true;
    if (std::any_of(of.begin(), of.end(), [&](Index n) { return nodes_[n].arc != nullptr; }))
      return arcs_alike(of);
    for (const Index n : of) {
      const Member& member = nodes_[n];
      const Transform& transform = instances_[member.instances[0]].transform;
      if (transform != instances_[first.instances[0]].transform || member.segments != first.segments) return false;
      for (const Index i : member.instances) {
        if (instances_[i].transform != transform) return false;
      }
      if (member.ball) {
        if (of.size() > 1) return false;
        for (const Index i : member.instances) {
          const RevolvedForm &a = form_of(i), &b = form_of(member.instances[0]);
          if (a.segments != b.segments || a.lines[0][0].steps != b.lines[0][0].steps) return false;
        }
        continue;
      }
      const PlacedForm& placed = member.placed;
      if (placed.start != placed.end || placed.along != first.placed.along) return false;
      for (const auto& line : placed.lines) {
        for (const MeridianPiece& piece : line) {
          if (piece.kind != MeridianPiece::Kind::line || piece.from.r != piece.to.r) return false;
        }
      }
    }
    return true;
  }

  /// Arcs that are drawn alike as they are (nets.h): those that overlap are equal curves.
  bool arcs_alike(const std::vector<Index>& of) const {
    for (const Index n : of) {
      if (nodes_[n].arc == nullptr) return false;
    }
    for (const Index a : of) {
      for (const Index b : of) {
        if (a >= b || nodes_[a].instances[0] == nodes_[b].instances[0]) continue;
        if (overlap(nodes_[a].placed, nodes_[b].placed) && !same_arc(*nodes_[a].arc, *nodes_[b].arc)) return false;
      }
    }
    return true;
  }
  void build() {
    // A ball that meets nobody about an axis, but another ball or a mark: about the axis of its own leaf.
    for (const auto& [ball, of] : balls_) {
      if (on_axes_.contains(ball)) continue;
      // It keeps the meridians of its leaf; of several leaves those of the finest.
      const Index finest = *std::min_element(of.begin(), of.end(), [&](Index a, Index b) {
        const int p = form_of(a).segments, q = form_of(b).segments;
        return p != q ? p > q : Placement(relative_.at(a)) < Placement(relative_.at(b));
      });
      const Transform& relative = relative_.at(finest);
      const PlacedForm own = place(form_of(finest), relative, *stretch(relative));
      Member member = ball_on(ball, own.axis);
      member.even = own.start;
      ball_node(ball, own.axis, std::move(member));
    }
    UnionFind sets(nodes_.size());
    for (const auto& [a, b] : edges_) sets.unite(a, b);
    std::map<Index, std::vector<Index>> families;
    for (Index n = 0; n < nodes_.size(); ++n) families[sets.find(n)].push_back(n);
    for (const auto& [first, of] : families) {
      const bool marked = std::any_of(of.begin(), of.end(), [&](Index n) { return needs_marks(nodes_[n]); });
      const bool nested = std::any_of(of.begin(), of.end(), [&](Index n) { return nested_nodes_.contains(n); });
      if (marked || nested || !alike(of)) {
        make_family(of, nested);
      } else if (std::any_of(of.begin(), of.end(), [&](Index n) { return needs_lines(nodes_[n]); })) {
        // A ball keeps the parameters of its leaf.
        Member& member = nodes_[first];
        if (member.ball) {
          const Index i = member.instances.front();
          member.placed = place(form_of(i), relative_.at(i), *stretch(relative_.at(i)));
          member.ball = false;
        }
        make_family(of, false);
      }
    }
    solve_turns();
    for (const auto& [ball, of] : balls_) {
      if (const auto hull = shared_.hull(ball)) replace_ball(ball, hull);
    }
    for (const auto& [family, of] : families_) {
      for (std::size_t m = 0; m < of.size(); ++m) {
        if (nodes_[of[m]].ball && shared_.hull(ball_of(nodes_[of[m]].instances[0]))) continue;
        if (nodes_[of[m]].arc != nullptr) {
          fix_arc(*family, m);
          continue;
        }
        if (const auto band = nodes_[of[m]].band) {
          const Index i = nodes_[of[m]].instances[0];
          banded_.set_grid(i, *band, family->band_grid(m, relative_.at(i).inverse()));
          continue;
        }
        for (const Index i : nodes_[of[m]].instances) replace(i, family, m);
      }
    }
    too_coarse_ = banded_.draw(instances_);
    for (auto& [i, fixed] : fixed_) {
      const PreparedLeaf& before = *instances_[i].leaf;
      std::unique_ptr<PreparedLeaf> leaf =
          extrude_anew(dynamic_cast<const ExtrudeForm&>(*before.form()), relative_.at(i), std::move(fixed));
      leaf->set_surfaces(moved(before.surfaces(), relative_.at(i)));
      instances_[i] = {std::move(leaf), of_.base};
    }
  }

  /// The points of an arc of an extrusion: in the plane of its curve, on the directions of the family.
  void fix_arc(const Family& family, std::size_t m) {
    const Member& member = family.members()[m];
    const ExtrudedArc& arc = *member.arc;
    std::vector<FixedSample>& samples = fixed_[member.instances[0]][{arc.segment, arc.piece}];
    const auto columns = family.columns(m, arc.degrees);
    for (std::size_t i = 1; i + 1 < columns.size(); ++i) {
      samples.push_back({arc.parameter(columns[i].turn), family.point(arc.placed.lines[0][0].from, columns[i])});
    }
  }

  void make_family(const std::vector<Index>& of, bool nested) {
    std::vector<Member> members;
    members.reserve(of.size());
    for (const Index n : of) members.push_back(nodes_[n]);
    const auto family = std::make_shared<Family>(std::move(members), of_.base->identity() && !nested);
    for (std::size_t m = 0; m < of.size(); ++m) {
      for (const Index i : nodes_[of[m]].instances) {
        const auto marks = of_.contacts.marks.find(i);
        if (marks != of_.contacts.marks.end()) family->add_marks(m, marks->second);
      }
    }
    families_.emplace_back(family, of);
  }

  void add_lines(Family& family, std::size_t m) {
    const Member& member = family.members()[m];
    if (member.band) return;
    for (const Index i : member.instances) {
      const auto extra = extra_.find(i);
      if (extra == extra_.end()) continue;
      drawn_.insert(i);
      if (member.arc != nullptr) {
        const auto& extrusion = dynamic_cast<const ExtrudeForm&>(*instances_[i].leaf->form());
        family.add_lines(m, revolved_lines(extra->second, extrusion, *member.arc));
      } else if (!member.ball) {
        family.add_lines(m, revolved_lines(extra->second, form_of(i), relative_.at(i), *stretch(relative_.at(i))));
      } else if (shared_.is_hull(ball_of(i))) {
        shared_.add_lines(ball_of(i), extra->second);
      } else {
        family.add_lines(m, revolved_lines(extra->second, ball_about(i, family.axis()), {}, 1));
      }
    }
  }
  /// A sphere is turned with all its parameters to the axis that it shares.
  RevolvedForm ball_about(Index i, const AxisLine& axis) const {
    return sphere_about(ball_of(i), axis.direction, form_of(i));
  }

  /// Draws what is inside before what is around it, and balls about several axes.
  void solve_turns() {
    std::vector<std::shared_ptr<Family>> families;
    std::map<Index, std::size_t> family_of, member_of;
    for (const auto& [family, of] : families_) {
      for (std::size_t m = 0; m < of.size(); ++m) {
        family_of.emplace(of[m], families.size());
        member_of.emplace(of[m], m);
        if (!nodes_[of[m]].ball) continue;
        std::vector<RationalPoint> points;
        for (const Index i : nodes_[of[m]].instances) {
          const auto marks = of_.contacts.marks.find(i);
          if (marks == of_.contacts.marks.end()) continue;
          points.insert(points.end(), marks->second.points.begin(), marks->second.points.end());
        }
        shared_.add(ball_of(nodes_[of[m]].instances[0]), *family, m, points);
      }
      families.push_back(family);
    }
    shared_.choose();
    for (const auto& [family, of] : families_) {
      for (std::size_t m = 0; m < of.size(); ++m) add_lines(*family, m);
    }
    std::vector<NestedFamilies> nested;
    for (const auto& [inner, outer, direction] : inside_)
      nested.push_back({family_of.at(inner), family_of.at(outer), direction});
    CommonCircles circles;
    for (const auto& [circle, node, radius, direction] : has_circle_)
      circles.add(circle, {families[family_of.at(node)], member_of.at(node), radius, direction});
    for (const auto& family : families) family->solve_meridians();
    shared_.solve([&] {
      do cnrg::solve_turns(families, nested);
      while (circles.exchange());
    });
  }

  void replace_ball(const Ball& ball, const std::shared_ptr<const BallHull>& hull) {
    const auto make = [ball, hull](LeafParameters* record) { return tessellate(ball, *hull, record); };
    const SurfaceSource surfaces = [ball] { return sphere_surfaces(ball.center, ball.radius, {0, 0, 1}); };
    for (const Index i : balls_.at(ball)) instances_[i] = {made(make, surfaces), of_.base};
  }

  void replace(Index i, const std::shared_ptr<Family>& family, std::size_t m) {
    const auto form = std::make_shared<const RevolvedForm>(
        family->members()[m].ball ? ball_about(i, family->axis()) : form_of(i));
    const auto grid = std::make_shared<const RevolvedGrid>(family->grid(m, *form));
    const auto make = [form, grid, family](LeafParameters* record) {
      return tessellate(
          *form, *grid,
          [&](const MeridianPoint& at, std::size_t column) { return family->point(at, grid->columns[column]); },
          record);
    };
    SurfaceSource surfaces;
    if (family->members()[m].ball) {
      surfaces = [ball = ball_of(i), axis = form->axis] {
        return sphere_surfaces(ball.center, ball.radius, axis);
      };
    } else {
      surfaces = moved(instances_[i].leaf->surfaces(), relative_.at(i));
    }
    const DrawnLeaves::Lines lines{relative_.at(i), family->axis(), family->rounded(), *grid};
    instances_[i] = {known_.on(instances_[i].leaf, lines, [&] { return made(make, surfaces); }), of_.base};
  }

  template <class Make>
  static std::unique_ptr<PreparedLeaf> made(const Make& make, const SurfaceSource& surfaces) {
    std::unique_ptr<PreparedLeaf> leaf = make(nullptr);
    leaf->set_parameters([make] {
      auto parameters = std::make_shared<LeafParameters>();
      make(parameters.get());
      return parameters;
    });
    leaf->set_surfaces(surfaces);
    return leaf;
  }

  std::vector<LeafInstance>& instances_;
  const RoundSpace& of_;
  const std::map<Index, int>& finer_;
  const ExtraOfInstances& extra_;
  std::set<Index>& drawn_;
  DrawnLeaves& known_;
  BandedLeaves banded_;
  std::set<Index> too_coarse_;
  std::map<Index, std::shared_ptr<const RevolvedForm>> forms_;  // as the leaves were
  std::map<Index, Transform> relative_;
  std::map<Index, std::vector<Index>> of_leaf_;  // nodes of an instance that is no sphere
  std::vector<Member> nodes_;
  std::map<Ball, std::vector<Index>> balls_;
  std::map<std::pair<Ball, AxisLine>, Index> ball_nodes_;
  std::set<Ball> on_axes_;  // of other leaves
  std::vector<std::array<Index, 2>> edges_;
  std::vector<Inside> inside_;  // of nodes
  struct OfCircle {
    CircleInSpace circle;
    Index node;
    Rational radius;
    std::optional<RationalPoint> direction;
  };
  std::vector<OfCircle> has_circle_;
  std::set<Index> nested_nodes_;
  std::vector<std::pair<std::shared_ptr<Family>, std::vector<Index>>> families_;  // and their nodes
  SharedBalls shared_;
  std::map<Index, FixedSamples> fixed_;
};

/// Replaces what `share_axes` does, with banded leaves as much finer as `finer` says; gives those that need more.
std::set<Index> share_at(const std::map<Index, int>& finer, std::vector<LeafInstance>& instances,
                         const std::vector<RoundSpace>& spaces, const ExtraOfInstances& extra,
                         std::set<Index>& drawn, std::vector<LeafWords>& notices, DrawnLeaves& known) {
  std::set<Index> too_coarse;
  for (const RoundSpace& of : spaces) {
    Space space(instances, of, finer, extra, drawn, notices, known);
    too_coarse.merge(space.run());
  }
  return too_coarse;
}

}  // namespace

void share_axes(std::vector<LeafInstance>& instances, const std::vector<RoundSpace>& spaces,
                const ExtraOfInstances& extra, std::set<Index>& drawn, std::vector<LeafWords>& notices,
                DrawnLeaves& known) {
  constexpr int kFinest = 8;
  const std::vector<LeafInstance> given = instances;
  std::map<Index, int> finer;
  for (;;) {
    std::vector<LeafWords> told;
    bool again = false;
    for (const Index i : share_at(finer, instances, spaces, extra, drawn, told, known)) {
      int& factor = finer.try_emplace(i, 1).first->second;
      again = again || factor < kFinest;
      factor = std::min(2 * factor, kFinest);
    }
    if (!again) {
      notices.insert(notices.end(), told.begin(), told.end());
      return;
    }
    instances = given;
  }
}

}  // namespace cnrg
