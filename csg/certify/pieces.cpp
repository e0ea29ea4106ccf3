// From soups and parameters to pieces; see the header.
#include "csg/certify/pieces.h"

#include <algorithm>

#include "csg/certify/piece_parts.h"
#include "csg/leaves/geometry_leaf.h"
#include "csg/leaves/parameters.h"
#include "kernel/base/error.h"
#include "kernel/base/limits.h"
#include "kernel/base/parallel.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/refine/box_pairs.h"

namespace cnrg {

using namespace surface_math;

namespace {

constexpr int kHalvedAlongSide = 4;  // how often a side is halved to prove an angle

}  // namespace

class PieceMaker {
 public:
  PieceMaker(Pieces& out, const PlacedLeaves& leaves, std::span<const RationalPoint> reach, Moulds& moulds,
             bool of_themselves)
      : out_(out), leaves_(leaves) {
    const std::vector<LeafInstance>& instances = leaves.instances;
    for (std::size_t i = 0; i < instances.size(); ++i) {
      if (instances[i].leaf->unbounded()) continue;
      const Mould& mould = moulds.of(instances[i].leaf);
      place(LeafId(i), mould, instances[i].transform);
      if (of_themselves && mould.surfaces && !mould.one_round_surface) out_.own_.insert(LeafId(i));
      if (instances[i].leaf->volume_bound() != 0.0) out_.unknown_.insert(LeafId(i));
    }
    add_unbounded(instances, reach);
    choose_cells();
    for (Place* const one : by_place()) add(*one);
    for (const auto& [plane, sheet] : planes_) out_.planes_[sheet] = plane;
    for (const auto& [key, sheet] : sheets_) {
      if (key[0] != 0) continue;
      const auto& [quadrics, tori] = leaves.equations;
      if (const auto it = quadrics.find(key[1]); it != quadrics.end())
        out_.equations_.quadrics[sheet] = it->second;
      if (const auto it = tori.find(key[1]); it != tori.end()) out_.equations_.tori[sheet] = it->second;
    }
  }

 private:
  struct Place {
    LeafId leaf;
    const Transform& transform;
    const Mould& mould;
    std::vector<Interval3> points{};
    std::vector<Box> boxes{};    // of the cells, facets and surfaces
    std::vector<char> chosen{};  // of the cells: those that become pieces
    std::vector<char> asked{};   // of the flat faces likewise
    /// Pieces, and side of the piece; kNone for cells that are none.
    PieceSides sides{};
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::set<std::uint32_t>> curves{};  // of sides, by ends
  };

  /// Leaves by where their points are: what is asked first must not depend on their order in the tree.
  std::vector<Place*> by_place() {
    std::vector<Place*> all;
    for (Place& one : places_) all.push_back(&one);
    std::stable_sort(all.begin(), all.end(), [](const Place* a, const Place* b) {
      return std::ranges::lexicographical_compare(
          a->points, b->points,
          [](const Interval3& p, const Interval3& q) { return middle_of(p) < middle_of(q); });
    });
    return all;
  }

  std::uint32_t sheet_of(LeafId leaf, std::uint32_t patch) {
    const std::vector<std::uint32_t>* known = leaves_.surfaces.empty() ? nullptr : &leaves_.surfaces[leaf.index()];
    const std::uint32_t number = known != nullptr && patch < known->size() ? (*known)[patch] : 0;
    if (number != 0) return numbered(sheets_, {0, number, 0});
    return numbered(sheets_, {1, static_cast<std::uint32_t>(leaf.index()), patch});
  }
  /// Of sheets and curves.
  template <class Map>
  std::uint32_t numbered(Map& numbers, const typename Map::key_type& key) {
    const auto [it, fresh] = numbers.try_emplace(key, next_);
    if (fresh) ++next_;
    return it->second;
  }
  void set_plane(Piece& piece, const RationalPoint& normal, const RationalPoint& on) {
    std::array<Rational, 4> key{normal[0], normal[1], normal[2], Rational(-dot(normal, on))};
    divide_by_first(key);
    piece.sheet = numbered(planes_, key);
    piece.normal = enclose3(normal);
    piece.point = enclose3(on);
  }

  void place(LeafId leaf, const Mould& mould, const Transform& transform) {
    Place& place = places_.emplace_back(Place{leaf, transform, mould});
    std::vector<RationalPoint>& exact = out_.points_[leaf];
    for (std::uint32_t i = 0; i < mould.point_count(); ++i) {
      exact.push_back(transform.identity() ? mould.point(i) : transform.apply(mould.point(i)));
    }
    for (const RationalPoint& p : exact) place.points.push_back(enclose3(p));
    if (mould.surfaces) {
      out_.leaf_surfaces_.push_back(mould.surfaces);
      if (!mould.surfaces->complete() || mould.torn) out_.unknown_.insert(leaf);
    }
    for (const Mould::Cell& cell : mould.cells) surface_of(place, cell.patch);
    place.boxes.resize(mould.cells.size());
    for_each_index(
        mould.cells.size(),
        [&](std::size_t i) {
          const enclosure::RoundOutward outward;
          const Mould::Cell& cell = mould.cells[i];
          std::array<Interval, 2> range = cell.at[0];
          for (const auto& at : cell.at) range = {hull(range[0], at[0]), hull(range[1], at[1])};
          Interval3 all = out_.placed_.at({leaf, cell.patch})->over(range[0], range[1]).point;
          for (const std::uint32_t p : cell.points) all = hull(all, place.points[p]);
          place.boxes[i] = box_of(all);
        },
        256);
  }
  const PlacedSurface* surface_of(const Place& place, std::uint32_t patch) {
    auto& surface = out_.placed_[{place.leaf, patch}];
    if (!surface) surface = std::make_unique<PlacedSurface>(place.mould.surfaces, patch, place.transform);
    return surface.get();
  }

  /// Of large leaves most cells are near nothing of another leaf. Those that are become pieces, and those about
  /// them. Of leaves without curved faces all is exact: of these, faces near what is not.
  void choose_cells() {
    constexpr std::uint32_t kAll = kNone;
    struct Item {
      std::uint32_t leaf, cell, flat;
      bool exact;
    };
    std::vector<Item> items;
    std::vector<Box> boxes;
    const auto add = [&](const Item& item, const Box& box) {
      items.push_back(item);
      boxes.push_back(box);
    };
    for (std::uint32_t i = 0; i < places_.size(); ++i) {
      Place& one = places_[i];
      one.chosen.assign(one.boxes.size(), out_.own_.contains(one.leaf) ? 1 : 0);
      for (std::uint32_t c = 0; c < one.boxes.size(); ++c) add({i, c, kAll, false}, one.boxes[c]);
      one.asked.assign(one.mould.flats.size(), one.mould.cells.empty() && !out_.own_.contains(one.leaf) ? 0 : 1);
      const auto hull_of = [&](const auto& numbers) {
        Interval3 all = one.points[numbers[0]];
        for (const std::uint32_t p : numbers) all = hull(all, one.points[p]);
        return all;
      };
      for (std::uint32_t f = 0; f < one.mould.flats.size(); ++f)
        add({i, kAll, f, true}, box_of(hull_of(one.mould.flats[f].loops[0])));
      for (const Mould::Wire& wire : one.mould.wires) {
        const std::shared_ptr<const Curve> curve = curve_of(one, wire.number);
        Interval3 all = hull_of(wire.points);
        if (curve != nullptr) all = hull(all, curve->over(hull(wire.at[0], wire.at[1])).point);
        add({i, kAll, kAll, curve == nullptr}, box_of(all));
      }
      for (const std::uint32_t p : one.mould.isolated) add({i, kAll, kAll, true}, box_of(one.points[p]));
    }
    for (const Piece& piece : out_.pieces_) add({kAll, kAll, kAll, true}, piece.box);
    const BoxPairs finder(boxes);
    const auto choose = [&](const Item& item, const Item& other) {
      if (item.cell != kAll) places_[item.leaf].chosen[item.cell] = 1;
      if (item.flat != kAll && !other.exact) places_[item.leaf].asked[item.flat] = 1;
    };
    for (std::size_t part = 0; part < finder.part_count(); ++part) {
      finder.find(part, [&](std::uint32_t x, std::uint32_t y) {
        const std::uint32_t a = finder.item(x), b = finder.item(y);
        if (items[a].leaf == items[b].leaf || !boxes[a].meets(boxes[b])) return;
        choose(items[a], items[b]);
        choose(items[b], items[a]);
      });
    }
    for (Place& one : places_) {
      std::vector<char> near(one.points.size(), 0);
      for (std::size_t c = 0; c < one.chosen.size(); ++c) {
        for (const std::uint32_t p : one.mould.cells[c].points) near[p] |= one.chosen[c];
      }
      for (std::size_t c = 0; c < one.chosen.size(); ++c) {
        for (const std::uint32_t p : one.mould.cells[c].points) one.chosen[c] |= near[p];
      }
    }
  }

  void add(Place& place) {
    const std::size_t first = out_.pieces_.size();
    std::vector<char> used(place.points.size(), 0);
    for (std::size_t i = 0; i < place.chosen.size(); ++i) {
      if (place.chosen[i] == 0) continue;
      add_cell(place, place.mould.cells[i]);
      for (const std::uint32_t p : place.mould.cells[i].points) used[p] = 1;
    }
    for (std::size_t i = 0; i < place.chosen.size(); ++i) {
      const std::vector<std::uint32_t>& points = place.mould.cells[i].points;
      for (std::size_t k = 0; place.chosen[i] == 0 && k < points.size(); ++k) {
        const std::uint32_t a = points[k], b = points[(k + 1) % points.size()];
        if (used[a] && used[b]) add_side(place, a, b, kNone, 0);
      }
    }
    for (std::size_t i = 0; i < place.asked.size(); ++i) {
      if (place.asked[i] != 0) add_flat(place, place.mould.flats[i]);
      else add_sides(place, place.mould.flats[i], kNone);
    }
    find_neighbours(out_.pieces_, first);
    find_columns(out_.pieces_, first, place.sides);
    find_poles(out_.pieces_, first);
    add_curves(place);
    for (const Mould::Wire& wire : place.mould.wires) add_wire(place, wire);
    for (const std::uint32_t p : place.mould.isolated) add_point(place, p);
    join_curves(first);
  }

  void add_cell(Place& place, const Mould::Cell& cell) {
    Piece piece;
    piece.leaf = place.leaf;
    piece.patch = cell.patch;
    piece.sheet = sheet_of(place.leaf, cell.patch);
    piece.surface = surface_of(place, cell.patch);
    piece.corner_count = static_cast<std::uint8_t>(cell.points.size());
    require(piece.corner_count >= 3 && piece.corner_count <= 4, "pieces: a cell of another number of corners");
    for (std::size_t i = 0; i < cell.points.size(); ++i) {
      piece.points[i] = cell.points[i];
      piece.corners[i] = place.points[cell.points[i]];
      for (std::size_t k = 0; k < 2; ++k) {
        piece.at[i][k] = middle_of(cell.at[i][k]);
        piece.range[k] = i == 0 ? cell.at[i][k] : hull(piece.range[k], cell.at[i][k]);
      }
    }
    piece.bent = cell.bent;
    derive(piece);
    require(!piece.bent || piece.grid, "pieces: two triangles that are no rectangle of parameters");
    measure_turn(piece);
    const auto number = static_cast<std::uint32_t>(out_.pieces_.size());
    for (std::size_t i = 0; i < cell.points.size(); ++i) {
      const std::uint32_t a = cell.points[i], b = cell.points[(i + 1) % cell.points.size()];
      add_side(place, a, b, number, i);
      if (cell.sides[i] != 0) place.curves[std::minmax(a, b)].insert(cell.sides[i]);
    }
    out_.pieces_.push_back(std::move(piece));
  }

  static void measure_turn(Piece& piece) {
    const enclosure::RoundNearest nearest;
    const double u0 = piece.range[0].inf(), u1 = piece.range[0].sup(), v0 = piece.range[1].inf(),
                 v1 = piece.range[1].sup();
    const auto normal = [&](double u, double v) {
      const Vector3<double> n = piece.surface->at(u, v).normal;
      return direction(n).value_or(n);
    };
    const auto turn = [](const Vector3<double>& a, const Vector3<double>& b) { return length(difference(a, b)); };
    const double u = (u0 + u1) / 2, v = (v0 + v1) / 2;
    piece.turn = {turn(normal(u0, v), normal(u1, v)), turn(normal(u, v0), normal(u, v1))};
  }

  static void add_side(Place& place, std::uint32_t a, std::uint32_t b, std::uint32_t piece, std::size_t side) {
    if (a != b) place.sides[std::minmax(a, b)].emplace_back(piece, static_cast<std::uint8_t>(side));
  }

  /// The derivatives of F by u and v, from its corners.
  static void derive(Piece& piece) {
    const auto way = [&](std::size_t a, std::size_t b) { return difference(piece.corners[b], piece.corners[a]); };
    const auto step = [&](std::size_t a, std::size_t b, std::size_t k) {
      return Interval(piece.at[b][k]) - Interval(piece.at[a][k]);
    };
    const auto is_zero = [](const Interval& x) { return x.inf() == 0 && x.sup() == 0; };
    if (piece.corner_count == 3) {
      const Interval d = step(0, 1, 0) * step(0, 2, 1) - step(0, 2, 0) * step(0, 1, 1);
      if (d.inf() <= 0 && d.sup() >= 0) {
        piece.blind = true;
        return;
      }
      const Interval3 p = way(0, 1), q = way(0, 2);
      const Interval one = Interval(1) / d;
      piece.along_u = scaled(one, difference(scaled(step(0, 2, 1), p), scaled(step(0, 1, 1), q)));
      piece.along_v = scaled(one, difference(scaled(step(0, 1, 0), q), scaled(step(0, 2, 0), p)));
      return;
    }
    // Sides 0 1 and 3 2 run along one parameter, 1 2 and 0 3 along the other.
    const std::size_t first = is_zero(step(0, 1, 1)) ? 0 : 1, second = 1 - first;
    if (!is_zero(step(0, 1, second)) || !is_zero(step(3, 2, second)) || !is_zero(step(1, 2, first)) ||
        !is_zero(step(0, 3, first))) {
      piece.blind = true;
      return;
    }
    piece.grid = true;
    // Where a side is a point, the derivative along it is that of the opposite side times a factor that falls to
    // zero, of F and of S: its direction is that of the opposite side.
    const auto along = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d, std::size_t k) {
      const bool no_first = piece.points[a] == piece.points[b], no_second = piece.points[c] == piece.points[d];
      const Interval3 p = scaled(Interval(1) / step(a, b, k), way(a, b)),
                      q = scaled(Interval(1) / step(c, d, k), way(c, d));
      if (no_first && no_second) piece.blind = true;
      return no_first ? normalized(q) : no_second ? normalized(p) : hull(normalized(p), normalized(q));
    };
    Interval3& x = first == 0 ? piece.along_u : piece.along_v;
    Interval3& y = first == 0 ? piece.along_v : piece.along_u;
    x = along(0, 1, 3, 2, first);
    y = along(1, 2, 0, 3, second);
  }

  void add_flat(Place& place, const Mould::Flat& flat) {
    const std::vector<std::uint32_t>& outer = flat.loops[0];
    const std::vector<RationalPoint>& exact = out_.points_.at(place.leaf);
    RationalPoint normal{0, 0, 0};
    for (std::size_t i = 1; i + 1 < outer.size() && is_zero(normal); ++i)
      normal = cross(exact[outer[i]] - exact[outer[0]], exact[outer[i + 1]] - exact[outer[0]]);
    if (is_zero(normal)) return;
    Piece piece{.kind = Piece::Kind::flat, .wall = flat.wall, .leaf = place.leaf, .patch = flat.patch};
    set_plane(piece, normal, exact[outer[0]]);
    Interval3 all = piece.point;
    for (const auto& loop : flat.loops) {
      for (const std::uint32_t p : loop) {
        all = hull(all, place.points[p]);
        piece.corner_numbers.push_back(p);
      }
    }
    std::sort(piece.corner_numbers.begin(), piece.corner_numbers.end());
    piece.box = box_of(all);
    add_limits(place, piece, outer);
    add_sides(place, flat, static_cast<std::uint32_t>(out_.pieces_.size()));
    out_.pieces_.push_back(std::move(piece));
  }
  static void add_sides(Place& place, const Mould::Flat& flat, std::uint32_t piece) {
    for (const auto& loop : flat.loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const std::uint32_t a = loop[i], b = loop[(i + 1) % loop.size()];
        add_side(place, a, b, piece, i);
        auto& curves = place.curves[std::minmax(a, b)];
        const bool known = std::ranges::find_first_of(curves, flat.curves) != curves.end();
        if (!known && !flat.curves.empty()) curves.insert(kNone);  // a straight side, and perhaps that of a cell
      }
    }
  }
  /// Half-planes that hold the face, also where it ends in a curve of a patch.
  void add_limits(const Place& place, Piece& piece, const std::vector<std::uint32_t>& outer) {
    constexpr std::size_t kMost = 16;
    std::vector<PiecePart> rims;
    for (std::size_t i = 0; i < outer.size(); ++i) {
      const auto it = place.sides.find(std::minmax(outer[i], outer[(i + 1) % outer.size()]));
      if (it == place.sides.end()) continue;
      for (const auto& [number, side] : it->second) {
        if (number == kNone) continue;
        const Piece& cell = out_.pieces_[number];
        if (cell.kind == Piece::Kind::cell) rims.push_back(part_of(out_.pieces_, cell, range_of_side(cell, side)));
      }
    }
    Interval3 all = all_of(piece.box);
    for (const PiecePart& rim : rims) all = hull(all, rim.box);
    piece.box = box_of(all);
    const std::size_t step = (outer.size() + kMost - 1) / kMost;
    for (std::size_t i = 0; i < outer.size(); i += step) {
      const Interval3& from = place.points[outer[i]];
      const auto out = direction(cross(middle_of(difference(place.points[outer[(i + 1) % outer.size()]], from)),
                                       middle_of(piece.normal)));
      if (!out) continue;
      const Interval3 along = thin(*out);
      Interval wide = dot(along, from);
      for (const std::uint32_t p : outer) wide = hull(wide, dot(along, place.points[p]));
      for (const PiecePart& rim : rims) wide = hull(wide, extents(rim, *out, Between::facets_and_surfaces).all());
      piece.limits.emplace_back(*out, wide);
    }
  }
  static std::array<Interval, 2> range_of_side(const Piece& cell, std::size_t side) {
    std::array<Interval, 2> range;
    const std::size_t next = (side + 1) % cell.corner_count;
    for (std::size_t k = 0; k < 2; ++k) range[k] = hull(Interval(cell.at[side][k]), Interval(cell.at[next][k]));
    return range;
  }

  /// Edges of cells that are not between two cells of one patch, nor where a cell and one other piece cross at an
  /// angle: borders of surfaces, and where one patch goes on smoothly as another, or in its plane.
  void add_curves(Place& place) {
    const enclosure::RoundOutward outward;
    for (const auto& [edge, pieces] : place.sides) {
      // Near nothing of another leaf, as the cell that is no piece.
      if (std::ranges::any_of(pieces, [](const auto& p) { return p.first == kNone; })) continue;
      std::vector<Piece>& all = out_.pieces_;
      const auto of = [&all, &pieces = pieces](std::size_t i) -> const Piece& { return all[pieces[i].first]; };
      if (const auto it = place.curves.find(edge); it != place.curves.end() && it->second.size() > 1) {
        for (const auto& [piece, side] : pieces) all[piece].torn |= std::uint8_t(1u << (side & 7u));
      }
      const bool curved =
          std::ranges::any_of(pieces, [&](const auto& p) { return all[p.first].kind == Piece::Kind::cell; });
      std::set<std::uint32_t> sheets;
      for (const auto& p : pieces) sheets.insert(all[p.first].sheet);
      if (pieces.size() == 2 && of(0).patch == of(1).patch && of(0).kind == of(1).kind) continue;
      if (!curved && sheets.size() > 1) continue;  // planes that cross
      if (pieces.size() > 1 && cross_at_edge(pieces)) continue;
      Piece curve = curve_between(place, edge.first, edge.second);
      curve.in_sheets.assign(sheets.begin(), sheets.end());
      curve.patch = of(0).patch;
      for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Piece& piece = of(i);
        if (piece.kind != Piece::Kind::cell) continue;
        curve.surface = piece.surface;
        const std::size_t a = pieces[i].second, b = (a + 1) % piece.corner_count;
        const bool ahead = piece.points[a] == edge.first;
        for (std::size_t k = 0; k < 2; ++k) {
          curve.side[0][k] = piece.at[ahead ? a : b][k];
          curve.side[1][k] = piece.at[ahead ? b : a][k];
        }
        curve.patch = piece.patch;
        if (piece.column && piece.at[a][piece.column->around] != piece.at[b][piece.column->around])
          curve.column = piece.column;
        break;
      }
      // Ends of segments are exact.
      const std::vector<RationalPoint>& exact = out_.points_.at(place.leaf);
      if (place.mould.rulings && is_zero(cross(exact[edge.second] - exact[edge.first],
                                               place.transform.apply_to_vector(*place.mould.rulings))))
        curve.surface = nullptr;
      // One number along a line of parameters of the patch, or for a straight edge.
      if (curve.surface != nullptr) {
        const bool on_u = curve.side[0][0].inf() == curve.side[1][0].inf();
        const double fixed = on_u ? curve.side[0][0].inf() : curve.side[0][1].inf();
        curve.sheet =
            numbered(curves_, {static_cast<double>(place.leaf.index()), double(curve.patch), double(on_u), fixed});
      } else {
        curve.sheet = next_++;
      }
      out_.pieces_.push_back(std::move(curve));
    }
  }

  /// True if all pieces at an edge are proven to meet there at an angle, two by two.
  bool cross_at_edge(const std::vector<std::pair<std::uint32_t, std::uint8_t>>& pieces) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const bool flat = out_.pieces_[pieces[i].first].kind == Piece::Kind::flat;
        const auto& [cell, side] = pieces[flat ? j : i];
        const auto& [other, of_other] = pieces[flat ? i : j];
        if (!at_angle(out_.pieces_[cell], side, out_.pieces_[other], of_other)) return false;
        out_.at_angle_.emplace(std::minmax(cell, other));
      }
    }
    return true;
  }
  /// True if two pieces are proven to be at an angle all along a side.
  bool at_angle(const Piece& cell, std::size_t side, const Piece& other, std::size_t of_other) {
    if (cell.kind == Piece::Kind::flat) return independent(cell.normal, other.normal);
    const PiecePart part = part_of(out_.pieces_, other,
                                   other.kind == Piece::Kind::flat ? other.range : range_of_side(other, of_other));
    return !cell.blind && !part.blind && at_angle(cell, range_of_side(cell, side), part.cone, kHalvedAlongSide);
  }
  bool at_angle(const Piece& cell, const std::array<Interval, 2>& side, const Interval3& normals, int halved) {
    const PiecePart part = part_of(out_.pieces_, cell, side);
    if (!part.blind && independent(part.cone, normals)) return true;
    if (halved == 0) return false;
    const std::size_t way = side[0].inf() < side[0].sup() ? 0 : 1;
    return std::ranges::all_of(
        halves(out_.pieces_, part, way, Between::facets_and_surfaces),
        [&](const PiecePart& half) { return at_angle(cell, half.range, normals, halved - 1); });
  }

  /// Of a curved wire; null for a straight one.
  std::shared_ptr<const Curve> curve_of(const Place& place, std::uint32_t wire) {
    if (!place.mould.surfaces || place.mould.surfaces->curve(wire) == nullptr) return nullptr;
    auto& made = wire_curves_[{place.leaf, wire}];
    if (!made) {
      const auto moved_all = moved([&] { return place.mould.surfaces; }, place.transform)();
      made = moved_all->curves().at(wire);
      kept_.push_back(moved_all);
    }
    return made;
  }
  void add_wire(Place& place, const Mould::Wire& wire) {
    Piece curve = curve_between(place, wire.points[0], wire.points[1]);
    curve.patch = wire.number;
    if ((curve.curve = curve_of(place, wire.number))) {
      curve.side[0][0] = wire.at[0];
      curve.side[1][0] = wire.at[1];
      curve.sheet = numbered(curves_, {static_cast<double>(place.leaf.index()), double(wire.number), 2, 0});
    } else {
      curve.sheet = next_++;
    }
    out_.pieces_.push_back(std::move(curve));
  }
  /// A curve of one point: along nothing, so that all that meets it does so at no angle.
  void add_point(Place& place, std::uint32_t p) {
    out_.pieces_.push_back(curve_between(place, p, p));
    out_.pieces_.back().sheet = next_++;
  }
  static Piece curve_between(const Place& place, std::uint32_t a, std::uint32_t b) {
    Piece curve{.kind = Piece::Kind::curve, .leaf = place.leaf, .points{a, b}};
    curve.corners = {place.points[a], place.points[b]};
    curve.range = {Interval(0, 1), 0};
    curve.along_u = difference(curve.corners[1], curve.corners[0]);
    return curve;
  }

  /// Pieces of one curve that share an end.
  void join_curves(std::size_t first) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> ends;
    std::vector<Piece>& all = out_.pieces_;
    for (std::size_t i = first; i < all.size(); ++i) {
      if (all[i].kind != Piece::Kind::curve) continue;
      for (std::size_t k = 0; k < 2; ++k) ends[{all[i].sheet, all[i].points[k]}].push_back(std::uint32_t(i));
    }
    for (std::size_t i = first; i < all.size(); ++i) {
      if (all[i].kind != Piece::Kind::curve) continue;
      for (std::size_t k = 0; k < 2; ++k) {
        for (const std::uint32_t j : ends[{all[i].sheet, all[i].points[k]}]) {
          if (j != i) all[i].neighbours.emplace_back(j, std::uint8_t(1u << k));
        }
      }
    }
  }

  void add_unbounded(const std::vector<LeafInstance>& instances, std::span<const RationalPoint> reach) {
    if (std::ranges::none_of(instances, [](const LeafInstance& i) { return i.leaf->unbounded(); })) return;
    const Soup soup = [&] {
      const enclosure::RoundNearest nearest;
      return make_soup(instances, reach);
    }();
    for (const SourceId f : IdRange<SourceId>(soup.face_count())) {
      const LeafId leaf = soup.face(f).leaf;
      if (leaf.index() >= instances.size() || !instances[leaf.index()].leaf->unbounded()) continue;
      std::vector<RationalPoint>& corners = out_.points_[leaf];
      for (const PointId p : soup.corners(f)) corners.push_back(exact_value(soup, p));
      Piece piece;
      piece.kind = Piece::Kind::flat;
      piece.leaf = leaf;
      set_plane(piece, cross(corners[1] - corners[0], corners[2] - corners[0]), corners[0]);
      Interval3 all = piece.point;
      for (const RationalPoint& p : corners) all = hull(all, enclose3(p));
      piece.box = box_of(all);
      out_.pieces_.push_back(std::move(piece));
    }
  }

  Pieces& out_;
  const PlacedLeaves& leaves_;
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> sheets_;
  std::map<std::array<Rational, 4>, std::uint32_t> planes_;  // a x + b y + c z + d = 0
  std::map<std::array<double, 4>, std::uint32_t> curves_;
  std::map<std::pair<LeafId, std::uint32_t>, std::shared_ptr<const Curve>> wire_curves_;
  std::vector<std::shared_ptr<const LeafSurfaces>> kept_;
  std::vector<Place> places_;
  std::uint32_t next_ = 1;
};

Pieces::Pieces(const PlacedLeaves& leaves, std::span<const RationalPoint> reach, Moulds& moulds,
               bool of_themselves) {
  // Leaves are drawn once more, for that with numbers rounded to nearest.
  for (const LeafInstance& one : leaves.instances) {
    if (!one.leaf->unbounded()) moulds.of(one.leaf);
  }
  {
    const enclosure::RoundOutward outward;
    PieceMaker(*this, leaves, reach, moulds, of_themselves);
  }
  for_each_index(
      pieces_.size(),
      [&](std::size_t i) {
        Piece& piece = pieces_[i];
        if (piece.kind == Piece::Kind::flat) return;
        const enclosure::RoundOutward outward;
        piece.box = box_of(part_of(pieces_, piece, piece.range).box);
      },
      256);
}

}  // namespace cnrg
