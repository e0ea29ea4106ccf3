// What leaves the program: everything on standard output and standard error goes through here.
//
// Names are escaped where they enter a line (csg/text/escape.h). A name that somebody forgot there is escaped
// here, but for line ends, which a whole text must have: so no control character passes whoever writes to
// `std::cout`.
#pragma once

#include <exception>
#include <streambuf>
#include <string>
#include <string_view>

#include "kernel/base/error.h"

namespace cnrg::app {

/// Prints a message on standard error as one line, whatever is in it.
void tell(std::string_view message);

/// Prints an error: its own line or, of one with places (csg/tree/position.h), each fault with the line of the
/// file and a mark below the column.
void tell_error(const std::exception& error);
/// Of an InputError.
void tell_error(const std::exception_ptr& error);

/// `write(file)` for each: a format that refuses a result does not keep other files from being written. Throws the
/// last refusal; those before it are told.
template <class Files, class Write>
void write_each(const Files& files, const Write& write) {
  std::exception_ptr refused;
  for (const auto& file : files) {
    try {
      write(file);
    } catch (const InputError&) {
      if (refused) tell_error(refused);
      refused = std::current_exception();
    }
  }
  if (refused) std::rethrow_exception(refused);
}

/// Standard streams that whoever started the program left closed are opened as such that cannot be used. Otherwise
/// the first files that are opened would take their places, and get what is printed.
void occupy_streams();

/// `std::cout` while it lives: escaped, written in blocks.
class Output : private std::streambuf {
 public:
  Output();
  ~Output() override;
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  /// Writes what is left. False if something could not be written, now or before; std::bad_alloc if there was no
  /// memory for it.
  bool finish();
  /// True if nobody reads any more (`cnrg ... | head -1`): there is nobody to complain to.
  bool unread() const;

 private:
  int overflow(int c) override;
  std::streamsize xsputn(const char* text, std::streamsize n) override;
  int sync() override;
  /// Writes whole lines, or all that there is.
  bool drain(bool all);

  std::streambuf* before_;
  std::string waiting_;
  std::size_t lines_ = 0;  ///< bytes of `waiting_` up to its last line end
  int reason_ = 0;         ///< of the system, why nothing more is written
};

}  // namespace cnrg::app
