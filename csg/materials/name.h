// What a part of a model is called: parts that operators have joined, each with who called it so. A name is data;
// text is made of it where people or files want one, and nothing is read out of that text again.
#pragma once

#include <compare>
#include <concepts>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace cnrg {

/// The weakest first.
enum class NameOrigin : std::uint8_t {
  entities,   ///< the entities of a group, which nobody named: yields to any name
  operation,  ///< cells that an operator added: `closure`
  node,       ///< called after its node
  file,       ///< of a result read back that does not tell
  given,      ///< somebody named it
};

/// In files.
inline constexpr const char* kNameOrigins[] = {"entities", "operator", "node", "file", "given"};

struct NamePart {
  std::string text{};
  std::uint32_t ordinal = 0;  ///< of several regions of one leaf, from 1; 0: there is one
  NameOrigin origin = NameOrigin::given;
  /// `two.1`
  std::string shown() const { return ordinal == 0 ? text : text + "." + std::to_string(ordinal); }
  /// Called the same, whoever did so.
  bool says(const NamePart& other) const { return text == other.text && ordinal == other.ordinal; }
  friend auto operator<=>(const NamePart&, const NamePart&) = default;
};

/// A value that its copies share.
class Name {
 public:
  Name() = default;
  /// One part that somebody gave; none if the text is empty.
  Name(const char* given) : Name(std::string(given)) {}
  Name(std::string given);
  explicit Name(std::vector<NamePart> parts);
  static const Name& of_entities();

  bool empty() const { return data_ == nullptr; }
  const std::vector<NamePart>& parts() const;
  bool is_of_entities() const;
  /// Parts with ` & ` between them.
  const std::string& text() const;
  operator const std::string&() const { return text(); }

  friend bool operator==(const Name& a, const Name& b) { return a.data_ == b.data_ || a.parts() == b.parts(); }
  friend auto operator<=>(const Name& a, const Name& b) { return a.parts() <=> b.parts(); }
  template <std::convertible_to<std::string_view> Text>
  requires(!std::same_as<Text, Name>) friend bool operator==(const Name& a, const Text& text) {
    return a.text() == std::string_view(text);
  }

 private:
  struct Data {
    std::vector<NamePart> parts;
    std::string text;
  };
  std::shared_ptr<const Data> data_;  // nothing: no parts
};

/// The parts of both, each once; what the entities of a group are called yields to any other name.
Name join_names(const Name& a, const Name& b);

}  // namespace cnrg
