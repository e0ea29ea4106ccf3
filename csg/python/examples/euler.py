"""Euler operators on a complex that is no manifold: each makes or kills one cell, or an edge with its end.

The formula of Euler and Poincaré holds after each of them (Masuda 1993):

    v - e + (f - r) - (V - Vh + Vc) = C - Ch + Cc

An operator is called by what it makes (m, M) and what it kills (k, K): mfKCh makes a face and kills a hole of the
whole, kfMCh is its inverse. So its name says how the numbers change. What they have become is asked of the library:
it evaluates the union of the cells that are there, from nothing after each operator, and counts each number by itself.
"""
import re
import sys
from collections import Counter

import cnrg

# A cell is called by its corners: a vertex P, an edge PQ, a face of three or four, the cube of all eight.
CORNERS = {"A": [0, 0, 0], "B": [4, 0, 0], "C": [4, 4, 0], "D": [0, 4, 0],  # of the cube, below
           "E": [0, 0, 4], "F": [4, 0, 4], "G": [4, 4, 4], "H": [0, 4, 4],  # and above
           "P": [2, 1, 4], "Q": [2, 1, 6], "S": [6, 1, 6], "T": [2, 3, 1]}  # on it, over it, in it
MAKING = [
    ("mvC", "A"), ("mev", "B AB, C BC, D CD"), ("meCh", "DA"), ("mfKCh", "ABCD"),
    ("mev", "E AE, F BF, G CG, H DH"), ("meCh", "EF, FG, GH, HE"), ("mfKCh", "ABFE, BCGF, CDHG, DAEH"),
    ("mfCc", "EFGH"),                # the last face closes the box
    ("mVKCc", "ABCDEFGH"),           # the box is filled
    ("mvr", "P"),                    # a point on its top is a ring of that face
    ("mev", "Q PQ"),                 # a rod on it
    ("mvC", "S"), ("meKC", "QS"),    # a second piece is joined
    ("meCh", "SF"),                  # and the wire closed to a loop
    ("meKr", "PE"),                  # on the top, from the point to the border
    ("mvVc", "T"),                   # a point inside is a cavity of the volume
    ("meKVc", "CT"),                 # until it hangs on the border
    ("meVh", "AG"),                  # a wire through the cube: around it is a solid ring
    ("mef", "BG"),                   # a diagonal parts a side
    ("mfKVh", "ABG"),                # a face spans the ring
    ("mef", "AH"), ("mfV", "AGH")]   # a second one parts the volume
# Not the way back: cells go in another order, so that many are killed by another operator than they were made by.
KILLING = [
    ("kfV", "ABG"), ("kef", "BG"), ("kfMVh", "AGH"), ("kef", "AH"), ("keVh", "AG"), ("keMVc", "CT"), ("kvVc", "T"),
    ("keMr", "PE"), ("keCh", "QS"), ("keMC", "SF"), ("kvC", "S"), ("kev", "Q PQ"), ("kvr", "P"), ("kVMCc", "ABCDEFGH"),
    ("kfCc", "ABCD"), ("kfMCh", "ABFE, BCGF, CDHG, DAEH, EFGH"), ("keCh", "AB, BC, CD, DA"),
    ("kev", "A AE, B BF, C CG, D DH"), ("keCh", "EF"), ("kev", "F FG, G GH, H HE"), ("kvC", "E")]
TERMS = ["v", "e", "f", "r", "V", "Vh", "Vc", "C", "Ch", "Cc"]


def changes(name):
    """How the numbers change, as the name says."""
    change = Counter()
    for word in re.findall("[VC][hc]|.", name):
        if word in "mMkK":
            by = 1 if word in "mM" else -1
        else:
            change[word] += by
    return change


def node(cell):
    corners = [CORNERS[c] for c in cell]
    if len(cell) == 8:
        return cnrg.box(corners[0], corners[6])
    return {1: cnrg.points, 2: cnrg.polyline}.get(len(cell), cnrg.polygon)(corners)


def counted(cells):
    """The numbers by the library. What is thin comes first and dominates: it stays inside of the cube, too."""
    if not cells:
        return Counter()
    first, *others = (node(cell) for cell in sorted(sorted(cells), key=len))
    model = cnrg.union(first, *others, dominance="left") if others else first
    return Counter(model.evaluate().topology().euler)


print(" " * 6 + "".join(f"{term:>3}" for term in TERMS) + "  formula  cells")
cells, numbers, steps = set(), Counter(), 0
for name, line in MAKING + KILLING:
    for step in line.split(", "):
        cells ^= set(step.split())  # makes those that are not there, kills those that are
        numbers.update(changes(name))
        found, steps = counted(cells), steps + 1
        v, e, f, r, V, Vh, Vc, C, Ch, Cc = (found[term] for term in TERMS)
        left, right = v - e + (f - r) - (V - Vh + Vc), C - Ch + Cc
        if left != right or any(found[term] != numbers[term] for term in {*found, *numbers}):
            sys.exit(f"{name} {step}: not what is counted")
    print(f"{name:<6}" + "".join(f"{found[term]:3}" for term in TERMS) + f"{left:5} = {right:<3} {line}")
names = {name for name, _ in MAKING}
inverses = {name.translate(str.maketrans("mMkK", "kKmM")) for name, _ in KILLING}
print(f"{len(names)} operators, {'each' if names == inverses else 'not each'} with its inverse, in {steps} steps")

# Output:
#         v  e  f  r  V Vh Vc  C Ch Cc  formula  cells
# mvC     1  0  0  0  0  0  0  1  0  0    1 = 1   A
# mev     4  3  0  0  0  0  0  1  0  0    1 = 1   B AB, C BC, D CD
# meCh    4  4  0  0  0  0  0  1  1  0    0 = 0   DA
# mfKCh   4  4  1  0  0  0  0  1  0  0    1 = 1   ABCD
# mev     8  8  1  0  0  0  0  1  0  0    1 = 1   E AE, F BF, G CG, H DH
# meCh    8 12  1  0  0  0  0  1  4  0   -3 = -3  EF, FG, GH, HE
# mfKCh   8 12  5  0  0  0  0  1  0  0    1 = 1   ABFE, BCGF, CDHG, DAEH
# mfCc    8 12  6  0  0  0  0  1  0  1    2 = 2   EFGH
# mVKCc   8 12  6  0  1  0  0  1  0  0    1 = 1   ABCDEFGH
# mvr     9 12  6  1  1  0  0  1  0  0    1 = 1   P
# mev    10 13  6  1  1  0  0  1  0  0    1 = 1   Q PQ
# mvC    11 13  6  1  1  0  0  2  0  0    2 = 2   S
# meKC   11 14  6  1  1  0  0  1  0  0    1 = 1   QS
# meCh   11 15  6  1  1  0  0  1  1  0    0 = 0   SF
# meKr   11 16  6  0  1  0  0  1  1  0    0 = 0   PE
# mvVc   12 16  6  0  1  0  1  1  1  0    0 = 0   T
# meKVc  12 17  6  0  1  0  0  1  1  0    0 = 0   CT
# meVh   12 18  6  0  1  1  0  1  1  0    0 = 0   AG
# mef    12 19  7  0  1  1  0  1  1  0    0 = 0   BG
# mfKVh  12 19  8  0  1  0  0  1  1  0    0 = 0   ABG
# mef    12 20  9  0  1  0  0  1  1  0    0 = 0   AH
# mfV    12 20 10  0  2  0  0  1  1  0    0 = 0   AGH
# kfV    12 20  9  0  1  0  0  1  1  0    0 = 0   ABG
# kef    12 19  8  0  1  0  0  1  1  0    0 = 0   BG
# kfMVh  12 19  7  0  1  1  0  1  1  0    0 = 0   AGH
# kef    12 18  6  0  1  1  0  1  1  0    0 = 0   AH
# keVh   12 17  6  0  1  0  0  1  1  0    0 = 0   AG
# keMVc  12 16  6  0  1  0  1  1  1  0    0 = 0   CT
# kvVc   11 16  6  0  1  0  0  1  1  0    0 = 0   T
# keMr   11 15  6  1  1  0  0  1  1  0    0 = 0   PE
# keCh   11 14  6  1  1  0  0  1  0  0    1 = 1   QS
# keMC   11 13  6  1  1  0  0  2  0  0    2 = 2   SF
# kvC    10 13  6  1  1  0  0  1  0  0    1 = 1   S
# kev     9 12  6  1  1  0  0  1  0  0    1 = 1   Q PQ
# kvr     8 12  6  0  1  0  0  1  0  0    1 = 1   P
# kVMCc   8 12  6  0  0  0  0  1  0  1    2 = 2   ABCDEFGH
# kfCc    8 12  5  0  0  0  0  1  0  0    1 = 1   ABCD
# kfMCh   8 12  0  0  0  0  0  1  5  0   -4 = -4  ABFE, BCGF, CDHG, DAEH, EFGH
# keCh    8  8  0  0  0  0  0  1  1  0    0 = 0   AB, BC, CD, DA
# kev     4  4  0  0  0  0  0  1  1  0    0 = 0   A AE, B BF, C CG, D DH
# keCh    4  3  0  0  0  0  0  1  0  0    1 = 1   EF
# kev     1  0  0  0  0  0  0  1  0  0    1 = 1   F FG, G GH, H HE
# kvC     0  0  0  0  0  0  0  0  0  0    0 = 0   E
# 15 operators, each with its inverse, in 66 steps
