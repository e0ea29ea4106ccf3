#include "csg/picture/options.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

#include "csg/text/escape.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

[[noreturn]] void refuse(const std::string& option, const std::string& value, const std::string& wanted) {
  throw InputError(option + ": `" + shown(value) + "` is not " + wanted);
}

/// What is between separators, also where that is nothing; of an empty text no part.
std::vector<std::string> parts_of(const std::string& text, char separator) {
  std::vector<std::string> out;
  if (text.empty()) return out;
  std::istringstream stream(text + separator);
  for (std::string part; std::getline(stream, part, separator);) out.push_back(part);
  return out;
}

double number_within(const std::string& option, const std::string& value, double low, double high,
                     const std::string& wanted) {
  const std::optional<Rational> x = parse_rational(value);
  if (!x || to_double(*x) < low || to_double(*x) > high) refuse(option, value, wanted);
  return to_double(*x);
}

DrawOptions::Camera camera(const std::string& option, const std::string& value) {
  const std::string wanted = "two angles in degrees such as 30,20: to the right of the negative y-axis, and up";
  const std::vector<std::string> parts = parts_of(value, ',');
  if (parts.size() != 2) refuse(option, value, wanted);
  return {number_within(option, parts[0], -360, 360, wanted),
          number_within(option, parts[1], -90, 90, "an angle from -90 to 90 degrees, upwards")};
}

DrawOptions::Cut cut_of(const std::string& option, const std::string& value) {
  const std::string wanted = "a plane such as x=5, or NX,NY,NZ,D for NX x + NY y + NZ z = D";
  DrawOptions::Cut out{{Rational(0), Rational(0), Rational(0)}, Rational(0)};
  if (value.size() > 2 && value[1] == '=' && value[0] >= 'x' && value[0] <= 'z') {
    const std::optional<Rational> offset = parse_rational(value.substr(2));
    if (!offset) refuse(option, value, wanted);
    out.normal[static_cast<std::size_t>(value[0] - 'x')] = 1;
    out.offset = *offset;
    return out;
  }
  const std::vector<std::string> parts = parts_of(value, ',');
  std::vector<Rational> numbers;
  for (const std::string& part : parts) {
    if (const std::optional<Rational> x = parse_rational(part)) numbers.push_back(*x);
  }
  if (parts.size() != 4 || numbers.size() != 4 || (numbers[0] == 0 && numbers[1] == 0 && numbers[2] == 0)) {
    refuse(option, value, wanted);
  }
  return {{numbers[0], numbers[1], numbers[2]}, numbers[3]};
}

constexpr std::array<std::pair<std::string_view, ColorBy>, 4> kColorings{{{"material", ColorBy::material},
                                                                          {"region", ColorBy::region},
                                                                          {"component", ColorBy::component},
                                                                          {"source", ColorBy::source}}};

ColorBy color_by(const std::string& option, const std::string& value) {
  for (const auto& [name, by] : kColorings) {
    if (value == name) return by;
  }
  refuse(option, value, "material, region, component or source");
}

DrawOptions::Labels labels(const std::string& option, const std::string& value) {
  DrawOptions::Labels out;
  for (const std::string& part : parts_of(value, ',')) {
    if (part == "v") out.vertices = true;
    else if (part == "e") out.edges = true;
    else if (part == "f") out.faces = true;
    else if (part == "r") out.regions = true;
    else if (part == "names") out.names = true;
    else refuse(option, value, "a list of v, e, f, r and names, such as v,e");
  }
  return out;
}

}  // namespace

std::string color_choices() {
  std::string text = "{";
  for (const auto& [name, by] : kColorings) text += std::string(text.size() > 1 ? "," : "") + std::string(name);
  return text + "}";
}

std::string OptionNames::operator()(const std::string& option) const {
  if (of_command_line_) return "--" + option;
  std::string name = option;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

void set_option(PanelOptions& panel, const std::string& option, const std::string& value,
                const OptionNames& names) {
  const std::string name = names(option);
  if (option == "camera") {
    panel.draw.camera = camera(name, value);
  } else if (option == "cut") {
    panel.draw.cuts.push_back(cut_of(name, value));
  } else if (option == "explode") {
    panel.draw.apart = number_within(name, value, 0, 100, "a number from 0 to 100, such as 0.3");
  } else if (option == "opacity") {
    panel.draw.opacity = number_within(name, value, 0.01, 1, "a number from 0.01 to 1, such as 0.4");
  } else if (option == "ghosts") {
    panel.ghosts = true;
  } else if (option == "color-by") {
    panel.draw.colors = color_by(name, value);
  } else if (option == "labels") {
    panel.draw.labels = labels(name, value);
  } else if (option == "caption") {
    panel.caption = value;
    panel.has_caption = true;
  } else {
    throw InputError(name + ": pictures have no such option");
  }
}

PictureSize picture_size(const std::string& value, const OptionNames& names) {
  const std::string option = names("size");
  const std::string wanted = "a size in pixels such as 640x480, each side 16 to 8192";
  const std::vector<std::string> parts = parts_of(value, 'x');
  if (parts.size() != 2) refuse(option, value, wanted);
  return {number_within(option, parts[0], 16, 8192, wanted), number_within(option, parts[1], 16, 8192, wanted)};
}

void check_options(const PanelOptions& panel, const OptionNames& names) {
  if (!panel.ghosts || (panel.draw.cuts.empty() && panel.draw.apart == 0)) return;
  throw InputError(names("ghosts") + " shows what was removed of the whole, and goes neither with " +
                   names("cut") + " nor with " + names("explode") + "; leave one out");
}

}  // namespace cnrg
