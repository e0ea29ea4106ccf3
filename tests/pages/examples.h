// The examples of a page: files that it shows, and commands with what they print.
//
// - A block of code below a line that ends with a file's name in backquotes and a colon ("..., as `slope.yaml`:")
//   is that file: it is written, or, if it is there already, it must be what is there.
// - A line `$ COMMAND` in any other block is run by the shell, where `cnrg` is the program and `example_NAME` one
//   of csg/examples, in a folder of the page's own with csg/python/examples, a copy of papers/ and the files of
//   README.md; those of a lesson in its folder of that copy. The lines below it, up to the next command, are all
//   that it prints on standard output and then on standard error; a line `...` stands for any number of lines. A
//   command of which nothing is shown prints nothing. It succeeds, unless a line that is shown is an error.
//
// Lines are compared by indentation and words. Free is what is not a result: the width of columns and the time of
// a row (the word before the volume); and of a number `N/D (decimal)` either part may be left out.
#pragma once

#include <string>
#include <vector>

#include "tests/pages/page.h"

namespace cnrg {

struct Claim {
  std::string command;
  std::size_t begin = 0, end = 0;  // lines of the page that it shows as printed
};

/// The commands in a block that is no file.
std::vector<Claim> claims_of(const Page& page, const CodeBlock& block);

/// The first difference between what is shown and what is printed, in words; empty if there is none.
std::string difference(const std::vector<std::string>& shown, const std::vector<std::string>& printed);

/// What `shown` has to be for `printed`: lines that are right stay as they are, times are zero.
std::vector<std::string> corrected(const std::vector<std::string>& shown, const std::vector<std::string>& printed);

}  // namespace cnrg
