// A result written for ParaView and, exactly, as .json; the .json read back has the same value.
//
// The files appear in the current folder. A result is a value of its own: it shares the complex with whoever else
// needs it. That of an evaluated tree is `evaluation.result()`.
#include <cnrg.h>

#include <iostream>

using namespace cnrg;

int main() {
  const auto complex = build_complex(make_soup(
      {{prepare(BoxShape{{0, 0, 0}, {2, 2, 2}})}, {prepare(BoxShape{{1, 1, 1}, {3, 3, Rational(10, 3)}})}}));
  const std::vector<Group> groups = leaf_groups(*complex, {{{.name = "a", .material = "clay"}}, {{.name = "b"}}});
  const Result both(complex,
                    boolean_operation(*complex, BooleanOp::unite, Dominance::left, groups[0], groups[1]).group,
                    {.result = "both", .leaves = {"a", "b"}, .materials = {{"clay", "#aa7744"}}});
  for (const char* path : {"both.json", "both.vtu"}) {
    const RoundingReport rounding = write(path, both);
    std::cout << path << ": rounding moved " << rounding.moved << " vertices\n";
  }

  const Result same = read_result("both.json");
  for (Component i = 1; i < same.component_count(); ++i) {  // the last are the walls
    const RegionAttributes& region = same.attributes(i);
    std::cout << "region " << region.name.text() << " (" << region.material.name() << "): volume "
              << *same.volume(i) << "\n";
  }
}

// Output:
// both.json: rounding moved 0 vertices
// both.vtu: rounding moved 4 vertices
// region a (clay): volume 8
// region b (): volume 25/3
