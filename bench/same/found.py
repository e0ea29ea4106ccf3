"""The trees that stand in the repository: of papers/, in blocks of pages, and in the texts of tests and examples.

A test rarely holds a whole tree. Of its string literals (adjacent ones are one text) these count: a tree file, the
inside of `nodes`, and a single leaf; the latter two become trees around them. What a text cannot say without its
test, such as the name of a node that stands elsewhere, makes a faulty tree, and its message is compared.
"""
import re
from zlib import crc32

from trees import Tree

# Trees of papers/ that read the result of another one, and the commands that make it (papers/run).
READ_BACK = {
    "papers/pereira2012/section.yaml": [("papers/pereira2012/fig10.yaml", None, "out/pereira2012/fig10.json")],
    "papers/pereira2012/fig10-bolts.yaml": [("papers/pereira2012/fig10.yaml", node, f"out/pereira2012/{node}.json")
                                            for node in ("G1", "G3", "rocks")],
}
LEAVES = ("box prism pyramid tetrahedron hull minkowski polygon polyline points halfspace plane sphere cylinder cone torus extrude "
          "revolve bezier bspline coons heightfield mesh step brep group cnrg").split()
OPERATORS = ("union intersection difference aggregate sum product subtract unify complement interior closure boundary "
             "regularize below above simplify select").split()
TOO_FINE = re.compile(r"segments: \d{4}")  # takes minutes
LEAF = re.compile(r"^\s*(" + "|".join(LEAVES) + r"): *(?=[\[{])")
NODE = re.compile(r"^  (\w+): *(\{|$|(?:&\w+ )?\{)", re.M)
IN_NODE = re.compile(r"\b(" + "|".join(LEAVES + OPERATORS) + r"): ")

LITERAL = re.compile(r"""
    R"(?P<mark>[^\s()\\"]{0,16})\((?P<raw>.*?)\)(?P=mark)"   # R"(...)"
  | (?<!')"(?P<text>(?:[^"\\\n]|\\.)*)"                      # "..."
  | //[^\n]* | '(?:[^'\\\n]|\\.)+'                           # no text
""", re.X | re.S)
ESCAPES = {"n": "\n", "t": "\t", '"': '"', "\\": "\\", "r": "\r", "0": "\0"}


def texts_of_source(source):
    """The string literals of a C++ file; those with nothing but blanks between them are one."""
    texts, end = [], None
    for match in LITERAL.finditer(source):
        if match["raw"] is not None:
            text = match["raw"]
        elif match["text"] is not None:
            text = re.sub(r"\\(.)", lambda m: ESCAPES.get(m[1], m[0]), match["text"], flags=re.S)
        else:
            continue
        if end is not None and not source[end:match.start()].strip():
            texts[-1] += text
        else:
            texts.append(text)
        end = match.end()
    return texts


def names_of(text):
    """The names in `nodes`, in block or in flow style; what is no tree has none."""
    start = re.search(r"^nodes: *(\{)?", text, re.M)
    if not start:
        return []
    if not start[1]:
        rest = text[start.end():]
        end = re.search(r"^\S", rest, re.M)
        first = re.search(r"^( +)[\w\"]", rest, re.M)
        if not first:
            return []
        return re.findall(rf"^{first[1]}([\w-]+):(?: |$)", rest[:end.start() if end else None], re.M)
    names, depth = [], 1
    for match in re.finditer(r"[\[{]|[\]}]|([\w-]+): ", text[start.end():]):
        if match[1] and depth == 1:
            names.append(match[1])
        depth += {"[": 1, "{": 1, "]": -1, "}": -1}.get(match[0], 0)
        if depth == 0:
            break
    return names


def whole(text):
    """A tree file of what a literal holds, or nothing."""
    if re.search(r"^\{?\"?cnrg\"?: *1\b", text, re.M):
        return text if re.search(r"\bnodes\b", text) else None
    if LEAF.match(text):
        return "cnrg: 1\nmaterials: {rock: {}, ore: {}, air: {}}\nnodes:\n  a: {" + text.strip() + "}\nresult: a\n"
    nodes = [m[1] for m in NODE.finditer(text)]
    if nodes and IN_NODE.search(text):
        inside = text if text.endswith("\n") else text + "\n"
        if re.search(r"^\S", inside, re.M):
            return None
        return f"cnrg: 1\nmaterials: {{rock: {{}}, ore: {{}}, air: {{}}}}\nnodes:\n{inside}result: {nodes[-1]}\n"
    return None


def points_near(text):
    """Points made of the numbers in a tree."""
    numbers = list(dict.fromkeys(re.findall(r"(?<![\w.])-?\d{1,4}(?:\.\d{1,4})?(?![\w./])", text)))[:12] or ["0"]
    n = len(numbers)
    return [f"{numbers[i % n]} {numbers[(i * 5 + 1) % n]} {numbers[(i * 7 + i // n) % n]}" for i in range(3 * n)]


def found_trees(root):
    """All of them, by name; the same text counts once."""
    trees, seen = [], set()

    def add(name, text, **more):
        if text in seen and not more:
            return
        seen.add(text)
        tree = Tree(name, text, nodes=names_of(text), points=points_near(text), **more)
        tree.turn = crc32(text.encode())
        trees.append(tree)

    for path in sorted((root / "papers").rglob("*.yaml")):
        name = path.relative_to(root).as_posix()
        before = READ_BACK.get(name, [])
        files = {tree: (root / tree).read_text() for tree, _, _ in before}
        add(name, path.read_text(), path=name, files=files, before=before, thorough=True)
    for path in sorted(root.rglob("*.md")):
        name = path.relative_to(root).as_posix()
        if name.split("/")[0] in ("build", "out"):
            continue
        for k, block in enumerate(re.findall(r"^```yaml\n(.*?)^```", path.read_text(), re.M | re.S)):
            if "nodes:" in block:
                add(f"{name}:{k}", block, thorough=True)
    sources = [p for room in ("csg/examples", "tests") for p in sorted((root / room).rglob("*.cpp"))]
    for path in sources:
        for k, text in enumerate(texts_of_source(path.read_text())):
            tree = whole(text)
            if tree and not TOO_FINE.search(tree):
                add(f"{path.relative_to(root).as_posix()}:{k}", tree)
    return trees
