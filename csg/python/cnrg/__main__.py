"""`python -m cnrg`: the program `cnrg`, with the same arguments."""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path


def program() -> str | None:
    """The program of this build or installation, else that on PATH."""
    package = Path(__file__).parent
    return shutil.which("cnrg", path=f"{package}{os.pathsep}{package.parents[1]}") or shutil.which("cnrg")


def main() -> None:
    found = program()
    if found is None:
        sys.exit("python -m cnrg: error: the program cnrg is not on PATH; install it, or build the target cnrg")
    os.execv(found, [found, *sys.argv[1:]])


if __name__ == "__main__":
    main()
