"""The records of a run's decisions, from which a tape is made on request.

The decisions are also a set of hashes, to count those that two runs do not share. A decision is one collapse (with the
pole that the survivor kept), one split, one vertex fixed, or the node of one vertex of the meso-skeleton, in its
iteration. Vertices are identified by the caller's vertices that they come from. Rows would shift after any difference.
"""

from typing import Any, NamedTuple

import numpy as np

from msf_jax.meso.collapse import CollapseRound
from msf_jax.meso.meso import Compaction, Fixing
from msf_jax.meso.split import SplitRound
from msf_jax.numerics.reconstruction import LowPass
from msf_jax.solid.frame import UnitFrame

MERGE, CUT, FIX, NODE = 1, 2, 3, 4  # kinds of decisions, hashed with them


class FoundPoles(NamedTuple):
    """Poles of a surface of n vertices.

    kept: the filter from its vertices to the sites. sites: (n, 3). poles: (n, 3). tetrahedron: (n, 4) the sites whose
    circumcentre the pole is. is_inside: (n,) whether the pole pulls. trust: (n,) from 0 to 1.
    """

    kept: LowPass | None
    sites: np.ndarray
    poles: np.ndarray
    tetrahedron: np.ndarray
    is_inside: np.ndarray
    trust: np.ndarray


class Start(NamedTuple):
    """The preparation of a component: the filter of its mesh, edits, and poles."""

    mesh_filter: LowPass | None
    edits: list[Any]
    found: FoundPoles | None


class Step(NamedTuple):
    """One iteration on a surface of m vertices, and the edits after it.

    order: (m,) the vertex in each packed row; the other arrays are by rows. positions: (m, 3) float32, before the
    iteration. rings: (m, K), see `packing.Packed`. degree, free, pull: (m,). left: (2, m, 3) residuals of the two
    solves, divided by the norms of their right-hand sides. factor: on w_L.
    """

    order: np.ndarray
    positions: np.ndarray
    rings: np.ndarray
    degree: np.ndarray
    free: np.ndarray
    pull: np.ndarray
    left: np.ndarray
    factor: float
    edits: list[Any]


class ComponentRecord(NamedTuple):
    """The data for the tape of a component.

    vertices: (V, 3) in the frame. vertex_of_input: (V,) the caller's vertex for each. pins: vertices held in place.
    num_meso: number of vertices of the contracted surface. thinning: its edits before the curve was extracted.
    node_of_meso: the node whose position each vertex contributes to, or -1. node_of_pin: the node of each pin.
    """

    vertices: np.ndarray
    faces: np.ndarray
    vertex_of_input: np.ndarray
    frame: UnitFrame
    pins: np.ndarray
    start: Start
    steps: list[Step]
    num_meso: int
    thinning: list[Any]
    node_of_meso: np.ndarray
    node_of_pin: np.ndarray
    num_nodes: int


class Recording(NamedTuple):
    """A run's components, and the caller's mesh.

    input_of_vertex: the caller's vertex for each checked vertex; for those of ``is_made``, one near it.
    """

    components: tuple[ComponentRecord, ...]
    vertices: np.ndarray
    faces: np.ndarray
    input_of_vertex: np.ndarray
    is_made: np.ndarray


def decisions(components: tuple[ComponentRecord, ...]) -> np.ndarray:
    """(D,) uint32, sorted: a hash of each decision of a run."""
    return np.sort(np.concatenate([_of_component(component) for component in components]))


def num_unlike(first: np.ndarray, second: np.ndarray) -> int:
    """The number of decisions of ``second`` that are not in ``first``."""
    place = np.searchsorted(first, second)
    return int((first[np.minimum(place, len(first) - 1)] != second).sum()) if len(first) else len(second)


def _of_component(record: ComponentRecord) -> np.ndarray:
    names = _hash(record.vertex_of_input)
    pole_names = names
    keys: list[np.ndarray] = []
    phases = [record.start.edits, *(step.edits for step in record.steps), record.thinning]
    for number, edits in enumerate(phases):
        for edit in edits:
            names, pole_names = _follow(edit, number, names, pole_names, keys)
    is_node = record.node_of_meso >= 0
    names, node = names[is_node], record.node_of_meso[is_node]
    first = np.full(record.num_nodes, np.iinfo(np.uint64).max, dtype=np.uint64)
    np.minimum.at(first, node, names)
    keys.append(_hash(NODE, names, first[node]))
    return (np.concatenate(keys) >> np.uint64(32)).astype(np.uint32)


def _follow(edit: Any, number: int, names: np.ndarray, pole_names: np.ndarray, keys: list[np.ndarray]) -> Any:
    """Add the decisions of one edit in phase ``number`` to ``keys``. Returns the vertices' names after the edit."""
    if isinstance(edit, CollapseRound):
        one, other = names[edit.survivor], names[edit.removed]
        pole = np.where(edit.takes_pole, pole_names[edit.removed], pole_names[edit.survivor])
        keys.append(_hash(MERGE, number, np.minimum(one, other), np.maximum(one, other), pole))
        names, pole_names = names.copy(), pole_names.copy()
        names[edit.survivor], pole_names[edit.survivor] = np.minimum(one, other), pole
    elif isinstance(edit, SplitRound):
        one, other = names[edit.a], names[edit.b]
        apex = names[edit.a if edit.apex is None else edit.apex]
        new = _hash(CUT, number, np.minimum(one, other), np.maximum(one, other), apex)
        keys.append(new)
        names, pole_names = np.concatenate([names, new]), np.concatenate([pole_names, new])
    elif isinstance(edit, Fixing):
        keys.append(_hash(FIX, number, names[edit.vertex]))
    elif isinstance(edit, Compaction):
        names, pole_names = names[edit.live], pole_names[edit.live]
    return names, pole_names


def _hash(*columns: Any) -> np.ndarray:
    """(c,) uint64 hashes of the rows of ``columns``, by the finaliser of splitmix64 (Steele et al. 2014)."""
    mixed = np.full(np.broadcast(*columns).shape, 0x9E3779B97F4A7C15, dtype=np.uint64)
    for column in columns:
        mixed = mixed * np.uint64(3) + np.asarray(column).astype(np.uint64)
        mixed = (mixed ^ (mixed >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
        mixed = (mixed ^ (mixed >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
        mixed = mixed ^ (mixed >> np.uint64(31))
    return mixed
