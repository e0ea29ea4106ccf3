// What is left of a stage, told from its speed: by a clock that the tests set.
#include "csg/app/pace.h"

#include "csg/app/progress_bar.h"
#include "tests/catch.h"

using cnrg::app::Foretold;
using cnrg::app::left_text;
using cnrg::app::Pace;
using cnrg::app::progress_line;

namespace {

/// So many steps in each second, told ten times a second, from one time to another.
void work(Pace& pace, double& done, std::size_t total, double each_second, double& now, double until) {
  for (; now < until; now += 0.1) {
    pace.see(std::size_t(done), total, now);
    done += each_second / 10;
  }
  pace.see(std::size_t(done), total, now);
}

}  // namespace

TEST_CASE("work of an even speed is told to take what is left of it", "[app][pace]") {
  Pace pace;
  double now = 100, done = 0;
  pace.begin(now);
  work(pace, done, 1000, 50, now, 100.9);
  CHECK_FALSE(pace.left(now));  // a first second says little
  for (const double until : {102.0, 105.0, 115.0}) {
    work(pace, done, 1000, 50, now, until);
    REQUIRE(pace.left(now));
    CHECK(*pace.left(now) == Approx((1000 - done) / 50).epsilon(0.1));
  }
  pace.see(1000, 1000, now);
  CHECK_FALSE(pace.left(now));
}

TEST_CASE("work that gets slower is told to take longer, and little by little", "[app][pace]") {
  Pace pace;
  double now = 0, done = 0;
  pace.begin(now);
  work(pace, done, 10'000, 400, now, 10);
  const double fast = *pace.left(now);
  work(pace, done, 10'000, 100, now, 11);
  const double between = *pace.left(now);
  CHECK(between > fast);
  CHECK(between < (10'000 - done) / 100);
  work(pace, done, 10'000, 100, now, 31);
  CHECK(*pace.left(now) == Approx((10'000 - done) / 100).epsilon(0.1));
}

TEST_CASE("work that stands still is not told to be done soon", "[app][pace]") {
  Pace pace;
  double now = 0, done = 0;
  pace.begin(now);
  work(pace, done, 1000, 100, now, 5);
  const double left = *pace.left(now);
  CHECK(*pace.left(now + 2) > left);
  CHECK(*pace.left(now + 20) > 2 * left);
}

TEST_CASE("nothing is told of work whose steps are not known, nor of a stage that begins", "[app][pace]") {
  Pace pace;
  pace.begin(0);
  CHECK_FALSE(pace.left(10));
  pace.see(5, 0, 10);
  CHECK_FALSE(pace.left(11));
  double now = 11, done = 0;
  work(pace, done, 1000, 100, now, 15);
  CHECK(pace.left(now));
  pace.see(0, 1000, now);  // the same stage once more
  CHECK_FALSE(pace.left(now + 0.5));
  pace.begin(now);
  CHECK_FALSE(pace.left(now + 5));
}

TEST_CASE("what is left is said in words, of the stage or of what was foretold", "[app][pace]") {
  const Foretold none, mesh{"the mesh", 100, false}, range{"the mesh", 100, true};
  CHECK(left_text({}, none, 0).empty());
  CHECK(left_text(17.2, none, 0) == "0:18 left of this stage");
  CHECK(left_text(17.2, mesh, 0) == "0:18 left of this stage");
  CHECK(left_text({}, mesh, 60) == "about 0:40 left of the mesh");
  CHECK(left_text({}, range, 30) == "up to 1:10 left of the mesh");
  CHECK(left_text({}, mesh, 99.5).empty());  // and nothing where it takes longer than foretold
  CHECK(left_text({}, mesh, 200).empty());
}

TEST_CASE("a line has what is left where there is room", "[app][pace]") {
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
