// The plug-in's part.
//
// A face that fails is taken as its facets, and all is made once more: its neighbours then meet flat faces, and
// may fail in their turn.
#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>
#include <algorithm>
#include <cmath>
#include <new>

#include "csg/exports/cad_text.h"
#include "csg/exports/occt_model.h"
#include "csg/exports/occt_write.h"
#include "csg/text/plugin.h"
#include "csg/text/table.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

/// Of splines, by the size of the model.
constexpr double kTolerance = 1e-7;

/// To two digits, upward.
double rounded_up(double x) {
  if (!(x > 0)) return 0;
  const double unit = std::pow(10, std::floor(std::log10(x)) - 1);
  return std::ceil(x / unit) * unit;
}

std::string short_number(double x) { return decimal(rounded_up(x), "%.2g"); }

class Maker {
 public:
  Maker(const CadParts& parts, CadFormat format) : parts_(parts), format_(format) {}

  CadText run() {
    for (CadParts::Index f = 0; f < parts_.faces.size(); ++f) {
      const CadParts::Face& face = parts_.faces[f];
      if (!face.surface && !face.flat) faceted_[f] = face.why;
    }
    const double tolerance = kTolerance * parts_.size;
    occt::CadModelMade made;
    for (bool again = true; again;) {
      occt::Faceted failed;
      made = occt::make_model(parts_, faceted_, tolerance, failed);
      again = !failed.empty();
      const std::size_t before = faceted_.size();
      faceted_.insert(failed.begin(), failed.end());
      require(!again || faceted_.size() > before, "exports: a face fails that is taken as its facets");
    }
    CadText result;
    result.text = format_ == CadFormat::step ? occt::step_text(parts_, made) : occt::brep_text(made);
    say_how_near(made, tolerance, result.notices);
    say_faceted(result.notices);
    return result;
  }

 private:
  const CadParts& parts_;
  const CadFormat format_;
  occt::Faceted faceted_;

  void say_how_near(const occt::CadModelMade& made, double tolerance, std::vector<std::string>& notices) const {
    std::size_t curved = 0;
    for (CadParts::Index f = 0; f < parts_.faces.size(); ++f)
      curved += parts_.faces[f].surface && faceted_.count(f) == 0;
    if (curved == 0) return;
    std::string words = counted(curved, "face is on its true surface", "faces are on their true surfaces");
    words += "; " + counted(made.moved, "vertex was moved there", "vertices were moved there");
    if (made.moved > 0) words += ", by " + short_number(made.farthest) + " at most";
    words += "; edges are within " + short_number(std::max(made.off_surface, made.off_curve)) + " of the surfaces";
    if (made.splines > 0) {
      words += ", " + counted(made.splines, "is a spline", "are splines") + " (tolerance " +
               short_number(tolerance) + ")";
    }
    notices.push_back(std::move(words));
  }

  void say_faceted(std::vector<std::string>& notices) const {
    constexpr std::size_t kMost = 5;
    std::size_t said = 0;
    for (const auto& [f, why] : faceted_) {
      if (++said > kMost) {
        notices.push_back("so are " + counted(faceted_.size() - kMost, "other face", "other faces"));
        return;
      }
      const CadParts::Face& face = parts_.faces[f];
      notices.push_back("face f" + std::to_string(f) +
                        (face.surface ? ", " + parts_.surface_names[*face.surface] : "") + ", is written as its " +
                        counted(face.facets.size(), "flat facet", "flat facets") + ": " + why);
    }
  }
};

}  // namespace
}  // namespace cnrg

CNRG_PLUGIN_EXPORT void cnrg_cad_text(const cnrg::CadParts& parts, cnrg::CadFormat format, cnrg::CadText& text) {
  try {
    text = cnrg::Maker(parts, format).run();
  } catch (const Standard_OutOfMemory&) {
    throw std::bad_alloc();
  } catch (const Standard_Failure& failure) {
    const std::string words = failure.GetMessageString() != nullptr ? failure.GetMessageString() : "";
    throw cnrg::InputError(std::string("OpenCASCADE fails with ") + failure.DynamicType()->Name() +
                           (words.empty() ? "" : ", " + words));
  }
}
