// The sentences of Fig. 3 as far as section 3 explains their terms. Each member says one term.
#include "tests/oracles/paper_reading.h"

#include <algorithm>
#include <set>
#include <string>

#include "tests/oracles/paper_classification.h"

namespace cnrg {
namespace {

enum class Class : std::uint8_t { none, in, out, inters };

/// One operand: its entities, each with the class that the paper's location gives it, and the terms about it.
class Operand {
 public:
  Operand(const Complex& complex, const Group& group, const Group& other)
      : complex_(complex),
        group_(group),
        faces_(complex.face_count(), Class::none),
        edges_(complex.edge_count(), Class::none),
        vertices_(complex.points.size(), Class::none) {
    const GroupClassification c = classify_by_location(complex, group, other);
    const auto of = [](Classification x) {
      return x == Classification::inters ? Class::inters : x == Classification::in ? Class::in : Class::out;
    };
    for (std::size_t i = 0; i < group.faces.size(); ++i) faces_[group.faces[i]] = of(c.faces[i]);
    for (std::size_t i = 0; i < group.edges.size(); ++i) edges_[group.edges[i]] = of(c.edges[i]);
    for (std::size_t i = 0; i < group.vertices.size(); ++i) vertices_[group.vertices[i]] = of(c.vertices[i]);
  }

  Class at(FaceId f) const { return faces_[f]; }
  Class at(EdgeId e) const { return edges_[e]; }
  Class at(VertexId v) const { return vertices_[v]; }

  std::uint32_t region(FaceId f, std::size_t side) const {
    return group_.region_of(complex_.face_regions[f][side]);
  }
  /// numReg: the regions that the face bounds; it is no boundary of a region that is on both sides of it.
  int num_reg(FaceId f) const {
    std::set<std::uint32_t> bounded{region(f, 0), region(f, 1)};
    if (bounded.size() == 1) return 0;
    bounded.erase(0);
    return static_cast<int>(bounded.size());
  }
  /// The side to which the outward normal of the only region of a face points.
  std::size_t outward(FaceId f) const { return region(f, 0) == 0 ? 0 : 1; }
  bool inside(FaceId f) const { return region(f, 0) != 0 && region(f, 0) == region(f, 1); }

  /// inside: one region is all around.
  template <class IdT>
  bool inside(IdT cell) const {
    std::vector<RegionId> around;
    complex_.star_regions(cell, around);
    const std::uint32_t first = group_.region_of(around.front());
    return first != 0 &&
           std::all_of(around.begin(), around.end(), [&](RegionId r) { return group_.region_of(r) == first; });
  }

 private:
  const Complex& complex_;
  const Group& group_;
  IdVector<FaceId, Class> faces_;
  IdVector<EdgeId, Class> edges_;
  IdVector<VertexId, Class> vertices_;
};

/// How often the loops of a face run along an edge: once on its boundary, twice in its interior.
int uses(const Complex& complex, EdgeId e, FaceId f) {
  int count = 0;
  for (const FaceUse& use : complex.edge_uses[e]) count += use.face == f;
  return count;
}

class Reader {
 public:
  Reader(const Complex& complex, BooleanOp op, Dominance dominance, const Group& left, const Group& right)
      : complex_(complex),
        op_(op),
        dominant_(dominance != Dominance::equal),
        swapped_(op != BooleanOp::subtract && dominance == Dominance::right),
        a_(complex, swapped_ ? right : left, swapped_ ? left : right),
        b_(complex, swapped_ ? left : right, swapped_ ? right : left),
        face_left_(complex.face_count(), 0),
        edge_left_(complex.edge_count(), 0) {}

  PaperReading read() {
    for (const FaceId f : IdRange<FaceId>(complex_.face_count())) {
      if (of_neither(f) || face_goes(f)) continue;
      face_left_[f] = 1;
      out_.faces.push_back(f);
    }
    for (const EdgeId e : IdRange<EdgeId>(complex_.edge_count())) {
      if (of_neither(e)) continue;
      bool stays = false;
      for (const FaceUse& use : complex_.edge_uses[e])
        stays = stays || (face_left_[use.face] && uses(complex_, e, use.face) == 1);
      if (!stays && lower_goes(e)) continue;
      edge_left_[e] = 1;
      out_.edges.push_back(e);
    }
    for (const VertexId v : IdRange<VertexId>(complex_.points.size())) {
      if (of_neither(v)) continue;
      bool stays = false;
      for (const EdgeId e : complex_.vertex_edges[v]) stays = stays || edge_left_[e];
      if (stays || !lower_goes(v)) out_.vertices.push_back(v);
    }
    return out_;
  }

 private:
  template <class IdT>
  bool of_neither(IdT cell) const {
    return a_.at(cell) == Class::none && b_.at(cell) == Class::none;
  }

  bool face_goes(FaceId f) const {
    const Class a = a_.at(f), b = b_.at(f);
    switch (op_) {
      case BooleanOp::unite:
        if (a == Class::in) return !dominant_ && a_.num_reg(f) == 1;
        if (b == Class::in) return dominant_ || b_.num_reg(f) == 1;
        return a == Class::inters && !dominant_ && a_.num_reg(f) == 1 && b_.num_reg(f) == 1 &&
               a_.outward(f) != b_.outward(f);
      case BooleanOp::intersect:
        if (a == Class::out || b == Class::out) return true;
        return b == Class::in && dominant_ && (b_.num_reg(f) == 2 || (b_.num_reg(f) == 0 && b_.inside(f)));
      default: break;
    }
    if (a == Class::in || b == Class::out) return true;
    if (a == Class::out) return false;
    // Of BinA and INTERS stay those that bound the new regions: A's, without what is in B.
    const auto fresh = [&](std::size_t side) { return b_.region(f, side) == 0 ? a_.region(f, side) : 0; };
    return fresh(0) == fresh(1);
  }

  /// dangOrLoose: in the interior of a removed face of the operand.
  bool dang_or_loose(const Operand& operand, EdgeId e) const {
    for (const FaceUse& use : complex_.edge_uses[e]) {
      if (operand.at(use.face) != Class::none && !face_left_[use.face] && uses(complex_, e, use.face) == 2)
        return true;
    }
    return false;
  }
  int num_face(const Operand& operand, EdgeId e) const {
    int count = 0;
    for (const FaceUse& use : complex_.edge_uses[e])
      count += operand.at(use.face) != Class::none && uses(complex_, e, use.face) == 1;
    return count;
  }
  /// loose: in the interior of a removed face of the operand, where no edge ends.
  bool loose(const Operand& operand, VertexId v) const {
    for (const FaceId f : complex_.vertex_faces[v]) {
      if (operand.at(f) != Class::none && !face_left_[f]) return true;
    }
    return false;
  }
  int num_edge(const Operand& operand, VertexId v) const {
    int count = 0;
    for (const EdgeId e : complex_.vertex_edges[v]) count += operand.at(e) != Class::none;
    return count;
  }

  // It was a boundary of faces of the operand (an end of edges), all of which are gone; or it goes with a face.
  bool went_with(const Operand& operand, EdgeId e) const {
    return num_face(operand, e) > 0 || dang_or_loose(operand, e);
  }
  bool went_with(const Operand& operand, VertexId v) const {
    return num_edge(operand, v) > 0 || loose(operand, v);
  }
  void count_alone(const Operand& operand, EdgeId e) { out_.dang_or_loose += num_face(operand, e) == 0; }
  void count_alone(const Operand& operand, VertexId v) { out_.loose += num_edge(operand, v) == 0; }

  template <class IdT>
  bool lower_goes(IdT cell) {
    const Class a = a_.at(cell), b = b_.at(cell);
    const auto with = [&](const Operand& operand) {
      if (!went_with(operand, cell)) return false;
      count_alone(operand, cell);
      return true;
    };
    switch (op_) {
      case BooleanOp::unite:
        if (a == Class::in) return !dominant_ && with(a_);
        if (b == Class::in) return dominant_ || with(b_);
        return a == Class::inters && !dominant_ && went_with(a_, cell) && went_with(b_, cell);
      case BooleanOp::intersect:
        if (a == Class::out || b == Class::out) return true;
        return b == Class::in && dominant_ && (b_.inside(cell) || with(b_));
      default: return a != Class::out;
    }
  }

  const Complex& complex_;
  const BooleanOp op_;
  const bool dominant_, swapped_;
  const Operand a_, b_;
  IdVector<FaceId, char> face_left_;
  IdVector<EdgeId, char> edge_left_;
  PaperReading out_;
};

template <class IdT>
bool listed(const std::vector<IdT>& list, IdT id) {
  return std::binary_search(list.begin(), list.end(), id);
}

/// Decides why a cell that the letter removes is in the result of the rows.
class Reasons {
 public:
  Reasons(const Complex& complex, BooleanOp op, Dominance dominance, const Group& left, const Group& right,
          const Group& result, const PaperReading& letter)
      : complex_(complex),
        wall_row_(op == BooleanOp::intersect && dominance != Dominance::equal),
        a_(dominance == Dominance::right ? right : left),
        b_(dominance == Dominance::right ? left : right),
        result_(result),
        letter_(letter) {}

  /// A kept face is on both sides of it (it is isolated in one), and it is boundary of none.
  bool in_kept_face(EdgeId e) const {
    bool held = false;
    for (const FaceUse& use : complex_.edge_uses[e]) {
      if (!result_.has(use.face)) continue;
      if (uses(complex_, e, use.face) == 1) return false;
      held = true;
    }
    return held;
  }
  /// Likewise: all kept edges that end there lie in a kept face themselves, and the letter has removed them.
  bool in_kept_face(VertexId v) const {
    const auto holders = complex_.vertex_faces[v];
    const bool isolated = std::any_of(holders.begin(), holders.end(), [&](FaceId f) { return result_.has(f); });
    bool held = isolated;
    for (const EdgeId e : complex_.vertex_edges[v]) {
      if (!result_.has(e)) continue;
      if (listed(letter_.edges, e)) return false;
      held = held || in_kept_face(e);
    }
    return held;
  }

  /// A feature of B where several of its regions meet, and nothing but the result's regions is around it.
  template <class IdT>
  bool feature_of_wall(IdT cell) const {
    if (!wall_row_ || !b_.has(cell) || a_.has(cell)) return false;
    std::vector<RegionId> around;
    complex_.star_regions(cell, around);
    std::set<std::uint32_t> of_b, of_result;
    for (const RegionId r : around) of_b.insert(b_.region_of(r)), of_result.insert(result_.region_of(r));
    return of_b.size() > 1 && !of_b.contains(0) && !of_result.contains(0) && feature(cell);
  }

 private:
  bool feature(EdgeId e) const { return listed(b_.features.edges, e); }
  bool feature(VertexId v) const {
    const auto edges = complex_.vertex_edges[v];
    return listed(b_.features.vertices, v) ||
           std::any_of(edges.begin(), edges.end(), [&](EdgeId e) { return feature(e); });
  }

  const Complex& complex_;
  const bool wall_row_;
  const Group &a_, &b_;
  const Group& result_;
  const PaperReading& letter_;
};

}  // namespace

PaperReading paper_reading(const Complex& complex, BooleanOp op, Dominance dominance, const Group& left,
                           const Group& right) {
  return Reader(complex, op, dominance, left, right).read();
}

std::string compare_readings(const Complex& complex, BooleanOp op, Dominance dominance, const Group& left,
                             const Group& right, const Group& result, const PaperReading& letter,
                             ReadingDifference& difference) {
  if (letter.faces != result.faces) return "faces differ";
  const Reasons why(complex, op, dominance, left, right, result, letter);
  const auto compare = [&](const auto& by_letter, const auto& by_rows, const std::string& kind) -> std::string {
    for (const auto cell : by_letter) {
      if (!listed(by_rows, cell))
        return kind + " " + std::to_string(cell.value()) + " is removed by the rows alone";
    }
    for (const auto cell : by_rows) {
      if (listed(by_letter, cell)) continue;
      if (why.in_kept_face(cell)) ++difference.faces_kept_around;
      else if (why.feature_of_wall(cell)) ++difference.features_of_walls;
      else
        return kind + " " + std::to_string(cell.value()) + " is removed by the letter alone, for no known reason";
    }
    return "";
  };
  const std::string edges = compare(letter.edges, result.edges, "edge");
  return edges.empty() ? compare(letter.vertices, result.vertices, "vertex") : edges;
}

}  // namespace cnrg
