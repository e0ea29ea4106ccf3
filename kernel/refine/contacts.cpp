// Pairs come from the broad phase (box_pairs.h); most are neighbours in a mesh, which a `Glance` passes over
// without a predicate. A `PairTester` decides the others.
#include "kernel/refine/contacts.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "kernel/base/parallel.h"
#include "kernel/exact/predicates.h"
#include "kernel/refine/box_pairs.h"
#include "kernel/refine/fans.h"
#include "kernel/refine/pair_tester.h"

namespace cnrg {

void ContactList::append(const ContactList& other) {
  traces.insert(traces.end(), other.traces.begin(), other.traces.end());
  on_face.insert(on_face.end(), other.on_face.begin(), other.on_face.end());
  on_wire.insert(on_wire.end(), other.on_wire.begin(), other.on_wire.end());
  wires_in_plane.insert(wires_in_plane.end(), other.wires_in_plane.begin(), other.wires_in_plane.end());
  coplanar.insert(coplanar.end(), other.coplanar.begin(), other.coplanar.end());
  candidates += other.candidates;
  for (std::size_t i = 0; i < kinds.size(); ++i) kinds[i] += other.kinds[i];
}

namespace {

/// Faces with the same sides are one point set: whatever the first of them meets, all meet.
struct EqualFaces {
  std::vector<std::pair<SourceId, SourceId>> pairs;  ///< the first of equal faces, and each other one
  /// By face: how many are equal to it, with itself; 0 for all but the first of them. Empty if no two are equal.
  std::vector<std::uint32_t> copies;
};

/// Leaves out two equal faces that no third face touches along a side. In a mesh that meets no other, every side
/// is one of two faces in opposite directions. A face with such a side has one equal face at most, so it is not
/// looked up: meshes in general position cost nothing.
EqualFaces equal_faces(const RefineInput& in) {
  std::vector<std::pair<std::uint64_t, SourceId>> faces;  // by the least and the greatest side
  for (const SourceId f : IdRange<SourceId>(in.corners.size())) {
    const auto sides = in.sides[f];
    if (sides.empty() || in.paired[sides[0]] != 0) continue;
    const auto [least, greatest] = std::ranges::minmax(sides);
    faces.emplace_back(std::uint64_t{least.value()} << 32 | greatest.value(), f);
  }
  std::sort(faces.begin(), faces.end());
  EqualFaces equal;
  for (auto begin = faces.begin(), end = begin; begin != faces.end(); begin = end) {
    end = std::find_if(begin, faces.end(), [&](const auto& face) { return face.first != begin->first; });
    if (end - begin == 1) continue;
    std::map<std::vector<SegmentId>, SourceId> by_sides;
    for (auto face = begin; face != end; ++face) {
      std::vector<SegmentId> sides(in.sides[face->second].begin(), in.sides[face->second].end());
      std::sort(sides.begin(), sides.end());
      const SourceId first = by_sides.try_emplace(std::move(sides), face->second).first->second;
      if (first != face->second) equal.pairs.emplace_back(first, face->second);
    }
  }
  if (equal.pairs.empty()) return equal;
  equal.copies.assign(in.corners.size(), 1);
  for (const auto& [first, other] : equal.pairs) {
    ++equal.copies[first.index()];
    equal.copies[other.index()] = 0;
  }
  return equal;
}

/// Pairs between two looks at the clock.
constexpr std::uint64_t kUnchecked = 1024;

/// All that can be in contact, in one numbering: faces, then wires, then isolated points.
class Elements {
 public:
  Elements(const RefineInput& in, const std::vector<std::uint32_t>& copies)
      : in_(in),
        copies_(copies),
        faces_(in.corners.size()),
        wires_(in.wires.size()),
        points_(in.isolated.size()) {}
  /// All but dropped faces, and of equal faces the first.
  std::vector<std::uint32_t> list() const {
    std::vector<std::uint32_t> kept;
    const std::size_t n = faces_ + wires_ + points_;
    kept.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
      if (i >= faces_ || (!in_.dropped(SourceId(i)) && (copies_.empty() || copies_[i] != 0)))
        kept.push_back(static_cast<std::uint32_t>(i));
    }
    return kept;
  }
  bool is_face(std::uint32_t e) const { return e < faces_; }
  Box box(std::uint32_t e) const {
    Box box;
    for_each_corner(e, [&](VertexId v) {
      const PointView p = in_.points.view(v);
      box.extend(p.lo, p.hi);
    });
    return box;
  }
  void describe(std::uint32_t e, const LargeFans& fans, BoxPairs::Outline& out) const {
    std::size_t groups = 0;
    for_each_corner(e, [&](VertexId v) {
      const PointView p = in_.points.view(v);
      out.corners.push_back({p.lo, p.hi});
      if (is_face(e) && fans.at(v)) out.groups[groups++] = v.value();  // all faces of a fan are triangles
    });
  }
  void test(std::uint32_t a, std::uint32_t b, PairTester& tester) const {
    if (a > b) std::swap(a, b);
    if (is_face(b)) tester.faces(SourceId(a), SourceId(b));
    else if (is_face(a) && is_wire(b)) tester.wire_face(wire(b), SourceId(a));
    else if (is_face(a)) tester.point_face(point(b), SourceId(a));
    else if (is_wire(b)) tester.wires(wire(a), wire(b));
    else if (is_wire(a)) tester.point_wire(point(b), wire(a));
  }

 private:
  bool is_wire(std::uint32_t e) const { return e >= faces_ && e < faces_ + wires_; }
  template <class Visit>
  void for_each_corner(std::uint32_t e, const Visit& visit) const {
    if (is_face(e)) {
      for (const VertexId v : in_.corners[SourceId(e)]) {
        if (v.valid()) visit(v);
      }
    } else if (is_wire(e)) {
      for (const VertexId v : in_.segment_ends[wire(e)]) visit(v);
    } else {
      visit(point(e));
    }
  }
  SegmentId wire(std::uint32_t e) const { return in_.wires[e - faces_]; }
  VertexId point(std::uint32_t e) const { return in_.isolated[e - faces_ - wires_]; }
  const RefineInput& in_;
  const std::vector<std::uint32_t>& copies_;
  std::size_t faces_, wires_, points_;
};

/// What tells most pairs apart, small and in the order of the tree. `normal` is a unit vector good to 2e-7:
/// computed normals N' with |N'| > 1e-6 W are off by less than 1e-8 of their length (plane_filter.h), rounding
/// adds 2^-24 per component. The cross product of two of them is off by less than 1e-6.
struct Glance {
  std::uint32_t element;
  std::array<VertexId, 3> corners;  // of a triangle
  std::array<char, 3> fans{};       // fans.h, by corner
  bool steady = false;              // there is a normal
  std::array<float, 3> normal{};

  /// True only if two triangles of one embedded fan meet in nothing but what they share, and lie in two planes.
  bool neighbours(const Glance& g) const {
    if (!steady || !g.steady) return false;
    int shared = 0, fan = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const int common =
          (corners[i] == g.corners[0]) | (corners[i] == g.corners[1]) | (corners[i] == g.corners[2]);
      shared += common;
      fan += common & fans[i];
    }
    if (fan == 0 || shared == 3) return false;
    const float x = normal[1] * g.normal[2] - normal[2] * g.normal[1];
    const float y = normal[2] * g.normal[0] - normal[0] * g.normal[2];
    const float z = normal[0] * g.normal[1] - normal[1] * g.normal[0];
    return std::max(std::fabs(x), std::max(std::fabs(y), std::fabs(z))) > 1e-5f;
  }
};

Glance glance(const RefineInput& in, std::uint32_t element, bool is_face, const std::vector<char>& fans) {
  Glance g{element, {}, {}, false, {}};
  if (!is_face) return g;
  const auto corners = in.corners[SourceId(element)];
  const std::optional<std::array<double, 3>> normal = in.filters[element].unit_normal();
  if (corners.size() != 3 || !normal) return g;
  g.steady = true;
  for (std::size_t i = 0; i < 3; ++i) {
    g.corners[i] = corners[i];
    g.fans[i] = fans[corners[i].index()];
    g.normal[i] = static_cast<float>((*normal)[i]);
  }
  return g;
}

}  // namespace

ContactList find_contacts(const RefineInput& in, const Watch& watch) {
  const EqualFaces equal = equal_faces(in);
  const Elements elements(in, equal.copies);
  std::vector<std::uint32_t> kept = elements.list();
  std::vector<Box> boxes(kept.size());
  for_each_index(kept.size(), [&](std::size_t i) { boxes[i] = elements.box(kept[i]); });
  BoxPairs pairs(boxes);
  std::vector<char> fans = embedded_fans(in);
  const FaceBoundaries boundaries(in);
  tbb::enumerable_thread_specific<PairTester> testers([&] { return PairTester(in, boundaries, equal.copies); });
  if (pairs.crowded()) {
    const LargeFans large(in, fans);
    pairs.orient(boxes, [&](std::uint32_t i, BoxPairs::Outline& out) { elements.describe(kept[i], large, out); });
    for_each_of(large.neighbours(), [&](const auto& pair) { testers.local().faces(pair.first, pair.second); });
  }
  boxes = {};
  std::vector<Glance> glances(pairs.place_count());
  for_each_index(glances.size(), [&](std::size_t place) {
    const std::uint32_t e = kept[pairs.item(static_cast<std::uint32_t>(place))];
    glances[place] = glance(in, e, elements.is_face(e), fans);
  });
  kept = {};
  Steps steps(watch, "refine: contacts", pairs.part_count());
  tbb::parallel_for(std::size_t{0}, pairs.part_count(), [&](std::size_t part) {
    PairTester& tester = testers.local();
    std::uint64_t candidates = 0;
    pairs.find(part, [&](std::uint32_t x, std::uint32_t y) {
      if (++candidates % kUnchecked == 0) watch.check();
      if (!glances[x].neighbours(glances[y])) elements.test(glances[x].element, glances[y].element, tester);
    });
    tester.list.candidates += candidates;
    steps.step();
  });
  ContactList all;
  all.coplanar = equal.pairs;
  for (const PairTester& tester : testers) {
    all.append(tester.list);
    count_filtered(tester.filtered);
  }
  return all;
}

}  // namespace cnrg
