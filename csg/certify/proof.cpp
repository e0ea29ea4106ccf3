// Pairs, triples and quadruples of pieces; see the header.
#include "csg/certify/proof.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "kernel/base/limits.h"
#include "kernel/refine/box_pairs.h"

namespace cnrg {

using namespace surface_math;

namespace {

using Index = std::uint32_t;
using Why = UncertainPlace::Why;
using PieceParts = std::vector<PiecePart>;
using Patches = std::vector<std::pair<LeafId, std::uint32_t>>;

constexpr std::size_t kMostSteps = 250;         // of one question
constexpr std::size_t kMostOfSurfaces = 20000;  // of one to surfaces alone
constexpr std::size_t kMostTold =
    64;  // places of the same patches of which it is asked whether facets are to blame
constexpr std::size_t kMostOpen = 1000;  // places of the same patches, after which no more are looked for

double size_of(const Interval3& x) {
  double size = 0;
  for (const Interval& c : x) size = std::max(size, c.sup() - c.inf());
  return size;
}
Interval3 thin(const Vector3<double>& x) { return {Interval(x[0]), Interval(x[1]), Interval(x[2])}; }
std::optional<Vector3<double>> direction(const Vector3<double>& x) {
  const double length = std::sqrt(dot(x, x));
  if (!(length > 0) || !std::isfinite(length)) return std::nullopt;
  return scaled(1 / length, x);
}

/// What is asked of some pieces.
enum class Question : std::uint8_t {
  none,     ///< answered by what is asked of fewer, or of the leaf itself
  angle,    ///< apart, or independent
  contact,  ///< apart, or what two have in common, along a curve, crosses the third at an angle
  apart,
};

/// True if the cones of normals, two or three, hold no dependent vectors.
bool independent(const Interval3& a, const Interval3& b) {
  const Interval3 n = cross(a, b);
  if (std::ranges::any_of(n, [](const Interval& x) { return !holds_zero(x); })) return true;
  const auto d = direction(cross(middle_of(a), middle_of(b)));
  if (!d) return false;
  // In the frame of the middle vectors the cones are as narrow as they can be.
  const Vector3<double> x = middle_of(a), y = cross(*d, x);
  const Interval3 ex = thin(x), ey = thin(y);
  return !holds_zero(dot(ex, a) * dot(ey, b) - dot(ey, a) * dot(ex, b));
}
bool independent(const Interval3& a, const Interval3& b, const Interval3& c) {
  if (!holds_zero(dot(cross(a, b), c))) return true;
  // Rows of the inverse of the middle: then each cone is near to an axis.
  const Vector3<double> x = middle_of(a), y = middle_of(b), z = middle_of(c);
  const double det = dot(cross(x, y), z);
  if (!(std::abs(det) > 0) || !std::isfinite(det)) return false;
  const std::array<Vector3<double>, 3> rows{scaled(1 / det, cross(y, z)), scaled(1 / det, cross(z, x)),
                                            scaled(1 / det, cross(x, y))};
  const std::array<Interval3, 3> cones{a, b, c};
  std::array<Interval3, 3> m;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) m[i][j] = dot(thin(rows[j]), cones[i]);
  }
  return !holds_zero(dot(m[0], cross(m[1], m[2])));
}

class Prover {
 public:
  Prover(Pieces& pieces, const std::function<bool(LeafId, LeafId)>& asked_for, std::size_t most_steps,
         const EarlierProof* earlier)
      : pieces_(pieces), all_(pieces.all()), asked_for_(asked_for), most_steps_(most_steps), earlier_(earlier) {}

  Proof run() {
    find_pairs();
    const enclosure::RoundOutward outward;
    together_.resize(all_.size());
    thickness_.assign(all_.size(), -1);
    roots_.resize(all_.size());
    relate_leaves();
    if (earlier_ != nullptr) {
      before_ = pieces_.same_in(earlier_->pieces);
      proof_.spent = earlier_->proof.spent;
    }
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
        if (all_[a].leaf != all_[b].leaf && !asked_for_(all_[a].leaf, all_[b].leaf)) return;
        pairs_.emplace_back(a, b);
      });
    }
    std::sort(pairs_.begin(), pairs_.end());
  }

  bool is_cell(Index i) const { return all_[i].kind != Piece::Kind::curve; }
  bool lies_in(Index curve, Index cell) const {
    return std::ranges::binary_search(all_[curve].in_sheets, all_[cell].sheet);
  }

  /// What goes on smoothly as what: before anything is asked, for it makes cones wider.
  void relate_leaves() {
    std::vector<std::pair<Index, Index>> joined;
    for (const auto& [a, b] : pairs_) {
      if (!is_cell(a) || !is_cell(b)) continue;
      const bool one_sheet = all_[a].sheet == all_[b].sheet;
      if (all_[a].leaf != all_[b].leaf) {
        if (!one_sheet) continue;
        if (parted({part_of(all_, all_[a], all_[a].range), part_of(all_, all_[b], all_[b].range)},
                   Between::facets_and_surfaces))
          continue;
        if (!pieces_.drawn_alike(a, b)) proof_.open.push_back({{a, b}, middle_of(all_[a].corners[0]), 0});
        joined.emplace_back(a, b);
      } else if (all_[a].patch != all_[b].patch && pieces_.adjacent(a, b)) {
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
    if (is_cell(a) && is_cell(b) && all_[a].sheet == all_[b].sheet) return;
    if (is_cell(a) != is_cell(b) && lies_in(is_cell(a) ? b : a, is_cell(a) ? a : b)) return;
    if (one_leaf && pieces_.adjacent(a, b)) return meet(a, b);
    const Question question = one_leaf ? Question::angle : question_of({a, b});
    if (question == Question::none) return;
    ++proof_.asked;
    bool some = false;
    if (!ask({a, b}, question, some)) return;  // what is asked of more pieces is open with it
    if (contacts_.contains({a, b})) ++proof_.contacts;
    else if (some) ++proof_.crossing, meet(a, b);
    else ++proof_.apart;
  }
  void meet(Index a, Index b) {
    together_[a].push_back(b);
    together_[b].push_back(a);
  }

  /// Triples and quadruples whose first piece that is not exact is i.
  void ask_more(Index i) {
    const std::vector<Index>& near = together_[i];
    const auto counts = [&](Index j) { return all_[j].exact() || j > i; };
    for (std::size_t x = 0; x < near.size(); ++x) {
      if (!counts(near[x])) continue;
      for (std::size_t y = x + 1; y < near.size(); ++y) {
        if (!counts(near[y]) || !may_meet(near[x], near[y]) || !boxes_meet({i, near[x], near[y]})) continue;
        const std::vector<Index> triple{i, near[x], near[y]};
        const Question question = question_of(triple);
        bool some = true;
        if (question != Question::none && !ask(triple, question, some)) continue;
        if (!some) continue;
        for (std::size_t z = y + 1; z < near.size(); ++z) {
          const std::vector<Index> four{i, near[x], near[y], near[z]};
          if (!counts(near[z]) || !may_meet(near[x], near[z]) || !may_meet(near[y], near[z]) || !boxes_meet(four))
            continue;
          const Question last = question_of(four);
          bool any = true;
          if (last != Question::none) ask(four, last, any);
        }
      }
    }
  }
  bool may_meet(Index a, Index b) const {
    if (all_[a].exact() && all_[b].exact()) return true;
    return std::ranges::binary_search(together_[a], b);
  }
  bool boxes_meet(const std::vector<Index>& tuple) const {
    for (std::size_t i = 0; i < tuple.size(); ++i) {
      for (std::size_t j = i + 1; j < tuple.size(); ++j) {
        if (!all_[tuple[i]].box.meets(all_[tuple[j]].box)) return false;
      }
    }
    return true;
  }

  Question question_of(const std::vector<Index>& tuple) const {
    bool one_leaf = true, exact = true;
    std::size_t cells = 0;
    std::vector<Index> curves;
    for (std::size_t i = 0; i < tuple.size(); ++i) {
      const Piece& piece = all_[tuple[i]];
      one_leaf = one_leaf && piece.leaf == all_[tuple[0]].leaf;
      exact = exact && piece.exact();
      if (is_cell(tuple[i])) ++cells;
      else curves.push_back(tuple[i]);
      for (std::size_t j = 0; j < i; ++j) {
        const Piece& other = all_[tuple[j]];
        if (piece.sheet == other.sheet && is_cell(tuple[i]) == is_cell(tuple[j])) return Question::none;
        if (is_cell(tuple[i]) != is_cell(tuple[j]) &&
            lies_in(is_cell(tuple[i]) ? tuple[j] : tuple[i], is_cell(tuple[i]) ? tuple[i] : tuple[j]))
          return Question::none;
        if (smooth_.contains(std::minmax(tuple[i], tuple[j]))) return Question::none;
        if (piece.leaf != other.leaf && !asked_for_(piece.leaf, other.leaf)) return Question::none;
      }
    }
    if (one_leaf || exact) return Question::none;
    std::size_t touching = 0;
    for (std::size_t i = 0; i < tuple.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) touching += contacts_.contains(std::minmax(tuple[i], tuple[j])) ? 1 : 0;
    }
    if (touching > 0) return touching == 1 && tuple.size() == 3 ? Question::contact : Question::apart;
    if (curves.empty()) return cells <= 3 ? Question::angle : Question::apart;
    if (curves.size() == 1) return cells == 1 ? Question::angle : Question::apart;
    if (curves.size() > 2) return Question::apart;
    std::vector<Index> common;
    std::ranges::set_intersection(all_[curves[0]].in_sheets, all_[curves[1]].in_sheets,
                                  std::back_inserter(common));
    if (common.size() > 1) return Question::none;  // the curve in which these sheets cross
    return common.size() == 1 && cells == 0 ? Question::angle : Question::apart;
  }

  /// True if it is proven. `some`: whether they may have a point in common.
  bool ask(const std::vector<Index>& tuple, Question question, bool& some) {
    Patches patches;
    for (const Index i : tuple) patches.emplace_back(all_[i].leaf, all_[i].patch);
    std::sort(patches.begin(), patches.end());
    std::size_t& open = open_[patches];
    if (open >= kMostOpen) return false;
    const PieceTuple key = key_of(tuple);
    if (const Proof::Answer* const before = answered_before(key)) return take(*before, tuple, patches, open, some);
    if (answered_at_once(tuple, question, some)) return answered(key, some);
    std::vector<LeafId> leaves;
    for (const auto& [leaf, patch] : patches) {
      if (leaves.empty() || leaves.back() != leaf) leaves.push_back(leaf);
    }
    std::size_t& spent = proof_.spent[leaves];
    if (spent >= most_steps_) {
      if (++proof_.left[leaves] == 1)
        proof_.open.push_back({tuple, middle_of(root(tuple[0]).box), size_of(root(tuple[0]).box), Why::budget});
      return false;
    }
    const std::size_t before = proof_.steps;
    const bool proven = ask_on(key, tuple, question, patches, open, some);
    spent += proof_.steps - before;
    return proven;
  }
  bool ask_on(const PieceTuple& key, const std::vector<Index>& tuple, Question question, const Patches& patches,
              std::size_t& open, bool& some) {
    Interval3 left{};
    some = false;
    if (tuple.size() == 2 && is_cell(tuple[0]) && is_cell(tuple[1])) {
      if (const auto known = touch(tuple[0], tuple[1])) {
        some = *known != Proof::Answer::Kind::apart;
        proof_.answers.try_emplace(key, Proof::Answer{*known});
        return true;
      }
    }
    if (answer(tuple, question, Between::facets_and_surfaces, kMostSteps, some, left)) return answered(key, some);
    some = true;
    OpenPlace place{tuple, middle_of(left), size_of(left), Why::facets};
    ++open;
    if (!hopeless_.contains(patches)) {
      bool any = false;
      const bool by_facets =
          answer(tuple, question, Between::surfaces, open <= kMostTold ? kMostOfSurfaces : kMostSteps / 2, any,
                 left) ||
          (open > kMostTold && answer(tuple, question, Between::surfaces, kMostOfSurfaces, any, left));
      if (!by_facets) {
        place.why = Why::near;
        place.at = middle_of(left);
        place.size = size_of(left);
        hopeless_.insert(patches);
      }
    }
    add_open(key, std::move(place));
    return false;
  }

  static PieceTuple key_of(std::vector<Index> tuple) {
    std::sort(tuple.begin(), tuple.end());
    PieceTuple key{kNone, kNone, kNone, kNone};
    std::ranges::copy(tuple, key.begin());
    return key;
  }
  bool answered(const PieceTuple& key, bool some) {
    using Kind = Proof::Answer::Kind;
    proof_.answers.try_emplace(key, Proof::Answer{some ? Kind::crossing : Kind::apart});
    return true;
  }
  void add_open(const PieceTuple& key, OpenPlace place) {
    proof_.answers.try_emplace(
        key, Proof::Answer{Proof::Answer::Kind::open, static_cast<std::uint32_t>(proof_.open.size())});
    proof_.open.push_back(std::move(place));
  }
  /// Of the same pieces in the earlier drawing; null if it is not known.
  const Proof::Answer* answered_before(const PieceTuple& key) const {
    if (earlier_ == nullptr) return nullptr;
    PieceTuple there{kNone, kNone, kNone, kNone};
    for (std::size_t k = 0; k < 4 && key[k] != kNone; ++k) {
      there[k] = before_[key[k]];
      if (there[k] == kNone) return nullptr;
    }
    std::sort(there.begin(), there.end());
    const auto it = earlier_->proof.answers.find(there);
    return it == earlier_->proof.answers.end() ? nullptr : &it->second;
  }
  bool take(const Proof::Answer& before, const std::vector<Index>& tuple, const Patches& patches,
            std::size_t& open, bool& some) {
    using Kind = Proof::Answer::Kind;
    some = before.kind != Kind::apart;
    if (before.kind == Kind::open) {
      OpenPlace place = earlier_->proof.open[before.place];
      place.pieces = tuple;
      ++open;
      if (place.why == Why::near) hopeless_.insert(patches);
      add_open(key_of(tuple), std::move(place));
      return false;
    }
    if (before.kind == Kind::contact) contacts_.emplace(std::minmax(tuple[0], tuple[1]));
    proof_.answers.try_emplace(key_of(tuple), before);
    return true;
  }
  /// Nothing, unless one sheet is on one side of the other, and so are the facets. Then whether they have points
  /// of the contact in common: facets and surfaces both.
  std::optional<Proof::Answer::Kind> touch(Index a, Index b) {
    using Kind = Proof::Answer::Kind;
    const std::optional<Contact>& contact = pieces_.contact_of(all_[a].sheet, all_[b].sheet);
    if (!contact) return std::nullopt;
    const Pieces::Meeting meeting = pieces_.facets_meet(a, b, *contact);
    if (meeting == Pieces::Meeting::otherwise) return std::nullopt;
    if (meeting == Pieces::Meeting::at_contact) {
      contacts_.emplace(a, b);
      return Kind::contact;
    }
    if (contact->kind == Contact::Kind::none) return Kind::apart;
    bool some = false;
    Interval3 left{};
    if (answer({a, b}, Question::apart, Between::surfaces, kMostOfSurfaces, some, left)) return Kind::apart;
    return std::nullopt;
  }

  const PiecePart& root(Index i) {
    if (!roots_[i]) roots_[i] = std::make_unique<const PiecePart>(part_of(all_, all_[i], all_[i].range));
    return *roots_[i];
  }
  /// True if no part has to be halved for the answer.
  bool answered_at_once(const std::vector<Index>& tuple, Question question, bool& some) {
    PieceParts parts;
    for (const Index i : tuple) parts.push_back(root(i));
    std::size_t steps = 0;
    Interval3 left{};
    some = false;
    // Pieces that meet are asked about with others, so it is worth to know which do not.
    if (tuple.size() == 2 && parted_along_sides(parts[0], parts[1])) return true;
    return answer(parts, question, Between::facets_and_surfaces, steps, some, left);
  }
  /// True if a plane along a side of one and a side of the other is between them.
  static bool parted_along_sides(const PiecePart& a, const PiecePart& b) {
    if (parted({a, b}, Between::facets_and_surfaces)) return true;
    for (const Vector3<double>& x : sides_of(a)) {
      for (const Vector3<double>& y : sides_of(b)) {
        const auto d = direction(cross(x, y));
        if (!d) continue;
        const Interval one = extent(a, *d, Between::facets_and_surfaces),
                       other = extent(b, *d, Between::facets_and_surfaces);
        if (one.sup() < other.inf() || other.sup() < one.inf()) return true;
      }
    }
    return false;
  }
  static std::vector<Vector3<double>> sides_of(const PiecePart& part) {
    const Piece& piece = *part.piece;
    const auto way = [&](std::size_t i, std::size_t j) {
      return difference(middle_of(piece.corners[j]), middle_of(piece.corners[i]));
    };
    if (piece.kind == Piece::Kind::curve) return {way(0, 1)};
    if (piece.kind == Piece::Kind::cell) return {way(0, 1), way(1, 2)};
    return {};
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
    Interval3 common = parts[0].box;
    for (const PiecePart& part : parts) {
      for (std::size_t k = 0; k < 3; ++k) {
        const double low = std::max(common[k].inf(), part.box[k].inf()),
                     high = std::min(common[k].sup(), part.box[k].sup());
        if (low > high) return true;
        common[k] = Interval(low, high);
      }
    }
    for (const PiecePart& part : parts) {
      if (part.piece->kind == Piece::Kind::flat && misses(*part.piece, common)) return true;
    }
    if ((question == Question::angle && at_angle(parts)) ||
        (question == Question::contact && contact_at_angle(parts))) {
      some = true;
      return true;
    }
    if (parted(parts, between)) return true;
    left = common;
    std::size_t chosen = parts.size(), way = 0;
    double most = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (parts[i].piece->kind == Piece::Kind::flat || !worth_halving(parts[i], between)) continue;
      const auto d = direction(middle_of(parts[i == 0 ? 1 : 0].cone));
      const std::array<double, 2> gain = gains(parts[i], d ? *d : Vector3<double>{1, 0, 0});
      for (std::size_t k = 0; k < 2; ++k) {
        if (gain[k] > most) most = gain[k], chosen = i, way = k;
      }
    }
    if (chosen == parts.size() || steps == 0) return false;
    --steps;
    ++proof_.steps;
    PieceParts next = parts;
    for (const PiecePart& half : halves(all_, parts[chosen], way, between)) {
      next[chosen] = half;
      if (!answer(next, question, between, steps, some, left)) return false;
    }
    return true;
  }

  /// Of two parts in contact and a third piece, a sheet.
  bool contact_at_angle(const PieceParts& parts) {
    std::array<std::size_t, 3> order{0, 1, 2};
    const auto number = [&](std::size_t i) { return static_cast<Index>(parts[i].piece - all_.data()); };
    while (!contacts_.contains(std::minmax(number(order[0]), number(order[1]))))
      std::rotate(order.begin(), order.begin() + 1, order.end());
    const PiecePart &a = parts[order[0]], &b = parts[order[1]], &c = parts[order[2]];
    if (c.blind || c.piece->kind == Piece::Kind::curve) return false;
    const Contact& contact = *pieces_.contact_of(a.piece->sheet, b.piece->sheet);
    const Interval3 direction{enclose(contact.direction[0]), enclose(contact.direction[1]),
                              enclose(contact.direction[2])};
    if (contact.kind == Contact::Kind::line) return !holds_zero(dot(direction, c.cone));
    if (contact.kind == Contact::Kind::circle) {
      const Interval3 way = cross(direction, difference(a.box, enclose3(contact.point)));
      return !holds_zero(dot(way, c.cone));
    }
    const PiecePart& one = a.blind ? b : a;
    return contact.kind == Contact::Kind::conic && !one.blind &&
           !holds_zero(dot(cross(direction, one.cone), c.cone));
  }

  /// False where a part is no longer than facets are away from the surface there: it gets no thinner.
  bool worth_halving(const PiecePart& part, Between between) {
    const Piece& piece = *part.piece;
    const double size = size_of(part.box);
    double far = 0;
    for (std::size_t k = 0; k < 3; ++k)
      far = std::max({far, std::abs(piece.box.lo[k]), std::abs(piece.box.hi[k])});
    if (size <= 1e-14 * far) return false;
    if (between == Between::surfaces || piece.kind == Piece::Kind::curve) return true;
    double& thickness = thickness_[static_cast<std::size_t>(&piece - all_.data())];
    if (thickness < 0) thickness = thickness_of(part_of(all_, piece, piece.range));
    return size > thickness / 2 || size > thickness_of(part) / 2;
  }
  static double thickness_of(const PiecePart& part) {
    const auto d = part.blind ? std::nullopt : direction(middle_of(part.cone));
    if (!d) return 0;
    const Interval wide = extent(part, *d, Between::facets_and_surfaces);
    return wide.sup() - wide.inf();
  }

  static bool at_angle(const PieceParts& parts) {
    for (const PiecePart& part : parts) {
      if (part.blind) return false;
    }
    if (parts.size() == 3) return independent(parts[0].cone, parts[1].cone, parts[2].cone);
    const bool first = parts[0].piece->kind == Piece::Kind::curve,
               second = parts[1].piece->kind == Piece::Kind::curve;
    if (first != second) return !holds_zero(dot(parts[0].cone, parts[1].cone));
    return independent(parts[0].cone, parts[1].cone);
  }

  /// True if the box has no point of the flat piece.
  static bool misses(const Piece& flat, const Interval3& box) {
    if (!holds_zero(dot(flat.normal, difference(box, flat.point)))) return true;
    for (const auto& [d, wide] : flat.limits) {
      const Interval there = dot(thin(d), box);
      if (there.inf() > wide.sup() || there.sup() < wide.inf()) return true;
    }
    return false;
  }

  /// True if two of the parts are on different sides of a plane.
  static bool parted(const PieceParts& parts, Between between) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (parts[i].blind || parts[i].piece->kind == Piece::Kind::curve) continue;
      const auto d = direction(middle_of(parts[i].cone));
      if (!d) continue;
      const Interval own = extent(parts[i], *d, between);
      for (std::size_t j = 0; j < parts.size(); ++j) {
        if (j == i) continue;
        const Interval other = extent(parts[j], *d, between);
        if (own.sup() < other.inf() || other.sup() < own.inf()) return true;
      }
    }
    return false;
  }

  Pieces& pieces_;
  const std::vector<Piece>& all_;
  const std::function<bool(LeafId, LeafId)>& asked_for_;
  const std::size_t most_steps_;
  const EarlierProof* const earlier_;
  std::vector<Index> before_;                            // by piece: the same one in the earlier drawing
  std::vector<std::unique_ptr<const PiecePart>> roots_;  // whole pieces, once they are asked for
  std::vector<std::pair<Index, Index>> pairs_;
  std::vector<std::vector<Index>> together_;
  std::set<std::pair<Index, Index>> smooth_, contacts_;
  std::vector<double> thickness_;        // of pieces; below 0 where it is not known yet
  std::set<Patches> hopeless_;           // that touch somewhere
  std::map<Patches, std::size_t> open_;  // how many places
  Proof proof_;
};

}  // namespace

Proof prove(Pieces& pieces, const std::function<bool(LeafId, LeafId)>& asked_for, std::size_t most_steps,
            const EarlierProof* earlier) {
  return Prover(pieces, asked_for, most_steps, earlier).run();
}

}  // namespace cnrg
