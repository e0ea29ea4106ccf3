// What a sweep says of itself beside its rows comes back as it was.
#include "bench/sweep/description.h"

#include "tests/catch.h"

namespace cnrg::bench {

TEST_CASE("descriptions come back as they were") {
  const std::vector<SystemInfo> systems = {
      {"ours", "cnrg", "any cells of dimension 0 to 3, exact", "0.1.0", 0, false, ""},
      {"mantyla-double", "Mäntylä, double", "closed 2-manifold solids", "1986", 1e-10, true, ""},
      {"openscad", "OpenSCAD", "", "", 1e-6, true, "there is no program openscad"},
      {"mantyla-double-arcs", "", "", "", 1e-10, true, "", {"mantyla-double", "arcs", false}}};
  CHECK(to_json(systems_of_json(to_json(systems))) == to_json(systems));
  const SystemInfo back = systems_of_json(to_json(systems)).at(1);
  CHECK(back.title == "Mäntylä, double");
  CHECK(back.rounding == 1e-10);
  CHECK(back.regularized);
  CHECK(back.varies.of.empty());
  CHECK(systems_of_json(to_json(systems)).at(3).varies.rule == "arcs");
  const MachineInfo machine = {"a processor",
                               2,
                               8000000000,
                               "Debian GNU/Linux 12",
                               "g++ 12.2.0",
                               "0123abcd",
                               "2026-11-21",
                               "bench/run all",
                               {{"x-union", "a mesh of it is empty"}}};
  CHECK(to_json(machine_of_json(to_json(machine))) == to_json(machine));
  CHECK(machine_of_json(to_json(machine)).left_out == machine.left_out);
  const std::vector<FamilyInfo> families{{"face", "two boxes", "boxes", "how far", "size"}};
  CHECK(to_json(families_of_json(to_json(families))) == to_json(families));
  CHECK(families_of_json(to_json(families))[0].distance_means == "how far");
}

TEST_CASE("what is no description is named") {
  CHECK_THROWS_WITH(systems_of_json("{}"), "no JSON list");
  CHECK_THROWS_WITH(systems_of_json("[{\"name\": 1}]"), "member `name` of a system is not a text");
  CHECK_THROWS_WITH(machine_of_json("{}"), "the machine has no member `cpu`");
}

}  // namespace cnrg::bench
