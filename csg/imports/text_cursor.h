// A place in a text file: tokens, numbers, and errors with the line.
#pragma once

#include <string>
#include <string_view>

#include "csg/imports/mesh_file.h"

namespace cnrg {

class TextCursor {
 public:
  /// `comment`: the rest of a line from this character on is skipped (0: none). `line`: where the text begins.
  TextCursor(std::string path, std::string_view text, char comment, int line = 1);

  /// Skips blanks, line ends and comments; false at the end of the file.
  bool more();
  /// Skips blanks and a comment in this line; false at its end.
  bool more_in_line();
  /// Moves to the start of the next line.
  void next_line();
  /// The characters up to the next blank or line end. Empty at the end of the file or of the line.
  std::string_view token_in_line();
  /// How many tokens, up to `most`, are ahead in this line; none is taken.
  int tokens_left(int most);
  /// The next token, in whichever line; at the end of the file an error that says `wanted` is missing.
  std::string_view token(const char* wanted);

  /// The next bytes of a file that is not only text, `count` or what there is. No line is told behind them.
  std::string_view bytes(std::size_t count);

  /// A whole number. `wanted` names it in errors.
  long long integer(const char* wanted);
  /// The same of a token that was taken, from its character `from` on.
  long long integer(std::string_view taken, const char* wanted, std::size_t from = 0) const;
  /// A finite number; infinite, not-a-number and other text are errors.
  double number(const char* wanted);
  /// A finite number with its exact decimal value.
  double decimal(const char* wanted, Rational& exact);
  /// Reads one point: appends its doubles to `mesh.xyz` and, with `decimals`, keeps its exact value.
  void coordinates(MeshData& mesh, bool decimals);

  int line() const { return line_; }
  std::size_t offset() const { return static_cast<std::size_t>(at_ - begin_); }
  /// Throws LeafFileError: `path:line: error: text`.
  [[noreturn]] void fail(const std::string& text) const { fail_at(line_, text); }
  [[noreturn]] void fail_at(int line, const std::string& text) const;
  /// Fails at the last line that is not empty: the file ends too early, as `text` says.
  [[noreturn]] void fail_at_end(const std::string& text) const;

 private:
  double parse(std::string_view token, const char* wanted, Rational* exact) const;

  std::string path_;
  const char *begin_, *at_, *end_;
  int first_line_, line_;
  char comment_;
};

/// Its ASCII letters as small ones.
std::string lower(std::string_view word);
/// The token in quotes for messages, cut to a readable length.
std::string in_quotes(std::string_view token);

}  // namespace cnrg
