#!/usr/bin/env python3
"""Trees of OpenSCAD against what OpenSCAD made of them.

usage: tests/campaign/openscad.py CNRG FOLDER [NAME...]

FOLDER has, in expected_openscad2021/SET/expected.json, volume, area, box and, where a Boolean ran, the counts of
the Nef polyhedron for each input; an input is SET/NAME.csg, or NAME.csg beside expected.json. Each input with a result
is evaluated: volume, area and box must agree to 1e-5, counts of vertices, edges and facets exactly, with
expected.json or, if `openscad` is installed, with what it makes of the .csg file: expected.json is partly of .scad
files, and OpenSCAD writes numbers of six digits. Prints what differs, and a line with the percentage. The exit status is 1 below 95 percent.
"""
import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile

TOLERANCE = 1e-5


def off_mesh(path):
    """Points and polygons of an OFF file."""
    with open(path, encoding="utf-8") as file:
        words = re.sub(r"#.*", "", file.read()).split()
    vertices, faces = int(words[1]), int(words[2])
    at = 4
    points = [tuple(map(float, words[at + 3 * i:at + 3 * i + 3])) for i in range(vertices)]
    at += 3 * vertices
    polygons = []
    for _ in range(faces):
        n = int(words[at])
        polygons.append([int(w) for w in words[at + 1:at + 1 + n]])
        at += 1 + n
    return points, polygons


def obj_mesh(path):
    """Points and polygons of an OBJ file."""
    points, polygons = [], []
    with open(path, encoding="utf-8") as file:
        for words in map(str.split, file):
            if words[:1] == ["v"]:
                points.append(tuple(map(float, words[1:4])))
            if words[:1] == ["f"]:
                polygons.append([int(w.split("/")[0]) - 1 for w in words[1:]])
    return points, polygons


def measure(points, polygons):
    """Volume, area and box of a surface; the area of a polygon is the length of its vector area."""
    volume = area = 0.0
    for polygon in polygons:
        a = points[polygon[0]]
        whole = [0.0, 0.0, 0.0]
        for b, c in ((points[polygon[i]], points[polygon[i + 1]]) for i in range(1, len(polygon) - 1)):
            u, v = [[q[k] - a[k] for k in range(3)] for q in (b, c)]
            normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
            whole = [x + y / 2 for x, y in zip(whole, normal)]
            volume += sum(a[k] * normal[k] for k in range(3)) / 6
        area += math.sqrt(sum(x * x for x in whole))
    used = [points[i] for polygon in polygons for i in polygon] or [(0, 0, 0)]
    box = [min(p[k] for p in used) for k in range(3)] + [max(p[k] for p in used) for k in range(3)]
    return {"volume": volume, "area": area, "bbox": box}


def evaluate(cnrg, path, folder):
    """What cnrg says of a tree: its measures, the counts of its result, or its error."""
    out = os.path.join(folder, "out.obj")
    try:
        run = subprocess.run([cnrg, "eval", path, "--threads", "2", "-o", out], capture_output=True, text=True,
                             timeout=120, check=False)
    except subprocess.TimeoutExpired:
        return None, None, "more than 120 seconds"
    if run.returncode != 0:
        return None, None, run.stderr.strip().splitlines()[0] if run.stderr.strip() else "no message"
    rows = [line.split() for line in run.stdout.splitlines()]
    row = next(r for r in rows if r and re.fullmatch("model(#1)?", r[0]))
    return measure(*obj_mesh(out)), [int(n) for n in row[2:5] + row[7:8]], ""


def differences(expected, got, counts):
    """What differs by more than is allowed, in words; the volume only of what has a region."""
    size = max(abs(x) for x in expected["bbox"]) or 1
    scale = max(abs(expected["volume"]), expected["area"] * size / 10)
    out = []
    if counts[3] > 0 and abs(got["volume"] - expected["volume"]) > TOLERANCE * scale:
        out.append(f"volume {got['volume']:.9g}, not {expected['volume']:.9g}")
    areas = [expected["area"], expected.get("vector area", expected["area"])]
    if all(abs(got["area"] - area) > TOLERANCE * area for area in areas):
        out.append(f"area {got['area']:.9g}, not {areas[0]:.9g}")
    if any(abs(a - b) > TOLERANCE * size for a, b in zip(got["bbox"], expected["bbox"])):
        out.append(f"box {got['bbox']}, not {expected['bbox']}")
    wanted = [expected.get(key) for key in ("nef_vertices", "nef_edges", "nef_facets")]
    if None not in wanted and counts[:3] != wanted:
        out.append(f"counts {counts[:3]}, not {wanted}")
    return out


def openscad_on(path, folder):
    """What OpenSCAD here makes of the .csg file itself: SET may have been made of files with more digits."""
    off = os.path.join(folder, "openscad.off")
    if shutil.which("openscad") is None:
        return None
    run = subprocess.run(["openscad", "-o", off, path], capture_output=True, text=True, timeout=120, check=False)
    if run.returncode != 0:
        return None
    out = measure(*off_mesh(off))
    for word in ("Vertices", "Edges", "Facets"):
        if found := re.search(rf"^ +{word}: +(\d+)$", run.stderr, re.M):
            out["nef_" + word.lower()] = int(found[1])
    return out


def inputs(folder, names):
    truth = os.path.join(folder, "expected_openscad2021")
    for name in sorted(os.listdir(truth)):
        with open(os.path.join(truth, name, "expected.json"), encoding="utf-8") as file:
            results = json.load(file)["results"]
        for key, expected in sorted(results.items()):
            stem = os.path.splitext(key)[0]
            beside = os.path.join(truth, name, stem + ".csg")
            path = beside if os.path.exists(beside) else os.path.join(folder, name, key)
            if expected["result"] == "ok" and (not names or stem in names):
                off = os.path.join(truth, name, stem + ".off")
                if os.path.exists(off):  # `area` cuts polygons into fans, which is wrong where they are not convex
                    expected["vector area"] = measure(*off_mesh(off))["area"]
                yield f"{name}/{stem}", path, expected


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    cnrg, folder, names = os.path.abspath(sys.argv[1]), sys.argv[2], sys.argv[3:]
    total = same = counted = 0
    with tempfile.TemporaryDirectory() as place:
        for name, path, expected in inputs(folder, names):
            total += 1
            got, counts, fault = evaluate(cnrg, path, place)
            found = [fault] if fault else differences(expected, got, counts)
            if found and not fault and (again := openscad_on(path, place)) and not differences(again, got, counts):
                print(f"{name}: agrees with OpenSCAD on the .csg file, not with expected.json: " + "; ".join(found))
                found = []
            counted += "nef_vertices" in expected and not found
            same += not found
            if found:
                print(f"{name}: " + "; ".join(found), flush=True)
    print(f"{same} of {total} agree, {100 * same / max(total, 1):.1f} %; {counted} of them also in counts")
    sys.exit(same < 0.95 * total)


if __name__ == "__main__":
    main()
