// Strict reading of YAML values: each reader says what it wants, and fails with the place and an excerpt of what
// is there instead.
#include "csg/tree/yaml_value.h"

#include <yaml-cpp/depthguard.h>
#include <yaml-cpp/eventhandler.h>

#include <algorithm>
#include <sstream>
#include <unordered_set>

#include "csg/text/escape.h"
#include "csg/text/number.h"
#include "csg/tree/suggest.h"
#include "kernel/base/error.h"
#include "kernel/exact/integers.h"

namespace cnrg {
namespace {

constexpr std::size_t kMostMerged = 100;  // maps under `<<` in each other

Position position_of(const YAML::Mark& mark, Position otherwise) {
  return mark.is_null() ? otherwise : Position{mark.line + 1, mark.column + 1};
}

/// The beginning of a text in quotes.
std::string quoted(const std::string& text) { return "`" + excerpt(text) + "`"; }

std::string words_of(const YAML::Node& node) {
  switch (node.Type()) {
    case YAML::NodeType::Scalar: return "the text " + quoted(node.Scalar());
    case YAML::NodeType::Sequence:
      return node.size() == 1 ? "a list of one" : "a list of " + std::to_string(node.size());
    case YAML::NodeType::Map: return "a map";
    default: return "empty";
  }
}

/// Notes where the content of a document begins.
class Beginning : public YAML::EventHandler {
 public:
  const std::optional<YAML::Mark>& mark() const { return mark_; }
  void OnDocumentStart(const YAML::Mark&) override { mark_.reset(); }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t) override { note(mark); }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override { note(mark); }
  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t, const std::string&) override {
    note(mark);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    note(mark);
  }
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {
    note(mark);
  }
  void OnMapEnd() override {}

 private:
  void note(const YAML::Mark& mark) {
    if (!mark_) mark_ = mark;
  }
  std::optional<YAML::Mark> mark_;
};

/// yaml-cpp takes any bytes for UTF-8, unless the text begins as one of UTF-16 or UTF-32, which it converts.
void check_encoding(const Document& document, const std::string& text) {
  const auto begins = [&](std::string_view bytes) { return std::string_view(text).starts_with(bytes); };
  if (begins("\xfe\xff") || begins("\xff\xfe") || text.find('\0') < 4) return;
  const std::size_t at = first_invalid(text);
  if (at == text.size()) return;
  const std::string_view before = std::string_view(text).substr(0, at);
  const std::size_t line_begin = before.rfind('\n') + 1;  // npos + 1 is 0
  const Position position{1 + static_cast<int>(std::count(before.begin(), before.end(), '\n')),
                          1 + static_cast<int>(before.size() - line_begin)};
  document.fail(position, "the byte " + shown(text.substr(at, 1)) + " is no UTF-8; save the file as UTF-8");
}

/// The text must hold one document and nothing else. `YAML::Load` stops silently after the first one, and
/// `YAML::LoadAll` never ends where a bracket or comma belongs to nothing, so documents are counted to two here.
void check_one_document(const Document& document, const std::string& text) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  Beginning beginning;
  if (!parser.HandleNextDocument(beginning)) {
    document.fail({}, "the file is empty; a tree file begins with `cnrg: 1`");
  }
  if (parser.HandleNextDocument(beginning)) {
    document.fail(position_of(beginning.mark().value_or(YAML::Mark()), {}),
                  "a second document begins here, or text that belongs to nothing; a tree file is one map");
  }
}

}  // namespace

Value::Value(Document& document, const YAML::Node& node, Position key_at)
    : document_(&document), node_(node), at_(node.IsNull() ? key_at : position_of(node.Mark(), key_at)) {
  if (document.values_left == 0) {
    throw TreeLimitError(
        document.file, at_,
        "the aliases and `repeat` of this file repeat too much: it yields far more values than it has letters; "
        "write one node and use it by name instead");
  }
  --document.values_left;
}

const std::string& Value::computed() const {
  if (computed_) return *computed_;
  try {
    computed_ = std::make_shared<const std::string>(with_values(node_.Scalar(), document_->parameters));
  } catch (const InputError& e) {
    fail(e.what());
  }
  if (computed_->size() > document_->values_left)
    throw TreeLimitError(
        document_->file, at_,
        "the values of expressions in this file are too long: they have far more letters than the "
        "file");
  document_->values_left -= computed_->size();
  return *computed_;
}

void Value::fail_type(const std::string& what, const std::string& wanted) const {
  fail(what + " must be " + wanted + ", not " + words_of(node_));
}

std::optional<bool> Value::as_bool() const {
  if (!is_text() || is_quoted()) return std::nullopt;
  const std::string& s = raw();
  if (s == "true" || s == "True" || s == "TRUE") return true;
  if (s == "false" || s == "False" || s == "FALSE") return false;
  return std::nullopt;
}

std::string Value::text(const std::string& what) const {
  if (!is_text()) fail_type(what, "a text");
  if (raw().empty()) fail(what + " must not be empty");
  return raw();
}

bool Value::boolean(const std::string& what) const {
  const std::optional<bool> value = as_bool();
  if (!value) fail_type(what, "true or false");
  return *value;
}

Rational Value::number(const std::string& what) const {
  if (!is_text()) fail_type(what, "a number");
  NumberText number = read_number(raw());
  if (number.value) return std::move(*number.value);
  try {
    evaluate_expression(raw(), document_->parameters);
  } catch (const InputError&) {
    fail(what + ": " + quoted(raw()) + number.fault);
  }
  fail(what + ": " + quoted(raw()) + number.fault + "; an expression is written \"${" + excerpt(raw()) + "}\"");
}

std::int64_t Value::integer(const std::string& what, std::int64_t low, std::int64_t high) const {
  const Rational value = number(what);
  if (value.get_den() != 1 || value < to_integer(low) || value > to_integer(high)) {
    fail(what + " must be a whole number from " + std::to_string(low) + " to " + std::to_string(high) + ", not " +
         quoted(raw()));
  }
  return to_machine<std::int64_t>(value.get_num());
}

std::vector<Value> Value::list(const std::string& what, const std::string& wanted) const {
  if (!is_list()) fail_type(what, wanted);
  std::vector<Value> items;
  items.reserve(node_.size());
  for (const auto& item : node_) items.emplace_back(*document_, item, position_of(item.Mark(), at_));
  return items;
}

std::vector<Rational> Value::numbers(const std::string& what, std::size_t n, const std::string& wanted) const {
  const std::vector<Value> items = list(what, wanted);
  if (items.size() != n) fail_type(what, wanted);
  std::vector<Rational> result;
  result.reserve(n);
  for (const Value& item : items) result.push_back(item.number(what));
  return result;
}

RationalPoint Value::point(const std::string& what) const {
  std::vector<Rational> n = numbers(what, 3, "a list of three numbers [x, y, z]");
  return {std::move(n[0]), std::move(n[1]), std::move(n[2])};
}

std::array<Rational, 2> Value::pair(const std::string& what) const {
  std::vector<Rational> n = numbers(what, 2, "a list of two numbers [x, y]");
  return {std::move(n[0]), std::move(n[1])};
}

std::vector<RationalPoint> Value::points(const std::string& what, int least) const {
  if (is_list() && node_.size() < static_cast<std::size_t>(least))
    fail_type(what, "a list of " + std::to_string(least) + (least == 1 ? " point" : " points") + " or more");
  std::vector<RationalPoint> result;
  const std::string each = "each point of " + what;
  for (const Value& item : list(what, "a list of points [[x, y, z], ...]")) result.push_back(item.point(each));
  return result;
}

std::vector<std::vector<RationalPoint>> Value::loops(const std::string& what, int least) const {
  std::vector<std::vector<RationalPoint>> result;
  const std::string each = "each loop of " + what;
  for (const Value& item : list(what, "a list of loops [[[x, y, z], ...], ...]"))
    result.push_back(item.points(each, least));
  return result;
}

std::vector<Value::Entry> Value::entries(const std::string& what, std::string_view first) const {
  if (!is_map()) fail_type(what, "a map {" + std::string(first) + ": value, ...}");
  std::vector<YAML::Node> around;
  return entries(what, around);
}

std::vector<Value::Entry> Value::entries(const std::string& what, std::vector<YAML::Node>& around) const {
  if (std::ranges::any_of(around, [&](const YAML::Node& node) { return node.is(node_); }))
    fail("this map is merged into itself; remove the `<<` that names it");
  if (around.size() == kMostMerged)
    fail("more than " + std::to_string(kMostMerged) + " maps are merged into each other; merge fewer");
  if (!is_map()) fail_type(what, "a map {key: value, ...}");
  around.push_back(node_);
  std::vector<Entry> entries;
  std::unordered_set<std::string> own, merged;
  std::optional<std::pair<std::size_t, std::vector<Value>>> maps;  // under `<<`, and before which entry
  for (const auto& item : node_) {
    const Position key_at = position_of(item.first.Mark(), at_);
    if (!item.first.IsScalar())
      document_->fail(key_at, "a key of " + what + " must be a text, not " + words_of(item.first));
    const std::string key = item.first.Scalar().find("${") == std::string::npos
                                ? item.first.Scalar()
                                : Value(*document_, item.first, at_).raw();
    const bool merges = key == "<<" && item.first.Tag() == "?";  // neither quoted nor tagged
    if (merges ? maps.has_value() : !own.insert(key).second) {
      document_->fail(key_at, "the key " + quoted(key) + " is there twice in " + what + "; remove or rename one");
    }
    Value value(*document_, item.second, key_at);
    if (!merges) entries.push_back({key, key_at, value});
    else if (value.is_map()) maps.emplace(entries.size(), std::vector{value});
    else maps.emplace(entries.size(), value.list("`<<`", "a map, or a list of maps"));
  }
  std::vector<Entry> result;
  for (std::size_t i = 0; i <= entries.size(); ++i) {
    if (maps && i == maps->first) {
      for (const Value& map : maps->second) {
        for (Entry& e : map.entries("`<<`", around)) {
          if (!own.contains(e.key) && merged.insert(e.key).second) result.push_back(std::move(e));
        }
      }
    }
    if (i < entries.size()) result.push_back(std::move(entries[i]));
  }
  around.pop_back();
  return result;
}

std::map<std::string, Position> places_of_values(const Value& value) {
  if (!value.is_map()) return {{"", value.at()}};
  std::map<std::string, Position> places;
  for (const auto& item : value.node()) {
    if (item.first.IsScalar()) places.emplace(item.first.Scalar(), position_of(item.second.Mark(), value.at()));
  }
  return places;
}

Fields::Fields(const Value& map, const Form& form, std::string what, Faults* faults)
    : map_(map),
      form_(form),
      what_(what.empty() ? std::string(form.name) : std::move(what)),
      entries_(map.entries(what_, form.keys.empty() || form.keys[0].name.empty() ? "key" : form.keys[0].name)) {
  Faults own;
  check_keys(own);
  if (own.empty()) check_presence(own);  // what is missing may be what is misspelt
  if (faults) faults->attempt([&] { own.raise(); });
  else own.raise();
}

void Fields::check_keys(Faults& faults) const {
  for (const Value::Entry& e : entries_) {
    if (is_of_others(e.key) || form_.find(e.key)) continue;
    std::vector<std::string_view> allowed;
    std::string known;
    for (const Key& k : form_.keys) {
      allowed.push_back(k.name);
      known += (known.empty() ? "" : ", ") + std::string(k.name);
    }
    const std::string hint = did_you_mean(e.key, allowed);
    faults.attempt([&] {
      map_.document().fail(e.key_at, "unknown key " + quoted(e.key) + " in " + what_ +
                                         (hint.empty() ? "; known are: " + known : hint));
    });
  }
}

void Fields::fail_missing(const std::vector<std::string_view>& keys) const {
  std::string words;
  for (std::size_t i = 0; i < keys.size(); ++i)
    words += (i == 0 ? "`" : i + 1 == keys.size() ? " or `" : ", `") + std::string(keys[i]) + "`";
  map_.fail(what_ + " needs " + words + "; add `" + std::string(keys[0]) + ": " +
            std::string(form_.find(keys[0])->type->hint) + "`");
}

void Fields::check_partners(const Key& key, const Value::Entry& e) const {
  for (const std::string_view other : key.excludes) {
    const Value::Entry* o = entry(other);
    if (!o) continue;
    const auto [first, second] = std::minmax({&e, o});
    map_.document().fail(second->key_at,
                         what_ + " has `" + first->key + "` and `" + second->key + "`; remove one of them");
  }
  if (!key.needs.empty() && !has(key.needs)) fail_missing({key.needs});
}

void Fields::check_presence(Faults& faults) const {
  for (const Key& key : form_.keys) {
    faults.attempt([&] {
      if (const Value::Entry* e = entry(key.name)) check_partners(key, *e);
      else if (key.is_required()) fail_missing({key.name});
    });
  }
  const std::vector<std::string_view>& keys = form_.one_of;
  if (!keys.empty() && std::none_of(keys.begin(), keys.end(), [&](auto key) { return has(key); }))
    faults.attempt([&] { fail_missing(keys); });
}

const Value& Fields::value_of(std::string_view key, Type::Kind kind) const {
  const Key* known = form_.find(key);
  require(known && known->type->kind == kind, "Fields: a key that the form has not, or as another type");
  return at(key);
}

std::string Fields::list_words(std::string_view key) const {
  const Type& type = *form_.find(key)->type;
  return (type.name.starts_with("list of") ? "a " : "a list of ") + std::string(type.name) + " " +
         std::string(type.hint);
}

void Fields::read_text(std::string_view key, std::string& to) const {
  const std::vector<std::string_view>& choices = form_.find(key)->type->choices;
  const Value& value = value_of(key, choices.empty() ? Type::Kind::text : Type::Kind::choice);
  to = value.text(name(key));
  if (choices.empty() || std::find(choices.begin(), choices.end(), to) != choices.end()) return;
  std::string words;
  for (const std::string_view choice : choices) words += (words.empty() ? "" : ", ") + std::string(choice);
  value.fail_type(name(key), "one of " + words);
}

const Value::Entry* Fields::entry(std::string_view key) const {
  for (const Value::Entry& e : entries_) {
    if (e.key == key) return &e;
  }
  return nullptr;
}

const Value* Fields::find(std::string_view key) const {
  const Value::Entry* e = entry(key);
  return e ? &e->value : nullptr;
}

const Value& Fields::at(std::string_view key) const {
  const Value* value = find(key);
  require(value, "Fields: a key that is not there");
  return *value;
}

namespace {

/// A tabulator among the blanks before a word: the reason why a text is no YAML, which yaml-cpp tells elsewhere.
void check_indentation(const Document& document, std::string_view text, int last_line) {
  int line = 1;
  for (std::size_t begin = 0; begin < text.size() && line <= last_line + 1; ++line) {
    const std::size_t word = std::min(text.find_first_not_of(" \t", begin), text.size());
    const std::size_t tab = std::min(text.find('\t', begin), text.size());
    if (tab < word && word < text.size() && text[word] != '\n' && text[word] != '\r' && text[word] != '#') {
      document.fail({line, static_cast<int>(tab - begin) + 1},
                    "a tabulator indents this line, which YAML does not allow; replace it by blanks");
    }
    const std::size_t end = text.find('\n', begin);
    if (end == std::string_view::npos) return;
    begin = end + 1;
  }
}

}  // namespace

YAML::Node load_yaml(const Document& document, const std::string& text) {
  check_encoding(document, text);
  try {
    check_one_document(document, text);
    return YAML::Load(text);
  } catch (const YAML::DeepRecursion& e) {
    document.fail(position_of(e.mark, {}),
                  "lists and maps are nested too deep here; give the inner nodes names in "
                  "`nodes` and use these as operands");
  } catch (const YAML::Exception& e) {
    check_indentation(document, text, position_of(e.mark, {}).line);
    document.fail(position_of(e.mark, {}),
                  "this is no YAML: " + e.msg + "; mend the brackets, quotes or indentation here or just before");
  }
}

}  // namespace cnrg
