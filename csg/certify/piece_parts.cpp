// Parts of pieces, by intervals; see the header.
#include "csg/certify/piece_parts.h"

#include "kernel/base/limits.h"

namespace cnrg {

using namespace surface_math;

namespace {

/// The normals of a part and, where it has a pole, those of all cells about it there: at an apex they differ.
Interval3 with_pole(const std::vector<Piece>& all, const Piece& piece, const std::array<Interval, 2>& range,
                    Interval3 cone) {
  for (std::size_t i = 0; piece.grid && i < 4; ++i) {
    const std::size_t next = (i + 1) % 4, fixed = piece.at[i][0] == piece.at[next][0] ? 0 : 1;
    const double pole = piece.at[i][fixed];
    if (piece.points[i] != piece.points[next] || pole < range[fixed].inf() || pole > range[fixed].sup()) continue;
    for (const auto& [j, bits] : piece.neighbours) {
      if ((bits >> i & 1u) == 0) continue;
      std::array<Interval, 2> there = all[j].range;
      there[fixed] = Interval(pole);
      cone = hull(normalized(cone), normalized(piece.surface->over(there[0], there[1]).normal));
    }
  }
  return cone;
}

/// Points whose convex hull holds F over a part of a cell.
PiecePart::FacetCorners facet_corners(const Piece& piece, const std::array<Interval, 2>& range) {
  PiecePart::FacetCorners result;
  if (!piece.grid) {
    for (std::size_t k = 0; k < piece.corner_count; ++k) result.add(piece.corners[k]);
    return result;
  }
  const std::size_t first = piece.at[0][0] != piece.at[1][0] ? 0 : 1, second = 1 - first;
  const auto place = [](double x, double from, double to) {
    if (x == from || x == to) return Interval(x == from ? 0 : 1);
    return (Interval(x) - Interval(from)) / (Interval(to) - Interval(from));
  };
  const auto mix = [](const Interval3& a, const Interval3& b, const Interval& x) {
    return sum(a, scaled(x, difference(b, a)));
  };
  if (piece.bent && !piece.column) {
    // F is linear on two triangles: its hull is that of its corners and of the ends of the diagonal.
    const auto at = [&](const Interval& s, const Interval& t) {
      const auto by = [&](std::size_t corner, const Interval& x, const Interval& y) {
        return sum(piece.corners[0], sum(scaled(x, difference(piece.corners[corner], piece.corners[0])),
                                         scaled(y, difference(piece.corners[2], piece.corners[0]))));
      };
      const Interval3 low = by(1, s - t, t), high = by(3, t - s, s);
      if (s.inf() >= t.sup()) return low;
      return t.inf() >= s.sup() ? high : hull(low, high);
    };
    std::array<std::array<Interval, 2>, 2> ends{};
    for (std::size_t k = 0; k < 2; ++k) {
      const std::size_t by = k == 0 ? first : second, far = k == 0 ? 1 : 3;
      ends[k] = {place(range[by].inf(), piece.at[0][by], piece.at[far][by]),
                 place(range[by].sup(), piece.at[0][by], piece.at[far][by])};
      if (ends[k][0].inf() > ends[k][1].inf()) std::swap(ends[k][0], ends[k][1]);
    }
    for (const Interval& s : ends[0]) {
      for (const Interval& t : ends[1]) result.add(at(s, t));
    }
    const Interval from(std::max(ends[0][0].inf(), ends[1][0].inf()),
                        std::max(ends[0][0].sup(), ends[1][0].sup())),
        to(std::min(ends[0][1].inf(), ends[1][1].inf()), std::min(ends[0][1].sup(), ends[1][1].sup()));
    if (from.inf() <= to.sup()) {
      result.add(at(from, from));
      result.add(at(to, to));
    }
    return result;
  }
  // F is bilinear: its hull is that of its corners. In a column also of two triangles that are nearly so.
  const double off = piece.column ? piece.column->off : 0;
  const auto share = [&](const Interval& way, std::size_t k) {
    return piece.column && piece.column->around == k ? piece.column->share(way) : way;
  };
  for (const double x : {range[first].inf(), range[first].sup()}) {
    const Interval s = share(place(x, piece.at[0][first], piece.at[1][first]), first);
    const Interval3 low = mix(piece.corners[0], piece.corners[1], s),
                    high = mix(piece.corners[3], piece.corners[2], s);
    for (const double y : {range[second].inf(), range[second].sup()})
      result.add(widened(mix(low, high, share(place(y, piece.at[0][second], piece.at[3][second]), second)), off));
  }
  return result;
}

Interval3 facet_box(const Piece& piece, const std::array<Interval, 2>& range,
                    const PiecePart::FacetCorners& corners) {
  Interval3 all = corners.all[0];
  for (std::size_t k = 1; k < corners.count; ++k) all = hull(all, corners.all[k]);
  if (piece.grid || piece.blind || piece.corner_count != 3) return all;
  const Interval3 affine =
      sum(piece.corners[0], sum(scaled(Interval(range[0] - Interval(piece.at[0][0])), piece.along_u),
                                scaled(Interval(range[1] - Interval(piece.at[0][1])), piece.along_v)));
  for (std::size_t k = 0; k < 3; ++k) {
    const double low = std::max(all[k].inf(), affine[k].inf()), high = std::min(all[k].sup(), affine[k].sup());
    if (low <= high) all[k] = Interval(low, high);
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
    const Interval own = side(a, Interval(piece.at[c][0]), Interval(piece.at[c][1])),
                   other = side(a, range[0], range[1]);
    if ((own.inf() > 0 && other.sup() < 0) || (own.sup() < 0 && other.inf() > 0)) return true;
  }
  return false;
}

/// False if the side from corner i on has no point in the range, proven.
bool on_side(const Piece& piece, std::size_t i, const std::array<Interval, 2>& range) {
  const auto &a = piece.at[i], &b = piece.at[(i + 1) % piece.corner_count];
  for (std::size_t k = 0; k < 2; ++k) {
    if (std::max(a[k], b[k]) < range[k].inf() || std::min(a[k], b[k]) > range[k].sup()) return false;
  }
  const Interval du = Interval(b[0]) - Interval(a[0]), dv = Interval(b[1]) - Interval(a[1]);
  const Interval off = du * (range[1] - Interval(a[1])) - dv * (range[0] - Interval(a[0]));
  return off.inf() <= 0 && off.sup() >= 0;
}

/// How far F of a curve is from its first to its last corner.
Interval share_of(const Piece& curve, const Interval& s) { return curve.column ? curve.column->share(s) : s; }

Upward share_of(const PiecePart& part, std::size_t k) {
  return width_of(part.range[k]) / width_of(part.piece->range[k]);
}

std::vector<Guess3> sides_of(const PiecePart& part) {
  const Piece& piece = *part.piece;
  const auto way = [&](std::size_t i, std::size_t j) {
    return difference(middle_of(piece.corners[j]), middle_of(piece.corners[i]));
  };
  if (piece.kind == Piece::Kind::curve) return {way(0, 1)};
  if (piece.kind == Piece::Kind::cell) return {way(0, 1), way(1, 2)};
  return {};
}

/// True if a part of a curve holds an end of it: beyond that it crosses nothing. But in what it ends for all t, it
/// does.
bool ends_beside(const Pieces& pieces, const PiecePart& curve, const PiecePart& other) {
  for (const std::size_t k : {0u, 1u}) {
    const bool there = k == 0 ? curve.range[0].inf() == 0 : curve.range[0].sup() == 1;
    if (there && std::ranges::none_of(curve.piece->neighbours, [&](const auto& n) { return n.second == 1 + k; }) &&
        !pieces.ends_in(*curve.piece, k, *other.piece))
      return true;
  }
  return false;
}

/// The hull with what F adds.
Interval3 with(const Interval3& facets, const Interval3& surface, Between between) {
  return between == Between::surfaces ? surface : hull(facets, surface);
}

PiecePart curve_part(const std::vector<Piece>& all, const Piece& piece, const std::array<Interval, 2>& range,
                     Between between) {
  PiecePart part{&piece, range};
  const Interval& s = range[0];
  const Interval3 chord = sum(piece.corners[0], scaled(share_of(piece, s), piece.along_u));
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
    part.cone =
        hull(normalized(part.cone), normalized(against ? scaled(Interval(-1), other.along_u) : other.along_u));
  }
  return part;
}

bool has_pole(const Piece& piece, const std::array<Interval, 2>& range) {
  const auto& pole = piece.pole;
  return pole && (range[pole->away].inf() == pole->at || range[pole->away].sup() == pole->at);
}

/// What is at right angles to all H over a part of a cell, also where it goes on in cells of its patch; nothing if
/// it is not known.
std::optional<Interval3> normals_of(const std::vector<Piece>& all, const Piece& piece,
                                    const std::array<Interval, 2>& range, const SurfaceJet<Interval>& jet) {
  if (has_pole(piece, range) && piece.pole->is_near(range)) return piece.pole->normals;
  const Interval3 u_of_facet = normalized(piece.along_u), v_of_facet = normalized(piece.along_v);
  Interval3 u = hull(u_of_facet, normalized(jet.way_u)), v = hull(v_of_facet, normalized(jet.way_v));
  if (piece.grid) {  // at a pole along the side that is none
    const std::size_t first = piece.at[0][0] != piece.at[1][0] ? 0 : 1, second = 1 - first;
    const auto at_pole = [&](std::size_t i, std::size_t j, std::size_t k) {
      return piece.points[i] == piece.points[j] && range[k].inf() <= piece.at[i][k] &&
             piece.at[i][k] <= range[k].sup();
    };
    const bool low = at_pole(0, 1, second), high = at_pole(3, 2, second);
    const bool left = at_pole(0, 3, first), right = at_pole(1, 2, first);
    const auto at_side = [&](std::size_t fixed, double value) {
      std::array<Interval, 2> line = range;
      line[fixed] = Interval(value);
      const SurfaceJet<Interval> there = piece.surface->over(line[0], line[1]);
      return normalized(1 - fixed == 0 ? there.way_u : there.way_v);
    };
    if (low || high) {
      Interval3& x = first == 0 ? u : v;
      x = hull(first == 0 ? u_of_facet : v_of_facet, at_side(second, piece.at[low ? 3 : 0][second]));
    }
    if (left || right) {
      Interval3& x = second == 0 ? u : v;
      x = hull(second == 0 ? u_of_facet : v_of_facet, at_side(first, piece.at[left ? 1 : 0][first]));
    }
  }
  std::array<bool, 4> corner{}, side{};
  for (std::size_t i = 0; i < piece.corner_count; ++i) {
    corner[i] = range[0].inf() <= piece.at[i][0] && piece.at[i][0] <= range[0].sup() &&
                range[1].inf() <= piece.at[i][1] && piece.at[i][1] <= range[1].sup();
    side[i] = on_side(piece, i, range);
  }
  for (const auto& [j, bits] : piece.neighbours) {
    bool touches = false;
    for (std::size_t i = 0; i < piece.corner_count; ++i) {
      const std::size_t next = (i + 1) % piece.corner_count;
      touches = touches || (corner[i] && (bits >> i & 1u) != 0) ||
                (side[i] && (bits >> i & 1u) != 0 && (bits >> next & 1u) != 0);
    }
    if (!touches) continue;
    if (all[j].blind) return std::nullopt;
    u = hull(u, normalized(all[j].along_u));
    v = hull(v, normalized(all[j].along_v));
  }
  return cross(u, v);
}

}  // namespace

PiecePart part_of(const std::vector<Piece>& all, const Piece& piece, const std::array<Interval, 2>& range,
                  Between between) {
  if (piece.kind == Piece::Kind::curve) return curve_part(all, piece, range, between);
  PiecePart part{&piece, range};
  if (piece.kind == Piece::Kind::flat) {
    part.box = all_of(piece.box);
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
    part.cone = with_pole(all, piece, range, jet.normal);
    part.blind = holds_zero(part.cone);
    return part;
  }
  part.facet = facet_corners(piece, range);
  part.box = hull(facet_box(piece, range, part.facet), jet.point);
  if (piece.column) part.box = widened(part.box, piece.column->bulge());
  part.blind = piece.blind || holds_zero(jet.normal);
  if (part.blind) return part;
  const std::optional<Interval3> normals = normals_of(all, piece, range, jet);
  part.blind = !normals;
  if (part.blind) return part;
  part.cone = *normals;
  for (const std::uint32_t j : piece.foreign) {
    const Piece& other = all[j];
    if (other.blind) {
      part.blind = true;
      return part;
    }
    Interval3 cone = other.kind == Piece::Kind::flat ? other.normal : Interval3{};
    if (other.kind == Piece::Kind::cell) {
      const SurfaceJet<Interval> there = other.surface->over(other.range[0], other.range[1]);
      cone = cross(hull(normalized(other.along_u), normalized(there.way_u)),
                   hull(normalized(other.along_v), normalized(there.way_v)));
    }
    if (dot(middle_of(cone), middle_of(part.cone)) < 0) cone = scaled(Interval(-1), cone);
    part.cone = hull(normalized(part.cone), normalized(cone));
  }
  return part;
}

std::optional<std::size_t> way_from_pole(const PiecePart& part) {
  if (!has_pole(*part.piece, part.range) || !holds_zero(part.cone)) return std::nullopt;
  return part.piece->pole->away;
}

std::array<Upward, 2> gains(const PiecePart& part, const Guess3& d) {
  const Piece& piece = *part.piece;
  std::array<Upward, 2> result{};
  const auto gain = [&](std::size_t k, const Interval3& along) {
    const Upward width = width_of(part.range[k]), whole = width_of(piece.range[k]);
    const double middle = middle_of(part.range[k]);
    if (width <= Upward(1e-15) * whole || middle <= part.range[k].inf() || middle >= part.range[k].sup())
      return;  // no halves
    const Guess3 way = middle_of(along);
    const Upward length = cnrg::length(way) * width;
    result[k] = abs(dot(way, d)) * width + piece.turn[k] * (width / whole) * length + 1e-9 * length;
  };
  if (piece.kind == Piece::Kind::flat) return result;
  if (piece.kind == Piece::Kind::curve) {
    gain(0, piece.along_u);
    if (result[0] > 0) {  // how it bends is not known
      result[0] = length(middle_of(piece.along_u)) * width_of(part.range[0]);
    }
    return result;
  }
  gain(0, part.along_u);
  gain(1, part.along_v);
  return result;
}

std::array<PiecePart, 2> halves(const std::vector<Piece>& all, const PiecePart& part, std::size_t k,
                                Between between) {
  const double middle = middle_of(part.range[k]);
  std::array<Interval, 2> low = part.range, high = part.range;
  low[k] = Interval(part.range[k].inf(), middle);
  high[k] = Interval(middle, part.range[k].sup());
  return {part_of(all, *part.piece, low, between), part_of(all, *part.piece, high, between)};
}

Upward PiecePart::share() const {
  if (piece->kind == Piece::Kind::flat) return 0;
  return piece->kind == Piece::Kind::curve ? share_of(*this, 0) : share_of(*this, 0) + share_of(*this, 1);
}
std::size_t PiecePart::longer() const {
  return piece->kind == Piece::Kind::curve || share_of(*this, 0) >= share_of(*this, 1) ? 0 : 1;
}

const Interval3& PiecePart::middle() const {
  if (known_middle) return *known_middle;
  const Interval s(middle_of(range[0]));
  if (piece->kind == Piece::Kind::cell) {
    known_middle = piece->surface->over(s, Interval(middle_of(range[1]))).point;
  } else {
    const auto at = [&](std::size_t k) { return piece->side[0][k] + s * (piece->side[1][k] - piece->side[0][k]); };
    known_middle = piece->curve ? piece->curve->over(at(0)).point : piece->surface->over(at(0), at(1)).point;
  }
  return *known_middle;
}

Interval3 normalized(const Interval3& x) {
  const Upward size = length(middle_of(x));
  if (!(size > 0) || !isfinite(size)) return x;
  return scaled(Interval(double(1 / size)), x);
}

Interval3 thin(const Guess3& x) {
  return {Interval(double(x[0])), Interval(double(x[1])), Interval(double(x[2]))};
}

bool independent(const Interval3& a, const Interval3& b) {
  const Interval3 n = cross(a, b);
  if (std::ranges::any_of(n, [](const Interval& x) { return !holds_zero(x); })) return true;
  const auto d = direction(cross(middle_of(a), middle_of(b)));
  if (!d) return false;
  // In the frame of the middle vectors the cones are as narrow as they can be.
  const Guess3 x = middle_of(a), y = cross(*d, x);
  const Interval3 ex = thin(x), ey = thin(y);
  return !holds_zero(dot(ex, a) * dot(ey, b) - dot(ey, a) * dot(ex, b));
}
bool independent(const Interval3& a, const Interval3& b, const Interval3& c) {
  if (!holds_zero(dot(cross(a, b), c))) return true;
  // Rows of the inverse of the middle: then each cone is near to an axis.
  const Guess3 x = middle_of(a), y = middle_of(b), z = middle_of(c);
  const Upward det = dot(cross(x, y), z);
  if (!(abs(det) > 0) || !isfinite(det)) return false;
  const Upward by = 1 / det;
  const std::array<Guess3, 3> rows{scaled(by, cross(y, z)), scaled(by, cross(z, x)), scaled(by, cross(x, y))};
  const std::array<Interval3, 3> cones{a, b, c};
  std::array<Interval3, 3> m;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) m[i][j] = dot(thin(rows[j]), cones[i]);
  }
  return !holds_zero(dot(m[0], cross(m[1], m[2])));
}

Extents extents(const PiecePart& part, const Guess3& d, Between between) {
  const Piece& piece = *part.piece;
  const Interval3 along = thin(d);
  const Interval of_box = dot(along, part.box);
  const auto narrowed = [&](const Interval& x) {
    const double low = std::max(of_box.inf(), x.inf()), high = std::min(of_box.sup(), x.sup());
    return low <= high ? Interval(low, high) : of_box;
  };
  const auto both = [&](const Interval& x) { return Extents{narrowed(x), narrowed(x)}; };
  if (piece.kind == Piece::Kind::flat) {
    // Along the normal, where it has one value, and the rest.
    const Interval share = dot(along, piece.normal) / dot(piece.normal, piece.normal);
    const Interval3 rest = difference(along, scaled(share, piece.normal));
    return both(share * dot(piece.normal, piece.point) + dot(rest, part.box));
  }
  const auto at = [&](const Interval3& corner) { return dot(along, corner); };
  if (piece.exact()) return both(at(piece.corners[0]) + part.range[0] * at(piece.along_u));
  // Of the surface by the mean value theorem, from the middle of its part.
  const auto away = [&](std::size_t k) { return part.range[k] - Interval(middle_of(part.range[k])); };
  Interval surface = at(part.middle()) + away(0) * at(part.along_u);
  if (piece.kind == Piece::Kind::cell) surface += away(1) * at(part.along_v);
  if (between == Between::surfaces || (piece.kind == Piece::Kind::cell && part.facet.count == 0))
    return both(surface);
  if (piece.kind == Piece::Kind::curve)
    return {narrowed(at(piece.corners[0]) + share_of(piece, part.range[0]) * at(piece.along_u)),
            narrowed(surface)};
  Interval facets = at(part.facet.all[0]);
  for (std::size_t k = 1; k < part.facet.count; ++k) facets = hull(facets, at(part.facet.all[k]));
  return {narrowed(facets), narrowed(surface), piece.column ? piece.column->bulge() : 0};
}

bool parted(const Extents& a, const Extents& b) {
  const auto before = [](const Extents& x, const Extents& y) {
    const Interval facets = Interval(y.facets.inf()) - x.facets.sup(),
                   surfaces = Interval(y.surface.inf()) - x.surface.sup(),
                   middle = facets + surfaces - Interval(4) * (Interval(x.bulge) + y.bulge);
    return facets.inf() > 0 && surfaces.inf() > 0 && middle.inf() > 0;
  };
  return before(a, b) || before(b, a);
}

bool parted(std::span<const PiecePart> parts, Between between) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].blind || parts[i].piece->kind == Piece::Kind::curve) continue;
    const auto d = direction(middle_of(parts[i].cone));
    if (!d) continue;
    const Extents own = extents(parts[i], *d, between);
    for (std::size_t j = 0; j < parts.size(); ++j) {
      if (j != i && parted(own, extents(parts[j], *d, between))) return true;
    }
  }
  return false;
}

bool parted_along_sides(const PiecePart& a, const PiecePart& b) {
  if (parted(std::array{a, b}, Between::facets_and_surfaces)) return true;
  for (const Guess3& x : sides_of(a)) {
    for (const Guess3& y : sides_of(b)) {
      const auto d = direction(cross(x, y));
      if (!d) continue;
      if (parted(extents(a, *d, Between::facets_and_surfaces), extents(b, *d, Between::facets_and_surfaces)))
        return true;
    }
  }
  return false;
}

bool at_angle(const Pieces& pieces, std::span<const PiecePart> parts) {
  if (std::ranges::any_of(parts, &PiecePart::blind)) return false;
  if (parts.size() == 3) return independent(parts[0].cone, parts[1].cone, parts[2].cone);
  const bool first = parts[0].piece->kind == Piece::Kind::curve,
             second = parts[1].piece->kind == Piece::Kind::curve;
  if (first == second ? !independent(parts[0].cone, parts[1].cone) : holds_zero(dot(parts[0].cone, parts[1].cone)))
    return false;
  return !(first && ends_beside(pieces, parts[0], parts[1])) &&
         !(second && ends_beside(pieces, parts[1], parts[0]));
}

bool misses(const Piece& flat, const Interval3& box) {
  if (!holds_zero(dot(flat.normal, difference(box, flat.point)))) return true;
  for (const auto& [d, wide] : flat.limits) {
    const Interval there = dot(thin(d), box);
    if (there.inf() > wide.sup() || there.sup() < wide.inf()) return true;
  }
  return false;
}

bool misses_line(const PiecePart& part, const Contact& contact, const Interval3& box, Between between) {
  if (contact.kind != Contact::Kind::line) return false;
  const Interval3 point = enclose3(contact.point), way = enclose3(contact.direction);
  Interval place(-kInfinity, kInfinity);
  for (std::size_t i = 0; i < 3; ++i) {
    const Interval off = box[i] - point[i];
    if (holds_zero(way[i])) {
      if (contact.direction[i] == 0 && !holds_zero(off)) return true;
      continue;
    }
    const Interval there = off / way[i];
    if (there.inf() > place.sup() || there.sup() < place.inf()) return true;
    place = Interval(std::max(place.inf(), there.inf()), std::min(place.sup(), there.sup()));
  }
  const bool is_curve = part.piece->kind == Piece::Kind::curve;
  const auto d = part.blind || is_curve ? std::nullopt : direction(middle_of(part.cone));
  if (!d || !std::isfinite(place.inf()) || !std::isfinite(place.sup())) return false;
  const Interval own = extents(part, *d, between).all(), other = dot(thin(*d), point) + place * dot(thin(*d), way);
  return own.sup() < other.inf() || other.sup() < own.inf();
}

double size_of(const Interval3& x) {
  Upward size = 0;
  for (const Interval& c : x) size = std::max(size, width_of(c));
  return double(size);
}

double PiecePart::thickness() const {
  if (known_thickness) return *known_thickness;
  const auto d = blind ? std::nullopt : direction(middle_of(cone));
  known_thickness = d ? double(width_of(extents(*this, *d, Between::facets_and_surfaces).all())) : 0;
  return *known_thickness;
}

Interval3 bounded(const Interval3& box, const Piece& piece) {
  if (std::isfinite(size_of(box))) return box;
  Interval3 corners = piece.corners[0];
  for (std::size_t i = 1; i < piece.corner_count; ++i) corners = hull(corners, piece.corners[i]);
  return corners;
}

bool worth_halving(const PiecePart& part, const PiecePart& whole, Between between) {
  const Piece& piece = *part.piece;
  const double size = size_of(part.box);
  double far = 0;
  for (std::size_t k = 0; k < 3; ++k) far = std::max({far, std::abs(piece.box.lo[k]), std::abs(piece.box.hi[k])});
  if (size <= double(Upward(1e-14) * far)) return false;
  if (between == Between::surfaces || piece.kind == Piece::Kind::curve) return true;
  return size > whole.thickness() / 2 || size > part.thickness() / 2;
}

std::optional<Interval3> common_box(std::span<const PiecePart> parts) {
  Interval3 common = parts[0].box;
  for (const PiecePart& part : parts) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double low = std::max(common[k].inf(), part.box[k].inf()),
                   high = std::min(common[k].sup(), part.box[k].sup());
      if (low > high) return std::nullopt;
      common[k] = Interval(low, high);
    }
  }
  return common;
}

}  // namespace cnrg
