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
FAULT = (0.72, 0.22, 0.18)


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


def actor(poly, colour, shift, smooth):
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputData(poly)
    normals.SetFeatureAngle(28)
    normals.ConsistencyOff()
    normals.SetSplitting(smooth)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(normals.GetOutputPort())
    mapper.ScalarVisibilityOff()
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    result = vtk.vtkActor()
    result.SetMapper(mapper)
    result.SetPosition(*shift)
    look = result.GetProperty()
    look.SetColor(*colour)
    look.SetAmbient(0.30)
    look.SetDiffuse(0.72)
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
    dimension, region, material = cells(grid, "dimension"), cells(grid, "region"), cells(grid, "material")
    front, back, leaf = cells(grid, "region_front"), cells(grid, "region_back"), cells(grid, "source_leaf")
    face_of, leaves = cells(grid, "source_face"), field(grid, "LeafNames")
    materials = field(grid, "MaterialNames")
    points = vtk_to_numpy(grid.GetPoints().GetData())
    regions = sorted(set(region[dimension == 3]))
    middle = {}
    for r in regions:
        p = vtk_to_numpy(surface(grid, (dimension == 3) & (region == r)).GetPoints().GetData())
        middle[r] = (p[:, 0].min() + p[:, 0].max()) / 2
    split = 120
    for r in regions:
        of_region = (dimension == 3) & (region == r)
        name = materials[material[of_region][0]]
        right = middle[r] > split
        shift = (apart if right else 0, 0, 0)
        # The faces of the region by what they are: a dark tunnel, a red fault, rock elsewhere.
        on = (dimension == 2) & ((front == r) | (back == r))
        kinds = classify(grid, on, r, region, front, back)
        renderer.AddActor(outlines(surface(grid, of_region), shift))
        for kind, chosen in kinds.items():
            colour = {"tunnel": TUNNEL, "fault": FAULT}.get(kind, COLOURS[name])
            if chosen.any():
                renderer.AddActor(actor(surface(grid, chosen), colour, shift, kind != "rock"))


def classify(grid, on, r, region, front, back):
    """Splits the triangles `on` a region: walls to the other side of the fault, the tunnel, the rest."""
    points = vtk_to_numpy(grid.GetPoints().GetData())
    kinds = {"tunnel": numpy.zeros(len(on), bool), "fault": numpy.zeros(len(on), bool),
             "rock": numpy.zeros(len(on), bool)}
    axis, along = numpy.array([-10.0, 76, 51]), numpy.array([260.0, 12, 7])
    along /= numpy.linalg.norm(along)
    for i in numpy.nonzero(on)[0]:
        ids = grid.GetCell(int(i)).GetPointIds()
        p = points[[ids.GetId(k) for k in range(3)]]
        away = p - axis
        distance = numpy.linalg.norm(away - numpy.outer(away @ along, along), axis=1)
        off_fault = numpy.abs(p[:, 0] - 96 - (p[:, 2] + 20) * 68 / 170)
        if distance.max() < 9.001 and distance.min() > 8.9:
            kinds["tunnel"][i] = True
        elif off_fault.max() < 1e-6:
            kinds["fault"][i] = True
        else:
            kinds["rock"][i] = True
    return kinds


def light(renderer):
    renderer.SetBackground(1, 1, 1)
    for position, strength in (((-0.5, -1.0, 1.3), 0.75), ((1.0, -0.8, 0.5), 0.35)):
        lamp = vtk.vtkLight()
        lamp.SetLightTypeToSceneLight()
        lamp.SetPosition(*(1000 * numpy.array(position)))
        lamp.SetFocalPoint(0, 0, 0)
        lamp.SetIntensity(strength)
        renderer.AddLight(lamp)


def main():
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(1800, 760)
    views = (("fig10.vtu", (0, 0, 0.44, 1), 0, (-0.62, -1.35, 0.78), 1.40),
             ("section.vtu", (0.44, 0, 1, 1), 42, (-0.42, -1.5, 0.62), 1.62))
    for name, viewport, apart, direction, zoom in views:
        renderer = vtk.vtkRenderer()
        renderer.SetViewport(*viewport)
        light(renderer)
        add_model(renderer, read(OUT / name), apart)
        camera = renderer.GetActiveCamera()
        camera.SetFocalPoint(120 + apart / 2, 80, 55)
        camera.SetPosition(*(numpy.array([120 + apart / 2, 80, 55]) + 400 * numpy.array(direction)))
        camera.SetViewUp(0, 0, 1)
        camera.SetViewAngle(22)
        renderer.ResetCamera()
        camera.Zoom(zoom)
        renderer.ResetCameraClippingRange()
        window.AddRenderer(renderer)
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetCompressionLevel(9)
    writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else str(HERE / "fig10.png"))
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


main()
