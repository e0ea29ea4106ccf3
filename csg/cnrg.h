// The library in one include, for programs that use it: `#include <cnrg.h>`.
//
// Two ways in:
//   * a tree file or a text of one: `read_tree`, `parse_tree`, then `evaluate`, then `write`;
//   * step by step: shapes (or a Soup by hand) -> `make_soup` -> `build_complex` -> `leaf_groups` -> operators
//     -> `simplify`, `volume`, `Locator`, `write`.
// csg/examples of the source has a short program for each. Everything is in the namespace cnrg. Errors are
// exceptions: InputError for what the caller can mend, FileError, InvariantError for bugs (kernel/base/error.h).
#pragma once

// Cells: soup, complex, point location.
#include "kernel/base/error.h"
#include "kernel/complex/complex.h"
#include "kernel/refine/soup.h"

// Sets of cells: topology, simplification, measures.
#include "kernel/selection/measure.h"
#include "kernel/selection/selection.h"
#include "kernel/selection/simplify.h"

// Leaves and trees.
#include "csg/evaluate/evaluate.h"
#include "csg/leaves/leaf.h"
#include "csg/leaves/shapes.h"
#include "csg/tree/finer.h"
#include "csg/tree/tree.h"

// Operators.
#include "csg/operators/boolean.h"
#include "csg/operators/cnrg.h"
#include "csg/operators/leaf_group.h"
#include "csg/operators/leaf_value.h"
#include "csg/operators/node_value.h"

// Files of results.
#include "csg/formats/node_file.h"
#include "csg/formats/writer.h"
