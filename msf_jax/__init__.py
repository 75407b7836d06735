"""Curve skeletons of closed triangle meshes by Medial Skeletonization Flow, as a differentiable JAX program.

import msf_jax

skeleton = msf_jax.skeletonize("hand.off")
print(skeleton.report)
skeleton.save("hand.swc")
"""

import ast
import pkgutil
import sys
from typing import Any

from msf_jax.base import version
from msf_jax.base.clock import imported

_STUB = ast.parse(pkgutil.get_data(__name__, "__init__.pyi") or b"")
# The module of each public name. It is imported on first access: a program that needs no JAX does not import it.
_HOMES = {
    alias.name: str(node.module) for node in _STUB.body if isinstance(node, ast.ImportFrom) for alias in node.names
}

__version__ = version.VERSION
__all__ = sorted(_HOMES)  # pyright: ignore[reportUnsupportedDunderAll]


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    home = imported(_HOMES[name])
    # A name that its home does not define is a module in it. A module of this package is none of its names yet.
    is_module = home is sys.modules[__name__] or not hasattr(home, name)
    value = imported(f"{_HOMES[name]}.{name}") if is_module else getattr(home, name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
