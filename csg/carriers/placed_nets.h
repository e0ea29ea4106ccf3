// A leaf with nets under its transform: its pieces in the space of all, where they are cut, and its facets.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "csg/carriers/cuts.h"
#include "csg/carriers/extra_lines.h"
#include "csg/curves/extrude.h"
#include "csg/curves/parametric.h"
#include "csg/leaves/leaf.h"

namespace cnrg {

/// A piece between cuts, with lines along u and along v as parameters of it.
struct CutPiece : NetPiece {
  PatchLines lines;
};
struct CutCurve : CurvePiece {
  std::vector<Rational> lines;
};

struct PlacedPiece {
  std::size_t number;  ///< of the patch
  BezierPatch patch;   ///< of least degree
  std::array<Span, 2> span;
  std::array<std::size_t, 2> strand{};  ///< of `Cuts`, along u and along v
  std::vector<CutPiece> parts(const Cuts& cuts) const;
};

/// A wire, or a segment of a profile.
struct PlacedCurve {
  std::size_t number;  ///< of the curve; of a profile that of the segment, through all lines
  ControlRow net;
  Span span;
  std::size_t strand = 0;
  std::vector<CutCurve> parts(const Cuts& cuts) const;
};

/// The finenesses that are asked for of patches, by their canonical nets.
using FinestPatches = std::map<std::vector<ControlRow>, Fineness>;

/// A curve swept along a vector is compared with others by its projection along it.
struct Sweep {
  RationalPoint vector;
  RationalPoint direction;  ///< its first coordinate that is not zero is 1
  explicit Sweep(const RationalPoint& along);
  ControlRow projected(ControlRow net) const;
  ControlRow far_rim(ControlRow net) const;  ///< the net moved by the vector
  /// Between which heights the swept net lies, in units of the direction.
  std::array<Rational, 2> heights(const ControlRow& net) const;

 private:
  std::size_t pivot() const;
};
/// If the patch is a curve that moves along a vector, S(u, v) = p(u) + v t, without weights.
std::optional<Sweep> sweep_of(const BezierPatch& patch);

class PlacedNets {
 public:
  /// True for leaves of patches and curves and for extrusions without twist and scale.
  static bool has_nets(const LeafInstance& instance);
  /// Along x, y and z: the leaf lies between, before its transform.
  using Extent = std::array<std::array<Rational, 2>, 3>;
  static Extent extent_of(const PreparedLeaf& leaf);
  PlacedNets(const LeafInstance& instance, const Extent& of_leaf, std::size_t owner);

  /// Fills `pieces` and `curves`.
  void place();
  /// Further lines of it, for `cuts`; after `place`.
  void add_lines(const ExtraLines& lines, Cuts& cuts);
  const Fineness& fineness() const { return nets_ ? nets_->fineness : extrusion_->fineness; }
  /// Of an extrusion.
  const std::optional<Sweep>& sweep() const { return sweep_; }
  /// The leaf with its pieces cut.
  std::shared_ptr<const PreparedLeaf> tessellated(const Cuts& cuts, const FinestPatches& finest,
                                                  std::shared_ptr<const AgreedSteps> steps) const;

  std::size_t owner;                   ///< the first instance that is this leaf under this transform
  std::vector<std::size_t> instances;  ///< all of them
  Extent extent;                       ///< where it is placed
  std::vector<PlacedPiece> pieces;
  std::vector<PlacedCurve> curves;

 private:
  std::shared_ptr<const PreparedLeaf> nets_anew(const Cuts& cuts, const FinestPatches& finest,
                                                std::shared_ptr<const AgreedSteps> steps) const;
  std::shared_ptr<const PreparedLeaf> extrusion_anew(const Cuts& cuts,
                                                     std::shared_ptr<const AgreedSteps> steps) const;
  std::shared_ptr<const NetForm> nets_;  // one of the two
  std::shared_ptr<const ExtrudeForm> extrusion_;
  std::shared_ptr<const PreparedLeaf> leaf_;  // as it was prepared
  Transform transform_;
  std::optional<Sweep> sweep_;
  std::set<Rational> heights_;  // of an extrusion: further lines, parts of its vector
};

}  // namespace cnrg
