// The nets of a leaf of Bézier, B-spline or Coons patches and of curves, and the way from them to facets.
//
// All become Bézier pieces. The pieces of one patch of the tree share its number, the wires of one curve the
// curve's; so people see the patches and curves that were given, however they are cut.
//
// A leaf alone is tessellated in its own coordinates, by its own fineness. Leaves that share surfaces or curves
// are tessellated where they are placed, with pieces cut further and steps that all of them agreed on
// (csg/carriers): that is `CommonNets`, which says everything that differs.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "csg/curves/boundary_curves.h"
#include "csg/curves/control_nets.h"
#include "csg/curves/patch_mesh.h"
#include "csg/leaves/leaf.h"
#include "csg/leaves/parameters.h"

namespace cnrg {

/// A piece of a patch and the parameters between which it runs, along u and v.
struct NetPiece {
  BezierPatch patch;
  std::array<Span, 2> span;
};
/// A piece of a curve.
struct CurvePiece {
  BezierCurve curve;
  Span span;
};

/// What a leaf was made of, its degrees and weights as given.
class NetForm final : public CurvedForm {
 public:
  struct Patch {
    std::string name;  ///< for messages: "the patch", "patch 2"
    std::vector<NetPiece> pieces;
  };
  struct Curve {
    std::string name;
    std::vector<CurvePiece> pieces;
  };
  /// A flat face of a skin (skin.h), numbered after the patches: the outer loop first. Each side runs from its
  /// corner to the next one, straight, or along the first or last row of a patch, which begins in the corner.
  struct Flat {
    struct Side {
      RationalPoint corner;
      std::optional<std::size_t> patch{};
      bool last_row = false;
    };
    std::string name;
    std::vector<std::vector<Side>> loops;
    bool turned = false;  ///< its front is that of the loops run backward
  };
  NetForm(const char* shape, const Tessellation& tessellation, Fill fill)
      : fineness(shape, tessellation), fill(fill) {}

  Fineness fineness;
  Fill fill;
  std::vector<Patch> patches;  ///< by number
  std::vector<Curve> curves;   ///< by number
  std::vector<Flat> flats;
};

/// How a leaf is tessellated together with others.
struct CommonNets {
  struct Piece {
    NetPiece net;
    Fineness fineness;
    PatchLines lines;
  };
  Transform transform;                      ///< that of the leaf
  std::vector<std::vector<Piece>> patches;  ///< pieces by patch, transformed and cut
  std::vector<std::vector<CurvePiece>> curves;
  std::shared_ptr<const AgreedSteps> steps;
};

/// Throws InputError for what is wrong in the shape.
std::shared_ptr<const NetForm> net_form(const BezierShape& shape);
std::shared_ptr<const NetForm> net_form(const CoonsShape& shape);

/// The facets of the leaf; `record` (if any) gets its parameters. With `common` the geometry is where the leaf was
/// placed.
std::unique_ptr<PreparedLeaf> tessellate(const NetForm& form, const CommonNets* common, LeafParameters* record);

}  // namespace cnrg
