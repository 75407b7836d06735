"""`msf_jax.torch.follow`: `msf_jax.follow` as a function of PyTorch, with its derivative.

Tensors and JAX's arrays share their memory (DLPack). The derivative is JAX's, computed from the saved vertices when
PyTorch asks for it. PyTorch is imported on the first call; this package does not depend on it.
"""

import importlib
from functools import lru_cache
from typing import Any

import jax
import jax.numpy as jnp

from msf_jax.base.errors import ConfigError, MeshError
from msf_jax.device import following
from msf_jax.device.buffers import real_dtype
from msf_jax.gradients import follow as by_jax
from msf_jax.gradients.batch import Batch
from msf_jax.gradients.follow import Followed


def follow(skeleton: Any, vertices: Any) -> Followed:
    """`msf_jax.follow` of a ``torch.Tensor``, for a loss in PyTorch; see there.

    Args:
        skeleton: a `Skeleton`, its ``binding``, or a `Batch` of `msf_jax.stack`.
        vertices: (V, 3) tensor, float32 or float64; of a batch (B, V, 3), as ``batch.vertices`` has it.

    Returns:
        Tensors of the type and on the device of ``vertices``: nodes (N, 3) and radii (N,), of a batch with B before. As
        in JAX, rows of padding are 0, and so is their gradient: see ``batch.node_mask`` and ``batch.vertex_mask``.

    Differentiable in: vertices, once.

    Raises:
        ConfigError: PyTorch is not installed, or JAX has no float64 for a float64 tensor.
        MeshError: ``vertices`` is no tensor of real numbers, has another shape, or is not finite.
    """
    torch = _imported()
    if not isinstance(vertices, torch.Tensor):
        raise MeshError(
            f"vertices is a {type(vertices).__name__}: expected a torch.Tensor; msf_jax.follow takes arrays"
        )
    if vertices.dtype not in (torch.float32, torch.float64):
        raise MeshError(f"vertices has the type {vertices.dtype}: expected torch.float32 or torch.float64")
    if vertices.dtype == torch.float64 and real_dtype() != jnp.float64:
        raise ConfigError(
            "vertices is float64, and JAX would compute in float32: expected vertices.float(), or "
            'jax.config.update("jax_enable_x64", True) at the start'
        )
    if isinstance(skeleton, Batch) and tuple(vertices.shape) != skeleton.vertices.shape:
        raise MeshError(f"vertices has shape {tuple(vertices.shape)}: expected {skeleton.vertices.shape}, as the batch")
    return Followed(*_function().apply(vertices, skeleton))


def _imported() -> Any:
    try:
        return importlib.import_module("torch")
    except ImportError as error:
        raise ConfigError("msf_jax.torch needs PyTorch: install it with pip install torch") from error


@lru_cache(1)
def _function() -> Any:
    """The `torch.autograd.Function`, which can only be defined where PyTorch is."""
    torch = _imported()

    def backward(ctx: Any, *slopes: Any) -> tuple[Any, None]:
        (vertices,) = ctx.saved_tensors
        found = _pulled(ctx.skeleton, _to_jax(vertices), *map(_to_jax, slopes))
        return torch.from_dlpack(found).to(vertices.dtype), None

    class Follow(torch.autograd.Function):
        @staticmethod
        def forward(ctx: Any, vertices: Any, skeleton: Any) -> tuple[Any, ...]:
            ctx.save_for_backward(vertices)
            ctx.skeleton = skeleton
            array = _to_jax(vertices)
            found = (
                _of_batch(skeleton.bindings, array) if isinstance(skeleton, Batch) else by_jax.follow(skeleton, array)
            )
            return tuple(torch.from_dlpack(part).to(vertices.dtype) for part in found)

    Follow.backward = staticmethod(torch.autograd.function.once_differentiable(backward))
    return Follow


def _to_jax(tensor: Any) -> jax.Array:
    return jax.dlpack.from_dlpack(tensor.detach().contiguous())


@jax.jit
def _of_batch(bindings: Any, vertices: jax.Array) -> Any:
    return jax.vmap(_plain)(bindings, vertices)


def _plain(binding: Any, vertices: jax.Array) -> Any:
    with jax.numpy_dtype_promotion("standard"), jax.numpy_rank_promotion("allow"):
        return tuple(following.follow(binding, vertices))


def _pulled(skeleton: Any, vertices: jax.Array, nodes: jax.Array, radii: jax.Array) -> jax.Array:
    """The slope of the vertices, from those of the ``nodes`` and the ``radii``."""
    if isinstance(skeleton, Batch):
        return _pull_batch(skeleton.bindings, vertices, nodes, radii)
    binding = by_jax.binding_of(skeleton)
    rows, rest = binding.num_vertices - len(vertices), len(binding.node_mask) - len(nodes)
    padded = jnp.pad(vertices, ((0, rows), (0, 0)))
    return _pull(binding, padded, jnp.pad(nodes, ((0, rest), (0, 0))), jnp.pad(radii, (0, rest)))[: len(vertices)]


def _slope(binding: Any, vertices: jax.Array, nodes: jax.Array, radii: jax.Array) -> jax.Array:
    found, pull = jax.vjp(lambda moved: _plain(binding, moved), vertices)
    return pull(tuple(slope.astype(part.dtype) for part, slope in zip(found, (nodes, radii), strict=True)))[0]


_pull, _pull_batch = jax.jit(_slope), jax.jit(jax.vmap(_slope))
