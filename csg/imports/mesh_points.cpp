// Merging by a hash of the coordinates; points whose coordinates are not all doubles are compared exactly.
#include "csg/imports/mesh_points.h"

#include <algorithm>

#include "kernel/base/number_table.h"
#include "kernel/base/point_hash.h"
#include "kernel/base/sorted.h"
#include "kernel/exact/coplanar.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {

MeshPoints::MeshPoints(const MeshData& mesh) {
  const std::size_t count = mesh.point_count();
  NumberTable numbers(count);
  number_.reserve(count);
  xyz_.reserve(mesh.xyz.size());
  auto next_exact = mesh.exact.begin();
  for (std::size_t i = 0; i < count; ++i) {
    // Adding zero turns -0 into 0.
    const double p[3] = {mesh.xyz[3 * i] + 0.0, mesh.xyz[3 * i + 1] + 0.0, mesh.xyz[3 * i + 2] + 0.0};
    const RationalPoint* value = nullptr;
    if (next_exact != mesh.exact.end() && next_exact->first == i) value = &(next_exact++)->second;
    std::uint32_t& number = numbers.slot(hash_of_point(p), [&](std::uint32_t other) {
      if (!std::equal(p, p + 3, xyz(other))) return false;
      const RationalPoint* other_value = exact(other);
      return value && other_value ? *value == *other_value : value == other_value;
    });
    if (number == NumberTable::kNone) {
      number = static_cast<std::uint32_t>(size());
      if (value) exact_.emplace_back(number, *value);
      xyz_.insert(xyz_.end(), p, p + 3);
    }
    number_.push_back(number);
  }
}

const RationalPoint* MeshPoints::exact(std::uint32_t p) const { return value_of_key(exact_, p); }

RationalPoint MeshPoints::value(std::uint32_t p) const {
  if (const RationalPoint* value = exact(p)) return *value;
  return {from_double(xyz(p)[0]), from_double(xyz(p)[1]), from_double(xyz(p)[2])};
}

bool MeshPoints::coplanar(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
  if (!exact(a) && !exact(b) && !exact(c) && !exact(d)) return cnrg::coplanar(xyz(a), xyz(b), xyz(c), xyz(d));
  return maybe_coplanar(xyz(a), xyz(b), xyz(c), xyz(d)) && volume6(value(a), value(b), value(c), value(d)) == 0;
}

bool MeshPoints::collinear(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  if (!exact(a) && !exact(b) && !exact(c)) return cnrg::collinear(xyz(a), xyz(b), xyz(c));
  return maybe_collinear(xyz(a), xyz(b), xyz(c)) && cnrg::collinear(value(a), value(b), value(c));
}

}  // namespace cnrg
