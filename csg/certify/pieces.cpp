// From soups and parameters to pieces; see the header.
#include "csg/certify/pieces.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>

#include "csg/leaves/geometry_leaf.h"
#include "csg/leaves/parameters.h"
#include "kernel/base/error.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {

using namespace surface_math;

namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

Interval hull(const Interval& a, const Interval& b) {
  return {std::min(a.inf(), b.inf()), std::max(a.sup(), b.sup())};
}
Interval3 hull(const Interval3& a, const Interval3& b) {
  return {hull(a[0], b[0]), hull(a[1], b[1]), hull(a[2], b[2])};
}
Interval3 enclose3(const RationalPoint& p) { return {enclose(p[0]), enclose(p[1]), enclose(p[2])}; }
bool holds_zero(const Interval3& x) {
  return std::all_of(x.begin(), x.end(), [](const Interval& c) { return c.inf() <= 0 && c.sup() >= 0; });
}
Box box_of(const Interval3& x) {
  Box box;
  for (std::size_t k = 0; k < 3; ++k) box.lo[k] = x[k].inf(), box.hi[k] = x[k].sup();
  return box;
}

/// Numbers of exact points, equal for equal ones.
class PointNumbers {
 public:
  std::uint32_t of(const RationalPoint& p) {
    std::vector<std::uint32_t>& same = by_doubles_[key(p)];
    for (const std::uint32_t i : same) {
      if (points_[i] == p) return i;
    }
    same.push_back(static_cast<std::uint32_t>(points_.size()));
    points_.push_back(p);
    return same.back();
  }
  const std::vector<RationalPoint>& points() const { return points_; }

 private:
  static std::size_t key(const RationalPoint& p) {
    std::size_t h = 0;
    for (const double x : to_doubles(p)) h = h * 1000003u + std::hash<double>()(x == 0 ? 0.0 : x);
    return h;
  }
  std::unordered_map<std::size_t, std::vector<std::uint32_t>> by_doubles_;
  std::vector<RationalPoint> points_;
};

/// A prepared leaf, before any transform, with the numbers of its points.
struct Mould {
  struct Cell {
    std::uint32_t patch = 0;
    std::vector<std::uint32_t> points;
    std::vector<std::array<Interval, 2>> at;
  };
  struct Flat {
    std::uint32_t patch = 0;
    std::vector<std::vector<std::uint32_t>> loops;
  };
  struct Wire {
    std::uint32_t number = 0;
    std::array<std::uint32_t, 2> points{};
    std::array<Interval, 2> at{0, 0};
  };
  PointNumbers numbers;
  std::vector<Cell> cells;
  std::vector<Flat> flats;
  std::vector<Wire> wires;
  std::vector<std::uint32_t> isolated;
  std::shared_ptr<const LeafSurfaces> surfaces;

  explicit Mould(const PreparedLeaf& leaf) {
    Soup soup;
    leaf.add_to(soup, Transform());
    if (leaf.surfaces()) surfaces = leaf.surfaces()();
    std::shared_ptr<const LeafParameters> parameters;
    if (surfaces && leaf.parameters()) parameters = leaf.parameters()();
    std::vector<std::uint32_t> number(soup.point_count(), kNone);
    const auto number_of = [&](PointId p) {
      std::uint32_t& n = number[p.index()];
      if (n == kNone) n = numbers.of(exact_value(soup, p));
      return n;
    };
    for (const SourceId f : IdRange<SourceId>(soup.face_count())) {
      const std::uint32_t patch = soup.face(f).patch;
      if (surfaces && surfaces->patch(patch) != nullptr) {
        for (const std::vector<PatchCorner>& corners : parameters->cells(f.index())) {
          Cell& cell = cells.emplace_back();
          cell.patch = patch;
          for (const PatchCorner& corner : corners) {
            cell.points.push_back(numbers.of(corner.point));
            cell.at.push_back({enclose(corner.at[0]), enclose(corner.at[1])});
          }
        }
        continue;
      }
      Flat& flat = flats.emplace_back();
      flat.patch = patch;
      flat.loops.emplace_back();
      for (const PointId p : soup.corners(f)) {
        if (p.valid()) flat.loops.back().push_back(number_of(p));
        else flat.loops.emplace_back();
      }
    }
    std::size_t i = 0;
    for (const Soup::Wire& wire : soup.wires()) {
      Wire one{wire.leaf_edge, {number_of(wire.a), number_of(wire.b)}};
      if (parameters && surfaces->curve(wire.leaf_edge) != nullptr) {
        const LeafParameters::Wire known = parameters->wire(i);
        one.points = {numbers.of(known.ends[0]), numbers.of(known.ends[1])};
        one.at = {enclose(known.at[0]), enclose(known.at[1])};
      }
      wires.push_back(one);
      ++i;
    }
    for (const Soup::Isolated& one : soup.isolated()) isolated.push_back(number_of(one.point));
  }
};

/// a x + b y + c z + d = 0, the first that is not zero 1.
using PlaneKey = std::array<Rational, 4>;
PlaneKey plane_key(const RationalPoint& normal, const RationalPoint& on) {
  PlaneKey key{normal[0], normal[1], normal[2], Rational(-dot(normal, on))};
  const Rational first = key[0] != 0 ? key[0] : key[1] != 0 ? key[1] : key[2];
  for (Rational& x : key) x /= first;
  return key;
}

}  // namespace

class PieceMaker {
 public:
  PieceMaker(Pieces& out, const PlacedLeaves& leaves, std::span<const RationalPoint> reach)
      : out_(out), leaves_(leaves) {
    const std::vector<LeafInstance>& instances = leaves.instances;
    for (std::size_t i = 0; i < instances.size(); ++i) {
      const PreparedLeaf* leaf = instances[i].leaf.get();
      if (leaf->unbounded()) continue;
      auto [it, fresh] = moulds_.try_emplace(leaf);
      if (fresh) it->second = std::make_unique<Mould>(*leaf);
      add(LeafId(i), *it->second, instances[i].transform);
    }
    add_unbounded(instances, reach);
    for (const auto& [plane, sheet] : planes_) out_.planes_[sheet] = plane;
    for (const auto& [key, sheet] : sheets_) {
      const auto it = leaves.quadrics.find(key[1]);
      if (key[0] == 0 && it != leaves.quadrics.end()) out_.quadrics_[sheet] = it->second;
    }
  }

 private:
  using Edge = std::pair<std::uint32_t, std::uint32_t>;
  struct Place {
    LeafId leaf;
    const Transform& transform;
    const Mould& mould;
    std::vector<Interval3> points;
    std::map<Edge, std::vector<std::pair<std::uint32_t, std::uint8_t>>> sides;  // pieces, and side of the piece
  };

  std::uint32_t sheet_of(LeafId leaf, std::uint32_t patch) {
    const std::vector<std::uint32_t>* known = leaves_.surfaces.empty() ? nullptr : &leaves_.surfaces[leaf.index()];
    const std::uint32_t number = known != nullptr && patch < known->size() ? (*known)[patch] : 0;
    if (number != 0) return sheet_number({0, number, 0});
    return sheet_number({1, static_cast<std::uint32_t>(leaf.index()), patch});
  }
  std::uint32_t sheet_number(const std::array<std::uint32_t, 3>& key) {
    return sheets_.try_emplace(key, next_).second ? next_++ : sheets_[key];
  }
  std::uint32_t sheet_of(const PlaneKey& key) {
    const auto [it, fresh] = planes_.try_emplace(key, next_);
    if (fresh) ++next_;
    return it->second;
  }

  void add(LeafId leaf, const Mould& mould, const Transform& transform) {
    Place place{leaf, transform, mould, {}, {}};
    const bool identity = transform.identity();
    exact_.clear();
    for (const RationalPoint& p : mould.numbers.points()) {
      if (identity) {
        place.points.push_back(enclose3(p));
      } else {
        exact_.push_back(transform.apply(p));
        place.points.push_back(enclose3(exact_.back()));
      }
    }
    if (identity) exact_ = mould.numbers.points();
    out_.points_[leaf] = exact_;
    const std::size_t first = out_.pieces_.size();
    if (mould.surfaces) {
      out_.leaf_surfaces_.push_back(mould.surfaces);
      for (const auto& [patch, form] : mould.surfaces->forms()) {
        if (form.surface.kind != CadSurface::Kind::plane && mould.surfaces->patch(patch) == nullptr)
          out_.unknown_.insert(leaf);
      }
    }
    for (const Mould::Cell& cell : mould.cells) add_cell(place, cell);
    for (const Mould::Flat& flat : mould.flats) add_flat(place, flat);
    find_neighbours(first);
    add_curves(place);
    for (const Mould::Wire& wire : mould.wires) add_wire(place, wire);
    for (const std::uint32_t p : mould.isolated) add_point(place, p);
    join_curves(first);
  }

  void add_cell(Place& place, const Mould::Cell& cell) {
    Piece piece;
    piece.leaf = place.leaf;
    piece.patch = cell.patch;
    piece.sheet = sheet_of(place.leaf, cell.patch);
    auto& surface = out_.placed_[{place.leaf, cell.patch}];
    if (!surface) surface = std::make_unique<PlacedSurface>(place.mould.surfaces, cell.patch, place.transform);
    piece.surface = surface.get();
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
    derive(piece);
    measure_turn(piece);
    const auto number = static_cast<std::uint32_t>(out_.pieces_.size());
    for (std::size_t i = 0; i < cell.points.size(); ++i)
      add_side(place, cell.points[i], cell.points[(i + 1) % cell.points.size()], number, i);
    out_.pieces_.push_back(std::move(piece));
  }

  static void measure_turn(Piece& piece) {
    const double u0 = piece.range[0].inf(), u1 = piece.range[0].sup(), v0 = piece.range[1].inf(),
                 v1 = piece.range[1].sup();
    const auto normal = [&](double u, double v) {
      const Vector3<double> n = piece.surface->at(u, v).normal;
      const double length = std::sqrt(dot(n, n));
      return length > 0 ? scaled(1 / length, n) : n;
    };
    const auto turn = [](const Vector3<double>& a, const Vector3<double>& b) {
      const Vector3<double> way = difference(a, b);
      return std::sqrt(dot(way, way));
    };
    const double u = (u0 + u1) / 2, v = (v0 + v1) / 2;
    piece.turn = {turn(normal(u0, v), normal(u1, v)), turn(normal(u, v0), normal(u, v1))};
  }

  static void add_side(Place& place, std::uint32_t a, std::uint32_t b, std::uint32_t piece, std::size_t side) {
    if (a != b) place.sides[std::minmax(a, b)].emplace_back(piece, static_cast<std::uint8_t>(side));
  }

  /// The derivatives of F by u and v, from its corners.
  static void derive(Piece& piece) {
    const auto way = [&](std::size_t a, std::size_t b) {
      return difference(piece.corners[b], piece.corners[a]);
    };
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
      return no_first ? q : no_second ? p : hull(p, q);
    };
    Interval3& x = first == 0 ? piece.along_u : piece.along_v;
    Interval3& y = first == 0 ? piece.along_v : piece.along_u;
    x = along(0, 1, 3, 2, first);
    y = along(1, 2, 0, 3, second);
  }

  void add_flat(Place& place, const Mould::Flat& flat) {
    const std::vector<std::uint32_t>& outer = flat.loops[0];
    RationalPoint normal{0, 0, 0};
    for (std::size_t i = 1; i + 1 < outer.size() && is_zero(normal); ++i)
      normal = cross(exact_[outer[i]] - exact_[outer[0]], exact_[outer[i + 1]] - exact_[outer[0]]);
    if (is_zero(normal)) return;
    Piece piece;
    piece.kind = Piece::Kind::flat;
    piece.leaf = place.leaf;
    piece.patch = flat.patch;
    piece.sheet = sheet_of(plane_key(normal, exact_[outer[0]]));
    piece.normal = enclose3(normal);
    piece.point = place.points[outer[0]];
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
    const auto number = static_cast<std::uint32_t>(out_.pieces_.size());
    for (const auto& loop : flat.loops) {
      for (std::size_t i = 0; i < loop.size(); ++i)
        add_side(place, loop[i], loop[(i + 1) % loop.size()], number, i);
    }
    out_.pieces_.push_back(std::move(piece));
  }
  /// Half-planes that hold the face, also where it ends in a curve of a patch.
  void add_limits(const Place& place, Piece& piece, const std::vector<std::uint32_t>& outer) {
    constexpr std::size_t kMost = 16;
    std::vector<PiecePart> rims;
    for (std::size_t i = 0; i < outer.size(); ++i) {
      const auto it = place.sides.find(std::minmax(outer[i], outer[(i + 1) % outer.size()]));
      if (it == place.sides.end()) continue;
      for (const auto& [number, side] : it->second) {
        const Piece& cell = out_.pieces_[number];
        if (cell.kind == Piece::Kind::cell) rims.push_back(part_of(out_.pieces_, cell, range_of_side(cell, side)));
      }
    }
    Interval3 all{Interval(piece.box.lo[0], piece.box.hi[0]), Interval(piece.box.lo[1], piece.box.hi[1]),
                  Interval(piece.box.lo[2], piece.box.hi[2])};
    for (const PiecePart& rim : rims) all = hull(all, rim.box);
    piece.box = box_of(all);
    const std::size_t step = (outer.size() + kMost - 1) / kMost;
    for (std::size_t i = 0; i < outer.size(); i += step) {
      const Interval3& from = place.points[outer[i]];
      Vector3<double> out = cross(middle_of(difference(place.points[outer[(i + 1) % outer.size()]], from)),
                                  middle_of(piece.normal));
      const double length = std::sqrt(dot(out, out));
      if (!(length > 0) || !std::isfinite(length)) continue;
      out = scaled(1 / length, out);
      const Interval3 along{Interval(out[0]), Interval(out[1]), Interval(out[2])};
      Interval wide = dot(along, from);
      for (const std::uint32_t p : outer) wide = hull(wide, dot(along, place.points[p]));
      for (const PiecePart& rim : rims) wide = hull(wide, extent(rim, out, Between::facets_and_surfaces));
      piece.limits.emplace_back(out, wide);
    }
  }
  static std::array<Interval, 2> range_of_side(const Piece& cell, std::size_t side) {
    std::array<Interval, 2> range;
    const std::size_t next = (side + 1) % cell.corner_count;
    for (std::size_t k = 0; k < 2; ++k) range[k] = hull(Interval(cell.at[side][k]), Interval(cell.at[next][k]));
    return range;
  }

  /// Cells of one patch that share corners.
  void find_neighbours(std::size_t first) {
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> at_point;
    std::vector<Piece>& all = out_.pieces_;
    for (std::size_t i = first; i < all.size() && all[i].kind == Piece::Kind::cell; ++i) {
      for (std::size_t k = 0; k < all[i].corner_count; ++k) at_point[all[i].points[k]].push_back(std::uint32_t(i));
    }
    for (std::size_t i = first; i < all.size() && all[i].kind == Piece::Kind::cell; ++i) {
      std::map<std::uint32_t, std::uint8_t> found;
      for (std::size_t k = 0; k < all[i].corner_count; ++k) {
        for (const std::uint32_t j : at_point[all[i].points[k]]) {
          if (j != i && all[j].patch == all[i].patch) found[j] |= std::uint8_t(1u << k);
        }
      }
      all[i].neighbours.assign(found.begin(), found.end());
    }
  }

  /// Edges of cells that are not between two cells of one patch, nor where a cell and one other piece cross at an
  /// angle: borders of surfaces, and where one patch goes on smoothly as another.
  void add_curves(Place& place) {
    const enclosure::RoundOutward outward;
    for (const auto& [edge, pieces] : place.sides) {
      std::vector<Piece>& all = out_.pieces_;
      const auto of = [&](std::size_t i) -> const Piece& { return all[pieces[i].first]; };
      const bool curved = std::ranges::any_of(
          pieces, [&](const auto& p) { return all[p.first].kind == Piece::Kind::cell; });
      std::set<std::uint32_t> sheets;
      for (const auto& p : pieces) sheets.insert(all[p.first].sheet);
      if (pieces.size() == 2 && of(0).patch == of(1).patch && of(0).kind == of(1).kind) continue;
      if (!curved && pieces.size() > 1) continue;  // planes that cross; coplanar ones are one
      if (pieces.size() > 1 && cross_at_edge(pieces)) continue;
      Piece curve;
      curve.kind = Piece::Kind::curve;
      curve.leaf = place.leaf;
      curve.points = {edge.first, edge.second};
      curve.corners = {place.points[edge.first], place.points[edge.second]};
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
        break;
      }
      // One number along a line of parameters of the patch, or for a straight edge.
      if (curve.surface != nullptr) {
        const bool on_u = curve.side[0][0].inf() == curve.side[1][0].inf();
        const double fixed = on_u ? curve.side[0][0].inf() : curve.side[0][1].inf();
        curve.sheet = curve_number({static_cast<double>(place.leaf.index()), double(curve.patch), double(on_u), fixed});
      } else {
        curve.sheet = next_++;
      }
      finish_curve(std::move(curve));
    }
  }

  /// True if all pieces at an edge are proven to meet there at an angle, two by two.
  bool cross_at_edge(const std::vector<std::pair<std::uint32_t, std::uint8_t>>& pieces) {
    const std::vector<Piece>& all = out_.pieces_;
    std::vector<Interval3> cones;
    for (const auto& [number, side] : pieces) {
      const Piece& piece = all[number];
      if (piece.kind == Piece::Kind::flat) {
        cones.push_back(piece.normal);
        continue;
      }
      if (piece.blind) return false;
      const PiecePart part = part_of(all, piece, range_of_side(piece, side));
      if (part.blind) return false;
      cones.push_back(part.cone);
    }
    for (std::size_t i = 0; i < cones.size(); ++i) {
      for (std::size_t j = i + 1; j < cones.size(); ++j) {
        if (holds_zero(cross(cones[i], cones[j]))) return false;
      }
    }
    return true;
  }

  void add_wire(Place& place, const Mould::Wire& wire) {
    Piece curve;
    curve.kind = Piece::Kind::curve;
    curve.leaf = place.leaf;
    curve.patch = wire.number;
    curve.points = {wire.points[0], wire.points[1]};
    curve.corners = {place.points[wire.points[0]], place.points[wire.points[1]]};
    if (place.mould.surfaces && place.mould.surfaces->curve(wire.number) != nullptr) {
      auto& made = wire_curves_[{place.leaf, wire.number}];
      if (!made) {
        const auto moved_all = moved([&] { return place.mould.surfaces; }, place.transform)();
        made = moved_all->curves().at(wire.number);
        kept_.push_back(moved_all);
      }
      curve.curve = made;
      curve.side[0][0] = wire.at[0];
      curve.side[1][0] = wire.at[1];
      curve.sheet = curve_number({static_cast<double>(place.leaf.index()), double(wire.number), 2, 0});
    } else {
      curve.sheet = next_++;
    }
    finish_curve(std::move(curve));
  }
  /// A curve of one point: along nothing, so that all that meets it does so at no angle.
  void add_point(Place& place, std::uint32_t p) {
    Piece point;
    point.kind = Piece::Kind::curve;
    point.leaf = place.leaf;
    point.points = {p, p};
    point.corners = {place.points[p], place.points[p]};
    point.sheet = next_++;
    finish_curve(std::move(point));
  }
  void finish_curve(Piece curve) {
    curve.range = {Interval(0, 1), 0};
    curve.along_u = difference(curve.corners[1], curve.corners[0]);
    out_.pieces_.push_back(std::move(curve));
  }
  std::uint32_t curve_number(const std::array<double, 4>& key) {
    const auto [it, fresh] = curves_.try_emplace(key, next_);
    if (fresh) ++next_;
    return it->second;
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
    const Soup soup = make_soup(instances, reach);
    for (const SourceId f : IdRange<SourceId>(soup.face_count())) {
      const LeafId leaf = soup.face(f).leaf;
      if (leaf.index() >= instances.size() || !instances[leaf.index()].leaf->unbounded()) continue;
      std::vector<RationalPoint>& corners = out_.points_[leaf];
      for (const PointId p : soup.corners(f)) corners.push_back(exact_value(soup, p));
      Piece piece;
      piece.kind = Piece::Kind::flat;
      piece.leaf = leaf;
      const RationalPoint normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
      piece.sheet = sheet_of(plane_key(normal, corners[0]));
      piece.normal = enclose3(normal);
      piece.point = enclose3(corners[0]);
      Interval3 all = piece.point;
      for (const RationalPoint& p : corners) all = hull(all, enclose3(p));
      piece.box = box_of(all);
      out_.pieces_.push_back(std::move(piece));
    }
  }

  Pieces& out_;
  const PlacedLeaves& leaves_;
  std::map<const PreparedLeaf*, std::unique_ptr<Mould>> moulds_;
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> sheets_;
  std::map<PlaneKey, std::uint32_t> planes_;
  std::map<std::array<double, 4>, std::uint32_t> curves_;
  std::map<std::pair<LeafId, std::uint32_t>, std::shared_ptr<const Curve>> wire_curves_;
  std::vector<std::shared_ptr<const LeafSurfaces>> kept_;
  std::vector<RationalPoint> exact_;
  std::uint32_t next_ = 1;
};

Pieces::Pieces(const PlacedLeaves& leaves, std::span<const RationalPoint> reach) {
  {
    const enclosure::RoundOutward outward;
    PieceMaker(*this, leaves, reach);
  }
  const enclosure::RoundOutward outward;
  for (Piece& piece : pieces_) {
    if (piece.kind != Piece::Kind::flat) piece.box = box_of(part_of(pieces_, piece, piece.range).box);
  }
}

namespace {

std::span<const std::uint32_t> corner_numbers(const Piece& piece) {
  if (piece.kind == Piece::Kind::flat) return piece.corner_numbers;
  return {piece.points.data(), piece.kind == Piece::Kind::curve ? 2u : piece.corner_count};
}
bool has_corner(const Piece& piece, std::uint32_t number) {
  const auto numbers = corner_numbers(piece);
  return piece.kind == Piece::Kind::flat ? std::binary_search(numbers.begin(), numbers.end(), number)
                                         : std::find(numbers.begin(), numbers.end(), number) != numbers.end();
}

}  // namespace

bool Pieces::adjacent(std::uint32_t a, std::uint32_t b) const {
  return std::ranges::any_of(corner_numbers(pieces_[a]), [&](std::uint32_t p) { return has_corner(pieces_[b], p); });
}

std::array<Interval, 2> Pieces::range_beside(std::uint32_t cell, std::uint32_t other) const {
  const Piece& piece = pieces_[cell];
  std::array<Interval, 2> range = piece.range;
  bool any = false;
  for (std::size_t i = 0; i < piece.corner_count; ++i) {
    if (!has_corner(pieces_[other], piece.points[i])) continue;
    for (std::size_t k = 0; k < 2; ++k) range[k] = any ? hull(range[k], Interval(piece.at[i][k])) : piece.at[i][k];
    any = true;
  }
  return range;
}

void Pieces::join(std::uint32_t a, std::uint32_t b) {
  for (const auto& [x, y] : {std::pair(a, b), std::pair(b, a)}) {
    if (pieces_[x].kind == Piece::Kind::cell) pieces_[x].foreign.push_back(y);
  }
}

const RationalPoint& Pieces::corner(std::uint32_t piece, std::size_t k) const {
  return points_.at(pieces_[piece].leaf)[pieces_[piece].points[k]];
}

RationalPoint Pieces::normal_of(std::uint32_t cell) const {
  const RationalPoint& first = corner(cell, 0);
  const RationalPoint normal = cross(corner(cell, 1) - first, corner(cell, 2) - first);
  if (!is_zero(normal)) return normal;
  return cross(corner(cell, 2) - first, corner(cell, pieces_[cell].corner_count - 1u) - first);
}

PlaneEquation Pieces::equation_of(std::uint32_t piece) const {
  if (pieces_[piece].kind == Piece::Kind::flat) return planes_.at(pieces_[piece].sheet);
  const RationalPoint normal = normal_of(piece);
  return {normal[0], normal[1], normal[2], Rational(-dot(normal, corner(piece, 0)))};
}

/// True if one of the points is in the closed hull of the corners of a piece, which are in one plane with it.
bool Pieces::holds(std::uint32_t piece, const std::vector<const RationalPoint*>& points) const {
  const RationalPoint normal = normal_of(piece);
  const std::size_t n = pieces_[piece].corner_count;
  return std::ranges::any_of(points, [&](const RationalPoint* p) {
    int seen = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const RationalPoint& from = corner(piece, k);
      const int side = sgn(dot(normal, cross(corner(piece, (k + 1) % n) - from, *p - from)));
      seen |= side > 0 ? 1 : side < 0 ? 2 : 0;
    }
    return seen != 3 && dot(normal, *p - corner(piece, 0)) == 0;
  });
}

int Pieces::sides(const PlaneEquation& equation, std::uint32_t of, std::vector<const RationalPoint*>& on) const {
  int result = 0;
  for (std::size_t k = 0; k < pieces_[of].corner_count; ++k) {
    const RationalPoint& p = corner(of, k);
    const int side = sgn(equation[0] * p[0] + equation[1] * p[1] + equation[2] * p[2] + equation[3]);
    result |= side > 0 ? 1 : side < 0 ? 2 : 0;
    if (side == 0) on.push_back(&p);
  }
  return result;
}

bool Pieces::drawn_alike(std::uint32_t a, std::uint32_t b) const {
  std::vector<const RationalPoint*> on;
  return sides(equation_of(a), b, on) != 3 || sides(equation_of(b), a, on) != 3;
}

const std::optional<Contact>& Pieces::contact_of(std::uint32_t sheet, std::uint32_t other) {
  const auto [it, fresh] = contacts_.try_emplace(std::minmax(sheet, other));
  if (!fresh) return it->second;
  const auto first = quadrics_.find(sheet), second = quadrics_.find(other);
  const auto plane = planes_.find(first == quadrics_.end() ? sheet : other);
  if (first != quadrics_.end() && second != quadrics_.end()) it->second = contact(first->second, second->second);
  else if ((first != quadrics_.end() || second != quadrics_.end()) && plane != planes_.end())
    it->second = contact(plane->second, (first != quadrics_.end() ? first : second)->second);
  return it->second;
}

namespace {

Rational row_times(const Quadric& q, std::size_t row, const RationalPoint& p) {
  return q[row][0] * p[0] + q[row][1] * p[1] + q[row][2] * p[2] + q[row][3];
}
RationalPoint gradient(const Quadric& q, const RationalPoint& p) {
  return {row_times(q, 0, p), row_times(q, 1, p), row_times(q, 2, p)};
}

}  // namespace

bool Pieces::on_true_side(std::uint32_t plane, std::uint32_t of, const Contact& contact) const {
  const Quadric& q = quadrics_.at(pieces_[plane].sheet);
  const RationalPoint& at = corner(plane, 0);
  const RationalPoint normal = normal_of(plane);
  const int turned = sgn(dot(normal, gradient(q, at)));
  for (std::size_t k = 0; k < pieces_[of].corner_count; ++k) {
    const RationalPoint& p = corner(of, k);
    if (contact.has(p)) continue;  // on both surfaces, but for what is rounded
    const int of_facet = sgn(dot(normal, p - at));
    const int of_surface = sgn(dot(p, gradient(q, p)) + row_times(q, 3, p));
    if (of_facet != 0 && of_facet * turned != of_surface) return false;
  }
  return turned != 0;
}

// The plane through the contact and at right angles to the surfaces has the cell on one side, as far as it is near.
bool Pieces::along_border(std::uint32_t cell, std::uint32_t other, const Contact& contact) const {
  if (contact.kind == Contact::Kind::point) return true;
  RationalPoint normal = contact.direction;
  if (contact.kind == Contact::Kind::line) {
    const auto quadric = quadrics_.find(pieces_[cell].sheet);
    const RationalPoint out = gradient(quadric != quadrics_.end() ? quadric->second : quadrics_.at(pieces_[other].sheet),
                                       contact.point);
    // The plane of the facet's pole, if the contact passes through it, and its two sides from there.
    for (std::size_t k = 0; k < pieces_[cell].corner_count; ++k) {
      const std::size_t n = pieces_[cell].corner_count, next = (k + 1) % n;
      if (pieces_[cell].points[k] != pieces_[cell].points[next] || !contact.has(corner(cell, k))) continue;
      const RationalPoint& pole = corner(cell, k);
      const RationalPoint first = corner(cell, (next + 1) % n) - pole, second = corner(cell, (k + n - 1) % n) - pole,
                          across = cross(first, second);
      RationalPoint way = contact.direction;
      if (dot(way, first + second) < 0) way = Rational(-1) * way;
      // way = x first + y second + z across
      const Rational x = dot(cross(way, second), across), y = dot(cross(first, way), across);
      return !(x > 0 && y > 0);
    }
    normal = cross(contact.direction, out);
    if (is_zero(normal)) return false;  // at the apex of a cone
  }
  std::vector<const RationalPoint*> on;
  return sides({normal[0], normal[1], normal[2], Rational(-dot(normal, contact.point))}, cell, on) != 3;
}

// A plane that has all of one on one side and all of the other on the other side: that of one of them, or where
// surfaces touch from outside, the one in which both are tangent.
Pieces::Meeting Pieces::facets_meet(std::uint32_t a, std::uint32_t b, const Contact& contact) const {
  const auto at_contact = [&](const std::vector<const RationalPoint*>& on) {
    return std::ranges::all_of(on, [&](const RationalPoint* p) { return contact.has(*p); });
  };
  for (const auto& [plane, of] : {std::pair(a, b), std::pair(b, a)}) {
    if (pieces_[of].kind == Piece::Kind::flat) continue;
    std::vector<const RationalPoint*> on;
    const int side = sides(equation_of(plane), of, on);
    if (side == 3 || side == 0 || !at_contact(on)) continue;
    if (pieces_[plane].kind == Piece::Kind::cell && !on_true_side(plane, of, contact)) continue;
    // What is not flat has the common points as corners, too.
    const bool met = !on.empty() && (pieces_[plane].kind == Piece::Kind::flat || holds(plane, on));
    if (!met) return Meeting::apart;
    return along_border(of, plane, contact) || (pieces_[plane].kind == Piece::Kind::cell && along_border(plane, of, contact))
               ? Meeting::at_contact
               : Meeting::otherwise;
  }
  if (pieces_[a].kind == Piece::Kind::flat || pieces_[b].kind == Piece::Kind::flat ||
      (contact.kind != Contact::Kind::point && contact.kind != Contact::Kind::line))
    return Meeting::otherwise;
  const RationalPoint normal = gradient(quadrics_.at(pieces_[a].sheet), contact.point);
  if (is_zero(normal)) return Meeting::otherwise;
  const PlaneEquation tangent{normal[0], normal[1], normal[2], Rational(-dot(normal, contact.point))};
  std::vector<const RationalPoint*> on_a, on_b;
  const int of_a = sides(tangent, a, on_a), of_b = sides(tangent, b, on_b);
  if (of_a == 0 || of_b == 0 || (of_a | of_b) != 3 || of_a == of_b || !at_contact(on_a) || !at_contact(on_b))
    return Meeting::otherwise;
  if (on_a.empty() || !holds(b, on_a)) return Meeting::apart;
  return along_border(a, b, contact) || along_border(b, a, contact) ? Meeting::at_contact : Meeting::otherwise;
}

namespace {

bool at_apex(const std::vector<Piece>& all, const Piece& piece, const std::array<Interval, 2>& range);

/// Points whose convex hull holds F over a part of a cell.
std::vector<Interval3> facet_corners(const Piece& piece, const std::array<Interval, 2>& range) {
  if (!piece.grid) return {piece.corners.begin(), piece.corners.begin() + piece.corner_count};
  // F is bilinear: its hull is that of its corners.
  const std::size_t first = piece.at[0][0] != piece.at[1][0] ? 0 : 1, second = 1 - first;
  const auto place = [](double x, double from, double to) {
    return (Interval(x) - Interval(from)) / (Interval(to) - Interval(from));
  };
  const auto mix = [](const Interval3& a, const Interval3& b, const Interval& x) {
    return sum(a, scaled(x, difference(b, a)));
  };
  std::vector<Interval3> result;
  for (const double x : {range[first].inf(), range[first].sup()}) {
    const Interval s = place(x, piece.at[0][first], piece.at[1][first]);
    const Interval3 low = mix(piece.corners[0], piece.corners[1], s),
                    high = mix(piece.corners[3], piece.corners[2], s);
    for (const double y : {range[second].inf(), range[second].sup()})
      result.push_back(mix(low, high, place(y, piece.at[0][second], piece.at[3][second])));
  }
  return result;
}

Interval3 facet_box(const Piece& piece, const std::array<Interval, 2>& range) {
  const std::vector<Interval3> corners = facet_corners(piece, range);
  Interval3 all = corners[0];
  for (const Interval3& p : corners) all = hull(all, p);
  if (!piece.grid) {
    if (piece.blind || piece.corner_count != 3) return all;
    const Interval3 affine =
        sum(piece.corners[0], sum(scaled(Interval(range[0] - Interval(piece.at[0][0])), piece.along_u),
                                  scaled(Interval(range[1] - Interval(piece.at[0][1])), piece.along_v)));
    for (std::size_t k = 0; k < 3; ++k) {
      const double low = std::max(all[k].inf(), affine[k].inf()), high = std::min(all[k].sup(), affine[k].sup());
      if (low <= high) all[k] = Interval(low, high);
    }
    return all;
  }
  return all;
}

/// True if a part of the box around a triangle of parameters has no point of it.
bool outside(const Piece& piece, const std::array<Interval, 2>& range) {
  if (piece.grid || piece.corner_count != 3) return false;
  const auto side = [&](std::size_t a, const Interval& u, const Interval& v) {
    const std::size_t b = (a + 1) % 3;
    const Interval du = Interval(piece.at[b][0]) - Interval(piece.at[a][0]),
                   dv = Interval(piece.at[b][1]) - Interval(piece.at[a][1]);
    return du * (v - Interval(piece.at[a][1])) - dv * (u - Interval(piece.at[a][0]));
  };
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t c = (a + 2) % 3;
    const Interval own = side(a, Interval(piece.at[c][0]), Interval(piece.at[c][1])), other = side(a, range[0], range[1]);
    if ((own.inf() > 0 && other.sup() < 0) || (own.sup() < 0 && other.inf() > 0)) return true;
  }
  return false;
}

/// To about length 1.
Interval3 normalized(const Interval3& x) {
  double square = 0;
  for (const Interval& c : x) square += middle_of(c) * middle_of(c);
  if (!(square > 0) || !std::isfinite(square)) return x;
  return scaled(Interval(1 / std::sqrt(square)), x);
}

/// The hull with what F adds.
Interval3 with(const Interval3& facets, const Interval3& surface, Between between) {
  return between == Between::surfaces ? surface : hull(facets, surface);
}

PiecePart curve_part(const std::vector<Piece>& all, const Piece& piece, const std::array<Interval, 2>& range,
                Between between) {
  PiecePart part{&piece, range};
  const Interval& s = range[0];
  const Interval3 chord = sum(piece.corners[0], scaled(s, piece.along_u));
  part.box = chord;
  part.cone = piece.along_u;
  if (piece.surface != nullptr || piece.curve) {
    const Interval du = piece.side[1][0] - piece.side[0][0], dv = piece.side[1][1] - piece.side[0][1];
    Interval3 point, along;
    if (piece.curve) {
      const CurveJet<Interval> jet = piece.curve->over(piece.side[0][0] + s * du);
      point = jet.point;
      along = scaled(du, jet.along);
    } else {
      const SurfaceJet<Interval> jet = piece.surface->over(piece.side[0][0] + s * du, piece.side[0][1] + s * dv);
      point = jet.point;
      along = sum(scaled(du, jet.along_u), scaled(dv, jet.along_v));
    }
    part.box = with(chord, point, between);
    part.cone = with(part.cone, along, between);
    part.along_u = along;
  }
  if (between == Between::surfaces && !piece.exact()) return part;
  for (const auto& [j, bit] : piece.neighbours) {
    const bool touches = bit == 1 ? s.inf() == piece.range[0].inf() : s.sup() == piece.range[0].sup();
    if (!touches) continue;
    // The neighbour goes on from there: against this one if it begins there where this one begins.
    const Piece& other = all[j];
    const bool begins = other.points[0] == piece.points[bit == 1 ? 0 : 1];
    const bool against = begins == (bit == 1);
    part.cone = hull(normalized(part.cone), normalized(against ? scaled(Interval(-1), other.along_u) : other.along_u));
  }
  return part;
}

}  // namespace

PiecePart part_of(const std::vector<Piece>& all, const Piece& piece, const std::array<Interval, 2>& range,
             Between between) {
  if (piece.kind == Piece::Kind::curve) return curve_part(all, piece, range, between);
  PiecePart part{&piece, range};
  if (piece.kind == Piece::Kind::flat) {
    for (std::size_t k = 0; k < 3; ++k) part.box[k] = Interval(piece.box.lo[k], piece.box.hi[k]);
    part.cone = piece.normal;
    return part;
  }
  if (outside(piece, range)) {
    for (Interval& x : part.box) x = Interval(kInfinity);
    return part;
  }
  const SurfaceJet<Interval> jet = piece.surface->over(range[0], range[1]);
  part.along_u = jet.along_u;
  part.along_v = jet.along_v;
  if (between == Between::surfaces) {
    part.box = jet.point;
    part.cone = jet.normal;
    part.blind = holds_zero(jet.normal) || at_apex(all, piece, range);
    return part;
  }
  part.box = hull(facet_box(piece, range), jet.point);
  part.blind = piece.blind || holds_zero(jet.normal);
  if (part.blind) return part;
  Interval3 u = hull(piece.along_u, jet.along_u), v = hull(piece.along_v, jet.along_v);
  if (piece.grid) {  // at a pole along the side that is none
    const std::size_t first = piece.at[0][0] != piece.at[1][0] ? 0 : 1, second = 1 - first;
    const bool low = piece.points[0] == piece.points[1], high = piece.points[3] == piece.points[2];
    const bool left = piece.points[0] == piece.points[3], right = piece.points[1] == piece.points[2];
    const auto at_side = [&](std::size_t fixed, double value) {
      std::array<Interval, 2> line = range;
      line[fixed] = Interval(value);
      const SurfaceJet<Interval> there = piece.surface->over(line[0], line[1]);
      return 1 - fixed == 0 ? there.along_u : there.along_v;
    };
    if (low || high) {
      Interval3& x = first == 0 ? u : v;
      x = hull(first == 0 ? piece.along_u : piece.along_v, at_side(second, piece.at[low ? 3 : 0][second]));
    }
    if (left || right) {
      Interval3& x = second == 0 ? u : v;
      x = hull(second == 0 ? piece.along_u : piece.along_v, at_side(first, piece.at[left ? 1 : 0][first]));
    }
  }
  std::array<bool, 4> corner{};
  std::array<bool, 4> side{};
  const auto on = [&](std::size_t i, std::size_t k) {
    return range[k].inf() <= piece.at[i][k] && piece.at[i][k] <= range[k].sup();
  };
  for (std::size_t i = 0; i < piece.corner_count; ++i) {
    corner[i] = !piece.grid || (on(i, 0) && on(i, 1));
    const std::size_t next = (i + 1) % piece.corner_count;
    const std::size_t fixed = piece.at[i][0] == piece.at[next][0] ? 0 : 1;
    side[i] = !piece.grid || on(i, fixed);
  }
  for (const auto& [j, bits] : piece.neighbours) {
    bool touches = false;
    for (std::size_t i = 0; i < piece.corner_count; ++i) {
      const std::size_t next = (i + 1) % piece.corner_count;
      touches = touches || (corner[i] && (bits >> i & 1u) != 0) ||
                (side[i] && (bits >> i & 1u) != 0 && (bits >> next & 1u) != 0);
    }
    if (!touches) continue;
    if (all[j].blind) {
      part.blind = true;
      return part;
    }
    u = hull(u, all[j].along_u);
    v = hull(v, all[j].along_v);
  }
  part.cone = cross(u, v);
  for (const std::uint32_t j : piece.foreign) {
    const Piece& other = all[j];
    if (other.blind) {
      part.blind = true;
      return part;
    }
    Interval3 cone = other.kind == Piece::Kind::flat ? other.normal : Interval3{};
    if (other.kind == Piece::Kind::cell) {
      const SurfaceJet<Interval> there = other.surface->over(other.range[0], other.range[1]);
      cone = cross(hull(other.along_u, there.along_u), hull(other.along_v, there.along_v));
    }
    double same = 0;
    for (std::size_t k = 0; k < 3; ++k) same += middle_of(cone[k]) * middle_of(part.cone[k]);
    if (same < 0) cone = scaled(Interval(-1), cone);
    part.cone = hull(normalized(part.cone), normalized(cone));
  }
  return part;
}

namespace {

/// True if the part has a pole at which the normals of all cells about it are not on one side of a plane.
bool at_apex(const std::vector<Piece>& all, const Piece& piece, const std::array<Interval, 2>& range) {
  for (std::size_t i = 0; piece.grid && i < 4; ++i) {
    if (piece.points[i] != piece.points[(i + 1) % 4]) continue;
    const std::size_t fixed = piece.at[i][0] == piece.at[(i + 1) % 4][0] ? 0 : 1;
    if (piece.at[i][fixed] < range[fixed].inf() || piece.at[i][fixed] > range[fixed].sup()) continue;
    std::array<Interval, 2> there = range;
    there[fixed] = Interval(piece.at[i][fixed]);
    const PiecePart pole = part_of(all, piece, there);
    if (pole.blind || holds_zero(pole.cone)) return true;
  }
  return false;
}

}  // namespace

std::array<double, 2> gains(const PiecePart& part, const Vector3<double>& d) {
  const Piece& piece = *part.piece;
  std::array<double, 2> result{};
  const auto gain = [&](std::size_t k, const Interval3& along) {
    const double width = part.range[k].sup() - part.range[k].inf(), whole = piece.range[k].sup() - piece.range[k].inf();
    const Vector3<double> way = middle_of(along);
    const double length = std::sqrt(dot(way, way)) * width;
    result[k] = std::abs(dot(way, d)) * width + piece.turn[k] * (width / whole) * length + 1e-9 * length;
  };
  if (piece.kind == Piece::Kind::flat) return result;
  if (piece.kind == Piece::Kind::curve) {
    gain(0, piece.along_u);
    result[0] = std::max(result[0], 1e-300);
    return result;
  }
  gain(0, part.along_u);
  gain(1, part.along_v);
  return result;
}

std::array<PiecePart, 2> halves(const std::vector<Piece>& all, const PiecePart& part, std::size_t k, Between between) {
  const double middle = middle_of(part.range[k]);
  std::array<Interval, 2> low = part.range, high = part.range;
  low[k] = Interval(part.range[k].inf(), middle);
  high[k] = Interval(middle, part.range[k].sup());
  return {part_of(all, *part.piece, low, between), part_of(all, *part.piece, high, between)};
}

Interval extent(const PiecePart& part, const Vector3<double>& d, Between between) {
  const Piece& piece = *part.piece;
  const Interval3 along{Interval(d[0]), Interval(d[1]), Interval(d[2])};
  const auto all_of = [&](std::span<const Interval3> points) {
    Interval all = dot(along, points[0]);
    for (const Interval3& p : points.subspan(1)) all = hull(all, dot(along, p));
    return all;
  };
  const Interval of_box = dot(along, part.box);
  const auto narrowed = [](const Interval& a, const Interval& b) {
    const double low = std::max(a.inf(), b.inf()), high = std::min(a.sup(), b.sup());
    return low <= high ? Interval(low, high) : a;
  };
  if (piece.kind == Piece::Kind::flat) {
    // Along the normal, where it has one value, and the rest.
    const Interval share = dot(along, piece.normal) / dot(piece.normal, piece.normal);
    const Interval3 rest = difference(along, scaled(share, piece.normal));
    return narrowed(of_box, share * dot(piece.normal, piece.point) + dot(rest, part.box));
  }
  // Of the surface by the mean value theorem, from the middle of its part.
  const Interval middle_u(middle_of(part.range[0])), middle_v(middle_of(part.range[1]));
  const Interval away_u = part.range[0] - middle_u, away_v = part.range[1] - middle_v;
  if (piece.kind == Piece::Kind::curve) {
    const Interval chord = dot(along, piece.corners[0]) + part.range[0] * dot(along, piece.along_u);
    if (piece.exact()) return narrowed(of_box, chord);
    const Interval3 middle =
        piece.curve
            ? piece.curve->over(piece.side[0][0] + middle_u * (piece.side[1][0] - piece.side[0][0])).point
            : piece.surface
                  ->over(piece.side[0][0] + middle_u * (piece.side[1][0] - piece.side[0][0]),
                         piece.side[0][1] + middle_u * (piece.side[1][1] - piece.side[0][1]))
                  .point;
    const Interval curve = dot(along, middle) + away_u * dot(along, part.along_u);
    return narrowed(of_box, between == Between::surfaces ? curve : hull(chord, curve));
  }
  const Interval surface = dot(along, piece.surface->over(middle_u, middle_v).point) +
                           away_u * dot(along, part.along_u) + away_v * dot(along, part.along_v);
  if (between == Between::surfaces) return narrowed(of_box, surface);
  return narrowed(of_box, hull(surface, all_of(facet_corners(piece, part.range))));
}

}  // namespace cnrg
