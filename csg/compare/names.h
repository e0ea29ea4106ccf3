// Which names count. A region that nobody named is called after its node; the nodes of an answer to an exercise
// may be called anything.
#pragma once

#include "csg/materials/name.h"

namespace cnrg {

/// Two names differ where one of them has a part that the other one has not and that somebody gave: by `name`, in
/// a group, in a CAD model. Parts of a result that was read back and does not tell may be either; they differ from
/// given ones and from each other, not from those of nodes.
bool names_differ(const Name& a, const Name& b);

}  // namespace cnrg
