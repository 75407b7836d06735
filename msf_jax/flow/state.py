"""The records of a run: `Iteration`, a line of its history; `State`, while it goes on; `Flow`, when it has ended."""

import numbers
from concurrent.futures import Future
from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple

import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.base.options import Config, Weights
from msf_jax.gradients.tape import Tape, record
from msf_jax.meshes.checking import Component
from msf_jax.meso import ring_tables
from msf_jax.meso.meso import Meso
from msf_jax.recording.records import Recording, Start, Step
from msf_jax.skeleton.skeleton import Skeleton, Source, Stage
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.frame import UnitFrame


class Iteration(NamedTuple):
    """One line of the history. Lengths are fractions of the component's diagonal."""

    component: int
    iteration: int
    t_c: float  # collapse threshold in this iteration
    live: int  # vertices of the surface after it
    fixed: int  # of which fixed
    collapses: int
    splits: int
    volume: float  # fraction of the first volume that is left
    area: float  # fraction of the first surface area that is left
    steps: int  # CG steps of the contraction
    residual: float  # relative residual at the end of it
    smoothing_steps: int
    smoothing_residual: float
    moved: float  # largest displacement
    redone: int = 0  # times that the step was repeated with a smaller w_L, because its coordinates diverged
    has_ended: bool = True  # whether both solves ended by their tolerances, and not by the number of steps


class Limits(NamedTuple):
    """Bounds of a run that are not options of the user."""

    growth: int = 3  # splits may grow the surface to this multiple of its first number of vertices,
    growth_margin: int = 1000  # plus this many vertices
    retries: int = 3  # of a step whose coordinates are not finite or diverge


LIMITS = Limits()


@dataclass
class State:
    """A component under contraction.

    The first group is set once; the second changes with every iteration.
    """

    component: Component
    number: int
    frame: UnitFrame
    order: np.ndarray  # (V,) the component's vertex for each sorted vertex
    shape: Enclosure  # the input's surface, in the frame
    solid: Enclosure  # the same with the solid's cavities, if it has any
    coarse: Enclosure  # the coarsened surface, if coarsening removed most vertices; else ``shape``
    pins: np.ndarray  # ids of sorted vertices that are held in place
    first_volume: float
    first_area: float
    max_rows: int
    num_coarsened: int
    first_ring_area: np.ndarray
    poles: np.ndarray
    has_pole: np.ndarray
    start: Start  # the record of the preparation, for the tape

    meso: Meso
    t_c: float
    w_L_factor: float
    caps: Future | None  # of ``coarse``, measured by the worker; None if limbs are not asked for, or known
    capacity: int = 0  # of the last buffers, see `layout.layout_after`
    history: list[Iteration] = field(default_factory=list)
    steps: list[Step] = field(default_factory=list)  # for the tape
    failure: str = ""  # why the flow cannot continue; empty if it can


def stage_at(
    iteration: int, steps: list[list[Step]], frames: list[UnitFrame], ends: list[tuple[np.ndarray, ...]]
) -> Stage:
    """The surface after ``iteration`` iterations, all components together, each with its ``steps`` and frame. ``ends``
    are the last vertices, faces and is_fixed of each, for components that had ended before."""
    vertices, faces, is_fixed, num = [], [], [], 0
    for own, frame, end in zip(steps, frames, ends, strict=True):
        if iteration < len(own):
            step = own[iteration]
            is_past = np.arange(step.rings.shape[1]) >= step.degree[:, None]
            faces.append(ring_tables.faces_from_rings(np.where(is_past, -1, step.rings)) + num)
            vertices.append(frame.leave(step.positions))
            is_fixed.append(~step.free.astype(bool))
        else:
            vertices.append(end[0])
            faces.append(end[1] + num)
            is_fixed.append(end[2])
        num += len(vertices[-1])
    return Stage(iteration, np.concatenate(vertices), np.concatenate(faces).astype(np.int32), np.concatenate(is_fixed))


@dataclass(frozen=True, eq=False)
class Flow:
    """All results of a run. All coordinates are in the caller's units.

    Attributes:
        weights, config: those of the run.
        meso_skeleton: ``(vertices (n, 3), faces (m, 3))`` of the contracted surface, all components together.
        is_fixed: (n,) True where a vertex of the meso-skeleton was fixed.
        poles: (V, 3) the first Voronoi pole of each vertex of the repaired input. A vertex without a pole has a point
            near itself. A vertex that coarsening or resampling merged has the pole of the merged vertex.
        has_pole: (V,) whether that pole pulls.
        history: one `Iteration` for each iteration of each component.
        curve: the flow's curve, without pruned branches. Nodes that finishing merged are one node here, too.
        skeleton: the finished curve. Its first nodes are those of ``curve``, moved; new nodes come last.
        recording, source: the data for the tape.
        tape: the recorded decisions of the run, for `replay`; made on first access.
    """

    weights: Weights
    config: Config
    meso_skeleton: tuple[np.ndarray, np.ndarray]
    is_fixed: np.ndarray
    poles: np.ndarray
    has_pole: np.ndarray
    history: tuple[Iteration, ...]
    curve: Skeleton
    skeleton: Skeleton
    recording: Recording = field(repr=False)
    source: Source = field(repr=False)

    @cached_property
    def tape(self) -> Tape:
        return record(self.recording, self.weights, self.config, self.curve, self.source)

    def surface(self, iteration: int) -> Stage:
        """The surface after that many iterations, with its ``vertices`` (n, 3), ``faces`` (m, 3) and ``is_fixed`` (n,),
        all components together; 0 is the surface at the start.

        Raises:
            ConfigError: there were fewer iterations.
        """
        records = self.recording.components
        most = max(len(one.steps) for one in records)
        if isinstance(iteration, bool) or not isinstance(iteration, numbers.Integral) or not 0 <= iteration <= most:
            raise ConfigError(f"iteration is {iteration!r}: expected a whole number from 0 to {most}")
        first = np.cumsum([one.num_meso for one in records])[:-1]
        vertices, faces = self.meso_skeleton
        of_face = np.searchsorted(first, faces[:, 0], side="right")
        ends = [
            (own, faces[of_face == number] - (first[number - 1] if number else 0), fixed)
            for number, (own, fixed) in enumerate(
                zip(np.split(vertices, first), np.split(self.is_fixed, first), strict=True)
            )
        ]
        steps, frames = [list(one.steps) for one in records], [one.frame for one in records]
        return stage_at(int(iteration), steps, frames, ends)

    def __repr__(self) -> str:
        return f"Flow({len(self.history)} iterations, {self.skeleton!r})"
