// The page is put together here and not from the template of `cnrg view`, which needs npm when the program is
// built and a file beside it when it runs: a report is tables and pictures, and every program that meshes can
// write it.
#include "csg/view/mesh_page.h"

#include <algorithm>
#include <cmath>

#include "csg/picture/draw.h"
#include "csg/picture/mesh_scene.h"
#include "csg/picture/paint.h"
#include "csg/result/file_numbers.h"
#include "csg/result/result_data.h"
#include "csg/text/file.h"
#include "csg/text/table.h"
#include "csg/text/xml.h"

namespace cnrg {
namespace {

constexpr const char* kStyle = R"(:root { --page: #fff; --ink: #1d2126; --muted: #626b7a; --rule: #dfe3e8;
  --card: #f5f7f9; --bar: #4a78b5; --alarm: #d1301c; }
@media (prefers-color-scheme: dark) { :root { --page: #14171b; --ink: #e6e9ed; --muted: #99a2af; --rule: #333a43;
  --card: #1d2228; --bar: #7ba6de; --alarm: #ff7a5c; } }
* { box-sizing: border-box; }
html { background: var(--page); color: var(--ink); -webkit-print-color-adjust: exact; print-color-adjust: exact; }
body { margin: 0; font: 15px/1.5 system-ui, "Segoe UI", "Noto Sans", "Liberation Sans", Arial, sans-serif; }
main { max-width: 1140px; margin: 0 auto; padding: 32px 20px 64px; }
h1 { font-size: 30px; line-height: 1.2; margin: 0 0 6px; letter-spacing: -0.01em; overflow-wrap: anywhere; }
h2 { font-size: 20px; margin: 0 0 10px; }
h3 { font-size: 14px; margin: 0 0 2px; }
p { margin: 0 0 10px; max-width: 84ch; }
section { margin-top: 40px; }
.lead, .note { color: var(--muted); }
.note { font-size: 13px; }
.facts { display: grid; grid-template-columns: repeat(auto-fit, minmax(150px, 1fr)); gap: 12px; margin-top: 22px; }
.facts div { background: var(--card); border-radius: 8px; padding: 12px 16px; }
.facts b { display: block; font-size: 27px; line-height: 1.25; letter-spacing: -0.02em;
  font-variant-numeric: tabular-nums; }
.facts span { color: var(--muted); font-size: 13px; }
.alarm { color: var(--alarm); }
.picture { background: #fff; border: 1px solid var(--rule); border-radius: 8px; padding: 14px; text-align: center; }
.picture svg { max-width: 100%; height: auto; }
.histograms { display: grid; grid-template-columns: repeat(auto-fill, minmax(290px, 1fr)); gap: 16px; }
.histograms figure { margin: 0; background: var(--card); border-radius: 8px; padding: 14px 16px 8px; }
.histograms figcaption { color: var(--muted); font-size: 12px; }
.histograms svg { display: block; width: 100%; height: auto; margin-top: 8px; }
.histograms rect { fill: var(--bar); }
.histograms rect.bad { fill: var(--alarm); }
.histograms line { stroke: var(--muted); stroke-width: 1; }
.histograms line.asked { stroke: var(--alarm); stroke-dasharray: 3 3; }
.histograms text { fill: var(--muted); font: 11px system-ui, "Noto Sans", "Liberation Sans", Arial, sans-serif; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-size: 13px; font-variant-numeric: tabular-nums; }
th, td { padding: 5px 8px; text-align: right; vertical-align: top; border-bottom: 1px solid var(--rule); }
th { color: var(--muted); font-size: 12px; font-weight: 600; white-space: nowrap; vertical-align: bottom; }
td { white-space: nowrap; }
th.text, td.text { text-align: left; }
td.words { white-space: normal; min-width: 220px; overflow-wrap: anywhere; }
tr.all td { border-top: 1px solid var(--muted); font-weight: 600; }
i.swatch { display: inline-block; width: 11px; height: 11px; border-radius: 3px; margin-right: 7px; }
)";

std::string shape_text(double x) { return decimal(x, x < 0.01 ? "%.2g" : "%.2f"); }
std::string list_of(const std::vector<std::string>& names) {
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "" : ", ") + name;
  return out;
}

/// A table of HTML; `columns` are titles, with `<` before those of texts and `=` before those that may wrap.
class HtmlTable {
 public:
  explicit HtmlTable(const std::vector<std::string>& columns) {
    text_ = "<div class=\"wide\"><table>\n<thead><tr>";
    for (const std::string& column : columns) {
      const bool text = column[0] == '<' || column[0] == '=';
      kinds_.push_back(text ? column[0] : '>');
      text_ += (text ? "<th class=\"text\">" : "<th>") + in_xml(text ? column.substr(1) : column) + "</th>";
    }
    text_ += "</tr></thead>\n<tbody>\n";
  }
  /// `swatch`: of the first cell.
  void row(const std::vector<std::string>& cells, bool all = false, const Rgb* swatch = nullptr) {
    text_ += all ? "<tr class=\"all\">" : "<tr>";
    for (std::size_t i = 0; i < cells.size(); ++i) {
      text_ += kinds_[i] == '>' ? "<td>" : kinds_[i] == '<' ? "<td class=\"text\">" : "<td class=\"text words\">";
      if (i == 0 && swatch != nullptr)
        text_ += "<i class=\"swatch\" style=\"background:" + hex(*swatch) + "\"></i>";
      text_ += in_xml(cells[i]) + "</td>";
    }
    text_ += "</tr>\n";
  }
  std::string text() const { return text_ + "</tbody></table></div>\n"; }

 private:
  std::string text_;
  std::vector<char> kinds_;
};

struct Histogram {
  std::string title, words;
  double begin = 0, step = 1;
  const char* format = "%g";  ///< of numbers at the axis
  double bad = -HUGE_VAL;     ///< bars below are
  double asked = 0;           ///< a line there; 0: none
  bool open = false;          ///< the last bar has all that is larger
};

template <std::size_t N>
std::string histogram(const Histogram& of, const std::array<std::size_t, N>& counts) {
  constexpr double kWidth = 340, kHeight = 150, kTop = 16, kBottom = 22;
  const double most = double(std::max<std::size_t>(1, *std::max_element(counts.begin(), counts.end())));
  const double bar = kWidth / double(N), room = kHeight - kTop - kBottom;
  std::string out =
      "<figure><h3>" + in_xml(of.title) + "</h3><figcaption>" + in_xml(of.words) +
      "</figcaption>\n<svg viewBox=\"0 0 340 150\" role=\"img\" aria-label=\"histogram: " + in_xml(of.title) +
      "\">\n";
  const auto number = [&](double x) { return decimal(x, "%.1f"); };
  for (std::size_t i = 0; i < N; ++i) {
    const double low = of.begin + double(i) * of.step;
    if (counts[i] > 0) {
      const double height = std::max(1.5, room * double(counts[i]) / most);
      out += std::string("<rect") + (low + of.step <= of.bad + 1e-9 ? " class=\"bad\"" : "") + " x=\"" +
             number(bar * double(i) + 1) + "\" y=\"" + number(kTop + room - height) + "\" width=\"" +
             number(bar - 2) + "\" height=\"" + number(height) + "\"><title>" + decimal(low, of.format) +
             (of.open && i + 1 == N ? " and more" : " to " + decimal(low + of.step, of.format)) + ": " +
             grouped(counts[i]) + "</title></rect>\n";
      if (double(counts[i]) == most) {
        const double at = std::clamp(bar * (double(i) + 0.5), 24.0, kWidth - 24);
        out += "<text x=\"" + number(at) + "\" y=\"" + number(kTop - 4) + "\" text-anchor=\"middle\">" +
               grouped(counts[i]) + "</text>\n";
      }
    }
    if (i % 4 == 0) {
      out += "<text x=\"" + number(bar * double(i)) + "\" y=\"" + number(kHeight - 6) + "\"" +
             (i == 0 ? "" : " text-anchor=\"middle\"") + ">" + decimal(low, of.format) + "</text>\n";
    }
  }
  out += "<text x=\"340\" y=\"" + number(kHeight - 6) + "\" text-anchor=\"end\">" +
         (of.open ? std::string("more") : decimal(of.begin + double(N) * of.step, of.format)) + "</text>\n";
  const std::string y = number(kTop + room);
  out += "<line x1=\"0\" x2=\"340\" y1=\"" + y + "\" y2=\"" + y + "\"/>\n";
  if (of.asked > 0) {
    const double x = (of.asked - of.begin) / of.step * bar;
    if (x < kWidth) {
      out += "<line class=\"asked\" x1=\"" + number(x) + "\" x2=\"" + number(x) + "\" y1=\"" + number(kTop) +
             "\" y2=\"" + y + "\"><title>asked for: " + decimal(of.asked, "%g") + "</title></line>\n";
    }
  }
  return out + "</svg></figure>\n";
}

/// Outside and opened, with the worst elements; of too many triangles the faces of the model.
std::string pictures(const Result& result, const Mesh& mesh, const std::vector<std::array<double, 3>>& worst,
                     int threads) {
  std::vector<Panel> panels;
  std::string words;
  bool drawn = false;  // the mesh itself, with its rings
  if (auto outside = draw_mesh(result, mesh, {false, worst}, threads)) {
    panels.push_back({std::move(*outside), "outside"});
    drawn = true;
  } else {
    panels.push_back({draw(result, {}, nullptr, threads), "the faces of the model"});
    words = "The mesh has too many triangles in sight to tell them apart: these are the faces of the model. ";
  }
  if (auto opened = draw_mesh(result, mesh, {true, worst}, threads)) {
    panels.push_back({std::move(*opened), "opened in the middle"});
    drawn = true;
  }
  if (drawn && !worst.empty()) {
    words += mesh.tetrahedra.empty() ? "Rings mark the smallest angles, by their numbers in the table below."
                                     : "Rings mark the worst tetrahedra, by their numbers in the table below; "
                                       "sides of tetrahedra of a shape below 0.1 are red.";
  }
  return "<section><h2>Picture</h2>\n<div class=\"picture\">\n" +
         picture_bytes("page.svg", panels, PictureSize{panels.size() > 1 ? 500.0 : 700.0, 460.0}) + "</div>\n" +
         (words.empty() ? "" : "<p class=\"note\">" + in_xml(words) + "</p>\n") + "</section>\n";
}

std::string fact(const std::string& number, const std::string& words, bool alarm = false) {
  return "<div><b" + std::string(alarm ? " class=\"alarm\"" : "") + ">" + in_xml(number) + "</b><span>" +
         in_xml(words) + "</span></div>\n";
}

std::string whole_page(const MeshPageOptions& options, const std::string& facts, const std::string& body) {
  const std::string node = in_xml(options.node), tree = in_xml(options.tree);
  std::string notices;
  for (const std::string& notice : options.notices) notices += "<p class=\"note\">" + in_xml(notice) + "</p>\n";
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
         "content=\"width=device-width, initial-scale=1\">\n<meta name=\"color-scheme\" content=\"light dark\">\n"
         "<title>mesh of " +
         node + "</title>\n<style>\n" + kStyle + "</style>\n</head>\n<body>\n<main>\n<h1>Mesh of " + node +
         "</h1>\n<p class=\"lead\">" + tree + "</p>\n" + notices + "<div class=\"facts\">\n" + facts + "</div>\n" +
         body + "</main>\n</body>\n</html>\n";
}

std::string regions_table(const Result& result, const TetrahedralMesh& made) {
  const std::optional<CurvedReport>& bent = made.bent;
  std::vector<std::string> columns{"<region", "tetrahedra"};
  if (bent) columns.insert(columns.end(), {"curved", "straight"});
  columns.insert(columns.end(), {"worst shape", "median shape", "below 0.1", "<volume"});
  HtmlTable table(columns);
  const std::vector<Rgb> colors = region_colors(result, made.mesh);
  std::size_t all = 0, all_curved = 0, all_straight = 0;
  Rational volume = 0;
  const auto row = [&](const std::string& name, std::size_t count, std::size_t curved, std::size_t straight,
                       const MeshQuality::Region& shapes, const Rational& of, const Rgb* color) {
    std::vector<std::string> cells{name, grouped(count)};
    if (bent) cells.insert(cells.end(), {grouped(curved), grouped(straight)});
    cells.insert(cells.end(),
                 {shape_text(shapes.worst), shape_text(shapes.median), grouped(shapes.bad), to_decimal(of)});
    table.row(cells, color == nullptr, color);
  };
  for (const std::size_t i : listed_regions(made)) {
    const RegionTetrahedra& region = made.regions[i];
    const std::size_t curved = bent ? bent->curved[i] : 0;
    const std::size_t straight = bent ? bent->straight[i] : 0;
    row(region.name, region.tetrahedra, curved, straight, made.quality.regions[i], region.volume, &colors[i]);
    all += region.tetrahedra, all_curved += curved, all_straight += straight, volume += region.volume;
  }
  const MeshQuality& q = made.quality;
  row("all", all, all_curved, all_straight, {q.bad, q.beyond, q.worst, q.median}, volume, nullptr);
  return "<section><h2>Regions</h2>\n" + table.text() + "</section>\n";
}

}  // namespace

bool is_page(const std::string& path) {
  const std::string extension = extension_of(path);
  return extension == ".html" || extension == ".htm";
}

std::string mesh_page(const Result& result, const TetrahedralMesh& made, const MeshPageOptions& options) {
  const MeshQuality& q = made.quality;
  const Mesh& mesh = made.mesh;
  std::vector<std::array<double, 3>> worst;
  for (const MeshQuality::Bad& bad : q.worst_ones) worst.push_back(bad.at);
  const std::string facts = fact(grouped(mesh.tetrahedra.size()), "tetrahedra") +
                            fact(grouped(mesh.points.size()), "points") +
                            fact(shape_text(q.worst), "worst shape, 1 is regular", q.worst < MeshQuality::kBad) +
                            fact(decimal(q.smallest_dihedral, "%.3g") + "°", "smallest dihedral angle") +
                            fact(decimal(q.largest_radius_edge, "%.3g"), "largest circumradius to shortest edge") +
                            fact(grouped(q.bad), "shapes below 0.1", q.bad > 0);
  std::string body = pictures(result, mesh, worst, options.threads) + regions_table(result, made);
  body += "<section><h2>Shapes</h2>\n<div class=\"histograms\">\n";
  body +=
      histogram({"Shape", "12 (3 V)^(2/3) / sum of squared edges; 1 is regular", 0, 0.05, "%g", MeshQuality::kBad},
                q.shapes);
  body += histogram({"Smallest dihedral angle", "degrees; 70.5 of a regular tetrahedron", 0, 5}, q.dihedrals);
  body += histogram({"Circumradius to shortest edge",
                     options.radius_edge > 0 ? "asked for: " + decimal(options.radius_edge, "%g") + "; " +
                                                   grouped(q.beyond) + " beyond"
                                             : "0.61 of a regular tetrahedron",
                     0.6, 0.2, "%g", -HUGE_VAL, options.radius_edge, true},
                    q.ratios);
  body += "</div>\n</section>\n";
  if (!q.worst_ones.empty()) {
    HtmlTable table({"number", "shape", "angle", "ratio", "<at", "=nodes", "=why"});
    const PlaceText place(made.mesh);
    std::size_t number = 0;
    for (const MeshQuality::Bad& bad : q.worst_ones) {
      table.row({std::to_string(++number), shape_text(bad.measures.shape), decimal(bad.measures.dihedral, "%.2g"),
                 decimal(bad.measures.radius_edge, "%.3g"), place(bad.at), list_of(bad.nodes), bad.why});
    }
    std::string note = grouped(q.worst_ones.size()) + " of " + grouped(q.bad) +
                       " below 0.1, at the middle of each tetrahedron, with the nodes that meet there.";
    for (const std::string& more : {forced_text(q), joining_text(q)})
      if (!more.empty()) note += " " + more + ".";
    body += "<section><h2>The worst shapes</h2>\n<p class=\"note\">" + in_xml(note) + "</p>\n" + table.text() +
            "</section>\n";
  }
  return whole_page(options, facts, body);
}

std::string mesh_page(const Result& result, const SurfaceTriangles& made, const MeshPageOptions& options) {
  const Mesh& mesh = made.mesh;
  const std::vector<std::string> leaves = leaf_names(result.data().leaves);
  const TriangleQuality q = triangle_quality_of(mesh, leaves);
  std::vector<std::array<double, 3>> worst;
  for (const TriangleQuality::Bad& bad : q.worst_ones) worst.push_back(bad.at);
  std::size_t below = 0;
  const bool quads = !mesh.quads.empty();
  std::vector<std::string> columns{"<faces"};
  if (quads) columns.insert(columns.end(), {"quadrilaterals", "least quality"});
  columns.insert(columns.end(), {"triangles", "<area", "least angle", "<at", "below 25°"});
  HtmlTable groups(columns);
  const PlaceText place(mesh);
  const FaceTriangles all = all_groups(made);
  const auto row = [&](const FaceTriangles& of, bool last) {
    std::size_t small = 0;
    for (std::size_t i = 1; i < of.why.size(); ++i) small += of.why[i];
    const bool some = of.triangles > 0;
    std::vector<std::string> cells{of.name};
    if (quads) cells.insert(cells.end(), {grouped(of.quads), of.quads > 0 ? decimal(of.least_quad, "%.2f") : ""});
    cells.insert(cells.end(),
                 {grouped(of.triangles), decimal(of.area, "%.6g"), some ? decimal(of.least_angle, "%.3g") : "",
                  some ? place(of.where) : "", grouped(small)});
    groups.row(cells, last);
    below = small;
  };
  for (const FaceTriangles& of : made.groups) row(of, false);
  if (!made.groups.empty()) row(all, true);
  std::string facts = (quads ? fact(grouped(mesh.quads.size()), "quadrilaterals on faces") : "") +
                      fact(grouped(mesh.triangles.size()), "triangles on faces") +
                      fact(grouped(mesh.segments.size()), "segments on edges") +
                      fact(grouped(mesh.points.size()), "points");
  std::string body = pictures(result, mesh, worst, options.threads);
  if (!made.groups.empty()) {
    if (quads) facts += fact(decimal(all.least_quad, "%.2f"), "least quality, 1 of a rectangle");
    if (all.triangles > 0)
      facts += fact(decimal(all.least_angle, "%.3g") + "°", "least angle", all.least_angle < 25);
    facts += fact(grouped(below), "below 25°", below > 0) + fact(decimal(all.area, "%.6g"), "area");
    body += "<section><h2>Faces</h2>\n" + groups.text() + "</section>\n<section><h2>Shapes</h2>\n" +
            "<div class=\"histograms\">\n" +
            histogram({"Smallest angle", "degrees; 60 of a regular triangle", 0, 5, "%g", 25}, q.angles) +
            "</div>\n</section>\n";
    HtmlTable table({"number", "angle", "<at", "=nodes"});
    std::size_t number = 0;
    for (const TriangleQuality::Bad& bad : q.worst_ones)
      table.row({std::to_string(++number), decimal(bad.angle, "%.3g"), place(bad.at), list_of(bad.nodes)});
    body += "<section><h2>The smallest angles</h2>\n" + table.text() + "</section>\n";
  }
  return whole_page(options, facts, body);
}

}  // namespace cnrg
