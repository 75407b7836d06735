"""The nearest triangle of a moved surface for many points, and the side of the surface that they are on.

Triangles are stored in runs of neighbours. A bounding ball of each run is computed from its moved corners. Runs whose
ball is farther from a point than a known triangle are skipped. So the result is exact for every motion, although only a
small part of the triangles is tested. The nearest triangle is held fixed in derivatives.

The side follows from the pseudonormal of the nearest face, edge or corner (Baerentzen and Aanaes 2005): the sum of the
normals around it, at a corner weighted by angles. It is exact for a closed surface that does not cross itself.
"""

import jax
import jax.numpy as jnp
from jax import lax

from msf_jax.base.binding import FACES_TOGETHER, Binding

MOST_RUNS = 1024  # runs of the shortest length; for more triangles, length and number of runs grow together
AT_ONCE = 1 << 14  # triangles that are tested in one step
ROUNDING = 16  # rounding errors (machine epsilons) that are subtracted from a lower bound of a distance


def signed_distances(binding: Binding, points: jax.Array, vertices: jax.Array) -> jax.Array:
    """Signed distance (N,) of the nodes at ``points`` (N, 3) to the surface at ``vertices`` (V, 3), negative outside.

    Differentiable in: points, vertices; the gradient of a point on an edge is 0.
    """
    frozen = lax.stop_gradient((points, vertices))
    face = nearest_faces(binding, *frozen)
    is_inside = _is_inside(binding, *frozen, face)
    distance = clearance(points, vertices[binding.faces[face]], is_inside)
    return jnp.asarray(binding.side, distance.dtype) * distance


def nearest_faces(binding: Binding, points: jax.Array, vertices: jax.Array) -> jax.Array:
    """(N,) the face nearest to each of ``points`` (N, 3), the first of several; any for NaN and for padding."""
    num, dtype = len(points), points.dtype
    count = binding.faces.shape[0]
    size = FACES_TOGETHER
    while count // size > MOST_RUNS * size // FACES_TOGETHER:
        size *= 2
    count = -(-count // size) * size
    corners = vertices[binding.faces]
    corners = jnp.concatenate([corners, jnp.broadcast_to(corners[-1:], (count - len(corners), 3, 3))])
    runs = corners.reshape(-1, 3 * size, 3)
    low, high = runs.min(1), runs.max(1)
    centre = (low + high) / 2
    radius = jnp.sqrt(((runs - centre[:, None]) ** 2).sum(-1).max(1))
    away = jnp.sqrt(((points[:, None] - centre) ** 2).sum(-1))
    bound = away - radius - ROUNDING * jnp.finfo(dtype).eps * (away + radius)
    # Of several meshes, a point is nearest to a face of its own: one from ``first`` to before ``stop``.
    per_mesh = jnp.asarray(binding.live.faces)
    ends = jnp.cumsum(per_mesh).reshape(per_mesh.shape).astype(jnp.int32)
    first, stop = (jnp.broadcast_to(binding.spread(x, "nodes")[..., None], (num, 1)) for x in (ends - per_mesh, ends))
    start = jnp.arange(len(runs), dtype=jnp.int32) * size
    is_run = (start < stop) & (start + size > first)
    bound = jnp.where(is_run & binding.node_mask[:, None], jnp.maximum(bound, 0.0), jnp.inf)
    runs = corners.reshape(-1, size, 3, 3)

    def smallest(point: jax.Array, run: jax.Array) -> tuple[jax.Array, jax.Array]:
        faces = start[run][:, None] + jnp.arange(size, dtype=jnp.int32)
        is_own = (first[point] <= faces) & (faces < stop[point])
        away = jnp.where(is_own, squared_distances(points[point], runs[run]), jnp.inf)
        return away.min(axis=1), start[run] + away.argmin(axis=1)

    # All pairs of a point and a run that may contain its nearest face, numbered, and tested ``together`` at a time.
    # One of two meshes has a large ball around both, whose far side is not near.
    some, _ = smallest(jnp.arange(num), jnp.where(bound < jnp.inf, away + radius, jnp.inf).argmin(axis=1))
    is_near = (bound * bound <= some[:, None]) & (bound < jnp.inf)  # rows of padding have no pair
    pair = jnp.cumsum(is_near.ravel().astype(jnp.int32))
    together = AT_ONCE // size

    def test_pairs(state: tuple[jax.Array, ...]) -> tuple[jax.Array, ...]:
        done, best, face = state
        number = jnp.searchsorted(pair, done + 1 + jnp.arange(together, dtype=jnp.int32))
        number = jnp.minimum(number, len(pair) - 1)  # testing the last pair again changes nothing
        point, run = number // len(runs), number % len(runs)
        away, which = smallest(point, run)
        least = jnp.minimum(best, jax.ops.segment_min(away, point, num, indices_are_sorted=True))
        which = jnp.where(away == least[point], which, count)
        first = jax.ops.segment_min(which.astype(jnp.int32), point, num, indices_are_sorted=True)
        return done + together, least, jnp.where(least < best, first, face)

    none = 0 * pair[-1]  # not a constant: in a `jax.shard_map` the state must vary from device to device
    far = jnp.full(num, jnp.inf, dtype) + none
    state = (none, far, first[:, 0] + none)
    found = lax.while_loop(lambda state: state[0] < pair[-1], test_pairs, state)[2]
    return jnp.minimum(found, per_mesh.sum(dtype=jnp.int32) - 1)  # padding repeats the last face


def clearance(points: jax.Array, triangles: jax.Array, is_inside: jax.Array) -> jax.Array:
    """Signed distance (N,) from each of ``points`` (N, 3) to its triangle (N, 3, 3), negative outside.

    If the nearest point is inside the triangle, the sign follows from the positions. If it is on an edge or a corner,
    ``is_inside`` (N,) gives the sign.
    Differentiable in: points, triangles; the gradient of a point on an edge is 0.
    """
    best = _square(_from_edges(points, triangles)[0]).min(-1)
    to_edge = jnp.where(best == 0, 0.0, jnp.sqrt(jnp.where(best == 0, 1.0, best)))
    is_over, height, area2 = _over(points, triangles)
    return jnp.where(is_over, -height / jnp.sqrt(area2), jnp.where(is_inside, to_edge, -to_edge))


def squared_distances(points: jax.Array, triangles: jax.Array) -> jax.Array:
    """(P, K) squared distances of each of ``points`` (P, 3) to its ``triangles`` (P, K, 3, 3): to the plane if the
    point projects into the triangle, else to the nearest edge."""
    to_edge = _square(_from_edges(points[:, None], triangles)[0]).min(-1)
    is_over, height, area2 = _over(points[:, None], triangles)
    return jnp.where(is_over, height * height / area2, to_edge)


def _from_edges(points: jax.Array, triangles: jax.Array) -> tuple[jax.Array, jax.Array]:
    """The vectors (..., 3, 3) to each of ``points`` (..., 3) from the nearest points on the edges of its triangle
    (..., 3, 3), and the fractions (..., 3) of the edges where these are."""
    along = jnp.roll(triangles, -1, axis=-2) - triangles
    offset = points[..., None, :] - triangles
    length2 = _square(along)
    share = jnp.clip((offset * along).sum(-1) / jnp.where(length2 > 0, length2, 1.0), 0.0, 1.0)
    return offset - share[..., None] * along, share


def _over(points: jax.Array, triangles: jax.Array) -> tuple[jax.Array, jax.Array, jax.Array]:
    """(...,) whether each of ``points`` (..., 3) projects into its triangle (..., 3, 3), its height over the plane
    times twice the area, and the square of twice the area, or 1 without an area. Normals point out of the solid."""
    along = jnp.roll(triangles, -1, axis=-2) - triangles
    offset = points[..., None, :] - triangles
    normal = jnp.cross(along[..., 0, :], along[..., 1, :])
    area2 = _square(normal)
    is_over = ((jnp.cross(along, offset) * normal[..., None, :]).sum(-1) >= 0).all(-1) & (area2 > 0)
    return is_over, (offset[..., 0, :] * normal).sum(-1), jnp.where(area2 > 0, area2, 1.0)


def _square(vectors: jax.Array) -> jax.Array:
    return (vectors * vectors).sum(-1)


def _is_inside(binding: Binding, points: jax.Array, vertices: jax.Array, face: jax.Array) -> jax.Array:
    """(N,) whether each point is inside, by the pseudonormal of the nearest edge or corner of its ``face`` (N,)."""
    aways, shares = _from_edges(points, vertices[binding.faces[face]])
    rows = jnp.arange(len(points))
    edge = _square(aways).argmin(axis=1)
    away, share = aways[rows, edge], shares[rows, edge]
    corner = jnp.where(share == 1, (edge + 1) % 3, edge)
    first, is_corner = (3 * face + corner).astype(jnp.int32), (share == 0) | (share == 1)
    twin = binding.twin.ravel()
    across = _normals(binding, vertices, first // 3) + _normals(binding, vertices, twin[first] // 3)

    def step(state: tuple[jax.Array, ...]) -> tuple[jax.Array, ...]:
        here, total, is_done, steps = state
        of, corner = here // 3, here % 3
        at = vertices[binding.faces[of]]
        middle, onward, back = (at[rows, (corner + shift) % 3] for shift in (0, 1, 2))
        angle = _angles(onward - middle, back - middle)
        total = jnp.where(is_done[:, None], total, total + angle[:, None] * _normals(binding, vertices, of))
        following = twin[3 * of + (corner + 2) % 3]
        return following.astype(jnp.int32), total, is_done | (following == first), steps + 1

    none = 0 * first[0]  # not a constant, as above
    start = (first, jnp.zeros_like(points) + none, ~is_corner, none)
    around = lax.while_loop(lambda state: ~state[2].all() & (state[3] < len(twin)), step, start)[1]
    normal = jnp.where(is_corner[:, None], around, across)
    return (away * normal).sum(-1) <= 0


def _normals(binding: Binding, vertices: jax.Array, face: jax.Array) -> jax.Array:
    """(P, 3) unit normals of the faces ``face`` (P,); 0 for a face without area."""
    a, b, c = jnp.moveaxis(vertices[binding.faces[face]], 1, 0)
    normal = jnp.cross(b - a, c - a)
    length2 = _square(normal)[:, None]
    return jnp.where(length2 > 0, normal / jnp.sqrt(jnp.where(length2 > 0, length2, 1.0)), 0.0)


def _angles(one: jax.Array, other: jax.Array) -> jax.Array:
    """(P,) angles between pairs of vectors, in radians."""
    normal = jnp.cross(one, other)
    return jnp.arctan2(jnp.sqrt(_square(normal)), (one * other).sum(-1))
