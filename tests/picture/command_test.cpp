// Pictures as people ask for them: what is in the files, which options are whose, what is refused.
#include <cairo/cairo.h>

#include <memory>

#include "tests/app/program.h"
#include "tests/catch.h"

using namespace cnrg;
using Catch::Contains;

namespace {

const char* const kTree =
    "cnrg: 1\n"
    "materials: {red: {color: \"#ff0000\"}, blue: {color: \"#0000ff\"}}\n"
    "nodes:\n"
    "  low:  {box: {min: [0, 0, 0], max: [2, 2, 1]}, material: red}\n"
    "  high: {box: {min: [0, 0, 1], max: [2, 2, 2]}, material: blue}\n"
    "  pin:  {polyline: [[1, 1, 1/2], [1, 1, 3]]}\n"
    "  both: {union: [low, high], dominance: left}\n"
    "  all:  {union: [both, pin]}\n"
    "  less: {difference: [low, {box: {min: [1, 1, -1], max: [3, 3, 3]}}]}\n"
    "  open: {halfspace: {point: [0, 0, 0], normal: [0, 0, 1]}}\n"
    "  none: {intersection: [low, {box: {min: [7, 7, 7], max: [8, 8, 8]}}]}\n"
    "  spot: {points: [[1, 2, 3]]}\n"
    "result: all\n";

struct Png {
  std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface;
  explicit Png(const std::string& path)
      : surface(cairo_image_surface_create_from_png(path.c_str()), cairo_surface_destroy) {
    REQUIRE(cairo_surface_status(surface.get()) == CAIRO_STATUS_SUCCESS);
  }
  int width() const { return cairo_image_surface_get_width(surface.get()); }
  int height() const { return cairo_image_surface_get_height(surface.get()); }
  std::array<int, 3> at(int x, int y) const {
    const unsigned char* row = cairo_image_surface_get_data(surface.get()) +
                               static_cast<std::ptrdiff_t>(y) * cairo_image_surface_get_stride(surface.get());
    const unsigned char* p = row + static_cast<std::ptrdiff_t>(4) * x;
    return {p[2], p[1], p[0]};
  }
  /// How many pixels are of a color between these.
  int count(const std::array<int, 3>& low, const std::array<int, 3>& high) const {
    int n = 0;
    for (int y = 0; y < height(); ++y) {
      for (int x = 0; x < width(); ++x) {
        const std::array<int, 3> c = at(x, y);
        bool in = true;
        for (std::size_t k = 0; k < 3; ++k) in = in && c[k] >= low[k] && c[k] <= high[k];
        n += in ? 1 : 0;
      }
    }
    return n;
  }
};

struct Studio {
  Workshop w;
  Studio() { w.write("t.yaml", kTree); }
  Outcome eval(const std::string& rest) const { return w.run("eval t.yaml --quiet " + rest); }
  std::string refusal(const std::string& rest) const {
    const Outcome o = eval(rest);
    CHECK(o.status == 2);
    CHECK(o.out.empty());
    CHECK(std::count(o.err.begin(), o.err.end(), '\n') >= 1);
    return o.err;
  }
  Png png(const std::string& rest) const {
    const Outcome o = eval(rest + " -o p.png");
    INFO(o.err);
    REQUIRE(o.status == 0);
    return Png(w.path("p.png").string());
  }
};

}  // namespace

TEST_CASE("a picture shows materials where they are, on white", "[picture]") {
  const Studio s;
  const Png p = s.png("--node both --camera 0,0 --size 200x200");
  // Two layers of 200 by 100 pixels of .svg, seen from the front.
  CHECK(p.height() > p.width());  // and the key of colors
  const int half = p.width() / 2, quarter = p.width() / 4;
  const std::array<int, 3> upper = p.at(half, quarter), lower = p.at(half, 3 * quarter), corner = p.at(2, 2);
  CHECK((upper[2] > 120 && upper[0] < 40));
  CHECK((lower[0] > 120 && lower[2] < 40));
  CHECK(corner == std::array<int, 3>{255, 255, 255});
  // From below the lower one alone.
  const Png below = s.png("--node both --camera 0,-90 --size 200x200");
  CHECK(below.count({0, 0, 100}, {60, 60, 255}) < 1000);  // in the key alone
  CHECK(below.count({100, 0, 0}, {255, 60, 60}) > 10000);
}

TEST_CASE("a cut shows what is inside, a wire in it too", "[picture]") {
  const Studio s;
  const std::string small = " --size 200x200 --camera 0,10";
  const int whole = s.png("--node all" + small).count({150, 50, 0}, {180, 90, 20});
  const int open = s.png("--node all --cut y=1" + small).count({150, 50, 0}, {180, 90, 20});
  CHECK(whole > 50);          // the part of the pin above the box
  CHECK(open > 1.2 * whole);  // and that in the plane of the cut
}

TEST_CASE("the same tree gives the same picture", "[picture]") {
  const Studio s;
  for (const std::string extension : {"svg", "png", "pdf"}) {
    CHECK(s.eval("--opacity 0.5 --labels names,v -o a." + extension + " --threads 1").status == 0);
    CHECK(s.eval("--opacity 0.5 --labels names,v -o b." + extension + " --threads 3").status == 0);
    CHECK(!s.w.read("a." + extension).empty());
    CHECK((s.w.read("a." + extension) == s.w.read("b." + extension)));
  }
  CHECK_THAT(s.w.read("a.svg"), Catch::StartsWith("<svg") && Catch::EndsWith("</svg>\n"));
  CHECK_THAT(s.w.read("a.pdf"), Catch::StartsWith("%PDF"));
}

TEST_CASE("options are for all panels, or for that of their node", "[picture]") {
  const Studio s;
  // One panel, two panels, two files with one each.
  const int one = s.png("--node both --size 200x200").width();
  CHECK(s.png("--node both --node both --size 200x200").width() > 3 * one / 2);
  CHECK(s.eval("--size 200x200 --node low -o a.png --node high -o b.png").status == 0);
  const std::array<int, 3> red{100, 0, 0}, reds{255, 60, 60}, blue{0, 0, 100}, blues{60, 60, 255};
  CHECK(Png(s.w.path("a.png").string()).count(red, reds) > 1000);
  CHECK(Png(s.w.path("a.png").string()).count(blue, blues) == 0);
  CHECK(Png(s.w.path("b.png").string()).count(blue, blues) > 1000);
  // From below blue is hidden by red: in both panels, or in the second alone.
  const std::string two = "--node both --node both --camera 0,90 --size 200x200";
  CHECK(s.png("--camera 0,-90 " + std::string("--node both --node both")).count(blue, blues) < 1000);
  const Png second = s.png("--node both --camera 0,-90 " + two);
  CHECK(second.count(blue, blues) > 1000);
  CHECK(second.count(red, reds) > 1000);
  // Six panels have two rows.
  const Png six = s.png("--size 100x100 --node low --node low --node low --node low --node low --node low");
  CHECK(six.height() > 2 * s.png("--size 100x100 --node low --node low").height() - 100);
}

TEST_CASE("captions are texts, whatever is in them", "[picture]") {
  const Studio s;
  const std::string plain = "--size 100x100 --node low --node low ";
  const int without = s.png(plain + "--caption ''").height();
  CHECK(s.png("--size 100x100 --node low --caption '' --node low --caption ''").height() < without);
  for (const std::string text : {"'<b>&amp;\"'", "$'a\\x01\\x1b[31mb'", "$'\\xff\\xfe'", "'äöü ∪ ∩'"}) {
    INFO(text);
    const Outcome o = s.w.shell("bash -c \"" CNRG_PROGRAM " eval t.yaml --quiet --node low --caption " + [&] {
      std::string out;
      for (const char c : text) {
        if (c == '"' || c == '\\' || c == '$') out += '\\';
        out += c;
      }
      return out;
    }() + " -o p.svg -o p.png -o p.pdf\" >.out 2>.err");
    CHECK(o.err.find("error") == std::string::npos);
    CHECK(o.status == 0);
    const std::string svg = s.w.read("p.svg");
    CHECK_THAT(svg, Catch::EndsWith("</svg>\n"));
    CHECK(std::none_of(svg.begin(), svg.end(),
                       [](char c) { return static_cast<unsigned char>(c) < 32 && c != '\n'; }));
  }
}

TEST_CASE("ghosts are what a difference took away", "[picture]") {
  const Studio s;
  const std::string grey = "--node less --camera 30,30 --size 200x200";
  const Png plain = s.png(grey), ghosts = s.png(grey + " --ghosts");
  const std::array<int, 3> pale{200, 200, 200}, white{250, 252, 254};
  CHECK(ghosts.count(pale, white) > plain.count(pale, white) + 1000);
}

TEST_CASE("pictures of nothing, and of next to nothing", "[picture]") {
  const Studio s;
  CHECK(s.png("--node none").width() > 0);
  const Png spot = s.png("--node spot");
  CHECK(spot.count({150, 50, 0}, {180, 90, 20}) > 20);
  CHECK(s.eval("--node open -o open.svg").status == 0);
  s.w.write("far.yaml",
            "cnrg: 1\nnodes: {b: {box: {min: [0, 0, 0], max: [\"1e240\", \"1e-240\", 1]}}}\nresult: b\n");
  const Outcome far = s.w.run("eval far.yaml --quiet -o far.svg");
  INFO(far.err);
  CHECK(far.status == 0);
  s.w.write("far.yaml", "cnrg: 1\nnodes: {b: {box: {min: [0, 0, 0], max: [\"1e260\", 1, 1]}}}\nresult: b\n");
  CHECK_THAT(s.w.run("eval far.yaml --quiet -o far.svg").err, Contains("far.yaml:2:") && Contains("1e250"));
}

TEST_CASE("what is no picture is refused in one line", "[picture]") {
  const Studio s;
  CHECK_THAT(s.refusal("--camera 1,2 -o x.vtu"), Contains("options of pictures are given, and no picture"));
  CHECK_THAT(s.refusal("-o x.svg --camera 1"), Contains("--camera: `1` is not two angles"));
  CHECK_THAT(s.refusal("-o x.svg --camera 1,95"), Contains("--camera: `95` is not an angle from -90 to 90"));
  CHECK_THAT(s.refusal("-o x.svg --cut w=1"), Contains("--cut: `w=1` is not a plane"));
  CHECK_THAT(s.refusal("-o x.svg --cut 0,0,0,1"), Contains("--cut: `0,0,0,1` is not a plane"));
  CHECK_THAT(s.refusal("-o x.svg --size 10x10"), Contains("--size: `10` is not a size"));
  CHECK_THAT(s.refusal("-o x.svg --size big"), Contains("--size: `big` is not a size"));
  // Nothing behind the last separator is a part that is missing, not one that is not there.
  CHECK_THAT(s.refusal("-o x.svg --camera 1,2,"), Contains("--camera: `1,2,` is not two angles"));
  CHECK_THAT(s.refusal("-o x.svg --cut 1,2,3,4,"), Contains("--cut: `1,2,3,4,` is not a plane"));
  CHECK_THAT(s.refusal("-o x.svg --size 64x48x"), Contains("--size: `64x48x` is not a size"));
  CHECK_THAT(s.refusal("-o x.svg --labels v,"), Contains("--labels: `v,` is not a list"));
  CHECK_THAT(s.refusal("-o x.svg --labels v,q"), Contains("--labels: `v,q` is not a list"));
  CHECK_THAT(s.refusal("-o x.svg --opacity 0"), Contains("--opacity: `0` is not a number"));
  CHECK_THAT(s.refusal("-o x.svg --explode nan"), Contains("--explode: `nan` is not a number"));
  CHECK_THAT(s.refusal("-o x.svg --color-by moon"), Contains("--color-by: `moon` is not material"));
  CHECK_THAT(s.refusal("-o x.svg --node open --cut z=0"), Contains("t.yaml:") && Contains("it is unbounded"));
  CHECK_THAT(s.refusal("-o x.svg --node less --ghosts --cut z=0"),
             Contains("neither with --cut nor with --explode"));
  CHECK_THAT(s.refusal("-o x.svg --node low --cut y=9"), Contains("t.yaml:") && Contains("takes away all"));
  CHECK_THAT(s.refusal("-o x.svg -o x.vtu --node low --node high --node both"), Contains("3 times --node"));
  CHECK_THAT(s.refusal("-o x.tiff"), Contains("use one of") && Contains(".svg .png .pdf"));
  CHECK_THAT(s.refusal("-o t.yaml"), Contains("t.yaml"));
}
