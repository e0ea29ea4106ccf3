"""Files of people to models: geology, fracture networks, cities. One function per format, named in a table.

Coordinates of networks are the decimals that the file has; those of meshes are the doubles that they round to, as
programs read them. A network given by angles is built in rational rotations, so that its polygons are planar.
"""
import ast
import json
import math
import re
import shutil
import struct
import subprocess
import tempfile
import xml.etree.ElementTree as xml
from collections import defaultdict
from fractions import Fraction
from pathlib import Path

from binaries import read_dagmc, read_ply
from model import Model, Sheet, Solid, Unread, Wire, is_planar, merged, planar_faces, surface, used_only

NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"


def double(text):
    return Fraction(float(text))


def decimal(text):
    return Fraction(text)


def points_of(words, number=decimal):
    values = [number(w) for w in words]
    return [tuple(values[i:i + 3]) for i in range(0, len(values), 3)]


def polygon(name, points, model):
    """A fracture; one that is in no plane is a fan of triangles."""
    faces = [[list(range(len(points)))]]
    if not is_planar(points):
        faces = [[[0, i, i + 1]] for i in range(1, len(points) - 1)]
        model.notes.append(f"{name} is not planar: triangles")
    points, faces = merged(points, faces)
    if faces:
        model.sheets.append(Sheet(name, points, faces))
    else:
        model.notes.append(f"{name} has no area: left out")


def polyline(name, points, model):
    distinct = [p for i, p in enumerate(points) if i == 0 or p != points[i - 1]]
    if len(distinct) > 1:
        wire(name, distinct, [(i, i + 1) for i in range(len(distinct) - 1)], model)


def wire(name, points, segments, model):
    """Segments that two lines share count once."""
    numbers = {}
    number = [numbers.setdefault(p, len(numbers)) for p in points]
    segments = sorted({tuple(sorted((number[a], number[b]))) for a, b in segments if number[a] != number[b]})
    if segments:
        model.wires.append(Wire(name, list(numbers), segments))


# GOCAD ---------------------------------------------------------------------------------------------------------

def gocad_objects(path):
    """(kind, name, lines) of each object in a file."""
    objects = []
    for line in path.read_text(errors="replace").splitlines():
        words = line.split()
        if not words:
            continue
        if words[0] == "GOCAD":
            objects.append([words[1], "", []])
        elif not objects:
            raise Unread("it does not begin with GOCAD")
        else:
            if words[0].startswith("name:") and not objects[-1][1]:
                objects[-1][1] = line.split(":", 1)[1].strip()
            objects[-1][2].append(words)
    return objects


def gocad_geometry(lines):
    """Points, triangles and segments."""
    number, points, triangles, segments = {}, [], [], []
    previous = None
    for words in lines:
        if words[0] in ("VRTX", "PVRTX"):
            number[words[1]] = len(points)
            points.append(tuple(double(w) for w in words[2:5]))
        elif words[0] in ("ATOM", "PATOM"):
            number[words[1]] = number[words[2]]
        elif words[0] == "TRGL":
            triangles.append([[number[w] for w in words[1:4]]])
        elif words[0] == "SEG":
            segments.append((number[words[1]], number[words[2]]))
        elif words[0] == "WREF":
            previous = tuple(double(w) for w in words[1:4])
            origin = previous
            points.append(origin)
        elif words[0] == "PATH":
            p = (origin[0] + double(words[3]), origin[1] + double(words[4]), double(words[2]))
            points.append(tuple(Fraction(float(x)) for x in p))
            segments.append((len(points) - 2, len(points) - 1))
    return points, triangles, segments


def read_gocad(path):
    model = Model(path.stem)
    for kind, name, lines in gocad_objects(path):
        points, triangles, segments = gocad_geometry(lines)
        if triangles:
            surface(name, points, triangles, model)
        if segments:
            wire(name, points, segments, model)
    if not model.solids and not model.sheets and not model.wires:
        raise Unread("no triangles and no lines in it")
    return model


def read_gocad_model(path):
    """A Model3d: all of its surfaces together bound its regions; every cavity is one."""
    model = Model(path.stem)
    points, triangles, stated = [], [], 0
    for kind, name, lines in gocad_objects(path):
        if kind == "Model3d":
            stated = sum(1 for w in lines if w[0] == "REGION" and w[2] != "Universe")
            continue
        p, t, _ = gocad_geometry(lines)
        triangles += [[[i + len(points) for i in loops[0]]] for loops in t]
        points += p
    surface("model", points, triangles, model, fill="cells")
    model.notes.append(f"{stated} regions by the file")
    return model


# Fracture networks ---------------------------------------------------------------------------------------------

def turn(degrees):
    """Cosine and sine of nearly this angle with cos^2 + sin^2 = 1; exact for right angles."""
    quarters, rest = divmod(degrees + 45, 90)
    t = Fraction(math.tan(math.radians(rest - 45) / 2))
    c, s = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
    for _ in range(int(quarters) % 4):
        c, s = -s, c
    return c, s


def rotate(p, axis, degrees):
    c, s = turn(degrees)
    i, j = [(1, 2), (2, 0), (0, 1)][axis]
    q = list(p)
    q[i], q[j] = c * p[i] - s * p[j], s * p[i] + c * p[j]
    return tuple(q)


def ellipse(a, b, n):
    """n points; the axes are exact."""
    result = []
    for i in range(n):
        c, s = turn(360 * i / n)
        result.append((a * c, b * s, Fraction(0)))
    return result


def read_csv(path):
    """PorePy: the box and polygons by their corners; or ellipses by centre, axes and angles in degrees."""
    rows = [[w.strip() for w in line.split(",")] for line in path.read_text().splitlines() if line.strip()]
    model = Model(path.parent.name if path.stem in ("fractures", "fracture_network") else path.stem)
    if rows and all(len(r) == 9 for r in rows):
        for i, row in enumerate(rows):
            v = [decimal(w) for w in row]
            major, strike, dip = map(float, v[5:8])
            corners = []
            for p in ellipse(v[3], v[4], int(v[8])):
                p = rotate(rotate(rotate(rotate(p, 2, major), 2, -strike), 0, dip), 2, strike)
                corners.append(tuple(x + c for x, c in zip(p, v[:3])))
            polygon(f"fracture {i}", corners, model)
        return model
    for i, row in enumerate(rows):
        if len(row) == 6 and i == 0:
            low, high = points_of(row)
            model.box = (low, high)
        elif len(row) >= 9 and len(row) % 3 == 0:
            polygon(f"fracture {i}", points_of(row), model)
        else:
            raise Unread(f"line {i + 1} is neither a box nor a polygon nor an ellipse")
    return model


def read_dat(path):
    """dfnWorks: fractures by their corners, or by radius, angle, centre and normal; or lines of points (a well)."""
    text = re.sub(r"//.*", "", path.read_text(errors="replace"))
    text = "\n".join(l for l in text.splitlines() if not re.match(r"\s*/?\*{3}", l))
    model = Model(path.stem)
    words = text.split()
    if words and all(re.fullmatch(NUMBER, w) for w in words):
        rows = [line.split() for line in text.splitlines() if line.split()]
        if all(len(r) == 3 for r in rows):
            polyline("well", points_of(words), model)
            return model
        raise Unread("rows of two numbers: an outline in the plane, and no model")
    sections = dict(re.findall(r"([A-Za-z_]+)\s*:\s*([^:]*?)(?=[A-Za-z_]+\s*:|\Z)", text, re.S))

    def values(key):
        return re.findall(NUMBER, sections.get(key, ""))

    if "Coordinates" in sections:
        lists = re.findall(r"\{([^}]*)\}", sections["Coordinates"])
        corners = [tuple(decimal(w) for w in re.findall(NUMBER, c)) for c in lists]
        n = int(values("nNodes")[0]) if "nNodes" in sections else 4
        count = int((values("nRectangles") or values("nEllipses") or values("nPolygons"))[0])
        if len(corners) < n * count:
            raise Unread(f"{count} fractures of {n} corners are announced, and {len(corners)} corners are there")
        for i in range(count):
            polygon(f"fracture {i}", corners[n * i:n * i + n], model)
        return model
    round_ = "nUserEll" in sections
    if not round_ and "nUserRect" not in sections:
        raise Unread("neither fractures nor a line of points")
    count = int((values("nUserEll") or values("nUserRect"))[0])
    radii, aspects = values("Radii"), values("Aspect_Ratio") or ["1"] * count
    degrees = "degree" in sections.get("AngleOption", "") or "1" in values("AngleOption")
    betas = [float(w) if degrees else math.degrees(float(w)) for w in values("Beta")]
    centres = points_of(values("Translation"))
    corner_counts = [int(w) for w in values("Number_of_Vertices")] or [4] * count
    if "Trend_Plunge" in sections:
        pairs = [tuple(map(float, values("Trend_Plunge")[2 * i:2 * i + 2])) for i in range(count)]
        turns = [(trend, 90 - plunge) for trend, plunge in pairs]
    else:
        normals = [tuple(map(float, p)) for p in points_of(values("Normal"))]
        turns = [(math.degrees(math.atan2(n[1], n[0])),
                  math.degrees(math.atan2(math.hypot(n[0], n[1]), n[2]))) for n in normals]
    if min(map(len, (radii, aspects, betas, centres, corner_counts, turns))) < count:
        raise Unread(f"{count} fractures are announced, and there is not one line for each")
    for i in range(count):
        a = decimal(radii[i])
        b = a * decimal(aspects[i])
        corners = ellipse(a, b, corner_counts[i]) if round_ else [(a, b, 0), (-a, b, 0), (-a, -b, 0), (a, -b, 0)]
        round_the_axis, from_the_axis = turns[i]
        placed = []
        for p in corners:
            p = rotate(tuple(map(Fraction, p)), 2, betas[i])
            p = rotate(rotate(rotate(p, 2, -round_the_axis), 1, from_the_axis), 2, round_the_axis)
            placed.append(tuple(x + c for x, c in zip(p, centres[i])))
        polygon(f"fracture {i}", placed, model)
    return model


def read_python(path):
    """Arrays of 3 rows of numbers in a Python source, read and not run: polygons, and with two columns wells."""
    model = Model(path.stem)
    for node in ast.walk(ast.parse(path.read_text())):
        is_array = isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "array"
        if not is_array or not node.args:
            continue
        try:
            rows = ast.literal_eval(node.args[0])
            columns = list(zip(*rows, strict=True))
        except (ValueError, TypeError):
            continue
        if len(rows) != 3 or len(columns) < 2:
            continue
        points = [tuple(Fraction(repr(x)) for x in c) for c in columns]
        place = f"line {node.lineno}"
        polyline(f"well of {place}", points, model) if len(points) == 2 else polygon(place, points, model)
    if not model.sheets and not model.wires:
        raise Unread("no array of corners in it")
    return model


def read_dev(path):
    """A deviation survey of Petrel: columns X, Y and Z under a row of names."""
    rows = [l.split() for l in path.read_text(errors="replace").splitlines() if l.strip() and l[0] != "#"]
    names = rows[0] if rows else []
    if not {"X", "Y", "Z"} <= set(names):
        raise Unread("no columns X, Y and Z")
    at = [names.index(n) for n in "XYZ"]
    model = Model(path.stem)
    polyline("well", [tuple(decimal(row[i]) for i in at) for row in rows[1:]], model)
    return model


# Meshes --------------------------------------------------------------------------------------------------------

def read_msh(path, name=None):
    """Gmsh 2: tetrahedra are regions by their physical group, triangles sheets, lines wires."""
    lines = path.read_text().split("\n")
    if "$MeshFormat" not in lines[0] or not lines[1].startswith("2"):
        raise Unread("only version 2 of the format, in text, is read")
    points, names, cells = {}, {}, defaultdict(lambda: defaultdict(list))
    i = 0
    while i < len(lines):
        section, i = lines[i].strip(), i + 1
        if section not in ("$Nodes", "$Elements", "$PhysicalNames"):
            continue
        count = int(lines[i])
        for line in lines[i + 1:i + 1 + count]:
            words = line.split()
            if section == "$Nodes":
                points[words[0]] = tuple(double(w) for w in words[1:4])
            elif section == "$PhysicalNames":
                names[words[0], words[1]] = line.split('"')[1]
            else:
                kind, tags = int(words[1]), int(words[2])
                if kind not in (1, 2, 3, 4, 15):
                    raise Unread(f"elements of kind {kind}: only straight lines, triangles, quadrilaterals and "
                                 "tetrahedra are read")
                kind = 2 if kind == 3 else kind
                cells[kind][words[3] if tags else "0"].append(words[3 + tags:])
        i += count
    model = Model(name or path.stem)
    number = {tag: n for n, tag in enumerate(points)}
    coordinates = list(points.values())
    if cells[4]:
        model.solids.append(solid_of_tetrahedra(coordinates, number, cells[4]))
    for group, triangles in cells[2].items():
        label = names.get(("2", group), group)
        p, f = merged(coordinates, [[[number[t] for t in c]] for c in triangles])
        f, bent = planar_faces(p, f)
        if bent:
            model.notes.append(f"{bent} faces are not planar: triangles")
        if f:
            model.sheets.append(Sheet(label, *used_only(p, f), overlap=True))
    for group, segments in cells[1].items():
        used = sorted({t for c in segments for t in c}, key=number.get)
        local = {t: n for n, t in enumerate(used)}
        wire(names.get(("1", group), group), [points[t] for t in used],
             [(local[a], local[b]) for a, b in segments], model)
    return model


def solid_of_tetrahedra(points, number, groups):
    """The walls of the groups: triangles with one tetrahedron, or with two of different groups."""
    label = {group: n + 1 for n, group in enumerate(groups)}
    sides, volume = {}, Fraction(0)
    for group, cells in groups.items():
        for cell in cells:
            a, b, c, d = (number[t] for t in cell)
            p = [points[n] for n in (a, b, c, d)]
            u, v, w = ([x - y for x, y in zip(q, p[0])] for q in p[1:])
            det = (u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
                   u[2] * (v[0] * w[1] - v[1] * w[0]))
            volume += abs(det) / 6
            if det < 0:
                c, d = d, c
            for face in ((a, c, b), (a, b, d), (b, c, d), (a, d, c)):   # seen from outside
                sides.setdefault(frozenset(face), []).append((face, label[group]))
    faces, labels = [], []
    for members in sides.values():
        if len(members) > 2:
            raise Unread("three tetrahedra share a triangle")
        (face, inside), (_, outside) = members[0], (members[1] if len(members) == 2 else (None, 0))
        if inside != outside:
            faces.append([list(face)])
            labels.append((outside, inside))
    p, f = used_only(points, faces)
    return Solid("tetrahedra", p, f, fill=None, sides=labels, volume=volume)


def read_geo(path):
    """A script of Gmsh, as Gmsh triangulates it; every cavity is a region."""
    if not shutil.which("gmsh"):
        raise Unread("gmsh is not installed (apt-get install gmsh)")
    if "SystemCall" in path.read_text(errors="replace"):
        raise Unread("it wants to run other programs")
    with tempfile.TemporaryDirectory() as folder:
        # A copy: a script may include its neighbours, and may write files beside itself.
        copy, out = Path(folder) / "scripts" / "here", Path(folder) / "out.msh"
        copy.mkdir(parents=True)
        for script in path.parent.glob("*.geo"):
            (copy / script.name).write_bytes(script.read_bytes())
        try:
            done = subprocess.run(["gmsh", "-2", "-v", "1", "-format", "msh22", "-save_all", "-nopopup", "-o", out,
                                   path.name], cwd=copy, capture_output=True, text=True, timeout=60)
        except subprocess.TimeoutExpired:
            raise Unread("Gmsh does not triangulate it in 60 s") from None
        if not out.exists():
            written = sorted((Path(folder) / "scripts").rglob("*.msh"))
            out = written[0] if len(written) == 1 else out    # the script has saved its mesh by itself
        said = (done.stdout + done.stderr).strip().split("\n")[0]
        if not out.exists():
            raise Unread(f"Gmsh does not triangulate it: {said}")
        flat = read_msh(out, path.stem)
    model = Model(path.stem)
    points, faces = [], []
    for sheet in flat.sheets:
        faces += [[[i + len(points) for i in loops[0]]] for loops in sheet.faces]
        points += sheet.points
    if not faces:
        raise Unread("Gmsh finds no surface in it")
    surface("surfaces", points, faces, model, fill="cells")
    model.notes.append("as Gmsh triangulates it")
    return model


def read_off(path):
    words = [w for line in path.read_text().splitlines() for w in line.split("#")[0].split()]
    if not words or words[0] != "OFF":
        raise Unread("no plain OFF")
    n, m, at = int(words[1]), int(words[2]), 4
    points = points_of(words[at:at + 3 * n], double)
    at += 3 * n
    faces = []
    for _ in range(m):
        k = int(words[at])
        faces.append([[int(w) for w in words[at + 1:at + 1 + k]]])
        at += 1 + k
    model = Model(path.stem)
    surface(path.stem, points, faces, model)
    return model


def read_obj(path):
    points, faces, segments = [], [], []
    for line in path.read_text().splitlines():
        words = line.split("#")[0].split()
        if not words:
            continue
        at = [int(w.split("/")[0]) for w in words[1:]] if words[0] in "fl" else []
        at = [i - 1 if i > 0 else len(points) + i for i in at]
        if words[0] == "v":
            points.append(tuple(double(w) for w in words[1:4]))
        elif words[0] == "f":
            faces.append([at])
        elif words[0] == "l":
            segments += list(zip(at, at[1:]))
    model = Model(path.stem)
    if faces:
        surface(path.stem, points, faces, model)
    if segments:
        wire(path.stem, points, segments, model)
    return model


def read_stl(path):
    data = path.read_bytes()
    count = struct.unpack_from("<I", data, 80)[0] if len(data) >= 84 else None
    if count is not None and len(data) == 84 + 50 * count:
        values = [struct.unpack_from("<9f", data, 84 + 50 * i + 12) for i in range(count)]
        points = [tuple(map(Fraction, v[k:k + 3])) for v in values for k in (0, 3, 6)]
    elif data.lstrip().startswith(b"solid"):
        points = [tuple(double(w) for w in v) for v in re.findall(rb"vertex\s+(\S+)\s+(\S+)\s+(\S+)", data)]
    else:
        raise Unread("neither STL in text nor as long as its triangles in binary")
    model = Model(path.stem)
    surface(path.stem, points, [[[i, i + 1, i + 2]] for i in range(0, len(points) - 2, 3)], model)
    return model


def read_cad(path):
    model = Model(path.stem)
    model.cad = path
    return model


def read_tetgen(path):
    """`.poly` and `.smesh`: facets with holes; a facet of two corners is a wire. Every cavity is a region."""
    rows = iter([l.split("#")[0].split() for l in path.read_text().splitlines() if l.split("#")[0].split()])
    count = int(next(rows)[0])
    number, points, faces, segments = {}, [], [], []
    for _ in range(count):
        row = next(rows)
        number[row[0]] = len(points)
        points.append(tuple(double(w) for w in row[1:4]))
    try:
        for _ in range(int(next(rows)[0])):
            row = next(rows)
            if path.suffix == ".poly":
                loops = [[number[w] for w in r[1:1 + int(r[0])]] for r in (next(rows) for _ in range(int(row[0])))]
                for _ in range(int(row[1]) if len(row) > 1 else 0):
                    next(rows)
            else:
                loops = [[number[w] for w in row[1:1 + int(row[0])]]]
            if len(loops[0]) == 2:
                segments.append(tuple(loops[0]))
            else:
                faces.append(loops)
    except (KeyError, StopIteration) as fault:
        raise Unread(f"its facets name points that are not there ({fault})") from None
    model = Model(path.stem)
    if faces:
        closed = len(faces) > 3
        surface(path.stem, points, faces, model, fill="cells" if closed else None)
    if segments:
        wire(path.stem, points, segments, model)
    return model


# Cities --------------------------------------------------------------------------------------------------------

def city_solid(name, shells, model):
    """Shells of polygons with holes, in coordinates; the solid is what they wind around."""
    numbers, faces = {}, []
    for shell in shells:
        for loops in shell:
            faces.append([[numbers.setdefault(p, len(numbers)) for p in loop] for loop in loops])
    surface(name, list(numbers), faces, model, fill="winding")


def read_cityjson(path):
    data = json.loads(path.read_text(), parse_float=decimal, parse_int=decimal)
    scale, offset = (1, 1, 1), (0, 0, 0)
    if "transform" in data:
        scale, offset = data["transform"]["scale"], data["transform"]["translate"]
    points = [tuple(Fraction(x) * s + t for x, s, t in zip(p, scale, offset)) for p in data["vertices"]]
    model = Model(path.stem + " (CityJSON)")
    for name, thing in data["CityObjects"].items():
        for geometry in thing.get("geometry", []):
            solids = {"Solid": lambda b: [b], "MultiSolid": list, "CompositeSolid": list}.get(geometry["type"])
            if not solids:
                raise Unread(f"a geometry of type {geometry['type']}")
            for shells in solids(geometry["boundaries"]):
                city_solid(name, [[[[points[int(i)] for i in loop] for loop in face] for face in shell]
                                  for shell in shells], model)
    return model


def read_gml(path):
    gml = "{http://www.opengis.net/gml}"
    model = Model(path.stem + " (GML)")
    root = xml.parse(path).getroot()
    polygons = {p.get(gml + "id"): p for p in root.iter(gml + "Polygon")}

    def loop_of(ring):
        words = " ".join(e.text for e in ring.iter(gml + "posList") if e.text).split()
        words = words or " ".join(e.text for e in ring.iter(gml + "pos")).split()
        points = points_of(words)
        return points[:-1] if points[0] == points[-1] else points

    for solid in root.iter(gml + "Solid"):
        shells = []
        for shell in list(solid.iter(gml + "exterior")) + list(solid.iter(gml + "interior")):
            faces = []
            for member in (m for m in shell.iter() if m.tag in (gml + "surfaceMember",)):
                link = member.get("{http://www.w3.org/1999/xlink}href")
                for p in [polygons[link[1:]]] if link else member.iter(gml + "Polygon"):
                    faces.append([loop_of(r) for tag in ("exterior", "interior") for r in p.findall(gml + tag)])
            if faces:
                shells.append(faces)
        if shells:
            city_solid(solid.get(gml + "id") or f"solid {len(model.solids)}", shells, model)
    if not model.solids:
        raise Unread("no solid in it")
    return model


READERS = {
    ".ts": read_gocad, ".pl": read_gocad, ".wl": read_gocad, ".ml": read_gocad_model,
    ".csv": read_csv, ".dat": read_dat, ".txt": read_dat, ".dev": read_dev, ".py": read_python,
    ".msh": read_msh, ".geo": read_geo, ".off": read_off, ".obj": read_obj, ".stl": read_stl,
    ".ply": read_ply, ".h5m": read_dagmc, ".step": read_cad, ".stp": read_cad, ".brep": read_cad,
    ".smesh": read_tetgen, ".poly": read_tetgen, ".json": read_cityjson, ".gml": read_gml,
}


def read(path):
    reader = READERS.get(path.suffix.lower())
    if not reader:
        raise Unread("there is no reader for this format")
    try:
        model = reader(path)
    except (ValueError, IndexError, KeyError, TypeError, SyntaxError, StopIteration, struct.error) as fault:
        raise Unread(f"not understood: {type(fault).__name__}: {fault}") from None
    if not (model.solids or model.sheets or model.wires or model.cad):
        raise Unread("nothing in it")
    return model
