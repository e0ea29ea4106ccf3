#include "bench/cases/model.h"

#include <istream>
#include <ostream>
#include <sstream>
#include <stdexcept>

namespace cnrg::bench {

bool Model::solid() const {
  for (const Face& face : faces)
    if (!face.solid) return false;
  return wires.empty() && isolated.empty();
}

std::size_t Model::triangle_count() const {
  std::size_t count = 0;
  for (const Face& face : faces) {
    for (const auto& loop : face.loops) count += loop.size();
    count += 2 * face.loops.size();  // a hole takes a bridge of two
    count -= 4;
  }
  return count;
}

Model model_of(const TriangleMesh& mesh, bool solid) {
  Model model;
  model.points.reserve(mesh.points.size());
  for (const auto& [x, y, z] : mesh.points)
    model.points.push_back({from_double(x), from_double(y), from_double(z)});
  for (const auto& polygon : mesh.polygons) model.faces.push_back({{polygon}, solid});
  if (!mesh.polygons.empty()) return model;
  model.faces.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) model.faces.push_back({{{a, b, c}}, solid});
  return model;
}

Rational signed_volume(const Model& model) {
  std::vector<Rational> six_times;
  for (const Model::Face& face : model.faces) {
    if (!face.solid) continue;
    for (const auto& loop : face.loops)
      for (std::size_t k = 2; k < loop.size(); ++k) {
        const RationalPoint &a = model.points[loop[0]], &b = model.points[loop[k - 1]], &c = model.points[loop[k]];
        six_times.push_back(a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                            a[2] * (b[0] * c[1] - b[1] * c[0]));
      }
  }
  return sum(std::move(six_times)) / 6;
}

TriangleMesh rounded_mesh(const Model& model) {
  if (!model.solid()) throw std::invalid_argument("a surface, wire or point by itself is no part of a mesh");
  TriangleMesh mesh;
  mesh.points.reserve(model.points.size());
  for (const auto& [x, y, z] : model.points) mesh.points.push_back({to_double(x), to_double(y), to_double(z)});
  bool polygons = false;
  for (const Model::Face& face : model.faces) {
    if (face.loops.size() != 1) throw std::invalid_argument("a face with holes is no polygon");
    polygons = polygons || face.loops[0].size() > 3;
  }
  for (std::uint32_t f = 0; f < model.faces.size(); ++f) {
    const auto& loop = model.faces[f].loops[0];
    for (std::size_t k = 2; k < loop.size(); ++k) {
      mesh.triangles.push_back({loop[0], loop[k - 1], loop[k]});
      if (polygons) mesh.faces.push_back(f);
    }
    if (polygons) mesh.polygons.push_back(loop);
  }
  return mesh;
}

void write_model(std::ostream& out, const Model& model) {
  out << "model " << model.points.size() << ' ' << model.faces.size() << ' ' << model.wires.size() << ' '
      << model.isolated.size() << '\n';
  for (const RationalPoint& p : model.points) out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for (const Model::Face& face : model.faces) {
    out << (face.solid ? "solid " : "sheet ") << face.loops.size();
    for (const auto& loop : face.loops) {
      out << ' ' << loop.size();
      for (const std::uint32_t p : loop) out << ' ' << p;
    }
    out << '\n';
  }
  for (const auto& [a, b] : model.wires) out << a << ' ' << b << '\n';
  for (const std::uint32_t p : model.isolated) out << p << '\n';
}

Model read_model(std::istream& in) {
  std::size_t line = 0;
  std::string text;
  std::istringstream words;
  const auto fail = [&](const std::string& what) {
    throw std::runtime_error("line " + std::to_string(line) + " of a model: " + what);
  };
  const auto next_line = [&] {
    ++line;
    if (!std::getline(in, text)) fail("the text ends early");
    words = std::istringstream(text);
  };
  const auto number = [&](std::size_t below) {
    std::size_t value = 0;
    if (!(words >> value) || value >= below) fail("a number is missing or too large");
    return value;
  };
  constexpr std::size_t kAny = 0xffffffffu;
  next_line();
  std::string word;
  if (!(words >> word) || word != "model") fail("does not start with `model`");
  Model model;
  model.points.resize(number(kAny));
  model.faces.resize(number(kAny));
  model.wires.resize(number(kAny));
  model.isolated.resize(number(kAny));
  const std::size_t points = model.points.size();
  for (RationalPoint& p : model.points) {
    next_line();
    for (Rational& x : p) {
      if (!(words >> word) || x.set_str(word, 10) != 0 || x.get_den() == 0) fail("a coordinate is no fraction");
      x.canonicalize();
    }
  }
  for (Model::Face& face : model.faces) {
    next_line();
    if (!(words >> word) || (word != "solid" && word != "sheet")) fail("is neither a solid face nor a sheet");
    face.solid = word == "solid";
    face.loops.resize(number(kAny));
    for (auto& loop : face.loops) {
      loop.resize(number(kAny));
      for (std::uint32_t& p : loop) p = static_cast<std::uint32_t>(number(points));
    }
  }
  for (auto& wire : model.wires) {
    next_line();
    for (std::uint32_t& p : wire) p = static_cast<std::uint32_t>(number(points));
  }
  for (std::uint32_t& p : model.isolated) {
    next_line();
    p = static_cast<std::uint32_t>(number(points));
  }
  return model;
}

}  // namespace cnrg::bench
