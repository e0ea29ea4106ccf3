// The volume that faces bound.
//
// A planar face and the origin span a cone of volume r . N / 3, where r is a point of the face's plane and N its
// area vector, half of the sum of p x q over its directed edges pq: so 6 V = sum of det(r, p, q). No triangle is
// made; holes and slits take themselves off. Faces whose corners are doubles cost integers (determinant_sum.h).
//
// Corners that were constructed make fractions, and an exact sum of fractions costs their number times the length
// of the sum. So first as many as can be are taken out of it. Let the edges of one plane that lie on one segment
// be pieces v0 v1, v1 v2, ... of the line through o. Then det(r, v0, v1) = det(r, o, v1) - det(r, o, v0), and what
// is summed is a multiple of det(r, o, v) per plane, segment and vertex. It vanishes at a vertex where the line
// goes on, and along an edge between two faces of the plane: the cuts that other bodies have made leave no trace.
// And o can be an end of the segment, which mostly is a double.
//
// The denominator of a term is the product of the weights w of its points (ExactPoint). Powers of two are kept
// apart; what is odd in a weight, and not 1, is a *pole* of the term, as often as it is there. Points of one turn
// mostly have one pole among them, points of intersections one each. Terms of the same poles are added first; then
// sums are joined two and two, over the product of all their poles, and the only common divisor to look for is
// that of the last sum. Poles are numbered along the terms (curves of intersection, mostly), so that what is
// joined shares few.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "kernel/complex/complex.h"
#include "kernel/exact/determinant_sum.h"
#include "kernel/selection/scratch.h"

namespace cnrg {

class VolumeSum {
 public:
  explicit VolumeSum(const Complex& complex);
  /// `outward`: +1 if the front normal points out of the volume, else -1.
  void add(FaceId f, int outward);
  /// To be called once.
  Rational total();

 private:
  using Pole = std::uint32_t;
  static constexpr Pole kNoPole = 0xffffffffu;
  using Poles = std::array<Pole, 3>;  // ascending, with kNoPole at the end
  /// numerator 2^exponent over the product of the poles.
  struct Term {
    Poles poles;
    Integer numerator;
    int exponent = 0;
  };
  /// 2^exponent times a pole.
  struct Weight {
    int exponent;
    Pole pole;
  };
  /// times det(r, o, vertex), r of the plane and o of the segment.
  struct Corner {
    std::uint64_t line;  ///< plane and segment
    VertexId vertex;
    int times;
    bool same_place(const Corner& other) const { return line == other.line && vertex == other.vertex; }
    bool operator<(const Corner& other) const {
      return line != other.line ? line < other.line : vertex < other.vertex;
    }
  };
  struct Determinant {
    std::uint32_t r, p, q;
    int times;
  };

  void add_corners(FaceId f, int outward);
  void merge_corners();
  std::uint32_t number(VertexId v);
  VertexId origin(SegmentId s) const;
  void add_term(VertexId r, VertexId o, VertexId v, int times);
  const Weight& weight_of(VertexId v);
  Integer sum_of_doubles();
  void number_along_terms();

  const Complex& complex_;
  std::vector<std::pair<FaceId, int>> double_faces_;  // all of whose corners are doubles
  std::vector<Corner> corners_;                       // of other faces
  std::vector<Determinant> determinants_;             // of these, if all three points are doubles
  std::vector<Term> terms_;                           // else
  ScaledPoints points_;
  Scratch<VertexId, std::uint32_t> place_;   // 1 + index into points_
  Scratch<VertexId, std::uint32_t> weight_;  // 1 + index into known_weights_
  std::vector<Weight> known_weights_;
  std::map<Integer, Pole> pole_;
  std::vector<Integer> weights_;  // by pole
};

}  // namespace cnrg
