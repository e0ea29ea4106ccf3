// A program for `bench/run speed --system NAME=PROGRAM` around the Boolean of a library (README.md).
#pragma once

#include <string>
#include <vector>

#include "bench/cases/measurement.h"
#include "bench/cases/triangle_mesh.h"

namespace cnrg::bench {

struct Measured {
  TriangleMesh result;
  Measures measures;
};

/// `operation` is `union`, `difference` (the first operand without all others) or `intersection`. The library's
/// structures of plain triangles are filled before the measurement begins; all that it derives of them is
/// measured. Throws std::runtime_error for what the library cannot do.
using Boolean = Measured (*)(const std::string& operation, const std::vector<TriangleMesh>& operands);

/// The `main` of such a program.
int measured_main(int argc, char** argv, Boolean boolean);

}  // namespace cnrg::bench
