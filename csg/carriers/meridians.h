// What meridians of several leaves about one axis have in common, in their half-plane.
//
// Circles that are drawn with chords do not meet where the true ones meet: a ball in a pipe of its radius touches
// it along a circle, but chords of the ball touch nothing. Here it is a problem of the plane, with lines and
// circles of rational coefficients: where pieces end on one another, cross or touch is decided exactly, and such a
// point is a vertex of both. Chords that cross where the curves do not are halved until they do so no more.
//
// The metric is dr^2 + N dt^2 with N the square of the axis' length.
#pragma once

#include <map>
#include <set>
#include <tuple>

#include "csg/curves/boundary_curves.h"
#include "csg/curves/revolved.h"

namespace cnrg {

struct MeridianContact {
  bool joins = false;                 ///< the two must have the same half-planes around the axis, too
  std::vector<MeridianPoint> points;  ///< that must be vertices of the arcs among the two
};

/// The contact of two pieces, ends included, but for points of the axis. Points that are not rational are near to
/// the true ones, on a straight piece exactly. Of nets only their ends are seen, and equal nets.
MeridianContact contact(const MeridianPiece& p, const MeridianPiece& q, const Rational& square);

/// True for a point of the piece, ends included; of a net only for its ends.
bool on_piece(const MeridianPiece& piece, const MeridianPoint& p, const Rational& square);

/// The pieces of leaves about one axis, and the points on which all of them are drawn.
class MeridianPlane {
 public:
  /// `round` makes sampled points short where that is wanted; ends and contacts stay as they are.
  MeridianPlane(Rational square, std::function<MeridianPoint(const MeridianPoint&)> round)
      : square_(std::move(square)), round_(std::move(round)) {}
  std::size_t add(const MeridianPiece& piece);
  /// A vertex of the arc that piece i is on, if it is on one and the point, nearly, too.
  void add_vertex(std::size_t i, const MeridianPoint& at);
  /// Vertices of the arc that piece i is on where planes across the axis, through ends of another piece, cut it
  /// near these ends.
  void add_across(std::size_t i, const MeridianPiece& other);
  /// A row of piece i at a fraction of the way of its parameter, from 0 to 1; all pieces on its circle have it.
  void add_row(std::size_t i, const Rational& way);
  /// After all is added: contacts of all pieces, vertices of all arcs.
  void solve();
  /// The rows of piece i.
  std::vector<RevolvedGrid::Row> rows(std::size_t i) const;
  /// Of a circle that arcs are on, its vertices or only ends of pieces and contacts; none if no arc is on it.
  std::vector<MeridianPoint> vertices(const MeridianPoint& middle, const Rational& radius, bool only_marks) const;
  /// The ends of pieces and the contacts on the arc of piece i.
  std::vector<MeridianPoint> marks(std::size_t i) const;

 private:
  /// Around a piece, in doubles.
  struct Bounds {
    double low_r, high_r, low_t, high_t;
    bool meets(const Bounds& b) const {
      return low_r <= b.high_r && b.low_r <= high_r && low_t <= b.high_t && b.low_t <= high_t;
    }
  };
  struct Vertex {
    MeridianPoint at;
    Rational degrees;  ///< of a mark as a double
    friend bool operator<(const Vertex& a, const Vertex& b) {
      return std::tie(a.degrees, a.at) < std::tie(b.degrees, b.at);
    }
  };
  struct Arc {
    MeridianPoint middle;
    Rational radius;
    int steps = 0;                        ///< of a whole circle
    std::vector<MeridianPoint> marks;     ///< ends and contacts
    std::vector<MeridianPoint> halvings;  ///< of chords
    std::set<Vertex> rows;                ///< of `add_row`; without those that are there
    std::vector<Vertex> vertices;
  };
  using ArcKey = std::tuple<MeridianPoint, Rational>;

  void sample(Arc& arc) const;
  bool separate_chords();
  bool separate(std::size_t i, std::size_t j);
  MeridianPoint on_arc(const Arc& arc, const Rational& degrees) const;
  double angle_of(const Arc& arc, const MeridianPoint& p) const;

  Rational square_;
  std::function<MeridianPoint(const MeridianPoint&)> round_;
  std::vector<MeridianPiece> pieces_;
  std::vector<Bounds> bounds_;  // of these
  std::map<ArcKey, Arc> arcs_;
  std::map<std::size_t, std::set<Rational>> lines_;  // of `add_row`, by straight piece
  std::map<ControlRow, CurveSteps> nets_;
};

}  // namespace cnrg
