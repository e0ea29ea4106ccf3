"""The supported tunnel of papers/pereira2012 in meshio and in Gmsh: for the room `formats`.

    supported_tunnel.py PROGRAM FOLDER    runs the program cnrg in an empty folder

What each physical group measures is worked out here from the exact points of the result's .json, by the table of
groups in csg/FORMATS.md; both programs open the .msh and have to find the same groups, as long and as large, with
the numbers that the tree says of them.
"""
import json
import math
import re
import shutil
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

import meshio
import numpy as np

sys.dont_write_bytecode = True

from simplices import measures_of  # noqa: E402

PROGRAM, FOLDER = sys.argv[1], Path(sys.argv[2])
PAPERS = Path(__file__).resolve().parents[2] / "papers/pereira2012"
TREES, FILES = FOLDER / "papers/pereira2012", FOLDER / "out/pereira2012"

# What fig10-bolts.yaml says in numbers: by key and name of a group.
SAID = {"diameter": {"bolts": 1 / 40, "spiles": 4 / 125}, "thickness": {"shell": 1 / 5},
        "aperture": {"fault": 1 / 200}}
DIMENSION = {"vertex": 0, "line": 1, "triangle": 2, "tetra": 3}


def run(*words):
    ended = subprocess.run(words, cwd=FOLDER, capture_output=True, text=True)
    assert ended.returncode == 0, (words, ended.returncode, ended.stdout + ended.stderr)
    return ended.stdout + ended.stderr


def check_close(found, exact, what, relative=1e-9):
    """Points of a mesh are rounded to doubles."""
    assert exact > 0 and abs(found - exact) <= relative * exact, (what, found, exact)


# Measures of the result, from exact points.
def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def length_of(edge, points):
    chain = [points[p] for p in edge["points"]]
    if edge["closed"]:
        chain.append(chain[0])
    return sum(math.sqrt(dot(minus(b, a), minus(b, a))) for a, b in zip(chain, chain[1:]))


def area_of(face, points):
    """Of planar pieces between their loops, of which inner ones run the other way; triangles do not matter."""
    area = 0
    for facet in face.get("facets", [face]):
        twice = [Fraction(0)] * 3
        origin = points[facet["loops"][0][0]]
        for loop in facet["loops"]:
            corners = [minus(points[p], origin) for p in loop]
            for a, b in zip(corners, corners[1:] + corners[:1]):
                twice = [x + y for x, y in zip(twice, cross(a, b))]
        area += math.sqrt(dot(twice, twice)) / 2
    return area


def volume_of(region, faces, points):
    """By the triangles around it, exactly."""
    six = Fraction(0)
    for shell in region["shells"]:
        for side in shell:
            sign = 1 if side["side"] == "back" else -1  # seen from the front, triangles are counter-clockwise
            for a, b, c in faces[side["face"]]["triangles"]:
                six += sign * dot(points[a], cross(points[b], points[c]))
    assert six / 6 == Fraction(region["volume"])
    return float(six / 6)


def normal_of(face, points):
    """Of the front, from which triangles are seen counter-clockwise."""
    return [sum(part) for part in zip(*(cross(minus(points[b], points[a]), minus(points[c], points[a]))
                                        for a, b, c in face["triangles"]))]


def points_of(result):
    return [[Fraction(x) for x in point] for point in result["points"]]


def sides_of(result, fronts):
    """By region, where it is: of the surfaces of which `fronts` has the normals of faces, by name and number."""
    points, leaves = points_of(result), [leaf["name"] for leaf in result["leaves"]]
    touched = [set() for _ in result["regions"]]
    for face in result["faces"]:
        for entry in face["origin"]:
            for number in entry.get("faces", []):
                name = leaves[entry["leaf"]]
                if name not in fronts:
                    continue
                along = dot(normal_of(face, points), fronts[name][number]) > 0
                for region, is_front in zip(face["regions"], (along, not along)):
                    if region is not None:
                        touched[region].add((name, is_front))
    return [{f"{'front of' if front else 'behind'} {name}" for name, front in sides if (name, not front) not in sides}
            for sides in touched]


class Groups:
    """Measures of the groups by dimension and name, as the page on .msh defines them."""

    def __init__(self, result, fronts):
        points = points_of(result)
        faces, regions, said = result["faces"], result["regions"], result["attributes"]
        leaves = [leaf["name"] for leaf in result["leaves"]]
        self.measures = {}
        names = [f"{region['name']} {region['component']}" for region in regions]  # they share a name
        assert len({region["name"] for region in regions[1:]}) == 1 and not regions[0]["component"]
        whole = regions[1]["name"]
        sides = sides_of(result, fronts)
        everywhere = set.intersection(*sides[1:])  # tells nothing
        for region, name, at in zip(regions[1:], names[1:], sides[1:]):
            self.add(3, [name, whole, f"material {region['material']}", *(f"{whole} {side}" for side in at - everywhere)],
                     volume_of(region, faces, points))
        for face in faces:
            groups = self.said_of(face, said)
            sides = sorted({side for side in face["regions"] if regions[side]["component"]},
                           key=lambda side: regions[side]["component"])
            if len(sides) == 2:
                groups += [f"wall {names[sides[0]]} | {names[sides[1]]}", f"wall {whole} | {whole}"]
            elif face["regions"][0] != face["regions"][1]:
                groups += [f"boundary of {names[sides[0]]}", f"boundary of {whole}"]
            groups += [f"from {leaves[entry['leaf']]}" for entry in face["origin"] if entry.get("faces")]
            self.add(2, groups, area_of(face, points))
        for edge in result["edges"]:
            groups = self.said_of(edge, said) if edge["wire"] else ["edges"]
            self.add(1, groups, length_of(edge, points))

    @staticmethod
    def said_of(cell, said):
        if "attributes" not in cell:
            return []
        words = said[cell["attributes"]]
        texts = [f"{key} {value}" for key, value in words["properties"].items() if isinstance(value, str)]
        return [words["name"], *([f"material {words['material']}"] if words["material"] else []), *texts]

    def add(self, dimension, names, measure):
        for name in names:
            key = dimension, name
            self.measures[key] = self.measures.get(key, 0) + measure


def check_in_meshio(file, groups, dimensions):
    """Groups, their measures, and numbers at each cell. Returns the tags of groups."""
    mesh = meshio.read(FILES / file)
    tags = {(int(dimension), name): int(tag) for name, (tag, dimension) in mesh.field_data.items()}
    found = {key for key in tags if key[0] > 0 and key[1] != "edges of facets"}
    assert found == set(groups.measures), found ^ set(groups.measures)
    sizes = [measures_of(mesh.points[block.data]) if DIMENSION[block.type] else None for block in mesh.cells]
    for (dimension, name), exact in groups.measures.items():
        if dimension in dimensions:
            total = sum(sizes[i][mesh.cell_sets[name][i]].sum() for i, block in enumerate(mesh.cells)
                        if DIMENSION[block.type] == dimension)
            check_close(total, exact, (file, name))
    assert set(SAID) <= set(mesh.cell_data), set(mesh.cell_data)
    for key, values in SAID.items():
        for i, block in enumerate(mesh.cells):
            wanted = np.full(len(block), np.nan)
            for name, value in values.items():
                wanted[mesh.cell_sets[name][i]] = value
            np.testing.assert_array_equal(np.ravel(mesh.cell_data[key][i]), wanted)
    return tags


def check_in_gmsh(file, groups, dimensions, tags):
    """Gmsh measures each group itself, and writes the numbers with the simplices that have them."""
    keys = sorted(SAID)
    script = [f'Merge "{FILES / file}";']
    script += [f'Save View[{i}] "{FOLDER}/{key}.pos";' for i, key in enumerate(keys)]
    asked = [key for key in groups.measures if key[0] in dimensions]
    for dimension, name in asked:
        script += [f"Plugin(MeshVolume).Dimension = {dimension};",
                   f"Plugin(MeshVolume).PhysicalGroup = {tags[dimension, name]};", "Plugin(MeshVolume).Run;"]
    (FOLDER / "measure.geo").write_text("\n".join(script) + "\n")
    said = run("gmsh", "-", "measure.geo")
    assert "Error" not in said, said
    found = {(int(d), int(tag)): float(v) for tag, d, v in
             re.findall(r"Mesh volume \(physical (\d+) \| dimension (\d)\): (\S+)", said)}
    assert len(found) == len(asked)
    for dimension, name in asked:  # it prints six digits
        check_close(found[dimension, tags[dimension, name]], groups.measures[dimension, name], (file, name), 1e-5)
    kinds = {2: "SL", 3: "ST"}
    for key in keys:
        text = (FOLDER / f"{key}.pos").read_text()
        assert text.startswith(f'View "{key}"')
        totals = {}
        for kind, places, values in re.findall(r"^(\w+)\(([^)]*)\)\{([^}]*)\}", text, re.M):
            values = {float(value) for value in values.split(",") if value != "nan"}
            if values:
                [value] = values
                simplex = np.array([float(x) for x in places.split(",")]).reshape(1, -1, 3)
                assert kind == kinds[simplex.shape[1]], (key, kind)
                totals[value] = totals.get(value, 0) + measures_of(simplex)[0]
        for name, value in SAID[key].items():
            [exact] = [m for (dimension, group), m in groups.measures.items() if group == name]
            check_close(totals.pop(value), exact, (file, key, name))
        assert not totals, (key, totals)


TREES.mkdir(parents=True)
FILES.mkdir(parents=True)
for name in ("fig10.yaml", "fig10-bolts.yaml"):
    shutil.copy(PAPERS / name, TREES / name)
TREE, OUT = "papers/pereira2012/fig10-bolts.yaml", "out/pereira2012/"
run(PROGRAM, "eval", "papers/pereira2012/fig10.yaml", "--quiet", "--node", "G1", "-o", OUT + "G1.json",
    "--node", "G3", "-o", OUT + "G3.json", "--node", "rocks", "-o", OUT + "rocks.json")
run(PROGRAM, "eval", TREE, "--quiet", "-o", OUT + "model.json", "-o", OUT + "model.msh")
run(PROGRAM, "mesh", TREE, "--quiet", "--quality", "2", "-o", OUT + "mesh.msh")
run(PROGRAM, "mesh", TREE, "--quiet", "-Y", "-o", OUT + "kept.msh")
# Of the horizons fronts are those of their file, of the fault that of its polygon.
horizons = json.loads((FILES / "G1.json").read_text())
fronts = {"G1": [normal_of(face, points_of(horizons)) for face in horizons["faces"]],
          "G2": [cross((0, 200, 0), (68, 0, 170))]}
groups = Groups(json.loads((FILES / "model.json").read_text()), fronts)
# Bolts and spiles are the steel; the shell is the shotcrete: the 48 sides of a prism, along 0.625 of the axis less
# what is before the box, where the plane x = 0 cuts it as much longer on one side as shorter on the other.
measure = groups.measures
check_close(measure[1, "bolts"] + measure[1, "spiles"], measure[1, "material steel"], "steel")
axis, side = math.hypot(260, 12, 7), 2 * 9 * math.sin(math.pi / 48)
check_close(measure[2, "material shotcrete"], 48 * side * (0.625 - 10 / 260) * axis, "shell")
for file, dimensions in (("model.msh", (1, 2)), ("mesh.msh", (1, 2, 3)), ("kept.msh", (1, 2, 3))):
    tags = check_in_meshio(file, groups, dimensions)
    check_in_gmsh(file, groups, dimensions, tags)

# The table of papers/pereira2012.
print("| dimension | group | number | measure of the elements |\n|---|---|---|---|")
materials = sorted(name for dimension, name in measure if dimension == 3 and name.startswith("material "))
for dimension, name in [(1, "bolts"), (1, "spiles"), (2, "shell"), (2, "fault"), *((3, name) for name in materials)]:
    number = "".join(f"`{key}` {values[name]:g}" for key, values in SAID.items() if name in values)
    print(f"| {dimension} | `{name}` | {number} | {measure[dimension, name]:,.2f} {('m', 'm²', 'm³')[dimension - 1]} |")
