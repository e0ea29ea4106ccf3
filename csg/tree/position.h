// Places in a tree file, and messages about them.
//
// Each fault of a user is reported once, as `file:line:column: error: what is wrong; what to do`. Lines and
// columns count from 1; (1, 1) also stands for the file as a whole.
#pragma once

#include <string>

#include "kernel/base/error.h"
#include "kernel/base/ids.h"

namespace cnrg {

using NodeId = Id<struct NodeTag>;  ///< a node of a tree file, inline nodes included

struct Position {
  int line = 1, column = 1;
  friend bool operator==(const Position&, const Position&) = default;
};

/// `file:line:column`.
std::string to_string(const std::string& file, Position at);

/// A fault of a tree file at its position; `what()` is the whole line that people read, names escaped.
class TreeError : public InputError {
 public:
  TreeError(std::string file, Position at, std::string message);
  const std::string& file() const { return file_; }
  int line() const { return at_.line; }
  int column() const { return at_.column; }
  /// Without the position.
  const std::string& message() const { return message_; }

 private:
  std::string file_;
  Position at_;
  std::string message_;
};

/// A fault at a place of a node; who knows the tree makes it a TreeError.
class FaultAt : public InputError {
 public:
  FaultAt(Position at, const std::string& message) : InputError(message), at_(at) {}
  Position at() const { return at_; }

 private:
  Position at_;
};

/// Something that people should know and that stops nothing.
struct Diagnostic {
  enum class Level { notice, warning };
  std::string file;
  Position at;
  Level level = Level::warning;
  std::string message;
  friend bool operator==(const Diagnostic&, const Diagnostic&) = default;
  /// `file:line:column: warning: message`, or `notice`.
  std::string text() const;
};

}  // namespace cnrg
