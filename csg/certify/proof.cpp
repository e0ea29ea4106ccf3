// Pairs, triples and quadruples of pieces; see the header.
#include "csg/certify/proof.h"

#include <cmath>

#include "csg/certify/coaxial.h"
#include "csg/certify/piece_filling.h"
#include "csg/certify/piece_parts.h"
#include "kernel/refine/box_pairs.h"

namespace cnrg {

using namespace surface_math;

namespace {

using Index = std::uint32_t;
using AnswerKind = Proof::Answer::Kind;
using Why = UncertainPlace::Why;
using PieceParts = std::vector<PiecePart>;

constexpr std::size_t kMostSteps = 250;         // of one question
constexpr std::size_t kMostInContact = 64;      // of one to more than two, of which some touch
constexpr std::size_t kMostOfSurfaces = 20000;  // of one to surfaces alone
constexpr std::size_t kMostOfOwn = 20000;       // of a leaf, whether it meets itself
constexpr std::size_t kMostOpen = 1000;         // places of the same patches, after which no more are looked for

/// What is asked of some pieces.
enum class Question : std::uint8_t {
  none,     ///< answered by what is asked of fewer, or of the leaf itself
  angle,    ///< apart, or independent
  contact,  ///< apart, or what two have in common, along a curve, crosses the third, or what one has with it
  apart,
};

class Prover {
 public:
  Prover(Pieces& pieces, const std::vector<LeafInstance>& leaves, const Relevance& relevance,
         std::size_t most_steps, const EarlierProof* earlier)
      : pieces_(pieces),
        all_(pieces.all()),
        relevance_(relevance),
        filling_(pieces, leaves),
        most_steps_(most_steps),
        earlier_(earlier) {}

  Proof run() {
    find_pairs();
    const enclosure::RoundOutward outward;
    together_.resize(all_.size());
    roots_.resize(all_.size());
    rims_.resize(all_.size());
    relate_leaves();
    if (earlier_ != nullptr) {
      before_ = pieces_.same_in(earlier_->pieces);
      proof_.spent = earlier_->proof.spent;
      proof_.spent_on_own = earlier_->proof.spent_on_own;
    }
    for (Index i = 0; i < all_.size(); ++i) ask_of_itself(i, i);
    for (const auto& [a, b] : pairs_) ask_pair(a, b);
    for (std::vector<Index>& near : together_) std::sort(near.begin(), near.end());
    for (Index i = 0; i < all_.size(); ++i) {
      if (!all_[i].exact()) ask_more(i);
    }
    return std::move(proof_);
  }

 private:
  void find_pairs() {
    std::vector<Box> boxes;
    for (const Piece& piece : all_) boxes.push_back(piece.box);
    const BoxPairs finder(boxes);
    for (std::size_t part = 0; part < finder.part_count(); ++part) {
      finder.find(part, [&](Index x, Index y) {
        const Index a = std::min(finder.item(x), finder.item(y)), b = std::max(finder.item(x), finder.item(y));
        if (a == b || (all_[a].exact() && all_[b].exact()) || !boxes[a].meets(boxes[b])) return;
        if (all_[a].leaf != all_[b].leaf && !relevance_.together(std::array{all_[a].leaf, all_[b].leaf})) return;
        pairs_.emplace_back(a, b);
      });
    }
    std::sort(pairs_.begin(), pairs_.end());
  }

  bool is_cell(Index i) const { return all_[i].kind != Piece::Kind::curve; }
  bool lies_in(Index curve, Index cell) const {
    const Piece &one = all_[curve], &other = all_[cell];
    return std::ranges::binary_search(one.in_sheets, other.sheet) ||
           (one.exact() && other.exact() && one.in_sheets.empty() && one.points[0] != one.points[1] &&
            pieces_.ends_in(one, 0, other) && pieces_.ends_in(one, 1, other));
  }

  /// What goes on smoothly as what: before anything is asked, for it makes cones wider.
  void relate_leaves() {
    std::vector<std::pair<Index, Index>> joined;
    for (const auto& [a, b] : pairs_) {
      if (!is_cell(a) || !is_cell(b)) continue;
      if (all_[a].exact() != all_[b].exact()) {
        const auto [cell, flat] = all_[a].exact() ? std::pair(b, a) : std::pair(a, b);
        if (pieces_.may_share_rim(flat, cell)) rims_[cell].push_back(flat);
      }
      const bool one_sheet = all_[a].sheet == all_[b].sheet;
      if (all_[a].leaf != all_[b].leaf) {
        if (!one_sheet) continue;
        if (parted(std::array{part_of(all_, all_[a], all_[a].range), part_of(all_, all_[b], all_[b].range)},
                   Between::facets_and_surfaces))
          continue;
        std::size_t steps = 0;  // the two nappes of a cone share its apex
        const bool alike =
            pieces_.drawn_alike(a, b) || (share_corner(pieces_, a, b) && apart_but_beside(pieces_, a, b, steps));
        if (!alike) proof_.open.push_back({{a, b}, doubles(middle_of(all_[a].corners[0])), 0});
        joined.emplace_back(a, b);
      } else if (all_[a].patch != all_[b].patch && pieces_.adjacent(a, b) && !pieces_.cross_at_edge(a, b)) {
        const PiecePart x = part_beside(a, b), y = part_beside(b, a);
        if (!one_sheet && !x.blind && !y.blind && independent(x.cone, y.cone)) continue;
        joined.emplace_back(a, b);
        smooth_.emplace(a, b);
      }
    }
    for (const auto& [a, b] : joined) pieces_.join(a, b);
  }

  /// Of a piece, where it has corners in common with another one of its leaf.
  PiecePart part_beside(Index a, Index b) const {
    return part_of(all_, all_[a], all_[a].kind == Piece::Kind::cell ? pieces_.range_beside(a, b) : all_[a].range);
  }

  void ask_pair(Index a, Index b) {
    const bool one_leaf = all_[a].leaf == all_[b].leaf;
    if (is_cell(a) && is_cell(b) && of_one_surface(a, b)) {
      if (one_leaf && all_[a].patch == all_[b].patch) return ask_of_itself(a, b);
      return ask_on_surface(a, b);
    }
    if (one_leaf ? of_one_surface(a, b) : answered_by_fewer(a, b)) return;
    if (one_leaf && pieces_.adjacent(a, b)) {
      if (asked_beside(a, b)) ask_beside(a, b);
      return meet(a, b);
    }
    const bool curves = !is_cell(a) && !is_cell(b);
    const Question question = one_leaf && !curves ? Question::angle : question_of({a, b});
    if (question == Question::none) return;
    ++proof_.asked;
    bool some = false;
    if (!ask({a, b}, question, some)) return;  // what is asked of more pieces is open with it
    if (contacts_.contains({a, b})) ++proof_.contacts;
    else if (some) ++proof_.crossing;
    else count_apart();
    if (some) meet(a, b);
  }
  bool asked_of_itself(Index a) const { return pieces_.asked_of_itself(all_[a].leaf); }
  /// Two cells, or a wire and another piece, of one leaf and beside each other. Of other curves cells are asked.
  bool asked_beside(Index a, Index b) const {
    const auto is_wire = [&](Index i) { return !is_cell(i) && all_[i].in_sheets.empty(); };
    return ((is_cell(a) && is_cell(b)) || is_wire(a) || is_wire(b)) && asked_of_itself(a) &&
           !meet_at_pole(all_[a], all_[b]);
  }
  void ask_beside(Index a, Index b) {
    ask_own(a, b, [&](std::size_t& steps) { return apart_but_beside(pieces_, a, b, steps); });
  }
  /// Cells of two patches of one surface, which may cross itself, and be drawn otherwise by another leaf.
  void ask_on_surface(Index a, Index b) {
    const bool one_leaf = all_[a].leaf == all_[b].leaf, blind = all_[a].blind || all_[b].blind;
    if (one_leaf ? !asked_of_itself(a) || meet_at_pole(all_[a], all_[b])
                 : blind || pieces_.is_quadric(all_[a].sheet) || pieces_.drawn_as_one(a, b))
      return;
    if (share_corner(pieces_, a, b)) return ask_beside(a, b);
    ask_apart(a, b);
  }
  void ask_apart(Index a, Index b) {
    bool some = false;
    ++proof_.asked;
    if (ask({a, b}, Question::apart, some)) count_apart();
  }
  /// Of a pair that died nothing is proven.
  void count_apart() { died_ ? --proof_.asked : ++proof_.apart; }
  /// Two cells of one surface, or one, or a wire.
  void ask_of_itself(Index a, Index b) {
    if (!asked_of_itself(a) || all_[a].exact() || pieces_.has_equation(all_[a].sheet)) return;
    if (!is_cell(a)) return all_[a].curve ? ask_beside(a, b) : void();
    if (a != b && !pieces_.adjacent(a, b)) return ask_apart(a, b);
    if (a != b && meet_at_pole(all_[a], all_[b])) return;
    ask_own(a, b, [&](std::size_t& steps) { return one_to_one(pieces_, of_patch(all_[a]), a, b, steps); });
  }
  /// Of pieces beside each other in a leaf, or one.
  template <class Proven>
  void ask_own(Index a, Index b, const Proven& proven) {
    const PieceTuple key = key_of({a, b});
    const Proof::Answer* const before = answered_before(key);
    std::size_t& spent = proof_.spent_on_own[all_[a].leaf];
    const bool asked = spent < kMostOfOwn;
    if ((before != nullptr && before->kind == AnswerKind::apart) || (asked && proven(spent))) {
      proof_.answers.try_emplace(key, Proof::Answer{AnswerKind::apart});
    } else if (!proof_.answers.contains(key)) {
      add_open(key, open_place({a, b}, asked ? Why::facets : Why::budget));
    }
  }
  OpenPlace open_place(const std::vector<Index>& tuple, Why why) {
    const Interval3 box = bounded(root(tuple[0]).box, all_[tuple[0]]);
    return {tuple, doubles(middle_of(box)), size_of(box), why};
  }
  const std::vector<Index>& of_patch(const Piece& piece) {
    const auto [it, fresh] = of_patch_.try_emplace({piece.leaf, piece.patch});
    for (Index i = 0; fresh && i < all_.size(); ++i) {
      if (all_[i].kind == Piece::Kind::cell && all_[i].leaf == piece.leaf && all_[i].patch == piece.patch)
        it->second.push_back(i);
    }
    return it->second;
  }
  /// What is asked of more pieces is asked of those that meet two at a time.
  void meet(Index a, Index b) {
    if (answered_by_fewer(a, b)) return;
    together_[a].push_back(b);
    together_[b].push_back(a);
  }
  bool of_one_surface(Index a, Index b) const {
    if (is_cell(a) && is_cell(b)) return all_[a].sheet == all_[b].sheet;
    return is_cell(a) != is_cell(b) && (is_cell(a) ? lies_in(b, a) : lies_in(a, b));
  }
  /// True if nothing is asked of two pieces with others.
  bool answered_by_fewer(Index a, Index b) const {
    return of_one_surface(a, b) || (!is_cell(a) && !is_cell(b) && all_[a].sheet == all_[b].sheet) ||
           smooth_.contains(std::minmax(a, b)) ||
           (all_[a].leaf != all_[b].leaf && !relevance_.together(std::array{all_[a].leaf, all_[b].leaf}));
  }

  /// Triples and quadruples whose first piece that is not exact is i.
  void ask_more(Index i) {
    std::vector<Index> near;
    for (const Index j : together_[i]) {
      if (all_[j].exact() || j > i) near.push_back(j);
    }
    for (std::size_t x = 0; x < near.size(); ++x) {
      for (std::size_t y = x + 1; y < near.size(); ++y) {
        if (!may_meet(near[x], near[y])) continue;
        if (!may_be_common({i, near[x], near[y]})) continue;
        for (std::size_t z = y + 1; z < near.size(); ++z) {
          if (may_meet(near[x], near[z]) && may_meet(near[y], near[z]))
            may_be_common({i, near[x], near[y], near[z]});
        }
      }
    }
  }
  /// Whether pieces that meet two at a time may all meet; false, too, where that is left open.
  bool may_be_common(const std::vector<Index>& tuple) {
    const Question question = question_of(tuple);
    bool some = true;
    return (question == Question::none || ask(tuple, question, some)) && some;
  }
  bool may_meet(Index a, Index b) const {
    if (!all_[a].exact() || !all_[b].exact()) return std::ranges::binary_search(together_[a], b);
    return all_[a].box.meets(all_[b].box) && !answered_by_fewer(a, b);
  }

  std::size_t pairs_in_contact(const std::vector<Index>& tuple) const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < tuple.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) count += contacts_.contains(std::minmax(tuple[i], tuple[j])) ? 1 : 0;
    }
    return count;
  }

  /// Of pieces that meet two at a time.
  Question question_of(const std::vector<Index>& tuple) const {
    bool one_leaf = true, exact = true;
    std::size_t cells = 0;
    std::vector<Index> curves;
    for (const Index i : tuple) {
      one_leaf = one_leaf && all_[i].leaf == all_[tuple[0]].leaf;
      exact = exact && all_[i].exact();
      if (is_cell(i)) ++cells;
      else curves.push_back(i);
    }
    if (exact || (one_leaf && tuple.size() > 2 && (!asked_of_itself(tuple[0]) || pieces_.share_corner(tuple))))
      return Question::none;
    if (pairs_in_contact(tuple) > 0) return tuple.size() == 3 ? Question::contact : Question::apart;
    if (curves.empty()) return cells <= 3 ? Question::angle : Question::apart;
    if (curves.size() == 1) return cells == 1 ? Question::angle : Question::apart;
    if (curves.size() > 2) return Question::apart;
    std::vector<Index> common;
    const auto &one = all_[curves[0]].in_sheets, &other = all_[curves[1]].in_sheets;
    std::ranges::set_intersection(one, other, std::back_inserter(common));
    if (common.size() > 1) return Question::none;  // the curve in which these sheets cross
    return common.size() == 1 && cells == 0 ? Question::angle : Question::apart;
  }

  /// True if it is proven. `some`: whether they may have a point in common.
  bool ask(const std::vector<Index>& tuple, Question question, bool& some) {
    died_ = false;
    const PiecePatches patches = patches_of(all_, tuple);
    std::size_t& open = open_[patches];
    if (open >= kMostOpen) return false;
    const PieceTuple key = key_of(tuple);
    if (const Proof::Answer* const before = answered_before(key)) return take(*before, tuple, patches, open, some);
    if (answered_at_once(tuple, question, some)) return answered(key, some);
    leaves_.clear();
    for (const auto& [leaf, patch] : patches) {
      if (leaves_.empty() || leaves_.back() != leaf) leaves_.push_back(leaf);
    }
    const auto fewer = along_rim(tuple);
    if (fewer) question = fewer->size() > 2 ? question_of(*fewer) : Question::none;
    const bool proven = question == Question::none ? answered(key, some = !fewer->empty())
                        : fewer                    ? ask_by_halves(key, *fewer, question, open, some)
                                                   : ask_by_halves(key, tuple, question, open, some);
    if (died_) proof_.dead.insert(leaves_), proof_.answers.erase(key);
    return proven;
  }
  bool ask_by_halves(const PieceTuple& key, const std::vector<Index>& tuple, Question question, std::size_t& open,
                     bool& some) {
    const PiecePatches patches = patches_of(all_, tuple);
    const bool hopeless = hold_any(patches, hopeless_);
    // What touches is asked little with others, whatever is left for these: finer facets do not tell more.
    const std::size_t contacts = tuple.size() > 2 ? pairs_in_contact(tuple) : 0;
    const bool little = contacts > 0 || (hopeless && tuple.size() > 2);
    std::size_t& spent = proof_.spent[leaves_];
    if (!little && spent >= most_steps_) {
      if (++proof_.left[leaves_] == 1) proof_.open.push_back(open_place(tuple, Why::budget));
      return false;
    }
    const std::size_t before = proof_.steps;
    const bool proven = ask_on(key, tuple, question, patches, contacts, hopeless, open, some);
    may_die_ = false;
    if (!little) spent += proof_.steps - before;
    return proven;
  }
  bool ask_on(const PieceTuple& key, const std::vector<Index>& tuple, Question question,
              const PiecePatches& patches, std::size_t contacts, bool hopeless, std::size_t& open, bool& some) {
    Interval3 left{};
    some = false;
    if (tuple.size() == 2 && is_cell(tuple[0]) && is_cell(tuple[1])) {
      if (const auto known = touch(tuple[0], tuple[1])) {
        some = *known != AnswerKind::apart;
        proof_.answers.try_emplace(key, Proof::Answer{*known});
        return true;
      }
    }
    if (tuple.size() == 2 && question == Question::angle && pieces_.cross_in_rulings(tuple[0], tuple[1]))
      return answered(key, some = true);
    const Coaxial coaxial = ask_coaxial(tuple, question, Between::facets_and_surfaces);
    if (coaxial == Coaxial::apart || coaxial == Coaxial::crossing) {
      some = coaxial == Coaxial::crossing;
      return answered(key, some);
    }
    const std::size_t steps = tuple.size() > 2 && (contacts > 0 || hopeless) ? kMostInContact : kMostSteps;
    if (answer(tuple, question, Between::facets_and_surfaces, steps, some, left)) return answered(key, some);
    may_die_ = relevance_.may_die(leaves_), some = false;
    if (may_die_ && answer(tuple, question, Between::facets_and_surfaces, steps, some, left))
      return answered(key, some);
    some = true;
    OpenPlace place{tuple, doubles(middle_of(left)), size_of(left), contacts > 1 ? Why::budget : Why::facets};
    place.coaxial = coaxial == Coaxial::open && ask_coaxial(tuple, question, Between::surfaces) != Coaxial::open;
    ++open;
    if (contacts < 2 && !hopeless && !place.coaxial) {
      bool any = false;
      if (!answer(tuple, question, Between::surfaces, kMostOfSurfaces, any, left)) {
        place.why = Why::near;
        place.at = doubles(middle_of(left));
        place.size = size_of(left);
        hopeless_.insert(patches);
      }
    }
    add_open(key, std::move(place));
    return false;
  }

  Coaxial ask_coaxial(const std::vector<Index>& tuple, Question question, Between between) const {
    if (tuple.size() != 2) return Coaxial::other;
    const Coaxial found = cnrg::ask_coaxial(all_, all_[tuple[0]], all_[tuple[1]], between);
    return found == Coaxial::crossing && question != Question::angle ? Coaxial::open : found;
  }

  bool answered(const PieceTuple& key, bool some) {
    proof_.answers.try_emplace(key, Proof::Answer{some ? AnswerKind::crossing : AnswerKind::apart});
    return true;
  }
  void add_open(const PieceTuple& key, OpenPlace place) {
    proof_.answers.try_emplace(key, Proof::Answer{AnswerKind::open, Index(proof_.open.size())});
    proof_.open.push_back(std::move(place));
  }
  /// Of the same pieces in the earlier drawing; null if it is not known.
  const Proof::Answer* answered_before(const PieceTuple& key) const {
    if (earlier_ == nullptr) return nullptr;
    std::vector<Index> there;
    for (std::size_t k = 0; k < 4 && key[k] != kNone; ++k) {
      there.push_back(before_[key[k]]);
      if (there.back() == kNone) return nullptr;
    }
    const auto it = earlier_->proof.answers.find(key_of(std::move(there)));
    return it == earlier_->proof.answers.end() ? nullptr : &it->second;
  }
  bool take(const Proof::Answer& before, const std::vector<Index>& tuple, const PiecePatches& patches,
            std::size_t& open, bool& some) {
    some = before.kind != AnswerKind::apart;
    if (before.kind == AnswerKind::open) {
      OpenPlace place = earlier_->proof.open[before.place];
      place.pieces = tuple;
      ++open;
      if (place.why == Why::near) hopeless_.insert(patches);
      add_open(key_of(tuple), std::move(place));
      return false;
    }
    if (before.kind == AnswerKind::contact) contacts_.emplace(std::minmax(tuple[0], tuple[1]));
    proof_.answers.try_emplace(key_of(tuple), before);
    return true;
  }
  /// Of cells of one patch what derivatives tell. Of others nothing, unless one sheet is on one side of the other,
  /// and so are the facets: whether facets and surfaces both have points of the contact in common.
  std::optional<AnswerKind> touch(Index a, Index b) {
    if (all_[a].leaf == all_[b].leaf && all_[a].patch == all_[b].patch)
      return differ(all_, of_patch(all_[a]), a, b) ? std::optional(AnswerKind::apart) : std::nullopt;
    const std::optional<Contact>& contact = pieces_.contact_of(all_[a].sheet, all_[b].sheet);
    if (!contact) return std::nullopt;
    const Pieces::Meeting meeting = pieces_.facets_meet(a, b, *contact);
    if (meeting == Pieces::Meeting::otherwise) return std::nullopt;
    if (meeting == Pieces::Meeting::at_contact) {
      contacts_.emplace(a, b);
      return AnswerKind::contact;
    }
    if (contact->kind == Contact::Kind::none) return AnswerKind::apart;
    bool some = false;
    Interval3 left{};
    if (answer({a, b}, Question::apart, Between::surfaces, kMostOfSurfaces, some, left)) return AnswerKind::apart;
    return std::nullopt;
  }

  /// Where two sheets have no more than a curve of a plane in common, but what dies: others are asked about one of
  /// them and the plane. None of them if they have not even that; nothing if there are no such sheets.
  std::optional<std::vector<Index>> along_rim(const std::vector<Index>& tuple) {
    for (const Index a : tuple) {
      for (const Index b : tuple) {
        if (all_[a].sheet >= all_[b].sheet) continue;
        for (const Index flat : rims_[a]) {
          if (!std::ranges::binary_search(rims_[b], flat)) continue;
          const bool there =
              std::ranges::any_of(tuple, [&](Index i) { return all_[i].sheet == all_[flat].sheet; });
          const bool at_edge = pieces_.cross_at_edge(a, flat) || pieces_.cross_at_edge(b, flat);
          if (!there && !at_edge && !all_[flat].numbers().empty()) continue;  // it may end before the curve does
          const auto& rim = pieces_.rim(flat, a, b);
          if (!rim || !(there || rim->sides[0] != rim->sides[1] || dies_beyond(flat, rim->sides[0], a, b)))
            continue;
          if (!rim->shared) return std::vector<Index>{};
          std::vector<Index> fewer = tuple;
          std::erase(fewer, pieces_.cross_at_edge(a, flat) ? b : a);
          if (!there) fewer.push_back(flat);
          return fewer;
        }
      }
    }
    return std::nullopt;
  }
  bool dies_beyond(Index flat, int side, Index a, Index b) {
    const std::array parts{root(a), root(b)};
    const auto common = common_box(parts);
    if (!common || !relevance_.may_die(leaves_)) return false;
    return died_ = relevance_.dies(leaves_, [&](LeafId leaf) {
      return filling_.of(leaf, parts, *common, Between::facets_and_surfaces, all_[flat].sheet, side);
    });
  }
  const PiecePart& root(Index i) {
    if (!roots_[i]) roots_[i] = std::make_unique<const PiecePart>(part_of(all_, all_[i], all_[i].range));
    return *roots_[i];
  }
  /// True if no part has to be halved for the answer.
  bool answered_at_once(const std::vector<Index>& tuple, Question question, bool& some) {
    Interval3 left{};
    some = false;
    // Pieces that meet are asked about with others, so it is worth to know which do not.
    if (tuple.size() == 2 && parted_along_sides(root(tuple[0]), root(tuple[1]))) return true;
    return answer(tuple, question, Between::facets_and_surfaces, 0, some, left);
  }
  bool answer(const std::vector<Index>& tuple, Question question, Between between, std::size_t steps, bool& some,
              Interval3& left) {
    PieceParts parts;
    for (const Index i : tuple) {
      parts.push_back(between == Between::surfaces ? part_of(all_, all_[i], all_[i].range, between) : root(i));
    }
    return answer(parts, question, between, steps, some, left);
  }

  bool answer(const PieceParts& parts, Question question, Between between, std::size_t& steps, bool& some,
              Interval3& left) {
    const auto known = common_box(parts);
    if (!known) return true;
    const Interval3& common = *known;
    for (const PiecePart& part : parts) {
      if (part.piece->kind == Piece::Kind::flat && misses(*part.piece, common)) return true;
    }
    if (question == Question::contact && misses_line_of_contact(parts, common, between)) return true;
    if ((question == Question::angle && at_angle(pieces_, parts)) ||
        (question == Question::contact && contact_at_angle(parts, between))) {
      some = true;
      return true;
    }
    if (parted(parts, between)) return true;
    left = bounded(common, *parts[0].piece);
    std::size_t chosen = parts.size(), way = 0;
    Upward most = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (parts[i].piece->kind == Piece::Kind::flat ||
          !worth_halving(parts[i], root(number_of(parts[i])), between))
        continue;
      if (const auto k = way_from_pole(parts[i]); k && size_of(parts[i].box) > size_of(common)) {
        chosen = i, way = *k;
        break;
      }
      const auto d = direction(middle_of(parts[i == 0 ? 1 : 0].cone));
      const std::array<Upward, 2> gain = gains(parts[i], d ? *d : Guess3{1, 0, 0});
      for (std::size_t k = 0; k < 2; ++k) {
        if (gain[k] > most) most = gain[k], chosen = i, way = k;
      }
    }
    if (may_die_ && dies(parts, common, between)) return died_ = true;
    if (chosen == parts.size() || steps == 0) return false;
    --steps;
    ++proof_.steps;
    PieceParts next = parts;
    return std::ranges::all_of(halves(all_, parts[chosen], way, between), [&](const PiecePart& half) {
      next[chosen] = half;
      return answer(next, question, between, steps, some, left);
    });
  }

  /// True if one of the parts is no part of what was asked for, where they may meet.
  bool dies(const PieceParts& parts, const Interval3& common, Between between) {
    return relevance_.dies(leaves_, [&](LeafId leaf) { return filling_.of(leaf, parts, common, between); });
  }

  Index number_of(const PiecePart& part) const { return static_cast<Index>(part.piece - all_.data()); }
  bool touch_in_contact(const PiecePart& a, const PiecePart& b) const {
    return contacts_.contains(std::minmax(number_of(a), number_of(b)));
  }
  /// Of two parts in contact along a curve: its directions.
  std::optional<Interval3> way_of_contact(const PiecePart& a, const PiecePart& b, Between between) {
    const Contact& contact = *pieces_.contact_of(a.piece->sheet, b.piece->sheet);
    const Interval3 direction = enclose3(contact.direction);
    if (contact.kind == Contact::Kind::line) return direction;
    // Facets go straight from corner to corner, as the circle does in the middle of the whole piece.
    if (contact.kind == Contact::Kind::circle)
      return cross(direction, difference(between == Between::surfaces ? a.box : root(number_of(a)).box,
                                         enclose3(contact.point)));
    const PiecePart& one = a.blind ? b : a;
    if (contact.kind != Contact::Kind::conic || one.blind) return std::nullopt;
    return cross(direction, one.cone);
  }
  /// Of three parts, two of which touch along a line: what these have in common in the box is not on the third.
  bool misses_line_of_contact(const PieceParts& parts, const Interval3& box, Between between) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const PiecePart &a = parts[k], &b = parts[(k + 1) % 3];
      if (touch_in_contact(a, b) &&
          misses_line(parts[(k + 2) % 3], *pieces_.contact_of(a.piece->sheet, b.piece->sheet), box, between))
        return true;
    }
    return false;
  }
  /// Of three parts.
  bool contact_at_angle(const PieceParts& parts, Between between) {
    for (std::size_t k = 0; k < 3; ++k) {
      const PiecePart &a = parts[k], &b = parts[(k + 1) % 3], &c = parts[(k + 2) % 3];
      if (!touch_in_contact(a, b)) continue;
      if (touch_in_contact(b, c)) {
        const auto way = way_of_contact(a, b, between), other = way_of_contact(b, c, between);
        if (way && other && independent(*way, *other)) return true;
      } else if (!touch_in_contact(c, a)) {
        if (c.blind || c.piece->kind == Piece::Kind::curve) return false;
        // A plane that crosses each of them, and holds what they have in common, has no more in common with both.
        if (c.piece->kind == Piece::Kind::flat &&
            pieces_.contact_of(a.piece->sheet, b.piece->sheet)->in(pieces_.plane_of(c.piece->sheet)))
          return true;
        const auto way = way_of_contact(a, b, between);
        return way && !holds_zero(dot(*way, c.cone));
      }
    }
    return false;
  }

  Pieces& pieces_;
  const std::vector<Piece>& all_;
  const Relevance& relevance_;
  PieceFilling filling_;
  const std::size_t most_steps_;
  const EarlierProof* const earlier_;
  std::vector<Index> before_;                            // by piece: the same one in the earlier drawing
  std::vector<std::unique_ptr<const PiecePart>> roots_;  // whole pieces, once they are asked for
  std::vector<std::pair<Index, Index>> pairs_;
  std::vector<std::vector<Index>> together_, rims_;  // by cell: flat pieces in the plane of a side
  std::set<std::pair<Index, Index>> smooth_, contacts_;
  std::map<std::pair<LeafId, std::uint32_t>, std::vector<Index>> of_patch_;  // cells
  std::set<PiecePatches> hopeless_;                                          // that touch somewhere
  std::map<PiecePatches, std::size_t> open_;                                 // how many places
  std::vector<LeafId> leaves_;                                               // of the question, ascending
  bool may_die_ = false, died_ = false;  // whether it is asked if parts die, and whether some did
  Proof proof_;
};

}  // namespace

Proof prove(Pieces& pieces, const std::vector<LeafInstance>& leaves, const Relevance& relevance,
            std::size_t most_steps, const EarlierProof* earlier) {
  return Prover(pieces, leaves, relevance, most_steps, earlier).run();
}

}  // namespace cnrg
