#include "kernel/tetrahedra/improve.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>

#include "kernel/base/limits.h"
#include "kernel/base/vectors.h"
#include "kernel/tetrahedra/lengths.h"
#include "kernel/tetrahedra/moves.h"
#include "kernel/tetrahedra/shapes.h"

namespace cnrg {
namespace {

using Index = Stars::Index;
using Point = Stars::Point;

double cube(double x) { return x * x * x; }
/// While points are added, moves are tried on what is worse than this part of a good shape.
constexpr double kRough = 0.5;
/// Rounds of moves, of refinement to length, of refinement to shape, of pulling short edges together.
constexpr int kMoveRounds = 6, kSizeRounds = 40, kShapeRounds = 40, kShortRounds = 6;
/// The last of them is one that changes less than this part of the mesh.
constexpr std::size_t kFewDone = 1000;
/// Moves are tried on worse shapes while short edges are pulled together.
constexpr double kSized = 0.6;
/// A vertex moves where that makes the worst shape around it so many times as good (to the third power, as shapes
/// are measured). There is nearly always a little to gain; it costs as much as a lot, and all around has to be
/// tried again. That is worth it for what is bad, where that is no more than this part of the mesh.
constexpr double kNotable = 1.05, kAny = 1, kFewBad = 0.05;
/// A tetrahedron with no edge longer than so many of its shortest one is not bad for its edges, but flat.
constexpr double kStretched = 1.5;

/// The cosine of 2.5 degrees: input that meets at less leaves no room for shapes of 0.1.
constexpr double kSharp = 0.99905;

/// Refinement ends when so many rounds in turn have left no smaller part bad, or no fewer edges too long.
constexpr int kPatience = 5;
/// And when there are so many times the tetrahedra of the mesh that was kept last: where a bound is too much for
/// halves, each round doubles what is bad, and all of it would be made in vain.
constexpr std::size_t kMostGrowth = 8;
/// A mesh that has fewer tetrahedra may need many times more, and costs little.
constexpr std::size_t kFew = 25'000;
/// The mesh is kept when the part of it that is bad is so much smaller than when it was kept last.
constexpr double kSaved = 0.9;
/// Halvings more than a bad shape needs at least.
constexpr int kSpare = 2;
/// Edges are halved to their length as long as a round has so many fewer to halve.
constexpr double kFewerLong = 0.95;
/// Moves that cost less end when so large a part of what was bad is left.
constexpr double kFewer = 0.98;
constexpr int kFewerRounds = 12;

class Improver {
 public:
  Improver(ConformingTetrahedra& mesh, const ImproveOptions& options, const Watch& watch)
      : options_(options),
        watch_(watch),
        mesh_(mesh, watch),
        moves_(mesh_, options.fixed, options.keep_boundary),
        lengths_(mesh_, moves_, options),
        bounds_{cube(options.shape), options.radius_edge, options.volume},
        in_the_end_{bounds_.shape, bounds_.radius_edge, bounds_.volume, options.longest},
        begin_(std::chrono::steady_clock::now()) {
    if (!options_.size) return;
    for (Index v = 0; v < mesh_.point_count(); ++v) {
      watch_.check();
      lengths_.wanted(v);
    }
  }

  Improved run() {
    until(0.5);
    if (options_.size) to_length();
    until(0.6);
    for (int round = 0; round < (too_many_ ? 1 : kMoveRounds) && !over(); ++round) {
      begin("mesh: shapes, round " + of_rounds(round, kMoveRounds));
      if (sweep(cube(options_.good)) * 200 < mesh_.size()) break;
    }
    if (!too_many_) {
      until(0.8);
      to_shapes();
      until(0.9);
      begin("mesh: shapes, last round");
      sweep(cube(options_.good));
      for (int round = 0; round < kMoveRounds && !over(); ++round) {
        if (sweep(cube(options_.shape)) == 0) break;
      }
    }
    until(1);
    moves_.aim_at(in_the_end_);
    mesh_.unsettle();
    to_fewer();
    if (!too_many_ && halve_large()) to_fewer();
    until(1);
    return late_       ? Improved::time_over
           : cut_      ? Improved::steps_over
           : too_many_ ? Improved::too_many
                       : Improved::done;
  }

  ConformingTetrahedra result() const { return mesh_.mesh(); }

 private:
  const ImproveOptions& options_;
  const Watch& watch_;
  Stars mesh_;
  Moves moves_;
  Lengths lengths_;
  const Bounds bounds_, in_the_end_;
  const std::chrono::steady_clock::time_point begin_;
  std::vector<int> halvings_;      // by vertex
  double gain_of_bad_ = kNotable;  // in the next sweep
  std::string stage_;              // of a walk through all tetrahedra: how many of them it takes nobody knows
  std::size_t steps_ = 0, asked_ = 0;
  bool wide_only_ = false;  // what is narrow stays as it is
  double part_ = 1;         // of the steps and seconds, for what is done now
  bool over_ = false;       // they are
  bool cut_ = false;        // they were, of something
  bool late_ = false;       // the seconds were
  bool too_many_ = false;   // refinement has ended for the number of tetrahedra

  /// Asked while refining.
  bool ends_refining() {
    too_many_ = too_many_ || (options_.most > 0 && mesh_.size() > options_.most);
    return too_many_;
  }

  /// What comes first may take all of the time for itself, and leave a mesh in which nearly all is bad. So what
  /// follows ends after that part of the steps and seconds.
  void until(double part) {
    cut_ = cut_ || over_;
    over_ = false;
    part_ = part;
  }

  void begin(std::string stage) {
    stage_ = std::move(stage);
    watch_.begin(stage_, mesh_.size());
  }
  static std::string of_rounds(int round, int most) {
    return std::to_string(round + 1) + " of " + std::to_string(most) + " at most";
  }

  /// Asked between moves, by a walk at tetrahedron `at`: are the steps or the time over? Throws Stopped.
  bool over(Index at = 0) {
    if (over_) return true;
    ++steps_;
    if (options_.steps > 0) over_ = double(steps_) > part_ * double(options_.steps);
    if (++asked_ % 256 != 0) return over_;
    watch_.check();
    if (watch_.progress && at > 0) watch_.progress(stage_, at, mesh_.size());
    if (options_.seconds > 0) {
      const std::chrono::duration<double> since = std::chrono::steady_clock::now() - begin_;
      late_ = since.count() > part_ * (options_.seconds - options_.afterwards * double(mesh_.size()));
      over_ = over_ || late_;
    }
    return over_;
  }

  /// One move that makes a tetrahedron better, or what comes in its place.
  bool mend(Index t) {
    steps_ += ImproveOptions::kStepsOfMove;
    const auto corners = mesh_.at(t).corners;
    const double gain = mesh_.at(t).shape < cube(options_.shape) ? gain_of_bad_ : kNotable;
    for (const auto& [i, j] : Stars::kEdges)
      if (moves_.remove_edge(corners[std::size_t(i)], corners[std::size_t(j)])) return true;
    for (int k = 0; k < 4; ++k)
      if (moves_.swap_face(t, k)) return true;
    bool moved = false;
    for (const Index v : corners) moved = moves_.smooth(v, gain) || moved;
    if (moved) return true;
    for (const auto& [i, j] : Stars::kEdges) {
      const Index a = corners[std::size_t(i)], b = corners[std::size_t(j)];
      const double longest = options_.size ? lengths_.most(a, b) : kInfinity;
      if (moves_.collapse(a, b, kInfinity, longest) || moves_.collapse(b, a, kInfinity, longest)) return true;
    }
    return false;
  }
  static double square(double x) { return x * x; }

  /// May what is bad move for any gain in the next sweep? While edges are brought to length it would be for
  /// nothing.
  enum class Bad : std::uint8_t { notably, for_any_gain };

  std::size_t sweep(double below, Bad next = Bad::for_any_gain) {
    std::size_t done = 0, bad = 0, all = 0;
    for (Index t = 0; t < mesh_.size() && !over(t); ++t) {
      if (!mesh_.alive(t)) continue;
      ++all, bad += mesh_.at(t).shape < cube(options_.shape);
      for (int tries = 0; tries < 4 && mesh_.alive(t) && mesh_.at(t).shape < below && !mesh_.is_settled(t);
           ++tries) {
        if (!mend(t)) {
          mesh_.settle(t);
          break;
        }
        ++done;
      }
    }
    if (next == Bad::notably) return done;
    const bool few = all < kFew || static_cast<double>(bad) < kFewBad * static_cast<double>(all);
    const double gain = few ? kAny : kNotable;
    if (gain < gain_of_bad_) mesh_.unsettle();
    gain_of_bad_ = gain;
    return done;
  }

  /// What is far too long is halved first, with moves between: they cost less while there are few tetrahedra.
  void to_length() {
    const Lengths::Ends ends = [this](Index at) { return over(at); };
    const Lengths::Ends ends_halving = [this](Index at) { return over(at) || ends_refining(); };
    begin("mesh: lengths");
    sweep(cube(kRough * options_.good), Bad::notably);  // halves of flat ones would be points that nearly coincide
    double longer = kInfinity;
    std::size_t fewest = std::numeric_limits<std::size_t>::max();  // halves of a round
    int patience = kPatience;
    for (int round = 0; round < kSizeRounds && !over(); ++round) {
      begin("mesh: lengths, round " + of_rounds(round, kSizeRounds));
      longer = std::max(Lengths::kLong, (round == 0 ? lengths_.longest(ends) : longer) / 2);
      const std::size_t done = lengths_.halve(longer, ends_halving);
      if (too_many_) return;
      begin("mesh: lengths, moves of round " + of_rounds(round, kSizeRounds));
      sweep(cube(kRough * options_.good), Bad::notably);
      if (longer > Lengths::kLong) continue;
      patience =
          double(done) < kFewerLong * double(fewest) ? kPatience : patience - 1;  // moves may undo what it does
      fewest = std::min(fewest, done);
      if (patience == 0 || done * kFewDone < mesh_.size()) break;
    }
    for (int round = 0; round < kShortRounds && !over(); ++round) {
      begin("mesh: short edges, round " + of_rounds(round, kShortRounds));
      const std::size_t done = lengths_.collapse(cube(kRough * options_.good), ends);
      begin("mesh: short edges, moves of round " + of_rounds(round, kShortRounds));
      sweep(cube(kSized));
      if (done * kFewDone < mesh_.size()) break;
    }
  }

  /// Is it as it has to be?
  bool is_bad(Index t) const {
    const auto& tet = mesh_.at(t);
    if (tet.region < 0 || (wide_only_ && is_narrow(t))) return false;
    return !bounds_.keeps(mesh_, tet);
  }
  /// Does the input meet in it at a sharp angle: two facets at an edge, two lines or a line and a facet at a
  /// corner? Then smaller tetrahedra there are as bad, without an end.
  bool is_forced(Index t) const {
    const auto& tet = mesh_.at(t);
    const auto corner = [&](std::size_t k) -> const Point& { return mesh_.point(tet.corners[k]); };
    const auto normal = [&](std::size_t k) {  // of the face opposite to corner k
      const Point& o = corner((k + 1) % 4);
      return cross(minus(corner((k + 2) % 4), o), minus(corner((k + 3) % 4), o));
    };
    const auto sharp = [](double product, double squares) {
      return product > 0 && product * product > kSharp * kSharp * squares;
    };
    for (const auto& [i, j] : Stars::kEdges) {
      if (tet.facets[std::size_t(i)] == Stars::kNone || tet.facets[std::size_t(j)] == Stars::kNone) continue;
      // The edge is that of the two other corners; normals of `normal` go out or in by turns.
      const Point m = normal(std::size_t(i)), n = normal(std::size_t(j));
      if (sharp((i + j) % 2 == 0 ? -dot(m, n) : dot(m, n), dot(m, m) * dot(n, n))) return true;
    }
    for (std::size_t v = 0; v < 4; ++v) {
      for (std::size_t a = 0; a < 4; ++a) {
        if (a == v || mesh_.line(tet.corners[v], tet.corners[a]) == Stars::kNone) continue;
        const Point d = minus(corner(a), corner(v));
        for (std::size_t b = a + 1; b < 4; ++b) {
          if (b == v || mesh_.line(tet.corners[v], tet.corners[b]) == Stars::kNone) continue;
          const Point e = minus(corner(b), corner(v));
          if (sharp(dot(d, e), dot(d, d) * dot(e, e))) return true;
        }
        if (tet.facets[a] == Stars::kNone) continue;
        const Point n = normal(a);
        const double sine = dot(d, n);
        if (sine * sine < (1 - kSharp * kSharp) * dot(d, d) * dot(n, n)) return true;
      }
    }
    return false;
  }

  /// Moves may have made some larger again than they may be; halves are smaller. True if there were any.
  bool halve_large() {
    if (in_the_end_.volume == 0 && !in_the_end_.length) return false;
    bool ever = false;
    for (bool any = true; any && !over();) {  // halves may be in places that are passed
      begin("mesh: what is large");
      any = false;
      for (Index t = 0; t < mesh_.size() && !over(t) && !ends_refining(); ++t) {
        while (mesh_.alive(t) && in_the_end_.is_large(mesh_, mesh_.at(t)) && !over()) {
          const auto [a, b] = longest_edge(t);
          if (moves_.split(a, b) == Stars::kNoTetrahedron) break;
          any = ever = true;
        }
      }
    }
    return ever;
  }

  std::array<Index, 2> longest_edge(Index t) const {
    const auto& c = mesh_.at(t).corners;
    std::array<Index, 2> out{c[0], c[1]};
    for (const auto& [i, j] : Stars::kEdges) {
      if (moves_.squared(c[std::size_t(i)], c[std::size_t(j)]) > moves_.squared(out[0], out[1]))
        out = {c[std::size_t(i)], c[std::size_t(j)]};
    }
    return out;
  }

  /// How often edges at a vertex may be halved for shapes. A tetrahedron that is n times as long as thick is good
  /// after log2 n times, if it can be at all; where sharp corners of the input meet it never is, and to go on
  /// makes more and more that are bad.
  void set_halvings() {
    halvings_.assign(mesh_.point_count(), 0);
    for (Index t = 0; t < mesh_.size(); ++t) {
      if (!mesh_.alive(t) || !is_bad(t)) continue;
      const double thin = std::max(mesh_.at(t).shape, 1e-30);
      const int needed = kSpare + static_cast<int>(std::ceil(-std::log2(thin) / 2));
      for (const Index v : mesh_.at(t).corners) halvings_[v] = std::max(halvings_[v], needed);
    }
  }

  /// Moves after which less is bad, and once these bring little new vertices, too: they cost more, and where no
  /// move has helped they do not either.
  void to_fewer() {
    std::size_t left = 0, bad = bad_ones();
    for (int round = 0; round < kFewerRounds && bad > 0 && !over(); ++round) {
      begin("mesh: fewer bad ones, round " + of_rounds(round, kFewerRounds));
      fewer(left);
      const std::size_t before = std::exchange(bad, bad_ones());
      if (double(bad) < kFewer * double(before)) continue;
      if (round == 0 || left > 0 || too_many_) break;
      left = options_.points;
      if (left > 0) mesh_.unsettle();
    }
  }
  std::size_t bad_ones() const {
    std::size_t bad = 0;
    for (Index t = 0; t < mesh_.size(); ++t) bad += mesh_.alive(t) && is_bad(t);
    return bad;
  }
  /// Most of what is narrow is as flat as the input: where few moves help there it is left alone.
  void fewer(std::size_t& left) {
    constexpr std::size_t kTried = 1000, kHelped = 50;
    std::size_t narrow = 0, helped = 0;
    const auto all = static_cast<Index>(mesh_.size());
    for (Index t = 0; t < all && !over(t); ++t) {
      if (!mesh_.alive(t) || !is_bad(t) || mesh_.is_settled(t)) continue;
      const bool flat = is_narrow(t);
      if (flat && narrow > kTried && helped * kHelped < narrow) continue;
      narrow += flat;
      if (mend(t)) helped += flat;
      else if (left > 0 && divide(t)) --left, helped += flat;
      else mesh_.settle(t);
    }
  }
  bool divide(Index t) {
    const auto corners = mesh_.at(t).corners;
    std::array<std::array<Index, 2>, 6> edges;
    for (std::size_t k = 0; k < 6; ++k) {
      const auto& [i, j] = Stars::kEdges[k];
      edges[k] = {corners[std::size_t(i)], corners[std::size_t(j)]};
    }
    std::ranges::sort(edges, std::greater{}, [&](const auto& e) { return moves_.squared(e[0], e[1]); });
    return std::ranges::any_of(edges, [&](const auto& e) { return moves_.divide(e[0], e[1]); });
  }

  struct Census {
    std::size_t all = 0;       // tetrahedra
    double bad = 0;            // the part of them that is
    std::vector<Index> worst;  // those of the bad ones that smaller ones may mend
  };
  Census census() const {
    Census now;
    std::size_t bad = 0;
    for (Index t = 0; t < mesh_.size(); ++t) {
      if (!mesh_.alive(t)) continue;
      ++now.all;
      if (!is_bad(t)) continue;
      ++bad;
      if (!is_forced(t)) now.worst.push_back(t);
    }
    now.bad = static_cast<double>(bad) / static_cast<double>(now.all);
    return now;
  }

  bool is_narrow(Index t) const {
    const auto& c = mesh_.at(t).corners;
    for (const Index v : c)
      if (mesh_.facet(v) == Stars::kNone) return false;
    return is_flat(mesh_.point(c[0]), mesh_.point(c[1]), mesh_.point(c[2]), mesh_.point(c[3]));
  }

  /// What is narrow comes last, and gets no more points than its ration.
  void to_shapes() {
    wide_only_ = options_.narrow_points > 0;
    halve_on(options_.points);
    if (!wide_only_) return;
    wide_only_ = false;
    halve_on(options_.narrow_points);
  }

  void set_mesh(const ConformingTetrahedra& mesh) {
    mesh_ = Stars(mesh, watch_);
    lengths_.forget(static_cast<Index>(mesh.points.size()));
  }

  double shortest_edge(Index t) const {
    const auto& c = mesh_.at(t).corners;
    double shortest = kInfinity;
    for (const auto& [i, j] : Stars::kEdges)
      shortest = std::min(shortest, moves_.squared(c[std::size_t(i)], c[std::size_t(j)]));
    return std::sqrt(shortest);
  }

  /// Rounds of halves. Keeps the mesh of which the smallest part was bad.
  void halve_on(std::size_t left) {
    set_halvings();
    ConformingTetrahedra best;
    double least = kInfinity, saved = kInfinity;  // parts that are bad, of all rounds and of `best`
    std::size_t size = 0;                         // of `best`
    int patience = kPatience;
    for (int round = 0;; ++round) {
      const Census now = census();
      if (now.worst.empty()) return;
      patience = now.bad < least ? kPatience : patience - 1;
      least = std::min(least, now.bad);
      if (now.bad < kSaved * saved) {
        best = mesh_.mesh();
        saved = now.bad;
        size = now.all;
      }
      const bool too_much = options_.volume == 0 && now.all > kMostGrowth * std::max(size, kFew);
      const bool ends = round == kShapeRounds || patience == 0 || too_much || over() || too_many_;
      if (ends || !halve(now.worst, left)) {
        if (now.bad > saved || too_much) set_mesh(best);
        return;
      }
      sweep(cube(kRough * options_.good));
    }
  }

  /// Halves the longest edge of each, with so many points at most that are left. False if it halves none.
  bool halve(const std::vector<Index>& worst, std::size_t& left) {
    begin("mesh: shapes, " + std::to_string(worst.size()) +
          (worst.size() == 1 ? " tetrahedron is bad" : " tetrahedra are bad"));
    bool any = false;
    for (const Index t : worst) {
      if (over() || left == 0 || ends_refining()) break;
      if (!mesh_.alive(t) || !is_bad(t) || is_forced(t)) continue;
      const auto [a, b] = longest_edge(t);
      const int halvings = std::min(halvings_[a], halvings_[b]);
      if (!bounds_.is_large(mesh_, mesh_.at(t)) &&
          (halvings == 0 || moves_.squared(a, b) < square(kStretched * shortest_edge(t))))
        continue;
      const Index v = moves_.split(a, b);
      halvings_.resize(mesh_.point_count(), std::max(halvings - 1, 0));
      if (v == Stars::kNoTetrahedron) continue;
      any = true, --left;
    }
    return any;
  }
};

}  // namespace

Improved improve(ConformingTetrahedra& mesh, const ImproveOptions& options, const Watch& watch) {
  Improver improver(mesh, options, watch);
  const Improved end = improver.run();
  mesh = improver.result();
  return end;
}

}  // namespace cnrg
