// CLI11 keeps a name for the value and what its validators say of it in one text: `K:INT in [1 - 1000]`,
// `WHAT:{names,materials}`.
#include "csg/app/program_text.h"

#include <CLI/CLI.hpp>
#include <sstream>

namespace cnrg::app {
namespace {

/// `{a,b}` is a list of all values.
std::vector<std::string> choices_in(const std::string& text) {
  std::vector<std::string> out;
  if (text.size() < 2 || text.front() != '{' || text.back() != '}') return out;
  std::istringstream stream(text.substr(1, text.size() - 2));
  for (std::string choice; std::getline(stream, choice, ',');) out.push_back(choice);
  return out;
}

OptionText option_text(const CLI::Option& option) {
  OptionText out;
  out.positional = option.get_positional();
  if (out.positional) out.names = {option.get_name(true, false)};
  for (const std::string& name : option.get_snames()) out.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) out.names.push_back("--" + name);
  out.help = option.get_description();
  out.group = option.get_group();
  out.required = option.get_required();
  if (option.get_items_expected_max() == 0) return out;  // a flag
  const std::string type = option.get_type_name();
  const std::size_t colon = type.find(':');
  out.value = type.substr(0, colon);
  if (colon != std::string::npos) out.bounds = type.substr(colon + 1);
  out.choices = choices_in(out.bounds.empty() ? out.value : out.bounds);
  if (!out.choices.empty()) out.bounds.clear();
  return out;
}

CommandText command_text(const CLI::App& command) {
  CommandText out{command.get_name(), command.get_description(), command.get_footer(), {}};
  for (const CLI::Option* option : command.get_options()) out.options.push_back(option_text(*option));
  return out;
}

}  // namespace

ProgramText program_text(const CLI::App& program) {
  ProgramText out{command_text(program), {}};
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
    if (!command->get_group().empty()) out.commands.push_back(command_text(*command));
  }
  return out;
}

namespace {

constexpr std::size_t kWidth = 80, kMeaning = 30;  // where CLI11 begins to say what an option means

/// Where further lines of a line begin.
std::size_t hanging(const std::string& line) {
  const std::size_t first = line.find_first_not_of(' ');
  return first == 2 && line.size() > kMeaning && line[kMeaning - 1] == ' ' ? kMeaning : first;
}

std::string wrapped_line(std::string line) {
  std::string out;
  const std::size_t indent = hanging(line);
  while (line.size() > kWidth) {
    std::size_t end = line.rfind(' ', kWidth);
    if (end == std::string::npos || end <= indent) end = line.find(' ', kWidth);
    if (end == std::string::npos) break;
    out += line.substr(0, end) + "\n";
    line = std::string(indent, ' ') + line.substr(end + 1);
  }
  return out + line;
}

}  // namespace

std::string wrapped_help(const std::string& help) {
  std::istringstream lines(help);
  std::string out;
  for (std::string line; std::getline(lines, line);) out += wrapped_line(std::move(line)) + "\n";
  return out;
}

}  // namespace cnrg::app
