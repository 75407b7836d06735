"""What a run keeps of its decisions, as they were made: what its tape is made from when that is asked for."""

from typing import Any, NamedTuple

import numpy as np

from msf_jax.host.reconstruction import LowPass
from msf_jax.host.solid.frame import Frame


class FoundPoles(NamedTuple):
    """Poles of a surface of n vertices.

    kept: the filter that made the sites of its vertices. sites: (n, 3). poles: (n, 3). tetrahedron: (n, 4) the sites
    whose circumcentre a pole is. is_inside: (n,) whether it pulls. trust: (n,).
    """

    kept: LowPass | None
    sites: np.ndarray
    poles: np.ndarray
    tetrahedron: np.ndarray
    is_inside: np.ndarray
    trust: np.ndarray


class Start(NamedTuple):
    """What was done to a component before its flow: the mesh filtered, edited, and its poles sought."""

    mesh_filter: LowPass | None
    edits: list[Any]
    found: FoundPoles | None


class Step(NamedTuple):
    """One iteration on a surface of m vertices, and the edits after it.

    order: (m,) the vertex in each packed row; all else is by rows. positions: (m, 3) float32, before it. rings: (m, K),
    see `packing.Packed`. degree, free, pull: (m,). left: (2, m, 3) residuals of the two solves, over their right-hand
    sides' norms.
    factor: that w_L had grown by.
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
    """Everything that the tape of a component is made from.

    vertices: (V, 3) in the frame. vertex_of_input: (V,) the caller's vertex that each is. pins: vertices held in place.
    num_meso: vertices of the contracted surface. thinning: edits of it before the curve was read off.
    node_of_meso: the node (-1 for none, or a pruned one) that each vertex counts for. node_of_pin: that of each pin.
    """

    vertices: np.ndarray
    faces: np.ndarray
    vertex_of_input: np.ndarray
    frame: Frame
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

    input_of_vertex: the caller's vertex that each checked one is, or, for those of ``is_made``, the one near it.
    """

    components: tuple[ComponentRecord, ...]
    vertices: np.ndarray
    faces: np.ndarray
    input_of_vertex: np.ndarray
    is_made: np.ndarray
