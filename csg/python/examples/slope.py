"""A slope: ground with a fault, a tunnel and a bolt, from shapes to names, volumes and a mesh.

Nodes are shapes and what operators make of them; nothing is computed before `evaluate`. The fault has no thickness
and parts the ground in two regions all the same, and the bolt is a wire in one of them. Numbers are exact: "145/3" is
that fraction, a volume is a Fraction, and the mesh is proven to have all of it but for what doubles round.
"""
import cnrg

ground = cnrg.box([0, 0, 0], [100, 100, 60], material="rock").named("ground")
fault = cnrg.polygon([[20, -5, -5], [70, -5, 65], [70, 105, 65], [20, 105, -5]]).named("fault")
bolt = cnrg.polyline([[60, 50, 30], [60, 50, "145/3"]]).named("bolt")
tunnel = cnrg.cylinder([60, -5, 30], [60, 105, 30], 6, segments=48)
model = cnrg.union(bolt, fault & ground, ground, dominance="left") - tunnel

slope = model.evaluate()
print(slope)
for part in slope.components:
    print(f"{part.number} {part.name}: {part.material or 'no material'}, volume {float(part.volume):.3f}")
for name, cells in {**slope.groups[2], **slope.groups[1]}.items():
    print(f"{name}: {len(cells)}")
mesh = slope.tetrahedralize(quality=1.4)
print([f"{part.name}: {float(part.volume):.3f}" for part in mesh.regions])

# Output:
# <cnrg.Result 'difference': 14 vertices, 23 edges, 12 faces, 2 regions>
# 1 ground: rock, volume 270000.000
# 2 ground: rock, volume 318722.537
# 3 entities: no material, volume 0.000
# boundary of ground 1: 5
# boundary of ground 2: 6
# wall ground 1 | ground 2: 1
# boundary of ground: 11
# wall ground | ground: 1
# from fault: 1
# from ground: 10
# from cylinder: 1
# wire of bolt: 1
# ['ground 1: 270000.000', 'ground 2: 318722.537']
