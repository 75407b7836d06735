"""The nearest triangle of a moved surface for many points, and the side of the surface that they are on.

Triangles are stored in runs of neighbours, mesh by mesh. Runs whose bounding ball, of the moved corners, is farther
from a point than a known triangle of its mesh are skipped. So the result is exact for every motion, although few
triangles are tested. The nearest triangle is held fixed in derivatives.

The side follows from the pseudonormal of the nearest face, edge or corner (Baerentzen and Aanaes 2005): the sum of the
normals around it, at a corner weighted by angles. It is exact for a closed surface that does not cross itself.
"""

import jax
import jax.numpy as jnp
from jax import lax

from msf_jax.base.binding import FACES_TOGETHER, Binding
from msf_jax.device.laplacian import norm, squared

TOGETHER = 512  # runs that are looked at together: bounds memory
AT_ONCE = 128  # points that are looked at together, of few meshes, and pairs of a point and a run tested in one step
ROUNDING = 16  # rounding errors (machine epsilons) that are subtracted from a lower bound of a distance


def signed_distances(binding: Binding, points: jax.Array, vertices: jax.Array) -> jax.Array:
    """Signed distance (N,) of the nodes at ``points`` (N, 3) to the wall at ``vertices`` (V, 3), negative outside.

    Differentiable in: points, vertices; the gradient of a point on an edge is 0.
    """
    frozen = lax.stop_gradient((points, vertices))
    face = nearest_faces(binding, *frozen)
    triangles = vertices[binding.faces[face]]
    to_edge = norm(_from_edges(points, triangles)[0]).min(-1)
    is_over, height, area2 = _over(points, triangles)
    by_edge = jnp.where(_is_inside(binding, *frozen, face), to_edge, -to_edge)
    return jnp.asarray(binding.side, points.dtype) * jnp.where(is_over, -height / jnp.sqrt(area2), by_edge)


def nearest_faces(binding: Binding, points: jax.Array, vertices: jax.Array) -> jax.Array:
    """(N,) the face of the wall nearest to each of ``points`` (N, 3), the first of several; any for NaN and padding."""
    size, dtype = FACES_TOGETHER, points.dtype
    corners = vertices[binding.faces]
    corners = jnp.concatenate([corners, jnp.broadcast_to(corners[-1:], (-len(corners) % size, 3, 3))])
    runs = corners.reshape(-1, 3 * size, 3)
    low, high = runs.min(1), runs.max(1)
    centre = (low + high) / 2
    radius = jnp.sqrt(((runs - centre[:, None]) ** 2).sum(-1).max(1))
    runs = corners.reshape(-1, size, 3, 3)
    is_wall = jnp.pad(jnp.asarray(binding.is_wall), (0, len(corners) - len(binding.faces)))
    window = min(TOGETHER, len(runs))
    # Of several meshes, a point is nearest to a face of its own, from ``first`` to before ``stop``; padding has none.
    per_mesh = jnp.asarray(binding.live.faces).astype(jnp.int32)
    ends = jnp.cumsum(per_mesh).reshape(per_mesh.shape)
    first, stop = (jnp.broadcast_to(binding.spread(x, "nodes"), len(points)) for x in (ends - per_mesh, ends))
    first, stop = (jnp.where(binding.node_mask, x, none) for x, none in ((first, len(corners)), (stop, 0)))

    def of_some(given: tuple[jax.Array, ...]) -> jax.Array:
        points, first, stop = given
        num = len(points)

        def smallest(point: jax.Array, run: jax.Array) -> tuple[jax.Array, jax.Array]:
            faces = size * run[:, None] + jnp.arange(size, dtype=jnp.int32)
            is_own = (first[point, None] <= faces) & (faces < stop[point, None]) & is_wall[faces]
            triangles, of = runs[run], points[point][:, None]
            is_over, height, area2 = _over(of, triangles)
            away = jnp.where(is_over, height * height / area2, squared(_from_edges(of, triangles)[0]).min(-1))
            away = jnp.where(is_own, away, jnp.inf)
            return away.min(axis=1), size * run + away.argmin(axis=1).astype(jnp.int32)

        def test_window(state: tuple[jax.Array, ...]) -> tuple[jax.Array, ...]:
            at, best, face = state
            # In the last window, runs after the last are the last again, which changes nothing.
            run = jnp.minimum(at + jnp.arange(window, dtype=jnp.int32), len(runs) - 1)
            is_own = (size * run < stop[:, None]) & (size * run + size > first[:, None])
            away = jnp.sqrt(((points[:, None] - centre[run]) ** 2).sum(-1))
            bound = away - radius[run] - ROUNDING * jnp.finfo(dtype).eps * (away + radius[run])
            bound = jnp.where(is_own, jnp.maximum(bound, 0.0), jnp.inf)
            # Of two meshes one run may have a large ball around both, whose far side is not near.
            near = run[jnp.where(is_own, away + radius[run], jnp.inf).argmin(axis=1)]
            some = jnp.minimum(best, smallest(jnp.arange(num), near)[0])
            # Pairs of a point and a run that may contain its nearest face, numbered, and tested ``AT_ONCE``.
            is_near = (bound * bound <= some[:, None]) & (bound < jnp.inf)
            pair = jnp.cumsum(is_near.ravel().astype(jnp.int32))

            def test_pairs(state: tuple[jax.Array, ...]) -> tuple[jax.Array, ...]:
                done, best, face = state
                number = jnp.searchsorted(pair, done + 1 + jnp.arange(AT_ONCE, dtype=jnp.int32))
                number = jnp.minimum(number, len(pair) - 1)  # testing the last pair again changes nothing
                point = number // window
                away, which = smallest(point, run[number % window])
                least = jnp.minimum(best, jax.ops.segment_min(away, point, num, indices_are_sorted=True))
                which = jnp.where(away == least[point], which, len(corners))
                which = jax.ops.segment_min(which, point, num, indices_are_sorted=True)
                return done + AT_ONCE, least, jnp.where(least < best, which, face)

            state = 0 * pair[-1], best, face
            return at + window, *lax.while_loop(lambda state: state[0] < pair[-1], test_pairs, state)[1:]

        none = 0 * ((points[:, 0] > radius[0]) + first)  # no constant: it varies between devices, as the state will
        state = first.min() // size, jnp.full(num, jnp.inf, dtype) + none, first + none
        return lax.while_loop(lambda state: size * state[0] < stop.max(), test_window, state)[2]

    parts = -(-len(points) // AT_ONCE)
    rows = jnp.arange(parts * -(-len(points) // parts), dtype=jnp.int32)
    rows = jnp.minimum(rows, len(points) - 1).reshape(parts, -1)  # the last point again, so that parts are alike
    found = lax.map(of_some, (points[rows], first[rows], stop[rows])).ravel()[: len(points)]
    return jnp.minimum(found, ends.max() - 1)  # padding repeats the last face


def _from_edges(points: jax.Array, triangles: jax.Array) -> tuple[jax.Array, jax.Array]:
    """The vectors (..., 3, 3) to each of ``points`` (..., 3) from the nearest points on the edges of its triangle
    (..., 3, 3), and the fractions (..., 3) of the edges where these are."""
    along = jnp.roll(triangles, -1, axis=-2) - triangles
    offset = points[..., None, :] - triangles
    length2 = squared(along)
    share = jnp.clip((offset * along).sum(-1) / jnp.where(length2 > 0, length2, 1.0), 0.0, 1.0)
    return offset - share[..., None] * along, share


def _over(points: jax.Array, triangles: jax.Array) -> tuple[jax.Array, jax.Array, jax.Array]:
    """(...,) whether each of ``points`` (..., 3) projects into its triangle (..., 3, 3), its height over the plane
    times twice the area, and the square of twice the area, or 1 without an area. Normals point out of the solid."""
    along = jnp.roll(triangles, -1, axis=-2) - triangles
    offset = points[..., None, :] - triangles
    normal = jnp.cross(along[..., 0, :], along[..., 1, :])
    area2 = squared(normal)
    is_over = ((jnp.cross(along, offset) * normal[..., None, :]).sum(-1) >= 0).all(-1) & (area2 > 0)
    return is_over, (offset[..., 0, :] * normal).sum(-1), jnp.where(area2 > 0, area2, 1.0)


def _is_inside(binding: Binding, points: jax.Array, vertices: jax.Array, face: jax.Array) -> jax.Array:
    """(N,) whether each point is inside, by the pseudonormal of the nearest edge or corner of its ``face`` (N,)."""
    aways, shares = _from_edges(points, vertices[binding.faces[face]])
    rows = jnp.arange(len(points))
    edge = squared(aways).argmin(axis=1)
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
        normal, cosine = jnp.cross(onward - middle, back - middle), ((onward - middle) * (back - middle)).sum(-1)
        angle = jnp.arctan2(jnp.sqrt(squared(normal)), cosine)
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
    length2 = squared(normal)[:, None]
    return jnp.where(length2 > 0, normal / jnp.sqrt(jnp.where(length2 > 0, length2, 1.0)), 0.0)
