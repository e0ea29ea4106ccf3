// Colors of regions, components, materials and leaves: which color a cell gets, for every kind of picture.
//
// The obvious way is that each picture counts what it shows and takes the next color. Then a leaf is blue in one
// panel and orange in the next. Here a color depends on a number that the thing has in all nodes and in all files:
// of a material its place in the tree's list, of a component and of an active region its own number, of leaves
// theirs. Two pictures of one tree agree without knowing of each other.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "csg/operators/tables.h"
#include "csg/result/flat.h"
#include "csg/result/result_view.h"

namespace cnrg {

using Rgb = std::array<double, 3>;  ///< 0 to 1

/// `#rrggbb` as a color and back, rounded; what has another form is an InvariantError.
Rgb rgb(const std::string& hex);
std::string hex(const Rgb& color);
/// From a (t = 0) to b (t = 1).
Rgb mix(const Rgb& a, const Rgb& b, double t);

/// Seven colors that are told apart with any color vision, then the same paler, then darker: all soft, so that
/// edges and what is picked stand out.
inline constexpr std::size_t kPaletteSize = 21;
Rgb palette_color(std::size_t i);  ///< for any i: they come again

/// What has no thickness is told by a color of its own; so is what nothing is said of.
Rgb sheet_color();
Rgb wire_color();
Rgb point_color();
Rgb no_color();
/// Of an entity by where it lies with respect to the other operand.
Rgb relation_color(Relation relation);

enum class ColorBy : std::uint8_t {
  region,     ///< sheets, wires and points in their own colors
  material,   ///< of its own material, else of its component's; see CellColors::of_material where there is none
  component,  ///< of a component of a CNRG operator or a region of a group, entities with them
  source,     ///< the leaves that a cell came from
};
/// What is chosen where nobody has chosen: materials, if they have colors and the node has materials; else what
/// the node is made of, which is regions of a group and components of everything else.
ColorBy default_colors(const ResultView& view);

/// A color and what it means to people; several cells have the same.
struct CellColor {
  Rgb color{};
  std::string text;  ///< empty if there is nothing to say but what kind of cell it is
};

/// Adds the names of the leaves below a node, in the order of its subtree, each once.
void add_names(const std::vector<LeafInfo>& leaves, std::vector<std::string>& names);

/// A leaf has the color of its number, a set of leaves one of the colors that come after those of all leaves: up
/// to four leaves and their sets all have different ones. Leaves of one name (a node used twice) are one.
class LeafColors {
 public:
  /// `names`: of all leaves of a picture that shows more nodes than this one.
  explicit LeafColors(const std::vector<LeafInfo>& leaves, std::vector<std::string> names = {});
  /// Of what came from these.
  CellColor of(std::span<const LeafId> leaves) const;

 private:
  std::vector<std::size_t> numbers_;  // by LeafId
  std::vector<std::string> names_;    // by number
};

/// The colors of one node's cells. Keeps references to the view and the cells.
class CellColors {
 public:
  CellColors(const ResultView& view, const FlatComplex& flat, std::vector<std::string> leaf_names = {});

  /// Of cell i of a dimension.
  CellColor of(ColorBy by, int dimension, FlatComplex::Index i) const;
  /// Of the side of face `face` that is the skin of region `region`: the region's color, except by component and
  /// by source, where a face of the set has its own, and by material, where it has one by itself.
  CellColor skin(ColorBy by, FlatComplex::Index region, FlatComplex::Index face) const;

  /// A cell of dimension 2 or lower without material has the color of its kind; a region the color of `no
  /// material` where another of the node's has one, else that of its component.
  CellColor of_material(int dimension, Component component) const;
  CellColor of_component(Component component) const;
  /// Of active regions counted in their order: r3 has the color of its rank among them.
  CellColor of_region(FlatComplex::Index region) const;

 private:
  const ResultView& view_;
  const FlatComplex& flat_;
  LeafColors leaves_;
  std::vector<RegionAttributes> attributes_;  // of component c at c - 1
  bool materials_ = false;                    // a component has one
  std::vector<std::size_t> rank_;             // of active regions
};

}  // namespace cnrg
