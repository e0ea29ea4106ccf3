// Work that is watched hears a stop wherever it is asked for.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <string>
#include <vector>

#include "kernel/base/progress.h"

namespace cnrg::test {

/// Runs the work once to the end, in which it tells of `stages`, and again for each time that it tells of its
/// progress, when it is asked to stop: then it tells of nothing more.
inline void check_stops(const std::function<void(const Watch&)>& work, const std::vector<std::string>& stages) {
  std::vector<std::string> told;
  work({[&](std::string_view stage, std::size_t done, std::size_t total) {
          CHECK((done <= total || total == 0));
          told.emplace_back(stage);
        },
        {}});
  for (const std::string& stage : stages) {
    INFO(stage);
    CHECK(std::find(told.begin(), told.end(), stage) != told.end());
  }
  for (std::size_t at = 0; at < told.size(); ++at) {
    INFO("stopped at " << told[at] << ", call " << at);
    std::stop_source stop;
    std::size_t calls = 0;
    const Watch watch{[&](std::string_view, std::size_t, std::size_t) {
                        if (calls++ == at) stop.request_stop();
                      },
                      stop.get_token()};
    CHECK_THROWS_AS(work(watch), Stopped);
    CHECK(calls == at + 1);
  }
}

}  // namespace cnrg::test
