// 3MF: a package of three small files of XML, zipped. Each region is an object of its own, a closed mesh with a
// material; an assembly places all of them, and alone is built. Numbers are millimetres.
//
// The format has no wall between two objects: parts that adjoin have the same triangles there, turned, with the
// same digits, so that who joins equal points gets the wall back. An edge of an object has exactly two triangles;
// where a region touches itself, its surface is cut there (csg/result/solid.h).
//
// lib3MF, which others write the format with, rounds coordinates to six decimals and gives every object a random
// number: two files of one result differ, and small parts fall together.
#include <map>

#include "csg/formats/formats.h"
#include "csg/mesh/mesh.h"
#include "csg/result/palette.h"
#include "csg/result/solid.h"
#include "csg/text/digits.h"
#include "csg/text/xml.h"
#include "csg/text/zip.h"

namespace cnrg {
namespace {

constexpr std::string_view kHead = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
constexpr std::string_view kTypes =
    "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">\n"
    "<Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\n"
    "<Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>\n"
    "</Types>\n";
constexpr std::string_view kRelationships =
    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\n"
    "<Relationship Target=\"/3D/3dmodel.model\" Id=\"model\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>\n"
    "</Relationships>\n";
constexpr std::string_view kModel =
    "<model unit=\"millimeter\" xml:lang=\"en-US\" "
    "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n";

std::string quoted(const std::string& value) { return "\"" + value + "\""; }
std::string quoted(std::size_t value) { return quoted(std::to_string(value)); }

class Model {
 public:
  Model(const ResultView& view, const FlatComplex& flat, const RoundedPoints& points)
      : view_(view), flat_(flat), points_(points), parts_(region_boundaries(flat, "3MF")) {}

  std::string run() {
    text_ = std::string(kHead) + std::string(kModel) + "<metadata name=\"Title\">" + in_xml(view_.node) +
            "</metadata>\n<metadata name=\"Application\">cnrg</metadata>\n<resources>\n";
    if (parts_.empty()) return text_ + "</resources>\n<build/>\n</model>\n";
    add_materials();
    const std::vector<std::string> names = region_labels(flat_, mesh_groups(view_, flat_));
    for (std::size_t i = 0; i < parts_.size(); ++i) add_object(i, in_xml(names[parts_[i].region]));
    add_assembly();
    return std::move(text_);
  }

 private:
  static constexpr std::size_t kMaterials = 1, kFirstObject = 2;  // numbers of resources
  const ResultView& view_;
  const FlatComplex& flat_;
  const RoundedPoints& points_;
  std::vector<RegionBoundary> parts_;
  std::vector<std::size_t> materials_;  // by part
  std::string text_;

  /// Regions without a material have a colour that tells them apart, as in pictures.
  void add_materials() {
    const CellColors colors(view_, flat_);
    std::map<std::pair<std::string, std::string>, std::size_t> known;
    text_ += "<basematerials id=" + quoted(kMaterials) + ">\n";
    for (const RegionBoundary& part : parts_) {
      const CellColor color = colors.of(ColorBy::material, 3, part.region);
      const auto [entry, fresh] = known.try_emplace({color.text, hex(color.color)}, known.size());
      materials_.push_back(entry->second);
      if (!fresh) continue;
      text_ += "<base name=" + quoted(in_xml(color.text)) + " displaycolor=" + quoted(hex(color.color)) + "/>\n";
    }
    text_ += "</basematerials>\n";
  }

  void add_object(std::size_t i, const std::string& name) {
    text_ += "<object id=" + quoted(kFirstObject + i) + " type=\"model\" name=" + quoted(name) +
             " pid=" + quoted(kMaterials) + " pindex=" + quoted(materials_[i]) + ">\n<mesh>\n<vertices>\n";
    const auto& [region, points, triangles] = parts_[i];
    append_lines(text_, points.size(), [&](std::string& out, std::size_t p) {
      const auto& [x, y, z] = points_.xyz[points[p]];
      Line(out) << "<vertex x=\"" << x << "\" y=\"" << y << "\" z=\"" << z << "\"/>\n";
    });
    text_ += "</vertices>\n<triangles>\n";
    append_lines(text_, triangles.size(), [&](std::string& out, std::size_t t) {
      const auto& [a, b, c] = triangles[t];
      Line(out) << "<triangle v1=\"" << a << "\" v2=\"" << b << "\" v3=\"" << c << "\"/>\n";
    });
    text_ += "</triangles>\n</mesh>\n</object>\n";
  }

  void add_assembly() {
    const std::string id = quoted(kFirstObject + parts_.size());
    text_ += "<object id=" + id + " type=\"model\" name=" + quoted(in_xml(view_.node)) + ">\n<components>\n";
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      text_ += "<component objectid=" + quoted(kFirstObject + i) + "/>\n";
    }
    text_ += "</components>\n</object>\n</resources>\n<build>\n<item objectid=" + id + "/>\n</build>\n</model>\n";
  }
};

}  // namespace

FileText three_mf_text(const ResultView& view) {
  const FlatComplex flat = flatten(view);
  require_closed_and_bounded(flat, "3MF");
  require_regions_only(flat, "3MF");
  const RoundedPoints points = round_points(view, flat);
  const std::string model = Model(view, flat, points).run();
  const std::string types = std::string(kHead) + std::string(kTypes);
  const std::string relations = std::string(kHead) + std::string(kRelationships);
  return {zip({{"[Content_Types].xml", types}, {"_rels/.rels", relations}, {"3D/3dmodel.model", model}}),
          report_rounding(points, drawing_of(flat))};
}

}  // namespace cnrg
