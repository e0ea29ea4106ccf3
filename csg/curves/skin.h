// Solids between sections: a profile at several places, and walls between each place and the next.
//
// A section is a profile as homogeneous nets, a row for each segment. Where two sections have straight segments
// whose four ends lie in a plane, the wall is flat; all other walls are Bézier patches, u along the segment, v
// from section to section. So a skin is a `bezier` leaf with flat faces: fineness, parameters, true surfaces and
// common lines with other leaves are the same. Faces are numbered: patches, flat walls, the first section, the
// last one.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "csg/curves/parametric.h"
#include "csg/curves/surface.h"

namespace cnrg {

/// Rows of the segments of each line: the outer one, then holes, which run against it.
using Section = std::vector<std::vector<ControlRow>>;

/// The section of a closed planar profile. Throws InputError for what is none; `shape` begins messages. `normal`,
/// if given, gets the normal of its plane from which the outer line is counter-clockwise.
Section section_of(const Profile& profile, const char* shape, RationalPoint* normal = nullptr);
/// Each control point somewhere else, weights included.
template <class Map>
Section mapped(Section section, Map map) {
  for (auto& line : section) {
    for (ControlRow& row : line) {
      for (Homogeneous& h : row) h = map(h);
    }
  }
  return section;
}

class Skin {
 public:
  Skin(const char* shape, const Tessellation& tessellation)
      : form_(std::make_shared<NetForm>(shape, tessellation, Fill::winding)) {}
  /// The walls of the next band; rows of control points from section to section, two or more.
  void add_band(const std::vector<Section>& rows);
  /// With the ends; there is a band.
  std::shared_ptr<const NetForm> finish();

 private:
  void add_wall(const std::vector<Section>& rows, std::size_t line, std::size_t segment, const std::string& name);
  NetForm::Flat end(const Section& section, std::size_t first_wall, bool last_row) const;

  std::shared_ptr<NetForm> form_;
  std::vector<NetForm::Flat> walls_;                       // flat ones
  std::vector<std::optional<std::size_t>> patch_of_wall_;  // of all walls; nothing for a flat one
  Section first_, last_;
  std::size_t bands_ = 0, last_band_ = 0;
};

std::unique_ptr<PreparedLeaf> prepare_skin(std::shared_ptr<const NetForm> skin, LeafParameters* record);
std::shared_ptr<const LeafSurfaces> skin_surfaces(const NetForm& skin);

}  // namespace cnrg
