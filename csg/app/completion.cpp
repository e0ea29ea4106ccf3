// What shells complete: scripts that ask the program, and its answer.
//
// Nothing of what was typed is evaluated: a name of a file must not run a command because somebody pressed a key.
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <iostream>

#include "csg/app/exit_status.h"
#include "csg/app/manual.h"
#include "csg/text/escape.h"
#include "csg/tree/tree.h"

namespace cnrg::app {
namespace {

// bash cuts words at `=`, and gives them as they were typed, quotes, backslashes and `~` included.
constexpr const char* kBash =
#include "csg/app/completion.bash.inc"
    ;

constexpr const char* kZsh =
#include "csg/app/completion.zsh.inc"
    ;

constexpr const char* kFish =
#include "csg/app/completion.fish.inc"
    ;

/// An answer is `:words`, one a line, with a tabulator before what they mean; or `:files` with the ends that names
/// of files have, if not all will do. Folders always do, and with `/` they alone.
constexpr const char *kWords = ":words\n", *kFiles = ":files\n", *kFolders = ":files /\n",
                     *kModels =
                         ":files .yaml .yml .json .csg .off .obj .stl .ply .vtp .vtu .vtk .ts .step .stp "
                         ".brep\n";

void offer(const std::vector<std::string>& words) {
  std::cout << kWords;
  for (const std::string& word : words) std::cout << word << '\n';
}

void offer_options(const CommandText& command) {
  for (const OptionText& option : command.options) {
    if (option.positional) continue;
    for (const std::string& name : option.names) std::cout << name << '\t' << option.help << '\n';
  }
}

/// Of all nodes with a name of their own. `~` is as it was typed.
void offer_nodes(std::string tree) {
  if (tree.empty() || tree == "-") return;
  const char* const home = std::getenv("HOME");
  if (tree.starts_with("~/") && home != nullptr) tree.replace(0, 1, home);
  std::vector<std::string> names;
  for (const Node& node : read_tree(tree).nodes) {
    if (!node.is_inline) names.push_back(shown(node.name));
  }
  offer(names);
}

/// Arguments of a command, with what was typed for each.
using TypedArguments = std::vector<std::pair<const OptionText*, std::string>>;

/// Of `--node-b` the argument that is called B, of other options the first one.
std::string asked_tree(const OptionText& option, const TypedArguments& arguments) {
  const std::string name(1, char(std::toupper(static_cast<unsigned char>(option.names.back().back()))));
  for (const auto& [argument, word] : arguments)
    if (argument->names[0] == name) return word;
  return arguments.empty() ? "" : arguments[0].second;
}

void offer_values(const OptionText& option, const TypedArguments& arguments) {
  if (!option.choices.empty()) offer(option.choices);
  else if (option.positional) std::cout << (option.names[0] == "TREE" ? kModels : kFiles);
  else if (option.value.starts_with("FILE")) std::cout << kFiles;
  else if (option.value == "FOLDER") std::cout << kFolders;
  else if (option.value == "N" && option.bounds.empty()) offer_nodes(asked_tree(option, arguments));
}

/// `words` are those behind the name of the command.
void complete(const CommandText& command, const std::vector<std::string>& words) {
  TypedArguments arguments;
  for (const OptionText& option : command.options)
    if (option.positional) arguments.emplace_back(&option, "");
  const auto valued = [&](const std::string& name) -> const OptionText* {
    for (const OptionText& option : command.options)
      if (!option.value.empty() && std::ranges::count(option.names, name) > 0) return &option;
    return nullptr;
  };
  const OptionText* asked = nullptr;  // what the next word is a value of
  std::size_t next = 0;
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    if (asked != nullptr) asked = nullptr;
    else if (words[i].starts_with('-') && words[i] != "-") asked = valued(words[i]);
    else if (next++ < arguments.size()) arguments[next - 1].second = words[i];
  }
  const std::string& last = words.back();
  if (asked == nullptr && !last.starts_with('-') && next < arguments.size()) asked = arguments[next].first;
  if (const std::size_t sign = last.find('='); asked == nullptr && sign != std::string::npos)
    asked = valued(last.substr(0, sign));
  if (asked != nullptr) return offer_values(*asked, arguments);
  if (!last.starts_with('-')) return;
  std::cout << kWords;
  offer_options(command);
}

}  // namespace

int run_completion(const std::string& shell) {
  std::cout << (shell == "zsh" ? kZsh : shell == "fish" ? kFish : kBash);
  return kDone;
}

int run_complete(const ProgramText& text, const std::vector<std::string>& words) {
  if (words.size() < 2) {
    std::cout << kWords;
    for (const CommandText& command : text.commands) std::cout << command.name << '\t' << command.help << '\n';
    offer_options(text.program);
    return kDone;
  }
  for (const CommandText& command : text.commands) {
    if (command.name == words[0]) complete(command, {words.begin() + 1, words.end()});
  }
  return kDone;
}

}  // namespace cnrg::app
