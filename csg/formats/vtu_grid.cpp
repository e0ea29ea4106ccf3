// VTK's XML as text. An array of numbers is one block of base64: its length in bytes, as a 64-bit number, and then
// the numbers themselves. Names are arrays of the numbers that they stand for, as text.
#include "csg/formats/vtu_grid.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <map>

#include "csg/mesh/material_field.h"
#include "csg/result/file_numbers.h"
#include "csg/result/said_table.h"
#include "csg/text/escape.h"
#include "csg/text/xml.h"
#include "kernel/base/parallel.h"

namespace cnrg {
namespace {

void append_base64(std::string& text, const std::string& bytes) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t start = text.size(), groups = bytes.size() / 3, rest = bytes.size() % 3;
  text.resize(start + 4 * (groups + (rest > 0)), '=');
  const auto put = [&](std::size_t g, std::size_t n) {
    const auto at = [&](std::size_t k) {
      return k < n ? std::uint32_t{static_cast<unsigned char>(bytes[3 * g + k])} : 0;
    };
    const std::uint32_t group = at(0) << 16 | at(1) << 8 | at(2);
    char* const to = &text[start + 4 * g];
    for (std::size_t k = 0; k <= n; ++k) to[k] = kDigits[group >> (18 - 6 * k) & 63];
  };
  for_each_index(groups, [&](std::size_t g) { put(g, 3); });
  if (rest > 0) put(groups, rest);
}

template <class T>
std::string little_endian(const std::vector<T>& values) {
  std::string bytes(values.size() * sizeof(T), '\0');
  if (!values.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  if constexpr (std::endian::native == std::endian::big) {
    for (std::size_t i = 0; i < bytes.size(); i += sizeof(T)) {
      std::reverse(bytes.data() + i, bytes.data() + i + sizeof(T));
    }
  }
  return bytes;
}

std::string comment(const ResultView& view) {
  std::string name = in_xml(view.node);
  for (std::size_t at; (at = name.find("--")) != std::string::npos;) name.replace(at, 2, "- -");
  return "node " + name + ", written by cnrg";
}

/// One number for each point or cell is no vector of one component: to readers of arrays these are different
/// shapes.
template <class T>
void append_array(std::string& text, const char* name, const char* type, const std::vector<T>& values,
                  int components = 1) {
  text += "<DataArray type=\"" + std::string(type) + "\" Name=\"" + name + "\"";
  if (components != 1) text += " NumberOfComponents=\"" + std::to_string(components) + "\"";
  text += " format=\"binary\">\n";
  const std::string bytes = little_endian(values);
  append_base64(text, little_endian(std::vector<std::uint64_t>{bytes.size()}) + bytes);
  text += "\n</DataArray>\n";
}

/// An array `ARRAY NAME` for each name: the places in `names` that have it, from `first` on, in the order of the
/// first of them. Such places are what the cell data ARRAY holds.
void append_names(std::string& text, const std::string& array, const std::vector<std::string>& names,
                  std::size_t first) {
  std::map<std::string, std::size_t> known;
  std::vector<std::pair<std::string, std::vector<std::size_t>>> numbers;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string name = array + (names[i].empty() ? "" : " ") + shown(names[i]);
    const auto [place, fresh] = known.try_emplace(name, numbers.size());
    if (fresh) numbers.push_back({name, {}});
    numbers[place->second].second.push_back(first + i);
  }
  for (const auto& [name, of_name] : numbers) {
    text += "<DataArray type=\"Int32\" Name=\"" + in_xml(name) + "\" NumberOfTuples=\"" +
            std::to_string(of_name.size()) + "\" format=\"ascii\">\n";
    for (std::size_t i = 0; i < of_name.size(); ++i) text += (i == 0 ? "" : " ") + std::to_string(of_name[i]);
    text += "\n</DataArray>\n";
  }
}

/// From 1, of a sheet, a wire or a point; 0: it has none.
std::int32_t number_of_name(const std::vector<std::string>& names, const CellTags& tags) {
  if (tags.said == nullptr || tags.dimension == 3) return 0;
  const auto it = std::lower_bound(names.begin(), names.end(), tags.said->name.text());
  if (it == names.end() || *it != tags.said->name) return 0;
  return static_cast<std::int32_t>(it - names.begin()) + 1;
}

}  // namespace

std::string VtuGrid::text(const ResultView& view, const std::vector<std::array<double, 3>>& points,
                          const VtuParameters* parameters, const std::vector<std::uint32_t>& twins) const {
  std::vector<std::string> regions, materials, leaves;
  for (const RegionAttributes& a : view.value->attributes()) regions.push_back(a.name);
  for (const auto& m : view.materials) materials.push_back(m.name);
  if (view.leaves != nullptr) leaves = leaf_names(*view.leaves);
  std::vector<double> coordinates;
  for (const auto& p : points) coordinates.insert(coordinates.end(), p.begin(), p.end());

  std::string text = "<?xml version=\"1.0\"?>\n<!-- " + comment(view) +
                     " -->\n"
                     "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
                     "header_type=\"UInt64\">\n<UnstructuredGrid>\n<FieldData>\n";
  append_names(text, "region", regions, 1);
  append_names(text, "material", materials, 1);
  append_names(text, "source_leaf", leaves, 0);
  const PropertyFields properties(view);
  const std::vector<std::string> names = said_names(view);
  if (!names.empty()) append_names(text, "name", names, 1);
  for (const PropertyFields::Field& field : properties.fields()) {
    if (!field.numeric) append_names(text, array_name(field.key), field.texts, 1);
  }
  if (parameters != nullptr) append_names(text, "patch", parameters->names, 1);
  text += "</FieldData>\n<Piece NumberOfPoints=\"" + std::to_string(points.size()) + "\" NumberOfCells=\"" +
          std::to_string(types_.size()) + "\">\n<Points>\n";
  append_array(text, "Points", "Float64", coordinates, 3);
  text += "</Points>\n<Cells>\n";
  append_array(text, "connectivity", "Int64", connectivity_);
  append_array(text, "offsets", "Int64", offsets_);
  append_array(text, "types", "UInt8", types_);
  text += "</Cells>\n";
  if (parameters != nullptr) {
    text += "<PointData TCoords=\"parameters\">\n";
    append_array(text, "parameters", "Float64", parameters->uv, 2);
    text += "</PointData>\n";
  }
  if (!twins.empty()) {
    text += "<PointData>\n";
    append_array(text, "twin", "UInt32", twins);
    text += "</PointData>\n";
  }
  text += "<CellData Scalars=\"region\">\n";
  const auto append_tag = [&](const char* name, std::int32_t CellTags::*tag) {
    std::vector<std::int32_t> values;
    for (const CellTags& tags : tags_) values.push_back(tags.*tag);
    append_array(text, name, "Int32", values);
  };
  append_tag("dimension", &CellTags::dimension);
  append_tag("cell", &CellTags::cell);
  append_tag("component", &CellTags::component);
  append_tag("region", &CellTags::region);
  append_tag("region_front", &CellTags::front);
  append_tag("region_back", &CellTags::back);
  append_tag("regions_bounded", &CellTags::bounded);
  append_tag("material", &CellTags::material);
  append_tag("source_leaf", &CellTags::leaf);
  append_tag("source_face", &CellTags::face);
  if (!names.empty()) {
    std::vector<std::int32_t> values;
    for (const CellTags& tags : tags_) values.push_back(number_of_name(names, tags));
    append_array(text, "name", "Int32", values);
  }
  for (const PropertyFields::Field& field : properties.fields()) append_property(text, field);
  append_fractions(text, view, points);
  if (parameters != nullptr) append_array(text, "patch", "Int32", parameters->patches);
  text += "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  return text;
}

void VtuGrid::append_property(std::string& text, const PropertyFields::Field& field) const {
  const std::string name = in_xml(array_name(field.key));
  if (field.numeric) {
    std::vector<double> values;
    for (const CellTags& tags : tags_) values.push_back(PropertyFields::number(field, tags));
    append_array(text, name.c_str(), "Float64", values);
  } else {
    std::vector<std::int32_t> values;
    for (const CellTags& tags : tags_) values.push_back(PropertyFields::text(field, tags));
    append_array(text, name.c_str(), "Int32", values);
  }
}

void VtuGrid::append_fractions(std::string& text, const ResultView& view,
                               const std::vector<std::array<double, 3>>& points) const {
  const MaterialField field(view);
  std::vector<std::vector<double>> fractions(field.names().size());
  if (field.empty()) return;
  std::vector<std::array<double, 3>> corners;
  for (std::size_t i = 0, begin = 0; i < types_.size(); ++i) {
    const auto end = static_cast<std::size_t>(offsets_[i]);
    corners.clear();
    for (; begin < end; ++begin) corners.push_back(points[static_cast<std::size_t>(connectivity_[begin])]);
    const std::vector<double> here =
        corners.empty() ? field.at(0, RationalPoint{}) : field.at(material_component(view, tags_[i]), corners);
    for (std::size_t k = 0; k < here.size(); ++k) fractions[k].push_back(here[k]);
  }
  for (std::size_t k = 0; k < fractions.size(); ++k) {
    append_array(text, in_xml("fraction of " + field.names()[k]).c_str(), "Float64", fractions[k]);
  }
}

}  // namespace cnrg
