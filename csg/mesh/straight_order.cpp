#include "csg/mesh/straight_order.h"

#include <algorithm>

#include "csg/mesh/quality.h"
#include "csg/mesh/second_order.h"
#include "csg/text/table.h"
#include "kernel/base/counts.h"
#include "kernel/base/error.h"
#include "kernel/base/parallel.h"
#include "kernel/base/sorted.h"

namespace cnrg {
namespace {

using Index = Mesh::Index;
using Edge = std::array<Index, 2>;

}  // namespace

std::vector<std::array<Mesh::Index, 2>> edges_of(const Mesh& mesh) {
  std::vector<Edge> edges;
  mesh.for_each_kind([&](std::size_t, std::size_t, const auto& simplices, const auto& ends) {
    for (const auto& s : simplices) {
      for (const auto& [i, j] : ends) edges.push_back(sorted(Edge{s.points[i], s.points[j]}));
    }
  });
  sort_unique(edges);
  return edges;
}

void add_straight_middles(Mesh& mesh) {
  require(mesh.middles.empty(), "a mesh of second order has its middles");
  for (const Edge& edge : edges_of(mesh)) {
    const auto &a = mesh.points[edge[0]], &b = mesh.points[edge[1]];
    const std::array<double, 3> middle{a[0] / 2 + b[0] / 2, a[1] / 2 + b[1] / 2, a[2] / 2 + b[2] / 2};
    mesh.middles.emplace_back(edge, next_number(mesh.points.size(), "points"));
    mesh.points.push_back(middle);
  }
  std::vector<char> good(mesh.tetrahedra.size());
  for_each_index(
      good.size(),
      [&](std::size_t i) {
        SecondOrderNodes nodes;
        const std::vector<Index> at = mesh.nodes(mesh.tetrahedra[i], kSecondOrderEdges);
        for (std::size_t k = 0; k < at.size(); ++k) nodes[k] = mesh.points[at[k]];
        good[i] = has_positive_determinant(nodes);
      },
      64);
  const auto first = std::find(good.begin(), good.end(), 0);
  if (first == good.end()) return;
  std::array<double, 3> at{};
  for (const Index p : mesh.tetrahedra[std::size_t(first - good.begin())].points) {
    for (std::size_t k = 0; k < 3; ++k) at[k] += mesh.points[p][k] / 4;
  }
  const auto flat = std::size_t(std::count(good.begin(), good.end(), 0));
  throw InputError(counted(flat, "tetrahedron is", "tetrahedra are") +
                   " so flat that nothing proves, once edges have rounded middles, how they are turned, one at " +
                   PlaceText(mesh)(at) +
                   "; join what nearly touches by --join, give --quality 2, or mesh without --order 2");
}

}  // namespace cnrg
