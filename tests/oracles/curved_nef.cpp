#include "tests/oracles/curved_nef.h"

#include <stdexcept>

#include "tests/oracles/evaluation.h"

namespace cnrg::properties {

scenes::Solid facets_of(const Soup& soup, LeafId leaf) {
  scenes::Solid solid;
  for (SourceId f : IdRange<SourceId>(soup.face_count())) {
    if (soup.face(f).leaf != leaf) continue;
    auto& facet = solid.emplace_back();
    for (PointId p : soup.corners(f)) {
      if (!p.valid()) throw std::logic_error("a facet with a hole");
      const RationalPoint* value = soup.rational(p);
      const double* x = soup.xyz(p);
      facet.push_back(value ? *value : RationalPoint{from_double(x[0]), from_double(x[1]), from_double(x[2])});
    }
  }
  return solid;
}

std::string compare_with_nef(const LeafInstance& a, const LeafInstance& b) {
  const Soup soup = make_soup({a, b});
  const auto built_complex = build_complex(soup, {.threads = 1});
  const Complex& complex = *built_complex;
  if (std::string f = cnrg::validate(complex); !f.empty()) return "the complex is not valid: " + f;
  const std::vector<Group> groups = leaf_groups(complex);
  const NefSet nef_a = NefSet::solid(facets_of(soup, LeafId(0))),
               nef_b = NefSet::solid(facets_of(soup, LeafId(1)));
  const auto compare = [&](const char* what, const Group& ours, const NefSet& nef) -> std::string {
    if (std::string f = validate(complex, ours); !f.empty()) return std::string(what) + " is no group: " + f;
    if (volume(complex, ours) != nef.volume()) return std::string(what) + ": volumes differ";
    const std::string f = difference(skeleton(complex, ours), nef.skeleton());
    return f.empty() ? "" : std::string(what) + ", ours first, then Nef's:\n" + f;
  };
  const auto boolean = [&](BooleanOp op) {
    return boolean_operation(complex, op, Dominance::equal, groups[0], groups[1]).group;
  };
  std::string wrong = compare("the first leaf", groups[0], nef_a);
  if (wrong.empty()) wrong = compare("the second leaf", groups[1], nef_b);
  if (wrong.empty()) wrong = compare("union", boolean(BooleanOp::unite), nef_a.unite(nef_b));
  if (wrong.empty()) wrong = compare("intersection", boolean(BooleanOp::intersect), nef_a.intersect(nef_b));
  if (wrong.empty()) wrong = compare("difference", boolean(BooleanOp::subtract), nef_a.subtract(nef_b));
  return wrong;
}

}  // namespace cnrg::properties
