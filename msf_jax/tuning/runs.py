"""The objective's value for given weights: fresh runs, here or in other processes, and a file that stores the values.

The objective is that of the finished curve (``of="skeleton"``), or of the flow's curve, of which a tape has gradients
(``of="flow"``).
"""

import concurrent.futures
import hashlib
import json
import multiprocessing
import os
from pathlib import Path
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from msf_jax.base.errors import ConfigError, FlowError
from msf_jax.base.options import Config, Weights
from msf_jax.base.writing import write_whole
from msf_jax.flow import loop
from msf_jax.flow.state import Flow
from msf_jax.meshes import checking, reading
from msf_jax.meshes.checking import Surface
from msf_jax.tuning.objectives import Objective, of_arrays, value_at

OF = ("skeleton", "flow", "surface")  # what an objective can be of: the finished curve, the flow's, its surface


class Found(NamedTuple):
    """value: the objective's mean over the meshes, inf if a run failed. converges: whether all runs converged."""

    value: float
    converges: bool


class RunCurve(NamedTuple):
    """The arrays of a run's curve that an objective needs, which another process can send; see `Replayed`."""

    nodes: np.ndarray
    radii: np.ndarray
    edges: np.ndarray
    node_of_vertex: np.ndarray
    areas: np.ndarray
    converges: bool


class Runs:
    """Fresh runs of some meshes, and the values of ``objective`` for their curves.

    Args:
        meshes: as `contract` takes them.
        of: "skeleton" or "flow".
        jobs: processes.
        checkpoint: a file that stores the values, or None.
    """

    def __init__(
        self,
        meshes: list[Any],
        objective: Objective,
        config: Config,
        of: str,
        jobs: int = 1,
        checkpoint: str | os.PathLike[str] | None = None,
    ):
        self.meshes = [reading.read(mesh) for mesh in meshes]
        self.surfaces = [checking.prepare(mesh) for mesh in self.meshes]  # checked once, not for every run
        self.objective, self.config, self.of, self.jobs = objective, config, of, jobs
        self.path = None if checkpoint is None else Path(checkpoint)
        self.key = self._key()
        self.known: dict[str, Found] = self._remembered()
        self.pool: concurrent.futures.ProcessPoolExecutor | None = None
        self.kept: tuple[Weights, tuple[Flow, ...]] | None = None  # the best of this process

    def flows(self, weights: Weights) -> tuple[Flow, ...]:
        """A fresh run of each mesh, or the kept runs if they have these weights."""
        if self.kept is not None and _name(self.kept[0]) == _name(weights):
            return self.kept[1]
        return tuple(loop.contract(surface, weights, self.config) for surface in self.surfaces)

    def value(self, flows: tuple[Flow, ...]) -> float:
        """The objective's mean over the runs ``flows``."""
        if self.of == "flow":
            found = [value_at_curve(self.objective, run) for run in flows]
        else:
            found = [self._value(number, _curve(run)) for number, run in enumerate(flows)]
        return float(np.mean(found))

    def found(self, proposals: list[Weights]) -> list[Found]:
        """The values of ``proposals``, computed in parallel by ``jobs`` processes."""
        missing = [weights for weights in proposals if _name(weights) not in self.known]
        if self.jobs > 1 and len(missing) * len(self.meshes) > 1:
            self.pool = self.pool or _started(self.jobs)
            each = [(surface, weights, self.config, self.of) for weights in missing for surface in self.surfaces]
            curves, num = list(self.pool.map(_run, each)), len(self.meshes)
            for number, weights in enumerate(missing):
                self._remember(weights, self._judged(curves[number * num : (number + 1) * num]))
        else:
            for weights in missing:
                self._run_here(weights)
        return [self.known[_name(weights)] for weights in proposals]

    def _run_here(self, weights: Weights) -> None:
        """Run ``weights`` in this process, and keep the runs if they are the best so far."""
        try:
            flows = self.flows(weights)
        except FlowError:
            self._remember(weights, Found(np.inf, False))
            return
        found = self._judged([_curve(run, self.of) for run in flows])
        best = max(map(_rank, self.known.values()), default=(False, -np.inf))
        if self.kept is None or _rank(found) > best:
            self.kept = weights, flows
        self._remember(weights, found)

    def close(self) -> None:
        """End the other processes."""
        if self.pool is not None:
            self.pool.shutdown(wait=True, cancel_futures=True)

    def _judged(self, curves: list[RunCurve | None]) -> Found:
        values = [np.inf if curve is None else self._value(number, curve) for number, curve in enumerate(curves)]
        value = float(np.mean(values))
        return Found(value, bool(np.isfinite(value)) and all(curve is not None and curve.converges for curve in curves))

    def _value(self, mesh: int, curve: RunCurve) -> float:
        """The objective of a run's curve."""
        nodes, radii, edges, node_of_vertex, areas, _ = curve
        return of_arrays(self.objective, nodes, radii, edges, node_of_vertex, self.meshes[mesh][0], areas)

    def _key(self) -> str:
        """A hash of all that values depend on. An objective is identified by its name."""
        digest = hashlib.sha256(f"{self.objective.name} {self.config} {self.of}".encode())
        for vertices, faces in self.meshes:
            digest.update(vertices.tobytes() + faces.tobytes())
        return digest.hexdigest()

    def _remembered(self) -> dict[str, Found]:
        if self.path is None or not self.path.exists():
            return {}
        try:
            if not self.path.is_file():  # reading a pipe would wait
                raise ValueError("not a regular file")
            content = json.loads(self.path.read_text())
            key, values = content["key"], {name: Found(*found) for name, found in content["values"].items()}
        except (ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
            raise ConfigError(f"{str(self.path)!r} is no checkpoint of a tuning: expected one, or no file") from error
        if key != self.key:
            raise ConfigError(
                f"{str(self.path)!r} is of another tuning: expected the same meshes, objective, config and curve; "
                "name another file, or remove it"
            )
        return values

    def _remember(self, weights: Weights, found: Found) -> None:
        self.known[_name(weights)] = found
        if self.path is not None:
            write_whole(self.path, json.dumps({"key": self.key, "values": self.known}) + "\n")


def value_at_curve(objective: Objective, run: Flow) -> float:
    """The ``objective`` of the flow's curve."""
    return float(value_at(objective, run.tape, jnp.asarray(run.curve.vertices)))


def _curve(run: Flow, of: str = "skeleton") -> RunCurve:
    skeleton = run.skeleton if of == "skeleton" else run.curve
    converges = skeleton.report.converged
    return RunCurve(skeleton.vertices, skeleton.radii, skeleton.edges, skeleton.mesh_map, run.source.areas, converges)


def _run(task: tuple[Surface, Weights, Config, str]) -> RunCurve | None:
    """One fresh run, in another process; None if it fails."""
    surface, weights, config, of = task
    try:
        return _curve(loop.contract(surface, weights, config), of)
    except FlowError:
        return None


def _rank(found: Found) -> tuple[bool, float]:
    """A key for comparison: higher is better."""
    return found.converges, -found.value


def _name(weights: Weights) -> str:
    return " ".join(float(weight).hex() for weight in vars(weights).values())


def _started(num: int) -> concurrent.futures.ProcessPoolExecutor:
    context = multiprocessing.get_context("spawn")  # a forked process would lack JAX's threads, and could hang
    settings = {
        name: getattr(jax.config, name)
        for name in ("jax_enable_x64", "jax_compilation_cache_dir", "jax_persistent_cache_min_compile_time_secs")
    }
    return concurrent.futures.ProcessPoolExecutor(num, context, _set_up, (settings,))


def _set_up(settings: dict[str, Any]) -> None:
    for name, value in settings.items():
        jax.config.update(name, value)
