// OFF, STL and PLY: the outer boundary of the solid regions as triangles, normals outward. Edges with more than
// two triangles, where solids touch, are what they are: the formats hold triangles by point number (STL by
// coordinates), and no two points are merged or split.
//
// The binary form of PLY says the same as its text. That of STL has numbers of 24 bits, so it is refused where
// these would make facets cross: nothing else could be told of a file that holds no more.
#include <array>
#include <bit>
#include <cmath>

#include "csg/formats/formats.h"
#include "csg/result/rounding.h"
#include "csg/result/solid.h"
#include "csg/text/digits.h"
#include "csg/text/escape.h"
#include "kernel/base/vectors.h"

namespace cnrg {
namespace {

struct RoundedSolid {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  RoundingReport rounding;
};

/// Each double rounded to 24 bits; `moved` counts points that are not their exact coordinates then.
void round_to_floats(const ResultView& view, const FlatComplex& flat, RoundedPoints& points) {
  points.moved = 0;
  points.reach.resize(points.xyz.size());
  for (std::size_t i = 0; i < points.xyz.size(); ++i) {
    const RationalPoint exact = view.complex->points.rational(flat.points[i]);
    bool moved = false;
    double off = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      double& x = points.xyz[i][k];
      const double nearest = x;
      x = static_cast<double>(static_cast<float>(x));
      off = std::max(off, std::abs(x - nearest));
      if (!std::isfinite(x)) {
        throw InputError(
            "a coordinate of the result is beyond the range of binary STL, 3.4e38; leave out --binary");
      }
      moved = moved || from_double(x) != exact[k];
    }
    points.moved += moved;
    if (moved) points.reach[i] = std::nextafter(points.reach[i] + off, std::numeric_limits<double>::infinity());
  }
}

/// `floats`: numbers of 24 bits, which must not break the result.
RoundedSolid rounded_solid(const ResultView& view, const std::string& format, bool floats = false) {
  FlatComplex flat = flatten(view, Flattening::shapes);
  SolidBoundary boundary = solid_boundary(flat, format);
  std::vector<VertexId> used;
  for (const auto p : boundary.points) used.push_back(flat.points[p]);
  flat.points = std::move(used);
  RoundedPoints points = round_points(view, flat);
  if (floats) round_to_floats(view, flat, points);
  Drawing drawing{boundary.triangles};
  drawing.sides.assign(drawing.triangles.size(), {0, 1});  // outside, inside
  const RoundingReport rounding = report_rounding(points, drawing);
  if (floats && !rounding.embedded) {
    throw RoundingFault(format + " in binary holds numbers of 24 bits, and rounding to them breaks the result (" +
                        std::to_string(points.moved) +
                        " vertices move); leave out --binary: the text holds doubles");
  }
  return {std::move(points.xyz), std::move(boundary.triangles), rounding};
}

/// Points, then triangles, one to a line.
void append_all(std::string& text, const RoundedSolid& solid) {
  append_lines(text, solid.points.size(),
               [&](std::string& out, std::size_t p) { Line(out) << solid.points[p] << '\n'; });
  append_lines(text, solid.triangles.size(), [&](std::string& out, std::size_t i) {
    const auto& [a, b, c] = solid.triangles[i];
    Line(out) << "3 " << a << ' ' << b << ' ' << c << '\n';
  });
}

std::string ply_header(const RoundedSolid& solid, const std::string& format) {
  return "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(solid.points.size()) +
         "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
         std::to_string(solid.triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
}

/// The least byte first.
template <class Number>
void append_bytes(std::string& bytes, Number number) {
  for (std::size_t k = 0; k < sizeof number; ++k) bytes += static_cast<char>(number >> (8 * k) & 0xff);
}

/// The unit normal, or zero for a triangle that rounding has flattened.
std::array<double, 3> normal(const RoundedSolid& solid, const std::array<std::uint32_t, 3>& t) {
  const auto &a = solid.points[t[0]], &b = solid.points[t[1]], &c = solid.points[t[2]];
  const DoubleVector n = cross(minus(b, a), minus(c, a));
  return length(n) > 0 && std::isfinite(length(n)) ? unit(n) : DoubleVector{0, 0, 0};
}

}  // namespace

FileText off_text(const ResultView& view) {
  const RoundedSolid solid = rounded_solid(view, "OFF");
  std::string text =
      "OFF\n" + std::to_string(solid.points.size()) + " " + std::to_string(solid.triangles.size()) + " 0\n";
  append_all(text, solid);
  return {std::move(text), solid.rounding};
}

FileText ply_text(const ResultView& view) {
  const RoundedSolid solid = rounded_solid(view, "PLY");
  std::string text = ply_header(solid, "ascii");
  append_all(text, solid);
  return {std::move(text), solid.rounding};
}

FileText ply_bytes(const ResultView& view) {
  const RoundedSolid solid = rounded_solid(view, "PLY");
  std::string bytes = ply_header(solid, "binary_little_endian");
  for (const auto& p : solid.points) {
    for (const double x : p) append_bytes(bytes, std::bit_cast<std::uint64_t>(x == 0 ? 0.0 : x));
  }
  for (const auto& t : solid.triangles) {
    bytes += '\3';
    for (const std::uint32_t p : t) append_bytes(bytes, p);
  }
  return {std::move(bytes), solid.rounding};
}

/// 80 bytes that are no text (they must not begin with `solid`), the number of triangles; of each its normal, its
/// corners, and two bytes without a meaning.
FileText stl_bytes(const ResultView& view) {
  const RoundedSolid solid = rounded_solid(view, "STL", true);
  std::string bytes = "written by cnrg";
  bytes.resize(80, ' ');
  append_bytes(bytes, static_cast<std::uint32_t>(solid.triangles.size()));
  const auto add = [&](const std::array<double, 3>& v) {
    for (const double x : v)
      append_bytes(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(x == 0 ? 0.0 : x)));
  };
  for (const auto& t : solid.triangles) {
    add(normal(solid, t));
    for (const auto p : t) add(solid.points[p]);
    append_bytes(bytes, std::uint16_t{0});
  }
  return {std::move(bytes), solid.rounding};
}

FileText stl_text(const ResultView& view) {
  const RoundedSolid solid = rounded_solid(view, "STL");
  const std::string name = shown(view.node);
  std::string text = "solid " + name + "\n";
  const PointTexts points(solid.points);
  append_lines(text, solid.triangles.size(), [&](std::string& out, std::size_t i) {
    const auto& t = solid.triangles[i];
    Line line(out);
    line << "facet normal " << normal(solid, t) << "\nouter loop\n";
    for (const auto p : t) line << "vertex " << points[p] << '\n';
    line << "endloop\nendfacet\n";
  });
  text += "endsolid " + name + "\n";
  return {std::move(text), solid.rounding};
}

}  // namespace cnrg
