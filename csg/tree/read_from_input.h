// Trees from standard input: written by another program, or typed.
#pragma once

#include "csg/tree/tree.h"

namespace cnrg {

/// As `read_tree`, of standard input up to its end: places are `<stdin>:line:column`, and files that the tree
/// names are looked for from the current folder on.
Tree read_tree_from_input(const ReadOptions& options = {});

}  // namespace cnrg
