// A result in doubles, for meshers: equal to the exact result but for the last digits of its points.
#pragma once

#include <memory>
#include <string>

#include "csg/result/rounding.h"

namespace cnrg {

/// Throws the RoundingFault that `what` of rounding is wrong for a format.
[[noreturn]] void refuse_rounding(const std::string& format, const std::string& what);

class RoundedResult {
 public:
  /// Rounds a closed and bounded result. Throws RoundingFault, naming `format`, unless it is embedded and each
  /// region, wire and point still lies where it does in the exact result: the rounded drawing is refined exactly,
  /// and its regions are compared with those of the result, side of a face by side of a face. Throws Stopped.
  RoundedResult(const ResultView& view, const FlatComplex& flat, const std::string& format,
                const std::stop_token& stop = {});
  ~RoundedResult();

  const RoundedPoints& points() const { return points_; }
  RoundingReport report() const { return {points_.moved, true}; }

  /// A point of doubles in the open interior of a bounded region and off its wires and points, well away from its
  /// boundary where there is room: half-way across the region. It is proven to lie there in the rounded result.
  /// Throws InputError for a region too thin to hold one that we find.
  std::array<double, 3> seed(FlatComplex::Index region) const;

 private:
  struct Data;
  const FlatComplex& flat_;
  const std::string format_;
  RoundedPoints points_;
  std::unique_ptr<Data> data_;

  [[noreturn]] void fail(const std::string& what) const;
  void match_regions();
  void match_wires_and_points() const;
};

}  // namespace cnrg
