// A family collects the meridians, directions and steps of its members, and gives each member the common ones.
#include "csg/carriers/family.h"

#include <algorithm>

#include "csg/geometry/circle.h"
#include "kernel/base/error.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

// Families get their directions in the order of nesting, the innermost first: the outer family needs all
// directions of the inner one, and the bisectors beside each contact. Families in a cycle are taken in the order
// of their axes.

RationalPoint bisector(const RationalPoint& a, const RationalPoint& b) {
  const RationalPoint sum = a + b;
  return Rational(1 / root(dot(sum, sum))) * sum;
}

}  // namespace

void solve_turns(const std::vector<std::shared_ptr<Family>>& families, const std::vector<NestedFamilies>& nested) {
  std::vector<std::vector<std::size_t>> around(families.size()), inside(families.size());  // places in `nested`
  std::vector<std::size_t> missing(families.size());
  for (std::size_t k = 0; k < nested.size(); ++k) {
    around[nested[k].inner].push_back(k);
    inside[nested[k].outer].push_back(k);
    ++missing[nested[k].outer];
  }
  std::vector<bool> solved(families.size());
  std::vector<std::size_t> ready;
  const auto solve = [&](std::size_t f) {
    std::vector<RationalPoint> directions;
    for (const std::size_t k : inside[f]) {
      if (!solved[nested[k].inner]) continue;
      const Turns& turns = families[nested[k].inner]->turns();
      for (const RationalPoint& d : turns.directions()) directions.push_back(d);
      for (const RationalPoint& d : turns.beside(nested[k].direction))
        directions.push_back(bisector(nested[k].direction, d));
    }
    families[f]->solve_turns(directions);
    solved[f] = true;
    for (const std::size_t k : around[f]) {
      if (--missing[nested[k].outer] == 0) ready.push_back(nested[k].outer);
    }
  };
  std::vector<std::size_t> by_axis(families.size());
  for (std::size_t f = 0; f < by_axis.size(); ++f) by_axis[f] = f;
  std::sort(by_axis.begin(), by_axis.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(missing[a] > 0, families[a]->axis()) < std::pair(missing[b] > 0, families[b]->axis());
  });
  for (const std::size_t first : by_axis) {
    ready.push_back(first);
    while (!ready.empty()) {
      const std::size_t f = ready.back();
      ready.pop_back();
      if (!solved[f]) solve(f);
    }
  }
}

Sector sector_of(const Member& member) {
  const PlacedForm& placed = member.placed;
  const bool with = placed.along != placed.mirrored;
  return {with ? placed.start : placed.end, with ? placed.end : placed.start, member.whole};
}

Family::Family(std::vector<Member> members, bool may_round)
    : members_(std::move(members)),
      axis_(members_[0].placed.axis),
      rounds_(may_round && stays_plane()),
      size_(smallest()),
      plane_(members_[0].placed.square(), [this](const MeridianPoint& p) { return rounded(p); }) {
  for (const Member& member : members_) {
    segments_ = std::max(segments_, member.segments);
    first_.push_back(pieces_);
    for (const auto& line : member.placed.lines) {
      for (const MeridianPiece& piece : line) {
        plane_.add(piece);
        ++pieces_;
      }
    }
    marks_.insert(marks_.end(), member.marks.begin(), member.marks.end());
    if (member.placed.start == member.placed.end) continue;
    marks_.push_back(member.placed.start);
    marks_.push_back(member.placed.end);
  }
}

void Family::add_marks(std::size_t member, const TangencyMarks& marks) {
  marks_.insert(marks_.end(), marks.directions.begin(), marks.directions.end());
  for (const RationalPoint& p : marks.points) add_point(member, p);
  for (const MeridianPoint& p : marks.circles) add_circle(member, p);
}

void Family::add_lines(std::size_t member, const RevolvedLines& lines) {
  lines_.insert(lines.directions.begin(), lines.directions.end());
  for (const auto& [piece, way] : lines.rows) plane_.add_row(first_[member] + piece, way);
}

void Family::solve_turns(const std::vector<RationalPoint>& others) {
  std::vector<RationalPoint> all = others_;
  all.insert(all.end(), others.begin(), others.end());
  turns_ = std::make_unique<Turns>(axis_.direction, first_direction(), segments_, marks_, all, lines_);
}

std::vector<RationalPoint> Family::corners(std::size_t m) const {
  std::vector<RationalPoint> result;
  const auto columns = turns_->around({members_[m].placed.start, true, false});
  for (const RevolvedGrid::Row& row : plane_.rows(first_[m])) {
    const std::size_t n = row.at.r == 0 ? 1 : columns.size() - 1;
    for (std::size_t i = 0; i < n; ++i) result.push_back(point(row.at, columns[i]));
  }
  return result;
}

std::vector<MeridianPoint> Family::shared_circles(std::size_t member) const {
  std::vector<MeridianPoint> result = plane_.marks(first_[member]);
  std::erase_if(result, [](const MeridianPoint& p) { return p.r == 0; });
  return result;
}

SphereCircle Family::circle(const MeridianPoint& at) const {
  SphereCircle result;
  const auto columns = turns_->around({members_[0].placed.start, true, false});
  result.reserve(columns.size());
  for (std::size_t i = 0; i + 1 < columns.size(); ++i) result.push_back(point(at, columns[i]));
  return result;
}

std::vector<RevolvedGrid::Column> Family::columns(std::size_t m, const Rational& degrees) const {
  const PlacedForm& placed = members_[m].placed;
  const Turns::Lie lie{placed.start, placed.along, placed.mirrored};
  return degrees == 360 ? turns_->around(lie) : turns_->part(lie, placed.end, degrees);
}

RevolvedGrid Family::grid(std::size_t m, const RevolvedForm& form) const {
  const PlacedForm& placed = members_[m].placed;
  RevolvedGrid grid;
  grid.mirrored = placed.mirrored;
  grid.columns = columns(m, form.degrees);
  std::size_t piece = first_[m];
  for (const auto& line : placed.lines) {
    grid.rows.emplace_back();
    for (std::size_t i = 0; i < line.size(); ++i) grid.rows.back().push_back(plane_.rows(piece++));
  }
  return grid;
}

BandGrid Family::band_grid(std::size_t m, const Transform& back) const {
  const Member& member = members_[m];
  const PlacedForm& placed = member.placed;
  std::vector<RevolvedGrid::Column> columns = turns_->around({placed.start, true, false});
  columns.pop_back();
  if (placed.along == placed.mirrored) std::reverse(columns.begin(), columns.end());
  const auto find = [&](const RationalPoint& direction) {
    return std::find_if(columns.begin(), columns.end(),
                        [&](const auto& column) { return same_ray(column.direction, direction); });
  };
  if (const auto first = find(placed.start); first != columns.end())
    std::rotate(columns.begin(), first, columns.end());
  if (member.whole) columns.push_back(columns.front());
  else columns.erase(find(placed.end) + 1, columns.end());
  BandGrid grid;
  grid.mirrored = placed.mirrored;
  for (const RevolvedGrid::Row& row : plane_.rows(first_[m])) {
    auto& points = grid.rows.emplace_back();
    for (const RevolvedGrid::Column& column : columns) points.push_back(back.apply(point(row.at, column)));
  }
  for (const RationalPoint& mark : member.marks) {
    const auto at = find(mark);
    require(at != columns.end(), "the marks of a band are lines of its family");
    grid.marks.push_back(static_cast<std::size_t>(at - columns.begin()));
  }
  return grid;
}

RationalPoint Family::point(const MeridianPoint& at, const RevolvedGrid::Column& column) const {
  RationalPoint p = axis_.foot + at.t * axis_.direction;
  if (at.r == 0) return p;
  p = p + at.r * column.direction;
  if (!rounds_ || column.mark) return p;
  for (std::size_t k = 0; k < 3; ++k) {
    if (axis_.direction[k] == 0) p[k] = rounded_for(p[k], size_);
  }
  return p;
}

bool Family::stays_plane() const {
  if (CircleFrame(axis_.direction).parallel_to() == 3) return false;
  for (const Member& member : members_) {
    if (!member.ball && member.placed.start != member.placed.end) return false;
    for (const auto& line : member.placed.lines) {
      for (const MeridianPiece& piece : line) {
        const bool straight = piece.from.r == piece.to.r || piece.from.t == piece.to.t;
        if (piece.kind == MeridianPiece::Kind::net || (piece.kind == MeridianPiece::Kind::line && !straight))
          return false;
      }
    }
  }
  return true;
}

RationalPoint Family::first_direction() const {
  const auto widest = [](const Member& member) {
    Rational r = 0;
    for (const auto& line : member.placed.lines) {
      for (const MeridianPiece& piece : line) r = std::max({r, piece.from.r, piece.to.r, piece.radius});
    }
    return r;
  };
  const auto start = [](const Member& member) { return member.even ? *member.even : member.placed.start; };
  const Member* best = nullptr;
  for (const Member& member : members_) {
    if (best != nullptr) {
      if (member.ball != best->ball) {
        if (member.ball) continue;
      } else if (member.segments != best->segments) {
        if (member.segments < best->segments) continue;
      } else if (const Rational r = widest(member), s = widest(*best); r != s) {
        if (r < s) continue;
      } else if (!(start(member) < start(*best))) {
        continue;
      }
    }
    best = &member;
  }
  return start(*best);
}

Rational Family::smallest() const {
  Rational size = 0;
  const auto see = [&](const Rational& r) {
    if (r > 0 && (size == 0 || r < size)) size = r;
  };
  for (const Member& member : members_) {
    for (const auto& line : member.placed.lines) {
      for (const MeridianPiece& piece : line) {
        see(piece.from.r);
        see(piece.to.r);
        see(piece.radius);
      }
    }
  }
  return size;
}

MeridianPoint Family::rounded(const MeridianPoint& p) const {
  if (!rounds_) return p;
  const std::size_t k = CircleFrame(axis_.direction).parallel_to();
  const Rational x = axis_.foot[k] + p.t * axis_.direction[k];
  return {p.r, (rounded_for(x, size_) - axis_.foot[k]) / axis_.direction[k]};
}

void Family::add_point(std::size_t member, const RationalPoint& p) {
  const Rational t = axis_.place_of(p);
  const RationalPoint out = p - (axis_.foot + t * axis_.direction);
  if (is_zero(out)) return;  // a pole
  const Rational square = dot(out, out);
  const Rational r = root(square);
  add_circle(member, {r, t});
  marks_.push_back((1 / r) * out);
}

void Family::add_circle(std::size_t member, const MeridianPoint& p) {
  std::size_t piece = first_[member];
  for (const auto& line : members_[member].placed.lines) {
    for (std::size_t i = 0; i < line.size(); ++i) plane_.add_vertex(piece++, p);
  }
}

}  // namespace cnrg
