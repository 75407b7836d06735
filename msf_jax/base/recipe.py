"""`Recipe`: how a finished curve hangs on the vertices of its mesh. The host writes it, the device reads it.

With c_j(V) the centroids of the cross-sections that were recorded,

    x_i(V) = sum_j a_ij c_j(V) + sum_v b_iv V_v + r_i,

where a smooths along the branches, and b turns, stretches and shears with the limb what node i was off sum_j a_ij c_j.
"""

from typing import Any, NamedTuple


class Recipe(NamedTuple):
    """Arrays, for N nodes, S sections, C corners of sections and V vertices of the caller's mesh; lengths in diagonals.

    tail, head: (C,) the vertices that each corner is between. part: (C,) how far from tail to head, as a fraction.
    onward: (C,) the corner that comes next in its section. section: (C,) ascending. share: (C,) one over the number of
    corners in that section. is_loop: (S,) False for a cloud of points: its centroid is their mean. area: (S,) of each
    section. node: (S,) whose it is. a_row, a_column, a_value: entries of a, (N, S), in the order of rows; b_row,
    b_column, b_value: those of b, (N, V). rest: (N, 3) r. nearby: (N, K, 3) vertices of triangles near each node, in
    all directions, the nearest among them. is_inside: (N,).
    centre: (3,), diagonal: of the surface in the caller's units.
    """

    tail: Any
    head: Any
    part: Any
    onward: Any
    section: Any
    share: Any
    is_loop: Any
    area: Any
    node: Any
    a_row: Any
    a_column: Any
    a_value: Any
    b_row: Any
    b_column: Any
    b_value: Any
    rest: Any
    nearby: Any
    is_inside: Any
    centre: Any
    diagonal: Any
