// The rows of an evaluation: an instance in numbers.
//
// Its totals (counts of cells, number and volume of its regions) are kept with the parts of a group (parts.h), so
// that a chain of unions pays for each part once and not in every row; the nodes of a chain that is one fold get
// theirs from its steps (chains.h). Only the result pays otherwise: its cells are simplified as a whole, for its
// files, and counted there.
#pragma once

#include "csg/evaluate/evaluate.h"
#include "csg/evaluate/simplified_value.h"
#include "csg/evaluate/value_store.h"

namespace cnrg {

/// A row with node, name and operator and without numbers.
NodeRow row_of(const Tree& tree, const Unfolding& unfolding, InstanceId id);

/// Fills the totals of a row of a group.
void fill_totals(const Totals& totals, NodeRow& row);

/// Fills the totals of a row; `region_volumes`: also the volume and name of each region or component.
/// `simplified`, of the same value, where it is at hand and no other node uses the value; else nullptr.
void fill_totals(const Complex& complex, NodeValue& value, bool region_volumes, const SimplifiedValue* simplified,
                 NodeRow& row);

/// The totals of the groups that are there, ahead of their rows and by all threads: no group's depend on
/// another's.
void prepare_totals(const Complex& complex, ValueStore& values);

}  // namespace cnrg
