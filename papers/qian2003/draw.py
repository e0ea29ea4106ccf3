#!/usr/bin/env python3
"""Draws graded.png from the mesh of graded.yaml: the fraction of ceramic, cut open.

From the repository's root: cnrg mesh papers/qian2003/graded.yaml --node drilled -o out/qian2003-graded.vtu
--max-volume 0.002, then this script. Needs VTK for Python (python3-vtk9) and an X display or xvfb-run."""
import pathlib
import sys

import vtk

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "papers/pereira2012"))
from draw import light, read, save  # noqa: E402

FRACTION = "fraction of ceramic"


def tetrahedra(grid):
    chosen = vtk.vtkThreshold()
    chosen.SetInputData(grid)
    chosen.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_CELLS, "dimension")
    chosen.SetUpperThreshold(2.5)
    chosen.SetThresholdFunction(vtk.vtkThreshold.THRESHOLD_UPPER)
    return chosen


def crinkled(port, normal, origin):
    """The cells on the far side of a plane, whole."""
    plane = vtk.vtkPlane()
    plane.SetNormal(*normal)
    plane.SetOrigin(*origin)
    clip = vtk.vtkClipDataSet()
    clip.SetInputConnection(port)
    clip.SetClipFunction(plane)
    return clip


def actor(port, table):
    skin = vtk.vtkDataSetSurfaceFilter()
    skin.SetInputConnection(port)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(skin.GetOutputPort())
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray(FRACTION)
    mapper.SetLookupTable(table)
    mapper.SetScalarRange(0, 1)
    one = vtk.vtkActor()
    one.SetMapper(mapper)
    one.GetProperty().SetAmbient(0.45)
    one.GetProperty().SetDiffuse(0.6)
    return one


def main():
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(1200, 620)
    table = vtk.vtkColorTransferFunction()
    for at, colour in ((0, (0.24, 0.36, 0.52)), (0.5, (0.86, 0.80, 0.66)), (1, (0.80, 0.34, 0.18))):
        table.AddRGBPoint(at, *colour)
    renderer = vtk.vtkRenderer()
    renderer.SetViewport(0, 0, 0.86, 1)
    renderer.SetBackground(1, 1, 1)
    light(renderer)
    cells = tetrahedra(read(ROOT / "out/qian2003-graded.vtu"))
    half = crinkled(cells.GetOutputPort(), (0, 1, 0), (0, 2, 0))
    renderer.AddActor(actor(half.GetOutputPort(), table))
    camera = renderer.GetActiveCamera()
    camera.SetViewUp(0, 0, 1)
    camera.SetFocalPoint(3, 2, 1.5)
    camera.SetPosition(1.2, -8, 4.6)
    renderer.ResetCamera()
    camera.Zoom(1.45)
    window.AddRenderer(renderer)
    scale = vtk.vtkRenderer()
    scale.SetViewport(0.86, 0, 1, 1)
    scale.SetBackground(1, 1, 1)
    bar = vtk.vtkScalarBarActor()
    bar.SetLookupTable(table)
    bar.SetTitle("ceramic\n ")
    bar.SetNumberOfLabels(5)
    bar.SetLabelFormat("%.2f")
    bar.SetPosition(0.1, 0.12)
    bar.SetWidth(0.75)
    bar.SetHeight(0.76)
    bar.SetUnconstrainedFontSize(True)
    for text in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
        text.SetColor(0.1, 0.1, 0.1)
        text.SetFontSize(20)
        text.ShadowOff()
        text.ItalicOff()
        text.BoldOff()
    scale.AddActor2D(bar)
    window.AddRenderer(scale)
    save(window, str(pathlib.Path(__file__).with_name("graded.png")))


if __name__ == "__main__":
    main()
