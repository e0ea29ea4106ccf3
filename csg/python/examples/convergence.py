"""A convergence study: the volume that two crossing pipes share, by facets and by curved tetrahedra.

Curved shapes are computed with as facets, exactly, so every difference to the true volume, 16/3 r^3, is that of the
facets: four times smaller for twice as many. With `curved=True` the elements of the mesh bend after the true surfaces,
which a result knows, and the volume is right to some digits with few of them. No number here depends on luck: the
same script prints the same digits on every machine.
"""
from fractions import Fraction

import cnrg

exact = Fraction(16, 3)


def common(segments):
    """What both pipes of radius 1 hold."""
    along_x = cnrg.cylinder([-2, 0, 0], [2, 0, 0], 1, segments=segments)
    along_y = cnrg.cylinder([0, -2, 0], [0, 2, 0], 1, segments=segments)
    return (along_x & along_y).evaluate()


print("segments  faces       volume      error  ratio")
before = None
for segments in (8, 16, 32, 64, 128):
    result = common(segments)
    error = exact - result.volume
    ratio = f"{float(before / error):.3f}" if before else "-"
    print(f"{segments:8}  {len(result.faces):5}  {float(result.volume):.9f}  {float(error):.2e}  {ratio:>5}")
    before = error

ball = cnrg.sphere([0, 0, 0], 1, segments=16).evaluate()
true = 4.18879020478639
for curved in (False, True):
    mesh = ball.tetrahedralize(quality=1.4, curved=curved)
    error = abs(float(sum(part.volume for part in mesh.regions)) / true - 1)
    print("a ball of 16 segments by", "curved" if curved else "flat", f"tetrahedra: wrong by {error:.0e}")

# Output:
# segments  faces       volume      error  ratio
#        8      4  4.552284750  7.81e-01      -
#       16      4  5.130345420  2.03e-01  3.848
#       32      4  5.282094081  5.12e-02  3.962
#       64      4  5.320492604  1.28e-02  3.990
#      128      4  5.330121217  3.21e-03  3.998
# a ball of 16 segments by flat tetrahedra: wrong by 6e-02
# a ball of 16 segments by curved tetrahedra: wrong by 2e-05
