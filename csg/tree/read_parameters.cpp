// Parameters of a tree file: numbers by name; some are given from outside in place of those of the file.
#include "csg/tree/read_parameters.h"

#include "csg/text/number.h"
#include "csg/tree/suggest.h"

namespace cnrg {
namespace {

Rational given_number(const std::string& name, const std::string& text, const ParameterValues& before) {
  try {
    const NumberText number = read_number(text);
    return number.value ? *number.value : evaluate_expression(text, before);
  } catch (const InputError& e) {
    throw InputError("the parameter `" + name + "`: " + e.what());
  }
}

Rational written_number(const std::string& name, const Value& value) {
  try {
    return given_number(name, value.raw(), value.document().parameters);
  } catch (const InputError& e) {
    value.fail(e.what());
  }
}

void read_map(Document& document, const Value& map, const std::map<std::string, std::string>& given) {
  if (!map.is_map()) map.fail_type("`parameters`", "a map {NAME: NUMBER, ...}");
  for (const Value::Entry& e : map.entries("`parameters`")) {
    const std::string what = "the parameter `" + e.key + "`";
    if (!is_parameter_name(e.key))
      document.fail(e.key_at, what + ": a name is letters, digits and `_`, and begins with no digit");
    const auto it = given.find(e.key);
    if (it == given.end() && !e.value.is_text()) e.value.fail_type(what, "a number or an expression");
    document.parameters.emplace(e.key, it != given.end() ? given_number(e.key, it->second, document.parameters)
                                                         : written_number(e.key, e.value));
  }
}

}  // namespace

void read_parameters(Document& document, const Value& top, const ReadOptions& options) {
  if (!top.is_map()) return;
  for (const Value::Entry& e : top.entries("a tree file")) {
    if (e.key == "parameters") read_map(document, e.value, options.parameters);
  }
  for (const auto& [name, text] : options.parameters) {
    if (document.parameters.contains(name)) continue;
    if (options.unknown != nullptr) {
      options.unknown->insert(name);
      continue;
    }
    std::vector<std::string_view> names;
    for (const auto& [known, value] : document.parameters) names.push_back(known);
    const std::string hint = did_you_mean(name, names);
    throw InputError("the parameter `" + name + "`: " + document.file + " has no such one" +
                     (hint.empty() ? "; `parameters` of the file lists those that it has" : hint));
  }
}

}  // namespace cnrg
