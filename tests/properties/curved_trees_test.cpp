// Curved, flat and unbounded leaves: identities of each node, both classifications, simplified walks.
#include "tests/properties/trials.h"

TEST_CASE("random trees of curved and unbounded leaves satisfy every identity", "[trees]") {
  cnrg::campaign::check_trials("curved trees");
}
