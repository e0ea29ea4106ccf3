// From a drawing to a proof, to further lines, to another drawing; see the header.
#include "csg/evaluate/proven_lines.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "csg/carriers/axes.h"
#include "csg/carriers/common_lines.h"
#include "csg/evaluate/leaf_numbers.h"
#include "csg/leaves/surface_parameters.h"
#include "kernel/base/sorted.h"
#include "kernel/base/union_find.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

constexpr int kMostRounds = 24;
constexpr std::size_t kStepsByDefault = 20'000;  // of a set of leaves, in all rounds
constexpr std::size_t kMostSteps = 400'000;      // the same with --certify
constexpr std::size_t kMostLines = 400;          // of a patch, in one direction
constexpr std::size_t kMostCells = 20'000;       // of a leaf that gets further lines

/// Neither finer facets nor more steps tell.
bool is_near(const OpenPlace& open) { return open.why == UncertainPlace::Why::near; }

/// By u and by v, whether a line in the middle brings facets nearer to the surface, or two triangles to its turn.
std::array<bool, 2> bends(const Piece& piece) {
  const auto point = [&](double u, double v) { return piece.surface->at(u, v).point; };
  std::array<double, 2> off{};
  const double u0 = piece.range[0].inf(), u1 = piece.range[0].sup(), v0 = piece.range[1].inf(),
               v1 = piece.range[1].sup(), u = (u0 + u1) / 2, v = (v0 + v1) / 2;
  const Vector3<double> middle = point(u, v);
  for (std::size_t k = 0; k < 2; ++k) {
    const Vector3<double> a = k == 0 ? point(u0, v) : point(u, v0), b = k == 0 ? point(u1, v) : point(u, v1);
    for (std::size_t i = 0; i < 3; ++i) off[k] = std::max(off[k], std::abs(middle[i] - (a[i] + b[i]) / 2));
  }
  const auto along = [&](const auto& x, std::size_t k) { return x[k] > 0 && 4 * x[k] >= x[1 - k]; };
  const auto asked = [&](std::size_t k) { return along(off, k) || (piece.bent && along(piece.turn, k)); };
  return {asked(0), asked(1)};
}

/// True if a corner was moved (csg/weld) as far as facets go: finer ones are no nearer to the surface.
bool is_moved(const Piece& piece) {
  double size = 0, off = 0;
  for (std::size_t k = 0; k < 3; ++k) size = std::max(size, piece.box.hi[k] - piece.box.lo[k]);
  for (std::size_t i = 0; i < piece.corner_count; ++i) {
    const Vector3<double> point = piece.surface->at(piece.at[i][0], piece.at[i][1]).point;
    for (std::size_t k = 0; k < 3; ++k)
      off = std::max(off, std::abs(point[k] - double(middle_of(piece.corners[i][k]))));
  }
  return 8 * off > size;
}

/// By u and by v, a line of parameters with which a cell, or a side of one, is nearer to its surface.
std::array<std::optional<double>, 2> further_lines(const Piece& piece, bool coaxial) {
  std::array<std::optional<double>, 2> lines;
  if (piece.kind == Piece::Kind::flat || piece.surface == nullptr || is_moved(piece)) return lines;
  const bool side = piece.kind == Piece::Kind::curve;
  std::array<bool, 2> asked = side ? std::array{true, true} : bends(piece);
  if (coaxial) asked[piece.column->around] = false, asked[1 - piece.column->around] = true;
  for (std::size_t k = 0; k < 2; ++k) {
    const Interval of = side ? hull(piece.side[0][k], piece.side[1][k]) : piece.range[k];
    if (asked[k] && of.inf() < of.sup()) lines[k] = of.inf() / 2 + of.sup() / 2;
  }
  return lines;
}

}  // namespace

Certificate certificate_of(const Evaluation& evaluation) {
  Certificate all;
  if (evaluation.certificate) all = *evaluation.certificate;
  for (const Evaluation& other : evaluation.others) {
    if (other.certificate) all.add(*other.certificate);
  }
  return all;
}

ProvenLines::ProvenLines(const Draw& draw, const std::function<Relevance()>& relevance,
                         const EvaluateOptions& options, Moulds& moulds, Transform motion)
    : motion_(std::move(motion)) {
  const PlacedLeaves* placed = &draw(lines_);
  if (options.proof == AskedProof::none) return;
  if (std::ranges::none_of(placed->instances, [](const LeafInstance& one) { return one.leaf->curved(); })) {
    proof_.emplace();
    return;
  }
  options.watch.begin("crossings");
  const Relevance asked = relevance();
  const bool to_the_end = options.proof == AskedProof::to_the_end;
  std::size_t most = kStepsByDefault;
  for (int round = 0;; ++round) {
    options.watch.check();
    const PlacedLeaves still{before(motion_, placed->instances), placed->surfaces, placed->equations};
    auto pieces = std::make_unique<Pieces>(still, options.reach, moulds, to_the_end);
    std::optional<EarlierProof> earlier;
    if (proof_) earlier.emplace(EarlierProof{*pieces_, *proof_});
    proof_ = prove(*pieces, still.instances, asked, most, earlier ? &*earlier : nullptr);
    pieces_ = std::move(pieces);
    for (const OpenPlace& open : proof_->open) {
      std::vector<LeafId> leaves;
      for (const std::uint32_t i : open.pieces) leaves.push_back(pieces_->all()[i].leaf);
      sort_unique(leaves);
      undecided_.insert(std::move(leaves));
    }
    for (const auto& [leaves, count] : proof_->left) undecided_.insert(leaves);
    dead_.insert(proof_->dead.begin(), proof_->dead.end());
    if (round < kMostRounds && add_lines()) {
      placed = &draw(lines_);
    } else if (to_the_end && most < kMostSteps && !proof_->open.empty() && pieces_->unknown().empty() &&
               std::ranges::none_of(proof_->open, is_near)) {  // of finer facets first, with fewer steps
      most = kMostSteps;
      round = 0;
    } else {
      return;
    }
  }
}

bool ProvenLines::add_lines() {
  const std::vector<Piece>& pieces = pieces_->all();
  // Where surfaces touch no facets are fine enough.
  std::set<PiecePatches> hopeless;
  for (const OpenPlace& open : proof_->open) {
    if (is_near(open)) hopeless.insert(patches_of(pieces, open.pieces));
  }
  std::map<LeafId, std::size_t> cells;
  for (const Piece& piece : pieces) ++cells[piece.leaf];
  bool any = false;
  for (const OpenPlace& open : proof_->open) {
    if (open.why != UncertainPlace::Why::facets || hold_any(patches_of(pieces, open.pieces), hopeless)) continue;
    for (const std::uint32_t i : open.pieces) {
      const Piece& piece = pieces[i];
      const auto leaf = static_cast<std::uint32_t>(piece.leaf.index());
      if (lines_.contains(leaf) && cells[piece.leaf] > kMostCells) continue;
      const std::array<std::optional<double>, 2> further = further_lines(piece, open.coaxial);
      for (std::size_t k = 0; k < 2; ++k) {
        if (!further[k]) continue;
        auto& of = lines_[leaf].of[piece.patch][k];
        const Rational line = from_double(*further[k]);
        if (of.size() >= kMostLines || std::find(of.begin(), of.end(), line) != of.end()) continue;
        of.push_back(line);
        any = true;
      }
    }
  }
  return any;
}

std::shared_ptr<const Certificate> ProvenLines::certificate(const Evaluation& evaluation) const {
  if (!proof_) return nullptr;
  auto result = std::make_shared<Certificate>();
  if (!pieces_) return result;
  const std::vector<Piece>& pieces = pieces_->all();
  result->asked = proof_->asked;
  result->apart = proof_->apart;
  result->crossing = proof_->crossing;
  result->contacts = proof_->contacts;
  for (const auto& [leaves, count] : proof_->left) result->left += count;
  for (const LeafId leaf : pieces_->unknown()) result->unknown.push_back(evaluation.leaves->node_of(leaf));
  std::map<PiecePatches, std::vector<const OpenPlace*>> by_patches;
  for (const OpenPlace& one : proof_->open) {
    PiecePatches patches = patches_of(pieces, one.pieces);
    sort_unique(patches);
    by_patches[std::move(patches)].push_back(&one);
  }
  for (const auto& [patches, ones] : by_patches) {
    UnionFind sets(ones.size());
    std::vector<Box> boxes;
    for (const OpenPlace* one : ones) boxes.push_back(pieces[one->pieces[0]].box);
    for (std::uint32_t i = 0; i < ones.size(); ++i) {
      for (std::uint32_t j = 0; j < i; ++j) {
        if (boxes[i].meets(boxes[j])) sets.unite(i, j);
      }
    }
    std::map<std::uint32_t, std::vector<const OpenPlace*>> parts;
    for (std::uint32_t i = 0; i < ones.size(); ++i) parts[sets.find(i)].push_back(ones[i]);
    for (const auto& [root, part] : parts) {
      UncertainPlace& place = result->places.emplace_back();
      for (const auto& [leaf, patch] : patches) {
        const std::string name = evaluation.parameters->patch_name(leaf, patch);
        place.names.push_back("`" + evaluation.leaf_names[leaf.index()] + "`" +
                              (name.empty() ? "" : " (" + name + ")"));
        place.nodes.push_back(evaluation.leaves->node_of(leaf));
      }
      // What finer facets do not tell comes first.
      const auto last = std::ranges::find_if(part, [](const OpenPlace* one) { return is_near(*one); });
      const OpenPlace& told = last == part.end() ? *part.front() : **last;
      place.at = to_doubles(motion_.apply({told.at[0], told.at[1], told.at[2]}));
      place.size = to_double(stretch(motion_).value()) * told.size;
      place.why = told.why;
      place.common = 3;
      for (const std::uint32_t i : told.pieces) place.common -= pieces[i].kind == Piece::Kind::curve ? 2 : 1;
    }
  }
  return result;
}

}  // namespace cnrg
