// The life of a cell as `cnrg explain` tells it, for people and for programs: a text, and the same facts as JSON.
//
// The facts themselves are structures of many kinds (explain.h), whose headers would bring half of the source
// along. Who is outside and wants to compute with them, in whatever language, reads JSON; its members are in
// answers.schema.json. Exact numbers are texts there, as in a .json of a result.
#pragma once

#include <string>

#include "csg/evaluate/evaluate.h"
#include "csg/tree/tree.h"

namespace cnrg {

struct Story {
  std::string text, json;
};

/// Of a cell such as `f12` of a node that was asked for. The evaluation must have kept all values
/// (EvaluateOptions::keep_all). Throws InputError for an unknown name; the message tells which cells there are.
Story story(const Tree& tree, const Evaluation& evaluation, NodeId node, const std::string& cell);
/// Of the cell of the refinement that holds a point, active in the node or not. Throws InputError beyond the frame
/// of unbounded leaves (EvaluateOptions::reach moves it).
Story story(const Tree& tree, const Evaluation& evaluation, NodeId node, const RationalPoint& point);

}  // namespace cnrg
