"""Formats for all of a skeleton, with its report: NumPy arrays (``.npz``) and JSON; and the checks of what is read.

Curves of all formats go through `checked_curve`: types, shapes, ranges and indices.
"""

import json
import os
import sys
from collections.abc import Mapping
from types import NoneType, UnionType
from typing import TYPE_CHECKING, Any, get_args, get_origin, get_type_hints

import numpy as np

from msf_jax.base import archive
from msf_jax.base.errors import ConfigError
from msf_jax.skeleton.report import SENTENCES, Report
from msf_jax.skeleton.source import Source
from msf_jax.solid.solid import Solid
from msf_jax.topology import graphs

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton


KIND = "skeleton"  # of the file, see `archive`
FORMAT_VERSION = 2  # of the format

LARGEST_NUMBER = 1e150  # coordinate or radius: squares of larger ones overflow
ROUNDED = 1e-9  # over 1 that a fraction may be
FRACTIONS = ("inside", "in_sheets", "unexplained")  # of a report


def npz(skeleton: "Skeleton") -> bytes:
    """The arrays by name, the report as JSON, and the surface and pins that the curve was made from, if known."""
    arrays: dict[str, Any] = {name: getattr(skeleton, name) for name in ("vertices", "edges", "radii", "mesh_map")}
    arrays |= {name: np.array(getattr(skeleton, name), dtype=np.int64) for name in ("roots", "openings")}
    arrays |= {name: np.array(getattr(skeleton, name)) for name in ("radius_of", "units")}
    source = skeleton.source
    if source is not None:
        shape = source.solid.shape
        arrays |= {
            "surface_vertices": source.solid.vertices,
            "surface_faces": shape.faces.astype(np.int32),
            "areas": source.areas,
            "pins": np.asarray(source.pins, dtype=np.int64),
            "lids": source.solid.lids,
        }
        if source.input_of_vertex is not None:
            arrays["input_of_vertex"] = source.input_of_vertex
    arrays["report"] = np.array(json.dumps(skeleton.report.to_dict()))
    return archive.packed(KIND, FORMAT_VERSION, {}, arrays)


def read_npz(path: str | os.PathLike[str]) -> "tuple[dict[str, Any], Report, Source | None]":
    """The arrays of a curve that `npz` wrote, its report, and its source without the stages of the flow.

    Raises:
        ConfigError: the file is of another kind, is damaged, or was written by another version.
    """
    advice = "save the skeleton anew"
    with archive.reading(path, KIND, FORMAT_VERSION, advice) as (_, held):
        texts = {name: str(held[name]) for name in ("radius_of", "units") if name in held}
        curve = checked_curve({**held, **texts})
        mesh_map = curve["mesh_map"]
        report = checked_report(json.loads(str(held["report"])))
        _check_graph(curve, report)
        source = None
        if "surface_vertices" in held:
            vertices, faces = held["surface_vertices"], held["surface_faces"].astype(np.int64)
            origin, areas, pins = held.get("input_of_vertex"), held["areas"], held["pins"]
            is_right = faces.shape[1:] == (3,) and ((faces >= 0) & (faces < len(vertices))).all()
            is_right &= vertices.shape[1:] == (3,) and areas.shape == mesh_map.shape
            is_right &= origin is None or origin.shape == vertices.shape[:1]
            known = [index for index in (origin, pins) if index is not None]
            is_right &= all(((index >= 0) & (index < len(mesh_map))).all() for index in known)
            is_right &= all(index.dtype.kind in "iu" for index in (held["surface_faces"], *known))
            is_right &= all(value.dtype.kind == "f" and np.isfinite(value).all() for value in (vertices, areas))
            is_right &= bool(np.ptp(vertices, axis=0).any())  # coincident vertices give no scale
            if not (is_right and len(faces) and (areas >= 0).all()):
                raise ValueError("the surface does not fit the curve")
            lids = held.get("lids", np.empty(0, dtype=np.int64))
            if lids.ndim != 1 or lids.dtype.kind not in "iu" or not ((lids >= 0) & (lids < len(faces))).all():
                raise ValueError("the lids are not ids of faces")
            source = Source(Solid(vertices, faces, lids.astype(np.int64)), areas, pins, (), origin)
    return curve, report, source


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
    if (largest := max(float(np.abs(values).max()) for values in found.values())) > LARGEST_NUMBER:
        raise ValueError(
            f"it has numbers up to {largest:.3g}: expected none over {LARGEST_NUMBER:g}; choose another unit"
        )
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
            most = 1 + ROUNDED if name in FRACTIONS else sys.float_info.max
            is_right = not (value < 0 or value > most)  # NaN is not known
        if not is_right:
            raise TypeError(f"{name} of the report is {value!r:.60}")
    return report


def _check_graph(curve: dict[str, Any], report: Report) -> None:
    """Raise a ValueError unless the curve has the components and cycles that its report says, and each edge once."""
    edges, num = np.sort(curve["edges"], axis=1), len(curve["vertices"])
    if (edges[:, 0] == edges[:, 1]).any() or len(np.unique(edges, axis=0)) < len(edges):
        raise ValueError("it has an edge twice, or from a node to itself")
    found = graphs.cycle_count(num, edges)
    if found != (report.components, report.cycles):
        raise ValueError(f"it has {found[0]} components and {found[1]} cycles, which its report does not say")


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


def plain_json(skeleton: "Skeleton") -> str:
    """All of a skeleton but its surface, by name, as JSON."""
    content = {
        "format": f"msf_jax {KIND}",
        "version": FORMAT_VERSION,
        "vertices": skeleton.vertices.tolist(),
        "edges": skeleton.edges.tolist(),
        "radii": skeleton.radii.tolist(),
        "mesh_map": skeleton.mesh_map.tolist(),
        "roots": list(skeleton.roots),
        "openings": list(skeleton.openings),
        "radius_of": skeleton.radius_of,
        "units": skeleton.units,
        "report": skeleton.report.to_dict(),
    }
    return json.dumps(content) + "\n"


def read_json(name: str, text: str) -> tuple[dict[str, Any], Report]:
    """The curve that `plain_json` wrote, and its report; a ConfigError for anything else."""
    try:
        content = json.loads(text)
        if content["format"] != f"msf_jax {KIND}" or content["version"] != FORMAT_VERSION:
            raise ValueError(f"it is a {content['format']!r} of version {content['version']!r}")
        held = content | {key: _array(content[key], (int, float), np.float64) for key in ("vertices", "radii")}
        held["edges"] = _array(held["edges"], (int,), np.int64)
        held |= {key: _array(held.get(key, []), (int,), np.int64) for key in ("mesh_map", "roots", "openings")}
        curve, report = checked_curve(held), checked_report(content["report"])
        _check_graph(curve, report)
        return curve, report
    except (ValueError, KeyError, TypeError, AttributeError, OverflowError, RecursionError, MemoryError) as error:
        raise ConfigError(
            f"{name!r} has no curve ({type(error).__name__}: {error}): expected a file of msf_jax"
        ) from error


def _array(values: Any, kinds: tuple[type, ...], dtype: Any) -> np.ndarray:
    """``values`` as an array, if all are of ``kinds``: NumPy would take a boolean for a number."""
    if not set(map(type, np.array(values, dtype=object).ravel().tolist())) <= set(kinds):
        raise TypeError(f"{str(values)[:40]} is no array of numbers")
    return np.array(values, dtype=dtype)
