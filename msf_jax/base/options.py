"""The two halves of a run's settings: `Weights`, which gradients flow through, and `Config`, the rest.

Of a `Config`, a jitted step depends on its `StepSettings` and on nothing else.
"""

import math
import numbers
import sys
from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np

from msf_jax.base.errors import ConfigError

LAPLACIANS = ("mean_value", "cotangent", "signed_cotangent", "uniform")
WHOLE = ("reconstruct_poles", "reconstruct_mesh", "max_iterations", "solve_steps")
SYSTEMS = ("msf", "tagliasacchi2012", "au2008")
POLES = ("auto", "voronoi", "balls")
FACTORED = "factored"  # the preconditioner that the host has a part in
SOLVED_BY = ("jacobi", FACTORED)


@dataclass(frozen=True)
class Weights:
    """Weights of the flow, a pytree. They multiply rows, so energies scale with their squares (article Eq. 2).

    Attributes:
        w_L: contraction, >= 0.
        w_H: attraction to where the vertex is, > 0: it keeps the system definite.
        w_M: attraction to the Voronoi pole, >= 0.
        smoothing: lambda of the implicit Laplacian step, >= 0; 0 turns it off.

    All are dimensionless. The ratios matter: a larger w_L / w_H contracts more in one iteration. Weights are equal if
    all their numbers are; those that hold arrays have no hash.

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
        """Raise a `ConfigError` unless all weights are in range; what JAX made of them is not checked otherwise."""
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
    """Whether ``value`` stands for numbers that are not known yet, in a function that JAX transforms."""
    jax = sys.modules.get("jax")  # without it, nothing is
    return jax is not None and isinstance(value, jax.core.Tracer)


@dataclass(frozen=True)
class Solver:
    """How a linear system is solved by conjugate gradients.

    tolerance: residual, relative to the right-hand side, that will do. max_steps: after which it gives up.
    preconditioner: one of `SOLVED_BY`.
    """

    tolerance: float
    max_steps: int
    preconditioner: str = "jacobi"


@dataclass(frozen=True)
class StepSettings:
    """All that a jitted step depends on, but for the layout of its buffers; see `Config` for what they mean."""

    laplacian: str
    solver: Solver
    step_tolerance: float
    w_H_follows_area: bool


@dataclass(frozen=True)
class Config:
    """Everything about a run that is not differentiable; frozen and hashable. Lengths are fractions of the diagonal.

    ``Config()`` is the article's own system, `Config.tagliasacchi2012()` and `Config.au2008()` the two it builds on.

    Attributes:
        weights_of: "msf", "tagliasacchi2012" or "au2008": whose weights `default_weights` are, and nothing else. For a
            whole system take `Config.tagliasacchi2012()`, `Config.au2008()` or `Config.named`.
        laplacian: "mean_value" (article Eq. 4), "cotangent", where a negative sum is 0, "signed_cotangent", where it
            is not, or "uniform".
        reconstruct_poles: eigenvectors kept in the mesh that the poles are computed on; 0 takes the mesh as it is.
        reconstruct_mesh: eigenvectors kept in the mesh that is contracted; 0 takes the mesh as it is.
        exact_reconstruction: whether eigenvectors are computed for that, as in the article. Else a polynomial of the
            Laplacian does their work, with an edge that is a little soft, in a twentieth of the time or less.
        resample: target edge length that the mesh is resampled to before poles are sought; 0 keeps its sampling.
        coarsen: edges shorter than that are collapsed before poles are sought, unless that would turn a face, so that
            the cost of a run follows the solid's shape and hardly the number of its vertices; 0 keeps them all. Where
            it would cost a twentieth of the volume, as of a thin plate, the mesh is taken as it is. Where a limb has a
            radius r below 0.005, this length and t_c are shorter by r / 0.005: a wire keeps its length.
        refine: edges longer than that are split before the flow where they are longer than two radii of the limb, so
            that it sees the limbs and holes of a coarse mesh; 0 keeps them all.
        use_poles: whether poles pull at all.
        poles: "voronoi" (article 3.1.2), "balls" (shrinking balls, Ma et al. 2012), or "auto": Voronoi poles, and balls
            where the solid is thin. There `reconstruct_poles` would take the solid itself away, and is left out, and a
            Voronoi diagram takes minutes.
        pole_confidence: whether w_M is weighted by how far apart the points are in which a pole's ball touches the
            surface. Off by default: over the benchmark's shapes it makes curves neither better nor worse.
        edit_connectivity: whether edges are collapsed and split, and vertices fixed, in the loop.
        t_min, t_step, t_max: saw-tooth of the collapse threshold t_c (article 3.2.6); t_step 0 keeps it constant. It
            starts at 0.005 and rises by 0.0005, where the article's program has 0.002 and 0.0001: a quarter of the
            iterations, and the curves have fewer side branches and are more inside.
        split_angle: theta_s in degrees: an edge with two opposite angles over it is split.
        growth: factor on w_L after each iteration (Au et al. 2008); 1 keeps it.
        w_H_follows_area: whether w_H grows as a vertex's one-ring area shrinks, and w_L begins at 400 times the root of
            the mean area of a face (Au et al. 2008).
        max_iterations: the flow gives up after so many.
        volume_tolerance: the flow has converged when this fraction of the volume is left, and
        area_tolerance: this fraction of the area, or area has stopped shrinking (a sheet has no volume, either).
        free_tolerance: it has converged, too, when this fraction of the vertices is not fixed.
        solve_tolerance: residual of the linear solves, relative to the right-hand side.
        step_tolerance: a contraction is solved, too, when a CG step moves no vertex by this part of t_c.
        preconditioner: of the contraction's conjugate gradients: "jacobi", or "factored", a sparse factor that the host
            makes anew in every iteration, for systems too ill-conditioned for the former (see `host.factors`). Those
            are solved in float64 whatever JAX is set to.
        solve_steps: CG steps after which a solve gives up (and the report says so).
        surgery: whether the curve is read off by half-edge collapses in the order of shape and sampling costs, and its
            nodes recentred by the boundaries of their regions (Au et al. 2008). Else the shortest edges go first.
        prune: branches of less than this `slenderness` are taken away (see `msf_jax.Branch`), and junctions well within
            one ball become one; 0 keeps all. The default is more than half a ball on a wall has, pi / 4, the corner
            of a plate, 0.6, or of a box, 0.7.
        centre: whether nodes are moved to the middle of their limb's cross-section, and edges refined, at the end.
        extend_tips: whether leaves are carried on to the ends of their limbs.
        evaluate: whether the report gets the figures of `metrics.evaluate`.
        check: verify after every round of edits that the surface is a closed manifold of the same genus.

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
    volume_tolerance: float = 1e-4
    area_tolerance: float = 0.01
    free_tolerance: float = 0.01
    solve_tolerance: float = 3e-3
    step_tolerance: float = 0.03
    solve_steps: int = 2000
    preconditioner: str = "jacobi"
    surgery: bool = False
    prune: float = 0.9
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
        ranges = {
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
        }
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
        """Tagliasacchi et al. 2012: resampled input, cotangent L, poles as they are, constant t_c.

        No smoothing belongs to its weights, `default_weights`. Entries of L are limited as in the default system.
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
        """Au et al. 2008: contraction to a millionth of the volume, surgery, and recentring; no poles, no edits before.

        ``Config.au2008(surgery=False)`` reads the curve off that contraction as that of the other systems is;
        ``centre=True, extend_tips=True`` finishes either as theirs are. Against the paper:

        - w_L begins at 0.001 times the root of a face's mean area there, in units that it does not give. Here it is 400
          times that root, in diagonals, or the first twenty steps would do nothing.
        - Cotangents of a triangle whose height is less than 0.3 of its longest edge are made smaller, all three by the
          same factor. The negative ones count, as in the paper: without them limbs shrink in length, and the surface
          crumples. But as they are, vertices at a limb's tip run away along it.
        - The normal equations are solved by conjugate gradients, to 1e-5 of the diagonal, and not by a factor of their
          own; one of their square root preconditions them (see `host.factors`).
        - Coordinates are rounded to a millionth of the diagonal at the start, and one-ring areas count as 1e-14 at
          least.
        - Surgery asks whether a merge would pinch a loop of the solid (see `host.meso.homology`), and not whether the
          edges i -> k and k -> j bound a face: a ring of three around a limb would stay for ever.
        - Before surgery, edges shorter than ``t_min`` go to their midpoints, all that are independent at once: of
          thousands of vertices to each node of the curve, what is left decides it.
        - The cost of a half-edge collapse is brought up to date when it has become dearer, or its sampling cost less by
          a tenth.
        - Recentring weighs boundary loops by their length, and a leaf goes with the node before it. Junctions that are
          within three quarters of a ball are merged, as for the other systems.
        - Twigs within a limb and branches into blunt corners are pruned, and what is outside the solid is led inside:
          ``prune=0`` keeps them, and all junctions.
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
    def named(cls, system: str, **changes: Any) -> "Config":
        """The configuration of the ``system`` of that name: "msf", "tagliasacchi2012" or "au2008"."""
        makers = {"msf": cls, "tagliasacchi2012": cls.tagliasacchi2012, "au2008": cls.au2008}
        if system not in makers:
            raise ConfigError(f"unknown system {system!r}: expected one of {', '.join(SYSTEMS)}")
        return makers[system](**changes)

    @property
    def on_device(self) -> StepSettings:
        """What of it a jitted step depends on: another value of anything else compiles nothing again."""
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
