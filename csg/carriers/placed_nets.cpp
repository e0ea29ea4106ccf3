// Transforms of homogeneous nets, pieces between cuts, and leaves made of them; see the header.
#include "csg/carriers/placed_nets.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "csg/carriers/surface_numbers.h"
#include "csg/curves/surface_placed.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

/// The image of a homogeneous point, its weight kept.
Homogeneous image(const Transform& t, const Homogeneous& h) {
  Homogeneous result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = t.offset[i] * h[3];
    for (std::size_t j = 0; j < 3; ++j) {
      if (t.linear[i][j] != 0) result[i] += t.linear[i][j] * h[j];
    }
  }
  result[3] = h[3];
  return result;
}

ControlRow image(const Transform& t, ControlRow row) {
  for (Homogeneous& h : row) h = image(t, h);
  return row;
}

BezierPatch image(const Transform& t, BezierPatch patch) {
  for (ControlRow& row : patch.net) row = image(t, std::move(row));
  return patch;
}

RationalPoint moved_vector(const Transform& t, const RationalPoint& v) { return t.apply(v) - t.offset; }

/// Smallest and largest coordinates of points as they come.
class Growing {
 public:
  void add(const RationalPoint& p) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (empty_ || p[k] < extent[k][0]) extent[k][0] = p[k];
      if (empty_ || p[k] > extent[k][1]) extent[k][1] = p[k];
    }
    empty_ = false;
  }
  void add(const ControlRow& row) {
    for (const Homogeneous& h : row) add(project(h));
  }
  PlacedNets::Extent extent;

 private:
  bool empty_ = true;
};

/// Around the image of the box.
PlacedNets::Extent image(const Transform& t, const PlacedNets::Extent& e) {
  Growing result;
  for (std::size_t corner = 0; corner < 8; ++corner)
    result.add(t.apply({e[0][corner & 1], e[1][corner >> 1 & 1], e[2][corner >> 2]}));
  return result.extent;
}

/// A curve in pieces as one B-spline, with knots where the pieces meet.
CurveNet joined(const std::vector<CutCurve>& parts) {
  CurveNet net;
  const std::size_t degree = parts[0].curve.degree();
  net.degree = static_cast<int>(degree);
  net.knots.push_back(parts[0].span[0]);
  for (const CurvePiece& part : parts) {
    net.knots.insert(net.knots.end(), degree, part.span[0]);
    for (std::size_t i = net.points.empty() ? 0 : 1; i <= degree; ++i) {
      net.points.push_back(project(part.curve.net[i]));
      net.weights.push_back(part.curve.net[i][3]);
    }
  }
  net.knots.insert(net.knots.end(), degree + 1, parts.back().span[1]);
  return net;
}

}  // namespace

Sweep::Sweep(const RationalPoint& along) : vector(along), direction(along) { divide_by_first(direction); }

std::size_t Sweep::pivot() const {
  return static_cast<std::size_t>(std::find(direction.begin(), direction.end(), 1) - direction.begin());
}

ControlRow Sweep::projected(ControlRow net) const {
  for (Homogeneous& h : net) {
    const Rational height = h[pivot()];
    for (std::size_t k = 0; k < 3; ++k) h[k] -= height * direction[k];
  }
  return net;
}

std::array<Rational, 2> Sweep::heights(const ControlRow& net) const {
  std::vector<Rational> all;
  for (const Homogeneous& h : net) {
    all.push_back(project(h)[pivot()]);
    all.push_back(all.back() + vector[pivot()]);
  }
  const auto [low, high] = std::minmax_element(all.begin(), all.end());
  return {*low, *high};
}

ControlRow Sweep::far_rim(ControlRow net) const {
  for (Homogeneous& h : net) {
    for (std::size_t k = 0; k < 3; ++k) h[k] += h[3] * vector[k];
  }
  return net;
}

std::optional<Sweep> sweep_of(const BezierPatch& patch) {
  if (patch.degree_v() != 1) return std::nullopt;
  std::optional<RationalPoint> vector;
  for (std::size_t i = 0; i <= patch.degree_u(); ++i) {
    const Homogeneous &a = patch.net[0][i], &b = patch.net[1][i];
    if (a[3] != patch.net[0][0][3] || b[3] != a[3]) return std::nullopt;
    const RationalPoint v = project(b) - project(a);
    if (vector && v != *vector) return std::nullopt;
    vector = v;
  }
  if (is_zero(*vector)) return std::nullopt;
  return Sweep(*vector);
}

std::vector<CutPiece> PlacedPiece::parts(const Cuts& cuts) const {
  std::vector<CutPiece> result;
  const auto &in_u = cuts.of(strand[0]), &in_v = cuts.of(strand[1]);
  if (in_u.size() == 2 && in_v.size() == 2)
    return {{{patch, span}, {cuts.lines(strand[0], 0, 1), cuts.lines(strand[1], 0, 1)}}};
  for (auto v = in_v.begin(); std::next(v) != in_v.end(); ++v) {
    for (auto u = in_u.begin(); std::next(u) != in_u.end(); ++u) {
      const Rational &u0 = *u, &u1 = *std::next(u), &v0 = *v, &v1 = *std::next(v);
      result.push_back(
          {{reduced(part(patch, {u0, u1}, {v0, v1})),
            {{{in_span(span[0], u0), in_span(span[0], u1)}, {in_span(span[1], v0), in_span(span[1], v1)}}}},
           {cuts.lines(strand[0], u0, u1), cuts.lines(strand[1], v0, v1)}});
    }
  }
  return result;
}

std::vector<CutCurve> PlacedCurve::parts(const Cuts& cuts) const {
  std::vector<CutCurve> result;
  const auto& at = cuts.of(strand);
  for (auto t = at.begin(); std::next(t) != at.end(); ++t) {
    const Rational &t0 = *t, &t1 = *std::next(t);
    result.push_back({{{part(net, t0, t1)}, {in_span(span, t0), in_span(span, t1)}}, cuts.lines(strand, t0, t1)});
  }
  return result;
}

bool PlacedNets::has_nets(const LeafInstance& instance) {
  const CurvedForm* const form = instance.leaf->form().get();
  return dynamic_cast<const NetForm*>(form) != nullptr || dynamic_cast<const ExtrudeForm*>(form) != nullptr;
}

PlacedNets::Extent PlacedNets::extent_of(const PreparedLeaf& leaf) {
  Growing result;
  if (const auto* nets = dynamic_cast<const NetForm*>(leaf.form().get())) {
    for (const NetForm::Patch& patch : nets->patches) {
      for (const NetPiece& piece : patch.pieces) {
        for (const ControlRow& row : piece.patch.net) result.add(row);
      }
    }
    for (const NetForm::Curve& curve : nets->curves) {
      for (const CurvePiece& piece : curve.pieces) result.add(piece.curve.net);
    }
  } else if (const auto* extrusion = dynamic_cast<const ExtrudeForm*>(leaf.form().get())) {
    for (const ProfileLine& line : extrusion->shape.profile.lines) {
      for (const CurveNet& net : line.segments) {
        for (const RationalPoint& p : net.points) {
          result.add(p);
          result.add(p + extrusion->shape.vector);
        }
      }
    }
  }
  return result.extent;
}

PlacedNets::PlacedNets(const LeafInstance& instance, const Extent& of_leaf, std::size_t owner)
    : owner(owner),
      extent(image(instance.transform, of_leaf)),
      nets_(std::dynamic_pointer_cast<const NetForm>(instance.leaf->form())),
      extrusion_(std::dynamic_pointer_cast<const ExtrudeForm>(instance.leaf->form())),
      leaf_(instance.leaf),
      transform_(instance.transform) {
  if (extrusion_) sweep_ = Sweep(moved_vector(transform_, extrusion_->shape.vector));
}

void PlacedNets::place() {
  if (nets_) {
    for (std::size_t i = 0; i < nets_->patches.size(); ++i) {
      for (const NetPiece& piece : nets_->patches[i].pieces)
        pieces.push_back({i, reduced(image(transform_, piece.patch)), piece.span});
    }
    for (std::size_t i = 0; i < nets_->curves.size(); ++i) {
      for (const CurvePiece& piece : nets_->curves[i].pieces)
        curves.push_back({i, image(transform_, piece.curve.net), piece.span});
    }
    return;
  }
  std::size_t number = 0;
  for (const ProfileLine& line : extrusion_->shape.profile.lines) {
    for (const CurveNet& net : line.segments) {
      const std::vector<Span> spans = curve_spans(net);
      const std::vector<BezierCurve> given = curve_pieces(net, "extrude");
      for (std::size_t k = 0; k < given.size(); ++k)
        curves.push_back({number, image(transform_, given[k].net), spans[k]});
      ++number;
    }
  }
}

void PlacedNets::add_lines(const ExtraLines& lines, Cuts& cuts) {
  cuts.concern(owner);
  const auto add = [&](const std::vector<Rational>& values, const Span& span, std::size_t strand) {
    each_between(values, span, [&](const Rational& t) { cuts.add_line(strand, t); });
  };
  if (nets_) {
    for (const PlacedPiece& piece : pieces) {
      const auto of = lines.of.find(static_cast<std::uint32_t>(piece.number));
      if (of == lines.of.end()) continue;
      for (std::size_t d = 0; d < 2; ++d) add(of->second[d], piece.span[d], piece.strand[d]);
    }
    return;
  }
  const std::size_t first = extrusion_->shape.profile.closed ? 2 : 0;
  for (const PlacedCurve& curve : curves) {
    const auto of = lines.of.find(static_cast<std::uint32_t>(first + curve.number));
    if (of == lines.of.end()) continue;
    add(of->second[0], curve.span, curve.strand);
    each_between(of->second[1], {0, 1}, [&](const Rational& t) { heights_.insert(t); });
  }
}

std::shared_ptr<const PreparedLeaf> PlacedNets::tessellated(const Cuts& cuts, const FinestPatches& finest,
                                                            std::shared_ptr<const AgreedSteps> steps) const {
  return nets_ ? nets_anew(cuts, finest, std::move(steps)) : extrusion_anew(cuts, std::move(steps));
}

std::shared_ptr<const PreparedLeaf> PlacedNets::nets_anew(const Cuts& cuts, const FinestPatches& finest,
                                                          std::shared_ptr<const AgreedSteps> steps) const {
  auto common = std::make_shared<CommonNets>();
  auto form = std::make_shared<NetForm>(*nets_);  // where the leaf is placed
  common->transform = transform_;
  common->steps = std::move(steps);
  common->patches.resize(nets_->patches.size());
  common->curves.resize(nets_->curves.size());
  for (NetForm::Patch& patch : form->patches) patch.pieces.clear();
  for (NetForm::Curve& curve : form->curves) curve.pieces.clear();
  for (NetForm::Flat& flat : form->flats) {
    for (auto& loop : flat.loops) {
      for (NetForm::Flat::Side& side : loop) side.corner = transform_.apply(side.corner);
    }
  }
  for (const PlacedPiece& piece : pieces) {
    form->patches[piece.number].pieces.push_back({piece.patch, piece.span});
    for (CutPiece& part : piece.parts(cuts)) {
      Fineness fineness = nets_->fineness;
      fineness.join(finest.at(canonical(part.patch).patch.net));
      PatchLines lines = std::move(part.lines);
      common->patches[piece.number].push_back({std::move(part), std::move(fineness), std::move(lines)});
    }
  }
  for (const PlacedCurve& curve : curves) {
    form->curves[curve.number].pieces.push_back({{curve.net}, curve.span});
    for (CutCurve& part : curve.parts(cuts)) common->curves[curve.number].push_back(std::move(part));
  }
  std::shared_ptr<PreparedLeaf> leaf = tessellate(*nets_, common.get(), nullptr);
  leaf->set_form(std::move(form));
  leaf->set_surfaces(moved(leaf_->surfaces(), transform_));
  leaf->set_parameters([given = nets_, common] {
    auto parameters = std::make_shared<LeafParameters>();
    tessellate(*given, common.get(), parameters.get());
    return parameters;
  });
  return leaf;
}

std::shared_ptr<const PreparedLeaf> PlacedNets::extrusion_anew(const Cuts& cuts,
                                                               std::shared_ptr<const AgreedSteps> steps) const {
  auto sweep = std::make_shared<CommonSweep>();
  sweep->shape = extrusion_->shape;
  sweep->shape.vector = sweep_->vector;
  sweep->shape.center.reset();
  sweep->mirrored = transform_.determinant() < 0;
  sweep->steps = std::move(steps);
  sweep->heights = heights_;
  auto curve = curves.begin();
  std::size_t number = 0;
  for (ProfileLine& line : sweep->shape.profile.lines) {
    for (CurveNet& net : line.segments) {
      std::vector<CutCurve> parts;
      for (; curve != curves.end() && curve->number == number; ++curve) {
        for (CutCurve& part : curve->parts(cuts)) parts.push_back(std::move(part));
      }
      net = joined(parts);
      ++number;
    }
  }
  std::shared_ptr<PreparedLeaf> leaf = tessellate(sweep);
  const auto form = std::make_shared<ExtrudeForm>(sweep->shape);
  form->mirrored = sweep->mirrored;
  form->steps = sweep->steps;
  form->heights = sweep->heights;
  leaf->set_form(form);
  leaf->set_surfaces(moved(leaf_->surfaces(), transform_));
  return leaf;
}

}  // namespace cnrg
