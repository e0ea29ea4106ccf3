// A recursive descent over the text, bounded in depth.
#include "csg/openscad/statement.h"

#include <algorithm>
#include <cctype>
#include <limits>
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

std::vector<Statement> parse_statements(const std::string& path, std::string_view text) {
  return Parser(path, text).file();
}

}  // namespace cnrg::openscad
