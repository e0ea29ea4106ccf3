#include "csg/text/escape.h"

#include "csg/text/graphviz.h"
#include "csg/text/table.h"
#include "tests/catch.h"

using namespace cnrg;

TEST_CASE("names are shown on one line, hostile characters as escapes") {
  CHECK(shown("box 1, größer, 漢, a\\b") == "box 1, größer, 漢, a\\b");
  CHECK(shown("a\nb\rc\td") == "a\\nb\\rc\\td");
  CHECK(shown("\x1b[2J") == "\\x1b[2J");
  CHECK(shown("\x7f") == "\\x7f");
  CHECK(shown(std::string("a\0b", 3)) == "a\\x00b");
  CHECK(shown("\xc2\x85\xc2\x9b") == "\\u0085\\u009b");
  CHECK(shown("\xe2\x80\xae\xe2\x80\xa8\xe2\x81\xa6") == "\\u202e\\u2028\\u2066");
  CHECK(shown("\xf3\xa0\x80\x81") == "\\U000e0001");
  CHECK(shown(shown("\x1b\n")) == shown("\x1b\n"));
  CHECK(shown_lines("a\tb\n\x1b") == "a\tb\n\\x1b");
}

TEST_CASE("bytes that are no UTF-8 are shown one by one") {
  CHECK(shown("\x9b") == "\\x9b");                             // C1 of Latin-1
  CHECK(shown("\xc0\x9b") == "\\xc0\\x9b");                    // ESC, overlong
  CHECK(shown("\xe0\x80\x8a") == "\\xe0\\x80\\x8a");           // a line end, overlong
  CHECK(shown("\xed\xa0\x80") == "\\xed\\xa0\\x80");           // a surrogate
  CHECK(shown("\xf4\x90\x80\x80") == "\\xf4\\x90\\x80\\x80");  // beyond U+10FFFF
  CHECK(shown("\xe2\x80") == "\\xe2\\x80");                    // cut short
  CHECK(shown("\xff\xc3\xa4") == "\\xff\xc3\xa4");
  CHECK(first_invalid("ä") == 2);
  CHECK(first_invalid("aä\x80z") == 3);
}

TEST_CASE("an excerpt ends with a whole character") {
  CHECK(excerpt("short") == "short");
  const std::string many(39, 'a');
  CHECK(excerpt(many + "漢字") == many + "漢...");
  CHECK(excerpt(std::string(1000, '\n')).size() == 83);
}

TEST_CASE("each format has names in its own escapes") {
  CHECK(shown_in_quotes("a\"\n") == "a'\\n");
  CHECK(graphviz_text("a\"\n&lt;\\") == "a\\\"\\\\n&amp;lt;\\\\");
  Table table({"<name"});
  table.add_row({"a\nb"});
  CHECK(table.text() == "name\na\\nb\n");
}
