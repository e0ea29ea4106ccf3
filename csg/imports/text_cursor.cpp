// Tokens and numbers of text files, one pass, without copies.
#include "csg/imports/text_cursor.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "csg/leaves/leaf.h"
#include "csg/text/escape.h"
#include "csg/text/input_file.h"
#include "csg/text/number.h"

namespace cnrg {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

}  // namespace

TextCursor::TextCursor(std::string path, std::string_view text, char comment, int line)
    : path_(std::move(path)),
      begin_(text.data()),
      at_(without_mark(text).data()),
      end_(text.data() + text.size()),
      first_line_(line),
      line_(line),
      comment_(comment) {}

bool TextCursor::more_in_line() {
  while (at_ != end_ && is_blank(*at_)) ++at_;
  if (at_ != end_ && comment_ != 0 && *at_ == comment_) {
    while (at_ != end_ && *at_ != '\n') ++at_;
  }
  return at_ != end_ && *at_ != '\n';
}

bool TextCursor::more() {
  while (!more_in_line()) {
    if (at_ == end_) return false;
    ++at_;
    ++line_;
  }
  return true;
}

void TextCursor::next_line() {
  while (at_ != end_ && *at_ != '\n') ++at_;
  if (at_ != end_) {
    ++at_;
    ++line_;
  }
}

std::string_view TextCursor::token_in_line() {
  if (!more_in_line()) return {};
  const char* start = at_;
  while (at_ != end_ && *at_ != '\n' && !is_blank(*at_)) ++at_;
  return {start, static_cast<std::size_t>(at_ - start)};
}

int TextCursor::tokens_left(int most) {
  const char* const here = at_;
  int count = 0;
  while (count < most && !token_in_line().empty()) ++count;
  at_ = here;
  return count;
}

std::string_view TextCursor::token(const char* wanted) {
  if (!more()) fail_at_end(std::string("the file ends where ") + wanted + " is expected");
  return token_in_line();
}

std::string_view TextCursor::bytes(std::size_t count) {
  const std::string_view found(at_, std::min(count, static_cast<std::size_t>(end_ - at_)));
  at_ += found.size();
  return found;
}

long long TextCursor::integer(const char* wanted) {
  const std::string_view text = token(wanted);
  return integer(text, wanted, text.size() > 1 && text[0] == '+' ? 1 : 0);
}

long long TextCursor::integer(std::string_view taken, const char* wanted, std::size_t from) const {
  long long value = 0;
  const char* const last = taken.data() + taken.size();
  const auto [end, error] = std::from_chars(taken.data() + from, last, value);
  if (error != std::errc() || end != last) {
    fail(in_quotes(taken) + " is no whole number, " + wanted + " is expected: correct it");
  }
  return value;
}

double TextCursor::number(const char* wanted) { return parse(token(wanted), wanted, nullptr); }

double TextCursor::decimal(const char* wanted, Rational& exact) { return parse(token(wanted), wanted, &exact); }

double TextCursor::parse(std::string_view text, const char* wanted, Rational* exact) const {
  const char* first = text.data() + (text.size() > 1 && text[0] == '+' && text[1] != '-' ? 1 : 0);
  const char* last = text.data() + text.size();
  double value = 0;
  const auto [end, error] = std::from_chars(first, last, value);
  const bool whole = end == last;
  if (whole && error == std::errc() && !std::isfinite(value)) {
    fail(in_quotes(text) + " is no finite number, " + wanted + " is expected: correct the file");
  }
  if (whole && error == std::errc() && !exact) return value;
  if (!whole && !exact) fail(in_quotes(text) + " is no number, " + wanted + " is expected: correct it");
  // Exact decimals, and numbers beyond the range of double (tiny ones are 0).
  NumberText number = read_number(text);
  if (!number.value) fail(in_quotes(text) + number.fault + ", " + wanted + " is expected: correct it");
  value = to_double(*number.value);
  if (!std::isfinite(value))
    fail(in_quotes(text) + " is beyond the largest double (1.8e308): use a larger unit of length");
  if (exact) *exact = std::move(*number.value);
  return value;
}

void TextCursor::coordinates(MeshData& mesh, bool decimals) {
  if (!decimals) {
    const double x = number("a coordinate"), y = number("a coordinate"), z = number("a coordinate");
    mesh.xyz.insert(mesh.xyz.end(), {x, y, z});
    return;
  }
  RationalPoint p;
  bool doubles = true;
  for (Rational& x : p) {
    mesh.xyz.push_back(decimal("a coordinate", x));
    doubles = doubles && is_double(x);
  }
  if (!doubles) mesh.exact.emplace_back(static_cast<std::uint32_t>(mesh.point_count() - 1), std::move(p));
}

void TextCursor::fail_at_end(const std::string& text) const {
  const std::string_view all(begin_, static_cast<std::size_t>(end_ - begin_));
  const std::string_view content = all.substr(0, all.find_last_not_of(" \t\r\n") + 1);
  const auto line = first_line_ + std::count(content.begin(), content.end(), '\n');
  fail_at(static_cast<int>(line), text + ": it is truncated, or a count is wrong; write the file again");
}

void TextCursor::fail_at(int line, const std::string& text) const { throw LeafFileError(path_, line, 0, text); }

std::string lower(std::string_view word) {
  std::string text(word);
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::string in_quotes(std::string_view token) { return "'" + excerpt(token) + "'"; }

}  // namespace cnrg
