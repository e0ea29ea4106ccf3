"""Fractures in a block: the graph of cells of all dimensions that codes for flow in fractured rock need (as PorePy).

Such a code has an unknown in each *subdomain*: blocks of rock (3D), pieces of fractures (2D), the lines in which
fractures cross (1D), the points in which these lines do (0D). Flow goes through *interfaces*, from a subdomain to one
of a dimension less on its boundary: a piece of a fracture has one on each of its two sides, even where it ends inside
of a block and both are the same block. An interface has a measure and a direction: the integral of the normal that
points out of the higher subdomain. Over the whole boundary of a subdomain these add up to zero; that is checked here.

Fractures are polygons, however they meet; a result has every piece and what is around it.
"""
import numpy as np

import cnrg

block = cnrg.box([0, 0, 0], [4, 4, 4]).named("rock")
plane = cnrg.polygon([[-1, -1, 2], [5, -1, 2], [5, 5, 2], [-1, 5, 2]]).named("plane")  # cuts the block in two
wall = cnrg.polygon([[1, 2, 1], [3, 2, 1], [3, 2, 3], [1, 2, 3]]).named("wall")  # ends in the rock
oblique = cnrg.polygon([[1, 1, 1], [3, 3, 1], [3, 3, 3], [1, 1, 3]]).named("oblique")
model = cnrg.union(plane & block, wall, oblique, block, dominance="left").evaluate()
faces, edges, vertices, regions = model.faces, model.edges, model.vertices, model.regions

# Subdomains by dimension. In rock are faces with rock on both sides; two fractures meet in a line, three in a point.
blocks = list(regions.active)
in_rock = [f for f in faces.active if all(r >= 0 and regions.component[r] > 0 for r in faces.regions[f])]
fractures_at = {e: {model.leaves[faces.leaf[side >> 1]] for side in edges.around[e]} for e in edges.active}
lines = [e for e in edges.active
         if all(side >> 1 in in_rock for side in edges.around[e]) and len(fractures_at[e]) > 1]
points = [v for v in vertices.active
          if len(set().union(*(fractures_at[e] for e in vertices.edges[v] if e in lines))) > 2]
print("subdomains:", {3: len(blocks), 2: len(in_rock), 1: len(lines), 0: len(points)})
# PorePy makes one grid of the pieces of a fracture, and one of the pieces of a line.
print("grids: rock,", ", ".join(sorted({model.leaves[faces.leaf[f]] for f in in_rock} |
                                       {" x ".join(sorted(fractures_at[e])) for e in lines})), "and", len(points),
      "point")


def vector(edge, turned):
    """From end to end of an edge, in the direction in which it is walked."""
    chain = model.points[edges.points[edge]]
    return (chain[-1] - chain[0]) * (-1 if turned else 1)


# Interfaces: (dimension of the higher one, its number, the number of the lower one, side, integral of the normal).
interfaces = []
rest = {}  # what else bounds a subdomain: the surface of the block, tips of fractures
for f in faces.active:
    for side, region in enumerate(faces.regions[f]):
        if region not in blocks:
            continue
        # Out of the region in front is into the back.
        normal = faces.area_vectors[f] * (-1 if side == 0 else 1)
        if f in in_rock:
            interfaces.append((3, region, f, side, normal))
        else:
            rest.setdefault((3, region), []).append(normal)
for f in in_rock:
    front = faces.area_vectors[f] / faces.areas[f]
    for walk in faces.loop_edges[f]:
        for step in walk:
            # The face is to the left of the walk: to its right is out of it.
            normal = np.cross(vector(step >> 1, step & 1), front)
            if step >> 1 in lines:
                interfaces.append((2, f, step >> 1, 0, normal))
            else:
                rest.setdefault((2, f), []).append(normal)
for e in lines:
    direction = vector(e, False) / edges.lengths[e]
    for end, v in enumerate(edges.vertices[e]):
        if v in points:
            interfaces.append((1, e, v, end, direction * (1, -1)[end == 0]))
        else:
            rest.setdefault((1, e), []).append(direction * (1, -1)[end == 0])

for d in (3, 2, 1):
    of = [i for i in interfaces if i[0] == d]
    print(f"interfaces {d}D-{d - 1}D: {len(of)}, measure {sum(np.linalg.norm(i[4]) for i in of):.6f}")
both = [i for i in interfaces if i[0] == 3 and faces.regions[i[2], 0] == faces.regions[i[2], 1]]
print("pieces with one block on both sides:", len(both) // 2)
for f in in_rock:
    name = model.leaves[faces.leaf[f]]
    print(f"  f{f} of {name}: blocks {sorted(map(int, faces.regions[f]))}, area {faces.areas[f]:.4f}, projections",
          np.abs(np.round(faces.area_vectors[f], 4)))
for d, subdomains in ((3, blocks), (2, in_rock), (1, lines)):
    for s in subdomains:
        out = [i[4] for i in interfaces if i[:2] == (d, s)] + rest.get((d, s), [])
        assert np.allclose(sum(out), 0), (d, s)
print("the normals of each subdomain add up to zero")

# Output:
# subdomains: {3: 2, 2: 9, 1: 6, 0: 1}
# grids: rock, oblique, oblique x plane, oblique x wall, plane, plane x wall, wall and 1 point
# interfaces 3D-2D: 18, measure 51.313708
# interfaces 2D-1D: 24, measure 27.313708
# interfaces 1D-0D: 6, measure 6.000000
# pieces with one block on both sides: 8
#   f5 of plane: blocks [1, 2], area 16.0000, projections [ 0.  0. 16.]
#   f9 of oblique: blocks [1, 1], area 1.4142, projections [1. 1. 0.]
#   f10 of oblique: blocks [2, 2], area 1.4142, projections [1. 1. 0.]
#   f11 of wall: blocks [1, 1], area 1.0000, projections [0. 1. 0.]
#   f12 of wall: blocks [2, 2], area 1.0000, projections [0. 1. 0.]
#   f13 of wall: blocks [1, 1], area 1.0000, projections [0. 1. 0.]
#   f14 of oblique: blocks [1, 1], area 1.4142, projections [1. 1. 0.]
#   f15 of wall: blocks [2, 2], area 1.0000, projections [0. 1. 0.]
#   f16 of oblique: blocks [2, 2], area 1.4142, projections [1. 1. 0.]
# the normals of each subdomain add up to zero
