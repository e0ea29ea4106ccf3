// From what people name to pieces of the refinement, and from the lives of the pieces to classes.
#include "csg/explain/explain.h"

#include <algorithm>
#include <charconv>

#include "csg/evaluate/leaf_numbers.h"
#include "csg/explain/lives.h"
#include "csg/materials/sampler.h"
#include "kernel/base/error.h"
#include "kernel/complex/interior.h"

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

std::vector<CellSide> pieces_of(const SimplifiedComplex& s, const Place& place) {
  std::vector<CellSide> out;
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

/// A cell that is asked about.
struct Question {
  std::vector<CellSide> pieces;
  Explanation* answer = nullptr;
  const RationalPoint* asked = nullptr;  ///< the point to tell, of the one piece
};

/// Makes classes of pieces, and tells those that are shown in full.
class LifeClasses {
 public:
  LifeClasses(const Tree& tree, const Evaluation& evaluation, NodeId node, const Locator& locator)
      : evaluation_(evaluation),
        root_(evaluation.value(node).instance),
        value_(*evaluation.value(node).value),
        made_(value_.is_group() ? components_of(*evaluation.complex, value_.group()) : Components()),
        components_(value_.is_group() ? made_ : value_.components()),
        locator_(locator),
        lives_(tree, evaluation, node) {}

  /// All questions at once, for every life runs the node's Booleans again.
  void explain(const std::vector<Question>& questions, std::size_t most) {
    std::vector<CellSide> pieces;
    std::vector<std::uint32_t> cells;
    for (std::size_t q = 0; q < questions.size(); ++q) {
      for (const CellSide& piece : questions[q].pieces) {
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
    std::vector<CellSide> examples;
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
  LifeClass make(const CellSide& piece, Life life, std::size_t count, const RationalPoint* asked) const {
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
        out.normal = shortest_normal(complex, {piece.cell.face, piece.side});
        break;
      default: out.point = interior_point(complex, locator_, piece.cell.region);
    }
    if (asked != nullptr) out.point = *asked;
    const std::vector<LeafId> leaves = origins_in(components_, piece.cell);
    out.origins = leaf_cells_at(complex, piece.cell, leaves);
    out.mixture = mixture_at(state_in(complex, value_, piece.cell).component, out.point);
    out.patches = first_of_each(evaluation_.parameters->on_patches(out.example, out.point, leaves));
    out.curves = first_of_each(evaluation_.parameters->on_curves(out.example, out.point, leaves));
    const LeafOrder order = evaluation_.leaves->order_below(evaluation_.instances, root_);
    const auto leaf_of = [](const auto& of) { return of.leaf; };
    order.sort(out.origins, leaf_of), order.sort(out.patches, leaf_of), order.sort(out.curves, leaf_of);
    return out;
  }

  /// Nothing where the material is one all over.
  Mixture mixture_at(Component component, const RationalPoint& p) const {
    if (component == 0) return {};
    const RegionMaterial& material = value_.attributes(component).material;
    return material.grade() == nullptr ? Mixture() : MaterialSampler(material).at(p);
  }

  const Evaluation& evaluation_;
  const InstanceId root_;
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
  CellSide piece{at, 0};
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
  LifeClasses classes(tree, evaluation, node, locator);
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
  if (beyond_frame(complex, at)) {
    throw InputError(
        "the point lies beyond the box to which planes and half-spaces are cut, where nothing is "
        "computed; ask for a point nearer to the other leaves");
  }
  Explanation out;
  const Question question = ask(tree, evaluation, node, at, out);
  out.asked = point;
  LifeClasses(tree, evaluation, node, locator).explain({{question.pieces, &out, &point}}, 1);
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
  LifeClasses(tree, evaluation, node, locator).explain(questions, 1);
  for (Explanation& e : out) e.asked = e.classes.front().point;
  return out;
}

}  // namespace cnrg
