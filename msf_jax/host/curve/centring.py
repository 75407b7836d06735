"""Move the nodes of a curve to the middle of the solid, and leave its graph alone.

The middle of a limb is the centroid c of its cross-section. In each round all nodes x of a curve are found at once, as
the minimum of

    sum_i w_i |P_i (x_i - c_i)|^2  +  sum_i (l_i / h_i)^4 |x_{i-1} - 2 x_i + x_{i+1}|^2  +  sum_i a_i |x_i - y_i|^2,

where P_i takes away most of what is along the branch: a smoothing spline, whose stiffness reaches over a part l of the
limb's radius whatever the spacing h of the nodes, and along which they can slide. Near a junction a cross-section cuts
several limbs and says nothing: w is 0 there, and the branches run straight on, so that the junction comes to where the
axes of its limbs meet. That is right for tubes. Where the solid is roomier around y, the place that the flow found for
a node, than around the straight way (the rump of a horse, a shell on a back), a holds the node there.
"""

from typing import NamedTuple

import numpy as np
from scipy import sparse
from scipy.sparse import linalg

from msf_jax.host.curve import branches
from msf_jax.host.solid import sections
from msf_jax.host.solid.enclosure import Enclosure
from msf_jax.host.solid.geometry import arc_length, at, unit

# Chosen on the ground-truth shapes and the research meshes, for the mean distance to the true curve, off-centre and
# missed together; see `tests.benchmarks.curves`.
ROUNDS = 3
STIFFNESS = 0.35  # the length l, in radii
STIFFEST = 1e5  # of (l / h)^4
ZONE = 0.7  # radii of a junction, within which sections do not count
LOPSIDED = 3.5  # a section so many times as wide as the inscribed ball is not that of a limb
ROUNDNESS = 4  # a section wider than its branch's usual one counts less, by this power of the ratio
STRAY = 0.3  # section radii: a centroid so far from the smooth curve counts for half
SLIDING = 0.03  # what is left of w along the branch
ANCHOR, JUNCTION_ANCHOR = 0.003, 0.1  # a: in general, at a junction, and
ROOMY_ANCHOR = 2.0  # near a junction, where the place that the flow found is roomier
LONGEST_STEP = 0.5  # radii, in one round
HELD = 1e9  # a, for a node that is not to move
THINNEST = 0.5  # of the clearance that the flow gave a node must be left of it


class Way(NamedTuple):
    """A branch with its arc length: nodes (k,), along (k,). is_loop: it has no junction, and its ends are one node."""

    nodes: np.ndarray
    along: np.ndarray
    is_loop: bool


def centre(
    shape: Enclosure, vertices: np.ndarray, edges: np.ndarray, is_held: np.ndarray, rounds: int = ROUNDS
) -> np.ndarray:
    """The nodes ``vertices`` (N, 3) of the curve, centred; those of ``is_held`` (N,) stay where they are.

    A step that would leave the solid, or half of the clearance that a node came with, is cut short; a node that is
    outside stays there.
    """
    x = vertices.copy()
    degree = np.bincount(edges.ravel(), minlength=len(x))
    ways = [np.array(way) for way in branches.trace(len(x), edges) if len(way) > 1]
    first_radii, near = shape.about_clearance(x)
    radii = first_radii.copy()
    for _ in range(rounds):
        measured = [Way(nodes, arc_length(x[nodes]), nodes[0] == nodes[-1] and degree[nodes[0]] == 2) for nodes in ways]
        tangent = _tangents(x, measured, radii)
        is_near = _near_junction(measured, degree, radii, len(x))
        limb = np.flatnonzero((degree > 0) & (degree <= 2) & ~is_near & ~is_held & (radii > 0))
        found = sections.cut(shape, x[limb], tangent[limb], radii[limb], near[limb])
        is_good = found.is_around & (found.radius < LOPSIDED * radii[limb])
        limb, middle, width = limb[is_good], found.centroid[is_good], found.radius[is_good]
        round_weight = np.minimum(1.0, _usual_width(ways, limb, width, len(x)) / width) ** ROUNDNESS
        anchor = np.where(degree > 2, JUNCTION_ANCHOR, ANCHOR)
        anchor[is_near & (first_radii > radii)] = ROOMY_ANCHOR
        anchor[is_held] = HELD
        weight, goal = round_weight, x
        for _ in range(2):
            goal = _fair(x, vertices, measured, radii, anchor, limb, middle, tangent[limb], weight)
            stray = np.linalg.norm(goal[limb] - middle, axis=1) / (STRAY * width)
            weight = round_weight / (1 + stray**2)
        step = goal - x
        length = np.linalg.norm(step, axis=1)
        step *= np.minimum(1.0, LONGEST_STEP * radii / np.maximum(length, 1e-300))[:, None]
        step[is_held] = 0.0
        left = np.flatnonzero(~is_held & (radii > 0))
        for part in (1.0, 0.5, 0.25):
            goal = x[left] + part * step[left]
            moved, triangle = shape.approach(goal)
            is_safe = (moved > np.minimum(THINNEST * first_radii[left], radii[left])) & shape.contains(goal)
            x[left[is_safe]] += part * step[left[is_safe]]
            radii[left[is_safe]], near[left[is_safe]] = moved[is_safe], triangle[is_safe]
            left = left[~is_safe]
    return x


def _usual_width(ways: list[np.ndarray], limb: np.ndarray, width: np.ndarray, num: int) -> np.ndarray:
    """For each node of ``limb``, the median of the widths along its branch."""
    known = np.full(num, np.nan)
    known[limb] = width
    usual = np.zeros(num)
    for nodes in ways:
        along = known[nodes]
        if not np.isnan(along).all():
            usual[nodes] = np.nanmedian(along)
    return usual[limb]


def _fair(
    x: np.ndarray,
    first: np.ndarray,
    ways: list[Way],
    radii: np.ndarray,
    anchor: np.ndarray,
    limb: np.ndarray,
    middle: np.ndarray,
    tangent: np.ndarray,
    weight: np.ndarray,
) -> np.ndarray:
    """The minimum of the energy in the module's docstring, by its normal equations."""
    num = len(x)
    triples, stiffness = [], []
    for nodes, along, is_loop in ways:
        if is_loop:
            nodes, along = np.r_[nodes, nodes[1]], np.r_[along, along[-1] + along[1]]
        if len(nodes) > 2:
            triples.append(np.stack([nodes[:-2], nodes[1:-1], nodes[2:]], axis=1))
            spacing = (along[2:] - along[:-2]) / 2
            stiffness.append(np.minimum((STIFFNESS * radii[nodes[1:-1]] / np.maximum(spacing, 1e-12)) ** 4, STIFFEST))
    across = np.eye(3) - (1 - SLIDING) * tangent[:, :, None] * tangent[:, None, :]
    blocks = anchor[:, None, None] * np.eye(3)
    blocks[limb] += weight[:, None, None] * across
    right = anchor[:, None] * first
    right[limb] += weight[:, None] * np.einsum("nij,nj->ni", across, middle)
    matrix = sparse.bsr_matrix((blocks, np.arange(num), np.arange(num + 1)), shape=(3 * num, 3 * num)).tocsc()
    if triples:
        triple, alpha = np.concatenate(triples), np.concatenate(stiffness)
        rows = np.repeat(np.arange(len(triple)), 3)
        bending = sparse.coo_matrix(
            (np.tile([1.0, -2.0, 1.0], len(triple)), (rows, triple.ravel())), (len(triple), num)
        )
        matrix = matrix + sparse.kron(bending.T @ sparse.diags(alpha) @ bending, sparse.eye(3), format="csc")
    return linalg.splu(matrix.tocsc()).solve(right.ravel()).reshape(num, 3)


def _tangents(x: np.ndarray, ways: list[Way], radii: np.ndarray) -> np.ndarray:
    """Direction (N, 3) of the branch at each node, over one radius to either side."""
    tangent = np.zeros_like(x)
    for nodes, along, is_loop in ways:
        points, reach = x[nodes], radii[nodes]
        if is_loop:
            lap = along[-1]
            points = np.concatenate([points[:-1], points[:-1], points])
            along = np.concatenate([along[:-1] - lap, along[:-1], along + lap])
            here = along[len(nodes) - 1 : 2 * len(nodes) - 1]
            reach = np.minimum(reach, lap / 4)
        else:
            here = along
        tangent[nodes] = unit(at(points, along, here + reach) - at(points, along, here - reach))
    return tangent


def _near_junction(ways: list[Way], degree: np.ndarray, radii: np.ndarray, num: int) -> np.ndarray:
    """(N,) True for a node within the zone of a junction at an end of its branch."""
    is_near = degree > 2
    for nodes, along, _ in ways:
        for end, distance in ((nodes[0], along), (nodes[-1], along[-1] - along)):
            if degree[end] > 2:
                is_near[nodes[distance < ZONE * radii[end]]] = True
    return is_near
