"""`replay`: the curve of a recorded run as a function of weights and vertices, in pure JAX."""

from dataclasses import replace as changed
from typing import Any

import jax
import jax.numpy as jnp

from msf_jax.device.buffers import real_dtype
from msf_jax.device.replay import replay_part
from msf_jax.options import Weights
from msf_jax.tape import Tape

TOLERANCE = {"float64": 1e-13, "float32": 1e-6}
MOST_STEPS = 20_000


def replay(tape: Tape, weights: Weights, vertices: Any = None) -> jax.Array:
    return _replayed(tape, weights, vertices)[1]


def replay_meso(tape: Tape, weights: Weights, vertices: Any = None) -> jax.Array:
    return _replayed(tape, weights, vertices)[0]


def _replayed(tape: Tape, weights: Weights, vertices: Any) -> tuple[jax.Array, jax.Array]:
    dtype = real_dtype()
    given = jnp.asarray(tape.vertices, dtype)
    moved = jnp.zeros_like(given) if vertices is None else jnp.asarray(vertices, dtype) - given
    config = changed(tape.config.on_device, solve_tolerance=TOLERANCE[str(dtype)], solve_steps=MOST_STEPS)
    results = []
    for part, shape, (num_meso, num_nodes) in zip(tape.parts, tape.shapes, tape.sizes, strict=True):
        meso, nodes = replay_part(part, weights, given + moved, moved, shape, config)
        results.append((meso[:num_meso], nodes[:num_nodes]))
    meso, nodes = (jnp.concatenate(column) for column in zip(*results, strict=True))
    return meso, nodes
