"""Curve skeletons of closed triangle meshes by Medial Skeletonization Flow, as a differentiable JAX program.

import msf_jax

skeleton = msf_jax.skeletonize("hand.off")
print(skeleton.report)
skeleton.save("hand.swc")
"""

import importlib
from typing import Any

from msf_jax.base import version

# The public names of each module, which is imported when one of them is used first: a program that needs no JAX does
# not import it. Editors and type checkers read `__init__.pyi`.
_NAMES = {
    "": "guide metrics shapes view",
    "app": "batch",
    "base.binding": "Binding",
    "base.errors": "ConfigError FlowError Interrupted MeshError",
    "base.options": "Config CurveOptions FlowOptions PreprocessingOptions SolverOptions read_weights save_weights",
    "device": "Weights",
    "flow.loop": "contract",
    "flow.programs": "cache_compilations",
    "flow.skeletonize": "skeletonize",
    "flow.state": "Flow",
    "gradients": "losses torch",
    "gradients.batch": "Batch stack",
    "gradients.follow": "Followed follow",
    "gradients.replay": "replay replay_meso replay_radii",
    "gradients.tape": "Tape",
    "gradients.track": "Track track",
    "inside.preprocessing": "reconstruct voronoi_poles",
    "limbs.one_branch": "Branch",
    "meshes.reading": "MeshLike read_mesh",
    "meshes.repair": "Repair",
    "skeleton.formats.importing": "read_curve",
    "skeleton.framing": "Frame",
    "skeleton.report": "Report",
    "skeleton.rigging.rig": "Rig",
    "skeleton.skeleton": "Skeleton",
    "tuning": "objectives",
    "tuning.tuner": "Tuned tune",
}
_HOMES = {name: module for module, names in _NAMES.items() for name in names.split()}

__version__ = version.VERSION
__all__ = sorted(_HOMES)  # pyright: ignore[reportUnsupportedDunderAll]


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    home = importlib.import_module(f"{__name__}.{_HOMES[name]}".rstrip("."))
    # A name that its home does not define is a module in it, and so is each name of this package itself.
    is_module = not _HOMES[name] or not hasattr(home, name)
    value = importlib.import_module(f"{home.__name__}.{name}") if is_module else getattr(home, name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
