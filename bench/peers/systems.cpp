#include "bench/peers/built_in.h"

namespace cnrg::bench {

std::vector<System> systems() {
  return {our_system(),          mantyla_double_system(), mantyla_exact_system(), nef_system(),
          corefinement_system(), occt_system(),           openscad_system()};
}

}  // namespace cnrg::bench
