"""PLY, and DAGMC's triangles in HDF5: files of rows of numbers that a head describes."""
import struct
from collections import defaultdict
from fractions import Fraction

from model import Model, Solid, Unread, is_closed, merged, surface, used_only

PLY_TYPES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I", "float": "f", "double": "d",
             "int8": "b", "uint8": "B", "int16": "h", "uint16": "H", "int32": "i", "uint32": "I", "float32": "f",
             "float64": "d"}


def read_ply(path):
    head, _, body = path.read_bytes().partition(b"end_header\n")
    lines = [line.split() for line in head.decode("ascii", "replace").splitlines()]
    if not lines or lines[0] != ["ply"] or not body:
        raise Unread("no PLY, or nothing in it")
    kind = next(line[1] for line in lines if line[:1] == ["format"])
    elements = []
    for line in lines:
        if line[:1] == ["element"]:
            elements.append((line[1], int(line[2]), []))
        elif line[:1] == ["property"]:
            elements[-1][2].append(line[1:])
    words, at, order = iter(body.split()), 0, ">" if "big" in kind else "<"

    def value(type_):
        nonlocal at
        if kind == "ascii":
            word = next(words)
            return float(word) if PLY_TYPES[type_] in "fd" else int(word)
        code = order + PLY_TYPES[type_]
        (found,), at = struct.unpack_from(code, body, at), at + struct.calcsize(code)
        return found

    rows = {}
    for name, count, properties in elements:
        rows[name] = [{p[-1]: [value(p[2]) for _ in range(value(p[1]))] if p[0] == "list" else value(p[0])
                       for p in properties} for _ in range(count)]
    points = [tuple(Fraction(v[k]) for k in "xyz") for v in rows.get("vertex", [])]
    faces = [[f.get("vertex_indices") or f.get("vertex_index")] for f in rows.get("face", [])]
    model = Model(path.stem)
    surface(path.stem, points, [f for f in faces if f[0]], model)
    return model


def read_dagmc(path):
    """Triangles of MOAB: sets of dimension 2 name the volumes on their two sides; each volume is a solid."""
    try:
        import h5py
    except ImportError:
        raise Unread("python3-h5py is not installed") from None
    with h5py.File(path) as file:
        tstt = file["tstt"]
        nodes = tstt["nodes/coordinates"]
        first, points = int(nodes.attrs["start_id"]), [tuple(map(Fraction, map(float, p))) for p in nodes[:]]
        triangles = {}
        for name, group in tstt["elements"].items():
            if name.startswith("Tri"):
                begin = int(group["connectivity"].attrs["start_id"])
                for i, corners in enumerate(group["connectivity"][:, :3]):
                    triangles[begin + i] = [int(c) - first for c in corners]
        tags, sets = tstt["tags"], tstt["sets/list"]
        dimensions = dict(zip(map(int, tags["GEOM_DIMENSION/id_list"][:]), map(int, tags["GEOM_DIMENSION/values"][:])))
        senses = dict(zip(map(int, tags["GEOM_SENSE_2/id_list"][:]), tags["GEOM_SENSE_2/values"][:].tolist()))
        contents, begin, handle = tstt["sets/contents"][:], 0, int(sets.attrs["start_id"])
        volumes = defaultdict(list)
        for i, (end, _, _, flags) in enumerate(sets[:].tolist()):
            members, begin = contents[begin:end + 1].tolist(), end + 1
            if dimensions.get(handle + i) != 2:
                continue
            if flags & 8:                                    # ranges: a first one and how many
                members = [m + k for m, n in zip(members[::2], members[1::2]) for k in range(n)]
            faces = [[triangles[m]] for m in members if m in triangles]
            for volume in set(senses[handle + i]) - {0}:
                volumes[volume] += faces
    model = Model(path.stem)
    for number, faces in enumerate(volumes.values()):
        p, f = merged(*used_only(points, faces))
        if is_closed(f):
            model.solids.append(Solid(f"volume {number + 1}", p, f, "parity"))
        else:
            model.notes.append(f"volume {number + 1} is not closed: left out")
    return model
