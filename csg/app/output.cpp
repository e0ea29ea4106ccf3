// A block ends with a line, so that no character is cut in two.
#include "csg/app/output.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <iostream>
#include <map>
#include <new>

#include "csg/text/escape.h"
#include "csg/text/input_file.h"
#include "csg/text/table.h"
#include "csg/tree/position.h"

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

/// Empty if it cannot be read again.
std::string read_again(const std::string& file) {
  if (file == kStandardInput) return {};
  try {
    return read_file(file);
  } catch (const std::runtime_error&) {
    return {};
  }
}

/// A line without its end; nothing if there are not so many.
std::string line_of(const std::string& text, int number) {
  std::size_t begin = 0;
  for (int line = 1; line < number; ++line) {
    begin = text.find('\n', begin) + 1;
    if (begin == 0) return {};
  }
  return text.substr(begin, text.find_first_of("\r\n", begin) - begin);
}

/// Removes a character in front and gives it as it is shown.
std::string next_shown(std::string_view& text) {
  const std::size_t length = first_character(text).length;
  std::string character = shown(text.substr(0, length));
  text.remove_prefix(length);
  return character;
}

/// The line of a fault, and below it a mark at the column; of a long line the part there. Nothing for a file as a
/// whole.
std::string marked_line(const Fault& fault, const std::string& text) {
  constexpr std::size_t kBefore = 60, kAfter = 40;
  if (fault.at == Position()) return {};
  const std::string line = line_of(text, fault.at.line);
  if (line.empty()) return {};
  std::string_view rest = line;
  const std::size_t column = std::min(static_cast<std::size_t>(fault.at.column) - 1, line.size());
  std::string before = column > kBefore ? "..." : "", after;
  while (line.size() - rest.size() < column) {
    const bool near = line.size() - rest.size() + kBefore >= column;
    const std::string character = next_shown(rest);
    if (near) before += character;
  }
  for (std::size_t i = 0; i < kAfter && !rest.empty(); ++i) after += next_shown(rest);
  const std::string margin = "  " + std::to_string(fault.at.line) + " | ";
  return margin + before + after + (rest.empty() ? "\n" : "...\n") + std::string(margin.size() - 2, ' ') + "| " +
         std::string(width_of(before), ' ') + "^\n";
}

}  // namespace

void tell_error(const std::exception& error) {
  constexpr std::size_t kMost = 50;
  const auto* const placed = dynamic_cast<const Placed*>(&error);
  if (placed == nullptr) return tell(error.what());
  const std::vector<Fault>& faults = placed->faults();
  std::map<std::string, std::string> texts;
  for (std::size_t i = 0; i < faults.size() && i < kMost; ++i) {
    tell(faults[i].text());
    const auto [text, fresh] = texts.try_emplace(faults[i].file);
    if (fresh) text->second = read_again(faults[i].file);
    std::cerr << marked_line(faults[i], text->second) << std::flush;
  }
  if (faults.size() > kMost) tell(counted(faults.size() - kMost, "more fault", "more faults"));
}

void tell_error(const std::exception_ptr& error) {
  try {
    std::rethrow_exception(error);
  } catch (const InputError& fault) {
    tell_error(fault);
  }
}

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
