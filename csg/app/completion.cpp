// A function for bash that knows every option by the table of them, and asks the program for the nodes of a tree.
//
// bash cuts words at `=` and gives them as they were typed, quotes, backslashes and `~` included. Nothing of them
// is evaluated: a name of a file must not run a command because somebody pressed a key.
#include <algorithm>
#include <cctype>
#include <iostream>
#include <string>

#include "csg/app/completion_shells.h"
#include "csg/app/exit_status.h"
#include "csg/app/manual.h"

namespace cnrg::app {
namespace {

constexpr const char* kHead = R"BASH(# Completions of cnrg for bash, made by `cnrg completion`.

# Every line that is a candidate.
_cnrg_offer() {
  local candidate
  while IFS= read -r candidate; do
    [[ $candidate == "$1"* ]] && COMPREPLY+=("$candidate")
  done
}

# Files that end in one of these, and folders; files of all kinds if there is none.
_cnrg_files() {
  local word file ending
  word=$(_cnrg_plain "$1")
  shift
  compopt -o filenames 2>/dev/null
  while IFS= read -r file; do
    if [[ $# -eq 0 || -d ${file/#\~/$HOME} ]]; then
      COMPREPLY+=("$file")
      continue
    fi
    for ending; do
      [[ $file == *"$ending" ]] && COMPREPLY+=("$file")
    done
  done < <(compgen -f -- "$word")
}

_cnrg_folders() {
  compopt -o filenames 2>/dev/null
  local folder
  while IFS= read -r folder; do COMPREPLY+=("$folder"); done < <(compgen -d -- "$(_cnrg_plain "$1")")
}

# A word as it was typed, without what quotes it; nothing of it is run.
_cnrg_plain() {
  local word=${1//\\/}
  word=${word//\"/}
  word=${word//\'/}
  printf '%s' "$word"
}

# Names of the nodes of a tree, quoted where they need it.
_cnrg_nodes() {
  local name
  [[ -n $2 && $2 != - ]] || return 0
  while IFS= read -r name; do
    [[ $name == "$3"* ]] && COMPREPLY+=("$(printf '%q' "$name")")
  done < <("$1" nodes "${2/#\~/$HOME}" 2>/dev/null)
}

_cnrg() {
  COMPREPLY=()
  local program=${1/#\~/$HOME} command=${COMP_WORDS[1]} word=${COMP_WORDS[COMP_CWORD]} before=
  local options= valued= i at taken arguments=()
  [[ $COMP_CWORD -gt 1 ]] && before=${COMP_WORDS[COMP_CWORD-1]}
  if [[ $word == "=" ]]; then
    word=
  elif [[ $before == "=" ]]; then
    before=${COMP_WORDS[COMP_CWORD-2]}
  fi
)BASH";

constexpr const char* kArguments = R"BASH(
  # The arguments that are no options.
  taken=
  for ((i = 2; i < COMP_CWORD; ++i)); do
    at=${COMP_WORDS[i]}
    if [[ $at == "=" ]]; then
      taken=yes
    elif [[ -n $taken ]]; then
      taken=
    elif [[ $valued == *" $at "* ]]; then
      [[ ${COMP_WORDS[i+1]} == "=" ]] || taken=yes
    elif [[ $at != -?* ]]; then
      arguments+=("$(_cnrg_plain "$at")")
    fi
  done
)BASH";

std::string quoted_list(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words) out += " '" + word + "'";
  return out;
}

std::string joined_words(const std::vector<std::string>& words, const std::string& between) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : between) + word;
  return out;
}

std::string offer(const std::vector<std::string>& words) {
  return "_cnrg_offer \"$word\" < <(printf '%s\\n'" + quoted_list(words) + ")";
}

/// Which argument the node of an option is of: of `--node-b` the one called B, else the first one.
std::size_t place_of_tree(const CommandText& command, const OptionText& option) {
  const std::string& name = option.names.back();
  std::size_t i = 0;
  for (const OptionText& other : command.options) {
    if (!other.positional) continue;
    std::string end = "-" + other.names[0];
    std::transform(end.begin(), end.end(), end.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    if (name.ends_with(end)) return i;
    ++i;
  }
  return 0;
}

/// What completes the value of an option.
std::string completed_value(const CommandText& command, const OptionText& option) {
  if (!option.choices.empty()) return offer(option.choices);
  if (option.value.starts_with("FILE")) return "_cnrg_files \"$word\"";
  if (option.value == "FOLDER") return "_cnrg_folders \"$word\"";
  if (option.value == "N") {
    return "_cnrg_nodes \"$program\" \"${arguments[" + std::to_string(place_of_tree(command, option)) +
           "]}\" \"$(_cnrg_plain \"$word\")\"";
  }
  return ":";
}

std::string command_case(const CommandText& command) {
  std::vector<std::string> names, valued;
  for (const OptionText& option : command.options) {
    if (option.positional) continue;
    names.insert(names.end(), option.names.begin(), option.names.end());
    if (!option.value.empty()) valued.insert(valued.end(), option.names.begin(), option.names.end());
  }
  return "    " + command.name + ")\n      options='" + joined_words(names, " ") + "'\n      valued=' " +
         joined_words(valued, " ") + " '\n      ;;\n";
}

std::string value_cases(const CommandText& command) {
  std::string out;
  for (const OptionText& option : command.options) {
    if (option.positional || option.value.empty()) continue;
    for (const std::string& name : option.names)
      out += "    '" + command.name + " " + name + "') " + completed_value(command, option) + "; return ;;\n";
  }
  return out;
}

std::string argument_cases(const CommandText& command) {
  static constexpr const char* kModels =
      " .yaml .yml .json .csg .off .obj .stl .ply .vtp .vtu .vtk .ts .step .stp .brep";
  std::string out;
  std::size_t i = 0;
  for (const OptionText& option : command.options) {
    if (!option.positional) continue;
    const std::string files = "_cnrg_files \"$word\"" + std::string(option.names[0] == "TREE" ? kModels : "");
    out += "    '" + command.name + " " + std::to_string(i++) + "') " +
           (option.choices.empty() ? files : offer(option.choices)) + " ;;\n";
  }
  return out;
}

std::string bash_completion(const ProgramText& text) {
  std::vector<std::string> first;
  for (const CommandText& command : text.commands) first.push_back(command.name);
  for (const OptionText& option : text.program.options) {
    first.insert(first.end(), option.names.begin(), option.names.end());
  }
  std::string out = kHead;
  out += "  if [[ $COMP_CWORD -eq 1 ]]; then\n    " + offer(first) + "\n    return\n  fi\n  case $command in\n";
  for (const CommandText& command : text.commands) out += command_case(command);
  out += std::string("    *) return ;;\n  esac\n") + kArguments + "  case \"$command $before\" in\n";
  for (const CommandText& command : text.commands) out += value_cases(command);
  out +=
      "  esac\n  if [[ $word == -* ]]; then\n    _cnrg_offer \"$word\" < <(printf '%s\\n' $options)\n    return\n"
      "  fi\n  case \"$command ${#arguments[@]}\" in\n";
  for (const CommandText& command : text.commands) out += argument_cases(command);
  return out + "  esac\n}\n\ncomplete -F _cnrg cnrg\n";
}

}  // namespace

int run_completion(const ProgramText& text, const std::string& shell) {
  const auto completion = shell == "zsh" ? zsh_completion : shell == "fish" ? fish_completion : bash_completion;
  std::cout << completion(text) << std::flush;
  return kDone;
}

}  // namespace cnrg::app
