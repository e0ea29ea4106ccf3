// The keys of a node in a tree file that are operators.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "csg/tree/tree.h"

namespace cnrg {

struct OperatorName {
  std::string_view name;
  Operator op;
};
inline constexpr std::array<OperatorName, 20> kOperators{{
    {"union", Operator::unite},           {"repeat", Operator::unite},
    {"layers", Operator::unite},          {"intersection", Operator::intersect},
    {"difference", Operator::subtract},   {"aggregate", Operator::aggregate},
    {"unify", Operator::unify},           {"sum", Operator::sum},
    {"product", Operator::product},       {"subtract", Operator::cnrg_subtract},
    {"complement", Operator::complement}, {"interior", Operator::interior},
    {"closure", Operator::closure},       {"boundary", Operator::boundary},
    {"regularize", Operator::regularize}, {"below", Operator::below},
    {"above", Operator::above},           {"simplify", Operator::simplify},
    {"csg", Operator::simplify},          {"select", Operator::select},
}};

inline const OperatorName* find_operator(std::string_view name) {
  const auto it =
      std::find_if(kOperators.begin(), kOperators.end(), [&](const auto& o) { return o.name == name; });
  return it == kOperators.end() ? nullptr : &*it;
}

inline bool is_boolean(Operator op) {
  return op == Operator::unite || op == Operator::intersect || op == Operator::subtract;
}

/// Operators on two or more operands.
inline bool takes_a_list(Operator op) {
  return is_boolean(op) || op == Operator::aggregate || op == Operator::sum || op == Operator::product ||
         op == Operator::cnrg_subtract;
}

/// Operators whose operands meet, so that one of them may dominate.
inline bool has_sides(Operator op) { return is_boolean(op) || op == Operator::sum || op == Operator::product; }

}  // namespace cnrg
