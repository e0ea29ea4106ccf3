"""A copy of the tree that holds all mutants at once; the environment says which of them is awake.

Compiling each mutant by itself would take days. Here a place reads `(cnrg_mutant(17) ? a <= b : a < b)`, so that all
of them are compiled once, and CNRG_MUTANT=17 chooses. The copy differs in three things from the tree: the places, the
two files below, and that the kernel is compiled with -O1, for it is compiled once more and run shortly.
"""
import os
import re
import subprocess
from collections import defaultdict
from pathlib import Path

import mutants_places

HEADER = """#pragma once
// The mutant that is awake, 0 if none; and where it is noted which ones were reached.
extern int cnrg_mutant_awake;
extern unsigned char* cnrg_mutants_reached;
inline bool cnrg_mutant(int number) {
  if (cnrg_mutants_reached) cnrg_mutants_reached[number] = 1;
  return cnrg_mutant_awake == number;
}
"""

SOURCE = """#include "kernel/mutants.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>

int cnrg_mutant_awake = 0;
unsigned char* cnrg_mutants_reached = nullptr;

// Before all constructors of static objects, for they may compute. The notes are shared memory in a file, so that
// they outlive a crash and are those of child processes, too.
__attribute__((constructor(101))) static void choose_mutant() {
  if (const char* number = std::getenv("CNRG_MUTANT")) cnrg_mutant_awake = std::atoi(number);
  const char* file = std::getenv("CNRG_MUTANTS_REACHED");
  if (!file) return;
  const int descriptor = open(file, O_RDWR);
  if (descriptor < 0) return;
  void* memory = mmap(nullptr, SIZE, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
  if (memory != MAP_FAILED) cnrg_mutants_reached = static_cast<unsigned char*>(memory);
  close(descriptor);
}
"""

# A header that many others read would have them all compiled again: more than so many, and its places are left out.
MOST_READERS = 5


class Copy:
    def __init__(self, root, folder, say):
        self.root, self.source, self.say = Path(root), Path(folder) / "source", say
        self.build = self.source / "build/release"

    def write(self, name, content):
        path = self.source / name
        if not path.exists() or path.read_bytes() != content:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)
            mode = self.root / name
            if mode.exists():
                os.chmod(path, mode.stat().st_mode)

    def write_all(self, places, size):
        by_file = defaultdict(list)
        for place in places:
            by_file[place.file].append(place)
        names = subprocess.run(["git", "ls-files", "-z"], cwd=self.root, check=True, capture_output=True, text=True)
        for name in names.stdout.split("\0"):
            path = self.root / name
            if not name or not path.is_file():
                continue
            content = path.read_bytes()
            if name in by_file:
                content = b'#include "kernel/mutants.h"\n' + mutants_places.rewritten(content, by_file[name])
            if name == "kernel/CMakeLists.txt":
                content = b"add_compile_options(-O1)\n" + content
            self.write(name, content)
        self.write("kernel/mutants.h", HEADER.encode())
        self.write("kernel/mutants.cpp", SOURCE.replace("SIZE", str(size)).encode())

    def configure(self):
        subprocess.run(["cmake", "--preset", "release"], cwd=self.source, check=True, stdout=subprocess.DEVNULL)

    def readers(self):
        """How many files outside of our rooms read each of our headers, as the last build knows it."""
        counts, outside = defaultdict(int), False
        deps = subprocess.run(["ninja", "-C", self.build, "-t", "deps"], capture_output=True, text=True)
        for line in deps.stdout.splitlines():
            if not line.startswith(" "):
                outside = not line.startswith(("kernel/", "csg/CMakeFiles/cnrg_csg.dir/operators/"))
            elif outside:
                match = re.search(r"((?:kernel|csg/operators)/[\w/]+\.h)$", line)
                if match:
                    counts[match[1]] += 1
        return counts

    def ninja(self, targets):
        return subprocess.run(["nice", "-n", "5", "ninja", "-j1", "-k0", "-C", str(self.build), *targets],
                              capture_output=True, text=True)

    def compile(self, places, size, targets):
        """Builds; the places that the compiler does not take are left out. The rest is returned."""
        places = list(places)
        while True:
            self.write_all(places, size)
            self.say(f"building {' '.join(targets)} with {len(places)} mutants")
            done = self.ninja(targets)
            if done.returncode == 0:
                return places
            refused = self.refused(done.stdout, places)
            if not refused:
                raise SystemExit("mutants: the copy does not compile:\n" + done.stdout[-6000:])
            for place in places:
                if place.number in refused:
                    self.say(f"  not compilable: {place.file}:{place.line} {place.old} -> {place.new}")
            places = [p for p in places if p.number not in refused]

    def refused(self, output, places):
        """The mutants on the lines that errors name."""
        lines = defaultdict(set)
        pattern = r"((?:kernel|csg/operators)/[\w/]+\.(?:cpp|h)):(\d+):(?:\d+:)?\s+(?:error|\S* ?required from)"
        for name, line in re.findall(pattern, output):
            lines[name].add(int(line))
        length = {p.number: p.last_line - p.line for p in places}
        refused = set()
        for name, wrong in lines.items():
            for i, text in enumerate((self.source / name).read_text().splitlines(), 1):
                for number in map(int, re.findall(r"cnrg_mutant\((\d+)\)", text)):
                    if any(i <= line <= i + 2 * length.get(number, 0) for line in wrong):
                        refused.add(number)
        return refused
