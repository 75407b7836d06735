"""`Weights` of the flow: the half of a run's options that is differentiable."""

import sys
from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.base.options.groups import known, taking


@taking(known)
@dataclass(frozen=True)
class Weights:
    """Weights of the flow, a pytree. They multiply rows, so energies scale with their squares (article Eq. 2).

    Attributes:
        w_L: contraction, >= 0.
        w_H: attraction to the vertex's current position, > 0, which keeps the system definite.
        w_M: attraction to the Voronoi pole, >= 0.
        smoothing: lambda of the implicit Laplacian step, >= 0; 0 turns it off.

    All are dimensionless. Only the ratios of w_L, w_H and w_M matter: a larger w_L / w_H contracts more in one
    iteration. Weights are equal if all their numbers are equal. Weights with arrays have no hash.

    Raises:
        ConfigError: a value is negative or not finite, or a name is unknown.
    """

    w_L: Any = 1.0
    w_H: Any = 0.1
    w_M: Any = 0.4
    smoothing: Any = 0.001

    def __post_init__(self) -> None:
        self.check()

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Weights):
            return NotImplemented
        pairs = list(zip(vars(self).values(), vars(other).values(), strict=True))
        return all(a is b or (not is_traced(a) and not is_traced(b) and np.array_equal(a, b)) for a, b in pairs)

    def check(self) -> None:
        """Raise a `ConfigError` unless all weights are in range. Traced values are not checked."""
        for field in fields(self):
            value = getattr(self, field.name)
            if is_traced(value):
                continue
            try:
                array = np.asarray(np.nan if isinstance(value, str) else value, dtype=np.float64)
            except (TypeError, ValueError):
                array = np.array(np.nan)
            if isinstance(value, bool) or not (np.isfinite(array) & (array >= 0)).all():
                raise ConfigError(f"Weights.{field.name} is {value!r}: expected a finite number of 0 or more")
            if field.name == "w_H" and not (array > 0).all():
                raise ConfigError(f"Weights.w_H is {value!r}: expected more than 0, or the system is singular")


def traced(what: str, instead: str) -> str:
    """What a run says of ``what``, which JAX traces."""
    return (
        f"the {what} are traced by JAX, and a run makes decisions that it cannot trace: make the run outside of "
        f"jax.jit, jax.grad and jax.vmap, and use {instead} inside"
    )


def is_traced(value: Any) -> bool:
    """Whether ``value`` is a tracer of JAX."""
    jax = sys.modules.get("jax")  # if JAX was not imported, there are no tracers
    return jax is not None and isinstance(value, jax.core.Tracer)
