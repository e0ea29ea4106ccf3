// Strips are triangles that turn the other way every second time, polylines are lines from point to point.
#include "csg/imports/vtk_cells.h"

#include <bit>

#include "csg/imports/little_endian.h"

namespace cnrg {

std::size_t size_of(VtkType type) {
  constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

bool is_whole(VtkType type) { return type != VtkType::float32 && type != VtkType::float64; }

std::int64_t whole_number_at(std::string_view bytes, std::size_t at, VtkType type, bool big_endian) {
  const bool with_sign = static_cast<std::size_t>(type) % 2 == 0;
  const std::size_t unused = 64 - 8 * size_of(type);
  const std::uint64_t bits = number_of_bytes(bytes, at, size_of(type), big_endian) << unused;
  return with_sign ? static_cast<std::int64_t>(bits) >> unused : static_cast<std::int64_t>(bits >> unused);
}

double real_number_at(std::string_view bytes, std::size_t at, VtkType type, bool big_endian) {
  const std::uint64_t bits = number_of_bytes(bytes, at, size_of(type), big_endian);
  if (type == VtkType::float64) return std::bit_cast<double>(bits);
  return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
}

VtkNumbers numbers_of(std::string_view bytes, VtkType type, bool big_endian) {
  const std::size_t size = size_of(type), count = bytes.size() / size;
  VtkNumbers numbers;
  numbers.whole = is_whole(type);
  if (numbers.whole) numbers.integers.reserve(count);
  else numbers.reals.reserve(count);
  for (std::size_t at = 0; at < count * size; at += size) {
    if (numbers.whole) numbers.integers.push_back(whole_number_at(bytes, at, type, big_endian));
    else numbers.reals.push_back(real_number_at(bytes, at, type, big_endian));
  }
  return numbers;
}

std::uint32_t VtkCollector::group() {
  if (!labels_) return groups_.group_without_label();
  return labels_->whole ? groups_.group(labels_->integers[cell_]) : groups_.group(labels_->reals[cell_]);
}

void VtkCollector::add(VtkKind kind, std::span<const std::int64_t> points, std::size_t first, std::size_t number,
                       const Fail& fail) {
  constexpr const char* kNames[] = {"vertex", "line", "polygon", "strip"};
  const auto name = [&] {
    return std::string(kNames[static_cast<std::size_t>(kind)]) + " " + std::to_string(number);
  };
  const std::size_t count = mesh.point_count() - first;
  for (const std::int64_t p : points) {
    if (p >= 0 && static_cast<std::uint64_t>(p) < count) continue;
    fail(name() + " has the point " + std::to_string(p) + ", but there are " + std::to_string(count) +
         " points, numbered from 0: correct the index");
  }
  const auto least = [&](std::size_t n) {
    if (points.size() < n) {
      fail(name() + " has " + std::to_string(points.size()) + " points, and needs at least " + std::to_string(n) +
           ": correct the file");
    }
  };
  const auto point = [&](std::size_t i) { return static_cast<std::uint32_t>(first + std::size_t(points[i])); };
  switch (kind) {
    case VtkKind::vertices:
      for (std::size_t i = 0; i < points.size(); ++i) mesh.points.push_back(point(i));
      break;
    case VtkKind::lines:
      least(2);
      for (std::size_t i = 0; i + 1 < points.size(); ++i) mesh.wires.push_back({point(i), point(i + 1)});
      break;
    case VtkKind::polygons:
      for (std::size_t i = 0; i < points.size(); ++i) mesh.corners.push_back(point(i));
      mesh.end_face();
      mesh.groups.push_back(group());
      break;
    case VtkKind::strips:
      least(3);
      for (std::size_t i = 0; i + 2 < points.size(); ++i) {
        const bool turned = i % 2 == 1;
        mesh.corners.insert(mesh.corners.end(),
                            {point(turned ? i + 1 : i), point(turned ? i : i + 1), point(i + 2)});
        mesh.end_face();
        mesh.groups.push_back(group());
      }
      break;
  }
  ++cell_;
}

VtkKind kind_of_cell(std::int64_t type, std::size_t number, std::vector<std::int64_t>& points,
                     const std::function<void(const std::string&)>& fail) {
  const std::string name = "cell " + std::to_string(number);
  const auto exactly = [&](std::size_t n) {
    if (points.size() == n) return;
    fail(name + " has " + std::to_string(points.size()) + " points, and one of type " + std::to_string(type) +
         " has " + std::to_string(n) + ": correct the file");
  };
  switch (type) {
    case 1: exactly(1); return VtkKind::vertices;
    case 2: return VtkKind::vertices;
    case 3: exactly(2); return VtkKind::lines;
    case 4: return VtkKind::lines;
    case 5: exactly(3); return VtkKind::polygons;
    case 6: return VtkKind::strips;
    case 7: return VtkKind::polygons;
    case 8:
      exactly(4);
      std::swap(points[2], points[3]);
      return VtkKind::polygons;
    case 9: exactly(4); return VtkKind::polygons;
    default: break;
  }
  fail(name + " is of type " + std::to_string(type) +
       ", and a mesh is made of points, lines and flat polygons (types 1 to 9): write the surface of the grid as "
       "PolyData");
  return VtkKind::polygons;
}

void VtkCollector::add(VtkKind kind, const VtkCells& cells, std::size_t first, const Fail& fail) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto begin = std::size_t(cells.offsets[i]), end = std::size_t(cells.offsets[i + 1]);
    add(kind, std::span(cells.connectivity).subspan(begin, end - begin), first, i, fail);
  }
}

MeshData VtkCollector::finish() {
  if (groups_.size() < 2) mesh.groups.clear();
  return std::move(mesh);
}

}  // namespace cnrg
