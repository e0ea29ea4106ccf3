// Each cell of a result gets a key that says which component it belongs to; components are the keys in order.
#include "tests/oracles/dag_reference.h"

#include <algorithm>
#include <map>
#include <set>

namespace cnrg::properties {
namespace {

using Set = CellIncidence::Set;
using Labels = CellIncidence::Labels;
using Key = std::vector<std::uint32_t>;  ///< empty: inactive

/// Components from 1 in the order of the keys.
Labels numbered(const std::vector<Key>& keys) {
  std::map<Key, std::uint32_t> number;
  for (const Key& key : keys)
    if (!key.empty()) number[key] = 0;
  std::uint32_t next = 0;
  for (auto& [key, n] : number) n = ++next;
  Labels out;
  for (const Key& key : keys) out.push_back(key.empty() ? 0 : number.at(key));
  return out;
}

Set complement_cells(Set set) {
  for (char& c : set) c = !c;
  return set;
}

Set common_cells(Set a, const Set& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = a[i] && b[i];
  return a;
}

Set topological(const CellIncidence& cells, Operator op, const Set& x) {
  switch (op) {
    case Operator::interior: return cells.interior(x);
    case Operator::closure: return cells.closure(x);
    case Operator::boundary: return common_cells(cells.closure(x), cells.closure(complement_cells(x)));
    default: return cells.closure(cells.interior(x));
  }
}

/// Xi and S by their numbers, S - |X| as one more.
Labels restricted(const Labels& x, const Set& s) {
  std::vector<Key> keys(x.size());
  for (std::size_t i = 0; i < x.size(); ++i)
    if (s[i]) keys[i] = x[i] != 0 ? Key{0, x[i]} : Key{1};
  return numbered(keys);
}

Labels each(const CellIncidence& cells, Operator op, const Labels& x) {
  std::vector<Key> keys(x.size());
  for (std::uint32_t c = 1; c <= *std::max_element(x.begin(), x.end()); ++c) {
    Set own(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) own[i] = x[i] == c;
    const Set s = topological(cells, op, own);
    for (std::size_t i = 0; i < x.size(); ++i)
      if (s[i]) keys[i].push_back(c);
  }
  return numbered(keys);
}

Labels overlay(Operator op, const Labels& x, const Labels& y) {
  std::vector<Key> keys(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] != 0 && y[i] == 0 && op != Operator::product) keys[i] = {0, x[i]};
    if (x[i] != 0 && y[i] != 0 && op != Operator::cnrg_subtract) keys[i] = {1, x[i], y[i]};
    if (x[i] == 0 && y[i] != 0 && op == Operator::sum) keys[i] = {2, y[i]};
  }
  return numbered(keys);
}

Labels aggregate_labels(const std::vector<Labels>& x) {
  std::vector<Key> keys(x[0].size());
  for (std::uint32_t k = 0; k < x.size(); ++k)
    for (std::size_t i = 0; i < keys.size(); ++i)
      if (x[k][i] != 0) keys[i] = {k, x[k][i]};
  return numbered(keys);
}

/// Components of a group by its own words: a region's cells and what is inside of it, then the entities.
std::string check_group_components(const Complex& complex, const CellIncidence& cells, const Group& group) {
  const Labels x = cells.labels(components_of(complex, group).selection);
  const Labels own = cells.labels(selection_of(complex, group));
  return x == own ? "" : "the components of a group are not its selection";
}

}  // namespace

Labels operator_by_definition(const CellIncidence& cells, const DagNode& node, const std::vector<Labels>& x) {
  switch (node.op) {
    case Operator::aggregate: return aggregate_labels(x);
    case Operator::unify: {
      Labels one = x[0];
      for (auto& c : one) c = c != 0;
      return one;
    }
    case Operator::complement: {
      Labels one = x[0];
      for (auto& c : one) c = c == 0;
      return one;
    }
    case Operator::sum:
    case Operator::product:
    case Operator::cnrg_subtract: {
      Labels all = x[0];
      for (std::size_t k = 1; k < x.size(); ++k) all = overlay(node.op, all, x[k]);
      return all;
    }
    case Operator::simplify: return x[0];
    default:
      return node.each ? each(cells, node.op, x[0])
                       : restricted(x[0], topological(cells, node.op, CellIncidence::support(x[0])));
  }
}

Labels regularized_by_definition(const CellIncidence& cells, const Labels& x) {
  return restricted(x, topological(cells, Operator::regularize, CellIncidence::support(x)));
}

CellIncidence::CellIncidence(const Complex& c) {
  vertex_number_.assign(c.points.size(), 0);
  for (std::size_t i = 0; i < c.vertices.size(); ++i) vertex_number_[c.vertices[i].index()] = i;
  edges_ = c.vertices.size();
  faces_ = edges_ + c.edge_count();
  regions_ = faces_ + c.face_count();
  closure_.resize(regions_ + c.region_count);
  const auto vertex = [&](VertexId v) { return vertex_number_[v.index()]; };
  for (const EdgeId e : IdRange<EdgeId>(c.edge_count()))
    for (const VertexId v : c.edge_ends[e]) closure_[edges_ + e.index()].push_back(vertex(v));
  // From loops and isolated vertices alone.
  for (const FaceId f : IdRange<FaceId>(c.face_count())) {
    std::set<std::size_t> bound;
    for (const LoopId l : c.face_loops[f])
      for (const HalfEdge h : c.loop[l]) bound.insert({edges_ + h.edge().index(), vertex(c.origin(h))});
    for (const VertexId v : c.face_vertices[f]) bound.insert(vertex(v));
    closure_[faces_ + f.index()].assign(bound.begin(), bound.end());
  }
  for (const RegionId r : IdRange<RegionId>(c.region_count)) {
    std::set<std::size_t> bound;
    const auto add = [&](std::size_t cell) {
      bound.insert(cell);
      bound.insert(closure_[cell].begin(), closure_[cell].end());
    };
    for (const FaceId f : IdRange<FaceId>(c.face_count()))
      if (c.face_regions[f][0] == r || c.face_regions[f][1] == r) add(faces_ + f.index());
    for (const EdgeId e : c.region_wires[r]) add(edges_ + e.index());
    for (const VertexId v : c.region_vertices[r]) add(vertex(v));
    closure_[regions_ + r.index()].assign(bound.begin(), bound.end());
  }
}

std::size_t CellIncidence::number(const Location& at) const {
  switch (at.dimension) {
    case 0: return vertex_number_[at.vertex.index()];
    case 1: return edges_ + at.edge.index();
    case 2: return faces_ + at.face.index();
    default: return regions_ + at.region.index();
  }
}

Labels CellIncidence::labels(const Selection& s) const {
  Labels out(size(), 0);
  for (const auto& [cell, component] : s.vertices) out[vertex_number_[cell.index()]] = component;
  for (const auto& [cell, component] : s.edges) out[edges_ + cell.index()] = component;
  for (const auto& [cell, component] : s.faces) out[faces_ + cell.index()] = component;
  for (const auto& [cell, component] : s.regions) out[regions_ + cell.index()] = component;
  return out;
}

Set CellIncidence::support(const Labels& labels) {
  Set out;
  for (const auto c : labels) out.push_back(c != 0);
  return out;
}

Set CellIncidence::interior(const Set& set) const {
  // A cell outside takes the cells of its boundary with it: their stars hold it.
  Set out = set;
  for (std::size_t i = 0; i < size(); ++i)
    if (!set[i])
      for (const std::size_t k : closure_[i]) out[k] = 0;
  return out;
}

Set CellIncidence::closure(const Set& set) const {
  Set out = set;
  for (std::size_t i = 0; i < size(); ++i)
    if (set[i])
      for (const std::size_t k : closure_[i]) out[k] = 1;
  return out;
}

std::string CellIncidence::name(std::size_t cell) const {
  if (cell < edges_) return "vertex " + std::to_string(cell);
  if (cell < faces_) return "edge " + std::to_string(cell - edges_);
  if (cell < regions_) return "face " + std::to_string(cell - faces_);
  return "region " + std::to_string(cell - regions_);
}

std::string compare_by_definition(const Complex& complex, const CellIncidence& cells, const DagNode& node,
                                  const std::vector<const NodeValue*>& operands, const NodeValue& value) {
  if (value.is_group()) {
    if (std::string f = check_group_components(complex, cells, value.group()); !f.empty()) return f;
  }
  const bool boolean =
      node.op == Operator::unite || node.op == Operator::intersect || node.op == Operator::subtract;
  if (boolean || node.op == Operator::leaf) return {};
  std::vector<Labels> x;
  for (const NodeValue* operand : operands) x.push_back(cells.labels(selection_of(complex, *operand)));
  Labels want = operator_by_definition(cells, node, x);
  if (node.regularize) {
    want = regularized_by_definition(cells, want);
  }
  Labels have = cells.labels(selection_of(complex, value));
  if (value.is_group()) {  // closure and regularize stay groups: their regions are detected again
    for (auto& c : want) c = c != 0;
    for (auto& c : have) c = c != 0;
  } else if (const std::size_t n = value.component_count(); n != *std::max_element(want.begin(), want.end())) {
    return std::to_string(n) + " components, by definition " +
           std::to_string(*std::max_element(want.begin(), want.end()));
  }
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (want[i] != have[i])
      return cells.name(i) + " is of component " + std::to_string(have[i]) + ", by definition of " +
             std::to_string(want[i]);
  return {};
}

}  // namespace cnrg::properties
