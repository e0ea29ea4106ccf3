// What both of VTK's formats of surfaces hold: numbers of a declared type, and cells as lists of points.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "csg/imports/mesh_labels.h"
#include "csg/leaves/mesh_data.h"

namespace cnrg {

enum class VtkType { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };
std::size_t size_of(VtkType type);
bool is_whole(VtkType type);

/// Numbers of one array. Whole ones lose no digit, which doubles would from 2^53 on.
struct VtkNumbers {
  bool whole = true;
  std::vector<std::int64_t> integers;  ///< those of 64 bits without sign as such with one
  std::vector<double> reals;
  std::size_t size() const { return whole ? integers.size() : reals.size(); }
  /// Number i alone.
  VtkNumbers one(std::size_t i) const {
    return whole ? VtkNumbers{true, {integers[i]}, {}} : VtkNumbers{false, {}, {reals[i]}};
  }
};
/// The number at a byte, of a whole or of another type; of 64 bits without sign as one with a sign.
std::int64_t whole_number_at(std::string_view bytes, std::size_t at, VtkType type, bool big_endian);
double real_number_at(std::string_view bytes, std::size_t at, VtkType type, bool big_endian);
/// The numbers in as many bytes as they take.
VtkNumbers numbers_of(std::string_view bytes, VtkType type, bool big_endian);

enum class VtkKind { vertices, lines, polygons, strips };

/// Cells of one kind: cell i is connectivity[offsets[i] .. offsets[i + 1]].
struct VtkCells {
  std::vector<std::int64_t> connectivity, offsets{0};
  std::size_t size() const { return offsets.size() - 1; }
};

/// What cell `number` of a grid is by its type; the points of a pixel are put in the order around it. `fail` is
/// told of one with volume or curved sides, and of a wrong number of points.
VtkKind kind_of_cell(std::int64_t type, std::size_t number, std::vector<std::int64_t>& points,
                     const std::function<void(const std::string&)>& fail);

/// Surfaces, lines and points of a VTK file on their way into a mesh.
class VtkCollector {
 public:
  using Fail = std::function<void(const std::string&)>;  ///< throws

  /// The labels of the cells that are added next, one each; none if `labels` is no such list.
  void take_labels(std::optional<VtkNumbers> labels) {
    labels_ = std::move(labels);
    cell_ = 0;
  }
  /// Cells on points of the mesh, `first` of which come before those that the cells count from 0; it has all
  /// points. `fail` is told of cells that are none.
  void add(VtkKind kind, const VtkCells& cells, std::size_t first, const Fail& fail);
  /// One of them.
  void add(VtkKind kind, std::span<const std::int64_t> points, std::size_t first, std::size_t number,
           const Fail& fail);

  MeshData mesh;
  /// The mesh with its groups.
  MeshData finish();

 private:
  MeshLabels groups_;
  std::optional<VtkNumbers> labels_;
  std::size_t cell_ = 0;  ///< that comes next, among those with labels

  std::uint32_t group();
};

}  // namespace cnrg
