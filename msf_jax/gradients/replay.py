"""`replay`: the curve of a recorded run as a function of its weights and of the mesh's vertices, in pure JAX.

Its gradient is that of the run's geometry with all recorded decisions held fixed. It does not see that other weights
may collapse, split or fix other vertices, or take more iterations.
"""

from dataclasses import replace as changed
from functools import partial
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from jax.custom_derivatives import SymbolicZero

from msf_jax.base.errors import ConfigError, MeshError
from msf_jax.base.layout import Layout
from msf_jax.base.options import StepSettings, Weights, is_traced
from msf_jax.device.buffers import real_dtype
from msf_jax.device.nearest import clearance
from msf_jax.device.playback import replay_part
from msf_jax.gradients.follow import check_finite, numbers_of
from msf_jax.gradients.tape import Tape

# Relative residuals of the linear solves, by type: where only the value is computed, and where a derivative is, too.
TOLERANCE = {"float64": (1e-14, 1e-8), "float32": (1e-6, 1e-6)}
MOST_STEPS = 20_000  # steps of conjugate gradients in one solve


def replay(tape: Tape, weights: Weights, vertices: Any = None, *, tolerance: float | None = None) -> jax.Array:
    """The nodes that the recorded run would have found at other ``weights``, or for other ``vertices``.

    Positions, Laplacians, poles and split points are computed anew. Collapses, splits and fixed vertices are those of
    the tape. At the recorded weights and vertices the result is ``flow.curve.vertices``. Works under `jax.jit`, `grad`,
    `vmap`, `jacfwd` and `jacrev`. Under `jax.jit`, pass the tape as an argument, or it is compiled in.

    Args:
        tape: of a run, ``flow.tape``.
        weights: each a number, or (V,), one value for each vertex of the mesh. A merged vertex gets the mean of its
            vertices' weights; a vertex that splits an edge gets an interpolated weight.
        vertices: (V, 3) of the mesh in the caller's units. The default is the recorded vertices.
        tolerance: relative residual of the linear solves. The default is 1e-14 where only the value is computed, and
            1e-8 where a derivative is, too, which is three to five times as fast and gives gradients to some
            thousandths; in float32 it is 1e-6. ``tolerance=1e-14`` makes gradients exact, to rounding.

    Returns:
        (N, 3), in the caller's units. NaN if a linear solve does not converge in 20,000 steps: then the weights are
        too extreme (w_H and w_M almost 0, for example). A derivative whose solve does not converge is NaN.

    Differentiable in: weights, vertices. The derivative includes a pole's dependence on its four sites, and the filter
    of the sites. Held constant are all decisions, the frame (the flow does not depend on it), the trust in a pole, and
    the direction of the residual that each loose solve of the run left; its length scales with the right-hand side.
    Of several welded vertices the first has the whole derivative. A system whose w_L grows (``Config.au2008()``) is
    ill-conditioned, and the replay has no factorisation for it: on more than some thousand vertices it takes minutes,
    or is NaN.

    Raises:
        ConfigError: ``tape`` or ``weights`` has a wrong type, or a weight is out of range or of the wrong shape.
        MeshError: ``vertices`` has another shape than those of the tape, or is not finite; or repair made vertices of
            the surface, so that it cannot follow the mesh.
    """
    return _replayed(tape, weights, vertices, tolerance)[1]


def replay_meso(tape: Tape, weights: Weights, vertices: Any = None, *, tolerance: float | None = None) -> jax.Array:
    """The vertices (n, 3) of the contracted surface, computed as in `replay`.

    At the recorded weights and vertices they are ``flow.meso_skeleton[0]``.
    """
    return _replayed(tape, weights, vertices, tolerance)[0]


def replay_radii(tape: Tape, nodes: jax.Array, vertices: Any = None) -> jax.Array:
    """Distance (N,) from each of the ``nodes`` (N, 3) to the surface, negative for a node outside.

    The triangle nearest to each node is held as recorded. At the recorded nodes the result is ``flow.curve.radii``
    where that is positive. Differentiable in: nodes, vertices.

    Raises:
        ConfigError: ``nodes`` are not those of the tape.
        MeshError: see `replay`.
    """
    _check_tape(tape)
    if np.shape(nodes) != (tape.num_nodes, 3):
        raise ConfigError(f"nodes has shape {np.shape(nodes)}: expected ({tape.num_nodes}, 3), as in the tape")
    surface = jnp.asarray(tape.vertices, real_dtype()) if vertices is None else _checked_vertices(tape, vertices)
    unit = jnp.asarray(tape.diagonal, surface.dtype)  # in this unit no square overflows float32
    triangles = (surface[jnp.asarray(tape.triangles)] + jnp.asarray(tape.offsets, surface.dtype)) / unit
    return unit * clearance(jnp.asarray(nodes) / unit, triangles, jnp.asarray(tape.is_inside))


def _replayed(tape: Tape, weights: Weights, vertices: Any, tolerance: float | None) -> tuple[jax.Array, jax.Array]:
    _check_tape(tape)
    if not isinstance(weights, Weights):
        raise ConfigError(f"weights is a {type(weights).__name__}: expected a msf_jax.Weights")
    weights.check(len(tape.vertices))
    dtype = real_dtype()
    given = jnp.asarray(tape.vertices, dtype)
    moved = jnp.zeros_like(given) if vertices is None else _checked_vertices(tape, vertices) - given
    if tolerance is None:
        tight, loose = TOLERANCE[str(dtype)]
    elif isinstance(tolerance, bool) or not isinstance(tolerance, int | float) or not 0 < tolerance < 1:
        raise ConfigError(f"tolerance is {tolerance!r}: expected a number above 0 and below 1")
    else:
        tight = loose = tolerance
    run = tape.config.on_device
    solvers = [changed(run.solver, tolerance=t, max_steps=MOST_STEPS, preconditioner="jacobi") for t in (tight, loose)]
    settings = tuple(run._replace(solver=solver) for solver in solvers)
    results = [
        _replayed_part(layouts, settings, (part, weights, given + moved, moved))
        for part, layouts in zip(tape.parts, tape.layouts, strict=True)
    ]
    meso, nodes = map(jnp.concatenate, zip(*results, strict=True))
    return meso, nodes


@partial(jax.custom_jvp, nondiff_argnums=(0, 1))
def _replayed_part(
    layouts: tuple[Layout, ...], settings: tuple[StepSettings, ...], arguments: Any
) -> tuple[jax.Array, jax.Array]:
    """`replay_part` with the first of ``settings``. Under differentiation, value and derivative use the second."""
    return replay_part(*arguments, layouts, settings[0])


def _derivative(layouts: tuple[Layout, ...], settings: tuple[StepSettings, ...], primals: Any, tangents: Any) -> Any:
    leaves, structure = jax.tree_util.tree_flatten(primals[0])
    slopes = structure.flatten_up_to(tangents[0])
    places = [number for number, slope in enumerate(slopes) if not isinstance(slope, SymbolicZero)]

    def of_live(*live: jax.Array) -> tuple[jax.Array, jax.Array]:
        every = list(leaves)
        for place, value in zip(places, live, strict=True):
            every[place] = value
        return replay_part(*jax.tree_util.tree_unflatten(structure, every), layouts, settings[1])

    return jax.jvp(of_live, [leaves[place] for place in places], [slopes[place] for place in places])


_replayed_part.defjvp(_derivative, symbolic_zeros=True)


def _check_tape(tape: Any) -> None:
    if not isinstance(tape, Tape):
        raise ConfigError(f"tape is a {type(tape).__name__}: expected a Tape, such as flow.tape of a contract call")


def _checked_vertices(tape: Tape, vertices: Any) -> jax.Array:
    if tape.is_joined:
        raise MeshError(
            "repair made vertices where it joined parts or extruded a rim, and these cannot follow the mesh: "
            'expected a run without repair="join" and without extruded rims, or a call without vertices'
        )
    array = numbers_of("vertices", vertices, MeshError).astype(real_dtype())
    if array.shape != tape.vertices.shape:
        raise MeshError(
            f"vertices has shape {array.shape}: expected {tape.vertices.shape}, as in the mesh that the tape was "
            "recorded for"
        )
    if not is_traced(array):
        check_finite(array)
    return jnp.asarray(array)
