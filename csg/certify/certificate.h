// What is proven of the leaves below the nodes of an evaluation, and what is not.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "csg/tree/tree.h"

namespace cnrg {

/// Where it is not proven that surfaces meet as their facets do: a connected set of pieces (proof.h) of the same
/// patches.
struct UncertainPlace {
  enum class Why : std::uint8_t {
    near,    ///< they touch, or are too near to it
    facets,  ///< facets are too coarse, and cannot be finer
    budget,  ///< there were no steps left
  };
  std::vector<std::string> names;  ///< nodes of leaves, each with the name of its patch in brackets, if it has one
  std::vector<NodeId> nodes;       ///< of the same
  std::array<double, 3> at{};
  double size = 0;  ///< within this length of `at` nothing was decided
  int common = 0;   ///< the dimension of what they have in common there if they cross; below 0: mostly nothing
  Why why = Why::near;
  std::string text() const;
};

struct Evaluation;
struct KeptValue;

struct Certificate {
  /// Pairs of facets near each other: in all, and what was proven of them and of their surfaces.
  std::size_t asked = 0, apart = 0, crossing = 0, contacts = 0;
  std::size_t left = 0;  ///< questions that were not answered within the budget
  std::vector<UncertainPlace> places;
  std::vector<NodeId> unknown;  ///< leaves of whose curved faces only facets are known
  void add(const Certificate& more);
  /// What a file on the true surfaces may have wrong, with the first place; empty: nothing.
  std::string doubt(const Tree& tree) const;
  /// Of the first places.
  std::vector<Diagnostic> notices(const Tree& tree, std::size_t most) const;
  /// Where nobody asked for all: the first places, how many more there are, and questions left.
  std::vector<Diagnostic> told(const Tree& tree) const;
};

/// Of the result and of the nodes that were asked for besides, as EvaluateOptions::proof said.
Certificate certificate_of(const Evaluation& evaluation);
/// Of one of these alone.
Certificate certificate_of(const Evaluation& evaluation, NodeId node);
/// True if all leaves that meet at the place are below the node.
bool is_below(const Evaluation& evaluation, const KeptValue& kept, const UncertainPlace& place);

}  // namespace cnrg
