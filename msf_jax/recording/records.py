"""The records of a run's decisions, from which a tape is made on request."""

from typing import Any, NamedTuple

import numpy as np

from msf_jax.numerics.reconstruction import LowPass
from msf_jax.solid.geometry import UnitFrame


class FoundPoles(NamedTuple):
    """Poles of a surface of n vertices.

    kept: the filter from its vertices to the sites (n, 3). poles: (n, 3). tetrahedron: (n, 4) the sites whose
    circumcentre the pole is. is_inside: (n,) whether the pole pulls.
    """

    kept: LowPass | None
    sites: np.ndarray
    poles: np.ndarray
    tetrahedron: np.ndarray
    is_inside: np.ndarray


class Start(NamedTuple):
    """The preparation of a component: the filter of its mesh, edits, and poles."""

    mesh_filter: LowPass | None
    edits: list[Any]
    found: FoundPoles | None


class Step(NamedTuple):
    """One iteration on a surface of m vertices, and the edits after it.

    order: (m,) the vertex in each packed row; the other arrays are by rows. positions: (m, 3) float32, before the
    iteration. rings: (m, K), see `packing.pack`. degree, free, pull: (m,). left: (2, m, 3) residuals of the two
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
