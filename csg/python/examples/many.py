"""Ten thousand models by Dask, on all cores of a machine; with a `dask.distributed.Client` on those of a cluster.

A task makes a model of some numbers, evaluates it on one thread, and gives what is wanted of it. Nodes and results can be
pickled, so a task may as well take or give these. Batches spare most of what Dask takes for a task, a millisecond.
"""
import sys
from fractions import Fraction

import dask

import cnrg


def volumes(numbers):
    """Of a block of 10 with a bore, for each side and depth."""
    block = cnrg.box(size=10)
    bores = [cnrg.box([1, 1, 10 - depth], [1 + side, 1 + side, 11]) for side, depth in numbers]
    return [(block - bore).evaluate(threads=1).volume for bore in bores]


if __name__ == "__main__":
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 100
    numbers = [(1 + i % 8, 1 + Fraction(8 * i, count)) for i in range(count)]
    batches = [numbers[i : i + 100] for i in range(0, count, 100)]
    found = dask.compute(*(dask.delayed(volumes)(batch) for batch in batches), scheduler="processes")
    found = [volume for batch in found for volume in batch]
    assert found == [1000 - side**2 * depth for side, depth in numbers]
    print(len(found), "volumes, from", min(found), "to", max(found))

# Output:
# 100 volumes, from 2248/5 to 999
