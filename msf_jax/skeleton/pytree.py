"""A skeleton as a pytree: it can be an argument of a jitted function, be mapped over, and be written by its leaves.

Its leaves are its arrays, and those of its binding where it has one. Its report and what it was made from are static: a
function that is jitted over a skeleton is compiled for that one. Its ``binding`` has nothing static, and shares
programs.
"""

from typing import Any

import jax

NAMES = ("vertices", "edges", "radii", "mesh_map")


class Static:
    """What of a skeleton is no array. It is equal where it is the same report and source: to compare them is slow."""

    def __init__(self, skeleton: Any):
        self.report, self.source, self.roots = skeleton.report, skeleton.source, skeleton.roots

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Static):
            return False
        return self.report is other.report and self.source is other.source and self.roots == other.roots

    def __hash__(self) -> int:
        return hash((id(self.report), id(self.source), self.roots))


def register(kind: Any) -> None:
    """Declare the class `Skeleton` a pytree."""

    def leaves(skeleton: Any) -> tuple[tuple[Any, ...], Static]:
        has_binding = "binding" in vars(skeleton) or (skeleton.source and skeleton.source.input_of_vertex is not None)
        arrays = (getattr(skeleton, name) for name in NAMES)
        return (*arrays, skeleton.binding if has_binding else None), Static(skeleton)

    def named(skeleton: Any) -> tuple[tuple[Any, ...], Static]:
        found, static = leaves(skeleton)
        return tuple(zip(map(jax.tree_util.GetAttrKey, (*NAMES, "binding")), found, strict=True)), static

    def whole(static: Static, children: Any) -> Any:
        """Unchecked: JAX puts axes, masks and gradients there."""
        skeleton = object.__new__(kind)
        *arrays, binding = children
        vars(skeleton).update(zip(NAMES, arrays, strict=True))
        vars(skeleton).update(report=static.report, source=static.source, roots=static.roots)
        if binding is not None:
            vars(skeleton)["binding"] = binding
        return skeleton

    jax.tree_util.register_pytree_with_keys(kind, named, whole, leaves)
