// A coordinate has 24 characters at most: a sign, 17 digits, a point, an exponent of five.
#include "csg/text/digits.h"

#include "kernel/base/parallel.h"

namespace cnrg {

PointTexts::PointTexts(const std::vector<std::array<double, 3>>& points) : of_(points.size()) {
  for_each_index(points.size(), [&](std::size_t p) {
    Point& to = of_[p];
    char* end = to.text;
    for (std::size_t k = 0; k < 3; ++k) {
      if (k > 0) *end++ = ' ';
      const double x = points[p][k] == 0 ? 0 : points[p][k];
      end = std::to_chars(end, to.text + sizeof to.text, x).ptr;
      to.ends[k] = static_cast<std::uint8_t>(end - to.text);
    }
  });
}

}  // namespace cnrg
