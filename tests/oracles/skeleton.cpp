#include "tests/oracles/skeleton.h"

#include <algorithm>
#include <numeric>
#include <sstream>

namespace cnrg::properties {
namespace {

std::string text(const RationalPoint& p) {
  return "(" + to_string(p[0]) + ", " + to_string(p[1]) + ", " + to_string(p[2]) + ")";
}

std::string text(const Skeleton& s, const Skeleton::Edge& e) {
  return text(s.vertices[e.ends[0]].point) + " - " + text(s.vertices[e.ends[1]].point) +
         (e.mark ? "" : " unmarked");
}

std::string text(const Skeleton& s, const Skeleton::Facet& f) {
  std::ostringstream out;
  out << "facet mark " << f.mark << " above " << f.above << " below " << f.below << ", boundary";
  for (const auto& e : f.boundary)
    out << " " << text(s.vertices[e[0]].point) << "-" << text(s.vertices[e[1]].point);
  if (!f.isolated.empty()) out << " and " << f.isolated.size() << " isolated vertices";
  return out.str();
}

/// What is in one list only, at most three of each.
template <class T, class Print>
void list_difference(std::ostringstream& out, const char* what, const std::vector<T>& a, const std::vector<T>& b,
                     Print print) {
  std::vector<T> only;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(only));
  for (std::size_t i = 0; i < only.size() && i < 3; ++i) out << "  " << what << ": " << print(only[i]) << "\n";
  if (only.size() > 3) out << "  " << what << ": and " << only.size() - 3 << " more\n";
}

}  // namespace

void Skeleton::sort() {
  std::vector<std::uint32_t> order(vertices.size()), rank(vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return vertices[a].point < vertices[b].point; });
  std::vector<Vertex> sorted;
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    rank[order[i]] = i;
    sorted.push_back(std::move(vertices[order[i]]));
  }
  vertices = std::move(sorted);
  const auto renumber = [&](std::array<std::uint32_t, 2>& ends) {
    ends = {rank[ends[0]], rank[ends[1]]};
    if (ends[0] > ends[1]) std::swap(ends[0], ends[1]);
  };
  for (Edge& e : edges) renumber(e.ends);
  for (Facet& f : facets) {
    for (auto& e : f.boundary) renumber(e);
    for (std::uint32_t& v : f.isolated) v = rank[v];
    std::sort(f.boundary.begin(), f.boundary.end());
    std::sort(f.isolated.begin(), f.isolated.end());
  }
  std::sort(edges.begin(), edges.end());
  std::sort(facets.begin(), facets.end());
}

std::string difference(const Skeleton& a, const Skeleton& b) {
  if (a == b) return {};
  std::ostringstream out;
  const auto counts = [&](const char* who, const Skeleton& s) {
    out << "  " << who << ": " << s.vertices.size() << " vertices, " << s.edges.size() << " edges, "
        << s.facets.size() << " facets, " << s.volumes << " volumes\n";
  };
  counts("first ", a);
  counts("second", b);
  std::vector<RationalPoint> pa, pb;
  for (const auto& v : a.vertices) pa.push_back(v.point);
  for (const auto& v : b.vertices) pb.push_back(v.point);
  const auto point = [](const RationalPoint& p) { return text(p); };
  list_difference(out, "vertex only in the first ", pa, pb, point);
  list_difference(out, "vertex only in the second", pb, pa, point);
  if (pa != pb) return out.str();
  for (std::size_t i = 0; i < pa.size(); ++i)
    if (a.vertices[i].mark != b.vertices[i].mark) out << "  marks of vertex " << text(pa[i]) << " differ\n";
  const auto edge = [&](const Skeleton::Edge& e) { return text(a, e); };
  list_difference(out, "edge only in the first ", a.edges, b.edges, edge);
  list_difference(out, "edge only in the second", b.edges, a.edges, edge);
  const auto facet = [&](const Skeleton::Facet& f) { return text(a, f); };
  list_difference(out, "only in the first ", a.facets, b.facets, facet);
  list_difference(out, "only in the second", b.facets, a.facets, facet);
  return out.str();
}

}  // namespace cnrg::properties
