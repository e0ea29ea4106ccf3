// The topology of a node's value in words and numbers, for `cnrg eval --topology`.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "csg/operators/group.h"
#include "csg/result/result.h"
#include "kernel/selection/simplify.h"

namespace cnrg {

/// The terms of the formula of Euler and Poincare for sets that are no manifolds (masuda1993 3), counted on the
/// cells that simplification leaves, with two more (eh, fc) that only cells of curved patches need:
///   v - (e - eh) + (f - r + fc) - (V - Vh + Vc) = C - Ch + Cc
/// v, e, f: vertices, edges, faces; eh: edges that close on themselves without a vertex; r: independent loops of
/// faces (the rings of a flat face); fc: faces without any boundary that enclose a cavity (all of a sphere);
/// V: volumes, Vh: their handles, Vc: their cavities; C: pieces of the whole, Ch: holes through it, Cc: cavities.
struct SimplifiedEuler {
  std::int64_t v = 0, e = 0, edge_loops = 0, f = 0, r = 0, closed_faces = 0;
  std::int64_t volumes = 0, volume_holes = 0, volume_cavities = 0;
  std::int64_t pieces = 0, holes = 0, cavities = 0;
  std::int64_t left() const {
    return v - (e - edge_loops) + (f - r + closed_faces) - (volumes - volume_holes + volume_cavities);
  }
  std::int64_t right() const { return pieces - holes + cavities; }
  static constexpr std::array kTerms{"v", "e", "eh", "f", "r", "fc", "V", "Vh", "Vc", "C", "Ch", "Cc"};
  std::array<std::int64_t, kTerms.size()> terms() const {
    return {v, e, edge_loops, f, r, closed_faces, volumes, volume_holes, volume_cavities, pieces, holes, cavities};
  }
};

/// The terms of the closure of a selection's point set, which must be bounded. Each is counted on its own, those
/// of a cell by its Betti numbers; `left() == right()` is a theorem.
SimplifiedEuler simplified_euler(const Complex& complex, const Selection& selection,
                                 const SimplifiedComplex& simplified);

/// Lines of text: Euler-Poincare with its terms; Betti numbers of the point set and of each component over Z/2 and
/// Q; vertices and edges by their local shape, each way not to be a manifold with the cells concerned (named as
/// `cnrg locate` names them), with radial orders and neighbourhoods there; sheets; shells and adjacency of
/// regions; what stands in the way of making the value (manufacturable.h). `simplified` is that of `selection`;
/// `components[i - 1]` is what is known of component i, for as many components as there are entries.
std::string topology_text(const Complex& complex, const Selection& selection, const SimplifiedComplex& simplified,
                          std::span<const RegionAttributes> components);

/// The same of a result, as that text and as JSON, whose members are in csg/explain/answers.schema.json. Lists are
/// whole there.
struct TopologyReport {
  std::string text, json;
};
TopologyReport topology_report(const Result& result);

}  // namespace cnrg
