"""`Config`, the settings of a run that are not differentiable: a few that users set often, and groups of the others.

A jitted step depends on a `Config` only through its `StepSettings`.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, fields, replace
from operator import attrgetter
from typing import TYPE_CHECKING, Any

from msf_jax.base.errors import ConfigError, deprecated
from msf_jax.base.options import flat
from msf_jax.base.options.groups import (
    FACTORED,
    GROUPS,
    CurveOptions,
    FlowOptions,
    PreprocessingOptions,
    SolverOptions,
    in_range,
    known,
    one_of,
    taking,
    true_or_false,
)
from msf_jax.base.options.weights import Weights

SMOOTH = (
    1e-8  # relative residual of solves in `Config.smooth`: at 1e-6 tape and run differed by up to 2e-3 of an objective
)
TIGHT = 1e-6  # relative residual of solves whose runs derivatives predict: to 3e-3 of an objective, for 2e-2 of a step
SYSTEMS = ("msf", "tagliasacchi2012", "au2008")  # values of ``Config.system``


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


def _values(kind: Any, given: dict[str, Any]) -> dict[str, Any]:
    """The values of a config, of keywords that may have flat names, and dictionaries in place of groups."""
    names = {member.name for member in fields(kind)}
    if not given.keys() >= names:
        return known(kind, _with_groups(flat.renamed("Config", given)))
    # `dataclasses.replace` gives all values, and changes, which may have flat names.
    whole = _with_groups({name: given[name] for name in names}, are_whole=True)
    changes = flat.renamed("config.replace", {name: given[name] for name in given if name not in names})
    return known(kind, whole | _changes(whole, changes))


def _with_groups(values: Mapping[str, Any], *, are_whole: bool = False) -> dict[str, Any]:
    """``values`` with groups made of dictionaries, which must have all members if they ``are_whole``."""
    groups = {name: values[name] for name in GROUPS if name in values}
    for name, group in groups.items():
        kind = GROUPS[name]
        if isinstance(group, Mapping):
            if are_whole and len(group) < len(fields(kind)):
                raise ConfigError(
                    f"{name} has {len(group)} of {len(fields(kind))} values: expected config.replace("
                    f"{name}={dict(group)}), which keeps the others"
                )
            groups[name] = kind(**group)
        elif not isinstance(group, kind):
            raise ConfigError(
                f"Config.{name} is a {type(group).__name__}: expected a msf_jax.{kind.__name__}, or a dictionary of "
                "its values"
            )
    return {**values, **groups}


def _changes(values: Mapping[str, Any], changes: Mapping[str, Any]) -> dict[str, Any]:
    """``changes``, with those of a group, in a dictionary, applied to that of ``values``."""
    return {name: replace(values[name], **new) if name in GROUPS else new for name, new in changes.items()}


@taking(_values)
@dataclass(frozen=True, kw_only=True)
class Config:
    """Everything about a run that is not differentiable; frozen and hashable. Lengths are fractions of the diagonal.

    ``Config()`` is the article's system, `Config.tagliasacchi2012()` and `Config.au2008()` the two it builds on. Here
    are the options that the command line has, too; the others are in groups, as ``config.flow.split_angle``. The
    constructor takes groups: ``Config(detail=0.6, flow=FlowOptions(split_angle=120))``. `replace` and the systems take
    changes of groups: ``Config.au2008(flow={"w_L_growth": 1.2})``. In the constructor, a dictionary is a group whose
    other values are the defaults.

    Attributes:
        detail: which limbs that are shorter than ``least_slenderness`` asks have a branch, because they stand out (see
            `limbs.protrusion`): none at 0, and any that might be a limb from 0.83 on. Nested: a finer detail
            only adds limbs. At the default, 0.5, they are those that people draw; the report names the next ones.
        least_slenderness: of the solid's limbs (see `limbs.caps`): length over radius, and half of that below
            0.12 % of the surface. Each limb gets one branch, others are removed, and junctions within one ball
            become one; 0 keeps the flow's branches. The default is above the slenderness of a half ball
            on a wall, 0.5, and of the corner of a box, up to 0.6.
        coarsen: edges shorter than this are collapsed before poles are computed, unless that would turn a face over.
            The cost of a run then depends on the solid's shape, and hardly on the number of its vertices. 0 collapses
            none. If it would change the volume by a twentieth, as of a thin plate, the mesh is not coarsened. On a limb
            of radius r below 0.005, this length and t_c are multiplied by r / 0.005, so that a wire keeps its length.
        max_iterations: the flow gives up after this many iterations.
        max_seconds: the run ends after this many seconds, and about two more, with the curve so far; None for no limit.
            The checking of the mesh counts; on the command line all since its begin does.
            How far the curve is then depends on the machine. If no iteration has ended, a `FlowError` is raised.
        evaluate: whether the report gets the figures of `metrics.evaluate`.
        check: whether to verify after every round of edits that the surface is a closed manifold of the same genus.
        preprocessing, flow, solver, curve: the groups; each has a page of its own.
        system: "msf", "tagliasacchi2012" or "au2008": the system that this was made from, whose weights
            `default_weights` returns. Only the systems' own constructors set it.

    Raises:
        ConfigError: a value is out of its range, or a name is unknown.
    """

    detail: float = 0.5
    least_slenderness: float = 1.0
    coarsen: float = 0.005
    max_iterations: int = 200
    max_seconds: float | None = None
    evaluate: bool = False
    check: bool = False
    preprocessing: PreprocessingOptions = field(default_factory=PreprocessingOptions)
    flow: FlowOptions = field(default_factory=FlowOptions)
    solver: SolverOptions = field(default_factory=SolverOptions)
    curve: CurveOptions = field(default_factory=CurveOptions)
    system: str = flat.System("msf")

    def __post_init__(self) -> None:
        one_of(self, "system", SYSTEMS, "system")
        if not isinstance(self.system, flat.System):
            raise ConfigError(
                f"the system of a config is that of its constructor: expected Config.named({self.system!r}, ...), "
                "which has its options, too"
            )
        in_range(self, detail=(0, 1), least_slenderness=(0, math.inf), coarsen=(0, 0.1))
        in_range(self, whole=True, max_iterations=(1, math.inf))
        if self.max_seconds is not None:
            in_range(self, max_seconds=(0, math.inf))
        true_or_false(self, "evaluate", "check")

    if not TYPE_CHECKING:  # type checkers report the old names of attributes

        def __getattr__(self, name: str) -> Any:
            if name not in flat.FLAT:
                raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")
            path = flat.FLAT[name]
            deprecated(f"Config.{name} is deprecated: use Config.{path}")
            return attrgetter(path)(self)

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state if "flow" in state else vars(Config.of_members(**state)))  # of a pickle of 0.4.0

    @classmethod
    def of_members(cls, **members: Any) -> "Config":
        """The config with these members, as a file has them: of 0.4.0, by flat names."""
        members = flat.grouped(members)
        members["system"] = flat.System(members.get("system", "msf"))
        return cls(**members)

    def replace(self, **changes: Any) -> "Config":
        """This configuration with ``changes``. Those of a group are a dictionary: ``flow={"split_angle": 120}``.

        Raises:
            ConfigError: a value is out of its range, a name is unknown, or the changes of a group are no dictionary.
        """
        return self._changed("config.replace", changes)

    def _changed(self, caller: str, changes: Mapping[str, Any]) -> "Config":
        changes = flat.renamed(caller, changes)
        for name, kind in GROUPS.items():
            if name in changes and not isinstance(changes[name], Mapping):
                raise ConfigError(
                    f"{name} is a {type(changes[name]).__name__}: expected a dictionary of changes, such as "
                    f"{name}={{{fields(kind)[0].name!r}: ...}}"
                )
        return replace(self, **_changes(vars(self), changes))

    @classmethod
    def tagliasacchi2012(cls, **changes: Any) -> "Config":
        """Tagliasacchi et al. 2012: resampled input, cotangent L, poles of the unfiltered surface, constant t_c.

        Its weights, `default_weights`, have no smoothing. Entries of L are limited as in the default system.
        """
        base = cls(
            system=flat.System("tagliasacchi2012"),
            coarsen=0.0,
            preprocessing=PreprocessingOptions(reconstruct_poles=0, resample=0.01, refine=0.0, poles="voronoi"),
            flow=FlowOptions(laplacian="cotangent", threshold_min=0.002, threshold_step=0.0),
            solver=SolverOptions(),
            curve=CurveOptions(),
        )
        return base._changed("Config.tagliasacchi2012", changes)

    @classmethod
    def au2008(cls, **changes: Any) -> "Config":
        """Au et al. 2008: contraction to a millionth of the volume without poles or edits, then surgery and recentring.

        ``Config.au2008(curve={"surgery": False})`` extracts the curve from that contraction as in the other systems.
        ``curve={"centre": True, "extend_tips": True}`` finishes the curve as in the other systems. It differs from the
        paper in these points:

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
        - Before surgery, edges shorter than ``threshold_min`` are collapsed to their midpoints, in rounds of
          independent edges. The surface has thousands of vertices for each node of the curve, and this reduces them.
        - The cost of a half-edge collapse is updated when it has risen, or its sampling cost has fallen by a tenth.
        - Recentring weights boundary loops by their length, and moves a leaf like the node before it. Junctions within
          one ball are merged, as for the other systems.
        - Spurious branches within a limb and branches into blunt corners are pruned, and edges outside the solid are
          moved inside. ``least_slenderness=0`` keeps these branches, and all junctions.
        """
        base = cls(
            system=flat.System("au2008"),
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
        return base._changed("Config.au2008", changes)

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
            max_iterations=iterations,
            preprocessing=PreprocessingOptions(refine=0.0),
            flow=FlowOptions(edit_connectivity=False, volume_tolerance=0.0),
            solver=SolverOptions(tolerance=SMOOTH, step_tolerance=0.0),
        )
        return base._changed("Config.smooth", changes)

    def tight(self) -> "Config":
        """This configuration with solves to a residual of 1e-6 at least, none of which ends by the length of a step.

        With loose solves a derivative does not predict a fresh run, even where no decision changes: each run stops
        elsewhere. A tight run takes several times the CG steps. A "factored" system is solved tightly as it is.
        """
        if self.solver.preconditioner == FACTORED:
            return self
        return self.replace(solver={"tolerance": min(self.solver.tolerance, TIGHT), "step_tolerance": 0.0})

    @classmethod
    def named(cls, system: str, **changes: Any) -> "Config":
        """The configuration of the ``system`` of that name: "msf", "tagliasacchi2012" or "au2008"."""
        makers = {"tagliasacchi2012": cls.tagliasacchi2012, "au2008": cls.au2008}
        if system not in SYSTEMS:
            raise ConfigError(f"unknown system {system!r}: expected one of {', '.join(SYSTEMS)}")
        return makers[system](**changes) if system in makers else cls()._changed("Config.named", changes)

    @property
    def on_device(self) -> StepSettings:
        """The settings that a jitted step depends on. A change of any other setting compiles nothing again."""
        return StepSettings(
            laplacian=self.flow.laplacian,
            solver=Solver(self.solver.tolerance, self.solver.max_steps, self.solver.preconditioner),
            step_tolerance=self.solver.step_tolerance,
            w_H_follows_area=self.flow.w_H_follows_area,
        )

    def default_weights(self) -> Weights:
        """The weights that go with this system."""
        return {
            "msf": Weights(),
            "tagliasacchi2012": Weights(w_L=1.0, w_H=0.1, w_M=0.2, smoothing=0.0),
            "au2008": Weights(w_L=1.0, w_H=1.0, w_M=0.0, smoothing=0.0),
        }[self.system]
