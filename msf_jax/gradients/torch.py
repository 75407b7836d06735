"""`msf_jax.torch.follow`: `msf_jax.follow` as a function of PyTorch, with JAX's derivative, in shared memory (DLPack).
PyTorch is imported on the first call."""

import importlib
from functools import lru_cache
from typing import Any

import jax
import jax.numpy as jnp

from msf_jax.base.errors import ConfigError, MeshError
from msf_jax.device.buffers import real_dtype
from msf_jax.gradients import follow as by_jax
from msf_jax.gradients.follow import Followed


def follow(skeleton: Any, vertices: Any) -> Followed:
    """`msf_jax.follow` of a ``torch.Tensor`` (V, 3), float32 or float64: tensors of its type and on its device.

    Differentiable in: vertices, once.

    Raises:
        ConfigError: PyTorch is not installed, or JAX has no float64 for a float64 tensor; or see `msf_jax.follow`.
        MeshError: ``vertices`` is no such tensor; or see there.
    """
    try:
        torch = importlib.import_module("torch")
    except ImportError as error:
        raise ConfigError("msf_jax.torch needs PyTorch: install it with pip install torch") from error
    if not isinstance(vertices, torch.Tensor) or vertices.dtype not in (torch.float32, torch.float64):
        kind = getattr(vertices, "dtype", "")
        raise MeshError(f"vertices is a {type(vertices).__name__} {kind}: expected a torch.Tensor, float32 or float64")
    if vertices.dtype == torch.float64 and real_dtype() != jnp.float64:
        raise ConfigError(
            "vertices is float64, and JAX would compute in float32: expected vertices.float(), or "
            'jax.config.update("jax_enable_x64", True) at the start'
        )
    return Followed(*_function(torch).apply(vertices, skeleton))


@lru_cache(1)
def _function(torch: Any) -> Any:
    """The `torch.autograd.Function`, which can only be defined where PyTorch is."""

    def backward(ctx: Any, *slopes: Any) -> tuple[Any, None]:
        (vertices,) = ctx.saved_tensors
        _, pull = jax.vjp(lambda moved: tuple(by_jax.follow(ctx.skeleton, moved)), _to_jax(vertices))
        return torch.from_dlpack(pull(tuple(map(_to_jax, slopes)))[0]), None

    class Follow(torch.autograd.Function):
        @staticmethod
        def forward(ctx: Any, vertices: Any, skeleton: Any) -> tuple[Any, ...]:
            ctx.save_for_backward(vertices)
            ctx.skeleton = skeleton
            return tuple(map(torch.from_dlpack, by_jax.follow(skeleton, _to_jax(vertices))))

    Follow.backward = staticmethod(torch.autograd.function.once_differentiable(backward))
    return Follow


def _to_jax(tensor: Any) -> jax.Array:
    return jax.dlpack.from_dlpack(tensor.detach().contiguous())
