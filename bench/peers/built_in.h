// The systems built in, one function each; see system.h.
#pragma once

#include "bench/peers/system.h"

namespace cnrg::bench {

System our_system();
System our_tree_system();
System mantyla_double_system();
System mantyla_exact_system();
std::vector<System> mantyla_published_systems();
System nef_system();
System corefinement_system();
System occt_system();
System openscad_system();

/// `arrange` of OpenCASCADE (occt_regions.cpp).
Arrangement arranged_by_occt(const std::vector<ParcelledOperand>& operands);

}  // namespace cnrg::bench
