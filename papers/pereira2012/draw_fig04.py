#!/usr/bin/env python3
"""Draws fig04.png from out/pereira2012/fig04-*.vtu. Needs what draw.py needs, and fonts-dejavu-core for ∪ and ∩.

Left G1 and what only it has, right G2 and what only it has, between them both under each dominance. Regions have
the colour of their material and can be seen through; sheets, wires and points have that of their group."""
import sys

import numpy
import vtk

from draw import HERE, OUT, cells, field, light, read, save, surface
from draw_fig07 import curves, smooth

MATERIALS = {"sand": (0.95, 0.80, 0.52), "gravel": (0.85, 0.58, 0.34), "slate": (0.52, 0.76, 0.78),
             "shale": (0.38, 0.60, 0.80), "basalt": (0.60, 0.54, 0.76)}
GROUPS = (({"crack", "fin", "bolt", "rod", "marks1", "upper", "lower"}, (0.80, 0.24, 0.10)),
          ({"split", "flag", "rail", "marks2", "left", "right", "foot"}, (0.10, 0.26, 0.66)))
WIRES, POINTS = {"bolt", "rod", "rail"}, {"marks1", "marks2"}
# Node, title, focal point, width of what is seen.
WHOLE, COMMON = ((4.6, 2.4, 2.85), 12), ((4.3, 2.5, 2.75), 9)
ROWS = ((("G1", "G1", WHOLE), ("union_G1", "G1 ∪ G2,  G1 > G2", WHOLE),
         ("union_equal", "G1 ∪ G2,  G1 = G2", WHOLE), ("union_G2", "G1 ∪ G2,  G1 < G2", WHOLE),
         ("G2", "G2", WHOLE)),
        (("G1_minus_G2", "G1 − G2", WHOLE), ("intersection_G1", "G1 ∩ G2,  G1 > G2", COMMON),
         ("intersection_equal", "G1 ∩ G2,  G1 = G2", COMMON), ("intersection_G2", "G1 ∩ G2,  G1 < G2", COMMON),
         ("G2_minus_G1", "G2 − G1", WHOLE)))
DIRECTION = numpy.array([0.42, -0.80, 0.42])


def beads(grid, chosen, colour, radius):
    """The chosen vertices as balls."""
    ball = vtk.vtkSphereSource()
    ball.SetRadius(radius)
    ball.SetThetaResolution(24)
    ball.SetPhiResolution(16)
    glyphs = vtk.vtkGlyph3D()
    glyphs.SetSourceConnection(ball.GetOutputPort())
    glyphs.SetInputData(surface(grid, chosen))
    glyphs.ScalingOff()
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(glyphs.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*colour)
    actor.GetProperty().SetAmbient(0.35)
    return actor


def rods(grid, chosen, colour, radius):
    """The chosen edges as rods."""
    tube = vtk.vtkTubeFilter()
    tube.SetInputData(surface(grid, chosen))
    tube.SetRadius(radius)
    tube.SetNumberOfSides(16)
    tube.CappingOn()
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(tube.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*colour)
    actor.GetProperty().SetAmbient(0.35)
    return actor


def scene(grid, title, place, viewport):
    renderer = vtk.vtkRenderer()
    renderer.SetViewport(*viewport)
    renderer.SetUseDepthPeeling(1)
    renderer.SetMaximumNumberOfPeels(16)
    renderer.UseFXAAOn()
    light(renderer)
    dimension, region, material = cells(grid, "dimension"), cells(grid, "region"), cells(grid, "material")
    leaf, bounded = cells(grid, "source_leaf"), cells(grid, "regions_bounded")
    materials, leaves = field(grid, "MaterialNames"), field(grid, "LeafNames")
    centre, width = numpy.array(place[0]), place[1]
    for r in sorted(set(region[dimension == 3])):
        of_region = (dimension == 3) & (region == r)
        colour = MATERIALS[materials[material[of_region][0]]]
        renderer.AddActor(smooth(surface(grid, of_region), colour, 0.30))
    for names, colour in GROUPS:
        def of_group(kinds):
            return numpy.isin(leaf, [i for i, name in enumerate(leaves) if name in names & kinds])

        sheets = of_group(names) & (dimension == 2) & (bounded == 0)
        wires, points = of_group(WIRES) & (dimension == 1), of_group(POINTS) & (dimension == 0)
        if sheets.any():
            renderer.AddActor(smooth(surface(grid, sheets), colour, 0.72))
        if wires.any():
            renderer.AddActor(rods(grid, wires, colour, width / 190))
        if points.any():
            renderer.AddActor(beads(grid, points, colour, width / 85))
    renderer.AddActor(curves(grid, dimension == 1))
    text = vtk.vtkTextActor()
    text.SetInput(title)
    look = text.GetTextProperty()
    look.SetFontFamily(vtk.VTK_FONT_FILE)
    look.SetFontFile("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf")
    look.SetFontSize(27)
    look.SetColor(0.10, 0.09, 0.09)
    look.SetJustificationToCentered()
    text.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    text.SetPosition(0.5, 0.04)
    renderer.AddActor2D(text)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(*centre)
    camera.SetPosition(*(centre + 40 * DIRECTION))
    camera.SetViewUp(0, 0, 1)
    camera.SetParallelScale(width / 2)
    renderer.ResetCameraClippingRange()
    return renderer


def main():
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetAlphaBitPlanes(1)
    window.SetSize(2200, 900)
    for i, row in enumerate(ROWS):
        for k, (node, title, place) in enumerate(row):
            viewport = (k / 5, (1 - i) / 2, (k + 1) / 5, (2 - i) / 2)
            window.AddRenderer(scene(read(OUT / f"fig04-{node}.vtu"), title, place, viewport))
    save(window, sys.argv[1] if len(sys.argv) > 1 else str(HERE / "fig04.png"))


if __name__ == "__main__":
    main()
