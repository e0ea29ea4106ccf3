// OpenCASCADE in a process of its own (csg/text/child.h). On a file that is damaged its readers follow null
// pointers, walk in circles, or ask for all memory; and its algorithms do so on shapes that its readers let
// through.
//
// The child reads and tessellates by the plug-in `cad` as a process without a child would, so facets are the
// same to the last bit: doubles come back as their bytes. What comes back is checked as far as this process relies
// on it, for a child that has overwritten its memory may end well: numbers are in range, lists of one length. All
// else is checked by cad.cpp, as for any file.
//
// The bounds are there to end what does not end. A child may work for ten minutes and longer on a large file, and
// take as much memory as the machine has.
#include <algorithm>
#include <new>

#include "csg/imports/cad_model.h"
#include "csg/imports/leaf_file.h"
#include "csg/leaves/leaf.h"
#include "csg/leaves/leaf_stop.h"
#include "csg/text/child.h"
#include "csg/text/input_file.h"
#include "csg/text/plugin.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

using Index = std::uint32_t;

/// What the child writes first: a model follows, or the text of an error.
enum class Answer : std::uint8_t { model, input_error, leaf_file_error, broken_invariant };

ChildLimits limits(const std::string& content) {
  constexpr std::size_t kSeconds = 600, kBytesPerSecond = 100'000;
  return {.seconds = kSeconds + content.size() / kBytesPerSecond, .bytes = memory_of_machine()};
}

// --- in the child

template <class T, class Write>
void write_each(const MemoryFile& file, const std::vector<T>& list, const Write& write) {
  file.write_value(std::uint64_t(list.size()));
  for (const T& item : list) write(item);
}

void write_knots(const MemoryFile& file, const CadKnots& knots) {
  file.write_value(knots.degree);
  file.write_value(knots.periodic);
  file.write_list(knots.values);
  file.write_list(knots.counts);
}

void write_curve(const MemoryFile& file, const CadCurve& curve) {
  file.write_value(curve.kind);
  for (const double x : {curve.first, curve.last, curve.radius, curve.minor_radius}) file.write_value(x);
  file.write_value(curve.axes);
  file.write_list(curve.points);
  file.write_list(curve.weights);
  write_knots(file, curve.knots);
  file.write_list(curve.name);
}

void write_surface(const MemoryFile& file, const CadSurface& surface) {
  file.write_value(surface.kind);
  file.write_value(surface.turned);
  file.write_value(surface.axes);
  for (const double x : {surface.radius, surface.minor_radius, surface.half_angle}) file.write_value(x);
  file.write_value(surface.rows);
  file.write_list(surface.points);
  file.write_list(surface.weights);
  for (const CadKnots& knots : surface.knots) write_knots(file, knots);
  write_curve(file, surface.profile);
  file.write_list(surface.name);
}

void write_model(const MemoryFile& file, const CadModel& model) {
  file.write_list(model.points);
  write_each(file, model.faces, [&](const CadModel::Face& face) {
    file.write_list(face.triangles);
    file.write_list(face.places);
    write_each(file, face.border, [&](const auto& step) {
      file.write_value(step.first);
      file.write_value(step.second);
    });
    file.write_list(face.behind);
    file.write_list(face.before);
    file.write_value(face.outside);
    write_surface(file, face.surface);
  });
  write_each(file, model.edges, [&](const CadModel::Edge& edge) {
    file.write_list(edge.points);
    file.write_list(edge.parameters);
    file.write_value(edge.seam);
    write_curve(file, edge.curve);
  });
  write_each(file, model.vertices, [&](const CadModel::Vertex& vertex) {
    file.write_value(vertex.point);
    file.write_value(vertex.seam);
  });
  for (const auto* texts : {&model.solids, &model.notices})
    write_each(file, *texts, [&](const std::string& text) { file.write_list(text); });
}

void write_error(const MemoryFile& file, Answer kind, const std::string& words) {
  file.write_value(kind);
  file.write_list(words);
}

int read_in_child(decltype(&cnrg_cad_read) read, const CadShape& shape, const std::string& content,
                  const MemoryFile& file) {
  try {
    CadModel model;
    read(shape, content, model);
    file.write_value(Answer::model);
    write_model(file, model);
  } catch (const LeafFileError& error) {
    write_error(file, Answer::leaf_file_error, error.fault());
    file.write_value(error.line());
  } catch (const InputError& error) {
    write_error(file, Answer::input_error, error.what());
  } catch (const InvariantError& error) {
    write_error(file, Answer::broken_invariant, error.what());
  }
  return 0;
}

// --- in the parent

class ModelReader {
 public:
  explicit ModelReader(const MemoryFile& file) : file_(file) {}

  CadModel read() {
    file_.read_list(model_.points);
    read_each(model_.faces, [&](CadModel::Face& face) {
      file_.read_list(face.triangles);
      file_.read_list(face.places);
      read_each(face.border, [&](auto& step) {
        step.first = file_.read_value<Index>();
        step.second = read_bool();
      });
      file_.read_list(face.behind);
      file_.read_list(face.before);
      face.outside = read_bool();
      read_surface(face.surface);
    });
    read_each(model_.edges, [&](CadModel::Edge& edge) {
      file_.read_list(edge.points);
      file_.read_list(edge.parameters);
      edge.seam = read_bool();
      read_curve(edge.curve);
    });
    read_each(model_.vertices, [&](CadModel::Vertex& vertex) {
      vertex.point = file_.read_value<Index>();
      vertex.seam = read_bool();
    });
    for (auto* texts : {&model_.solids, &model_.notices})
      read_each(*texts, [&](std::string& text) { file_.read_list(text); });
    check();
    return std::move(model_);
  }

 private:
  const MemoryFile& file_;
  CadModel model_;

  bool read_bool() const { return file_.read_value<std::uint8_t>() != 0; }

  void read_knots(CadKnots& knots) const {
    knots.degree = file_.read_value<int>();
    knots.periodic = read_bool();
    file_.read_list(knots.values);
    file_.read_list(knots.counts);
  }
  void read_curve(CadCurve& curve) const {
    curve.kind = read_kind(CadCurve::Kind::other);
    for (double* x : {&curve.first, &curve.last, &curve.radius, &curve.minor_radius})
      *x = file_.read_value<double>();
    curve.axes = file_.read_value<CadAxes>();
    file_.read_list(curve.points);
    file_.read_list(curve.weights);
    read_knots(curve.knots);
    file_.read_list(curve.name);
  }
  void read_surface(CadSurface& surface) const {
    surface.kind = read_kind(CadSurface::Kind::other);
    surface.turned = read_bool();
    surface.axes = file_.read_value<CadAxes>();
    for (double* x : {&surface.radius, &surface.minor_radius, &surface.half_angle})
      *x = file_.read_value<double>();
    surface.rows = file_.read_value<std::array<std::uint32_t, 2>>();
    file_.read_list(surface.points);
    file_.read_list(surface.weights);
    for (CadKnots& knots : surface.knots) read_knots(knots);
    read_curve(surface.profile);
    file_.read_list(surface.name);
  }
  /// A kind up to `last`.
  template <class Kind>
  Kind read_kind(Kind last) const {
    const auto number = file_.read_value<std::uint8_t>();
    require_sound(number <= static_cast<std::uint8_t>(last));
    return static_cast<Kind>(number);
  }

  template <class T, class Read>
  void read_each(std::vector<T>& list, const Read& read) const {
    const auto n = file_.read_value<std::uint64_t>();
    for (std::uint64_t i = 0; i < n; ++i) read(list.emplace_back());  // ends with the file, if n is wrong
  }

  static void require_below(std::size_t limit, const std::vector<Index>& numbers) {
    for (const Index n : numbers) require_below(limit, n);
  }
  static void require_below(std::size_t limit, Index n) { require_sound(n < limit); }
  static void require_sound(bool sound) {
    if (!sound) throw InputError("OpenCASCADE returned a result that is damaged");
  }

  static void check_knots(const CadKnots& knots) { require_sound(knots.values.size() == knots.counts.size()); }
  static void check_spline(const CadCurve& curve) {
    check_knots(curve.knots);
    require_sound(curve.weights.empty() || curve.weights.size() == curve.points.size());
  }
  static void check_splines(const CadSurface& surface) {
    for (const CadKnots& knots : surface.knots) check_knots(knots);
    require_sound(surface.points.size() == std::uint64_t{surface.rows[0]} * surface.rows[1]);
    require_sound(surface.weights.empty() || surface.weights.size() == surface.points.size());
    check_spline(surface.profile);
  }

  void check() const {
    for (const CadModel::Face& face : model_.faces) {
      require_sound(face.places.size() == face.triangles.size());
      check_splines(face.surface);
      for (const auto& triangle : face.triangles) {
        for (const Index p : triangle) require_below(model_.points.size(), p);
      }
      for (const auto& [edge, forward] : face.border) require_below(model_.edges.size(), edge);
      require_below(model_.solids.size(), face.behind);
      require_below(model_.solids.size(), face.before);
    }
    for (const CadModel::Edge& edge : model_.edges) {
      require_sound(!edge.points.empty() && edge.parameters.size() == edge.points.size());
      require_below(model_.points.size(), edge.points);
      check_spline(edge.curve);
    }
    for (const CadModel::Vertex& vertex : model_.vertices) require_below(model_.points.size(), vertex.point);
  }
};

/// What became of a child that has no answer.
[[noreturn]] void fail(const CadShape& shape, const ChildEnd& end) {
  using Kind = ChildEnd::Kind;
  const std::string repair = ": write the file again, or repair the part where it was made";
  switch (end.kind) {
    case Kind::time:
      throw InputError(cad_subject(shape) + "OpenCASCADE did not end within " + std::to_string(end.seconds) +
                       " s of processor time" + repair + ", or give a larger `chord` or fewer `segments`");
    case Kind::memory:
      throw FileError(cad_subject(shape) + "OpenCASCADE ran out of memory: free some, " + repair.substr(2) +
                      ", or give a larger `chord` or fewer `segments`");
    case Kind::signal:
      throw InputError(cad_subject(shape) + "OpenCASCADE crashed (signal " + std::to_string(end.number) + ")" +
                       repair);
    default:
      throw InputError(cad_subject(shape) + "OpenCASCADE ended its process (" + std::to_string(end.number) + ")" +
                       repair);
  }
}

}  // namespace

std::string cad_subject(const CadShape& shape) { return std::string(shape.name()) + ": '" + shape.file + "': "; }

CadModel read_cad(const CadShape& shape) {
  require_plugin(kCadPlugin, std::string(shape.name()) + ": '" + shape.file + "'", "give the part as a mesh file");
  const auto read = CNRG_PLUGIN_FUNCTION(kCadPlugin, cnrg_cad_read);
  const std::string content = read_leaf_file(shape.file, shape.inside, "write the part again");
  const MemoryFile file("OpenCASCADE");
  const ChildEnd end = run_in_child(
      "OpenCASCADE", limits(content), [&] { return read_in_child(read, shape, content, file); },
      LeafStop::token());
  if (end.kind != ChildEnd::Kind::done || end.number != 0) fail(shape, end);
  file.rewind();
  const auto answer = file.read_value<Answer>();
  if (answer == Answer::model) return ModelReader(file).read();
  std::string words;
  file.read_list(words);
  switch (answer) {
    case Answer::leaf_file_error: throw LeafFileError(shape.file, file.read_value<int>(), 0, words);
    case Answer::broken_invariant: throw InvariantError(words);
    default: throw InputError(words);
  }
}

}  // namespace cnrg
