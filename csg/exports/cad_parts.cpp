// Patches to surfaces, corners to their parameters; see the header.
#include "csg/exports/cad_parts.h"

#include <cmath>

#include "csg/leaves/surface_parameters.h"
#include "csg/operators/node_value.h"
#include "csg/result/rounding.h"
#include "csg/result/solid.h"
#include "kernel/base/parallel.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/refine/box.h"

namespace cnrg {
namespace {

using Index = FlatComplex::Index;

class Collector {
 public:
  Collector(const ResultView& view, const std::string& format) : view_(view) {
    parts_.flat = flatten(view);
    require_closed_and_bounded(parts_.flat, format);
    parts_.points = round_points(view, parts_.flat).xyz;
    parts_.name = view.node;
  }

  CadParts run() {
    measure();
    find_numbers();
    for (const FlatComplex::Face& face : parts_.flat.faces) choose_surface(face);
    for_each_index(parts_.faces.size(), [&](std::size_t i) { add_facets(parts_.flat.faces[i], parts_.faces[i]); });
    for (const FlatComplex::Edge& edge : parts_.flat.edges) add_edge(edge);
    add_components();
    add_said(0, parts_.flat.vertices), add_said(1, parts_.flat.edges), add_said(2, parts_.flat.faces);
    return std::move(parts_);
  }

 private:
  const ResultView& view_;
  CadParts parts_;
  std::map<FlatComplex::Patch, std::optional<Index>> surface_of_, curve_of_;
  std::map<std::uint32_t, Index> surface_of_number_;  // by Soup::Face::surface
  std::map<FlatComplex::Patch, std::uint32_t> number_of_;
  std::vector<FlatComplex::Patch> patch_of_;  // whose form each surface has
  std::map<cnrg::Attributes, Index, AttributesOrder> said_;

  void measure() {
    Box box;
    for (const CadPoint& p : parts_.points) box.extend(p, p);
    const auto& [low, high] = box;
    if (!parts_.points.empty()) parts_.size = std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  }

  std::string leaf_name(LeafId leaf) const {
    return leaf.index() < view_.leaves->size() ? (*view_.leaves)[leaf.index()].name : "";
  }

  static bool is_elementary(const CadSurface& surface) {
    using Kind = CadSurface::Kind;
    return surface.kind == Kind::cylinder || surface.kind == Kind::cone || surface.kind == Kind::sphere ||
           surface.kind == Kind::torus;
  }

  void find_numbers() {
    if (view_.complex->surface_count == 0) return;
    for (const Soup::Face& source : view_.complex->sources) {
      if (source.surface != 0) number_of_[{source.leaf, source.patch}] = source.surface;
    }
  }

  std::optional<Index> surface(const FlatComplex::Patch& patch) {
    const auto [it, fresh] = surface_of_.try_emplace(patch);
    if (!fresh || view_.parameters == nullptr) return it->second;
    const auto surfaces = view_.parameters->surfaces(patch.first);
    if (surfaces == nullptr) return it->second;
    const auto form = surfaces->forms().find(patch.second);
    if (form == surfaces->forms().end()) return it->second;
    // Patches of one surface have one form, where that finds the parameters of points by formula.
    const auto number = number_of_.find(patch);
    if (number != number_of_.end() && is_elementary(form->second.surface)) {
      const auto [known, first] = surface_of_number_.try_emplace(number->second, Index(parts_.surfaces.size()));
      if (!first) return it->second = known->second;
    }
    it->second = Index(parts_.surfaces.size());
    patch_of_.push_back(patch);
    parts_.surfaces.push_back(form->second);
    parts_.surfaces.back().placed = view_.parameters->transform(patch.first) * form->second.placed;
    parts_.surface_names.push_back("`" + view_.parameters->patch_name(patch.first, patch.second) + "` of `" +
                                   leaf_name(patch.first) + "`");
    return it->second;
  }

  std::optional<Index> curve(const FlatComplex::Patch& number) {
    const auto [it, fresh] = curve_of_.try_emplace(number);
    if (!fresh || view_.parameters == nullptr) return it->second;
    const auto surfaces = view_.parameters->surfaces(number.first);
    if (surfaces == nullptr) return it->second;
    const auto form = surfaces->curve_forms().find(number.second);
    if (form == surfaces->curve_forms().end()) return it->second;
    it->second = Index(parts_.curves.size());
    parts_.curves.push_back(form->second);
    parts_.curves.back().placed = view_.parameters->transform(number.first) * form->second.placed;
    return it->second;
  }

  void choose_surface(const FlatComplex::Face& face) {
    CadParts::Face& of = parts_.faces.emplace_back();
    of.flat = face.facets.empty();
    if (face.patch) of.surface = surface(*face.patch);
    for (const auto& [patch, cell] : face.cells_of_patches) {
      if (!of.surface) of.surface = surface(patch);
    }
    if (of.surface && of.flat && parts_.surfaces[*of.surface].surface.kind == CadSurface::Kind::plane)
      of.surface.reset();
    if (of.surface || of.flat) return;
    if (view_.parameters == nullptr)
      of.why = "the result knows nothing of its true surfaces, since it was snapped";
    else if (face.patch) of.why = "`" + leaf_name(face.patch->first) + "` names no surface for it";
    else of.why = "no one surface covers it";
  }

  void add_facets(const FlatComplex::Face& face, CadParts::Face& of) const {
    if (of.flat) of.facets.push_back({face.loops, plane_of(face, 0, face.triangles.size()), {}});
    std::size_t begin = 0;
    for (std::size_t i = 0; i < face.facets.size(); ++i) {
      of.facets.push_back({face.facets[i].loops, plane_of(face, begin, face.facet_ends[i]), {}});
      begin = face.facet_ends[i];
    }
    if (!of.surface) return;
    const SurfaceForm& form = parts_.surfaces[*of.surface];
    if (is_elementary(form.surface) && form.placed.identity()) return;
    const FlatComplex::Patch& patch = patch_of_[*of.surface];
    std::vector<std::vector<PatchCorner>> all;
    for (const auto& [of_patch, cell] : face.cells_of_patches) {
      if (of_patch == patch) all.push_back(cell);
    }
    const bool own = face.patch && *face.patch == patch;
    for (std::size_t i = 0; i < of.facets.size(); ++i) {
      for (const FlatComplex::Loop& loop : of.facets[i].loops) {
        for (const Index p : loop) {
          if (own && i < face.cells.size()) find_near(face.cells[i], p, form, of.facets[i].near);
          else find_near(all, p, form, of.facets[i].near);
        }
      }
    }
  }

  CadParts::Plane plane_of(const FlatComplex::Face& face, std::size_t begin, std::size_t end) const {
    CadParts::Plane plane;
    double most = -1;
    for (std::size_t t = begin; t < end; ++t) {
      const auto& [a, b, c] = face.triangles[t];
      const CadPoint &p = parts_.points[a], &q = parts_.points[b], &r = parts_.points[c];
      CadPoint n;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
        n[k] = (q[i] - p[i]) * (r[j] - p[j]) - (q[j] - p[j]) * (r[i] - p[i]);
      }
      const double length = std::hypot(n[0], n[1], n[2]);
      if (length <= most) continue;
      most = length;
      plane = {p, {n[0] / length, n[1] / length, n[2] / length}};
    }
    return plane;
  }

  void find_near(const std::vector<std::vector<PatchCorner>>& cells, Index p, const SurfaceForm& form,
                 std::map<Index, CadParameters>& near) const {
    const RationalPoint point = view_.complex->points.rational(parts_.flat.points[p]);
    for (const auto& cell : cells) {
      if (volume6(cell[0].point, cell[1].point, cell[2].point, point) != 0 || !holds(cell, point)) continue;
      const Parameters at = parameters_in(cell, point);
      CadParameters found{to_double(at[0]), to_double(at[1])};
      if (form.swapped) std::swap(found[0], found[1]);
      for (std::size_t d = 0; d < 2; ++d) found[d] = form.zero[d] + found[d] * (form.one[d] - form.zero[d]);
      near[p] = found;
      return;
    }
  }

  void add_edge(const FlatComplex::Edge& edge) {
    CadParts::Edge& of = parts_.edges.emplace_back();
    for (const FlatComplex::Patch& patch : edge.patches) {
      const std::optional<Index> found = surface(patch);
      if (found && parts_.surfaces[*found].surface.kind != CadSurface::Kind::plane) of.surfaces.push_back(*found);
    }
    if (!edge.curve) return;
    of.curve = curve(*edge.curve);
    if (!of.curve) return;
    for (const Index p : edge.points) {
      const VertexId v = parts_.flat.points[p];
      const LeafId leaf = edge.curve->first;
      std::optional<double> at;
      for (const CurvePoint& found : view_.parameters->on_curves(
               Location{0, v, {}, {}, {}}, view_.complex->points.rational(v), std::span(&leaf, 1))) {
        if (found.curve != edge.curve->second) continue;
        const double t = to_double(found.at);
        // Where a curve closes, its point is at both ends: the one that is nearer to what came before.
        if (!at || (!of.at.empty() && std::abs(t - of.at.back()) < std::abs(*at - of.at.back()))) at = t;
      }
      if (!at) {
        of.curve.reset();
        return;
      }
      of.at.push_back(*at);
    }
  }

  void add_components() {
    const std::size_t n = view_.value->component_count();
    const bool group = view_.of_group || view_.value->is_group();
    parts_.leaves = *view_.leaves;
    for (Component i = 1; i <= n; ++i) parts_.components.push_back(in_words(attributes_of(view_, i)));
    parts_.called_as_leaves.assign(n, 0);
    for (const auto& region : parts_.flat.regions) {
      if (region.component != 0) parts_.called_as_leaves[region.component - 1] = 1;
    }
    if (group && n > 0 && view_.value->attributes(Component(n)).name.is_of_entities())
      parts_.called_as_leaves[n - 1] = 1;
  }

  template <class Words>
  CadParts::Attributes in_words(const Words& attributes) const {
    CadParts::Attributes of{attributes.name, attributes.material.name(), ""};
    for (const ResultView::Material& material : view_.materials) {
      if (!of.material.empty() && material.name == of.material) of.color = material.color;
    }
    return of;
  }

  template <class Cells>
  void add_said(std::size_t dimension, const Cells& cells) {
    for (const auto& cell : cells) {
      Index& at = parts_.said_of[dimension].emplace_back(FlatComplex::kNone);
      if (cell.component == 0 || cell.origin.said == nullptr) continue;
      const auto [known, fresh] = said_.try_emplace(*cell.origin.said, Index(parts_.said.size()));
      if (fresh) parts_.said.push_back(in_words(*cell.origin.said));
      at = known->second;
    }
  }
};

}  // namespace

CadParts cad_parts(const ResultView& view, const std::string& format) { return Collector(view, format).run(); }

}  // namespace cnrg
