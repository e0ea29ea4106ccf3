// MED, the format of SALOME and code_aster: HDF5 with French names.
//
// The layout is that of version 3.0, which all later libraries read. It is written through HDF5 itself: the
// library of MED, as Debian has it, brings Open MPI into every process, and writes to a path at once instead of a
// file that appears whole.
//
// An element has one number of a family (FAM), and a family lists its groups: so simplices with the same groups
// are one family. Families of elements count down from -1, those of points up from 1; 0 is in no group. Lists of
// numbers go by columns, all x before all y. The second and third corner of a tetrahedron are exchanged: MED's
// look from their first three corners away from the fourth.
#include <array>
#include <map>

#include "csg/formats/formats.h"
#include "csg/formats/group_names.h"
#include "csg/formats/hdf5_file.h"
#include "csg/mesh/second_order.h"
#include "csg/text/escape.h"

namespace cnrg {
namespace {

using Index = Mesh::Index;
using Kind = Hdf5File::Kind;

constexpr std::size_t kGroupSize = 80;
const std::string kMesh = "mesh";
const std::string kStep = "ENS_MAA/mesh/-0000000000000000001-0000000000000000001";
const std::string kAll = "MED_NO_PROFILE_INTERNAL";

/// Readers take a name byte by byte.
std::string ascii_of(std::string_view name) {
  std::string result;
  const std::string text = shown(name);
  for (std::size_t i = 0; i < text.size(); i += first_character(std::string_view(text).substr(i)).length) {
    const Character c = first_character(std::string_view(text).substr(i));
    result += c.code < 0x80 ? text[i] : '_';
  }
  return result;
}

class MedWriter {
 public:
  explicit MedWriter(const Mesh& mesh) : mesh_(mesh), names_(distinct_names(mesh, {ascii_of, kGroupSize})) {}

  std::string run() {
    add_head();
    add_points();
    file_->add_group(kStep + "/MAI");
    file_->set(kStep + "/MAI", "CGT", Kind::i32, 1);
    const bool straight = mesh_.middles.empty();
    std::vector<Mesh::Simplex<2>> edges;  // of the result
    for (const auto& s : mesh_.segments) {
      if (mesh_.entities[1][s.entity].feature) edges.push_back(s);
    }
    add_elements(1, straight ? "SE2" : "SE3", straight ? 102 : 103, edges, kSecondOrderLine);
    add_elements(2, straight ? "TR3" : "TR6", straight ? 203 : 206, mesh_.triangles, kSecondOrderTriangle);
    add_elements(2, "QU4", 204, mesh_.quads, kSecondOrderPoint);
    std::vector<Mesh::Simplex<4>> tetrahedra = mesh_.tetrahedra;
    for (auto& t : tetrahedra) std::swap(t.points[1], t.points[2]);
    add_elements(3, straight ? "TE4" : "T10", straight ? 304 : 310, tetrahedra, kSecondOrderEdges);
    add_families();
    return file_->bytes();
  }

 private:
  const Mesh& mesh_;
  const std::array<std::vector<std::string>, 4> names_;
  const std::unique_ptr<Hdf5File> file_ = new_hdf5_file();
  /// By dimension and groups: the number.
  std::map<std::pair<std::size_t, ShortList<Index, 2>>, std::int32_t> families_;
  std::int32_t of_elements_ = 0, of_points_ = 0;

  std::int32_t family(std::size_t dimension, const ShortList<Index, 2>& groups) {
    if (groups.empty()) return 0;
    const auto [entry, fresh] = families_.try_emplace({dimension, groups}, 0);
    if (fresh) entry->second = dimension == 0 ? ++of_points_ : --of_elements_;
    return entry->second;
  }

  void add_head() {
    file_->add_group("INFOS_GENERALES");
    set_all("INFOS_GENERALES", {{"MAJ", 3}, {"MIN", 0}, {"REL", 0}});
    file_->add_group(kStep);
    const std::string mesh = "ENS_MAA/" + kMesh;
    // Of three dimensions, Cartesian, unstructured.
    set_all(mesh, {{"DIM", 3}, {"ESP", 3}, {"REP", 0}, {"SRT", 1}, {"TYP", 0}});
    file_->set(mesh, "UNT", std::string(16, ' '));
    file_->set(mesh, "UNI", std::string(48, ' '));
    file_->set(mesh, "NOM", "x" + std::string(15, ' ') + "y" + std::string(15, ' ') + "z" + std::string(15, ' '));
    file_->set(mesh, "DES", "node " + cut(shown(mesh_.node), 150) + ", written by cnrg");
    set_all(mesh, {{"NXT", -1}, {"NXI", -1}});
    set_all(kStep, {{"CGT", 1}, {"NDT", -1}, {"NOR", -1}, {"NXT", -1}, {"NXI", -1}, {"PVT", -1}, {"PVI", -1}});
    const double no_time = -1;
    file_->set(kStep, "PDT", {Kind::f64}, &no_time);
  }

  void set_all(const std::string& path, std::initializer_list<std::pair<const char*, std::int64_t>> numbers) {
    for (const auto& [attribute, number] : numbers) file_->set(path, attribute, Kind::i32, number);
  }
  void set_counts(const std::string& path, std::size_t count) {
    set_all(path, {{"CGT", 1}, {"NBR", static_cast<std::int64_t>(count)}});
  }
  void set_support(const std::string& path) {
    set_all(path, {{"CGT", 1}, {"CGS", 1}});
    file_->set(path, "PFL", kAll);
  }

  void add_points() {
    const std::string path = kStep + "/NOE";
    std::vector<double> columns;
    for (std::size_t k = 0; k < 3; ++k) {
      for (const auto& p : mesh_.points) columns.push_back(p[k]);
    }
    file_->add(path + "/COO", columns);
    set_support(path);
    set_counts(path + "/COO", mesh_.points.size());
    std::vector<std::int32_t> families(mesh_.points.size(), 0);
    for (const auto& v : mesh_.vertices) families[v.points[0]] = family(0, mesh_.entities[0][v.entity].groups);
    file_->add(path + "/FAM", families);
    set_counts(path + "/FAM", families.size());
  }

  template <class Simplices, class Ends>
  void add_elements(std::size_t dimension, const std::string& type, int number, const Simplices& simplices,
                    const Ends& ends) {
    if (simplices.empty()) return;
    const std::size_t n = simplices.size();
    const std::size_t size = mesh_.nodes(simplices[0], ends).size();
    std::vector<std::int32_t> nodes(n * size), families;
    for (std::size_t i = 0; i < n; ++i) {
      const std::vector<Index> at = mesh_.nodes(simplices[i], ends);
      for (std::size_t k = 0; k < size; ++k) nodes[k * n + i] = static_cast<std::int32_t>(at[k]) + 1;
      families.push_back(family(dimension, mesh_.entities[dimension][simplices[i].entity].groups));
    }
    const std::string path = kStep + "/MAI/" + type;
    file_->add(path + "/NOD", nodes);
    set_support(path);
    file_->set(path, "GEO", Kind::i32, number);
    set_counts(path + "/NOD", n);
    file_->add(path + "/FAM", families);
    set_counts(path + "/FAM", n);
  }

  void add_families() {
    const std::string path = "FAS/" + kMesh;
    file_->add_group(path + "/FAMILLE_ZERO");
    file_->set(path + "/FAMILLE_ZERO", "NUM", Kind::i32, 0);
    for (const auto& [key, number] : families_) {
      const auto& [dimension, groups] = key;
      const std::string family = path + (dimension == 0 ? "/NOEUD/" : "/ELEME/") + "FAM_" + std::to_string(number);
      std::vector<std::string> names;
      for (const Index group : groups) names.push_back(names_[dimension][group - 1]);
      file_->add(family + "/GRO/NOM", names, {Kind::i8, kGroupSize});
      file_->set(family + "/GRO", "NBR", Kind::i32, static_cast<std::int64_t>(groups.size()));
      file_->set(family, "NUM", Kind::i32, number);
    }
  }
};

}  // namespace

std::string med_bytes(const Mesh& mesh) {
  return hdf5_bytes("MED", [&] { return MedWriter(mesh).run(); });
}

}  // namespace cnrg
