// The corners of a triangle get their parameters in the cell of its facet, exactly, and are rounded last.
#include "csg/formats/vtu_parameters.h"

#include <algorithm>
#include <limits>

#include "kernel/base/counts.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

using Cells = std::vector<std::vector<PatchCorner>>;

/// A cell whose map serves all the cells; nullptr if no one affine map does.
const std::vector<PatchCorner>* common(const Cells& cells) {
  if (cells.size() == 1) return &cells[0];
  if (cells.empty()) return nullptr;
  const std::vector<PatchCorner>& first = cells[0];
  // Three corners of the first one; the fourth is checked with the others.
  std::vector<PatchCorner> three{first[0], first[1], first[2]};
  if (!is_cell(three)) three = {first[0], first[2], first[3]};
  for (const auto& cell : cells) {
    for (const PatchCorner& corner : cell) {
      if (parameters_in(three, corner.point) != corner.at) return nullptr;
    }
  }
  return &first;
}

}  // namespace

VtuSplit::VtuSplit(const ResultView& view, const FlatComplex& flat, const std::vector<std::array<double, 3>>& xyz)
    : xyz_(xyz), patches_(flat.faces.size(), 0) {
  parameters_.uv.assign(2 * xyz.size(), std::numeric_limits<double>::quiet_NaN());
  std::map<FlatComplex::Patch, std::int32_t> rows;
  for (Index i = 0; i < flat.faces.size(); ++i) {
    const FlatComplex::Face& face = flat.faces[i];
    first_.push_back(triangles_.size());
    triangles_.insert(triangles_.end(), face.triangles.begin(), face.triangles.end());
    std::vector<const std::vector<PatchCorner>*> cells;  // by facet
    for (const Cells& facet : face.cells) cells.push_back(common(facet));
    if (std::find(cells.begin(), cells.end(), nullptr) != cells.end() || cells.empty()) continue;
    const auto [row, fresh] =
        rows.try_emplace(*face.patch, static_cast<std::int32_t>(parameters_.names.size() + 1));
    if (fresh) {
      const auto& [leaf, patch] = *face.patch;
      const bool named = view.leaves != nullptr && leaf.index() < view.leaves->size();
      parameters_.names.push_back((named ? (*view.leaves)[leaf.index()].name + ": " : "") +
                                  view.parameters->patch_name(leaf, patch));
    }
    patches_[i] = row->second;
    for (std::size_t k = 0, facet = 0; k < face.triangles.size(); ++k) {
      while (!face.facet_ends.empty() && k >= face.facet_ends[facet]) ++facet;
      for (Index& p : triangles_[first_[i] + k]) {
        const RationalPoint at = view.complex->points.rational(flat.points[p]);
        p = split(p, row->second, parameters_in(*cells[facet], at));
      }
    }
  }
}

VtuSplit::Index VtuSplit::split(Index point, std::int32_t patch, const Parameters& at) {
  const auto [it, fresh] = number_.try_emplace({point, patch, at}, next_number(xyz_.size(), "points"));
  if (fresh) {
    xyz_.push_back(std::array<double, 3>(xyz_[point]));
    for (const Rational& x : at) parameters_.uv.push_back(to_double(x));
  }
  return it->second;
}

}  // namespace cnrg
