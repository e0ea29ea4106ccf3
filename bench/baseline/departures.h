// The rules in which the baseline departs from the published algorithm, each a switch.
//
// "Published" means the programs of mantyla1988 as their author gave them away (gwb.shar, 1988; kept in the
// repository aki5/gwb at commit 983deb8), for facts only; nothing of them is here. Two later transcriptions tell
// where that archive has a stub or a slip: OscarChavarro/vitral at d2cb104, mfernba/rGWB at 346de75.
#pragma once

#include <array>

namespace cnrg::bench::mantyla {

/// All on: the baseline. All off: the published algorithm.
struct Departures {
  bool sides = true, single = true, arcs = true;
  bool pairs = true, order = true;
  bool nearest = true, rings = true;
  bool curves = true, shells = true;
  bool checks = true;
};

struct Departure {
  const char* name;  ///< in names of systems
  bool Departures::*rule;
  const char* published;
  const char* ours;
};

inline constexpr std::array<Departure, 10> kDepartures = {{
    {"sides", &Departures::sides, "an edge in a face, between an IN and an OUT edge of its vertex, is IN",
     "its side depends on the operation and the solid"},
    {"single", &Departures::single, "an edge of B inside of a sector of A is OUT in a union, else IN",
     "it is IN in a union, else OUT, as where it lies on an edge of A"},
    {"arcs", &Departures::arcs, "two vertices are compared by pairs of sectors, which overwrite their neighbours",
     "by parts of arcs of sectors, from points where the neighbourhoods meet"},
    {"pairs", &Departures::pairs, "crossings of a vertex make null edges two by two, as they were found",
     "along the arcs that the result keeps"},
    {"order", &Departures::order, "null edges in one corner are told apart by the convexity of edges",
     "by the order of their directions"},
    {"nearest", &Departures::nearest, "an end joins the first loose end in the order of coordinates",
     "the nearest ahead on the line of its faces"},
    {"rings", &Departures::rings, "a face that is split gives away rings by their first vertex, once",
     "rings follow where a join needs them, turn when they are split, and are placed at the end"},
    {"curves", &Departures::curves, "null faces are paired in the order in which they close, glued by coordinates",
     "paired by their curve, glued by its pieces"},
    {"shells", &Departures::shells, "shells without a curve are lost; without any curve there is no result",
     "they are located by rays"},
    {"checks", &Departures::checks, "nothing is checked", "a state that no right result has is refused"},
}};

constexpr Departures published() {
  Departures departures;
  for (const Departure& departure : kDepartures) departures.*departure.rule = false;
  return departures;
}

}  // namespace cnrg::bench::mantyla
