// Reads keys.inc, line by line, once.
#include "csg/tree/forms.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>

#include "kernel/base/error.h"

namespace cnrg {
namespace {

constexpr std::string_view kText =
#include "csg/tree/keys.inc"
    ;

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
  return text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
}

/// The cells of a line: a bar with a blank before it ends one.
std::vector<std::string_view> cells_of(std::string_view line) {
  const bool in_table = line.starts_with('|');
  std::vector<std::string_view> cells;
  if (in_table) line.remove_prefix(1);
  for (std::size_t end = line.find(" |"); end != std::string_view::npos; end = line.find(" |")) {
    cells.push_back(trimmed(line.substr(0, end)));
    line.remove_prefix(end + 2);
  }
  if (!in_table) cells.push_back(trimmed(line));
  return cells;
}

/// The words between backquotes that follow the text at once, with commas or blanks between them.
std::vector<std::string_view> quoted_words(std::string_view text) {
  std::vector<std::string_view> words;
  while (text.starts_with('`')) {
    const std::size_t end = text.find('`', 1);
    words.push_back(text.substr(1, end - 1));
    text.remove_prefix(std::min(text.find_first_not_of(", ", end + 1), text.size()));
  }
  return words;
}

std::vector<std::string_view> words_after(std::string_view text, std::string_view mark) {
  const std::size_t at = text.find(mark);
  return at == std::string_view::npos ? std::vector<std::string_view>()
                                      : quoted_words(text.substr(at + mark.size()));
}

Type type_of(const std::vector<std::string_view>& cells) {
  constexpr std::array<std::string_view, 10> kKinds{"number", "count", "point",   "pair",   "points",
                                                    "loops",  "text",  "boolean", "choice", "other"};
  const auto kind = std::find(kKinds.begin(), kKinds.end(), cells.at(1)) - kKinds.begin();
  Type type{Type::Kind(kind), cells[0], cells.at(2), cells.at(3)};
  if (type.kind == Type::Kind::choice) type.choices = quoted_words(type.schema.empty() ? type.name : type.schema);
  if (type.kind == Type::Kind::points || type.kind == Type::Kind::loops) {
    constexpr std::string_view kLeast = R"(/point"},"minItems":)";
    const std::size_t at = type.schema.find(kLeast);
    if (at != std::string_view::npos)
      std::from_chars(type.schema.data() + at + kLeast.size(), type.schema.data() + type.schema.size(),
                      type.least);
  }
  if (type.kind == Type::Kind::count) {
    const char* const end = type.schema.data() + type.schema.size();
    std::from_chars(std::from_chars(type.schema.data(), end, type.least).ptr + 2, end, type.most);
  }
  return type;
}

/// All that the text says.
class KeyText {
 public:
  KeyText() {
    for (std::string_view text = kText, line; !text.empty(); text.remove_prefix(line.size() + 1)) {
      line = text.substr(0, text.find('\n'));
      if (line.starts_with("<!-- ")) part_ = line;
      else if (line.starts_with("```")) part_ = kExamples;
      else if (!line.empty()) read(line);
    }
    Form& criteria = forms.emplace_back(form("select"));
    criteria.name = "criteria";
    criteria.keys.erase(criteria.keys.begin());
  }
  const Form& form(std::string_view name) const {
    const auto it = std::find_if(forms.begin(), forms.end(), [&](const Form& f) { return f.name == name; });
    require(it != forms.end(), "form: there is no such one");
    return *it;
  }

  std::vector<Form> forms;
  std::vector<NamedSchema> schemas;

 private:
  static constexpr std::string_view kExamples = "examples";

  void read(std::string_view line) {
    if (part_ == kExamples) {
      const std::size_t colon = line.find(": ");
      const_cast<Form&>(form(line.substr(0, colon))).example = line.substr(colon + 2);
      return;
    }
    const std::vector<std::string_view> cells = cells_of(line);
    if (part_.starts_with("<!-- types")) types_.emplace(cells[0], type_of(cells));
    else if (part_.starts_with("<!-- schemas")) schemas.push_back({cells[0], cells.at(1)});
    else if (part_.starts_with("<!-- rules")) rules_.emplace(cells[0], cells.at(1));
    else if (!line.starts_with("|---")) read_row(cells);
  }

  /// The head of a table, or a row of it.
  void read_row(std::vector<std::string_view> cells) {
    const auto value = std::find(cells.begin(), cells.end(), "value");
    if (value != cells.end()) {
      has_owner_ = cells.at(1) == "key";
      has_default_ = cells.at(cells.size() - 2) == "default";
      if (!has_owner_)
        add_form(cells[0] == "key" ? "fineness" : cells[0] == "key of the file" ? "a tree file" : cells[0]);
      return;
    }
    if (has_owner_ && !cells[0].empty())
      add_form(cells[0].starts_with('`') ? quoted_words(cells[0])[0] : cells[0]);
    cells.erase(cells.begin(), cells.begin() + (has_owner_ ? 1 : 0));
    if (!has_default_) cells.insert(cells.begin() + 2, "");
    std::vector<std::string_view> names = quoted_words(cells[0]);
    if (names.empty()) names.push_back("");
    for (const std::string_view name : names) add_key(name, cells[1], cells[2], cells[3]);
  }

  void add_form(std::string_view name) {
    const auto rule = rules_.find(name);
    forms.push_back({.name = name, .rule = rule == rules_.end() ? "" : rule->second});
  }

  void add_key(std::string_view name, std::string_view value, std::string_view otherwise,
               std::string_view meaning) {
    Form& form = forms.back();
    if (meaning.find("alone in place of the map") != std::string_view::npos) form.first_alone = true;
    if (otherwise.empty() && value.empty()) return form.keys.push_back(*like(meaning.substr(7)).find(name));
    if (otherwise.starts_with("this or ") || otherwise == "one or more of these") form.one_of.push_back(name);
    const auto type = types_.find(value);
    if (type == types_.end()) return form.keys.push_back(*this->form("fineness").find(name));
    const std::vector<std::string_view> needs = words_after(meaning, "with ");
    form.keys.push_back({name, &type->second, otherwise, meaning, words_after(meaning, "excludes "),
                         needs.empty() ? "" : needs[0]});
  }

  /// The form in `as for FORM; ...`.
  const Form& like(std::string_view words) const { return form(words.substr(0, words.find(';'))); }

  std::string_view part_;
  bool has_owner_ = false, has_default_ = false;
  std::map<std::string_view, Type> types_;
  std::map<std::string_view, std::string_view> rules_;
};

const KeyText& key_text() {
  static const KeyText text;
  return text;
}

}  // namespace

const Key* Form::find(std::string_view key) const {
  const auto it = std::find_if(keys.begin(), keys.end(), [&](const Key& k) { return k.name == key; });
  return it == keys.end() ? nullptr : &*it;
}

const Form& form(std::string_view name) { return key_text().form(name); }

const std::vector<Form>& all_forms() { return key_text().forms; }

const std::vector<NamedSchema>& definitions() { return key_text().schemas; }

std::string_view key_tables() { return kText.substr(kText.find("<!-- keys: ")); }

}  // namespace cnrg
