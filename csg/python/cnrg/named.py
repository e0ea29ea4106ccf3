"""Materials, regions and nodes that nodes name."""

from __future__ import annotations

from itertools import chain
from typing import Any, Iterable, Iterator

from .nodes import _FILES, Exact, Material, MeshArrays, Node, Picked, Text
from .operands import StoredResult


def mixed(data: Any) -> Iterator[str]:
    """The materials that the stops of a graded one name."""
    for grade in ("linear", "distance"):
        stops = data.get(grade, {}).get("stops", []) if isinstance(data.get(grade), dict) else []
        for stop in stops if isinstance(stops, list) else []:
            mixture = stop[1] if isinstance(stop, list) and len(stop) == 2 else None
            if isinstance(mixture, str) and not isinstance(mixture, Exact):
                yield mixture
            elif isinstance(mixture, dict):
                yield from mixture


def of_regions(node: Node) -> Iterator[str]:
    """The materials that the regions of a group name."""
    regions = node.value.get("regions") if node.operator == "group" and isinstance(node.value, dict) else None
    for region in regions.values() if isinstance(regions, dict) else ():
        name = region.get("material") if isinstance(region, dict) else None
        if isinstance(name, str):
            yield name


def region_names(nodes: Iterable[Node], keys: Iterable[str]) -> set[str] | None:
    """All that a region of these nodes can be called; None where files may say more."""
    names = set(keys)
    for node in nodes:
        if isinstance(node.value, StoredResult):
            names.update(chain.from_iterable(name.split(" & ") for name in node.value.regions))
        elif node.operator in _FILES and not isinstance(node.value, MeshArrays):
            return None
        elif node.operator == "group" and isinstance(node.value.get("regions"), dict):
            names.update(str(region.get("name")) for region in node.value["regions"].values() if isinstance(region, dict))
        names.update(str(value) for key, value in node.attributes if key == "name")
        if node.key is not None:
            names.add(node.key)
    return names


def named_regions(node: Node) -> list[str]:
    """What the regions that a node picks by name are made of."""
    wanted = node.value.criteria.get("region", []) if isinstance(node.value, Picked) else []
    listed = [wanted] if isinstance(wanted, (str, Exact)) else list(wanted)
    return list(chain.from_iterable(str(name).split(" & ") for name in listed if isinstance(name, Text)))


def picked_materials(node: Node) -> list[str]:
    """The names of the materials by which a node picks."""
    wanted = node.value.criteria.get("material", []) if isinstance(node.value, Picked) else []
    return [wanted] if isinstance(wanted, str) else list(wanted)


def sources(node: Node) -> tuple[Node, ...]:
    """Nodes that a node names beside its operands."""
    return tuple(chain.from_iterable(node.value.sources.values())) if isinstance(node.value, Picked) else ()


def own_material(node: Node) -> Material | None:
    return next((value for name, value in node.attributes if name == "material"), None)


def own_materials(node: Node) -> list[Material]:
    """The materials that the node has or picks by, and those in their stops, at any depth, each once."""
    own = own_material(node)
    listed = [] if own is None else [own]
    if isinstance(node.value, Picked):
        listed += node.value.materials
    seen = {id(m) for m in listed}
    for m in listed:
        for inner in m.mixed:
            if id(inner) not in seen:
                seen.add(id(inner))
                listed.append(inner)
    return listed
