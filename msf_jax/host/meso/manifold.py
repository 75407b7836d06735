"""What must hold of the surface after every edit: closed, oriented, manifold, of the Euler characteristic it had."""

import numpy as np

from msf_jax.base.errors import FlowError
from msf_jax.host.meso.ring_tables import encode_edges, find_slot, ring_degrees


def euler_characteristic(rings: np.ndarray) -> int:
    """V - E + F of the live part of the table: 2 - 2 genus for each component."""
    half = int((rings >= 0).sum())
    return int((rings[:, 0] >= 0).sum()) - half // 2 + half // 3


def check_closed_manifold(rings: np.ndarray, euler: int) -> None:
    """The debug check after an edit: closed, oriented, simplicial, and of the Euler characteristic it had.

    Raises:
        FlowError: naming the first vertex that breaks a rule.
    """
    vertex, slot = np.nonzero(rings >= 0)
    neighbour = rings[vertex, slot]
    degree = ring_degrees(rings)
    code = encode_edges(vertex, neighbour, len(rings))
    faults = {
        "is its own neighbour": vertex[vertex == neighbour],
        "has a neighbour twice": np.sort(code)[1:][np.diff(np.sort(code)) == 0] // len(rings),
        "has a neighbour that does not know it": vertex[~np.isin(code, encode_edges(neighbour, vertex, len(rings)))],
        "has fewer than three neighbours": np.flatnonzero((degree > 0) & (degree < 3)),
        "has a gap in its ring": np.flatnonzero((rings >= 0) != (np.arange(rings.shape[1]) < degree[:, None]))
        // rings.shape[1],
    }
    # Face (i, j, k) read at i must be read at j as (j, k, i): after k comes i.
    following = np.where(slot + 1 < degree[vertex], slot + 1, 0)
    third = rings[vertex, following]
    if not any(len(found) for found in faults.values()):
        slot_of_third = find_slot(rings[neighbour], third)
        after = rings[neighbour, np.where(slot_of_third + 1 < degree[neighbour], slot_of_third + 1, 0)]
        faults["bears a face that its neighbours do not"] = vertex[after != vertex]
    for what, found in faults.items():
        if len(found):
            raise FlowError(
                f"the surface is no closed manifold any more: vertex {found[0]} {what}, as do {len(found) - 1} others"
            )
    if (now := euler_characteristic(rings)) != euler:
        raise FlowError(f"an edit changed the topology: Euler characteristic {now}, was {euler}")
