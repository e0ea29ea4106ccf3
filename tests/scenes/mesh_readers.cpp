#include "tests/scenes/mesh_readers.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace cnrg::test {
namespace {

void demand(bool condition, const std::string& what) {
  if (!condition) throw std::runtime_error("not of the format: " + what);
}

template <class T>
T next(std::istream& in) {
  T value;
  demand(bool(in >> value), "a number is missing");
  return value;
}

std::array<double, 3> next_point(std::istream& in) {
  const double x = next<double>(in), y = next<double>(in), z = next<double>(in);
  return {x, y, z};
}

/// The lines between $NAME and $EndNAME.
std::istringstream section(const std::string& text, const std::string& name) {
  const auto begin = text.find("$" + name + "\n"), end = text.find("$End" + name + "\n");
  demand(begin != std::string::npos && end != std::string::npos, name);
  return std::istringstream(text.substr(begin + name.size() + 2, end - begin - name.size() - 2));
}

/// The text without lines that begin with #.
std::istringstream without_comments(const std::string& text) {
  std::istringstream lines(text);
  std::string line, rest;
  while (std::getline(lines, line)) {
    if (line.empty() || line[0] != '#') rest += line + "\n";
  }
  return std::istringstream(rest);
}

using Vector = std::array<double, 3>;
Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector cross_of(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double length(const Vector& a) { return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]); }

}  // namespace

std::size_t MeshFile::count(int dimension) const {
  return std::size_t(
      std::count_if(elements.begin(), elements.end(), [&](const Element& e) { return e.dimension == dimension; }));
}

std::set<std::string> MeshFile::names_of(int dimension) const {
  std::set<std::string> result;
  for (const auto& [key, name] : names) {
    if (key.first == dimension) result.insert(name);
  }
  return result;
}

std::vector<MeshFile::Element> MeshFile::in_group(int dimension, const std::string& name) const {
  std::vector<Element> result;
  for (const Element& e : elements) {
    if (e.dimension != dimension) continue;
    for (const int g : entities.at({dimension, e.entity}).groups) {
      if (names.at({dimension, g}) == name) result.push_back(e);
    }
  }
  return result;
}

Rational MeshFile::six_volumes(const Element& e) const {
  Rational m[3][3];
  for (int i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      m[i][k] = from_double(nodes.at(e.nodes[std::size_t(i) + 1])[k]) - from_double(nodes.at(e.nodes[0])[k]);
    }
  }
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

Rational MeshFile::volume(int entity) const {
  Rational six = 0;
  for (const Element& e : elements) {
    if (e.dimension == 3 && e.entity == entity) six += six_volumes(e);
  }
  return six / 6;
}

Rational MeshFile::volume(const std::string& group) const {
  Rational six = 0;
  for (const Element& e : in_group(3, group)) six += six_volumes(e);
  return six / 6;
}

double MeshFile::measure(const std::vector<Element>& list) const {
  double sum = 0;
  for (const Element& e : list) {
    const Vector u = minus(nodes.at(e.nodes.at(1)), nodes.at(e.nodes[0]));
    const Vector v = minus(nodes.at(e.nodes.back()), nodes.at(e.nodes[0]));
    sum += e.dimension == 1 ? length(u) : length(cross_of(u, v)) / 2;
  }
  return sum;
}

std::size_t MeshFile::loose(int dimension) const {
  std::set<std::vector<int>> in_tetrahedra;
  for (const Element& e : elements) {
    if (e.dimension != 3) continue;
    for (unsigned mask = 1; mask < 16; ++mask) {
      std::vector<int> part;
      for (std::size_t k = 0; k < 4; ++k) {
        if (mask >> k & 1) part.push_back(e.nodes[k]);
      }
      if (int(part.size()) != dimension + 1) continue;
      std::sort(part.begin(), part.end());
      in_tetrahedra.insert(part);
    }
  }
  std::size_t n = 0;
  for (const Element& e : elements) {
    if (e.dimension != dimension) continue;
    std::vector<int> part = e.nodes;
    std::sort(part.begin(), part.end());
    n += in_tetrahedra.count(part) == 0;
  }
  return n;
}

MeshFile read_msh(const std::string& text) {
  MeshFile file;
  demand(text.rfind("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n", 0) == 0, "MeshFormat");
  if (text.find("$PhysicalNames\n") != std::string::npos) {
    auto in = section(text, "PhysicalNames");
    for (int n = next<int>(in); n > 0; --n) {
      const int dimension = next<int>(in), number = next<int>(in);
      std::string name;
      std::getline(in, name);
      demand(name.size() > 3 && name.find('"') == 1 && name.back() == '"', "a name");
      demand(file.names.try_emplace({dimension, number}, name.substr(2, name.size() - 3)).second, "a group twice");
    }
  }
  auto in = section(text, "Entities");
  int counts[4];
  for (int& n : counts) n = next<int>(in);
  for (int d = 0; d < 4; ++d) {
    for (int i = 0; i < counts[d]; ++i) {
      auto& entity = file.entities[{d, next<int>(in)}];
      for (int k = 0; k < (d == 0 ? 3 : 6); ++k) next<double>(in);
      for (int n = next<int>(in); n > 0; --n) entity.groups.push_back(next<int>(in));
      if (d == 0) continue;
      for (int n = next<int>(in); n > 0; --n) {
        entity.boundary.push_back(next<int>(in));
        demand(file.entities.count({d - 1, std::abs(entity.boundary.back())}) == 1, "a boundary");
      }
    }
  }
  in = section(text, "Nodes");
  int blocks = next<int>(in);
  const std::size_t nodes = next<std::size_t>(in);
  next<int>(in), next<int>(in);
  for (; blocks > 0; --blocks) {
    const int d = next<int>(in), entity = next<int>(in);
    demand(file.entities.count({d, entity}) == 1 && next<int>(in) == 0, "a block of nodes");
    std::vector<int> numbers(next<std::size_t>(in));
    for (int& n : numbers) n = next<int>(in);
    for (const int n : numbers) demand(file.nodes.try_emplace(n, next_point(in)).second, "a node twice");
  }
  demand(file.nodes.size() == nodes, "the number of nodes");
  in = section(text, "Elements");
  blocks = next<int>(in);
  const std::size_t elements = next<std::size_t>(in);
  next<int>(in), next<int>(in);
  static constexpr int kTypes[] = {15, 1, 2, 4};
  for (; blocks > 0; --blocks) {
    const int d = next<int>(in), entity = next<int>(in), type = next<int>(in);
    demand(d >= 0 && d < 4 && (type == kTypes[d] || type > 4) && file.entities.count({d, entity}) == 1, "a block");
    for (int n = next<int>(in); n > 0; --n) {
      demand(next<std::size_t>(in) > 0, "an element");
      auto& e = file.elements.emplace_back(MeshFile::Element{d, entity, {}});
      for (int k = 0; k <= d; ++k) e.nodes.push_back(next<int>(in));
      for (const int p : e.nodes) demand(file.nodes.count(p) == 1, "a node of an element");
    }
  }
  demand(file.elements.size() == elements, "the number of elements");
  return file;
}

MeshFile read_medit(const std::string& text) {
  MeshFile file;
  std::istringstream comments(text);
  for (std::string line; std::getline(comments, line);) {
    if (line.rfind("# ", 0) != 0) continue;
    std::istringstream words(line.substr(2));
    std::string kind, name;
    int number;
    words >> kind >> number >> std::ws;
    std::getline(words, name);
    static const std::map<std::string, int> kinds{
        {"vertices", 0}, {"edges", 1}, {"triangles", 2}, {"tetrahedra", 3}};
    file.names[{kinds.at(kind), number}] = name;
  }
  auto in = without_comments(text);
  static const std::map<std::string, int> sections{{"Edges", 1}, {"Triangles", 2}, {"Tetrahedra", 3}};
  for (std::string word; in >> word;) {
    if (word == "End") return file;
    if (word == "Identifier") continue;  // for others; what is behind it is said to us
    const int n = next<int>(in);
    if (word == "MeshVersionFormatted" || word == "Dimension") {
      demand(n == (word == "Dimension" ? 3 : 2), word);
    } else if (word == "Vertices") {
      for (int i = 1; i <= n; ++i) {
        file.nodes[i] = next_point(in);
        const int reference = next<int>(in);
        file.entities[{0, reference}].groups = {reference};
        if (reference != 0) file.elements.push_back({0, reference, {i}});
      }
    } else if (const auto found = sections.find(word); found != sections.end()) {
      for (int i = 0; i < n; ++i) {
        auto& e = file.elements.emplace_back(MeshFile::Element{found->second, 0, {}});
        for (int k = 0; k <= found->second; ++k) e.nodes.push_back(next<int>(in));
        for (const int p : e.nodes) demand(file.nodes.count(p) == 1, "a node of an element");
        e.entity = next<int>(in);
        auto& groups = file.entities[{found->second, e.entity}].groups;
        if (e.entity != 0) groups = {e.entity};
      }
    } else {
      demand(word == "Corners" || word == "RequiredVertices" || word == "Ridges" || word == "RequiredEdges", word);
      for (int i = 0; i < n; ++i) file.lists[word].insert(next<int>(in));
    }
  }
  throw std::runtime_error("no End");
}

TetgenFile read_tetgen(const std::string& text, bool poly) {
  auto in = without_comments(text);
  TetgenFile file;
  const int points = next<int>(in);
  demand(next<int>(in) == 3 && next<int>(in) == 0 && next<int>(in) == 1, "the head of points");
  for (int i = 0; i < points; ++i) {
    const int number = next<int>(in);
    file.nodes[number] = next_point(in);
    file.node_marker[number] = next<int>(in);
  }
  const auto polygon = [&] {
    std::vector<int> corners(next<std::size_t>(in));
    for (int& c : corners) c = next<int>(in);
    for (const int c : corners) demand(file.nodes.count(c) == 1, "a corner");
    return corners;
  };
  const int facets = next<int>(in);
  demand(next<int>(in) == 1, "markers of facets");
  for (int i = 0; i < facets; ++i) {
    TetgenFile::Facet facet;
    if (!poly) {
      facet.polygons.push_back(polygon());
      facet.marker = next<int>(in);
    } else {
      int polygons = next<int>(in), holes = next<int>(in);
      facet.marker = next<int>(in);
      for (; polygons > 0; --polygons) facet.polygons.push_back(polygon());
      for (; holes > 0; --holes) {
        next<int>(in);
        facet.holes.push_back(next_point(in));
      }
    }
    file.facets.push_back(facet);
  }
  for (int n = next<int>(in); n > 0; --n) {
    next<int>(in);
    file.holes.push_back(next_point(in));
  }
  for (int n = next<int>(in); n > 0; --n) {
    next<int>(in);
    const auto point = next_point(in);
    file.regions.push_back({point, next<int>(in)});
    demand(next<int>(in) == -1, "a bound of volumes");
  }
  std::string rest;
  demand(!(in >> rest), "nothing more");
  return file;
}

std::map<int, double> tetgen_volumes(const std::string& node_text, const std::string& ele_text) {
  auto in = without_comments(node_text);
  std::map<int, std::array<double, 3>> nodes;
  const int points = next<int>(in);
  next<int>(in), next<int>(in);
  const bool marked = next<int>(in) == 1;
  for (int i = 0; i < points; ++i) {
    const int number = next<int>(in);
    nodes[number] = next_point(in);
    if (marked) next<int>(in);
  }
  in = without_comments(ele_text);
  const int elements = next<int>(in);
  demand(next<int>(in) == 4 && next<int>(in) == 1, "tetrahedra with one attribute");
  std::map<int, double> volumes;
  for (int i = 0; i < elements; ++i) {
    next<int>(in);
    Vector p[4];
    for (Vector& corner : p) corner = nodes.at(next<int>(in));
    const Vector n = cross_of(minus(p[1], p[0]), minus(p[2], p[0])), d = minus(p[3], p[0]);
    volumes[next<int>(in)] += std::abs(n[0] * d[0] + n[1] * d[1] + n[2] * d[2]) / 6;
  }
  return volumes;
}

bool installed(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

}  // namespace cnrg::test
