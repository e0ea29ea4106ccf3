#include "csg/tree/read_properties.h"

#include <cmath>

#include "csg/text/number.h"

namespace cnrg {

Properties read_properties(const Value& value) {
  constexpr const char* kWanted = "a map of keys with numbers or texts, such as {diameter: 25, section: round}";
  if (!value.is_map()) value.fail_type("`attributes`", kWanted);
  Properties properties;
  for (const Value::Entry& e : value.entries("`attributes`")) {
    const std::string what = "the attribute `" + e.key + "`";
    if (e.key.empty()) value.document().fail(e.key_at, "an attribute needs a name, such as `diameter: 25`");
    if (e.key == "name" || e.key == "material" || e.key == "dominance") {
      value.document().fail(e.key_at, "`" + e.key + "` is a key of the node itself; write it beside `attributes`");
    }
    properties.emplace(e.key, read_property(e.value, what));
  }
  return properties;
}

Property read_property(const Value& value, const std::string& what) {
  if (!value.is_text()) value.fail_type(what, "a number or a text");
  const std::string text = value.text(what);
  if (value.is_quoted()) return text;
  if (NumberText number = read_number(text); number.value) return std::move(*number.value);
  const std::size_t sign = text.front() == '-' || text.front() == '+' ? 1 : 0;
  const std::size_t first = sign + (text.size() > sign && text[sign] == '.' ? 1 : 0);
  if (text.size() > first && text[first] >= '0' && text[first] <= '9') {
    value.fail(what + ": `" + text + "` begins like a number and is none; mend it, or write a text in quotes");
  }
  return text;
}

Rational read_size(const Value& value) {
  Rational size = value.number("`size`");
  const double rounded = to_double(size);
  if (!(rounded > 0 && std::isfinite(rounded))) {
    value.fail("`size` is how long edges of a mesh are to be, and must be above 0; write one such as 0.5");
  }
  return size;
}

}  // namespace cnrg
