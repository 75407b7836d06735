"""The decisions of a run as padded arrays, which the host records and `device.playback` replays.

Numbers of rows, iterations, rounds, terms and neighbours are capacities, see `layout.capacity_for`, so that a program
serves all tapes of a size. What pads has no share in any sum.
"""

from typing import Any, NamedTuple


class Mixing(NamedTuple):
    """A sparse matrix by its entries (e,)."""

    row: Any
    column: Any
    share: Any


class Polynomial(NamedTuple):
    """The filter sum_j share_j T_j(1 - 2 L / top) of the graph Laplacian L on n rows; a constant linear map.

    neighbour: (n, K) rows, of which the first ``degree`` (n,) count.
    """

    neighbour: Any
    degree: Any
    share: Any
    top: Any


class Stretch(NamedTuple):
    """T consecutive iterations in one layout of n rows, each followed by R rounds of M splits.

    start: (n,) the row of the workspace before, from which each row starts. rings: (T, S) each. enter: (T, n) the same
    as start, for each iteration; itself for the first. degree, free, pull: (T, n). site: (T, n) the row of the first
    stretch whose pole each row has. left: (T, 2, n, 3) residuals r of the solves. factor: (T,) on w_L; 0 for the first
    lines, which pad: nothing is computed for them. group, share: (T, n) the row that each row is merged into, and its
    share of that. cut: (T, R, M, 3) the ends of the split edge, and the apex.
    """

    start: Any
    rings: Any
    enter: Any
    degree: Any
    free: Any
    pull: Any
    site: Any
    left: Any
    factor: Any
    group: Any
    share: Any
    cut: Any


class Part(NamedTuple):
    """The tape of one component. Its first rows are those of the surface at the start of the flow.

    vertices: (V, 3) of the component in its frame. vertex_of_input: (V,) the caller's vertex for each. is_pin: (V,).
    mesh_filter, site_filter: of the mesh itself and of the sites of poles: a `Polynomial`, Phi (V, k) of the filter
    Phi Phi^T, or None. gather: the matrix (n, V) from vertices to first rows. tetrahedron: (n, 4), is_firm: (n,),
    offset: (n, 3): see `recording.records.record_poles`. meso_row: (m,) rows of the last workspace. nodes, pins: the
    matrices (N, m) from the meso-skeleton to the nodes, and (N, V) from the caller's vertices to those nodes that are
    means of pins. is_held: (N,) these nodes. centre: (3,), diagonal: (), axes: (3, 3): the frame.
    """

    vertices: Any
    vertex_of_input: Any
    is_pin: Any
    mesh_filter: Any
    gather: Mixing
    site_filter: Any
    tetrahedron: Any
    is_firm: Any
    offset: Any
    stretches: tuple[Stretch, ...]
    meso_row: Any
    nodes: Mixing
    pins: Mixing
    is_held: Any
    centre: Any
    diagonal: Any
    axes: Any
