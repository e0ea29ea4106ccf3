#!/usr/bin/env python3
"""Draws fig05.png, fig06.png, fig08.png and fig09.png from the files of those figures in out/pereira2012.
Needs what draw.py needs.

Facets have a colour per leaf, in the order of the leaves. Lines are the edges of the result."""
import numpy
import vtk

from draw import HERE, OUT, cells, light, read, save, surface
from draw_fig07 import curves, smooth

COLOURS = ((0.86, 0.66, 0.46), (0.42, 0.66, 0.62), (0.66, 0.6, 0.74), (0.78, 0.76, 0.5), (0.6, 0.7, 0.82))
# Figure: nodes from left to right, each with its opacity.
PICTURES = {
    "fig05": (("frame", 1), ("socket", 1), ("basin", 1)),
    "fig06": (("b", 0.4), ("c", 1), ("d", 0.4), ("e", 1), ("f", 1)),
    "fig08": (("dangling", 1), ("slotted", 1), ("edge", 1)),
    "fig09": (("faces_first", 0.6), ("inside", 0.8), ("outside", 0.8)),
}
DIRECTION = numpy.array([0.55, -0.75, 0.5])


def half_mesh(grid):
    """The tetrahedra of a mesh behind a plane through its middle, whole, with their edges."""
    chosen = vtk.vtkThreshold()
    chosen.SetInputData(grid)
    chosen.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_CELLS, "dimension")
    chosen.SetUpperThreshold(2.5)
    chosen.SetThresholdFunction(vtk.vtkThreshold.THRESHOLD_UPPER)
    plane = vtk.vtkPlane()
    plane.SetOrigin(*grid.GetCenter())
    plane.SetNormal(0, -1, 0)
    behind = vtk.vtkExtractGeometry()
    behind.SetInputConnection(chosen.GetOutputPort())
    behind.SetImplicitFunction(plane)
    behind.ExtractInsideOn()
    behind.ExtractBoundaryCellsOn()
    skin = vtk.vtkDataSetSurfaceFilter()
    skin.SetInputConnection(behind.GetOutputPort())
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(skin.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(*COLOURS[0])
    look.SetInterpolationToFlat()
    look.SetAmbient(0.4)
    look.EdgeVisibilityOn()
    look.SetEdgeColor(0.2, 0.18, 0.17)
    look.SetLineWidth(0.6)
    return actor


def scene(grid, opacity, viewport):
    renderer = vtk.vtkRenderer()
    renderer.SetViewport(*viewport)
    renderer.SetUseDepthPeeling(1)
    renderer.SetMaximumNumberOfPeels(12)
    renderer.UseFXAAOn()
    light(renderer)
    dimension, leaf = cells(grid, "dimension"), cells(grid, "source_leaf")
    if grid.GetCell(grid.GetNumberOfCells() - 1).GetCellType() == vtk.VTK_TETRA:
        renderer.AddActor(half_mesh(grid))
    else:
        for place, number in enumerate(sorted(set(leaf[dimension == 2]))):
            poly = surface(grid, (dimension == 2) & (leaf == number))
            renderer.AddActor(smooth(poly, COLOURS[place % len(COLOURS)], opacity))
        renderer.AddActor(curves(grid, dimension == 1))
    camera = renderer.GetActiveCamera()
    low, high = numpy.array(grid.GetBounds()).reshape(3, 2).T
    centre = (low + high) / 2
    camera.SetFocalPoint(*centre)
    camera.SetPosition(*(centre + 2.4 * numpy.linalg.norm(high - low) * DIRECTION))
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(25)
    renderer.ResetCameraClippingRange()
    return renderer


def draw(figure, nodes):
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetAlphaBitPlanes(1)
    window.SetSize(500 * len(nodes), 500)
    for i, (node, opacity) in enumerate(nodes):
        viewport = (i / len(nodes), 0, (i + 1) / len(nodes), 1)
        window.AddRenderer(scene(read(OUT / f"{figure}-{node}.vtu"), opacity, viewport))
    save(window, str(HERE / f"{figure}.png"))


if __name__ == "__main__":
    for figure, nodes in PICTURES.items():
        draw(figure, nodes)
