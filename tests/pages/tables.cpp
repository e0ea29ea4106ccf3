#include "tests/pages/tables.h"

#include <algorithm>

namespace cnrg {
namespace {

/// The cells of a line `| a | b |`; `\|` is no border.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells{""};
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (line[i] == '\\' && i + 1 < line.size() && line[i + 1] == '|') cells.back() += line[++i];
    else if (line[i] == '|') cells.emplace_back();
    else cells.back() += line[i];
  }
  cells.pop_back();
  for (std::string& cell : cells) {
    const std::size_t begin = cell.find_first_not_of(' ');
    cell = begin == std::string::npos ? "" : cell.substr(begin, cell.find_last_not_of(' ') + 1 - begin);
  }
  return cells;
}

bool in_a_block(const Page& page, std::size_t line) {
  return std::any_of(page.blocks.begin(), page.blocks.end(),
                     [&](const CodeBlock& b) { return b.begin <= line && line < b.end; });
}

}  // namespace

std::vector<PageTable> tables_of(const Page& page) {
  std::vector<PageTable> tables;
  std::size_t heading = 0;
  bool in_table = false;
  for (std::size_t i = 0; i < page.lines.size(); ++i) {
    const std::string& line = page.lines[i];
    const bool outside = !in_a_block(page, i);
    if (outside && line.starts_with("#")) ++heading;
    const bool row = outside && line.starts_with("|");
    if (row && !in_table) {
      tables.push_back({heading == 0 ? "" : page.anchors.at(heading - 1), cells_of(line), {}});
      ++i;  // the line of hyphens
    } else if (row) {
      tables.back().rows.push_back(cells_of(line));
      tables.back().rows.back().resize(tables.back().head.size());
    }
    in_table = row;
  }
  return tables;
}

std::vector<std::string> quoted_words(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t begin = text.find('`'); begin != std::string::npos; begin = text.find('`', begin)) {
    const std::size_t end = text.find('`', begin + 1);
    if (end == std::string::npos) break;
    words.push_back(text.substr(begin + 1, end - begin - 1));
    begin = end + 1;
  }
  return words;
}

std::set<std::string> first_words(const Page& page, const std::string& title) {
  std::set<std::string> words;
  for (const PageTable& table : tables_of(page)) {
    if (table.head.empty() || table.head[0] != title) continue;
    for (const std::vector<std::string>& row : table.rows) {
      for (const std::string& word : quoted_words(row[0])) words.insert(word);
    }
  }
  return words;
}

}  // namespace cnrg
