// Exact zero tests on points given as doubles, for input that is not yet in a PointTable.
#pragma once

namespace cnrg {

/// Four points (three finite doubles each) lie on one plane, exactly. Staged: a forward error bound on the 3x3
/// determinant first, integers then.
bool coplanar(const double* a, const double* b, const double* c, const double* d);

/// Three points lie on one line (or coincide), exactly. Staged likewise.
bool collinear(const double* a, const double* b, const double* c);

/// False only if the determinant of b - a, c - a, d - a is surely not zero when every coordinate is off by at
/// most one rounding (relative 2^-53): a filter for points whose exact values are not doubles.
bool maybe_coplanar(const double* a, const double* b, const double* c, const double* d);
bool maybe_collinear(const double* a, const double* b, const double* c);

}  // namespace cnrg
