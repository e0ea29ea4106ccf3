// Differences in words. Exact numbers stay exact; rounded numbers are marked as such.
#include <algorithm>

#include "csg/compare/compare.h"
#include "csg/text/escape.h"
#include "csg/text/number.h"
#include "csg/text/table.h"

namespace cnrg {
namespace {

constexpr std::array<const char*, 2> kSides{"A", "B"};

std::string some(std::size_t count, const std::string& what) {
  const bool vowel = what.find_first_of("aeiou") == 0;
  return count == 1 ? (vowel ? "an " : "a ") + what : std::to_string(count) + " " + what + "s";
}

std::string extent_text(const Extent& extent, const std::string& what) {
  return extent.unbounded ? "unbounded " + what : what + " " + extent.sum.text();
}
std::string volume_text(const std::optional<Rational>& volume) {
  return volume ? "volume " + number_text(*volume, "") : "unbounded volume";
}

/// Coordinates that are too long to be read are rounded.
std::string point_text(const RationalPoint& p) {
  constexpr std::size_t kReadable = 24;
  std::string text;
  bool rounded = false;
  for (const Rational& x : p) {
    const std::string exact = to_string(x);
    const bool readable = exact.size() <= kReadable;
    rounded = rounded || !readable;
    text += (text.empty() ? "(" : ", ") + (readable ? exact : to_decimal(x));
  }
  return text + ")" + (rounded ? ", rounded" : "");
}

std::vector<std::string> sizes(const Size& size) {
  std::vector<std::string> parts;
  if (!size.volume || *size.volume != 0) parts.push_back(volume_text(size.volume));
  if (!size.area.is_zero()) parts.push_back(extent_text(size.area, "area"));
  if (!size.length.is_zero()) parts.push_back(extent_text(size.length, "length"));
  if (size.points != 0) parts.push_back(size.points == 1 ? "1 point" : std::to_string(size.points) + " points");
  return parts;
}

std::string piece_text(const SetPiece& piece) {
  const auto& counts = piece.counts;
  std::vector<std::string> parts;
  const auto add = [&](std::size_t count, const char* what, const std::string& size) {
    if (count != 0) parts.push_back(some(count, what) + " of " + size + (count == 1 ? "" : " in all"));
  };
  add(counts[3], "region", volume_text(piece.size.volume));
  add(counts[2], "face", extent_text(piece.size.area, "area"));
  add(counts[1], "edge", extent_text(piece.size.length, "length"));
  if (counts[0] != 0) parts.push_back(some(counts[0], "point"));
  const bool one_point = piece.dimension() == 0;
  return listed(parts) + (one_point ? " " : " about ") + point_text(piece.at);
}

class Lines {
 public:
  explicit Lines(std::size_t most) : most_(most) {}

  /// A line per piece between `before` and `behind`, and one about all of them.
  void pieces(const std::vector<SetPiece>& pieces, const std::string& before, const std::string& behind = "") {
    Size all;
    for (const SetPiece& piece : pieces) all.add(piece.size);
    for (std::size_t i = 0; i < std::min(most_, pieces.size()); ++i) {
      append_line(text_, before + piece_text(pieces[i]) + behind);
    }
    if (pieces.size() < 2) return;
    const std::size_t more = pieces.size() - std::min(most_, pieces.size());
    append_line(text_, before + (more == 0 ? "" : "and " + std::to_string(more) + " more; ") + "all " +
                           std::to_string(pieces.size()) + " together: " + listed(sizes(all)) + behind);
  }

  void list(const std::vector<std::string>& lines, const std::string& what) {
    for (std::size_t i = 0; i < std::min(most_, lines.size()); ++i) append_line(text_, lines[i]);
    if (lines.size() > most_) more(lines.size() - most_, what);
  }

  void more(std::size_t count, const std::string& what) {
    append_line(text_, "and " + std::to_string(count) + " more " + what);
  }

  std::string take() { return std::move(text_); }

 private:
  std::size_t most_;
  std::string text_;
};

std::string said(const std::string& word, const std::string& what) {
  if (word.empty()) return "no " + what;
  return std::string("`").append(shown(word)).append("`");
}

/// `region 1`, or `region 1 of A, region 2 of B`.
std::string both_of(const Comparison& comparison, const std::array<Component, 2>& of, bool names) {
  std::array<std::string, 2> words;
  for (std::size_t side = 0; side < 2; ++side) {
    words[side] = comparison.components[side][of[side] - 1];
    if (!names) words[side].resize(std::min(words[side].size(), words[side].find(" `")));
  }
  return words[0] == words[1] ? words[0] : words[0] + " of A, " + words[1] + " of B";
}

std::string regrouped_text(const Comparison& comparison, const Comparison::Regrouped& regrouped) {
  std::array<std::string, 2> words;
  for (std::size_t side = 0; side < 2; ++side) {
    std::vector<std::string> parts;
    for (const Component i : regrouped.of[side]) parts.push_back(comparison.components[side][i - 1]);
    words[side] = listed(parts);
  }
  for (const std::size_t side : {0, 1}) {
    if (regrouped.of[1 - side].empty())
      return words[side] + " of " + kSides[side] + " is nowhere in " + kSides[1 - side];
  }
  return words[0] + " of A " + (regrouped.of[0].size() == 1 ? "is " : "are ") + words[1] + " of B";
}

/// Where a piece of a pair is in one of the values.
std::string within(const Comparison& comparison, const Comparison::Moved& moved, std::size_t side) {
  const std::string& what = comparison.components[side][moved.in[side] - 1];
  return (what == kEntitiesLabel ? "an entity" : "in " + what) + " of " + kSides[side];
}

std::string what_of(const Comparison::Word& word) { return word.property ? shown(word.what) : word.what; }

/// `rock` in A, no material in B; with its key: material `rock` in A, no material in B
std::string word_text(const Comparison::Word& word, bool with_key) {
  const auto side = [&](std::size_t k) {
    const bool key = with_key && !word.said[k].empty();
    return (key ? what_of(word) + " " : "") + said(word.said[k], what_of(word));
  };
  if (word.same_word) return side(0) + " changes otherwise with position in A than in B";
  return side(0) + " in A, " + side(1) + " in B";
}

std::string attribute_text(const Comparison& comparison, const Comparison::Attribute& attribute) {
  return what_of(attribute.word) + " of " +
         both_of(comparison, attribute.of, attribute.word.property || attribute.word.what != "name") + ": " +
         word_text(attribute.word, false);
}

}  // namespace

std::string comparison_text(const Comparison& comparison, std::size_t most) {
  Lines lines(most);
  for (std::size_t side = 0; side < 2; ++side) {
    lines.pieces(comparison.only[side], std::string("only in ") + kSides[side] + ": ");
  }
  std::vector<std::string> regrouped, attributes;
  for (const auto& one : comparison.regrouped) regrouped.push_back(regrouped_text(comparison, one));
  for (const auto& [in_a, in_b] : comparison.mostly) {
    regrouped.push_back(comparison.components[0][in_a - 1] + " of A is mostly " +
                        comparison.components[1][in_b - 1] + " of B");
  }
  lines.list(regrouped, "such components");
  for (std::size_t i = 0; i < std::min(most, comparison.moved.size()); ++i) {
    const Comparison::Moved& one = comparison.moved[i];
    lines.pieces(one.pieces, "in both: ", ": " + within(comparison, one, 0) + ", " + within(comparison, one, 1));
  }
  if (comparison.moved.size() > most) lines.more(comparison.moved.size() - most, "pairs of components");
  for (const auto& one : comparison.attributes) attributes.push_back(attribute_text(comparison, one));
  lines.list(attributes, "such names, materials and attributes");
  for (std::size_t i = 0; i < std::min(most, comparison.said.size()); ++i) {
    std::string words;
    for (const Comparison::Word& word : comparison.said[i].words) {
      words += (words.empty() ? ": " : "; ") + word_text(word, true);
    }
    lines.pieces(comparison.said[i].pieces, "in both: ", words);
  }
  if (comparison.said.size() > most) lines.more(comparison.said.size() - most, "things said of cells");
  for (std::size_t side = 0; side < 2; ++side) {
    lines.pieces(comparison.features[side], std::string("a cell of its own only in ") + kSides[side] + ": ");
  }
  return lines.take();
}

}  // namespace cnrg
