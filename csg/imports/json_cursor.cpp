// Numbers are read by hand: those of cells are most of a file, and exact ones must not pass through doubles.
#include "csg/imports/json_cursor.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "csg/imports/text_cursor.h"
#include "csg/text/number.h"

namespace cnrg::result {
namespace {

/// `0`, or digits that do not begin with it.
bool is_count(std::string_view text) {
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  return !text.empty() && std::all_of(text.begin(), text.end(), digit) && (text[0] != '0' || text.size() == 1);
}

}  // namespace

void Cursor::fail(const std::string& what) const {
  const std::string path = json().path(*value_);
  const auto [line, column] = position_in(json().text(), value_->begin - (value_->kind() == Kind::text ? 1 : 0));
  throw LeafFileError(file_->name, line, column, (path.empty() ? "" : path + ": ") + what);
}

const Cursor& Cursor::object() const {
  if (value_->kind() != Kind::object) refuse("an object is needed here");
  return *this;
}

std::string Cursor::shown() const {
  constexpr std::size_t kMost = 12;
  if (value_->kind() == Kind::text) return in_quotes(json().written(*value_));
  const bool list = value_->kind() == Kind::list;
  if (!list && value_->kind() != Kind::object) return std::string(json().written(*value_));
  std::string all;
  for (std::size_t i = 0; i < value_->count && i <= kMost; ++i) {
    all += i == 0 ? "" : ", ";
    if (i == kMost) all += "...";
    else if (list) all += at(i).shown();
    else all += json().decoded(json().key(*value_, i)) + ": " + Cursor(*file_, json().value(*value_, i)).shown();
  }
  return (list ? "[" : "{") + all + (list ? "]" : "}");
}

void Cursor::require_same(const Cursor& made, std::initializer_list<const char*> but) const {
  static const std::string kBy = "by the cells of the file ";
  const auto require = [&](bool same) {
    if (!same) refuse(kBy + "this is " + made.shown());
  };
  require(value_->kind() == made.value_->kind());
  if (value_->kind() == Kind::list) {
    for (std::size_t i = 0; i < size(); ++i) {
      if (i == made.size()) at(i).refuse(kBy + "nothing stands here");
      at(i).require_same(made.at(i), but);
    }
    if (size() < made.size()) refuse(kBy + made.at(size()).shown() + " stands behind the last entry");
  } else if (value_->kind() == Kind::object) {
    made.each_member([&](const std::string& key, const Cursor&) { member(key.c_str()); });
    each_member([&](const std::string& key, const Cursor& value) {
      if (std::find(but.begin(), but.end(), key) != but.end()) return;
      if (!made.has(key.c_str()))
        value.fail("no member of results is called " + in_quotes(key) + " here; remove it");
      value.require_same(made.member(key.c_str()), but);
    });
  } else if (value_->kind() == Kind::text) {
    require(text() == made.text());
  } else {
    require(json().written(*value_) == made.json().written(*made.value_));
  }
}

Cursor Cursor::member(const char* key) const {
  const Value* found = json().member(*object().value_, key);
  if (found == nullptr) refuse("`" + std::string(key) + "` is missing");
  return {*file_, *found};
}

const Cursor& Cursor::array() const {
  if (value_->kind() != Kind::list) refuse("a list is needed here");
  return *this;
}

const Cursor& Cursor::array_of(std::size_t count, const char* what) const {
  if (array().size() != count) refuse(what);
  return *this;
}

Index Cursor::number(std::size_t limit, const char* what) const {
  const std::string_view text = value_->kind() == Kind::number ? json().written(*value_) : std::string_view();
  if (!is_count(text)) refuse(std::string("the number of a ") + what + " is needed here");
  std::uint64_t n = 0;
  const bool fits = std::from_chars(text.data(), text.data() + text.size(), n).ec == std::errc();
  if (!fits || n >= limit) {
    const std::string known = limit == 0   ? "there are none"
                              : limit == 1 ? "the only number is 0"
                                           : "numbers are 0 to " + std::to_string(limit - 1);
    refuse(std::string(what) + " " + std::string(text.substr(0, 20)) + " does not exist: " + known);
  }
  return Index(n);
}

bool Cursor::boolean() const {
  if (value_->kind() != Kind::boolean) refuse("true or false is needed here");
  return json().truth(*value_);
}

std::string Cursor::text() const {
  if (value_->kind() != Kind::text) refuse("a text is needed here");
  return json().decoded(*value_);
}

Rational Cursor::rational() const {
  const std::string_view text = value_->kind() == Kind::text ? json().written(*value_) : std::string_view();
  if (text.size() > kMostResultDigits) fail("this number" + read_number(text, kMostResultDigits).fault);
  const std::size_t slash = std::min(text.find('/'), text.size());
  const std::string_view above = text.substr(0, slash), below = text.substr(std::min(slash + 1, text.size()));
  const std::string_view digits = above.starts_with('-') ? above.substr(1) : above;
  if (!is_count(digits) || above == "-0" || (slash < text.size() && (!is_count(below) || below == "0"))) {
    refuse("an exact number is needed here, in quotation marks: \"3\", \"-1/4\" or \"121/3\"");
  }
  Rational value;
  value.get_num().set_str(std::string(above), 10);
  if (slash == text.size()) return value;
  value.get_den().set_str(std::string(below), 10);
  if (below == "1" || gcd(value.get_num(), value.get_den()) != 1) {
    value.canonicalize();
    refuse("fractions are in lowest terms; this one is " + in_quotes(to_string(value)));
  }
  return value;
}

RationalPoint Cursor::point() const {
  array_of(3, "a point has three coordinates");
  RationalPoint p{at(0).rational(), at(1).rational(), at(2).rational()};
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::isinf(to_double(p[k])))
      at(k).fail("this is larger than 1.797e308, the largest double; use a larger unit of length");
  }
  return p;
}

}  // namespace cnrg::result
