// Volumes by the names of regions, for comparison of results whose numbers differ.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "csg/result/result.h"

namespace cnrg {

inline std::map<std::string, Rational> volumes(const Result& result) {
  std::map<std::string, Rational> out;
  for (Component i = 1; i <= Component(result.component_count()); ++i) {
    const std::optional<Rational> volume = result.volume(i);
    if (volume && *volume != 0) out[result.attributes(i).name] += *volume;
  }
  return out;
}

}  // namespace cnrg
