"""The decisions of a run as a set of hashes, to count the decisions that two runs do not share.

A decision is one collapse (with the pole that the survivor kept), one split, one vertex fixed, or the node of one
vertex of the meso-skeleton, in its iteration. Vertices are identified by the caller's vertices that they come from.
Rows would shift after any difference.
"""

from typing import Any

import numpy as np

from msf_jax.meso.collapse import CollapseRound
from msf_jax.meso.meso import Compaction, Fixing
from msf_jax.meso.split import SplitRound
from msf_jax.recording.records import ComponentRecord

MERGE, CUT, FIX, NODE = 1, 2, 3, 4  # kinds of decisions, hashed with them


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
