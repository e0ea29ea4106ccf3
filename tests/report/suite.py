"""The tests of bench/report, for the program test_report: `suite.py --list` prints their names, one per line;
`suite.py NAME...` runs these, `suite.py` all."""
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[1] / "bench" / "report")]


def tests_in(suite):
    for test in suite:
        yield from tests_in(test) if isinstance(test, unittest.TestSuite) else [test]


def main():
    found = {test.id(): test for test in tests_in(unittest.TestLoader().discover(HERE, top_level_dir=HERE))}
    if sys.argv[1:] == ["--list"]:
        broken = [test for test in found.values() if isinstance(test, unittest.loader._FailedTest)]
        for test in broken:
            print(test._exception, file=sys.stderr)
        print("\n".join(found))
        return bool(broken) or not found
    chosen = unittest.TestSuite(found[name] for name in sys.argv[1:] or found)
    return not unittest.TextTestRunner(stream=sys.stdout).run(chosen).wasSuccessful()


if __name__ == "__main__":
    sys.exit(main())
