"""The value of one node: its cells as arrays, exact numbers, questions to it, files, pictures, other packages' meshes."""

from __future__ import annotations

import contextlib
import html
import operator
import os
import tempfile
import warnings
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any, Callable, Iterable, NamedTuple, Sequence, TypeVar

import numpy as np
from numpy.typing import NDArray

from . import _cnrg, stories
from .cells import Cells, Component, Edges, ExactPoints, Faces, Regions, Said, SaidTable, Vertices
from .errors import FileError, InputError, Notice
from .exported import Exported
from .habits import missing
from .operands import Operand, StoredResult
from .pictures import View, options_of, replace_file
from .place import site_of_caller
from .progress import Progress, Shown, threads_of
from .sizes import Sizes
from .stories import Comparison, Explanation, Selectable, Topology
from .surface import SurfaceMesh
from .tetrahedra import Tetrahedra

if TYPE_CHECKING:
    from .nodes import Node, Number, Point

T = TypeVar("T")
C = TypeVar("C", bound=Cells)

_EXACT_DOUBLES = 2**53
_LETTERS = "vefr"
_MOST_DRAWN = 20_000  # faces, in a notebook without being asked: some seconds


def axes_of(letters: str) -> str:
    """Of `periodic`: "xz" or "x,z"."""
    if not isinstance(letters, str) or not set(letters) <= set("xyz,"):
        raise InputError(f"periodic: some of the letters x, y, z are wanted, not {letters!r}")
    return letters


class Places(NamedTuple):
    """Where points lie, n of them."""

    dimension: NDArray[np.int8]
    """(n,) int8: of the cell that holds the point, 0 to 3"""
    cell: NDArray[np.int32]
    """(n,) int32: its number among the cells of that dimension; -1: a region outside that touches nothing of the
    result and is not listed"""
    component: NDArray[np.int32]
    """(n,) int32: from 1; 0: the point is not in the result"""

    @property
    def names(self) -> list[str]:
        """As `cnrg locate` and `explain` call the cells: "f12"; "-" for what is not listed."""
        return ["-" if c < 0 else f"{_LETTERS[d]}{c}" for d, c in zip(self.dimension, self.cell)]


class Result(Operand, Sizes, Exported):
    """An exact result of n points and the cells on them. It never changes and needs neither the tree nor the
    evaluation any more.

    Arrays are read-only, show memory of the library without a copy, and keep it alive by themselves. Everything is
    made when it is first asked for.
    """

    _result: Any
    _evaluation: Any
    _made: dict[str, Any]

    def __init__(self) -> None:
        raise TypeError("a Result comes from node.evaluate()")

    @classmethod
    def _of(cls, result: Any, evaluation: Any) -> Result:
        self = object.__new__(cls)
        self._result = result
        self._evaluation = evaluation
        self._made = {}
        return self

    def _once(self, what: str, make: Callable[[], T]) -> T:
        if what not in self._made:
            self._made[what] = make()
        made: T = self._made[what]
        return made

    def _placed(self) -> Any:
        """Errors from within come out with places in the script."""
        return self._evaluation.tree.placed() if self._evaluation is not None else contextlib.nullcontext()

    @property
    def name(self) -> str:
        """Of the node."""
        return self._result.name

    # --- cells

    @property
    def _arrays(self) -> Any:
        return self._once("arrays", lambda: _cnrg.result_arrays(self._result))

    @property
    def _data(self) -> dict[str, Any]:
        return self._once("data", self._make_data)

    def _make_data(self) -> dict[str, Any]:
        """The arrays, with -1 for the outside."""
        data: dict[str, Any] = self._arrays.data()
        outside = np.append((data["regions"]["component"] == 0) & ~data["regions"]["bounded"], True)  # the last for -1
        for kind, key in (("vertices", "region"), ("edges", "region"), ("faces", "regions")):
            numbers = data[kind][key]
            data[kind][key] = np.where(outside[numbers], np.int32(-1), numbers)
            data[kind][key].flags.writeable = False
        return data

    def _cells(self, kind: str, made: Callable[[Any, Any, tuple[str, ...]], C]) -> C:
        return self._once(kind, lambda: made(self._data[kind], self._arrays, self.leaves))

    @property
    def points(self) -> NDArray[np.float64]:
        """(n, 3) float64: the nearest doubles, ascending by exact coordinates. InputError beyond 1.8e308."""
        return self._data["points"]

    @property
    def exact_points(self) -> Sequence[tuple[Fraction, Fraction, Fraction]]:
        """n exact points, each made when it is asked for."""
        return ExactPoints(self._arrays, len(self.points))

    @property
    def frame_points(self) -> NDArray[np.int32]:
        """The points that stand for infinity: ends of what a plane or half-space leaves without bounds."""
        return self._data["frame_points"]

    @property
    def point_vertices(self) -> NDArray[np.int32]:
        """(n,) int32: the vertex at each point, or -1."""
        return self._data["point_vertices"]

    @property
    def vertices(self) -> Vertices:
        """Vertices, as arrays."""
        return self._cells("vertices", Vertices)

    @property
    def edges(self) -> Edges:
        """Edges, as arrays, with the faces around each in radial order."""
        return self._cells("edges", Edges)

    @property
    def faces(self) -> Faces:
        """Faces, as arrays, with loops and triangles."""
        return self._cells("faces", Faces)

    @property
    def regions(self) -> Regions:
        """Regions, as arrays, with shells and volumes."""
        return self._cells("regions", lambda data, arrays, leaves: Regions(data, arrays, leaves, self._data["components"]))

    @property
    def components(self) -> list[Component]:
        """Component i is at [i - 1]: the regions of a group, then its entities if it has any; or the components."""
        return list(self._once("components", self._make_components))

    def _make_components(self) -> list[Component]:
        leaves = self.leaves
        return [
            Component(i, name, material, tuple(leaves[k] for k in of), self._result.volume_of(i), attributes)
            for i, (name, material, of, attributes) in enumerate(self._data["components"], 1)
        ]

    @property
    def is_group(self) -> bool:
        """A group of regions, walls, sheets, wires and points; otherwise components of CNRG."""
        return self._data["group"]

    @property
    def leaves(self) -> tuple[str, ...]:
        """Names of the leaves that the result came from."""
        return tuple(self._data["leaves"])

    @property
    def materials(self) -> list[tuple[str, str]]:
        """Name and color ("#rrggbb", or "") of each; those of the tree come first."""
        return list(self._data["materials"])

    @property
    def said(self) -> SaidTable:
        """What is said of cells: name, material, attributes, each different thing once. `said` of vertices, edges,
        faces and regions has places in it: result.said[result.faces.said[5]], if that is not -1."""
        return self._once("said", lambda: SaidTable(self._data["said"]))

    def said_of(self, places: Places) -> list[Said | None]:
        """Of each of n places that `locate` found: what is said of its cell, as `cnrg locate` prints it; None:
        nothing."""
        kinds = [cells for _, cells in self._counted()]
        said = [-1 if cell < 0 else int(kinds[d].said[cell]) for d, cell in zip(places.dimension, places.cell)]
        return [None if place < 0 else self.said[place] for place in said]

    @property
    def groups(self) -> list[dict[str, NDArray[np.int32]]]:
        """By dimension: names as those of a .msh ("rock", "boundary of rock", "wall rock | ore"), each with the numbers
        of its cells."""
        return self._once("groups", lambda: _cnrg.cell_groups(self._result))

    @property
    def volume(self) -> Fraction | None:
        """Exact, of all of it, in cubic units; None: unbounded."""
        volumes = [self.volume_of(i) for i in range(1, self._result.component_count + 1)]
        known = [v for v in volumes if v is not None]
        return sum(known, Fraction(0)) if len(known) == len(volumes) else None

    @property
    def volume_bound(self) -> float | None:
        """How far `volume`, and that of each component, may be from that between the true surfaces; 0: there are no
        curved ones; None: it is unknown, as of CAD models and of results that were snapped or joined."""
        return self._once("volume bound", lambda: self._result.volume_bound)

    @property
    def node(self) -> Node:
        """The result as a leaf of other expressions: without a file, and without evaluating again what made it. It means
        the same as its .json. InputError for what has no bounds."""
        return self._once("node", self._make_node)

    def _make_node(self) -> Node:
        from .nodes import Node

        stored = StoredResult(self._result, self.name, self.materials, [c.name for c in self.components])
        return Node("cnrg", (), stored)

    if not TYPE_CHECKING:

        def __getattr__(self, name):
            from .nodes import Node

            raise missing("a result", name, Result, Node, "it is of a node, result.node.")

    def __len__(self) -> int:
        raise TypeError("a result is no list; len(result.points), len(result.faces.active) and the like count cells")

    def __bool__(self) -> bool:
        return True

    def __copy__(self) -> Result:
        return self

    def __deepcopy__(self, memo: Any) -> Result:
        return self

    def __reduce__(self) -> Any:
        """Exactly, as its .json: without its tree and the leaves that cells came from. InputError for what has no bounds;
        that has nodes that can be pickled."""
        return _again, (self._result.json(), self.name, self.materials)

    def volume_of(self, component: int) -> Fraction | None:
        """Exact, of one component (from 1), in cubic units; None: unbounded. IndexError for none."""
        component = operator.index(component)
        if not 1 <= component <= self._result.component_count:
            raise IndexError(f"components are numbered from 1 to {self._result.component_count}, and this is none of them")
        return self._once(f"volume {component}", lambda: self._result.volume_of(component))

    def __repr__(self) -> str:
        counts = (f"{len(c.active)} {kind}" for kind, c in self._counted())
        return f"<cnrg.Result {self.name!r}: {', '.join(counts)}>"

    def _counted(self) -> list[tuple[str, Cells]]:
        return [("vertices", self.vertices), ("edges", self.edges), ("faces", self.faces), ("regions", self.regions)]

    # --- questions

    def locate(self, points: Any, *, progress: Progress = None) -> Places:
        """The cell that holds each point, exactly, found on all cores.

        points: an array (n, 3) of floats (exactly these doubles) or integers, or a sequence of n exact points, each
        three numbers (int, float, str such as "1/3", Fraction, Decimal). One point is as a list of one.

        Points may lie anywhere: where planes and half-spaces were cut at a frame and a point is beyond it, the tree is
        evaluated once more. InputError for what is not finite and beyond 2**1000.
        """
        places = self._once("places", lambda: _cnrg.places(self._result))
        doubles, exact = _given_points(points)
        with Shown(progress) as shown, self._placed():
            if doubles is not None:
                return Places(*places.locate(doubles, shown))
            return Places(*places.locate_exact(exact, shown))

    def contains(self, points: Any, *, progress: Progress = None) -> NDArray[np.bool_]:
        """(n,) bool: of each point whether it is part of the result, exactly; points as of `locate`."""
        return self.locate(points, progress=progress).component != 0

    def explain(self, what: str | Point, *, threads: int = 0, progress: Progress = None) -> Explanation:
        """Why a cell ("f12") is there, or what became of the cell of the refinement that holds a point, at every node
        of the tree: which row of the tables kept or removed it, and on which facts.

        The values of all nodes are computed for this, once, and kept with the result. InputError for a name that is
        none and for a result without a tree.
        """
        with Shown(progress) as shown, self._placed():
            if isinstance(what, str):
                text, facts = _cnrg.explain_cell(self._result, self._all(threads_of(threads), shown), what)
            else:
                if _cnrg.has_frame(self._result):  # it may lie beyond: the frame has to hold it
                    everything = _cnrg.evaluate_all(self._result, what, threads_of(threads), shown)
                else:
                    everything = self._all(threads_of(threads), shown)
                text, facts = _cnrg.explain_point(self._result, everything, what)
        return stories.explanation(text, facts, self._evaluation.tree.line_of)

    def _all(self, threads: int, shown: Any) -> Any:
        return self._once("all", lambda: _cnrg.evaluate_all(self._result, None, threads, shown))

    def topology(self) -> Topology:
        """Euler-Poincaré term by term, Betti numbers, where it is a manifold and why not, shells, what touches what."""
        return self._once("topology", lambda: stories.topology(*_cnrg.topology(self._result)))

    def selectables(self) -> list[Selectable]:
        """What `Node.select` can pick of it: dimensions, regions, names, materials, attributes, leaves, pairs of
        regions, with numbers of cells."""
        return [Selectable(*one) for one in _cnrg.selectables(self._result)]

    def compare(self, other: Result, *, ignore: str | Iterable[str] = (), threads: int = 0,
                progress: Progress = None) -> Comparison:
        """Do two results mean the same: the same points, components, materials, names and cells? Both are refined
        together, exactly; numbers of cells and names of nodes do not matter.

        ignore: some of "components" (all but the point sets), "materials", "names", "attributes", "features".
        """
        if not isinstance(other, Result):
            raise TypeError(f"compare: a Result is wanted, not {type(other).__name__}")
        ignored = [ignore] if isinstance(ignore, str) else list(ignore)
        with tempfile.TemporaryDirectory() as folder, Shown(progress) as shown, self._placed():
            a, b = (one._as_side(os.path.join(folder, f"{i}.json")) for i, one in enumerate((self, other)))
            same, text, facts = _cnrg.compare(a, b, ignored, threads_of(threads), shown)
        return stories.comparison(text, facts)

    def _as_side(self, path: str) -> Any:
        """What can be compared: the result with its tree, or a file that holds it exactly."""
        if self._result.has_tree:
            return self._result
        self._result.write(path, False, True, False)
        return path

    # --- other results

    def snap(self, *, progress: Progress = None) -> Result:
        """The result on doubles: every vertex is three floats, and nothing crosses. The same where rounding alone is
        right. A warning (cnrg.Notice) names each region that is thinner than what vertices move, and vanishes. InputError
        for a face or line without bounds, and for what does not come to rest."""
        with Shown(progress) as shown, self._placed():
            snapped, rounds, _, _, notices = self._result.snap(shown)
        for notice in notices:
            warnings.warn_explicit(notice, Notice, *site_of_caller())
        return self if rounds == 0 else Result._of(snapped, self._evaluation)

    def join(self, within: Number, *, progress: Progress = None) -> Result:
        """The result with all that does not touch and is nearer than `within` (units) brought together: corners,
        edges and faces. The same where nothing is as near. A warning (cnrg.Notice) names each region that is thinner
        and vanishes, and says what is still near. InputError for a distance that is not positive or not smaller than
        the result, and for a face or line without bounds."""
        with Shown(progress) as shown, self._placed():
            joined, rounds, _, _, notices = self._result.join(within, shown)
        for notice in notices:
            warnings.warn_explicit(notice, Notice, *site_of_caller())
        return self if rounds == 0 else Result._of(joined, self._evaluation)

    def tetrahedralize(self, *, max_volume: Number = 0, quality: Number = 0, keep_boundary: bool = False,
                       seconds: int | None = None, curved: bool = False, order: int = 1,
                       size: Number = 0, growth: Number = 0.3,
                       surface_first: bool = False, periodic: str = "", progress: Progress = None) -> Tetrahedra:
        """Fills the regions with tetrahedra that conform to every wall, sheet, wire and point, proven exactly.

        max_volume: no tetrahedron is larger (cubic units), 0: no bound. quality: the largest ratio of circumradius to
        shortest edge, 1.1 to 100, 0: no bound. keep_boundary: no new points on faces and edges. seconds: for
        all of the meshing, by the clock, 0: no bound; a mesh that is there then is kept as it is, and a warning
        (cnrg.Notice) says so. None: steps are counted, and the mesh is the same on every machine. curved: elements of
        second order on the true surfaces. order: of the elements, 1, or 2 with a node in the middle of each straight
        edge; curved ones are of order 2.
        size: how long edges are to be where neither a node's `size` nor short edges and small facets of the model ask
        for shorter ones (units of the model), 0: no bound. growth: how much longer they may be per unit of distance
        from there, 0.05 to 2. surface_first: faces are meshed as by `mesh_surface` before, and these triangles are the
        boundary; neither with keep_boundary nor with curved. periodic: axes, as "xy", along which opposite sides get the
        same triangles; as surface_first.

        InputError for a result that is not closed and bounded, has no region, or is broken by rounding (`snap()`
        helps), where no mesh is proven, and where seconds are over before there is one. Where TetGen makes none, a warning (cnrg.Notice) says so: they are
        constrained tetrahedra then, improved, and bounds are kept where that can be.
        """
        max_volume, quality, size, growth = (
            float(_cnrg.fraction(number)) for number in (max_volume, quality, size, growth))
        seconds = None if seconds is None else operator.index(seconds)
        order = operator.index(order)
        if max_volume < 0:
            raise InputError(f"max_volume: a volume is wanted, or 0 for no bound, not {max_volume}")
        if quality != 0 and not 1.1 <= quality <= 100:
            raise InputError(f"quality: a number from 1.1 to 100 is wanted, or 0 for no bound, not {quality}")
        if size < 0:
            raise InputError(f"size: a length is wanted, or 0 for no bound, not {size}")
        if not 0.05 <= growth <= 2:
            raise InputError(f"growth: a number from 0.05 to 2 is wanted, not {growth}")
        if seconds is not None and not 0 <= seconds < 2**31:
            raise InputError(f"seconds: a whole number from 0 is wanted, not {seconds}")
        if order not in (1, 2):
            raise InputError(f"order: 1 or 2 is wanted, not {order}")
        if (surface_first or periodic) and (keep_boundary or curved):
            raise InputError("surface_first and periodic: neither with keep_boundary nor with curved")
        with Shown(progress) as shown, self._placed():
            mesh = _cnrg.tetrahedralize(self._result, max_volume, quality, bool(keep_boundary), seconds, bool(curved),
                                        order, size, growth, bool(surface_first), axes_of(periodic), shown)
        if notice := mesh.notice():
            warnings.warn_explicit(notice, Notice, *site_of_caller())
        return Tetrahedra(mesh, self)

    def mesh_surface(self, *, size: Number = 0, growth: Number = 0.3, max_points: int = 1_000_000, seconds: int = 0,
                     order: int = 1, quads: bool = False, periodic: str = "",
                     progress: Progress = None) -> SurfaceMesh:
        """Triangles on all faces and segments on all edges and wires, without volumes (ruppert1995, ungor2004): what
        meets shares points, and no angle is below 25 degrees where the result allows that.

        size, growth: as of `tetrahedralize`; no side is longer than 1.4 times the size in its middle. max_points: no
        points are added beyond so many. seconds: for all of it, 0: no bound. order: 1, or 2 with a node in the middle
        of each straight side. quads: triangles of a face are merged by pairs into convex quadrilaterals with angles from
        30 to 150 degrees (remacle2012), as many as can be; of order 1 only. periodic: as of `tetrahedralize`; without quads.

        InputError for a result that is not closed, or has neither faces nor wires, or is broken by rounding (`snap()`
        helps), and where the size asked for takes more points or time than there may be.
        """
        size, growth = (float(_cnrg.fraction(number)) for number in (size, growth))
        max_points, seconds, order = (operator.index(number) for number in (max_points, seconds, order))
        if size < 0:
            raise InputError(f"size: a length is wanted, or 0 for no bound, not {size}")
        if not 0.05 <= growth <= 2:
            raise InputError(f"growth: a number from 0.05 to 2 is wanted, not {growth}")
        if not 1 <= max_points <= 1_000_000_000:
            raise InputError(f"max_points: a whole number from 1 to 1000000000 is wanted, not {max_points}")
        if not 0 <= seconds < 2**31:
            raise InputError(f"seconds: a whole number from 0 is wanted, not {seconds}")
        if order not in (1, 2):
            raise InputError(f"order: 1 or 2 is wanted, not {order}")
        with Shown(progress) as shown, self._placed():
            mesh = _cnrg.mesh_surface(self._result, size, growth, max_points, seconds, order, bool(quads), axes_of(periodic),
                                      shown)
        return SurfaceMesh(mesh, self)

    # --- files

    def write(self, path: str | os.PathLike[str], *, parameters: bool = False, snap: bool = True,
              binary: bool = False) -> list[str]:
        """Writes a file in the format of its extension: .json, exactly, or .vtu .msh .msh2 .mesh .smesh .poly .inp .bdf
        .h5m .med .obj .off .stl .ply .3mf .glb .step .stp .brep .regions.dot. Returns, and warns of (cnrg.Notice), what is to be
        said of it: vertices that are elsewhere as doubles, faces that a CAD file has as facets.

        parameters: .json and .vtu say the parameters of faces on curved patches. snap: where rounding to doubles
        would break the result, the file gets the snapped one; False: as it is rounded, with a warning (cnrg.Notice).
        A warning names each region that vanishes by that.
        binary: of .stl and .ply. InputError for a format that cannot hold the result, FileError.
        """
        name = os.fspath(path)
        method = {".svg": "picture", ".png": "picture", ".pdf": "picture", ".html": "view"}
        ending = os.path.splitext(name)[1].lower() if isinstance(name, str) else ""
        if ending in method:
            raise InputError(f"{name}: `write` writes cells; use .{method[ending]}(path) for {ending}")
        with self._placed():
            moved, embedded, notices, vanished = self._result.write(name, bool(parameters), bool(snap), bool(binary))
        for text in vanished:
            warnings.warn_explicit(f"{name}: {text}", Notice, *site_of_caller())
        vertices = "1 vertex" if moved == 1 else f"{moved} vertices"
        if not embedded:
            text = f"{name}: rounding moved {vertices} and broke the result in this file; .json has the exact one"
            warnings.warn_explicit(text, Notice, *site_of_caller())
        elif moved:
            notices.append(f"rounding moved {vertices}; the facets still meet as they should")
        for text in notices:
            warnings.warn_explicit(f"{name}: {text}", Notice, *site_of_caller())
        return list(notices)

    # --- pictures

    def picture(self, path: str | os.PathLike[str] | None = None, *, format: str = "svg", camera: Any = None,
                cut: Any = (), explode: Any = None, opacity: Any = None, ghosts: bool = False,
                color_by: str | None = None, labels: str | Iterable[str] = (), caption: str | None = None,
                size: Any = None, threads: int = 0, progress: Progress = None) -> bytes | None:
        """A still, in which what hides what is decided exactly; as bytes, or written to a path (.svg .png .pdf).

        format: "svg", "png" or "pdf", if there is no path. camera: (azimuth, elevation) in degrees, with 0, 0 along +y.
        cut: a plane such as "x=5" or (nx, ny, nz, d), or a list of them: what is on the camera's side goes. explode: how
        far regions are moved apart, 0.3 by 30 % of their distance from the middle. opacity: of faces, 0.01 to 1. ghosts:
        what the node's operator removed, grey. color_by: "material", "region", "component", "source". labels: any of
        "v", "e", "f", "r", "names". caption: below. size: (width, height) at most, in pixels of .svg.

        InputError for what is none of these, and for coordinates beyond 1e250.
        """
        options = options_of(camera, cut, explode, opacity, ghosts, color_by, labels, caption, size)
        extension = Path(os.fspath(path)).suffix.lower() if path is not None else "." + format
        with Shown(progress) as shown, self._placed():
            data = _cnrg.picture(self._result, extension, options, threads_of(threads), shown)
        if path is None:
            return data
        replace_file(path, data)
        return None

    def view(self, path: str | os.PathLike[str] | None = None, *, title: str | None = None, height: int = 600,
             threads: int = 0, progress: Progress = None) -> View | None:
        """A page to look at in a browser: the tree, its nodes taken apart, every cell with its story. It needs no server
        and no network. Written to a path (.html), or a View, which a notebook shows in a frame (about 1 MB).

        FileError if the page was not built into this package (that takes Node.js).
        """
        if path is not None and not os.fspath(path).endswith((".html", ".htm")):
            raise InputError(f"{os.fspath(path)}: a page is an .html file", *site_of_caller())
        template = Path(__file__).with_name("view.html")
        try:
            page = template.read_text(encoding="utf-8")
        except OSError:
            raise FileError(f"{template} is not there: the page is bundled when cnrg is built where Node.js, npm and the "
                            "network are") from None
        with Shown(progress) as shown, self._placed():
            text = _cnrg.page(self._result, page, title or self.name, threads_of(threads), shown)
        if path is None:
            return View(text, operator.index(height))
        replace_file(path, text.encode("utf-8", "replace"))
        return None

    def _still(self, format: str, **options: Any) -> bytes | None:
        """A picture for a notebook; None for what cannot be drawn, and for so much that nobody would wait for it."""
        if len(self.faces) > _MOST_DRAWN:
            return None
        try:
            return self.picture(format=format, **options)
        except InputError:
            return None

    def _repr_png_(self) -> bytes | None:
        return self._still("png")

    def _repr_html_(self) -> str:
        """Counts, components and a picture."""
        head = "".join(f"<td><b>{len(c.active)}</b> {kind}</td>" for kind, c in self._counted())
        rows = ""
        listed = self.components[:20]
        for c in listed:
            volume = "unbounded" if c.volume is None else f"{float(c.volume):.10g}"
            cells = (str(c.number), html.escape(c.name), html.escape(c.material), volume)
            rows += "<tr>" + "".join(f"<td style='text-align: left'>{cell}</td>" for cell in cells) + "</tr>"
        more = len(self.components) - len(listed)
        if more:
            rows += f"<tr><td></td><td>and {more} more</td><td></td><td></td></tr>"
        still = (self._still("svg", size=(480, 360)) or b"").decode()
        still = still[still.find("<svg"):] if "<svg" in still else ""
        return (f"<div><table><tr><th>{html.escape(self.name)}</th>{head}</tr></table>{still}"
                f"<table><tr><th></th><th>component</th><th>material</th><th>volume</th></tr>{rows}</table></div>")


def _again(json: bytes, name: str, materials: list[tuple[str, str]]) -> Result:
    """One that was pickled."""
    return Result._of(_cnrg.result_of_json(json, name, materials), None)


def _given_points(points: Any) -> tuple[Any, Any]:
    """As an array of doubles if that is what they are exactly, else as a list of exact points."""
    if isinstance(points, np.ndarray):
        array = points[None, :] if points.ndim == 1 and points.shape == (3,) else points
        if array.ndim != 2 or array.shape[1] != 3:
            raise ValueError(f"points must have the shape (n, 3), not {points.shape}")
        if array.dtype.kind == "b":
            raise TypeError("points: an array of numbers is wanted, not of bool")
        if array.dtype.kind == "f" and array.dtype.itemsize <= 8:
            return np.ascontiguousarray(array, dtype=np.float64), None
        if array.dtype.kind in "iu":
            exact = array.astype(np.float64)
            if array.size == 0 or np.all(np.abs(exact) < _EXACT_DOUBLES):
                return np.ascontiguousarray(exact), None
        return None, [list(row) for row in array]
    if isinstance(points, str) or not hasattr(points, "__len__") or not hasattr(points, "__getitem__"):
        points = list(points) if hasattr(points, "__iter__") and not isinstance(points, str) else points
        if not isinstance(points, list):
            raise TypeError("points: an array (n, 3) or a sequence of points is wanted, not " + type(points).__name__)
    if len(points) == 3 and not any(hasattr(p, "__len__") and not isinstance(p, str) for p in points):
        points = [points]
    if not len(points):
        return np.zeros((0, 3)), None
    if all(type(p) in (list, tuple) and len(p) == 3 and all(type(x) is float for x in p) for p in points):
        return np.array(points, dtype=np.float64), None
    return None, list(points)
