"""Graded materials: a bar that turns from steel to ceramic, its mass, and fractions at the corners of its mesh.

A material may change with position: linearly between stops, along a line or with the distance from a node. It is
placed with the shape, goes through every operator as any other, and is exact. In a mesh each tetrahedron has the
fractions at its four corners; they may jump where regions meet. Linear in each tetrahedron, they integrate to the
mass without error but for rounding.
"""
import numpy as np

import cnrg

steel, ceramic = cnrg.material("steel", color="#667788"), cnrg.material("ceramic")
graded = cnrg.material("graded", linear={"from": [0, 0, 0], "to": [0, 0, 4], "stops": [
    [0, "steel"], ["1/2", {"steel": "1/4", "ceramic": "3/4"}], [1, "ceramic"]]})
bar = cnrg.box([0, 0, 0], [1, 1, 4], material=graded).named("bar")
foot = cnrg.box([-1, -1, -1], [2, 2, 0], material=steel).named("foot")
band = cnrg.polygon([[-1, -1, 2], [2, -1, 2], [2, 2, 2], [-1, 2, 2]]).named("band")  # where the slope of it changes
model = cnrg.union(band & bar, bar, foot, dominance="left").evaluate()

mesh = model.tetrahedralize(quality=1.5)
p = mesh.points[mesh.tetrahedra.points]
volumes = np.einsum("ij,ij->i", np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), p[:, 3] - p[:, 0]) / 6
density = {"steel": 7.8, "ceramic": 3.9}
mass = 0
for name, fractions in mesh.fields.items():
    material = name.removeprefix("fraction of ")
    volume = (volumes * fractions.mean(axis=1)).sum()
    mass += volume * density[material]
    print(f"{material}: volume {volume:.6f}")
print(f"mass {mass:.6f}")
# By hand: the foot is 9 of steel; of the bar, steel is 5/8 and 1/8 of its halves.
print(f"by hand {7.8 * (9 + 2 * 5 / 8 + 2 / 8) + 3.9 * (2 * 3 / 8 + 2 * 7 / 8):.6f}")

# Output:
# steel: volume 10.500000
# ceramic: volume 2.500000
# mass 91.650000
# by hand 91.650000
