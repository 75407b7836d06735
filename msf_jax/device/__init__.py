"""Jitted, differentiable steps on padded buffers, in JAX only.

`Weights` are registered as a pytree here, and not where they are defined, so that options and the command line's help
do not import JAX.
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
    """`Weights` built without checks, because JAX also passes axes, masks and gradients."""
    weights = object.__new__(Weights)
    for name, leaf in zip(_NAMES, leaves, strict=True):
        object.__setattr__(weights, name, leaf)
    return weights


jax.tree_util.register_pytree_with_keys(Weights, _named_leaves, _unchecked, _leaves)
