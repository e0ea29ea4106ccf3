// Places in a tree file, and messages about them.
//
// Each fault of a user is reported once, as `file:line:column: error: what is wrong; what to do`. Lines and
// columns count from 1; (1, 1) also stands for the file as a whole. Independent parts of a file are read one by
// one, and an error holds the faults of all of them.
#pragma once

#include <string>
#include <vector>

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

/// What is wrong, and where.
struct Fault {
  std::string file;
  Position at;
  std::string message;
  friend bool operator==(const Fault&, const Fault&) = default;
  /// The line that people read, names escaped.
  std::string text() const;
};

/// An error with the faults that were found, one or more.
class Placed {
 public:
  explicit Placed(std::vector<Fault> faults) : faults_(std::move(faults)) {}
  virtual ~Placed() = default;
  const std::vector<Fault>& faults() const { return faults_; }
  const std::string& file() const { return faults_.front().file; }
  int line() const { return faults_.front().at.line; }
  int column() const { return faults_.front().at.column; }
  /// Without the position.
  const std::string& message() const { return faults_.front().message; }

 private:
  std::vector<Fault> faults_;
};

/// Faults of a tree file; `what()` is the text of the first one.
class TreeError : public InputError, public Placed {
 public:
  TreeError(std::string file, Position at, std::string message);
  explicit TreeError(std::vector<Fault> faults) : InputError(faults.front().text()), Placed(std::move(faults)) {}
};

/// More than a whole file may have: nothing else of it is read.
class TreeLimitError : public TreeError {
 public:
  using TreeError::TreeError;
};

/// Faults of a tree file, where the first one is a file that cannot be read.
class TreeFileError : public FileError, public Placed {
 public:
  explicit TreeFileError(std::vector<Fault> faults)
      : FileError(faults.front().text()), Placed(std::move(faults)) {}
};

/// Collects the faults of independent parts.
class Faults {
 public:
  /// Runs `work` and keeps what TreeError and TreeFileError say, but for TreeLimitError.
  template <class Work>
  void attempt(Work work) {
    try {
      work();
    } catch (const TreeLimitError&) {
      throw;
    } catch (const TreeError& e) {
      add(e, false);
    } catch (const TreeFileError& e) {
      add(e, true);
    }
  }
  bool empty() const { return faults_.empty(); }
  /// Throws if there is a fault.
  void raise() const;

 private:
  std::vector<Fault> faults_;  ///< each once
  bool file_first_ = false;
  void add(const Placed& error, bool of_file);
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
