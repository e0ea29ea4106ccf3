#include "csg/materials/name.h"

#include <algorithm>

namespace cnrg {

Name::Name(std::string given) {
  if (!given.empty()) *this = Name(std::vector{NamePart{std::move(given)}});
}

Name::Name(std::vector<NamePart> parts) {
  if (parts.empty()) return;
  auto data = std::make_shared<Data>();
  for (const NamePart& part : parts) data->text += (data->text.empty() ? "" : " & ") + part.shown();
  data->parts = std::move(parts);
  data_ = std::move(data);
}

const Name& Name::of_entities() {
  static const Name name(std::vector{NamePart{"entities", 0, NameOrigin::entities}});
  return name;
}

const std::vector<NamePart>& Name::parts() const {
  static const std::vector<NamePart> none;
  return data_ == nullptr ? none : data_->parts;
}

bool Name::is_of_entities() const { return !empty() && parts().front().origin == NameOrigin::entities; }

const std::string& Name::text() const {
  static const std::string none;
  return data_ == nullptr ? none : data_->text;
}

Name join_names(const Name& a, const Name& b) {
  if (b.empty() || a == b) return a;
  if (a.empty() || (a.is_of_entities() && !b.is_of_entities())) return b;
  if (b.is_of_entities()) return a;
  std::vector<NamePart> parts = a.parts();
  for (const NamePart& part : b.parts()) {
    const auto known = std::find_if(parts.begin(), parts.end(), [&](const NamePart& p) { return p.says(part); });
    if (known == parts.end()) parts.push_back(part);
    else known->origin = std::max(known->origin, part.origin);
  }
  return Name(std::move(parts));
}

}  // namespace cnrg
