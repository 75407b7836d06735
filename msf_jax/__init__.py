"""Curve skeletons of closed triangle meshes by Medial Skeletonization Flow, as a differentiable JAX program.

skeleton = msf_jax.skeletonize("hand.off")
print(skeleton.report)
skeleton.save("hand.swc")
"""

import re
from importlib import import_module
from pathlib import Path
from typing import Any

from msf_jax.base import version

# The public names and their modules, as editors and type checkers read them. A module is imported when one of its names
# is used first: a program that needs no JAX does not import it.
_STUB = Path(__file__).with_suffix(".pyi").read_text("utf-8")
_HOMES = {name: home for home, name in re.findall(r"^from (\S+) import (\w+) as ", _STUB, re.MULTILINE)}
__version__ = version.VERSION
__all__ = sorted(_HOMES)  # pyright: ignore[reportUnsupportedDunderAll]


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    home = import_module(_HOMES[name])
    globals()[name] = value = vars(home).get(name) or import_module(f"{home.__name__}.{name}")  # or a module in it
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
