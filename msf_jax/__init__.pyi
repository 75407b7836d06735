"""The public names of `__init__.py`, for editors and type checkers."""

from msf_jax import guide as guide
from msf_jax import metrics as metrics
from msf_jax import shapes as shapes
from msf_jax import view as view
from msf_jax.app import batch as batch
from msf_jax.base.binding import Binding as Binding
from msf_jax.base.errors import ConfigError as ConfigError
from msf_jax.base.errors import FlowError as FlowError
from msf_jax.base.errors import Interrupted as Interrupted
from msf_jax.base.errors import MeshError as MeshError
from msf_jax.base.options import Config as Config
from msf_jax.base.options import CurveOptions as CurveOptions
from msf_jax.base.options import FlowOptions as FlowOptions
from msf_jax.base.options import PreprocessingOptions as PreprocessingOptions
from msf_jax.base.options import SolverOptions as SolverOptions
from msf_jax.device import Weights as Weights  # importing `device` registers it as a pytree
from msf_jax.flow.loop import contract as contract
from msf_jax.flow.loop import skeletonize as skeletonize
from msf_jax.flow.programs import cache_compilations as cache_compilations
from msf_jax.flow.state import Flow as Flow
from msf_jax.gradients import losses as losses
from msf_jax.gradients import measures as measures
from msf_jax.gradients import torch as torch
from msf_jax.gradients.follow import Followed as Followed
from msf_jax.gradients.follow import follow as follow
from msf_jax.gradients.follow import stack as stack
from msf_jax.gradients.replay import Tape as Tape
from msf_jax.gradients.replay import replay as replay
from msf_jax.gradients.replay import replay_meso as replay_meso
from msf_jax.gradients.track import Track as Track
from msf_jax.gradients.track import track as track
from msf_jax.meshes.reading import MeshLike as MeshLike
from msf_jax.meshes.reading import read_mesh as read_mesh
from msf_jax.meshes.repair import Repair as Repair
from msf_jax.preprocessing import reconstruct as reconstruct
from msf_jax.preprocessing import voronoi_poles as voronoi_poles
from msf_jax.skeleton.formats.importing import read_curve as read_curve
from msf_jax.skeleton.framing import Frame as Frame
from msf_jax.skeleton.pruning import Branch as Branch
from msf_jax.skeleton.report import Report as Report
from msf_jax.skeleton.rigging.rig import Rig as Rig
from msf_jax.skeleton.skeleton import Skeleton as Skeleton
from msf_jax.tuning.tuner import Tuned as Tuned
from msf_jax.tuning.tuner import tune as tune

__version__: str
