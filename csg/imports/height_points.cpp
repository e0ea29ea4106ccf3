// The reader of points as lines of x, y and z.
//
// Commas are not taken as blanks: a file with decimal commas would be read as other points, without a word.
#include "csg/imports/height_points.h"

#include <algorithm>
#include <numeric>

#include "csg/imports/leaf_file.h"
#include "csg/imports/text_cursor.h"
#include "csg/text/file.h"
#include "csg/text/table.h"

namespace cnrg {

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
