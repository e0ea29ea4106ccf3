"""What a report is made of: a folder of rows and what a sweep says beside them (bench/sweep/row.h, description.h).

    FOLDER/systems.json    systems in the order of the report
    FOLDER/families.json   families in the order of the report
    FOLDER/machine.json    the machine
    FOLDER/**/*.json       one row each; hidden files and folders are not looked at

The first three may be missing: then the report says so and orders by name. Files are read strictly, since a report
of half-read rows would look like any other: each member must be there and of its type, and a fault is an `Unread`
that names the file, the member and what to do. Members that nobody here knows are left out.
"""
import json
import math
import os
import re
from dataclasses import dataclass
from pathlib import Path

OURS = "ours"  # the system that others are compared with
# Verdicts in the order of the tables, and what a reader counts them as.
CLASS_OF = {"same": "exact", "same-regularized": "right", "contact-duplicated": "right", "contact-lost": "right",
            "dangling-lost": "right", "within-rounding": "right", "wrong": "wrong", "refused": "refused",
            "crashed": "no result", "timed-out": "no result", "out-of-memory": "no result", "unjudged": "unjudged"}
VERDICTS = tuple(CLASS_OF)
FAILURES = ("wrong", "refused", "no result")
CONFIRMED = ("Nef", "Nef-by-us", "node", "formula", "volume", "none", "DISAGREES")
CONFIRMED_ROWS = ("Nef", "integrals", "points", "none", "DISPUTED", "no-verdict")
LAST_DISTANCE = 300


class Unread(Exception):
    """The rows, or a file of them, are not what a report can be made of."""


class _NotA(Exception):
    """A value is not what the text says."""


def _text(value):
    if not isinstance(value, str):
        raise _NotA("a text")
    try:
        value.encode()
    except UnicodeEncodeError:  # half of a pair of surrogates
        raise _NotA("a text") from None
    return value


def _flag(value):
    if not isinstance(value, bool):
        raise _NotA("true or false")
    return value


def _number(value):
    try:
        if type(value) in (int, float) and math.isfinite(float(value)):
            return float(value)
    except OverflowError:
        pass
    raise _NotA("a number")


def _not_negative(value):
    if _number(value) < 0:
        raise _NotA("a number from 0")
    return float(value)


def _whole(least, most):
    def check(value):
        if type(value) is not int:
            raise _NotA("a whole number")
        if not least <= value <= most:
            raise _NotA("a number in its range")
        return value
    return check


def _one_of(known, said):
    def check(value):
        if _text(value) not in known:
            raise _NotA(said)
        return value
    return check


def _or_null(check):
    return lambda value: None if value is None else check(value)


def _list(value):
    if not isinstance(value, list):
        raise _NotA("a list")
    return value


def _object(name, schema):
    """Checks an object: its members that the schema names, in the schema's order."""
    def check(value):
        if not isinstance(value, dict):
            raise Unread(f"{name} is no JSON object")
        members = {}
        for key, check_member in schema.items():
            if key not in value:
                raise Unread(f"{name} has no member `{key}`")
            try:
                members[key] = check_member(value[key])
            except _NotA as expected:
                raise Unread(f"member `{key}` of {name} is not {expected}") from None
        return members
    return check


def _objects(name, schema):
    check = _object(name, schema)
    return lambda value: [check(one) for one in _list(value)]


def _numbers(value):
    if not isinstance(value, list):
        raise _NotA("a list of numbers from 0")
    return [_not_negative(one) for one in value]


def _texts_by_name(value):
    if not isinstance(value, dict) or not all(isinstance(text, str) for text in value.values()):
        raise _NotA("an object of texts")
    return {_text(name): _text(text) for name, text in value.items()}


def _pairs(value):
    for one in _list(value):
        if not (isinstance(one, list) and len(one) == 2 and all(isinstance(text, str) for text in one)):
            raise _NotA("a list of pairs of texts")
    return [[_text(text) for text in one] for one in value]


_count, _long, _unsigned = _whole(0, 2**64 - 1), _whole(-2**63, 2**63 - 1), _whole(0, 2**32 - 1)
_FACTS = {"volume": _text, "vertices": _count, "edges": _count, "faces": _count, "regions": _count,
          "shells": _count, "genus": _long, "non_manifold_edges": _count, "non_manifold_vertices": _count,
          "dangling_faces": _count, "dangling_edges": _count, "dangling_vertices": _count}
_TRUTH = {"facts": _object("the truth's facts", _FACTS),
          "confirmed": _one_of(CONFIRMED, "one of " + ", ".join(CONFIRMED)), "reason": _text}
_CONFIRMATION = {"by": _one_of(CONFIRMED_ROWS, "one of " + ", ".join(CONFIRMED_ROWS)), "reason": _text}
_ROW = {"problem": _text, "family": _text, "values": _texts_by_name, "operation": _text, "size": _long,
        "distance": _or_null(_whole(-2**31, 2**31 - 1)), "has_distance": _flag, "seed": _unsigned,
        "operands": _count, "triangles": _count, "system": _text,
        "verdict": _one_of(CLASS_OF, "a known verdict"), "stage": _text, "message": _text,
        "stages": _objects("a stage", {"name": _text, "seconds": _not_negative}),
        "warm": _numbers, "asserted_seconds": _or_null(_not_negative), "seconds": _not_negative, "peak_bytes": _count, "own_bytes": _count,
        "exact_share": _number, "note": _text,
        "facts": _or_null(_object("the facts", _FACTS)), "excess": _or_null(_number),
        "missing": _or_null(_number), "duplicates": _count, "truth": _object("the truth", _TRUTH),
        "confirmation": _object("the confirmation", _CONFIRMATION),
        "limit_seconds": _not_negative, "limit_bytes": _count, "load": _not_negative, "command": _text}
_SYSTEM = {"name": _text, "title": _text, "guarantee": _text, "version": _text, "rounding": _not_negative,
           "regularized": _flag, "absent": _text,
           "varies": _or_null(_object("a system's varies", {"of": _text, "rule": _text, "on": _flag}))}
_FAMILY = {"name": _text, "title": _text, "size_means": _text, "distance_means": _text,
           "growth": _one_of(("triangles", "size", ""), "triangles or size")}
_MACHINE = {"cpu": _text, "cores": _unsigned, "memory_bytes": _count, "system": _text, "compiler": _text,
            "commit": _text, "date": _text, "command": _text,
            "left_out": _pairs}


def row_of(value):
    row = _object("the row", _ROW)(value)
    if row["distance"] is not None and not (row["has_distance"] and 0 <= row["distance"] <= LAST_DISTANCE):
        raise Unread("member `distance` of the row is not null or, in a family that has distances, a whole number "
                     f"from 0 to {LAST_DISTANCE}")
    return row


def _described(name, schema):
    def read(value):
        if not isinstance(value, list):
            raise Unread("no JSON list")
        return _objects(name, schema)(value)
    return read


def systems_of(value):
    """`varies` is None where a system varies none."""
    known = [{"varies": None} | one if isinstance(one, dict) else one for one in value] if isinstance(value, list) else value
    return _described("a system", _SYSTEM)(known)


families_of = _described("a family", _FAMILY)
machine_of = _object("the machine", _MACHINE)


def _no_constant(name):
    raise ValueError(f"{name} is no number")


def _json(data):
    try:
        return json.loads(data.decode(), parse_constant=_no_constant)
    except json.JSONDecodeError as fault:
        raise Unread(f"no JSON: parse error at line {fault.lineno}, column {fault.colno}: {fault.msg}") from None
    except (ValueError, RecursionError) as fault:
        raise Unread(f"no JSON: {fault}") from None


def _read(path, remedy, check):
    try:
        data = Path(path).read_bytes()
    except OSError:
        raise Unread(f"{path}: cannot be read") from None
    try:
        return check(_json(data))
    except Unread as fault:
        raise Unread(f"{path}: {fault}; {remedy}") from None


def natural(name):
    """A key by which numbers in names are sorted by value: `s10` comes after `s9`."""
    key = []
    for part in re.findall(r"[0-9]+|[^0-9]", name):
        digits = part[0].isascii() and part[0].isdigit()
        key.append((ord("0"), len(part.lstrip("0") or "0"), part.lstrip("0") or "0") if digits
                   else (ord(part), 0, ""))
    return key, name


@dataclass
class Experiment:
    """Every system and family of a row is there, then with its name only if no file describes it."""
    systems: list
    families: list
    machine: dict  # or None
    rows: list     # by family, problem (numbers in names by value) and system

    def __post_init__(self):
        self.system = {info["name"]: info for info in self.systems}
        self.family = {info["name"]: info for info in self.families}
        self.place = {name: place for place, name in enumerate(self.system)}


def _completed(infos, schema, names):
    """With infos that say nothing but a name for the names that have none."""
    known = set()
    for info in infos:
        if info["name"] in known:
            raise Unread(f"`{info['name']}` is described twice; remove one of the two")
        known.add(info["name"])
    nothing = {key: "" for key in schema} | ({"rounding": 0.0, "regularized": True} if "rounding" in schema else {})
    return infos + [nothing | {"name": name, "title": name} for name in sorted(names - known, key=natural)]


def make_experiment(rows, systems, families, machine):
    if not rows:
        raise Unread("there are no rows; run a sweep first")
    systems = _completed(systems, _SYSTEM, {row["system"] for row in rows})
    families = _completed(families, _FAMILY, {row["family"] for row in rows})
    systems.sort(key=lambda info: info["name"] != OURS)
    experiment = Experiment(systems, families, machine, rows)
    family_place = {name: place for place, name in enumerate(experiment.family)}
    experiment.rows = sorted(rows, key=lambda row: (family_place[row["family"]], natural(row["problem"]),
                                                    experiment.place[row["system"]]))
    for row, after in zip(experiment.rows, experiment.rows[1:]):
        if (row["problem"], row["system"]) == (after["problem"], after["system"]):
            raise Unread(f"two rows of {row['system']} on {row['problem']}; remove one of the two files")
    return experiment


def _row_files(folder):
    def fail(fault):
        raise Unread(f"{fault.filename}: cannot be read")
    found = []
    for where, folders, files in os.walk(folder, onerror=fail):
        folders[:] = [name for name in folders if not name.startswith(".")]
        for name in files:
            path = Path(where) / name
            described = Path(where) == folder and name in ("systems.json", "families.json", "machine.json")
            if path.suffix == ".json" and not name.startswith(".") and not described and path.is_file():
                found.append(path)
    return sorted(found)


def read_experiment(folder, machine_file=None):
    """Reads a folder; `machine_file` replaces its machine.json."""
    root = Path(folder)
    if not root.is_dir():
        raise Unread(f"{folder}: is no folder; give the one that a sweep wrote its rows to")
    rows = [_read(path, "remove the file and let the sweep make it again", row_of) for path in _row_files(root)]
    if not rows:
        raise Unread(f"{folder}: there are no rows (*.json); give the folder that a sweep wrote its rows to")

    def beside(name, remedy, check, otherwise):
        return _read(root / name, remedy, check) if (root / name).exists() else otherwise

    systems = beside("systems.json", "correct or remove it", systems_of, [])
    families = beside("families.json", "correct or remove it", families_of, [])
    remedy = "correct it or leave it out"
    machine = (_read(machine_file, remedy, machine_of) if machine_file
               else beside("machine.json", remedy, machine_of, None))
    return make_experiment(rows, systems, families, machine)
