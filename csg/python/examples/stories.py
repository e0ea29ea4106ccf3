"""Why is there no face here? Every cell has a story, and what vanished has one as well.

The operators of Pereira et al. (2012) keep or remove entities by rows of tables, for reasons that a person can check:
which operand dominates, on which side of the other an entity lies, what it bounds. A result answers for each cell, and
for each place, by which row it lived or went, node by node. Here a sheet vanishes in one union and stays in the other.
"""
import cnrg

ground = cnrg.box([0, 0, 0], [4, 4, 4]).named("ground")
sheet = cnrg.polygon([[1, 1, 2], [3, 1, 2], [3, 3, 2], [1, 3, 2]]).named("sheet")
for dominance in ("left", "right"):
    both = cnrg.union(ground, sheet, dominance=dominance).named("both").evaluate()
    found = both.locate([[2, 2, 2]])
    print(f"dominance {dominance}: {len(both.faces.active)} faces; at the middle of the sheet is {found.names[0]}")
    for step in both.explain([2, 2, 2]).steps:
        rows = " " + ", ".join(step.rows) if step.rows else ""
        print(f"    {step.node}:{rows}{' removed it' if step.removed else ''}; {step.component_name or 'outside'}")

# Output:
# dominance left: 6 faces; at the middle of the sheet is r0
#     ground:; ground
#     sheet:; entities
#     both: union.face.BinA.dominant removed it; ground
# dominance right: 7 faces; at the middle of the sheet is f5
#     ground:; ground
#     sheet:; entities
#     both: union.face.AinB.dominant; entities
