"""What is said of regions, sheets, wires and points: counted by hand in a block with a fault and two bolts."""
import os
import subprocess
import tempfile
import unittest
from fractions import Fraction
from pathlib import Path

import numpy

import cnrg

try:
    import meshio
except ImportError:
    meshio = None

# The fault parts the block and ends outside of it: a square in it, a ring around that. The first bolt leaves the block
# through its top, the second one crosses the fault: four wires.
BOLTS = """cnrg: 1
materials: {rock: {}, steel: {}, clay: {}}
nodes:
  rock:   {box: {min: [0, 0, 0], max: [4, 4, 4]}, material: rock, attributes: {diameter: 1/3}}
  fault:  {polygon: [[2, -1, -1], [2, 5, -1], [2, 5, 5], [2, -1, 5]], material: clay, attributes: {aperture: 1/1000, cell: 7}}
  first:  {polyline: [[1, 1, 1], [1, 1, 6]]}
  second: {polyline: [[1, 3, 1], [3, 3, 1]]}
  bolts:  {union: [first, second], name: bolts, material: steel, attributes: {diameter: 25, section: round}}
  spring: {points: [[3, 1, 1]], attributes: {flow: 1/7}}
  all:    {union: [rock, fault, bolts, spring], dominance: right}
  one:    {unify: all}
result: all
"""
STEEL = cnrg.Said("bolts", "steel", {"diameter": Fraction(25), "section": "round"})
CLAY = cnrg.Said("", "clay", {"aperture": Fraction(1, 1000), "cell": Fraction(7)})
ROCK = cnrg.Said("rock", "rock", {"diameter": Fraction(1, 3)})
SPRING = cnrg.Said("", "", {"flow": Fraction(1, 7)})


def result_of(node="all"):
    return cnrg.parse(BOLTS).evaluate(node)[node]


def size_where(cells, sizes, result, said):
    return sizes[[place >= 0 and result.said[place] == said for place in cells.said]].sum()


class Cells(unittest.TestCase):
    def test_cells_know_what_is_said_of_them(self):
        result = result_of()
        self.assertCountEqual(list(result.said), [STEEL, CLAY, ROCK, SPRING])
        self.assertEqual((result.faces.said.dtype, result.faces.said.shape), (numpy.int32, (len(result.faces),)))
        self.assertEqual(size_where(result.faces, result.faces.areas, result, CLAY), 36)
        self.assertEqual(size_where(result.edges, result.edges.lengths, result, STEEL), 3 + 2 + 1 + 1)
        self.assertEqual(size_where(result.regions, result.regions.volumes, result, ROCK), 64)
        counts = [numpy.count_nonzero(cells.said >= 0) for cells in (result.vertices, result.edges, result.faces)]
        self.assertEqual(counts, [1, 4, 2])  # walls of the block are no sheets, ends of bolts no points

    def test_their_material_is_their_own(self):
        result = result_of()
        names = [name for name, _ in result.materials]
        for cells, said, material in ((result.faces, CLAY, "clay"), (result.edges, STEEL, "steel")):
            of = [m for m, place in zip(cells.material, cells.said) if place >= 0 and result.said[place] == said]
            self.assertEqual({names[m] for m in of}, {material})

    def test_values_are_exact(self):
        result = result_of()
        values = result.said.values("aperture", result.faces.said)
        self.assertEqual(values.count(Fraction(1, 1000)), 2)
        self.assertEqual(values.count(None), len(result.faces) - 2)
        self.assertEqual(result.said.values("section", result.edges.said).count("round"), 4)
        self.assertEqual(result.components[0].attributes, {"diameter": Fraction(1, 3)})

    def test_components_say_it_of_their_cells_but_where_these_speak(self):
        result = result_of("one")
        self.assertEqual(len(result.components), 1)
        self.assertEqual(size_where(result.faces, result.faces.areas, result, CLAY), 36)
        self.assertEqual(size_where(result.edges, result.edges.lengths, result, STEEL), 7)
        self.assertEqual(size_where(result.faces, result.faces.areas, result, ROCK), 6 * 16)

    def test_a_file_that_is_read_back_says_the_same(self):
        result = result_of()
        with tempfile.TemporaryDirectory() as folder:
            result.write(Path(folder) / "a.json")
            back = cnrg.load(Path(folder) / "a.json").evaluate()
        for kind in ("vertices", "edges", "faces", "regions"):
            a, b = (getattr(r, kind) for r in (result, back))
            self.assertEqual([r.said[p] if p >= 0 else None for r, p in ((result, p) for p in a.said)],
                             [r.said[p] if p >= 0 else None for r, p in ((back, p) for p in b.said)])

    def test_what_says_nothing_has_no_table(self):
        dots = cnrg.points([[0, 0, 0]]).evaluate()
        self.assertEqual((len(dots.said), dots.vertices.said.tolist()), (0, [-1]))


class Places(unittest.TestCase):
    POINTS = [[1, 1, 2], [2, 3, 2], [2, 3, 1], [3, 1, 1], [1, 1, 0.5], [9, 9, 9], [0, 1, 1]]

    def test_places_know_what_is_said_of_their_cells(self):
        result = result_of()
        said = result.said_of(result.locate(self.POINTS))
        self.assertEqual(said, [STEEL, CLAY, None, SPRING, ROCK, None, None])

    def test_they_say_what_the_program_says(self):
        with tempfile.TemporaryDirectory() as folder:
            tree = Path(folder) / "bolts.yaml"
            tree.write_text(BOLTS)
            lines = "".join(" ".join(map(str, p)) + "\n" for p in self.POINTS)
            for node in ("all", "one"):
                told = subprocess.run([os.environ["CNRG_PROGRAM"], "locate", str(tree), "--node", node], input=lines,
                                      capture_output=True, text=True, check=True).stdout.splitlines()
                result = result_of(node)
                said = result.said_of(result.locate(self.POINTS))
                fields = [[field for field in line.split("\t")[1:] if not field.startswith(("front of: ", "behind: "))]
                          for line in told]
                self.assertEqual(fields,
                                 [[f"{key}: {value}" for key, value in (s.attributes if s else {}).items()] for s in said])


class Meshes(unittest.TestCase):
    @unittest.skipIf(meshio is None, "meshio is not installed (Debian: python3-meshio)")
    def test_cells_of_meshio_have_what_is_said(self):
        result = result_of()
        tetrahedra = result.tetrahedralize()
        for mesh, table in ((result.to_meshio(), result.said), (tetrahedra.to_meshio(), tetrahedra.said)):
            sizes = {}
            for i, block in enumerate(mesh.cells):
                p = mesh.points[block.data]
                data = {name: values[i] for name, values in mesh.cell_data.items()}
                if block.type == "line":
                    lengths = numpy.linalg.norm(p[:, 1] - p[:, 0], axis=1)
                    sizes["steel"] = lengths[data["diameter"] == 25].sum()
                    sizes["round"] = lengths[data["section"] == table.texts["section"].index("round")].sum()
                    sizes["bolts"] = lengths[data["name"] == table.texts["name"].index("bolts")].sum()
                if block.type == "triangle":
                    areas = numpy.linalg.norm(numpy.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1) / 2
                    sizes["fault"] = areas[data["aperture"] == 0.001].sum()
                    sizes["cell'"] = areas[data["cell'"] == 7].sum()
                    self.assertTrue(numpy.isnan(data["diameter"]).all())
                if block.type == "tetra":
                    self.assertTrue((data["diameter"] == 1 / 3).all())
                    self.assertTrue((data["name"] == 0).all())
            for name, size in {"steel": 7, "round": 7, "bolts": 7, "fault": 36, "cell'": 36}.items():
                self.assertAlmostEqual(sizes[name], size, places=12)

    def test_tetrahedra_know_it_exactly(self):
        mesh = result_of().tetrahedralize()
        self.assertEqual(set(mesh.said.values("diameter", mesh.tetrahedra.said)), {Fraction(1, 3)})
        self.assertEqual(set(mesh.said.values("section", mesh.segments.said)), {"round", None})
        self.assertEqual(mesh.said.values("flow", mesh.vertices.said).count(Fraction(1, 7)), 1)


if __name__ == "__main__":
    unittest.main()
