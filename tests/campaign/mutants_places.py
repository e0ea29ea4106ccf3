"""Where the source can be changed by one operator or constant, and the text of the change.

Read from the syntax tree, for in the text alone a `<` may open a template's arguments and a `-` belong to a number.
A place is a comparison, `&&` or `||`, an integer or a floating constant, true or false, a sum, a difference, a sign,
or one of += and -=. Left out are constant expressions, which no switch at run time can change, and what only a
message of an error says.
"""
import hashlib
import json
import os
import random
import re
import shlex
from dataclasses import asdict, dataclass, field
from pathlib import Path

try:
    from clang import cindex
except ImportError as error:
    raise SystemExit("mutants: needs Debian's python3-clang-14: kernel/install-deps python3-clang-14") from error

ROOMS = ("kernel/", "csg/operators/")

# What an operator may become; with two, a place has one of them by its seed.
BINARY = {
    "<": ("<=", ">="), "<=": ("<", ">"), ">": (">=", "<="), ">=": (">", "<"), "==": ("!=",), "!=": ("==",),
    "&&": ("||",), "||": ("&&",), "+": ("-",), "-": ("+",), "+=": ("-=",), "-=": ("+=",),
}
ASSIGNMENTS = ("+=", "-=")
INTEGERS = {"bool", "char", "signed char", "unsigned char", "short", "unsigned short", "int", "unsigned int", "long",
            "unsigned long", "long long", "unsigned long long"}


@dataclass
class Place:
    """An expression of a file, in bytes from `start` to `end`, and how it changes."""
    file: str
    line: int
    start: int
    end: int
    old: str                 # the operator or constant
    new: str                 # what it becomes
    kind: str                # binary, sign or constant
    left: tuple = ()         # of a binary one: where the operands are
    right: tuple = ()
    type: str = ""           # what both branches are converted to, if they would differ
    last_line: int = 0
    number: int = field(default=0, compare=False)

    def key(self):
        return (self.file, self.start, self.end, self.old)


def arguments_of(command):
    """What of a compile command the syntax tree depends on."""
    words = shlex.split(command)
    kept = ["-xc++"]
    for i, word in enumerate(words):
        if word.startswith(("-D", "-I", "-std=", "-isystem")):
            kept.append(word)
            if word in ("-isystem", "-I", "-D"):
                kept.append(words[i + 1])
    return kept


class Parser:
    """libclang with the compile commands of the preset `tidy`. Headers of other libraries are parsed once."""

    def __init__(self, root, folder):
        self.root, self.folder = Path(root), Path(folder)
        self.index = cindex.Index.create()
        commands = json.loads((self.root / "build/tidy/compile_commands.json").read_text())
        self.arguments = {}
        for entry in commands:
            name = os.path.relpath(entry["file"], self.root)
            if name.startswith(ROOMS):
                self.arguments[name] = arguments_of(entry["command"])
        self.precompiled = {}

    def files(self):
        return sorted(self.arguments)

    def precompile(self, arguments):
        key = hashlib.sha1(" ".join(a for a in arguments if not a.startswith("-I")).encode()).hexdigest()[:12]
        if key not in self.precompiled:
            names = set()
            for room in ROOMS:
                for file in (self.root / room).rglob("*.*"):
                    if file.suffix in (".h", ".cpp"):
                        names.update(re.findall(r"^#include (<[^>]+>)", file.read_text(), re.M))
            header, output = self.folder / f"others-{key}.h", self.folder / f"others-{key}.pch"
            text = "".join(f"#include {name}\n" for name in sorted(names))
            if not output.exists() or not header.exists() or header.read_text() != text:
                header.write_text(text)
                flags = ["-xc++-header"] + [a for a in arguments if a != "-xc++"]
                # Incomplete: it is going to be the beginning of another file.
                unit = self.index.parse(str(header), flags, options=cindex.TranslationUnit.PARSE_INCOMPLETE)
                unit.save(str(output))
            self.precompiled[key] = output
        return ["-include-pch", str(self.precompiled[key])]

    def parse(self, name):
        arguments = self.arguments[name]
        return self.index.parse(str(self.root / name), arguments + self.precompile(arguments))


def errors_of(unit, root):
    """What is wrong in our files; headers of others confuse libclang where the compiler takes them."""
    return [d for d in unit.diagnostics if d.severity >= cindex.Diagnostic.Error and d.location.file is not None and
            d.location.file.name.startswith(str(root))]


class Finder:
    """The places of all files of our rooms that a translation unit reads."""

    def __init__(self, root, seed):
        self.root, self.seed = str(root) + "/", seed
        self.texts, self.places = {}, {}

    def ours(self, cursor):
        file = cursor.location.file
        if file is None or not file.name.startswith(self.root):
            return None
        name = os.path.normpath(file.name)[len(self.root):]
        return name if name.startswith(ROOMS) else None

    def text(self, name):
        if name not in self.texts:
            self.texts[name] = Path(self.root + name).read_bytes()
        return self.texts[name]

    def unit(self, unit):
        for error in errors_of(unit, self.root):
            raise SystemExit(f"mutants: {error}")
        for cursor in unit.cursor.get_children():
            name = self.ours(cursor)
            if name is not None:
                self.walk(cursor, name, None)

    def walk(self, cursor, name, parent):
        kind = cursor.kind
        if kind in (cindex.CursorKind.CXX_THROW_EXPR, cindex.CursorKind.STATIC_ASSERT, cindex.CursorKind.ENUM_DECL,
                    cindex.CursorKind.TYPE_ALIAS_DECL):
            return
        if kind.is_declaration() and kind not in (cindex.CursorKind.NAMESPACE, cindex.CursorKind.CLASS_DECL,
                                                  cindex.CursorKind.STRUCT_DECL):
            head = self.text(name)[cursor.extent.start.offset:cursor.location.offset]
            if re.search(rb"\b(constexpr|consteval|constinit)\b", head):
                return
        children = list(cursor.get_children())
        if kind.is_expression():
            self.expression(cursor, children, name, parent)
        if kind == cindex.CursorKind.CALL_EXPR and cursor.spelling == "require":
            children = children[:2]  # the function and the condition
        if kind == cindex.CursorKind.CASE_STMT:
            children = children[1:]
        for child in children:
            self.walk(child, name, cursor)

    def expression(self, cursor, children, name, parent):
        text = self.text(name)
        start, end = cursor.extent.start.offset, cursor.extent.end.offset
        kind = cursor.kind
        if kind in (cindex.CursorKind.INTEGER_LITERAL, cindex.CursorKind.FLOATING_LITERAL,
                    cindex.CursorKind.CXX_BOOL_LITERAL_EXPR):
            self.constant(cursor, text, start, end, name, parent)
        elif kind == cindex.CursorKind.UNARY_OPERATOR:
            if text[start:start + 1] == b"-" and text[start + 1:start + 2] != b"-":
                self.add(cursor, name, start, end, "-", "", "sign", (), (start + 1, end))
        elif len(children) >= 2:
            first, last = children[0].extent, children[-1].extent
            if first.start.offset == start and last.end.offset == end and first.end.offset < last.start.offset:
                old = text[first.end.offset:last.start.offset].decode().strip()
                if old in BINARY and "basic_string" not in cursor.type.get_canonical().spelling:
                    choices = BINARY[old]
                    draw = random.Random(f"{self.seed} {name} {start} {end}")
                    self.add(cursor, name, start, end, old, draw.choice(choices), "binary",
                             (start, first.end.offset), (last.start.offset, end))

    def constant(self, cursor, text, start, end, name, parent):
        old = text[start:end].decode()
        if text[end:end + 1] == b">" or re.match(rb"\]\s*[;{=]", text[end:end + 4]) and parent.kind in (
                cindex.CursorKind.VAR_DECL, cindex.CursorKind.FIELD_DECL):
            return  # an argument of a template, the size of an array
        if cursor.kind == cindex.CursorKind.CXX_BOOL_LITERAL_EXPR:
            new = {"true": "false", "false": "true"}.get(old)
        elif cursor.kind == cindex.CursorKind.INTEGER_LITERAL:
            match = re.fullmatch(r"(\d+)([uUlL]*)", old)
            new = None if not match else str(1 - int(match[1]) if int(match[1]) < 2 else int(match[1]) + 1) + match[2]
        else:
            new = "1.0" if re.fullmatch(r"[0.]+", old) else f"2 * {old}"
        if new is None:
            return
        to = parent.type.spelling if parent is not None and parent.kind == cindex.CursorKind.UNEXPOSED_EXPR else ""
        to = to if to in INTEGERS else ""
        self.add(cursor, name, start, end, old, new, "constant", (), (), to)

    def add(self, cursor, name, start, end, old, new, kind, left, right, to=""):
        if kind != "constant" and old not in ASSIGNMENTS:
            spelling = cursor.type.get_canonical().spelling
            # Sums of GMP are expressions that have not been computed yet, each of a type of its own.
            if spelling.startswith("__gmp_expr<"):
                to = "mpq_class" if spelling.startswith("__gmp_expr<__mpq") else "mpz_class"
        place = Place(name, cursor.extent.start.line, start, end, old, new, kind, tuple(left), tuple(right), to,
                      cursor.extent.end.line)
        self.places.setdefault(place.key(), place)


def all_places(parser, folder, seed, say):
    """The places of all files, from a file of earlier runs if nothing has changed since."""
    sources = sorted(p for room in ROOMS for p in (parser.root / room).rglob("*.*") if p.suffix in (".h", ".cpp"))
    state = hashlib.sha1(str(seed).encode() + Path(__file__).read_bytes())
    for path in sources:
        state.update(str(path).encode() + path.read_bytes())
    cache = Path(folder) / f"places-{state.hexdigest()[:12]}.json"
    if not cache.exists():
        finder = Finder(parser.root, seed)
        for i, name in enumerate(parser.files(), 1):
            say(f"reading {name} ({i} of {len(parser.files())})", passing=True)
            finder.unit(parser.parse(name))
        places = sorted(finder.places.values(), key=Place.key)
        cache.write_text(json.dumps([asdict(p) for p in places]))
    return [Place(**{**p, "left": tuple(p["left"]), "right": tuple(p["right"])}) for p in json.loads(cache.read_text())]


def rewritten(text, places):
    """The text of a file with a switch at each of these places. Places may stand inside of each other."""
    ordered = sorted(places, key=lambda p: (p.start, -p.end))

    def span(start, end, inside):
        out, at = [], start
        while inside:
            place, rest = inside[0], inside[1:]
            within = [p for p in rest if p.end <= place.end]
            inside = [p for p in rest if p.end > place.end]
            out += [text[at:place.start], switch(place, within)]
            at = place.end
        return b"".join(out + [text[at:end]])

    def part(bounds, within):
        return span(*bounds, [p for p in within if bounds[0] <= p.start and p.end <= bounds[1]])

    def switch(place, within):
        if place.kind == "constant":
            changed, usual = place.new.encode(), place.old.encode()
        elif place.kind == "sign":
            value = part(place.right, within)
            changed, usual = b"+(" + value + b")", b"-(" + value + b")"
        else:
            left, right = part(place.left, within), part(place.right, within)
            changed, usual = (b"(" + left + b") " + o.encode() + b" (" + right + b")" for o in (place.new, place.old))
        if place.type and place.kind != "constant":
            changed, usual = (place.type.encode() + b"(" + x + b")" for x in (changed, usual))
        choice = b"(cnrg_mutant(%d) ? %s : %s)" % (place.number, changed, usual)
        if place.type and place.kind == "constant":
            choice = b"static_cast<%s>%s" % (place.type.encode(), choice)
        return choice

    return span(0, len(text), ordered)
