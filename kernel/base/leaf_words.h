// Messages about leaves. The kernel knows leaves by number, people by name: so a message keeps its places as data,
// and who knows the tree puts names there.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "kernel/base/error.h"

namespace cnrg {

/// A leaf, or faces or solids of one.
struct LeafPlace {
  std::uint32_t leaf = 0;
  std::vector<std::uint32_t> faces{}, solids{};
  /// `leaf 3, face 2`.
  std::string text() const {
    std::string out = "leaf " + std::to_string(leaf);
    for (const std::uint32_t face : faces) out += ", face " + std::to_string(face);
    for (const std::uint32_t solid : solids) out += ", solid " + std::to_string(solid);
    return out;
  }
};

/// Texts and places by turns.
class LeafWords {
 public:
  LeafWords() = default;
  LeafWords(const char* text) : LeafWords(std::string(text)) {}
  LeafWords(std::string text) {
    if (!text.empty()) parts_.emplace_back(std::move(text));
  }
  LeafWords(LeafPlace place) : parts_{std::move(place)} {}
  bool empty() const { return parts_.empty(); }
  friend LeafWords operator+(LeafWords a, const LeafWords& b) {
    a.parts_.insert(a.parts_.end(), b.parts_.begin(), b.parts_.end());
    return a;
  }
  /// Each place in these words.
  std::string text(const std::function<std::string(const LeafPlace&)>& words_of = &LeafPlace::text) const {
    std::string out;
    for (const auto& part : parts_) {
      const auto* const place = std::get_if<LeafPlace>(&part);
      out += place != nullptr ? words_of(*place) : std::get<std::string>(part);
    }
    return out;
  }
  /// With numbers of leaves in place of their places in a list.
  LeafWords renumbered(std::span<const std::uint32_t> leaves) const {
    LeafWords out = *this;
    for (auto& part : out.parts_)
      if (auto* const place = std::get_if<LeafPlace>(&part)) place->leaf = leaves[place->leaf];
    return out;
  }
  /// In their order.
  std::vector<LeafPlace> places() const {
    std::vector<LeafPlace> out;
    for (const auto& part : parts_)
      if (const auto* const place = std::get_if<LeafPlace>(&part)) out.push_back(*place);
    return out;
  }

 private:
  std::vector<std::variant<std::string, LeafPlace>> parts_;
};

/// Leaves that cannot be evaluated.
class LeafError : public InputError {
 public:
  explicit LeafError(LeafWords words) : InputError(words.text()), words_(std::move(words)) {}
  const LeafWords& words() const { return words_; }

 private:
  LeafWords words_;
};

}  // namespace cnrg
