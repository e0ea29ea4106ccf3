#!/usr/bin/env python3
"""Draws fig10.png from out/pereira2012/{fig10,section}.vtu. Needs python3-vtk9 and python3-numpy; without a
display run it under xvfb-run.

Left the whole model. Right the model cut open along the tunnel and pulled apart at the fault."""
import pathlib
import sys

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

HERE = pathlib.Path(__file__).resolve().parent
OUT = HERE.parent.parent / "out" / "pereira2012"
COLOURS = {"clay": (0.80, 0.58, 0.38), "marl": (0.93, 0.82, 0.52), "limestone": (0.62, 0.72, 0.62),
           "granite": (0.56, 0.50, 0.60)}
TUNNEL = (0.27, 0.32, 0.40)
FAULT = (0.84, 0.30, 0.22)


def read(path):
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def field(grid, name):
    array = grid.GetFieldData().GetAbstractArray(name)
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())]


def cells(grid, name):
    return vtk_to_numpy(grid.GetCellData().GetArray(name))


def surface(grid, chosen):
    """The chosen triangles as polygons."""
    ids = vtk.vtkIdTypeArray()
    for i in numpy.nonzero(chosen)[0]:
        ids.InsertNextValue(int(i))
    node = vtk.vtkSelectionNode()
    node.SetFieldType(vtk.vtkSelectionNode.CELL)
    node.SetContentType(vtk.vtkSelectionNode.INDICES)
    node.SetSelectionList(ids)
    selection = vtk.vtkSelection()
    selection.AddNode(node)
    extract = vtk.vtkExtractSelection()
    extract.SetInputData(0, grid)
    extract.SetInputData(1, selection)
    to_polygons = vtk.vtkGeometryFilter()
    to_polygons.SetInputConnection(extract.GetOutputPort())
    clean = vtk.vtkCleanPolyData()
    clean.SetInputConnection(to_polygons.GetOutputPort())
    clean.PointMergingOff()
    clean.Update()
    return clean.GetOutput()


def actor(poly, colour, shift):
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputData(poly)
    normals.SetFeatureAngle(28)
    normals.ConsistencyOff()
    normals.SplittingOn()
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(normals.GetOutputPort())
    mapper.ScalarVisibilityOff()
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    result = vtk.vtkActor()
    result.SetMapper(mapper)
    result.SetPosition(*shift)
    look = result.GetProperty()
    look.SetColor(*colour)
    look.SetAmbient(0.36)
    look.SetDiffuse(0.74)
    look.SetSpecular(0.05)
    return result


def outlines(poly, shift):
    edges = vtk.vtkFeatureEdges()
    edges.SetInputData(poly)
    edges.SetFeatureAngle(28)
    edges.ManifoldEdgesOff()
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(edges.GetOutputPort())
    mapper.ScalarVisibilityOff()
    result = vtk.vtkActor()
    result.SetMapper(mapper)
    result.SetPosition(*shift)
    result.GetProperty().SetColor(0.16, 0.14, 0.13)
    result.GetProperty().SetLineWidth(2.2)
    result.GetProperty().LightingOff()
    return result


def add_model(renderer, grid, apart):
    """Each region as its boundary, the right side of the fault moved by `apart` along x."""
    dimension, region, material = cells(grid, "dimension"), cells(grid, "region"), cells(grid, "material")
    materials = field(grid, "MaterialNames")
    for r in sorted(set(region[dimension == 3])):
        of_region = (dimension == 3) & (region == r)
        whole = surface(grid, of_region)
        low, high = whole.GetBounds()[:2]
        shift = (apart if low + high > 240 else 0, 0, 0)
        renderer.AddActor(outlines(whole, shift))
        rock = COLOURS[materials[material[of_region][0]]]
        for colour, chosen in zip((TUNNEL, FAULT, rock), classify(grid, of_region)):
            if chosen.any():
                renderer.AddActor(actor(surface(grid, chosen), colour, shift))


def classify(grid, chosen):
    """The triangles on the tunnel, on the fault, and the others."""
    points = vtk_to_numpy(grid.GetPoints().GetData())
    tunnel, fault = numpy.zeros(len(chosen), bool), numpy.zeros(len(chosen), bool)
    start, along = numpy.array([-10.0, 76, 51]), numpy.array([260.0, 12, 7])
    along /= numpy.linalg.norm(along)
    for i in numpy.nonzero(chosen)[0]:
        ids = grid.GetCell(int(i)).GetPointIds()
        p = points[[ids.GetId(k) for k in range(3)]]
        away = p - start
        distance = numpy.linalg.norm(away - numpy.outer(away @ along, along), axis=1)
        tunnel[i] = 8.9 < distance.min() and distance.max() < 9.001
        fault[i] = numpy.abs(p[:, 0] - 96 - (p[:, 2] + 20) * 68 / 170).max() < 1e-6
    return tunnel, fault & ~tunnel, chosen & ~tunnel & ~fault


def light(renderer):
    renderer.SetBackground(1, 1, 1)
    for position, strength in (((-0.45, -1.3, 1.0), 0.85), ((1.0, -0.8, 0.6), 0.35)):
        lamp = vtk.vtkLight()
        lamp.SetLightTypeToSceneLight()
        lamp.SetPosition(*(1000 * numpy.array(position)))
        lamp.SetFocalPoint(0, 0, 0)
        lamp.SetIntensity(strength)
        renderer.AddLight(lamp)


def label(renderer, text, position, colour):
    actor_of_text = vtk.vtkBillboardTextActor3D()
    actor_of_text.SetInput(text)
    actor_of_text.SetPosition(*position)
    look = actor_of_text.GetTextProperty()
    look.SetFontSize(25)
    look.SetColor(*colour)
    look.SetJustificationToCentered()
    look.SetVerticalJustificationToCentered()
    renderer.AddActor(actor_of_text)


INK, WHITE = (0.10, 0.09, 0.09), (1, 1, 1)
LABELS = (("clay", (235, 70, 102), INK), ("marl", (60, 70, 83), INK), ("limestone", (222, 70, 38), INK),
          ("granite", (60, 70, 16), INK), ("tunnel", (60, 70, 54.5), WHITE), ("fault", (172, 100, 97), WHITE))


def save(window, path):
    """Renders the window and writes it as PNG."""
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetCompressionLevel(9)
    writer.SetFileName(path)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


def main():
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(1800, 640)
    views = (("fig10.vtu", (0, 0, 0.43, 1), 0, (-0.80, -1.35, 0.62), 1.26),
             ("section.vtu", (0.43, 0, 1, 1), 42, (-0.50, -1.5, 0.50), 1.44))
    for name, viewport, apart, direction, zoom in views:
        renderer = vtk.vtkRenderer()
        renderer.SetViewport(*viewport)
        light(renderer)
        add_model(renderer, read(OUT / name), apart)
        for text, position, colour in LABELS if apart else ():
            label(renderer, text, position, colour)
        camera = renderer.GetActiveCamera()
        camera.SetFocalPoint(120 + apart / 2, 80, 55)
        camera.SetPosition(*(numpy.array([120 + apart / 2, 80, 55]) + 400 * numpy.array(direction)))
        camera.SetViewUp(0, 0, 1)
        camera.SetViewAngle(22)
        renderer.ResetCamera()
        camera.Zoom(zoom)
        renderer.ResetCameraClippingRange()
        window.AddRenderer(renderer)
    save(window, sys.argv[1] if len(sys.argv) > 1 else str(HERE / "fig10.png"))


if __name__ == "__main__":
    main()
