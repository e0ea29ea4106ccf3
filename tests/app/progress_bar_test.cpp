// The line of the progress bar: how much of a stage is done, and what is left at most.
#include "csg/app/progress_bar.h"

#include "tests/catch.h"

using cnrg::app::left_text;
using cnrg::app::progress_line;

TEST_CASE("what is left is told until what was foretold is over, where there is room", "[app][progress]") {
  CHECK(left_text(50, 200, 6) == "0:18 left of this stage");
  for (const auto& [done, total, seconds] :
       {std::tuple(1, 200, 6.0), {50, 200, 0.5}, {200, 200, 6.0}, {0, 0, 6.0}})
    CHECK(left_text(std::size_t(done), std::size_t(total), seconds).empty());
  CHECK(left_text("", 60).empty());
  CHECK(left_text("the mesh", 70) == "up to 1:10 left of the mesh");
  CHECK(left_text("the mesh", 0.5).empty());
  CHECK(left_text("the mesh", -100).empty());
  CHECK(progress_line("mesh: TetGen", 0, 0, 75, 80, "up to 0:40 left of the mesh") ==
        "mesh: TetGen ...  1:15, up to 0:40 left of the mesh");
  CHECK(progress_line("mesh: TetGen", 0, 0, 75, 30, "up to 0:40 left of the mesh") == "mesh: TetGen ...  1:15");
  CHECK(progress_line("mesh: proof", 30, 100, 75, 80) ==
        "mesh: proof [#########.....................]  30 %  1:15");
  for (std::size_t columns = 1; columns < 80; ++columns)
    CHECK(progress_line("mesh: proof", 30, 100, 75, columns, "up to 0:40 left of the mesh").size() <= columns);
}
