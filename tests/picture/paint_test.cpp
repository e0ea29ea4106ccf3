// Pictures as files: what is painted where, read back from the bytes.
#include "csg/picture/paint.h"

#include <cairo/cairo.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <regex>

#include "kernel/base/error.h"
#include "tests/catch.h"

using namespace cnrg;

namespace {

constexpr Rgb kRed{0.8, 0.1, 0.1}, kBlue{0.1, 0.2, 0.8};

Figure::Area rectangle(double x0, double y0, double x1, double y1, const Rgb& color) {
  Figure::Area area;
  area.loops = {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
  area.color = color;
  return area;
}

/// Two squares side by side, 8 by 4 in all, and nothing else.
Figure two_squares() {
  Figure figure;
  figure.areas = {rectangle(0, 0, 4, 4, kRed), rectangle(4, 0, 8, 4, kBlue)};
  figure.low = {0, 0};
  figure.high = {8, 4};
  return figure;
}

/// A .png, decoded.
class Pixels {
 public:
  explicit Pixels(const std::string& bytes) : rest_(bytes) {
    surface_.reset(cairo_image_surface_create_from_png_stream(
        [](void* self, unsigned char* to, unsigned n) {
          std::string& rest = *static_cast<std::string*>(self);
          if (rest.size() < n) return CAIRO_STATUS_READ_ERROR;
          std::memcpy(to, rest.data(), n);
          rest.erase(0, n);
          return CAIRO_STATUS_SUCCESS;
        },
        &rest_));
    REQUIRE(cairo_surface_status(surface_.get()) == CAIRO_STATUS_SUCCESS);
  }
  int width() const { return cairo_image_surface_get_width(surface_.get()); }
  int height() const { return cairo_image_surface_get_height(surface_.get()); }
  /// At shares of width and height, from the upper left corner.
  Rgb at(double x, double y) const { return pixel(static_cast<int>(x * width()), static_cast<int>(y * height())); }
  Rgb pixel(int x, int y) const {
    std::uint32_t word = 0;
    std::memcpy(
        &word,
        cairo_image_surface_get_data(surface_.get()) + y * cairo_image_surface_get_stride(surface_.get()) + 4 * x,
        4);
    return {(word >> 16 & 255) / 255.0, (word >> 8 & 255) / 255.0, (word & 255) / 255.0};
  }
  /// How many pixels have about this color.
  int count(const Rgb& color) const {
    int n = 0;
    for (int y = 0; y < height(); ++y)
      for (int x = 0; x < width(); ++x) n += near(pixel(x, y), color);
    return n;
  }
  static bool near(const Rgb& a, const Rgb& b) {
    return std::abs(a[0] - b[0]) < 0.02 && std::abs(a[1] - b[1]) < 0.02 && std::abs(a[2] - b[2]) < 0.02;
  }

 private:
  std::string rest_;
  std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface_{nullptr, cairo_surface_destroy};
};

Pixels pixels(const std::vector<Panel>& panels, std::optional<PictureSize> size = PictureSize{200, 100}) {
  return Pixels(picture_bytes("p.png", panels, size));
}
std::string svg(const std::vector<Panel>& panels, std::optional<PictureSize> size = PictureSize{200, 100}) {
  return picture_bytes("p.svg", panels, size);
}
int count(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  return static_cast<int>(std::distance(std::sregex_iterator(text.begin(), text.end(), regex), {}));
}

/// A number of the first element that fits the pattern.
double number(const std::string& text, const std::string& pattern) {
  std::smatch match;
  REQUIRE(std::regex_search(text, match, std::regex(pattern)));
  return std::stod(match[1]);
}

}  // namespace

TEST_CASE("areas have their colors, at their places, and nothing shines through between them", "[picture]") {
  const Pixels p = pixels({{two_squares(), ""}});
  CHECK(p.height() == 2 * (100 + 8));  // the box, in which rims are, and the margins
  CHECK(Pixels::near(p.at(0.25, 0.5), kRed));
  CHECK(Pixels::near(p.at(0.75, 0.5), kBlue));
  CHECK(Pixels::near(p.pixel(1, 1), {1, 1, 1}));
  // From one square into the other no pixel is lighter than both.
  for (int x = p.width() / 2 - 6; x < p.width() / 2 + 6; ++x) {
    const Rgb c = p.pixel(x, p.height() / 2);
    CHECK(c[1] < 0.25);
  }
}

TEST_CASE("the picture is as high as what is in it", "[picture]") {
  Figure flat = two_squares();
  for (auto& area : flat.areas)
    for (auto& point : area.loops[0]) point[1] /= 8;
  flat.high[1] = 0.5;
  const Pixels p = pixels({{flat, ""}});
  CHECK(p.height() < p.width() / 5);
}

TEST_CASE("panels have one scale, and their captions are below", "[picture]") {
  Figure small;
  small.areas = {rectangle(0, 0, 2, 2, kRed)};
  small.high = {2, 2};
  const Pixels p = pixels({{two_squares(), ""}, {small, ""}});
  // The small square is a quarter of the red one beside it.
  const double red = p.count(kRed), blue = p.count(kBlue);
  CHECK(red / blue == Approx(1.25).epsilon(0.02));
  const std::string text = svg({{two_squares(), "left"}, {small, "right"}});
  const double left = number(text, "x=\"([0-9]+)\"[^>]*>left<"),
               right = number(text, "x=\"([0-9]+)\"[^>]*>right<");
  CHECK(left < right);
  CHECK(number(text, "y=\"([0-9]+)\"[^>]*>left<") == number(text, "y=\"([0-9]+)\"[^>]*>right<"));
  CHECK(text.find("aria-label=\"left; right\"") != std::string::npos);
}

TEST_CASE("more than five panels are in rows of one length", "[picture]") {
  const std::vector<Panel> six(6, {two_squares(), ""}), five(5, {two_squares(), ""});
  const Pixels rows = pixels(six), row = pixels(five);
  CHECK(rows.width() < row.width());
  CHECK(rows.height() > 1.8 * row.height());
}

TEST_CASE("what is missing is hatched, dashed, hollow", "[picture]") {
  Figure figure = two_squares();
  figure.areas[0].missing = true;
  figure.areas[1].sheet = true;
  figure.strokes.push_back({{{0, 0}, {8, 0}}, false, Figure::Line::edge, kInk, true, false});
  figure.dots.push_back({{0, 4}, Figure::Mark::vertex, kInk, true, false});
  figure.dots.push_back({{4, 2}, Figure::Mark::isolated, kInk, false, false});
  const std::string text = svg({{figure, ""}});
  CHECK(count(text, "<pattern ") == 2);
  CHECK(count(text, "stroke-dasharray") == 1);
  CHECK(count(text, "<circle ") == 3);
  CHECK(count(text, "<circle [^>]*fill=\"#fff\"") == 1);  // the hollow one
  CHECK(count(text, "<circle [^>]*fill=\"none\"") == 1);  // the ring
  // Between the lines of a hatch the area is nearly white; a weave is nearly its color.
  const Pixels p = pixels({{figure, ""}});
  int light = 0, dark = 0, blue = 0;
  for (int x = 0; x < 60; ++x) {
    const Rgb left = p.pixel(p.width() / 8 + x, p.height() / 3),
              right = p.pixel(p.width() * 5 / 8 + x, p.height() / 3);
    light += left[1] > 0.7;
    dark += left[1] < 0.5;
    blue += right[2] > 0.6 && right[0] < 0.2;
  }
  CHECK(light > 30);
  CHECK(dark > 5);
  CHECK(blue == 60);
}

TEST_CASE("strokes that go on are one line, others are not", "[picture]") {
  Figure figure;
  figure.high = {8, 4};
  const auto stroke = [&](Point2 a, Point2 b) {
    figure.strokes.push_back({{a, b}, false, Figure::Line::edge, kInk, false, false});
  };
  stroke({0, 0}, {4, 0});
  stroke({4, 4}, {4, 0});
  CHECK(count(svg({{figure, ""}}), "d=\"m[^m\"]*\"") == 1);
  stroke({4, 0}, {8, 0});  // a third end there
  CHECK(count(svg({{figure, ""}}), "d=\"m[^m\"]*m[^m\"]*m[^m\"]*\"") == 1);
  Figure ring;
  ring.high = {4, 4};
  std::swap(figure, ring);
  stroke({0, 0}, {4, 0});
  stroke({4, 4}, {4, 0});
  stroke({4, 4}, {0, 0});
  CHECK(count(svg({{figure, ""}}), "d=\"m[^m\"]*z\"") == 1);
}

TEST_CASE("labels stand where there is room, and never over one another", "[picture]") {
  Figure figure = two_squares();
  figure.labels = {{"wide", {{{2, 2}, 2}}}, {"too wide for its place", {{{6, 2}, 0.5}}}};
  for (int i = 0; i < 12; ++i) figure.labels.push_back({"v" + std::to_string(i), {{{8, 4}, 0}}});
  const std::string text = svg({{figure, ""}});
  CHECK(text.find(">wide<") != std::string::npos);
  CHECK(text.find("too wide") == std::string::npos);
  // Beside one point there are eight places, and fewer that are free of each other.
  std::vector<std::pair<double, double>> places;
  const std::regex label("<text x=\"([0-9]+)\" y=\"([0-9]+)\"[^>]*>v[0-9]+<");
  for (std::sregex_iterator i(text.begin(), text.end(), label), end; i != end; ++i) {
    places.emplace_back(std::stod((*i)[1]), std::stod((*i)[2]));
  }
  CHECK(places.size() >= 2);
  CHECK(places.size() <= 8);
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t k = i + 1; k < places.size(); ++k) {
      const bool apart = std::abs(places[i].first - places[k].first) > 100 ||
                         std::abs(places[i].second - places[k].second) >= 120;
      CHECK(apart);
    }
  }
}

TEST_CASE("a label beside a vertex keeps off the lines", "[picture]") {
  Figure figure = two_squares();
  figure.strokes.push_back({{{0, 0}, {8, 4}}, false, Figure::Line::edge, kInk, false, false});
  figure.labels = {{"v1", {{{4, 2}, 0}}}};
  const std::string text = svg({{figure, ""}});
  // The line goes up to the right: the text is above it to the left, or below it to the right.
  const double width = number(text, "viewBox=\"0 0 ([0-9]+) "),
               height = number(text, "viewBox=\"0 0 [0-9]+ ([0-9]+)");
  const double x = number(text, "<text x=\"([0-9]+)\"[^>]*>v1<") - width / 2;
  const double y = height / 2 - (number(text, " y=\"([0-9]+)\"[^>]*>v1<") - 43);  // letters stand that much lower
  CHECK(x * y < 0);
}

TEST_CASE("colors have a key unless labels name them", "[picture]") {
  Figure figure = two_squares();
  figure.keys = {{kRed, "clay"}};
  CHECK(svg({{figure, ""}}).find("clay") == std::string::npos);
  figure.keys.push_back({kBlue, "marl"});
  const std::string text = svg({{figure, ""}, {figure, ""}});
  CHECK(count(text, ">clay<") == 1);
  CHECK(count(text, ">marl<") == 1);
  figure.labels = {{"clay", {{{2, 2}, 2}}}, {"marl", {{{6, 2}, 2}}}};
  CHECK(count(svg({{figure, ""}}), ">clay<") == 1);  // the label
  // A color that stands for two things explains nothing.
  figure.labels.clear();
  figure.keys.push_back({kBlue, "coal"});
  CHECK(count(svg({{figure, ""}}), ">clay<") == 0);
}

TEST_CASE("texts from files are texts", "[picture]") {
  Figure figure = two_squares();
  figure.labels = {{"a<b>&\"c\"", {{{4, 2}, 4}}}};
  const std::string hostile = "x\x1b[2J\n</svg><script>\xe2\x80\xae";
  const std::string text = svg({{figure, hostile}});
  CHECK(text.find("a&lt;b&gt;&amp;&quot;c&quot;") != std::string::npos);
  CHECK(text.find("<script") == std::string::npos);
  CHECK(text.find("\x1b") == std::string::npos);
  CHECK(text.find("\\x1b[2J") != std::string::npos);
  CHECK(text.find("\\u202e") != std::string::npos);
  // Other scripts: as they are in .svg; in files that bring their font, as escapes where it has no letters for
  // them.
  CHECK(svg({{figure, "\xe4\xb8\xad"}}).find("\xe4\xb8\xad") != std::string::npos);
  CHECK(picture_bytes("p.png", {{figure, "\xe4\xb8\xad"}}) == picture_bytes("p.png", {{figure, "\\u4e2d"}}));
}

TEST_CASE("the same figures give the same bytes, without a date", "[picture]") {
  Figure figure = two_squares();
  figure.labels = {{"clay", {{{2, 2}, 2}}}};
  for (const char* const path : {"p.png", "p.svg", "p.pdf"}) {
    INFO(path);
    const std::string bytes = picture_bytes(path, {{figure, "caption"}});
    CHECK(bytes == picture_bytes(path, {{figure, "caption"}}));
    CHECK(bytes.find("CreationDate") == std::string::npos);
  }
  CHECK(picture_bytes("p.PDF", {{figure, ""}}).substr(0, 5) == "%PDF-");
  CHECK(is_picture("a.SVG"));
  CHECK_FALSE(is_picture("a.vtu"));
}

TEST_CASE("figures without extent, and of the largest coordinates, are painted", "[picture]") {
  Figure point;
  point.dots.push_back({{3, 3}, Figure::Mark::isolated, kInk, false, false});
  point.low = point.high = {3, 3};
  CHECK(pixels({{point, ""}}).count(kInk) > 20);
  Figure huge = two_squares();
  for (auto& area : huge.areas)
    for (auto& p : area.loops[0]) p = {(p[0] - 4) * 4e307, (p[1] - 2) * 4e307};
  huge.low = {-1.6e308, -8e307};
  huge.high = {1.6e308, 8e307};
  const Pixels p = pixels({{huge, ""}});
  CHECK(Pixels::near(p.at(0.25, 0.5), kRed));
  CHECK(Pixels::near(p.at(0.75, 0.5), kBlue));
  CHECK(svg({{Figure{}, "nothing"}}).find(">empty<") != std::string::npos);
}

TEST_CASE("a .png that cairo cannot hold is refused, a .svg of that size is not", "[picture]") {
  const std::vector<Panel> row(5, {two_squares(), ""});
  CHECK_THROWS_WITH(picture_bytes("p.png", row, PictureSize{8000, 6000}),
                    Catch::Contains("more than 32,767 pixels") && Catch::Contains("--size"));
  CHECK_NOTHROW(picture_bytes("p.svg", row, PictureSize{8000, 6000}));
}
