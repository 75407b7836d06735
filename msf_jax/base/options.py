"""The settings of a run: `Weights`, which are differentiable, and `Config`, which has all others.

A jitted step depends on a `Config` only through its `StepSettings`.
"""

import math
import numbers
import sys
from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np

from msf_jax.base.errors import ConfigError

LAPLACIANS = ("mean_value", "cotangent", "signed_cotangent", "uniform")  # values of ``Config.laplacian``
WHOLE = ("reconstruct_poles", "reconstruct_mesh", "max_iterations", "solve_steps")  # options that are integers
SMOOTH = (
    1e-8  # relative residual of solves in `Config.smooth`: at 1e-6 tape and run differed by up to 2e-3 of an objective
)
TIGHT = 1e-6  # relative residual of solves whose runs derivatives predict: to 3e-3 of an objective, for 2e-2 of a step
SYSTEMS = ("msf", "tagliasacchi2012", "au2008")  # values of ``Config.weights_of``
POLES = ("auto", "voronoi", "balls")  # values of ``Config.poles``
FACTORED = "factored"  # the preconditioner that the host factorises
SOLVED_BY = ("jacobi", FACTORED)  # values of ``Config.preconditioner``


@dataclass(frozen=True)
class Weights:
    """Weights of the flow, a pytree. They multiply rows, so energies scale with their squares (article Eq. 2).

    Attributes:
        w_L: contraction, >= 0.
        w_H: attraction to the vertex's current position, > 0, which keeps the system definite.
        w_M: attraction to the Voronoi pole, >= 0.
        smoothing: lambda of the implicit Laplacian step, >= 0; 0 turns it off.

    All are dimensionless. Only the ratios of w_L, w_H and w_M matter: a larger w_L / w_H contracts more in one
    iteration. Weights are equal if all their numbers are equal. Weights with arrays have no hash.

    Raises:
        ConfigError: a value is negative or not finite.
    """

    w_L: Any = 1.0
    w_H: Any = 0.1
    w_M: Any = 0.4
    smoothing: Any = 0.001

    def __post_init__(self) -> None:
        self.check()

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Weights):
            return NotImplemented
        pairs = list(zip(vars(self).values(), vars(other).values(), strict=True))
        return all(a is b or (not is_traced(a) and not is_traced(b) and np.array_equal(a, b)) for a, b in pairs)

    def check(self) -> None:
        """Raise a `ConfigError` unless all weights are in range. Traced values are not checked."""
        for field in fields(self):
            value = getattr(self, field.name)
            if is_traced(value):
                continue
            try:
                array = np.asarray(np.nan if isinstance(value, str) else value, dtype=np.float64)
            except (TypeError, ValueError):
                array = np.array(np.nan)
            if isinstance(value, bool) or not (np.isfinite(array) & (array >= 0)).all():
                raise ConfigError(f"Weights.{field.name} is {value!r}: expected a finite number of 0 or more")
            if field.name == "w_H" and not (array > 0).all():
                raise ConfigError(f"Weights.w_H is {value!r}: expected more than 0, or the system is singular")


def is_traced(value: Any) -> bool:
    """Whether ``value`` is a tracer of JAX."""
    jax = sys.modules.get("jax")  # if JAX was not imported, there are no tracers
    return jax is not None and isinstance(value, jax.core.Tracer)


@dataclass(frozen=True)
class Solver:
    """Settings of conjugate gradients.

    tolerance: residual relative to the right-hand side, at which the solve ends. max_steps: CG steps after which the
    solve gives up. preconditioner: one of `SOLVED_BY`.
    """

    tolerance: float
    max_steps: int
    preconditioner: str = "jacobi"


@dataclass(frozen=True)
class StepSettings:
    """The settings that a jitted step depends on, besides the layout of its buffers; `Config` explains them."""

    laplacian: str
    solver: Solver
    step_tolerance: float
    w_H_follows_area: bool


@dataclass(frozen=True)
class Config:
    """Everything about a run that is not differentiable; frozen and hashable. Lengths are fractions of the diagonal.

    ``Config()`` is the article's system, `Config.tagliasacchi2012()` and `Config.au2008()` the two it builds on.

    Attributes:
        weights_of: "msf", "tagliasacchi2012" or "au2008": the system whose weights `default_weights` returns. It has no
            other effect. For a whole system use `Config.tagliasacchi2012()`, `Config.au2008()` or `Config.named`.
        laplacian: "mean_value" (article Eq. 4), "cotangent" with negative sums set to 0, "signed_cotangent" with
            negative sums kept, or "uniform".
        reconstruct_poles: number of eigenvectors kept in the mesh that poles are computed on; 0 uses the mesh itself.
        reconstruct_mesh: number of eigenvectors kept in the mesh that is contracted; 0 uses the mesh itself.
        exact_reconstruction: whether reconstruction computes eigenvectors, as in the article. Else it applies a
            polynomial of the Laplacian, whose cut-off is less sharp, in a twentieth of the time or less.
        resample: target edge length that the mesh is resampled to before poles are computed; 0 keeps its sampling.
        coarsen: edges shorter than this are collapsed before poles are computed, unless that would turn a face over.
            The cost of a run then depends on the solid's shape, and hardly on the number of its vertices. 0 collapses
            none. If it would change the volume by a twentieth, as of a thin plate, the mesh is not coarsened. On a limb
            of radius r below 0.005, this length and t_c are multiplied by r / 0.005, so that a wire keeps its length.
        refine: edges longer than this, and longer than two radii of their limb, are split before the flow, so that the
            limbs and holes of a coarse mesh are resolved; 0 splits none.
        use_poles: whether poles pull at all.
        poles: "voronoi" (article 3.1.2), "balls" (shrinking balls, Ma et al. 2012), or "auto": balls if the solid is
            thin, else Voronoi poles. On a thin solid a Voronoi diagram takes minutes, and `reconstruct_poles` is left
            out, because it would remove most of the solid.
        pole_confidence: whether w_M is weighted by how far apart the points are in which a pole's ball touches the
            surface. Off by default: over the benchmark's shapes it makes curves neither better nor worse.
        edit_connectivity: whether each iteration collapses and splits edges, and fixes vertices.
        t_min, t_step, t_max: saw-tooth of the collapse threshold t_c (article 3.2.6); t_step 0 keeps it constant. It
            starts at 0.005 and rises by 0.0005. The article's program has 0.002 and 0.0001; the larger values take a
            quarter of the iterations, and their curves have fewer side branches and are more inside.
        split_angle: theta_s in degrees: an edge whose two opposite angles are larger is split.
        growth: factor on w_L after each iteration (Au et al. 2008); 1 keeps w_L constant.
        w_H_follows_area: whether w_H grows as a vertex's one-ring area shrinks, and w_L starts at 400 times the square
            root of the mean area of a face (Au et al. 2008).
        max_iterations: the flow gives up after this many iterations.
        max_seconds: the run ends after this many seconds, and about two more, with the curve so far; None for no limit.
            The checking of the mesh counts; on the command line all since its begin does.
            How far the curve is then depends on the machine. If no iteration has ended, a `FlowError` is raised.
        volume_tolerance, area_tolerance: the flow has converged when this fraction of the volume is left, and this
            fraction of the area, or the area has stopped shrinking. The area counts because a sheet has no volume. With
            a volume_tolerance of 0 a run makes all of its max_iterations.
        free_tolerance: the flow has also converged when at most this fraction of the vertices is not fixed.
        solve_tolerance: residual of the linear solves, relative to the right-hand side.
        step_tolerance: a contraction also ends when a CG step moves no vertex by more than this part of t_c. This says
            little about its error, see ``Report.unsolved``.
        preconditioner: of the contraction's conjugate gradients: "jacobi", or "factored", a sparse factorisation that
            the host computes in every iteration, for systems too ill-conditioned for "jacobi" (see `numerics.factors`).
            Such systems are solved in float64, whatever JAX is set to.
        solve_steps: CG steps after which a solve gives up; the report counts such solves (``out_of_steps``).
        surgery: whether the curve is extracted by half-edge collapses in the order of shape and sampling costs, and its
            nodes recentred by the boundaries of their regions (Au et al. 2008). Else the shortest edges go first.
        prune: least slenderness of the solid's limbs (see `limbs.caps`): length over radius, and half of that below
            0.12 % of the surface. Each limb gets one branch, others are removed, and junctions within one ball
            become one; 0 keeps the flow's branches. The default is above the slenderness of a half ball on a wall,
            0.5, and of the corner of a box, up to 0.6.
        detail: which limbs that are shorter than ``prune`` asks have a branch, because they stand out (see
            `limbs.protrusion`): none at 0, and any that might be a limb from 0.65 on. Nested: a finer detail
            only adds limbs. At the default, 0.5, they are those that people draw; the report names the next ones.
        centre: whether nodes are finally moved to the middle of their limb's cross-section, and edges refined.
        extend_tips: whether branches end on the axes of their limbs' ends (see `limbs.ends`), and limbs that the
            flow has missed get one.
        evaluate: whether the report gets the figures of `metrics.evaluate`.
        check: whether to verify after every round of edits that the surface is a closed manifold of the same genus.

    Raises:
        ConfigError: a value is out of its range, or a name is unknown.
    """

    weights_of: str = "msf"
    laplacian: str = "mean_value"
    reconstruct_poles: int = 200
    reconstruct_mesh: int = 0
    exact_reconstruction: bool = False
    resample: float = 0.0
    coarsen: float = 0.005
    refine: float = 0.02
    use_poles: bool = True
    poles: str = "auto"
    pole_confidence: bool = False
    edit_connectivity: bool = True
    t_min: float = 0.005
    t_step: float = 0.0005
    t_max: float = 0.016
    split_angle: float = 110.0
    growth: float = 1.0
    w_H_follows_area: bool = False
    max_iterations: int = 200
    max_seconds: float | None = None
    volume_tolerance: float = 1e-4
    area_tolerance: float = 0.01
    free_tolerance: float = 0.01
    solve_tolerance: float = 3e-3
    step_tolerance: float = 0.03
    solve_steps: int = 2000
    preconditioner: str = "jacobi"
    surgery: bool = False
    prune: float = 1.0
    detail: float = 0.5
    centre: bool = True
    extend_tips: bool = True
    evaluate: bool = False
    check: bool = False

    def __post_init__(self) -> None:
        if self.weights_of not in SYSTEMS:
            raise ConfigError(f"unknown system {self.weights_of!r}: expected one of {', '.join(SYSTEMS)}")
        if self.laplacian not in LAPLACIANS:
            raise ConfigError(f"unknown Laplacian {self.laplacian!r}: expected one of {', '.join(LAPLACIANS)}")
        if self.poles not in POLES:
            raise ConfigError(f"unknown poles {self.poles!r}: expected one of {', '.join(POLES)}")
        if self.preconditioner not in SOLVED_BY:
            raise ConfigError(f"unknown preconditioner {self.preconditioner!r}: expected one of {', '.join(SOLVED_BY)}")
        ranges: dict[str, tuple[float, float]] = {
            "reconstruct_poles": (0, math.inf),
            "reconstruct_mesh": (0, math.inf),
            "resample": (0, 0.5),
            "coarsen": (0, 0.1),
            "refine": (0, 1),
            "t_min": (1e-5, 0.5),
            "t_step": (0, 0.5),
            "t_max": (0, 0.5),
            "split_angle": (90, 180),
            "growth": (1, 100),
            "max_iterations": (1, math.inf),
            "volume_tolerance": (0, 1),
            "area_tolerance": (0, 1),
            "free_tolerance": (0, 1),
            "solve_tolerance": (0, 1),
            "step_tolerance": (0, 1),
            "solve_steps": (1, math.inf),
            "prune": (0, math.inf),
            "detail": (0, 1),
        }
        if self.max_seconds is not None:
            ranges["max_seconds"] = (0, math.inf)
        for name, (low, high) in ranges.items():
            value = getattr(self, name)
            kind, what = (numbers.Integral, "whole number") if name in WHOLE else (numbers.Real, "number")
            if isinstance(value, bool) or not isinstance(value, kind) or not low <= float(value) <= high:
                raise ConfigError(f"Config.{name} is {value!r}: expected a {what} from {low} to {high}")
        for name in (
            "exact_reconstruction",
            "use_poles",
            "pole_confidence",
            "edit_connectivity",
            "w_H_follows_area",
            "surgery",
            "centre",
            "extend_tips",
            "evaluate",
            "check",
        ):
            if not isinstance(getattr(self, name), bool):
                raise ConfigError(f"Config.{name} is {getattr(self, name)!r}: expected True or False")
        if self.t_max < self.t_min:
            raise ConfigError(f"Config.t_max is {self.t_max}, below t_min {self.t_min}: expected t_min <= t_max")
        if 0 < self.resample < 1e-3:
            raise ConfigError(f"Config.resample is {self.resample}: expected 0 (off) or at least 0.001 of the diagonal")
        if self.w_H_follows_area and self.edit_connectivity:
            raise ConfigError("w_H_follows_area needs edit_connectivity=False: a merged vertex has no first area")
        if 0 < self.reconstruct_poles < 4 or 0 < self.reconstruct_mesh < 4:
            raise ConfigError("fewer than 4 eigenvectors rebuild no volume: expected 0 (off) or at least 4")

    @classmethod
    def tagliasacchi2012(cls, **changes: Any) -> "Config":
        """Tagliasacchi et al. 2012: resampled input, cotangent L, poles of the unfiltered surface, constant t_c.

        Its weights, `default_weights`, have no smoothing. Entries of L are limited as in the default system.
        """
        base = cls(
            weights_of="tagliasacchi2012",
            laplacian="cotangent",
            reconstruct_poles=0,
            resample=0.01,
            coarsen=0.0,
            refine=0.0,
            poles="voronoi",
            t_min=0.002,
            t_step=0.0,
        )
        return replace(base, **changes)

    @classmethod
    def au2008(cls, **changes: Any) -> "Config":
        """Au et al. 2008: contraction to a millionth of the volume without poles or edits, then surgery and recentring.

        ``Config.au2008(surgery=False)`` extracts the curve from that contraction as in the other systems.
        ``centre=True, extend_tips=True`` finishes the curve as in the other systems. It differs from the paper in these
        points:

        - In the paper w_L starts at 0.001 times the square root of a face's mean area, in units that are not given.
          Here it starts at 400 times that root, in diagonals; else the first twenty steps would do nothing.
        - If the height of a triangle is less than 0.3 of its longest edge, its three cotangents are multiplied by the
          same factor below 1. Otherwise vertices at a limb's tip diverge along the limb. Negative cotangents are kept,
          as in the paper: without them limbs become shorter, and the surface crumples.
        - The normal equations are solved by conjugate gradients, to 1e-5 of the diagonal, instead of by factorisation.
          A factor of their square root is the preconditioner (see `numerics.factors`).
        - Coordinates are rounded to a millionth of the diagonal at the start. One-ring areas are at least 1e-14.
        - Surgery tests whether a merge would pinch a loop of the solid (see `meso.homology`). The paper tests
          whether the edges i -> k and k -> j bound a face, and a ring of three edges around a limb would never
          collapse.
        - Before surgery, edges shorter than ``t_min`` are collapsed to their midpoints, in rounds of independent edges.
          The surface has thousands of vertices for each node of the curve, and this reduces them.
        - The cost of a half-edge collapse is updated when it has risen, or its sampling cost has fallen by a tenth.
        - Recentring weights boundary loops by their length, and moves a leaf like the node before it. Junctions within
          one ball are merged, as for the other systems.
        - Spurious branches within a limb and branches into blunt corners are pruned, and edges outside the solid are
          moved inside. ``prune=0`` keeps these branches, and all junctions.
        """
        base = cls(
            weights_of="au2008",
            laplacian="signed_cotangent",
            reconstruct_poles=0,
            coarsen=0.0,
            refine=0.0,
            t_min=0.002,
            t_step=0.0,
            use_poles=False,
            edit_connectivity=False,
            growth=2.0,
            w_H_follows_area=True,
            volume_tolerance=1e-6,
            area_tolerance=1.0,
            solve_tolerance=1e-12,
            step_tolerance=0.005,
            preconditioner=FACTORED,
            surgery=True,
            centre=False,
            extend_tips=False,
        )
        return replace(base, **changes)

    @classmethod
    def smooth(cls, iterations: int = 6, **changes: Any) -> "Config":
        """The default system without decisions: ``iterations`` steps of the mesh as it is, with tight solves.

        Before the curve is extracted no edge is collapsed or split and no vertex is fixed, and only their number ends
        the iterations. So the contracted surface is a smooth function of the weights and of the vertices, and the
        replay of one tape is a fresh run at any weights, in float64. This is what `tune` needs for weights per vertex.
        A run with this preset takes several times the CG steps. A surface that is not edited also contracts along its
        limbs, so that a curved limb may leave its axis with the default weights.
        """
        base = cls(
            coarsen=0.0,
            refine=0.0,
            edit_connectivity=False,
            max_iterations=iterations,
            volume_tolerance=0.0,
            solve_tolerance=SMOOTH,
            step_tolerance=0.0,
        )
        return replace(base, **changes)

    def tight(self) -> "Config":
        """This configuration with solves to a residual of 1e-6 at least, none of which ends by the length of a step.

        With loose solves a derivative does not predict a fresh run, even where no decision changes: each run stops
        elsewhere. A tight run takes several times the CG steps. A "factored" system is solved tightly as it is.
        """
        return (
            self
            if self.preconditioner == FACTORED
            else replace(self, solve_tolerance=min(self.solve_tolerance, TIGHT), step_tolerance=0.0)
        )

    @classmethod
    def named(cls, system: str, **changes: Any) -> "Config":
        """The configuration of the ``system`` of that name: "msf", "tagliasacchi2012" or "au2008"."""
        makers = {"msf": cls, "tagliasacchi2012": cls.tagliasacchi2012, "au2008": cls.au2008}
        if system not in makers:
            raise ConfigError(f"unknown system {system!r}: expected one of {', '.join(SYSTEMS)}")
        return makers[system](**changes)

    @property
    def on_device(self) -> StepSettings:
        """The settings that a jitted step depends on. A change of any other setting compiles nothing again."""
        return StepSettings(
            laplacian=self.laplacian,
            solver=Solver(self.solve_tolerance, self.solve_steps, self.preconditioner),
            step_tolerance=self.step_tolerance,
            w_H_follows_area=self.w_H_follows_area,
        )

    def default_weights(self) -> Weights:
        """The weights that go with this system."""
        return {
            "msf": Weights(),
            "tagliasacchi2012": Weights(w_L=1.0, w_H=0.1, w_M=0.2, smoothing=0.0),
            "au2008": Weights(w_L=1.0, w_H=1.0, w_M=0.0, smoothing=0.0),
        }[self.weights_of]
