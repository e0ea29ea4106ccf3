// A carriage return and an erased line: every terminal of today knows both.
#include "csg/app/progress_bar.h"

#include <unistd.h>

#include <cstdlib>
#include <iostream>

#include "csg/text/escape.h"

namespace cnrg::app {
namespace {

bool is_terminal() {
  const char* kind = std::getenv("TERM");
  return isatty(STDERR_FILENO) && kind && std::string_view(kind) != "dumb";
}

}  // namespace

ProgressBar::ProgressBar(bool quiet) : active_(!quiet && is_terminal()) {}

ProgressBar::~ProgressBar() { clear(); }

void ProgressBar::show(std::string_view stage, std::size_t done, std::size_t total) {
  if (!active_) return;
  const auto now = std::chrono::steady_clock::now();
  if (stage == stage_ && now - last_ < std::chrono::milliseconds(100)) return;
  stage_ = stage;
  last_ = now;
  constexpr std::size_t kWidth = 30;
  std::cerr << "\r\x1b[K" << shown(stage_);
  if (total > 0) {
    const std::size_t full = kWidth * done / total;
    std::cerr << " [" << std::string(full, '#') << std::string(kWidth - full, '.') << "] " << done << "/" << total;
  } else {
    std::cerr << " ...";
  }
  std::cerr << std::flush;
  drawn_ = true;
}

void ProgressBar::clear() {
  if (drawn_) std::cerr << "\r\x1b[K" << std::flush;
  drawn_ = false;
  stage_.clear();
}

}  // namespace cnrg::app
