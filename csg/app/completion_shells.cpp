// Completions for zsh and fish. Both ask for a description of each option, and cut words and quote names
// themselves; what an option takes they are told in their own words: `_arguments` and `complete`.
#include "csg/app/completion_shells.h"

namespace cnrg::app {
namespace {

constexpr const char* kZshHead = R"ZSH(#compdef cnrg
# Completions of cnrg for zsh, made by `cnrg completion zsh`.

# Names of the nodes of the first word that is a file.
_cnrg_nodes() {
  local word
  for word in ${words[2,-1]}; do
    word=${(Q)word}
    if [[ $word != -* && -f $word ]]; then
      local -a names=("${(@f)$(cnrg nodes "$word" 2>/dev/null)}")
      compadd -a names
      return
    fi
  done
}

)ZSH";

constexpr const char* kFishHead = R"FISH(# Completions of cnrg for fish, made by `cnrg completion fish`.

# Names of the nodes of the first word that is a file.
function __cnrg_nodes
    for word in (commandline -opc)[3..]
        if not string match -q -- '-*' $word; and test -f $word
            cnrg nodes $word 2>/dev/null
            return
        end
    end
end

complete -c cnrg -f
)FISH";

/// In apostrophes, with what ends or escapes there written as `escape` says.
std::string in_apostrophes(const std::string& text, const char* apostrophe) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'') out += apostrophe;
    else if (c == '\\') out += "\\\\";
    else out += c;
  }
  return out + "'";
}

/// What `_arguments` takes for a sign of its own.
std::string zsh_escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':') out += '\\';
    out += c;
  }
  return out;
}
/// In a word that is quoted in apostrophes; backslashes are there already.
std::string zsh_quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

std::string zsh_value(const OptionText& option) {
  if (!option.choices.empty()) {
    std::string words;
    for (const std::string& choice : option.choices) words += (words.empty() ? "" : " ") + choice;
    return "(" + words + ")";
  }
  if (option.positional || option.value.starts_with("FILE")) return "_files";
  if (option.value == "FOLDER") return "_files -/";
  return option.value == "N" ? "_cnrg_nodes" : " ";
}

/// The specifications of an option for `_arguments`, one for each name.
std::string zsh_option(const OptionText& option) {
  const std::string value = option.value.empty() ? "" : ":" + zsh_escaped(option.value) + ":" + zsh_value(option);
  if (option.positional)
    return " \\\n      " + zsh_quoted(":" + zsh_escaped(option.names[0]) + ":" + zsh_value(option));
  std::string out;
  for (const std::string& name : option.names)
    out += " \\\n      " + zsh_quoted("*" + name + "[" + zsh_escaped(option.help) + "]" + value);
  return out;
}

std::string fish_value(const OptionText& option) {
  if (option.value.empty()) return "";
  if (!option.choices.empty()) {
    std::string words;
    for (const std::string& choice : option.choices) words += (words.empty() ? "" : " ") + choice;
    return " -x -a " + in_apostrophes(words, "\\'");
  }
  if (option.value.starts_with("FILE")) return " -r -F";
  if (option.value == "FOLDER") return " -x -a '(__fish_complete_directories)'";
  return option.value == "N" ? " -x -a '(__cnrg_nodes)'" : " -x";
}

std::string fish_option(const std::string& command, const OptionText& option) {
  std::string out = "complete -c cnrg -n '" + command + "'";
  if (option.positional) return out + (option.choices.empty() ? " -F" : fish_value(option)) + "\n";
  for (const std::string& name : option.names)
    out += name[1] == '-' ? " -l " + name.substr(2) : " -s " + name.substr(1);
  return out + fish_value(option) + " -d " + in_apostrophes(option.help, "\\'") + "\n";
}

}  // namespace

std::string zsh_completion(const ProgramText& text) {
  std::string out = kZshHead;
  out += "_cnrg() {\n  local -a commands=(\n";
  for (const CommandText& command : text.commands)
    out += "    " + zsh_quoted(command.name + ":" + zsh_escaped(command.help)) + "\n";
  out += "  )\n  if (( CURRENT == 2 )); then\n    _describe command commands\n    _arguments";
  for (const OptionText& option : text.program.options) out += zsh_option(option);
  out += "\n    return\n  fi\n  shift words\n  (( CURRENT-- ))\n  case $words[1] in\n";
  for (const CommandText& command : text.commands) {
    out += "    " + command.name + ") _arguments";
    for (const OptionText& option : command.options) out += zsh_option(option);
    out += " ;;\n";
  }
  return out + "  esac\n}\n\nif [[ $funcstack[1] == _cnrg ]]; then _cnrg \"$@\"; else compdef _cnrg cnrg; fi\n";
}

std::string fish_completion(const ProgramText& text) {
  std::string out = kFishHead;
  for (const OptionText& option : text.program.options) out += fish_option("__fish_use_subcommand", option);
  for (const CommandText& command : text.commands) {
    out += "complete -c cnrg -n __fish_use_subcommand -a " + command.name + " -d " +
           in_apostrophes(command.help, "\\'") + "\n";
    for (const OptionText& option : command.options)
      out += fish_option("__fish_seen_subcommand_from " + command.name, option);
  }
  return out;
}

}  // namespace cnrg::app
