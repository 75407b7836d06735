"""How far each node of a recorded run moves, per unit of each weight and of each vertex of the mesh."""

from functools import partial
from typing import NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from msf_jax.errors import ConfigError
from msf_jax.options import Weights
from msf_jax.replaying import replay
from msf_jax.tape import Tape


class Sensitivity(NamedTuple):
    """Derivatives of the nodes of ``tape`` at ``weights``, decisions frozen.

    by_weight: `Weights` whose entries are (N, 3): how far each node moves per unit of that weight, in the mesh's units.
    """

    tape: Tape
    weights: Weights
    by_weight: Weights

    def of_vertex(self, vertex: int) -> np.ndarray:
        """(N, 3, 3): column k is how far each node moves per unit that ``vertex`` moves along axis k.

        Three products with the Jacobian, which itself, (N, 3, V, 3), is never formed.

        Raises:
            ConfigError: the mesh has no such vertex.
        """
        num = len(self.tape.vertices)
        if isinstance(vertex, bool) or not isinstance(vertex, int | np.integer) or not 0 <= vertex < num:
            raise ConfigError(f"vertex is {vertex!r}: expected a number from 0 to {num - 1}")
        return np.asarray(_by_vertex(self.tape, self.weights, jnp.asarray(vertex)))

    def of_node(self, node: int) -> np.ndarray:
        """(V, 3, 3): row k is how far ``node`` moves along axis k per unit that each vertex moves along each axis.

        Three products with the transposed Jacobian.

        Raises:
            ConfigError: the curve has no such node.
        """
        num = self.tape.num_nodes
        if isinstance(node, bool) or not isinstance(node, int | np.integer) or not 0 <= node < num:
            raise ConfigError(f"node is {node!r}: expected a number from 0 to {num - 1}")
        return np.asarray(_of_node(self.tape, self.weights, jnp.asarray(node)))


def sensitivity(tape: Tape, weights: Weights | None = None) -> Sensitivity:
    """How far each node moves, per unit of each weight and, on request, of each vertex of the mesh.

    Args:
        tape: of a run.
        weights: where to differentiate; those of the run if not given. Numbers, not arrays.

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
    return Sensitivity(tape, at, jax.tree_util.tree_map(np.asarray, jax.jacfwd(partial(replay, tape))(at)))


@jax.jit
def _by_vertex(tape: Tape, weights: Weights, vertex: jax.Array) -> jax.Array:
    at = jnp.asarray(tape.vertices)

    def column(axis: jax.Array) -> jax.Array:
        return jax.jvp(partial(replay, tape, weights), (at,), (jnp.zeros_like(at).at[vertex, axis].set(1.0),))[1]

    return jnp.moveaxis(jax.vmap(column)(jnp.arange(3)), 0, -1)


@jax.jit
def _of_node(tape: Tape, weights: Weights, node: jax.Array) -> jax.Array:
    nodes, pull_back = jax.vjp(partial(replay, tape, weights), jnp.asarray(tape.vertices))
    rows = jax.vmap(lambda axis: pull_back(jnp.zeros_like(nodes).at[node, axis].set(1.0))[0])(jnp.arange(3))
    return jnp.moveaxis(rows, 0, 1)
