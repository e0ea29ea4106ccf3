#include "csg/text/table.h"

#include <algorithm>

#include "tests/catch.h"

using namespace cnrg;

TEST_CASE("a table aligns its columns and leaves out empty ones") {
  Table table({"<node", "cells", "nothing", "<note"});
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

TEST_CASE("names are listed as people list them", "[text][table]") {
  const std::vector<std::string> names{"",
                                       "all",
                                       "layer.1",
                                       "layer.01",
                                       "layer.2",
                                       "layer.9",
                                       "layer.10",
                                       "layer.10a",
                                       "layer.10.2",
                                       "layer.10.11",
                                       "layers",
                                       "z18446744073709551616",
                                       "z18446744073709551617"};
  std::vector<std::string> listed = names;
  std::sort(listed.begin(), listed.end(), [](const auto& a, const auto& b) { return listed_before(a, b); });
  for (std::size_t i = 0; i < names.size(); ++i) {
    INFO(names[i]);
    CHECK_FALSE(listed_before(names[i], names[i]));
    for (std::size_t j = 0; j < names.size(); ++j)
      if (i != j) CHECK(listed_before(names[i], names[j]) != listed_before(names[j], names[i]));
  }
  const auto place = [&](const char* name) {
    return std::find(listed.begin(), listed.end(), name) - listed.begin();
  };
  CHECK(place("layer.2") < place("layer.10"));
  CHECK(place("layer.9") < place("layer.10"));
  CHECK(place("layer.10") < place("layer.10.2"));
  CHECK(place("layer.10.2") < place("layer.10.11"));
  CHECK(place("z18446744073709551616") < place("z18446744073709551617"));
}
