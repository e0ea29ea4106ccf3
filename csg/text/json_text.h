// JSON as text, member by member. A file has hundreds of thousands of them: to build them first as values of a
// JSON library would take most of the time of writing it.
#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "csg/text/digits.h"

namespace cnrg {

template <class T>
requires std::is_integral_v<T>
void append_json(std::string& text, T value) { Line(text) << value; }

/// A text in quotation marks, hostile characters (escape.h) as escapes; U+FFFD stands for a byte that is no UTF-8.
void append_json(std::string& text, std::string_view value);
inline void append_json(std::string& text, const char* value) { append_json(text, std::string_view(value)); }
inline void append_json(std::string& text, const std::string& value) {
  append_json(text, std::string_view(value));
}

/// A list, each item by `write(item)`.
template <class Text, class List, class Write>
void append_json(Text& text, const List& list, Write write) {
  char before = '[';
  for (const auto& item : list) {
    text += before;
    write(item);
    before = ',';
  }
  text += before == '[' ? "[]" : "]";
}

/// A list of numbers or of lists of them.
template <class List>
void append_json(Line& line, const List& list) {
  char before = '[';
  for (const auto& item : list) {
    line << std::exchange(before, ',');
    if constexpr (std::is_integral_v<std::remove_cvref_t<decltype(item)>>) line << item;
    else append_json(line, item);
  }
  if (before == '[') line << before;
  line << ']';
}
template <class List>
requires requires(const List& list) { list.begin(); }
void append_json(std::string& text, const List& list) {
  Line line(text);
  append_json(line, list);
}

/// An object at the end of a text, closed when this goes.
class JsonObject {
 public:
  explicit JsonObject(std::string& text) : text_(text) { text_ += '{'; }
  ~JsonObject() { text_ += '}'; }
  JsonObject(const JsonObject&) = delete;
  JsonObject& operator=(const JsonObject&) = delete;

  /// Adds a key, a word of letters; its value is to be appended to the text returned.
  std::string& key(std::string_view name) {
    Line line(text_);
    put(line, name);
    return text_;
  }
  /// The same for a key of any letters and length.
  std::string& named(std::string_view name) {
    if (text_.back() != '{') text_ += ',';
    append_json(text_, name);
    return text_ += ':';
  }
  template <class T>
  JsonObject& add(std::string_view name, const T& value) {
    if constexpr (std::is_integral_v<T>) {
      Line line(text_);
      put(line, name);
      line << value;
    } else {
      append_json(key(name), value);
    }
    return *this;
  }

 private:
  void put(Line& line, std::string_view name) const {
    if (text_.back() != '{') line << ',';
    line << '"' << name << "\":";
  }
  std::string& text_;
};

}  // namespace cnrg
