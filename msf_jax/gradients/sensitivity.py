"""How far each node of a recorded run moves, per unit of each weight and of each vertex of the mesh."""

from functools import partial
from typing import NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.base.options import Weights
from msf_jax.gradients.replay import replay
from msf_jax.gradients.tape import Tape


class Sensitivity(NamedTuple):
    """Derivatives of the nodes of ``tape`` at ``weights``, decisions frozen.

    by_weight: `Weights` whose entries are (N, 3): how far each node moves per unit of that weight, in the mesh's units.
    tolerance: of the solves.
    """

    tape: Tape
    weights: Weights
    by_weight: Weights
    tolerance: float | None = None

    def __repr__(self) -> str:
        return f"Sensitivity({self.tape!r})"

    def of_vertex(self, vertex: int) -> np.ndarray:
        """(N, 3, 3): column k is how far each node moves per unit that ``vertex`` moves along axis k.

        Three products with the Jacobian, which itself, (N, 3, V, 3), is never formed.

        Raises:
            ConfigError: the mesh has no such vertex.
            MeshError: the surface does not follow it, as some of it was made by repair.
        """
        self.tape.check_movable()
        num = len(self.tape.vertices)
        if isinstance(vertex, bool) or not isinstance(vertex, int | np.integer) or not 0 <= vertex < num:
            raise ConfigError(f"vertex is {vertex!r}: expected a number from 0 to {num - 1}")
        moved = np.zeros((4, num, 3))
        moved[[0, 1, 2], vertex, [0, 1, 2]] = 1.0
        columns = _columns(self.tape.padded(), self.weights, np.zeros((4, 4)), moved, self.tolerance)
        return np.moveaxis(np.asarray(columns[:3, : self.tape.num_nodes]), 0, -1)

    def of_node(self, node: int) -> np.ndarray:
        """(V, 3, 3): row k is how far ``node`` moves along axis k per unit that each vertex moves along each axis.

        Three products with the transposed Jacobian.

        Raises:
            ConfigError: the curve has no such node.
            MeshError: the surface does not follow the mesh's vertices, as some of it was made by repair.
        """
        self.tape.check_movable()
        num = self.tape.num_nodes
        if isinstance(node, bool) or not isinstance(node, int | np.integer) or not 0 <= node < num:
            raise ConfigError(f"node is {node!r}: expected a number from 0 to {num - 1}")
        return np.asarray(_of_node(self.tape.padded(), self.weights, jnp.asarray(node), self.tolerance))


def sensitivity(tape: Tape, weights: Weights | None = None, *, tolerance: float | None = None) -> Sensitivity:
    """How far each node moves, per unit of each weight and, on request, of each vertex of the mesh.

    Args:
        tape: of a run.
        weights: where to differentiate; those of the run if not given. Numbers, not arrays.
        tolerance: of the solves, see `msf_jax.replay`.

    Decisions are frozen: see `msf_jax.replay`.

    Raises:
        ConfigError: see `msf_jax.replay`; or a weight is an array.
    """
    if not isinstance(tape, Tape):
        raise ConfigError(f"tape is a {type(tape).__name__}: expected a Tape, such as flow.tape of a contract call")
    weights = tape.weights if weights is None else weights
    if not isinstance(weights, Weights):
        raise ConfigError(f"weights is a {type(weights).__name__}: expected a msf_jax.Weights")
    for name, value in vars(weights).items():
        if np.ndim(value):
            raise ConfigError(f"Weights.{name} has shape {np.shape(value)}: expected a number")
    at = Weights(*(jnp.asarray(value, float) for value in vars(weights).values()))
    none = np.zeros((4, *tape.vertices.shape))
    columns = _columns(tape.padded(), at, np.eye(4), none, tolerance)[:, : tape.num_nodes]
    structure = jax.tree_util.tree_structure(at)  # slopes are no weights: their signs are free
    return Sensitivity(tape, at, jax.tree_util.tree_unflatten(structure, np.asarray(columns)), tolerance)


@partial(jax.jit, static_argnames="tolerance")
def _columns(
    tape: Tape, weights: Weights, by_weight: jax.Array, by_vertex: jax.Array, tolerance: float | None
) -> jax.Array:
    """(4, N, 3): how the nodes move along four directions, each a change of the four weights and of (V, 3) vertices.

    Four, as there are four weights: those of a vertex, three, share what was compiled for them.
    """
    at = weights, jnp.asarray(tape.vertices, by_vertex.dtype)

    def column(of_weights: jax.Array, of_vertices: jax.Array) -> jax.Array:
        if tape.is_joined:
            return jax.jvp(partial(replay, tape, tolerance=tolerance), (weights,), (Weights(*of_weights),))[1]
        return jax.jvp(partial(replay, tape, tolerance=tolerance), at, (Weights(*of_weights), of_vertices))[1]

    return jax.vmap(column)(by_weight, by_vertex)


@partial(jax.jit, static_argnames="tolerance")
def _of_node(tape: Tape, weights: Weights, node: jax.Array, tolerance: float | None) -> jax.Array:
    nodes, pull_back = jax.vjp(partial(replay, tape, weights, tolerance=tolerance), jnp.asarray(tape.vertices))
    rows = jax.lax.map(lambda axis: pull_back(jnp.zeros_like(nodes).at[node, axis].set(1.0))[0], jnp.arange(3))
    return jnp.moveaxis(rows, 0, 1)
