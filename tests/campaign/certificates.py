#!/usr/bin/python3
"""Constellations of curved solids whose topology algebra tells, against `cnrg eval --certify`.

    tests/campaign/certificates.py CNRG COUNT SEED           named ones and COUNT random ones, certified
    tests/campaign/certificates.py CNRG COUNT SEED agree     also at other fineness and turned: the same truth
    tests/campaign/certificates.py CNRG COUNT SEED truth     the truth itself, against fine facets without a proof
    tests/campaign/certificates.py CNRG COUNT SEED contacts  contacts alone, without a proof: is each found?
      --only KIND   kinds that have this in their name     --jobs J   programs at a time
      --show N      also the tree of random constellation N, which every line names     --list   every verdict

Numbers are exact fractions, and each kind draws general positions, positions 1e-1 to 1e-12 from a contact, and
contacts. What is right is vertices, edges, faces and 3-cells of the result of the true surfaces. Verdicts: `right`;
`WRONG`, certified with other counts; `undecided`, an error that names a place; `failed`, all else. The exit status is 1
if anything was certified and is wrong (with `truth` and `contacts`: if counts are wrong).
"""
import argparse
import json
import random
import re
import subprocess
import sys
import tempfile
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent / "certificates"))

import quadrics  # noqa: E402
import rings  # noqa: E402
from bodies import FRAMES, draw_fineness, frame  # noqa: E402
from named import named  # noqa: E402

KINDS = quadrics.KINDS + rings.KINDS
GAPS = ["general", *(str(-k) for k in range(1, 13)), "contact"]
VERDICTS = ("right", "WRONG", "undecided", "failed")
SECONDS = 120


def draw(number, seed, kinds, gaps):
    """The random constellation of a number: kinds in turn, every distance, every frame."""
    rng = random.Random(f"{seed} {number}")
    kind = kinds[number % len(kinds)]
    gap = rng.choice(gaps)
    while True:
        distance = None if gap == "general" else Fraction(0)
        if gap not in ("general", "contact"):
            distance = Fraction(10) ** int(gap) * rng.choice([1, -1]) * Fraction(rng.randint(8, 24), 8)
        case = kind(rng, distance)
        if case and case.truth:
            break
    case.gap = gap
    draw_fineness(case.leaves.values(), rng)
    case.where = frame(rng.choice(FRAMES), rng)
    return case


def run(program, case, tree, options):
    """Exit status, counts of the result (None if there is no row) and what the program told."""
    with tempfile.TemporaryDirectory() as folder:
        for name, made in [*case.files.items(), ("tree.yaml", tree)]:
            path = Path(folder) / "tree.yaml"
            path.write_text(json.dumps(made), encoding="utf-8")
            more = ["-o", str(Path(folder) / name), "--quiet"] if made is not tree else options
            command = ["nice", program, "eval", str(path), "--threads", "1", *more]
            try:
                done = subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, check=False)
            except subprocess.TimeoutExpired:
                return None, None, f"no answer in {SECONDS} s"
            if done.returncode != 0:
                break
        told = done.stderr.replace(folder + "/", "")
    rows = re.findall(r"^result +\S+ +(\d+) +(\d+) +(\d+) +(\d+) ", done.stdout, re.MULTILINE)
    return done.returncode, tuple(map(int, rows[0])) if rows else None, told


def judged(status, counts, told, truth):
    """The verdict on a run with --certify."""
    if status == 0 and counts and re.search(r"(?<!not )\bcertified\b", told):
        return "right" if counts == truth else "WRONG"
    if status == 2 and re.search(r"error: .*(near [\[(]|decide)", told):
        return "undecided"
    return "failed"


def others(case, rng):
    """The same constellation at other fineness and turned: name, tree, options."""
    yield "--finer 2", case.tree(), ["--finer", "2"]
    if case.files:
        return
    for segments in (16, 24, 48, 96):
        yield f"segments {segments}", case.tree(segments), []
    yield "turned", case.tree(where=frame("3-4-5", rng)), []


def trial(program, number, case, mode):
    """All runs of a constellation: (verdict, what to print) of each."""
    found = []

    def told(verdict, name, counts, text):
        words = [case.kind, case.expression[0], case.situation, case.gap, case.where.name]
        line = f"{number}: {verdict}: {', '.join(words)}{name}: "
        line += f"{counts} for {case.truth}" if counts else "".join(text.strip().splitlines()[-1:])[-300:]
        found.append((verdict, line))

    if mode in ("truth", "contacts"):
        for segments in (96, 320) if mode == "truth" else (None,):
            finer = ["--finer", "8"] if case.files and segments else []
            status, counts, text = run(program, case, case.tree(segments), finer)
            verdict = "failed" if status else "right" if counts == case.truth else "WRONG"
            if verdict != "WRONG":
                break
        told(verdict, "", counts, text)
        return found
    status, counts, text = run(program, case, case.tree(), ["--certify"])
    told(judged(status, counts, text, case.truth), "", counts if status == 0 else None, text)
    if mode == "agree":
        for name, tree, options in others(case, random.Random(number)):
            status, counts, text = run(program, case, tree, ["--certify", *options])
            told(judged(status, counts, text, case.truth), ", " + name, counts if status == 0 else None, text)
    return found


def print_contacts(counted):
    """By kind and contact: how many are found, of how many, in each frame."""
    rows = sorted({row for row, _, _ in counted})
    width = max(map(len, rows))
    print(f"{'contact':{width}}  " + "  ".join(f"{name:>9}" for name in FRAMES))
    for row in rows:
        cells = []
        for name in FRAMES:
            right = counted[row, name, "right"]
            tried = sum(counted[row, name, verdict] for verdict in VERDICTS)
            cells.append(f"{right}/{tried}" if tried else "")
        print(f"{row:{width}}  " + "  ".join(f"{cell:>9}" for cell in cells))


def print_table(title, keys, counted):
    width = max([len(title), *map(len, keys)])
    print(f"\n{title:{width}}  " + "  ".join(f"{v:>9}" for v in VERDICTS))
    for key in [*keys, "all"]:
        row = [sum(n for (k, v), n in counted.items() if v == verdict and key in (k, "all")) for verdict in VERDICTS]
        if any(row):
            print(f"{key:{width}}  " + "  ".join(f"{n:>9}" for n in row))


def print_distances(keys, counted):
    """By kind and distance from the contact: right, WRONG and all others, a number each."""
    width = max(map(len, keys))
    print(f"\n{'right/WRONG/other':{width}}  " + " ".join(f"{gap:>8}" for gap in GAPS))
    for key in [*keys, "all"]:
        cells = []
        for gap in GAPS:
            row = [sum(n for (k, g, v), n in counted.items() if v in verdicts and g == gap and key in (k, "all"))
                   for verdicts in (("right",), ("WRONG",), ("undecided", "failed"))]
            cells.append("/".join(map(str, row)) if any(row) else "")
        print(f"{key:{width}}  " + " ".join(f"{cell:>8}" for cell in cells))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("count", type=int)
    parser.add_argument("seed", type=int)
    parser.add_argument("mode", nargs="?", choices=["agree", "truth", "contacts"])
    parser.add_argument("--only", default="")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--show", type=int)
    parser.add_argument("--list", action="store_true")
    options = parser.parse_args()
    kinds = [k for k in KINDS if options.only.replace(" ", "_") in k.__name__]
    none = f"--only {options.only}: there are {', '.join(k.__name__ for k in KINDS)}"
    if options.show is not None and not kinds:
        parser.error(none)
    gaps = {"truth": ["general", "-1"], "contacts": ["contact"]}.get(options.mode, GAPS)
    if options.show is not None:
        print(json.dumps(draw(options.show, options.seed, kinds, gaps).tree(), indent=1))
        return 0
    cases = [(case.kind, case) for case in named() if options.only in case.kind and case.gap in gaps]
    cases += [(n, draw(n, options.seed, kinds, gaps)) for n in range(options.count if kinds else 0)]
    if not cases:
        parser.error(none)
    by_kind, by_distance, by_frame, by_contact = Counter(), Counter(), Counter(), Counter()
    wrong = 0
    with ThreadPoolExecutor(options.jobs) as pool:
        for (number, case), runs in zip(cases, pool.map(lambda x: trial(options.program, *x, options.mode), cases)):
            for verdict, line in runs:
                wrong += verdict == "WRONG" or (verdict == "failed" and options.mode in ("truth", "contacts"))
                if options.list or (verdict in ("WRONG", "failed") and options.mode != "contacts"):
                    print(line, flush=True)
                by_contact[f"{case.kind}, {case.situation}", case.where.name, verdict] += 1
                kind = case.kind if isinstance(number, int) else "named"
                by_kind[kind, verdict] += 1
                by_distance[kind, case.gap, verdict] += 1
                by_frame[case.where.name, verdict] += 1
    if options.mode == "contacts":
        print_contacts(by_contact)
    kinds = list(dict.fromkeys(k for k, _ in by_kind))
    print_table("kind", kinds, by_kind)
    if options.mode != "contacts":
        print_distances(kinds, by_distance)
    print_table("frame", FRAMES, by_frame)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
