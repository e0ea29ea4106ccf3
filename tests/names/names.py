"""Names of C++ that stand for two things.

All of a room can be compiled as one file, and all of the house is linked into one program. So a class of a namespace
is defined in one file, and a name in an anonymous namespace is in one file of its room and in none of the headers
that the room sees. Two aliases of a name are one if they stand for the same type.

    names.py [FOLDER...]    prints what is wrong below the folders, all of the house without one; exit status 1 if
                            there is something

It reads declarations at the scope of namespaces, formatted as `.clang-format` has them, not what is in classes and
functions.
"""
import re
import sys
from collections import defaultdict
from pathlib import Path
from typing import NamedTuple

# Folders of programs and of stand-ins: what is in one of these files meets nothing of the others.
ALONE = ("csg/examples", "bench", "bench/peers/external", "tests/consumer", "kernel/stand_ins")


class Name(NamedTuple):
    file: str
    line: int
    scope: str      # the namespaces around, without anonymous ones
    hidden: bool    # in an anonymous namespace, or a constant of a .cpp
    kind: str       # type, alias, variable, function
    name: str
    said: str       # of an alias what it stands for, of a function its parameters
    body: bool      # of a function: it is defined, too

    def at(self):
        return f"{self.file}:{self.line}"


NO_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|R"([^()\\ ]*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"'
                     r"|(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+'|^[ \t]*#(?:\\\n|[^\n])*", re.S | re.M)
CLASS = re.compile(r"(?:template ?<.*> )?(?:requires .* )?(?:struct|class|union|enum(?: class| struct)?) "
                   r"(?:alignas\(\w+\) )?(?:\[\[.*?\]\] )?(\w+)(?: final)?(?: ?:[^:(].*)?$")
FORWARD = re.compile(r"(?:template ?<.*> ?)?(?:struct|class|union|enum(?: class)?) [\w:<>, ]+(?: : [\w:]+)?$")
OPERATOR = re.compile(r"operator ?(?:[^\w\s(]+|\(\)|[\w:<>, ]+(?=\())")
ANGLES = re.compile(r"<[^<>()]*>")
USING = re.compile(r"^using namespace ([\w:]+);", re.M)
INCLUDE = re.compile(r'^\s*#include "([^"]+)"', re.M)


def without_text(source):
    """Without comments, texts and lines of the preprocessor; as many lines as before."""
    def blank(match):
        first = match[0][0]
        return ('""' if first in '"R' else "0" if first == "'" else " ") + "\n" * match[0].count("\n")
    return NO_CODE.sub(blank, source)


def without_angles(head):
    while (shorter := ANGLES.sub("", head)) != head:
        head = shorter
    return head


def is_function(head):
    flat = without_angles(OPERATOR.sub("operator", head))
    bracket, equals = flat.find("("), flat.find("=")
    return bracket >= 0 and (equals < 0 or bracket < equals)


def parameters(head, begin):
    """The types of the parameters behind the bracket, without names and defaults."""
    parts, depth, last = [], 1, begin
    for i in range(begin, len(head)):
        depth += (head[i] in "([{<") - (head[i] in ")]}>")
        if depth == 0 or (depth == 1 and head[i] == ","):
            parts.append(head[last:i])
            last = i + 1
        if depth == 0:
            break
    types = []
    for part in parts:
        part = part.split("=")[0].strip()
        named = re.match(r"(.*[\s&*>])\w+$", part)
        types.append((named[1] if named and named[1].strip() not in ("const", "unsigned") else part).strip())
    return ", ".join(types)


def declared(head):
    """(kind, name, what is said of it) of a declaration that is no class; None of what declares nothing here."""
    if head.startswith(("using namespace ", "template <> ", "static_assert", "extern template", "friend ")):
        return None
    if head.startswith("using ") or re.match(r"namespace \w+ =", head):
        name, _, stands_for = head.split(" ", 1)[1].partition(" = ")
        return ("alias", name, stands_for) if stands_for else None
    if FORWARD.match(head) or re.match(r"(?:typename|class|struct) ", head):
        return None
    if is_function(head):
        if match := re.search(r"(?:^|[\s&*])(operator ?(?:[^\w\s(]+|\(\)))\(", head):
            return "function", match[1], parameters(head, match.end())
        head = re.sub(r"\bHandle\((\w+)\)", r"\1", re.sub(r"alignas\(\w+\)", "", head))
        match = re.search(r"([\w:~]+)\(", without_angles(OPERATOR.sub("operator", head)))
        if not match or "::" in match[1] or re.fullmatch(r"operator.*|[A-Z_]+", match[1]):  # or a macro
            return None
        return "function", match[1], parameters(head, head.index(match[1] + "(") + len(match[1]) + 1)
    match = re.search(r"(?:^|[\s&*])(\w+)$", re.split(r"[={\[,]", without_angles(head), maxsplit=1)[0].strip())
    return ("variable", match[1], "") if match else None


def past_brackets(text, at):
    """The place behind the bracket that closes the one before `at`."""
    depth = 1
    for bracket in re.compile(r"[{}]").finditer(text, at):
        depth += 1 if bracket[0] == "{" else -1
        if depth == 0:
            return bracket.end()
    raise ValueError("a bracket is open")


def names_in(file, source):
    text = without_text(source)
    scopes, begin, at = [], 0, 0
    mark = re.compile(r"[{};]")
    while found := mark.search(text, at):
        head = " ".join(text[begin:found.start()].split())
        at = found.end()
        body = found[0] == "{"
        entry = None
        if found[0] == "}":
            scopes.pop()
        elif body and (opened := re.match(r'(?:inline )?namespace ?([\w:]*)$|extern ""$', head)):
            scopes.append(opened[1])
        else:
            if body:
                # Braces between round brackets or in the initializers of a constructor belong to the head.
                inner = head.count("(") > head.count(")")
                at = past_brackets(text, at)
                if inner or (is_function(head) and not text[found.start() - 1].isspace()):
                    continue
            named = CLASS.match(head) if body else None
            entry = ("type", named[1], "") if named else declared(head) if head else None
            if body and not is_function(head):  # up to the semicolon
                while (found := mark.search(text, at))[0] == "{":
                    at = past_brackets(text, found.end())
                at = found.end()
        if entry:
            first = begin + len(text[begin:]) - len(text[begin:].lstrip())
            kept = "static " if entry[0] == "function" else "(?:static|const|constexpr) "
            own = entry[0] == "alias" or re.match(kept, head)
            hidden = "" in scopes or (file.endswith(".cpp") and bool(own))
            yield Name(file, text.count("\n", 0, first) + 1, "::".join(s for s in scopes if s), hidden, *entry, body)
        begin = at


class House:
    """The sources below some folders of the root."""

    def __init__(self, root, folders):
        self.names, self.includes, self.stands_for, self.local, self.used = [], {}, {}, {}, {}
        for folder in folders:
            for path in sorted(Path(root, folder).rglob("*")):
                file = path.relative_to(root).as_posix()
                if path.suffix in (".h", ".cpp") and path.parent.relative_to(root).as_posix() not in ALONE:
                    self.add(file, path.read_text())

    def add(self, file, source):
        self.includes[file] = INCLUDE.findall(source)
        found = list(names_in(file, source))
        self.names += found
        self.used[file] = set(USING.findall(source)) if file.endswith(".cpp") else set()
        self.local[file] = {n.name: n.said for n in found if n.kind == "alias"}
        if file.endswith(".h"):
            # Aliases in classes, by the class that begins last before: enough to tell what `Mesh::Index` stands for.
            owner = ""
            for match in re.finditer(r"^(?:class|struct) (\w+)[^;\n]*\{|^ *using (\w+) = ([^;]+);", source, re.M):
                if match[1]:
                    owner = match[1]
                else:
                    self.stands_for.setdefault((owner if match[0][0] == " " else "", match[2]), match[3])

    def meaning(self, type_name):
        """An alias followed to what it stands for."""
        for _ in range(8):
            last = type_name
            owner, _, name = type_name.rpartition("::")
            type_name = self.stands_for.get((owner, name), type_name)
            if type_name == last:
                # In a class, another alias of it.
                return " ".join(type_name.split())
            if "::" not in type_name and (owner, type_name) in self.stands_for:
                type_name = f"{owner}::{type_name}"
        return type_name

    def types(self, function):
        """The parameters of a function, aliases of its file and of the house followed."""
        local = self.local[function.file]
        return re.sub(r"[A-Za-z_][\w:]*", lambda m: self.meaning(local.get(m[0], m[0])), function.said)

    def sees(self, file, seen):
        for included in self.includes.get(file, []):
            if included in self.includes and included not in seen:
                seen.add(included)
                self.sees(included, seen)
        return seen

    def are_one(self, names):
        """All of them are aliases of one type, or declarations of one function."""
        if all(n.kind == "alias" for n in names):
            return len({self.meaning(n.said) for n in names}) == 1
        return all(n.kind == "function" for n in names) and sum(n.body for n in names) <= 1 and \
            len({self.types(n) for n in names}) == 1

    def faults(self):
        yield from self.classes_of_one_name()
        yield from self.hidden_names()
        yield from self.ambiguous_names()

    def classes_of_one_name(self):
        known = defaultdict(list)
        for n in self.names:
            if not n.hidden and (n.kind != "function" or (n.body and n.file.endswith(".h"))):
                known[n.scope, n.name, self.types(n) if n.kind == "function" else ""].append(n)
        for (scope, name, _), names in sorted(known.items()):
            if len({n.file for n in names}) > 1 and not self.are_one(names):
                yield f"{scope}::{name} is defined in more than one file: " + ", ".join(n.at() for n in names)

    def hidden_names(self):
        rooms, shown = defaultdict(list), defaultdict(list)
        for n in self.names:
            if n.hidden and n.file.endswith(".cpp"):
                rooms[n.file.rpartition("/")[0]].append(n)
            elif not n.hidden:
                shown[n.name].append(n)
        for room, names_of_room in sorted(rooms.items()):
            seen = {f for f in self.includes if f.rpartition("/")[0] == room and f.endswith(".cpp")}
            for file in list(seen):
                self.sees(file, seen)
            used = set().union(*(self.used[file] for file in seen))
            hidden = defaultdict(list)
            for n in names_of_room:
                # Operators are overloads of each other, and differ by what they take.
                takes = self.types(n) if n.name.startswith("operator") else ""
                hidden["" if n.scope in used else n.scope, n.name, takes].append(n)
            for (scope, name, _), names in sorted(hidden.items()):
                if len({n.file for n in names}) > 1 and not self.are_one(names):
                    yield f"`{name}` is in more than one file of {room}: " + ", ".join(n.at() for n in names)
                for other in shown[name] if name in shown else []:
                    around = (scope + "::").startswith(other.scope + "::") or (scope == "" and other.scope in used)
                    one = names[0].kind == other.kind == "alias" and self.are_one([other, *names])
                    if other.file in seen and around and not one:
                        yield f"`{name}` hides what the room sees: {names[0].at()}, {other.at()}"
                        break

    def ambiguous_names(self):
        """What one file of a room uses two namespaces for, and another one sees in both."""
        rooms = defaultdict(set)
        for file in self.includes:
            if file.endswith(".cpp"):
                rooms[file.rpartition("/")[0]].add(file)
        for room, seen in sorted(rooms.items()):
            used = set().union(*(self.used[file] for file in seen))
            if len(used) < 2:
                continue
            for file in list(seen):
                self.sees(file, seen)
            known = defaultdict(dict)
            for n in self.names:
                if n.file in seen and n.scope in used and not n.hidden and n.kind != "function":
                    known[n.name].setdefault(n.scope, n)
            for name, by_scope in sorted(known.items()):
                if len(by_scope) > 1 and not self.are_one(list(by_scope.values())):
                    yield f"`{name}` is ambiguous in {room}: " + ", ".join(n.at() for n in by_scope.values())


def main():
    root = Path(__file__).resolve().parents[2]
    faults = list(House(root, sys.argv[1:] or ["kernel", "csg", "bench", "tests"]).faults())
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
