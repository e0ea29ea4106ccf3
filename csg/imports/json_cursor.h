// A cursor on a JSON document that knows its path, so that each fault names its place.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "csg/leaves/leaf.h"
#include "csg/text/number.h"

namespace cnrg::result {

using Json = nlohmann::json;
using Index = std::uint32_t;

[[noreturn]] inline void refuse(const std::string& file, const std::string& path, const std::string& what) {
  throw LeafFileError(file + ": error: " + (path.empty() ? "" : path + ": ") + what);
}
inline constexpr const char* kAgain = "; write the file again with `cnrg eval -o`";

/// A value of the document and the way to it.
class Cursor {
 public:
  Cursor(const std::string& file, const Json& value, std::string path = "")
      : file_(&file), value_(&value), path_(std::move(path)) {}

  [[noreturn]] void fail(const std::string& what) const { refuse(*file_, path_, what); }
  const std::string& path() const { return path_; }
  bool is_null() const { return value_->is_null(); }
  std::size_t size() const { return value_->size(); }

  Cursor member(const char* key) const {
    if (!value_->is_object()) fail(std::string("an object is needed here") + kAgain);
    const auto found = value_->find(key);
    if (found == value_->end()) fail("`" + std::string(key) + "` is missing" + kAgain);
    return {*file_, *found, path_ + "/" + key};
  }
  bool has(const char* key) const { return value_->is_object() && value_->contains(key); }
  Cursor at(std::size_t i) const { return {*file_, (*value_)[i], path_ + "/" + std::to_string(i)}; }
  /// The value must be an array.
  const Cursor& array() const {
    if (!value_->is_array()) fail(std::string("a list is needed here") + kAgain);
    return *this;
  }
  /// The number of a thing, below `limit`; `what` is the thing's name in messages.
  Index number(std::size_t limit, const char* what) const {
    if (!value_->is_number_unsigned()) fail(std::string("the number of a ") + what + " is needed here" + kAgain);
    const auto n = value_->get<std::uint64_t>();
    if (n >= limit) {
      fail(std::string(what) + " " + std::to_string(n) + " does not exist: there are " + std::to_string(limit) +
           kAgain);
    }
    return Index(n);
  }
  bool boolean() const {
    if (!value_->is_boolean()) fail(std::string("true or false is needed here") + kAgain);
    return value_->get<bool>();
  }
  std::string text() const {
    if (!value_->is_string()) fail(std::string("a text is needed here") + kAgain);
    return value_->get<std::string>();
  }
  RationalPoint point() const {
    if (array().size() != 3) fail(std::string("a point has three coordinates") + kAgain);
    return {at(0).rational(), at(1).rational(), at(2).rational()};
  }
  /// Calls `see` with each member of an object and its key, in the order of the keys.
  template <class See>
  void each_member(See see) const {
    if (!value_->is_object()) fail(std::string("an object is needed here") + kAgain);
    for (const auto& [key, value] : value_->items()) see(key, Cursor(*file_, value, path_ + "/" + key));
  }
  Rational rational() const {
    if (value_->is_number_integer()) return *parse_rational(value_->dump());
    if (value_->is_string()) {
      const auto& text = value_->get_ref<const std::string&>();
      if (auto number = read_number(text, kMostResultDigits).value) return std::move(*number);
      if (text.size() > kMostResultDigits) fail(read_number(text, kMostResultDigits).fault);
    }
    fail("an exact number is needed here, such as \"3\", \"0.25\" or \"121/3\"");
  }

 private:
  const std::string* file_;
  const Json* value_;
  std::string path_;
};

}  // namespace cnrg::result
