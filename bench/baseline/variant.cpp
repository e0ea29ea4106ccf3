// The kind is part of the name, the epsilon stands behind a colon, rules behind signs.
#include "bench/baseline/variant.h"

#include <regex>
#include <stdexcept>

#include "kernel/exact/rational.h"

namespace cnrg::bench::mantyla {
namespace {

const Departure& departure_of(const std::string& word, const std::string& name) {
  std::string known;
  for (const Departure& departure : kDepartures) {
    if (word == departure.name) return departure;
    known += (known.empty() ? "" : ", ") + std::string(departure.name);
  }
  throw std::runtime_error("'" + name + "' has no rule '" + word + "'; rules are " + known);
}

/// `+RULE` and `-RULE` after another; each changes something.
std::vector<Change> change_rules(Departures& departures, const std::string& rules, const std::string& name) {
  static const std::regex rule("[+-][a-z]+");
  std::vector<Change> changes;
  for (auto it = std::sregex_iterator(rules.begin(), rules.end(), rule); it != std::sregex_iterator(); ++it) {
    const std::string text = it->str(), word = text.substr(1);
    const bool on = text[0] == '+';
    const Departure& departure = departure_of(word, name);
    bool& value = departures.*departure.rule;
    if (value == on)
      throw std::runtime_error("'" + name + "': the rule '" + word + "' is " + (on ? "on" : "off") + " already");
    value = on;
    changes.push_back({&departure, on});
  }
  return changes;
}

double epsilon_of(const std::string& text, const std::string& name) {
  const std::optional<Rational> epsilon = parse_rational(text);
  if (!epsilon || *epsilon <= 0 || *epsilon >= 1)
    throw std::runtime_error("'" + name + "' has no epsilon between 0 and 1, such as mantyla-double:1e-8");
  return to_double(*epsilon);
}

}  // namespace

std::optional<Variant> parse_variant(const std::string& name) {
  static const std::regex form("mantyla-(double|exact|published-exact|published)(:(.*?))?(([+-][a-z]+)*)");
  std::smatch parts;
  if (!std::regex_match(name, parts, form)) return {};
  const std::string kind = parts[1];
  Variant variant;
  variant.fractions = kind.ends_with("exact");
  if (variant.fractions && parts[2].matched) throw std::runtime_error("'" + name + "': fractions have no epsilon");
  if (kind.starts_with("published")) variant.departures = published();
  variant.changes = change_rules(variant.departures, parts[4], name);
  if (parts[2].matched) variant.epsilon = epsilon_of(parts[3], name);
  return variant;
}

}  // namespace cnrg::bench::mantyla
