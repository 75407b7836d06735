"""The flat names that a config's values had in 0.4.0. Files keep them; calls may use them, with a deprecation.

Tapes name all values of a config; checkpoints, tunings and batches have a text of them, or its hash. These are written
by flat names, in this order, so that a version reads the tapes of the one before, and a run that it began goes on.
"""

from collections.abc import Mapping
from dataclasses import replace
from operator import attrgetter
from typing import Any

from msf_jax.base.errors import deprecated
from msf_jax.base.options.groups import CurveOptions, FlowOptions, PreprocessingOptions, SolverOptions

GROUPS = {
    "preprocessing": PreprocessingOptions(),
    "flow": FlowOptions(),
    "solver": SolverOptions(),
    "curve": CurveOptions(),
}  # of a `Config`, with their defaults
# Where each value is now. A new option gets a flat name, too, and comes last.
FLAT = {
    "weights_of": "system",
    "laplacian": "flow.laplacian",
    "reconstruct_poles": "preprocessing.reconstruct_poles",
    "reconstruct_mesh": "preprocessing.reconstruct_mesh",
    "exact_reconstruction": "preprocessing.exact_reconstruction",
    "resample": "preprocessing.resample",
    "coarsen": "coarsen",
    "refine": "preprocessing.refine",
    "use_poles": "preprocessing.use_poles",
    "poles": "preprocessing.poles",
    "pole_confidence": "preprocessing.pole_confidence",
    "edit_connectivity": "flow.edit_connectivity",
    "t_min": "flow.threshold_min",
    "t_step": "flow.threshold_step",
    "t_max": "flow.threshold_max",
    "split_angle": "flow.split_angle",
    "growth": "flow.w_L_growth",
    "w_H_follows_area": "flow.w_H_follows_area",
    "max_iterations": "max_iterations",
    "max_seconds": "max_seconds",
    "volume_tolerance": "flow.volume_tolerance",
    "area_tolerance": "flow.area_tolerance",
    "free_tolerance": "flow.free_tolerance",
    "solve_tolerance": "solver.tolerance",
    "step_tolerance": "solver.step_tolerance",
    "solve_steps": "solver.max_steps",
    "preconditioner": "solver.preconditioner",
    "surgery": "curve.surgery",
    "prune": "least_slenderness",
    "detail": "detail",
    "centre": "curve.centre",
    "extend_tips": "curve.extend_tips",
    "evaluate": "evaluate",
    "check": "check",
}


def flat(config: Any) -> dict[str, Any]:
    """All values of a config, by their flat names."""
    return {name: attrgetter(path)(config) for name, path in FLAT.items()}


def grouped(values: Mapping[str, Any], groups: Mapping[str, Any] = GROUPS) -> dict[str, Any]:
    """``values`` with those of flat names put into ``groups``; other names stay as they are."""
    old, changes = old_names(values), {}
    found = {name: value for name, value in values.items() if name not in old}
    for name, value in old.items():
        group, _, field = FLAT[name].rpartition(".")
        if group:
            changes.setdefault(group, {})[field] = value
        else:
            found[field] = value
    return found | {group: replace(found.get(group, groups[group]), **change) for group, change in changes.items()}


def old_names(values: Mapping[str, Any]) -> dict[str, Any]:
    """Those of ``values`` whose name has changed."""
    return {name: value for name, value in values.items() if FLAT.get(name, name) != name}


def warn(caller: str, old: Mapping[str, Any], *, as_changes: bool) -> None:
    """A deprecation of the ``old`` names given to ``caller``, with the call that takes their place.

    ``as_changes``: it changes a config and takes dictionaries, as `Config.replace` does; else it takes whole groups.
    """
    if not old:
        return
    if "weights_of" in old:
        maker = f"Config.named({old['weights_of']!r})"
        deprecated(
            f"weights_of is deprecated, it sets no more than default weights: use {maker} for a whole system, or give "
            f"the weights {maker}.default_weights() to the run"
        )
    new: dict[str, dict[str, Any]] = {}
    for name, value in old.items():
        group, _, field = FLAT[name].rpartition(".")
        if name != "weights_of":
            new.setdefault(group, {})[field] = value
    words = [f"{name}={value!r}" for name, value in new.pop("", {}).items()]
    for group, values in new.items():
        members = ", ".join(f"{name}={value!r}" for name, value in values.items())
        words.append(f"{group}={values}" if as_changes else f"{group}={type(GROUPS[group]).__name__}({members})")
    if words:
        names = ", ".join(name for name in old if name != "weights_of")
        deprecated(f"{names} of {caller} is deprecated: use {caller}({', '.join(words)})")
