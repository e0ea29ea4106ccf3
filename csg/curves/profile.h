// Profiles of straight and curved segments as polygons on which each edge knows its segment.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "csg/curves/boundary_curves.h"
#include "csg/curves/control_nets.h"
#include "csg/leaves/parameters.h"

namespace cnrg {

/// A line of a profile as points exactly on it. Edge i runs from point i to the next (the last one, of a closed
/// line, to the first) and is a piece of segment `segment[i]`, counted through all lines of the profile.
struct SampledLine {
  std::vector<RationalPoint> points;
  std::vector<std::uint32_t> segment;
  std::vector<Span> parameters;  ///< of the segment's curve at the two ends of edge i
};

/// The same closed line run backward.
void reverse(SampledLine& line);

/// Points inside of pieces of a profile, by segment and piece: with their parameters, 0 to 1, which ascend.
struct FixedSample {
  Rational t;
  RationalPoint point;
};
using FixedSamples = std::map<std::pair<std::uint32_t, std::size_t>, std::vector<FixedSample>>;

/// `steps` gives the parameters of the points between the ends of a piece, ascending, but for pieces whose points
/// are given. Checked are the nets of
/// the segments, that no segment is a point, and that each begins where the one before it ends. Throws InputError;
/// `shape` begins the message.
std::vector<SampledLine> sample(const Profile& profile, const std::string& shape,
                                const std::function<std::vector<Rational>(const BezierCurve&)>& steps,
                                const FixedSamples& fixed = {});

/// Names the patch that each segment sweeps, `first` being the number of the first one: "extrude segment 1" ...
void name_segments(LeafParameters& record, const std::vector<SampledLine>& lines, const std::string& shape,
                   std::uint32_t first);

/// Checks that closed lines bound a planar area with holes, on the points that are used (`check_polygon`), and
/// returns its normal.
RationalPoint check_area(const std::vector<SampledLine>& lines, const std::string& shape);

}  // namespace cnrg
