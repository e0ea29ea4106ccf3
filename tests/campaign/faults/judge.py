"""What a run with a fault may have done, and what not.

A fault is either survived, then the run is like one without it: status 0, the same files, the same words; or told:
an exit status that is documented, one line with `error:` that says what was lacking, and files that are old or new,
each as a whole. Calls that were interrupted or short have to be survived: the system asks for another try.
"""
import os
import re
import signal
import time
from pathlib import Path

SECONDS = re.compile(rb"[0-9]+\.[0-9]{3}(?= |\b s\b|$)", re.M)
RETRIED = ("EINTR", "short")
#: What a message may name besides files of the command: what was lacking, or what the system says.
LACKING = re.compile(r"memory|thread|process|pipe|standard output|<stdin>|OpenCASCADE|TetGen|HDF5|in/|rows|edge-|filesystem")
#: Libraries in processes of their own, which may take lack of memory for a fault of what they work on, or crash.
FOREIGN = re.compile(r"OpenCASCADE|TetGen")


def same_words(text):
    """Without times, and without the padding that goes with them."""
    return re.sub(rb" +", b" ", SECONDS.sub(b"T", text))


def files_below(folder):
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def running(group):
    """True if a process of the group runs: one that ended and that nobody has waited for yet does not."""
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            state, _, its_group = stat.read_text().rpartition(")")[2].split()[:3]
        except OSError:
            continue  # gone meanwhile
        if int(its_group) == group and state not in "ZX":
            return True
    return False


def still_alive(group):
    """True if a process of the group outlives its leader, by more than a busy machine takes to end it."""
    for _ in range(50):
        if not running(group):
            return False
        time.sleep(0.1)
    os.killpg(group, signal.SIGKILL)
    return True


def fault_of_message(outcome, scenario):
    """What is wrong with what a run says that gave up; nothing if all is well."""
    if not scenario.same and outcome.status == 1 and re.search(rb": OOM|: error ", outcome.out):
        return None  # the row of what was lost tells it
    lines = [line for line in outcome.err.decode(errors="replace").splitlines() if "error:" in line]
    if len(lines) != 1 and (scenario.same or not lines):  # a row that is lost has a line of its own
        return f"{len(lines)} error lines"
    if outcome.status not in scenario.failures and not FOREIGN.search(lines[0]):
        return f"exit status {outcome.status}"
    if "bug of" in outcome.err.decode(errors="replace"):
        return "the fault is called a bug"
    named = [word.split("/")[-1] for word in scenario.command[1:] if "." in word] + scenario.outputs
    if not LACKING.search(lines[0]) and not any(name in lines[0] for name in named):
        return "the message names neither a file nor what was lacking"
    return None


def judge(outcome, undisturbed, scenario, fault, before):
    """What is wrong with the outcome; nothing if all is well. `before`: files that were there."""
    if outcome.alive:
        return "a process stays behind"
    if outcome.status is None:
        return "no end"
    if outcome.status < 0:
        return f"ended by {signal.Signals(-outcome.status).name}"
    if outcome.status not in (0, 2, *scenario.failures):
        return f"exit status {outcome.status}"
    if outcome.status != 0 and fault.answer in RETRIED:
        return f"{fault.answer} is not survived"
    # The message itself may be what could not be written.
    to_terminal = fault.kind == "write" and (outcome.descriptor == 2 or fault.times == 0)
    if outcome.status != 0 and not to_terminal:
        wrong = fault_of_message(outcome, scenario)
        if wrong:
            return wrong
    for name, content in outcome.files.items():
        if name not in undisturbed.files:
            if fault.kind != "remove":
                return "a file stays: " + re.sub("[0-9]+", "N", name)
        elif not scenario.same:
            if name.endswith(".json") and not whole_json(content):
                return "a file is not whole"
        elif content != undisturbed.files[name] and content != before.get(name):
            return "a file is not whole"
    if outcome.status == 0:
        if set(undisturbed.files) - set(outcome.files):
            return "a file is missing, and the status is 0"
        if scenario.same:
            if any(outcome.files[name] != content for name, content in undisturbed.files.items()):
                return "an old file stays, and the status is 0"
            if same_words(outcome.out) != same_words(undisturbed.out):
                return "another output, and the status is 0"
            if not to_terminal and same_words(outcome.err) != same_words(undisturbed.err):
                return "another message, and the status is 0"
    elif scenario.same and not same_words(undisturbed.out).startswith(same_words(outcome.out).rstrip(b"\n ")):
        return "another output"
    if any(name not in outcome.files for name in before):
        return "an old file is gone"
    return None


def whole_json(content):
    import json
    try:
        json.loads(content)
        return True
    except ValueError:
        return False
