#!/usr/bin/python3
"""Makes a mesh of a model in Gmsh's own way, in a process that may crash: model as JSON on standard input.

`fragments`: the box or the solids, surfaces and wires as OpenCASCADE shapes, which BooleanFragments makes one
model of. `discrete`: triangles as they are, made to a geometry (classifySurfaces, createGeometry) and embedded in a
box; they must not cross.
"""
import json
import math
import sys
import time

import gmsh


class Shapes:
    """Points and lines of one part, each once."""

    def __init__(self, points):
        self.kernel = gmsh.model.occ
        self.tags = [self.kernel.addPoint(*p) for p in points]
        self.lines = {}

    def line(self, a, b):
        """The line from a to b; negative where it was made from b to a."""
        if (b, a) in self.lines:
            return -self.lines[b, a]
        if (a, b) not in self.lines:
            self.lines[a, b] = self.kernel.addLine(self.tags[a], self.tags[b])
        return self.lines[a, b]

    def face(self, loops):
        return self.kernel.addPlaneSurface(
            [self.kernel.addCurveLoop([self.line(a, b) for a, b in zip(loop, loop[1:] + loop[:1])]) for loop in loops])


def fragments(model):
    occ = gmsh.model.occ
    volumes, others = [], []
    if model["box"]:
        low, high = model["box"]
        volumes.append((3, occ.addBox(*low, *(h - l for l, h in zip(low, high)))))
    for solid in model["solids"]:
        shapes = Shapes(solid["points"])
        volumes.append((3, occ.addVolume([occ.addSurfaceLoop([shapes.face(f) for f in solid["faces"]])])))
    for sheet in model["sheets"]:
        shapes = Shapes(sheet["points"])
        others += [(2, shapes.face(f)) for f in sheet["faces"]]
    for wire in model["wires"]:
        shapes = Shapes(wire["points"])
        others += [(1, abs(shapes.line(a, b))) for a, b in wire["segments"]]
    if len(volumes) + len(others) > 1:
        occ.fragment(volumes, others)
    occ.synchronize()


def discrete(model):
    first = 1
    for sheet in model["sheets"]:
        surface = gmsh.model.addDiscreteEntity(2)
        count = len(sheet["points"])
        gmsh.model.mesh.addNodes(2, surface, range(first, first + count), [x for p in sheet["points"] for x in p])
        gmsh.model.mesh.addElementsByType(surface, 2, [], [first + i for f in sheet["faces"] for i in f[0]])
        first += count
    gmsh.model.mesh.classifySurfaces(math.pi, True, True, math.pi)
    gmsh.model.mesh.createGeometry()
    surfaces = [tag for _, tag in gmsh.model.getEntities(2)]
    geo = gmsh.model.geo
    low, high = model["box"]
    point = [geo.addPoint(*(high[k] if i >> k & 1 else low[k] for k in range(3))) for i in range(8)]
    lines = {}
    for i in range(8):
        for k in range(3):
            if not i >> k & 1:
                lines[i, i | 1 << k] = geo.addLine(point[i], point[i | 1 << k])
    sides = []
    for square in ((0, 1, 3, 2), (4, 5, 7, 6), (0, 1, 5, 4), (2, 3, 7, 6), (0, 2, 6, 4), (1, 3, 7, 5)):
        loop = [lines[a, b] if (a, b) in lines else -lines[b, a] for a, b in zip(square, square[1:] + square[:1])]
        sides.append(geo.addPlaneSurface([geo.addCurveLoop(loop)]))
    volume = geo.addVolume([geo.addSurfaceLoop(sides)])
    geo.synchronize()
    gmsh.model.mesh.embed(2, surfaces, 3, volume)


def main():
    model = json.load(sys.stdin)
    begin = time.monotonic()
    gmsh.initialize(["gmsh", "-v", "2"])
    gmsh.option.setNumber("Mesh.SaveAll", 1)
    if model["size"]:
        gmsh.option.setNumber("Mesh.CharacteristicLengthMax", model["size"])
    {"fragments": fragments, "discrete": discrete}[model["way"]](model)
    shaped = time.monotonic()
    gmsh.model.mesh.generate(3)
    done = time.monotonic()
    gmsh.write(model["out"])
    print(json.dumps({"shapes": shaped - begin, "mesh": done - shaped}))
    gmsh.finalize()


main()
