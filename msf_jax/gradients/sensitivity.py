"""Derivatives of the nodes of a recorded run with respect to the weights and to the vertices of the mesh."""

import warnings
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
    """Derivatives of the nodes of ``tape`` at ``weights``, with decisions held fixed.

    by_weight: `Weights` whose entries are (N, 3), the derivatives of the nodes with respect to that weight, in the
    mesh's units. tolerance: of the solves.
    """

    tape: Tape
    weights: Weights
    by_weight: Weights
    tolerance: float | None = None

    def __repr__(self) -> str:
        return f"Sensitivity({self.tape!r})"

    def of_vertex(self, vertex: int) -> np.ndarray:
        """(N, 3, 3) derivatives of the nodes with respect to ``vertex``; column k is for its motion along axis k.

        It computes three products with the Jacobian (N, 3, V, 3), without forming that.

        Raises:
            ConfigError: the mesh has no such vertex.
            MeshError: repair made vertices of the surface, so that it cannot follow the mesh.
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
        """(V, 3, 3) derivatives of ``node`` with respect to every vertex; row k is its motion along axis k.

        It computes three products with the transposed Jacobian.

        Raises:
            ConfigError: the curve has no such node.
            MeshError: repair made vertices of the surface, so that it cannot follow the mesh.
        """
        self.tape.check_movable()
        num = self.tape.num_nodes
        if isinstance(node, bool) or not isinstance(node, int | np.integer) or not 0 <= node < num:
            raise ConfigError(f"node is {node!r}: expected a number from 0 to {num - 1}")
        return np.asarray(_of_node(self.tape.padded(), self.weights, jnp.asarray(node), self.tolerance))


def sensitivity(tape: Tape, weights: Weights | None = None, *, tolerance: float | None = None) -> Sensitivity:
    """Derivatives of the nodes with respect to each weight and, by methods of the result, to vertices of the mesh.

    Args:
        tape: of a run.
        weights: numbers at which to differentiate; those of the run if not given.
        tolerance: of the solves, see `msf_jax.replay`.

    Decisions are held fixed, see `msf_jax.replay`. The tape should be of a run with tight solves,
    ``contract(mesh, config=Config().tight())``: else a warning says that the derivatives do not predict fresh runs, not
    even where no decision changes.

    Raises:
        ConfigError: see `msf_jax.replay`; or a weight is an array.
    """
    if not isinstance(tape, Tape):
        raise ConfigError(f"tape is a {type(tape).__name__}: expected a Tape, such as flow.tape of a contract call")
    if tape.config != tape.config.tight():
        warnings.warn(
            "the tape is of a run with loose solves, so these derivatives do not predict fresh runs: expected that of "
            "contract(mesh, config=config.tight())",
            stacklevel=2,
        )
    weights = tape.weights if weights is None else weights
    if not isinstance(weights, Weights):
        raise ConfigError(f"weights is a {type(weights).__name__}: expected a msf_jax.Weights")
    for name, value in vars(weights).items():
        if np.ndim(value):
            raise ConfigError(f"Weights.{name} has shape {np.shape(value)}: expected a number")
    at = Weights(*(jnp.asarray(value, float) for value in vars(weights).values()))
    none = np.zeros((4, *tape.vertices.shape))
    columns = _columns(tape.padded(), at, np.eye(4), none, tolerance)[:, : tape.num_nodes]
    structure = jax.tree_util.tree_structure(at)  # derivatives may be negative, which the constructor would refuse
    return Sensitivity(tape, at, jax.tree_util.tree_unflatten(structure, np.asarray(columns)), tolerance)


@partial(jax.jit, static_argnames="tolerance")
def _columns(
    tape: Tape, weights: Weights, by_weight: jax.Array, by_vertex: jax.Array, tolerance: float | None
) -> jax.Array:
    """(4, N, 3): derivatives along four directions, each a change of the four weights and of the (V, 3) vertices.

    There are four directions for the four weights. The three of a vertex use the same compiled program.
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
