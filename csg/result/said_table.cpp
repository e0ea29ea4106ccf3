#include "csg/result/said_table.h"

#include <algorithm>
#include <array>

#include "csg/text/escape.h"
#include "kernel/base/sorted.h"

namespace cnrg {

std::vector<std::string> said_names(const ResultView& view) {
  std::vector<std::string> names;
  const LeafSets& sets = view.value->origins().sets;
  for (std::size_t s = 0; s < sets.size(); ++s) {
    const SaidPointer& said = sets.said(LeafSetId(s));
    if (said != nullptr && !said->attributes.name.empty()) names.push_back(said->attributes.name);
  }
  sort_unique(names);
  return names;
}

std::string array_name(const std::string& key) {
  static constexpr std::array kOwn{
      "dimension", "cell",        "component",   "region", "region_front", "region_back", "regions_bounded",
      "material",  "source_leaf", "source_face", "name",   "patch",        "parameters"};
  const bool taken = std::find(kOwn.begin(), kOwn.end(), key) != kOwn.end() || key.starts_with("fraction of ");
  return shown(key) + (taken ? "'" : "");
}

std::int32_t SaidTableMaker::place(const CellTags& tags) {
  if (tags.said == nullptr || tags.said->empty()) return ResultArrays::kNone;
  const auto [at, fresh] = places_.try_emplace(*tags.said, static_cast<std::int32_t>(said_.size()));
  if (fresh) said_.push_back(*tags.said);
  return at->second;
}

SaidTable SaidTableMaker::table(const ResultView& view) const {
  SaidTable out;
  out.said = said_;
  const std::vector<std::string> names = said_names(view);
  if (!names.empty()) {
    SaidTable::Column& column = out.columns.emplace_back();
    column.array = "name";
    column.texts = names;
    for (const Attributes& said : said_) {
      const auto at = std::lower_bound(names.begin(), names.end(), said.name.text());
      const bool known = at != names.end() && *at == said.name;
      column.places.push_back(known ? static_cast<std::int32_t>(at - names.begin()) + 1 : 0);
    }
  }
  const PropertyFields properties(view);
  for (const PropertyFields::Field& field : properties.fields()) {
    SaidTable::Column& column = out.columns.emplace_back();
    column.array = array_name(field.key);
    column.texts = field.texts;
    for (const Attributes& said : said_) {
      CellTags tags;
      tags.said = &said;
      if (field.numeric) column.numbers.push_back(PropertyFields::number(field, tags));
      else column.places.push_back(PropertyFields::text(field, tags));
    }
  }
  return out;
}

}  // namespace cnrg
