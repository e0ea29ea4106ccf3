// A recursive descent over the text, bounded in depth.
#include "csg/openscad/statement.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "csg/leaves/leaf.h"
#include "csg/text/escape.h"
#include "csg/text/input_file.h"
#include "csg/text/number.h"

namespace cnrg::openscad {
namespace {

constexpr int kDeepest = 1'000;  // statements and lists within each other

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '$'; }

class Parser {
 public:
  Parser(const std::string& path, std::string_view text) : path_(path), rest_(without_mark(text)) {}

  std::vector<Statement> file() {
    std::vector<Statement> out;
    while (more()) statement(out, 0);
    return out;
  }

 private:
  [[noreturn]] void fail(const std::string& fault) const { throw LeafFileError(path_, line_, column_, fault); }
  [[noreturn]] void fail_wanted(const std::string& wanted) const {
    fail(wanted + " is expected here, not " +
         (rest_.empty() ? "the end of the file" : "`" + excerpt(rest_.substr(0, rest_.find('\n'))) + "`") +
         "; a .csg file is what `openscad -o model.csg model.scad` writes");
  }
  void check_depth(int depth) const {
    if (depth > kDeepest) fail("more than 1,000 statements or lists stand in each other here; write fewer levels");
  }

  void skip(std::size_t count) {
    for (const char c : rest_.substr(0, count)) {
      column_ = c == '\n' ? 1 : column_ + 1;
      line_ += c == '\n';
    }
    rest_.remove_prefix(std::min(count, rest_.size()));
  }
  /// Skips blanks and comments; false at the end of the file.
  bool more() {
    while (!rest_.empty()) {
      if (std::isspace(static_cast<unsigned char>(rest_.front()))) skip(1);
      else if (rest_.starts_with("//")) skip(rest_.find('\n'));
      else if (rest_.starts_with("/*")) skip_comment();
      else return true;
    }
    return false;
  }
  void skip_comment() {
    const std::size_t end = rest_.find("*/", 2);
    if (end == std::string_view::npos) fail("this comment has no end; add `*/`");
    skip(end + 2);
  }
  bool at(char c) { return more() && rest_.front() == c; }
  bool take(char c) {
    if (!at(c)) return false;
    skip(1);
    return true;
  }
  void expect(char c) {
    if (!take(c)) fail_wanted(std::string("`") + c + "`");
  }
  std::string word() {
    const auto end = std::find_if_not(rest_.begin(), rest_.end(), is_word);
    const std::string out(rest_.begin(), end);
    skip(out.size());
    return out;
  }

  void statement(std::vector<Statement>& out, int depth) {
    check_depth(depth);
    if (take(';')) return;
    Statement made;
    bool hidden = false;
    for (; more() && std::string_view("%#!*").find(rest_.front()) != std::string_view::npos; skip(1)) {
      hidden = hidden || rest_.front() == '%' || rest_.front() == '*';
      made.is_root = made.is_root || rest_.front() == '!';
    }
    made.line = line_;
    made.column = column_;
    made.name = more() ? word() : "";
    if (made.name.empty()) fail_wanted("the name of a module such as `cube`");
    if (!at('(')) fail_wanted("`(` behind `" + excerpt(made.name) + "`");
    made.arguments = arguments(depth);
    if (take('{')) {
      while (more() && rest_.front() != '}') statement(made.children, depth + 1);
      expect('}');
    } else if (!take(';')) {
      statement(made.children, depth + 1);
    }
    if (!hidden) out.push_back(std::move(made));
  }

  std::vector<Argument> arguments(int depth) {
    std::vector<Argument> out;
    expect('(');
    while (!take(')')) {
      if (!out.empty()) {
        expect(',');
        if (take(')')) break;
      }
      more();
      Argument made;
      made.line = line_;
      made.column = column_;
      const Parser before = *this;
      made.name = word();
      if (made.name.empty() || !take('=')) {
        *this = before;
        made.name.clear();
      }
      made.value = literal(depth + 1);
      out.push_back(std::move(made));
    }
    return out;
  }

  Literal literal(int depth) {
    check_depth(depth);
    if (!more()) fail_wanted("a value");
    if (rest_.front() == '[') return list(depth);
    if (rest_.front() == '"') return {Literal::Kind::text, 0, quoted()};
    return scalar();
  }

  Literal list(int depth) {
    Literal out{Literal::Kind::list};
    expect('[');
    while (!take(']')) {
      if (!out.items.empty()) {
        expect(',');
        if (take(']')) break;
      }
      out.items.push_back(literal(depth + 1));
    }
    return out;
  }

  std::string quoted() {
    std::string out;
    for (skip(1); !rest_.starts_with('"'); skip(1)) {
      if (rest_.starts_with('\\')) {
        skip(1);
        const std::size_t letter = std::string_view("ntr").find(rest_.substr(0, 1));
        out += rest_.empty() ? ""
               : letter < 3  ? std::string(1, "\n\t\r"[letter])
                             : std::string(rest_.substr(0, 1));
      } else {
        out += rest_.substr(0, 1);
      }
      if (rest_.empty()) fail_wanted("`\"` at the end of a text");
    }
    skip(1);
    return out;
  }

  Literal scalar() {
    const std::string_view text =
        rest_.substr(0, std::min(rest_.size(), rest_.find_first_of(" \t\r\n,;()[]{}=\"")));
    const std::string_view plain = text.starts_with('-') ? text.substr(1) : text;
    Literal out{Literal::Kind::number};
    if (text == "undef") out.kind = Literal::Kind::undefined;
    else if (text == "true" || text == "false") out = {Literal::Kind::boolean, text == "true" ? 1.0 : 0.0};
    else if (plain == "nan") out.number = std::numeric_limits<double>::quiet_NaN();
    else if (plain == "inf") out.number = std::numeric_limits<double>::infinity() * (text == plain ? 1 : -1);
    else if (const NumberText read = read_number(text); read.value && text.find('/') == std::string_view::npos)
      out.number = to_double(*read.value);
    else fail_wanted("a number, a text, a list, `true`, `false` or `undef`");
    skip(text.size());
    return out;
  }

  std::string path_;
  std::string_view rest_;
  int line_ = 1, column_ = 1;
};

}  // namespace

// Typed reading of arguments: what is wanted or an error at the statement.

void fail(const std::string& path, const Statement& at, const std::string& fault) {
  throw LeafFileError(path, at.line, at.column, "`" + excerpt(at.name) + "` " + fault);
}

Arguments::Arguments(const std::string& path, const Statement& statement,
                     std::initializer_list<std::string_view> known)
    : path_(path), statement_(statement), first_(known.size() == 0 ? std::string_view() : *known.begin()) {
  constexpr std::array<std::string_view, 4> kAlways{"$fn", "$fa", "$fs", "convexity"};
  std::set<std::string_view> seen;
  for (const Argument& argument : statement.arguments) {
    const bool named = !argument.name.empty();
    const bool is_first = !named && !first_.empty() && &argument == &statement.arguments.front();
    const std::string_view name = is_first ? first_ : argument.name;
    if ((named || is_first) && !seen.insert(name).second)
      fail(path, statement, "has the argument `" + excerpt(name) + "` twice; remove one");
    if (is_first) continue;
    const auto is_it = [&](std::string_view name) { return name == argument.name; };
    if (named &&
        (std::any_of(known.begin(), known.end(), is_it) || std::any_of(kAlways.begin(), kAlways.end(), is_it)))
      continue;
    fail(path, statement,
         (named ? "has the argument `" + excerpt(argument.name) + "`"
                : std::string("has an argument without a name")) +
             ", which is not read; give it the arguments that OpenSCAD writes into .csg files");
  }
}

void Arguments::fail_wanted(std::string_view name, const std::string& wanted) const {
  fail(path_, statement_, "needs `" + std::string(name) + "`, " + wanted);
}

const Literal* Arguments::find(std::string_view name) const {
  for (const Argument& argument : statement_.arguments) {
    if (argument.name == name || (argument.name.empty() && name == first_)) return &argument.value;
  }
  return nullptr;
}

double Arguments::number(std::string_view name, double otherwise) const {
  const Literal* value = find(name);
  if (value == nullptr) return otherwise;
  if (value->kind != Literal::Kind::number || !std::isfinite(value->number)) fail_wanted(name, "a finite number");
  return value->number;
}

bool Arguments::boolean(std::string_view name) const {
  const Literal* value = find(name);
  if (value == nullptr) return false;
  if (value->kind != Literal::Kind::boolean) fail_wanted(name, "true or false");
  return value->number != 0;
}

std::string Arguments::text(std::string_view name) const {
  const Literal* value = find(name);
  if (value == nullptr || value->kind != Literal::Kind::text) fail_wanted(name, "a text");
  return value->text;
}

std::vector<double> Arguments::list(std::string_view name, const Literal& value, std::size_t count,
                                    const std::string& wanted) const {
  std::vector<double> out;
  for (const Literal& item : value.items) {
    if (item.kind != Literal::Kind::number) fail_wanted(name, wanted);
    out.push_back(item.number);
  }
  if (value.kind != Literal::Kind::list || (count > 0 && out.size() != count)) fail_wanted(name, wanted);
  return out;
}

std::vector<double> Arguments::numbers(std::string_view name, std::size_t count, double otherwise) const {
  const Literal* value = find(name);
  const std::string wanted = "a finite number or a list of " + std::to_string(count);
  std::vector<double> out(count, otherwise);
  if (value != nullptr && value->kind == Literal::Kind::number) out.assign(count, value->number);
  else if (value != nullptr) out = list(name, *value, count, wanted);
  if (!std::all_of(out.begin(), out.end(), [](double x) { return std::isfinite(x); })) fail_wanted(name, wanted);
  return out;
}

std::vector<std::vector<double>> Arguments::points(std::string_view name, std::size_t count) const {
  const Literal* value = find(name);
  const std::string wanted = "a list of points of " + std::to_string(count) + " finite numbers";
  if (value == nullptr || value->kind != Literal::Kind::list) fail_wanted(name, wanted);
  std::vector<std::vector<double>> out;
  for (const Literal& item : value->items) {
    out.push_back(list(name, item, count, wanted));
    for (const double x : out.back()) {
      if (!std::isfinite(x)) fail_wanted(name, wanted);
    }
  }
  return out;
}

std::vector<Face> Arguments::indices(std::string_view name, std::size_t points) const {
  const Literal* value = find(name);
  std::vector<Face> out;
  if (value == nullptr || value->kind == Literal::Kind::undefined) return out;
  const std::string wanted = "a list of lists of numbers of points, below " + std::to_string(points);
  if (value->kind != Literal::Kind::list) fail_wanted(name, wanted);
  for (const Literal& item : value->items) {
    Face& face = out.emplace_back();
    for (const double x : list(name, item, 0, wanted)) {
      if (!(x >= 0 && x < static_cast<double>(points) && x == std::floor(x))) fail_wanted(name, wanted);
      face.push_back(static_cast<std::uint32_t>(x));
    }
  }
  return out;
}

Matrix Arguments::matrix(std::string_view name) const {
  const Literal* value = find(name);
  const std::string wanted = "four rows of four numbers, the last [0, 0, 0, 1]";
  if (value == nullptr || value->kind != Literal::Kind::list || value->items.size() != 4)
    fail_wanted(name, wanted);
  Matrix out{};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::vector<double> row = list(name, value->items[i], 4, wanted);
    if (i < 3) std::copy(row.begin(), row.end(), out[i].begin());
    else if (row != std::vector<double>{0, 0, 0, 1}) fail_wanted(name, wanted);
  }
  return out;
}

Fineness fineness_of(const std::string& path, const Statement& statement, const Fineness& parent) {
  const Arguments a(path, statement);
  const Fineness out{a.number("$fn", parent.fn), a.number("$fa", parent.fa), a.number("$fs", parent.fs)};
  if (out.fa <= 0 || out.fs <= 0) fail(path, statement, "needs `$fa` and `$fs` above 0");
  return out;
}

std::vector<Statement> parse_statements(const std::string& path, std::string_view text) {
  return Parser(path, text).file();
}

}  // namespace cnrg::openscad
