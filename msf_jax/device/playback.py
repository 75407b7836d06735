"""The replay of one component's flow from its tape: recorded decisions, geometry computed anew, one JAX program.

Each iteration is a step of a `lax.scan`: contract and smooth, apply the recorded collapses and splits, and gather the
rows of the next iteration. Each of the run's loose solves left a residual r |b| of A x = b, and the tape has r. The
replay solves A x = b - r |b| tightly, for the same x with the derivatives of an exact solve.
"""

from functools import partial
from typing import Any

import jax
import jax.numpy as jnp
from jax import lax

from msf_jax.base.decisions import Mixing, Part, Polynomial, Stretch
from msf_jax.base.layout import Layout
from msf_jax.base.options import SolverOptions, StepSettings, Weights
from msf_jax.device.buffers import Buffers, Rings
from msf_jax.device.cg import keeps_solutions
from msf_jax.device.iteration import move


@partial(jax.jit, static_argnames=("layouts", "laplacian", "max_steps"))
def replay_part(
    part: Part,
    weights: Weights,
    vertices: jax.Array,
    moved: jax.Array,
    tolerance: Any,
    layouts: tuple[Layout, ...],
    laplacian: str,
    max_steps: int,
) -> tuple[jax.Array, jax.Array]:
    """Meso-skeleton (m, 3) and nodes (N, 3) of a component, in the caller's units, for ``weights``, scalars or (V,),
    ``vertices`` (V, 3) of the caller's mesh, and ``moved`` (V, 3), their displacement from the recorded ones. One
    program serves every ``tolerance``, the relative residual of the solves. ``layouts``: of the stretches.

    Differentiable in: weights, vertices together with moved.
    """
    solver = SolverOptions(tolerance=tolerance, step_tolerance=0.0, max_steps=max_steps)
    settings = StepSettings(laplacian, solver, w_H_follows_area=False)
    start = jnp.asarray(part.vertices) + (moved[part.vertex_of_input] / part.diagonal) @ part.axes.T
    workspace, sites = _first_rows(part, weights, start)
    poles = _poles(part, sites)
    for stretch, layout in zip(part.stretches, layouts, strict=True):
        workspace = _replay_stretch(stretch, poles, workspace[stretch.start], layout, settings)
    meso, num = workspace[part.meso_row, :3], len(part.is_held)
    meso, nodes = (part.centre[None] + part.diagonal * (x @ part.axes) for x in (meso, _mixed(part.nodes, meso, num)))
    return meso, jnp.where(part.is_held[:, None], _mixed(part.pins, vertices, num), nodes)


def _first_rows(part: Part, weights: Weights, start: jax.Array) -> tuple[jax.Array, jax.Array]:
    """Position and weights (n, 3 + 4) of the rows at the start of the flow, and the sites of their poles (n, 3)."""
    if part.mesh_filter is not None:
        start = jnp.where(part.is_pin[:, None], start, _filtered(part.mesh_filter, start))
    values = [jnp.asarray(weight, start.dtype) for weight in vars(weights).values()]
    values = [jnp.broadcast_to(value[part.vertex_of_input] if value.ndim else value, len(start)) for value in values]
    rows = _mixed(part.gather, jnp.concatenate([start, jnp.stack(values, axis=1)], axis=1), len(part.tetrahedron))
    return rows, rows[:, :3] if part.site_filter is None else _filtered(part.site_filter, rows[:, :3])


def _mixed(mixing: Mixing, values: jax.Array, num: int) -> jax.Array:
    return jax.ops.segment_sum(mixing.share[:, None] * values[mixing.column], mixing.row, num)


def _filtered(kept: Any, x: jax.Array) -> jax.Array:
    if not isinstance(kept, Polynomial):
        return kept @ (kept.T @ x)
    degree = jnp.asarray(kept.degree, x.dtype)[:, None]
    used = (jnp.arange(kept.neighbour.shape[1]) < degree).astype(x.dtype)[:, :, None]

    def cosine(y: jax.Array) -> jax.Array:
        return y - 2 / kept.top * (degree * y - (used * y[kept.neighbour]).sum(axis=1))

    def term(carry: tuple[jax.Array, ...], share: jax.Array) -> tuple[tuple[jax.Array, ...], None]:
        before, now, total = carry
        return (now, 2 * cosine(now) - before, total + share * now), None

    return lax.scan(term, (cosine(x), x, jnp.zeros_like(x)), jnp.asarray(kept.share, x.dtype))[0][2]


def _poles(part: Part, sites: jax.Array) -> jax.Array:
    """The poles (n, 3): circumcentres c of their tetrahedra, c - p = (|a|^2 b x c + ...) / (2 a . b x c); where that is
    ill-conditioned, the pole moves with the mean of the sites."""
    corner = sites[part.tetrahedron]
    a, b, c = (corner[:, k] - corner[:, 0] for k in (1, 2, 3))
    bc, ca, ab = jnp.cross(b, c), jnp.cross(c, a), jnp.cross(a, b)
    square_a, square_b, square_c = ((edge * edge).sum(1, keepdims=True) for edge in (a, b, c))
    is_firm = part.is_firm[:, None]
    determinant = jnp.where(is_firm, (a * bc).sum(1, keepdims=True), 1.0)
    centre = corner[:, 0] + (square_a * bc + square_b * ca + square_c * ab) / (2 * determinant)
    offset = jnp.asarray(part.offset, corner.dtype)
    turned = offset[:, :1] * a + offset[:, 1:2] * b + offset[:, 2:] * c
    return jnp.where(is_firm, centre + turned, corner.mean(axis=1) + offset)


def _replay_stretch(
    stretch: Stretch, poles: jax.Array, rows: jax.Array, layout: Layout, settings: StepSettings
) -> jax.Array:
    """The workspace (n + R M, 7) after the iterations of ``stretch``: position and weights of rows and of new rows."""
    fresh = jnp.zeros((stretch.cut[0, :, :, 0].size, rows.shape[1]), rows.dtype)

    def iteration(workspace: jax.Array, line: Any) -> tuple[jax.Array, None]:
        rows = workspace[line.enter]
        dtype = rows.dtype
        buffers = Buffers(
            positions=rows[:, :3],
            rings=Rings(*line.rings),
            degree=jnp.asarray(line.degree, dtype),
            free=jnp.asarray(line.free, dtype),
            poles=poles[line.site],
            pull=jnp.asarray(line.pull, dtype),
            t_c=jnp.zeros((), dtype),  # solve to the tolerance
            area=jnp.ones(layout.capacity, dtype),
        )
        weights = Weights(rows[:, 3] * line.factor, rows[:, 4], rows[:, 5], rows[:, 6])
        moved = move(buffers, weights, settings, layout, jnp.asarray(line.left, dtype))
        positions = jnp.where(moved.solves.has_ended.all(), moved.positions, jnp.nan)
        parts = line.share[:, None] * jnp.concatenate([positions, rows[:, 3:]], axis=1)
        rows = jax.ops.segment_sum(parts, line.group, layout.capacity)
        return _cut(jnp.concatenate([rows, fresh]), line.cut, layout.capacity), None

    # Reverse mode stores the workspace and the two solutions of every iteration, and recomputes the rest.
    live, idle = jax.checkpoint(iteration, policy=keeps_solutions), lambda workspace, _: (workspace, None)
    either = lambda workspace, line: lax.cond(line.factor > 0, live, idle, workspace, line)  # noqa: E731
    return lax.scan(either, jnp.concatenate([rows, fresh]), stretch._replace(start=None))[0]


def _cut(workspace: jax.Array, cut: jax.Array, first: int) -> jax.Array:
    """Apply rounds of splits (R, M, 3): each adds a row, from ``first`` on, where the apex projects on the edge."""

    def one_round(workspace: jax.Array, line: tuple[jax.Array, jax.Array]) -> tuple[jax.Array, None]:
        edges, place = line
        a, b, apex = (workspace[edges[:, k]] for k in range(3))
        along = b[:, :3] - a[:, :3]
        length2 = (along * along).sum(1)
        length2 = jnp.where(length2 > 0, length2, 1.0)  # it is 0 in padding
        fraction = (((apex[:, :3] - a[:, :3]) * along).sum(1) / length2)[:, None]
        return lax.dynamic_update_slice(workspace, (1 - fraction) * a + fraction * b, (place, 0)), None

    places = first + cut.shape[1] * jnp.arange(cut.shape[0])
    return lax.scan(one_round, workspace, (cut, places))[0]
