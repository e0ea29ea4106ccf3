// Progress of work that consists of named parts: each stage is reported with the name of its part.
#pragma once

#include <string>
#include <utility>

#include "kernel/base/progress.h"

namespace cnrg {

/// A watch that reports each stage to `watch` as `name: stage`.
inline Watch part_of(const Watch& watch, std::string name) {
  Watch out{{}, watch.stop};
  if (!watch.progress) return out;
  out.progress = [told = watch.progress, name = std::move(name)](std::string_view stage, std::size_t done,
                                                                 std::size_t total) {
    told(name + ": " + std::string(stage), done, total);
  };
  return out;
}

}  // namespace cnrg
