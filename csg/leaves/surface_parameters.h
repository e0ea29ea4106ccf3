// Parameters of points of a complex on the patches and curves of its leaves (parameters.h).
//
// A leaf is tessellated again, for its parameters, when a point on it is asked for, once. All is thread-safe.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "csg/leaves/leaf.h"
#include "csg/leaves/parameters.h"
#include "kernel/complex/complex.h"

namespace cnrg {

/// A leaf of the complex: where its parameters come from (empty: nowhere), how it was placed, its true surfaces.
struct PlacedParameters {
  ParameterSource source;
  SharedTransform transform{};
  SurfaceSource surfaces{};
};

/// S(at) is near the point asked for, and equal to it where that is a vertex of the tessellation.
struct PatchPoint {
  LeafId leaf;
  std::uint32_t patch = 0;  ///< Soup::Face::patch
  Parameters at;
  friend bool operator==(const PatchPoint&, const PatchPoint&) = default;
};
struct CurvePoint {
  LeafId leaf;
  std::uint32_t curve = 0;  ///< Soup::Wire::leaf_edge
  Rational at;
  friend bool operator==(const CurvePoint&, const CurvePoint&) = default;
};

/// A cell of a patch, its corners where the leaf was placed.
struct PlacedCell {
  LeafId leaf;
  std::uint32_t patch = 0;
  std::vector<PatchCorner> corners;
};

/// Of each soup face and wire that a complex came from, its place among those that its leaf has added. What knows
/// parameters of facets (csg/leaves/surface_parameters.h) counts them so.
struct LeafPlaces {
  IdVector<SourceId, std::uint32_t> faces;
  IdVector<WireId, std::uint32_t> wires;
  LeafPlaces() = default;
  /// Of a complex in which the faces of each leaf follow each other.
  explicit LeafPlaces(const Complex& complex);
};

class SurfaceParameters {
 public:
  /// `leaves` by LeafId; `complex` must outlive this.
  /// Without `places` the faces and wires of a leaf follow each other among those of the complex.
  SurfaceParameters(const Complex& complex, std::vector<PlacedParameters> leaves,
                    std::optional<LeafPlaces> places = std::nullopt);
  ~SurfaceParameters();

  /// True if the leaf has patches or curves with parameters.
  bool has(LeafId leaf) const;
  /// "" for what has none.
  std::string patch_name(LeafId leaf, std::uint32_t patch) const;
  std::string curve_name(LeafId leaf, std::uint32_t curve) const;

  /// The true surfaces and curves of the leaf, before its transform; null where its facets are what is meant.
  std::shared_ptr<const LeafSurfaces> surfaces(LeafId leaf) const;
  /// The identity for the frame.
  const Transform& transform(LeafId leaf) const;

  /// The cells in which a face of the soup lies, before the leaf's transform; none for a leaf without parameters.
  std::vector<std::vector<PatchCorner>> cells(SourceId source) const;
  /// The cells of patches of the given leaves (ascending) in which a face of the complex lies.
  std::vector<PlacedCell> cells(FaceId f, std::span<const LeafId> leaves) const;
  /// Places on the patches of the given leaves (ascending) of a point of a face, an edge or a vertex of the
  /// complex: ascending by leaf, patch and parameters, each once. Where patches meet it has one on each; on a seam
  /// or at a pole more than one on a patch.
  std::vector<PatchPoint> on_patches(const Location& cell, const RationalPoint& p,
                                     std::span<const LeafId> leaves) const;
  /// The same on curves, for a point of an edge or a vertex.
  std::vector<CurvePoint> on_curves(const Location& cell, const RationalPoint& p,
                                    std::span<const LeafId> leaves) const;

 private:
  struct Leaf;
  std::size_t facet_of(SourceId source) const;
  std::size_t wire_of(WireId wire) const;
  const LeafParameters& parameters(LeafId leaf) const;
  const Complex& complex_;
  std::vector<std::unique_ptr<Leaf>> leaves_;  // by LeafId
  std::optional<LeafPlaces> places_;
};

/// The first place on each patch (curve): enough for people, on a seam or at a pole.
std::vector<PatchPoint> first_of_each(std::vector<PatchPoint> points);
std::vector<CurvePoint> first_of_each(std::vector<CurvePoint> points);

}  // namespace cnrg
