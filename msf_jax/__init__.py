"""Curve skeletons of closed triangle meshes by Medial Skeletonization Flow, as a differentiable JAX program.

import msf_jax

skeleton = msf_jax.skeletonize("hand.off")
print(skeleton.report)
skeleton.save("hand.swc")
"""

import importlib
from typing import TYPE_CHECKING, Any

from msf_jax.base import version

if TYPE_CHECKING:
    from msf_jax import ground_truth, guide, metrics, shapes, view
    from msf_jax.app import batch
    from msf_jax.base.binding import Binding
    from msf_jax.base.errors import ConfigError, FlowError, Interrupted, MeshError
    from msf_jax.base.options import Config, Weights
    from msf_jax.base.weights import read_weights, save_weights
    from msf_jax.device.caching import cache_compilations
    from msf_jax.flow.loop import contract
    from msf_jax.flow.skeletonize import skeletonize
    from msf_jax.flow.state import Flow
    from msf_jax.gradients import losses, torch
    from msf_jax.gradients.batch import Batch, stack
    from msf_jax.gradients.follow import Followed, follow
    from msf_jax.gradients.replay import replay, replay_meso, replay_radii
    from msf_jax.gradients.sensitivity import sensitivity
    from msf_jax.gradients.tape import Tape
    from msf_jax.gradients.track import Track, track
    from msf_jax.inside.preprocessing import reconstruct, voronoi_poles
    from msf_jax.limbs.pruning import Branch
    from msf_jax.meshes.reading import read_mesh
    from msf_jax.meshes.repair import Repair
    from msf_jax.skeleton.formats.importing import read_curve
    from msf_jax.skeleton.framing.frame import Frame
    from msf_jax.skeleton.report import Report
    from msf_jax.skeleton.rigging.rig import Rig
    from msf_jax.skeleton.skeleton import Skeleton
    from msf_jax.tuning import objectives
    from msf_jax.tuning.result import Tuned
    from msf_jax.tuning.tuner import tune

# The module of each public name. It is imported on first access: a program that needs no JAX does not import it.
_MODULES = {
    "batch": "app.batch",
    "ground_truth": "ground_truth",
    "guide": "guide",
    "losses": "gradients.losses",
    "metrics": "metrics",
    "objectives": "tuning.objectives",
    "shapes": "shapes",
    "torch": "gradients.torch",
    "view": "view",
}
_HOMES = {
    "Batch": "gradients.batch",
    "Binding": "base.binding",
    "Branch": "limbs.pruning",
    "Config": "base.options",
    "ConfigError": "base.errors",
    "Flow": "flow.state",
    "FlowError": "base.errors",
    "Followed": "gradients.follow",
    "Frame": "skeleton.framing.frame",
    "Interrupted": "base.errors",
    "MeshError": "base.errors",
    "Repair": "meshes.repair",
    "Report": "skeleton.report",
    "Rig": "skeleton.rigging.rig",
    "Skeleton": "skeleton.skeleton",
    "Tape": "gradients.tape",
    "Track": "gradients.track",
    "Tuned": "tuning.result",
    "Weights": "device",  # importing `device` registers it as a pytree
    "cache_compilations": "device.caching",
    "contract": "flow.loop",
    "follow": "gradients.follow",
    "read_curve": "skeleton.formats.importing",
    "read_mesh": "meshes.reading",
    "read_weights": "base.weights",
    "reconstruct": "inside.preprocessing",
    "replay": "gradients.replay",
    "replay_meso": "gradients.replay",
    "replay_radii": "gradients.replay",
    "save_weights": "base.weights",
    "sensitivity": "gradients.sensitivity",
    "skeletonize": "flow.skeletonize",
    "stack": "gradients.batch",
    "track": "gradients.track",
    "tune": "tuning.tuner",
    "voronoi_poles": "inside.preprocessing",
}

__version__ = version.VERSION

__all__ = [
    "Batch",
    "Binding",
    "Branch",
    "Config",
    "ConfigError",
    "Flow",
    "FlowError",
    "Followed",
    "Frame",
    "Interrupted",
    "MeshError",
    "Repair",
    "Report",
    "Rig",
    "Skeleton",
    "Tape",
    "Track",
    "Tuned",
    "Weights",
    "batch",
    "cache_compilations",
    "contract",
    "follow",
    "ground_truth",
    "guide",
    "losses",
    "metrics",
    "objectives",
    "read_curve",
    "read_mesh",
    "read_weights",
    "reconstruct",
    "replay",
    "replay_meso",
    "replay_radii",
    "save_weights",
    "sensitivity",
    "shapes",
    "skeletonize",
    "stack",
    "torch",
    "track",
    "tune",
    "view",
    "voronoi_poles",
]


def __getattr__(name: str) -> Any:
    if name in _MODULES:
        value = importlib.import_module(f"{__name__}.{_MODULES[name]}")
    elif name in _HOMES:
        value = getattr(importlib.import_module(f"{__name__}.{_HOMES[name]}"), name)
    else:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
