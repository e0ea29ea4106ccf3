"""CAD solids for neutron transport: imprint, merge, and the .h5m file that DAGMC reads (OpenMC, MCNP).

A transport code tracks particles from surface to surface and wants every interface once, with the volume on each of
its sides; CAD programs write solids one by one, each with a surface of its own. To *imprint and merge* them is to find
what they have in common, which tolerances make fragile. Here it is a union: solids whose surfaces are the same share
their faces, exactly, round ones as well, and what does not fit would be seen as a sliver, with its volume.

A .h5m is HDF5 in the layout of MOAB: nodes, triangles, and sets of them. A set for each surface has its triangles, and
by the tag GEOM_SENSE_2 the volume behind and the one in front of these; a set for each volume has no triangles but its
surfaces as children; groups have names such as `mat:fuel`, and the volumes. All is numbered through: nodes, triangles,
sets. Here the file is read back and each volume summed up over its surfaces, in fractions.
"""
import warnings
from fractions import Fraction

import h5py
import numpy as np

import cnrg

warnings.simplefilter("ignore", cnrg.Notice)  # how near the faces of a file are to their surfaces

# Three solids as a CAD program would give them, in files of their own.
cell = cnrg.box([-1, -1, 0], [1, 1, 4])
pellet, tube = (cnrg.cylinder([0, 0, 0], [0, 0, 4], radius, segments=32) for radius in ("0.5", "0.6"))
for name, solid in ("fuel", pellet), ("clad", tube - pellet), ("water", cell - tube):
    solid.evaluate().write(f"{name}.step")

parts = [cnrg.load(f"{name}.step", material=name, name=name) for name in ("fuel", "clad", "water")]
pin = cnrg.union(*parts, dominance="left").evaluate().snap()  # on doubles, which is what the file holds
print("before:", sum(len(part.evaluate().faces) for part in parts), "faces, merged:", len(pin.faces))


def write_h5m(path, result):
    """Every face that bounds a region is a surface of the file; groups are materials and the outer boundary."""
    faces, regions = result.faces, result.regions
    volumes = regions.active
    surfaces = [f for f in faces.active if set(faces.regions[f]) & set(volumes)]
    triangles = np.concatenate([faces.triangles[f] for f in surfaces])
    first_triangle = 1 + len(result.points)
    first_set = first_triangle + len(triangles)
    surface_set = {f: first_set + i for i, f in enumerate(surfaces)}
    volume_set = {r: first_set + len(surfaces) + i for i, r in enumerate(volumes)}
    # The triangles are counter-clockwise as seen from the front: out of the volume behind, which is "forward".
    senses = [[volume_set.get(faces.regions[f, side], 0) for side in (1, 0)] for f in surfaces]
    groups = {}
    for r in volumes:
        groups.setdefault("mat:" + result.materials[regions.material[r]][0], []).append(volume_set[r])
    groups["boundary:vacuum"] = [surface_set[f] for f, sense in zip(surfaces, senses) if 0 in sense]

    contents, children, parents, rows = [], [], [], []

    def add_set(has=(), below=(), above=()):
        """A row has where its lists end, inclusive, and 2: a set without an order."""
        for ends, more in (contents, has), (children, below), (parents, above):
            ends.extend(more)
        rows.append([len(contents) - 1, len(children) - 1, len(parents) - 1, 2])

    at = first_triangle
    for f, sense in zip(surfaces, senses):
        n = len(faces.triangles[f])
        add_set(has=[*np.unique(faces.triangles[f]) + 1, *range(at, at + n)], above=[v for v in sense if v])
        at += n
    for r in volumes:
        add_set(below=[s for s, sense in zip(surface_set.values(), senses) if volume_set[r] in sense])
    for members in groups.values():
        add_set(has=members)
    sets = first_set + np.arange(len(rows))
    kinds = ["Surface"] * len(surfaces) + ["Volume"] * len(volumes) + ["Group"] * len(groups)
    dimensions = np.array([{"Surface": 2, "Volume": 3, "Group": 4}[kind] for kind in kinds])

    with h5py.File(path, "w") as file:
        root = file.create_group("tstt")
        root.attrs.create("max_id", sets[-1], dtype="u8")
        topologies = ("Edge", "Tri", "Quad", "Polygon", "Tet", "Pyramid", "Prism", "Knife", "Hex", "Polyhedron")
        root["elemtypes"] = h5py.enum_dtype({name: i for i, name in enumerate(topologies, 1)}, "u1")
        for name, data, start in (("nodes/coordinates", result.points, 1),
                                  ("elements/Tri3/connectivity", triangles.astype("u8") + 1, first_triangle),
                                  ("sets/list", np.array(rows, "i8"), first_set)):
            root[name] = data
            root[name].attrs.create("start_id", start, dtype="i8")
        root["elements/Tri3"].attrs.create("element_type", 2, dtype=root["elemtypes"])
        for name, data in ("contents", contents), ("children", children), ("parents", parents):
            root[f"sets/{name}"] = np.array(data, "u8")

        def tag(name, kind, ids=None, values=None, stored=1, **more):
            """Values of some sets (stored 1, sparse), or elsewhere of all (2, dense)."""
            made = root.create_group(f"tags/{name}")
            made["type"] = np.dtype(kind)
            made.attrs.create("class", stored, dtype="i4")
            for key, value in more.items():
                made.attrs.create(key.rstrip("_"), np.array(value), dtype="i4" if key == "is_handle" else kind)
            if ids is not None:
                made["id_list"] = np.array(ids, "u8")
                made.create_dataset("values", (len(ids),), dtype=made["type"])[...] = values
            return made["type"]

        tag("CATEGORY", "V32", sets, np.array(kinds, "S32").view("V32"))
        tag("GEOM_DIMENSION", "i4", sets, dimensions, default=-1, global_=-1)
        tag("GEOM_SENSE_2", ("u8", (2,)), list(surface_set.values()), np.array(senses, "u8"), is_handle=1,
            default=[0, 0])
        tag("NAME", "V32", sets[len(rows) - len(groups):], np.array(list(groups), "S32").view("V32"))
        kind = tag("GLOBAL_ID", "i4", stored=2, default=0, global_=0)
        numbers = np.concatenate([np.arange(1, kinds.count(k) + 1) for k in ("Surface", "Volume", "Group")])
        root.create_dataset("sets/tags/GLOBAL_ID", data=numbers, dtype=kind)


def read_h5m(path):
    """The exact volume of each volume by the names of its groups, and how many surfaces have two volumes."""
    with h5py.File(path) as file:
        root = file["tstt"]
        points = [[Fraction(x) for x in p] for p in root["nodes/coordinates"][:].tolist()]
        triangles = root["elements/Tri3/connectivity"][:].astype(int) - 1
        first = root["elements/Tri3/connectivity"].attrs["start_id"]
        first_set = root["sets/list"].attrs["start_id"]
        ends = root["sets/list"][:, 0]

        def members(number):
            i = number - first_set
            return root["sets/contents"][(ends[i - 1] + 1 if i else 0):ends[i] + 1].astype(int)

        volumes = {}
        senses = dict(zip(root["tags/GEOM_SENSE_2/id_list"][:].tolist(), root["tags/GEOM_SENSE_2/values"][:].tolist()))
        for surface, (forward, reverse) in senses.items():
            flux = Fraction(0)
            for t in members(surface):
                if t < first:
                    continue  # a node
                (ax, ay, az), (bx, by, bz), (cx, cy, cz) = (points[p] for p in triangles[t - first])
                flux += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)
            volumes[forward] = volumes.get(forward, 0) + flux / 6
            volumes[reverse] = volumes.get(reverse, 0) - flux / 6
        names = zip(root["tags/NAME/id_list"][:].tolist(), root["tags/NAME/values"][:])
        groups = {name.tobytes().rstrip(b"\0").decode(): members(number) for number, name in names}
        return ({name: sum(volumes[v] for v in of) for name, of in groups.items() if name.startswith("mat:")},
                sum(1 for sense in senses.values() if 0 not in sense), {k: len(v) for k, v in groups.items()})


write_h5m("pin.h5m", pin)
volumes, interfaces, groups = read_h5m("pin.h5m")
print("interfaces between volumes:", interfaces, "groups:", groups)
for part in pin.components:
    if part.material:
        same = volumes["mat:" + part.material] == part.volume
        print(f"{part.material}: volume {float(part.volume):.9f}, in the file {'the same' if same else 'another'}")
print("all of the cell:", sum(volumes.values()))

# Output:
# before: 14 faces, merged: 12
# interfaces between volumes: 2 groups: {'mat:water': 1, 'mat:clad': 1, 'mat:fuel': 1, 'boundary:vacuum': 10}
# water: volume 11.591486859, in the file the same
# clad: volume 1.347045682, in the file the same
# fuel: volume 3.061467459, in the file the same
# all of the cell: 16
