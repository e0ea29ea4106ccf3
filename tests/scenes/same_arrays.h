// Byte for byte: what determinism means.
#pragma once

#include "kernel/complex/complex.h"

namespace cnrg::scenes {

/// True if all arrays of two complexes are equal, exact coordinates of the vertices included.
bool same_arrays(const Complex& a, const Complex& b);

}  // namespace cnrg::scenes
