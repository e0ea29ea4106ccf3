// Small results to write: soups by hand, evaluated, and kept alive with everything a writer looks at.
#pragma once

#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "csg/formats/writer.h"
#include "csg/operators/boolean.h"
#include "csg/operators/group.h"
#include "kernel/refine/box_faces.h"

namespace cnrg::test {

using Names = std::vector<std::vector<Attributes>>;

/// The faces of a box, outward, in the order of x, y and z. Bit k of a corner's number says that it is the high
/// one in axis k.
inline void add_box_faces(Soup& soup, LeafId leaf, const PointId (&p)[8]) {
  std::uint32_t number = 0;
  for (const auto& f : kBoxFaces) {
    const std::vector<PointId> loop{p[f[0]], p[f[1]], p[f[2]], p[f[3]]};
    soup.add_face(leaf, std::span(&loop, 1), number, number);
    ++number;
  }
}

/// A solid box; region 1 inside.
inline LeafId add_box(Soup& soup, const RationalPoint& low, const RationalPoint& high) {
  const LeafId leaf = soup.add_leaf(Fill::winding);
  PointId p[8];
  for (int i = 0; i < 8; ++i) {
    const RationalPoint at{i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 4 ? high[2] : low[2]};
    p[i] = soup.add_point(at);
  }
  add_box_faces(soup, leaf, p);
  return leaf;
}

/// A polygon, no region.
inline LeafId add_sheet(Soup& soup, const std::vector<RationalPoint>& points) {
  const LeafId leaf = soup.add_leaf(Fill::none);
  std::vector<PointId> loop;
  for (const auto& p : points) loop.push_back(soup.add_point(p));
  soup.add_face(leaf, std::span(&loop, 1), 0, 0);
  return leaf;
}

inline LeafId add_wire(Soup& soup, const RationalPoint& a, const RationalPoint& b) {
  const LeafId leaf = soup.add_leaf(Fill::none);
  soup.add_wire(leaf, soup.add_point(a), soup.add_point(b), 0);
  return leaf;
}

inline LeafId add_point(Soup& soup, const RationalPoint& p) {
  const LeafId leaf = soup.add_leaf(Fill::none);
  soup.add_isolated(leaf, soup.add_point(p));
  return leaf;
}

/// A prism over a polygon with n corners on a circle of radius 5 about the z axis; the side is one curved patch.
inline LeafId add_drum(Soup& soup, int n, const Rational& bottom, const Rational& top) {
  const LeafId leaf = soup.add_leaf(Fill::winding);
  std::vector<PointId> low, high;
  for (int i = 0; i < n; ++i) {
    const Rational t = Rational(i < n / 2 ? i : i - n) * 4 / n;  // tangent of half the angle
    const Rational d = 1 + t * t;
    const RationalPoint p{5 * (1 - t * t) / d, 5 * 2 * t / d, 0};
    low.push_back(soup.add_point(RationalPoint{p[0], p[1], bottom}));
    high.push_back(soup.add_point(RationalPoint{p[0], p[1], top}));
  }
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    const std::vector<PointId> side{low[i], low[j], high[j], high[i]};
    soup.add_face(leaf, std::span(&side, 1), 2 + std::uint32_t(i), 2);
  }
  soup.add_face(leaf, std::span(&high, 1), 1, 1);
  const std::vector<PointId> below(low.rbegin(), low.rend());
  soup.add_face(leaf, std::span(&below, 1), 0, 0);
  return leaf;
}

/// A result and all that its view points to.
struct Case {
  std::shared_ptr<const Complex> complex;
  std::vector<VertexId> vertex_of;  // by point of the soup
  std::vector<Group> leaves;
  Group group;
  NodeValue value;
  SimplifiedComplex simplified;
  std::vector<LeafInfo> infos;
  std::vector<ResultView::Material> materials;

  explicit Case(const Soup& soup, const Names& names = {}) {
    RefineReport report;
    complex = build_complex(soup, {.vertices = true}, &report);
    vertex_of = std::move(report.vertex_of);
    leaves = leaf_groups(*complex, names);
    for (std::uint32_t i = 0; i < leaves.size(); ++i) infos.push_back({"leaf" + std::to_string(i), i});
    show(leaves[0]);
  }
  void show(Group shown, SimplifyMode mode = SimplifyMode::features) {
    group = std::move(shown);
    value = NodeValue(*complex, group);
    simplified = simplify(*complex, selection_of(*complex, group), group.features, mode);
  }
  void show(Components shown) { show(NodeValue(std::move(shown))); }
  void show(NodeValue shown) {
    value = std::move(shown);
    if (value.is_group()) group = value.group();
    simplified = simplify(*complex, selection_of(*complex, value), value.features());
  }
  Group unite(Dominance dominance = Dominance::equal) const {
    Group all = leaves[0];
    for (std::size_t i = 1; i < leaves.size(); ++i) {
      all = boolean_operation(*complex, BooleanOp::unite, dominance, all, leaves[i]).group;
    }
    return all;
  }
  ResultView view() const {
    ResultView v;
    v.node = "model";
    v.complex = complex.get();
    v.value = &value;
    v.simplified = &simplified;
    v.leaves = &infos;
    v.materials = materials;
    for (Component i = 1; i <= value.component_count(); ++i) {  // as Result::Data::name
      const std::string& name = value.attributes(i).material.name();
      const auto same = [&](const ResultView::Material& m) { return m.name == name; };
      if (!name.empty() && std::none_of(v.materials.begin(), v.materials.end(), same))
        v.materials.push_back({name, ""});
    }
    return v;
  }
};

/// A directory of its own, removed at the end.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "cnrg-output-XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

inline std::string text_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

}  // namespace cnrg::test
