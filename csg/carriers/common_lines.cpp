// The stage between prepared leaves and their soup.
#include "csg/carriers/common_lines.h"

#include "csg/carriers/axes.h"
#include "csg/carriers/axial.h"
#include "csg/carriers/bands.h"
#include "csg/carriers/boxes.h"
#include "csg/carriers/extruded_arcs.h"
#include "csg/carriers/nets.h"
#include "csg/carriers/revolved_families.h"
#include "csg/carriers/round_spaces.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/refine/box_tree.h"

namespace cnrg {
namespace {

using Index = std::uint32_t;

/// False for an axis whose numbers are too far apart for doubles, such as [1e300, 1, 0]: such a leaf stays as it
/// is.
bool in_range_of_doubles(const RationalPoint& axis, const Transform& transform) {
  const RationalPoint direction = axis_line({0, 0, 0}, transform.apply_to_vector(axis)).direction;
  return to_double(dot(direction, direction)) < 1e300 && to_double(dot(axis, axis)) < 1e300;
}

}  // namespace

std::vector<LeafInstance> with_common_lines(std::vector<LeafInstance> instances, std::vector<NearSurfaces>* near,
                                            std::vector<LeafWords>* apart, const std::vector<Index>& anew,
                                            const ExtraOfInstances& extra, std::set<Index>* drawn,
                                            DrawnLeaves* known) {
  std::set<Index> have_lines;
  DrawnLeaves none_known;
  if (drawn == nullptr) drawn = &have_lines;
  if (known == nullptr) known = &none_known;
  instances = with_common_nets(instances, extra, drawn);
  const std::map<Index, LeafInstance> stretched = replace_axial(instances);
  std::vector<RevolvedInstance> revolved;
  std::vector<Index> round;
  std::vector<Box> boxes;
  for (Index i = 0; i < instances.size(); ++i) {
    const CurvedForm* const form = instances[i].leaf->form().get();
    if (const auto* of = dynamic_cast<const RevolvedForm*>(form)) {
      if (!in_range_of_doubles(of->axis, instances[i].transform)) continue;
      boxes.push_back(box_of(*of, instances[i].transform));
      revolved.push_back({i, instances[i].transform, boxes.back()});
    } else if (const auto* extrusion = dynamic_cast<const ExtrudeForm*>(form)) {
      if (!in_range_of_doubles(extrusion->shape.vector, instances[i].transform)) continue;
      boxes.push_back(box_of(*extrusion, instances[i].transform));
    } else if (const auto* banded = dynamic_cast<const BandedForm*>(form)) {
      Box box;
      for (const Band& band : banded->bands) box.extend(box_of(band.form, instances[i].transform));
      boxes.push_back(box);
    } else {
      continue;
    }
    round.push_back(i);
  }
  if (round.empty()) return instances;  // so none was replaced
  std::vector<std::array<Index, 2>> pairs;
  const BoxTree tree(boxes);
  for (Index a = 0; a < round.size(); ++a) {
    tree.query([&](const Box& box) { return box.meets(boxes[a]); },
               [&](Index b) {
                 if (b < a) pairs.push_back({round[b], round[a]});
               });
  }
  const std::vector<std::array<Index, 2>> about_one_axis = near_axes(instances, pairs);
  if (near != nullptr) *near = near_surfaces(instances, about_one_axis);
  std::vector<LeafWords> told;
  share_axes(instances, round_spaces(instances, revolved, pairs, about_one_axis, anew, extra), extra, *drawn, told,
             *known);
  restore_axial(stretched, instances);
  if (apart != nullptr) *apart = std::move(told);
  return instances;
}

}  // namespace cnrg
