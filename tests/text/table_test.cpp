#include "csg/text/table.h"

#include <catch2/catch.hpp>

using namespace cnrg;

TEST_CASE("a table aligns its columns and leaves out empty ones") {
  Table table;
  table.add_column("node", Table::Align::left);
  table.add_column("cells");
  table.add_column("nothing");
  table.add_column("note", Table::Align::left);
  table.add_row({"box", "8", "", "flat"});
  table.add_row({"größer", "1,234"});
  CHECK(table.text() ==
        "node    cells  note\n"
        "box         8  flat\n"
        "größer  1,234\n");
  CHECK(table.line(1) == "größer  1,234\n");
}

TEST_CASE("a text is as wide as it has characters") {
  CHECK(width_of("größer") == 6);
  CHECK(width_of("漢字") == 2);
  CHECK(padded("größer", 8) == "größer  ");
  CHECK(padded("größer", 3) == "größer");
  CHECK(padded("", 2) == "  ");
}

TEST_CASE("groups of digits") {
  CHECK(grouped(0) == "0");
  CHECK(grouped(999) == "999");
  CHECK(grouped(1000) == "1,000");
  CHECK(grouped(1234567) == "1,234,567");
}
