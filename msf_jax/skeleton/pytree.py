"""A skeleton as a pytree, for jitted functions, `jax.tree.map`, and libraries that save leaves.

Its leaves are its arrays, and those of its binding if it has one. Its report and its source are static, so a jitted
function of a skeleton is compiled for each skeleton. Its ``binding`` has no static fields, and shares programs.
"""

import dataclasses
from typing import Any

import jax

NAMES = ("vertices", "edges", "radii", "mesh_map")  # attributes of a skeleton that are leaves


class Static:
    """The static part of a skeleton. Report and source are compared by identity, because comparing values is slow."""

    def __init__(self, skeleton: Any):
        names = [field.name for field in dataclasses.fields(skeleton) if field.name not in NAMES]
        self.values = {name: getattr(skeleton, name) for name in names}
        self._key = tuple(id(value) if name in ("report", "source") else value for name, value in self.values.items())

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Static) and self._key == other._key

    def __hash__(self) -> int:
        return hash(self._key)


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
        """Built without checks, because JAX also passes axes, masks and gradients."""
        skeleton = object.__new__(kind)
        *arrays, binding = children
        vars(skeleton).update(zip(NAMES, arrays, strict=True))
        vars(skeleton).update(static.values)
        if binding is not None:
            vars(skeleton)["binding"] = binding
        return skeleton

    jax.tree_util.register_pytree_with_keys(kind, named, whole, leaves)
