// A place in a result file: its value, checked as it is read, and errors with line, column and path.
//
// The page of the format (csg/FORMATS.md, formats/result.schema.json) says which members there are and how numbers
// are written; what it does not allow is refused, since a member that nobody reads says something that nobody
// checks.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>

#include "csg/leaves/leaf.h"
#include "csg/text/json_document.h"

namespace cnrg::result {

using Index = std::uint32_t;

inline constexpr const char* kWriteAgain = "write the file again with `cnrg eval -o`";

/// A JSON file and its name.
struct JsonFile {
  std::string name;
  JsonDocument document;
};

/// A value of the file.
class Cursor {
 public:
  using Kind = JsonDocument::Kind;
  using Value = JsonDocument::Value;

  explicit Cursor(const JsonFile& file) : file_(&file), value_(&file.document.root()) {}

  /// LeafFileError: `file:line:column: error: path: what`.
  [[noreturn]] void fail(const std::string& what) const;
  /// The same with how to mend it: by writing the file again.
  [[noreturn]] void refuse(const std::string& what) const { fail(what + "; " + kWriteAgain); }

  bool is_null() const { return value_->kind() == Kind::null; }
  /// Of a list.
  std::size_t size() const { return value_->count; }
  /// A value that says the same as `made`, which the cells of the file make; members of these names apart.
  void require_same(const Cursor& made, std::initializer_list<const char*> but) const;
  /// A member that must be there.
  Cursor member(const char* key) const;
  bool has(const char* key) const { return find(key) != nullptr; }
  Cursor at(std::size_t i) const { return {*file_, json().at(*value_, i)}; }
  /// The value must be a list.
  const Cursor& array() const;
  /// A list of so many items; `what` says so in messages.
  const Cursor& array_of(std::size_t count, const char* what) const;

  /// The number of a thing, below `limit`; `what` is the thing's name in messages.
  Index number(std::size_t limit, const char* what) const;
  bool boolean() const;
  std::string text() const;
  /// Written as `p` or `p/q` in lowest terms.
  Rational rational() const;
  /// Coordinates in the range of doubles.
  RationalPoint point() const;
  /// Calls `see` with each member of an object and its key, in the order of the file.
  template <class See>
  void each_member(See see) const {
    object();
    for (std::size_t i = 0; i < value_->count; ++i) {
      see(json().decoded(json().key(*value_, i)), Cursor(*file_, json().value(*value_, i)));
    }
  }

 private:
  Cursor(const JsonFile& file, const Value& value) : file_(&file), value_(&value) {}
  const JsonDocument& json() const { return file_->document; }
  const Cursor& object() const;
  /// Its text, shortened.
  std::string shown() const;
  const Value* find(const char* key) const {
    return value_->kind() == Kind::object ? json().member(*value_, key) : nullptr;
  }

  const JsonFile* file_;
  const Value* value_;
};

}  // namespace cnrg::result
