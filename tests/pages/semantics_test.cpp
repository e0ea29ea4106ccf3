// The tables of csg/SEMANTICS.md against the rows of the program (`cnrg tables`): the same words in each cell, and
// no row without its cell.
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "tests/app/program.h"
#include "tests/catch.h"
#include "tests/pages/tables.h"

namespace cnrg {
namespace {

/// Operator, kind of entity, relation, and whether A dominates or is equal (`any` for the difference).
using Cell = std::tuple<std::string, std::string, std::string, std::string>;

std::map<Cell, std::string> cells_of_program() {
  const Workshop w;
  std::istringstream lines(w.run("tables").out);
  std::map<Cell, std::string> cells;
  const std::regex heading("## (\\w+), (\\w+): remove when");
  const std::regex row("\\| (\\w+)((?: \\| .* \\(`.*`\\))+) \\|");
  const std::regex entry(" \\| (.*?) \\(`[\\w.]*?`\\)");
  std::string op, kind;
  for (std::string line; std::getline(lines, line);) {
    std::smatch m;
    if (std::regex_match(line, m, heading)) {
      op = m[1], kind = m[2];
    } else if (std::regex_match(line, m, row)) {
      const std::string relation = m[1], rest = m[2];
      std::vector<std::string> words;
      for (std::sregex_iterator it(rest.begin(), rest.end(), entry), end; it != end; ++it)
        words.push_back((*it)[1]);
      if (words.size() == 1) {
        cells[{op, kind, relation, "any"}] = words[0];
      } else {
        REQUIRE(words.size() == 2);
        cells[{op, kind, relation, "dominant"}] = words[0];
        cells[{op, kind, relation, "equal"}] = words[1];
      }
    }
  }
  return cells;
}

/// `AoutB and BoutA` as two words; `all others` as those of the operator that have not been named.
std::vector<std::string> relations(const std::string& text, std::set<std::string>& left) {
  std::vector<std::string> out;
  if (text == "all others") {
    out.assign(left.begin(), left.end());
  } else {
    std::istringstream words(text);
    for (std::string word; words >> word;) {
      if (word != "and") out.push_back(word);
    }
  }
  for (const std::string& relation : out) left.erase(relation);
  return out;
}

TEST_CASE("csg/SEMANTICS.md has the tables of the program", "[pages]") {
  std::map<Cell, std::string> rows = cells_of_program();
  REQUIRE(rows.size() == 75);
  std::size_t number = 0;
  for (const PageTable& table : tables_of(read_page(root() / "csg" / "SEMANTICS.md"))) {
    if (table.anchor != "the-tables") continue;
    // Faces of unions and intersections, faces of differences, edges, vertices.
    const char* kinds[] = {"faces", "faces", "edges", "vertices"};
    REQUIRE(number < std::size(kinds));
    const std::string kind = kinds[number++];
    std::map<std::string, std::set<std::string>> left;
    for (const std::vector<std::string>& row : table.rows) {
      const std::string op = quoted_words(row.at(0)).at(0);
      const auto named = left.emplace(op, std::set<std::string>{"AinB", "BinA", "INTERS", "AoutB", "BoutA"}).first;
      for (const std::string& relation : relations(row[0].substr(row[0].find(", ") + 2), named->second)) {
        const std::vector<std::string> columns =
            op == "difference" ? std::vector<std::string>{"any"} : std::vector<std::string>{"dominant", "equal"};
        for (std::size_t i = 0; i < columns.size(); ++i) {
          const auto cell = rows.find({op, kind, relation, columns[i]});
          INFO(op << ", " << kind << ", " << relation << ", " << columns[i]);
          REQUIRE(cell != rows.end());
          CHECK(cell->second == row.at(i + 1));
          rows.erase(cell);
        }
      }
    }
  }
  CHECK(number == 4);
  CHECK(rows.empty());
}

}  // namespace
}  // namespace cnrg
