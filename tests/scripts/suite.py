"""The tests of a room that are written in Python, for its program.

    suite.py FOLDER --list    prints the names of the tests in test_*.py, one per line
    suite.py FOLDER NAME...   runs these, or all without a name; prints for each a line `passed NAME` or `failed NAME`
                              and then, indented, why; `skipped NAME` and `not run: ` why
"""
import sys
import textwrap
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
HERE = Path(sys.argv[1]).resolve()
sys.path.insert(0, str(HERE))


def tests_in(suite):
    for test in suite:
        yield from tests_in(test) if isinstance(test, unittest.TestSuite) else [test]


class Result(unittest.TestResult):
    def startTest(self, test):
        super().startTest(test)
        self.before = len(self.failures) + len(self.errors)

    def stopTest(self, test):
        said = [text for _, text in (self.failures + self.errors)]
        passed = len(said) == self.before
        skipped = [why for _, why in self.skipped]
        print("failed" if not passed else "skipped" if skipped else "passed", test.id(), flush=True)
        if passed and skipped:
            print("  not run: " + "; ".join(skipped), flush=True)
        self.skipped = []
        if not passed:
            print(textwrap.indent("\n".join(said), "  "), flush=True)
            self.failures, self.errors, self.any_failed = [], [], True
        super().stopTest(test)


def main():
    found = {test.id(): test for test in tests_in(unittest.TestLoader().discover(HERE, top_level_dir=HERE))}
    if sys.argv[2:] == ["--list"]:
        print("\n".join(found))
        return not found
    result = Result()
    result.any_failed = False
    unittest.TestSuite(found[name] for name in sys.argv[2:] or found).run(result)
    return result.any_failed


if __name__ == "__main__":
    sys.exit(main())
