// Lines of standard input, as they come.
//
// A reader of whole input answers nothing to `yes '1 1 1' | cnrg locate T | head -1`, and a buffered one leaves a
// person at a terminal without the answer to the line just typed. Here a line is given out when it is there, and
// before the program waits for more, what it has printed is sent.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace cnrg::app {

class LineReader {
 public:
  /// `before_waiting` is called before a read that would wait.
  explicit LineReader(std::function<void()> before_waiting) : before_waiting_(std::move(before_waiting)) {}

  /// The next line without its end, the first one without a byte order mark; false when there is none. Throws
  /// FileError if the system cannot read, TreeError with the place `<stdin>:line:1` for a line that is longer than
  /// any line of points.
  bool next(std::string_view& line);
  /// Of the line that was read last, from 1.
  int number() const { return number_; }

 private:
  /// Reads a block behind what waits.
  void fill();

  std::function<void()> before_waiting_;
  std::string waiting_;
  std::size_t at_ = 0;        // of the next line in `waiting_`
  std::size_t searched_ = 0;  // no line ends from `at_` up to here
  int number_ = 0;
  bool ended_ = false;
};

}  // namespace cnrg::app
