"""The flat names that the values of a config had in 0.4.0. Calls may use them, with a deprecation; its tapes have them.

A new option has no flat name.
"""

from collections.abc import Mapping
from typing import Any

from msf_jax.base.errors import ConfigError, deprecated


class System(str):
    """The name of a system, as its constructor sets it: a config refuses a plain string."""

    __slots__ = ()


FLAT = {
    "weights_of": "system",
    "laplacian": "flow.laplacian",
    "reconstruct_poles": "preprocessing.reconstruct_poles",
    "reconstruct_mesh": "preprocessing.reconstruct_mesh",
    "exact_reconstruction": "preprocessing.exact_reconstruction",
    "resample": "preprocessing.resample",
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
    "volume_tolerance": "flow.volume_tolerance",
    "area_tolerance": "flow.area_tolerance",
    "free_tolerance": "flow.free_tolerance",
    "solve_tolerance": "solver.tolerance",
    "step_tolerance": "solver.step_tolerance",
    "solve_steps": "solver.max_steps",
    "preconditioner": "solver.preconditioner",
    "surgery": "curve.surgery",
    "prune": "least_slenderness",
    "centre": "curve.centre",
    "extend_tips": "curve.extend_tips",
}  # where each is now


def grouped(values: Mapping[str, Any]) -> dict[str, Any]:
    """``values`` with those of flat names by their new ones, in a dictionary for each group; others as they are."""
    found: dict[str, Any] = {}
    for name, value in values.items():
        group, _, field = FLAT.get(name, name).rpartition(".")
        if group:
            found.setdefault(group, {})[field] = value
        else:
            found[field] = System(value) if name == "weights_of" else value
    return found


def renamed(caller: str, values: Mapping[str, Any]) -> dict[str, Any]:
    """`grouped`, for values that were given to ``caller``: a deprecation has the call that takes their place.

    Raises:
        ConfigError: a flat name and its new one, or its group, are both given.
    """
    old = {name: value for name, value in values.items() if name in FLAT}
    for name in old:
        if (place := FLAT[name].partition(".")[0]) in values:
            raise ConfigError(f"{name} is the old name of {FLAT[name]}: expected no {place} beside it")
    if "weights_of" in old:
        maker = f"Config.named({old['weights_of']!r})"
        deprecated(
            f"weights_of is deprecated, it sets no more than default weights: use {maker} for a whole system, or give "
            f"the weights {maker}.default_weights() to the run"
        )
    names = [name for name in old if name != "weights_of"]
    if names:
        words = [_said(caller, *new) for new in grouped({name: old[name] for name in names}).items()]
        verb = "is" if len(names) == 1 else "are"
        deprecated(f"{', '.join(names)} of {caller} {verb} deprecated: use {caller}({', '.join(words)})")
    return grouped(values)


def _said(caller: str, name: str, value: Any) -> str:
    """An argument of ``caller``; of the constructor, whose type takes whole groups, a group is one."""
    if caller != "Config" or not isinstance(value, dict):
        return f"{name}={value!r}"
    members = ", ".join(f"{field}={member!r}" for field, member in value.items())
    return f"{name}={name.capitalize()}Options({members})"
