// One pass over the text. Lists and objects that are open are on a stack of their own, so that no depth costs the
// stack of the program; children wait until theirs is closed and then move to one row.
#include "csg/text/json_document.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "csg/text/escape.h"
#include "csg/text/input_file.h"

namespace cnrg {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

void append_utf8(std::string& out, unsigned code) {
  const auto add = [&](unsigned byte) { out += static_cast<char>(byte); };
  if (code < 0x80) return add(code);
  if (code < 0x800) return add(0xc0 | code >> 6), add(0x80 | (code & 63));
  if (code < 0x10000) return add(0xe0 | code >> 12), add(0x80 | (code >> 6 & 63)), add(0x80 | (code & 63));
  add(0xf0 | code >> 18), add(0x80 | (code >> 12 & 63)), add(0x80 | (code >> 6 & 63)), add(0x80 | (code & 63));
}

/// The code of `XXXX` behind `\u`; nothing if these are no four hexadecimal digits.
std::optional<unsigned> hex_code(std::string_view text) {
  unsigned code = 0;
  if (text.size() < 4) return std::nullopt;
  const auto [end, error] = std::from_chars(text.data(), text.data() + 4, code, 16);
  if (error != std::errc() || end != text.data() + 4) return std::nullopt;
  return code;
}

/// A character behind `\`, of which `text` is the rest: its code and the number of bytes it takes; 0 bytes if it
/// is none. Characters beyond the 16 bits of `\u` are two of these, a high and a low surrogate.
std::pair<unsigned, std::size_t> escape_code(std::string_view text) {
  static constexpr std::string_view kLetters = "\"\\/bfnrt", kMeaning = "\"\\/\b\f\n\r\t";
  if (text.empty()) return {0, 0};
  if (const auto i = kLetters.find(text[0]); i != std::string_view::npos) {
    return {static_cast<unsigned char>(kMeaning[i]), 1};
  }
  if (text[0] != 'u') return {0, 0};
  const auto high = hex_code(text.substr(1));
  if (!high || (*high >= 0xdc00 && *high <= 0xdfff)) return {0, 0};
  if (*high < 0xd800 || *high > 0xdfff) return {*high, 5};
  if (text.substr(5, 2) != "\\u") return {0, 0};
  const auto low = hex_code(text.substr(7));
  if (!low || *low < 0xdc00 || *low > 0xdfff) return {0, 0};
  return {0x10000 + ((*high - 0xd800) << 10) + (*low - 0xdc00), 11};
}

}  // namespace

class JsonParser {
 public:
  explicit JsonParser(JsonDocument& document) : document_(document), text_(document.text_) {}

  void run() {
    at_ = text_.size() - without_mark(text_).size();
    blanks();
    while (step()) blanks();
    blanks();
    if (at_ != text_.size()) fail();
    document_.root_ = waiting_.back();
  }

 private:
  using Kind = JsonDocument::Kind;
  using Value = JsonDocument::Value;
  static constexpr std::size_t kDeepest = 1000;

  struct Open {
    Kind kind;
    std::size_t begin;
    std::size_t first;  // of its children, in `waiting_`
  };

  [[noreturn]] void fail() const {
    throw JsonError(at_, "this is no JSON text from here on: the file may be cut short");
  }

  char here() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void blanks() {
    while (at_ < text_.size() &&
           (text_[at_] == ' ' || text_[at_] == '\n' || text_[at_] == '\r' || text_[at_] == '\t'))
      ++at_;
  }
  void take(char wanted) {
    if (here() != wanted) fail();
    ++at_;
  }
  void wait(Kind kind, std::size_t begin, std::size_t count, std::size_t first = 0) {
    if (!std::in_range<std::uint32_t>(count) || !std::in_range<std::uint32_t>(first)) {
      throw JsonError(begin, "there are more than 2^32 values or bytes in a text here; no result is that large");
    }
    Value value{};
    value.begin = begin;
    value.kind_number = static_cast<std::uint64_t>(kind);
    value.first = static_cast<std::uint32_t>(first);
    value.count = static_cast<std::uint32_t>(count);
    waiting_.push_back(value);
  }

  // Takes a value, or opens it, and closes all that end with it. False when the outermost one is complete.
  bool step() {
    const char c = here();
    if (c == '{' || c == '[') {
      if (open_.size() == kDeepest)
        throw JsonError(at_, "more than 1000 lists in each other; no result is that deep");
      open_.push_back({c == '{' ? Kind::object : Kind::list, at_, waiting_.size()});
      ++at_;
      blanks();
      if (here() == (c == '{' ? '}' : ']')) return close();
      if (c == '{') take_key();
      return true;
    }
    take_scalar(c);
    return after_value();
  }

  bool after_value() {
    blanks();
    if (open_.empty()) return false;
    const bool object = open_.back().kind == Kind::object;
    if (here() == (object ? '}' : ']')) return close();
    take(',');
    blanks();
    if (object) take_key();
    return true;
  }

  bool close() {
    ++at_;
    const Open open = open_.back();
    open_.pop_back();
    const std::size_t first = document_.values_.size(), count = waiting_.size() - open.first;
    document_.values_.insert(document_.values_.end(), waiting_.begin() + std::ptrdiff_t(open.first),
                             waiting_.end());
    waiting_.resize(open.first);
    const bool object = open.kind == Kind::object;
    wait(open.kind, open.begin, object ? count / 2 : count, first);
    if (object) require_distinct_keys(waiting_.back());
    return after_value();
  }

  void require_distinct_keys(const Value& object) {
    keys_.clear();
    for (std::size_t i = 0; i < object.count; ++i) keys_.push_back(&document_.key(object, i));
    const auto name = [&](const Value* key) { return document_.decoded(*key); };
    if (keys_.size() <= 16) {  // as nearly all have: cheaper than names in order
      for (std::size_t i = 1; i < keys_.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
          if (document_.written(*keys_[i]) == document_.written(*keys_[k]) ||
              (escapes(*keys_[i]) + escapes(*keys_[k]) != 0 && name(keys_[i]) == name(keys_[k]))) {
            twice(*keys_[i]);
          }
        }
      }
      return;
    }
    std::vector<std::pair<std::string, const Value*>> names;
    for (const Value* key : keys_) names.emplace_back(name(key), key);
    std::sort(names.begin(), names.end());
    const auto same = std::adjacent_find(names.begin(), names.end(),
                                         [](const auto& a, const auto& b) { return a.first == b.first; });
    if (same != names.end()) twice(*std::next(same)->second);
  }
  bool escapes(const Value& key) const { return document_.written(key).find('\\') != std::string_view::npos; }
  [[noreturn]] static void twice(const Value& key) {
    throw JsonError(key.begin - 1, "the object has this member twice; remove one");
  }

  void take_key() {
    if (here() != '"') fail();
    take_text();
    blanks();
    take(':');
    blanks();
  }

  void take_scalar(char c) {
    if (c == '"') return take_text();
    const std::size_t begin = at_;
    const auto word = [&](std::string_view wanted, Kind kind) {
      if (text_.compare(at_, wanted.size(), wanted) != 0) fail();
      at_ += wanted.size();
      wait(kind, begin, wanted.size());
    };
    if (c == 't') return word("true", Kind::boolean);
    if (c == 'f') return word("false", Kind::boolean);
    if (c == 'n') return word("null", Kind::null);
    if (c == '-') ++at_;
    if (here() == '0') ++at_;
    else digits();
    if (here() == '.') ++at_, digits();
    if (here() == 'e' || here() == 'E') {
      ++at_;
      if (here() == '+' || here() == '-') ++at_;
      digits();
    }
    wait(Kind::number, begin, at_ - begin);
  }
  void digits() {
    if (!is_digit(here())) fail();
    while (is_digit(here())) ++at_;
  }

  void take_text() {
    const std::size_t begin = ++at_;
    for (;;) {
      const auto c = static_cast<unsigned char>(here());
      if (c == '"') break;
      if (c < 0x20) fail();  // the end, too
      std::size_t length = 1;
      if (c == '\\') {
        const std::size_t taken = escape_code(std::string_view(text_).substr(at_ + 1, 11)).second;
        length = taken == 0 ? 0 : taken + 1;
      } else if (c >= 0x80) {
        const Character character = first_character(std::string_view(text_).substr(at_, 4));
        length = character.valid ? character.length : 0;
      }
      if (length == 0) fail();
      at_ += length;
    }
    wait(Kind::text, begin, at_ - begin);
    ++at_;
  }

  JsonDocument& document_;
  const std::string& text_;
  std::size_t at_ = 0;
  std::vector<Open> open_;
  std::vector<Value> waiting_;  // children of what is open, complete themselves
  std::vector<const Value*> keys_;
};

JsonDocument::JsonDocument(std::string text) : text_(std::move(text)) { JsonParser(*this).run(); }

bool JsonDocument::is_key(const Value& key, std::string_view name) const {
  const std::string_view here = written(key);
  return here == name || (here.find('\\') != std::string_view::npos && decoded(key) == name);
}

const JsonDocument::Value* JsonDocument::member(const Value& object, std::string_view name) const {
  for (std::size_t i = 0; i < object.count; ++i) {
    if (is_key(key(object, i), name)) return &value(object, i);
  }
  return nullptr;
}

std::string JsonDocument::decoded(const Value& text) const {
  std::string_view rest = written(text);
  std::string out;
  for (std::size_t plain; (plain = rest.find('\\')) != std::string_view::npos;) {
    out += rest.substr(0, plain);
    const auto [code, length] = escape_code(rest.substr(plain + 1));
    append_utf8(out, code);
    rest.remove_prefix(plain + 1 + length);
  }
  return out += rest;
}

std::string JsonDocument::path(const Value& wanted) const {
  std::string out;
  const Value* at = &root_;
  while (at != &wanted && at->count > 0 && (at->kind() == Kind::list || at->kind() == Kind::object)) {
    // The last child that begins no later is the one that holds it.
    const bool object = at->kind() == Kind::object;
    const std::size_t step = object ? 2 : 1;
    std::size_t low = 0, high = at->count;
    while (high - low > 1) {
      const std::size_t middle = (low + high) / 2;
      (values_[at->first + step * middle].begin <= wanted.begin ? low : high) = middle;
    }
    out += '/';
    if (object) out += written(key(*at, low));
    else out += std::to_string(low);
    if (object && &key(*at, low) == &wanted) break;
    at = object ? &value(*at, low) : &this->at(*at, low);
  }
  return out;
}

std::pair<int, int> position_in(const std::string& text, std::size_t byte) {
  byte = std::min(byte, text.size());
  const auto line = 1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(byte), '\n');
  const std::size_t newline = byte == 0 ? std::string::npos : text.rfind('\n', byte - 1);
  return {static_cast<int>(line), static_cast<int>(newline == std::string::npos ? byte + 1 : byte - newline)};
}

}  // namespace cnrg
