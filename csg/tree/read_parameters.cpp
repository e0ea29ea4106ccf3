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
  for (const auto& item : map.node()) {
    const Value key(document, item.first, map.at());
    const std::string name = key.text("a name in `parameters`"), what = "the parameter `" + name + "`";
    if (!is_parameter_name(name)) key.fail(what + ": a name is letters, digits and `_`, and begins with no digit");
    const Value written(document, item.second, key.at());
    const auto it = given.find(name);
    if (it == given.end() && !written.is_text()) written.fail_type(what, "a number or an expression");
    const Rational value =
        it != given.end() ? given_number(name, it->second, document.parameters) : written_number(name, written);
    if (!document.parameters.emplace(name, value).second) key.fail(what + " is there twice; remove or rename one");
  }
}

}  // namespace

void read_parameters(Document& document, const YAML::Node& root, const ReadOptions& options) {
  if (!root.IsMap()) return;
  for (const auto& entry : root) {
    if (!entry.first.IsScalar() || entry.first.Scalar() != "parameters") continue;
    read_map(document, Value(document, entry.second, Value(document, entry.first, {}).at()), options.parameters);
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
