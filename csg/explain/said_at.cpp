#include "csg/explain/said_at.h"

#include <set>

#include "csg/materials/grade.h"

namespace cnrg {
namespace {

using Words = std::map<std::string, std::string>;  // what is said, by key

/// A text of an attribute is in quotes, since a number is none.
Words words_of(const Attributes* said) {
  Words words;
  if (said == nullptr) return words;
  if (!said->name.empty()) words["name"] = said->name;
  if (!said->material.empty()) words["material"] = said->material.name();
  for (const auto& [key, value] : said->properties) {
    const bool is_text = std::holds_alternative<std::string>(value);
    words[key] = is_text ? '"' + to_text(value) + '"' : to_text(value);
  }
  return words;
}

bool gives(const Node& node, const std::string& key) {
  if (key == "name") return !node.label.empty();
  if (key == "material") return !node.material.empty();
  return node.properties.contains(key);
}

/// Operators made one name, or one material, of several.
bool is_joined(const Attributes* said, const std::string& key) {
  if (said == nullptr) return false;
  if (key == "name") return said->name.parts().size() > 1;
  const PlacedGrade* const grade = said->material.grade();
  return key == "material" && grade != nullptr && std::holds_alternative<BlendGrade>(grade->grade.along);
}

std::string value_in(const Words& words, const std::string& key) {
  const auto it = words.find(key);
  return it == words.end() ? std::string() : it->second;
}

}  // namespace

const Attributes* SaidAt::of(const NodeValue& value, const Location& cell, const CellState& state) {
  if (state.component == 0) return nullptr;
  const bool of_component = cell.dimension == 3 || (state.group && !state.entity);
  if (!of_component) {
    const ValueSources& all = sources(value);
    const Attributes* const own = cell.dimension == 2   ? all.said(cell.face)
                                  : cell.dimension == 1 ? all.said(cell.edge)
                                                        : all.said(cell.vertex);
    if (own != nullptr || state.group) return own;
  }
  return &value.attributes(state.component);
}

const Attributes* SaidAt::around(const NodeValue& value, const Location& cell) {
  const ValueSources& all = sources(value);
  return cell.dimension == 2   ? all.said_around(cell.face)
         : cell.dimension == 1 ? all.said_around(cell.edge)
                               : all.said_around(cell.vertex);
}

const ValueSources& SaidAt::sources(const NodeValue& value) {
  std::unique_ptr<const ValueSources>& known = sources_[&value];
  if (known == nullptr) known = sources_of(complex_, value);
  return *known;
}

std::vector<Word> SaidAt::changes(const Node& node, const Attributes* said,
                                  const std::vector<std::pair<std::string, const Attributes*>>& operands,
                                  bool by_itself) {
  const bool is_leaf = operands.empty();
  const Words here = words_of(said);
  std::vector<std::pair<std::string, Words>> below;
  std::set<std::string> keys;
  for (const auto& [key, value] : here) keys.insert(key);
  for (const auto& [name, what] : operands) {
    below.emplace_back(name, words_of(what));
    for (const auto& [key, value] : below.back().second) keys.insert(key);
  }
  std::vector<Word> out;
  for (const std::string& key : keys) {
    Word word{key, value_in(here, key), {}, {}, {}};
    word.given = !word.value.empty() && (gives(node, key) || is_leaf);
    for (const auto& [name, words] : below) {
      const std::string other = value_in(words, key);
      if (other == word.value && !other.empty()) word.from.push_back(name);
      else if (!other.empty()) word.gave_way.emplace_back(name, other);
    }
    if (is_joined(said, key) && !word.given && word.from.empty()) {
      for (const auto& [name, value] : word.gave_way) word.from.push_back(name);
      word.gave_way.clear();
      out.push_back(std::move(word));
      continue;
    }
    if (key == "name" && !by_itself && node.label.empty()) {
      // A region is called after its leaf where nobody names it: that is told with its number.
      if (is_leaf || word.from.empty() || word.gave_way.empty()) continue;
    }
    if (word.given || !word.gave_way.empty()) out.push_back(std::move(word));
  }
  return out;
}

}  // namespace cnrg
