// The seven colors are those of Okabe and Ito (2008) without black.
#include "csg/result/palette.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

#include "csg/result/file_numbers.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

constexpr std::size_t kHues = 7;

/// The color of a kind of cell.
CellColor of_kind(int dimension) {
  return {dimension == 3   ? no_color()
          : dimension == 2 ? sheet_color()
          : dimension == 1 ? wire_color()
                           : point_color(),
          {}};
}

/// Of a material of the tree: the one that it has there, else that of its place in the list.
CellColor of_name(const ResultView& view, const std::string& material) {
  const auto& all = view.materials;
  const auto at = std::find_if(all.begin(), all.end(), [&](const auto& m) { return m.name == material; });
  const bool colored = at != all.end() && !at->color.empty();
  return {colored ? rgb(at->color) : palette_color(static_cast<std::size_t>(at - all.begin())), material};
}

/// 2^n modulo the size of the palette.
std::size_t power_of_two(std::size_t n) {
  std::size_t out = 1;
  for (std::size_t base = 2; n != 0; n /= 2, base = base * base % kPaletteSize) {
    if (n % 2 == 1) out = out * base % kPaletteSize;
  }
  return out;
}

}  // namespace

Rgb rgb(const std::string& hex) {
  Rgb out{};
  bool good = hex.size() == 7 && hex[0] == '#';
  for (std::size_t k = 0; k < 3 && good; ++k) {
    unsigned byte = 0;
    const char* begin = hex.data() + 1 + 2 * k;
    good = std::from_chars(begin, begin + 2, byte, 16).ptr == begin + 2;
    out[k] = byte / 255.0;
  }
  require(good, "rgb: a color is `#` and six hexadecimal digits");
  return out;
}

std::string hex(const Rgb& color) {
  char text[8];
  const auto byte = [](double x) { return static_cast<unsigned>(std::llround(std::clamp(x, 0.0, 1.0) * 255)); };
  std::snprintf(text, sizeof text, "#%02x%02x%02x", byte(color[0]), byte(color[1]), byte(color[2]));
  return text;
}

Rgb mix(const Rgb& a, const Rgb& b, double t) {
  Rgb out{};
  for (std::size_t k = 0; k < 3; ++k) out[k] = a[k] + (b[k] - a[k]) * t;
  return out;
}

Rgb palette_color(std::size_t i) {
  static const std::array<Rgb, kHues> hues{rgb("#56b4e9"), rgb("#e69f00"), rgb("#009e73"), rgb("#cc79a7"),
                                           rgb("#f0e442"), rgb("#0072b2"), rgb("#d55e00")};
  static const std::array<Rgb, 3> towards{rgb("#ffffff"), rgb("#ffffff"), rgb("#282832")};
  constexpr std::array<double, 3> share{0.22, 0.55, 0.32};
  const std::size_t round = i / kHues % share.size();
  return mix(hues[i % kHues], towards[round], share[round]);
}

Rgb sheet_color() { return rgb("#d55e00"); }
Rgb wire_color() { return rgb("#a5460a"); }
Rgb point_color() { return rgb("#a5460a"); }
Rgb no_color() { return rgb("#b0b4ba"); }

Rgb relation_color(Relation relation) {
  static const std::array<Rgb, kRelations> colors{rgb("#0072b2"), rgb("#56b4e9"), rgb("#e69f00"), rgb("#009e73"),
                                                  rgb("#cc79a7")};
  return colors[static_cast<std::size_t>(relation)];
}

ColorBy default_colors(const ResultView& view) {
  const auto& materials = view.materials;
  if (std::any_of(materials.begin(), materials.end(), [](const auto& m) { return !m.color.empty(); })) {
    for (const Attributes* said : all_said(*view.value)) {
      if (!said->material.empty()) return ColorBy::material;
    }
  }
  return view.value->is_group() || view.of_group ? ColorBy::region : ColorBy::component;
}

void add_names(const std::vector<LeafInfo>& leaves, std::vector<std::string>& names) {
  std::set<std::string> known(names.begin(), names.end());
  for (const LeafId leaf : in_order_of_place(leaves)) {
    const std::string& name = leaves[leaf.index()].name;
    if (known.insert(name).second) names.push_back(name);
  }
}

LeafColors::LeafColors(const std::vector<LeafInfo>& leaves, std::vector<std::string> names)
    : numbers_(leaves.size()), names_(std::move(names)) {
  add_names(leaves, names_);
  std::map<std::string, std::size_t> numbers;
  for (const std::string& name : names_) numbers.emplace(name, numbers.size());
  for (const LeafId leaf : in_order_of_place(leaves))
    numbers_[leaf.index()] = numbers.at(leaves[leaf.index()].name);
}

CellColor LeafColors::of(std::span<const LeafId> leaves) const {
  std::set<std::size_t> numbers;
  for (const LeafId leaf : leaves) numbers.insert(numbers_[leaf.index()]);
  if (numbers.empty()) return {no_color(), "no leaf"};
  std::string text;
  std::size_t sets = 0;  // of all sets of leaves up to this one, as binary numbers
  for (const std::size_t n : numbers) {
    const std::string& name = names_[n];
    if (!text.empty()) text += " + ";
    text += name.empty() ? "frame" : name;
    sets = (sets + power_of_two(n)) % kPaletteSize;
  }
  const std::size_t last = *numbers.rbegin();
  if (numbers.size() == 1) return {palette_color(last), text};
  // Sets of one leaf are not counted: those up to this one are last + 1, and the empty set is one more.
  const std::size_t less = (last + 2) % kPaletteSize;
  return {palette_color(names_.size() + sets + kPaletteSize - less), text};
}

CellColors::CellColors(const ResultView& view, const FlatComplex& flat, std::vector<std::string> leaf_names)
    : view_(view),
      flat_(flat),
      leaves_(*view.leaves, std::move(leaf_names)),
      attributes_(view.value->attributes()) {
  materials_ = std::any_of(attributes_.begin(), attributes_.end(),
                           [](const RegionAttributes& a) { return !a.material.empty(); });
  std::size_t active = 0;
  for (const FlatComplex::Region& region : flat.regions) {
    rank_.push_back(active);
    active += region.component != 0;
  }
}

CellColor CellColors::of_material(int dimension, Component component) const {
  if (component == 0) return {no_color(), {}};
  const std::string& name = attributes_[component - 1].material.name();
  if (name.empty()) {
    if (dimension < 3) return of_kind(dimension);
    return materials_ ? CellColor{no_color(), "no material"} : of_component(component);
  }
  return of_name(view_, name);
}

CellColor CellColors::of_component(Component component) const {
  if (component == 0) return {no_color(), {}};
  const std::string& name = attributes_[component - 1].name;
  const std::string number = std::to_string(component);
  return {palette_color(component - 1), name.empty() ? "component " + number : number + " " + name};
}

CellColor CellColors::of_region(FlatComplex::Index region) const {
  const Component component = flat_.regions[region].component;
  if (component == 0) return {no_color(), {}};
  const std::string& name = attributes_[component - 1].name;
  std::string text(1, 'r');
  text += std::to_string(region);
  if (!name.empty()) text += " " + name;
  return {palette_color(rank_[region]), text};
}

CellColor CellColors::of(ColorBy by, int dimension, FlatComplex::Index i) const {
  const auto cell = [&](auto&& ask) {
    switch (dimension) {
      case 0: return ask(flat_.vertices[i]);
      case 1: return ask(flat_.edges[i]);
      case 2: return ask(flat_.faces[i]);
      default: return ask(flat_.regions[i]);
    }
  };
  switch (by) {
    case ColorBy::region: return dimension == 3 ? of_region(i) : of_kind(dimension);
    case ColorBy::material: {
      const Attributes* said = cell([](const auto& c) { return c.origin.said; });
      if (said != nullptr && !said->material.empty()) return of_name(view_, said->material.name());
      return of_material(dimension, cell([](const auto& c) { return c.component; }));
    }
    case ColorBy::component: return of_component(cell([](const auto& c) { return c.component; }));
    default: return leaves_.of(cell([](const auto& c) { return c.origin.leaves; }));
  }
}

CellColor CellColors::skin(ColorBy by, FlatComplex::Index region, FlatComplex::Index face) const {
  const FlatComplex::Face& f = flat_.faces[face];
  const bool said = f.origin.said != nullptr && !f.origin.said->material.empty();
  const bool own =
      f.component != 0 && (by == ColorBy::component || by == ColorBy::source || (by == ColorBy::material && said));
  return own ? of(by, 2, face) : of(by, 3, region);
}

}  // namespace cnrg
