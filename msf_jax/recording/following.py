"""Record the binding of a finished curve to its mesh, so that the curve can follow moving vertices.

A node follows the cross-sections of its limb, whose corners are stored as fractions of mesh edges. A node without a
section has a cloud instead: the vertices that belong to it and its neighbours. The centroids c of both, with weights w
(those of `centring`, and small ones for clouds), are smoothed along the curve:

    minimise  sum_i w_i |x_i - c_i|^2  +  sum_ij mu_ij |x_i - x_j|^2,   mu = (REACH size / h)^2

for neighbours h apart in a limb of that size: x = a c with a constant matrix a, whose rows sum to one. The remainder
o = x - a c at the recorded mesh is turned by the affine map F that best fits how the corners of the sections around the
node have moved. F o is linear in the vertices, b V:

    F = C / S,   C = sum_k a_k (p_k - p_mean) (q_k - q_mean)^T,   S = the same with p = q,   q the recorded corners.

Both a and b reproduce every affine map of the mesh exactly. A pinned node has the mean of its pins, as its row of b.
"""

from typing import Any, NamedTuple

import numpy as np
from scipy import sparse
from scipy.sparse import csgraph, linalg
from trimesh.triangles import closest_point

from msf_jax.base.binding import FACES_TOGETHER, Binding, Sizes
from msf_jax.curve import branches as measures
from msf_jax.curve import centring
from msf_jax.solid.geometry import RESOLUTION, together, unit
from msf_jax.solid.solid import Solid, moved_inside
from msf_jax.topology import graphs

REACH = 0.25  # limb sizes along the branch over which sections are averaged, and a frame is fitted
SLIGHT = 0.1  # least weight w of a section, sections of less are left out; and that of a cloud
FRAME_CORNERS = 12  # corners of each section that a frame is fitted to
LEAST_SHARE = 1e-2  # of a row's largest entry: smaller entries of a are left out


class BoundSurface(NamedTuple):
    """The mesh that a curve is bound to: the checked ``solid``, the caller's number of each ``vertex`` (v,) of it, and
    its ``node`` (v,)."""

    solid: Solid
    vertex: np.ndarray
    node: np.ndarray

    def given(self, num: int) -> np.ndarray:
        """The ``num`` vertices of the caller's mesh; vertices in no face have no effect, and are at 0."""
        vertices = np.zeros((num, 3))
        vertices[self.vertex] = self.solid.vertices
        return vertices


class BoundCorners(NamedTuple):
    """The corners (C,) of S sections, one section after the other; section: (C,); tail, head, part: `sections.Corners`;
    centroid: (S, 3); node: (S,); weight: (S,) w."""

    section: np.ndarray
    tail: np.ndarray
    head: np.ndarray
    part: np.ndarray
    centroid: np.ndarray
    node: np.ndarray
    weight: np.ndarray


def record(
    surface: BoundSurface, num: int, vertices: np.ndarray, edges: np.ndarray, pins_of_node: dict[int, np.ndarray]
) -> Binding:
    """The binding of the curve ``(vertices (N, 3), edges (E, 2))``, in the caller's units, to ``surface``; not padded.

    ``num``: number of the caller's vertices. ``pins_of_node``: for each pinned node, the vertices whose mean it is.
    """
    solid, shape, x = surface.solid, surface.solid.shape, surface.solid.enter(vertices)
    is_held = np.zeros(len(x), dtype=bool)
    is_held[list(pins_of_node)] = True
    distance, nearest = shape.nearest(x)
    here, paths = shape.winding_numbers(x), measures.paths_of(x, edges, is_held)
    inside = here > 0
    loops, size = _sections(solid, x, paths, is_held, np.where(inside, distance, 0.0))
    corners = _with_clouds(surface, edges, loops, len(x))
    a = _smoothing(x, edges, size, corners, is_held)
    offset = np.where(is_held[:, None], 0.0, x - a @ corners.centroid)
    b = _turning(surface, num, corners, a, offset).tolil()
    for node, pins in pins_of_node.items():
        b[node, pins] = 1 / len(pins)
    a, b = sparse.coo_array(a), sparse.coo_array(b.tocsr())
    placed = np.zeros((num, 3))
    placed[surface.vertex] = shape.vertices
    first = np.searchsorted(corners.section, corners.section)
    onward = np.where(np.diff(corners.section, append=-1) != 0, first, np.arange(len(first)) + 1)
    order = together(shape.centroids, FACES_TOGETHER)
    twin = shape.mesh.twins.reshape(-1, 3)[order]
    # Behind the nearest wall of a node inside, the surface winds around less, unless the wall is another part's.
    foot = closest_point(shape.triangles[nearest], x)
    behind = shape.winding_numbers(foot + RESOLUTION * unit(foot - x))
    ends = [np.stack([path.nodes[:-1], path.nodes[1:]], axis=1) for path in paths]
    unit_of_length = 2.0 ** np.round(np.log2(solid.diagonal))
    scale = solid.diagonal / unit_of_length
    binding = Binding(
        live=Sizes(*8 * [0]),
        vertices=surface.given(num),
        tail=surface.vertex[corners.tail],
        head=surface.vertex[corners.head],
        part=corners.part,
        onward=onward,
        section=corners.section,
        share=1 / np.bincount(corners.section)[corners.section],
        is_loop=np.arange(len(corners.node)) < len(loops.node),
        node=corners.node,
        a_row=a.row,
        a_column=a.col,
        a_value=a.data,
        b_row=b.row,
        b_column=b.col,
        b_value=b.data,
        rest=scale * (x - a @ corners.centroid - b @ placed),
        faces=surface.vertex[shape.faces[order]],
        twin=3 * np.argsort(order)[twin // 3] + twin % 3,
        is_wall=np.isin(order, solid.lids, invert=True),
        side=np.where(np.where(inside, behind > here, behind < here), -1.0, 1.0),
        edges=np.concatenate([edges[:0], *ends]),
        branch=np.repeat(np.arange(len(ends)), list(map(len, ends))),
        centre=solid.centre,
        diagonal=np.asarray(solid.diagonal),
        unit=np.asarray(unit_of_length),
    )
    return binding._replace(live=binding.capacity)


def _sections(
    solid: Solid,
    x: np.ndarray,
    paths: list[measures.BranchPath],
    is_held: np.ndarray,
    radii: np.ndarray,
) -> tuple[BoundCorners, np.ndarray]:
    """The sections that count in `centring`, without those that the lid of an opening cuts off, and the size (N,) of
    the limb at every node."""
    shape = solid.shape
    if not paths:
        none = np.zeros(0, dtype=np.int64)
        return BoundCorners(none, none, none, none, np.zeros((0, 3)), none, none), radii
    limbs = centring.limb_sections(shape, x, paths, is_held, radii)
    node, found, normal = limbs.node, limbs.found, limbs.tangent
    weight = limbs.robust(x[node] - found.middle)
    is_whole = (moved_inside(x, normal, solid.openings) == x).all(axis=1)
    # The centroid across a whole sheet moves much farther by noise than its vertices.
    is_kept = (weight > SLIGHT) & is_whole[node] & (found.radius < measures.WIDE * found.size)
    found, node, weight = found.only(is_kept), node[is_kept], weight[is_kept]
    cut = found.corners
    return BoundCorners(cut.loop, cut.tail, cut.head, cut.part, found.centroid, node, weight), limbs.size


def _with_clouds(surface: BoundSurface, edges: np.ndarray, loops: BoundCorners, num: int) -> BoundCorners:
    """Add a cloud for each of ``num`` nodes without a section: the vertices of the node and its neighbours, if any."""
    beside = sparse.eye_array(num) + graphs.weighted(num, *np.r_[edges, edges[:, ::-1]].T)
    every = np.arange(len(surface.node))
    own = sparse.csr_array((np.ones(len(every)), (surface.node, every)), shape=(num, len(every)))
    clouds = sparse.csr_array(beside @ own)
    count = np.diff(clouds.indptr)
    node = np.setdiff1d(np.flatnonzero(count), loops.node)
    vertex, section = clouds[node].indices, len(loops.node) + np.repeat(np.arange(len(node)), count[node])
    centroid = clouds[node] @ surface.solid.shape.vertices / count[node, None]
    added = section, vertex, vertex, np.zeros(len(vertex)), centroid, node, np.full(len(node), SLIGHT)
    return BoundCorners(*map(np.concatenate, zip(loops, added, strict=True)))


def _smoothing(
    x: np.ndarray, edges: np.ndarray, size: np.ndarray, corners: BoundCorners, is_held: np.ndarray
) -> sparse.csr_array:
    """The matrix a (N, S), see the module, without small entries; rows of nodes ``is_held`` (N,) are empty."""
    num, (tail, head) = len(x), edges.T
    size = np.maximum(size, 1e-3)  # diagonals: a thinner limb is as stiff as one of that size
    gap = np.maximum(np.linalg.norm(x[tail] - x[head], axis=1), 1e-9)  # diagonals: nodes in one place
    mu = (REACH * np.minimum(np.minimum(size[tail], size[head]) / gap, 1e3)) ** 2
    membrane = csgraph.laplacian(graphs.weighted(num, *np.r_[edges, edges[:, ::-1]].T, weight=np.r_[mu, mu]))
    # A node that neither a section nor an edge holds would make the matrix singular.
    own = np.bincount(corners.node, corners.weight, num) + 1e-12
    solve, blocks = linalg.splu(sparse.csc_matrix(membrane + sparse.diags(own))).solve, []
    for rows in np.array_split(np.arange(num), num // 256 + 1):  # the matrix is symmetric; in blocks, to save memory
        block = solve(np.equal.outer(np.arange(num), rows).astype(float)).T[:, corners.node] * corners.weight
        block[is_held[rows, None] | (block <= LEAST_SHARE * block.max(axis=1, keepdims=True, initial=0.0))] = 0.0
        blocks.append(sparse.csr_array(block / np.maximum(block.sum(axis=1, keepdims=True), 1e-300)))
    return sparse.csr_array(sparse.vstack(blocks))


def _turning(surface: BoundSurface, num: int, corners: BoundCorners, a: Any, offset: np.ndarray) -> sparse.csr_array:
    """The matrix b (N, V) with b V = F o, for the offsets o (N, 3) of the nodes."""
    shape, section = surface.solid.shape, corners.section
    place = shape.vertices[corners.tail]
    place = place + corners.part[:, None] * (shape.vertices[corners.head] - place)
    # A frame is fitted to a few corners of each section, evenly chosen.
    step = -(-np.bincount(section) // FRAME_CORNERS)[section]
    chosen = np.flatnonzero((np.arange(len(section)) - np.searchsorted(section, section)) % step == 0)
    section = section[chosen]
    share = 1 / np.bincount(section)[section]
    spread = sparse.csr_array((share, (section, chosen)), shape=(len(corners.node), len(place)))
    weight = sparse.coo_array(a @ spread)  # (N, C) weight of every corner in a node's frame
    row, corner = weight.coords
    away = place[corner] - (weight @ place)[row]
    moments = np.zeros((len(offset), 3, 3))
    np.add.at(moments, row, weight.data[:, None, None] * away[:, :, None] * away[:, None, :])
    # Along axes where S has hardly an eigenvalue, o stays as recorded.
    lever = np.einsum("nij,nj->ni", np.linalg.pinv(moments, rcond=RESOLUTION, hermitian=True), offset)
    omega = sparse.csr_array((weight.data * np.einsum("ci,ci->c", away, lever[row]), (row, corner)), shape=weight.shape)
    each, part = np.arange(len(place)), corners.part
    ends = np.r_[1 - part, part], (np.r_[each, each], surface.vertex[np.r_[corners.tail, corners.head]])
    return sparse.csr_array(omega @ sparse.csr_array(ends, shape=(len(place), num)))
