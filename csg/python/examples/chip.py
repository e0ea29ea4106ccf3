"""A chip: a stack of layers with metal that has no thickness, and every interface by its name.

In a solver for fields or heat metal of 100 nm on layers of some 10 um is better a surface with a property than a layer
of flat tetrahedra. Here metal is polygons: a gate in the interface of two layers, a trace inside of a layer, a pad on
top, a via as a wire. Each becomes faces of the result wherever it lies, parts what it lies in, and keeps its name;
so do the interfaces of the layers. The mesh conforms to all of them.
"""
import cnrg

layers = [("substrate", "silicon", 0, 20), ("oxide", "silica", 20, 26), ("passivation", "nitride", 26, 30)]
stack = [cnrg.box([0, 0, low], [40, 40, high], material=of).named(name) for name, of, low, high in layers]


def metal(name, x, y, z):
    return cnrg.polygon([[x[0], y[0], z], [x[1], y[0], z], [x[1], y[1], z], [x[0], y[1], z]]).named(name)


gate = metal("gate", (15, 25), (5, 35), 20)  # between substrate and oxide
trace = metal("trace", (10, 14), (5, 35), 23)  # inside of the oxide
pad = metal("pad", (4, 20), (12, 28), 30)  # on top
via = cnrg.polyline([[12, 20, 23], [12, 20, 30]]).named("via")
chip = cnrg.union(gate, trace, pad, via, *stack, dominance="left").evaluate()

for part in chip.components[:3]:
    print(f"{part.name}: {part.material}, volume {part.volume}")
print("surfaces, by what they part and by where they came from:")
for name, cells in chip.groups[2].items():
    print(f"  {name}: area {chip.faces.areas[cells].sum():g}")
for name, cells in chip.groups[1].items():
    print(f"  {name}: length {chip.edges.lengths[cells].sum():g}")

mesh = chip.tetrahedralize(max_volume=50)
mesh.write("chip.msh")  # with these names as physical groups
covered = set(mesh.triangles.cell[i] for i in range(len(mesh.triangles)))
print("the mesh has the gate:", set(chip.groups[2]["from gate"]) <= covered)
print("volumes of the mesh:", [str(part.volume) for part in mesh.regions])

# Output:
# substrate: silicon, volume 32000
# oxide: silica, volume 9600
# passivation: nitride, volume 6400
# surfaces, by what they part and by where they came from:
#   boundary of substrate: area 4800
#   boundary of oxide: area 960
#   boundary of passivation: area 2240
#   wall substrate | oxide: area 1600
#   wall oxide | passivation: area 1600
#   face of trace: area 120
#   from gate: area 300
#   from trace: area 120
#   from pad: area 256
#   from substrate: area 6400
#   from oxide: area 4160
#   from passivation: area 3840
#   wire of via: length 7
# the mesh has the gate: True
# volumes of the mesh: ['32000', '9600', '6400']
