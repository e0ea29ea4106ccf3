"""Reads files (or batches of them) below some folders by the compiler of a build, warnings as errors, without code made.

    syntax.py COMPILE_COMMANDS JOBS FOLDER...

Prints what the compiler says of files that fail, and last `N passed, N failed`.
"""
import json
import shlex
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path


def read_by_compiler(entry):
    """The compiler's words on a file, and whether it takes it."""
    command = shlex.split(entry["command"])
    command[command.index("-o"):command.index("-o") + 2] = ["-fsyntax-only", "-Werror"]
    done = subprocess.run(command, cwd=entry["directory"], capture_output=True, text=True)
    return done.stderr, done.returncode == 0


def main():
    commands, jobs, *folders = sys.argv[1:]
    roots = [Path(folder).resolve() for folder in folders]
    entries = [entry for entry in json.loads(Path(commands).read_text())
               if any(root in Path(entry["file"]).parents for root in roots)]
    failed = 0
    with ThreadPoolExecutor(int(jobs)) as pool:
        for entry, (words, good) in zip(entries, pool.map(read_by_compiler, entries)):
            if not good:
                failed += 1
                print(f"{entry['file']}:\n{words}", flush=True)
    print(f"{len(entries) - failed} passed, {failed} failed")
    return 0 if entries and not failed else 1


if __name__ == "__main__":
    sys.exit(main())
