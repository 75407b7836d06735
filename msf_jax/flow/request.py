"""Checks of a run's arguments: weights, configuration, pins."""

import reprlib
from collections.abc import Iterable
from typing import Any

import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.base.options import Config, Weights, is_traced, traced
from msf_jax.meshes.checking import Surface


def checked_options(weights: Any, config: Any) -> tuple[Weights, Config]:
    """The weights and the config, with defaults for None; a `ConfigError` if a type is wrong or a weight traced."""
    if not isinstance(config, Config | None):
        raise ConfigError(f"config is a {type(config).__name__}: expected a msf_jax.Config")
    if not isinstance(weights, Weights | None):
        shape = getattr(weights, "shape", None)
        if isinstance(shape, tuple) and shape[1:] == (3,):
            raise ConfigError(
                f"weights has shape {tuple(shape)}, as faces have: pass the mesh as one argument, (vertices, faces)"
            )
        raise ConfigError(f"weights is a {type(weights).__name__}: expected a msf_jax.Weights (config comes after it)")
    if weights is not None and any(map(is_traced, vars(weights).values())):
        raise ConfigError(traced("weights", "msf_jax.replay") + ", with the tape of msf_jax.contract")
    config = Config() if config is None else config
    return (config.default_weights() if weights is None else weights), config


def weights_of_vertices(weights: Weights, checked: Surface) -> np.ndarray | None:
    """(V, 4) weights of the checked surface's vertices, or None if all weights are scalars."""
    num = len(checked.vertex_of_input)
    columns = []
    for name, value in vars(weights).items():
        if np.shape(value) not in ((), (num,)):
            raise ConfigError(
                f"Weights.{name} has shape {np.shape(value)}: expected a number, or ({num},): one for each vertex"
            )
        columns.append(np.broadcast_to(np.asarray(value, dtype=np.float64), num)[checked.input_of_vertex])
    return None if all(np.ndim(value) == 0 for value in vars(weights).values()) else np.stack(columns, axis=1)


def checked_pins(pins: Any, checked: Surface) -> tuple[np.ndarray, np.ndarray]:
    """The caller's ``pins`` as an array of ids, and the ids of these vertices in the checked surface."""
    num = len(checked.vertex_of_input)
    if pins is None:
        listed: Any = []
    elif isinstance(pins, np.ndarray) or not isinstance(pins, Iterable):
        listed = np.atleast_1d(pins)
    else:
        listed = list(pins)
    try:
        given: np.ndarray = np.array(listed)
    except ValueError:  # lists of different lengths
        given = np.empty((0, 0))
    if given.size == 0 and given.ndim == 1:
        return np.empty(0, dtype=np.int64), np.empty(0, dtype=np.int64)
    if given.ndim != 1 or given.dtype.kind not in "iu" or given.min() < 0 or given.max() >= num:
        raise ConfigError(f"pins is {reprlib.repr(pins)}: expected vertex numbers from 0 to {num - 1}")
    rows = checked.vertex_of_input[given]
    if (rows < 0).any():
        raise ConfigError(f"pins has vertex {given[rows < 0][0]}, which no face uses: expected vertices of the surface")
    is_lining = np.isin(rows, np.concatenate(checked.linings))
    if is_lining.any():
        raise ConfigError(f"pins has vertex {given[is_lining][0]} of a cavity: expected vertices of the outer surface")
    return np.unique(given).astype(np.int64), np.unique(rows)
