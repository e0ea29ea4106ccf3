// Rules for two attributes that meet; operators only say which of the two dominates.
#include "csg/materials/attributes.h"

#include <algorithm>
#include <functional>
#include <tuple>

#include "kernel/exact/rational.h"

namespace cnrg {

std::string to_text(const Property& value) {
  if (const auto* number = std::get_if<Rational>(&value)) return to_string(*number);
  return std::get<std::string>(value);
}

bool AttributesOrder::operator()(const Attributes& a, const Attributes& b) const {
  const auto key = [](const Attributes& x) {
    return std::tuple<const Name&, const std::string&, const Properties&>(x.name, x.material.name(), x.properties);
  };
  if (key(a) != key(b)) return key(a) < key(b);
  return a.material != b.material && std::less<>()(a.material.grade(), b.material.grade());
}

bool Yielded::is_in(const Attributes& attributes) const {
  if (key.empty()) return attributes.material == material;
  const auto it = attributes.properties.find(key);
  return it != attributes.properties.end() && it->second == value;
}

std::string Yielded::text() const { return key.empty() ? material.name() : to_text(value); }

void fill_in(Attributes& kept, const Attributes& weaker, std::vector<Yielded>& yielded) {
  const auto gives_way = [&](Yielded what) {
    if (std::find(yielded.begin(), yielded.end(), what) == yielded.end()) yielded.push_back(std::move(what));
  };
  if (kept.material.empty()) kept.material = weaker.material;
  else if (!weaker.material.empty() && weaker.material != kept.material) gives_way({"", weaker.material, {}});
  for (const auto& [key, value] : weaker.properties) {
    const auto [it, fresh] = kept.properties.try_emplace(key, value);
    if (!fresh && it->second != value) gives_way({key, {}, value});
  }
}

void fill_in(Attributes& kept, const Attributes& weaker) {
  std::vector<Yielded> yielded;
  if (kept.name.empty()) kept.name = weaker.name;
  fill_in(kept, weaker, yielded);
}

void replace(Attributes& attributes, const Attributes& stronger) {
  if (!stronger.name.empty()) attributes.name = stronger.name;
  if (!stronger.material.empty()) attributes.material = stronger.material;
  for (const auto& [key, value] : stronger.properties) attributes.properties[key] = value;
}

}  // namespace cnrg
