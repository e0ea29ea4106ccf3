// A table of text for terminals: columns aligned, numbers to the right.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cnrg {

class Table {
 public:
  /// By titles. `<` in front of one: its texts begin below each other; else they end so, as numbers do.
  explicit Table(const std::vector<std::string>& titles);
  /// Adds a row of texts, as they are shown (escape.h), at most as many as there are columns; missing ones are
  /// empty.
  void add_row(std::vector<std::string> cells);
  std::size_t rows() const { return rows_.size(); }

  /// The title line and one line per row, two spaces between columns, no space at the end of a line. A column
  /// without any text below its title is left out.
  std::string text() const;
  /// One row in the widths that `text` uses.
  std::string line(std::size_t row) const;

 private:
  struct Column {
    std::string title;
    bool left;
  };
  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;

  std::vector<std::size_t> widths() const;
  std::string format(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths) const;
};

/// Columns that a text takes on a terminal: one for each character of UTF-8, not for each byte.
std::size_t width_of(std::string_view text);

/// The text and blanks behind it, `width` columns in all; as it is if it takes more.
std::string padded(std::string text, std::size_t width);

/// Do people list `a` before `b`? Digits count as the number that they are: `layer.9` before `layer.10`.
bool listed_before(std::string_view a, std::string_view b);

/// An integer in groups of three digits, for people: 1234567 -> `1,234,567`.
std::string grouped(std::size_t number);

/// As printf prints it.
std::string decimal(double x, const char* format);

/// A number and the word for so many: `1 vertex`, `3 vertices`.
std::string counted(std::size_t n, std::string_view one, std::string_view many);

/// `a`, `a and b`, `a, b and c`.
std::string listed(const std::vector<std::string>& words);

}  // namespace cnrg
