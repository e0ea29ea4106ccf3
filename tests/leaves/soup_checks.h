// Exact statements about soups: planarity, closedness, volume.
#pragma once

#include <concepts>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <set>
#include <string>

#include "csg/leaves/leaf.h"
#include "kernel/exact/exact_vectors.h"
#include "tests/catch.h"

namespace cnrg::test {

inline RationalPoint value(const Soup& soup, PointId p) {
  if (const RationalPoint* exact = soup.rational(p)) return *exact;
  const double* x = soup.xyz(p);
  return {from_double(x[0]), from_double(x[1]), from_double(x[2])};
}

/// Loops of a face; holes turned against the outer loop.
inline std::vector<std::vector<RationalPoint>> loops(const Soup& soup, SourceId f) {
  std::vector<std::vector<RationalPoint>> result(1);
  for (PointId p : soup.corners(f)) {
    if (p.valid()) result.back().push_back(value(soup, p));
    else result.emplace_back();
  }
  const auto area = [](const std::vector<RationalPoint>& loop) {
    RationalPoint sum{0, 0, 0};
    for (std::size_t i = 0; i < loop.size(); ++i) sum = sum + cross(loop[i], loop[(i + 1) % loop.size()]);
    return sum;
  };
  for (std::size_t l = 1; l < result.size(); ++l) {
    if (dot(area(result[l]), area(result[0])) > 0) std::reverse(result[l].begin(), result[l].end());
  }
  return result;
}

/// Six times the volume inside of a leaf, by signed tetrahedra.
inline Rational volume(const Soup& soup, LeafId leaf = LeafId(0)) {
  Rational six = 0;
  for (SourceId f : IdRange<SourceId>(soup.face_count())) {
    if (soup.face(f).leaf != leaf) continue;
    for (const auto& loop : loops(soup, f)) {
      for (std::size_t i = 1; i + 1 < loop.size(); ++i) six += dot(loop[0], cross(loop[i], loop[i + 1]));
    }
  }
  return six / 6;
}

inline bool planar(const Soup& soup) {
  for (SourceId f : IdRange<SourceId>(soup.face_count())) {
    const auto face = loops(soup, f);
    RationalPoint normal{0, 0, 0};
    for (std::size_t i = 2; i < face[0].size() && is_zero(normal); ++i) {
      normal = cross(face[0][1] - face[0][0], face[0][i] - face[0][0]);
    }
    if (is_zero(normal)) return false;
    for (const auto& loop : face) {
      for (const RationalPoint& p : loop) {
        if (dot(normal, p - face[0][0]) != 0) return false;
      }
    }
  }
  return true;
}

/// Every edge of the leaf is run through as often in one direction as in the other.
inline bool closed(const Soup& soup, LeafId leaf = LeafId(0)) {
  std::map<std::pair<RationalPoint, RationalPoint>, int> edges;
  for (SourceId f : IdRange<SourceId>(soup.face_count())) {
    if (soup.face(f).leaf != leaf) continue;
    for (const auto& loop : loops(soup, f)) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const RationalPoint &a = loop[i], &b = loop[(i + 1) % loop.size()];
        a < b ? ++edges[{a, b}] : --edges[{b, a}];
      }
    }
  }
  return std::all_of(edges.begin(), edges.end(), [](const auto& e) { return e.second == 0; });
}

inline std::size_t leaf_faces(const Soup& soup, LeafId leaf = LeafId(0)) {
  std::set<std::uint32_t> numbers;
  for (SourceId f : IdRange<SourceId>(soup.face_count())) {
    if (soup.face(f).leaf == leaf) numbers.insert(soup.face(f).leaf_face);
  }
  return numbers.size();
}

inline bool all_doubles(const Soup& soup) {
  for (PointId p : IdRange<PointId>(soup.point_count())) {
    if (soup.rational(p)) return false;
  }
  return true;
}

inline Soup soup_of(const Shape& shape, const Transform& transform = {}) {
  const auto leaf = prepare(shape);
  return make_soup({{leaf, transform}});
}

/// The message of the InputError that `action` throws; empty if it throws none.
template <std::invocable Action>
std::string error_of(Action action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}
inline std::string error_of(const Shape& shape) {
  return error_of([&] { prepare(shape); });
}

/// Files in a directory of their own that goes away.
class Files {
 public:
  Files() {
    std::random_device random;
    directory_ = std::filesystem::temp_directory_path() /
                 ("cnrg_leaves_" + std::to_string(random()) + std::to_string(random()));
    std::filesystem::create_directories(directory_);
  }
  ~Files() { std::filesystem::remove_all(directory_); }
  std::string path(const std::string& name) const { return (directory_ / name).string(); }
  std::string write(const std::string& name, const std::string& content) const {
    std::ofstream(path(name), std::ios::binary) << content;
    return path(name);
  }

 private:
  std::filesystem::path directory_;
};

/// The mesh file of the corner of a unit cube.
inline void check_tetrahedron(const std::string& path) {
  CAPTURE(path);
  const Soup soup = soup_of(MeshShape{path, {}, false});
  CHECK(soup.fill(LeafId(0)) == Fill::winding);
  CHECK(soup.point_count() == 4);
  CHECK(soup.face_count() == 4);
  CHECK(closed(soup));
  CHECK(volume(soup) == Rational(1, 6));
}

}  // namespace cnrg::test
