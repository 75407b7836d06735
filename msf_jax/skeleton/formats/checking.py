"""Checks of a curve from a file of any format: types, shapes, ranges and indices, of its arrays and its report."""

from collections.abc import Mapping
from types import NoneType, UnionType
from typing import Any, get_args, get_origin, get_type_hints

import numpy as np

from msf_jax.skeleton.report import SENTENCES, Report

LARGEST = 1e150  # coordinate or radius: squares of larger ones overflow
ROUNDED = 1e-9  # over 1 that a fraction may be
FRACTIONS = ("inside", "in_sheets")  # of a report


def checked_curve(held: Mapping[str, Any]) -> dict[str, Any]:
    """The members of a `Skeleton` but its report and source, from arrays by name, which may lack all but three.

    Raises:
        ValueError, KeyError, OverflowError: they are no curve; the message says why.
    """
    found: dict[str, Any] = {name: np.asarray(held[name]) for name in ("vertices", "radii")}
    num = len(found["vertices"])
    for name, shape in (("vertices", (num, 3)), ("radii", (num,))):
        if found[name].dtype.kind != "f" or found[name].shape != shape:
            raise ValueError(
                f"the {name} are {found[name].dtype} of shape {found[name].shape}: expected float, {shape}"
            )
        found[name] = np.array(found[name], dtype=np.float64)
    if not num or not all(np.isfinite(values).all() for values in found.values()):
        raise ValueError(f"it has {num} nodes, not all finite: expected at least one, with numbers")
    if (largest := max(float(np.abs(values).max()) for values in found.values())) > LARGEST:
        raise ValueError(f"it has numbers up to {largest:.3g}: expected none over {LARGEST:g}; choose another unit")
    if (found["radii"] < 0).any():
        node = int(found["radii"].argmin())
        raise ValueError(f"node {node} has a negative radius, {found['radii'][node]:.6g}: expected 0 or more")
    for name in ("edges", "mesh_map", "roots", "openings"):  # files of other programs, and old ones, lack some
        index = np.asarray(held[name] if name == "edges" else held.get(name, ()))
        index = index.astype(np.int64) if index.size == 0 else index
        if (
            index.dtype.kind not in "iu"
            or (name == "edges" and index.shape[1:] != (2,) and index.size)
            or (name != "edges" and index.ndim != 1)
        ):
            raise ValueError(f"the {name} are {index.dtype} of shape {index.shape}: expected ids of nodes")
        if index.size and not (index.min() >= 0 and index.max() < num):
            raise ValueError(f"it has {name} to nodes that it does not have: expected ids below {num}")
        found[name] = index.astype(np.int64)
    found["edges"] = found["edges"].reshape(-1, 2)
    found |= {name: tuple(found[name].tolist()) for name in ("roots", "openings")}
    found |= {name: held.get(name, other) for name, other in (("radius_of", "ball"), ("units", ""))}
    if found["radius_of"] not in ("ball", "section"):
        raise ValueError("the radii are of nothing that is known")
    if not isinstance(found["units"], str) or not found["units"].encode(errors="replace").decode() == found["units"]:
        raise ValueError("the units are no text")
    return found


def checked_report(values: Any) -> Report:
    """The report from ``values`` of `Report.to_dict`; raises a KeyError, a TypeError or a ValueError for others."""
    if not isinstance(values, dict) or not isinstance(values["figures"], dict):
        raise TypeError("no report")
    if not all(isinstance(values.get(key, []), list) for key in SENTENCES):
        raise TypeError(f"{', '.join(SENTENCES)} of the report are no lists")
    report = Report.from_dict(values)
    for name, hint in get_type_hints(Report).items():
        value = getattr(report, name)
        is_right = _is_a(value, hint)
        if is_right and isinstance(value, int | float):
            is_right = not value < 0 and not (name in FRACTIONS and value > 1 + ROUNDED)  # NaN is not known
        if not is_right:
            raise TypeError(f"{name} of the report is {value!r:.60}")
    return report


def _is_a(value: Any, hint: Any) -> bool:
    """Whether ``value`` has the type ``hint``: a plain type, or a tuple, dictionary or union of plain types."""
    kind, parts = get_origin(hint) or hint, get_args(hint)
    if kind is UnionType:
        return any(_is_a(value, part) for part in parts)
    if kind is tuple:
        return isinstance(value, tuple) and all(_is_a(one, parts[0]) for one in value)
    if kind is dict:
        return isinstance(value, dict) and all(_is_a(one, parts[1]) for one in value.values())
    if kind is float:
        return isinstance(value, int | float) and not isinstance(value, bool)
    if kind is int:
        return isinstance(value, int) and not isinstance(value, bool)
    return isinstance(value, kind) if kind in (bool, str, NoneType) else True
