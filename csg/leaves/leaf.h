// What a leaf is: a shape that is prepared once, then put into a soup (kernel/refine/soup.h: faces, wires and
// points that nothing has cut yet) under each transform that the tree gives it.
//
// Files are read and checked before any soup is made, so that `cnrg check` can validate without evaluating and
// so that an unbounded leaf can see how far the others reach.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "csg/geometry/transform.h"
#include "csg/leaves/shapes.h"
#include "csg/materials/attributes.h"
#include "kernel/base/error.h"

namespace cnrg {

class LeafParameters;
class LeafSurfaces;
struct StoredValue;

/// The surfaces that carry the curved patches of a leaf, before its transform. csg/carriers compares those of all
/// leaves; what is derived from this says which kinds there are.
class CurvedForm {
 public:
  virtual ~CurvedForm() = default;
};

/// A fault inside a file that a leaf reads: who knows the tree's position may add where the file is used.
class LeafFileError : public InputError {
 public:
  /// The message is `file:line:column: error: fault`; without a line, or a column, where these are 0.
  LeafFileError(const std::string& file, int line, int column, const std::string& fault)
      : InputError(file + (line > 0 ? ":" + std::to_string(line) : "") +
                   (column > 0 ? ":" + std::to_string(column) : "") + ": error: " + fault),
        file_(file),
        fault_(fault),
        line_(line),
        column_(column) {}
  const std::string& file() const { return file_; }
  const std::string& fault() const { return fault_; }
  int line() const { return line_; }
  int column() const { return column_; }

 private:
  std::string file_, fault_;
  int line_, column_;
};

/// A fault in the value that one key of a leaf has.
class LeafKeyError : public InputError {
 public:
  LeafKeyError(std::string key, const std::string& fault) : InputError(fault), key_(std::move(key)) {}
  const std::string& key() const { return key_; }

 private:
  std::string key_;
};

/// Runs `work`, of which every fault is in the value of `key`.
template <class Work>
auto in_value_of(const char* key, Work work) {
  try {
    return work();
  } catch (const InputError& e) {
    throw LeafKeyError(key, e.what());
  }
}

/// A fault in one of the faces that a leaf lists.
class LeafFaceError : public InputError {
 public:
  LeafFaceError(std::size_t face, const std::string& fault) : InputError(fault), face_(face) {}
  std::size_t face() const { return face_; }

 private:
  std::size_t face_;
};

/// Makes the parameters of a leaf (parameters.h), also when the leaf itself is gone. Empty for a leaf without
/// patches and curves.
using ParameterSource = std::function<std::shared_ptr<const LeafParameters>()>;

/// Makes the true surfaces and curves of a leaf (csg/curves/surface.h), in the parameters that ParameterSource
/// gives its facets. Empty for a leaf whose facets are what is meant.
using SurfaceSource = std::function<std::shared_ptr<const LeafSurfaces>()>;

/// A shape whose files were read and whose geometry was checked. It keeps what it needs of them.
class PreparedLeaf {
 public:
  virtual ~PreparedLeaf() = default;
  /// Adds the leaf under a transform. A reflection does not turn it inside out: sides and winding mean the same.
  /// An unbounded leaf adds only its id; `make_soup`, which sees how far the others reach, adds its face.
  virtual LeafId add_to(Soup& soup, const Transform& transform) const = 0;
  /// What the leaf itself says of its regions (regions of a group, components of results read back): region i
  /// (from 1) has entry i - 1. The node's own attributes are in the tree. A grade is in the leaf's coordinates.
  virtual std::vector<Attributes> regions() const = 0;
  /// The value of a result read back or joined (csg/transfer/stored_value.h); `regions` are then its components.
  /// Nothing for all other leaves.
  virtual const StoredValue* stored() const { return nullptr; }
  /// How far the volumes of such a value may be from those between true surfaces, before the transform; nothing:
  /// nobody knows.
  virtual std::optional<double> volume_bound() const { return 0.0; }
  /// Things to tell the user, such as an open mesh that is taken as a surface.
  virtual std::vector<std::string> notices() const { return {}; }
  /// True for planes and half-spaces.
  virtual bool unbounded() const { return false; }

  /// How to get the parameters of a curved leaf: `add_to` adds faces and wires in their order. Empty for others.
  const ParameterSource& parameters() const { return parameters_; }
  /// They are made once, and kept.
  void set_parameters(ParameterSource source);

  /// How to get the true surfaces of a curved leaf. Empty for others.
  const SurfaceSource& surfaces() const { return surfaces_; }
  void set_surfaces(SurfaceSource source) { surfaces_ = std::move(source); }

  /// True if faces stand for curved ones: of true surfaces, or of a value that is read back.
  bool curved() const { return surfaces_ || volume_bound() != 0.0; }

  /// Of a curved leaf: what its patches lie on. Null for others.
  const std::shared_ptr<const CurvedForm>& form() const { return form_; }
  void set_form(std::shared_ptr<const CurvedForm> form) { form_ = std::move(form); }

 private:
  ParameterSource parameters_;
  SurfaceSource surfaces_;
  std::shared_ptr<const CurvedForm> form_;
};

/// Reads files and checks everything that can be checked for the leaf alone. Throws InputError: the message
/// starts with `file:line:` for a fault inside a mesh file (LeafFileError), otherwise it has no position and the
/// tree reader puts the node's position in front. Throws FileError if a file exists but cannot be read.
std::shared_ptr<const PreparedLeaf> prepare(const Shape& shape);

/// One instance of a leaf.
struct LeafInstance {
  std::shared_ptr<const PreparedLeaf> leaf;
  SharedTransform transform{};
  SharedTransform above{};  ///< what the leaf's users add to its own transform: `transform` less that
};

/// Makes the soup of all instances, which it copies; LeafId(i) is instance i. If one is unbounded, the frame
/// (unbounded.h) is one more leaf at the end, around the others and the points `reach`. `surfaces`: of each
/// instance the numbers of its patches' surfaces (csg/carriers/surface_numbers.h); empty: none is known.
Soup make_soup(const std::vector<LeafInstance>& instances, std::span<const RationalPoint> reach = {},
               std::span<const std::vector<std::uint32_t>> surfaces = {});

}  // namespace cnrg
