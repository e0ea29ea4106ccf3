// The system's `read`, since streams do not tell an error from the end.
#include "csg/app/line_reader.h"

#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "csg/text/input_file.h"
#include "csg/text/number.h"
#include "csg/text/table.h"
#include "csg/tree/position.h"

namespace cnrg::app {
namespace {

constexpr std::size_t kLineBlock = 1 << 16;
constexpr std::size_t kLongestLine = 4 * kMostDigits;  // three numbers and what is between them

bool must_wait() {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  return poll(&input, 1, 0) == 0;
}

}  // namespace

bool LineReader::next(std::string_view& line) {
  for (;;) {
    const std::size_t end = waiting_.find('\n', searched_);
    const bool whole = end != std::string::npos;
    const std::size_t length = (whole ? end : waiting_.size()) - at_;
    if (length > kLongestLine) {
      throw TreeError(
          kStandardInput, {number_ + 1, 1},
          "this line has more than " + grouped(kLongestLine) + " characters; a point is `x y z` on a line");
    }
    if (whole || (ended_ && length > 0)) {
      line = std::string_view(waiting_).substr(at_, length);
      at_ += length + (whole ? 1 : 0);
      searched_ = at_;
      if (number_++ == 0) line = without_mark(line);
      return true;
    }
    if (ended_) return false;
    searched_ = waiting_.size();
    fill();
  }
}

void LineReader::fill() {
  waiting_.erase(0, at_);
  searched_ -= at_;
  at_ = 0;
  if (must_wait()) before_waiting_();
  const std::size_t size = waiting_.size();
  waiting_.resize(size + kLineBlock);
  ssize_t n;
  do {
    n = ::read(STDIN_FILENO, waiting_.data() + size, kLineBlock);
  } while (n < 0 && errno == EINTR);
  const int reason = errno;
  waiting_.resize(size + static_cast<std::size_t>(n > 0 ? n : 0));
  if (n < 0) {
    throw FileError(std::string(kStandardInput) + ":" + std::to_string(number_ + 1) +
                    ":1: error: the points cannot be read: " + std::strerror(reason));
  }
  ended_ = n == 0;
}

}  // namespace cnrg::app
