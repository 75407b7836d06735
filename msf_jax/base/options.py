"""The options of a run: `Weights`, which are differentiable, and `Config`, which is not. Each checks its values."""

import dataclasses
import math
import numbers
import sys
from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from typing import Any, NamedTuple

import numpy as np

from msf_jax.base.errors import ConfigError

SMOOTH = 1e-8  # relative residual of solves in `Config.smooth`: at 1e-6 tape and run differed by 2e-3 of an objective
TIGHT = 1e-6  # the same in `Config.tight`
SYSTEMS = ("msf", "tagliasacchi2012", "au2008")  # values of ``Config.system``
LAPLACIANS = ("mean_value", "cotangent", "signed_cotangent", "uniform")  # values of ``FlowOptions.laplacian``
POLES = ("balls", "voronoi")  # values of ``PreprocessingOptions.poles``
FACTORED = "factored"  # the preconditioner that the host factorises
SOLVED_BY = ("jacobi", FACTORED)  # values of ``SolverOptions.preconditioner``


@dataclass(frozen=True)
class Weights:
    """Weights of the flow, a pytree. They multiply rows, so energies scale with their squares (article Eq. 2).

    Attributes:
        w_L: contraction, >= 0.
        w_H: attraction to the vertex's current position, > 0, which keeps the system definite.
        w_M: attraction to the pole, >= 0.
        smoothing: lambda of the implicit Laplacian step, >= 0; 0 turns it off.

    All are dimensionless. Only the ratios of w_L, w_H and w_M matter: a larger w_L / w_H contracts more in one
    iteration. A value out of range is a `ConfigError`. Weights with arrays have no hash.
    """

    w_L: Any = 1.0
    w_H: Any = 0.1
    w_M: Any = 0.4
    smoothing: Any = 0.001

    def __post_init__(self) -> None:
        self.check()

    def __eq__(self, other: object) -> bool:
        pairs = zip(vars(self).values(), vars(other).values(), strict=True) if isinstance(other, Weights) else [(0, 1)]
        return all(a is b or (not is_traced(a) and not is_traced(b) and np.array_equal(a, b)) for a, b in pairs)

    def check(self, num: int | None = None) -> None:
        """Raise a `ConfigError` unless all weights are in range, and numbers or, if given, ``num`` of them. Of traced
        values only the shape is checked."""
        for name, value in vars(self).items():
            if num is not None and np.shape(value) not in ((), (num,)):
                raise ConfigError(
                    f"Weights.{name} has shape {np.shape(value)}: expected a number, or ({num},), one for each vertex"
                )
            if is_traced(value):
                continue
            try:
                array = np.asarray(np.nan if isinstance(value, str | bool) else value, dtype=np.float64)
            except (TypeError, ValueError):
                array = np.array(np.nan)
            if not (np.isfinite(array) & (array >= 0)).all():
                raise ConfigError(f"Weights.{name} is {value!r}: expected a finite number of 0 or more")
            if name == "w_H" and not (array > 0).all():
                raise ConfigError(f"Weights.w_H is {value!r}: expected more than 0, or the system is singular")


def traced(what: str, instead: str) -> str:
    """What a run says of ``what``, which JAX traces."""
    return f"JAX traces the {what}, and a run makes decisions: run it outside of jit and grad, and use {instead} inside"


def is_traced(value: Any) -> bool:
    """Whether ``value`` is a tracer of JAX."""
    jax = sys.modules.get("jax")  # if JAX was not imported, there are no tracers
    return jax is not None and isinstance(value, jax.core.Tracer)


def number(default: float | None, low: float, high: float) -> Any:
    """A field of `Options` from ``low`` to ``high``; of whole numbers, if its default is one."""
    return field(default=default, metadata={"range": (low, high)})


def choice(default: str, values: tuple[str, ...]) -> Any:
    """A field of `Options` that has one of ``values``."""
    return field(default=default, metadata={"values": values})


class Options:
    """A dataclass that checks its fields: `number`, `choice`, and flags. None is allowed where it is the default. A
    number that JAX traces is not checked."""

    def __post_init__(self) -> None:
        for member in fields(self):  # pyright: ignore[reportArgumentType]
            value, default = getattr(self, member.name), member.default
            named = f"{type(self).__name__}.{member.name} is {value!r}: expected"
            if isinstance(default, bool) and not isinstance(value, bool):
                raise ConfigError(f"{named} True or False")
            if "values" in member.metadata and value not in member.metadata["values"]:
                raise ConfigError(f"{named} one of {', '.join(member.metadata['values'])}")
            if "range" in member.metadata and not (value is None and default is None) and not is_traced(value):
                is_whole = isinstance(default, int)
                kind = numbers.Integral if is_whole else numbers.Real
                low, high = member.metadata["range"]
                if isinstance(value, bool) or not isinstance(value, kind) or not low <= float(value) <= high:
                    bounds = f"of {low} or more" if high == math.inf else f"from {low} to {high}"
                    raise ConfigError(f"{named} a {'whole ' * is_whole}number {bounds}")


@dataclass(frozen=True, kw_only=True)
class PreprocessingOptions(Options):
    """The surface before the flow, and its poles.

    Attributes:
        reconstruct_mesh, reconstruct_poles: number of eigenvectors kept in the mesh that is contracted, and in the one
            that poles are computed on, unless most of the solid is thin or it would lose a quarter; 0: the mesh itself.
        exact_reconstruction: whether eigenvectors are computed, as in the article; else a polynomial of the Laplacian
            replaces them, whose cut-off is less sharp, in a twentieth of the time or less.
        resample: edge length that the mesh is resampled to before poles are computed; 0 keeps its sampling.
        refine: edges longer than this, and than two radii of their limb, are split before the flow, so that limbs and
            holes of a coarse mesh are resolved; 0 splits none.
        use_poles: whether poles pull at all.
        poles: "balls" (shrinking balls, Ma et al. 2012), or "voronoi" (article 3.1.2; minutes on a thin solid).
    """

    reconstruct_mesh: int = number(0, 0, math.inf)
    reconstruct_poles: int = number(200, 0, math.inf)
    exact_reconstruction: bool = False
    resample: float = number(0.0, 0, 0.5)
    refine: float = number(0.02, 0, 1)
    use_poles: bool = True
    poles: str = choice("balls", POLES)

    def __post_init__(self) -> None:
        super().__post_init__()
        if 0 < self.resample < 1e-3:  # millions of vertices
            raise ConfigError(f"PreprocessingOptions.resample is {self.resample}: expected 0 (off) or at least 0.001")
        if any(0 < kept < 4 for kept in (self.reconstruct_poles, self.reconstruct_mesh)):  # a constant, x, y and z
            raise ConfigError("fewer than 4 eigenvectors rebuild no volume: expected 0 (off) or at least 4")


@dataclass(frozen=True, kw_only=True)
class FlowOptions(Options):
    """The iterations: contraction, edits of the surface, and when the flow has converged.

    Attributes:
        laplacian: "mean_value" (article Eq. 4), "cotangent" with negative sums set to 0, "signed_cotangent" with
            negative sums kept, or "uniform".
        edit_connectivity: whether each iteration collapses and splits edges, and fixes vertices.
        threshold_min, threshold_step, threshold_max: saw-tooth of the collapse threshold t_c (article 3.2.6): it rises
            from the least by the step in each iteration, and falls back above the largest. The article's program has
            0.002 and 0.0001; with the defaults a run takes a quarter of the iterations, and curves have fewer side
            branches and are more inside.
        split_angle: theta_s in degrees: an edge whose two opposite angles are larger is split.
        w_L_growth: factor on w_L after each iteration (Au et al. 2008); 1 keeps w_L constant.
        w_H_follows_area: whether w_H grows as a vertex's one-ring area shrinks, and w_L starts at 400 times the square
            root of the mean area of a face (Au et al. 2008).
        volume_tolerance, area_tolerance: the flow has converged when these fractions of volume and area are left, or
            the area, which counts because a sheet has no volume, has stopped shrinking. With a volume_tolerance of 0 a
            run makes all of its iterations.
        free_tolerance: the flow has also converged when at most this fraction of the vertices is not fixed.
    """

    laplacian: str = choice("mean_value", LAPLACIANS)
    edit_connectivity: bool = True
    threshold_min: float = number(0.005, 1e-5, 0.5)
    threshold_step: float = number(0.0005, 0, 0.5)
    threshold_max: float = number(0.016, 0, 0.5)
    split_angle: float = number(110.0, 90, 180)
    w_L_growth: float = number(1.0, 1, 100)
    w_H_follows_area: bool = False
    volume_tolerance: float = number(1e-4, 0, 1)
    area_tolerance: float = number(0.01, 0, 1)
    free_tolerance: float = number(0.01, 0, 1)

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.threshold_max < self.threshold_min:
            raise ConfigError(f"threshold_max is {self.threshold_max}, below threshold_min {self.threshold_min}")
        if self.w_H_follows_area and self.edit_connectivity:
            raise ConfigError("w_H_follows_area needs edit_connectivity=False: a merged vertex has no first area")

    @property
    def thresholds(self) -> tuple[float, float, float]:
        """The least threshold, its step, and the largest."""
        return self.threshold_min, self.threshold_step, self.threshold_max


@dataclass(frozen=True, kw_only=True)
class SolverOptions(Options):
    """The linear solves of the contraction, by conjugate gradients (CG).

    Attributes:
        tolerance: residual of a solve, relative to the right-hand side, at which it ends.
        step_tolerance: a solve also ends when a CG step moves no vertex by more than this part of t_c.
        max_steps: CG steps after which a solve gives up; the report counts such solves (``out_of_steps``).
        preconditioner: "jacobi", or "factored", a sparse factorisation by the host in every iteration, for systems too
            ill-conditioned for "jacobi" (see `numerics.factors`), which are solved in float64 whatever JAX is set to.
    """

    tolerance: float = number(3e-3, 0, 1)
    step_tolerance: float = number(0.03, 0, 1)
    max_steps: int = number(2000, 1, math.inf)
    preconditioner: str = choice("jacobi", SOLVED_BY)


@dataclass(frozen=True, kw_only=True)
class CurveOptions(Options):
    """How the curve is extracted from the contracted surface, and finished.

    Attributes:
        surgery: whether edges collapse in the order of shape and sampling costs, and nodes are recentred by the
            boundaries of their regions (Au et al. 2008). Else the shortest edges go first.
        centre: whether nodes are finally moved to the middle of their limb's cross-section, and edges refined.
        extend_tips: whether branches end on the axes of their limbs' ends, and limbs that the flow has missed get one.
    """

    surgery: bool = False
    centre: bool = True
    extend_tips: bool = True


class StepSettings(NamedTuple):
    """The settings that a jitted step depends on, besides the layout of its buffers; `Config` explains them."""

    laplacian: str
    solver: SolverOptions
    w_H_follows_area: bool


GROUPS: dict[str, type[Options]] = {"preprocessing": PreprocessingOptions, "flow": FlowOptions}  # of a `Config`
GROUPS |= {"solver": SolverOptions, "curve": CurveOptions}


@dataclass(frozen=True, kw_only=True)
class Config(Options):
    """Everything about a run that is not differentiable; frozen and hashable. Lengths are fractions of the diagonal.

    ``Config()`` is the article's system, `Config.tagliasacchi2012()` and `Config.au2008()` the two it builds on. What
    is set often is here, the rest in groups: ``Config(detail=0.6, flow=FlowOptions(split_angle=120))``. `replace` and
    the systems take changes of groups: ``Config.au2008(flow={"w_L_growth": 1.2})``. A value out of its range is a
    `ConfigError`.

    Attributes:
        detail: which limbs that are shorter than ``least_slenderness`` asks have a branch, because they stand out (see
            `limbs.tree`): none at 0, and any at 1. Nested: at a finer detail, each limb stays, or several in its place.
            At the default, 0.5, they are most of those that people draw; the report names the next ones.
        least_slenderness: of the solid's limbs (see `limbs.tree`): length over radius. Each limb gets one branch,
            others are removed, and junctions within one ball become one; 0 keeps the flow's branches. A half ball on a
            wall has 0.5.
        coarsen: edges shorter than this are collapsed before poles are computed, unless that would turn a face over, or
            change the volume by a twentieth; 0 collapses none. The cost of a run then hardly depends on the number of
            vertices. On a limb of radius r below 0.005, this length and t_c are multiplied by r / 0.005, so that a wire
            keeps its length.
        max_iterations: the flow gives up after this many iterations.
        max_seconds: the run ends after this many seconds, and about two more, with the curve so far; None for no limit.
            If no iteration has ended, a `FlowError` is raised.
        evaluate: whether the report gets the figures of `metrics.evaluate`.
        preprocessing, flow, solver, curve: the groups.
        system: the system that this was made from, whose weights `default_weights` returns; only the systems' own
            constructors set it.
    """

    detail: float = number(0.5, 0, 1)
    least_slenderness: float = number(0.5, 0, math.inf)
    coarsen: float = number(0.005, 0, 0.1)
    max_iterations: int = number(200, 1, math.inf)
    max_seconds: float | None = number(None, 0, math.inf)
    evaluate: bool = False
    preprocessing: PreprocessingOptions = field(default_factory=PreprocessingOptions)
    flow: FlowOptions = field(default_factory=FlowOptions)
    solver: SolverOptions = field(default_factory=SolverOptions)
    curve: CurveOptions = field(default_factory=CurveOptions)
    system: str = choice("msf", SYSTEMS)

    def __post_init__(self) -> None:
        super().__post_init__()
        for name, kind in GROUPS.items():
            if not isinstance(getattr(self, name), kind):
                found = type(getattr(self, name)).__name__
                raise ConfigError(f"Config.{name} is a {found}: expected a msf_jax.{kind.__name__}")
        if self.system != "msf" and self.flow == FlowOptions():
            raise ConfigError(f"system only names the default weights: expected Config.named({self.system!r}, ...)")

    def replace(self, **changes: Any) -> "Config":
        """This configuration with ``changes``. Those of a group may be a dictionary: ``flow={"split_angle": 120}``."""
        for name, value in changes.items():
            if name in GROUPS and isinstance(value, Mapping):
                changes[name] = dataclasses.replace(getattr(self, name), **value)
        return dataclasses.replace(self, **changes)

    @classmethod
    def tagliasacchi2012(cls, **changes: Any) -> "Config":
        """Tagliasacchi et al. 2012: resampled input, cotangent L, poles of the unfiltered surface, constant t_c, no
        smoothing. Entries of L are limited as in the default system."""
        base = cls(
            system="tagliasacchi2012",
            coarsen=0.0,
            preprocessing=PreprocessingOptions(reconstruct_poles=0, resample=0.01, refine=0.0, poles="voronoi"),
            flow=FlowOptions(laplacian="cotangent", threshold_min=0.002, threshold_step=0.0),
        )
        return base.replace(**changes)

    @classmethod
    def au2008(cls, **changes: Any) -> "Config":
        """Au et al. 2008: contraction to a millionth of the volume without poles or edits, then surgery and recentring.

        ``curve={"surgery": False}`` extracts the curve from that contraction as in the other systems, and
        ``curve={"centre": True, "extend_tips": True}`` finishes it so. The guide says where it departs from the paper.
        """
        base = cls(
            system="au2008",
            coarsen=0.0,
            preprocessing=PreprocessingOptions(reconstruct_poles=0, refine=0.0, use_poles=False),
            flow=FlowOptions(
                laplacian="signed_cotangent",
                edit_connectivity=False,
                threshold_min=0.002,
                threshold_step=0.0,
                w_L_growth=2.0,
                w_H_follows_area=True,
                volume_tolerance=1e-6,
                area_tolerance=1.0,
            ),
            solver=SolverOptions(tolerance=1e-12, step_tolerance=0.005, preconditioner=FACTORED),
            curve=CurveOptions(surgery=True, centre=False, extend_tips=False),
        )
        return base.replace(**changes)

    @classmethod
    def smooth(cls, iterations: int = 6, **changes: Any) -> "Config":
        """The default system without decisions: ``iterations`` steps of the mesh as it is, with tight solves.

        In float64 the replay of one tape is then a fresh run at any weights, as `tune` needs. A surface that is not
        edited also contracts along its limbs, so that a curved limb may leave its axis.
        """
        base = cls(
            coarsen=0.0,
            max_iterations=iterations,
            preprocessing=PreprocessingOptions(refine=0.0),
            flow=FlowOptions(edit_connectivity=False, volume_tolerance=0.0),
            solver=SolverOptions(tolerance=SMOOTH, step_tolerance=0.0),
        )
        return base.replace(**changes)

    def tight(self) -> "Config":
        """This configuration with solves to a residual of 1e-6 at least, none of which ends by the length of a step: no
        derivative predicts where loose ones stop. It takes several times the CG steps. A "factored" system is solved
        tightly as it is."""
        if self.solver.preconditioner == FACTORED:
            return self
        return self.replace(solver={"tolerance": min(self.solver.tolerance, TIGHT), "step_tolerance": 0.0})

    @classmethod
    def named(cls, system: str, **changes: Any) -> "Config":
        """The configuration of the ``system`` of that name: "msf", "tagliasacchi2012" or "au2008"."""
        if system not in SYSTEMS:
            raise ConfigError(f"unknown system {system!r}: expected one of {', '.join(SYSTEMS)}")
        return cls().replace(**changes) if system == "msf" else getattr(cls, system)(**changes)

    @property
    def on_device(self) -> StepSettings:
        """The settings that a jitted step depends on. A change of any other setting compiles nothing again."""
        return StepSettings(self.flow.laplacian, self.solver, self.flow.w_H_follows_area)

    def default_weights(self) -> Weights:
        """The weights that go with this system."""
        return {
            "msf": Weights(),
            "tagliasacchi2012": Weights(w_L=1.0, w_H=0.1, w_M=0.2, smoothing=0.0),
            "au2008": Weights(w_L=1.0, w_H=1.0, w_M=0.0, smoothing=0.0),
        }[self.system]
