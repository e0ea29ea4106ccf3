// Which regions come first that go on for ever.
//
// The frame that planes are cut at (Complex::frame) is as large as all leaves need it, so its corners must not
// decide which region comes first. Regions that go on for ever towards lower x (or, if x is the same on the way,
// lower y or z) have no least point. They have one in a box of which the sides are farther away than any number,
// each much farther than the one before. Whatever is cut off by finite leaves, the least point is that of a cell
// of the planes alone. So they are those of a second complex: the planes in a box that is large enough.
#pragma once

#include <memory>

#include "kernel/complex/complex.h"

namespace cnrg {

class FarOrder {
 public:
  /// Of a complex with a frame, in the coordinates `axes` (nullptr: x, y, z).
  FarOrder(const Complex& complex, const LeafAxes* axes);
  ~FarOrder();
  /// The place, from 1, of what goes on for ever beyond a face of the frame, of which `outside` is the outer side;
  /// 0 if there is no way there to lower and lower points.
  std::uint32_t place(HalfFace outside) const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace cnrg
