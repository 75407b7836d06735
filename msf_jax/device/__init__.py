"""Jitted, differentiable steps on padded buffers, in JAX only. `Weights` are registered as a pytree here, so that
options and the command line's help do not import JAX."""

from typing import Any

from jax.tree_util import GetAttrKey, register_pytree_with_keys

from msf_jax.base.options import Weights

__all__ = ["Weights"]


def _unchecked(names: tuple[str, ...], leaves: Any) -> Weights:
    """`Weights` built without checks, because JAX also passes axes, masks and gradients."""
    weights = object.__new__(Weights)
    vars(weights).update(zip(names, leaves, strict=True))
    return weights


register_pytree_with_keys(
    Weights,
    lambda weights: ([(GetAttrKey(name), leaf) for name, leaf in vars(weights).items()], tuple(vars(weights))),
    _unchecked,
)
