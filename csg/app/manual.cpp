// The manual page: names in bold, what stands for a value in italics, examples as they are typed.
#include "csg/app/manual.h"

#include <algorithm>
#include <cctype>
#include <iostream>
#include <sstream>

#include "csg/app/exit_status.h"

namespace cnrg::app {
namespace {

constexpr const char* kDescription =
    "A tree file names shapes and operators on them. The program computes every cell of the result (vertices, "
    "edges, faces, regions) in exact arithmetic, says which rule removed what, and writes files for ParaView, "
    "meshers and other programs. As `model.yaml`:";
constexpr const char* kTree = R"(cnrg: 1
nodes:
  ground: {box: {min: [0, 0, 0], max: [100, 100, 60]}}
  tunnel: {cylinder: {from: [50, -5, 30], to: [50, 105, 30], radius: 6}}
  model:  {difference: [ground, tunnel]}
result: model
)";
constexpr const char* kMore =
    "Results go to standard output, all that is said about them goes to standard error. A command that reads a "
    "tree reads it from standard input where `-` stands for it, but for `cnrg locate`, which reads its points "
    "there; files that such a tree names are looked for from the current folder on.";

/// A text of one line as roff has it: no letter of it is a command, and a hyphen is what one would type.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\') out += "\\e";
    else if (c == '-') out += "\\-";
    else out += c;
  }
  if (!out.empty() && (out[0] == '.' || out[0] == '\'')) out.insert(0, "\\&");
  return out;
}

std::string bold(const std::string& text) { return "\\fB" + escaped(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + escaped(text) + "\\fR"; }

/// Running text: what is between backticks in bold.
std::string prose(const std::string& text) {
  std::string out;
  std::size_t begin = 0;
  for (bool quoted = false; begin <= text.size(); quoted = !quoted) {
    const std::size_t end = std::min(text.find('`', begin), text.size());
    const std::string part = text.substr(begin, end - begin);
    out += quoted ? bold(part) : escaped(part);
    begin = end + 1;
  }
  return out + "\n";
}

/// Lines as they stand.
std::string lines_of(const std::string& text) {
  std::string out = ".in +4n\n.nf\n";
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    out += line.empty() ? std::string(".sp\n") : escaped(line) + "\n";
  }
  return out + ".fi\n.in\n";
}

/// A tag, and text behind it.
std::string item(const std::string& tag, const std::string& text) { return ".TP\n" + tag + "\n" + text; }

std::string synopsis(const CommandText& command) {
  std::string out = ".B cnrg " + escaped(command.name) + "\n[\\fIOPTIONS\\fR]";
  for (const OptionText& option : command.options) {
    if (option.positional) out += " " + italic(option.names[0]);
  }
  return out + "\n";
}

std::string option_item(const OptionText& option) {
  std::string tag;
  for (const std::string& name : option.names) {
    tag += (tag.empty() ? "" : ", ") + (option.positional ? italic(name) : bold(name));
  }
  if (!option.positional && !option.value.empty()) {
    std::string choices;
    for (const std::string& choice : option.choices) choices += (choices.empty() ? "" : " | ") + bold(choice);
    tag += " " + (choices.empty() ? italic(option.value) : choices);
  }
  std::string text = option.help;
  std::string more = option.bounds;
  if (option.required && !option.positional) more += std::string(more.empty() ? "" : "; ") + "must be given";
  if (!more.empty()) text += " (" + more + ")";
  return item(tag, prose(text + "."));
}

/// The parts of a footer: of the example its lines, of another part `Title: text` both, in `add`.
template <class Add>
void for_each_part(const std::string& footer, Add add) {
  for (std::size_t begin = 0; begin < footer.size();) {
    const std::size_t end = std::min(footer.find("\n\n", begin), footer.size());
    const std::string part = footer.substr(begin, end - begin);
    const std::size_t colon = part.find(':');
    std::string text = colon == std::string::npos ? part : part.substr(colon + 1);
    text.erase(0, text.find_first_not_of(" \n"));
    add(colon == std::string::npos ? std::string() : part.substr(0, colon), text);
    begin = end + 2;
  }
}

bool is_example(const std::string& title) { return title.starts_with("Example"); }

std::string without_indent(const std::string& text) {
  std::string out;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    out += line.substr(std::min(line.find_first_not_of(' '), line.size())) + "\n";
  }
  return out;
}

std::string command_section(const CommandText& command) {
  std::string out = ".SS cnrg " + escaped(command.name) + "\n" + prose(command.help + ".");
  std::string group = "Options";
  for (const OptionText& option : command.options) {
    const bool is_help = std::find(option.names.begin(), option.names.end(), "--help") != option.names.end();
    if (is_help) continue;  // said once for all
    if (!option.positional && option.group != group) out += ".PP\n" + prose(option.group + ":");
    if (!option.positional) group = option.group;
    out += option_item(option);
  }
  for_each_part(command.footer, [&](const std::string& title, const std::string& text) {
    if (is_example(title)) out += ".PP\n" + lines_of(without_indent(text));
    else out += ".PP\n" + prose(title + ": " + text);
  });
  return out;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::toupper(c)); });
  return text;
}

std::string spaced(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

/// What the page's first line says without its stop.
std::string summary(std::string help) {
  if (!help.empty() && help.back() == '.') help.pop_back();
  if (!help.empty()) help[0] = char(std::tolower(static_cast<unsigned char>(help[0])));
  return help;
}

}  // namespace

int run_manual(const ProgramText& text) {
  std::string out = ".TH CNRG 1 \"\" \"cnrg " CNRG_VERSION "\" \"User Commands\"\n";
  out += ".SH NAME\ncnrg \\- " + escaped(summary(text.program.help)) + "\n.SH SYNOPSIS\n";
  for (const CommandText& command : text.commands) {
    if (&command != &text.commands.front()) out += ".br\n";
    out += synopsis(command);
  }
  out += ".SH DESCRIPTION\n" + prose(kDescription) + ".PP\n" + lines_of(kTree) + ".PP\n" + prose(kMore);
  out += ".SH OPTIONS\n";
  for (const OptionText& option : text.program.options) out += option_item(option);
  out += ".SH COMMANDS\n" + prose("Each has `--help`.");
  for (const CommandText& command : text.commands) out += command_section(command);
  for_each_part(text.program.footer, [&](const std::string& title, const std::string& part) {
    out +=
        ".SH " + upper(title) + "\n" + (is_example(title) ? lines_of(without_indent(part)) : prose(spaced(part)));
  });
  std::cout << out << std::flush;
  return kDone;
}

}  // namespace cnrg::app
