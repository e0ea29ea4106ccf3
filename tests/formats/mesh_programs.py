"""Meshes in the programs that they are written for, or in readers of others: for the room `formats`.

    mesh_programs.py PROGRAM CASE FOLDER    runs a case of below with the program cnrg, in an empty folder

Of one model, whose measures are worked out by hand, each reader finds the groups and measures them: volumes of
regions, areas of faces, lengths of wires. Gmsh reads .mesh and .bdf, MED's own library .med, meshio all of them, h5py
the sets of .h5m, and CalculiX computes with .inp.
"""
import itertools
import random
import re
import shutil
import subprocess
import sys
from math import pi
from pathlib import Path

import h5py
import meshio
import numpy as np

sys.dont_write_bytecode = True

from simplices import measures_of  # noqa: E402

PROGRAM, CASE, FOLDER = sys.argv[1], sys.argv[2], Path(sys.argv[3])

# Volume 27: a rock that a seam parts in two, a sheet and a bolt that hang in it, a cable and a point outside.
MODEL = """
cnrg: 1
materials: {granite: {color: "#998877"}, ore: {}, steel: {}}
nodes:
  rock:  {box: {min: [0, 0, 0], max: [3, 3, 3]}, material: granite, attributes: {temp: 300}}
  seam:  {box: {min: [1, 0, 0], max: [2, 3, 3]}, material: ore}
  flap:  {polygon: [["5/2", 1, 1], ["5/2", 2, 1], ["5/2", 2, 2], ["5/2", 1, 2]], name: "flap: a sheet",
          attributes: {thickness: 1/5}}
  bolt:  {polyline: [["1/2", 1, 1], ["1/2", 1, 2]], material: steel, name: bolt, attributes: {diameter: 1/40}}
  cable: {polyline: [[5, 0, 0], [5, 4, 0], [5, 4, 3]]}
  mark:  {points: [[6, 6, 6]]}
  m:     {union: [rock, seam, flap, bolt, cable, mark], dominance: right}
result: m
"""
VOLUMES = {"rock 1": 9, "rock 3": 9, "rock": 18, "seam": 9, "material granite": 18, "material ore": 9}
# The outer skin of each third is 1 x 3 four times, and of the outer two one square of 9 more.
BOUNDARIES = {"boundary of rock 1": 21, "boundary of rock 3": 21, "boundary of seam": 12,
              "wall rock 1 | seam": 9, "wall seam | rock 3": 9, "boundary of rock": 42, "wall rock | seam": 18, "from rock": 54, "from seam": 30}
SHEETS = {"flap: a sheet": 1, "from flap": 1}
WIRES = {"bolt": 1, "material steel": 1, "wire of cable": 7}
ALL = {**{(3, name): value for name, value in VOLUMES.items()}, **{(1, name): value for name, value in WIRES.items()},
       **{(2, name): value for name, value in {**BOUNDARIES, **SHEETS}.items()}}
WHOLE = ("rock", "boundary of rock", "wall rock | seam")  # of both parts that are called rock
FIRST = {key: value for key, value in ALL.items() if not key[1].startswith(("material", "from")) and key[1] not in WHOLE}
DIMENSION = {"vertex": 0, "line": 1, "line3": 1, "triangle": 2, "triangle6": 2, "quad": 2, "tetra": 3, "tetra10": 3}
MIDDLES = {"line3": ((0, 1),), "triangle6": ((0, 1), (1, 2), (0, 2)),
           "tetra10": ((0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3))}


def run(*words, status=0):
    ended = subprocess.run([PROGRAM, *words], cwd=FOLDER, capture_output=True, text=True)
    assert ended.returncode == status, (words, ended.returncode, ended.stderr)
    return ended


def tree(text=MODEL, name="m.yaml"):
    (FOLDER / name).write_text(text)
    return name


def check(found, exact, what, close=1e-12):
    """Groups and measures are these and no others."""
    assert set(found) == set(exact), (what, set(found) ^ set(exact))
    for key, value in exact.items():
        assert abs(found[key] - value) <= close * value, (what, key, found[key], value)


def check_counts(mesh, counts, what):
    """As many simplices of each dimension as in the .msh."""
    found = {}
    for block in mesh.cells:
        found[DIMENSION[block.type]] = found.get(DIMENSION[block.type], 0) + len(block.data)
    for dimension, count in found.items():
        assert count == counts[dimension], (what, dimension, count, counts)
    return found


def check_middles(mesh, what, close=1e-12):
    """In meshio's order the nodes behind the corners are the middles of straight edges."""
    some = 0
    for block in mesh.cells:
        corners = DIMENSION[block.type] + 1
        for k, (i, j) in enumerate(MIDDLES.get(block.type, ())):
            p = mesh.points[block.data]
            assert np.allclose(p[:, corners + k], (p[:, i] + p[:, j]) / 2, rtol=0, atol=close), (what, block.type, k)
            some += len(block.data)
    assert some > 0, what


def totals(mesh, rows_of):
    """By dimension and name: the sum over the cells of each block that `rows_of(block, i)` gives by name."""
    found = {}
    for i, block in enumerate(mesh.cells):
        dimension = DIMENSION[block.type]
        if dimension == 0:
            continue
        sizes = measures_of(mesh.points[block.data[:, :dimension + 1]])
        for name, rows in rows_of(block, i).items():
            if len(rows):
                key = dimension, name
                found[key] = found.get(key, 0) + sizes[rows].sum()
    return found


def by_reference(mesh, array, names):
    """Cells of each group by numbers in an array; names by dimension and number."""
    def rows_of(block, i):
        numbers = np.asarray(mesh.cell_data[array][i], int)
        return {name: np.flatnonzero(numbers == number) for (dimension, number), name in names.items()
                if dimension == DIMENSION[block.type]}
    return totals(mesh, rows_of)


def in_gmsh(file, order=1):
    """What Gmsh reads, as meshio reads what Gmsh writes then."""
    ended = subprocess.run(["gmsh", file, "-save", "-save_all", "-o", f"{file}.again.msh"], cwd=FOLDER,
                           capture_output=True, text=True)
    said = (ended.stdout + ended.stderr).replace("Warning : Gmsh must be compiled with ANN", "")  # Debian's is not
    assert ended.returncode == 0 and "Error" not in said and "Warning" not in said, said
    return meshio.read(FOLDER / f"{file}.again.msh")


def gmsh_version():
    ended = subprocess.run(["gmsh", "--version"], capture_output=True, text=True)
    return tuple(int(number) for number in re.findall(r"\d+", ended.stdout + ended.stderr)[:2])


def meshed(order, *extensions):
    files = [f"t.{extension}" for extension in ("msh", "vtu", *extensions)]
    words = [word for file in files for word in ("-o", file)]
    run("mesh", tree(), "--quiet", "--max-volume", "0.2", "--order", str(order), *words)
    mesh = meshio.read(FOLDER / "t.msh")
    mesh.in_order = meshio.read(FOLDER / "t.vtu").points  # as all files but .msh have them
    found = {}
    for block in mesh.cells:
        found[DIMENSION[block.type]] = found.get(DIMENSION[block.type], 0) + len(block.data)
    return mesh, found


def msh():
    """Of both orders; all groups, the first of each element, and the nodes of second order in their places."""
    for order in (1, 2):
        mesh, counts = meshed(order, "msh2")
        rows = {name: [mesh.cell_sets[name][i] for i in range(len(mesh.cells))] for name in mesh.field_data}
        found = totals(mesh, lambda block, i: {name: of[i] for name, of in rows.items()})
        check({key: value for key, value in found.items() if key != (1, "edges")}, ALL, f".msh {order}")
        again = in_gmsh("t.msh")
        assert len(again.points) == len(mesh.points)
        assert {b.type for b in mesh.cells} == {b.type for b in again.cells}
        text = (FOLDER / "t.msh2").read_text()
        assert text.count("$ElementData\n") == 3  # which meshio reads in no file of this version
        (FOLDER / "old.msh").write_text(re.sub(r"\$ElementData\n.*?\$EndElementData\n", "", text, flags=re.S))
        old = meshio.read(FOLDER / "old.msh")
        check_counts(in_gmsh("t.msh2"), counts, ".msh2 in Gmsh")
        assert check_counts(old, counts, ".msh2") == counts
        check_first(by_reference(old, "gmsh:physical", numbered(old)), ".msh2")
        run("mesh", tree(), "--quiet", "--max-volume", "0.2", "--order", str(order), "--one-group", "-o", "one.msh")
        one = meshio.read(FOLDER / "one.msh")
        check_first(by_reference(one, "gmsh:physical", numbered(one)), "--one-group")
        for i, block in enumerate(one.cells):
            rows = [one.cell_sets[name][i] for name in one.field_data]
            assert sorted(np.concatenate(rows)) == list(range(len(block.data))), block.type
        if order == 2:
            check_middles(mesh, ".msh")
            check_middles(old, ".msh2")


def numbered(mesh):
    """Names of groups by dimension and number."""
    return {(dimension, number): name for name, (number, dimension) in mesh.field_data.items()}


def check_first(found, what):
    """Each element is in its first group."""
    check({key: value for key, value in found.items() if key != (1, "edges")}, FIRST, what)


def medit():
    """References are first groups, named by comments; wires are required edges, which meshio passes over."""
    _, counts = meshed(1, "mesh")
    text = (FOLDER / "t.mesh").read_text()
    words = {"vertices": 0, "edges": 1, "triangles": 2, "tetrahedra": 3}
    names = {(words[kind], int(number)): name
             for kind, number, name in re.findall(r"^# (\w+) (\d+) (.*)$", text, re.M)}
    mesh = meshio.read(FOLDER / "t.mesh")
    assert check_counts(mesh, counts, ".mesh") == {d: counts[d] for d in (1, 2, 3)}
    check(by_reference(mesh, "medit:ref", names), FIRST, ".mesh in meshio")
    mesh = in_gmsh("t.mesh")
    check(by_reference(mesh, "gmsh:geometrical", names), FIRST, ".mesh in Gmsh")
    [required] = re.findall(r"^RequiredEdges (\d+)((?: \d+)+)$", text, re.M)
    edges = np.array([line.split() for line in text.split("\nEdges\n")[1].split("\n")[1:1 + counts[1]]], int)
    numbers = np.array(required[1].split(), int)
    assert len(numbers) == int(required[0])
    assert set(edges[numbers - 1, 2]) == {n for (d, n), name in names.items() if d == 1 and (d, name) in FIRST}


def nastran():
    """Solids, shells and rods by property; sizes that the tree says; sets of elements and of points."""
    for order in (1, 2):
        whole, counts = meshed(order, "bdf")
        text = (FOLDER / "t.bdf").read_text()
        kinds = {"PSOLID": 3, "PSHELL": 2, "PROD": 1}
        names = {(kinds[kind], int(number)): name
                 for kind, number, name in re.findall(r"^\$ (P\w+) (\d+): (.*)$", text, re.M)}
        elements = {key: value for key, value in FIRST.items() if key[1] not in BOUNDARIES}
        for mesh, array in ((meshio.read(FOLDER / "t.bdf"), "nastran:ref"), (in_gmsh("t.bdf"), "gmsh:geometrical")):
            blocks = [block.type for block in mesh.cells if block.type != "vertex"]
            corners = array == "gmsh:geometrical" and gmsh_version() < (4, 13)  # it takes those of solids alone
            solid = "tetra10" if order == 2 and not corners else "tetra"
            assert set(blocks) == {"line", "triangle" if order == 1 else "triangle6", solid}, blocks
            check(by_reference(mesh, array, names), elements, f".bdf {order} {array}")
            if order == 2:
                check_middles(mesh, f".bdf {array}")
        size = {name: float(re.sub(r"(?<=\d)-", "e-", card[40:56])) for name, card in
                re.findall(r"^\$ P(?:SHELL|ROD) \d+: (.*)\n(P\w+\*.*)$", text, re.M) if card[40:56].strip()}
        assert size["flap: a sheet"] == 1 / 5 and abs(size["bolt"] - pi / 4 / 40**2) < 1e-16, size
        # Sets, with the cards that continue them.
        sets = {}
        for what, name, card in re.findall(r"^\$ SET1 \d+: (elements|points) of (.*)\nSET1 ((?:.*\n\+)*.*)$", text, re.M):
            sets[what, name] = np.array(card.replace("+", " ").split()[1:], int)
        mesh = meshio.read(FOLDER / "t.bdf")
        numbers = np.concatenate(mesh.cells_id)
        rows = np.concatenate([measures_of(mesh.points[b.data[:, :DIMENSION[b.type] + 1]]) for b in mesh.cells])
        for name in ("material granite", "material ore", "from flap", "material steel"):
            [exact] = [value for (_, group), value in ALL.items() if group == name]
            total = rows[np.isin(numbers, sets.pop(("elements", name)))].sum()
            assert abs(total - exact) < 1e-12 * exact, (name, total)
        for name in ("boundary of seam", "wall rock 1 | seam"):
            # The same points as the .msh has there.
            cells = np.concatenate([b.data[whole.cell_sets[name][i]].ravel() for i, b in enumerate(whole.cells)
                                    if DIMENSION[b.type] == 2])
            places = {tuple(p) for p in mesh.points[sets["points", name] - 1].round(9).tolist()}
            assert places == {tuple(p) for p in whole.points[cells].round(9).tolist()}, name
        assert np.allclose(mesh.points, whole.in_order, rtol=1e-13, atol=0)
        [mark] = sets["points", "point of mark"]
        assert (mesh.points[mark - 1] == 6).all()


def abaqus():
    """Sets in meshio; CalculiX computes with them: volumes of sets, areas of surfaces."""
    for order in (1, 2):
        whole, counts = meshed(order, "inp")
        text = (FOLDER / "t.inp").read_text()
        names = dict(re.findall(r"^\*\* (\S+) is (.*)$", text, re.M))
        mesh = meshio.read(FOLDER / "t.inp")
        assert np.allclose(mesh.points, whole.in_order, rtol=1e-14, atol=0)
        for block in mesh.cells:
            if block.type == "line3":  # here the middle stands between the ends
                block.data[:, [1, 2]] = block.data[:, [2, 1]]
        if order == 2:
            check_middles(mesh, ".inp")
        found = totals(mesh, lambda block, i: {names.get(name, name): rows[i] for name, rows in mesh.cell_sets.items()})
        check(found, {key: value for key, value in ALL.items() if key[1] not in BOUNDARIES}, f".inp {order}")
        label = {name: key for key, name in names.items()}
        of = lambda name: label.get(name, name)
        assert (mesh.points[mesh.point_sets[of("point of mark")]] == 6).all()
        if shutil.which("ccx"):
            in_calculix(order, text, of)
        else:
            print("left out: .inp in CalculiX, which is not installed (Debian 12: calculix-ccx)")


def in_calculix(order, text, of):
    """Volumes of sets and areas of surfaces of t.inp, as CalculiX computes with them; `of` is the label of a name."""
    sets = {name: value for name, value in VOLUMES.items() if not name.startswith("material")}
    surfaces = {**BOUNDARIES, **SHEETS}
    deck = ["*INCLUDE, INPUT=t.inp", "*MATERIAL, NAME=M", "*ELASTIC", "1., 0."]
    for name in sets:
        deck += [f"*SOLID SECTION, ELSET={of(name)}, MATERIAL=M"]
    deck += [f"*SHELL SECTION, ELSET={of('flap: a sheet')}, MATERIAL=M", ".01"]
    for name in ("bolt", "wire of cable"):
        deck += [f"*SOLID SECTION, ELSET={of(name)}, MATERIAL=M", ".01"]
    deck += ["*BOUNDARY"] + [f"{of(name)}, 1, 3" for name in (
        "bolt", "wire of cable", "flap: a sheet", "boundary of rock 1", "boundary of rock 3", "boundary of seam")]
    deck += ["*STEP", "*STATIC"]
    for name in [*sets, "bolt", "wire of cable"]:
        deck += [f"*EL PRINT, ELSET={of(name)}, TOTALS=ONLY", "EVOL"]
    for k, name in enumerate(surfaces):
        deck += [f"*SECTION PRINT, SURFACE={of(name)}, NAME=S{k}", "SOF, SOM"]
    # CalculiX calls Abaqus's STRI65 S6.
    (FOLDER / "t.inp").write_text(text.replace("TYPE=STRI65", "TYPE=S6"))
    (FOLDER / "deck.inp").write_text("\n".join([*deck, "*END STEP"]) + "\n")
    ended = subprocess.run(["ccx", "deck"], cwd=FOLDER, capture_output=True, text=True)
    said = ended.stdout + ended.stderr
    assert ended.returncode == 0 and "*ERROR" not in said and "Job finished" in said, said[-3000:]
    results = (FOLDER / "deck.dat").read_text()
    volumes = {name: float(value) for name, value in
               re.findall(r"total volume.*?set\s+(\S+)\s+and time.*?\n\s*\n\s*(\S+)", results)}
    for name, exact in {**sets, "bolt": .01, "wire of cable": .07}.items():
        assert abs(volumes[of(name).upper()] - exact) <= 1e-5 * exact, (order, name, volumes)
    areas = [float(value) for value in re.findall(r"^ *area,.*\n\s*\n\s*(\S+)", results, re.M)]
    assert len(areas) == len(surfaces), (areas, len(surfaces))
    for found, (name, exact) in zip(areas, surfaces.items()):
        assert abs(found - exact) <= 1e-5 * exact, (order, name, found, exact)


def faults():
    """A crack in a block: in meshio and Gmsh sides, twins and wedges; in CalculiX it opens, in the middle most."""
    name = tree("""cnrg: 1
nodes:
  block: {box: {min: [0, 0, 0], max: [10, 10, 10]}}
  crack: {polygon: [[2, 2, 5], [8, 2, 5], [8, 8, 5], [2, 8, 5]]}
  m:     {union: [block, crack]}
result: m
""")
    run("mesh", name, "--size", "2", "-o", "whole.msh")
    run("mesh", name, "--size", "2", "--split", "crack", "-o", "t.msh", "-o", "t.inp")
    run("mesh", name, "--size", "2", "--split", "crack", "--interfaces", "-o", "w.msh", "-o", "w.msh2", "-o", "w.vtu", "-o", "w.inp")
    whole, mesh, grid = (meshio.read(FOLDER / file) for file in ("whole.msh", "w.msh", "w.vtu"))
    inside = whole.points[(whole.points[:, 2] == 5) & (abs(whole.points[:, :2] - 5) < 3).all(axis=1)]
    twin = grid.point_data["twin"]
    parted = np.flatnonzero(twin != np.arange(len(twin)))
    assert len(inside) > 4 and {*map(tuple, grid.points[parted])} == {*map(tuple, inside)} and len(parted) == len(inside)
    assert (grid.points == grid.points[twin]).all()
    assert sorted(mesh.point_data["twin"].ravel()) == sorted(twin + 1)
    wedges = np.concatenate([b.data for b in mesh.cells if b.type == "wedge"])
    assert (mesh.points[wedges[:, :3]] == mesh.points[wedges[:, 3:]]).all() and (wedges[:, :3] != wedges[:, 3:]).any(axis=1).all()
    flat = [i for i, b in enumerate(mesh.cells) if b.type == "triangle"]
    faces = meshio.Mesh(mesh.points, [mesh.cells[i] for i in flat],
                        cell_data={"group": [mesh.cell_data["gmsh:physical"][i] for i in flat]})
    found = by_reference(faces, "group", {(int(d), int(n)): key for key, (n, d) in mesh.field_data.items()})
    for side in ("back of crack", "front of crack"):
        assert 30 < found[(2, side)] <= 36 + 1e-9, found
    shutil.copy(FOLDER / "w.msh2", FOLDER / "two.msh")
    for other in (in_gmsh("w.msh"), in_gmsh("two.msh"), grid):
        assert sum(len(b.data) for b in other.cells if b.type == "wedge") == len(wedges)
        assert len(other.points) == len(mesh.points)
    text = (FOLDER / "w.inp").read_text()
    assert "TYPE=COH3D6" in text and "TYPE=S3" not in text
    if not shutil.which("ccx"):
        print("left out: .inp in CalculiX, which is not installed (Debian 12: calculix-ccx)")
        return
    points = meshio.read(FOLDER / "t.inp").points
    ends = [f"*NSET, NSET={name}\n" + ",\n".join(str(i + 1) for i in np.flatnonzero(points[:, 2] == z)) for name, z in (("LOW", 0), ("HIGH", 10))]
    (FOLDER / "deck.inp").write_text("\n".join([
        "*INCLUDE, INPUT=t.inp", *ends, "*MATERIAL, NAME=M", "*ELASTIC", "1000., .2", "*SOLID SECTION, ELSET=block, MATERIAL=M", "*STEP", "*STATIC",
        "*BOUNDARY", "LOW, 1, 3", "*CLOAD", "HIGH, 3, 1.", "*NODE PRINT, NSET=block", "U", "*END STEP"]) + "\n")
    ended = subprocess.run(["ccx", "deck"], cwd=FOLDER, capture_output=True, text=True)
    said = ended.stdout + ended.stderr
    assert ended.returncode == 0 and "*ERROR" not in said and "Job finished" in said, said[-3000:]
    up = {int(row[0]) - 1: float(row[3]) for row in map(str.split, (FOLDER / "deck.dat").read_text().splitlines()) if len(row) == 4 and row[0].isdigit()}
    at = {}
    for i, p in enumerate(points):
        at.setdefault(tuple(p), []).append(up[i])
    openings = {p: max(values) - min(values) for p, values in at.items() if len(values) > 1}
    assert len(openings) == len(inside) and min(openings.values()) > 0, openings
    widest = max(openings, key=openings.get)
    assert abs(widest[0] - 5) < 2 and abs(widest[1] - 5) < 2, openings


def periodic():
    """Grains that cross the sides of a cell, and go on opposite: what meshio and Gmsh find there is alike, exactly. Layers
    that are stretched in CalculiX have the stress of springs in a row."""
    random.seed(11)
    for axes in ("x", "y,z", "x,y,z"):
        along = np.array([axis in axes for axis in "xyz"])
        grains = [[random.randrange(100) for _ in range(3)] for _ in range(3)]
        copies = [f"{{sphere: {{center: {[f'{x + 100 * d}/100' for x, d in zip(p, by)]}, radius: 0.3, segments: 8}}}}"
                  for p in grains for by in itertools.product(*[(-1, 0, 1) if on else (0,) for on in along])]
        name = tree(f"""cnrg: 1
nodes:
  cell:   {{box: {{min: [0, 0, 0], max: [1, 1, 1]}}}}
  grains: {{intersection: [{{union: [{", ".join(copies)}]}}, cell]}}
  m:      {{sum: [{{difference: [cell, grains]}}, grains]}}
result: m
""")
        run("mesh", name, "--size", "0.4", "--no-certify", "--periodic", axes, "-o", "t.msh", "-o", "t.vtu", "-o", "t.msh2")
        run("mesh", name, "--size", "0.4", "--periodic", axes, "--surface", "--order", "2", "-o", "s.vtu")
        for file in ("t.vtu", "s.vtu"):
            grid = meshio.read(FOLDER / file)
            far = (grid.points == 1) & along
            twin = grid.point_data["twin"]
            assert (grid.points - grid.points[twin] == far).all() and far.any(axis=0).sum() == along.sum(), (axes, grains)
            at = {tuple(p): i for i, p in enumerate(grid.points)}
            for block in grid.cells:
                corners = grid.points[block.data[:, :3] if block.type.startswith("triangle") else block.data]
                for k in np.flatnonzero(along):
                    sides = [{frozenset(tuple(np.delete(p, k)) for p in cell) for cell in corners[(corners[:, :, k] == end).all(axis=1)]}
                             for end in (0, 1)]
                    assert sides[0] == sides[1] and (sides[0] or not block.type.startswith("triangle")), (axes, k, grains)
        shutil.copy(FOLDER / "t.msh2", FOLDER / "two.msh")
        links = meshio.read(FOLDER / "t.msh").gmsh_periodic
        points = meshio.read(FOLDER / "t.vtu").points  # by number, as meshio has these pairs
        for mesh in (meshio.read(FOLDER / "t.msh"), in_gmsh("t.msh"), meshio.read(FOLDER / "two.msh")):
            assert [(d, len(pairs)) for d, _, _, pairs in mesh.gmsh_periodic] == [(d, len(pairs)) for d, _, _, pairs in links]
            for _, _, affine, pairs in mesh.gmsh_periodic:
                by = np.subtract(*points[np.asarray(pairs).T])
                assert (abs(by - np.asarray(affine).reshape(4, 4)[:3, 3]) < 1e-12).all() and (by >= 0).all(), (axes, grains)
    name = tree("""cnrg: 1
nodes:
  low:  {box: {min: [0, 0, 0], max: [1, 1, 0.5]}}
  high: {box: {min: [0, 0, 0.5], max: [1, 1, 1]}}
  m:    {sum: [low, high]}
result: m
""")
    run("mesh", name, "--size", "0.3", "--periodic", "x,y,z", "-o", "t.inp")
    if not shutil.which("ccx"):
        print("left out: .inp in CalculiX, which is not installed (Debian 12: calculix-ccx)")
        return
    corner = int(np.flatnonzero((meshio.read(FOLDER / "t.inp").points == 0).all(axis=1))[0]) + 1
    (FOLDER / "deck.inp").write_text("\n".join([
        "*INCLUDE, INPUT=t.inp", "*MATERIAL, NAME=SOFT", "*ELASTIC", "1., .3", "*MATERIAL, NAME=HARD", "*ELASTIC", "3., .3",
        "*SOLID SECTION, ELSET=low, MATERIAL=SOFT", "*SOLID SECTION, ELSET=high, MATERIAL=HARD", "*STEP", "*STATIC", "*BOUNDARY",
        f"{corner}, 1, 3", "periodic-x, 1, 3", "periodic-y, 1, 3", "periodic-z, 1, 2", "periodic-z, 3, 3, .01",
        "*EL PRINT, ELSET=low", "S", "*EL PRINT, ELSET=high", "S", "*END STEP"]) + "\n")
    ended = subprocess.run(["ccx", "deck"], cwd=FOLDER, capture_output=True, text=True)
    said = ended.stdout + ended.stderr
    assert ended.returncode == 0 and "*ERROR" not in said and "Job finished" in said, said[-3000:]
    rows = [row.split() for row in (FOLDER / "deck.dat").read_text().splitlines()]
    stress = np.array([float(row[4]) for row in rows if len(row) == 8 and row[0].isdigit()])  # along z
    stiff = [young * .7 / (1.3 * .4) for young in (1, 3)]
    assert len(stress) > 100 and (abs(stress / (.01 / (.5 / stiff[0] + .5 / stiff[1])) - 1) < 1e-5).all(), stress


def flac3d():
    """Zones and faces by meshio, whose sets count through all blocks: each group measures what it should."""
    run("mesh", tree(), "--quiet", "--max-volume", "0.2", "-o", "t.f3grid")
    run("mesh", "m.yaml", "--quiet", "--surface", "--quads", "--size", "0.4", "-o", "q.f3grid")
    for file, exact in (("t.f3grid", ALL), ("q.f3grid", {key: value for key, value in ALL.items() if key[0] < 3})):
        mesh = meshio.read(FOLDER / file)
        starts = np.cumsum([0] + [len(block.data) for block in mesh.cells])
        assert max(int(key.rsplit(":", 1)[1]) for key in mesh.cell_sets) <= 4
        for key, rows in mesh.cell_sets.items():
            mesh.cell_sets[key] = [rows[i] - starts[i] if key.startswith(kind) else [] for i, kind in enumerate(
                "zone" if DIMENSION[block.type] == 3 else "face" for block in mesh.cells)]
        if file[0] == "q":
            mesh, count = split(mesh)
            assert count > 0
        check(totals(mesh, lambda block, i: {key.split(":", 1)[1].rsplit(":", 1)[0]: rows[i] for key, rows in mesh.cell_sets.items()}),
              {key: value for key, value in exact.items() if key[0] > 1}, file)


def in_mdump(file):
    """What MED's own library reads of a file, as its program prints it: with six decimals."""
    ended = subprocess.run(["mdump4", file, "NODALE", "FULL_INTERLACE", "0"], cwd=FOLDER, capture_output=True)
    text = ended.stdout.decode("utf-8", "replace")
    assert ended.returncode == 0 and not ended.stderr and "ERREUR" not in text, (text[-500:], ended.stderr)
    rows = lambda part, kind: np.array([line.split()[0:] for line in re.findall(r"^ \[ *\d+ \] : (.*)$", part, re.M)], kind)
    points = rows(text.split("Coordonnees des noeuds")[1].split("Numeros des familles")[0], float)
    kinds = {"MED_SEG2": "line", "MED_SEG3": "line3", "MED_TRIA3": "triangle", "MED_TRIA6": "triangle6", "MED_QUAD4": "quad",
             "MED_TETRA4": "tetra", "MED_TETRA10": "tetra10"}
    cells, families = [], []
    for kind, part in re.findall(r"^- Mailles de type (\w+) : \n(.*?)(?=^- Mailles|^\(\*)", text, re.M | re.S):
        nodes, numbers = part.split("Num\u00e9ros de familles : ")
        cells.append((kinds[kind], rows(nodes, int) - 1))
        families.append(np.array(numbers.split(), int))
    names = {int(number): re.findall(r"^   gro = (.*?) *$", groups, re.M) for number, groups in
             re.findall(r"et de numero (\S+) : \n(.*?)(?=^- Famille|\Z)", text, re.M | re.S)}
    return meshio.Mesh(points, cells, cell_data={"cell_tags": families}), names


def med():
    """Families of groups, in meshio and in MED's own library."""
    for order in (1, 2):
        whole, counts = meshed(order, "med")
        mesh = meshio.read(FOLDER / "t.med")
        np.testing.assert_array_equal(mesh.points, whole.in_order)
        [number] = [n for n, names in mesh.point_tags.items() if names == ["point of mark"]]
        assert (mesh.points[mesh.point_data["point_tags"] == number] == 6).all()
        if order == 2:
            check_middles(mesh, ".med")
        for found, tags, close in ((mesh, mesh.cell_tags, 1e-12), (*in_mdump("t.med"), 1e-5)):
            assert check_counts(found, counts, ".med") == {d: counts[d] for d in (1, 2, 3)}

            def rows_of(block, i):
                numbers = found.cell_data["cell_tags"][i]
                groups = {}
                for number, names in tags.items():
                    for name in names:
                        groups.setdefault(name, []).append(np.flatnonzero(numbers == number))
                return {re.sub("_2$", "", name): np.concatenate(rows) for name, rows in groups.items()}
            check(totals(found, rows_of), ALL, f".med {order}", close)
            for block in found.cells:
                if DIMENSION[block.type] == 3:  # seen from the first three corners the fourth is in front
                    p = found.points[block.data]
                    assert (np.linalg.det(p[:, 1:4] - p[:, :1]) < 0).all()


def xdmf():
    """A grid for each dimension, points in one order for all; groups by number, further ones as arrays."""
    for order in (1, 2):
        whole, counts = meshed(order, "xdmf", "faces.xdmf", "edges.xdmf", "points.xdmf")
        found, points = {}, np.zeros((0, 3))
        for dimension, file in ((3, "t.xdmf"), (2, "t.faces.xdmf"), (1, "t.edges.xdmf"), (0, "t.points.xdmf")):
            mesh = meshio.read(FOLDER / file)
            np.testing.assert_array_equal(mesh.points[:len(points)], points)
            points = mesh.points
            [block] = mesh.cells
            if dimension == 3:  # FEniCS takes no point that is in no cell
                assert set(block.data.ravel()) == set(range(len(points)))
            assert DIMENSION[block.type] == dimension and len(block.data) == counts[dimension]
            numbers = {name: int(number) for name, (number, _) in mesh.field_data.items()}
            assert all(int(d) == dimension for _, d in mesh.field_data.values())
            [group] = mesh.cell_data["group"]
            rows = {name: np.flatnonzero(group == number) for name, number in numbers.items()}
            for name, [values] in mesh.cell_data.items():
                if name in numbers:
                    assert set(values) == {0, 1}
                    rows[name] = np.union1d(rows[name], np.flatnonzero(values))
            if dimension:
                found.update(totals(mesh, lambda b, i: rows))
                if order == 2:
                    check_middles(mesh, file)
            if dimension == 2:
                [thickness] = mesh.cell_data["thickness"]
                assert set(np.flatnonzero(thickness == 1 / 5)) == set(rows["flap: a sheet"])
                assert np.isnan(np.delete(thickness, rows["flap: a sheet"])).all()
        check(found, ALL, f".xdmf {order}")
        assert sorted(points.tolist()) == sorted(whole.in_order.tolist())
    run("eval", tree("cnrg: 1\nnodes: {p: {points: [[0, 0, 0]]}}\nresult: p\n", "p.yaml"), "--quiet", "-o", "p.msh")
    said = run("mesh", tree("cnrg: 1\nnodes: {p: {sphere: {center: [0, 0, 0], radius: 1, segments: 8}}}\nresult: p\n",
                            "p.yaml"), "--quiet", "-o", "p.edges.xdmf", status=2).stderr
    assert "the mesh has no edges" in said, said
    # Without tetrahedra NAME.xdmf has what is there of the highest dimension: sheets, or else wires.
    faces = """cnrg: 1
nodes:
  sheet: {polygon: [[0, 0, 0], [2, 0, 0], [2, 1, 0], [0, 1, 0]]}
  cable: {polyline: [[0, 0, 0], [0, 0, 3]]}
  m:     {union: [sheet, cable]}
result: m
"""
    for node, dimension, measure in (("m", 2, 2), ("sheet", 2, 2), ("cable", 1, 3)):
        run("mesh", tree(faces, "f.yaml"), "--node", node, "--surface", "--size", "0.5", "--quiet", "-o", "f.xdmf")
        mesh = meshio.read(FOLDER / "f.xdmf")
        [block] = mesh.cells
        assert DIMENSION[block.type] == dimension and len(block.data) > 3, (node, block)
        assert set(block.data.ravel()) == set(range(len(mesh.points))), node
        assert abs(measures_of(mesh.points[block.data]).sum() - measure) < 1e-12, node
    run("mesh", tree(faces, "f.yaml"), "--surface", "--quiet", "-o", "f.xdmf", "-o", "f.edges.xdmf")
    whole, edges = meshio.read(FOLDER / "f.xdmf"), meshio.read(FOLDER / "f.edges.xdmf")
    np.testing.assert_array_equal(edges.points[:len(whole.points)], whole.points)
    assert abs(measures_of(edges.points[edges.cells[0].data]).sum() - 9) < 1e-12


def sets_of(file):
    """The sets of a .h5m: by name of a group its members, surfaces with their senses, and what is in each."""
    with h5py.File(FOLDER / file) as f:
        root = f["tstt"]
        ends = root["sets/list"][:]
        start = root["sets/list"].attrs["start_id"]

        def parts(column, data):
            begin = np.concatenate([[0], ends[:-1, column] + 1])
            return {start + i: data[a:b + 1] for i, (a, b) in enumerate(zip(begin, ends[:, column]))}
        contents = parts(0, root["sets/contents"][:].astype(int))
        children = parts(1, root["sets/children"][:].astype(int))
        parents = parts(2, root["sets/parents"][:].astype(int))
        tag = lambda name: dict(zip(root[f"tags/{name}/id_list"][:].astype(int), root[f"tags/{name}/values"][:]))
        text = lambda value: bytes(value).rstrip(b"\0").decode()
        dimension = tag("GEOM_DIMENSION")
        assert {text(v) for v in tag("CATEGORY").values()} == {"Surface", "Volume", "Group"}
        assert len(ends) == len(dimension) and root.attrs["max_id"] == start + len(ends) - 1
        blocks = {}
        for kind, block in root["elements"].items():
            blocks[kind] = block["connectivity"].attrs["start_id"], block["connectivity"][:].astype(int) - 1
        return (root["nodes/coordinates"][:], blocks, contents, children, parents, dimension, tag("GEOM_SENSE_2"),
                {text(name): contents[i] for i, name in tag("NAME").items()})


def h5m():
    """Volumes by their surfaces with senses, as a transport code takes them, by groups of materials."""
    name = tree()
    run("eval", name, "--quiet", "-o", "e.h5m")
    meshed(1, "h5m")
    for file, has_tetrahedra in (("e.h5m", False), ("t.h5m", True)):
        points, blocks, contents, children, parents, dimension, senses, groups = sets_of(file)
        mesh = meshio.read(FOLDER / file)
        np.testing.assert_array_equal(mesh.points, points)
        assert {b.type for b in mesh.cells} == {"line", "triangle"} | ({"tetra"} if has_tetrahedra else set())
        first, triangles = blocks["Tri3"]

        def rows(kind, members):
            start, cells = blocks[kind]
            members = members[(members >= start) & (members < start + len(cells))]
            return cells[members - start]
        # Six times what the surfaces of a volume enclose; "forward" is out of the first of both.
        volumes = {}
        for volume in (i for i, d in dimension.items() if d == 3):
            total = 0
            for surface in children[volume]:
                assert volume in parents[surface] and dimension[surface] == 2
                behind, in_front = senses[surface]
                assert volume in (behind, in_front) and behind != in_front
                p = points[rows("Tri3", contents[surface])]
                enclosed = np.einsum("ij,ij->i", p[:, 0], np.cross(p[:, 1], p[:, 2])).sum() / 6
                total += enclosed if behind == volume else -enclosed
            volumes[volume] = total
            if has_tetrahedra:
                assert abs(measures_of(points[rows("Tet4", contents[volume])]).sum() - total) < 1e-12
        check({name: sum(volumes[v] for v in members) for name, members in groups.items()
               if name.startswith(("mat:", "rock", "seam", "temp"))
               and (set(members) <= set(volumes))},
              {"mat:granite": 18, "mat:ore": 9, "rock 1": 9, "rock 3": 9, "rock": 18, "seam": 9, "temp:300": 18}, file)
        for name, area in BOUNDARIES.items():
            total = sum(measures_of(points[rows("Tri3", contents[s])]).sum() for s in groups[name])
            assert abs(total - area) < 1e-12 * area, (name, total)
        assert sum(1 for sense in senses.values() if 0 not in sense) == 2  # the walls
        sheet = groups["flap_ a sheet"]
        assert abs(measures_of(points[rows("Tri3", sheet)]).sum() - 1) < 1e-12
        inside = np.concatenate([contents[i] for i, d in dimension.items() if d == 2])
        assert not np.isin(sheet, inside).any()
        for wire, length in (("bolt", 1), ("wire of cable", 7)):
            assert abs(measures_of(points[rows("Edge2", groups[wire])]).sum() - length) < 1e-12
        assert (points[groups["point of mark"] - 1] == 6).all()
    long = MODEL.replace("granite", "g" * 40)
    said = run("eval", tree(long, "long.yaml"), "--quiet", "-o", "long.h5m", status=2).stderr
    assert "31 bytes" in said and not (FOLDER / "long.h5m").exists(), said


def surfaces():
    """Without tetrahedra all triangles are shells; in every format that `cnrg eval` writes."""
    run("eval", tree(), "--quiet", "-o", "e.inp", "-o", "e.bdf", "-o", "e.med")
    faces = {key: value for key, value in ALL.items() if key[0] < 3}
    mesh = meshio.read(FOLDER / "e.inp")
    names = dict(re.findall(r"^\*\* (\S+) is (.*)$", (FOLDER / "e.inp").read_text(), re.M))
    check(totals(mesh, lambda block, i: {names.get(name, name): rows[i] for name, rows in mesh.cell_sets.items()}),
          faces, "e.inp")
    text = (FOLDER / "e.bdf").read_text()
    names = {({"PSHELL": 2, "PROD": 1}[kind], int(number)): name
             for kind, number, name in re.findall(r"^\$ (P\w+) (\d+): (.*)$", text, re.M)}
    first = {key: value for key, value in FIRST.items() if key[0] < 3}
    check(by_reference(meshio.read(FOLDER / "e.bdf"), "nastran:ref", names), first, "e.bdf")
    found, tags = in_mdump("e.med")
    rows = lambda block, i: {re.sub("_2$", "", name): np.flatnonzero(np.isin(found.cell_data["cell_tags"][i], [
        number for number, names in tags.items() if name in names])) for name in sum(tags.values(), [])}
    check(totals(found, rows), faces, "e.med", 1e-5)


def split(mesh):
    """With each quadrilateral as two triangles, once it was found flat and convex; and how many there were."""
    cells, of, count = [], [], 0
    for i, block in enumerate(mesh.cells):
        if block.type != "quad":
            cells.append((block.type, block.data))
            of.append((i, np.arange(len(block.data))))
            continue
        count += len(block.data)
        p = mesh.points[block.data]
        turns = [np.cross(p[:, (k + 1) % 4] - p[:, k], p[:, (k + 2) % 4] - p[:, (k + 1) % 4]) for k in range(4)]
        for turn in turns[1:]:
            assert (np.einsum("ij,ij->i", turns[0], turn) > 0).all(), "not convex, or corners not in turn"
        flat = np.abs(np.einsum("ij,ij->i", turns[0], p[:, 3] - p[:, 0]))
        assert (flat < 1e-5).all(), flat.max()
        cells.append(("triangle", np.concatenate([block.data[:, :3], block.data[:, [0, 2, 3]]])))
        of.append((i, np.tile(np.arange(len(block.data)), 2)))
    data = {key: [np.asarray(values[i])[rows] for i, rows in of] for key, values in mesh.cell_data.items()}
    sets = {}
    for name, rows in mesh.cell_sets.items():
        if name.startswith("gmsh:"):
            continue
        sets[name] = []
        for i, places in of:
            member = np.zeros(len(mesh.cells[i].data), bool)
            if rows[i] is not None and len(rows[i]):
                member[np.asarray(rows[i], int)] = True
            sets[name].append(np.flatnonzero(member[places]))
    return meshio.Mesh(mesh.points, cells, cell_data=data, cell_sets=sets), count


def quads():
    """Of a surface mesh: each reader finds as many, and groups measure what they should."""
    extensions = ("msh", "vtu", "mesh", "inp", "bdf", "med", "faces.xdmf")
    run("mesh", tree(), "--quiet", "--surface", "--quads", "--size", "0.4",
        *(word for extension in extensions for word in ("-o", f"q.{extension}")))
    faces = {key: value for key, value in ALL.items() if key[0] < 3}
    first = {key: value for key, value in FIRST.items() if key[0] < 3}
    whole, count = split(meshio.read(FOLDER / "q.msh"))
    triangles = sum(len(b.data) for b in whole.cells if b.type == "triangle") - 2 * count
    assert count > 2 * triangles > 0, (count, triangles)
    by_sets = lambda mesh, named: totals(mesh, lambda block, i: {
        named.get(name, name): rows[i] for name, rows in mesh.cell_sets.items()})
    check({key: value for key, value in by_sets(whole, {}).items() if key != (1, "edges")}, faces, "q.msh")
    again, n = split(in_gmsh("q.msh"))
    assert n == count
    mesh, n = split(meshio.read(FOLDER / "q.vtu"))
    assert n == count
    mesh, n = split(meshio.read(FOLDER / "q.faces.xdmf"))
    assert n == count and abs(sum(measures_of(mesh.points[b.data]).sum() for b in mesh.cells) - (21 + 21 + 12 + 9 + 9 + 1)) < 1e-9
    mesh, n = split(meshio.read(FOLDER / "q.inp"))
    names = dict(re.findall(r"^\*\* (\S+) is (.*)$", (FOLDER / "q.inp").read_text(), re.M))
    assert n == count
    check(by_sets(mesh, names), faces, "q.inp")
    text = (FOLDER / "q.bdf").read_text()
    names = {({"PSHELL": 2, "PROD": 1}[kind], int(number)): name
             for kind, number, name in re.findall(r"^\$ (P\w+) (\d+): (.*)$", text, re.M)}
    mesh, n = split(meshio.read(FOLDER / "q.bdf"))
    assert n == count
    check(by_reference(mesh, "nastran:ref", names), first, "q.bdf")
    text = (FOLDER / "q.mesh").read_text()
    names = {({"edges": 1, "triangles": 2}[kind], int(number)): name for kind, number, name in
             re.findall(r"^# (edges|triangles) (\d+) (.*)$", text, re.M)}
    for mesh, array in ((meshio.read(FOLDER / "q.mesh"), "medit:ref"), (in_gmsh("q.mesh"), "gmsh:geometrical")):
        mesh, n = split(mesh)
        assert n == count, (array, n, count)
        check(by_reference(mesh, array, names), first, f"q.mesh {array}")
    found, tags = in_mdump("q.med")
    found, n = split(found)
    assert n == count
    rows = lambda block, i: {re.sub("_2$", "", name): np.flatnonzero(np.isin(found.cell_data["cell_tags"][i], [
        number for number, names in tags.items() if name in names])) for name in sum(tags.values(), [])}
    check(totals(found, rows), faces, "q.med", 1e-5)
    run("mesh", "m.yaml", "--surface", "--quads", "-o", "q.h5m", status=2)
    assert not (FOLDER / "q.h5m").exists()


def same():
    """The same bytes each time, and names that are long, of any script, or equal but for case."""
    words = ["l" * 300, "l" * 299 + "m", "Wall", "wall", "a/b:c", "3 things", "Ö — 岩", "a\nb", "x" * 28]
    nodes = ", ".join(f'b{i}: {{box: {{min: [{2 * i}, 0, 0], max: [{2 * i + 1}, 1, 1]}}, name: "{word}"}}'
                      for i, word in enumerate(w.replace("\n", "\\n") for w in words))
    name = tree(f"cnrg: 1\nnodes: {{{nodes}, m: {{union: [{', '.join(f'b{i}' for i in range(len(words)))}]}}}}\nresult: m\n")
    files = [f"{{}}.{extension}" for extension in ("inp", "bdf", "h5m", "med", "xdmf", "mesh")]
    for run_of in ("a", "b"):
        run("mesh", name, "--quiet", *(word for file in files for word in ("-o", file.format(run_of))))
    for file in files:
        assert (FOLDER / file.format("a")).read_bytes() == (FOLDER / file.format("b")).read_bytes(), file
    mesh = meshio.read(FOLDER / "a.inp")
    labels = [key for key in mesh.cell_sets if sum(len(rows) for rows in mesh.cell_sets[key])]
    assert len({label.upper() for label in labels}) == len(labels) == len(words)
    assert all(re.fullmatch(r"[A-Za-z][\w-]{0,79}", label, re.A) for label in labels), labels
    for label in labels:
        rows = mesh.cell_sets[label]
        total = sum(measures_of(mesh.points[b.data[rows[i]]]).sum() for i, b in enumerate(mesh.cells))
        assert abs(total - 1) < 1e-12
    groups = [name for names in meshio.read(FOLDER / "a.med").cell_tags.values() for name in names]
    assert len(set(groups)) == 2 * len(words) + len(words), groups  # regions, their boundaries, what comes from each
    _, _, _, _, _, _, _, groups = sets_of("a.h5m")
    assert len(groups) == 3 * len(words) and all(len(group.encode()) < 32 for group in groups)


{"msh": msh, "medit": medit, "nastran": nastran, "abaqus": abaqus, "med": med, "xdmf": xdmf, "h5m": h5m,
 "surfaces": surfaces, "quads": quads, "same": same, "faults": faults, "periodic": periodic,
 "flac3d": flac3d}[CASE]()
