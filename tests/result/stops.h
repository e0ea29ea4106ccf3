// Work that is watched hears a stop in whichever stage it is asked for.
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "kernel/base/progress.h"
#include "tests/catch.h"

namespace cnrg::test {

/// Runs the work once to the end, in which it begins `stages` among others, and again for each beginning, when it
/// is asked to stop: then it begins nothing more.
inline void check_stops(const std::function<void(const Watch&)>& work, const std::vector<std::string>& stages) {
  std::vector<std::string> told;
  work({[&](std::string_view stage, std::size_t done, std::size_t total) {
          CHECK((done <= total || total == 0));
          if (done == 0) told.emplace_back(stage);
        },
        {}});
  for (const std::string& stage : stages) {
    INFO(stage);
    CHECK(std::find(told.begin(), told.end(), stage) != told.end());
  }
  for (std::size_t at = 0; at < told.size(); ++at) {
    INFO("stopped at " << told[at]);
    std::stop_source stop;
    std::size_t begun = 0;
    const Watch watch{[&](std::string_view, std::size_t done, std::size_t) {
                        if (done == 0 && begun++ == at) stop.request_stop();
                      },
                      stop.get_token()};
    CHECK_THROWS_AS(work(watch), Stopped);
    CHECK(begun == at + 1);
  }
}

}  // namespace cnrg::test
