// Forms under stretches along their axes; see the header.
#include "csg/carriers/axial.h"

#include <set>

#include "csg/carriers/axes.h"
#include "csg/carriers/bands.h"
#include "csg/carriers/round_spaces.h"
#include "csg/curves/surface_placed.h"
#include "csg/geometry/circle.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

/// A leaf in the place where it was put, with the form that it has there.
class AxialLeaf final : public PreparedLeaf {
 public:
  AxialLeaf(LeafInstance from, RevolvedForm form) : from_(std::move(from)) {
    set_form(std::make_shared<const RevolvedForm>(std::move(form)));
    set_surfaces(moved(from_.leaf->surfaces(), from_.transform));
  }
  LeafId add_to(Soup& soup, const Transform& transform) const override {
    return from_.leaf->add_to(soup, transform * from_.transform);
  }
  std::vector<Attributes> regions() const override { return from_.leaf->regions(); }

 private:
  LeafInstance from_;
};

/// The form under the transform, if it is one and has arcs neither before nor after.
std::optional<RevolvedForm> stretched(const RevolvedForm& form, const Transform& transform) {
  const CircleFrame frame(form.axis);
  const RationalPoint along = transform.apply_to_vector(form.axis),
                      first = transform.apply_to_vector(frame.first()),
                      second = transform.apply_to_vector(frame.second());
  const Rational square = dot(first, first) / dot(frame.first(), frame.first());
  if (dot(along, first) != 0 || dot(along, second) != 0 || dot(first, second) != 0 ||
      dot(second, second) != square * dot(frame.second(), frame.second()))
    return std::nullopt;
  const std::optional<Rational> scale = rational_root(square);
  if (!scale) return std::nullopt;
  const CircleFrame there(along);
  const auto agree = [](const RationalPoint& a, const RationalPoint& b) {
    return is_zero(cross(a, b)) && dot(a, b) > 0;
  };
  if (!agree(first, there.first()) || !agree(second, there.second())) return std::nullopt;
  RevolvedForm result = form;
  result.center = transform.apply(form.center);
  result.axis = along;
  for (auto& line : result.lines) {
    for (MeridianPiece& piece : line) {
      if (piece.kind == MeridianPiece::Kind::arc) return std::nullopt;
      piece.from.r *= *scale;
      piece.to.r *= *scale;
      for (Homogeneous& h : piece.net.net) h[0] *= *scale;
    }
  }
  return result;
}

}  // namespace

std::map<std::uint32_t, LeafInstance> replace_axial(std::vector<LeafInstance>& instances) {
  std::map<std::uint32_t, std::pair<Metric, RevolvedForm>> forms;
  std::set<Metric> stay;
  for (std::uint32_t i = 0; i < instances.size(); ++i) {
    const CurvedForm* const form = instances[i].leaf->form().get();
    const auto* revolved = dynamic_cast<const RevolvedForm*>(form);
    if ((revolved == nullptr && dynamic_cast<const BandedForm*>(form) == nullptr) ||
        stretch(instances[i].transform))
      continue;
    std::optional<RevolvedForm> there;
    if (revolved != nullptr) there = stretched(*revolved, instances[i].transform);
    Metric metric = metric_of(instances[i].transform);
    if (there) forms.emplace(i, std::pair(std::move(metric), std::move(*there)));
    else stay.insert(std::move(metric));
  }
  std::map<std::uint32_t, LeafInstance> before;
  for (auto& [i, entry] : forms) {
    auto& [metric, form] = entry;
    if (stay.contains(metric)) continue;
    before.emplace(i, instances[i]);
    instances[i] = {std::make_shared<const AxialLeaf>(instances[i], std::move(form)), {}};
  }
  return before;
}

void restore_axial(const std::map<std::uint32_t, LeafInstance>& before, std::vector<LeafInstance>& instances) {
  for (const auto& [i, instance] : before) {
    if (dynamic_cast<const AxialLeaf*>(instances[i].leaf.get()) != nullptr) instances[i] = instance;
  }
}

}  // namespace cnrg
