"""What `cnrg mesh` says that it did to a model before it had tetrahedra, and whether they are that model's.

Where rounding would break the result it is snapped, and where there are no tetrahedra in doubles it is joined: then
its cells get other numbers, thin ones vanish, and a mesh that is compared cell by cell would fail without a fault. The
names of regions and of the leaves that faces and wires come from do not change. So volumes are compared by region,
areas and lengths by leaf, and points by where they are, to what moving each point by the distance that the program
states can change. What was neither snapped nor joined is compared cell by cell, too.
"""
import math
import re
from bisect import bisect_left, bisect_right
from collections import defaultdict
from dataclasses import dataclass, field
from fractions import Fraction

from exact import size

RELATIVE = 1e-12
LAST_DIGITS = 4 * 2.0 ** -53        # how far points of a mesh may be from where they belong, by the largest coordinate
NUMBER = r"([0-9.]+(?:e[-+]?[0-9]+)?)"


class Unsaid(Exception):
    """The program has told of a change in words that are not understood here."""


@dataclass
class Change:
    """From what the program said on its way to a mesh."""
    kind: str = "as is"             # or "snapped", "joined"
    within: float | None = None     # what is nearer was joined
    moved: float = 0.0              # no point went farther
    faces: bool = False             # some vanished; so may wires and edges
    vanished: dict = field(default_factory=dict)    # by name: how many regions of it, at least and at most
    thin: float = 0.0               # area of leaves that went with regions, once they are compared
    by: str = "TetGen"              # or "exact": constrained tetrahedra
    regions: int = 0                # how many vanished, as counted
    named: int = 0                  # and as named

    @classmethod
    def told(cls, said):
        """said: what stood on standard error."""
        self = cls()
        for line in said.split("\n"):
            if ": notice: " not in line and ": warning: " not in line:
                continue
            text = line.split(": notice: ")[-1]
            if "constrained tetrahedra" in text or "there were no tetrahedra in doubles" in text:
                self.by = "exact"
            joined = re.search(r"joined (?:no|\d+) pairs? nearer than " + NUMBER + ".*?nothing moved by more than "
                               + NUMBER, text)
            snapped = re.search(r"snapped \d+ of \d+ vertices, by " + NUMBER + " at most", text)
            if joined:
                self.kind, self.within = "joined", float(joined[1])
                self.moved += float(joined[2])
            elif snapped:
                self.kind = "joined" if self.kind == "joined" else "snapped"
                self.moved += float(snapped[1])
            elif "joined" in text and "pair" in text or "snapped" in text:
                raise Unsaid(f"a notice is not understood: {text}")
            if joined or snapped:
                self.faces |= bool(re.search(r"\d+ (?:face|wire)s?\b[^;]*vanished", text))
                self.regions += sum(map(int, re.findall(r"(\d+) regions? vanished", text)))
            for region in re.findall(r"the region (.*?), at \(.*?\), is thinner than \S+ and has vanished", text):
                self.lose(region)
        return self

    def lose(self, region):
        """region: `dust, r2`, `rock (a piece)`, `rock (3 pieces), r2`, `dust (all 2 pieces)`. One with a number was
        in the model; pieces without may have been pinched off by joining, and then the model had none of them."""
        self.named += 1
        name, numbered = re.subn(r", r\d+$", "", region)
        found = re.search(r" \((a piece|(?:all )?(\d+) pieces)\)$", name)
        most = int(found[2] or 1) if found else 1
        least = 0 if found and not found[1].startswith("all ") and not numbered else 1
        if self.kind == "snapped":      # then no region has parted before
            least = most
        if found:
            name = name[:found.start()]
        low, high = self.vanished.get(name, (0, 0))
        self.vanished[name] = low + least, high + most

    def title(self):
        return f"joined at {self.within:.2g}" if self.kind == "joined" else self.kind


def grouped(model):
    """Of a result: volumes by the name of their regions, largest first."""
    volumes = defaultdict(list)
    for i, volume in model.regions.items():
        volumes[model.region_names[i]].append(volume)
    return {name: sorted(found, reverse=True) for name, found in volumes.items()}


def is_piece(group, names):
    """A group of some of several regions of a name has a number behind it, or a side of a surface."""
    return group not in names and any(re.fullmatch(re.escape(name) + r" (\d+|front of .*|behind .*)", group)
                                      for name in names)


def compare_groups(check, model, mesh, change):
    """Volumes by region, areas and lengths by leaf, points. Returns the largest relative differences of the three."""
    worst = [0.0, 0.0, 0.0]
    digits = LAST_DIGITS * mesh.largest
    room = change.moved + digits
    every = sum(size(a) for a in model.faces.values())
    exact = grouped(model)
    found = defaultdict(list, {group: volumes for group, volumes in mesh.volumes_by_group.items()
                               if not is_piece(group, exact)})
    check.equal("regions that vanished and are named", change.named, change.regions)
    parted = False
    for name in sorted(set(exact) | set(found) | set(change.vanished)):
        volumes, there = exact.get(name, []), sorted(found[name], reverse=True)
        least, most = change.vanished.get(name, (0, 0))
        missing = len(volumes) - len(there)
        if change.kind != "as is" and missing < 0:      # what met has parted one
            there, volumes, missing, parted = [sum(there)], [sum(volumes)], 0, True
        check.equal(f"regions {name} that vanished", missing, min(max(missing, least), most))
        for a, b in zip(there, volumes):
            check.near(f"volume of a region {name}", a, b, room * every)
            worst[0] = max(worst[0], float(abs(a - b) / b))
        for b in volumes[len(there):]:
            check.near(f"volume of a region {name} that vanished", Fraction(0), b, room * every)
    check.near("volume of all tetrahedra", sum(mesh.volumes.values(), Fraction(0)), model.volume, room * every)
    areas, rims = model.sheets()
    for name, area in areas.items():
        there = mesh.area_by_group.get(f"from {name}", 0.0)
        room_of_area = change.moved * rims[name] + digits * mesh.rim_by_group.get(f"from {name}", 0.0)
        # Both walls of what was thin went with it, or met where it is parted now; how much is told, not judged.
        if (change.regions or parted) and there < area:
            change.thin += area - there
        else:
            check.near(f"area from {name}", there, area, room_of_area)
        worst[1] = max(worst[1], abs(there - area) / area)
    for name, chains in model.wires().items():
        length = sum(math.dist(p, q) for chain in chains for p, q in zip(chain, chain[1:]))
        there, pieces = along(chains, mesh.segments, 2 * room)
        check.near(f"length from {name}", there, length, 2 * room * pieces)
        worst[2] = max(worst[2], abs(there - length) / length)
    points = model.corners() if change.kind == "as is" else model.ends()
    lost = away(points, mesh.places, max(room, digits))
    check.equal("points that are not in the mesh", lost, 0)
    return worst


def away(points, places, room):
    """How many of the points have no place within room."""
    if not points:
        return 0
    width = max(room, 1e-300) * 2
    cells = defaultdict(list)
    for p in places:
        cells[tuple(math.floor(x / width) for x in p)].append(p)
    lost = 0
    for point in points:
        p = tuple(map(float, point))
        at = tuple(math.floor(x / width) for x in p)
        near = (q for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1)
                for q in cells.get((at[0] + i, at[1] + j, at[2] + k), ()))
        lost += not any(math.dist(p, q) <= 2 * room for q in near)
    return lost


def along(chains, segments, room):
    """Length of the segments of a mesh on chains of points, but for room, and how many pieces both have. Groups of a
    mesh name but the first of several wires that lie on each other, so it is looked where they are. A segment may lie
    on several pieces: a vertex between two that go straight on is none of what was joined."""
    ordered = sorted((min(a[0], b[0]), k) for k, (a, b) in enumerate(segments))
    starts = [x for x, _ in ordered]
    widest = max((abs(a[0] - b[0]) for a, b in segments), default=0.0)
    on, pieces = defaultdict(list), 0
    for chain in chains:
        for p, q in zip(chain, chain[1:]):
            pieces += 1
            low, high = min(p[0], q[0]) - room - widest, max(p[0], q[0]) + room
            for _, k in ordered[bisect_left(starts, low):bisect_right(starts, high)]:
                part = common(segments[k], p, q, room)
                if part:
                    on[k].append(part)
    lengths = []
    for k, parts in on.items():
        end = 0.0
        for begin, to in sorted(parts):
            lengths.append(max(0.0, to - max(begin, end)) * math.dist(*segments[k]))
            end = max(end, to)
    return math.fsum(lengths), pieces + sum(map(len, on.values()))


def common(segment, p, q, room):
    """From which to which part of its length a segment lies on another one, but for room; nothing if it does not."""
    a, b = segment
    way = [y - x for x, y in zip(a, b)]
    square = sum(w * w for w in way)
    ends = sorted(sum((x - y) * w for x, y, w in zip(end, a, way)) / square for end in (p, q))
    begin, to = max(ends[0], 0.0), min(ends[1], 1.0)
    far = max(off([x + t * w for x, w in zip(a, way)], p, q) for t in (begin, to)) if begin < to else math.inf
    return (begin, to) if far <= room else None


def off(x, p, q):
    """Distance of a point from a segment."""
    way = [b - a for a, b in zip(p, q)]
    square = sum(w * w for w in way)
    t = sum((a - b) * w for a, b, w in zip(x, p, way)) / square if square else 0.0
    t = min(max(t, 0.0), 1.0)
    return math.dist(x, [a + t * w for a, w in zip(p, way)])


def compare_cells(check, model, mesh):
    """Of what was neither snapped nor joined: cell by cell. Returns the largest relative differences."""
    worst = [0.0, 0.0, 0.0]
    digits = LAST_DIGITS * mesh.largest
    area = sum(size(a) for a in model.faces.values())
    check.equal("regions with tetrahedra", len(mesh.volumes), len(model.regions))
    for entity, (i, volume) in enumerate(model.regions.items()):     # active regions have the numbers of a mesh
        found = mesh.volumes.get(entity, Fraction(0))
        worst[0] = max(worst[0], float(abs(found - volume) / volume))
        check.near(f"volume of region r{i}", found, volume, digits * area)
    for i, parts in model.faces.items():
        exact, found = size(parts), mesh.areas.get(i, 0.0)
        worst[1] = max(worst[1], abs(found - exact) / exact)
        check.near(f"area of face f{i}", found, exact, digits * mesh.perimeters.get(i, 0.0))
    for i, (_, exact) in model.edges.items():
        found = mesh.lengths.get(i, 0.0)
        worst[2] = max(worst[2], abs(found - exact) / exact)
        check.near(f"length of edge e{i}", found, exact, 2 * digits * mesh.pieces.get(i, 0))
    return worst
