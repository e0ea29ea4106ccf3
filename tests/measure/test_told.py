"""What `cnrg mesh` says of regions that vanished, as bench/conserve reads it, and that a mesh is held to it."""
import unittest
from fractions import Fraction
from types import SimpleNamespace

from meshed import Change, compare_groups

SNAPPED = "m.msh: notice: snapped 8 of 24 vertices, by 1e-17 at most, in 1 round; 18 faces vanished; 2 regions vanished\n"
DUST = "m.msh: warning: the region dust, r2, at (3, 0, 1), is thinner than 2e-17 and has vanished\n"
PIECES = "m.msh: warning: the region rock, hard (2 pieces), r4, at (0, 0, 1), is thinner than 2e-17 and has vanished\n"
JOINED = ("m.yaml: notice: `model`: joined 5 pairs nearer than 0.001, in 2 rounds; nothing moved by more than 0.0003; "
          "4 faces vanished; 2 regions vanished; there were 3 regions and are 2\n")
PINCHED = "m.yaml: warning: `model`: the region rock (a piece), at (0, 1/3, 60), is thinner than 0.001 and has vanished\n"
WHOLE = "m.yaml: warning: `model`: the region dust (all 3 pieces), r1, at (0, 0, 6), is thinner than 0.001 and has vanished\n"


class Told(unittest.TestCase):
    def test_names_are_counted(self):
        snapped = Change.told(SNAPPED + DUST + PIECES)
        self.assertEqual((snapped.kind, snapped.regions, snapped.named), ("snapped", 2, 2))
        self.assertEqual(snapped.vanished, {"dust": (1, 1), "rock, hard": (2, 2)})
        joined = Change.told(JOINED + PINCHED + WHOLE)
        self.assertEqual((joined.kind, joined.regions, joined.named), ("joined", 2, 2))
        self.assertEqual(joined.vanished, {"rock": (0, 1), "dust": (1, 3)})

    def faults(self, said, there):
        """Of a model with the regions dust, of no volume, and rock, in pieces of 1, 1e-30 and 1e-30."""
        volumes = {0: Fraction(1, 10 ** 30), 1: Fraction(1), 2: Fraction(1, 10 ** 30), 3: Fraction(1, 10 ** 30)}
        model = SimpleNamespace(regions=volumes, region_names={0: "dust", 1: "rock", 2: "rock", 3: "rock"}, faces={},
                                volume=sum(volumes.values()), sheets=lambda: ({}, {}), wires=dict, ends=list,
                                corners=list)
        mesh = SimpleNamespace(largest=1.0, volumes=there,
                               volumes_by_group={name: [volume] for name, volume in there.items()}, area_by_group={}, rim_by_group={},
                               segments=[], places=[])
        faults = []
        check = SimpleNamespace(
            equal=lambda what, a, b: a == b or faults.append(what),
            near=lambda what, a, b, room: abs(a - b) <= room + 1e-12 or faults.append(what))
        compare_groups(check, model, mesh, Change.told(said))
        return faults

    def test_a_mesh_lacks_what_is_said_and_nothing_else(self):
        pieces = PIECES.replace("rock, hard", "rock")
        self.assertEqual(self.faults(SNAPPED + DUST + pieces, {"rock": Fraction(1)}), [])
        self.assertIn("regions that vanished and are named", self.faults(SNAPPED + DUST, {"rock": Fraction(1)}))
        self.assertIn("regions rock that vanished", self.faults(SNAPPED + DUST, {"rock": Fraction(1)}))
        self.assertIn("regions dust that vanished", self.faults(
            SNAPPED + DUST + pieces, {"rock": Fraction(1), "dust": Fraction(1, 10 ** 30)}))


if __name__ == "__main__":
    unittest.main()
