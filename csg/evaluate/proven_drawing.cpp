// From a drawing to a proof, to further lines, to another drawing; see the header.
#include "csg/evaluate/proven_drawing.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "csg/evaluate/leaf_numbers.h"
#include "csg/leaves/surface_parameters.h"
#include "kernel/base/union_find.h"

namespace cnrg {
namespace {

constexpr int kMostRounds = 24;
constexpr std::size_t kStepsAsDrawn = 20'000;  // as Proof::steps; of a few curved leaves a hundred times less
constexpr std::size_t kMostSteps = 5'000'000;  // with lines, of all rounds
constexpr std::size_t kMostLines = 400;        // of a patch, in one direction
constexpr std::size_t kMostPieces = 30'000;    // more than there were

using Patches = std::vector<std::pair<LeafId, std::uint32_t>>;

Patches patches_of(const std::vector<Piece>& pieces, const OpenPlace& open) {
  Patches result;
  for (const std::uint32_t i : open.pieces) result.emplace_back(pieces[i].leaf, pieces[i].patch);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/// By u and by v, whether a line there brings facets nearer to the surface.
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
  return {off[0] > 0 && 4 * off[0] >= off[1], off[1] > 0 && 4 * off[1] >= off[0]};
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

ProvenDrawing::ProvenDrawing(const Tree& tree, const Unfolding& unfolding, const PreparedLeaves& leaves,
                             const EvaluateOptions& options)
    : tree_(tree), unfolding_(unfolding), leaves_(leaves), options_(options), lines_(options.lines) {
  draw();
  if (options.proof == AskedProof::none) return;
  options.watch.begin("crossings");
  prove_it();
  if (options.proof != AskedProof::with_lines) return;
  const std::size_t most = pieces_->all().size() + kMostPieces;
  for (int round = 0; round < kMostRounds && pieces_->all().size() < most && steps_ < kMostSteps && add_lines();
       ++round) {
    options.watch.check();
    draw();
    prove_it();
  }
}

void ProvenDrawing::draw() {
  diagnostics_.clear();
  drawings_ = std::make_unique<Drawings>(tree_, unfolding_, leaves_, lines_.get(), diagnostics_);
}

void ProvenDrawing::prove_it() {
  // Of a result read back only facets are known; most of them are those of a surface beside it, which is no fault.
  std::vector<std::vector<char>> below;
  for (const InstanceId root : unfolding_.roots) {
    below.emplace_back(leaves_.instances().size());
    for (const LeafId leaf : leaves_.below(unfolding_, root)) {
      const bool read_back = leaves_.instances()[leaf.index()].leaf->cells() != nullptr;
      below.back()[leaf.index()] = options_.proof == AskedProof::with_lines || !read_back;
    }
  }
  auto pieces = std::make_unique<Pieces>(drawings_->whole(), options_.reach, moulds_);

  const auto asked_for = [&](LeafId a, LeafId b) {
    return std::ranges::any_of(below, [&](const auto& in) { return in[a.index()] && in[b.index()]; });
  };
  const std::size_t most = options_.proof == AskedProof::as_drawn ? kStepsAsDrawn : kMostSteps;
  std::optional<EarlierProof> earlier;
  if (proof_) earlier.emplace(EarlierProof{*pieces_, *proof_});
  proof_ = prove(*pieces, asked_for, most - steps_, earlier ? &*earlier : nullptr);
  steps_ += proof_->steps;
  pieces_ = std::move(pieces);
}

bool ProvenDrawing::add_lines() {
  const std::vector<Piece>& pieces = pieces_->all();
  // Where surfaces touch no facets are fine enough.
  std::set<Patches> hopeless;
  for (const OpenPlace& open : proof_->open) {
    if (!open.by_facets) hopeless.insert(patches_of(pieces, open));
  }
  auto lines = std::make_shared<LeafLines>(lines_ ? *lines_ : LeafLines());
  std::map<LeafId, InstanceId> instance_of;
  for (const InstanceId id : IdRange<InstanceId>(unfolding_.instances.size())) {
    if (const LeafId leaf = leaves_.leaf_of(id); leaf.valid()) instance_of[leaf] = id;
  }
  bool any = false;
  for (const OpenPlace& open : proof_->open) {
    if (hopeless.contains(patches_of(pieces, open))) continue;
    for (const std::uint32_t i : open.pieces) {
      const Piece& piece = pieces[i];
      if (piece.kind != Piece::Kind::cell) continue;
      const Instance& instance = unfolding_.instances[instance_of.at(piece.leaf)];
      auto& of = lines->of[{instance.node, Placement(*instance.transform)}].of[piece.patch];
      const std::array<bool, 2> asked = bends(piece);
      for (std::size_t k = 0; k < 2; ++k) {
        const double middle = piece.range[k].inf() / 2 + piece.range[k].sup() / 2;
        const Rational line = from_double(middle);
        if (!asked[k] || of[k].size() >= kMostLines || std::find(of[k].begin(), of[k].end(), line) != of[k].end())
          continue;
        of[k].push_back(line);
        any = true;
      }
    }
  }
  if (any) lines_ = std::move(lines);
  return any;
}

std::shared_ptr<const Certificate> ProvenDrawing::certificate(const Evaluation& evaluation) const {
  if (!proof_) return nullptr;
  const std::vector<Piece>& pieces = pieces_->all();
  auto result = std::make_shared<Certificate>();
  result->asked = proof_->asked;
  result->apart = proof_->apart;
  result->crossing = proof_->crossing;
  result->contacts = proof_->contacts;
  result->left = proof_->left;
  for (const LeafId leaf : pieces_->unknown()) result->unknown.push_back(evaluation.leaves->node_of(leaf));
  std::map<Patches, std::vector<const OpenPlace*>> by_patches;
  for (const OpenPlace& one : proof_->open) by_patches[patches_of(pieces, one)].push_back(&one);
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
      const auto last = std::ranges::find_if(part, [](const OpenPlace* one) { return !one->by_facets; });
      const OpenPlace& told = last == part.end() ? *part.front() : **last;
      place.at = told.at;
      place.size = told.size;
      place.by_facets = told.by_facets;
    }
  }
  return result;
}

}  // namespace cnrg
