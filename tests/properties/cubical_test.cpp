// Every operator and dominance, attributes and Betti numbers by brute force on grids, as they are and moved.
#include "tests/properties/trials.h"

TEST_CASE("random groups and trees on a grid are as by brute force", "[cubical]") {
  cnrg::campaign::check_trials("brute force");
}
