"""The device wing: jitted, differentiable steps on padded buffers, in JAX only.

Whoever asks for it can pass `Weights` through JAX: they are declared a pytree here, so that options and the command
line's help need not wait for JAX.
"""

from dataclasses import fields
from typing import Any

import jax

from msf_jax.base.options import Weights

__all__ = ["Weights"]

_NAMES = tuple(field.name for field in fields(Weights))


def _leaves(weights: Weights) -> tuple[tuple[Any, ...], None]:
    return tuple(getattr(weights, name) for name in _NAMES), None


def _named_leaves(weights: Weights) -> tuple[tuple[tuple[Any, Any], ...], None]:
    return tuple((jax.tree_util.GetAttrKey(name), getattr(weights, name)) for name in _NAMES), None


def _unchecked(_: None, leaves: Any) -> Weights:
    """A tree of the same shape, unchecked: JAX puts axes, masks and gradients there."""
    weights = object.__new__(Weights)
    for name, leaf in zip(_NAMES, leaves, strict=True):
        object.__setattr__(weights, name, leaf)
    return weights


jax.tree_util.register_pytree_with_keys(Weights, _named_leaves, _unchecked, _leaves)
