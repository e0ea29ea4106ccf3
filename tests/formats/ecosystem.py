"""Files of ours in programs of others, and files of others in ours: for the room `formats`.

    ecosystem.py PROGRAM CASE FOLDER    runs a case of below with the program cnrg, in an empty folder

meshio, VTK and Gmsh read what cnrg writes; what they find is compared with what is exact. VTK writes surfaces in every
form that it has, and cnrg reads them.
"""
import json
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

import meshio
import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

PROGRAM, CASE, FOLDER = sys.argv[1], sys.argv[2], Path(sys.argv[3])

# Volume 27 in two parts, of which one is cut by a sheet that hangs in it; a wire and a point inside, others outside.
MIXED = """
cnrg: 1
materials: {granite: {color: "#998877"}, ore: {}}
nodes:
  rock:  {box: {min: [0, 0, 0], max: [3, 3, 3]}, material: granite}
  seam:  {box: {min: [1, 0, 0], max: [2, 3, 3]}, material: ore}
  flap:  {polygon: [["5/2", 1, 1], ["5/2", 2, 1], ["5/2", 2, 2], ["5/2", 1, 2]]}
  bolt:  {polyline: [["1/2", 1, 1], ["1/2", 1, 2]]}
  cable: {polyline: [[5, 0, 0], [5, 4, 0], [5, 4, 3]]}
  tip:   {points: [["1/2", 2, 2]]}
  mark:  {points: [[6, 6, 6]]}
  m:     {union: [rock, seam, flap, bolt, cable, tip, mark], dominance: right}
  wires: {union: [bolt, cable]}
  dots:  {union: [tip, mark]}
  none:  {difference: [rock, rock]}
result: m
"""
ROUND = """
cnrg: 1
nodes:
  ball: {sphere: {center: [0, 0, 0], radius: 1, segments: 16}}
  pin:  {cylinder: {from: [0, 0, -2], to: [0, 0, 2], radius: 1/3, segments: 12}}
  m:    {union: [ball, pin], dominance: right}
result: m
"""
GRADED = """
cnrg: 1
materials:
  steel: {}
  ceramic: {}
  mixed: {linear: {from: [0, 0, 0], to: [4, 0, 0], stops: [[0, steel], [1, ceramic]]}}
nodes:
  bar: {box: {min: [0, 0, 0], max: [4, 1, 1]}, material: mixed}
result: bar
"""
GAP = """
cnrg: 1
nodes:
  low:   {box: {min: [0, 0, 0], max: [1, 1, 1]}}
  high:  {box: {min: [0, 0, 1.00000000000000001], max: [1, 1, 2]}}
  model: {union: [low, high]}
result: model
"""


def run(*words, status=0):
    ended = subprocess.run([PROGRAM, *words], cwd=FOLDER, capture_output=True, text=True)
    assert ended.returncode == status, (words, ended.returncode, ended.stderr)
    return ended


def tree(name, text):
    (FOLDER / name).write_text(text)
    return name


def close(found, exact):
    assert abs(found - exact) <= 1e-12 * max(1, abs(exact)), (found, exact)


# What is measured: the points of simplices, one row each.
def lengths(p):
    return np.linalg.norm(p[:, 1] - p[:, 0], axis=1)


def areas(p):
    return np.linalg.norm(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1) / 2


def volumes(p):
    """Signed ones of tetrahedra."""
    a, b, c = (p[:, k] - p[:, 0] for k in (1, 2, 3))
    return np.einsum("ij,ij->i", a, np.cross(b, c)) / 6


def enclosed(p):
    """By closed surfaces of triangles."""
    return np.einsum("ij,ij->i", p[:, 0], np.cross(p[:, 1], p[:, 2])).sum() / 6


def second_order_volume(p):
    """Of tetrahedra of ten nodes: their Jacobian is of third degree, for which five places are enough."""
    places = [((1 / 4,) * 4, -4 / 5)] + [(tuple(1 / 2 if i == k else 1 / 6 for i in range(4)), 9 / 20) for k in range(4)]
    edges = ((0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3))
    total = 0
    for at, weight in places:
        slopes = np.zeros((4, 10))  # of each node's function by each barycentric coordinate
        for i in range(4):
            slopes[i, i] = 4 * at[i] - 1
        for n, (i, j) in enumerate(edges):
            slopes[i, 4 + n], slopes[j, 4 + n] = 4 * at[j], 4 * at[i]
        d = np.einsum("kn,tnx->tkx", slopes, p)
        total += weight * np.linalg.det(d[:, 1:] - d[:, :1]).sum() / 6
    return total


class Grid:
    """A .vtu as meshio and VTK find it, which must be the same."""

    KINDS = {1: "vertex", 3: "line", 5: "triangle", 10: "tetra", 21: "line3", 22: "triangle6", 24: "tetra10"}

    def __init__(self, name):
        self.mesh = meshio.read(FOLDER / name)
        reader = vtk.vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(FOLDER / name))
        faults = []
        reader.AddObserver("ErrorEvent", lambda *_: faults.append(name))
        reader.Update()
        assert not faults, faults
        self.grid = grid = reader.GetOutput()
        by_kind = {}
        for kind in (grid.GetCellType(i) for i in range(grid.GetNumberOfCells())):
            by_kind[kind] = by_kind.get(kind, 0) + 1
        self.counts = {self.KINDS[kind]: n for kind, n in by_kind.items() if kind != 2}
        found = {}
        for block in self.mesh.cells:
            found[block.type] = found.get(block.type, 0) + len(block)
        assert found == self.counts, (found, self.counts)
        assert len(self.mesh.points) == grid.GetNumberOfPoints()
        data, fields = grid.GetCellData(), grid.GetFieldData()
        if self.mesh.cells:
            for key, blocks in self.mesh.cell_data.items():
                np.testing.assert_array_equal(np.concatenate(blocks), vtk_to_numpy(data.GetArray(key)))
        assert set(self.mesh.field_data) == {fields.GetArrayName(i) for i in range(fields.GetNumberOfArrays())}
        for key, numbers in self.mesh.field_data.items():
            np.testing.assert_array_equal(numbers, vtk_to_numpy(fields.GetArray(key)))

    def select(self, kind, **wanted):
        """Points of the cells of a kind with these tags; a name stands for its numbers."""
        chosen = []
        for i, block in enumerate(self.mesh.cells):
            if block.type != kind:
                continue
            keep = np.ones(len(block), bool)
            for key, value in wanted.items():
                numbers = self.mesh.field_data[f"{key} {value}"] if isinstance(value, str) else [value]
                keep &= np.isin(self.mesh.cell_data[key][i], numbers)
            chosen.append(self.mesh.points[block.data[keep]])
        return np.concatenate(chosen)


class Msh:
    """A .msh as meshio finds it; every element is in a group, and Gmsh finds as many."""

    def __init__(self, name):
        self.mesh = self.read(name)
        ended = subprocess.run(["gmsh", name, "-save", "-o", "again.msh"], cwd=FOLDER, capture_output=True, text=True)
        assert ended.returncode == 0 and "Error" not in ended.stdout + ended.stderr, ended.stdout + ended.stderr
        again = self.read("again.msh")
        assert self.count(again) == self.count(self.mesh), (self.count(again), self.count(self.mesh))
        assert set(again.field_data) == set(self.mesh.field_data)

    @staticmethod
    def read(name):
        mesh = meshio.read(FOLDER / name)
        groups = mesh.cell_data["gmsh:physical"]
        assert [len(g) for g in groups] == [len(block) for block in mesh.cells]
        return mesh

    @staticmethod
    def count(mesh):
        found = {}
        for block in mesh.cells:
            found[block.type] = found.get(block.type, 0) + len(block)
        return found

    def select(self, kind, group):
        tag, _ = self.mesh.field_data[group]
        rows = self.mesh.cell_sets[group]
        return np.concatenate([self.mesh.points[block.data[rows[i]]] for i, block in enumerate(self.mesh.cells)
                               if block.type == kind])


def check_mixed(grid):
    """What both kinds of .vtu of MIXED have below dimension 3."""
    close(areas(grid.select("triangle", dimension=2, regions_bounded=2)).sum(), 18)
    close(areas(grid.select("triangle", dimension=2, regions_bounded=0)).sum(), 1)
    close(areas(grid.select("triangle", dimension=2, source_leaf="flap")).sum(), 1)
    close(lengths(grid.select("line", source_leaf="cable")).sum(), 7)
    close(lengths(grid.select("line", source_leaf="bolt")).sum(), 1)


def written():
    """Regions, walls, sheets, wires and points, by their names."""
    name = tree("m.yaml", MIXED)
    run("eval", name, "--quiet", "-o", "m.vtu", "-o", "m.msh", "--node", "m")
    grid, msh = Grid("m.vtu"), Msh("m.msh")
    check_mixed(grid)
    for region, volume in (("rock", 18), ("seam", 9)):
        close(enclosed(grid.select("triangle", dimension=3, region=region)), volume)
    close(enclosed(grid.select("triangle", dimension=3, material="granite")), 18)
    close(areas(msh.select("triangle", "wall rock 1 | seam")).sum(), 9)
    close(areas(msh.select("triangle", "wall seam | rock 3")).sum(), 9)
    close(areas(msh.select("triangle", "face of flap")).sum(), 1)
    close(lengths(msh.select("line", "wire of cable")).sum(), 7)
    assert msh.select("vertex", "point of mark").tolist() == [[[6, 6, 6]]]
    run("mesh", name, "--quiet", "-o", "t.vtu", "-o", "t.msh")
    grid, msh = Grid("t.vtu"), Msh("t.msh")
    check_mixed(grid)
    for region, volume in (("rock", 18), ("seam", 9)):
        close(volumes(grid.select("tetra", region=region)).sum(), volume)
    close(volumes(grid.select("tetra", material="ore")).sum(), 9)
    close(volumes(msh.select("tetra", "seam")).sum(), 9)
    close(volumes(msh.select("tetra", "material granite")).sum(), 18)
    close(areas(msh.select("triangle", "from seam")).sum(), areas(msh.select("triangle", "boundary of seam")).sum() + 18)
    assert msh.count(msh.mesh) == grid.counts


def little():
    """Results with only wires, only points, only a sheet, and with nothing; raw cells; open sets."""
    name = tree("m.yaml", MIXED)
    for node, counts in (("wires", {"vertex": 5, "line": 3}), ("dots", {"vertex": 2}),
                         ("flap", {"vertex": 4, "line": 4, "triangle": 2})):
        run("eval", name, "--quiet", "--node", node, "-o", "n.vtu", "-o", "n.msh")
        assert Grid("n.vtu").counts == counts
        msh = Msh("n.msh")
        assert msh.count(msh.mesh) == counts
    run("eval", name, "--quiet", "--node", "none", "-o", "n.vtu")
    assert Grid("n.vtu").counts == {}
    assert "readers refuse" in run("eval", name, "--quiet", "--node", "none", "-o", "none.msh", status=2).stderr
    run("eval", name, "--quiet", "--raw", "-o", "n.vtu", "-o", "n.msh")
    grid, msh = Grid("n.vtu"), Msh("n.msh")
    check_mixed(grid)
    close(enclosed(grid.select("triangle", dimension=3, region="seam")), 9)
    close(areas(msh.select("triangle", "face of flap")).sum(), 1)
    name = tree("open.yaml", "cnrg: 1\nnodes:\n  a: {box: {min: [0, 0, 0], max: [2, 1, 1]}}\n"
                             "  i: {interior: a}\nresult: i\n")
    run("eval", name, "--quiet", "-o", "n.vtu")
    close(enclosed(Grid("n.vtu").select("triangle", dimension=3)), 2)


def curved():
    """Elements of second order, parameters of patches, graded materials."""
    name = tree("r.yaml", ROUND)
    table = run("mesh", name, "--curved", "-o", "c.vtu", "-o", "c.msh").stdout
    volume = {row.split()[0]: float(row.split()[-1]) for row in table.splitlines()[1:] if len(row.split()) == 8}
    grid, msh = Grid("c.vtu"), Msh("c.msh")
    assert set(grid.counts) == {"line3", "triangle6", "tetra10"} and msh.count(msh.mesh) == grid.counts
    for region in ("ball", "pin"):
        for found in (grid.select("tetra10", region=region), msh.select("tetra10", region)):
            assert abs(second_order_volume(found) - volume[region]) < 1e-9, (region, volume)
    run("eval", name, "--quiet", "--parameters", "-o", "p.vtu")
    grid = Grid("p.vtu")
    assert {"patch ball: sphere", "patch pin: cylinder side"} <= set(grid.mesh.field_data)
    assert np.isfinite(grid.mesh.point_data["parameters"]).all(axis=1).any()
    side = grid.select("triangle", dimension=2, patch="pin: cylinder side")
    assert len(side) > 0 and np.allclose(np.linalg.norm(side[:, :, :2], axis=2), 1 / 3)
    name = tree("g.yaml", GRADED)
    run("eval", name, "--quiet", "-o", "g.vtu")
    run("mesh", name, "--quiet", "--max-volume", "0.1", "-o", "t.vtu", "-o", "t.msh")
    Grid("g.vtu"), Msh("t.msh")
    grid = Grid("t.vtu")
    for i, block in enumerate(grid.mesh.cells):
        if block.type == "tetra":
            middle = grid.mesh.points[block.data].mean(axis=1)[:, 0] / 4
            assert np.allclose(grid.mesh.cell_data["fraction of ceramic"][i], middle)


def names():
    """Names that are quoted, long, of any script, equal, or end in what escapes."""
    long = "l" * 300
    words = ["a \"good\" <rock> & more", "back\\", "two\\\\strokes", long, long[:-1] + "m", "Ö — 岩", "wire of x", "edges",
             "it's", "line\nend", "$End"]
    nodes = {f"b{i}": {"box": {"min": [2 * i, 0, 0], "max": [2 * i + 1, 1, 1]}, "name": word}
             for i, word in enumerate(words)}
    name = tree("n.yaml", json.dumps({"cnrg": 1, "nodes": {**nodes, "m": {"union": list(nodes)}}, "result": "m"}))
    run("eval", name, "--quiet", "-o", "n.vtu", "-o", "n.msh")
    run("mesh", name, "--quiet", "-o", "t.vtu", "-o", "t.msh")
    for msh in (Msh("n.msh"), Msh("t.msh")):
        groups = [key for key, (_, dimension) in msh.mesh.field_data.items() if dimension == 3]
        assert len(groups) == len(words), groups
    for group in groups:
        close(volumes(msh.select("tetra", group)).sum(), 1)
    for grid in (Grid("n.vtu"), Grid("t.vtu")):
        shown = {key for key in grid.mesh.field_data if key.startswith("region ")}
        assert shown == {"region " + word.replace("\n", "\\n") for word in words} | {"region entities"}, shown
    close(volumes(grid.select("tetra", region=words[0])).sum(), 1)


def snapped():
    """Where rounding breaks a result, files hold the snapped one: two boxes with a gap that doubles cannot hold."""
    name = tree("gap.yaml", GAP)
    ended = run("eval", name, "-o", "g.vtu", "-o", "g.msh")
    assert ended.stderr.count("notice: snapped") == 2, ended.stderr
    for file in (Grid("g.vtu"), Msh("g.msh")):
        assert file.mesh.points.shape == (12, 3)
    close(areas(Grid("g.vtu").select("triangle", dimension=2, regions_bounded=2)).sum(), 1)
    run("eval", name, "--no-snap", "-o", "g.vtu", "-o", "g.msh")
    assert len(Grid("g.vtu").mesh.points) == len(Msh("g.msh").mesh.points) == 16


def volume_of(file, options=""):
    """Of the mesh in a file, exactly, and what its leaf has."""
    name = tree("read.yaml", f"cnrg: 1\nnodes: {{m: {{mesh: {{file: {file}{options}}}}}}}\nresult: m\n")
    run("eval", name, "--quiet", "-o", "read.json")
    result = json.loads((FOLDER / "read.json").read_text())
    volume = sum(Fraction(r["volume"]) for r in result["regions"] if r["component"] and r["volume"])
    return volume, result


def box():
    """Of six squares."""
    cube = vtk.vtkCubeSource()
    cube.SetBounds(0, 2, 0, 1, 0, 1)
    clean = vtk.vtkCleanPolyData()
    clean.SetInputConnection(cube.GetOutputPort())
    clean.Update()
    data = vtk.vtkPolyData()
    data.DeepCopy(clean.GetOutput())
    data.GetPointData().Initialize()
    return data


def every_form(data, case):
    """The file in every form that VTK writes it in."""
    for version in (42, 51):
        for form in (1, 2):
            writer = vtk.vtkPolyDataWriter()
            writer.SetFileVersion(version)
            writer.SetFileType(form)
            yield writer, f"{case}-{version}-{form}.vtk"
    for mode in range(3):
        for order in range(2):
            for header in (32, 64):
                for packed in (False, True):
                    for base64 in (True, False):
                        writer = vtk.vtkXMLPolyDataWriter()
                        writer.SetDataMode(mode)
                        writer.SetByteOrder(order)
                        writer.SetHeaderType(header)
                        writer.SetEncodeAppendedData(base64)
                        writer.SetBlockSize(64)
                        if not packed:
                            writer.SetCompressorTypeToNone()
                        yield writer, f"{case}-{mode}{order}{header}{packed:d}{base64:d}.vtp"


def read():
    """Surfaces that VTK writes, in every form: polygons, strips, lines, points, labels, arrays of every type."""
    data = box()
    sides = data.GetNumberOfPolys()
    strips = vtk.vtkStripper()
    triangles = vtk.vtkTriangleFilter()
    triangles.SetInputData(data)
    strips.SetInputConnection(triangles.GetOutputPort())
    strips.Update()
    stripped = vtk.vtkPolyData()
    stripped.DeepCopy(strips.GetOutput())
    assert stripped.GetNumberOfStrips() > 0
    rich = vtk.vtkPolyData()
    rich.DeepCopy(data)
    points = vtk.vtkPoints()
    points.SetDataTypeToDouble()
    for i in range(rich.GetNumberOfPoints()):
        points.InsertNextPoint(rich.GetPoint(i))
    ends = [points.InsertNextPoint(*p) for p in ((5, 0, 0), (5, 1, 0), (5, 1, 1 / 3))]
    alone = points.InsertNextPoint(7, 7, 7)
    rich.SetPoints(points)
    lines, verts = vtk.vtkCellArray(), vtk.vtkCellArray()
    lines.InsertNextCell(3)
    for p in ends:
        lines.InsertCellPoint(p)
    verts.InsertNextCell(1)
    verts.InsertCellPoint(alone)
    rich.SetLines(lines)
    rich.SetVerts(verts)
    n = rich.GetNumberOfCells()
    for array, name, components in ((vtk.vtkFloatArray(), "normals of it", 3), (vtk.vtkUnsignedCharArray(), "color", 4),
                                    (vtk.vtkBitArray(), "flag", 1), (vtk.vtkIdTypeArray(), "patch", 1)):
        array.SetName(name)
        array.SetNumberOfComponents(components)
        if components == 3:
            array.SetComponentName(0, "x of it")
        array.SetNumberOfTuples(n)
        for i in range(n):
            for k in range(components):
                array.SetComponent(i, k, i % 2)
        rich.GetCellData().AddArray(array)
    strings = vtk.vtkStringArray()
    strings.SetName("words of it")
    for word in ("", "one two", "long " * 40):
        strings.InsertNextValue(word)
    rich.GetFieldData().AddArray(strings)
    rich.GetCellData().SetScalars(rich.GetCellData().GetArray("color"))
    files = 0
    for model, case in ((data, "plain"), (stripped, "strips"), (rich, "rich")):
        for writer, name in every_form(model, case):
            writer.SetInputData(model)
            writer.SetFileName(str(FOLDER / name))
            assert writer.Write() == 1
            volume, result = volume_of(name)
            assert volume == 2, (name, volume)
            assert len(result["faces"]) == sides, (name, len(result["faces"]))
            if case == "rich":
                assert sum(e["wire"] for e in result["edges"]) == 2, name
                assert ["7", "7", "7"] in result["points"], name
            files += 1
    assert files == 3 * (4 + 48)


def labelled():
    """Coplanar faces with different labels stay two faces; a grid of flat cells is a surface, too."""
    tree("flat.vtk", """# vtk DataFile Version 3.0
two triangles, a square, a pixel, a strip, a line and a point
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 12 float
0 0 0 1 0 0 1 1 0 0 1 0
2 0 0 2 1 0 3 0 0 3 1 0
4 0 0 4 1 0 9 9 9 8 8 8
CELLS 7 28
3 0 1 2
3 0 2 3
4 1 4 5 2
4 4 6 5 7
4 6 8 7 9
2 10 11
1 10
CELL_TYPES 7
5 5 9 8 6 3 1
CELL_DATA 7
SCALARS label int 1
LOOKUP_TABLE default
4 4 4 9 9 0 0
""")
    volume, result = volume_of("flat.vtk", ", fill: none")
    assert volume == 0
    assert len(result["faces"]) == 2, len(result["faces"])
    assert sum(e["wire"] for e in result["edges"]) == 1


{"written": written, "little": little, "curved": curved, "names": names, "snapped": snapped, "read": read,
 "labelled": labelled}[CASE]()
