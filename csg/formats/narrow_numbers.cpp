#include "csg/formats/narrow_numbers.h"

#include <algorithm>
#include <charconv>

#include "csg/mesh/exact_volume.h"
#include "csg/mesh/second_order.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

/// `0.5` as `.5`, `2e-07` as `2.-7`.
std::string in_nastran(const std::string& text) {
  std::string digits = text.substr(0, text.find('e')), exponent;
  if (digits.size() < text.size()) {
    exponent = text.substr(digits.size() + 1);
    const char sign = exponent[0] == '-' ? '-' : '+';
    exponent.erase(0, std::min(exponent.find_first_not_of("+-0"), exponent.size()));
    if (!exponent.empty()) exponent.insert(0, 1, sign);
  }
  if (digits.find('.') == std::string::npos) digits += '.';
  const std::size_t zero = digits[0] == '-' ? 1 : 0;
  if (digits[zero] == '0' && digits.size() > zero + 2) digits.erase(zero, 1);
  return digits + exponent;
}

std::string form(const std::string& text, Column column) {
  return column == Column::nastran ? in_nastran(text) : text;
}

double value_of(const std::string& text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace

NarrowNumber narrow_number(double number, Column column) {
  const std::size_t width = column == Column::nastran ? 16 : 20;
  if (number == 0) number = 0.0;  // without a sign
  char buffer[64];
  const std::string shortest(buffer, std::to_chars(buffer, buffer + sizeof buffer, number).ptr);
  const std::string whole = form(shortest, column);
  if (whole.size() <= width) return {whole, number};
  for (int digits = 17;; --digits) {
    require(digits > 0, "a number without room for a digit");
    for (const auto format : {std::chars_format::general, std::chars_format::scientific}) {
      const int precision = format == std::chars_format::general ? digits : digits - 1;
      const std::string text(buffer, std::to_chars(buffer, buffer + sizeof buffer, number, format, precision).ptr);
      const std::string fitting = form(text, column);
      if (fitting.size() <= width) return {fitting, value_of(text)};
    }
  }
}

std::vector<std::array<std::string, 3>> narrow_points(const Mesh& mesh, Column column, const std::string& format) {
  std::vector<std::array<std::string, 3>> texts(mesh.points.size());
  std::vector<std::array<double, 3>> read(mesh.points.size());
  std::vector<char> moved(mesh.points.size(), 0);
  bool any = false;
  for (std::size_t p = 0; p < texts.size(); ++p) {
    for (std::size_t k = 0; k < 3; ++k) {
      NarrowNumber number = narrow_number(mesh.points[p][k], column);
      if (number.value != mesh.points[p][k]) moved[p] = 1, any = true;
      read[p][k] = number.value;
      texts[p][k] = std::move(number.text);
    }
  }
  if (!any || mesh.tetrahedra.empty()) return texts;
  std::size_t turned = 0;
  ExactVolume volume(read);
  for (const auto& t : mesh.tetrahedra) {
    const std::vector<Mesh::Index> nodes = mesh.nodes(t, kSecondOrderEdges);
    if (std::none_of(nodes.begin(), nodes.end(), [&](Mesh::Index p) { return moved[p] != 0; })) continue;
    bool right = false;
    if (mesh.middles.empty()) {
      volume.clear();
      volume.add(nodes[0], nodes[1], nodes[2], nodes[3]);
      right = volume.value() > 0;
    } else {
      SecondOrderNodes at;
      for (std::size_t k = 0; k < at.size(); ++k) at[k] = read[nodes[k]];
      right = has_positive_determinant(at);
    }
    turned += right ? 0 : 1;
  }
  if (turned > 0) {
    throw InputError(format + " holds numbers of " + (column == Column::nastran ? "16" : "20") +
                     " characters, with which " + std::to_string(turned) +
                     " tetrahedra are not turned right; give --quality 2, or write .msh, which holds all digits");
  }
  return texts;
}

}  // namespace cnrg
