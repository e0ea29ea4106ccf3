// The library in one include, for programs that use it: `#include <cnrg.h>`.
//
// Two ways in:
//   * a tree file or a text of one: `read_tree`, `parse_tree`, then `evaluate`, then `write` of a `Result`;
//   * step by step: shapes (or a Soup by hand) -> `make_soup` -> `build_complex` -> `leaf_groups` -> operators
//     -> `volume`, `Locator`, a `Result` -> `write`.
// csg/examples of the source has a short program for each. Everything is in the namespace cnrg. Errors are
// exceptions: InputError for what the caller can mend, FileError where the system refuses a file, InvariantError
// for bugs (kernel/base/error.h).
//
// What lives how long:
//   * A Tree, a Soup, an Evaluation and a Result own what they hold. A Complex is shared
//     (std::shared_ptr<const Complex>) and constant.
//   * Groups, components, selections and sets of cells are values, too; the ids in them are those of one complex
//     and mean nothing on another.
//   * What takes a `const Complex&` uses it during the call. Only Locator keeps the reference; what is kept for
//     later (a Result) takes the pointer.
//
// These headers and what they include are all that is installed; the rest of the source is private.
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
#include "csg/leaves/mesh_data.h"
#include "csg/leaves/shapes.h"
#include "csg/materials/sampler.h"
#include "csg/tree/selector.h"
#include "csg/tree/tree.h"

// Operators.
#include "csg/operators/boolean.h"
#include "csg/operators/cnrg.h"
#include "csg/operators/components.h"
#include "csg/operators/group.h"
#include "csg/operators/say.h"
#include "csg/operators/select.h"

// Results, their files, and what is told of them.
#include "csg/compare/difference.h"
#include "csg/evaluate/places.h"
#include "csg/explain/story.h"
#include "csg/formats/result_file.h"
#include "csg/formats/tetrahedra_arrays.h"
#include "csg/mesh/cell_groups.h"
#include "csg/picture/picture.h"
#include "csg/result/arrays.h"
#include "csg/result/join.h"
#include "csg/result/measures.h"
#include "csg/result/result.h"
#include "csg/topology/selectables.h"
#include "csg/topology/topology.h"
#include "csg/view/page.h"
