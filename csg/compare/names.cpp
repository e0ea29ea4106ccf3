#include "csg/compare/names.h"

#include <algorithm>

namespace cnrg {
namespace {

/// The strongest origin of a part of `name` that `other` has not.
NameOrigin strongest(const Name& name, const Name& other) {
  NameOrigin most = NameOrigin::entities;
  for (const NamePart& part : name.parts()) {
    const auto& all = other.parts();
    const auto says = [&](const NamePart& p) { return p.shown() == part.shown(); };
    if (std::none_of(all.begin(), all.end(), says)) most = std::max(most, part.origin);
  }
  return most;
}

}  // namespace

bool names_differ(const Name& a, const Name& b) {
  const NameOrigin of_a = strongest(a, b), of_b = strongest(b, a);
  return std::max(of_a, of_b) == NameOrigin::given || (of_a == NameOrigin::file && of_b == NameOrigin::file);
}

}  // namespace cnrg
