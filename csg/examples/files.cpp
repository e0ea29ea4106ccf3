// A result written for ParaView and, exactly, as .json; the .json read back as a leaf has the same value.
//
// The files appear in the current folder. A node of an evaluated tree is written by one call,
// `write(path, tree, evaluation, node)`; here the view is put together by hand.
#include <cnrg.h>

#include <iostream>

using namespace cnrg;

int main() {
  const auto a = prepare(BoxShape{{0, 0, 0}, {2, 2, 2}});
  const auto b = prepare(BoxShape{{1, 1, 1}, {3, 3, Rational(10, 3)}});
  const Complex complex = build_complex(make_soup({{a.get(), {}}, {b.get(), {}}}));
  const std::vector<Group> groups = leaf_groups(complex, {{{.name = "a", .material = "clay"}}, {{.name = "b"}}});
  const NodeValue value(complex,
                        boolean_operation(complex, BooleanOp::unite, Dominance::left, groups[0], groups[1]).group);
  const SimplifiedComplex simplified = simplify(complex, value, selection_of(complex, value));
  const std::vector<LeafInfo> leaves{{"a"}, {"b"}};
  const ResultView view{.node = "both",
                        .complex = &complex,
                        .value = &value,
                        .simplified = &simplified,
                        .leaves = &leaves,
                        .materials = {{"clay", "#aa7744"}}};
  for (const char* path : {"both.json", "both.vtu"}) {
    const RoundingReport rounding = write(path, view);
    std::cout << path << ": rounding moved " << rounding.moved << " vertices\n";
  }

  const auto read = prepare(ResultShape{"both.json"});
  const Complex again = build_complex(make_soup({{read.get(), {}}}));
  std::vector<RegionAttributes> names;
  for (const LeafRegion& r : read->regions()) names.push_back({.name = r.name, .material = r.material});
  const NodeValue same = leaf_value(again, LeafId(0), leaf_groups(again).front(), *read->cells(), {}, names);
  const Selection selection = selection_of(again, same);
  for (Component i = 1; i <= same.group().regions.size(); ++i) {
    const RegionAttributes& region = same.attributes(i);
    std::cout << "region " << region.name << " (" << region.material.name() << "): volume "
              << volume(again, support(selection, i).regions).value() << "\n";
  }
}

// Output:
// both.json: rounding moved 0 vertices
// both.vtu: rounding moved 4 vertices
// region a (clay): volume 8
// region b (): volume 25/3
