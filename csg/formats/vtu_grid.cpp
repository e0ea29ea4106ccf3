// VTK's XML as text. An array of numbers is one block of base64: its length in bytes, as a 64-bit number, and then
// the numbers themselves. Names are arrays of the numbers that they stand for, as text.
#include "csg/formats/vtu_grid.h"

#include <algorithm>
#include <bit>
#include <map>
#include <ranges>
#include <span>
#include <string_view>

#include "csg/mesh/material_field.h"
#include "csg/result/file_numbers.h"
#include "csg/result/said_table.h"
#include "csg/text/escape.h"
#include "csg/text/xml.h"
#include "kernel/base/parallel.h"

namespace cnrg {
namespace {

void append_base64(std::string& text, std::string_view bytes) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t start = text.size(), groups = bytes.size() / 3, rest = bytes.size() % 3;
  text.resize(start + 4 * (groups + (rest > 0)), '=');
  const auto put = [from = bytes.data(), to = text.data() + start](std::size_t g, auto n) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < n; ++k)
      group |= std::uint32_t{static_cast<unsigned char>(from[3 * g + k])} << (16 - 8 * k);
    for (std::size_t k = 0; k <= n; ++k) to[4 * g + k] = kDigits[group >> (18 - 6 * k) & 63];
  };
  for_each_index(groups, [&](std::size_t g) { put(g, std::integral_constant<std::size_t, 3>()); });
  if (rest > 0) put(groups, rest);
}

template <class T>
decltype(auto) little_endian(const std::vector<T>& values) {
  if constexpr (std::endian::native == std::endian::big) {
    std::vector<T> turned = values;
    for (T& value : turned) std::ranges::reverse(std::as_writable_bytes(std::span(&value, 1)));
    return turned;
  } else {
    return (values);
  }
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
  const std::vector<T>& turned = little_endian(values);
  const std::string_view bytes(reinterpret_cast<const char*>(turned.data()), turned.size() * sizeof(T));
  std::string head;  // the length, and what fills the third group
  for (int k = 0; k < 8; ++k) head += static_cast<char>(bytes.size() >> (8 * k));
  append_base64(text, head.append(bytes.substr(0, 1)));
  if (bytes.size() > 1) append_base64(text, bytes.substr(1));
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

  std::string text;
  text.reserve(11 * (connectivity_.size() + offsets_.size()) + 60 * types_.size() + 33 * points.size());
  text += "<?xml version=\"1.0\"?>\n<!-- " + comment(view) +
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
  for (std::size_t k = 0; k < kTags.size(); ++k) append_array(text, kTags[k].first, "Int32", tags_[k]);
  const auto append_values = [&](const std::string& name, const char* type, auto value_of) {
    std::vector<decltype(value_of(tags(0)))> values;
    for (std::size_t i = 0; i < types_.size(); ++i) values.push_back(value_of(tags(i)));
    append_array(text, in_xml(name).c_str(), type, values);
  };
  if (!names.empty())
    append_values("name", "Int32", [&](const CellTags& tags) { return number_of_name(names, tags); });
  for (const PropertyFields::Field& field : properties.fields()) {
    const std::string name = array_name(field.key);
    if (field.numeric)
      append_values(name, "Float64", [&](const CellTags& tags) { return PropertyFields::number(field, tags); });
    else append_values(name, "Int32", [&](const CellTags& tags) { return PropertyFields::text(field, tags); });
  }
  append_fractions(text, view, points);
  if (parameters != nullptr) append_array(text, "patch", "Int32", parameters->patches);
  text += "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  return text;
}

CellTags VtuGrid::tags(std::size_t cell) const {
  CellTags out;
  for (std::size_t k = 0; k < kTags.size(); ++k) out.*kTags[k].second = tags_[k][cell];
  out.said = said_[cell];
  return out;
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
        corners.empty() ? field.at(0, RationalPoint{}) : field.at(material_component(view, tags(i)), corners);
    for (std::size_t k = 0; k < here.size(); ++k) fractions[k].push_back(here[k]);
  }
  for (std::size_t k = 0; k < fractions.size(); ++k) {
    append_array(text, in_xml("fraction of " + field.names()[k]).c_str(), "Float64", fractions[k]);
  }
}

}  // namespace cnrg
