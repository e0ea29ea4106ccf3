// What people say of a part of a model: its name, its material, and whatever else they want to hand on to a mesh
// or a report, as keys with values (`diameter: 25`, `section: round`).
//
// It is said of regions, and of what stands for itself in lower dimensions: a sheet, a wire, a point. How
// operators carry it is in csg/SEMANTICS.md#attributes.
#pragma once

#include <map>
#include <string>
#include <variant>
#include <vector>

#include "csg/materials/material.h"
#include "csg/materials/name.h"

namespace cnrg {

/// An exact number, or a text.
using Property = std::variant<Rational, std::string>;
using Properties = std::map<std::string, Property>;
/// The number as a fraction in lowest terms, or the text.
std::string to_text(const Property& value);

struct Attributes {
  Name name{};                ///< may be empty
  RegionMaterial material{};  ///< empty: none; a grade is placed in the space of the complex
  Properties properties{};
  /// Nothing is said.
  bool empty() const { return name.empty() && material.empty() && properties.empty(); }
  friend bool operator==(const Attributes&, const Attributes&) = default;
};

/// Some order of attributes, the same in every run but for materials graded differently under one name.
struct AttributesOrder {
  bool operator()(const Attributes& a, const Attributes& b) const;
};

/// A material, or the value of a property, that gave way to another one without being dominated.
struct Yielded {
  std::string key{};          ///< of the property; empty: it is the material
  RegionMaterial material{};  ///< if it is the material
  Property value{};           ///< if it is a property
  /// True if that is said in `attributes`.
  bool is_in(const Attributes& attributes) const;
  /// The name of the material, or the value.
  std::string text() const;
  friend bool operator==(const Yielded&, const Yielded&) = default;
};

/// What `weaker` says of material and properties is added to `kept` where that is silent; where it says something
/// else it gives way, which is added to `yielded`, each once. Names are left to the caller.
void fill_in(Attributes& kept, const Attributes& weaker, std::vector<Yielded>& yielded);

/// The same, the name included, where nobody asks what gave way.
void fill_in(Attributes& kept, const Attributes& weaker);

/// What `stronger` says replaces what `attributes` say: name and material if they are given, properties key by
/// key.
void replace(Attributes& attributes, const Attributes& stronger);

}  // namespace cnrg
