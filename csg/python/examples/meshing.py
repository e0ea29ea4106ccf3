"""A mesh for a finite-element code, by meshio: cells with the names of regions and boundaries.

`tetrahedralize` fills regions with tetrahedra that conform to every wall, sheet, wire and point. As a mesh of meshio
it goes to any format that meshio writes, with sets of cells by name: regions and materials for the equation, boundaries
for its conditions, walls and sheets for jumps. Here each set is measured by its simplices alone, and is as large as
it was drawn.
"""
import meshio
import numpy as np

import cnrg

rock = cnrg.box([0, 0, 0], [4, 4, 2], material="sandstone").named("rock")
seal = cnrg.box([0, 0, 2], [4, 4, 3], material="shale").named("seal")
fault = cnrg.polygon([[1, 1, 0], [3, 1, "3/2"], [3, 3, "3/2"], [1, 3, 0]]).named("fault")  # ends in the rock
well = cnrg.polyline([[2, 2, 3], [2, 2, 1]]).named("well")
model = cnrg.union(well, fault, rock, seal, dominance="left").evaluate()
mesh = model.tetrahedralize(quality=1.3, max_volume="0.05").to_meshio()


def measure(kind, cells):
    """Length, area or volume."""
    p = mesh.points[cells]
    if kind == "line":
        return np.linalg.norm(p[:, 1] - p[:, 0], axis=1).sum()
    if kind == "triangle":
        return np.linalg.norm(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1).sum() / 2
    return np.einsum("ij,ij->i", np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), p[:, 3] - p[:, 0]).sum() / 6


for name, sets in mesh.cell_sets.items():
    size = sum(measure(block.type, block.data[cells]) for block, cells in zip(mesh.cells, sets) if len(cells))
    print(f"{name}: {size:.6f}")
solid = meshio.Mesh(mesh.points, {"tetra": mesh.cells_dict["tetra"]})
solid.write("model.vtk")
print("written and read:", np.array_equal(meshio.read("model.vtk").cells_dict["tetra"], solid.cells_dict["tetra"]))

# Output:
# wire of well: 2.000000
# boundary of rock: 48.000000
# boundary of seal: 32.000000
# wall rock | seal: 16.000000
# face of fault: 5.000000
# from fault: 5.000000
# from rock: 64.000000
# from seal: 48.000000
# rock: 32.000000
# seal: 16.000000
# material sandstone: 32.000000
# material shale: 16.000000
# written and read: True
