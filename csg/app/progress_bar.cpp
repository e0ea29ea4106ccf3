// A carriage return and an erased line: every terminal of today knows both. A line is written in one piece and by
// the system's `write`, so that a process that is forked meanwhile inherits neither a lock nor half a line.
#include "csg/app/progress_bar.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <system_error>

#include "csg/app/stopwatch.h"
#include "csg/text/escape.h"
#include "csg/text/table.h"

namespace cnrg::app {
namespace {

constexpr double kSeldom = 0.1;                         // seconds between two lines of one stage
constexpr auto kTick = std::chrono::milliseconds(500);  // and where nobody says anything
constexpr const char* kErase = "\r\x1b[K";

bool is_terminal() {
  const char* kind = std::getenv("TERM");
  return isatty(STDERR_FILENO) && kind && std::string_view(kind) != "dumb";
}

std::size_t columns_of_terminal() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

void put(const std::string& text) {
  [[maybe_unused]] const ssize_t n = ::write(STDERR_FILENO, text.data(), text.size());  // a bar may be lost
}

/// 0:07, 12:34, 1:02:03.
std::string clock_text(double seconds) {
  const auto all = static_cast<unsigned long long>(seconds);
  char text[48];
  if (all < 3600) std::snprintf(text, sizeof text, "%llu:%02llu", all / 60, all % 60);
  else std::snprintf(text, sizeof text, "%llu:%02llu:%02llu", all / 3600, all / 60 % 60, all % 60);
  return text;
}

/// The front of a text of UTF-8, without a character that is cut.
std::string front_of(std::string text, std::size_t columns) {
  while (width_of(text) > columns) {
    while (!text.empty() && (text.back() & 0xc0) == 0x80) text.pop_back();
    text.pop_back();
  }
  return text;
}

}  // namespace

std::optional<double> left_of_stage(std::size_t done, std::size_t total, double seconds) {
  constexpr double kFirst = 1, kLeast = 0.01;
  if (done == 0 || done >= total || double(done) < kLeast * double(total) || seconds < kFirst) return std::nullopt;
  return seconds * double(total - done) / double(done);
}

std::string left_text(std::optional<double> of_stage, const Foretold& foretold, double now) {
  if (of_stage) return clock_text(std::ceil(*of_stage)) + " left of this stage";
  const double left = foretold.until - now;
  if (foretold.what.empty() || left < 1) return {};
  return (foretold.at_most ? "up to " : "about ") + clock_text(left) + " left of " + foretold.what;
}

std::string progress_line(std::string_view stage, std::size_t done, std::size_t total, double seconds,
                          std::size_t columns, std::string_view left) {
  constexpr std::size_t kWidest = 30, kLeast = 10;
  std::string end = "  " + clock_text(seconds);
  if (!left.empty() &&
      width_of(stage) + std::string_view("  100 %  , ").size() + end.size() + left.size() < columns)
    end += ", " + std::string(left);
  if (total > 0) {
    const std::size_t part = std::min(done, total);
    char percent[16];
    std::snprintf(percent, sizeof percent, "%3d %%", static_cast<int>(100.0 * double(part) / double(total)));
    end = std::string("  ") + percent + end;
    const std::size_t taken = width_of(stage) + end.size() + 3;
    const std::size_t width = std::min(kWidest, columns - std::min(columns, taken));
    if (width >= kLeast) {
      const auto full = static_cast<std::size_t>(double(width) * double(part) / double(total));
      end = " [" + std::string(full, '#') + std::string(width - full, '.') + "]" + end.substr(1);
    }
  } else {
    end = " ..." + end;
  }
  return front_of(front_of(std::string(stage), columns - std::min(columns, end.size())) + end, columns);
}

ProgressBar::ProgressBar(bool quiet) : active_(!quiet && is_terminal()) {}

ProgressBar::~ProgressBar() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  ended_.notify_all();
  if (thread_.joinable()) thread_.join();
  clear();
}

void ProgressBar::draw() {
  last_ = seconds_so_far();
  const std::size_t columns = columns_of_terminal() - 1;  // in the last one some terminals begin a new line
  const std::string left = left_text(left_of_stage(done_, total_, last_ - begun_), foretold_, last_);
  put(kErase + progress_line(shown(stage_), done_, total_, last_, columns, left));
  drawn_ = true;
}

void ProgressBar::keep_drawing() {
  std::unique_lock lock(mutex_);
  while (!ended_.wait_for(lock, kTick, [&] { return ends_; })) {
    if (drawn_) draw();
  }
}

void ProgressBar::show(std::string_view stage, std::size_t done, std::size_t total) {
  if (!active_) return;
  const std::lock_guard lock(mutex_);
  const bool same = stage == stage_;
  const double now = seconds_so_far();
  if (!same || done < done_) begun_ = now;
  stage_ = stage;
  done_ = done;
  total_ = total;
  if (same && drawn_ && now - last_ < kSeldom) return;
  draw();
  if (thread_.joinable()) return;
  try {
    thread_ = std::thread([this] { keep_drawing(); });
  } catch (const std::system_error&) {  // the bar stands still, then
  }
}

void ProgressBar::foretell(std::string what, double seconds, bool at_most) {
  const std::lock_guard lock(mutex_);
  foretold_ = {std::move(what), seconds_so_far() + seconds, at_most};
}

Progress ProgressBar::progress() {
  return [this](std::string_view stage, std::size_t done, std::size_t total) { show(stage, done, total); };
}

void ProgressBar::clear() {
  const std::lock_guard lock(mutex_);
  if (drawn_) put(kErase);
  drawn_ = false;
  stage_.clear();
}

}  // namespace cnrg::app
