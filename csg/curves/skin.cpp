#include "csg/curves/skin.h"

#include <algorithm>

#include "csg/curves/profile.h"
#include "csg/geometry/planar_polygon.h"
#include "csg/leaves/prepare_shapes.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

/// A straight wall: two segments without curves, their ends in one plane.
bool is_flat(const BezierPatch& patch) {
  if (patch.net.size() != 2 || patch.net[0].size() != 2) return false;
  const RationalPoint a = project(patch.net[0][0]), b = project(patch.net[0][1]), c = project(patch.net[1][1]);
  return volume6(a, b, c, project(patch.net[1][0])) == 0;
}

void run_backward(std::vector<ControlRow>& line) {
  std::reverse(line.begin(), line.end());
  for (ControlRow& row : line) std::reverse(row.begin(), row.end());
}

/// Rows of one wall, of equal degrees.
BezierPatch wall(const std::vector<Section>& rows, std::size_t line, std::size_t segment) {
  BezierPatch patch;
  std::size_t degree = 1;
  for (const Section& section : rows) {
    patch.net.push_back(reduced(section[line][segment]));
    degree = std::max(degree, patch.net.back().size() - 1);
  }
  for (ControlRow& row : patch.net) row = elevated(std::move(row), degree);
  return patch;
}

std::shared_ptr<const NetForm> skin_of(const LoftShape& shape) {
  if (shape.profiles.size() < 2)
    throw LeafKeyError("profiles", "loft: there are fewer than two profiles: give two or more");
  std::vector<Section> sections;
  RationalPoint before{0, 0, 0}, front;
  for (const Profile& profile : shape.profiles) {
    Section& section = sections.emplace_back(section_of(profile, "loft", &front));
    if (dot(before, front) < 0) {
      front = Rational(-1) * front;
      for (auto& line : section) run_backward(line);
    }
    before = front;
  }
  const auto counts = [](const Section& section) {
    std::vector<std::size_t> result;
    for (const auto& line : section) result.push_back(line.size());
    return result;
  };
  Skin skin("loft", shape.tessellation);
  for (std::size_t i = 1; i < sections.size(); ++i) {
    if (counts(sections[i]) != counts(sections[0])) {
      throw LeafKeyError("profiles", "loft: profile " + std::to_string(i + 1) +
                                         " has other numbers of lines or segments than the" +
                                         " first one: give equal ones, with corners on segments where need be");
    }
    skin.add_band({sections[i - 1], sections[i]});
  }
  return skin.finish();
}

}  // namespace

Section section_of(const Profile& profile, const char* shape, RationalPoint* normal) {
  std::vector<SampledLine> lines = sample(
      profile, shape, [](const BezierCurve& curve) { return CurveSteps{curve.degree() == 1 ? 1 : 8}.inside(); });
  const RationalPoint front = check_area(lines, shape);
  if (normal != nullptr) *normal = front;
  Section section;
  for (std::size_t l = 0; l < lines.size(); ++l) {
    auto& line = section.emplace_back();
    for (const CurveNet& net : profile.lines[l].segments) {
      for (BezierCurve& piece : curve_pieces(net, shape)) line.push_back(std::move(piece.net));
    }
    if ((dot(area_vector(lines[l].points), front) > 0) == (l == 0)) continue;
    run_backward(line);
  }
  return section;
}

void Skin::add_band(const std::vector<Section>& rows) {
  if (bands_ == 0) first_ = rows.front();
  last_ = rows.back();
  last_band_ = patch_of_wall_.size();
  const std::string band = "part " + std::to_string(++bands_) + ", segment ";
  std::size_t number = 0;
  for (std::size_t line = 0; line < first_.size(); ++line) {
    for (std::size_t s = 0; s < first_[line].size(); ++s) add_wall(rows, line, s, band + std::to_string(++number));
  }
}

void Skin::add_wall(const std::vector<Section>& rows, std::size_t line, std::size_t segment,
                    const std::string& name) {
  BezierPatch patch = wall(rows, line, segment);
  if (is_flat(patch)) {
    patch_of_wall_.emplace_back();
    NetForm::Flat& flat = walls_.emplace_back();
    flat.name = name;
    auto& loop = flat.loops.emplace_back();
    for (const Homogeneous* corner : {&patch.net[0][0], &patch.net[0][1], &patch.net[1][1], &patch.net[1][0]})
      loop.push_back({project(*corner)});
    return;
  }
  patch_of_wall_.emplace_back(form_->patches.size());
  form_->patches.push_back({name, {{std::move(patch), {{{0, 1}, {0, 1}}}}}});
}

NetForm::Flat Skin::end(const Section& section, std::size_t first_wall, bool last_row) const {
  NetForm::Flat flat;
  flat.name = last_row ? "end" : "start";
  flat.turned = !last_row;
  for (const auto& line : section) {
    auto& loop = flat.loops.emplace_back();
    for (const ControlRow& row : line)
      loop.push_back({project(row.front()), patch_of_wall_[first_wall++], last_row});
  }
  return flat;
}

std::shared_ptr<const NetForm> Skin::finish() {
  form_->flats = walls_;
  form_->flats.push_back(end(first_, 0, false));
  form_->flats.push_back(end(last_, last_band_, true));
  return form_;
}

std::unique_ptr<PreparedLeaf> prepare_skin(std::shared_ptr<const NetForm> skin, LeafParameters* record) {
  std::unique_ptr<PreparedLeaf> leaf = tessellate(*skin, nullptr, record);
  leaf->set_form(std::move(skin));
  return leaf;
}

std::unique_ptr<PreparedLeaf> prepare_leaf(const LoftShape& shape, LeafParameters* record) {
  return prepare_skin(skin_of(shape), record);
}

std::shared_ptr<const LeafSurfaces> true_surfaces(const LoftShape& shape) {
  return skin_surfaces(*skin_of(shape));
}

}  // namespace cnrg
