// Leaves as parts with an axis, radii and places, and back.
#include "csg/weld/weld_surfaces.h"

#include <algorithm>
#include <set>

#include "csg/carriers/bands.h"
#include "csg/geometry/circle.h"
#include "csg/leaves/prepare_shapes.h"
#include "csg/text/table.h"
#include "csg/weld/planes.h"
#include "csg/weld/round_carriers.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

using Index = std::uint32_t;
using Kind = MeridianPiece::Kind;

/// A leaf as it was drawn, with the form of another surface.
class OnAgreedSurface final : public PreparedLeaf {
 public:
  OnAgreedSurface(std::shared_ptr<const PreparedLeaf> leaf, std::shared_ptr<const CurvedForm> form)
      : leaf_(std::move(leaf)) {
    set_parameters(leaf_->parameters());
    set_surfaces(surfaces_of(std::dynamic_pointer_cast<const RevolvedForm>(form), leaf_->surfaces()));
    set_form(std::move(form));
  }
  LeafId add_to(Soup& soup, const Transform& transform) const override { return leaf_->add_to(soup, transform); }
  std::vector<Attributes> regions() const override { return leaf_->regions(); }
  std::vector<std::string> notices() const override { return leaf_->notices(); }

  /// Whether the leaf's surface is made of its form: its angles are then counted from where the new axis has them.
  static bool is_remade(const RevolvedForm& form) { return form.turn_is_u; }

 private:
  static SurfaceSource surfaces_of(const std::shared_ptr<const RevolvedForm>& form, const SurfaceSource& before) {
    if (form == nullptr || !is_remade(*form)) return before;
    return [form]() -> std::shared_ptr<const LeafSurfaces> {
      const MeridianPiece& piece = form->lines[0][0];
      const RationalPoint from = form->center + piece.from.t * form->axis,
                          to = form->center + piece.to.t * form->axis;
      if (piece.kind == Kind::line)
        return true_surfaces(ConeShape{from, to, piece.from.r, piece.to.r, form->segments});
      const RationalPoint middle = form->center + piece.middle.t * form->axis;
      if (piece.middle.r == 0) return sphere_surfaces(middle, piece.radius, form->axis);
      return true_surfaces(
          TorusShape{middle, form->axis, piece.middle.r, piece.radius, form->segments, piece.steps});
    };
  }

  std::shared_ptr<const PreparedLeaf> leaf_;
};

/// A banded leaf, its bands on other surfaces.
class AgreedBands final : public BandedForm {
 public:
  AgreedBands(std::shared_ptr<const BandedForm> form, double moved) : form_(std::move(form)) {
    bands = form_->bands;
    obstacle = form_->obstacle;
    slack = form_->slack + moved;
  }
  Drawn draw(const std::vector<BandGrid>& grids, double by) const override { return form_->draw(grids, by); }

 private:
  std::shared_ptr<const BandedForm> form_;
};

bool is_arc(const RevolvedForm& form) {
  return form.lines.size() == 1 && form.lines[0].size() == 1 && form.lines[0][0].kind == Kind::arc &&
         form.lines[0][0].sweep == 360;
}
bool is_straight(const RevolvedForm& form) {
  return std::all_of(form.lines.begin(), form.lines.end(), [](const auto& line) {
    return std::all_of(line.begin(), line.end(), [](const MeridianPiece& p) { return p.kind == Kind::line; });
  });
}

class SurfaceWelder {
 public:
  SurfaceWelder(const std::vector<LeafInstance>& instances, const Rational& d) : instances_(instances), d_(d) {}

  WeldedSurfaces run() {
    for (Index i = 0; i < instances_.size(); ++i) take(i);
    const welding::RoundWeld made = welding::weld_round(parts_, d_);
    WeldedSurfaces result{instances_, {}, 0, {}};
    std::vector<std::array<Index, 2>> left = made.left;
    std::size_t moved = 0;
    for (Index k = 0; k < parts_.size();) {
      // The bands of a leaf go together or not at all: they have circles in common.
      std::vector<std::shared_ptr<const RevolvedForm>> forms;
      const Index first = k, i = of_[k].instance;
      Rational most = 0;
      for (; k < parts_.size() && of_[k].instance == i; ++k) {
        forms.push_back(form_on(k, made.parts[k]));
        if (forms.back() != nullptr)
          most = std::max(most, Rational(made.parts[k].moved + turned_by(k, *forms.back())));
      }
      if (std::all_of(forms.begin(), forms.end(), [](const auto& form) { return form == nullptr; })) continue;
      if (most > d_) {
        left.push_back({first, first});
        continue;
      }
      if (const auto banded = std::dynamic_pointer_cast<const BandedForm>(instances_[i].leaf->form())) {
        result.instances[i].leaf = std::make_shared<const OnAgreedSurface>(
            instances_[i].leaf, on_forms(banded, forms, welding::rounded_up(most)));
      } else {
        result.instances[i].leaf = std::make_shared<const OnAgreedSurface>(instances_[i].leaf, forms[0]);
        result.anew.push_back(i);
      }
      result.farthest = std::max(result.farthest, most);
      ++moved;
    }
    result.notice = notice(moved, result.farthest, left);
    return result;
  }

 private:
  struct Part {
    Index instance = 0;
    std::shared_ptr<const RevolvedForm> form;
    Rational scale;
    PlacedForm placed;
    bool band = false;
  };

  void take(Index i) {
    const std::optional<Rational> scale = stretch(instances_[i].transform);
    if (!scale) return;
    if (const auto form = std::dynamic_pointer_cast<const RevolvedForm>(instances_[i].leaf->form()))
      add({i, form, *scale, place(*form, instances_[i].transform, *scale), false}, form->is_sphere());
    const auto banded = std::dynamic_pointer_cast<const BandedForm>(instances_[i].leaf->form());
    if (banded == nullptr) return;
    // A part of a ball that has its axis in common with other bands goes where that goes.
    std::vector<Part> bands;
    std::set<AxisLine> axes;
    for (const Band& band : banded->bands) {
      const std::shared_ptr<const RevolvedForm> form(banded, &band.form);
      bands.push_back({i, form, *scale, place(*form, instances_[i].transform, *scale), true});
      if (!is_round(*form)) axes.insert(bands.back().placed.axis);
    }
    for (Part& band : bands) {
      const bool ball = is_round(*band.form) && !axes.contains(band.placed.axis);
      add(std::move(band), ball);
    }
  }
  static bool is_round(const RevolvedForm& band) {
    return band.lines[0][0].kind == Kind::arc && band.lines[0][0].middle.r == 0;
  }

  void add(Part of, bool ball) {
    welding::RoundPart part;
    part.axis = of.placed.axis;
    if (ball) {
      const MeridianPiece& piece = of.placed.lines[0][0];
      part.ball = true;
      part.center = part.axis.foot + piece.middle.t * part.axis.direction;
      part.reach = piece.radius;
      part.radii = {piece.radius};
    } else {
      measure(of, part);
    }
    parts_.push_back(std::move(part));
    of_.push_back(std::move(of));
  }

  static void measure(const Part& of, welding::RoundPart& part) {
    const Rational unit = welding::root_above(1 / of.placed.square());
    bool first = true;
    const auto add = [&](const Rational& r, const Rational& low, const Rational& high) {
      part.reach = std::max(part.reach, r);
      part.ends = first ? std::array<Rational, 2>{low, high}
                        : std::array<Rational, 2>{std::min(part.ends[0], low), std::max(part.ends[1], high)};
      first = false;
    };
    const bool straight = !of.band && is_straight(*of.form);
    for (const auto& line : of.placed.lines) {
      for (const MeridianPiece& piece : line) {
        for (const MeridianPoint& p : {piece.from, piece.to}) {
          add(p.r, p.t, p.t);
          if (p.r != 0 && (straight || of.band)) part.radii.push_back(p.r);
          if (straight) part.places.push_back(p.t);
        }
        for (const Homogeneous& h : piece.net.net) add(h[0] / h[3], h[2] / h[3], h[2] / h[3]);
        if (piece.kind != Kind::arc) continue;
        const Rational along = piece.radius * unit;
        add(piece.middle.r + piece.radius, piece.middle.t - along, piece.middle.t + along);
      }
    }
    const MeridianPiece& circle = of.placed.lines[0][0];
    if (circle.kind != Kind::arc || (!of.band && !is_arc(*of.form))) return;
    if (!of.band) part.radii.clear();
    if (circle.middle.r != 0) part.radii.push_back(circle.middle.r);
    part.radii.push_back(circle.radius);
    part.places = {circle.middle.t};
  }

  // --- and back

  /// The form on what was agreed; null if that is where it is.
  std::shared_ptr<const RevolvedForm> form_on(Index k, const welding::RoundPlace& to) const {
    const Part& of = of_[k];
    const welding::RoundPart& part = parts_[k];
    const auto stays = [](const auto& map) {
      return std::all_of(map.begin(), map.end(), [](const auto& entry) { return entry.first == entry.second; });
    };
    const Transform& transform = instances_[of.instance].transform;
    const Transform back = transform.inverse();
    if (part.ball) {
      if (to.center == part.center && stays(to.radii)) return nullptr;
      const Rational radius = to.radii.at(part.radii[0]) / of.scale;
      if (of.band) {
        auto form = std::make_shared<RevolvedForm>(*of.form);
        form->center = form->center + back.apply_to_vector(to.center - part.center);
        form->lines[0][0].radius = radius;
        return form;
      }
      return std::make_shared<const RevolvedForm>(
          sphere_about({back.apply(to.center), radius}, of.form->axis, *of.form));
    }
    // Places are compared on the new axis, which may be the old one: what is there already has not moved.
    const auto on_new = [&](const Rational& t) {
      return to.axis.place_of(part.axis.foot + t * part.axis.direction);
    };
    if (to.axis == part.axis && stays(to.radii) && stays(to.places)) return nullptr;
    auto form = std::make_shared<RevolvedForm>(*of.form);
    const RationalPoint center = transform.apply(form->center), along = transform.apply_to_vector(form->axis);
    const RationalPoint& direction = to.axis.direction;
    const Rational first = to.axis.place_of(center), step = dot(along, direction) / dot(direction, direction);
    form->center = back.apply(to.axis.foot + first * direction);
    form->axis = back.apply_to_vector(step * direction);
    const auto radius = [&](const Rational& r) {
      const auto it = to.radii.find(of.scale * r);
      return it == to.radii.end() ? r : Rational(it->second / of.scale);
    };
    const auto place = [&](Rational& t, const Rational& was) {
      if (const auto it = to.places.find(was); it != to.places.end()) t += (it->second - on_new(was)) / step;
    };
    for (std::size_t l = 0; l < form->lines.size(); ++l) {
      for (std::size_t m = 0; m < form->lines[l].size(); ++m) {
        MeridianPiece& piece = form->lines[l][m];
        const MeridianPiece& was = of.placed.lines[l][m];
        if (of.band && piece.kind == Kind::arc) {
          piece.from.r = radius(piece.from.r);
          piece.to.r = radius(piece.to.r);
          piece.middle.r = radius(piece.middle.r);
          piece.radius = radius(piece.radius);
          place(piece.middle.t, was.middle.t);
        } else if (piece.kind == Kind::line) {
          piece.from.r = radius(piece.from.r);
          piece.to.r = radius(piece.to.r);
          place(piece.from.t, was.from.t);
          place(piece.to.t, was.to.t);
          if (piece.from == piece.to) refuse(of.instance, piece.patch);
        } else if (is_arc(*of.form)) {
          piece.middle.r = radius(piece.middle.r);
          piece.radius = radius(piece.radius);
          place(piece.middle.t, was.middle.t);
          if (piece.middle.r <= piece.radius) refuse(of.instance, piece.patch);
          piece.from = piece.to = moved_end(*of.form, piece);
        }
      }
    }
    return form;
  }

  /// The end of a whole circle that begins at the angle at which it did.
  static MeridianPoint moved_end(const RevolvedForm& was, const MeridianPiece& now) {
    const MeridianPiece& before = was.lines[0][0];
    const Rational grown = now.radius / before.radius;
    return {now.middle.r + grown * (before.from.r - before.middle.r),
            now.middle.t + grown * (before.from.t - before.middle.t)};
  }

  /// The bands of a leaf on other surfaces; null: it stays.
  static std::shared_ptr<const BandedForm> on_forms(const std::shared_ptr<const BandedForm>& leaf,
                                                    const std::vector<std::shared_ptr<const RevolvedForm>>& forms,
                                                    double moved) {
    auto made = std::make_shared<AgreedBands>(leaf, moved);
    for (std::size_t b = 0; b < forms.size(); ++b) {
      if (forms[b] == nullptr) continue;
      Band& band = made->bands[b];
      band.form = *forms[b];
      const RationalPoint& axis = band.form.axis;
      const auto level = [&](RationalPoint& p) { p = p - Rational(dot(p, axis) / dot(axis, axis)) * axis; };
      level(band.start);
      level(band.end);
      for (RationalPoint& p : band.marks) level(p);
    }
    return made;
  }

  [[noreturn]] void refuse(Index i, Index face) const {
    refuse_weld("", LeafWords(LeafPlace{i, {face}}) + " would vanish", d_);
  }

  /// How far points go because angles about the new axis are counted from elsewhere: for a whole turn that is no
  /// other surface, but a partial one ends elsewhere, and surfaces that stay have to have the same angles.
  Rational turned_by(Index k, const RevolvedForm& form) const {
    const RevolvedForm& was = *of_[k].form;
    if (of_[k].band || form.axis == was.axis || form.is_sphere()) return 0;
    if (was.around() && OnAgreedSurface::is_remade(was)) return 0;
    const CircleFrame before(was.axis), after(form.axis);
    Rational most = 0;
    for (const int degrees : {0, 90}) {
      const RationalPoint by = after.offset(1, degrees) - before.offset(1, degrees);
      most += welding::root_above(dot(by, by));
    }
    return parts_[k].reach * most;
  }

  LeafWords notice(std::size_t moved, const Rational& farthest,
                   const std::vector<std::array<Index, 2>>& left) const {
    std::string words;
    LeafWords example;
    if (moved > 0) {
      words = "round surfaces of " + counted(moved, "leaf", "leaves") + " joined with others, moved by " +
              decimal(std::min(welding::rounded_up(farthest), to_double(d_)), "%.3g") + " at most";
    }
    if (!left.empty()) {
      const auto name = [&](Index k) { return LeafWords(LeafPlace{of_[k].instance}); };
      const auto& [a, b] = left[0];
      words += (words.empty() ? "" : "; ") +
               counted(left.size(), "pair of round surfaces is", "pairs of round surfaces are") +
               " near but not joined, since all that is joined has to lie within the length, such as ";
      example = a == b ? name(a) : name(a) + " and " + name(b);
    }
    if (words.empty()) return {};
    return LeafWords("weld " + to_decimal(d_, 6) + ": " + words) + example;
  }

  const std::vector<LeafInstance>& instances_;
  const Rational& d_;
  std::vector<welding::RoundPart> parts_;
  std::vector<Part> of_;
};

}  // namespace

WeldedSurfaces weld_surfaces(const std::vector<LeafInstance>& instances, const Rational& d) {
  return SurfaceWelder(instances, d).run();
}

}  // namespace cnrg
