#!/usr/bin/env python3
"""Draws fig07.png from out/pereira2012/fig07-{both,intersection,difference}.vtu. Needs what draw.py needs.

Facets have the colour of the solid whose patch they lie on. Lines are the edges of the result: patch boundaries
and the curves in which the solids meet."""
import sys

import numpy
import vtk

from draw import HERE, OUT, cells, field, light, read, save, surface

COLOURS = {"cube": (0.86, 0.66, 0.46), "bottle": (0.42, 0.66, 0.62)}
VIEWS = (("both", 0.33), ("intersection", 1), ("difference", 1))


def smooth(poly, colour, opacity):
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputData(poly)
    normals.SetFeatureAngle(40)
    normals.ConsistencyOff()
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(normals.GetOutputPort())
    mapper.ScalarVisibilityOff()
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(*colour)
    look.SetOpacity(opacity)
    look.SetAmbient(0.36)
    look.SetDiffuse(0.74)
    look.SetSpecular(0.08)
    return actor


def curves(grid, chosen):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(surface(grid, chosen))
    mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0.16, 0.14, 0.13)
    actor.GetProperty().SetLineWidth(2.8)
    actor.GetProperty().LightingOff()
    return actor


def add(renderer, grid, opacity):
    dimension, leaf = cells(grid, "dimension"), cells(grid, "source_leaf")
    names = field(grid, "LeafNames")
    for number, name in enumerate(names):
        of_leaf = (dimension == 2) & (leaf == number)
        if name in COLOURS and of_leaf.any():
            renderer.AddActor(smooth(surface(grid, of_leaf), COLOURS[name], opacity if name == "cube" else 1))
    renderer.AddActor(curves(grid, dimension == 1))


def main():
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetAlphaBitPlanes(1)
    window.SetSize(1800, 620)
    for i, (name, opacity) in enumerate(VIEWS):
        renderer = vtk.vtkRenderer()
        renderer.SetViewport(i / 3, 0, (i + 1) / 3, 1)
        renderer.SetUseDepthPeeling(1)
        renderer.SetMaximumNumberOfPeels(12)
        renderer.UseFXAAOn()
        light(renderer)
        add(renderer, read(OUT / f"fig07-{name}.vtu"), opacity)
        camera = renderer.GetActiveCamera()
        camera.SetFocalPoint(0, 0, 2.2)
        camera.SetPosition(*(numpy.array([0, 0, 2.2]) + 15.5 * numpy.array([0.55, -0.75, 0.42])))
        camera.SetViewUp(0, 0, 1)
        camera.SetViewAngle(26)
        renderer.ResetCameraClippingRange()
        window.AddRenderer(renderer)
    save(window, sys.argv[1] if len(sys.argv) > 1 else str(HERE / "fig07.png"))


if __name__ == "__main__":
    main()
