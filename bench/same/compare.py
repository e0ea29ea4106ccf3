"""Compares two builds of the program byte for byte, on all trees of the repository and on random ones.

Each tree is evaluated by both, in folders of their own: rows with --trace, topology and exact files of every node,
unsimplified cells, every format, parameters, snapping, locate, explain, check, meshes of tetrahedra, with one and
with two threads (runs.py). Streams, exit statuses and files must be the same bytes; times, candidates and stages of predicates do not count.
One line says so; else differences are printed and the smallest tree among the differing ones is kept, with both
answers. Exit status 0 if all is the same, 1 if not, 2 if nothing could be compared.

The trees: those of papers/, pages, tests and examples (found.py), and random ones that depend on the seed alone
(trees.py, leaves.py). If gmsh is installed, two models in CAD files are made with it.
"""
import argparse
import hashlib
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
sys.dont_write_bytecode = True

from found import found_trees  # noqa: E402
from runs import (LIBRARY_LEAVES, STOPPED, answers, command_runs, differences, digest_of, files_in,  # noqa: E402
                  key_of, runs_of, where, without_libraries, write_tree)
from trees import Tree, random_tree  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
MOST_TREES = 20        # that differ, until there is no use in more
MOST_DIFFERENCES = 3   # that are printed of one tree
CAD_MODELS = {
    "boxes.brep": "Box(1) = {0,0,0,2,2,2};\nBox(2) = {1,1,1,2,2,2};\n"
                  "BooleanFragments{ Volume{1}; Delete; }{ Volume{2}; Delete; }\n",
    "bolt.step": "Cylinder(1) = {1,1,0, 0,0,3, 1};\nBox(2) = {0,0,2,2,2,2};\n"
                 "BooleanUnion{ Volume{1}; Delete; }{ Volume{2}; Delete; }\n",
}


class Same:
    """Two programs and what has been compared so far."""

    def __init__(self, options):
        self.base, self.head = options.base, options.head
        self.seconds, self.jobs, self.keep, self.seed = options.seconds, options.jobs, options.keep, options.seed
        self.bare = options.bare
        self.counts = dict.fromkeys(("trees", "runs", "files", "refused", "stopped"), 0)
        self.rewords = [text.encode().split(b"=", 1) for text in options.reword]
        self.different, self.smallest = 0, None
        self.answers_file, self.known, self.fresh = None, {}, {}
        if options.answers and is_binary(self.base):
            self.answers_file = Path(options.answers) / (file_digest(self.base) + ".json")
            if self.answers_file.exists():
                self.known = json.loads(self.answers_file.read_text())

    def compare(self, tree):
        """Of one tree: runs, what head answers, and where base answers differently."""
        runs = command_runs(tree) if tree.name == "commands" else runs_of(tree)
        if self.bare:
            runs = without_libraries(runs)
        with tempfile.TemporaryDirectory(prefix="cnrg_same_") as folder:
            head = answers(self.head, tree, runs, in_folder(folder, "head"), self.seconds)
            key = key_of(tree, runs)
            if self.known.get(key) in (digest_of(head), digest_of(self.old_words(head))):
                return tree, runs, head, []
            base = answers(self.base, tree, runs, in_folder(folder, "base"), self.seconds)
        if not any(STOPPED in answer.values() for answer in base):
            self.fresh[key] = digest_of(base)
        return tree, runs, head, differences(runs, self.old_words(base), self.old_words(head))

    def old_words(self, answer_list):
        """Streams with the words of before, where messages are meant to change."""
        def text_of(name, text):
            for old, new in self.rewords if name in ("stdout", "stderr") else ():
                text = text.replace(new, old)
            return text

        return [{name: text_of(name, text) for name, text in answer.items()} for answer in answer_list]

    def run(self, trees):
        with ThreadPoolExecutor(self.jobs) as pool:
            futures = [pool.submit(self.compare, tree) for tree in trees]
            try:
                for number, future in enumerate(futures):
                    self.add(*future.result())
                    if number % 50 == 49:
                        self.save_answers()
                    if sys.stderr.isatty():
                        print(f"\r{number + 1} of {len(futures)} trees", end="", file=sys.stderr, flush=True)
                    if self.different == MOST_TREES:
                        break
            finally:  # nobody wants the rest, if there is one
                pool.shutdown(wait=False, cancel_futures=True)
        if sys.stderr.isatty():
            print("\r\033[K", end="", file=sys.stderr, flush=True)
        self.save_answers()

    def add(self, tree, runs, head, found):
        self.counts["trees"] += 1
        self.counts["runs"] += len(runs)
        self.counts["files"] += files_in(head)
        main = head[len(tree.before)] if tree.name != "commands" else {}
        self.counts["refused"] += main.get("exit status", b"0") not in (b"0", STOPPED)
        self.counts["stopped"] += sum(STOPPED in answer.values() for answer in head)
        if not found:
            return
        self.different += 1
        size = len(tree.text) + sum(map(len, tree.files.values()))
        if self.smallest is None or size < self.smallest[0]:
            self.smallest = (size, tree, runs, found)
        print(f"{tree.name}: {len(found)} {'difference' if len(found) == 1 else 'differences'}")
        for d in found[:MOST_DIFFERENCES]:
            line, base, head_line = where(d)
            print(f"  {d.name}{line} of: cnrg {' '.join(short(runs[d.run].arguments))}")
            print(f"    base: {show(base)}\n    head: {show(head_line)}", flush=True)

    def save_answers(self):
        if not self.answers_file or not self.fresh:
            return
        self.answers_file.parent.mkdir(parents=True, exist_ok=True)
        if self.answers_file.exists():  # another comparison may have been here
            self.known = json.loads(self.answers_file.read_text())
        self.known.update(self.fresh)
        part = self.answers_file.with_suffix(f".{os.getpid()}")
        part.write_text(json.dumps(self.known))
        part.replace(self.answers_file)

    def keep_smallest(self):
        """The smallest tree that differs, the commands, and both answers where they part."""
        _, tree, runs, found = self.smallest
        folder = Path(self.keep) / tree.name.replace("/", "-").replace(":", "-")
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        write_tree(tree, folder)
        commands = "".join(f"{i}: cnrg {' '.join(run.arguments)}\n" for i, run in enumerate(runs))
        (folder / "commands").write_text(commands)
        for d in found:
            for side, text in (("base", d.base), ("head", d.head)):
                in_folder(folder, side)
                (folder / side / f"{d.run}-{d.name.replace(' ', '-')}").write_bytes(STOPPED if text is None else text)
        return folder

    def report(self):
        c = self.counts
        seed = f"seed {self.seed}"
        if self.different == 0:
            more = [f"{c['runs']} runs", seed, f"{c['refused']} trees refused alike"]
            if c["stopped"]:
                more.append(f"{c['stopped']} runs stopped after {self.seconds} s")
            print(f"identical: {c['trees']} trees, {c['files']} files ({', '.join(more)})")
            return 0
        print(f"different: {self.different} of {c['trees']} trees ({seed}); the smallest of them and both answers "
              f"are in {self.keep_smallest()}")
        return 1


def in_folder(folder, name):
    path = Path(folder) / name
    path.mkdir(exist_ok=True)
    return str(path)


def short(arguments):
    return arguments if len(arguments) <= 12 else arguments[:9] + ["..."] + arguments[-2:]


def show(line):
    return line.decode("utf-8", "backslashreplace")


def is_binary(program):
    """No script, which could change without its bytes doing so."""
    with open(program, "rb") as file:
        return file.read(4) == b"\x7fELF"


def file_digest(path):
    return hashlib.sha256(Path(path).read_bytes()).hexdigest()


def cad_files():
    """Texts of models, if there is gmsh."""
    if not shutil.which("gmsh"):
        return {}
    texts = {}
    with tempfile.TemporaryDirectory(prefix="cnrg_same_") as folder:
        for name, script in CAD_MODELS.items():
            path = Path(folder) / "model.geo"
            path.write_text('SetFactory("OpenCASCADE");\n' + script)
            subprocess.run(["gmsh", "-0", "model.geo", "-o", name], cwd=folder, stdout=subprocess.DEVNULL,
                           stderr=subprocess.DEVNULL, check=False)
            if (Path(folder) / name).exists():
                text = (Path(folder) / name).read_text()
                texts[name] = re.sub(r"'\d{4}-\d\d-\d\dT[\d:]+'", "'2000-01-01T00:00:00'", text)  # of STEP's header
    return texts


def trees_of(options):
    boxes = ("cnrg: 1\nnodes:\n  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n"
             "  b: {box: {min: [1, 0, 0], max: [2, 1, 1]}}\n  c: {union: [a, b]}\nresult: c\n")
    trees = [Tree("commands", boxes, nodes=["a", "b", "c"])] + found_trees(ROOT)
    if options.bare:
        trees = [tree for tree in trees if not LIBRARY_LEAVES.search(tree.text)]
    cad = cad_files() if options.trees and not options.bare else {}
    trees += [random_tree(options.seed, number, cad) for number in range(options.trees)]
    return [tree for tree in trees if options.only in tree.name]


def parse():
    parser = argparse.ArgumentParser(prog="bench/run same", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("base", help="a program cnrg")
    parser.add_argument("head", help="another one")
    parser.add_argument("--trees", type=int, default=1000, metavar="N", help="random trees (1000)")
    parser.add_argument("--seed", type=int, default=1, metavar="S", help="of the random trees (1)")
    parser.add_argument("--only", default="", metavar="TEXT",
                        help="trees with this text in their names: random/17, papers/")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), metavar="N", help="trees at a time")
    parser.add_argument("--seconds", type=float, default=300, metavar="S", help="a run that takes longer is stopped")
    parser.add_argument("--keep", default="out/same", metavar="FOLDER",
                        help="where the smallest differing tree is kept (out/same)")
    parser.add_argument("--reword", action="append", default=[], metavar="OLD=NEW",
                        help="messages are meant to have changed so: both count as OLD")
    parser.add_argument("--answers", metavar="FOLDER",
                        help="digests of what base answers are kept here, so that it is asked once only")
    parser.add_argument("--bare", action="store_true",
                        help="only what builds without optional libraries answer alike: no CAD files, .vtp, .h5m, .med, mesh")
    parser.add_argument("--print", action="store_true", help="print the trees instead of comparing anything")
    options = parser.parse_args()
    if not all(text.partition("=")[2] for text in options.reword):
        parser.error("--reword is OLD=NEW")
    options.base, options.head = (str(Path(p).absolute()) for p in (options.base, options.head))
    for program in () if options.print else (options.base, options.head):
        if not os.access(program, os.X_OK) or os.path.isdir(program):
            parser.error(f"{program} is no program")
    return options


def main():
    options = parse()
    trees = trees_of(options)
    if not trees:
        print("bench/run same: error: there is no such tree", file=sys.stderr)
        return 2
    if options.print:
        for tree in trees:
            print(f"# {tree.name}\n{tree.text}")
        return 0
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))  # not before what is under way has ended
    same = Same(options)
    same.run(trees)
    return same.report()


if __name__ == "__main__":
    sys.exit(main())
