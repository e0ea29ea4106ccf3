// A JSON text (RFC 8259) as values that know where they stand in it.
//
// Results are read back exactly and every fault is told with its line and column. JSON libraries make numbers
// doubles, take the last of two members with one name, and forget places. Here a value is its kind and the place
// of its first byte; numbers and texts stay in the text until someone asks. The children of a list are in one row
// of the table of values, so that the i-th one is found at once; those of an object, key and value in turn, too.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/base/error.h"

namespace cnrg {

/// What is wrong with a JSON text, and at which byte.
class JsonError : public InputError {
 public:
  JsonError(std::size_t at, const std::string& what) : InputError(what), at_(at) {}
  std::size_t at() const { return at_; }

 private:
  std::size_t at_;
};

/// The line and column of a byte, from 1.
std::pair<int, int> position_in(const std::string& text, std::size_t byte);

class JsonDocument {
 public:
  enum class Kind : std::uint8_t { null, boolean, number, text, list, object };

  struct Value {
    std::uint64_t begin : 60;  ///< of its first byte in the text; of a text after the quotation mark
    std::uint64_t kind_number : 4;
    std::uint32_t first = 0;  ///< of a list or object: where its children are
    std::uint32_t count = 0;  ///< of children, of an object of members; else of bytes
    Kind kind() const { return static_cast<Kind>(kind_number); }
  };

  /// Throws JsonError: no JSON, an object with a member twice, more nested or more values than are counted.
  explicit JsonDocument(std::string text);

  const std::string& text() const { return text_; }
  const Value& root() const { return root_; }
  /// Child i of a list.
  const Value& at(const Value& list, std::size_t i) const { return values_[list.first + i]; }
  const Value& key(const Value& object, std::size_t i) const { return values_[object.first + 2 * i]; }
  const Value& value(const Value& object, std::size_t i) const { return values_[object.first + 2 * i + 1]; }
  /// The member with this key; nullptr if there is none.
  const Value* member(const Value& object, std::string_view key) const;

  /// A number, boolean or text as it is written, escapes and all.
  std::string_view written(const Value& value) const { return {text_.data() + value.begin, value.count}; }
  bool truth(const Value& boolean) const { return written(boolean) == "true"; }
  /// A text without escapes.
  std::string decoded(const Value& text) const;
  bool is_key(const Value& key, std::string_view name) const;

  /// The keys and places that lead to a value, such as `/faces/3/loops`.
  std::string path(const Value& value) const;

 private:
  friend class JsonParser;
  std::string text_;
  std::vector<Value> values_;
  Value root_{};
};

}  // namespace cnrg
