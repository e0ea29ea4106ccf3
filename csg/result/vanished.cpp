#include "csg/result/vanished.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "csg/result/part_text.h"
#include "csg/result/relabel.h"
#include "csg/result/result_data.h"
#include "csg/text/escape.h"
#include "csg/text/table.h"
#include "kernel/base/vectors.h"
#include "kernel/selection/canonical.h"

namespace cnrg {
namespace {

using Index = FlatComplex::Index;

/// Its name, or else its leaves.
std::string name_of_region(const ResultView& view, const FlatComplex& flat, Index r) {
  const std::string name = shown(attributes_of(view, flat.regions[r].component).name.text());
  return name.empty() ? "a region of " + names_of_leaves(view, flat.regions[r].origin) : name;
}

/// `, at (1, 2, 3)`: the first of its points.
std::string place_of_region(const ResultView& view, const FlatComplex& flat, Index r) {
  Index first = FlatComplex::kNone;
  for (const auto& shell : flat.regions[r].shells) {
    for (const Index side : shell) {
      for (const auto& t : flat.faces[side / 2].triangles) first = std::min({first, t[0], t[1], t[2]});
    }
  }
  if (first == FlatComplex::kNone) return "";
  return ", at " + coordinates(view.complex->points.rational(flat.points[first]));
}

/// In doubles; of a bounded region.
double rough_volume(const ResultView& view, const FlatComplex& flat, Index r) {
  const auto at = [&](Index p) {
    const auto& q = view.complex->points.nearest(flat.points[p]);
    return DoubleVector{q[0], q[1], q[2]};
  };
  double sum = 0;
  std::optional<DoubleVector> origin;
  for (const auto& shell : flat.regions[r].shells) {
    for (const Index side : shell) {
      for (const auto& t : flat.faces[side / 2].triangles) {
        if (!origin) origin = at(t[0]);
        const double six =
            dot(minus(at(t[0]), *origin), cross(minus(at(t[1]), *origin), minus(at(t[2]), *origin)));
        sum += side % 2 == 0 ? -six : six;
      }
    }
  }
  return std::abs(sum) / 6;
}

/// Regions of a group in the order of the components that it is made of.
void keep_order(const Components& x, Group& group) {
  const std::size_t n = group.regions.size();
  std::vector<Component> from(n, 0);
  for (std::size_t i = 0; i < group.cells.size(); ++i)
    from[group.cells[i].second - 1] = x.selection.regions[i].second;
  std::vector<std::uint32_t> order(n), number(n);
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return from[a] < from[b]; });
  std::vector<RegionAttributes> regions;
  for (std::size_t k = 0; k < n; ++k) {
    number[order[k]] = static_cast<std::uint32_t>(k + 1);
    regions.push_back(std::move(group.regions[order[k]]));
  }
  group.regions = std::move(regions);
  for (auto& [cell, region] : group.cells) region = number[region - 1];
}

/// Of each component what number it has, of those that have a cell.
std::vector<Component> numbers_of_left(const Components& x) {
  std::vector<Component> number(x.attributes.size() + 1, 0);
  const auto mark = [&](const auto& cells) {
    for (const auto& [cell, component] : cells) number[component] = 1;
  };
  mark(x.selection.regions), mark(x.selection.faces), mark(x.selection.edges), mark(x.selection.vertices);
  Component last = 0;
  for (Component& n : number) {
    if (n != 0) n = ++last;
  }
  return number;
}

}  // namespace

void LostRegions::add(const ResultView& view, const FlatComplex& flat, Index r, bool numbered) {
  Lost& lost = lost_[flat.regions[r].component];
  if (lost.pieces++ > 0) return;
  lost.name = name_of_region(view, flat, r);
  if (numbered) lost.place = ", r" + std::to_string(r);
  lost.place += place_of_region(view, flat, r);
}

std::vector<std::string> LostRegions::lines(const std::set<Component>& left) const {
  std::vector<std::string> out;
  for (const auto& [component, lost] : lost_) {
    const bool whole = !left.contains(component);
    std::string pieces;
    if (lost.pieces > 1) pieces = std::string(whole ? " (all " : " (") + std::to_string(lost.pieces) + " pieces)";
    else if (!whole) pieces = " (a piece)";
    out.push_back(lost.name + pieces + lost.place);
  }
  return out;
}

std::set<Component> components_with_regions(const FlatComplex& flat) {
  std::set<Component> out;
  for (Index r = 0; r < flat.regions.size(); ++r) {
    if (flat.active(r)) out.insert(flat.regions[r].component);
  }
  return out;
}

std::string vanished_text(std::size_t faces, std::size_t wires, std::size_t regions) {
  std::string text;
  if (faces > 0) text += "; " + counted(faces, "face", "faces") + " vanished";
  if (wires > 0) text += "; " + counted(wires, "wire", "wires") + " vanished";
  if (regions > 0) text += "; " + counted(regions, "region", "regions") + " vanished";
  return text;
}

std::vector<std::string> vanished_warnings(const std::vector<std::string>& lines, const std::string& distance) {
  std::vector<std::string> out;
  for (const std::string& region : lines)
    out.push_back("the region " + region + ", is thinner than " + distance + " and has vanished");
  return out;
}

std::vector<std::string> parted_warnings(const FlatComplex& before, const std::vector<Index>& left,
                                         const ResultView& view, const FlatComplex& after) {
  std::map<Component, std::size_t> pieces;
  for (const Index r : left) ++pieces[before.regions[r].component];
  std::map<Component, std::vector<Index>> now;
  for (Index r = 0; r < after.regions.size(); ++r) {
    if (after.active(r)) now[after.regions[r].component].push_back(r);
  }
  std::vector<std::string> out;
  for (const auto& [component, regions] : now) {
    const std::size_t was = pieces[component];
    if (was == 0 || regions.size() <= was) continue;
    const Index smallest = *std::min_element(regions.begin(), regions.end(), [&](Index r, Index s) {
      return rough_volume(view, after, r) < rough_volume(view, after, s);
    });
    out.push_back("the region " + name_of_region(view, after, smallest) + " is in " +
                  std::to_string(regions.size()) + " pieces now and was in " +
                  (was == 1 ? "one" : std::to_string(was)) + ", the smallest" +
                  place_of_region(view, after, smallest).substr(1));
  }
  return out;
}

std::shared_ptr<const Result::Data> settled(Result::Data data) {
  Components x = data.value->components();
  const std::vector<Component> number = numbers_of_left(x);
  std::vector<ComponentAttributes> attributes;
  for (Component c = 1; c < number.size(); ++c) {
    if (number[c] != 0) attributes.push_back(std::move(x.attributes[c - 1]));
  }
  x.attributes = std::move(attributes);
  const auto renumber = [&](auto& cells) {
    for (auto& [cell, component] : cells) component = number[component];
  };
  renumber(x.selection.regions), renumber(x.selection.faces);
  renumber(x.selection.edges), renumber(x.selection.vertices);
  const Complex& complex = *data.complex;
  if (data.of_group) {
    Group group = group_of(complex, x);
    keep_order(x, group);
    data.value = std::make_shared<const NodeValue>(complex, std::move(group));
  } else {
    data.value = std::make_shared<const NodeValue>(std::move(x));
  }
  data.of_group = false;
  const Components parts =
      data.value->is_group() ? components_of(complex, data.value->group()) : data.value->components();
  SimplifiedComplex cells = simplify_relabelled(complex, parts, data.value->features(),
                                                data.raw ? SimplifyMode::raw : SimplifyMode::features);
  put_in_order(complex, cells);
  data.simplified = std::make_shared<const SimplifiedComplex>(std::move(cells));
  return std::make_shared<const Result::Data>(std::move(data));
}

}  // namespace cnrg
