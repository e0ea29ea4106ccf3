// OBJ: every face as a group of triangles, wires as `l`, isolated points as `p`. The group of a face is named
// after its number and after the regions behind and in front of it (`none` outside), so that walls keep both.
#include "csg/formats/formats.h"
#include "csg/result/rounding.h"
#include "csg/result/solid.h"
#include "csg/text/digits.h"
#include "csg/text/escape.h"

namespace cnrg {
namespace {

/// A region as one word: its name, or `region` and its number. A backslash would go on with the next line, and `#`
/// begin a comment.
std::string word_of(const ResultView& view, const FlatComplex& flat, FlatComplex::Index region) {
  if (!flat.active(region)) return "none";
  const Component component = flat.regions[region].component;
  std::string word = attributes_of(view, component).name;
  if (word.empty()) word = "region" + std::to_string(component);
  word = shown(word);
  for (char& c : word) {
    if (c == ' ' || c == '\\' || c == '#') c = '_';
  }
  return word;
}

}  // namespace

FileText obj_text(const ResultView& view) {
  const FlatComplex flat = flatten(view, Flattening::shapes);
  require_closed_and_bounded(flat, "OBJ");
  const RoundedPoints points = round_points(view, flat);
  Drawing drawing;
  std::string text = "# Groups of faces: number, region behind, region in front\n";
  append_lines(text, points.xyz.size(),
               [&](std::string& out, std::size_t p) { Line(out) << "v " << points.xyz[p] << '\n'; });
  std::vector<std::string> words(flat.regions.size());
  for (FlatComplex::Index r = 0; r < words.size(); ++r) words[r] = word_of(view, flat, r);
  const auto word = [&](FlatComplex::Index r) { return r == FlatComplex::kNone ? "none" : words[r]; };
  // Faces between the cells of one component are not drawn.
  const auto place = [&](FlatComplex::Index region) {
    return flat.active(region) ? std::uint32_t(flat.regions[region].component) : 0;
  };
  std::vector<char> drawn(flat.points.size(), 0);
  append_lines(text, flat.faces.size(), [&](std::string& out, std::size_t i) {
    const auto& face = flat.faces[i];
    if (!face.own) return;
    Line line(out);
    line << "g face" << i << ' ' << word(face.regions[1]) << ' ' << word(face.regions[0]) << '\n';
    for (const auto& [a, b, c] : face.triangles) line << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
  });
  for (const auto& face : flat.faces) {
    if (!face.own) continue;
    for (const auto& t : face.triangles) {
      drawing.triangles.push_back(t);
      drawing.sides.push_back({place(face.regions[0]), place(face.regions[1])});
      for (const auto p : t) drawn[p] = 1;
    }
  }
  for (std::size_t i = 0; i < flat.edges.size(); ++i) {
    const auto& edge = flat.edges[i];
    if (!edge.own || !(edge.wire || edge.slit)) continue;
    Line line(text);
    line << "g edge" << i << "\nl";
    for (const auto p : edge.points) line << ' ' << p + 1;
    if (edge.closed) line << ' ' << edge.points[0] + 1;
    line << '\n';
    for (std::size_t k = 0; k < edge.points.size(); ++k) {
      drawn[edge.points[k]] = 1;
      if (k + 1 == edge.points.size() && !edge.closed) break;
      if (!edge.wire) continue;
      drawing.segments.push_back({edge.points[k], edge.points[(k + 1) % edge.points.size()]});
      drawing.around_segments.push_back(place(edge.region));
    }
  }
  for (std::size_t i = 0; i < flat.vertices.size(); ++i) {
    const auto& vertex = flat.vertices[i];
    if (!vertex.own || !vertex.free) continue;
    Line(text) << "g vertex" << i << "\np " << vertex.point + 1 << '\n';
    if (drawn[vertex.point]) continue;
    drawing.points.push_back(vertex.point);
    drawing.around_points.push_back(place(vertex.region));
  }
  return {std::move(text), report_rounding(points, drawing)};
}

}  // namespace cnrg
