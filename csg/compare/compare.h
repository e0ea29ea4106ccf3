// Do two values mean the same? The same point set, the same components with the same names and materials, and the
// same cells after simplification: and if not, what differs, where and by how much.
//
// Files of results cannot be laid side by side for this: a face that one tree cuts in two has other numbers in the
// other, numbers of regions follow the order of leaves, and facets of a surface depend on who else lies on it.
// Therefore both trees are refined together (together.h). Then both values are selections on one complex, and
// what differs is a set of its cells.
//
// What is compared is in csg/SEMANTICS.md#the-same, what is told in csg/FORMATS.md#two-trees-compared. All is
// symmetric: to exchange A and B exchanges what is said of them.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "csg/compare/difference.h"
#include "csg/compare/pieces.h"
#include "csg/evaluate/evaluate.h"

namespace cnrg {

/// What the entities of a group are called as one of its components.
inline constexpr const char* kEntitiesLabel = "the entities";

/// What two values differ in. Of each pair the first is of A, the second of B.
struct Comparison {
  /// Of component i at i - 1, in words: "region 1 `ground`", "component 2", "the entities".
  std::array<std::vector<std::string>, 2> components;

  /// Active in one value alone.
  std::array<std::vector<SetPiece>, 2> only;

  /// Components that are made of each other and are not one and one: {1}, {1, 2} where one of A is two of B.
  /// With an empty list: those that share no cell with the other value.
  struct Regrouped {
    std::array<std::vector<Component>, 2> of;
  };
  std::vector<Regrouped> regrouped;

  /// Where several of one value share cells with several of the other: those that correspond.
  std::vector<std::array<Component, 2>> mostly;

  /// Active in both values, but in components that do not correspond.
  struct Moved {
    std::array<Component, 2> in;
    std::vector<SetPiece> pieces;
  };
  std::vector<Moved> moved;

  /// What is said of something in one value and not, or otherwise, in the other.
  struct Word {
    std::string what;                 ///< `name`, `material`, or the key of an attribute
    bool property = false;            ///< it is such a key
    std::array<std::string, 2> said;  ///< empty: nothing
    bool same_word = false;           ///< materials of one name that change otherwise with position
    friend auto operator<=>(const Word&, const Word&) = default;
  };
  struct Attribute {
    std::array<Component, 2> of;
    Word word;
  };
  std::vector<Attribute> attributes;

  /// Faces, edges and vertices that both have in components that correspond, and of which other things are said.
  struct Said {
    std::vector<Word> words;
    std::vector<SetPiece> pieces;
  };
  std::vector<Said> said;

  /// Vertices, edges and faces of the simplified value that the other one has within a larger cell, where nothing
  /// else differs.
  std::array<std::vector<SetPiece>, 2> features;

  bool same() const;
};

/// The values of two nodes compared. Throws what `evaluate` does, faults of a tree as if it were evaluated alone.
Comparison compare(const Tree& a, NodeId node_a, const Tree& b, NodeId node_b, const CompareOptions& options = {});

/// The differences, a line each, the largest first: of each kind `most` at most and how many more there are.
/// Empty when there are none.
std::string comparison_text(const Comparison& comparison, std::size_t most = 10);

}  // namespace cnrg
