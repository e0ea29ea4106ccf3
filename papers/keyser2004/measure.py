#!/usr/bin/env python3
"""measure.py PROGRAM: what the page says about errors and bounds, by the program `cnrg` on chords.yaml.

Volumes are exact fractions; only pi and the distances are doubles.

Why boundaries are at most K e apart (the terms are the page's): let x be on the boundary of f(S), and let the ball of
radius K e around x hold a point in f(S) and one not in it, both farther than e from the boundary of every S_i. By the
page's lemma f(P) has the one and not the other, so the segment between them meets the boundary of f(P), at most K e
away from x. From f(P) to f(S) likewise. On one smooth surface, away from the others, K tends to 1 with e. Where two
surfaces meet at an angle theta (the smaller one, up to 90 degrees), the point in the middle of a wedge is far enough
from both faces at e/sin(theta/2), so K = 1/sin(theta/2), up to terms in e times the curvatures. Where three meet, half
the angle of the widest round cone in the narrowest corner replaces theta/2. The same factor bounds how far the curve
moves in which the surfaces meet.
"""
import fractions
import json
import math
import pathlib
import subprocess
import sys
import tempfile

TREE = pathlib.Path(__file__).resolve().parent / "chords.yaml"
LEAVES = {"pipe_x": 3 * math.pi, "pipe_y": 3 * math.pi, "ball": 500 * math.pi / 3, "bore": 108 * math.pi,
          "wide": 300 * math.pi}
CURVED_AREA = {"pipe_x": 6 * math.pi, "pipe_y": 6 * math.pi, "ball": 100 * math.pi, "bore": 72 * math.pi,
               "wide": 120 * math.pi}
RESULTS = {"steinmetz": (16 / 3, ("pipe_x", "pipe_y")), "ring": (256 * math.pi / 3, ("ball", "bore")),
           "touch": (0, ("ball", "wide"))}


def evaluate(program, names):
    """The results of the nodes, as read from their files."""
    with tempfile.TemporaryDirectory() as folder:
        files = [pathlib.Path(folder) / f"{name}.json" for name in names]
        arguments = [word for name, file in zip(names, files) for word in ("--node", name, "-o", str(file))]
        subprocess.run([program, "eval", str(TREE), "--quiet", *arguments], check=True)
        return {name: json.loads(file.read_text()) for name, file in zip(names, files)}


def volume(result):
    return sum(fractions.Fraction(r["volume"]) for r in result["regions"] if r["component"] and r["bounded"])


def farthest(result, distance, shift, steps=16):
    """The largest distance of the points of edges where two leaves meet, sampled."""
    points = [[float(fractions.Fraction(c)) for c in p] for p in result["points"]]
    points = [[x - shift, y, z] for x, y, z in points]
    largest = 0
    for edge in result["edges"]:
        if len(edge["origin"]) < 2:
            continue
        for a, b in zip(edge["points"], edge["points"][1:]):
            for i in range(steps + 1):
                t = i / steps
                largest = max(largest, distance([(1 - t) * x + t * y for x, y in zip(points[a], points[b])]))
    return largest


def to_edge_of_ring(p):
    return math.hypot(math.hypot(p[0], p[1]) - 3, abs(p[2]) - 4)


def main():
    chords = (10, 60, 360)
    names = [f"{kind}_{e}" for e in chords for kind in (*LEAVES, *RESULTS)]
    results = evaluate(sys.argv[1], names)
    print("| node | volume | error | of the leaves | bound |\n|---|---|---|---|---|")
    for kind, (exact, leaves) in RESULTS.items():
        for e in chords:
            v = float(volume(results[f"{kind}_{e}"]))
            lost = sum(LEAVES[leaf] - float(volume(results[f"{leaf}_{e}"])) for leaf in leaves)
            bound = sum(CURVED_AREA[leaf] for leaf in leaves) / e
            print(f"| `{kind}_{e}` | {v:.7g} | {v - exact:.3g} | {lost:.3g} | {bound:.3g} |")
    print("\n| node | distance | bound |\n|---|---|---|")
    for place, e in enumerate(chords):
        far = farthest(results[f"ring_{e}"], to_edge_of_ring, 20 * place)
        print(f"| `ring_{e}` | {far:.3g} | {math.sqrt(5) / e:.3g} |")


if __name__ == "__main__":
    main()
