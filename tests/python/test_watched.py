"""Long work: other threads run, progress is told, Ctrl-C and exceptions end it."""
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import warnings

import numpy

import cnrg


def rippled(n, m):
    """A torus of 2 n m triangles."""
    u, v = numpy.meshgrid(numpy.arange(n) * (2 * numpy.pi / n), numpy.arange(m) * (2 * numpy.pi / m), indexing="ij")
    r = 3 + numpy.cos(v)
    points = numpy.stack([r * numpy.cos(u), r * numpy.sin(u), numpy.sin(v)], -1).reshape(-1, 3)
    a = numpy.arange(n * m).reshape(n, m)
    b, d = numpy.roll(a, -1, 0), numpy.roll(a, -1, 1)
    c = numpy.roll(b, -1, 1)
    faces = [numpy.stack(t, -1).reshape(-1, 3) for t in ((a, b, c), (a, c, d))]
    return points, numpy.concatenate(faces)


def long_work():
    """Some seconds of it."""
    a = cnrg.mesh(*rippled(600, 400))
    return a | a.rotate([1, 2, 3], 10)


def children():
    """The processes that this one has begun and that are still there."""
    found = set()
    for thread in os.listdir("/proc/self/task"):
        try:
            with open(f"/proc/self/task/{thread}/children") as file:
                found.update(map(int, file.read().split()))
        except FileNotFoundError:  # the thread has ended meanwhile
            pass
    return found


class Watched(unittest.TestCase):
    def test_progress_has_stages_and_ends(self):
        told = []
        a = cnrg.mesh(*rippled(60, 40))
        (a - a.rotate([1, 2, 3], 10)).evaluate(progress=lambda *step: told.append(step))
        for stage, done, total in told:
            self.assertIsInstance(stage, str)
            self.assertTrue(0 <= done <= total or total == 0)

    def test_a_bar_is_shown_on_request(self):
        script = "import cnrg; cnrg.box([0,0,0],[1,1,1]).evaluate(progress=True)"
        done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, env=os.environ)
        self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)
        for bad in 3, "bar":
            with self.assertRaises(TypeError):
                cnrg.box([0, 0, 0], [1, 1, 1]).evaluate(progress=bad)

    def test_an_exception_of_the_progress_ends_the_work(self):
        def fail(stage, done, total):
            raise ZeroDivisionError(stage)

        model = long_work()
        began = time.monotonic()
        with self.assertRaises(ZeroDivisionError):
            model.evaluate(progress=fail)
        waited = time.monotonic() - began
        whole = time.monotonic()
        model.evaluate(rows=False)
        self.assertLess(waited, (time.monotonic() - whole) / 2)

    def test_a_signal_ends_the_work(self):
        model = long_work()
        kept = signal.signal(signal.SIGALRM, signal.default_int_handler)
        self.addCleanup(signal.signal, signal.SIGALRM, kept)
        signal.setitimer(signal.ITIMER_REAL, 0.3)
        began = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            model.evaluate()
        waited = time.monotonic() - began
        whole = time.monotonic()
        self.assertGreater(model.evaluate(rows=False).__class__.__name__, "")
        self.assertLess(waited, (time.monotonic() - whole) / 2 + 0.5)

    def test_a_process_that_is_interrupted_ends(self):
        script = (
            "import sys; sys.path[:0] = %r; import test_watched, signal; signal.setitimer(signal.ITIMER_REAL, 0.5)\n"
            "signal.signal(signal.SIGALRM, signal.default_int_handler)\ntest_watched.long_work().evaluate()" % [sys.path[0]]
        )
        done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=100)
        self.assertIn("KeyboardInterrupt", done.stderr)
        self.assertNotIn("terminate", done.stderr)
        self.assertNotIn("Fatal", done.stderr)

    def interrupted(self, seconds, work):
        """Ctrl-C comes after so many seconds of the work."""
        kept = signal.signal(signal.SIGALRM, signal.default_int_handler)
        self.addCleanup(signal.signal, signal.SIGALRM, kept)
        signal.setitimer(signal.ITIMER_REAL, seconds)
        with self.assertRaises(KeyboardInterrupt):
            work()

    def test_a_signal_ends_a_mesh_and_what_was_there_is_sound(self):
        # Millions of tetrahedra and more: who is not stopped is here for long.
        result = cnrg.box([0, 0, 0], [1, 1, 1]).evaluate()
        before, stages = children(), []
        for endless in (lambda told: result.tetrahedralize(max_volume=4e-7, seconds=None, progress=told),
                        lambda told: result.tetrahedralize(max_volume=4e-7, seconds=0, progress=told),
                        lambda told: result.mesh_surface(size=1e-5, max_points=10**9, seconds=0, progress=told)):
            stages.clear()
            self.interrupted(0.7, lambda: endless(lambda stage, done, total: stages.append(stage)))
            self.assertTrue(stages)
        end = time.monotonic() + 60  # TetGen goes with it
        while children() - before and time.monotonic() < end:
            time.sleep(0.05)
        self.assertEqual(children() - before, set())
        self.assertEqual(result.volume, 1)
        mesh = result.tetrahedralize()
        self.assertEqual(mesh.regions[0].volume, 1)

    def test_an_exception_of_the_progress_ends_tetgen(self):
        def fail(stage, done, total):
            if "TetGen" in stage:
                raise ZeroDivisionError(stage)

        result = cnrg.box([0, 0, 0], [1, 1, 1]).evaluate()
        with self.assertRaises(ZeroDivisionError):
            result.tetrahedralize(max_volume=4e-7, seconds=0, progress=fail)

    def test_no_bound_of_seconds_is_that_of_the_program(self):
        result = cnrg.box([0, 0, 0], [2, 3, 4]).evaluate()
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            made = [result.tetrahedralize(max_volume=0.5, **how)
                    for how in ({}, {"seconds": None}, {"seconds": 0}, {"seconds": 1000})]
        for mesh in made[1:]:
            self.assertTrue(numpy.array_equal(made[0].points, mesh.points))
            self.assertTrue(numpy.array_equal(made[0].tetrahedra.points, mesh.tetrahedra.points))
        for bad in "3", 2.5:
            with self.assertRaises(TypeError):
                result.tetrahedralize(seconds=bad)
        with self.assertRaises(cnrg.InputError):
            result.tetrahedralize(seconds=-1)

    def test_a_file_whose_writing_is_interrupted_is_old_or_whole(self):
        script = (
            "import sys; sys.path[:0] = %r; import cnrg, signal, test_watched\n"
            "result = cnrg.mesh(*test_watched.rippled(150, 100)).evaluate(rows=False)\n"
            "result.write('whole.json')\n"
            "signal.signal(signal.SIGALRM, signal.default_int_handler)\n"
            "try:\n    signal.setitimer(signal.ITIMER_REAL, float(sys.argv[1]))\n    result.write('cut.json')\n"
            "    signal.setitimer(signal.ITIMER_REAL, 0); print('whole')\nexcept KeyboardInterrupt: print('interrupted')\n"
            % [sys.path[0]]
        )
        seen = set()
        for seconds in 0.001, 0.05, 0.2:
            with tempfile.TemporaryDirectory() as folder:
                cut, whole = (os.path.join(folder, name) for name in ("cut.json", "whole.json"))
                with open(cut, "w") as file:
                    file.write("old")
                done = subprocess.run([sys.executable, "-c", script, str(seconds)], capture_output=True, text=True,
                                      cwd=folder)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                seen.add(done.stdout.strip())
                with open(cut) as file, open(whole) as same:
                    content = file.read()
                    self.assertIn(content, ("old", same.read()))
                self.assertTrue(content != "old" or done.stdout.strip() == "interrupted")
                self.assertEqual(sorted(os.listdir(folder)), ["cut.json", "whole.json"])
        self.assertIn("interrupted", seen)

    def test_other_threads_run_meanwhile(self):
        model, ticks, ended = long_work(), [], threading.Event()

        def tick():
            while not ended.wait(0.001):
                ticks.append(time.monotonic())

        thread = threading.Thread(target=tick)
        thread.start()
        model.evaluate(rows=False)
        ended.set()
        thread.join()
        self.assertGreater(len(ticks), 20)

    def test_threads_evaluate_at_once(self):
        volumes = [None] * 8

        def work(i):
            a, b = cnrg.sphere([0, 0, 0], 2), cnrg.box([0, 0, 0], [3, 3, i + 1])
            volumes[i] = cnrg.evaluate(a & b, threads=1 + i % 2).rows[-1].volume

        threads = [threading.Thread(target=work, args=(i,)) for i in range(8)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertTrue(all(volumes))
        self.assertEqual(volumes[2], volumes[7])  # all of it is below 2


if __name__ == "__main__":
    unittest.main()
