// Values of a YAML document with the place to blame, read strictly: a value is what is wanted or a TreeError.
//
// yaml-cpp neither sees repeated keys nor unknown ones, reads numbers through double, and follows aliases
// without limit. Here maps check their keys, numbers go to `parse_rational` as text, and a document may yield
// only so many values: as many as it has bytes, plus a million for honest aliases.
#pragma once

#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "csg/tree/expression.h"
#include "csg/tree/forms.h"
#include "csg/tree/position.h"
#include "kernel/exact/rational.h"

namespace cnrg {

/// What all values of one document share.
struct Document {
  std::string file;              ///< for messages
  std::size_t values_left = 0;   ///< values that may still be read
  ParameterValues parameters{};  ///< that expressions name
  [[noreturn]] void fail(Position at, const std::string& message) const { throw TreeError(file, at, message); }
};

class Value {
 public:
  /// `key_at` is blamed where the value itself is empty.
  Value(Document& document, const YAML::Node& node, Position key_at);
  Value(const Value&) = default;
  Value& operator=(const Value&) = delete;  // YAML::Node's assignment changes the document

  Position at() const { return at_; }
  const YAML::Node& node() const { return node_; }
  Document& document() const { return *document_; }
  bool is_empty() const { return node_.IsNull(); }
  bool is_text() const { return node_.IsScalar(); }
  bool is_list() const { return node_.IsSequence(); }
  bool is_map() const { return node_.IsMap(); }
  /// The text of a scalar, as it is written, but with values for expressions.
  const std::string& raw() const { return has_expression() ? computed() : node_.Scalar(); }
  /// True for a scalar in quotes; one that is an expression and nothing else stands in quotes for YAML.
  bool is_quoted() const {
    return node_.Tag() == "!" &&
           !(has_expression() && raw_text().starts_with("${") && raw_text().find('}') + 1 == raw_text().size());
  }
  /// The text of a scalar without quotes around it that says true or false.
  std::optional<bool> as_bool() const;

  [[noreturn]] void fail(const std::string& message) const { document_->fail(at_, message); }
  /// Fails with `WHAT must be WANTED, not THIS`.
  [[noreturn]] void fail_type(const std::string& what, const std::string& wanted) const;

  // Typed reading; `what` names the value in messages, such as `radius of sphere`.
  std::string text(const std::string& what) const;
  bool boolean(const std::string& what) const;
  Rational number(const std::string& what) const;
  /// An integer from `low` to `high`.
  std::int64_t integer(const std::string& what, std::int64_t low, std::int64_t high) const;
  std::vector<Value> list(const std::string& what, const std::string& wanted = "a list") const;
  RationalPoint point(const std::string& what) const;           ///< `[x, y, z]`
  std::array<Rational, 2> pair(const std::string& what) const;  ///< `[x, y]`
  /// At least so many points.
  std::vector<RationalPoint> points(const std::string& what, int least = 0) const;
  /// Loops of at least so many points.
  std::vector<std::vector<RationalPoint>> loops(const std::string& what, int least = 0) const;

  struct Entry;
  /// Keys and values of a map in the order of the file; at the place of `<<` those of the maps there that it has
  /// not itself. A repeated key, one that is no text and a map that is merged into itself fail.
  std::vector<Entry> entries(const std::string& what, std::string_view first = "key") const;

 private:
  /// `around`: the maps that this one is merged into.
  std::vector<Entry> entries(const std::string& what, std::vector<YAML::Node>& around) const;
  /// One list of exactly `n` numbers.
  std::vector<Rational> numbers(const std::string& what, std::size_t n, const std::string& wanted) const;
  Document* document_;
  YAML::Node node_;
  Position at_;
  mutable std::shared_ptr<const std::string> computed_{};
  bool has_expression() const { return is_text() && raw_text().find("${") != std::string::npos; }
  const std::string& computed() const;
  const std::string& raw_text() const { return node_.Scalar(); }
};

struct Value::Entry {
  std::string key;
  Position key_at;
  Value value;
};

/// Where the values of a map stand, by their keys; of another value its own place, at the key "".
std::map<std::string, Position> places_of_values(const Value& value);

/// Of maps with known keys: those that other programs read, such as `x-experiment`.
inline bool is_of_others(std::string_view key) { return key.starts_with("x-"); }

/// A map with known keys: those of a form (forms.h).
class Fields {
 public:
  /// Fails for a key that the form has not, naming the nearest, for one that is missing, and for two that exclude
  /// each other. `what` names the map in messages; without it the form does. With `faults` they get what fails.
  Fields(const Value& map, const Form& form, std::string what = {}, Faults* faults = nullptr);
  /// The value of a key, or nullptr.
  const Value* find(std::string_view key) const;
  const Value::Entry* entry(std::string_view key) const;
  /// The value of a key that is required.
  const Value& at(std::string_view key) const;
  bool has(std::string_view key) const { return find(key) != nullptr; }
  /// `KEY of WHAT`.
  std::string name(std::string_view key) const { return "`" + std::string(key) + "` of " + what_; }

  /// Reads the values of keys that are there, as the types that the form has for them: `read("min", min, "max",
  /// max)`. Fails with the faults of all of them.
  template <class... Pairs>
  void read(Pairs&&... pairs) const {
    Faults faults;
    read_into(faults, pairs...);
    faults.raise();
  }
  /// The items of a list, each by `read(item)`; nothing where the key is not there.
  template <class Read>
  void each(std::string_view key, Read read) const {
    if (const Value* value = find(key)) {
      for (const Value& item : value->list(name(key), list_words(key))) read(item);
    }
  }

 private:
  void check_keys(Faults& faults) const;
  void check_presence(Faults& faults) const;
  void check_partners(const Key& key, const Value::Entry& e) const;
  [[noreturn]] void fail_missing(const std::vector<std::string_view>& keys) const;
  /// The value of a key that is there; the form has to have it as one of that kind.
  const Value& value_of(std::string_view key, Type::Kind kind) const;
  std::string list_words(std::string_view key) const;
  void read_text(std::string_view key, std::string& to) const;
  template <class T, class... More>
  void read_into(Faults& faults, std::string_view key, T& to, More&... more) const {
    if (has(key)) faults.attempt([&] { read_value(key, to); });
    if constexpr (sizeof...(more) > 0) read_into(faults, more...);
  }
  template <class T>
  void read_value(std::string_view key, T& to) const {
    using Kind = Type::Kind;
    if constexpr (std::is_same_v<T, Rational>) to = value_of(key, Kind::number).number(name(key));
    else if constexpr (std::is_same_v<T, bool>) to = value_of(key, Kind::boolean).boolean(name(key));
    else if constexpr (std::is_same_v<T, RationalPoint>) to = value_of(key, Kind::point).point(name(key));
    else if constexpr (std::is_same_v<T, std::vector<RationalPoint>>)
      to = value_of(key, Kind::points).points(name(key), form_.find(key)->type->least);
    else if constexpr (std::is_same_v<T, std::string>) read_text(key, to);
    else if constexpr (std::is_same_v<T, int>) {
      const Type& type = *form_.find(key)->type;
      to = static_cast<int>(value_of(key, Kind::count).integer(name(key), type.least, type.most));
    } else to = value_of(key, Kind::loops).loops(name(key), form_.find(key)->type->least);
  }
  template <class T>
  void read_value(std::string_view key, std::optional<T>& to) const {
    read_value(key, to.emplace());
  }

  Value map_;
  const Form& form_;
  std::string what_;
  std::vector<Value::Entry> entries_;
};

/// Parses the text as one YAML document; TreeError with the parser's mark for what is no YAML.
YAML::Node load_yaml(const Document& document, const std::string& text);

}  // namespace cnrg
