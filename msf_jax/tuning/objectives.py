"""Objectives for `tune`: functions of a curve, 0 at best, that can be added and multiplied by numbers.

    objective = explained() + 0.5 * inside() + 0.1 * smooth()

`tune` also takes any JAX function of ``(nodes, radii)`` that returns a number. The objectives here are in diagonals of
the mesh, or without unit, so that they can be added for meshes of any size. Differentiable in: the nodes and radii of
the curve, with nearest points and edges held fixed.
"""

import inspect
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.gradients import losses
from msf_jax.gradients.losses import norm
from msf_jax.gradients.replay import Tape
from msf_jax.meshes import reading
from msf_jax.skeleton.skeleton import Skeleton

MOST_SAMPLES = 2000  # vertices of a surface that `explained` uses, about


class Placed(NamedTuple):
    """A curve in its surface."""

    nodes: jax.Array  # (N, 3)
    radii: jax.Array  # (N,) distance to the surface, negative outside
    edges: jax.Array  # (E, 2)
    surface: jax.Array  # (V, 3) vertices of the mesh
    areas: jax.Array  # (V,) the area that belongs to each
    node_of_vertex: jax.Array  # (V,)
    diagonal: jax.Array  # of the bounding box


@dataclass(frozen=True)
class Objective:
    """A function from a `Placed` curve to a number; lower is better. ``a + b`` and ``2 * a`` are objectives, too."""

    name: str
    function: Callable[[Placed], jax.Array]

    def __call__(self, curve: Placed) -> jax.Array:
        return self.function(curve)

    def __add__(self, other: "Objective") -> "Objective":
        other = as_objective(other)
        return Objective(f"{self.name} + {other.name}", lambda curve: self(curve) + other(curve))

    def __mul__(self, factor: float) -> "Objective":
        if not isinstance(factor, int | float):
            return NotImplemented
        return Objective(f"{factor:g} * ({self.name})", lambda curve: factor * self(curve))

    __rmul__ = __mul__


def as_objective(objective: Any) -> Objective:
    """An `Objective` unchanged, or an `Objective` made from a function of ``(nodes, radii)``.

    Raises:
        ConfigError: ``objective`` is neither.
    """
    if isinstance(objective, Objective):
        return objective
    try:
        inspect.signature(objective).bind("nodes", "radii")
    except (TypeError, ValueError):
        raise ConfigError(
            f"objective is a {type(objective).__name__}, {objective!r:.80}: expected one of msf_jax.objectives, with "
            "its parentheses, or a function of (nodes, radii)"
        ) from None
    function: Callable[..., Any] = objective
    name = getattr(objective, "__name__", type(objective).__name__)
    return Objective(name, lambda curve: function(curve.nodes, curve.radii))


def of_skeleton(objective: Any, skeleton: Skeleton, mesh: Any) -> float:
    """The ``objective`` of a finished ``skeleton`` of ``mesh``, as `skeletonize` takes it; `tune` reduces this value.

    Raises:
        ConfigError: the skeleton has no source mesh (of files, only `.npz` has one), or ``mesh`` is another mesh.
    """
    surface = reading.read(mesh)[0]
    source = skeleton.known_source
    if len(skeleton.mesh_map) != len(surface):
        raise ConfigError(
            f"mesh has {len(surface)} vertices, the skeleton's has {len(skeleton.mesh_map)}: expected the same mesh"
        )
    objective = as_objective(objective)
    curve = Placed(
        nodes=jnp.asarray(skeleton.vertices),
        radii=jnp.asarray(skeleton.radii),
        edges=jnp.asarray(skeleton.edges),
        surface=jnp.asarray(surface),
        areas=jnp.asarray(source.areas),
        node_of_vertex=jnp.asarray(skeleton.mesh_map),
        diagonal=jnp.asarray(np.linalg.norm(np.ptp(surface, axis=0))),
    )
    return float(_number_jitted(objective, curve))


def of_surface(objective: Any, tape: Tape, vertices: Any) -> jax.Array:
    """The ``objective`` of a contracted surface: its ``vertices`` (n, 3) count as nodes.

    ``vertices`` are ``flow.meso_skeleton[0]``, or `msf_jax.replay_meso` of ``tape``. They have no radii and no edges:
    only objectives of positions are possible, such as ``near(target)``. Differentiable in: vertices.

    Raises:
        ConfigError: the objective needs radii or edges, or its value is not one number.
    """
    objective = as_objective(objective)
    nothing: Any = None
    surface, areas, diagonal = jnp.asarray(tape.vertices), jnp.asarray(tape.areas), jnp.asarray(tape.diagonal)
    curve = Placed(jnp.asarray(vertices), nothing, nothing, surface, areas, nothing, diagonal)
    try:
        return _number(objective, curve)
    except (TypeError, AttributeError) as error:
        raise ConfigError(
            f"objective {objective.name} cannot be computed for a contracted surface, which has no radii and no edges: "
            "expected one of positions only, such as objectives.near(target)"
        ) from error


def _number(objective: Objective, curve: Placed) -> jax.Array:
    returned = objective(curve)
    try:
        number = jnp.asarray(returned)
    except (TypeError, ValueError):
        raise ConfigError(f"objective {objective.name} returned {type(returned).__name__}: expected a number") from None
    if number.shape != () or not jnp.issubdtype(number.dtype, jnp.floating):
        what = f"{number.dtype} of shape {number.shape}"
        raise ConfigError(f"objective {objective.name} returned {what}: expected one floating-point number, shape ()")
    return number


_number_jitted = jax.jit(_number, static_argnums=0)


def explained() -> Objective:
    """Mean distance of the surface, by area, from the union of the balls around the nodes, in diagonals.

    It is 0 if every point of the surface is on a ball. Centred nodes have large balls, and so low values.
    (Reconstruction, Cornea et al. 2007.)
    """

    def function(curve: Placed) -> jax.Array:
        stride = -(-len(curve.surface) // MOST_SAMPLES)
        points, areas = curve.surface[::stride], curve.areas[::stride]
        away = _distances(points, curve.nodes, curve.diagonal) - (curve.radii / curve.diagonal)[None]
        return (areas * jnp.maximum(away.min(axis=1), 0.0)).sum() / areas.sum()

    return Objective("explained", function)


def centred() -> Objective:
    """Mean, by area, of a node's distance from the centroid of the surface around it, over that surface's mean distance
    from its nodes.

    The surface around a node consists of the vertices that are mapped to the node or its neighbours.
    """

    def function(curve: Placed) -> jax.Array:
        num = len(curve.nodes)
        a, b = curve.edges[:, 0], curve.edges[:, 1]

        def around(values: jax.Array) -> jax.Array:
            own = jax.ops.segment_sum(values, curve.node_of_vertex, num)
            return own + jax.ops.segment_sum(own[b], a, num) + jax.ops.segment_sum(own[a], b, num)

        area = around(curve.areas)
        has_area = area > 0
        safe = jnp.where(has_area, area, 1.0)
        middle = around(curve.areas[:, None] * curve.surface) / safe[:, None]
        away = norm((curve.surface - curve.nodes[curve.node_of_vertex]) / curve.diagonal)
        reach = around(curve.areas * away) / safe
        # A millionth of the diagonal: a limb that has no extent is divided by more than 0.
        off = norm((curve.nodes - middle) / curve.diagonal) / jnp.where(has_area, reach + 1e-6, 1.0)
        return jnp.where(has_area, area * off, 0.0).sum() / area.sum()

    return Objective("centred", function)


def inside(margin: float = 0.0) -> Objective:
    """Mean over the nodes of the shortfall of the signed distance to the surface below ``margin``, in diagonals."""
    if isinstance(margin, bool) or not isinstance(margin, int | float) or not np.isfinite(margin):
        raise ConfigError(f"margin is {margin!r}: expected a finite number, in diagonals")

    def function(curve: Placed) -> jax.Array:
        return jnp.maximum(margin - curve.radii / curve.diagonal, 0.0).mean()

    return Objective(f"inside({margin:g})" if margin else "inside", function)


def smooth() -> Objective:
    """Mean over nodes with two neighbours of one minus the cosine of the angle by which the curve turns there."""

    def function(curve: Placed) -> jax.Array:
        turn, counts = losses.turning(curve.nodes / curve.diagonal, curve.edges, jnp.ones(len(curve.edges), bool))
        return jnp.where(counts, turn, 0.0).sum() / jnp.maximum(counts.sum(), 1)

    return Objective("smooth", function)


def near(target: Any) -> Objective:
    """Mean distance between the curve and ``target``, the mean of both directions, in diagonals.

    ``target``: points (P, 3) along the wanted curve, in the mesh's units.

    Raises:
        ConfigError: ``target`` is not an array of finite points.
    """
    try:
        points = np.asarray(getattr(target, "vertices", target), dtype=np.float64)
    except (TypeError, ValueError):
        raise ConfigError(f"target is a {type(target).__name__}: expected points (P, 3) along a curve") from None
    if points.ndim != 2 or points.shape[1] != 3 or not len(points) or not np.isfinite(points).all():
        what = f"shape {points.shape}, {points.size - np.isfinite(points).sum()} values that are not finite"
        raise ConfigError(f"target has {what}: expected finite points (P, 3) along a curve")

    def function(curve: Placed) -> jax.Array:
        away = _distances(jnp.asarray(points, curve.nodes.dtype), curve.nodes, curve.diagonal)
        return (away.min(axis=1).mean() + away.min(axis=0).mean()) / 2

    return Objective("near", function)


def _distances(points: jax.Array, nodes: jax.Array, diagonal: jax.Array) -> jax.Array:
    """(P, N) distances, in diagonals."""
    return norm((points[:, None] - nodes[None]) / diagonal)
