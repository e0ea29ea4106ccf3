#!/usr/bin/python3
"""house.py: how large the house is, as a table, and whether that is within the limits.

    house.py            prints the table; the exit status is 1 if a measure is above its limit, or a limit above what it
                        was in one of the last two commits
    house.py --lower    writes the limits that what is measured needs, where they are less: of lines and words the next
                        thousand that leaves 500 free

A room is a folder below kernel, csg, bench or tests; its lines are those of .h and .cpp. A class is measured from its
head to its last bracket, in kernel and csg. Words are those of all pages. limits.json, beside this file, is made by
--lower alone.
"""
import json
import re
import subprocess
import sys
from collections import Counter
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "names"))
from names import without_text  # noqa: E402

PARTS = {"kernel": "kernel and csg", "csg": "kernel and csg", "bench": "bench and tests", "tests": "bench and tests"}
LIMITS = "tests/measure/limits.json"
LARGE_CLASS, LARGE_FILE = 250, 600
CLASS = re.compile(r"^[ \t]*(?:template ?<[^;{]*>\s*)?(?:class|struct) (?:\[\[\w+\]\] )?(\w+)(?: final)?"
                   r"(?: ?:(?!:)[^;{]*)? ?\{", re.M)


def lines_of_classes(source):
    """By class of a file, its lines."""
    code = without_text(source)
    for head in CLASS.finditer(code):
        depth, end = 1, head.end()
        while depth and end < len(code):
            depth += (code[end] == "{") - (code[end] == "}")
            end += 1
        yield head[1], code.count("\n", head.start() + len(head[0]) - len(head[0].lstrip()), end) + 1


def room_of(path):
    parts = path.split("/")
    return "/".join(parts[:2]) if len(parts) > 2 else parts[0]


def measure(texts):
    """Of the texts of files by their paths: lines by room, what has limits, and what is above the size of its kind."""
    rooms, measures, large = Counter(), Counter({"words of pages": 0}), []
    for path, text in texts.items():
        part = path.split("/")[0]
        if path.endswith(".md"):
            measures["words of pages"] += len(text.split())
        if part not in PARTS or not path.endswith((".h", ".cpp")):
            continue
        lines = text.count("\n")
        rooms[room_of(path)] += lines
        measures[f"lines of {PARTS[part]}"] += lines
        sizes = [(f"files above {LARGE_FILE} lines", path, lines, LARGE_FILE)]
        if part in ("kernel", "csg"):
            sizes += [(f"classes above {LARGE_CLASS} lines", f"{path}: {name}", size, LARGE_CLASS)
                      for name, size in lines_of_classes(text)]
        for kind, name, size, most in sizes:
            measures[kind] += size > most
            if size > most:
                large.append((size, name))
    return rooms, dict(measures), sorted(large, reverse=True)


def needed(name, value):
    return value if name.endswith(f"{LARGE_FILE} lines") or name.endswith(f"{LARGE_CLASS} lines") \
        else -(-(value + 500) // 1000) * 1000


def faults(measures, limits, before):
    """Measures above their limits, and limits above those of `before`, the limits of some commits."""
    for name, value in measures.items():
        if name not in limits:
            yield f"{name}: {value} without a limit; house.py --lower writes one"
        elif value > limits[name]:
            yield f"{name}: {value}, the limit is {limits[name]}"
    for older in before:
        yield from (f"{name}: the limit rose from {older[name]} to {limit}"
                    for name, limit in limits.items() if limit > older.get(name, limit))


def table(rooms, measures, limits, large):
    rows = [(f"lines of {room}", lines, "") for room, lines in sorted(rooms.items()) if "/" in room]
    rows += [(name, value, limits.get(name, "")) for name, value in sorted(measures.items())]
    wide = max(len(name) for name, _, _ in rows)
    yield f"{'measure':{wide}}  {'now':>7}  {'limit':>7}"
    yield from (f"{name:{wide}}  {value:>7}  {limit:>7}" for name, value, limit in rows)
    yield from (f"{size:>{wide + 9}}  {name}" for size, name in large)


def git(*arguments):
    done = subprocess.run(["git", *arguments], cwd=HERE, capture_output=True, text=True, check=False)
    return done.stdout if done.returncode == 0 else ""


def main():
    if sys.argv[1:] not in ([], ["--lower"]):
        sys.exit(f"house.py: '{' '.join(sys.argv[1:])}' is no argument\n{__doc__}")
    root = Path(git("rev-parse", "--show-toplevel").strip() or HERE.parents[1])
    paths = git("ls-files", "--full-name", "--cached", "--others", "--exclude-standard", str(root)).split("\n")
    texts = {path: (root / path).read_text(encoding="utf-8") for path in sorted(set(paths))
             if path.endswith((".h", ".cpp", ".md")) and (root / path).is_file()}
    if not texts:
        print("not run: git knows no files here")
        sys.exit(77)
    rooms, measures, large = measure(texts)
    limits = json.loads((root / LIMITS).read_text()) if (root / LIMITS).exists() else {}
    if sys.argv[1:]:
        limits = {name: min(needed(name, value), limits.get(name, needed(name, value)))
                  for name, value in sorted(measures.items())}
        (root / LIMITS).write_text(json.dumps(limits, indent=2) + "\n")
    print("\n".join(table(rooms, measures, limits, large)))
    commits = git("log", "-2", "--format=%H", "--", str(root / LIMITS)).split()
    before = [json.loads(git("show", f"{commit}:{LIMITS}") or "{}") for commit in commits]
    found = list(faults(measures, limits, before))
    print("\n".join(found), end="\n" if found else "", file=sys.stderr)
    sys.exit(bool(found))


if __name__ == "__main__":
    main()
