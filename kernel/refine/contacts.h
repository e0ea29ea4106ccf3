// Where two inputs meet: all pairs of faces, wires and points (the kinds of contact of Gursoz et al. 1991), as
// symbols. Equal points are one vertex before this.
//
// Two faces in different planes meet along the common line of their planes. Each face cuts a set of closed
// intervals out of that line; what is common to both sets are traces (segments) and touching points. Every
// decision is an exact predicate on input data or on constructions from it; results are keys, not coordinates.
// Coplanar faces are only noted: their overlap is the business of their sheet.
#pragma once

#include <vector>

#include "kernel/base/progress.h"
#include "kernel/refine/point_key.h"

namespace cnrg {

/// What was found.
struct ContactList {
  struct Trace {
    SourceId f, g;
    PointKey a, b;
  };
  struct OnFace {
    SourceId face;
    PointKey point;
  };
  struct OnWire {
    SegmentId wire;
    PointKey point;
  };
  struct WireInPlane {
    SourceId face;
    SegmentId wire;
  };
  std::vector<Trace> traces;
  std::vector<OnFace> on_face;
  std::vector<OnWire> on_wire;
  std::vector<WireInPlane> wires_in_plane;
  /// Coplanar faces that meet, in pairs: who meets whom by chains of them is told, not every pair.
  std::vector<std::pair<SourceId, SourceId>> coplanar;
  std::uint64_t candidates = 0;
  std::array<std::uint64_t, 6> kinds{};

  void append(const ContactList& other);
};

/// All contacts of the input, in parallel. The lists are sets: their order is by chance, entries may be repeated.
ContactList find_contacts(const RefineInput& input, const Watch& watch = {});

}  // namespace cnrg
