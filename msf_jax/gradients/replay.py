"""`replay`: the curve of a run, from its tape, as a function of its weights and of the mesh's vertices, in pure JAX. It
does not see that other weights may collapse, split or fix other vertices, or take more iterations."""

from dataclasses import dataclass, field
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

from msf_jax.base.decisions import Part
from msf_jax.base.errors import ConfigError, MeshError
from msf_jax.base.layout import Layout, capacity_for
from msf_jax.base.options import FACTORED, Config, Weights, is_traced
from msf_jax.device.buffers import real_dtype
from msf_jax.device.playback import replay_part
from msf_jax.gradients.follow import check_finite, numbers_of
from msf_jax.recording.records import Recording, record_component

TOLERANCE = {"float64": 1e-14, "float32": 1e-6}  # relative residuals of the linear solves
MOST_STEPS = 20_000  # steps of conjugate gradients in one solve
MOST_KINDS = 12  # of tapes' parts whose programs are kept: each takes some 2,000 of the 65,530 memory maps of a process
_kinds: set[Any] = set()


@jax.tree_util.register_dataclass
@dataclass(frozen=True, eq=False)
class Tape:
    """The decisions of a run, for `replay`, as ``flow.tape``. A pytree of arrays, for `jax.jit` and pickle.

    Attributes:
        parts, layouts, counts: of each component of the mesh: one-rings, collapses and splits, poles, fixed vertices,
            residuals of the linear solves, the map to nodes; the layouts of its buffers; and how many vertices its
            contracted surface has, and nodes its curve. Arrays are padded: tapes of a size share compiled programs.
        vertices: (V, 3) of the mesh, in the caller's units.
        areas: (V,) of each vertex.
        weights, config: of the run.
        is_joined: whether the surface has vertices that repair made, where it joined parts or extruded a rim.
    """

    parts: tuple[Part, ...]
    vertices: Any
    areas: Any
    weights: Weights
    layouts: tuple[tuple[Layout, ...], ...] = field(metadata={"static": True})
    counts: tuple[tuple[int, int], ...] = field(metadata={"static": True})
    config: Config = field(metadata={"static": True})
    is_joined: bool = field(metadata={"static": True})

    def __repr__(self) -> str:
        return f"Tape({self.num_nodes} nodes, {len(self.vertices)} vertices)"

    @property
    def num_nodes(self) -> int:
        """The number of nodes of the recorded curve."""
        return sum(num for _, num in self.counts)


def record(run: Recording, weights: Weights, config: Config, areas: np.ndarray) -> Tape:
    """The tape of a run whose vertices have ``areas`` (V,)."""
    parts, layouts, counts = zip(*map(record_component, run.components), strict=True)
    return Tape(
        parts=parts,
        vertices=run.vertices,
        areas=areas,
        weights=Weights(*(np.asarray(weight, dtype=np.float64) for weight in vars(weights).values())),
        layouts=layouts,
        counts=counts,
        config=config,
        is_joined=run.is_joined,
    )


def replay(tape: Tape, weights: Weights, vertices: Any = None, *, tolerance: float | None = None) -> jax.Array:
    """The nodes that the recorded run would have found at other ``weights``, or for other ``vertices``.

    Positions, Laplacians, poles and split points are computed anew. Collapses, splits and fixed vertices are those of
    the tape. At the recorded weights and vertices the result is ``flow.curve.vertices``. Works under JAX's
    transformations. Under `jax.jit`, pass the tape as an argument, or it is compiled in.

    Args:
        tape: of a run, ``flow.tape``.
        weights: each a number, or (V,), one for each vertex of the mesh, interpolated at merged and new vertices.
        vertices: (V, 3) of the mesh in the caller's units. The default is the recorded vertices.
        tolerance: relative residual of the linear solves. The default, 1e-14 (1e-6 in float32), makes gradients exact,
            to rounding; ``tolerance=1e-8`` is somewhat faster and gives them to some thousandths.

    Returns:
        (N, 3), in the caller's units. NaN if a linear solve does not converge in 20,000 steps, as with extreme weights
        (w_H and w_M almost 0); so is a derivative whose solve does not converge.

    Differentiable in: weights, vertices; in float64 only. The derivative includes a pole's dependence on its four
    sites, and the filter of the sites; the centre of a ball moves with the circumcentre of four sites near it. Held
    constant are all decisions, the frame (the flow does not depend on it), the trust in a pole, and the direction of
    the residual that each loose solve of the run left; its length scales with the right-hand side. Of several welded
    vertices the first has the whole derivative.

    Raises:
        ConfigError: ``tape`` or ``weights`` has a wrong type, or a weight is out of range or of the wrong shape; the
            run's systems were solved by a factorisation, which a replay has not (``Config.au2008()``); or JAX derives
            the replay and computes in float32.
        MeshError: ``vertices`` has another shape than those of the tape, or is not finite; or repair made vertices of
            the surface, so that it cannot follow the mesh.
    """
    return _replayed(tape, weights, vertices, tolerance, 1)


def replay_meso(tape: Tape, weights: Weights, vertices: Any = None, *, tolerance: float | None = None) -> jax.Array:
    """The vertices (n, 3) of the contracted surface, computed as in `replay`; at the recorded weights and vertices they
    are ``flow.meso_skeleton[0]``."""
    return _replayed(tape, weights, vertices, tolerance, 0)


def _replayed(tape: Tape, weights: Weights, vertices: Any, tolerance: float | None, which: int) -> jax.Array:
    """Of `replay_part`'s results the one with number ``which``, without padding, of all components."""
    if not isinstance(tape, Tape):
        raise ConfigError(f"tape is a {type(tape).__name__}: expected a Tape, such as flow.tape of a contract call")
    if tape.config.solver.preconditioner == FACTORED or tape.config.flow.w_H_follows_area:
        raise ConfigError(
            "the run's systems need a factorisation, which a replay has not: expected Config(), or another"
        )
    if not isinstance(weights, Weights):
        raise ConfigError(f"weights is a {type(weights).__name__}: expected a msf_jax.Weights")
    weights.check(len(tape.vertices))
    shapes = (tuple(map(np.shape, jax.tree.leaves(part))) for part in tape.parts)
    kinds = {(*each, tape.config.flow.laplacian) for each in zip(tape.layouts, shapes, strict=True)}
    if len(_kinds | kinds) > MOST_KINDS:
        _kinds.clear()
        replay_part.clear_cache()  # pyright: ignore[reportAttributeAccessIssue]
    _kinds.update(kinds)
    dtype, shape = real_dtype(), np.shape(tape.vertices)

    def padded(values: Any) -> jax.Array:
        if np.ndim(values):
            more = [(0, capacity_for(shape[0]) - shape[0]), (0, 0)][: np.ndim(values)]
            library = jnp if isinstance(values, jax.Array) else np  # JAX would compile this for every size
            values = library.pad(values, more)
        return jnp.asarray(values, dtype)

    given = padded(tape.vertices)
    moved = jnp.zeros_like(given)
    if vertices is not None:
        if tape.is_joined:
            raise MeshError(
                "repair made vertices where it joined parts or extruded a rim, and these cannot follow the mesh: "
                'expected a run without repair="join" and without extruded rims, or a call without vertices'
            )
        array = numbers_of("vertices", vertices, MeshError).astype(dtype)
        if array.shape != shape:
            raise MeshError(f"vertices has shape {array.shape}: expected {shape}, as in the mesh of the tape")
        if not is_traced(array):
            check_finite(array)
        moved = padded(array) - given
    tolerance = TOLERANCE[str(dtype)] if tolerance is None else tolerance
    if isinstance(tolerance, bool) or not isinstance(tolerance, int | float) or not 0 < tolerance < 1:
        raise ConfigError(f"tolerance is {tolerance!r}: expected a number above 0 and below 1")
    weights, moved = jax.tree.map(_in_float64, (jax.tree.map(padded, weights), moved))
    arguments = weights, given + moved, moved, float(tolerance)
    found = [
        replay_part(part, *arguments, layouts, tape.config.flow.laplacian, MOST_STEPS)[which][: num[which]]
        for part, layouts, num in zip(tape.parts, tape.layouts, tape.counts, strict=True)
    ]
    return jnp.concatenate(found)


@jax.custom_jvp
def _in_float64(values: jax.Array) -> jax.Array:
    """``values``, whose derivative there is in float64 only."""
    return values


@_in_float64.defjvp
def _derivative(primals: Any, tangents: Any) -> Any:
    if primals[0].dtype != jnp.float64:
        raise ConfigError(
            "JAX derives a replay in float32, whose rounding leaves nothing of a derivative through so many solves: "
            'expected jax.config.update("jax_enable_x64", True) at the start; or msf_jax.follow for a derivative by '
            "the vertices, which is right in float32"
        )
    return primals[0], tangents[0]
