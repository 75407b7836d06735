"""`replay`: the curve of a recorded run as a function of its weights and of the mesh's vertices, in pure JAX.

Its gradient is that of the run's geometry with all recorded decisions held fixed. It does not see that other weights
may collapse, split or fix other vertices, or take more iterations.
"""

from functools import lru_cache, partial
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

from msf_jax.base.decisions import Part
from msf_jax.base.errors import ConfigError, MeshError
from msf_jax.base.layout import Layout
from msf_jax.base.options import FACTORED, SOLVED_BY, StepSettings, Weights, is_traced
from msf_jax.device.buffers import real_dtype
from msf_jax.device.cg import Ending
from msf_jax.device.nearest import clearance
from msf_jax.device.playback import replay_part
from msf_jax.gradients.follow import check_finite, numbers_of
from msf_jax.gradients.tape import Tape
from msf_jax.numerics.factors import solved
from msf_jax.recording.records import room

TOLERANCE = {"float64": 1e-14, "float32": 1e-6}  # relative residuals of the linear solves, by type
MOST_PROGRAMS = 8  # shapes of tapes whose programs are kept: 65,530 parts of memory hold some forty programs
MOST_STEPS = 20_000  # steps of conjugate gradients in one solve


def replay(
    tape: Tape,
    weights: Weights,
    vertices: Any = None,
    *,
    tolerance: float | None = None,
    preconditioner: str = FACTORED,
) -> jax.Array:
    """The nodes that the recorded run would have found at other ``weights``, or for other ``vertices``.

    Positions, Laplacians, poles and split points are computed anew. Collapses, splits and fixed vertices are those of
    the tape. At the recorded weights and vertices the result is ``flow.curve.vertices``. Works under `jax.jit`, `grad`,
    `vmap`, `jacfwd` and `jacrev`. Under `jax.jit`, pass the tape as an argument, or it is compiled in.

    Args:
        tape: of a run, ``flow.tape``.
        weights: each a number, or (V,), one value for each vertex of the mesh. A merged vertex gets the mean of its
            vertices' weights; a vertex that splits an edge gets an interpolated weight.
        vertices: (V, 3) of the mesh in the caller's units. The default is the recorded vertices.
        tolerance: relative residual of the linear solves, for the value and for derivatives. The default is 1e-14, or
            1e-6 in float32. On an accelerator, gradients at 1e-8 are right to some thousandths and take a third.
        preconditioner: of conjugate gradients on a CPU: "factored" is a sparse factorisation by the host, in float64,
            with which they take 5 to 16 steps; "jacobi" takes hundreds, as always on an accelerator, but is pure JAX:
            only such a program can be stored by `jax.export` or by JAX's cache of compiled programs.

    Returns:
        (N, 3), in the caller's units. NaN if a linear solve does not converge in 20,000 steps: then the weights are
        too extreme (w_H and w_M almost 0, for example). A derivative whose solve does not converge is NaN.

    Differentiable in: weights, vertices. The derivative includes a pole's dependence on its four sites, and the filter
    of the sites. Held constant are all decisions, the frame (the flow does not depend on it), the trust in a pole, and
    the direction of the residual that each loose solve of the run left; its length scales with the right-hand side.
    Of several welded vertices the first has the whole derivative. With "jacobi", a system whose w_L grows
    (``Config.au2008()``) takes minutes on more than some thousand vertices, or is NaN; so are many gradients in
    float32, whose rounding is more than those systems bear.

    A program serves all tapes, weights and tolerances of about the same size: sizes are padded to powers of two. Those
    of the last 8 sizes are kept.

    Raises:
        ConfigError: ``tape`` or ``weights`` has a wrong type, or a weight is out of range or of the wrong shape.
        MeshError: ``vertices`` has another shape than those of the tape, or is not finite; or repair made vertices of
            the surface, so that it cannot follow the mesh.
    """
    return _replayed(tape, weights, vertices, tolerance, preconditioner)[1]


def replay_meso(
    tape: Tape,
    weights: Weights,
    vertices: Any = None,
    *,
    tolerance: float | None = None,
    preconditioner: str = FACTORED,
) -> jax.Array:
    """The vertices (n, 3) of the contracted surface, computed as in `replay`.

    At the recorded weights and vertices they are ``flow.meso_skeleton[0]``.
    """
    return _replayed(tape, weights, vertices, tolerance, preconditioner)[0]


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


def _replayed(
    tape: Tape, weights: Weights, vertices: Any, tolerance: float | None, preconditioner: str
) -> tuple[jax.Array, jax.Array]:
    _check_tape(tape)
    if not isinstance(weights, Weights):
        raise ConfigError(f"weights is a {type(weights).__name__}: expected a msf_jax.Weights")
    weights.check(len(tape.vertices))
    dtype = real_dtype()
    given = _padded(tape.vertices, dtype)
    moved = jnp.zeros_like(given) if vertices is None else _padded(_checked_vertices(tape, vertices), dtype) - given
    if tolerance is None:
        tolerance = TOLERANCE[str(dtype)]
    elif isinstance(tolerance, bool) or not isinstance(tolerance, int | float) or not 0 < tolerance < 1:
        raise ConfigError(f"tolerance is {tolerance!r}: expected a number above 0 and below 1")
    if preconditioner not in SOLVED_BY:
        raise ConfigError(f"preconditioner is {preconditioner!r}: expected one of {', '.join(map(repr, SOLVED_BY))}")
    weights = jax.tree.map(lambda weight: _padded(weight, dtype), weights)
    settings = tape.config.on_device._replace(solver=None)
    results = []
    for part, size in zip(tape.parts, tape.sizes, strict=True):
        arguments = part, weights, given + moved, moved, jnp.asarray(tolerance, dtype)
        leaves, structure = jax.tree_util.tree_flatten(arguments)
        run = _program(size.layout, settings, preconditioner, structure, tuple(map(jnp.shape, leaves)))
        found = run(*arguments)
        results.append((found[0][: size.num_meso], found[1][: size.num_nodes]))
    meso, nodes = map(jnp.concatenate, zip(*results, strict=True))
    return meso, nodes


def _padded(values: Any, dtype: Any) -> jax.Array:
    """``values`` of vertices with rows of zeros up to a power of two, or a scalar, as they are."""
    if np.ndim(values) == 0:
        return jnp.asarray(values, dtype)
    rows = [(0, room(len(values)) - len(values)), *[(0, 0)] * (np.ndim(values) - 1)]
    # NumPy pads what is no tracer, because JAX would compile this for every size.
    return jnp.asarray((jnp if is_traced(values) else np).pad(values, rows), dtype)


@lru_cache(MOST_PROGRAMS)
def _program(layout: Layout, settings: StepSettings, preconditioner: str, *_: Any) -> Any:
    """`replay_part`, compiled for arguments of one structure and shape."""

    by_factors = partial(solved, max_steps=MOST_STEPS) if preconditioner == FACTORED else None

    def replayed(part: Part, weights: Weights, vertices: jax.Array, moved: jax.Array, tolerance: jax.Array) -> Any:
        ending = Ending(tolerance, MOST_STEPS, on_cpu=by_factors)
        return replay_part(part, weights, vertices, moved, layout, settings._replace(solver=ending))

    return jax.jit(replayed)


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
