// Grids have keys and values of the header in any order, then the rows, northern ones first; points are lines of
// x, y and z. Commas are not taken as blanks: a file with decimal commas would be read as other points, without a
// word.
#include "csg/imports/heights.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <numeric>

#include "csg/imports/leaf_file.h"
#include "csg/imports/text_cursor.h"
#include "csg/leaves/leaf.h"
#include "csg/text/escape.h"
#include "csg/text/file.h"
#include "csg/text/table.h"
#include "kernel/exact/integers.h"

namespace cnrg {
namespace {

/// What the header gives for a key.
struct Entry {
  Rational value;
  std::string_view written;
  int line = 0;
};

}  // namespace

HeightGrid read_height_grid(const std::string& path, const std::string& inside) {
  const std::string text = read_leaf_file(path, inside, "give an ESRI ASCII grid");
  TextCursor cursor(path, text, 0);
  std::map<std::string, Entry> header;
  for (;;) {
    TextCursor ahead = cursor;
    const std::string key = lower(ahead.token("a height"));
    if (std::isalpha(static_cast<unsigned char>(key[0])) == 0 || key == "nan" || key == "inf") break;
    cursor = ahead;
    Entry entry;
    entry.written = ahead.token("a number of the header");
    entry.line = ahead.line();
    cursor.decimal("a number of the header", entry.value);
    if (!header.emplace(key, entry).second) cursor.fail("the header gives " + key + " twice: leave one out");
  }
  const auto take_entry = [&](const char* key) -> std::optional<Entry> {
    const auto found = header.extract(key);
    return found ? std::optional(found.mapped()) : std::nullopt;
  };
  const auto take = [&](const char* key) -> std::optional<Rational> {
    const std::optional<Entry> entry = take_entry(key);
    return entry ? std::optional(entry->value) : std::nullopt;
  };
  const auto count = [&](const char* key) {
    const std::optional<Entry> entry = take_entry(key);
    if (!entry)
      cursor.fail(std::string("the header has no ") + key + ": an ESRI ASCII grid starts with ncols and nrows");
    const Rational& value = entry->value;
    if (value.get_den() != 1 || value < 2 || value > 100000) {
      cursor.fail_at(entry->line, std::string(key) + " is " + excerpt(entry->written) +
                                      ": it must be a whole number from 2 to 100000");
    }
    return to_machine<std::size_t>(value.get_num());
  };
  HeightGrid grid;
  grid.columns = count("ncols");
  grid.rows = count("nrows");
  const std::optional<Rational> cell = take("cellsize"), dx = take("dx"), dy = take("dy");
  if (!cell && !(dx && dy)) cursor.fail("the header has no cellsize: add it");
  grid.spacing_x = dx ? *dx : *cell;
  grid.spacing_y = dy ? *dy : *cell;
  if (grid.spacing_x <= 0 || grid.spacing_y <= 0) cursor.fail("the cellsize is not positive: correct it");
  const auto origin = [&](const char* corner, const char* center, const Rational& spacing) -> Rational {
    if (const std::optional<Rational> value = take(center)) return *value;
    if (const std::optional<Rational> value = take(corner)) return *value + spacing / 2;
    return 0;
  };
  grid.origin_x = origin("xllcorner", "xllcenter", grid.spacing_x);
  grid.origin_y = origin("yllcorner", "yllcenter", grid.spacing_y);
  const std::optional<Rational> missing = take("nodata_value");
  const double no_data = missing ? to_double(*missing) : 0;
  if (!header.empty())
    cursor.fail("the header has the unknown word " + in_quotes(header.begin()->first) + ": leave it out");

  grid.heights.assign(std::min(grid.columns * grid.rows, text.size()), 0);
  for (std::size_t row = grid.rows; row-- > 0;) {
    for (std::size_t column = 0; column < grid.columns; ++column) {
      if (!cursor.more()) {
        cursor.fail_at_end("the file ends within row " + std::to_string(grid.rows - row) + " of " +
                           std::to_string(grid.rows));
      }
      const double height = cursor.number("a height");
      const std::size_t at = row * grid.columns + column;
      if (at >= grid.heights.size()) {
        cursor.fail("the file is too short for " + std::to_string(grid.columns * grid.rows) +
                    " heights: it is truncated");
      }
      grid.heights[at] = height;
      if (missing && height == no_data) {
        grid.missing.resize(grid.heights.size(), false);  // all of them, or the file is too short
        grid.missing[at] = true;
      }
    }
  }
  if (cursor.more())
    cursor.fail("more heights follow after " + std::to_string(grid.rows) + " rows: correct ncols or nrows");
  return grid;
}

bool holds_height_points(const std::string& path) { return extension_of(path) == ".xyz"; }

HeightPoints read_height_points(const std::string& path, const std::string& inside) {
  const std::string text = read_leaf_file(path, inside, "give a line `x y z` for each point");
  TextCursor cursor(path, text, '#');
  std::vector<std::array<double, 3>> points;
  std::vector<int> lines;
  for (; cursor.more(); cursor.next_line()) {
    const int line = cursor.line();
    std::array<double, 3> point;
    std::size_t count = 0;
    for (double& x : point) {
      if (!cursor.more_in_line()) {
        cursor.fail_at(line, "a line of " + counted(count, "entry", "entries") +
                                 ": give x, y and z of a point with blanks between them");
      }
      x = cursor.number("x, y or z of a point");
      ++count;
    }
    points.push_back(point);
    lines.push_back(line);
  }

  // One height at each place: equal places are neighbours in the order of x, y and line.
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto place = [&](std::size_t i) { return std::array<double, 2>{points[i][0], points[i][1]}; };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return place(i) < place(j); });
  std::vector<bool> repeats(points.size(), false);
  for (std::size_t k = 1, first = 0; k < order.size(); ++k) {
    const std::size_t a = order[first], b = order[k];
    if (place(a) != place(b)) {
      first = k;
      continue;
    }
    if (points[a][2] != points[b][2]) {
      cursor.fail_at(lines[b], "another height at the place of line " + std::to_string(lines[a]) +
                                   ": a height field has one height at each x and y; leave one out, or give the "
                                   "surface as a mesh");
    }
    repeats[b] = true;
  }
  HeightPoints result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (repeats[i]) ++result.repeated;
    else result.points.push_back(points[i]);
  }
  return result;
}

}  // namespace cnrg
