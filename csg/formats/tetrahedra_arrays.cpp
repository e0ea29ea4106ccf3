#include "csg/formats/tetrahedra_arrays.h"

#include "csg/formats/mesh_file.h"
#include "csg/result/file_numbers.h"
#include "csg/result/result_data.h"
#include "csg/result/said_table.h"

namespace cnrg {
namespace {

using Number = std::int32_t;

void add(const CellTags& tags, SaidTableMaker& said, MeshArrays::Simplices& out) {
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

/// All but what is said, which goes to `said`.
void fill(const Result& result, const Mesh& mesh, SaidTableMaker& said, MeshArrays& out) {
  for (const auto& p : mesh.points) out.points.insert(out.points.end(), p.begin(), p.end());
  std::array<MeshArrays::Simplices*, 6> kinds{&out.of[0], &out.of[1], &out.of[2], &out.quads, &out.of[3], nullptr};
  mesh.for_each_kind(
      [&](std::size_t kind, std::size_t dimension, const auto& simplices, const auto& edges) {
        for (std::size_t i = 0; kinds[kind] != nullptr && i < simplices.size(); ++i) {
          mesh.for_each_node(simplices[i], edges,
                             [&](Mesh::Index p) { kinds[kind]->points.push_back(static_cast<Number>(p)); });
          add(mesh.entities[dimension][simplices[i].entity].tags, said, *kinds[kind]);
        }
      },
      kGmshEdges);
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

TetrahedralResult::TetrahedralResult(const Result& result, const TetrahedraOptions& options)
    : result_(result), made_(std::make_shared<const TetrahedralMesh>(tetrahedra(result, options))) {}

const std::string& TetrahedralResult::notice() const { return made_->notice; }
double TetrahedralResult::expected() const { return made_->expected; }

TetrahedraArrays TetrahedralResult::arrays() const {
  TetrahedraArrays out;
  SaidTableMaker said;
  fill(result_, made_->mesh, said, out);
  out.said = said.table(result_.data().view());
  out.regions = made_->regions;
  out.rounding = made_->rounding;
  for (const Mesh::Field& field : made_->mesh.fields) out.fields.emplace_back(field.name, field.values);
  return out;
}

void TetrahedralResult::write(const std::string& path, const std::stop_token& stop) const {
  cnrg::write(path, result_, made_->mesh, stop);
}

SurfaceMeshResult::SurfaceMeshResult(const Result& result, const SurfaceOptions& options)
    : result_(result), made_(std::make_shared<const SurfaceTriangles>(surface_triangles(result, options))) {}

std::size_t SurfaceMeshResult::kept() const { return made_->kept; }

SurfaceArrays SurfaceMeshResult::arrays() const {
  SurfaceArrays out;
  SaidTableMaker said;
  fill(result_, made_->mesh, said, out);
  out.said = said.table(result_.data().view());
  out.faces = made_->groups;
  out.rounding = made_->rounding;
  return out;
}

void SurfaceMeshResult::write(const std::string& path, const std::stop_token& stop) const {
  cnrg::write(path, result_, made_->mesh, stop);
}

}  // namespace cnrg
