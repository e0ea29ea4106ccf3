// How the program ends (csg/FORMATS.md#exit-statuses).
#pragma once

namespace cnrg::app {

inline constexpr int kDone = 0;
inline constexpr int kBug = 1;        ///< a broken invariant
inline constexpr int kBadInput = 2;   ///< tree, points or command line
inline constexpr int kNoAccess = 3;   ///< a file could not be read or written, or memory ran out
inline constexpr int kDifferent = 4;  ///< of `cnrg compare`

}  // namespace cnrg::app
