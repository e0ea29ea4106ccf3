"""Test programs run case by case: which mutants a case reaches, and which mutants a set of cases catches."""
import os
import re
import resource
import signal
import subprocess
import tempfile
import time
from dataclasses import dataclass, field

MEMORY = 4 << 30
# Rooms that look at pages, scripts and the installed library, or at what other systems answer.
LEFT_OUT = {"install", "pages", "report", "same", "conserve", "sweep", "peers", "cad_absent"}
FEW_SEEDS = "2"


@dataclass(frozen=True)
class Stage:
    """Cases by processor seconds: more than `over`, at most `upto`; random ones with few seeds or with all."""
    says: str
    over: float
    upto: float
    few: bool = False


# What is over soon is tried first, with all mutants, before the rest with what is left. A random case that fails with
# few seeds fails with all, for the few are the first of them.
STAGES = (
    Stage("cases up to 0.1 s", -1, 0.1),
    Stage("random cases above 0.1 s, their first two seeds", 0.1, float("inf"), True),
    Stage("cases up to 1 s", 0.1, 1),
    Stage("cases up to 6 s", 1, 6),
    Stage("all cases", 6, float("inf")),
)


@dataclass
class Case:
    room: str
    name: str
    seconds: float = 0
    few: float = 0  # seconds with few seeds; 0 if that is no saving, or not enough for the case to pass
    passed: bool = True
    reached: list = field(default_factory=list)
    number: int = 0


@dataclass
class Outcome:
    status: int
    how: str          # "", failed, crashed, hung, out of memory
    output: str
    seconds: float


class Programs:
    def __init__(self, copy, folder):
        self.copy, self.folder = copy, folder
        self.notes = folder / "reached"

    def rooms(self):
        targets = subprocess.run(["ninja", "-C", self.copy.build, "-t", "targets", "all"], capture_output=True,
                                 text=True, check=True).stdout
        return sorted(set(re.findall(r"^test_([a-z_]+): phony$", targets, re.M)) - LEFT_OUT)

    def run(self, room, arguments, environment, cpu, wall):
        program = self.copy.build / f"tests/test_{room}"

        def limit():
            os.setsid()
            os.setpriority(os.PRIO_PROCESS, 0, 10)
            resource.setrlimit(resource.RLIMIT_CPU, (int(cpu) + 1, int(cpu) + 3))
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

        begin = resource.getrusage(resource.RUSAGE_CHILDREN)
        with tempfile.TemporaryFile(mode="w+", errors="replace") as output:
            process = subprocess.Popen([program, *arguments], cwd=self.copy.source, stdout=output,
                                       stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, preexec_fn=limit,
                                       env={**os.environ, **environment})
            hung = False
            try:
                process.wait(timeout=wall)
            except subprocess.TimeoutExpired:
                hung = True
            try:
                os.killpg(process.pid, signal.SIGKILL)  # what it may have left behind
            except ProcessLookupError:
                pass
            process.wait()
            output.seek(0)
            text = output.read(1 << 20)
        end = resource.getrusage(resource.RUSAGE_CHILDREN)
        seconds = end.ru_utime + end.ru_stime - begin.ru_utime - begin.ru_stime
        status, how = process.returncode, ""
        if hung or status in (-signal.SIGXCPU, -signal.SIGKILL):
            how = "hung"
        elif "bad_alloc" in text and status:
            how = "out of memory"
        elif status < 0 or "fatal error condition" in text:
            how = "crashed"
        elif status:
            how = "failed"
        return Outcome(status, how, text, seconds)

    def cases(self, room):
        """The names that the program runs when nothing is asked for: all but hidden ones."""
        program = self.copy.build / f"tests/test_{room}"
        listed = subprocess.run([program, "--list-test-names-only", "~[.]"], cwd=self.copy.source,
                                capture_output=True, text=True)
        return [line for line in listed.stdout.splitlines() if line.strip()]

    def list_file(self, names):
        path = self.folder / "cases.txt"
        # A comma would begin another name.
        path.write_text("".join(name.replace(",", "\\,") + "\n" for name in names))
        return str(path)

    def record(self, room, name, size):
        """A case without a mutant: what it costs and reaches."""
        self.notes.write_bytes(bytes(size))
        out = self.run(room, ["-f", self.list_file([name])], {"CNRG_MUTANTS_REACHED": str(self.notes)}, 900, 3600)
        passed = out.status == 0 and " in 1 test case)" in out.output
        reached = [i for i, x in enumerate(self.notes.read_bytes()) if x]
        few = 0
        if passed and out.seconds > STAGES[0].upto:
            less = self.run(room, ["-f", self.list_file([name])], {"CNRG_SEEDS": FEW_SEEDS}, 900, 3600)
            few = less.seconds if less.status == 0 and less.seconds < out.seconds / 2 else 0
        return Case(room, name, round(out.seconds, 3), round(few, 3), passed, reached)

    def attack(self, number, room, cases, stage):
        """These cases with a mutant, up to the first that fails."""
        cost = sum(c.few if stage.few else c.seconds for c in cases)
        environment = {"CNRG_MUTANT": str(number), **({"CNRG_SEEDS": FEW_SEEDS} if stage.few else {})}
        out = self.run(room, ["-a", "-f", self.list_file([c.name for c in cases])], environment,
                       4 * cost + 4, 16 * cost + 90)
        if not out.how and "No tests ran" in out.output:
            raise SystemExit(f"mutants: test_{room} does not know its own cases {[c.name for c in cases]}")
        failed = re.search(r"^-{70,}\n(.+)\n", out.output, re.M)
        return out, failed[1].strip() if failed else ""


def own_room(file):
    room = "operators" if file.startswith("csg/") else file.split("/")[1]
    return "refine" if room == "base" else room


def batches(place, cases, stage):
    """The cases of a stage that reach the place, by program: its own room's first, then the cheaper first."""
    by_room = {}
    for case in cases:
        if case.passed and stage.over < case.seconds <= stage.upto and (case.few or not stage.few) and (
                place.number in case.reached):
            by_room.setdefault(case.room, []).append(case)
    order = sorted(by_room.items(), key=lambda x: (x[0] != own_room(place.file), sum(c.seconds for c in x[1])))
    return [(room, sorted(group, key=lambda c: c.seconds)) for room, group in order]
