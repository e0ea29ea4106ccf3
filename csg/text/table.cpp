// Columns as wide as their widest text, counted in characters and not in bytes.
#include "csg/text/table.h"

#include <algorithm>
#include <cstdio>

#include "csg/text/escape.h"
#include "kernel/base/error.h"

namespace cnrg {

Table::Table(const std::vector<std::string>& titles) {
  for (const std::string& title : titles) {
    const bool left = title.starts_with('<');
    columns_.push_back({title.substr(left ? 1 : 0), left});
  }
}

void Table::add_row(std::vector<std::string> cells) {
  require(cells.size() <= columns_.size(), "Table: a row has more cells than there are columns");
  for (std::string& cell : cells) cell = shown(cell);
  rows_.push_back(std::move(cells));
}

std::vector<std::size_t> Table::widths() const {
  std::vector<std::size_t> result(columns_.size(), 0);
  for (const auto& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i) result[i] = std::max(result[i], width_of(row[i]));
  }
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (result[i] > 0 || rows_.empty()) result[i] = std::max(result[i], width_of(columns_[i].title));
  }
  return result;
}

std::string Table::format(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths) const {
  std::string result;
  bool first = true;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (widths[i] == 0) continue;
    if (!first) result += "  ";
    first = false;
    const std::string cell = i < cells.size() ? cells[i] : std::string();
    if (columns_[i].left) result += padded(cell, widths[i]);
    else result += std::string(widths[i] - std::min(widths[i], width_of(cell)), ' ') + cell;
  }
  result.erase(result.find_last_not_of(' ') + 1);
  return result + "\n";
}

std::string Table::line(std::size_t row) const { return format(rows_.at(row), widths()); }

std::string Table::text() const {
  const auto width = widths();
  std::vector<std::string> titles;
  for (const Column& column : columns_) titles.push_back(column.title);
  std::string result = format(titles, width);
  for (const auto& row : rows_) result += format(row, width);
  return result;
}

std::size_t width_of(std::string_view text) {
  const auto begins_one = [](char c) { return (c & 0xc0) != 0x80; };
  return std::size_t(std::count_if(text.begin(), text.end(), begins_one));
}

std::string padded(std::string text, std::size_t width) {
  return text.append(width - std::min(width, width_of(text)), ' ');
}

bool listed_before(std::string_view a, std::string_view b) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto take_number = [&](std::string_view& text) {
    const std::size_t n = std::size_t(std::find_if_not(text.begin(), text.end(), is_digit) - text.begin());
    std::string_view digits = text.substr(0, n);
    text.remove_prefix(n);
    digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
    return digits;
  };
  const std::string_view whole_a = a, whole_b = b;
  while (!a.empty() && !b.empty()) {
    if (is_digit(a[0]) && is_digit(b[0])) {
      const std::string_view m = take_number(a), n = take_number(b);
      if (m != n) return m.size() != n.size() ? m.size() < n.size() : m < n;
    } else if (a[0] != b[0]) {
      return a[0] < b[0];
    } else {
      a.remove_prefix(1), b.remove_prefix(1);
    }
  }
  return a.empty() && b.empty() ? whole_a < whole_b : a.empty();
}

std::string grouped(std::size_t number) {
  std::string digits = std::to_string(number);
  for (std::ptrdiff_t i = std::ptrdiff_t(digits.size()) - 3; i > 0; i -= 3) digits.insert(std::size_t(i), 1, ',');
  return digits;
}

std::string decimal(double x, const char* format) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, format, x);
  return buffer;
}

std::string counted(std::size_t n, std::string_view one, std::string_view many) {
  return std::to_string(n).append(" ").append(n == 1 ? one : many);
}

std::string listed(const std::vector<std::string>& words) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    out += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  }
  return out;
}

}  // namespace cnrg
