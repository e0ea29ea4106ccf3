// What a tree file may say: for each map with known keys these, with their types, defaults and meaning.
//
// They stand in keys.inc, as the tables that csg/FORMATS.md shows. Readers check and read maps by them (`Fields`
// of yaml_value.h), and the JSON schema of a tree file is made of them (schema.cpp): a key that is added there is
// known everywhere. A reader that asks for a key that no table has, or as another type, is an InvariantError.
//
// What is read in the words of a table: `required` as the default; `this or ...` and `one or more of these`, of
// which one is needed; `excludes` and `with` before keys in the meaning; `alone in place of the map`.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cnrg {

/// What the value of a key is.
struct Type {
  enum class Kind : std::uint8_t { number, count, point, pair, points, loops, text, boolean, choice, other };
  Kind kind = Kind::other;
  std::string_view name;  ///< on the page: `number > 0`
  std::string_view hint;  ///< what a message proposes: `[x, y, z]`
  std::string_view
      schema;  ///< a JSON schema, or the name of a form or a definition; of choices and counts what they are
  std::vector<std::string_view> choices{};
  int least = 0, most = 0;  ///< of a count; how many points each list has at least
};

struct Key {
  std::string_view name;  ///< empty: the value itself, which is no map, has the type
  const Type* type;
  std::string_view otherwise;  ///< the default, or `required`
  std::string_view meaning;
  std::vector<std::string_view> excludes{};  ///< keys that may not stand beside this one
  std::string_view needs{};                  ///< the key that has to stand beside this one
  bool is_required() const { return otherwise == "required"; }
};

/// A map with known keys.
struct Form {
  std::string_view name;  ///< in messages
  std::vector<Key> keys{};
  std::vector<std::string_view> one_of{};  ///< keys of which one is needed
  std::string_view example{}, rule{};      ///< of a value; members of its JSON schema that no table says
  bool first_alone = false;                ///< the value of the first key may stand for the map

  const Key* find(std::string_view key) const;
};

/// The form of that name.
const Form& form(std::string_view name);

struct NamedSchema {
  std::string_view name, schema;
};

/// All of them, in the order of the page.
const std::vector<Form>& all_forms();

/// JSON schemas of what types are made of.
const std::vector<NamedSchema>& definitions();

/// The tables as the page has them, each between `<!-- keys: NAME -->` and `<!-- /keys -->`.
std::string_view key_tables();

/// The JSON Schema (draft 2020-12) of a tree file (schema.cpp). What it cannot say: which names there are, how
/// values depend on each other, what an expression is worth.
std::string tree_schema();

}  // namespace cnrg
