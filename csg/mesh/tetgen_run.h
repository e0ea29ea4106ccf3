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

/// What TetGen may take: there are models on which it never ends.
struct TetgenTime {
  int seconds = 0;   ///< of processor time; 0: no bound
  int step = 0;      ///< the same until it begins to refine, and between two looks at tetrahedra after that
  double clock = 0;  ///< seconds by the clock; 0 or infinite: no bound
};

/// What it is asked for.
struct TetgenSwitches {
  bool keep_boundary = false;  ///< no new points on facets and segments
  double quality = 0;          ///< largest ratio of circumradius to shortest edge; 0: no bound
  bool volumes = false;        ///< those of the complex are bounds
};

/// While there is one, TetGen's time is over when it has looked at so many tetrahedra: how it ends does not depend
/// on the machine then.
class TetgenLooksAtMost {
 public:
  explicit TetgenLooksAtMost(std::size_t looks);
  ~TetgenLooksAtMost();
  TetgenLooksAtMost(const TetgenLooksAtMost&) = delete;
  TetgenLooksAtMost& operator=(const TetgenLooksAtMost&) = delete;
};

/// TetGen did not end in its time.
class TetgenLate : public InputError {
 public:
  using InputError::InputError;
};

/// Told meanwhile how many tetrahedra it has looked at whether they have to be split.
using LookedAt = std::function<void(std::size_t)>;

/// Fills the box, all of it, with tetrahedra. `too_large`, if there is one, is asked of each tetrahedron while the
/// mesh is refined. Throws InputError with what TetGen said and what helps, TetgenLate where its time is over,
/// std::bad_alloc when it runs out of memory, Stopped.
PlcMesh run_tetgen(const Plc& plc, const TetgenSwitches& switches, TetgenFrame frame, const TetgenTime& time,
                   const TooLarge& too_large = {}, const std::stop_token& stop = {},
                   const LookedAt& looked_at = {});

/// What the child does.
struct TetgenWork {
  std::string switches;  ///< as TetGen's manual has them
  TetgenFrame frame = TetgenFrame::even;
  int step = 0;                ///< of TetgenTime
  std::size_t most_looks = 0;  ///< 0: no bound
  const TooLarge* too_large = nullptr;
  const SharedCount* looked = nullptr;
};

}  // namespace cnrg

// Of the plug-in `tetgen`, to be called in a child: 0, or the number that TetGen throws.
extern "C" {
int cnrg_tetgen_mesh(const cnrg::Plc& plc, const cnrg::TetgenWork& work, const cnrg::MemoryFile& result);
const char* cnrg_tetgen_version();
}
