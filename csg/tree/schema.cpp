// A definition for each form, beside those of keys.inc, to which types refer by name. The schema is put together
// as text, a line for each definition.
#include <algorithm>
#include <string_view>
#include <vector>

#include "csg/text/json_text.h"
#include "csg/tree/forms.h"
#include "csg/tree/operator_names.h"
#include "csg/tree/read_leaf.h"

namespace cnrg {
namespace {

/// A name as it stands in references: nothing in it has to be escaped.
std::string identifier(std::string_view name) {
  std::string id(name);
  std::replace(id.begin(), id.end(), ' ', '-');
  return id;
}

std::string reference(std::string_view name) { return R"({"$ref":"#/$defs/)" + identifier(name) + "\"}"; }

std::string list_of(const std::vector<std::string_view>& words) {
  std::string text;
  append_json(text, words, [&](std::string_view word) { append_json(text, word); });
  return text;
}

std::string schema_of(const Type& type) {
  if (type.kind == Type::Kind::choice) return "{\"enum\":" + list_of(type.choices) + "}";
  if (type.kind != Type::Kind::count)
    return type.schema.starts_with('{') ? std::string(type.schema) : reference(type.schema);
  return R"({"anyOf":[{"type":"integer","minimum":)" + std::to_string(type.least) +
         ",\"maximum\":" + std::to_string(type.most) + "}," + reference("number as text") + "]}";
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

/// The schema of a key, with what an editor shows of it.
std::string schema_of(const Key& key) {
  std::string words = plain(key.type->name), text = "{\"description\":";
  if (!key.meaning.empty()) words += "; " + plain(key.meaning);
  if (key.is_required()) words += " (required)";
  else if (!key.otherwise.empty()) words += " (default: " + plain(key.otherwise) + ")";
  append_json(text, words);
  return text + "," + schema_of(*key.type).substr(1);
}

/// One of the keys is there.
std::string any_of(const std::vector<std::string_view>& keys) {
  std::string text = "{\"anyOf\":";
  append_json(text, keys, [&](std::string_view key) { text += "{\"required\":" + list_of({key}) + "}"; });
  return text + "}";
}

void append_properties(std::string& text, const std::vector<Key>& keys) {
  JsonObject properties(text);
  for (const Key& key : keys) properties.named(key.name) += schema_of(key);
}

/// Which keys a key excludes, and which it needs.
void append_partners(std::string& text, const std::vector<Key>& keys) {
  JsonObject partners(text);
  for (const Key& key : keys) {
    if (key.excludes.empty() && key.needs.empty()) continue;
    JsonObject schema(partners.named(key.name));
    if (!key.needs.empty()) schema.key("required") += list_of({key.needs});
    JsonObject others(schema.key("properties"));
    for (const std::string_view other : key.excludes) others.named(other) += "false";
  }
}

std::string map_schema(const Form& form) {
  std::vector<std::string_view> required;
  for (const Key& key : form.keys) {
    if (key.is_required()) required.push_back(key.name);
  }
  std::string text = R"({"type":"object","properties":)";
  append_properties(text, form.keys);
  text += R"(,"patternProperties":{"^x-":true},"additionalProperties":false)";
  if (!required.empty()) text += ",\"required\":" + list_of(required);
  text += ",\"dependentSchemas\":";
  append_partners(text, form.keys);
  if (!form.one_of.empty()) text += ",\"allOf\":[" + any_of(form.one_of) + "]";
  return text + (form.rule.empty() ? "" : "," + std::string(form.rule)) + "}";
}

std::string form_schema(const Form& form) {
  if (form.keys[0].name.empty()) return schema_of(form.keys[0]);
  if (!form.first_alone) return map_schema(form);
  return "{\"anyOf\":[" + schema_of(*form.keys[0].type) + "," + map_schema(form) + "]}";
}

/// What is an attribute, too, beside another operator or with a certain value.
bool may_be_attribute(std::string_view key) { return key == "regularize" || key == "simplify"; }

/// Exactly one leaf or operator; of the two that may be attributes one with such a value.
std::string node_schema() {
  std::vector<Key> keys = form("operator").keys;
  std::string leaves, operations;
  for (const std::string_view leaf : leaf_names()) {
    leaves += "," + list_of({leaf}).substr(1);
    leaves.back() = ':';
    std::string words = "{\"description\":";
    append_json(words, "such as " + std::string(form(leaf).example));
    leaves += words + "," + reference(leaf).substr(1);
    operations += "{\"required\":" + list_of({leaf}) + "},";
  }
  for (const Key& key : keys) {
    if (!may_be_attribute(key.name)) operations += "{\"required\":" + list_of({key.name}) + "},";
  }
  for (const Key& key : form("attribute").keys) {
    if (!may_be_attribute(key.name)) keys.push_back(key);
  }
  std::string text = R"({"type":"object","properties":)";
  append_properties(text, keys);
  text.pop_back();
  return text + leaves + R"(},"patternProperties":{"^x-":true},"additionalProperties":false,"oneOf":[)" +
         operations +
         R"({"required":["regularize"],"properties":{"regularize":{"not":{"type":"boolean"}}}},)"
         R"({"required":["simplify"],"properties":{"simplify":{"not":{"enum":["features","points"]}}}}],)" +
         std::string(form("attribute").rule) + "}";
}

}  // namespace

std::string tree_schema() {
  std::string text = R"({"$schema":"https://json-schema.org/draft/2020-12/schema","title":"cnrg: a tree file",)"
                     "\n\"$ref\":\"#/$defs/a-tree-file\",\"$defs\":{\n\"node\":" +
                     node_schema();
  const auto add = [&](std::string_view name, const std::string& schema) {
    text += ",\n\"" + identifier(name) + "\":" + schema;
  };
  for (const NamedSchema& one : definitions()) add(one.name, std::string(one.schema));
  for (const Form& form : all_forms()) {
    if (form.name != "operator" && form.name != "attribute" && form.name != "criteria" && form.name != "fineness")
      add(form.name, form_schema(form));
  }
  return text + "\n}}\n";
}

}  // namespace cnrg
