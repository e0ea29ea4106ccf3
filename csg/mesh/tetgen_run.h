// TetGen (si2015) in a process of its own (csg/text/child.h): its library throws numbers, prints, and ends the
// process where an assertion of its own fails; none of that reaches the caller.
#pragma once

#include <functional>
#include <stop_token>
#include <string>

#include "csg/mesh/plc.h"
#include "kernel/base/error.h"

namespace cnrg {

class MemoryFile;
class SharedCount;

/// The box around the complex: equally far away on all sides, or a little further on each than on the one before.
/// A model and its even box may be so regular together (their corners on one sphere) that TetGen stops at an
/// assertion of its own.
enum class TetgenFrame { even, uneven };

/// True for a tetrahedron that has to be split, by its corners.
using TooLarge = std::function<bool(const std::array<std::array<double, 3>, 4>&)>;

/// What TetGen may take: there are models on which it never ends. A step is a question on which side of a plane a
/// point lies.
struct TetgenBounds {
  std::size_t steps = 0;  ///< 0: no bound
  std::size_t idle = 0;   ///< of these until it begins to refine, and between two looks at tetrahedra; 0: no bound
  double clock = 0;       ///< seconds by the clock; 0 or infinite: no bound
};

/// What it is asked for.
struct TetgenSwitches {
  bool keep_boundary = false;  ///< no new points on facets and segments
  double quality = 0;          ///< largest ratio of circumradius to shortest edge; 0: no bound
  bool volumes = false;        ///< those of the complex are bounds
};

/// While there is one, TetGen ends when it has looked at so many tetrahedra.
class TetgenLooksAtMost {
 public:
  explicit TetgenLooksAtMost(std::size_t looks);
  ~TetgenLooksAtMost();
  TetgenLooksAtMost(const TetgenLooksAtMost&) = delete;
  TetgenLooksAtMost& operator=(const TetgenLooksAtMost&) = delete;
};

/// TetGen did not end within its bounds.
class TetgenLate : public InputError {
 public:
  using InputError::InputError;
};

/// Told meanwhile how many tetrahedra it has looked at whether they have to be split.
using LookedAt = std::function<void(std::size_t)>;

/// Fills the box, all of it, with tetrahedra. `too_large`, if there is one, is asked of each tetrahedron while the
/// mesh is refined. Throws InputError with what TetGen said and what helps, TetgenLate where a bound ends it,
/// std::bad_alloc when it runs out of memory, Stopped.
PlcMesh run_tetgen(const Plc& plc, const TetgenSwitches& switches, TetgenFrame frame, const TetgenBounds& bounds,
                   const TooLarge& too_large = {}, const std::stop_token& stop = {},
                   const LookedAt& looked_at = {});

inline constexpr int kTetgenOutOfSteps = 100;

/// What the child does.
struct TetgenWork {
  std::string switches;  ///< as TetGen's manual has them
  TetgenFrame frame = TetgenFrame::even;
  TetgenBounds bounds{};       ///< without the clock
  std::size_t most_looks = 0;  ///< 0: no bound
  const TooLarge* too_large = nullptr;
  const SharedCount* looked = nullptr;
};

}  // namespace cnrg

// Of the plug-in `tetgen`, to be called in a child: 0, the number that TetGen throws, or kTetgenOutOfSteps.
extern "C" {
int cnrg_tetgen_mesh(const cnrg::Plc& plc, const cnrg::TetgenWork& work, const cnrg::MemoryFile& result);
const char* cnrg_tetgen_version();
}
