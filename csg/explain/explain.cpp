// From what people name to pieces of the refinement, and from the lives of the pieces to classes.
#include "csg/explain/explain.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "csg/explain/lives.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

using Place = SimplifiedComplex::Place;

std::size_t count_of(const SimplifiedComplex& s, int dimension) {
  const std::size_t counts[] = {s.vertices.size(), s.edges.size(), s.faces.size(), s.regions.size()};
  return counts[dimension];
}

/// `f12` as a place of the simplified node.
Place parse_cell(const std::string& text, const std::string& node, const SimplifiedComplex& simplified) {
  static const std::string kLetters = "vefr";
  static const char* const kKinds[] = {"vertices", "edges", "faces", "regions"};
  const std::size_t dimension = text.empty() ? std::string::npos : kLetters.find(text[0]);
  std::uint32_t index = 0;
  const char* const end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data() + std::min<std::size_t>(1, text.size()), end, index);
  const bool overflow = parsed.ec == std::errc::result_out_of_range;
  if (dimension == std::string::npos || parsed.ptr != end || (parsed.ec != std::errc() && !overflow)) {
    throw InputError("`" + text +
                     "` names no cell; write v, e, f or r and a number, such as f12, as `cnrg locate` does");
  }
  const std::size_t count = count_of(simplified, static_cast<int>(dimension));
  if (overflow || index >= count) {
    const std::string letter(1, text[0]), kind = kKinds[dimension];
    throw InputError("`" + text + "`: the node `" + node + "` has " +
                     (count == 0   ? "no " + kind
                      : count == 1 ? "of its " + kind + " only " + letter + "0"
                                   : kind + " " + letter + "0 to " + letter + std::to_string(count - 1)));
  }
  return {static_cast<int>(dimension), index};
}

std::vector<Piece> pieces_of(const SimplifiedComplex& s, const Place& place) {
  std::vector<Piece> out;
  switch (place.dimension) {
    case 0: out.push_back({{0, s.vertices[place.index].cell, {}, {}, {}}, 0}); break;
    case 1:
      for (const HalfEdge h : s.edges[place.index].chain) out.push_back({{1, {}, h.edge(), {}, {}}, 0});
      break;
    case 2:
      for (const HalfFace h : s.faces[place.index].cells) out.push_back({{2, {}, {}, h.face(), {}}, h.side()});
      break;
    default:
      for (const RegionId r : s.regions[place.index].cells) out.push_back({{3, {}, {}, {}, r}, 0});
  }
  return out;
}

/// The integer normal of a face's plane, shortest, to the given side.
std::array<Integer, 3> normal_of(const Complex& complex, const Piece& piece) {
  const ExactPlane& plane = complex.points.exact_plane(complex.plane(piece.cell.face));
  Integer divisor = gcd(gcd(plane.a, plane.b), plane.c);
  if (piece.side != 0) divisor = -divisor;
  return {plane.a / divisor, plane.b / divisor, plane.c / divisor};
}

/// A multiple of 10^-k nearest to `value`, 10^-k the largest power that is at most `step` > 0.
Rational rounded(double value, double step) {
  Rational power = 1;
  while (to_double(power) > step) power /= 10;
  while (to_double(power * 10) <= step) power *= 10;
  const Rational scaled = from_double(value) / power + Rational(1, 2);
  Integer whole;
  mpz_fdiv_q(whole.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
  return Rational(whole) * power;
}

/// A point in the open region, of few digits if possible: away from one of its faces by less and less until the
/// region holds it.
RationalPoint point_in(const Complex& complex, const Locator& locator, RegionId r) {
  if (complex.region_faces[r].empty()) {  // space with nothing but wires and points in it
    Rational beyond = 0;
    for (const VertexId v : complex.vertices) beyond = std::max(beyond, complex.points.rational(v)[0]);
    return {beyond + 1, 0, 0};
  }
  const HalfFace h = complex.region_faces[r].front();
  const RationalPoint base = interior_point(complex, h.face()).rational();
  const std::array<Integer, 3> n = normal_of(complex, {{2, {}, {}, h.face(), {}}, h.side()});
  std::array<double, 3> direction;
  const Integer size = abs(n[0]) + abs(n[1]) + abs(n[2]);
  double norm = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    direction[k] = to_double(Rational(n[k], size));
    norm += direction[k] * direction[k];
  }
  double reach = 1;
  for (const HalfEdge e : complex.loop[complex.face_loops[h.face()].front()]) {
    const auto p = complex.points.approx(complex.origin(e));
    for (std::size_t k = 0; k < 3; ++k) reach = std::max(reach, std::abs(p[k] - to_double(base[k])));
  }
  constexpr int kShort = 50;  // halvings, after which doubles do not tell the point from the face
  for (int attempt = 0; attempt < kShort; ++attempt, reach /= 2) {
    RationalPoint p;
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = rounded(to_double(base[k]) + direction[k] / std::sqrt(norm) * reach, reach / 2);
    }
    const Location at = locator.locate(p);
    if (at.dimension == 3 && at.region == r) return p;
  }
  // A thin region: exactly along the normal, by steps that shrink faster and faster. `base` is in the open face,
  // so all points near enough are in the region.
  Rational step(1, size);
  for (Rational shrink(1, 2);; shrink *= shrink) {
    step *= shrink;
    RationalPoint p{base[0] + step * n[0], base[1] + step * n[1], base[2] + step * n[2]};
    const Location at = locator.locate(p);
    if (at.dimension == 3 && at.region == r) return p;
  }
}

/// A cell that is asked about.
struct Question {
  std::vector<Piece> pieces;
  Explanation* answer = nullptr;
  const RationalPoint* asked = nullptr;  ///< the point to tell, of the one piece
};

/// Makes classes of pieces, and tells those that are shown in full.
class Classes {
 public:
  Classes(const Tree& tree, const Evaluation& evaluation, NodeId node, const Locator& locator)
      : evaluation_(evaluation),
        value_(*evaluation.value(node).value),
        made_(value_.is_group() ? components_of(*evaluation.complex, value_.group()) : Components()),
        components_(value_.is_group() ? made_ : value_.components()),
        locator_(locator),
        lives_(tree, evaluation, node) {}

  /// All questions at once, for every life runs the node's Booleans again.
  void explain(const std::vector<Question>& questions, std::size_t most) {
    std::vector<Piece> pieces;
    std::vector<std::uint32_t> cells;
    for (std::size_t q = 0; q < questions.size(); ++q) {
      for (const Piece& piece : questions[q].pieces) {
        pieces.push_back(piece);
        cells.push_back(static_cast<std::uint32_t>(q));
      }
    }
    struct Class {
      std::size_t first, count = 0;
    };
    std::vector<std::vector<Class>> of_cell(questions.size());
    const std::vector<std::uint32_t> classes = lives_.classes(pieces, cells);
    std::size_t known = 0;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      std::vector<Class>& mine = of_cell[cells[p]];
      if (classes[p] == known) {
        mine.push_back({p});
        ++known;
      }
      ++mine[classes[p] + mine.size() - known].count;
    }
    std::vector<Piece> examples;
    for (const auto& mine : of_cell) {
      for (std::size_t c = 0; c < std::min(most, mine.size()); ++c) examples.push_back(pieces[mine[c].first]);
    }
    std::vector<Life> told = lives_.of(examples, true);
    std::size_t next = 0;
    for (std::size_t q = 0; q < questions.size(); ++q) {
      Explanation& out = *questions[q].answer;
      const std::vector<Class>& mine = of_cell[q];
      for (std::size_t c = 0; c < mine.size(); ++c) {
        if (c < most) {
          out.classes.push_back(make(examples[next], std::move(told[next]), mine[c].count, questions[q].asked));
          ++next;
        } else {
          ++out.classes_left_out;
          out.pieces_left_out += mine[c].count;
        }
      }
    }
  }

 private:
  LifeClass make(const Piece& piece, Life life, std::size_t count, const RationalPoint* asked) const {
    const Complex& complex = *evaluation_.complex;
    LifeClass out;
    out.life = std::move(life);
    out.pieces = count;
    out.example = piece.cell;
    switch (piece.cell.dimension) {
      case 0: out.point = complex.points.rational(piece.cell.vertex); break;
      case 1: out.point = interior_point(complex, piece.cell.edge).rational(); break;
      case 2:
        out.point = interior_point(complex, piece.cell.face).rational();
        out.normal = normal_of(complex, piece);
        break;
      default: out.point = point_in(complex, locator_, piece.cell.region);
    }
    if (asked != nullptr) out.point = *asked;
    const std::vector<LeafId> leaves = origins_in(components_, piece.cell);
    out.origins = leaf_cells_at(complex, piece.cell, leaves);
    out.mixture = mixture_at(state_in(complex, value_, piece.cell).component, out.point);
    out.patches = first_of_each(evaluation_.parameters->on_patches(out.example, out.point, leaves));
    out.curves = first_of_each(evaluation_.parameters->on_curves(out.example, out.point, leaves));
    return out;
  }

  /// Nothing where the material is one all over.
  Mixture mixture_at(Component component, const RationalPoint& p) const {
    if (component == 0) return {};
    const RegionMaterial& material = value_.attributes(component).material;
    return material.grade() == nullptr ? Mixture() : MaterialSampler(material).at(p);
  }

  const Evaluation& evaluation_;
  const NodeValue& value_;
  const Components made_;  // of a group
  const Components& components_;
  const Locator& locator_;
  Lives lives_;
};

Explanation head(const Tree& tree, const Evaluation& evaluation, NodeId node, const Place& place) {
  const KeptValue& kept = evaluation.value(node);
  Explanation out;
  out.node = node;
  out.node_name = tree.nodes[node].name;
  out.cell = cell_name(place.dimension, place.index);
  out.dimension = place.dimension;
  if (place.index != SimplifiedComplex::kNowhere) out.pieces = pieces_of(*kept.simplified, place).size();
  return out;
}

/// About one cell of the refinement, active in the node or not.
Question ask(const Tree& tree, const Evaluation& evaluation, NodeId node, const Location& at, Explanation& out) {
  const KeptValue& kept = evaluation.value(node);
  const Complex& complex = *evaluation.complex;
  const Place place = kept.simplified->place(complex, at);
  out = head(tree, evaluation, node, place);
  out.state = state_in(complex, *kept.value, at);
  Piece piece{at, 0};
  if (at.dimension == 2 && place.dimension == 2) {
    for (const HalfFace h : kept.simplified->faces[place.index].cells) {
      if (h.face() == at.face) piece.side = h.side();
    }
  }
  return {{piece}, &out, nullptr};
}

}  // namespace

Explanation explain(const Tree& tree, const Evaluation& evaluation, NodeId node, const std::string& cell,
                    std::size_t most) {
  const Place place = parse_cell(cell, tree.nodes[node].name, *evaluation.value(node).simplified);
  return std::move(explain(tree, evaluation, node, std::vector{place}, most).front());
}

std::vector<Explanation> explain(const Tree& tree, const Evaluation& evaluation, NodeId node,
                                 const std::vector<Place>& cells, std::size_t most) {
  const KeptValue& kept = evaluation.value(node);
  const Locator locator(*evaluation.complex);
  Classes classes(tree, evaluation, node, locator);
  std::vector<Explanation> out(cells.size());
  // No more pieces at once than memory holds lives of with ease.
  constexpr std::size_t kPieces = 4096;
  std::vector<Question> questions;
  std::size_t pieces = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    out[i] = head(tree, evaluation, node, cells[i]);
    questions.push_back({pieces_of(*kept.simplified, cells[i]), &out[i], nullptr});
    out[i].state = state_in(*evaluation.complex, *kept.value, questions.back().pieces.front().cell);
    pieces += questions.back().pieces.size();
    if (pieces < kPieces && i + 1 < cells.size()) continue;
    classes.explain(questions, most);
    questions.clear();
    pieces = 0;
  }
  return out;
}

Explanation explain(const Tree& tree, const Evaluation& evaluation, NodeId node, const RationalPoint& point) {
  const Complex& complex = *evaluation.complex;
  const Locator locator(complex);
  const Location at = locator.locate(point);
  const bool beyond = (at.dimension == 3 && complex.outside_frame(at.region)) ||
                      (at.dimension == 2 && complex.on_frame(at.face)) ||
                      (at.dimension == 1 && complex.on_frame(at.edge)) ||
                      (at.dimension == 0 && complex.on_frame(at.vertex));
  if (beyond) {
    throw InputError(
        "the point lies beyond the box to which planes and half-spaces are cut, where nothing is "
        "computed; ask for a point nearer to the other leaves");
  }
  Explanation out;
  const Question question = ask(tree, evaluation, node, at, out);
  out.asked = point;
  Classes(tree, evaluation, node, locator).explain({{question.pieces, &out, &point}}, 1);
  return out;
}

std::vector<Explanation> explain(const Tree& tree, const Evaluation& evaluation, NodeId node,
                                 const std::vector<Location>& cells) {
  const Locator locator(*evaluation.complex);
  std::vector<Explanation> out(cells.size());
  std::vector<Question> questions;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    questions.push_back(ask(tree, evaluation, node, cells[i], out[i]));
  }
  Classes(tree, evaluation, node, locator).explain(questions, 1);
  for (Explanation& e : out) e.asked = e.classes.front().point;
  return out;
}

}  // namespace cnrg
