"""Curve skeletons of closed triangle meshes by Medial Skeletonization Flow, as a differentiable JAX program.

skeleton = msf_jax.skeletonize("hand.off")
print(skeleton.report)
skeleton.save("hand.swc")
"""

from importlib import import_module
from typing import Any

from msf_jax.base import version

# The public modules, and the public names of others. A module is imported when it is used first: a program that needs
# no JAX does not import it. Editors and type checkers read `__init__.pyi`.
_PATHS = ["app.batch", "guide", "metrics", "shapes", "view"]
_PATHS += ["gradients.losses", "gradients.measures", "gradients.torch"]
_NAMES = {
    "base.binding": "Binding",
    "base.errors": "ConfigError FlowError Interrupted MeshError",
    "base.options": "Config CurveOptions FlowOptions PreprocessingOptions SolverOptions",
    "device": "Weights",
    "flow.loop": "contract skeletonize",
    "flow.programs": "cache_compilations",
    "flow.state": "Flow",
    "gradients.follow": "Followed follow stack",
    "gradients.replay": "Tape replay replay_meso",
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
    "tuning.tuner": "Tuned tune",
}
_MODULES = {path.rpartition(".")[2]: path for path in _PATHS}
_HOMES = _MODULES | {name: home for home, names in _NAMES.items() for name in names.split()}
__version__ = version.VERSION
__all__ = sorted(_HOMES)  # pyright: ignore[reportUnsupportedDunderAll]


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    home = import_module(f"{__name__}.{_HOMES[name]}")
    globals()[name] = value = home if name in _MODULES else getattr(home, name)
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
