// Problems of a folder of meshes: pairs by name, solids and surfaces, what becomes of odd polygons.
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "bench/cases/family.h"
#include "tests/catch.h"
#include "tests/families/model_checks.h"

namespace cnrg::bench {
namespace {

namespace fs = std::filesystem;
using Catch::Contains;

/// A folder of its own, removed at the end.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "cnrg-families-XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~Folder() { fs::remove_all(path_); }
  void write(const std::string& name, const std::string& text) const {
    fs::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name) << text;
  }
  std::string path() const { return path_.string(); }
  Problem problem(const std::string& name) const { return make_folder_problem(path(), name); }

 private:
  fs::path path_;
};

const std::string kPoints = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string kTetrahedron = kPoints + "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
const std::string kInsideOut = kPoints + "3 0 1 2\n3 0 3 1\n3 1 3 2\n3 2 3 0\n";
const std::string kOpen = "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n";
/// The points of the lower square are there twice, the upper square has a corner that is lifted.
const std::string kBox =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 2\nv 0 1 1\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
    "v 5 5 5\nf 12 11 10 9\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\nf 1 9 2\n";

}  // namespace

TEST_CASE("files that belong together are one problem", "[families]") {
  const Folder folder;
  for (const char* name : {"x_left.off", "x_right.off", "src-y.off", "cut-y.off", "zA.off", "zB.off",
                           "deep/er/zA.off", "deep/zB.off", "alone_left.OFF", "src-wA.off", "cut-wA.off",
                           "src-wB.off", "cut-wB.off", "a b.off", "a_b.off", "qA.off", "qB.stl"})
    folder.write(name, kTetrahedron);
  folder.write("notes.txt", "no mesh");
  const std::vector<std::string> names = folder_problems(folder.path());
  CHECK(names == std::vector<std::string>{"files-union-a_b.off", "files-union-a_b.off_2",
                                          "files-union-alone_left.OFF", "files-union-deep+er+zA.off",
                                          "files-union-deep+zB.off", "files-union-qA.off", "files-union-qB.stl",
                                          "files-union-src-wA.off-cut-wA.off", "files-union-src-wB.off-cut-wB.off",
                                          "files-union-src-y.off-cut-y.off", "files-union-x_left.off-x_right.off",
                                          "files-union-zA.off-zB.off"});
  const Problem pair = folder.problem("files-union-x_left.off-x_right.off");
  CHECK(pair.name == "files-union-x_left.off-x_right.off");
  CHECK(pair.operands.size() == 2);
  CHECK(pair.operands[0] == pair.operands[1]);
  CHECK(pair.steps == std::vector{Operation::unite});
  CHECK(folder.problem("files-difference-zA.off-zB.off").steps == std::vector{Operation::subtract});
  CHECK_THROWS_WITH(folder_problems(folder.path(), "fold"), Contains("'fold' is no operation"));
  CHECK(folder_problems(folder.path(), "intersection")[1] == "files-intersection-a_b.off_2");
  CHECK_THROWS_WITH(folder.problem("files-union-none"), Contains("files-union-none"));
  CHECK_THROWS_WITH(folder.problem("files-fold-zA.off-zB.off"), Contains("files-fold-zA.off-zB.off"));
  CHECK_THROWS_WITH(folder_problems(folder.path() + "/none"), Contains("is no folder"));
}

TEST_CASE("a file by itself is united with its copy, turned", "[families]") {
  const Folder folder;
  folder.write("t.off", kTetrahedron);
  const Problem problem = folder.problem("files-union-t.off");
  REQUIRE(problem.operands.size() == 2);
  CHECK(problem.solids());
  for (const Model& model : problem.operands) {
    CHECK(fault_of(model) == "");
    CHECK(abs(volume_of(model) - Rational(1, 6)) < Rational(1, 1000000000));
  }
  const Meeting m = meeting(problem.operands[0], problem.operands[1]);
  CHECK(m.general());
  CHECK(m.both > 0);
  CHECK(folder.problem("files-union-t.off").operands == problem.operands);
}

TEST_CASE("closed meshes are solids, others are surfaces", "[families]") {
  const Folder folder;
  folder.write("inside.off", kInsideOut);
  folder.write("open.off", kOpen);
  folder.write("plate.off", "OFF\n4 2 0\n0 0 0\n3 1 2\n4 5 7\n1 4 5\n4 0 1 2 3\n4 1 0 3 2\n");
  const Problem inside = folder.problem("files-union-inside.off");
  CHECK(inside.solids());
  CHECK(fault_of(inside.operands[0]) == "");
  for (const Model& model : folder.problem("files-union-open.off").operands) {
    CHECK(model.faces.size() == 3);
    for (const Model::Face& face : model.faces) CHECK_FALSE(face.solid);
  }
  // Closed, but there is no volume in it; its rounded copy has some.
  for (const Model& model : folder.problem("files-union-plate.off").operands)
    for (const Model::Face& face : model.faces) CHECK_FALSE(face.solid);
}

TEST_CASE("points are merged, polygons stay if they are planar", "[families]") {
  const Folder folder;
  folder.write("box.obj", kBox);
  const Problem problem = folder.problem("files-union-box.obj");
  const Model& box = problem.operands[0];
  CHECK(box.points.size() == 8);
  // Bottom and sides are planar, the top becomes two triangles, the triangle with a corner twice is left out.
  CHECK(box.faces.size() == 7);
  CHECK(fault_of(box) == "");
  CHECK(volume_of(box) == Rational(4, 3));
  CHECK(problem.operands[1].points.size() == 8);
  CHECK(problem.operands[1].solid());
}

TEST_CASE("a mesh that cannot be read is listed and named", "[families]") {
  const Folder folder;
  folder.write("broken.off", "OFF\n3 1 0\n0 0 0\n1 0\n");
  folder.write("empty.off", "OFF\n0 0 0\n");
  CHECK(folder_problems(folder.path()) ==
        std::vector<std::string>{"files-union-broken.off", "files-union-empty.off"});
  CHECK_THROWS_WITH(folder.problem("files-union-broken.off"), Contains("broken.off:"));
  CHECK_THROWS_WITH(folder.problem("files-union-empty.off"), Contains("empty.off: "));
}

}  // namespace cnrg::bench
