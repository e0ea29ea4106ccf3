#!/usr/bin/env python3
"""Draws fig10-bolts.png from out/pereira2012/fig10-bolts{,-section}.vtu. Needs what draw.py needs.

Left the model cut open along the tunnel, with the whole shell and all bolts; right the tunnel at the fault."""
import sys

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from draw import (COLOURS, FAULT, HERE, OUT, TUNNEL, actor, cells, classify, field, label, light, outlines, read,
                  save, surface)
from draw_fig04 import rods
from draw_fig07 import curves, smooth

SHELL, BOLT, INK, WHITE = (0.64, 0.68, 0.72), (0.72, 0.10, 0.08), (0.10, 0.09, 0.09), (1, 1, 1)
LABELS = (("shell", (70, 71, 50.5), INK), ("unlined", (205, 84, 57.5), WHITE), ("clay", (225, 82, 104), INK),
          ("marl", (225, 82, 74), INK), ("limestone", (160, 81, 37), INK), ("granite", (60, 77, 12), INK))
# Centre, direction to the eye, height of what is seen, labels, part of the window.
VIEWS = (((117, 90, 64), (-0.38, -1.5, 0.42), 176, LABELS, (0, 0, 0.5, 1)),
         ((106, 78, 58), (-0.42, -1.5, 0.50), 56, (), (0.5, 0, 1, 1)))


def add_rocks(renderer, grid):
    dimension, region, material = cells(grid, "dimension"), cells(grid, "region"), cells(grid, "material")
    materials = field(grid, "MaterialNames")
    for r in sorted(set(region[dimension == 3])):
        of_region = (dimension == 3) & (region == r)
        renderer.AddActor(outlines(surface(grid, of_region), (0, 0, 0)))
        rock = COLOURS[materials[material[of_region][0]]]
        for colour, chosen in zip((TUNNEL, FAULT, rock), classify(grid, of_region)):
            if chosen.any():
                renderer.AddActor(actor(surface(grid, chosen), colour, (0, 0, 0)))


def on_wall(grid):
    """The cells with all points on the wall of the tunnel."""
    points = vtk_to_numpy(grid.GetPoints().GetData())
    start, along = numpy.array([-10.0, 76, 51]), numpy.array([260.0, 12, 7])
    away = points - start
    along /= numpy.linalg.norm(along)
    distance = numpy.linalg.norm(away - numpy.outer(away @ along, along), axis=1)
    wall = (8.9 < distance) & (distance < 9.001)
    ids = [grid.GetCell(i).GetPointIds() for i in range(grid.GetNumberOfCells())]
    return numpy.array([all(wall[k.GetId(j)] for j in range(k.GetNumberOfIds())) for k in ids])


def add_support(renderer, grid):
    dimension, leaf = cells(grid, "dimension"), cells(grid, "source_leaf")
    leaves = field(grid, "LeafNames")
    shell = numpy.isin(leaf, [i for i, name in enumerate(leaves) if name == "driven"])
    bolts = numpy.isin(leaf, [i for i, name in enumerate(leaves) if name.startswith(("ring_", "spiles"))])
    renderer.AddActor(smooth(surface(grid, shell & (dimension == 2)), SHELL, 0.72))
    renderer.AddActor(curves(grid, (dimension == 1) & on_wall(grid)))
    renderer.AddActor(rods(grid, bolts & (dimension == 1), BOLT, 0.28))


def scene(centre, direction, height, labels, viewport):
    renderer = vtk.vtkRenderer()
    renderer.SetViewport(*viewport)
    renderer.SetUseDepthPeeling(1)
    renderer.SetMaximumNumberOfPeels(8)
    renderer.UseFXAAOn()
    light(renderer)
    add_rocks(renderer, read(OUT / "fig10-bolts-section.vtu"))
    add_support(renderer, read(OUT / "fig10-bolts.vtu"))
    for text, position, colour in labels:
        label(renderer, text, numpy.array(position) + 100 * numpy.array(direction), colour)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(*centre)
    camera.SetPosition(*(numpy.array(centre) + 400 * numpy.array(direction)))
    camera.SetViewUp(0, 0, 1)
    camera.SetParallelScale(height / 2)
    renderer.ResetCameraClippingRange()
    return renderer


def main():
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetAlphaBitPlanes(1)
    window.SetSize(2000, 640)
    for view in VIEWS:
        window.AddRenderer(scene(*view))
    save(window, sys.argv[1] if len(sys.argv) > 1 else str(HERE / "fig10-bolts.png"))


if __name__ == "__main__":
    main()
