#include "csg/tree/read_properties.h"

#include "csg/text/number.h"

namespace cnrg {

Properties read_properties(const Value& value) {
  constexpr const char* kWanted = "a map of keys with numbers or texts, such as {diameter: 25, section: round}";
  if (!value.is_map()) value.fail_type("`attributes`", kWanted);
  Properties properties;
  for (const Value::Entry& e : value.entries("`attributes`")) {
    const std::string what = "the attribute `" + e.key + "`";
    if (e.key.empty()) value.document().fail(e.key_at, "an attribute needs a name");
    if (e.key == "name" || e.key == "material" || e.key == "dominance") {
      value.document().fail(e.key_at, "`" + e.key + "` is a key of the node itself; write it beside `attributes`");
    }
    properties.emplace(e.key, read_property(e.value, what));
  }
  return properties;
}

Property read_property(const Value& value, const std::string& what) {
  const std::string text = value.text(what);
  if (!is_quoted(value)) {
    if (NumberText number = read_number(text); number.value) return std::move(*number.value);
  }
  return text;
}

bool is_quoted(const Value& value) { return value.node().Tag() == "!"; }

}  // namespace cnrg
