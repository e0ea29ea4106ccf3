// The classic contacts of mantyla1988, chapter 15, exactly: volumes, what represents them, and what is there
// twice.
//
// Counts are those of the representation. Vertices that reduction put on edges stay there, and coplanar neighbours
// stay apart: the book has no step that removes them. Where a result touches itself, each part has vertices of its
// own.

#include "bench/baseline/mantyla.h"
#include "tests/baseline/oracle.h"
#include "tests/baseline/shapes.h"
#include "tests/catch.h"

namespace cnrg::bench::baseline_test {
namespace {

struct Expected {
  long volume_times_6;
  Counts counts;           ///< v, e, f, r, s, g
  std::size_t duplicates;  ///< points at the place of another one
};

struct Contact {
  std::string name;
  Model a, b;
  std::array<Expected, 3> expected;  ///< union, difference, intersection
};

const Expected kEmpty = {0, {}, 0};

/// A triangular prism that stands on an edge, on the x axis; and one upside down below it with its edge on the y
/// axis.
Model edge_down() { return with_axis(prism({{0, 0}, {2, 2}, {-2, 2}}, {}, -1, 1), 1); }
Model edge_up() { return placed(edge_down(), {0, 1, 1, 0}, 1, {0, 0, 0}); }

std::vector<Contact> contacts() {
  const Model cube = box({0, 0, 0}, {2, 2, 2}), large = box({0, 0, 0}, {4, 4, 4});
  return {
      {"boxes that share a face",
       cube,
       at(cube, 2, 0, 0),
       {{{96, {12, 20, 10, 0, 1, 0}, 0}, {48, {8, 12, 6, 0, 1, 0}, 0}, kEmpty}}},
      {"a box on a part of a face, in its middle",
       large,
       box({4, 1, 1}, {5, 2, 2}),
       {{{390, {16, 24, 11, 1, 1, 0}, 0}, {384, {8, 12, 6, 0, 1, 0}, 0}, kEmpty}}},
      {"a box on a part of a face, at a corner of it",
       large,
       box({4, 0, 0}, {5, 2, 2}),
       {{{408, {15, 24, 11, 0, 1, 0}, 0}, {384, {10, 14, 6, 0, 1, 0}, 0}, kEmpty}}},
      {"faces that overlap in part",
       cube,
       at(cube, 2, 1, 1),
       {{{96, {18, 28, 12, 0, 1, 0}, 0}, {48, {10, 14, 6, 0, 1, 0}, 0}, kEmpty}}},
      {"boxes that share an edge",
       cube,
       at(cube, 2, 2, 0),
       {{{96, {16, 24, 12, 0, 2, 0}, 2}, {48, {8, 12, 6, 0, 1, 0}, 0}, kEmpty}}},
      {"boxes that share a part of an edge",
       cube,
       at(cube, 2, 2, 1),
       {{{96, {18, 26, 12, 0, 2, 0}, 2}, {48, {9, 13, 6, 0, 1, 0}, 0}, kEmpty}}},
      {"boxes that share a vertex",
       cube,
       at(cube, 2, 2, 2),
       {{{96, {16, 24, 12, 0, 2, 0}, 1}, {48, {8, 12, 6, 0, 1, 0}, 0}, kEmpty}}},
      {"a vertex on a face",
       large,
       at(octahedron(), 2, 2, 5),
       {{{392, {14, 24, 14, 0, 2, 0}, 0}, {384, {8, 12, 6, 0, 1, 0}, 0}, kEmpty}}},
      {"an edge on a face",
       box({-3, -3, -2}, {3, 3, 0}),
       edge_down(),
       {{{480, {14, 21, 11, 0, 2, 0}, 0}, {432, {8, 12, 6, 0, 1, 0}, 0}, kEmpty}}},
      {"an edge across an edge",
       edge_up(),
       edge_down(),
       {{{96, {14, 20, 10, 0, 2, 0}, 1}, {48, {7, 10, 5, 0, 1, 0}, 0}, kEmpty}}},
      {"identical boxes", cube, cube, {{{48, {8, 12, 6, 0, 1, 0}, 0}, kEmpty, {48, {8, 12, 6, 0, 1, 0}, 0}}}},
      {"a box in a box, three walls shared",
       large,
       cube,
       {{{384, {11, 15, 6, 0, 1, 0}, 0}, {336, {14, 21, 9, 0, 1, 0}, 0}, {48, {8, 12, 6, 0, 1, 0}, 0}}}},
      {"a box in a box, one wall shared",
       large,
       box({1, 1, 0}, {2, 2, 2}),
       {{{384, {8, 12, 6, 0, 1, 0}, 0}, {372, {16, 24, 11, 1, 1, 0}, 0}, {12, {8, 12, 6, 0, 1, 0}, 0}}}},
      {"a box in a box, nothing shared",
       large,
       box({1, 1, 1}, {2, 2, 2}),
       {{{384, {8, 12, 6, 0, 1, 0}, 0}, {378, {16, 24, 12, 0, 2, 0}, 0}, {6, {8, 12, 6, 0, 1, 0}, 0}}}},
      {"boxes apart",
       cube,
       at(cube, 5, 0, 0),
       {{{96, {16, 24, 12, 0, 2, 0}, 0}, {48, {8, 12, 6, 0, 1, 0}, 0}, kEmpty}}},
      {"a box across a box, ends in faces",
       large,
       box({1, 1, 0}, {2, 2, 4}),
       {{{384, {8, 12, 6, 0, 1, 0}, 0}, {360, {16, 24, 10, 2, 1, 1}, 0}, {24, {8, 12, 6, 0, 1, 0}, 0}}}},
      {"boxes that overlap, two faces coplanar",
       cube,
       at(cube, 1, 0, 1),
       {{{84, {18, 28, 12, 0, 1, 0}, 0}, {36, {12, 18, 8, 0, 1, 0}, 0}, {12, {8, 12, 6, 0, 1, 0}, 0}}}},
      {"boxes that overlap, four faces coplanar",
       cube,
       at(cube, 1, 0, 0),
       {{{72, {16, 24, 10, 0, 1, 0}, 0}, {24, {8, 12, 6, 0, 1, 0}, 0}, {24, {8, 12, 6, 0, 1, 0}, 0}}}},
      {"an L and the box in its notch",
       prism(ell(), {}, 0, 2),
       box({1, 1, 0}, {2, 2, 2}),
       {{{48, {14, 22, 10, 0, 1, 0}, 0}, {36, {12, 18, 8, 0, 1, 0}, 0}, kEmpty}}},
      {"an L and a box over its reflex edge",
       prism(ell(), {}, 0, 2),
       box({0, 0, 1}, {2, 2, 3}),
       {{{66, {22, 33, 13, 0, 1, 0}, 0}, {18, {12, 18, 8, 0, 1, 0}, 0}, {18, {12, 18, 8, 0, 1, 0}, 0}}}},
      {"two L's, one upside down in the other",
       prism(ell(), {}, 0, 2),
       at(placed(prism(ell(), {}, 0, 2), {0, 0, 0, 1}, 1, {0, 0, 0}), 2, 2, 0),
       {{{48, {18, 26, 10, 0, 1, 0}, 0}, {12, {8, 12, 6, 0, 1, 0}, 0}, {24, {15, 25, 12, 0, 1, 0}, 0}}}},
      {"a U and its lid",
       prism(letter_u(), {}, 0, 1),
       box({0, 3, 0}, {3, 4, 1}),
       {{{60, {20, 34, 14, 0, 1, 1}, 0}, {42, {16, 24, 10, 0, 1, 0}, 0}, kEmpty}}},
      {"a frame and its plug",
       frame(),
       box({-1, -1, -1}, {1, 1, 1}),
       {{{192, {16, 20, 8, 2, 1, 0}, 0}, {144, {16, 24, 10, 2, 1, 1}, 0}, kEmpty}}},
      {"a frame and a plug that touches two of its edges",
       frame(),
       prism({{0, -1}, {1, 0}, {0, 1}, {-1, 0}}, {}, -1, 1),
       {{{168, {32, 44, 16, 2, 2, 1}, 8}, {144, {24, 32, 10, 2, 1, 1}, 0}, kEmpty}}},
      {"a plus and a box in its corner",
       prism(plus(), {}, 0, 1),
       box({0, 0, 0}, {1, 1, 1}),
       {{{36, {26, 40, 16, 0, 1, 0}, 0}, {30, {24, 36, 14, 0, 1, 0}, 0}, kEmpty}}},
      {"a plus across a plus",
       prism(plus(), {}, 1, 2),
       with_axis(prism(plus(), {}, 1, 2), 1),
       {{{42, {32, 60, 30, 0, 1, 0}, 0}, {12, {16, 24, 12, 0, 2, 0}, 0}, {18, {16, 24, 10, 0, 1, 0}, 0}}}},
      {"a box cut at its vertices",
       at(cube, -1, -1, -1),
       tetrahedron(),
       {{{48, {8, 12, 6, 0, 1, 0}, 0}, {32, {12, 18, 10, 0, 2, 0}, 4}, {16, {4, 6, 4, 0, 1, 0}, 0}}}},
      {"an octahedron whose vertices are on the faces",
       at(cube, -1, -1, -1),
       octahedron(),
       {{{48, {8, 12, 6, 0, 1, 0}, 0}, {40, {14, 24, 14, 0, 2, 0}, 0}, {8, {6, 12, 8, 0, 1, 0}, 0}}}},
  };
}

}  // namespace

TEST_CASE("contacts of the book") {
  for (const Contact& contact : contacts()) {
    int k = 0;
    for (const Operation operation : {Operation::unite, Operation::subtract, Operation::intersect}) {
      INFO(contact.name << ", " << to_string(operation));
      const Expected& expected = contact.expected[k++];
      const Model answer = mantyla::boolean_exact(contact.a, contact.b, operation);
      CHECK(truth_of(contact.a, contact.b, operation, answer).same_set);
      CHECK(volume_of(answer) * 6 == expected.volume_times_6);
      CHECK(counts_of(answer) == expected.counts);
      CHECK(duplicates_of(answer) == expected.duplicates);
      // On the grid doubles are exact, too.
      const Model rounded = mantyla::boolean_double(contact.a, contact.b, operation);
      CHECK(volume_of(rounded) * 6 == expected.volume_times_6);
      CHECK(counts_of(rounded).vertices == expected.counts.vertices);
    }
  }
}

// The contacts in a face, an edge, a vertex that the literature names: the published programs are wrong in some,
// and nothing says so.
TEST_CASE("contacts of the book by the published algorithm") {
  mantyla::Departures with_shells = mantyla::published();
  with_shells.shells = true;
  mantyla::Departures with_checks = with_shells;
  with_checks.checks = true;
  int same = 0, wrong = 0;
  for (const Contact& contact : contacts())
    for (const Operation operation : {Operation::unite, Operation::subtract, Operation::intersect}) {
      INFO(contact.name << ", " << to_string(operation));
      const std::string found = outcome(contact.a, contact.b, operation, with_shells);
      if (found == "same") ++same;
      if (found != "wrong") continue;
      ++wrong;
      const std::string checked = outcome(contact.a, contact.b, operation, with_checks);
      CHECK(checked != "same");
      CHECK(checked != "wrong");
    }
  CHECK(same == 77);
  CHECK(wrong == 6);
}

}  // namespace cnrg::bench::baseline_test
