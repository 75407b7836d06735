"""The groups of a `Config`: what is seldom set, by the part of a run that it belongs to.

Each checks its own values. Lengths are fractions of the bounding box's diagonal.
"""

import inspect
import math
import numbers
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import wraps
from typing import Any, TypeVar

from msf_jax.base.errors import ConfigError
from msf_jax.base.options.flat import FLAT

LAPLACIANS = ("mean_value", "cotangent", "signed_cotangent", "uniform")  # values of ``FlowOptions.laplacian``
POLES = ("auto", "voronoi", "balls")  # values of ``PreprocessingOptions.poles``
FACTORED = "factored"  # the preconditioner that the host factorises
SOLVED_BY = ("jacobi", FACTORED)  # values of ``SolverOptions.preconditioner``
FEWEST_EIGENVECTORS = 4  # a constant and three coordinates: with fewer, a rebuilt mesh has no volume

Kind = TypeVar("Kind")


def taking(made_of: Callable[[Any, dict[str, Any]], dict[str, Any]]) -> Callable[[type[Kind]], type[Kind]]:
    """Let the constructor of a class take what ``made_of`` makes of the class and the keywords."""

    def decorated(kind: type[Kind]) -> type[Kind]:
        constructor: Callable[..., None] = kind.__init__

        @wraps(constructor)
        def init(self: Any, *args: Any, **given: Any) -> None:
            constructor(self, *args, **made_of(kind, given))

        kind.__init__ = init
        return kind

    return decorated


def known(kind: Any, given: dict[str, Any], own: Iterable[str] = ()) -> dict[str, Any]:
    """``given``. A name that ``kind``, a class or a function, does not take is a `ConfigError`, with its place if a
    config has one in a group, or as its ``own``."""
    names = list(inspect.signature(kind).parameters)
    places = {path.rpartition(".")[2]: path for path in FLAT.values()} | FLAT | {name: name for name in own}
    for name in given:
        if name not in names:
            expected = f"it is config.{places[name]}" if name in places else f"expected one of {', '.join(names)}"
            raise ConfigError(f"{kind.__name__} has no {name!r}: {expected}")
    return given


@taking(known)
@dataclass(frozen=True, kw_only=True)
class PreprocessingOptions:
    """The surface before the flow, and its poles.

    Attributes:
        reconstruct_mesh: number of eigenvectors kept in the mesh that is contracted; 0 uses the mesh itself.
        reconstruct_poles: number of eigenvectors kept in the mesh that poles are computed on; 0 uses the mesh itself.
        exact_reconstruction: whether reconstruction computes eigenvectors, as in the article. Else it applies a
            polynomial of the Laplacian, whose cut-off is less sharp, in a twentieth of the time or less.
        resample: target edge length that the mesh is resampled to before poles are computed; 0 keeps its sampling.
        refine: edges longer than this, and longer than two radii of their limb, are split before the flow, so that the
            limbs and holes of a coarse mesh are resolved; 0 splits none.
        use_poles: whether poles pull at all.
        poles: "voronoi" (article 3.1.2), "balls" (shrinking balls, Ma et al. 2012), or "auto": balls if the solid is
            thin, else Voronoi poles. On a thin solid a Voronoi diagram takes minutes, and ``reconstruct_poles`` is left
            out, because it would remove most of the solid.
        pole_confidence: whether w_M is weighted by how far apart the points are in which a pole's ball touches the
            surface. Off by default: over the benchmark's shapes it makes curves neither better nor worse.

    Raises:
        ConfigError: a value is out of its range, or a name is unknown.
    """

    reconstruct_mesh: int = 0
    reconstruct_poles: int = 200
    exact_reconstruction: bool = False
    resample: float = 0.0
    refine: float = 0.02
    use_poles: bool = True
    poles: str = "auto"
    pole_confidence: bool = False

    def __post_init__(self) -> None:
        one_of(self, "poles", POLES, "poles")
        in_range(self, whole=True, reconstruct_mesh=(0, math.inf), reconstruct_poles=(0, math.inf))
        in_range(self, resample=(0, 0.5), refine=(0, 1))
        true_or_false(self, "exact_reconstruction", "use_poles", "pole_confidence")
        if 0 < self.resample < 1e-3:  # millions of vertices
            raise ConfigError(
                f"PreprocessingOptions.resample is {self.resample}: expected 0 (off) or at least 0.001 of the diagonal"
            )
        if any(0 < kept < FEWEST_EIGENVECTORS for kept in (self.reconstruct_poles, self.reconstruct_mesh)):
            raise ConfigError(
                f"fewer than {FEWEST_EIGENVECTORS} eigenvectors rebuild no volume: expected 0 (off) or at least "
                f"{FEWEST_EIGENVECTORS}"
            )


@taking(known)
@dataclass(frozen=True, kw_only=True)
class FlowOptions:
    """The iterations: contraction, edits of the surface, and when the flow has converged.

    Attributes:
        laplacian: "mean_value" (article Eq. 4), "cotangent" with negative sums set to 0, "signed_cotangent" with
            negative sums kept, or "uniform".
        edit_connectivity: whether each iteration collapses and splits edges, and fixes vertices.
        threshold_min, threshold_step, threshold_max: saw-tooth of the collapse threshold t_c (article 3.2.6): it starts
            at the least, rises by the step in each iteration, and falls back above the largest; a step of 0 keeps it
            constant. The article's program has 0.002 and 0.0001; the larger defaults, 0.005 and 0.0005, take a quarter
            of the iterations, and their curves have fewer side branches and are more inside.
        split_angle: theta_s in degrees: an edge whose two opposite angles are larger is split.
        w_L_growth: factor on w_L after each iteration (Au et al. 2008); 1 keeps w_L constant.
        w_H_follows_area: whether w_H grows as a vertex's one-ring area shrinks, and w_L starts at 400 times the square
            root of the mean area of a face (Au et al. 2008).
        volume_tolerance, area_tolerance: the flow has converged when this fraction of the volume is left, and this
            fraction of the area, or the area has stopped shrinking. The area counts because a sheet has no volume. With
            a volume_tolerance of 0 a run makes all of its iterations.
        free_tolerance: the flow has also converged when at most this fraction of the vertices is not fixed.

    Raises:
        ConfigError: a value is out of its range, or a name is unknown.
    """

    laplacian: str = "mean_value"
    edit_connectivity: bool = True
    threshold_min: float = 0.005
    threshold_step: float = 0.0005
    threshold_max: float = 0.016
    split_angle: float = 110.0
    w_L_growth: float = 1.0
    w_H_follows_area: bool = False
    volume_tolerance: float = 1e-4
    area_tolerance: float = 0.01
    free_tolerance: float = 0.01

    def __post_init__(self) -> None:
        one_of(self, "laplacian", LAPLACIANS, "Laplacian")
        in_range(self, threshold_min=(1e-5, 0.5), threshold_step=(0, 0.5), threshold_max=(0, 0.5))
        in_range(self, split_angle=(90, 180), w_L_growth=(1, 100))
        in_range(self, volume_tolerance=(0, 1), area_tolerance=(0, 1), free_tolerance=(0, 1))
        true_or_false(self, "edit_connectivity", "w_H_follows_area")
        if self.threshold_max < self.threshold_min:
            raise ConfigError(
                f"FlowOptions.threshold_max is {self.threshold_max}, below threshold_min {self.threshold_min}: "
                "expected threshold_min <= threshold_max"
            )
        if self.w_H_follows_area and self.edit_connectivity:
            raise ConfigError("w_H_follows_area needs edit_connectivity=False: a merged vertex has no first area")

    @property
    def thresholds(self) -> tuple[float, float, float]:
        """The least threshold, its step, and the largest: the arguments of `fixing.threshold`."""
        return self.threshold_min, self.threshold_step, self.threshold_max


@taking(known)
@dataclass(frozen=True, kw_only=True)
class SolverOptions:
    """The linear solves of the contraction, by conjugate gradients (CG).

    Attributes:
        tolerance: residual of a solve, relative to the right-hand side, at which it ends.
        step_tolerance: a solve also ends when a CG step moves no vertex by more than this part of t_c. This says little
            about its error, see ``Report.unsolved``.
        max_steps: CG steps after which a solve gives up; the report counts such solves (``out_of_steps``).
        preconditioner: "jacobi", or "factored", a sparse factorisation that the host computes in every iteration, for
            systems too ill-conditioned for "jacobi" (see `numerics.factors`). Such systems are solved in float64,
            whatever JAX is set to.

    Raises:
        ConfigError: a value is out of its range, or a name is unknown.
    """

    tolerance: float = 3e-3
    step_tolerance: float = 0.03
    max_steps: int = 2000
    preconditioner: str = "jacobi"

    def __post_init__(self) -> None:
        one_of(self, "preconditioner", SOLVED_BY, "preconditioner")
        in_range(self, tolerance=(0, 1), step_tolerance=(0, 1))
        in_range(self, whole=True, max_steps=(1, math.inf))


@taking(known)
@dataclass(frozen=True, kw_only=True)
class CurveOptions:
    """How the curve is extracted from the contracted surface, and finished.

    Attributes:
        surgery: whether the curve is extracted by half-edge collapses in the order of shape and sampling costs, and its
            nodes recentred by the boundaries of their regions (Au et al. 2008). Else the shortest edges go first.
        centre: whether nodes are finally moved to the middle of their limb's cross-section, and edges refined.
        extend_tips: whether branches end on the axes of their limbs' ends (see `limbs.ends`), and limbs that the
            flow has missed get one.

    Raises:
        ConfigError: a value is neither True nor False, or a name is unknown.
    """

    surgery: bool = False
    centre: bool = True
    extend_tips: bool = True

    def __post_init__(self) -> None:
        true_or_false(self, "surgery", "centre", "extend_tips")


GROUPS: dict[str, Any] = {
    "preprocessing": PreprocessingOptions,
    "flow": FlowOptions,
    "solver": SolverOptions,
    "curve": CurveOptions,
}  # of a `Config`


def in_range(options: Any, *, whole: bool = False, **ranges: tuple[float, float]) -> None:
    """Raise a `ConfigError` unless each attribute is a number, or ``whole`` one, in its range, ends included."""
    kind, what = (numbers.Integral, "whole number") if whole else (numbers.Real, "number")
    for name, (low, high) in ranges.items():
        value = getattr(options, name)
        if isinstance(value, bool) or not isinstance(value, kind) or not low <= float(value) <= high:
            raise ConfigError(f"{_named(options, name)} is {value!r}: expected a {what} from {low} to {high}")


def true_or_false(options: Any, *names: str) -> None:
    """Raise a `ConfigError` unless each attribute is True or False."""
    for name in names:
        value = getattr(options, name)
        if not isinstance(value, bool):
            raise ConfigError(f"{_named(options, name)} is {value!r}: expected True or False")


def one_of(options: Any, name: str, values: tuple[str, ...], what: str) -> None:
    """Raise a `ConfigError` unless the attribute is one of ``values``."""
    value = getattr(options, name)
    if value not in values:
        raise ConfigError(f"unknown {what} {value!r}: expected one of {', '.join(values)}")


def _named(options: Any, name: str) -> str:
    return f"{type(options).__name__}.{name}"
