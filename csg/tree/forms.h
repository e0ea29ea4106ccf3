// What a tree file may say: a table for each map with known keys, of its keys with their types, defaults and
// meaning.
//
// Readers check and read maps by these tables (`Fields` of yaml_value.h); the JSON schema of a tree file and the
// tables of csg/FORMATS.md are printed from them (schema.h). So a key that is added here is known everywhere.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace cnrg {

/// What the value of a key is.
struct Type {
  enum class Kind : std::uint8_t { number, count, point, pair, points, loops, text, boolean, choice, other };
  Kind kind;
  std::string_view name;  ///< on the page: `number > 0`
  std::string_view hint;  ///< what a message proposes: `[x, y, z]`
  /// A definition or a form by name, `[TYPE]` a list, `[TYPE;3]` of three, `[TYPE;2+]` of two or more, `{TYPE}` a
  /// map with keys of any name, `TYPE|TYPE` either; empty of counts and choices.
  std::string_view schema;
  std::span<const std::string_view> choices{};
  std::int64_t least = 0, most = 0;  ///< of a count
};

inline constexpr std::string_view kRequired = "required";

struct Key {
  std::string_view name;  ///< empty: the value itself, which is no map, has the type
  const Type& type;
  std::string_view otherwise{};  ///< the default, or `kRequired`; empty where there is none to tell
  std::string_view meaning{};
  std::string_view excludes{};  ///< keys that may not stand beside this one, separated by commas
  std::string_view needs{};     ///< the key that has to stand beside this one
  std::string_view shown_at{};  ///< the section of the page that has its row; others refer to it
};

/// A map with known keys.
struct Form {
  std::string_view name;     ///< in messages and on the page
  std::string_view section;  ///< of the page; empty: the page does not show it
  std::span<const Key> keys;
  std::string_view example{};  ///< of a value
  std::string_view one_of{};   ///< keys of which one is needed, separated by commas
  std::string_view rule{};     ///< members of the JSON schema that no table says
  bool first_alone = false;    ///< the value of the first key may stand for the map

  const Key* find(std::string_view key) const;
};

/// The keys in a list with commas.
std::vector<std::string_view> listed_keys(std::string_view list);

/// The form of that name.
const Form& form(std::string_view name);

/// All of them, in the order of the page.
std::span<const Form> all_forms();

}  // namespace cnrg
