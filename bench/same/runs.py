"""What the program is asked about a tree, its answers as bytes, and where two answers part.

All that it says counts: both streams, the exit status and every file, byte for byte, but for what
`without_times` takes out.
"""
import hashlib
import json
import os
import random
import re
import subprocess
from collections import namedtuple

CURVED = re.compile(r"\b(sphere|cylinder|cone|torus|extrude|revolve|bezier|bspline|coons|step|brep)\b")
# What takes long: nodes that are asked for once only, leaves that are.
LARGE = {"papers/keyser2004/chords.yaml": re.compile("_(60|360)$")}
FINE = re.compile(r"chord: \"?1/\d{3,}|segments: \d{3}")
FILES = ("json", "vtu", "obj", "dot", "regions.dot", "msh", "msh2", "mesh", "inp", "bdf", "h5m", "med", "poly", "smesh", "glb",
         "off", "stl", "ply", "3mf")
LIBRARY_FILES = (".h5m", ".med")  # by plug-ins
LIBRARY_LEAVES = re.compile(r"\b(step|brep|vtp|stp)\b")
STOPPED = b"stopped: it ran too long"
MISSING = b"no such file"

# arguments of the program, standard input, the files that it may write
Run = namedtuple("Run", "arguments input files")


def run_of(*arguments, text="", files=()):
    arguments = [str(a) for a in arguments]
    for file in files:
        arguments += ["-o", file]
    return Run(arguments, text, list(files))


def each_node(kind, tree, nodes, *options):
    """Nodes at once, each with its exact file."""
    files, arguments = [], ["eval", tree.path, *options]
    for node in nodes or [None]:
        files.append(f"{kind}-{node or 'result'}.json")
        arguments += ["--node", node] if node else []
        arguments += ["-o", files[-1]]
    return Run([str(a) for a in arguments], "", files)


def files_of(tree, *options):
    """Every format, of the result."""
    return run_of("eval", tree.path, *options, files=[f"result.{ending}" for ending in FILES])


def runs_of(tree):
    """The runs for one tree: its files always, the rest in turns, since a process takes longer than most trees do.

    Threads take turns, too, so that each kind of answer comes from one and from two.
    """
    r = random.Random(tree.name)
    path, turn = tree.path, tree.turn
    one, two = ("--threads", 1 + turn // 4 % 2), ("--threads", 2 - turn // 4 % 2)
    runs = []
    for part, node, file in tree.before:
        runs.append(run_of("eval", part, *(["--node", node] if node else []), files=[file]))
    if FINE.search(tree.text) and not tree.thorough:
        return [run_of("check", path), run_of("eval", path, "--trace", *two, files=["result.json"])]
    large = LARGE.get(tree.name)
    nodes = [node for node in tree.nodes if not (large and large.search(node))]
    runs.append(each_node("exact", tree, tree.nodes, "--trace", "--topology", *one))
    if turn % 2 or tree.thorough:
        runs.append(each_node("raw", tree, nodes, "--trace", "--raw", *two))
    runs.append(files_of(tree, *two))
    if tree.thorough:  # formats that refuse nothing, of every node at once
        shown = [(node, f"{node}.{ending}") for node in nodes for ending in ("vtu", "obj", "regions.dot")]
        runs.append(Run(["eval", path, "--quiet", *(word for node, file in shown
                                                    for word in ("--node", node, "-o", file))], "",
                        [file for _, file in shown]))
    curved = CURVED.search(tree.text) is not None
    if (curved and turn % 2) or tree.thorough:
        runs.append(run_of("eval", path, "--parameters", "--quiet", *one, files=["uv.json", "uv.vtu"]))
    if turn % 6 == 1 or tree.thorough:
        runs.append(run_of("eval", path, "--quiet", *two, files=["snap.vtu", "snap.msh", "snap.stl"]))
        runs.append(run_of("eval", path, "--no-snap", "--quiet", *two, files=["round.vtu", "round.msh"]))
    if curved and turn % 3 == 0 and not tree.thorough:
        runs.append(run_of("eval", path, "--finer", 2, "--topology", *one, files=["finer.json"]))

    points = "".join(p + "\n" for p in tree.points)
    asked = [r.choice(nodes) if nodes and r.randrange(2) else None]
    if tree.thorough:
        asked = [None] + r.sample(nodes, min(2, len(nodes)))
    for node in asked:
        of = ["--node", node] if node else []
        if turn % 2 == 0 or tree.thorough:
            runs.append(run_of("locate", path, *of, "--parameters", "--material", *one, text=points))
        cell = r.choice("vveefffrrr")
        if turn // 2 % 2 or tree.thorough:
            runs.append(run_of("explain", path, *of, "--cell", cell + str(r.randrange(3 if cell == "r" else 8)), *two))
    if tree.points and (turn // 2 % 2 == 0 or tree.thorough):
        runs.append(run_of("explain", path, "--point", r.choice(tree.points).replace(" ", ","), *one))
    if turn % 9 == 0 or tree.thorough:
        runs.append(run_of("check", path))
    if turn % 16 == 3 or tree.thorough:
        ways = (["--quality", "1.6"], ["-Y"], ["--no-snap", "--max-volume", "1"])
        options = [] if tree.thorough else ways[turn // 16 % 3]
        endings = ("msh", "vtu", "mesh", "inp", "bdf", "h5m", "med", "xdmf")
        runs.append(run_of("mesh", path, *options, files=["mesh." + endings[turn // 16 % len(endings)]]))
    return runs


def command_runs(tree):
    """What does not depend on a tree, or is wrong."""
    commands = ("eval", "check", "locate", "explain", "mesh", "tables")
    return ([run_of("--help"), run_of("--version"), run_of("tables"), run_of(), run_of("evil", tree.path)] +
            [run_of(command, "--help") for command in commands] +
            [run_of("eval"), run_of("eval", "no-such.yaml"), run_of("eval", tree.path, "--no-such"),
             run_of("eval", tree.path, "--node", "no_such"), run_of("eval", tree.path, files=["a.no"]),
             run_of("eval", tree.path, files=["a.json", "a.json"]), run_of("eval", tree.path, files=["no/such.json"]),
             run_of("eval", tree.path, "--node", tree.nodes[0], "--node", tree.nodes[1], files=["a.obj"]),
             run_of("eval", tree.path, "--snap", "--parameters"), run_of("mesh", tree.path),
             run_of("eval", tree.path, "--threads", "-1"), run_of("eval", tree.path, "--finer", "0"),
             run_of("mesh", tree.path, "--quality", "1", files=["a.msh"]), run_of("explain", tree.path),
             run_of("explain", tree.path, "--cell", "x1"), run_of("explain", tree.path, "--cell", "f999"),
             run_of("explain", tree.path, "--point", "1,2"), run_of("explain", tree.path, "--point", "1,b,2"),
             run_of("locate", tree.path, text="1 2\n"), run_of("locate", tree.path, text="1 2 x\n"),
             run_of("locate", tree.path, text="\n1 1 1\n1 2 3 4\n")])


def without_libraries(runs):
    """What builds without optional libraries answer alike: no meshes of tetrahedra, no files of HDF5."""
    kept = []
    for run in runs:
        if run.arguments[:1] == ["mesh"] or "--version" in run.arguments:
            continue
        lost = {file for file in run.files if file.endswith(LIBRARY_FILES)}
        words = run.arguments
        arguments = [word for i, word in enumerate(words)
                     if not (word in lost or (word == "-o" and words[i + 1:i + 2] and words[i + 1] in lost))]
        kept.append(Run(arguments, run.input, [file for file in run.files if file not in lost]))
    return kept


def without_times(text):
    """Rows and the summary of `eval` without what tells how and not what: seconds, candidates, stages of predicates."""
    text = re.sub(rb"(?m)(; of )\d+( candidates)$", rb"\1-\2", text)
    text = re.sub(rb"(?m)^predicates: .*$", b"predicates: -", text)
    text = re.sub(rb"(?m)  +\d+\.\d{3}(?=  +\S)", b"  -.---", text)
    text = re.sub(rb"(?m)^( +[a-z]+\b.*?) +\d+\.\d{3}$", rb"\1  -.---", text)  # of a stage, which has no name
    return re.sub(rb"(?m)(3-cells; )\d+\.\d{3} s$", rb"\1-.--- s", text)


def read(path):
    try:
        with open(path, "rb") as file:
            return file.read()
    except FileNotFoundError:
        return MISSING


def write_tree(tree, folder):
    for path, text in {tree.path: tree.text, **tree.files}.items():
        os.makedirs(os.path.dirname(os.path.join(folder, path)), exist_ok=True)
        with open(os.path.join(folder, path), "w", encoding="utf-8", newline="") as file:
            file.write(text)
    for run in tree.before:
        os.makedirs(os.path.dirname(os.path.join(folder, run[2])) or folder, exist_ok=True)


def answers(program, tree, runs, folder, seconds):
    """Of each run its streams, exit status and files by name; `folder` is empty before."""
    write_tree(tree, folder)
    result = []
    for run in runs:
        answer = {}
        try:
            done = subprocess.run([program, *run.arguments], input=run.input.encode(), cwd=folder, timeout=seconds,
                                  capture_output=True, close_fds=False, check=False)
        except subprocess.TimeoutExpired:
            answer["exit status"] = STOPPED
        else:
            answer["stdout"] = without_times(done.stdout) if run.arguments[:1] == ["eval"] else done.stdout
            answer["stderr"] = done.stderr
            answer["exit status"] = str(done.returncode).encode()
        for file in run.files:
            answer[file] = read(os.path.join(folder, file))
        result.append(answer)
    return result


def files_in(answer_list):
    """How many files were written."""
    return sum(text is not MISSING for answer in answer_list for name, text in answer.items()
               if name not in ("stdout", "stderr", "exit status"))


def digest_of(answer_list):
    state = hashlib.sha256()
    for answer in answer_list:
        for name in sorted(answer):
            state.update(f"{name} {len(answer[name])} {answer[name] is MISSING}\n".encode())
            state.update(answer[name])
    return state.hexdigest()


def key_of(tree, runs):
    """The same for the same questions."""
    return hashlib.sha256(json.dumps([tree.path, tree.text, tree.files, runs]).encode()).hexdigest()


Difference = namedtuple("Difference", "run name base head")


def differences(runs, base, head):
    """All of them, in the order of the runs."""
    return [Difference(i, name, base[i].get(name), head[i].get(name)) for i in range(len(runs))
            for name in dict.fromkeys([*base[i], *head[i]]) if base[i].get(name) != head[i].get(name)]


def where(difference):
    """The line at which two answers part, from both, cut around the place."""
    if difference.base is None or difference.head is None:
        return "", difference.base or STOPPED, difference.head or STOPPED
    base, head = difference.base.split(b"\n"), difference.head.split(b"\n")
    line = next((i for i, (a, b) in enumerate(zip(base, head)) if a != b), min(len(base), len(head)))
    a, b = (x[line] if line < len(x) else b"(it ends here)" for x in (base, head))
    column = next((i for i, (x, y) in enumerate(zip(a, b)) if x != y), min(len(a), len(b)))
    start = max(0, column - 60)
    return f", line {line + 1}", a[start:column + 60], b[start:column + 60]
