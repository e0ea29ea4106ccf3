"""What is run with faults: commands on small inputs, which are made here, by the program itself where it can.

A command runs in a folder of its own. `../in` has its inputs, which have to stay as they are; the folder has what
was there before, which has to be whole afterwards, old or new.
"""
import subprocess
from dataclasses import dataclass, field
from pathlib import Path

BLOCK = """\
cnrg: 1
materials: {rock: {color: "#998877"}, ore: {}}
nodes:
  ground: {box: {min: [0, 0, 0], max: [4, 4, 3]}, material: rock}
  fault:  {polygon: [[1, -1, -1], [3, -1, 4], [3, 5, 4], [1, 5, -1]]}
  bolt:   {polyline: [[2, 2, 1], [2, 2, "8/3"]]}
  inside: {intersection: [fault, ground]}
  model:  {union: [bolt, inside, ground], dominance: left}
result: model
"""
ROUND = """\
cnrg: 1
nodes:
  ball: {sphere: {center: [0, 0, 0], radius: 1, segments: 8}}
  hole: {cylinder: {from: [0, 0, -2], to: [0, 0, 2], radius: "1/3", segments: 6}}
  ring: {difference: [ball, hole]}
result: ring
"""
SOLID = """\
cnrg: 1
nodes:
  a: {box: {min: [0, 0, 0], max: [2, 2, 2]}}
  b: {box: {min: [1, 1, 1], max: [3, 3, 3]}}
  c: {difference: [a, b]}
result: c
"""
LEAF = "cnrg: 1\nnodes:\n  a: {%s: %s}\nresult: a\n"
FROM_FILE = "{file: %s}"
POINTS = "".join(f"{x} {x}/2 1/{x + 1}\n" for x in range(8)) + "\n2 2 2\n"
CORPUS = Path(__file__).resolve().parents[1] / "fuzz" / "corpus"
OLD = b"an old file\n" * 100


@dataclass
class Scenario:
    name: str
    command: list  # words; the first is a program of `Programs`
    outputs: list = field(default_factory=list)  # files that the command makes
    old: bool = False  # the files are there before
    input: str = None  # on standard input, by a pipe
    input_file: str = None  # the same from a file of ../in
    old_disk: bool = False  # a file system without files that have no name
    failures: tuple = (3,)  # exit statuses that a fault may have
    kinds: tuple = None  # of faults; all without it
    alone: bool = False  # no thread may be started
    same: bool = True  # undisturbed runs write the same bytes
    small: bool = False  # part of `test_faults`


def scenarios():
    cnrg = "cnrg"
    found = [
        Scenario("check", [cnrg, "check", "../in/block.yaml"]),
        Scenario("tables", [cnrg, "tables"]),
        Scenario("version", [cnrg, "--version"]),
        Scenario("eval", [cnrg, "eval", "../in/block.yaml"]),
        Scenario("trace", [cnrg, "eval", "../in/block.yaml", "--trace", "--topology"]),
        Scenario("threads", [cnrg, "eval", "../in/round.yaml", "--threads", "4", "-o", "r.json"], ["r.json"],
                 small=True),
        Scenario("one thread", [cnrg, "eval", "../in/round.yaml", "--threads", "1", "-o", "r.json"], ["r.json"],
                 alone=True, small=True),
        Scenario("all files", [cnrg, "eval", "../in/block.yaml", "-o", "r.json", "-o", "r.vtu", "-o", "r.regions.dot"],
                 ["r.json", "r.vtu", "r.regions.dot"], old=True, small=True),
        Scenario("link", [cnrg, "eval", "../in/solid.yaml", "-o", "link.json"], ["r.json", "link.json"], old=True),
        Scenario("old disk", [cnrg, "eval", "../in/solid.yaml", "-o", "r.json"], ["r.json"], old=True, old_disk=True,
                 small=True),
        Scenario("new on an old disk", [cnrg, "eval", "../in/solid.yaml", "-o", "r.obj"], ["r.obj"], old_disk=True),
        Scenario("explain", [cnrg, "explain", "../in/block.yaml", "--point", "2,2,1"]),
        Scenario("locate", [cnrg, "locate", "../in/block.yaml"], input=POINTS, small=True),
        Scenario("locate from a file", [cnrg, "locate", "../in/round.yaml", "--parameters"], input_file="points"),
        Scenario("mesh", [cnrg, "mesh", "../in/block.yaml", "-o", "m.msh"], ["m.msh"], old=True, small=True),
        Scenario("mesh, all", [cnrg, "mesh", "../in/solid.yaml", "--quality", "1.6", "-o", "m.mesh", "-o", "m.vtu",
                               "-o", "m.xdmf", "-o", "m.h5m", "-o", "m.med"],
                 ["m.mesh", "m.vtu", "m.xdmf", "m.h5m", "m.med"]),
    ]
    for ending in ("json", "vtu", "msh", "mesh", "smesh", "poly", "inp", "bdf", "h5m", "med", "obj", "off", "stl", "ply", "3mf", "glb", "dot",
                   "regions.dot", "svg", "png", "pdf"):
        found.append(Scenario(f"write .{ending}", [cnrg, "eval", "../in/solid.yaml", "-o", f"r.{ending}"],
                              [f"r.{ending}"], old=ending in ("json", "vtu")))
    found.append(Scenario("write .stl in binary", [cnrg, "eval", "../in/solid.yaml", "--binary", "-o", "r.stl"],
                          ["r.stl"]))
    # OpenCASCADE may take lack of memory for a fault of its file: what it returns is then refused as that.
    for name in ("solid.stl", "solid.off", "solid.obj", "solid.ply", "solid.json", "part.vtp", "part.vtk", "grid.asc",
                 "part.step", "part.brep"):
        found.append(Scenario(f"read {name}", [cnrg, "eval", f"../in/read-{name}.yaml"],
                              failures=(2, 3) if name in ("part.step", "part.brep") else (3,),
                              small=name in ("solid.json", "part.step")))
    # A row per run, whatever becomes of it: a run that is lost is told in its row, and the status is 1.
    found += [
        Scenario("robust", ["bench_robust", "--seconds", "5", "../in/solid.stl"], failures=(1, 2), same=False),
        Scenario("sweep", ["bench_sweep", "edge", "--systems", "ours", "--limit", "2", "--seconds", "5", "--out", "rows",
                           "--quiet"], failures=(1, 2), same=False),
        Scenario("report", ["report", "../in/sweep/rows", "-o", "page.html"], ["page.html"], old=True, failures=(2,),
                 kinds=("rename",)),  # others are those of Python and its libraries
    ]
    return found


def write_inputs(folder, programs):
    """Fills the folder of inputs."""
    folder.mkdir(parents=True)
    for name, text in (("block.yaml", BLOCK), ("round.yaml", ROUND), ("solid.yaml", SOLID), ("points", POINTS)):
        (folder / name).write_text(text)
    (folder / "grid.asc").write_text("ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n0 1 2\n1 2 3\n")
    files = [f"solid.{ending}" for ending in ("stl", "off", "obj", "ply", "json")]
    words = [programs["cnrg"], "eval", "solid.yaml", "--quiet"] + [w for f in files for w in ("-o", f)]
    subprocess.run(words, cwd=folder, check=True, stdout=subprocess.DEVNULL)
    for name in files:
        (folder / f"read-{name}.yaml").write_text(LEAF % (("cnrg", name) if name.endswith("json") else ("mesh", FROM_FILE % name)))
    (folder / "read-grid.asc.yaml").write_text(LEAF % ("heightfield", FROM_FILE % "grid.asc"))
    for leaf, ending, model in (("step", "step", "cylinder"), ("brep", "brep", "box"), ("mesh", "vtp", "packed"),
                                ("mesh", "vtk", "binary51")):
        (folder / f"part.{ending}").write_bytes((CORPUS / ending / model).read_bytes())
        (folder / f"read-part.{ending}.yaml").write_text(LEAF % (leaf, FROM_FILE % f"part.{ending}"))
    if not programs["bench_sweep"].exists():
        return
    subprocess.run([programs["bench_sweep"], "edge", "--systems", "ours", "--limit", "2", "--out", "sweep", "--quiet"],
                   cwd=folder, check=True, stdout=subprocess.DEVNULL)
