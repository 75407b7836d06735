"""Curve skeletons of closed triangle meshes by Medial Skeletonization Flow, as a differentiable JAX program.

import msf_jax

skeleton = msf_jax.skeletonize("hand.off")
print(skeleton.report)
skeleton.save("hand.swc")
"""

from msf_jax import batch, ground_truth, guide, metrics, objectives, shapes, view
from msf_jax.errors import ConfigError, FlowError, Interrupted, MeshError
from msf_jax.flow import Flow, contract
from msf_jax.host.branches import Branch
from msf_jax.host.repair import Repair
from msf_jax.importing import read_curve
from msf_jax.options import Config, Weights
from msf_jax.preprocessing import reconstruct, voronoi_poles
from msf_jax.replaying import replay, replay_meso, replay_radii
from msf_jax.sensitivity import sensitivity
from msf_jax.skeleton import Report, Skeleton
from msf_jax.skeletonize import skeletonize
from msf_jax.tape import Tape
from msf_jax.tuning import Tuned, tune

__all__ = [
    "Branch",
    "Config",
    "ConfigError",
    "Flow",
    "FlowError",
    "Interrupted",
    "MeshError",
    "Repair",
    "Report",
    "Skeleton",
    "Tape",
    "Tuned",
    "Weights",
    "batch",
    "contract",
    "ground_truth",
    "guide",
    "metrics",
    "objectives",
    "read_curve",
    "reconstruct",
    "replay",
    "replay_meso",
    "replay_radii",
    "sensitivity",
    "shapes",
    "skeletonize",
    "tune",
    "view",
    "voronoi_poles",
]

__version__ = "0.2.0"
