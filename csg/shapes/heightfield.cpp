// Height fields: a surface over a grid or over scattered points, or the solid from it down to a level.
//
// Cell (i, j) is cut by the diagonal from (i, j) to (i + 1, j + 1). The surface is one patch, number 0, its front
// is up; a solid has its bottom as number 1 and its four walls as 2 to 5, each one polygon.
// Heights in the tree are exact. In a file they are the doubles that the text rounds to, and the coordinates of
// its points are the doubles nearest to origin + i * spacing, taken exactly from the decimals of the header.
// Scattered points (.xyz) are joined by the Delaunay triangulation of their plan, which covers its convex hull; a
// solid has a wall for each side of the hull, counter-clockwise as the four are.
#include <algorithm>

#include "csg/imports/heights.h"
#include "csg/leaves/geometry_leaf.h"
#include "csg/leaves/prepare_shapes.h"
#include "csg/shapes/coarse_grid.h"
#include "csg/text/table.h"
#include "kernel/base/error.h"
#include "kernel/exact/delaunay.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

/// Points of the grid, rows along y upwards; `none` where data is missing.
struct GridPoints {
  std::size_t columns, rows;
  std::vector<PointId> ids;
  PointId at(std::size_t i, std::size_t j) const { return ids[j * columns + i]; }
};

void check_base(const Rational& lowest, const Rational& base) {
  if (lowest > base) return;
  throw LeafKeyError("base", "heightfield: base is " + to_decimal(base) + ", but the lowest height is " +
                                 to_decimal(lowest) + ": give a base below all heights");
}

GridPoints points_of_tree(LeafBuilder& builder, const HeightfieldShape& shape) {
  const auto& rows = shape.heights;
  if (rows.size() < 2 || rows[0].size() < 2) {
    throw LeafKeyError("heights", "heightfield: heights has " + std::to_string(rows.size()) + " rows of " +
                                      std::to_string(rows.empty() ? 0 : rows[0].size()) +
                                      " entries: give at least 2 rows of 2");
  }
  if (shape.spacing_x <= 0 || shape.spacing_y <= 0) {
    throw LeafKeyError("spacing", "heightfield: spacing is [" + to_decimal(shape.spacing_x) + ", " +
                                      to_decimal(shape.spacing_y) + "]: give positive lengths");
  }
  GridPoints grid{rows[0].size(), rows.size(), {}};
  for (std::size_t j = 0; j < rows.size(); ++j) {
    if (rows[j].size() != grid.columns) {
      throw LeafKeyError("heights", "heightfield: row " + std::to_string(j + 1) + " has " +
                                        std::to_string(rows[j].size()) + " heights, row 1 has " +
                                        std::to_string(grid.columns) + ": give rows of equal length");
    }
    const Rational y = shape.origin_y + to_integer(j) * shape.spacing_y;
    for (std::size_t i = 0; i < grid.columns; ++i) {
      if (shape.base) check_base(rows[j][i], *shape.base);
      const Rational x = shape.origin_x + to_integer(i) * shape.spacing_x;
      grid.ids.push_back(builder.point({x, y, rows[j][i]}));
    }
  }
  return grid;
}

GridPoints points_of_file(LeafBuilder& builder, const HeightfieldShape& shape, std::vector<std::string>& notices) {
  const HeightGrid file = read_height_grid(shape.file, shape.inside);
  GridPoints grid{file.columns, file.rows, {}};
  if (!file.missing.empty()) {
    const auto missing = std::count(file.missing.begin(), file.missing.end(), true);
    if (shape.base) {
      throw InputError("heightfield: '" + shape.file + "' has no data at " + std::to_string(missing) +
                       " points, so it has no solid: fill the gaps, or leave out `base`");
    }
    notices.push_back("heightfield '" + shape.file + "' has no data at " + std::to_string(missing) +
                      " points: the cells around them are left out");
  }
  if (shape.base)
    check_base(from_double(*std::min_element(file.heights.begin(), file.heights.end())), *shape.base);
  const auto coordinates = [](const Rational& origin, const Rational& spacing, std::size_t n) {
    std::vector<double> result;
    for (std::size_t i = 0; i < n; ++i) result.push_back(to_double(origin + to_integer(i) * spacing));
    for (std::size_t i = 1; i < n; ++i) {
      if (result[i - 1] < result[i]) continue;
      throw InputError(
          "heightfield: the cellsize is too small against the coordinates, neighbours round to one point");
    }
    return result;
  };
  const std::vector<double> x = coordinates(file.origin_x, file.spacing_x, file.columns);
  const std::vector<double> y = coordinates(file.origin_y, file.spacing_y, file.rows);
  for (std::size_t j = 0; j < file.rows; ++j) {
    for (std::size_t i = 0; i < file.columns; ++i) {
      const std::size_t k = j * file.columns + i;
      const bool gap = !file.missing.empty() && file.missing[k];
      grid.ids.push_back(gap ? PointId::none() : builder.soup().add_point(x[i], y[j], file.heights[k]));
    }
  }
  return grid;
}

void add_surface(LeafBuilder& builder, const GridPoints& grid) {
  const auto triangle = [&](PointId a, PointId b, PointId c) {
    if (a.valid() && b.valid() && c.valid()) builder.triangle(a, b, c, 0);
  };
  std::size_t cells = 0;
  for (std::size_t j = 0; j + 1 < grid.rows; ++j) {
    for (std::size_t i = 0; i + 1 < grid.columns; ++i) {
      const PointId a = grid.at(i, j), b = grid.at(i + 1, j), c = grid.at(i + 1, j + 1), d = grid.at(i, j + 1);
      if (!a.valid() || !b.valid() || !c.valid() || !d.valid()) continue;
      ++cells;
      triangle(a, b, c);
      triangle(a, c, d);
    }
  }
  if (cells == 0) throw InputError("heightfield: no cell has data at all of its corners: there is no surface");
}

/// Keeps of a grid the points of a surface with fewer triangles, which it adds.
GridPoints add_coarse(LeafBuilder& builder, const LeafBuilder& all, const GridPoints& grid, const Rational& within,
                      std::vector<std::string>& notices) {
  HeightTable table{grid.columns, grid.rows, {}};
  for (const PointId p : grid.ids) {
    if (!p.valid())
      throw LeafKeyError("within", "heightfield: `within` is for grids without gaps: fill these, or leave it out");
    table.heights.push_back(all.value(p)[2]);
  }
  const CoarseSurface surface = coarse_surface(table, within);
  GridPoints kept{grid.columns, grid.rows, std::vector<PointId>(grid.ids.size())};
  std::size_t count = 0;
  for (const auto& triangle : surface.triangles) {
    for (const std::uint32_t p : triangle) {
      if (kept.ids[p].valid()) continue;
      kept.ids[p] = builder.point(all.value(grid.ids[p]));
      ++count;
    }
    builder.triangle(kept.ids[triangle[0]], kept.ids[triangle[1]], kept.ids[triangle[2]], 0);
  }
  notices.push_back("heightfield: " + grouped(count) + " of " + grouped(grid.ids.size()) +
                    " points make a surface within " + decimal(surface.deviation, "%.6g") + " of all");
  return kept;
}

/// The sides of the border, each with its two ends, counter-clockwise as seen from above.
using Sides = std::vector<std::vector<PointId>>;

/// South, east, north, west.
Sides sides_of(const GridPoints& grid) {
  const std::size_t last_i = grid.columns - 1, last_j = grid.rows - 1;
  Sides sides(4);
  for (std::size_t i = 0; i <= last_i; ++i) {
    sides[0].push_back(grid.at(i, 0));
    sides[2].push_back(grid.at(last_i - i, last_j));
  }
  for (std::size_t j = 0; j <= last_j; ++j) {
    sides[1].push_back(grid.at(last_i, j));
    sides[3].push_back(grid.at(0, last_j - j));
  }
  return sides;
}

/// From corner to corner of the hull; other points of its border lie on a side, exactly.
Sides sides_of(const std::vector<std::array<double, 3>>& points, const std::vector<std::uint32_t>& border,
               const std::vector<PointId>& ids) {
  const auto exact = [&](std::size_t i, std::size_t axis) { return from_double(points[border[i]][axis]); };
  const std::size_t n = border.size();
  const auto is_corner = [&](std::size_t i) {
    const std::size_t before = (i + n - 1) % n, after = (i + 1) % n;
    return (exact(i, 0) - exact(before, 0)) * (exact(after, 1) - exact(i, 1)) !=
           (exact(i, 1) - exact(before, 1)) * (exact(after, 0) - exact(i, 0));
  };
  Sides sides;  // the border begins with the smallest x, and of these y: a corner
  for (std::size_t i = 0; i < n; ++i) {
    if (is_corner(i)) sides.emplace_back(1, ids[border[i]]);
    sides.back().push_back(ids[border[(i + 1) % n]]);
  }
  return sides;
}

void add_walls(LeafBuilder& builder, const Sides& sides, const Rational& base) {
  std::vector<PointId> bottom;
  for (const std::vector<PointId>& side : sides) {
    RationalPoint p = builder.value(side.front());
    p[2] = base;
    bottom.push_back(builder.point(p));
  }
  builder.face(std::vector<PointId>(bottom.rbegin(), bottom.rend()), 1);
  for (std::size_t s = 0; s < sides.size(); ++s) {
    std::vector<PointId> loop{bottom[s], bottom[(s + 1) % sides.size()]};
    loop.insert(loop.end(), sides[s].rbegin(), sides[s].rend());
    builder.face(loop, static_cast<std::uint32_t>(2 + s));
  }
}

/// The surface over scattered points.
Sides add_scattered(LeafBuilder& builder, const HeightfieldShape& shape, std::vector<std::string>& notices) {
  const HeightPoints file = read_height_points(shape.file, shape.inside);
  if (file.repeated > 0) {
    notices.push_back("heightfield '" + shape.file + "': " + std::to_string(file.repeated) +
                      (file.repeated == 1 ? " line repeats a point" : " lines repeat points") + ": left out");
  }
  std::vector<std::array<double, 2>> plan;
  for (const auto& p : file.points) plan.push_back({p[0], p[1]});
  const Delaunay surface = delaunay(plan);
  if (surface.triangles.empty()) {
    throw InputError("heightfield: '" + shape.file + "' has " + std::to_string(plan.size()) +
                     (plan.size() == 1 ? " point" : " points, all on one line as seen from above") +
                     ": give three or more that are not");
  }
  std::vector<PointId> ids;
  for (const auto& p : file.points) {
    if (shape.base) check_base(from_double(p[2]), *shape.base);
    ids.push_back(builder.soup().add_point(p[0], p[1], p[2]));
  }
  for (const auto& [a, b, c] : surface.triangles) builder.triangle(ids[a], ids[b], ids[c], 0);
  return sides_of(file.points, surface.border, ids);
}

}  // namespace

std::unique_ptr<PreparedLeaf> prepare_leaf(const HeightfieldShape& shape) {
  if (!shape.file.empty() && !shape.heights.empty()) {
    throw InputError("heightfield: both heights and a file are given: leave one out");
  }
  LeafBuilder builder(shape.base ? Fill::winding : Fill::none);
  std::vector<std::string> notices;
  Sides sides;
  if (holds_height_points(shape.file)) {
    if (shape.within)
      throw LeafKeyError("within", "heightfield: `within` is for grids, and .xyz are points: leave it out");
    sides = add_scattered(builder, shape, notices);
  } else {
    LeafBuilder all(Fill::none);
    LeafBuilder& of_grid = shape.within ? all : builder;
    const GridPoints grid =
        shape.file.empty() ? points_of_tree(of_grid, shape) : points_of_file(of_grid, shape, notices);
    if (!shape.within) add_surface(builder, grid);
    sides = sides_of(shape.within ? add_coarse(builder, all, grid, *shape.within, notices) : grid);
    if (shape.within) {
      for (std::vector<PointId>& side : sides) std::erase_if(side, [](PointId p) { return !p.valid(); });
    }
  }
  for (const std::vector<PointId>& side : sides) {
    if (side.front().valid()) builder.soup().add_curve_end(builder.leaf(), side.front());
  }
  if (shape.base) add_walls(builder, sides, *shape.base);
  return builder.finish(std::move(notices));
}

}  // namespace cnrg
