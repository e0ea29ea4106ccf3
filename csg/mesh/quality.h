// How good the tetrahedra of a mesh are, and where the bad ones are and why.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "csg/mesh/mesh.h"

namespace cnrg {

/// Of one tetrahedron, in doubles.
struct TetrahedronMeasures {
  double shape = 0;        ///< 12 (3 V)^(2/3) / (sum of squared edges), 1 of a regular one (liu1994)
  double radius_edge = 0;  ///< circumradius to shortest edge; sqrt(6) / 4 of a regular one
  double dihedral = 0;     ///< the smallest of its six, degrees
  double volume = 0;
};
TetrahedronMeasures measures_of(const std::array<std::array<double, 3>, 4>& corners);

struct MeshQuality {
  static constexpr double kBad = 0.1;  ///< a shape below is counted as bad
  static constexpr std::size_t kShown = 10;
  /// Degrees. A tetrahedron is bad if two of its faces, two of its edges or a face and an edge meet at less:
  /// shapes are below 0.098 then.
  static constexpr double kForced = 0.9;
  struct Region {
    std::size_t bad = 0;
    std::size_t beyond = 0;        ///< as of all
    double worst = 1, median = 1;  ///< shapes
  };
  /// A tetrahedron that is bad.
  struct Bad {
    std::array<double, 3> at;  ///< its middle
    TetrahedronMeasures measures;
    std::string why;                 ///< words, escaped
    std::vector<std::string> nodes;  ///< names of leaves whose cells meet there, escaped
    std::size_t tetrahedron = 0;     ///< its place in the mesh
  };
  std::vector<Region> regions;  ///< as the mesh's entities of dimension 3
  std::size_t bad = 0;
  std::size_t forced = 0;  ///< of them where the model is sharper than `kForced`: whatever else is there is bad
  /// Of the bad ones those that are flat for a gap between two cells of the model, which do not touch.
  std::size_t near = 0;
  double narrowest = 0;    ///< of these gaps (units); 0: there are none
  double extent = 0;       ///< the longest side of the box around all
  std::size_t beyond = 0;  ///< whose ratio of circumradius to shortest edge is larger than asked for
  std::size_t larger = 0;  ///< whose volume is larger than asked for
  double largest = 0;      ///< volume of all
  double worst = 1, median = 1, largest_radius_edge = 0, smallest_dihedral = 180;
  std::array<std::size_t, 20> shapes{};     ///< how many by twentieths
  std::array<std::size_t, 18> dihedrals{};  ///< by the smallest angle, 5 degrees each
  /// By ratios of circumradius to shortest edge, from 0.6 on 0.2 each; all larger ones are in the last.
  std::array<std::size_t, 16> ratios{};
  std::vector<Bad> worst_ones;  ///< `kShown` at most, the worst first
};

/// `leaves`: their names, by number; `radius_edge`, `volume`: the largest that were asked for, 0: none.
MeshQuality quality_of(const Mesh& mesh, const std::vector<std::string>& leaves, double radius_edge = 0,
                       double volume = 0);

/// `2 of them are where faces or edges of the model meet at less than 0.9 degrees: ...`; empty where none is.
std::string forced_text(const MeshQuality& quality);

/// What helps where shapes are bad for what nearly touches: where that is nearer than 1e-4 of the extent, or where
/// they are more than a hundredth of all; empty elsewhere.
std::string joining_text(const MeshQuality& quality);

/// `6 tetrahedra are larger than --max-volume, the largest 0.167`; empty where none is.
std::string larger_text(const MeshQuality& quality);

/// Places of a mesh in words, `19.36 4.3 13.96`: six digits of each coordinate, and more where the mesh is small
/// beside its distance from the origin, so that each is told to a millionth of the mesh's size.
class PlaceText {
 public:
  explicit PlaceText(const Mesh& mesh);
  std::string operator()(const std::array<double, 3>& at) const;

 private:
  int digits_ = 6;
};

/// How good triangles are: by their smallest angles.
struct TriangleQuality {
  struct Bad {
    std::array<double, 3> at;  ///< its middle
    double angle = 0;          ///< degrees
    std::vector<std::string> nodes;
    std::size_t triangle = 0;  ///< its place in the mesh
  };
  std::array<std::size_t, 12> angles{};  ///< by the smallest angle, 5 degrees each
  std::vector<Bad> worst_ones;           ///< `MeshQuality::kShown` at most, the worst first
};
TriangleQuality triangle_quality_of(const Mesh& mesh, const std::vector<std::string>& leaves);

}  // namespace cnrg
