// A result in .json as a leaf. Reading it has three parts: a cursor on the JSON document (json_cursor.h); the
// tables of the file with every number checked (result_reader.cpp), and held against the cells that they make
// (result_check.cpp); and the leaf made from them, here. All cells of the file go to the soup, active or not; the
// cell table says which are active.
//
// Edges are wires where the faces alone would not give the same edge again:
//   * A face is handed to the soup without its slits (edges that it walks in both directions): loops of the soup
//     enclose by parity.
//   * A bent chain is one edge because it is one curve (kernel/selection/curve.h), and a wire is one.
//   * Two edges that meet in a corner of curved faces might become one curve: a wire along one of them parts them.
#include <algorithm>
#include <utility>

#include "csg/imports/leaf_file.h"
#include "csg/imports/result_content.h"
#include "csg/leaves/prepare_shapes.h"

namespace cnrg {
namespace result {

LeafId add_to(Soup& soup, const Content& content, const Transform& transform, Fill fill) {
  const LeafId leaf = soup.add_leaf(fill);
  const bool mirrored = sgn(transform.determinant()) < 0;
  std::vector<PointId> ids;
  ids.reserve(content.table.points.size());
  for (const RationalPoint& p : content.table.points) {
    ids.push_back(soup.add_point(transform.identity() ? p : transform.apply(p)));
  }
  const auto label = [&](Index region) { return fill == Fill::sides ? content.regions[region].label : 0; };
  std::vector<std::vector<PointId>> loops;
  for (const Facet& facet : content.facets) {
    loops.clear();
    for (const Loop& loop : facet.outline()) {
      auto& ring = loops.emplace_back();
      for (const Index p : loop) ring.push_back(ids[p]);
      if (mirrored) std::reverse(ring.begin(), ring.end());
    }
    const Face& face = content.faces[facet.face];
    soup.add_face(leaf, loops, facet.face, face.patch, label(face.regions[0]), label(face.regions[1]));
  }
  for (Index number = 0; number < content.edges.size(); ++number) {
    const Edge& edge = content.edges[number];
    if (!edge.wire) continue;
    const Loop& p = edge.points;
    for (std::size_t i = 1; i < p.size(); ++i) soup.add_wire(leaf, ids[p[i - 1]], ids[p[i]], number);
  }
  for (const Index p : content.isolated) soup.add_isolated(leaf, ids[p]);
  return leaf;
}

}  // namespace result

namespace {

using result::Content;

class ResultLeaf : public PreparedLeaf {
 public:
  explicit ResultLeaf(Content content) : content_(std::move(content)) {
    if (content_.patches.empty()) return;
    set_parameters([made = parameters_of(content_)] { return made; });
  }

  LeafId add_to(Soup& soup, const Transform& transform) const override {
    return result::add_to(soup, content_, transform, Fill::sides);
  }
  std::vector<Attributes> regions() const override { return content_.components; }
  const CellTable* cells() const override { return &content_.table; }

 private:
  /// Faces and wires as `add_to` adds them; curves have no parameters in files.
  static std::shared_ptr<const LeafParameters> parameters_of(const Content& content) {
    auto parameters = std::make_shared<LeafParameters>();
    for (const auto& [patch, name] : content.patches) parameters->name_patch(patch, name);
    for (const result::Facet& facet : content.facets) {
      std::vector<std::vector<PatchCorner>> cells;
      for (const result::Index cell : facet.cells) cells.push_back(content.cells[cell]);
      parameters->add_facet(cells);
    }
    for (const result::Edge& edge : content.edges) {
      if (!edge.wire) continue;
      const auto& points = content.table.points;
      for (std::size_t i = 1; i < edge.points.size(); ++i) {
        parameters->add_wire({{points[edge.points[i - 1]], points[edge.points[i]]}, {0, 0}});
      }
    }
    return parameters;
  }

  Content content_;
};

result::JsonFile parsed(const std::string& text, const std::string& file) {
  try {
    return {file, JsonDocument(text)};
  } catch (const JsonError& error) {
    const auto [line, column] = position_in(text, error.at());
    throw LeafFileError(file, line, column, error.what() + std::string("; ") + result::kWriteAgain);
  }
}

}  // namespace

std::unique_ptr<PreparedLeaf> prepare_result(const ResultShape& shape) {
  return prepare_result(read_leaf_file(shape.file, shape.inside, result::kWriteAgain), shape.file);
}

std::unique_ptr<PreparedLeaf> prepare_result(const std::string& text, const std::string& name,
                                             std::shared_ptr<const CellMakers> makers) {
  const result::JsonFile file = parsed(text, name);
  const result::Cursor root(file);
  Content content = result::read_content(root);
  result::check_content(root, content);
  content.table.makers = std::move(makers);
  return std::make_unique<ResultLeaf>(std::move(content));
}

}  // namespace cnrg
