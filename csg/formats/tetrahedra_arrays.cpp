#include "csg/formats/tetrahedra_arrays.h"

#include "csg/formats/gmsh_order.h"
#include "csg/formats/mesh_file.h"
#include "csg/result/file_numbers.h"
#include "csg/result/result_data.h"
#include "csg/result/said_table.h"

namespace cnrg {
namespace {

using Number = std::int32_t;

template <class List, class Edges>
void add(const Mesh& mesh, const List& simplices, std::size_t dimension, const Edges& edges, SaidTableMaker& said,
         MeshArrays::Simplices& out) {
  for (const auto& simplex : simplices) {
    for (const Mesh::Index p : mesh.nodes(simplex, edges)) out.points.push_back(static_cast<Number>(p));
    const CellTags& tags = mesh.entities[dimension][simplex.entity].tags;
    out.cell.push_back(tags.cell);
    out.component.push_back(tags.component);
    out.front.push_back(tags.front);
    out.back.push_back(tags.back);
    out.region.push_back(tags.region);
    out.material.push_back(tags.material);
    out.said.push_back(said.place(tags));
    out.leaf.push_back(tags.leaf);
    out.face.push_back(tags.face);
  }
}

/// All but what is said, which goes to `said`.
void fill(const Result& result, const Mesh& mesh, SaidTableMaker& said, MeshArrays& out) {
  for (const auto& p : mesh.points) out.points.insert(out.points.end(), p.begin(), p.end());
  add(mesh, mesh.vertices, 0, kEdges0, said, out.of[0]);
  add(mesh, mesh.segments, 1, kEdges1, said, out.of[1]);
  add(mesh, mesh.triangles, 2, kEdges2, said, out.of[2]);
  add(mesh, mesh.tetrahedra, 3, kEdges3, said, out.of[3]);
  for (std::size_t d = 0; d < 4; ++d) {
    for (const std::string& name : mesh.groups[d]) out.groups[d].push_back({name, {}});
    for (const Mesh::Entity& entity : mesh.entities[d]) {
      for (const Mesh::Index group : entity.groups) out.groups[d][group - 1].cells.push_back(entity.tags.cell);
    }
  }
  out.leaves = leaf_names(result.data().leaves);
  for (const ResultNames::Material& material : result.data().materials) out.materials.push_back(material.name);
  out.curved = !mesh.middles.empty();
}

}  // namespace

struct TetrahedralResult::Data {
  Result result;
  TetrahedralMesh made;
};

TetrahedralResult::TetrahedralResult(const Result& result, const TetrahedraOptions& options)
    : data_(std::make_shared<const Data>(Data{result, tetrahedra(result, options)})) {}

const std::string& TetrahedralResult::notice() const { return data_->made.notice; }
double TetrahedralResult::expected() const { return data_->made.expected; }

TetrahedraArrays TetrahedralResult::arrays() const {
  TetrahedraArrays out;
  SaidTableMaker said;
  fill(data_->result, data_->made.mesh, said, out);
  out.said = said.table(data_->result.data().view());
  out.regions = data_->made.regions;
  out.rounding = data_->made.rounding;
  for (const Mesh::Field& field : data_->made.mesh.fields) out.fields.emplace_back(field.name, field.values);
  return out;
}

void TetrahedralResult::write(const std::string& path, const std::stop_token& stop) const {
  cnrg::write(path, data_->result, data_->made.mesh, stop);
}

struct SurfaceMeshResult::Data {
  Result result;
  SurfaceTriangles made;
};

SurfaceMeshResult::SurfaceMeshResult(const Result& result, const SurfaceOptions& options)
    : data_(std::make_shared<const Data>(Data{result, surface_triangles(result, options)})) {}

std::size_t SurfaceMeshResult::kept() const { return data_->made.kept; }

SurfaceArrays SurfaceMeshResult::arrays() const {
  const SurfaceTriangles& made = data_->made;
  SurfaceArrays out;
  SaidTableMaker said;
  fill(data_->result, made.mesh, said, out);
  add(made.mesh, made.mesh.quads, 2, kEdges0, said, out.quads);
  out.said = said.table(data_->result.data().view());
  out.faces = made.groups;
  out.rounding = made.rounding;
  return out;
}

void SurfaceMeshResult::write(const std::string& path, const std::stop_token& stop) const {
  cnrg::write(path, data_->result, data_->made.mesh, stop);
}

}  // namespace cnrg
