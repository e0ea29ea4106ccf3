// OpenCASCADE in a process of its own (csg/text/child.h). On a file that is damaged its readers follow null
// pointers, walk in circles, or ask for all memory; and its algorithms do so on shapes that its readers let
// through.
//
// The child reads and tessellates by the plug-in `cad` as a process without a child would, so facets are the
// same to the last bit: doubles come back as their bytes. What comes back is checked as far as this process relies
// on it, for a child that has overwritten its memory may end well: numbers are in range, lists of one length. All
// else is checked by cad.cpp, as for any file.
//
// The bounds are there to end what does not end. A child may work for a minute on a small file, for ten minutes
// and longer on a large one, and take as much memory as the machine has.
#include <algorithm>
#include <utility>

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
  constexpr std::size_t kLeast = 60, kMost = 600, kOfSmall = 5'000,
                        kOfLarge = 100'000;  // seconds, bytes per second
  const std::size_t size = content.size();
  return {.seconds = std::min(kLeast + size / kOfSmall, kMost) + size / kOfLarge, .bytes = memory_of_machine()};
}

// --- a model, field by field: the same order in the child, which writes it, and in the parent, which reads it

template <class Archive, class Knots>
void pass_knots(const Archive& to, Knots& knots) {
  to.value(knots.degree);
  to.value(knots.periodic);
  to.list(knots.values);
  to.list(knots.counts);
}

template <class Archive, class Curve>
void pass_curve(const Archive& to, Curve& curve) {
  to.kind(curve.kind, CadCurve::Kind::other);
  for (auto* x : {&curve.first, &curve.last, &curve.radius, &curve.minor_radius}) to.value(*x);
  to.value(curve.axes);
  to.list(curve.points);
  to.list(curve.weights);
  pass_knots(to, curve.knots);
  to.list(curve.name);
}

template <class Archive, class Surface>
void pass_surface(const Archive& to, Surface& surface) {
  to.kind(surface.kind, CadSurface::Kind::other);
  to.value(surface.turned);
  to.value(surface.axes);
  for (auto* x : {&surface.radius, &surface.minor_radius, &surface.half_angle}) to.value(*x);
  to.value(surface.rows);
  to.list(surface.points);
  to.list(surface.weights);
  for (auto& knots : surface.knots) pass_knots(to, knots);
  pass_curve(to, surface.profile);
  to.list(surface.name);
}

template <class Archive, class Model>
void pass_model(const Archive& to, Model& model) {
  to.list(model.points);
  to.each(model.faces, [&](auto& face) {
    to.list(face.triangles);
    to.list(face.places);
    to.each(face.border, [&](auto& step) { to.value(step.first), to.value(step.second); });
    to.list(face.behind);
    to.list(face.before);
    to.value(face.outside);
    pass_surface(to, face.surface);
  });
  to.each(model.edges, [&](auto& edge) {
    to.list(edge.points);
    to.list(edge.parameters);
    to.value(edge.seam);
    pass_curve(to, edge.curve);
  });
  to.each(model.vertices, [&](auto& vertex) { to.value(vertex.point), to.value(vertex.seam); });
  for (auto* texts : {&model.solids, &model.notices}) to.each(*texts, [&](auto& text) { to.list(text); });
}

// --- in the child

struct ModelWriter {
  const MemoryFile& file;

  void value(const auto& x) const { file.write_value(x); }
  void kind(const auto& x, const auto&) const { file.write_value(x); }
  void list(const auto& items) const { file.write_list(items); }
  template <class T, class Pass>
  void each(const std::vector<T>& items, const Pass& pass) const {
    file.write_value(std::uint64_t(items.size()));
    for (const T& item : items) pass(item);
  }
};

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
    pass_model(ModelWriter{file}, std::as_const(model));
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
    pass_model(*this, model_);
    check();
    return std::move(model_);
  }

  template <class T>
  void value(T& x) const {
    x = file_.read_value<T>();
  }
  void value(bool& x) const { x = file_.read_value<std::uint8_t>() != 0; }
  /// A kind up to `last`.
  template <class Kind>
  void kind(Kind& x, Kind last) const {
    const auto number = file_.read_value<std::uint8_t>();
    require_sound(number <= static_cast<std::uint8_t>(last));
    x = static_cast<Kind>(number);
  }
  void list(auto& items) const { file_.read_list(items); }
  template <class T, class Pass>
  void each(std::vector<T>& items, const Pass& pass) const {
    const auto n = file_.read_value<std::uint64_t>();
    for (std::uint64_t i = 0; i < n; ++i) pass(items.emplace_back());  // ends with the file, if n is wrong
  }

 private:
  const MemoryFile& file_;
  CadModel model_;

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
