// What the program says of its commands and options, as data: manual page and completions are made of it.
//
// It is read from the table of options itself (main.cpp), which the help is made of, too, so that no page can tell
// of an option that is not there.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace cnrg::app {

struct OptionText {
  std::vector<std::string> names;  ///< `-o`, `--threads`; of an argument without a name what it is called: `TREE`
  bool positional = false;         ///< such an argument
  std::string value;               ///< what stands for the value: `FILE`, `N`; empty: it has none
  std::string bounds;              ///< of numbers: `INT in [1 - 1000]`
  std::vector<std::string> choices;  ///< all values that there are, if they are few
  std::string help, group;
  bool required = false;
};

struct CommandText {
  std::string name, help, footer;
  std::vector<OptionText> options;  ///< in the order of the help
};

struct ProgramText {
  CommandText program;
  std::vector<CommandText> commands;  ///< without those that the help does not list
};

ProgramText program_text(const CLI::App& program);

/// The text of a help in lines of 80 characters; what an option means goes on below where it began.
std::string wrapped_help(const std::string& help);

}  // namespace cnrg::app
