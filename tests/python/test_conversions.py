"""Results for other packages, tetrahedra, pictures and pages."""
import os
import subprocess
import sys
import tempfile
import types
import unittest
from fractions import Fraction
from pathlib import Path

import numpy

import cnrg
from test_said import BOLTS
from test_results import HALF, MIXED, OPEN, ROUND, SLOPE, result_of

try:
    import meshio
except ImportError:
    meshio = None
try:
    from vtkmodules.util import numpy_support
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
except ImportError:
    numpy_support = None

LAYERS = """cnrg: 1
materials: {rock: {}, clay: {}}
nodes:
  low:   {box: {min: [0, 0, 0], max: [2, 2, 1]}, material: clay}
  high:  {box: {min: [0, 0, 1], max: [2, 2, 2]}, material: rock}
  bolt:  {polyline: [[1, 1, 1/2], [1, 1, 3/2]]}
  model: {union: [bolt, high, low], dominance: left}
result: model
"""


class WithFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)


def volume_of(points, triangles):
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return float((a * numpy.cross(b, c)).sum() / 6)


@unittest.skipIf(meshio is None, "meshio is not installed (Debian: python3-meshio)")
class Meshio(WithFolder):
    def test_a_surface_has_all_cells_and_their_numbers(self):
        for text in (SLOPE, ROUND, MIXED, OPEN):
            result = result_of(text)
            mesh = result.to_meshio()
            blocks = {block.type: (block.data, {name: data[i] for name, data in mesh.cell_data.items()})
                      for i, block in enumerate(mesh.cells)}
            self.assertTrue((mesh.points == result.points).all())
            for kind, cells in (("vertex", result.vertices), ("line", result.edges), ("triangle", result.faces)):
                numbers = blocks[kind][1]["cell"] if kind in blocks else []
                self.assertEqual(sorted(set(numbers)), cells.active.tolist())
                self.assertEqual(blocks[kind][1]["component"].tolist(), cells.component[numbers].tolist())
            triangles, data = blocks["triangle"]
            for i in result.faces.active:
                self.assertEqual(triangles[data["cell"] == i].tolist(), result.faces.triangles[i].tolist())
            lines, data = blocks["line"]
            for i in result.edges.active:
                chain = result.edges.points[i].tolist()
                chain += chain[:1] if result.edges.closed[i] else []
                self.assertEqual(lines[data["cell"] == i].tolist(), [list(pair) for pair in zip(chain, chain[1:])])

    def test_groups_are_sets_and_tags(self):
        mesh = result_of(LAYERS).to_meshio()
        self.assertIn("wall low | high", mesh.cell_sets)
        kinds = [block.type for block in mesh.cells]
        wall = mesh.cell_sets["wall low | high"][kinds.index("triangle")]
        self.assertTrue((mesh.points[mesh.cells[kinds.index("triangle")].data[wall]][:, :, 2] == 1).all())
        number, dimension = mesh.field_data["wall low | high"]
        self.assertEqual(dimension, 2)
        self.assertEqual(set(mesh.cell_data["gmsh:physical"][kinds.index("triangle")][wall]), {number})

    def test_files_of_meshio_hold_the_same(self):
        mesh = result_of(LAYERS).tetrahedralize().to_meshio()
        mesh.write(self.folder / "a.vtu")
        back = meshio.read(self.folder / "a.vtu")
        self.assertTrue((back.points == mesh.points).all())
        self.assertEqual([(b.type, len(b.data)) for b in back.cells], [(b.type, len(b.data)) for b in mesh.cells])
        for name in ("component", "region", "cell"):
            self.assertEqual([d.tolist() for d in back.cell_data[name]], [d.tolist() for d in mesh.cell_data[name]])
        for name in set(mesh.cell_data) - {"gmsh:physical", "gmsh:geometrical"}:
            del mesh.cell_data[name]  # meshio 7.0 writes it and cannot read it back
        meshio.write(self.folder / "a.msh", mesh, file_format="gmsh22")
        back = meshio.read(self.folder / "a.msh", file_format="gmsh")
        self.assertEqual(back.field_data["boundary of high"].tolist(), mesh.field_data["boundary of high"].tolist())
        self.assertEqual([(b.type, len(b.data)) for b in back.cells], [(b.type, len(b.data)) for b in mesh.cells])
        for name in ("gmsh:physical", "gmsh:geometrical"):
            self.assertEqual([d.tolist() for d in back.cell_data[name]], [d.tolist() for d in mesh.cell_data[name]])

    def test_what_reaches_infinity_is_no_mesh(self):
        with self.assertRaisesRegex(cnrg.InputError, "box"):
            result_of(HALF).to_meshio()


@unittest.skipIf(numpy_support is None, "vtk is not installed (Debian: python3-vtk9)")
class Vtk(WithFolder):
    def arrays(self, grid):
        data = grid.GetCellData()
        return {data.GetArrayName(i): numpy_support.vtk_to_numpy(data.GetArray(i)) for i in range(data.GetNumberOfArrays())}

    def read(self, path):
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(path))
        reader.Update()
        return reader.GetOutput()

    def assert_same(self, grid, other):
        self.assertEqual(grid.GetNumberOfPoints(), other.GetNumberOfPoints())
        self.assertTrue((numpy_support.vtk_to_numpy(grid.GetPoints().GetData())
                         == numpy_support.vtk_to_numpy(other.GetPoints().GetData())).all())
        self.assertEqual(grid.GetNumberOfCells(), other.GetNumberOfCells())
        own, read = self.arrays(grid), self.arrays(other)
        for name in own:
            if name != "source_leaf":  # places in two lists of leaves
                numpy.testing.assert_array_equal(own[name], read[name], name)  # a NaN is equal to a NaN
        for i in range(grid.GetNumberOfCells()):
            self.assertEqual(grid.GetCellType(i), other.GetCellType(i))
            a, b = grid.GetCell(i).GetPointIds(), other.GetCell(i).GetPointIds()
            a, b = ([ids.GetId(k) for k in range(ids.GetNumberOfIds())] for ids in (a, b))
            if grid.GetCellType(i) == 5:  # whichever corner is first
                a, b = (ids[ids.index(min(ids)):] + ids[: ids.index(min(ids))] for ids in (a, b))
            self.assertEqual(a, b)

    def test_a_grid_is_what_a_file_holds(self):
        for text in (SLOPE, ROUND, MIXED, OPEN, BOLTS):
            result = result_of(text)
            result.write(self.folder / "a.vtu")
            self.assert_same(result.to_vtk(), self.read(self.folder / "a.vtu"))

    def test_tetrahedra_are_what_a_file_holds(self):
        for text, curved in ((LAYERS, False), (BOLTS, False),
                             (ROUND.replace("[ball, ring, {difference: [block, bore]}]", "[ball, block]"), True)):
            mesh = result_of(text).tetrahedralize(curved=curved)
            mesh.write(self.folder / "a.vtu")
            self.assert_same(mesh.to_vtk(), self.read(self.folder / "a.vtu"))

    def test_a_file_says_no_more_of_cells(self):
        result = result_of(BOLTS)
        for made in (result, result.tetrahedralize()):
            made.write(self.folder / "a.vtu")
            more = set(self.arrays(self.read(self.folder / "a.vtu"))) - set(self.arrays(made.to_vtk()))
            self.assertLessEqual(more, {"regions_bounded"})  # which tetrahedra in Python never had
            texts = made.to_vtk().GetFieldData().GetAbstractArray("section texts")
            self.assertEqual([texts.GetValue(i) for i in range(texts.GetNumberOfValues())], ["", "round"])

    def test_a_grid_has_names(self):
        fields = result_of(SLOPE).to_vtk().GetFieldData()
        names = fields.GetAbstractArray("RegionNames")
        self.assertEqual([names.GetValue(i) for i in range(names.GetNumberOfValues())], ["outside", "ground", "ground", "entities"])


class Trimesh(unittest.TestCase):
    """By duck typing: what stands for the package keeps what it is given."""

    def setUp(self):
        module = types.ModuleType("trimesh")

        class Trimesh:
            def __init__(self, vertices, faces, process=True):
                self.vertices, self.faces, self.process = vertices, faces, process

        module.Trimesh = Trimesh
        self.addCleanup(sys.modules.update if "trimesh" in sys.modules else sys.modules.pop, *(
            ({"trimesh": sys.modules["trimesh"]},) if "trimesh" in sys.modules else ("trimesh", None)))
        sys.modules["trimesh"] = module

    def test_regions_are_closed_and_turned_outward(self):
        result = result_of(SLOPE)
        for i in result.regions.active:
            mesh = result.to_trimesh(int(i))
            self.assertAlmostEqual(volume_of(mesh.vertices, mesh.faces), float(result.regions.volume(i)), places=6)
            edges = sorted((int(f[k]), int(f[(k + 1) % 3])) for f in mesh.faces for k in range(3))
            self.assertEqual(edges, sorted((b, a) for a, b in edges))
        self.assertFalse(mesh.process)

    def test_a_trimesh_by_name_and_as_a_whole(self):
        result = result_of(LAYERS)
        high = result.to_trimesh("high")
        self.assertEqual(high.vertices[:, 2].min(), 1)
        self.assertEqual(len(result.to_trimesh().faces), len(result.faces.triangles.values))
        for wrong in ("none", 7, "entities"):
            with self.assertRaises(cnrg.InputError):
                result.to_trimesh(wrong)
        with self.assertRaisesRegex(cnrg.InputError, "several"):
            result_of(SLOPE).to_trimesh("ground")


class Missing(unittest.TestCase):
    def test_a_package_that_is_missing_is_named(self):
        result = result_of(LAYERS)
        for method, module, package in (("to_meshio", "meshio", "meshio"), ("to_trimesh", "trimesh", "trimesh"),
                                        ("to_vtk", "vtkmodules.vtkCommonCore", "vtk")):
            held = sys.modules.get(module)
            sys.modules[module] = None
            try:
                with self.assertRaisesRegex(ImportError, f"pip install {package}"):
                    getattr(result, method)()
            finally:
                del sys.modules[module]
                if held is not None:
                    sys.modules[module] = held


class Tetrahedra(WithFolder):
    def volumes(self, mesh):
        """Of all tetrahedra of each region, exactly."""
        out = {}
        corners = [tuple(Fraction(float(x)) for x in p) for p in mesh.points]
        for points, component in zip(mesh.tetrahedra.points.tolist(), mesh.tetrahedra.component.tolist()):
            a, b, c, d = (corners[p] for p in points)
            u, v, w = (tuple(q[k] - a[k] for k in range(3)) for q in (b, c, d))
            six = (u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0]))
            self.assertGreater(six, 0)
            out[component] = out.get(component, 0) + six / 6
        return out

    def test_tetrahedra_have_volumes_and_cells(self):
        result = result_of(LAYERS)
        mesh = result.tetrahedralize(max_volume="1/20", quality=1.4)
        self.assertEqual(self.volumes(mesh), {c.number: c.volume for c in result.components[:2]})
        self.assertEqual([(r.name, r.volume) for r in mesh.regions], [("low", 4), ("high", 4)])
        self.assertEqual(sum(r.tetrahedra for r in mesh.regions), len(mesh.tetrahedra))
        for i in range(4):
            of = (mesh.vertices, mesh.segments, mesh.triangles, mesh.tetrahedra)[i]
            self.assertEqual(of.points.shape, (len(of), i + 1))
            self.assertEqual(of.points.dtype, numpy.int32)
        # Each face is covered by its triangles, each edge by its segments.
        p = mesh.points[mesh.triangles.points]
        areas = numpy.linalg.norm(numpy.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1) / 2
        for i in result.faces.active:
            self.assertAlmostEqual(areas[mesh.triangles.cell == i].sum(), result.faces.areas[i], places=12)
        p = mesh.points[mesh.segments.points]
        lengths = numpy.linalg.norm(p[:, 1] - p[:, 0], axis=1)
        for i in result.edges.active:
            self.assertAlmostEqual(lengths[mesh.segments.cell == i].sum(), result.edges.lengths[i], places=12)
        self.assertEqual(mesh.groups[3].keys() >= {"high", "low", "material rock", "material clay"}, True)
        wall = mesh.groups[2]["wall low | high"]
        on = numpy.isin(mesh.triangles.cell, wall)
        self.assertEqual({(a, b) for a, b in zip(mesh.triangles.region_front[on], mesh.triangles.region_back[on])} <= {(1, 2), (2, 1)}, True)
        self.assertTrue((mesh.points[mesh.triangles.points[on]][:, :, 2] == 1).all())

    def test_nothing_is_added_to_a_kept_boundary(self):
        result = cnrg.box([0, 0, 0], [1, 1, 1]).evaluate()
        mesh = result.tetrahedralize(keep_boundary=True, quality=1.2)
        on = ((mesh.points == 0) | (mesh.points == 1)).any(axis=1)
        self.assertEqual(on.sum(), 8)

    def test_where_tetgen_fails_there_are_constrained_tetrahedra(self):
        thin = cnrg.tetrahedron([0.4, 0.5, 1.5], [1.5, 0.6, 1.5], [1.4, 1.5, 1.5], [0.5, 1.4, 1.500000000000001])
        result = cnrg.union(thin, cnrg.box([0, 0, 0], [2, 2, 2]), dominance="left").evaluate()
        with self.assertWarnsRegex(cnrg.Notice, "TetGen .*constrained tetrahedra"):
            mesh = result.tetrahedralize()
        self.assertAlmostEqual(float(sum(region.volume for region in mesh.regions)), 8, places=12)

    def test_curved_elements_bend(self):
        ball = cnrg.sphere([0, 0, 0], 1, segments=16).evaluate()
        mesh = ball.tetrahedralize(curved=True)
        self.assertTrue(mesh.curved)
        self.assertEqual(mesh.tetrahedra.points.shape[1], 10)
        self.assertAlmostEqual(float(mesh.regions[0].volume), 4.18879, places=3)
        a, b, middle = mesh.points[mesh.triangles.points[:, [0, 1, 3]]].transpose(1, 0, 2)
        on = numpy.abs(numpy.linalg.norm(middle, axis=1) - 1) < 1e-9
        self.assertGreater(on.mean(), 0.9)
        hot = cnrg.sphere([0, 0, 0], 1, segments=16, attributes={"temperature": 20}).evaluate()
        hot.tetrahedralize(curved=True).write(self.folder / "hot.msh")
        text = (self.folder / "hot.msh").read_text()
        self.assertEqual((text.count('"temperature"'), text.count('"temperature (2)"')), (1, 0))

    def test_surface_meshes(self):
        result = result_of(LAYERS)
        for quads in (False, True):
            mesh = result.mesh_surface(size="1/4", quads=quads)
            self.assertEqual(mesh.points.dtype, numpy.float64)
            self.assertEqual(mesh.triangles.points.shape, (len(mesh.triangles), 3))
            self.assertEqual(mesh.quads.points.shape, (len(mesh.quads), 4))
            self.assertEqual(len(mesh.quads) > len(mesh.triangles), quads)
            cells = numpy.concatenate([mesh.triangles.cell, mesh.quads.cell, mesh.quads.cell])
            corners = numpy.concatenate([mesh.triangles.points, mesh.quads.points[:, :3], mesh.quads.points[:, [0, 2, 3]]])
            p = mesh.points[corners]
            areas = numpy.linalg.norm(numpy.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1) / 2
            for i in result.faces.active:
                self.assertAlmostEqual(areas[cells == i].sum(), result.faces.areas[i], places=12)
            self.assertEqual(sum(of.triangles for of in mesh.faces), len(mesh.triangles))
            self.assertEqual(sum(of.quads for of in mesh.faces), len(mesh.quads))
            self.assertIn("wall low | high", mesh.groups[2])
            with self.assertRaises(ValueError):
                mesh.quads.points[:] = 0
            mesh.write(self.folder / "s.msh")
            self.assertGreater((self.folder / "s.msh").stat().st_size, 1000)
        with self.assertRaisesRegex(cnrg.InputError, "take triangles only"):
            mesh.write(self.folder / "s.h5m")
        boundary = result.mesh_surface(size="1/4")
        filled = result.tetrahedralize(size="1/4", surface_first=True)
        self.assertEqual(sorted(map(tuple, filled.points[filled.triangles.points].mean(axis=1).round(9).tolist())),
                         sorted(map(tuple, boundary.points[boundary.triangles.points].mean(axis=1).round(9).tolist())))
        self.assertEqual(result.mesh_surface(order=2).triangles.points.shape[1], 6)
        for wrong in ({"order": 3}, {"size": -1}, {"growth": 9}, {"seconds": -1}, {"max_points": 0},
                      {"order": 2, "quads": True}, {"size": "1/1000", "max_points": 50}):
            with self.assertRaises(cnrg.InputError):
                result.mesh_surface(**wrong)

    def test_straight_elements_of_second_order(self):
        result = result_of(LAYERS)
        mesh, first = result.tetrahedralize(order=2), result.tetrahedralize()
        self.assertEqual([of.points.shape[1] for of in (mesh.segments, mesh.triangles, mesh.tetrahedra)], [3, 6, 10])
        numpy.testing.assert_array_equal(mesh.tetrahedra.points[:, :4], first.tetrahedra.points)
        for k, (i, j) in enumerate(((0, 1), (1, 2), (0, 2), (0, 3), (2, 3), (1, 3))):
            a, b, middle = mesh.points[mesh.tetrahedra.points[:, [i, j, 4 + k]]].transpose(1, 0, 2)
            numpy.testing.assert_allclose(middle, (a + b) / 2, atol=1e-12)
        self.assertEqual(first.regions, mesh.regions)
        mesh.write(self.folder / "a.vtu")
        with self.assertRaisesRegex(cnrg.InputError, "first order only"):
            mesh.write(self.folder / "a.mesh")

    def test_tetrahedra_are_written(self):
        mesh = result_of(LAYERS).tetrahedralize()
        for name in ("a.msh", "a.mesh", "a.vtu"):
            mesh.write(self.folder / name)
            self.assertGreater((self.folder / name).stat().st_size, 1000)
        with self.assertRaises(cnrg.InputError):
            mesh.write(self.folder / "a.stl")
        with self.assertRaises(cnrg.FileError):
            mesh.write(self.folder / "no" / "a.msh")

    def test_arrays_outlive_the_mesh(self):
        points = result_of(LAYERS).tetrahedralize().points
        copy = points.copy()
        result_of(LAYERS).tetrahedralize(max_volume=0.01)
        self.assertTrue((points == copy).all())
        with self.assertRaises(ValueError):
            points[0] = 0

    def test_sizes_of_nodes_and_of_the_mesh(self):
        box = cnrg.box([0, 0, 0], [4, 4, 4])
        fine = box.with_(size=0.5)
        self.assertIn("size: 0.5", fine.to_yaml())
        self.assertEqual(cnrg.parse(fine.to_yaml()).result.to_yaml(), fine.to_yaml())
        plain = box.evaluate().tetrahedralize()
        self.assertGreater(plain.expected, 0)  # roughly: a range alone is known
        for mesh in (fine.evaluate().tetrahedralize(), box.evaluate().tetrahedralize(size="1/2", growth=0.5)):
            self.assertGreater(len(mesh.tetrahedra), 10 * len(plain.tetrahedra))
            self.assertLess(0.5, mesh.expected / len(mesh.tetrahedra))
            self.assertLess(mesh.expected / len(mesh.tetrahedra), 2)

    def test_what_cannot_be_meshed(self):
        result = result_of(LAYERS)
        for wrong in ({"max_volume": -1}, {"max_volume": float("nan")}, {"quality": 1}, {"quality": float("nan")},
                      {"seconds": -1}, {"quality": 1000}, {"size": -1}, {"size": float("inf")}, {"growth": 0},
                      {"growth": 3}, {"order": 0}, {"order": 3}):
            with self.assertRaises(cnrg.InputError):
                result.tetrahedralize(**wrong)
        for text in (OPEN, HALF):
            with self.assertRaises(cnrg.InputError):
                result_of(text).tetrahedralize()

    def test_progress_is_told_and_stops_it(self):
        stages = []
        result_of(LAYERS).tetrahedralize(progress=lambda stage, done, total: stages.append(stage))
        self.assertTrue(stages)

        def stop(stage, done, total):
            raise KeyboardInterrupt

        with self.assertRaises(KeyboardInterrupt):
            result_of(LAYERS).tetrahedralize(max_volume=1e-5, progress=stop)


class Pictures(WithFolder):
    def test_a_still_is_that_of_the_program(self):
        tree = self.folder / "slope.yaml"
        tree.write_text(SLOPE)
        options = ["--camera", "20,25", "--labels", "names,v", "--opacity", "0.5", "--cut", "y=50", "--explode", "0.2",
                   "--caption", "cut", "--size", "500x400", "--color-by", "region"]
        subprocess.run([os.environ["CNRG_PROGRAM"], "eval", str(tree), "--quiet", *options, "-o", str(self.folder / "a.svg")], check=True)
        result = cnrg.read(tree).evaluate().result
        keywords = {"camera": (20, 25), "labels": ["names", "v"], "opacity": 0.5, "cut": "y=50", "explode": 0.2,
                    "caption": "cut", "size": (500, 400), "color_by": "region"}
        self.assertEqual(result.picture(**keywords), (self.folder / "a.svg").read_bytes())
        result.picture(self.folder / "b.svg", **{**keywords, "cut": [(0, 1, 0, 50)], "camera": "20,25", "labels": "names,v"})
        self.assertEqual((self.folder / "b.svg").read_bytes(), (self.folder / "a.svg").read_bytes())
        subprocess.run([os.environ["CNRG_PROGRAM"], "eval", str(tree), "--quiet", "--ghosts", "-o", str(self.folder / "g.svg")], check=True)
        self.assertEqual(result.picture(ghosts=True), (self.folder / "g.svg").read_bytes())

    def test_formats_of_pictures(self):
        result = result_of(LAYERS)
        self.assertTrue(result.picture(format="png").startswith(b"\x89PNG"))
        self.assertTrue(result.picture(format="pdf").startswith(b"%PDF"))
        self.assertTrue(result._repr_png_().startswith(b"\x89PNG"))

    def test_what_is_no_option_of_pictures(self):
        result = result_of(LAYERS)
        for wrong, said in (({"camera": (1, 2, 3)}, "camera: "), ({"cut": "w=5"}, "cut: "), ({"explode": -1}, "explode: "),
                            ({"opacity": 2}, "opacity: "), ({"color_by": "taste"}, "color_by: "), ({"labels": "x"}, "labels: "),
                            ({"size": (1, 1)}, "size: "), ({"format": "gif"}, "svg"), ({"ghosts": True, "cut": "x=1"}, "ghosts")):
            with self.assertRaisesRegex(cnrg.InputError, said):
                result.picture(**wrong)
        with self.assertRaises(cnrg.FileError):
            result.picture(self.folder / "no" / "a.svg")
        with self.assertRaisesRegex(cnrg.InputError, "no tree"):
            gap = cnrg.box([0, 0, 0], [1, 1, 1]) | cnrg.box([0, 0, "1.00000000000000001"], [1, 1, 2])
            gap.evaluate().snap().picture(ghosts=True)

    def test_notebooks_show_counts_components_and_a_picture(self):
        text = result_of(SLOPE.replace("ground", "a<b"))._repr_html_()
        self.assertIn("<b>14</b> vertices", text)
        self.assertIn("a&lt;b", text)
        self.assertNotIn("a<b", text)
        self.assertIn("<svg", text)
        self.assertLess(len(text), 50_000)
        self.assertIn("unbounded", result_of(HALF)._repr_html_())
        self.assertNotIn("<svg", result_of("cnrg: 1\nnodes: {a: {points: [[0, 0, 1e300]]}}\nresult: a\n")._repr_html_())

    def test_a_page_of_a_result(self):
        result = result_of(SLOPE)
        if not (Path(cnrg.__file__).parent / "view.html").exists():
            with self.assertRaisesRegex(cnrg.FileError, "Node.js"):
                result.view()
            self.skipTest("the page was not bundled: Node.js, npm or the network were not there")
        shown = result.view(title="a & b")
        self.assertIn("<title>a &amp; b</title>", shown.text)
        self.assertIn("srcdoc=", shown._repr_html_())
        result.view(self.folder / "a.html")
        self.assertGreater((self.folder / "a.html").stat().st_size, 100_000)
        self.assertNotIn("<!--cnrg:data-->", (self.folder / "a.html").read_text())


if __name__ == "__main__":
    unittest.main()
