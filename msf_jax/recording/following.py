"""Record the binding of a finished curve to its mesh, so that the curve can follow moving vertices.

A node follows the cross-sections of its limb, in whose middle centring put it. Their corners are stored as fractions of
mesh edges, so a section moves, turns and bulges with the surface. Along a branch, the centroids c are smoothed by the
energy of `centring`, with its weights w and its stiffness alpha at the recorded curve. There are three differences:
wide sections count less everywhere, not in loops only; w also acts along the branch, so nodes go with a limb that is
stretched; and a membrane mu carries along the nodes without a section:

    minimise  sum_i w_i |x_i - c_i|^2  +  sum alpha_i |x_{i-1} - 2 x_i + x_{i+1}|^2  +  sum_ij mu_ij |x_i - x_j|^2.

So x = a c with a constant matrix a, whose rows sum to one. In a sheet, a node can be far from every section. There c is
the mean of the vertices of the node and its neighbours. The remainder o = x - a c at the recorded mesh is carried in a
frame of each node: the affine map F that best fits how the corners of the sections around it have moved. F o is linear
in the vertices, F = C / S with

    C = sum_k beta_k (p_k - p_mean) (q_k - q_mean)^T,   S = the same with p = q,   q the recorded corners,

so it is a matrix b times the vertices. Both a and b reproduce every affine map of the mesh exactly. A pinned node has
only the mean of its pins, as its row of b.
"""

from typing import Any, NamedTuple

import numpy as np
from scipy import sparse
from scipy.sparse import csgraph, linalg

from msf_jax.base.binding import FACES_TOGETHER, Binding, Sizes
from msf_jax.curve import branches as measures
from msf_jax.curve import centring
from msf_jax.curve.branches import BranchPath
from msf_jax.solid import openings, sections
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import cross, together, unit, vertex_normals
from msf_jax.solid.solid import Solid
from msf_jax.topology import graphs

SLIGHT = 0.02  # least weight w of a section; sections of less are left out
# Vertices: least number in a cloud. Limb sizes: distance along the curve from every section, beyond which a node needs
# a cloud. Ratio of the noise of a node's offset to that of the vertices, above which a node needs a cloud.
FEWEST_IN_CLOUD, FAR_FROM_SECTIONS, LEVER = 4, 3.0, 0.5
MEMBRANE = 0.01  # mu = MEMBRANE (size / h)^2, for nodes h apart in a limb of that size
FRAME_REACH = 1.0  # limb sizes along the branch over which a frame is fitted
FRAME_CORNERS = 12  # corners of each section that a frame is fitted to
LEAST_EIGENVALUE = 1e-6  # eigenvalues of S over the largest: along axes of smaller ones, o stays as recorded
# Shares of a row's largest entry: smaller entries of the smoothings are left out.
SMALLEST_ENTRIES = {"a": 1e-3, "b": 2e-2}
NOTHING = 1e-6  # entries of a solved block below this are left out at once, to save memory


class BoundSurface(NamedTuple):
    """The mesh that a curve is bound to.

    solid: the checked mesh. vertex: (v,) the caller's number of each vertex of the solid. node: (v,) its node.
    """

    solid: Solid
    vertex: np.ndarray
    node: np.ndarray

    def given(self, num: int) -> np.ndarray:
        """The ``num`` vertices of the caller's mesh; vertices in no face have no effect, and are at 0."""
        vertices = np.zeros((num, 3))
        vertices[self.vertex] = self.solid.leave(self.solid.shape.vertices)
        return vertices


class BoundCorners(NamedTuple):
    """The corners (C,) of S sections, one section after the other; section: (C,); tail, head, part: `sections.Corners`.

    is_loop: (S,) False for a cloud. centroid: (S, 3). area: (S,). node: (S,). weight: (S,) w.
    """

    section: np.ndarray
    tail: np.ndarray
    head: np.ndarray
    part: np.ndarray
    is_loop: np.ndarray
    centroid: np.ndarray
    area: np.ndarray
    node: np.ndarray
    weight: np.ndarray


def record(
    surface: BoundSurface, num: int, vertices: np.ndarray, edges: np.ndarray, pins_of_node: dict[int, np.ndarray]
) -> Binding:
    """The binding of the curve ``(vertices (N, 3), edges (E, 2))``, in the caller's units, to ``surface``; not padded.

    ``num``: number of the caller's vertices. ``pins_of_node``: for each pinned node, the vertices whose mean it is.
    """
    shape, x = surface.solid.shape, surface.solid.enter(vertices)
    inside = shape.contains(x)
    distance, nearest = shape.nearest(x)
    radii = np.where(inside, distance, 0.0)
    is_held = np.zeros(len(x), dtype=bool)
    is_held[list(pins_of_node)] = True
    is_free = np.where(is_held, 0.0, 1.0)
    paths = measures.paths_of(x, edges, is_held)
    size = _sections(surface.solid, x, edges, paths, radii, radii, nearest, is_held)[1]
    found, size = _sections(surface.solid, x, edges, paths, radii, size, nearest, is_held)

    def matrices(is_lost: np.ndarray) -> tuple[BoundCorners, Any, Any]:
        corners = _with_clouds(surface, edges, found, is_lost)
        a = _smoothing(x, edges, paths, size, corners, stiffness=centring.STIFFNESS, membrane=MEMBRANE)
        beta = _smoothing(
            x, edges, paths, _wide(surface, size, corners), corners, stiffness=0.0, membrane=FRAME_REACH**2
        )
        a = _pruned(sparse.diags(is_free) @ a, SMALLEST_ENTRIES["a"])
        offset = is_free[:, None] * (x - a @ corners.centroid)
        return corners, a, _turning(surface, corners, _pruned(beta, SMALLEST_ENTRIES["b"]), offset)

    is_lost = _far(x, edges, size, found.node)
    corners, a, b = matrices(is_lost)
    is_noisy = np.asarray(b.multiply(b).sum(axis=1)).ravel() > LEVER**2
    if (is_noisy & ~is_lost).any():
        corners, a, b = matrices(is_lost | is_noisy)
    pin = sparse.lil_matrix(b.shape)
    for node, pins in pins_of_node.items():
        pin[node, pins] = 1 / len(pins)
    b = (b + pin).tocsr()
    placed = np.zeros((b.shape[1], 3))
    placed[surface.vertex] = shape.vertices
    rest = x - a @ corners.centroid - b @ placed
    order = np.arange(len(corners.section))
    is_last = np.r_[corners.section[1:] != corners.section[:-1], True]
    onward = np.where(is_last, np.searchsorted(corners.section, corners.section), order + 1)
    count = np.bincount(corners.section, minlength=len(corners.node))
    a, b = a.tocoo(), b.tocoo()
    unit_of_length = 2.0 ** np.round(np.log2(surface.solid.diagonal))
    scale = surface.solid.diagonal / unit_of_length
    order_of_faces = together(shape.centroids, FACES_TOGETHER)
    rank = np.argsort(order_of_faces)
    twin = shape.mesh.twins.reshape(-1, 3)[order_of_faces]
    return Binding(
        live=Sizes(
            vertices=num,
            faces=len(shape.faces),
            nodes=len(x),
            edges=len(edges),
            sections=len(corners.node),
            corners=len(corners.section),
            smoothing=a.nnz,
            turning=b.nnz,
        ),
        tail=surface.vertex[corners.tail],
        head=surface.vertex[corners.head],
        part=corners.part,
        onward=onward,
        section=corners.section,
        share=1 / count[corners.section],
        is_loop=corners.is_loop,
        area=scale**2 * corners.area,
        node=corners.node,
        a_row=a.row,
        a_column=a.col,
        a_value=a.data,
        b_row=b.row,
        b_column=b.col,
        b_value=b.data,
        rest=scale * rest,
        faces=surface.vertex[shape.faces[order_of_faces]],
        twin=3 * rank[twin // 3] + twin % 3,
        side=np.where(_is_behind(shape, x, nearest) == inside, 1.0, -1.0),
        edges=edges,
        branch=_branches(len(x), edges),
        centre=surface.solid.centre,
        diagonal=np.float64(surface.solid.diagonal),
        unit=unit_of_length,
    )


def _sections(
    solid: Solid,
    x: np.ndarray,
    edges: np.ndarray,
    paths: list[BranchPath],
    radii: np.ndarray,
    size: np.ndarray,
    nearest: np.ndarray,
    is_held: np.ndarray,
) -> tuple[BoundCorners, np.ndarray]:
    """The sections that go around nodes, with weights as in `centring` in loops, and the size (N,) of the nodes' limbs.

    Nodes in a sheet would move as much as its vertices by noise if wide sections counted.

    ``size`` (N,) is an estimate of the latter. Sections that the lid of an opening cuts off are left out.
    """
    shape = solid.shape
    degree = np.bincount(edges.ravel(), minlength=len(x))
    tangent = unit(measures.chords(x, paths, size) @ x) if paths else np.zeros_like(x)
    clear = measures.clear_of_junctions(x, paths, degree, size, centring.ZONE, centring.MARGIN)
    is_whole = (openings.moved_inside(x, tangent, solid.openings) == x).all(axis=1)
    limb = np.flatnonzero((degree > 0) & (clear > 0) & ~is_held & (radii > 0) & tangent.any(axis=1) & is_whole)
    corners = sections.corners(shape, x[limb], tangent[limb], size[limb], nearest[limb])
    found = sections.measured(shape, x[limb], tangent[limb], corners)
    is_good = found.is_around
    node, found = limb[is_good], sections.Sections(*(field[is_good] for field in found))
    weight, everywhere = centring.weighed(paths, clear, node, found, SLIGHT, np.ones(len(x), dtype=bool))
    size = measures.sizes(x, paths, *everywhere, clearance=radii)
    centroid, radius = found.centroid, found.radius
    weight /= (1 + (np.linalg.norm(x[node] - centroid, axis=1) / (centring.STRAY * radius)) ** 2) ** 2
    is_one = weight > SLIGHT
    node, centroid, weight = node[is_one], centroid[is_one], weight[is_one]
    is_good[is_good] = is_one
    kept = is_good[corners.loop]
    section = (np.cumsum(is_good) - 1)[corners.loop[kept]]
    tail, head, part = corners.tail[kept], corners.head[kept], corners.part[kept]
    area = sections.areas(shape, corners, tangent[limb])[is_good]
    return BoundCorners(section, tail, head, part, np.ones(len(node), dtype=bool), centroid, area, node, weight), size


def _far(x: np.ndarray, edges: np.ndarray, size: np.ndarray, node: np.ndarray) -> np.ndarray:
    """(N,) whether each node is far along the curve from every ``node`` (S,) that has a section."""
    if not len(node):
        return np.ones(len(x), dtype=bool)
    graph = graphs.weighted(len(x), *edges.T, weight=graphs.lengths(x, edges))
    return csgraph.dijkstra(graph, directed=False, indices=node, min_only=True) > FAR_FROM_SECTIONS * size


def _with_clouds(surface: BoundSurface, edges: np.ndarray, found: BoundCorners, is_lost: np.ndarray) -> BoundCorners:
    """Add a cloud for each node with ``is_lost`` (N,): the vertices of the node and its neighbours, if they are enough.

    A component of the curve with fewer than two sections and clouds gets a cloud of all its vertices."""
    num, many = len(is_lost), len(surface.node)
    graph: Any = graphs.weighted(num, *edges.T)
    component = graphs.labels(num, *edges.T)
    went = sparse.csr_matrix((np.ones(many), (surface.node, np.arange(many))), shape=(num, many))
    went = sparse.csr_matrix((graph + graph.T + sparse.eye(num)) @ went)
    lost = np.flatnonzero(is_lost & (np.diff(went.indptr) >= FEWEST_IN_CLOUD))
    clouds = [(node, np.sort(went[node].indices)) for node in lost]
    count = np.bincount(component[np.r_[found.node, lost]], minlength=component.max() + 1)
    for number in np.flatnonzero(count < 2):
        clouds.append((np.flatnonzero(component == number)[0], np.flatnonzero(component[surface.node] == number)))
    for node, cloud in clouds:
        if not len(cloud):
            continue
        found = BoundCorners(
            np.r_[found.section, np.full(len(cloud), len(found.node))],
            np.r_[found.tail, cloud],
            np.r_[found.head, cloud],
            np.r_[found.part, np.zeros(len(cloud))],
            np.r_[found.is_loop, False],
            np.concatenate([found.centroid, surface.solid.shape.vertices[cloud].mean(axis=0)[None]]),
            np.r_[found.area, 0.0],
            np.r_[found.node, node],
            np.r_[found.weight, 1.0],
        )
    return found


def _wide(surface: BoundSurface, size: np.ndarray, corners: BoundCorners) -> np.ndarray:
    """``size`` (N,), at least the RMS distance of a cloud's vertices from their mean for a node with a cloud."""
    rows = np.flatnonzero(~corners.is_loop[corners.section])
    away2 = ((surface.solid.shape.vertices[corners.tail[rows]] - corners.centroid[corners.section[rows]]) ** 2).sum(1)
    wide2 = np.bincount(corners.section[rows], away2, len(corners.node)) / np.maximum(
        np.bincount(corners.section[rows], minlength=len(corners.node)), 1
    )
    size = size.copy()
    np.maximum.at(size, corners.node, np.sqrt(wide2))
    return size


def _smoothing(
    x: np.ndarray,
    edges: np.ndarray,
    paths: list[BranchPath],
    size: np.ndarray,
    corners: BoundCorners,
    *,
    stiffness: float,
    membrane: float,
) -> sparse.csr_matrix:
    """The matrix (N, S) from centroids to the nodes that minimise the energy in the module's docstring."""
    num = len(x)
    size = np.maximum(size, 1e-3)  # diagonals: a thinner limb is as stiff as one of that size
    gather: Any = sparse.coo_matrix(
        (corners.weight, (corners.node, np.arange(len(corners.node)))), shape=(num, len(corners.node))
    ).tocsc()
    matrix = sparse.diags(np.asarray(gather.sum(axis=1)).ravel())
    a, b = edges[:, 0], edges[:, 1]
    gap = np.maximum(np.linalg.norm(x[a] - x[b], axis=1), 1e-9)  # diagonals: nodes in one place
    mu = membrane * np.minimum(np.minimum(size[a], size[b]) / gap, 1e3) ** 2
    rows = np.repeat(np.arange(len(edges)), 2)
    along_edge = sparse.coo_matrix((np.tile([1.0, -1.0], len(edges)), (rows, edges.ravel())), shape=(len(edges), num))
    matrix = matrix + along_edge.T @ sparse.diags(mu) @ along_edge
    if stiffness:
        bend, alpha, _ = measures.bending(x, paths, stiffness * size)
        matrix = matrix + bend.T @ sparse.diags(alpha) @ bend
    # A node that neither a section nor an edge holds would make the matrix singular.
    solve = linalg.splu((matrix + 1e-12 * sparse.eye(num)).tocsc())
    # Blocks of sections save memory: entries of nodes far from a section are tiny, and are left out at once.
    blocks = []
    for first in range(0, gather.shape[1], 256):
        block = solve.solve(gather[:, first : first + 256].toarray())
        block[np.abs(block) < NOTHING] = 0.0
        blocks.append(sparse.csr_matrix(block))
    return sparse.csr_matrix(sparse.hstack(blocks)) if blocks else sparse.csr_matrix((num, 0))


def _pruned(matrix: Any, smallest: float) -> sparse.csr_matrix:
    """The matrix without tiny entries, and with rows scaled to a sum of one; empty rows stay empty."""
    matrix = sparse.csr_matrix(matrix)
    row = np.repeat(np.arange(matrix.shape[0]), np.diff(matrix.indptr))
    largest = np.zeros(matrix.shape[0])
    np.maximum.at(largest, row, np.abs(matrix.data))
    matrix.data[np.abs(matrix.data) <= smallest * largest[row]] = 0.0
    matrix.eliminate_zeros()
    total = np.asarray(matrix.sum(axis=1)).ravel()
    return sparse.csr_matrix(sparse.diags(1 / np.where(total == 0, 1.0, total)) @ matrix)


def _turning(surface: BoundSurface, corners: BoundCorners, beta: Any, offset: np.ndarray) -> sparse.csr_matrix:
    """The matrix b (N, V) with b V = F o, for ``offset`` (N, 3) o; ``beta`` (N, S) has the sections' weights in F."""
    shape, num = surface.solid.shape, len(corners.section)
    place = shape.vertices[corners.tail]
    place = place + corners.part[:, None] * (shape.vertices[corners.head] - place)
    count = np.bincount(corners.section, minlength=len(corners.node))
    # A frame is fitted to a few corners of each section, evenly chosen.
    rank = np.arange(num) - np.searchsorted(corners.section, corners.section)
    most = np.minimum(count, FRAME_CORNERS)[corners.section]
    chosen = np.flatnonzero((rank + 1) * most // count[corners.section] > rank * most // count[corners.section])
    section = corners.section[chosen]
    share = 1 / np.bincount(section, minlength=len(corners.node))[section]
    spread = sparse.coo_matrix((share, (section, chosen)), shape=(len(corners.node), num))
    weight: Any = (beta @ spread).tocoo()  # (N, C) weight of every corner in a node's frame
    row, corner = weight.row, weight.col
    mean = weight @ place
    away = place[corner] - mean[row]
    moments = np.zeros((len(offset), 3, 3))
    for i in range(3):
        for j in range(3):
            moments[:, i, j] = np.bincount(row, weight.data * away[:, i] * away[:, j], minlength=len(offset))
    lever = np.einsum("nij,nj->ni", np.linalg.pinv(moments, rcond=LEAST_EIGENVALUE, hermitian=True), offset)
    omega = sparse.coo_matrix((weight.data * np.einsum("ci,ci->c", away, lever[row]), (row, corner)), weight.shape)
    ends = sparse.coo_matrix(
        (
            np.r_[1 - corners.part, corners.part],
            (np.tile(np.arange(num), 2), surface.vertex[np.r_[corners.tail, corners.head]]),
        ),
        shape=(num, int(surface.vertex.max()) + 1),
    )
    return sparse.csr_matrix(omega @ ends)


def _is_behind(shape: Enclosure, x: np.ndarray, nearest: np.ndarray) -> np.ndarray:
    """(N,) whether each node is on the inner side of its ``nearest`` triangle (N,), by the pseudonormal of the nearest
    face, edge or corner; see `device.nearest`."""
    triangle = shape.triangles[nearest]
    along, offset = np.roll(triangle, -1, axis=1) - triangle, x[:, None] - triangle
    length2 = np.einsum("nki,nki->nk", along, along)
    t = np.clip(np.einsum("nki,nki->nk", offset, along) / np.where(length2 > 0, length2, 1.0), 0.0, 1.0)
    foot = triangle + t[..., None] * along
    edge = np.linalg.norm(x[:, None] - foot, axis=2).argmin(axis=1)
    rows = np.arange(len(x))
    t, foot = t[rows, edge], foot[rows, edge]
    on_face = shape.normals[nearest]
    is_over = (np.einsum("nki,ni->nk", cross(along, offset), on_face) > 0).all(axis=1)
    on_edge = on_face + shape.normals[shape.mesh.twins[3 * nearest + edge] // 3]
    corner = shape.faces[nearest, np.where(t == 1, (edge + 1) % 3, edge)]
    at_corner = vertex_normals(shape.vertices, shape.faces)[corner]
    normal = np.where(((t == 0) | (t == 1))[:, None], at_corner, on_edge)
    normal, away = np.where(is_over[:, None], on_face, normal), np.where(is_over[:, None], offset[:, 0], x - foot)
    return np.einsum("ni,ni->n", away, normal) <= 0


def _branches(num: int, edges: np.ndarray) -> np.ndarray:
    """(E,) the number of each edge's branch, among the branches of `graphs.trace` that have edges."""
    if not len(edges):
        return np.zeros(0, dtype=np.int64)
    pairs = [
        np.stack([path[:-1], path[1:]], axis=1) for path in map(np.array, graphs.trace(num, edges)) if len(path) > 1
    ]
    branch = np.repeat(np.arange(len(pairs)), [len(pair) for pair in pairs])
    code = np.sort(np.concatenate(pairs), axis=1) @ [num, 1]
    order = np.argsort(code)
    return branch[order[np.searchsorted(code, np.sort(edges, axis=1) @ [num, 1], sorter=order)]]
