// All that a result file says, held against the cells that it makes.
//
// A file lists cells, and then says of them what follows from where they are: which region is on which side, what
// bounds it, its volume, triangles, which cells are wires. A reader that trusts these takes an edge that was moved
// through a face for one edge, and a region without faces for nothing. So the cells of the file are refined by
// themselves and flattened as for a file; each cell that is listed stays a cell. Then the file is what would be
// written: the first member that differs is an error. Nothing is told twice how files are written.
//
// What a file says and its cells cannot contradict is taken as it is: which component a cell is of (as long as a
// group stays a group), features, names, parameters u and v, and where cells came from. Which of two diagonals
// halves a rectangle is left to the file: triangles are checked by themselves (result_triangles.cpp).
#include <algorithm>

#include "csg/imports/leaf_file.h"
#include "csg/leaves/prepare_shapes.h"
#include "csg/result/flat.h"
#include "csg/transfer/leaf_value.h"
#include "csg/transfer/marked_cells.h"
#include "csg/transfer/result_triangles.h"
#include "kernel/base/leaf_words.h"
#include "kernel/base/limits.h"
#include "kernel/base/union_find.h"
#include "kernel/complex/builder.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/selection/measure.h"

namespace cnrg {
namespace result {
namespace {

using Piece = CellMap::Piece;
using Loop = FlatComplex::Loop;

std::string words(const char* kind, Index number) { return std::string(kind) + " " + std::to_string(number); }
template <class List>
std::string words(const List& list) {
  std::string text = "[";
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (i == 12) return text + ", ...]";
    text += (i == 0 ? "" : ", ");
    if constexpr (requires { list[i].size(); }) text += words(list[i]);
    else text += std::to_string(list[i]);
  }
  return text + "]";
}

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

class Check {
 public:
  Check(const Cursor& root, const StoredValue& stored)
      : root_(root), stored_(stored), cells_(stored.cells), made_(complex_of(root, stored)), c_(*made_) {
    for (Index i = 0; i < cells_.faces.size(); ++i)
      for_each_facet(cells_.faces[i], [&](auto&&...) { face_of_facet_.push_back(i); });
  }

  void run() {
    if (stored_.group) require_group();
    std::vector<VertexId> points;
    for (Index p = 0; p < stored_.points.size(); ++p)
      points.emplace_back(p);  // all distinct: they keep their numbers
    const CellMap map(c_, {part_of(LeafId(0), stored_, points)});
    require_apart(map);
    const std::vector<PlacedFacet> facets = place_facets();
    require_one_place(facets);
    const NodeValue value =
        leaf_value(c_, LeafId(0), leaf_groups(c_).front(), stored_, map, stored_.components, std::identity());
    const MarkedCells marks = marks_of(map);
    const SimplifiedComplex simplified =
        simplify(c_, selection_of(c_, value), value.features(), SimplifyMode::features, &marks);
    ResultView view;
    view.complex = &c_;
    view.value = &value;
    view.simplified = &simplified;
    flat_ = flatten(view, Flattening::cells);
    compare(facets);
  }

 private:
  const Cursor& root_;
  const StoredValue& stored_;
  const FlatComplex& cells_;
  const std::shared_ptr<const Complex> made_;
  const Complex& c_;
  std::vector<Index> face_of_facet_;
  FlatComplex flat_;

  // --- before the cells are flattened

  /// A component is one region, in one piece but for faces that are inside of it; features are of entities.
  void require_group() const {
    UnionFind sets(cells_.regions.size());
    for (const FlatComplex::Face& face : cells_.faces) {
      const auto [front, back] = face.regions;
      const Index c = face.component;
      if (c != 0 && cells_.regions[front].component == c && cells_.regions[back].component == c)
        sets.unite(front, back);
    }
    std::vector<Index> first(stored_.components.size() + 1, kNone);
    for (Index i = 0; i < cells_.regions.size(); ++i) {
      const Index c = cells_.regions[i].component;
      if (c == 0) continue;
      if (first[c] == kNone) first[c] = i;
      if (sets.find(i) == sets.find(first[c])) continue;
      at("regions", i)
          .member("component")
          .refuse("in a group a component is one region, and " + words("region", first[c]) + " is of this one");
    }
    for (Index c = 1; c < first.size(); ++c) {
      if (first[c] == kNone)
        at("components", c - 1).refuse("in a group a component is a region, and none is of this one");
    }
    const auto require_entities = [&](const char* kind, const auto& cells) {
      for (Index i = 0; i < cells.size(); ++i) {
        if (cells[i].feature && cells[i].component != stored_.components.size() + 1)
          at(kind, i).member("feature").refuse("only entities of a group are features");
      }
    };
    require_entities("vertices", cells_.vertices);
    require_entities("edges", cells_.edges);
  }

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

  /// Every facet is one face.
  std::vector<PlacedFacet> place_facets() const {
    std::vector<PlacedFacet> facets(face_of_facet_.size());
    for (const FaceId f : IdRange<FaceId>(c_.face_count())) {
      const auto covers = c_.cover(f);
      const Index k = covers[0].source.value(), face = face_of_facet_[k];
      if (covers.size() > 1) {
        const Index other = face_of_facet_[covers[1].source.index()];
        at("faces", face)
            .refuse(other == face ? "facets of this face lie on each other"
                                  : "this face and " + words("face", other) + " lie on each other");
      }
      if (facets[k].cell.valid()) at("faces", face).refuse("this face falls into several pieces");
      facets[k] = {f, covers[0].same};
    }
    for (Index k = 0; k < facets.size(); ++k) {
      if (!facets[k].cell.valid()) at("faces", face_of_facet_[k]).refuse("a face without area");
    }
    return facets;
  }

  /// A region of the file is one of the complex.
  void require_one_place(const std::vector<PlacedFacet>& facets) const {
    std::vector<RegionId> place(cells_.regions.size());
    for (Index k = 0; k < facets.size(); ++k) {
      const Index face = face_of_facet_[k];
      for (unsigned side = 0; side < 2; ++side) {
        const RegionId r = c_.region(HalfFace(facets[k].cell, facets[k].same ? side : 1 - side));
        RegionId& known = place[cells_.faces[face].regions[side]];
        if (known.valid() && known != r)
          at("faces", face).member("regions").at(side).refuse("this side does not look into that region");
        known = r;
      }
    }
    if (facets.empty() && !place.empty()) place[0] = RegionId(0);  // all of space
    for (Index i = 0; i < place.size(); ++i) {
      if (!place[i].valid()) at("regions", i).refuse("no side of a face looks into this region");
    }
  }

  /// Each active cell stays one; what is no part of the result unites as it would before it is written.
  MarkedCells marks_of(const CellMap& map) const {
    MarkedCells marks(c_);
    const auto mark = [&](auto& list, auto id, const Piece& piece, Index component) {
      if (component != 0) list[id] = piece.number + 1;
    };
    for (const FaceId f : IdRange<FaceId>(c_.face_count())) {
      map.for_each_piece(
          c_, f, [&](const Piece& piece) { mark(marks.faces, f, piece, cells_.faces[piece.number].component); });
    }
    for (const EdgeId e : IdRange<EdgeId>(c_.edge_count())) {
      for (const Piece& piece : map.pieces(e)) {
        if (piece.dimension == 1) mark(marks.edges, e, piece, cells_.edges[piece.number].component);
      }
    }
    for (const VertexId v : c_.vertices) {
      for (const Piece& piece : map.pieces(v)) {
        if (piece.dimension == 0) mark(marks.vertices, v, piece, cells_.vertices[piece.number].component);
      }
    }
    return marks;
  }

  Cursor at(const char* kind, std::size_t i) const { return root_.member(kind).at(i); }
  Cursor cell(const Piece& piece) const {
    static constexpr const char* kLists[] = {"vertices", "edges", "faces"};
    return at(kLists[piece.dimension], piece.number);
  }

  // --- what was flattened, and the file

  template <class Stated, class Made>
  static void same(const Cursor& at, const Stated& stated, const Made& made) {
    if (!std::equal(stated.begin(), stated.end(), made.begin(), made.end()))
      at.refuse("the cells of the file make " + words(made) + " here");
  }
  static void same(const Cursor& at, Index stated, Index made, const char* kind) {
    if (stated != made) at.refuse(words(kind, made) + " is meant by the cells of the file");
  }
  static void same(const Cursor& at, bool made, const char* yes, const char* no) {
    if (at.boolean() != made) at.refuse(made ? yes : no);
  }
  static void same_loops(const Cursor& at, const std::vector<Loop>& stated, const std::vector<Loop>& made) {
    if (stated != made) at.member("loops").refuse("the loops that the cells of the file make are " + words(made));
  }
  template <class Points>
  static void same_isolated(const Cursor& at, const Points& stated, const Points& made) {
    if (at.has("isolated") || !made.empty()) same(at.member("isolated"), stated, made);
  }

  /// Calls `see` for each cell of a list, which must have as many.
  template <class Cells, class See>
  void each(const char* kind, const Cells& cells, const See& see) const {
    const Cursor list = root_.member(kind);
    for (Index i = 0; i < list.size(); ++i) {
      if (i == cells.size()) list.at(i).refuse("this cell is no part of the result and bounds none");
      see(list.at(i), cells[i], i);
    }
    if (list.size() < cells.size()) list.refuse("a cell is missing behind the last one");
  }

  void compare(const std::vector<PlacedFacet>& facets) const {
    for (Index p = 0; p < stored_.points.size(); ++p) {
      if (p < flat_.points.size() && flat_.points[p].value() == p) continue;
      at("points", p)
          .refuse("this point is inside of a straight edge or of a face, and no vertex; it is left out");
    }
    each("vertices", flat_.vertices, [&](const Cursor& at, const FlatComplex::Vertex& made, Index i) {
      same(at.member("point"), cells_.vertices[i].point, made.point, "point");
      compare_state(at, cells_.vertices[i], made);
      compare_region(at, made.free, made.region);
    });
    each("edges", flat_.edges, [&](const Cursor& at, const FlatComplex::Edge& made, Index i) {
      same(at.member("points"), cells_.edges[i].points, made.points);
      same(at.member("closed"), made.closed, "this edge has no vertex and is closed", "this edge has ends");
      compare_state(at, cells_.edges[i], made);
      same(at.member("wire"), made.wire, "no face has this edge on its boundary",
           "a face has this edge on its boundary");
      compare_region(at, made.wire, made.region);
    });
    each("faces", flat_.faces, [&](const Cursor& at, const FlatComplex::Face& made, Index i) {
      const FlatComplex::Face& face = cells_.faces[i];
      compare_face(at, face, made);
      compare_state(at, face, made);
      const auto first = std::lower_bound(face_of_facet_.begin(), face_of_facet_.end(), i);
      require_triangles(c_, stored_.points, face, facets.data() + (first - face_of_facet_.begin()), at);
    });
    each("regions", flat_.regions,
         [&](const Cursor& at, const FlatComplex::Region& made, Index i) { compare_region(at, made, i); });
  }

  template <class Cell>
  static void compare_state(const Cursor& at, const Cell& stated, const Cell& made) {
    same(at.member("component"), stated.component, made.component, "component");
    same(at.member("entity"), made.entity, "the regions around this cell are not all of its component",
         stated.component == 0 ? "a cell that is no part of the result is no entity"
                               : "this cell is in the interior of a region of its component");
    if constexpr (requires { made.feature; }) {
      if (made.feature != stated.feature)
        at.member("feature").refuse("a cell that is no part of the result is no feature");
    }
  }

  /// The member `region` of a cell that no face bounds or holds; other cells have none.
  void compare_region(const Cursor& at, bool wanted, Index made) const {
    if (wanted && made != kNone) {
      same(at.member("region"), at.member("region").number(cells_.regions.size(), "region"), made, "region");
    } else if (at.has("region")) {
      at.member("region").refuse("faces are around this cell, and say which regions are");
    }
  }

  static void compare_face(const Cursor& at, const FlatComplex::Face& stated, const FlatComplex::Face& made) {
    same_loops(at, stated.loops, made.loops);
    same_isolated(at, stated.isolated, made.isolated);
    same(at.member("regions"), stated.regions, made.regions);
    const bool flat = stated.facets.empty();
    if (flat != made.facets.empty())
      at.refuse(flat ? "this face is not flat, and has facets" : "this face is flat, and has no facets");
    if (flat) return;
    const Cursor facets = at.member("facets");
    for (std::size_t k = 0; k < facets.size(); ++k) {
      if (k == made.facets.size()) facets.at(k).refuse("this facet is none");
      same_loops(facets.at(k), stated.facets[k].loops, made.facets[k].loops);
      same_isolated(facets.at(k), stated.facets[k].isolated, made.facets[k].isolated);
    }
    if (facets.size() < made.facets.size()) facets.refuse("a facet is missing behind the last one");
  }

  void compare_region(const Cursor& at, const FlatComplex::Region& made, Index i) const {
    same(at.member("component"), cells_.regions[i].component, made.component, "component");
    same(at.member("bounded"), made.bounded, "this region has bounds", "this region reaches infinity");
    const Cursor shells = at.member("shells").array();
    for (std::size_t s = 0; s < shells.size() || s < made.shells.size(); ++s) {
      if (s == shells.size()) shells.refuse("a shell is missing, of " + words("face", made.shells[s][0] / 2));
      if (s == made.shells.size()) shells.at(s).refuse("the faces bound this region in fewer shells");
      compare_shell(shells.at(s).array(), made.shells[s]);
    }
    const Cursor volume = at.member("volume");
    if (volume.is_null() == made.bounded)
      volume.refuse(made.bounded ? "a bounded region has a volume"
                                 : "the volume of a region without bounds is null");
    if (!made.bounded) return;
    const Rational inside = *cnrg::volume(c_, made.cells);
    const std::string text = to_string(inside);
    if (volume.rational() != inside) {
      volume.refuse("the volume inside of its shells is " + (text.size() > 40 ? to_decimal(inside) : text));
    }
  }

  void compare_shell(const Cursor& shell, const std::vector<Index>& made) const {
    for (std::size_t k = 0; k < shell.size() || k < made.size(); ++k) {
      const auto wanted = [&] {
        return words("face", made[k] / 2) + (made[k] % 2 == 0 ? ", its front" : ", its back");
      };
      if (k == shell.size()) shell.refuse("a side is missing: " + wanted());
      const Cursor side = shell.at(k).only({"face", "side"});
      if (k == made.size()) side.refuse("this side is not of this shell");
      const Index face = side.member("face").number(cells_.faces.size(), "face");
      const std::string which = side.member("side").text();
      if (which != "front" && which != "back") side.member("side").refuse("`front` or `back` is needed here");
      if (2 * face + (which == "back") != made[k]) side.refuse("here in this shell is " + wanted());
    }
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
  StoredValue stored = result::read_value(root);
  result::Check(root, stored).run();
  return leaf_of(std::move(stored));
}

}  // namespace cnrg
