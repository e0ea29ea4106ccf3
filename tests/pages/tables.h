// Tables of a page: cells as they are written, by the heading above them.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "tests/pages/page.h"

namespace cnrg {

struct PageTable {
  std::string anchor;                          // of the heading above
  std::vector<std::string> head;               // of the first line
  std::vector<std::vector<std::string>> rows;  // of the others; as many cells as the head has
};

std::vector<PageTable> tables_of(const Page& page);

/// The words between backquotes, in their order.
std::vector<std::string> quoted_words(const std::string& text);

/// Words in the first column of the tables whose head begins with `title`.
std::set<std::string> first_words(const Page& page, const std::string& title);

}  // namespace cnrg
