#!/usr/bin/env python3
"""curved.py PROGRAM: how far the volumes of straight and of bent tetrahedra are from those of the true solids, by the
program `cnrg` on curved.yaml."""
import math
import pathlib
import subprocess
import sys
import tempfile

TREE = pathlib.Path(__file__).resolve().parent / "curved.yaml"
# The wall of the bottle: a clamped cubic spline of radius and height, turned about the axis.
RADII = (1.2, 1.35, 1.2, 1.3, 0.3, 0.5, 0.5)
HEIGHTS = (0, 1, 2.5, 3.3, 3.6, 4.4, 5)
KNOTS = (0, 0, 0, 0, 0.25, 0.5, 0.75, 1, 1, 1, 1)


def spline(values, knots, degree, t, span):
    """The value at t, by de Boor's algorithm."""
    d = list(values[span - degree:span + 1])
    for r in range(1, degree + 1):
        for j in range(degree, r - 1, -1):
            low, high = knots[span - degree + j], knots[span + j - r + 1]
            d[j] = ((high - t) * d[j - 1] + (t - low) * d[j]) / (high - low)
    return d[degree]


def slope(values, t, span):
    """The derivative of a cubic spline at t."""
    steps = [3 * (values[i + 1] - values[i]) / (KNOTS[i + 4] - KNOTS[i + 1]) for i in range(len(values) - 1)]
    return spline(steps, KNOTS[1:-1], 2, t, span - 1)


def bottle():
    """pi times the integral of r^2 z', a polynomial of degree 8 between two knots: five points of Gauss."""
    nodes = (0, math.sqrt(5 - 2 * math.sqrt(10 / 7)) / 3, math.sqrt(5 + 2 * math.sqrt(10 / 7)) / 3)
    weights = (128 / 225, (322 + 13 * math.sqrt(70)) / 900, (322 - 13 * math.sqrt(70)) / 900)
    total = 0
    for span in range(3, 7):
        low, high = KNOTS[span], KNOTS[span + 1]
        for node, weight in zip(nodes, weights):
            for x in {node, -node}:
                t = (low + high) / 2 + x * (high - low) / 2
                total += weight * (high - low) / 2 * spline(RADII, KNOTS, 3, t, span) ** 2 * slope(HEIGHTS, t, span)
    return math.pi * total


def mesh(program, node, finer, curved):
    """Tetrahedra, such that had to stay straight, volume."""
    with tempfile.TemporaryDirectory() as folder:
        arguments = [program, "mesh", str(TREE), "--node", node, "--finer", str(finer), "--quality", "1.4",
                     "-o", str(pathlib.Path(folder) / "out.msh")] + ["--curved"] * curved
        run = subprocess.run(arguments, check=True, capture_output=True, text=True)
    cells = next(line.split() for line in run.stdout.splitlines() if line.startswith("all "))
    return int(cells[1]), int(cells[3]) if curved else 0, float(cells[-1])


def main():
    exact = {"ball": 4 * math.pi / 3, "can": 2 * math.pi, "bottle": bottle()}
    print("| node | finer | straight mesh | error | bent mesh | stay straight | error | ratio |")
    print("|---|---|---|---|---|---|---|---|")
    for node, volume in exact.items():
        before = None
        for finer in (1, 2, 4):
            plain, bent = (mesh(sys.argv[1], node, finer, curved) for curved in (False, True))
            error = bent[2] - volume
            ratio = "" if before is None else f"{abs(before / error):.1f}"
            print(f"| `{node}` | {finer} | {plain[0]} | {plain[2] - volume:.2g} | {bent[0]} | {bent[1]} | {error:.2g} | {ratio} |")
            before = error


if __name__ == "__main__":
    main()
