"""Writes the types of the extension for checkers: python3 stub.py FOLDER_OF_THE_EXTENSION FILE.pyi

pybind11 says them in the first line of each docstring. A stub that is written by hand would say what the extension was
once; this one is made with it.
"""

import ast
import re
import sys
from pathlib import Path

HEAD = '''"""Types of the extension, made of its docstrings by csg/python/stub.py."""

from typing import Any, Callable, Iterable, Iterator, Optional, Sequence, Set, Union

import numpy
import numpy.typing
'''
WORDS = {"List": "list", "Dict": "dict", "Tuple": "tuple", "object": "Any", "handle": "Any", "array": "numpy.ndarray[Any, Any]",
         "iterable": "Iterable[Any]", "iterator": "Iterator[Any]", "function": "Callable[..., Any]",
         "sequence": "Sequence[Any]", "buffer": "Any", "capsule": "Any", "Fraction": "Any"}


def python_type(text):
    """A type as pybind11 writes it, as checkers read it."""
    text = re.sub(r"numpy\.ndarray\[(numpy\.\w+)[^\]]*\]", r"numpy.typing.NDArray[\1]", text.replace("cnrg._cnrg.", ""))
    text = re.sub(r"\b_cnrg\.", "", text)
    text = re.sub(r"\bcnrg::[\w:]+", "Any", text)  # a class that was not yet known when the function was bound
    text = re.sub(r"(?<![\w.])(%s)\b" % "|".join(WORDS), lambda m: WORDS[m[1]], text)
    for plain in ("list", "dict", "tuple"):
        text = re.sub(rf"(?<![\w.]){plain}(?!\w|\[)", {"list": "list[Any]", "dict": "dict[Any, Any]",
                                                      "tuple": "tuple[Any, ...]"}[plain], text)
    return text


def definition(name, doc, in_class, static=False):
    """`def name(...) -> type: ...`; of a docstring without a signature that is of use, one that takes anything."""
    line = (doc or "").strip().split("\n")[0]
    match = re.match(r"\w*(\(.*\) -> .*)$", line)
    if match:
        signature = re.sub(r" = <[^>]*>", " = ...", python_type(match[1]))
        signature = re.sub(r"\(self: [\w.]+", "(self", signature, count=1)
        if in_class and not static:
            signature = re.sub(r"^\(arg0: [\w.]+", "(self", signature)
        text = f"def {name}{signature}: ..."
        try:
            ast.parse(text)
            return text
        except SyntaxError:
            pass
    return f"def {name}({'self, ' if in_class and not static else ''}*arguments: Any, **named: Any) -> Any: ..."


def class_text(cls):
    lines = []
    for name, member in sorted(vars(cls).items()):
        if isinstance(member, property):
            text = definition(name, member.fget.__doc__, True)
            lines += ["@property", text]
            if member.fset is not None:
                lines += [f"@{name}.setter", f"def {name}(self, value: Any) -> None: ..."]
        elif isinstance(member, staticmethod):
            lines += ["@staticmethod", definition(name, member.__func__.__doc__, True, static=True)]
        elif name == "__init__" and " -> " not in (member.__doc__ or ""):
            continue  # nobody makes one
        elif callable(member) and (not name.startswith("_") or name in ("__init__", "__len__", "__getitem__", "__iter__")):
            lines.append(definition(name, member.__doc__, True))
    return [f"class {cls.__name__}:"] + [f"    {line}" for line in lines or ["..."]]


def stub_of(module):
    members = {name: value for name, value in vars(module).items() if not name.startswith("__") or name == "__version__"}
    classes = sorted((n, v) for n, v in members.items() if isinstance(v, type))
    others = sorted((n, v) for n, v in members.items() if not isinstance(v, type))
    lines = [HEAD]
    for _, cls in classes:
        lines += ["", *class_text(cls), ""]
    for name, value in others:
        lines.append(definition(name, value.__doc__, False) if callable(value) else f"{name}: {type(value).__name__}")
    return "\n".join(lines) + "\n"


def main():
    folder, target = sys.argv[1:]
    sys.dont_write_bytecode = True
    sys.path.insert(0, folder)
    import _cnrg

    Path(target).write_text(stub_of(_cnrg), encoding="utf-8")


if __name__ == "__main__":
    main()
