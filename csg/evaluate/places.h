// Where many points lie in a result, exactly, found on all threads.
//
// Planes and half-spaces are cut at a frame around everything else. What lies beyond it is computed by evaluating
// the tree once more, with a frame that holds all such points together. Cells have other numbers there; a cell of
// this result that has no bounds has a point within both frames, which tells its number in either.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "csg/evaluate/evaluate.h"
#include "csg/result/result.h"
#include "csg/tree/tree.h"

namespace cnrg {

class Places {
 public:
  using Place = SimplifiedComplex::Place;

  /// `tree`, if there is one, is the tree of which the result is the node.
  explicit Places(Result result, std::shared_ptr<const Tree> tree = {}, NodeId node = {});
  ~Places();

  /// The cell of the result that holds each point. Throws InputError for points beyond the frame if there is no
  /// tree, and for such as are farther away than any frame may be.
  std::vector<Place> of(std::span<const RationalPoint> points, const Watch& watch = {}, int threads = 0) const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

/// Why a point is too far away for a tree with planes or half-spaces, in words; empty if it is not.
std::string too_far(const RationalPoint& p);

}  // namespace cnrg
