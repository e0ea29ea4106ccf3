#include "csg/carriers/sharing.h"

#include <cmath>
#include <optional>

#include "csg/carriers/axes.h"
#include "csg/carriers/bands.h"
#include "csg/carriers/boxes.h"
#include "csg/carriers/tangency.h"
#include "csg/curves/extrude.h"
#include "csg/curves/parametric.h"
#include "csg/curves/revolved.h"
#include "kernel/base/union_find.h"
#include "kernel/refine/box_tree.h"

namespace cnrg {
namespace {

/// Around all surfaces of a leaf whose form shares with what it meets; nothing for others, and beyond doubles.
std::optional<Box> box_around(const PreparedLeaf& leaf, const Transform& transform) {
  const CurvedForm& form = *leaf.form();
  if (!squared_stretch(transform))
    return std::nullopt;  // what is stretched alike is compared in one stretched space
  Box box;
  if (const auto* revolved = dynamic_cast<const RevolvedForm*>(&form)) {
    box = box_of(*revolved, transform);
  } else if (const auto* extrusion = dynamic_cast<const ExtrudeForm*>(&form)) {
    box = box_of(*extrusion, transform);
  } else if (const auto* banded = dynamic_cast<const BandedForm*>(&form);
             banded != nullptr && banded->slack == 0) {
    for (const Band& band : banded->bands) box.extend(box_of(band.form, transform));
  } else {
    return std::nullopt;
  }
  if (const auto* geometry = dynamic_cast<const GeometryLeaf*>(&leaf)) box.extend(leaf_box(*geometry, transform));
  for (std::size_t k = 0; k < 3; ++k) {
    if (!std::isfinite(box.lo[k]) || !std::isfinite(box.hi[k])) return std::nullopt;
  }
  return box;
}

}  // namespace

std::vector<std::uint32_t> sharing_groups(const std::vector<LeafInstance>& instances) {
  UnionFind groups(instances.size());
  std::vector<Box> boxes;
  std::vector<std::uint32_t> boxed, others, flat;  // curved leaves with and without a box; those without curves
  bool touchable = false;                          // some of the others may be of revolution
  for (std::uint32_t i = 0; i < instances.size(); ++i) {
    const CurvedForm* const form = instances[i].leaf->form().get();
    if (form == nullptr) {
      flat.push_back(i);
    } else if (const std::optional<Box> box = box_around(*instances[i].leaf, *instances[i].transform)) {
      boxes.push_back(*box);
      boxed.push_back(i);
    } else {
      others.push_back(i);
      touchable = touchable || dynamic_cast<const NetForm*>(form) == nullptr;
    }
  }
  const BoxTree tree(boxes);
  for (std::uint32_t a = 0; a < boxes.size(); ++a) {
    if (!others.empty()) groups.unite(others.front(), boxed[a]);
    else
      tree.query([&](const Box& box) { return box.meets(boxes[a]); },
                 [&](std::uint32_t b) { groups.unite(boxed[a], boxed[b]); });
  }
  for (const std::uint32_t i : others) groups.unite(others.front(), i);
  for (const std::uint32_t i : flat) {
    if (boxes.empty() && !touchable) break;
    if (touchable) groups.unite(others.front(), i);
    const auto* const geometry = dynamic_cast<const GeometryLeaf*>(instances[i].leaf.get());
    const Box reach = geometry != nullptr ? leaf_box(*geometry, *instances[i].transform) : Box();
    tree.query([&](const Box& box) { return geometry == nullptr || box.meets(reach); },
               [&](std::uint32_t b) { groups.unite(i, boxed[b]); });
  }
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < instances.size(); ++i) numbers.push_back(groups.find(i));
  return numbers;
}

}  // namespace cnrg
