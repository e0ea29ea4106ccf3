#include "csg/compare/difference.h"

#include <nlohmann/json.hpp>

#include "csg/compare/compare.h"

namespace cnrg {
namespace {

using Json = nlohmann::ordered_json;

/// A double, for a sum of roots is no fraction; null for what has no end.
Json json_of(const Extent& extent) {
  return extent.unbounded ? Json() : extent.sum.is_zero() ? Json(0) : Json(to_double(extent.sum.value()));
}

Json json_of(const SetPiece& piece) {
  Json out{{"dimension", piece.dimension()},
           {"counts", piece.counts},
           {"volume", piece.size.volume ? Json(to_string(*piece.size.volume)) : Json()},
           {"area", json_of(piece.size.area)},
           {"length", json_of(piece.size.length)}};
  out["point"] = {to_string(piece.at[0]), to_string(piece.at[1]), to_string(piece.at[2])};
  return out;
}

Json json_of(const std::vector<SetPiece>& pieces) {
  Json out = Json::array();
  for (const SetPiece& piece : pieces) out.push_back(json_of(piece));
  return out;
}

Json json_of(const Comparison::Word& word) {
  return {{"what", word.property ? "attribute" : word.what},
          {"key", word.property ? Json(word.what) : Json()},
          {"said_a", word.said[0]},
          {"said_b", word.said[1]}};
}

Json json_of(const Comparison& c) {
  Json out{{"same", c.same()}, {"components", c.components}};
  out["only_a"] = json_of(c.only[0]);
  out["only_b"] = json_of(c.only[1]);
  Json regrouped = Json::array(), mostly = Json::array(), moved = Json::array(), attributes = Json::array();
  for (const Comparison::Regrouped& one : c.regrouped) regrouped.push_back({{"a", one.of[0]}, {"b", one.of[1]}});
  for (const auto& [a, b] : c.mostly) mostly.push_back({{"a", a}, {"b", b}});
  for (const Comparison::Moved& one : c.moved) {
    moved.push_back({{"a", one.in[0]}, {"b", one.in[1]}, {"pieces", json_of(one.pieces)}});
  }
  for (const Comparison::Attribute& one : c.attributes) {
    Json entry = json_of(one.word);
    entry["a"] = one.of[0];
    entry["b"] = one.of[1];
    attributes.push_back(std::move(entry));
  }
  Json said = Json::array();
  for (const Comparison::Said& one : c.said) {
    Json words = Json::array();
    for (const Comparison::Word& word : one.words) words.push_back(json_of(word));
    said.push_back({{"words", words}, {"pieces", json_of(one.pieces)}});
  }
  out["regrouped"] = regrouped;
  out["mostly"] = mostly;
  out["moved"] = moved;
  out["attributes"] = attributes;
  out["said"] = said;
  out["features_a"] = json_of(c.features[0]);
  out["features_b"] = json_of(c.features[1]);
  return out;
}

}  // namespace

Difference difference(const Tree& a, NodeId node_a, const Tree& b, NodeId node_b, const CompareOptions& options) {
  const Comparison comparison = compare(a, node_a, b, node_b, options);
  return {comparison.same(), comparison_text(comparison),
          json_of(comparison).dump(-1, ' ', false, Json::error_handler_t::replace)};
}

}  // namespace cnrg
