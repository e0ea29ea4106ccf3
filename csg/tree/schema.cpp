// A definition for each form and for each type that no table has; types refer to these by name.
#include "csg/tree/schema.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "csg/text/json_text.h"
#include "csg/tree/forms.h"
#include "csg/tree/operator_names.h"
#include "csg/tree/read_leaf.h"

namespace cnrg {
namespace {

struct NamedSchema {
  std::string_view name, schema;
};

// In place of a number there may be a fraction, or a text with an expression, whose value no schema knows.
#define CNRG_NUMBER(BOUNDS) R"({"anyOf":[{"type":"number")" BOUNDS R"(},{"$ref":"#/$defs/number-as-text"}]})"

constexpr NamedSchema kDefinitions[] = {
    {"number as text",
     R"({"type":"string","pattern":"^[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?(/(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?)?$|\\$\\{"})"},
    {"number", CNRG_NUMBER("")},
    {"positive number", CNRG_NUMBER(R"(,"exclusiveMinimum":0)")},
    {"number from 0", CNRG_NUMBER(R"(,"minimum":0)")},
    {"number from a list", R"({"anyOf":[{"type":"integer","minimum":0},{"$ref":"#/$defs/number-as-text"}]})"},
    {"text", R"({"type":["string","number","boolean"],"minLength":1})"},
    {"boolean", R"({"type":"boolean"})"},
    {"nothing", R"({"type":"null"})"},
    {"anything", "true"},
    {"version", R"({"enum":[1,"1"]})"},
    {"parameters",
     R"({"type":"object","propertyNames":{"pattern":"^[A-Za-z_][A-Za-z0-9_]*$"},"additionalProperties":{"type":["number","string"]}})"},
    {"color", R"({"type":"string","pattern":"^#[0-9a-fA-F]{6}$"})"},
    {"nodes", R"({"type":"object","minProperties":1,"additionalProperties":{"$ref":"#/$defs/node"}})"},
    {"regions",
     R"({"type":"object","patternProperties":{"^[1-9][0-9]*$|\\$\\{":{"$ref":"#/$defs/region-of-a-group"}},"additionalProperties":false})"},
    {"line",
     R"({"type":"array","contains":{"$ref":"#/$defs/point"},"minContains":2,"prefixItems":[{"$ref":"#/$defs/point"}],"items":{"anyOf":[{"$ref":"#/$defs/point"},{"$ref":"#/$defs/curve-of-a-line"}]}})"},
    {"flat line",
     R"({"type":"array","contains":{"$ref":"#/$defs/pair"},"minContains":2,"prefixItems":[{"$ref":"#/$defs/pair"}],"items":{"anyOf":[{"$ref":"#/$defs/pair"},{"$ref":"#/$defs/curve-of-a-flat-line"}]}})"},
    {"side", R"({"enum":["left","right","equal"]})"},
    {"dimension", R"({"anyOf":[{"type":"integer","minimum":0,"maximum":3},{"$ref":"#/$defs/number-as-text"}]})"},
    {"degree", R"({"anyOf":[{"type":"integer","minimum":1,"maximum":32},{"$ref":"#/$defs/number-as-text"}]})"},
    {"operand", R"({"anyOf":[{"$ref":"#/$defs/text"},{"$ref":"#/$defs/node"}]})"},
    {"point", R"({"type":"array","items":{"$ref":"#/$defs/number"},"minItems":3,"maxItems":3})"},
    {"pair", R"({"type":"array","items":{"$ref":"#/$defs/number"},"minItems":2,"maxItems":2})"},
    {"stop",
     R"({"type":"array","prefixItems":[{"$ref":"#/$defs/number"},{"anyOf":[{"$ref":"#/$defs/text"},{"type":"object","additionalProperties":{"$ref":"#/$defs/number-from-0"}}]}],"minItems":2,"maxItems":2})"},
};

/// A name in a reference: nothing in it has to be escaped.
std::string reference(std::string_view name) {
  std::string id(name);
  std::replace(id.begin(), id.end(), ' ', '-');
  return "#/$defs/" + id;
}

/// The parts of a type as `Type::schema` has it, between commas that stand in no brackets.
std::vector<std::string_view> alternatives(std::string_view text) {
  std::vector<std::string_view> parts;
  int depth = 0;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '[' || text[i] == '{') ++depth;
    if (text[i] == ']' || text[i] == '}') --depth;
    if (text[i] != '|' || depth > 0) continue;
    parts.push_back(text.substr(begin, i - begin));
    begin = i + 1;
  }
  parts.push_back(text.substr(begin));
  return parts;
}

std::string schema_of(std::string_view type);

/// Of `[TYPE]`, `[TYPE;3]`, `[TYPE;2+]` without the brackets.
std::string list_schema(std::string_view inside) {
  const std::size_t last = inside.find_last_of(";]}");
  std::string bounds;
  if (last != std::string_view::npos && inside[last] == ';') {
    const bool more = inside.ends_with('+');
    const std::string number(inside.substr(last + 1, inside.size() - last - 1 - (more ? 1 : 0)));
    bounds = ",\"minItems\":" + number + (more ? "" : ",\"maxItems\":" + number);
    inside = inside.substr(0, last);
  }
  return R"({"type":"array","items":)" + schema_of(inside) + bounds + "}";
}

/// Of a type in the notation of `Type::schema`.
std::string schema_of(std::string_view type) {
  const std::vector<std::string_view> parts = alternatives(type);
  if (parts.size() > 1) {
    std::string text = "{\"anyOf\":";
    append_json(text, parts, [&](std::string_view part) { text += schema_of(part); });
    return text + "}";
  }
  const std::string_view inside = type.substr(1, type.size() < 2 ? 0 : type.size() - 2);
  if (type.starts_with('[')) return list_schema(inside);
  if (type.starts_with('{')) return R"({"type":"object","additionalProperties":)" + schema_of(inside) + "}";
  return R"({"$ref":")" + reference(type) + "\"}";
}

std::string schema_of(const Type& type) {
  if (type.kind == Type::Kind::count) {
    return R"({"anyOf":[{"type":"integer","minimum":)" + std::to_string(type.least) +
           ",\"maximum\":" + std::to_string(type.most) + "}," + schema_of("number as text") + "]}";
  }
  if (type.kind != Type::Kind::choice) return schema_of(type.schema);
  std::string text = "{\"enum\":";
  append_json(text, type.choices, [&](std::string_view choice) { append_json(text, choice); });
  return text + "}";
}

/// The text of a page without links and backquotes.
std::string plain(std::string_view text) {
  std::string out(text);
  for (std::size_t end = out.find("]("); end != std::string::npos; end = out.find("](")) {
    out.erase(end, out.find(')', end) + 1 - end);
    out.erase(out.rfind('[', end), 1);
  }
  std::erase(out, '`');
  return out;
}

/// What an editor shows for a key.
std::string description(const Key& key) {
  std::string text = plain(key.type.name);
  if (!key.meaning.empty()) text += "; " + plain(key.meaning);
  if (key.otherwise == kRequired) return text + " (required)";
  return key.otherwise.empty() ? text : text + " (default: " + plain(key.otherwise) + ")";
}

/// A schema, which is an object, with a description.
std::string described(std::string schema, const std::string& words) {
  std::string text = "{\"description\":";
  append_json(text, words);
  return text + "," + schema.substr(1);
}

/// `{"anyOf": [{"required": [KEY]}, ...]}`.
std::string one_is_there(const std::vector<std::string_view>& keys) {
  std::string text = "{\"anyOf\":";
  append_json(text, keys, [&](std::string_view key) {
    text += "{\"required\":[";
    append_json(text, key);
    text += "]}";
  });
  return text + "}";
}

std::vector<std::string_view> required_keys(const Form& form) {
  std::vector<std::string_view> keys;
  for (const Key& key : form.keys) {
    if (key.otherwise == kRequired) keys.push_back(key.name);
  }
  return keys;
}

void append_partners(std::string& text, const Form& form) {
  JsonObject keys(text);
  for (const Key& key : form.keys) {
    if (key.excludes.empty() && key.needs.empty()) continue;
    JsonObject schema(keys.named(key.name));
    if (!key.needs.empty())
      append_json(schema.key("required"), std::vector{key.needs}, [&](auto k) { append_json(text, k); });
    if (key.excludes.empty()) continue;
    JsonObject others(schema.key("properties"));
    for (const std::string_view other : listed_keys(key.excludes)) others.named(other) += "false";
  }
}

void append_properties(std::string& text, std::span<const Key> keys) {
  JsonObject properties(text);
  for (const Key& key : keys) properties.named(key.name) += described(schema_of(key.type), description(key));
}

std::string map_schema(const Form& form) {
  std::string text = R"({"type":"object","properties":)";
  append_properties(text, form.keys);
  text += R"(,"patternProperties":{"^x-":true},"additionalProperties":false,"required":)";
  append_json(text, required_keys(form), [&](auto key) { append_json(text, key); });
  text += ",\"dependentSchemas\":";
  append_partners(text, form);
  if (!form.one_of.empty()) text += ",\"allOf\":[" + one_is_there(listed_keys(form.one_of)) + "]";
  if (!form.rule.empty()) text += "," + std::string(form.rule);
  return text + "}";
}

std::string form_schema(const Form& form) {
  const Key& first = form.keys.front();
  if (first.name.empty()) return described(schema_of(first.type), description(first));
  if (!form.first_alone) return map_schema(form);
  return "{\"anyOf\":[" + schema_of(first.type) + "," + map_schema(form) + "]}";
}

template <class Is>
std::vector<std::string_view> operators(Is is) {
  std::vector<std::string_view> names;
  for (const OperatorName& o : kOperators) {
    if (is(o.op)) names.push_back(o.name);
  }
  return names;
}

/// True for what is an attribute, too: beside another operator, or with a certain value.
bool may_be_attribute(std::string_view key) { return key == "regularize" || key == "simplify"; }

/// One leaf or operator: `regularize` with a node, `simplify` with anything but a mode.
std::string one_operation() {
  std::string text = "[";
  const auto add = [&](std::string_view key) { text += "{\"required\":[\"" + std::string(key) + "\"]},"; };
  for (const std::string_view leaf : leaf_names()) add(leaf);
  for (const OperatorName& o : kOperators) {
    if (!may_be_attribute(o.name)) add(o.name);
  }
  return text + R"({"required":["regularize"],"properties":{"regularize":{"not":{"type":"boolean"}}}},)" +
         R"({"required":["simplify"],"properties":{"simplify":{"not":{"enum":["features","points"]}}}}])";
}

std::string node_schema() {
  std::string text = R"({"type":"object","properties":)";
  append_properties(text, form("attribute").keys);
  text.pop_back();
  for (const std::string_view leaf : leaf_names())
    text += ",\"" + std::string(leaf) +
            "\":" + described(schema_of(leaf), "such as " + std::string(form(leaf).example));
  for (const Key& key : form("operator").keys) {
    if (!may_be_attribute(key.name))
      text += ",\"" + std::string(key.name) + "\":" + described(schema_of(key.type), description(key));
  }
  text += R"(},"patternProperties":{"^x-":true},"additionalProperties":false,"oneOf":)" + one_operation();
  const std::string unites = one_is_there(operators([](Operator op) { return op == Operator::unite; })),
                    has_side = one_is_there(operators(has_sides)),
                    topological = one_is_there(operators(is_topological)),
                    number = R"({"properties":{"dominance":{"$ref":"#/$defs/number"}}})";
  text += R"(,"dependentRequired":{"below":["within"],"above":["within"]},"dependentSchemas":{"within":)" +
          one_is_there({"below", "above"}) + ",\"blend\":{\"allOf\":[" + unites + "," + number +
          "]},\"dominance\":{\"anyOf\":[" + number + "," + has_side +
          R"(]},"each":{"anyOf":[{"properties":{"each":{"const":false}}},)" + topological + "]}}}";
  return text;
}

/// Words, each in backquotes.
std::string quoted_keys(const std::vector<std::string_view>& keys, const std::string& between) {
  std::string text;
  for (const std::string_view key : keys) text += (text.empty() ? "`" : between + "`") + std::string(key) + "`";
  return text;
}

std::string default_words(const Form& form, const Key& key) {
  std::vector<std::string_view> one_of = listed_keys(form.one_of);
  const bool is_one = std::erase(one_of, key.name) > 0;
  if (!key.otherwise.empty() || !is_one) return std::string(key.otherwise);
  return one_of.size() == 1 ? "this or " + quoted_keys(one_of, "") : "one of these";
}

std::string meaning_words(const Form& form, const Key& key) {
  std::string text(key.meaning);
  const auto add = [&](const std::string& words) { text += (text.empty() ? "" : "; ") + words; };
  if (!key.excludes.empty() && form.one_of.find(key.excludes) == std::string_view::npos)
    add("excludes " + quoted_keys(listed_keys(key.excludes), ", "));
  if (!key.needs.empty()) add("with `" + std::string(key.needs) + "`");
  return text;
}

/// Cells of a row of a table, from the second on where the first is `|`.
std::string row(const std::vector<std::string>& cells) {
  std::string text = "|";
  for (const std::string& cell : cells) text += (cell.empty() ? "" : " " + cell) + " |";
  return text + "\n";
}

/// What a table tells of a key: its value, default and meaning, or where these stand.
std::vector<std::string> cells_of(const Form& form, const Key& key) {
  if (!key.shown_at.empty() && key.shown_at != form.section)
    return {"[" + std::string(key.shown_at) + "](#" + std::string(key.shown_at) + ")", "", ""};
  return {std::string(key.type.name), default_words(form, key), meaning_words(form, key)};
}

/// The keys of a form, in one row where all but the name is the same; `owner` stands in the first row.
std::string rows_of(const Form& form, std::optional<std::string> owner, bool with_defaults) {
  std::string text;
  for (std::size_t i = 0; i < form.keys.size();) {
    const Key& key = form.keys[i];
    std::vector<std::string> cells = cells_of(form, key);
    std::vector<std::string_view> names;
    for (; i < form.keys.size() && cells_of(form, form.keys[i]) == cells; ++i) names.push_back(form.keys[i].name);
    const bool is_path = key.type.kind == Type::Kind::text;
    if (!with_defaults) cells.erase(cells.begin() + 1);
    cells.insert(cells.begin(), !key.name.empty() ? quoted_keys(names, " ") : is_path ? "path" : "list");
    if (owner) cells.insert(cells.begin(), std::exchange(*owner, ""));
    text += row(cells);
  }
  return text;
}

/// One row for a form with keys of an earlier one.
std::string row_of_likes(const Form& form, const std::string& owner, const Form& like) {
  std::vector<std::string_view> names;
  for (const Key& key : form.keys) names.push_back(key.name);
  return row({owner, quoted_keys(names, " "), "", "", "as for " + std::string(like.name)});
}

/// What stands above the first column: forms of one title make a table.
std::string title_of(const Form& form) {
  if (form.section == "file") return "key of the file";
  if (form.section == "fineness") return "key";
  if (form.section == "operators" || form.section == "attributes") return std::string(form.name);
  const auto leaves = leaf_names();
  return std::find(leaves.begin(), leaves.end(), form.name) == leaves.end() ? "part" : "leaf";
}

std::string table_of(std::span<const Form> forms) {
  const std::string title = title_of(forms.front());
  const bool with_owner = title == "leaf" || title == "part", with_defaults = title != "operator";
  std::vector<std::string> head{title, "value", "meaning"};
  if (with_owner) head.insert(head.begin() + 1, "key");
  if (with_defaults) head.insert(head.end() - 1, "default");
  std::string text = row(head) + row(std::vector<std::string>(head.size(), "---")), examples;
  for (std::size_t i = 0; i < forms.size(); ++i) {
    const Form& form = forms[i];
    const std::string name = title == "leaf" ? "`" + std::string(form.name) + "`" : std::string(form.name);
    const auto like =
        std::find_if(forms.begin(), forms.begin() + static_cast<std::ptrdiff_t>(i), [&](const Form& before) {
          return form.keys.data() >= before.keys.data() &&
                 form.keys.data() < before.keys.data() + before.keys.size();
        });
    if (like != forms.begin() + static_cast<std::ptrdiff_t>(i)) text += row_of_likes(form, name, *like);
    else text += rows_of(form, with_owner ? std::optional(name) : std::nullopt, with_defaults);
    if (!form.example.empty()) examples += std::string(form.name) + ": " + std::string(form.example) + "\n";
  }
  return examples.empty() ? text : text + "```yaml\n" + examples + "```\n";
}

}  // namespace

std::string tree_schema() {
  std::string text = R"({"$schema":"https://json-schema.org/draft/2020-12/schema","title":"cnrg: a tree file",)"
                     "\n\"$ref\":\"" +
                     reference("a tree file") + "\",\"$defs\":{\n\"node\":" + node_schema();
  const auto add = [&](std::string_view name, const std::string& schema) {
    text += ",\n\"" + reference(name).substr(8) + "\":" + schema;
  };
  for (const NamedSchema& one : kDefinitions) add(one.name, std::string(one.schema));
  for (const Form& form : all_forms()) {
    if (form.name != "operator" && form.name != "attribute" && form.name != "criteria" && form.name != "fineness")
      add(form.name, form_schema(form));
  }
  return text + "\n}}\n";
}

std::string key_tables() {
  const std::span<const Form> forms = all_forms();
  std::string text;
  for (std::size_t i = 0; i < forms.size();) {
    const std::string_view section = forms[i].section;
    std::vector<Form> shown;
    for (; i < forms.size() && (forms[i].section == section || forms[i].section.empty()); ++i) {
      if (!forms[i].section.empty()) shown.push_back(forms[i]);
    }
    if (!shown.empty())
      text += "<!-- keys: " + std::string(section) + " -->\n" + table_of(shown) + "<!-- /keys -->\n";
  }
  return text;
}

}  // namespace cnrg
