"""Two cubes that overlap: what components, open sets and closed sets are, and why they are kept apart (CNRG).

Rossignac and Requicha (1991) let a geometric set be any union of open cells: a cube without its boundary, a face
without its rim, a solid with a crack. Nothing is closed or thrown away unless you ask for it. An operator on components
keeps who was in what: `sum` of A and B has three of them, A without B, both, B without A. Here each value is told by
its cells of each dimension and by who holds two places: the middle of a face that both cubes want, and a corner.
"""
import cnrg

a = cnrg.box([0, 0, 0], [2, 2, 2]).named("a")
b = cnrg.box([1, 0, 0], [3, 2, 2]).named("b")
places = [[1, 1, 1], [0, 0, 0]]  # in the middle of a face of b, inside of a; a corner of a


def tell(what, node):
    value = node.evaluate()
    counts = [len(cells.active) for cells in (value.vertices, value.edges, value.faces, value.regions)]
    at = [value.components[c - 1].name if c else "-" for c in value.locate(places).component]
    print(f"{what:<24} cells {counts} volume {value.volume}, at the places: {', '.join(at)}")
    return value


# A group is closed: regions and the entities around them. The one that dominates keeps its boundary and its volume.
tell("a | b", a | b)
tell("union, a dominates", cnrg.union(a, b, dominance="left"))
# Components are sets of cells. Which has the face between them? The sum says: those of the overlap are its own.
tell("sum(a, b)", cnrg.sum(a.unify(), b.unify()))
# a - b in the sense of sets: b is closed, so what is left lacks the face that b took with it: it is not closed.
left = tell("subtract(a, b)", cnrg.subtract(a.unify(), b.unify()))
try:
    left.write("left.stl")
except cnrg.InputError as error:
    print("   ", error.message.split(";")[0])
closed = tell("... closed", cnrg.subtract(a.unify(), b.unify()).closure())
# The interior has no faces; taken away it leaves the skin, a surface without volume.
tell("interior", a.interior())
skin = tell("subtract(a, interior)", cnrg.subtract(a.unify(), a.interior()))
print("    the skin has", skin.topology().betti, "pieces, tunnels, cavities")
# Whatever the components, the set of points is what sets say it is.
print(cnrg.subtract(a.unify(), b.unify()).evaluate().volume + b.evaluate().volume == (a | b).evaluate().volume)

# Output:
# a | b                    cells [16, 28, 14, 1] volume 12, at the places: a, entities
# union, a dominates       cells [16, 28, 15, 2] volume 12, at the places: a, entities
# sum(a, b)                cells [16, 28, 16, 3] volume 12, at the places: a & b, a
# subtract(a, b)           cells [4, 8, 5, 1] volume 4, at the places: -, a
#     left.stl: STL holds closed sets only, and the result lacks 1 boundary face, 4 boundary edges, 4 boundary vertices
# ... closed               cells [8, 12, 6, 1] volume 4, at the places: closure, a
# interior                 cells [0, 0, 0, 1] volume 8, at the places: a, -
# subtract(a, interior)    cells [8, 12, 6, 0] volume 0, at the places: -, a
#     the skin has (1, 0, 1) pieces, tunnels, cavities
# True
