"""The records of a run: `Iteration`, a line of its history; `State`, while it goes on; `Flow`, when it has ended."""

import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple

import numpy as np

from msf_jax.base.options import Config, Weights
from msf_jax.gradients.tape import Tape, record
from msf_jax.host.mesh.checking import Component
from msf_jax.host.meso.meso import Meso
from msf_jax.host.recording.records import Recording, Start, Step
from msf_jax.host.solid.enclosure import Enclosure
from msf_jax.host.solid.frame import Frame
from msf_jax.skeleton.skeleton import Skeleton
from msf_jax.skeleton.source import Source


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
    is_solved: bool  # whether it and the smoothing reached their tolerance
    smoothing_steps: int
    smoothing_residual: float
    moved: float  # largest displacement
    redone: int = 0  # times that the step was tried again, shorter, as its numbers were not sensible


class Limits(NamedTuple):
    """Bounds of a run that are no option of the user's.

    checkpoint_every: iterations between two writes. growth, growth_room: splitting may take the surface to so many
    times its first vertices, and so many. retries: of a step that has left sensible numbers.
    """

    checkpoint_every: int = 5
    growth: int = 3
    growth_room: int = 1000
    retries: int = 3


LIMITS = Limits()


@dataclass
class State:
    """A component under contraction.

    The first group is set once; the second changes with every iteration.
    """

    component: Component
    number: int
    frame: Frame
    order: np.ndarray  # (V,) the component's vertex that each of the sorted ones is
    shape: Enclosure  # the input's surface, in the frame
    coarse: Enclosure  # the same after coarsening, where that took most of it
    pins: np.ndarray  # sorted vertices that are held in place
    first_volume: float
    first_area: float
    max_rows: int
    num_coarsened: int
    first_ring_area: np.ndarray
    poles: np.ndarray
    has_pole: np.ndarray
    start: Start  # what the tape needs to know of it

    meso: Meso
    t_c: float
    w_L_factor: float
    capacity: int = 0  # of the buffers that it was in, see `layout.layout_after`
    history: list[Iteration] = field(default_factory=list)
    steps: list[Step] = field(default_factory=list)  # for the tape
    failure: str = ""  # why it cannot go on


@dataclass(frozen=True, eq=False)
class Flow:
    """A run, opened up. All coordinates are in the caller's units.

    Attributes:
        weights, config: what the run used.
        meso_skeleton: ``(vertices (n, 3), faces (m, 3))`` of the contracted surface, all components together.
        is_fixed: (n,) True where a vertex of the meso-skeleton was fixed.
        poles: (V, 3) the Voronoi pole that each vertex of the repaired input started with, near the vertex itself
            where it has none; where it was merged by coarsening or resampling, that of the vertex it went into.
        has_pole: (V,) whether that pole pulls.
        history: one `Iteration` for each iteration of each component.
        curve: the curve as the flow left it, without the branches that were pruned, and with one node where finishing
            has made one of several.
        skeleton: the finished curve; its first nodes are those of ``curve``, moved, and new ones come last.
        recording, source: what the tape is made from.
        tape: what the run decided, for `replay`; made when first asked for.
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

    def tape_like(self, tape: Tape) -> Tape:
        """The tape of this run, padded, in buffers as large as those of ``tape``, wherever this run has room in them.

        For the tape of a run on the same mesh, moved a little, or at other weights: a function that was jitted over
        ``tape.padded()`` then serves both, although this run took more iterations, or cut more. What has no room gets
        larger buffers, and another program.
        """
        found = record(self.recording, self.weights, self.config, self.curve, self.source, tape)
        return found.padded(tape)

    def __repr__(self) -> str:
        return f"Flow({len(self.history)} iterations, {self.skeleton!r})"


class Stopwatch:
    """Seconds by stage, added up."""

    def __init__(self) -> None:
        self.seconds: dict[str, float] = {}

    @contextmanager
    def stage(self, name: str) -> Iterator[None]:
        """Add the time spent inside to stage ``name``."""
        start = time.perf_counter()
        try:
            yield
        finally:
            self.seconds[name] = self.seconds.get(name, 0.0) + time.perf_counter() - start
