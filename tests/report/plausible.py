"""Rows like those of a sweep: what systems are known to do, exaggerated; times and memory by power laws with noise.
The same whenever they are made."""
import json
import random
from pathlib import Path

FACTS = {"volume": "1", "vertices": 8, "edges": 12, "faces": 6, "regions": 1, "shells": 1, "genus": 0,
         "non_manifold_edges": 0, "non_manifold_vertices": 0, "dangling_faces": 0, "dangling_edges": 0,
         "dangling_vertices": 0}
OPERATIONS = ("union", "difference", "intersection")
LIMIT = 60.0


def system_info(name, title, guarantee="", version="", rounding=0.0, regularized=True, absent="", varies=None):
    return {"name": name, "title": title, "guarantee": guarantee, "version": version, "rounding": rounding,
            "regularized": regularized, "absent": absent, "varies": varies}


SYSTEMS = [
    system_info("ours", "cnrg", "any cells of dimension 0 to 3, exact, each contact once", "0.1.0", 0.0, False),
    system_info("mantyla-double", "Mäntylä, double", "closed 2-manifold solids; one epsilon for all comparisons",
                "1986", 1e-10),
    system_info("mantyla-exact", "Mäntylä, exact", "closed 2-manifold solids; rationals", "1986"),
    system_info("nef", "CGAL Nef", "any cells, exact", "CGAL 5.5.1", 0.0, False),
    system_info("corefinement", "CGAL corefinement", "closed 2-manifold surfaces; refuses a result that is none",
                "CGAL 5.5.1", 1e-15),
    system_info("occt", "OpenCASCADE", "boundary representations with a tolerance", "7.6.3", 1e-7),
    system_info("openscad", "OpenSCAD", "solids; Nef polyhedra inside, doubles outside", "2021.01", 1e-6)]
# Name, title, what the size means, whether it has distances, sizes, triangles per size.
FAMILIES = [
    ("face", "two boxes that share a whole face", "boxes", True, (1,), 24),
    ("part-face", "two boxes that share a part of a face", "boxes", True, (1,), 24),
    ("edge", "two boxes that touch along an edge", "boxes", True, (1,), 24),
    ("vertex", "two boxes that touch at a vertex", "boxes", True, (1,), 24),
    ("wall", "one box inside another, a wall in common", "boxes", True, (1,), 24),
    ("turned", "a cube and its copy, turned by less and less", "cubes", True, (1,), 24),
    ("coplanar", "prisms with coplanar tops", "corners", True, (4, 16, 64, 256), 8),
    ("menger", "a cube without its prisms", "levels", False, (1, 2, 3), 200),
    ("boxes", "random boxes on an integer grid", "boxes", False, (5, 20, 80, 320), 12),
    ("spheres", "spheres on a lattice that overlap", "spheres", False, (2, 8, 27, 64), 1020),
    ("ground", "layers of ground with faults and tunnels", "layers", False, (2, 4, 8, 16), 400),
    ("fractures", "fractures in a box with wells", "fractures", False, (4, 16, 64), 14),
    ("chain", "one union after the other", "unions", False, (1, 10, 100, 1000), 10),
    ("wires", "a solid and wires through it", "wires", False, (1, 4), 12),
    ("files", "meshes of people and their turned copies", "meshes", False, (1,), 20000)]
# Seconds per triangle, exponent, bytes per triangle; by system.
COSTS = [(6e-6, 1.03, 420), (2e-6, 1.9, 300), (9e-5, 1.95, 900), (5e-4, 1.12, 16000), (4e-6, 1.08, 700),
         (1.5e-4, 1.3, 5000), (6e-4, 1.1, 18000)]


def right_row(system, family, size=1, seed=1, **members):
    """A row that is right, without a distance, with other members as they are given."""
    problem = f"{family}-union-s{size}-r{seed}"
    return {"problem": problem, "family": family, "values": {"seed": str(seed)}, "operation": "union", "size": size,
            "distance": None, "warm": [], "has_distance": False, "seed": seed, "operands": 2, "triangles": 24 * size, "system": system,
            "verdict": "same", "stage": "", "message": "", "stages": [], "seconds": 1.0, "peak_bytes": 3000000,
            "own_bytes": 1000000, "exact_share": -1.0, "note": "", "facts": None, "excess": 0.0, "missing": 0.0,
            "duplicates": 0, "truth": {"facts": FACTS, "confirmed": "Nef", "reason": ""}, "limit_seconds": LIMIT,
            "confirmation": {"by": "integrals", "reason": "the volume of the difference is 0"}, "asserted_seconds": None,
            "limit_bytes": 4000000000, "load": 0.5, "command": f"bench/run --one {problem} {system}"} | members


def at_distance(row, k, verdict="same", **members):
    problem = f"{row['family']}-{row['operation']}-s{row['size']}-k{'exact' if k is None else k}-r{row['seed']}"
    return row | {"has_distance": True, "distance": k, "verdict": verdict, "problem": problem} | members


def _near_degeneracy(system, family, k, draw):
    contact, exact, near = family in ("edge", "vertex", "wall"), k is None, 99 if k is None else k
    if system.startswith("mantyla") and exact and contact:
        return "contact-duplicated", "", ""
    if system == "mantyla-double":
        if near >= 9 and not exact and draw() < min(0.9, 0.15 * (near - 8)):
            if draw() < 0.3:
                return "wrong", "", "volume is 0.83 of the exact one"
            return "refused", "connecting" if draw() < 0.6 else "classification", "loose ends are left over"
        if exact and draw() < 0.2:
            return "refused", "finishing", "a loop has no partner"
    if system == "corefinement" and exact and contact:
        return ("refused", "output", "no manifold") if draw() < 0.4 else ("contact-duplicated", "", "")
    if system == "occt" and near >= 7 and draw() < (0.1 if exact else 0.25 if near > 12 else 0.55):
        return ("wrong", "", "surface too much") if draw() < 0.5 else ("crashed", "unknown", "signal 11")
    if system == "openscad" and near >= 14 and not exact and draw() < 0.7:
        return "contact-lost", "", ""
    return "same", "", ""


def _result(system, family, row, draw):
    others = system not in ("ours", "nef")
    if family == "wires" and others:
        return ("dangling-lost", "", "") if system == "occt" else ("refused", "input", "an operand is no solid")
    if family == "files" and row["seed"] == 2:
        return "unjudged", "", "the exact result took too long"
    if family == "fractures" and others:
        return "same-regularized", "", ""
    if system.startswith("mantyla") and row["triangles"] > 20000:
        return "timed-out", "", "60 s"
    if system == "nef" and row["triangles"] > 50000:
        return "out-of-memory", "", ""
    return _near_degeneracy(system, family, row["distance"], draw) if row["has_distance"] else ("same", "", "")


def _rows_of(family, systems, seeds, draw):
    name, _, _, has_distance, sizes, triangles = family
    for operation in OPERATIONS:
        for size in sizes:
            for k in (None, *range(17)) if has_distance else (None,):
                for seed in range(1, seeds + 1):
                    row = right_row("", name, size, seed, operation=operation)
                    row |= {"problem": f"{name}-{operation}-s{size}-r{seed}",
                            "triangles": triangles * size * (20 ** (size - 1) if name == "menger" else 1)}
                    if has_distance:
                        row = at_distance(row, k)
                    if name == "files":
                        row["truth"] = row["truth"] | {"confirmed": "volume"}
                    for info, (seconds, exponent, size_of) in zip(SYSTEMS[:systems], COSTS):
                        verdict, stage, message = _result(info["name"], name, row, draw)
                        time = 2e-4 + seconds * row["triangles"] ** exponent * (0.8 + 0.5 * draw())
                        own = int(60000 + size_of * row["triangles"] * (0.9 + 0.2 * draw()))
                        yield row | {
                            "system": info["name"], "verdict": verdict, "stage": stage, "message": message,
                            "seconds": LIMIT if verdict == "timed-out" else time, "own_bytes": own,
                            "peak_bytes": own + 18000000, "stages": [{"name": "Boolean", "seconds": time}],
                            "exact_share": 1e-4 * draw() if info["name"] == "ours" else -1.0,
                            "command": f"bench/run --one {row['problem']} {info['name']}"}


class Sweep:
    """The first families of fifteen, the first systems of seven, `seeds` problems of each kind."""

    def __init__(self, families, systems, seeds=1):
        draw = random.Random(7).random
        self.systems = [dict(info) for info in SYSTEMS[:systems]]
        self.families = [{"name": name, "title": title, "size_means": means, "distance_means": "distance to the degenerate position, as a part of the operands' size", "growth": "triangles"}
                         for name, title, means, *_ in FAMILIES[:families]]
        self.machine = {"cpu": "Intel Xeon Platinum 8370C at 2.80 GHz", "cores": 2, "memory_bytes": 8000000000,
                        "system": "Debian GNU/Linux 12, Linux 6.1", "compiler": "g++ 12.2.0 -O3",
                        "commit": "0123abcd", "date": "2026-11-21", "command": "bench/run all", "left_out": []}
        self.rows = [row for family in FAMILIES[:families] for row in _rows_of(family, systems, seeds, draw)]

    def write(self, folder):
        """The rows as `FOLDER/rows/PROBLEM/SYSTEM.json` and the three descriptions beside them."""
        folder = Path(folder)
        folder.mkdir(parents=True)
        for name in ("systems", "families", "machine"):
            (folder / f"{name}.json").write_text(json.dumps(getattr(self, name)))
        for row in self.rows:
            problem = folder / "rows" / row["problem"]
            problem.mkdir(parents=True, exist_ok=True)
            (problem / f"{row['system']}.json").write_text(json.dumps(row))
