// All that a result file says, held against the cells that it makes.
//
// A file lists cells, and then says of them what follows from where they are: which region is on which side, what
// bounds it, its volume, triangles, which cells are wires. A reader that trusts these takes an edge that was moved
// through a face for one edge, and a region without faces for nothing. So the cells of the file are refined by
// themselves, each cell that is listed stays a cell, and they are written again: the first value that differs is
// an error. Nothing is told twice how files are written.
//
// What a file says and its cells cannot contradict is taken as it is: which component a cell is of (as long as a
// group stays a group), features, names, parameters u and v, and where cells came from. Which of two diagonals
// halves a rectangle is left to the file: triangles are checked by themselves.
#include <algorithm>
#include <map>

#include "csg/imports/leaf_file.h"
#include "csg/leaves/prepare_shapes.h"
#include "csg/result/result_data.h"
#include "csg/result/result_json.h"
#include "csg/transfer/leaf_value.h"
#include "csg/transfer/marked_cells.h"
#include "kernel/base/leaf_words.h"
#include "kernel/base/limits.h"
#include "kernel/complex/builder.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/predicates.h"

namespace cnrg {
namespace result {
namespace {

using Piece = CellMap::Piece;
using Loop = FlatComplex::Loop;
using Triangle = FlatComplex::Triangle;

std::string words(const char* kind, Index number) { return std::string(kind) + " " + std::to_string(number); }

/// The cells of the file as a complex; an error at the first face that is not planar, or whose sides are not.
std::shared_ptr<const Complex> complex_of(const Cursor& root, const StoredValue& stored) {
  const auto made = [&](Fill fill) {
    Soup soup;
    add_to(soup, stored, {}, fill);
    return build_complex(soup);
  };
  const auto face = [&](const LeafError& e) {
    return root.member("faces").at(e.words().places().at(0).faces.at(0));
  };
  try {
    return made(Fill::sides);
  } catch (const LeafError& sides) {
    try {
      made(Fill::none);
    } catch (const LeafError& e) {
      const std::string text = e.words().text([](const LeafPlace&) { return std::string(); });
      face(e).refuse(text.substr(2, text.find(';') - 2));
    }
    face(sides).member("regions").refuse("the faces around one region name several");
  }
}

/// The face that a facet of the file has become, and whether it has the same front.
struct PlacedFacet {
  FaceId cell;
  bool same = true;
};

Triangle read_triangle(const Complex& c, const PlacedFacet& facet, const Cursor& at) {
  at.array_of(3, "a triangle has three points");
  Triangle p{};
  for (std::size_t k = 0; k < 3; ++k) p[k] = at.at(k).number(c.points.size(), "point");
  const Projection axes = c.sheet_projection[c.face_sheet[facet.cell]];
  const bool turned =
      p[0] != p[1] && p[1] != p[2] && p[2] != p[0] &&
      orient2d(c.points, axes, VertexId(p[0]), VertexId(p[1]), VertexId(p[2])) == (facet.same ? 1 : -1);
  if (!turned) at.refuse("a triangle goes counter-clockwise as seen from the front of its face");
  if (p[0] > p[1] || p[0] > p[2]) at.refuse("a triangle begins at its point of the least number");
  return p;
}

bool cover(const std::vector<Triangle>& triangles, const std::vector<Loop>& walks,
           const ShortList<Index, 2>& isolated) {
  std::map<std::pair<Index, Index>, int> sides;  // how often, less how often the walks go there
  std::map<Index, int> corners;
  const auto add = [&](const auto& walk, int n) {
    for (std::size_t i = 0; i < walk.size(); ++i) sides[{walk[i], walk[(i + 1) % walk.size()]}] += n;
  };
  for (const Triangle& t : triangles) {
    add(t, 1);
    for (const Index p : t) ++corners[p];
  }
  for (const Loop& walk : walks) add(walk, -1);
  const auto cancels = [&](const auto& side) {
    const auto& [step, n] = side;
    const auto back = sides.find({step.second, step.first});
    return n == 0 || (n > 0 && back != sides.end() && back->second == n);
  };
  return std::all_of(sides.begin(), sides.end(), cancels) &&
         std::all_of(isolated.begin(), isolated.end(), [&](Index p) { return corners.contains(p); });
}

bool in_plane(const std::vector<PatchCorner>& cell, const RationalPoint& p) {
  const auto flat = [&](std::size_t i, std::size_t k) {
    return volume6(cell[0].point, cell[i].point, cell[k].point, p) == 0;
  };
  return flat(1, 2) && (cell.size() == 3 || flat(2, 3));
}

/// Triangles of a face of the file, and the cells of its patch, against the face. They are not made again.
/// Triangles are turned as their facet is, begin with their least point, and cover it once: their sides cancel but
/// for its walks. `face` is what the cells of the file make of a face, `placed` its facets, `at` its place in the
/// file, whose points have their numbers in the complex.
void require_triangles(const Complex& complex, const FlatComplex::Face& face, const PlacedFacet* placed,
                       const Cursor& at) {
  const Cursor list = at.member("triangles").array();
  std::size_t t = 0;
  for_each_facet(face, [&](const std::vector<Loop>& walks, const auto& isolated, auto&&...) {
    std::size_t wanted = 2 * walks.size() + 2 * isolated.size();
    for (const Loop& walk : walks) wanted += walk.size();
    wanted -= 4;  // by Euler's formula: each corner is one of some triangle
    std::vector<Triangle> triangles;
    for (; triangles.size() < wanted; ++t) {
      if (t == list.size()) list.refuse("triangles are missing: they do not cover the face");
      triangles.push_back(read_triangle(complex, *placed, list.at(t)));
      if (triangles.size() > 1 && triangles.back() < triangles[triangles.size() - 2])
        list.at(t).refuse("the triangles of a facet are in the order of their points");
    }
    ++placed;
    const bool is_triangle = walks.size() == 1 && wanted == 1 && std::ranges::equal(triangles[0], walks[0]);
    if (!is_triangle && !cover(triangles, walks, isolated))
      list.refuse("the triangles do not cover the face from edge to edge, once");
  });
  if (t < list.size()) list.at(t).refuse("there are more triangles than cover the face");
}

/// Each facet lies in the cells of its patch.
void require_cells(const std::vector<RationalPoint>& points, const FlatComplex::Face& face, const Cursor& at) {
  if (face.cells.empty()) return;
  std::size_t facet = 0;
  for_each_facet(face, [&](const std::vector<Loop>& walks, auto&&...) {
    const auto& cells = face.cells[facet];
    const Cursor list = at.member("cells").at(facet++);
    for (const Loop& walk : walks) {
      for (const Index p : walk) {
        for (std::size_t i = 0; i < cells.size(); ++i) {
          if (!in_plane(cells[i], points[p]))
            list.at(i).refuse("the facet does not lie in the plane of this cell");
        }
        if (std::none_of(cells.begin(), cells.end(), [&](const auto& cell) { return holds(cell, points[p]); }))
          list.refuse("point " + std::to_string(p) + " of the facet is in none of these cells");
      }
    }
  });
}

class Check {
 public:
  Check(const Cursor& root, const ResultFile& file)
      : root_(root),
        file_(file),
        stored_(file.value),
        cells_(stored_.cells),
        made_(complex_of(root, stored_)),
        c_(*made_) {}

  void run() {
    std::vector<VertexId> points;
    for (Index p = 0; p < stored_.points.size(); ++p)
      points.emplace_back(p);  // all distinct: they keep their numbers
    const CellMap map(c_, {part_of(LeafId(0), stored_, points)});
    require_apart(map);
    const NodeValue value = value_on(map);
    const MarkedCells marks = marks_of(map);
    Result::Data data;
    data.complex = made_;
    data.value = with_leaves(value);
    data.simplified = std::make_shared<const SimplifiedComplex>(
        simplify(c_, selection_of(c_, value), value.features(), SimplifyMode::features, &marks));
    data.parameters = names_of_patches();
    data.name(file_.names);
    const ResultView view = data.view(true);
    FlatComplex flat = flatten(view, Flattening::cells);
    take_what_is_told(flat);
    const std::vector<FlatComplex::Face> faces = flat.faces;
    const JsonFile again{"", JsonDocument(result_json(view, std::move(flat)))};
    root_.require_same(Cursor(again), {"triangles", "volume_bound"});
    const std::vector<PlacedFacet> facets = place_facets();
    for (Index i = 0, first = 0; i < faces.size(); ++i) {
      require_triangles(c_, faces[i], facets.data() + first, at("faces", i));
      require_cells(stored_.points, faces[i], at("faces", i));
      first += Index(std::max<std::size_t>(faces[i].facets.size(), 1));
    }
  }

 private:
  const Cursor& root_;
  const ResultFile& file_;
  const StoredValue& stored_;
  const FlatComplex& cells_;
  const std::shared_ptr<const Complex> made_;
  const Complex& c_;

  /// Cells meet in points of the file only, and none lies on another one.
  void require_apart(const CellMap& map) const {
    std::optional<std::pair<Piece, VertexId>> first;
    const auto see = [&](const Piece& piece, VertexId v) {
      if (!first || piece < first->first) first.emplace(piece, v);
    };
    for (const VertexId v : c_.vertices) {
      if (v.index() < stored_.points.size()) continue;
      for (const Piece& piece : map.pieces(v)) see(piece, v);
    }
    if (first) {
      cell(first->first)
          .refuse("another cell meets this one in " + describe(c_.points.rational(first->second)) +
                  ", where the file has no point");
    }
    if (!map.overlap()) return;
    const auto& [a, b] = *map.overlap();
    cell(b).refuse("this cell lies on " + words(a.dimension == 1 ? "edge" : "vertex", a.number));
  }

  /// The face that each facet of the file has become.
  std::vector<PlacedFacet> place_facets() const {
    std::vector<PlacedFacet> facets(c_.sources.size());
    for (const FaceId f : IdRange<FaceId>(c_.face_count())) {
      const Cover& cover = c_.cover(f)[0];
      facets[cover.source.index()] = {f, cover.same};
    }
    return facets;
  }

  NodeValue value_on(const CellMap& map) const {
    try {
      return leaf_value(c_, LeafId(0), leaf_groups(c_).front(), stored_, map, stored_.components, std::identity());
    } catch (const InputError& error) {
      root_.member("components").fail(error.what());
    }
  }

  /// Each active cell stays one; what is no part of the result unites as it would before it is written.
  MarkedCells marks_of(const CellMap& map) const {
    MarkedCells marks(c_);
    const auto mark = [](auto& list, auto id, std::span<const Piece> pieces, int dimension, const auto& cells) {
      for (const Piece& piece : pieces) {
        if (piece.dimension == dimension && cells[piece.number].component != 0) list[id] = piece.number + 1;
      }
    };
    for (const FaceId f : IdRange<FaceId>(c_.face_count())) {
      map.for_each_piece(c_, f, [&](const Piece& piece) { mark(marks.faces, f, {&piece, 1}, 2, cells_.faces); });
    }
    for (const EdgeId e : IdRange<EdgeId>(c_.edge_count())) mark(marks.edges, e, map.pieces(e), 1, cells_.edges);
    for (const VertexId v : c_.vertices) mark(marks.vertices, v, map.pieces(v), 0, cells_.vertices);
    return marks;
  }

  Cursor at(const char* kind, std::size_t i) const { return root_.member(kind).at(i); }
  Cursor cell(const Piece& piece) const {
    static constexpr const char* kLists[] = {"vertices", "edges", "faces"};
    return at(kLists[piece.dimension], piece.number);
  }

  // --- what is written again

  /// Components came from the leaves that the file names.
  std::shared_ptr<const NodeValue> with_leaves(const NodeValue& value) const {
    const auto name = [&](auto& components) {
      for (std::size_t i = 0; i < components.size(); ++i) components[i].leaves = file_.leaves_of[i];
    };
    if (value.is_group()) {
      Group group = value.group();
      name(group.regions);
      return std::make_shared<const NodeValue>(c_, std::move(group));
    }
    Components components = value.components();
    name(components.attributes);
    return std::make_shared<const NodeValue>(std::move(components));
  }

  /// Those of the file, as names of each leaf.
  std::shared_ptr<const SurfaceParameters> names_of_patches() const {
    const auto names = std::make_shared<LeafParameters>();
    for (const auto& [patch, name] : stored_.patches) names->name_patch(patch, name);
    const PlacedParameters placed{[names] { return names; }};
    return std::make_shared<const SurfaceParameters>(
        c_, std::vector<PlacedParameters>(file_.names.leaves.size(), placed), LeafPlaces());
  }

  /// Cells that are more or fewer than those of the file show when they are written.
  void take_what_is_told(FlatComplex& flat) const {
    const auto take = [](auto& cells, const auto& told, const auto& more) {
      for (std::size_t i = 0; i < std::min(cells.size(), told.size()); ++i) {
        cells[i].origin = told[i].origin;
        more(cells[i], told[i]);
      }
    };
    const auto nothing = [](auto&, const auto&) {};
    take(flat.vertices, cells_.vertices, nothing);
    take(flat.edges, cells_.edges, nothing);
    take(flat.faces, cells_.faces, [](FlatComplex::Face& face, const FlatComplex::Face& told) {
      face.patch = told.patch;
      face.cells = told.cells;
    });
    take(flat.regions, cells_.regions, nothing);
  }
};

JsonFile parsed(const std::string& text, const std::string& file) {
  try {
    return {file, JsonDocument(text)};
  } catch (const JsonError& error) {
    const auto [line, column] = position_in(text, error.at());
    throw LeafFileError(file, line, column, error.what() + std::string("; ") + kWriteAgain);
  }
}

}  // namespace
}  // namespace result

std::unique_ptr<PreparedLeaf> prepare_result(const ResultShape& shape) {
  return prepare_result(read_leaf_file(shape.file, shape.inside, result::kWriteAgain), shape.file);
}

std::unique_ptr<PreparedLeaf> prepare_result(const std::string& text, const std::string& name) {
  const result::JsonFile file = result::parsed(text, name);
  const result::Cursor root(file);
  result::ResultFile read = result::read_file(root);
  result::Check(root, read).run();
  forget_origins(read.value.cells);
  return leaf_of(std::move(read.value));
}

}  // namespace cnrg
