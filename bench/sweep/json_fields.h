// Members of JSON objects, read strictly: each fault names the member.
#pragma once

#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace cnrg::bench {

/// An object that must have the members that are asked for, of the right type; others are not looked at.
/// Everything throws std::runtime_error with the member's name.
class JsonFields {
 public:
  /// `name` is what the object is called in messages, such as `row`.
  JsonFields(const nlohmann::json& object, std::string name) : object_(object), name_(std::move(name)) {
    if (!object.is_object()) throw std::runtime_error(name_ + " is no JSON object");
  }
  const nlohmann::json& at(const char* key) const {
    const auto found = object_.find(key);
    if (found == object_.end()) throw std::runtime_error(name_ + " has no member `" + key + "`");
    return *found;
  }
  bool is_null(const char* key) const { return at(key).is_null(); }
  std::string text(const char* key) const {
    if (!at(key).is_string()) fail(key, "a text");
    return at(key).get<std::string>();
  }
  bool flag(const char* key) const {
    if (!at(key).is_boolean()) fail(key, "true or false");
    return at(key).get<bool>();
  }
  /// Finite, by JSON's own rules.
  double number(const char* key) const {
    if (!at(key).is_number()) fail(key, "a number");
    return at(key).get<double>();
  }
  /// `null` for not a number: what is not finite has no other form in JSON.
  double number_or_nan(const char* key) const {
    return is_null(key) ? std::numeric_limits<double>::quiet_NaN() : number(key);
  }
  double not_negative(const char* key) const {
    const double value = number(key);
    if (!(value >= 0)) fail(key, "a number from 0");
    return value;
  }
  template <class Integer>
  Integer integer(const char* key) const {
    const nlohmann::json& value = at(key);
    if (!value.is_number_integer()) fail(key, "a whole number");
    if (value.is_number_unsigned()) {
      const auto number = value.get<std::uint64_t>();
      if (number > std::uint64_t(std::numeric_limits<Integer>::max())) fail(key, "a number in its range");
      return static_cast<Integer>(number);
    }
    const auto number = value.get<std::int64_t>();
    if (number < 0 &&
        (!std::numeric_limits<Integer>::is_signed || number < std::int64_t(std::numeric_limits<Integer>::min()))) {
      fail(key, "a number in its range");
    }
    return static_cast<Integer>(number);
  }
  const nlohmann::json& list(const char* key) const {
    if (!at(key).is_array()) fail(key, "a list");
    return at(key);
  }
  const nlohmann::json& object(const char* key) const {
    if (!at(key).is_object()) fail(key, "an object");
    return at(key);
  }
  [[noreturn]] void fail(const char* key, const char* expected) const {
    throw std::runtime_error("member `" + std::string(key) + "` of " + name_ + " is not " + expected);
  }

 private:
  const nlohmann::json& object_;
  std::string name_;
};

/// The text of a JSON value. Throws std::runtime_error with the place of a fault.
inline nlohmann::json parse_json(const std::string& text) {
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::exception& e) {
    const std::string what =
        e.what();  // "[json.exception.parse_error.101] parse error at ...": the class says nothing
    const std::size_t bracket = what.find("] ");
    throw std::runtime_error("no JSON: " + (bracket == std::string::npos ? what : what.substr(bracket + 2)));
  }
}

/// Bytes that are no UTF-8, as messages of crashed programs have them, are replaced.
template <class Json>
std::string json_text(const Json& value, int indent = -1) {
  return value.dump(indent, ' ', true, Json::error_handler_t::replace);
}

}  // namespace cnrg::bench
