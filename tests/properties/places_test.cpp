// Points by rays and logic, volumes by inclusion and exclusion.
#include "tests/properties/trials.h"

TEST_CASE("points and volumes of random trees are those of the definitions", "[places]") {
  cnrg::campaign::check_trials("places and volumes");
}
