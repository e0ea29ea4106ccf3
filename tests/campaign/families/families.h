// The families of a campaign; each function adds those of one kind.
#pragma once

#include "tests/campaign/driver/family.h"

namespace cnrg::campaign {

/// Brute force on cubical complexes: pairs of groups, and whole trees with every operator.
void add_cubes(Families& families);
/// CGAL's Nef polyhedra: scenes, soups, curved leaves, trees with every operator.
void add_nef(Families& families);
/// Values of whole trees: laws, definitions, order, motion, threads, many operands, files.
void add_values(Families& families);
/// Nodes under transforms.
void add_transforms(Families& families);
/// Volumes by inclusion and exclusion, of boxes, solids and echoes.
void add_volumes(Families& families);
/// Which points are in which node, by definition.
void add_places(Families& families);
/// Betti numbers by elimination and by duality.
void add_betti(Families& families);
/// Near features joined, doubles snapped.
void add_moved(Families& families);

Families every_family();

}  // namespace cnrg::campaign
