// What the bar says of how long work still takes.
#include "csg/app/progress_bar.h"

#include "tests/catch.h"

using cnrg::app::Foretold;
using cnrg::app::left_of_stage;
using cnrg::app::left_text;
using cnrg::app::progress_line;

TEST_CASE("what is left of a stage follows from its steps so far", "[app][bar]") {
  CHECK(left_of_stage(50, 200, 10) == 30.0);
  CHECK(left_of_stage(50, 200, 20) == 60.0);  // no step since
  CHECK_FALSE(left_of_stage(50, 200, 0.9));   // a first second says little
  CHECK_FALSE(left_of_stage(1, 200, 10));
  CHECK_FALSE(left_of_stage(0, 0, 10));
  CHECK_FALSE(left_of_stage(5, 0, 10));
  CHECK_FALSE(left_of_stage(200, 200, 10));
}

TEST_CASE("what is left is said in words, of the stage or of what was foretold", "[app][bar]") {
  const Foretold none, mesh{"the mesh", 100, false}, range{"the mesh", 100, true};
  CHECK(left_text({}, none, 0).empty());
  CHECK(left_text(17.2, none, 0) == "0:18 left of this stage");
  CHECK(left_text(17.2, mesh, 0) == "0:18 left of this stage");
  CHECK(left_text({}, mesh, 60) == "about 0:40 left of the mesh");
  CHECK(left_text({}, range, 30) == "up to 1:10 left of the mesh");
  CHECK(left_text({}, mesh, 99.5).empty());  // and nothing where it takes longer than foretold
  CHECK(left_text({}, mesh, 200).empty());
}

TEST_CASE("a line has what is left where there is room", "[app][bar]") {
  CHECK(progress_line("mesh: proof", 30, 100, 75, 80, "0:18 left of this stage") ==
        "mesh: proof [########....................]  30 %  1:15, 0:18 left of this stage");
  CHECK(progress_line("mesh: TetGen", 0, 0, 75, 80, "about 0:40 left of the mesh") ==
        "mesh: TetGen ...  1:15, about 0:40 left of the mesh");
  CHECK(progress_line("mesh: TetGen", 0, 0, 75, 30, "about 0:40 left of the mesh") == "mesh: TetGen ...  1:15");
  CHECK(progress_line("mesh: proof", 30, 100, 75, 80) ==
        "mesh: proof [#########.....................]  30 %  1:15");
  for (std::size_t columns = 1; columns < 80; ++columns)
    CHECK(progress_line("mesh: proof", 30, 100, 75, columns, "0:18 left of this stage").size() <= columns);
}
