// A judgement (judge.h) made in a process with limits.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "bench/cases/child.h"
#include "bench/sweep/judge.h"

namespace cnrg::bench {

/// A judgement, or why there is none.
struct Judged {
  std::optional<Judgement> judgement;
  std::string reason;
};

/// Of the text of a model. Where comparing ends without a judgement, a volume that is far off is wrong.
Judged judged(const std::function<Problem()>& make, const Limits& limits, double rounding,
              const std::string& model);

}  // namespace cnrg::bench
