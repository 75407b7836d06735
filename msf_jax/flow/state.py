"""The records of a run: `Iteration`, a line of its history; `State`, while it goes on; `Flow`, when it has ended."""

import numbers
from concurrent.futures import Future
from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple

import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.base.options import Config, Weights
from msf_jax.gradients.replay import Tape, record
from msf_jax.meso import ring_tables
from msf_jax.meso.frame import UnitFrame
from msf_jax.meso.meso import Meso
from msf_jax.recording.records import ComponentRecord, Recording, Start, Step
from msf_jax.skeleton.skeleton import Skeleton, Source, Stage
from msf_jax.solid.enclosure import Enclosure


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


@dataclass
class State:
    """A component under contraction. The first group is set once; the second changes with every iteration."""

    number: int  # of the component
    frame: UnitFrame
    order: np.ndarray  # (V,) the component's vertex for each sorted vertex
    outside: Enclosure  # the input's surface, in the frame
    shape: Enclosure  # the same with the solid's cavities, if it has any
    coarse: Enclosure  # the coarsened surface, if coarsening removed most vertices; else ``outside``
    pins: np.ndarray  # ids of sorted vertices that are held in place
    first_volume: float
    first_area: float
    max_rows: int
    num_coarsened: int
    first_ring_area: np.ndarray
    start: Start  # the record of the preparation, for the tape

    meso: Meso
    t_c: float
    w_L_factor: float
    limbs: Future | None  # of ``coarse``, found by the worker; None if limbs are not asked for, or known
    history: list[Iteration] = field(default_factory=list)
    steps: list[Step] = field(default_factory=list)  # for the tape
    failure: str = ""  # why the flow cannot continue; empty if it can


def stage_at(
    iteration: int, records: tuple[ComponentRecord, ...], vertices: np.ndarray, faces: np.ndarray, is_fixed: np.ndarray
) -> Stage:
    """The surface after ``iteration`` iterations, all components together. A component that had ended before has its
    part of the contracted surface, ``vertices``, ``faces`` and ``is_fixed``."""
    first, parts, num = 0, [], 0
    for component in records:
        last = first + component.num_meso
        if iteration < len(component.steps):
            step = component.steps[iteration]
            rings = np.where(np.arange(step.rings.shape[1]) < step.degree[:, None], step.rings, -1)
            corners = ring_tables.faces_from_rings(rings)
            parts.append((component.frame.leave(step.positions), corners + num, ~step.free.astype(bool)))
        else:
            own = faces[(faces[:, 0] >= first) & (faces[:, 0] < last)]
            parts.append((vertices[first:last], own - first + num, is_fixed[first:last]))
        first, num = last, num + len(parts[-1][0])
    points, corners, is_held = map(np.concatenate, zip(*parts, strict=True))
    return Stage(iteration, points, corners.astype(np.int32), is_held)


@dataclass(frozen=True, eq=False)
class Flow:
    """All results of a run. All coordinates are in the caller's units.

    Attributes:
        weights, config: those of the run.
        meso_skeleton: ``(vertices (n, 3), faces (m, 3))`` of the contracted surface, all components together.
        is_fixed: (n,) True where a vertex of the meso-skeleton was fixed.
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
    history: tuple[Iteration, ...]
    curve: Skeleton
    skeleton: Skeleton
    recording: Recording = field(repr=False)
    source: Source = field(repr=False)

    @cached_property
    def tape(self) -> Tape:
        return record(self.recording, self.weights, self.config, self.source.areas)

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
        return stage_at(int(iteration), records, *self.meso_skeleton, self.is_fixed)

    def __repr__(self) -> str:
        return f"Flow({len(self.history)} iterations, {self.skeleton!r})"
