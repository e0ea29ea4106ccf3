// Whole trees against themselves: laws of the algebra, order, motions, folds, what is near joined.
#include "tests/properties/trials.h"

TEST_CASE("random trees obey the laws, in every order, moved, folded, joined and snapped", "[dag]") {
  cnrg::campaign::check_trials("trees");
}
