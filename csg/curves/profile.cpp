// Sampling of profiles; see the header.
#include "csg/curves/profile.h"

#include <algorithm>

#include "csg/geometry/planar_polygon.h"
#include "kernel/base/error.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {

void reverse(SampledLine& line) {
  std::reverse(line.points.begin(), line.points.end());
  std::reverse(line.segment.begin(), line.segment.end() - 1);  // edge i now ends in the old point n - 2 - i
  std::reverse(line.parameters.begin(), line.parameters.end() - 1);
  for (Span& span : line.parameters) std::swap(span[0], span[1]);
}

std::vector<SampledLine> sample(const Profile& profile, const std::string& shape,
                                const std::function<std::vector<Rational>(const BezierCurve&)>& steps,
                                const FixedSamples& fixed) {
  if (profile.lines.empty()) throw InputError(shape + ": the profile is empty: give its corners");
  std::vector<SampledLine> result;
  std::uint32_t number = 0;
  for (const ProfileLine& line : profile.lines) {
    const std::string in_line = profile.lines.size() == 1
                                    ? " of the profile"
                                    : " of line " + std::to_string(result.size() + 1) + " of the profile";
    if (line.segments.empty())
      throw InputError(shape + ": a line of the profile has no segments: give at least two corners");
    SampledLine& sampled = result.emplace_back();
    for (std::size_t s = 0; s < line.segments.size(); ++s) {
      const std::string name = "segment " + std::to_string(s + 1) + in_line;
      const bool last = s + 1 == line.segments.size();
      const CurveNet& net = line.segments[s];
      const std::vector<BezierCurve> pieces = curve_pieces(net, shape + ": " + name);
      const CurveNet& next = line.segments[last ? 0 : s + 1];
      if ((!last || profile.closed) && !next.points.empty() && net.points.back() != next.points[0]) {
        throw InputError(shape + ": " + name + " ends in " + describe(net.points.back()) +
                         ", the next one begins in " + describe(next.points[0]) +
                         ": let segments follow each other");
      }
      const std::vector<Span> spans = curve_spans(net);
      for (std::size_t k = 0; k < pieces.size(); ++k) {
        const BezierCurve& piece = pieces[k];
        if (piece.is_point()) {
          throw InputError(shape + ": " + name + " is one point, " + describe(piece.at(0)) +
                           ": leave a corner out");
        }
        std::vector<FixedSample> samples{{0, piece.at(0)}};
        if (const auto given = fixed.find({number, k}); given != fixed.end()) {
          samples.insert(samples.end(), given->second.begin(), given->second.end());
        } else {
          for (const Rational& t : steps(piece)) samples.push_back({t, piece.at(t)});
        }
        for (std::size_t i = 0; i < samples.size(); ++i) {
          const Rational next = i + 1 < samples.size() ? samples[i + 1].t : Rational(1);
          sampled.points.push_back(samples[i].point);
          sampled.segment.push_back(number);
          sampled.parameters.push_back({in_span(spans[k], samples[i].t), in_span(spans[k], next)});
        }
        if (last && k + 1 == pieces.size() && !profile.closed) sampled.points.push_back(piece.at(1));
      }
      ++number;
    }
  }
  return result;
}

void name_segments(LeafParameters& record, const std::vector<SampledLine>& lines, const std::string& shape,
                   std::uint32_t first) {
  for (const SampledLine& line : lines) {
    for (const std::uint32_t segment : line.segment) {
      record.name_patch(first + segment, shape + " segment " + std::to_string(segment + 1));
    }
  }
}

RationalPoint check_area(const std::vector<SampledLine>& lines, const std::string& shape) {
  std::vector<std::vector<RationalPoint>> loops;
  for (const SampledLine& line : lines) loops.push_back(line.points);
  const auto point_name = [&](std::size_t l, std::size_t i) {
    return "point " + std::to_string(i + 1) + (l == 0 ? "" : " of hole " + std::to_string(l));
  };
  return check_polygon(loops, {"the profile of " + shape, point_name});
}

}  // namespace cnrg
