// Prepared leaves taken apart; see the header.
#include "csg/certify/piece_moulds.h"

#include <algorithm>
#include <tuple>

#include "csg/curves/extrude.h"
#include "csg/curves/parametric.h"
#include "csg/curves/revolved.h"
#include "csg/leaves/geometry_leaf.h"

namespace cnrg {

using namespace surface_math;

namespace {

using CornerKey = std::tuple<std::uint32_t, double, double>;
CornerKey corner_of(const Mould::Cell& cell, std::size_t i) {
  return {cell.points[i], cell.at[i][0].inf(), cell.at[i][1].inf()};
}
bool alike(const Interval& a, const Interval& b) { return a.inf() == b.inf() && a.sup() == b.sup(); }

/// A side of a net: the number of its curve, by the parameter that is fixed there.
struct SideCurve {
  std::uint32_t number;
  std::size_t fixed;
  Rational at;
  Span along;
  bool has(const Parameters& x) const {
    return x[fixed] == at && along[0] <= x[1 - fixed] && x[1 - fixed] <= along[1];
  }
};
/// Of the nets of a leaf, by patch.
std::map<std::uint32_t, std::vector<SideCurve>> side_curves(const CurvedForm* form) {
  std::map<std::uint32_t, std::vector<SideCurve>> sides;
  const auto* const nets = dynamic_cast<const NetForm*>(form);
  std::map<ControlRow, std::uint32_t> numbers;
  for (std::uint32_t p = 0; nets != nullptr && p < nets->patches.size(); ++p) {
    for (const auto& [patch, span] : nets->patches[p].pieces) {
      for (std::size_t k = 0; k < 4; ++k) {
        if (patch.side(k).is_point()) continue;
        const auto known = numbers.try_emplace(canonical(patch.side(k)).curve.net, numbers.size() + 1).first;
        const std::size_t fixed = 1 - k % 2;
        sides[p].push_back({known->second, fixed, span[fixed][k == 1 || k == 2 ? 1 : 0], span[1 - fixed]});
      }
    }
  }
  return sides;
}

bool is_wall(const CurvedForm* form, std::uint32_t patch) {
  if (const auto* const extrusion = dynamic_cast<const ExtrudeForm*>(form))
    return !extrusion->shape.profile.closed || patch >= 2;
  const auto* const nets = dynamic_cast<const NetForm*>(form);
  return nets != nullptr && patch >= nets->patches.size() &&
         std::ranges::none_of(nets->flats[patch - nets->patches.size()].loops, [](const auto& loop) {
           return std::ranges::any_of(loop,
                                      [](const NetForm::Flat::Side& side) { return side.patch.has_value(); });
         });
}

}  // namespace

Mould::Mould(const PreparedLeaf& leaf) {
  Soup soup;
  leaf.add_to(soup, Transform());
  if (leaf.surfaces()) surfaces = leaf.surfaces()();
  if (surfaces && leaf.parameters()) parameters_ = leaf.parameters()();
  if (parameters_) of_cells_ = parameters_->points().size();
  std::vector<std::uint32_t> number(soup.point_count(), kNone);
  const auto number_of = [&](PointId p) {
    std::uint32_t& n = number[p.index()];
    if (n == kNone) n = this->number_of(exact_value(soup, p));
    return n;
  };
  auto curves = side_curves(leaf.form().get());
  if (const auto* const round = dynamic_cast<const RevolvedForm*>(leaf.form().get()))
    one_round_surface = round->lines.size() == 1 && round->lines[0].size() == 1 &&
                        round->lines[0][0].kind != MeridianPiece::Kind::net;
  if (const auto* const extrusion = dynamic_cast<const ExtrudeForm*>(leaf.form().get()))
    rulings = extrusion->shape.vector;
  std::map<std::uint32_t, Rational> areas;  // of parameters, by patch
  std::vector<Interval> values;
  if (parameters_) {
    for (const Rational& value : parameters_->values()) values.push_back(enclose(value));
  }
  for (const SourceId f : IdRange<SourceId>(soup.face_count())) {
    const std::uint32_t patch = soup.face(f).patch;
    if (surfaces && surfaces->patch(patch) != nullptr) {
      for (const auto& corners : parameters_->cells_by_number(f.index())) {
        Cell& cell = cells.emplace_back();
        cell.patch = patch;
        for (const LeafParameters::Corner& corner : corners) {
          cell.points.push_back(corner.point);
          cell.at.push_back({values[corner.u], values[corner.v]});
        }
        const auto at = [&](std::size_t i) -> Parameters {
          const LeafParameters::Corner& corner = corners[i % corners.size()];
          return {parameters_->values()[corner.u], parameters_->values()[corner.v]};
        };
        Rational twice = 0;
        for (std::size_t i = 0; i < corners.size(); ++i)
          twice += at(i)[0] * at(i + 1)[1] - at(i + 1)[0] * at(i)[1];
        areas[patch] += abs(twice) / 2;
        for (std::size_t i = 0; i < corners.size(); ++i) {
          cell.sides.push_back(0);
          for (const SideCurve& one : curves[patch]) {
            if (one.has(at(i)) && one.has(at(i + 1))) cell.sides.back() = one.number;
          }
        }
      }
      continue;
    }
    Flat& flat = flats.emplace_back();
    flat.patch = patch;
    for (const SideCurve& one : curves[patch]) flat.curves.push_back(one.number);
    flat.wall = is_wall(leaf.form().get(), patch);
    flat.loops.emplace_back();
    for (const PointId p : soup.corners(f)) {
      if (p.valid()) flat.loops.back().push_back(number_of(p));
      else flat.loops.emplace_back();
    }
  }
  const auto* const nets = dynamic_cast<const NetForm*>(leaf.form().get());
  for (std::uint32_t p = 0; surfaces && nets != nullptr && p < nets->patches.size(); ++p) {
    for (const auto& [patch, span] : nets->patches[p].pieces)
      areas[p] -= (span[0][1] - span[0][0]) * (span[1][1] - span[1][0]);
    torn = torn || (surfaces->patch(p) != nullptr && areas[p] < 0);
  }
  std::size_t i = 0;
  for (const Soup::Wire& wire : soup.wires()) {
    Wire one{wire.leaf_edge, {number_of(wire.a), number_of(wire.b)}};
    if (parameters_ && surfaces->curve(wire.leaf_edge) != nullptr) {
      const LeafParameters::Wire known = parameters_->wire(i);
      one.points = {this->number_of(known.ends[0]), this->number_of(known.ends[1])};
      one.at = {enclose(known.at[0]), enclose(known.at[1])};
    }
    wires.push_back(one);
    ++i;
  }
  for (const Soup::Isolated& one : soup.isolated()) isolated.push_back(number_of(one.point));
  unite_triangles();
}

std::uint32_t Mould::number_of(const RationalPoint& p) {
  const std::uint32_t known = parameters_ ? parameters_->find(p) : kNone;
  return known != kNone ? known : static_cast<std::uint32_t>(of_cells_) + others_.of(p, "points");
}

void Mould::unite_triangles() {
  std::map<std::tuple<std::uint32_t, CornerKey, CornerKey>, std::pair<std::size_t, std::size_t>> waiting;
  std::vector<char> gone(cells.size(), 0);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i].points.size() != 3) continue;
    const auto diagonal = [&](std::size_t k) {
      const auto &a = cells[i].at[k], &b = cells[i].at[(k + 1) % 3], &c = cells[i].at[(k + 2) % 3];
      return (alike(c[0], a[0]) && alike(c[1], b[1])) || (alike(c[0], b[0]) && alike(c[1], a[1]));
    };
    std::size_t side = 0;
    while (side < 3 && !diagonal(side)) ++side;
    if (side == 3) continue;
    const CornerKey a = corner_of(cells[i], side), b = corner_of(cells[i], (side + 1) % 3);
    const auto [it, fresh] =
        waiting.try_emplace({cells[i].patch, std::min(a, b), std::max(a, b)}, std::pair(i, side));
    if (fresh) continue;
    Cell& one = cells[it->second.first];
    const std::size_t from = it->second.second, third = (side + 2) % 3, own = (from + 2) % 3;
    // The other two corners of the rectangle.
    const bool whole =
        !alike(cells[i].at[third][0], one.at[own][0]) && !alike(cells[i].at[third][1], one.at[own][1]);
    if (!whole || one.points.size() != 3) continue;
    const auto pick = [&](const auto& of, const auto& other) {
      return std::decay_t<decltype(of)>{of[(from + 1) % 3], of[own], of[from], other[third]};
    };
    std::vector<std::uint32_t> sides{one.sides[(from + 1) % 3], one.sides[own], cells[i].sides[(side + 1) % 3],
                                     cells[i].sides[third]};
    if (one.points[from] == cells[i].points[side]) std::swap(sides[2], sides[3]);
    one = {one.patch, pick(one.points, cells[i].points), pick(one.at, cells[i].at), std::move(sides), true};
    gone[i] = 1;
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (gone[i] == 0 && kept++ != i) cells[kept - 1] = std::move(cells[i]);
  }
  cells.resize(kept);
}

const Mould& Moulds::of(const std::shared_ptr<const PreparedLeaf>& leaf) {
  auto& mould = of_[leaf];
  if (!mould) mould = std::make_unique<const Mould>(*leaf);
  return *mould;
}

}  // namespace cnrg
