// A block ends with a line, so that no character is cut in two.
#include "csg/app/output.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <iostream>
#include <new>

#include "csg/text/escape.h"

namespace cnrg::app {
namespace {

constexpr std::size_t kOutputBlock = 1 << 16;

/// Writes to standard output; the system's reason if it refuses.
int write_out(std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = ::write(STDOUT_FILENO, text.data(), text.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return errno;
    text.remove_prefix(static_cast<std::size_t>(n));
  }
  return 0;
}

}  // namespace

void tell(std::string_view message) {
  std::cout.flush();  // what was said before stands before
  std::cerr << shown(message) << std::endl;
}

void occupy_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) >= 0 || errno != EBADF) continue;
    (void)open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);  // the least number that is free
  }
}

Output::Output() : before_(std::cout.rdbuf(this)) {}

Output::~Output() {
  try {
    drain(true);
  } catch (const std::bad_alloc&) {  // whoever did not `finish` has an error of its own to tell
  }
  std::cout.rdbuf(before_);
}

bool Output::finish() {
  // A stream keeps every exception to itself, and what was to be printed is lost.
  if (std::cout.bad() && reason_ == 0) throw std::bad_alloc();
  return drain(true);
}

bool Output::unread() const { return reason_ == EPIPE; }

int Output::overflow(int c) {
  if (c == traits_type::eof()) return 0;
  const char one = traits_type::to_char_type(c);
  return xsputn(&one, 1) == 1 ? c : traits_type::eof();
}

std::streamsize Output::xsputn(const char* text, std::streamsize n) {
  const std::string_view added(text, static_cast<std::size_t>(n));
  const std::size_t line_end = added.rfind('\n');
  if (line_end != std::string_view::npos) lines_ = waiting_.size() + line_end + 1;
  waiting_ += added;
  if (waiting_.size() >= kOutputBlock && !drain(false)) return 0;
  return n;
}

int Output::sync() { return drain(true) ? 0 : -1; }

bool Output::drain(bool all) {
  const std::size_t end = all ? waiting_.size() : lines_;
  if (reason_ == 0) reason_ = write_out(shown_lines(std::string_view(waiting_).substr(0, end)));
  waiting_.erase(0, end);
  lines_ = 0;
  return reason_ == 0;
}

}  // namespace cnrg::app
