"""The JSON schema of a tree file against the reader: `schema.py CNRG [MUTATIONS [SEED]] [FILE...]`.

Each tree of the repository, and each example of the tables, that `cnrg check` takes is valid. Random mutations of a
tree with every key (renamed, dropped and added keys, other values; of each key some, whatever MUTATIONS says) are judged
by both: what the schema refuses the reader refuses; what the reader alone refuses is something that no schema says, by
the list below.
"""
import json
import random
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import jsonschema
import yaml

ROOT = Path(__file__).resolve().parents[2]

# What a schema cannot say, as the reader says it.
UNSAID = [
    # names
    r"there is no (node called|parameter)", r"is not declared", r"use each other in a cycle", r"is made of itself",
    r"nothing of .* is from", r"is not below", r"there is no file", r"a name of letters, digits and `_` that no parameter has",
    # how values depend on each other
    r"all rows must be equally long", r"rows of control points and", r"control points and \d+ weights", r"takes at least \d+ control points",
    r"take \d+ knots", r"this knot is less than", r"names a point, but `(vertices|points)` is empty",
    r"must be a whole number from 0 to \d+, not", r"`source face` is a face of one leaf", r"null is no region",
    r"begin with a corner", r"end with a corner", r"give the corner between them", r"does not come after the one",
    r"add up to", r"`from` and `to` of .* are one point", r"has no direction", r"makes a solid flat",
    # bounds of what is written as a text, and what an expression is
    r"must be above 0", r"must be a positive length", r"a weight must be positive", r"must be 0 or more", r"at most 360",
    r"must be a whole number from", r"is negative", r"error: the parameter `", r"an expression is written", r"`\$\{.*`: ", r"since its denominator is 0",
    r"begins like a number", r"`size` is how long", r"one more than surfaces",
    # lists that may be empty for the sake of others
    r"is empty; (add|give)", r"give at least two (corners|rows)",
]


class Loader(yaml.SafeLoader):
    """YAML 1.2, as the reader has it: `1e-3` is a number, `yes` and dates are texts; `<<` merges."""


Loader.yaml_implicit_resolvers = {}
for tag, pattern, first in [
        ("bool", r"true|True|TRUE|false|False|FALSE", "tTfF"), ("null", r"~|null|Null|NULL|", ["~", "n", "N", ""]),
        ("int", r"[-+]?[0-9]{1,4000}", "-+0123456789"), ("merge", r"<<", "<"),
        ("float", r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?", "-+.0123456789")]:
    Loader.add_implicit_resolver(f"tag:yaml.org,2002:{tag}", re.compile(f"^(?:{pattern})$"), list(first))
Loader.add_constructor("tag:yaml.org,2002:int", lambda loader, node: int(node.value))
Loader.add_constructor("tag:yaml.org,2002:float", lambda loader, node: float(node.value))


def with_text_keys(value):
    if isinstance(value, dict):
        return {str(key): with_text_keys(item) for key, item in value.items()}
    return [with_text_keys(item) for item in value] if isinstance(value, list) else value


def read(path):
    return with_text_keys(yaml.load(path.read_text(), Loader))


class Judges:
    def __init__(self, program, folder):
        self.program, self.folder = program, Path(folder)
        schema = json.loads(self.run("schema").stdout)
        jsonschema.Draft202012Validator.check_schema(schema)
        self.validator = jsonschema.Draft202012Validator(schema)

    def run(self, *words):
        return subprocess.run([self.program, *words], capture_output=True, text=True, timeout=120)

    def schema(self, tree):
        """Where the schema finds the first fault; nothing if there is none."""
        fault = jsonschema.exceptions.best_match(self.validator.iter_errors(tree))
        return fault and f"{'/'.join(str(step) for step in fault.absolute_path)}: {fault.message[:300]}"

    def reader(self, path, *words):
        """What the reader says of a fault; nothing if there is none. To complete nodes reads no files of leaves."""
        ended = self.run(*words or ("__complete", "explain", str(path), "--node", ""))
        if ended.returncode not in (0, 2, 3):
            raise AssertionError(f"{path}: {ended.stderr}")
        return ended.stderr.strip() if ended.returncode else ""

    def disagreement(self, path, tree):
        said, fault = self.reader(path), self.schema(tree)
        if fault and not said:
            said = self.reader(path, "check", str(path))  # a radius of 0
        if bool(said) == bool(fault) or (said and any(re.search(words, said) for words in UNSAID)):
            return None
        return f"{path.name}: the reader: {said or 'good'}\n  the schema: {fault or 'good'}"


def tables(judges):
    """The keys in the tables, and the examples."""
    keys, examples, column = set(), {}, 0
    for line in judges.run("schema", "--tables").stdout.splitlines():
        if re.match(r"[a-z]+: ", line):
            examples.update(read_text(line))
        cells = [cell.strip() for cell in line.strip("|").split(" |")]
        if "value" in cells:
            column = cells.index("value") - 1
        elif line.startswith("| "):
            keys.update(re.findall(r"`([^`]+)`", cells[column]))
    return sorted(keys), examples


# What the examples of the tables leave out: with these each key is somewhere.
MORE = r"""
cnrg: 1
$schema: tree.schema.json
x-note: {anything: [1, two]}
parameters: {R: 2, half: R / 4}
materials:
  steel:
  ceramic: {dominance: 2}
  graded: {distance: {to: box, stops: [[0, steel], [1, {steel: 1/2, ceramic: "${half}"}]]}, x-note: 1}
weld: 1e-9
nodes:
  prism: {prism: {base: [[0, 0, 0], [4, 0, 0], [0, 4, 0]], holes: [[[1, 1, 0], [2, 1, 0], [1, 2, 0]]], vector: [0, 0, 1],
    fit: 0.1}}
  ellipse: {disk: {center: [0, 0, 0], radii: [2, 1], normal: [0, 0, 1], along: [1, 1, 0], segments: 8}}
  fracture: {disk: {center: [0, 0, 0], radii: [2, 1], dip: 30, strike: 45}}
  polyline: {polyline: {points: [[0, 0, 0], [1, 0, 0], [0, "${R}", 0]], closed: true}, name: 12}
  dots: {points: [[0, 0, 0]], attributes: {diameter: 25, section: round}, size: 0.5, dominance: -1/2}
  sphere: {sphere: {center: [0, 0, 0], radius: 1, segments: 8, rings: 4}, simplify: points, regularize: true}
  torus: {torus: {center: [0, 0, 0], axis: [0, 0, 1], radius: 2, tube: 1/2, segments: 8, rings: 8}, scale: [1, 2, -1]}
  cone: {cone: {from: [0, 0, 0], to: [0, 0, 1], radius: 1, segments: 8}, scale: 2}
  extrude: {extrude: {profile: {outer: [[0, 0, 0], [4, 0, 0], {bezier: [[4, 4, 0]], weights: [1, 2, 1]}, [0, 4, 0]],
    holes: [[[1, 1, 0], [2, 1, 0], [1, 2, 0]]]}, vector: [0, 0, 1], twist: 10, scale: 1/2, center: [0, 0, 0], segments: 4}}
  sheet: {extrude: {curve: [[0, 0, 0], [1, 0, 0]], vector: [0, 0, 1]}}
  revolve: {revolve: {profile: {outer: [[1, 0], [3, 0], {bezier: [[3, 2]], weights: [1, 1, 1]}, [1, 3]],
    holes: [[[1.2, 0.2], [1.4, 0.2], [1.2, 0.4]]]}, center: [0, 0, 0], axis: [0, 1, 0], degrees: 90, chord: 0.1}}
  pipe: {sweep: {profile: {outer: [[0, 0, 0], [1, 0, 0], [0, 1, 0]], holes: [[[0.1, 0.1, 0], [0.4, 0.1, 0], [0.1, 0.4, 0]]]},
    path: [[0, 0, 0], [0, 0, 9], [0, 9, 9]], radius: 4, chord: 0.1}}
  hopper: {loft: {profiles: [[[0, 0, 0], [1, 0, 0], [0, 1, 0]], {outer: [[0, 0, 1], [2, 0, 1], [0, 2, 1]]}], segments: 4}}
  cup: {revolve: {curve: [[1, 0], [2, 1]], segments: 4}}
  bezier: {bezier: {patches: [{points: [[[0, 0, 0], [1, 0, 0]], [[0, 1, 0], [1, 1, 1]]], weights: [[1, 1], [1, 2]]}],
    curves: [[[0, 0, 0], [0, 0, 1]], {points: [[0, 0, 0], [0, 1, 1]], weights: [1, 2]}], fill: none, chord: 0.1}}
  arc: {bezier: {curve: {points: [[1, 0, 0], [1, 1, 0], [0, 1, 0]], weights: [1, 1, 2]}, segments: 4}}
  bspline: {bspline: {patch: {points: [[[0, 0, 0], [1, 0, 0]], [[0, 1, 0], [1, 1, 1]]], weights: [[1, 1], [1, 2]],
    degree: [1, 1], knots: [[0, 0, 1, 1], [0, 0, 1, 1]]}, fill: none, chord: 0.1}}
  splines: {bspline: {patches: [{points: [[[0, 0, 0], [1, 0, 0]], [[0, 1, 0], [1, 1, 1]]], degree: [1, 1]}],
    curves: [{points: [[0, 0, 0], [1, 0, 0]], weights: [1, 2], degree: 1, knots: [0, 0, 1, 1]}], segments: 4}}
  coons: {coons: {patches: [[[[0, 0, 0], [1, 0, 0]], [[1, 0, 0], [1, 1, 1]], [[1, 1, 1], [0, 1, 0]], [[0, 1, 0], [0, 0, 0]]]],
    fill: none, chord: 0.1}}
  heightfield: {heightfield: {heights: [[0, 1], [2, 3]], origin: [1, 2], within: 1/8}}
  grid: {heightfield: {file: none.asc, base: -1}}
  mesh: {mesh: {file: none.off, fill: winding, coordinates: decimal, weld: 1e-6}}
  step: {step: {file: none.step, chord: 0.1, unit: mm, fill: solids, solids: [1, bolt], seams: true, weld: 1e-6}}
  brep: {brep: {file: none.brep, segments: 4, fill: cells, solids: [1], seams: false, weld: 1e-6}}
  group: {group: {vertices: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], faces: [{loops: [[0, 1, 2]], sides: [1, 0]}],
    edges: [[0, 3]], points: [3], regions: {1: {material: steel, name: one}}}}
  filled: {group: {vertices: [[0, 0, 0], [1, 0, 0], [0, 1, 0]], faces: [{loops: [[0, 1, 2]]}], fill: none}}
  cnrg: {cnrg: none.json}
  csg: {intersection: [box, {union: [dots, box], blend: linear}, {interior: box, each: true}], dominance: left}
  box: {box: {min: [0, 0, 0], max: [1, 1, 1]}, material: graded, mirror: {normal: [1, 0, 0], point: [1, 0, 0]},
    matrix: [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]], translate: [0, 0, 1], rotate: {axis: [0, 0, 1], degrees: 90}}
  below: {below: dots, within: box}
  above: {above: dots, within: {complement: {closure: {boundary: {unify: box}}}}}
  all: {difference: [{sum: [box, dots]}, {product: [box, dots]}, {subtract: [box, dots]}, {aggregate: [box]}]}
  regular: {regularize: box, each: true, simplify: features}
  simple: {simplify: {of: box, mode: points, within: 1/8}}
  many: {repeat: {of: {simplify: box, translate: ["${3 * i}", 0, 0]}, count: 2, index: i}}
  layers: {layers: {within: box, surfaces: [dots, {points: [[0, 0, 0]]}], names: [low, mid, top],
    materials: [steel, ceramic, steel]}}
  select: {select: {of: box, dimension: [0, 1], name: box, material: [steel, ceramic], attributes: {diameter: [25, 30]},
    region: [1, "2"], front of: box, behind: [box], from: box, source face: [0, 1], between: [[box, null]], inside: box,
    touching: [box, {points: [[0, 0, 0]]}]}}
result: all
"""


def read_text(text):
    return with_text_keys(yaml.load(text, Loader))


def seeds(examples):
    """The tree above, and one with the examples of the tables."""
    nodes = {"a": {"points": [[0, 0, 0]]}, "bolt": {"points": [[0, 0, 0]]}, "model": {"points": [[0, 0, 0]]}}
    for name, example in examples.items():
        if name in ("rotate", "mirror"):
            nodes[f"a {name}"] = {"simplify": "a", name: example}
        elif name != "material":
            nodes[f"a {name}"] = {name: example}
    materials = {"steel": {}, "ceramic": None, "rock": {}, "clay": {}, "material": examples["material"]}
    return [read_text(MORE), {"cnrg": 1, "materials": materials, "nodes": nodes, "result": "a"}]


def places(value, path=()):
    yield path
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, item in items:
        yield from places(item, (*path, key))


def parts(tree):
    """A tree for each node, with those that others use; and where in it mutations are of use."""
    for name in tree["nodes"]:
        kept = {node: value for node, value in tree["nodes"].items() if node in (name, "a", "bolt", "box", "dots", "model")}
        part = {**tree, "nodes": kept, "result": name}
        yield part, [path for path in places(part) if path[:2] == ("nodes", name) and path[2:]]
    yield part, [path for path in places(part) if path and path[0] not in ("nodes", "x-note")]


def at(tree, path):
    for step in path:
        tree = tree[step]
    return tree


VALUES = [0, -1, 1, 3, 2.5, "x", "1/2", "-1e-3", "a", "", True, None, [], {}, [1, 2], [0, 0, 1], [[0, 0, 0], [1, 0, 0]],
          {"points": [[0, 0, 0]]}, {"x": 1}, "none", "${1/2}", "${R}", 10**6, ["a", "box"], "0x10", ".inf"]


def each_key(part, paths):
    """Every key dropped, renamed, and with values that hardly any key takes."""
    for path in paths:
        if not isinstance(path[-1], str):
            continue
        for change in ("drop", "rename", "x", [[]], {"x": 1}):
            tree = json.loads(json.dumps(part))
            holder = at(tree, path[:-1])
            value = holder.pop(path[-1])
            if change != "drop":
                holder.update({path[-1] + "e": value} if change == "rename" else {path[-1]: change})
            yield tree


def mutated(part, paths, keys, random):
    tree = json.loads(json.dumps(part))
    path = random.choice(paths)
    holder, last = at(tree, path[:-1]), path[-1]
    kind = random.choice(["rename", "drop", "value", "value", "add", "swap"])
    if kind == "drop":
        del holder[last]
    elif kind == "value" or isinstance(holder, list) and kind != "swap":
        holder[last] = random.choice(VALUES)
    elif kind == "swap":
        other = random.choice([path for path in places(tree) if path])
        holder[last] = json.loads(json.dumps(at(tree, other)))
    else:
        key = random.choice([random.choice(keys), last[:-1], last + "s", last.upper(), "x-" + last])
        value = holder.pop(last) if kind == "rename" else random.choice([holder[last], random.choice(VALUES)])
        holder[key] = value
    return tree


def trees_of(folders):
    """Tree files below folders that are no exercise with blanks to fill."""
    for folder in folders:
        for path in sorted([folder] if folder.is_file() else folder.rglob("*.yaml")):
            if re.search(r"^cnrg: *1", path.read_text(), re.M) or path.read_text().startswith("{cnrg"):
                yield path


def main():
    program, count, seed = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    folders = [Path(word) for word in sys.argv[4:]] or [ROOT / room for room in ("papers", "tests", "bench")]
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(2) as pool:
        judges = Judges(program, folder)
        known, examples = tables(judges)
        begun = seeds(examples)
        missing = [key for key in known if not any(key in map(str, path) for tree in begun for path in places(tree))]
        faults = [f"no seed has the key {key}" for key in missing]
        files = [(path, read(path)) for path in trees_of(folders)]

        def write(number, tree):
            path = Path(folder) / f"{number}.yaml"
            path.write_text(json.dumps(tree, indent=1))
            return path, tree

        drawn = random.Random(seed)
        files += [write(f"seed-{k}", tree) for k, tree in enumerate(begun)]
        for path, tree in files[-len(begun):]:
            faults += [f"{path.name}: {fault}" for fault in (judges.reader(path), judges.schema(tree)) if fault]
        pieces = [piece for tree in begun for piece in parts(tree)]
        wild = [tree for piece in pieces for tree in each_key(*piece)]
        wild += [mutated(*drawn.choice(pieces), known, drawn) for _ in range(count)]
        found = list(pool.map(lambda one: judges.disagreement(*one), files + [write(k, tree) for k, tree in enumerate(wild)]))
        faults += [fault for fault in found if fault]
        refused = sum(1 for tree in wild if not judges.validator.is_valid(tree))
    print("\n".join(faults[:40]))
    print(f"{len(files)} files, {len(wild)} mutations, of which the schema refuses {refused}; {len(faults)} faults")
    return bool(faults) or len(files) < 50 and not sys.argv[4:] or not len(wild) // 4 < refused < len(wild)


if __name__ == "__main__":
    sys.exit(main())
