"""Formats for all of a skeleton, with its report: NumPy arrays (``.npz``) and JSON; and the checks of what is read.

Curves of all formats go through `checked_curve`: types, shapes, ranges and indices.
"""

import json
import os
import sys
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, get_args, get_origin, get_type_hints

import numpy as np

from msf_jax.base import archive
from msf_jax.base.errors import ConfigError
from msf_jax.skeleton.report import SENTENCES, Report
from msf_jax.skeleton.skeleton import Source
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


def read_npz(path: str | os.PathLike[str]) -> dict[str, Any]:
    """The attributes of a `Skeleton` that `npz` wrote, its source without the stages of the flow.

    Raises:
        ConfigError: the file is of another kind, is damaged, or was written by another version.
    """
    advice = "save the skeleton anew"
    with archive.reading(path, KIND, FORMAT_VERSION, advice) as (_, held):
        texts = {name: str(held[name]) for name in ("radius_of", "units") if name in held}
        curve = checked_curve({**held, **texts})
        curve["report"] = checked_report(json.loads(str(held["report"])))
        _check_graph(curve)
        if "surface_vertices" in held:
            vertices = checked("surface_vertices", held["surface_vertices"], (-1, 3))
            faces = checked("surface_faces", held["surface_faces"], (-1, 3), below=len(vertices))
            areas = checked("areas", held["areas"], curve["mesh_map"].shape)
            pins = checked("pins", held["pins"], (-1,), below=len(areas))
            lids = checked("lids", held.get("lids", np.empty(0, dtype=np.int64)), (-1,), below=len(faces))
            if (origin := held.get("input_of_vertex")) is not None:
                origin = checked("input_of_vertex", origin, (len(vertices),), below=len(areas))
            if not len(faces) or not np.ptp(vertices, axis=0).any() or (areas < 0).any():
                raise ValueError("the surface has no faces, no extent, or a negative area")
            curve["source"] = Source(Solid(vertices, faces, lids), areas, pins, (), origin)
    return curve


def checked(name: str, values: Any, shape: tuple[int, ...], below: int | None = None) -> np.ndarray:
    """``values`` as float64 if they are finite numbers of that ``shape``, in which -1 is any length; or as int64, if
    they are whole and ``below`` is given, which they must be, and not negative.

    Raises:
        ValueError: they are not; the message says what they are.
    """
    array = np.asarray(values)
    fits = [want in (-1, have) for want, have in zip(shape, array.shape, strict=False)]
    is_number = array.dtype.kind in ("f" if below is None else "iu") or not array.size
    if not is_number or array.ndim != len(shape) or not all(fits):
        kind = "float" if below is None else "int"
        raise ValueError(f"the {name} are {array.dtype} of shape {array.shape}: expected {kind}, {shape}")
    if below is None:
        if not np.isfinite(array).all():
            raise ValueError(f"the {name} are not all finite: expected numbers")
        return np.array(array, dtype=np.float64)
    if array.size and not (array.min() >= 0 and array.max() < below):
        raise ValueError(f"it has {name} to nodes that it does not have: expected ids below {below}")
    return array.astype(np.int64)


def checked_curve(held: Mapping[str, Any]) -> dict[str, Any]:
    """The attributes of a `Skeleton` but its report and source, from arrays by name. Files of other programs, and old
    ones, have no more than vertices, radii and edges.

    Raises:
        ValueError, KeyError, OverflowError: they are no curve; the message says why.
    """
    curve: dict[str, Any] = {"vertices": checked("vertices", held["vertices"], (-1, 3))}
    num = len(curve["vertices"])
    curve["radii"] = checked("radii", held["radii"], (num,))
    if not num:
        raise ValueError("it has 0 nodes: expected at least one")
    if (largest := max(float(np.abs(curve[name]).max()) for name in ("vertices", "radii"))) > LARGEST_NUMBER:
        raise ValueError(
            f"it has numbers up to {largest:.3g}: expected none over {LARGEST_NUMBER:g}; choose another unit"
        )
    if (least := curve["radii"].min()) < 0:
        raise ValueError(f"node {curve['radii'].argmin()} has a negative radius, {least:.6g}: expected 0 or more")
    edges = np.asarray(held["edges"])
    curve["edges"] = checked("edges", edges if edges.size else edges.reshape(0, 2), (-1, 2), below=num)
    curve |= {name: checked(name, held.get(name, ()), (-1,), below=num) for name in ("mesh_map", "roots", "openings")}
    curve |= {name: tuple(curve[name].tolist()) for name in ("roots", "openings")}
    curve |= {name: held.get(name, other) for name, other in (("radius_of", "ball"), ("units", ""))}
    if curve["radius_of"] not in ("ball", "section"):
        raise ValueError(f"the radii are of {curve['radius_of']!r:.60}: expected ball or section")
    if not isinstance(curve["units"], str) or curve["units"].encode(errors="replace").decode() != curve["units"]:
        raise ValueError("the units are no text")
    return curve


def checked_report(values: Any) -> Report:
    """The report from ``values`` of `Report.to_dict`; raises a KeyError, a TypeError or a ValueError for others."""
    if not isinstance(values, dict) or not isinstance(values["figures"], dict):
        raise TypeError("no report")
    if not all(isinstance(values.get(key, []), list) for key in SENTENCES):
        raise TypeError(f"{', '.join(SENTENCES)} of the report are no lists")
    report = Report.from_dict(values)
    for name, hint in get_type_hints(Report).items():
        value = getattr(report, name)
        most = 1 + ROUNDED if name in FRACTIONS else sys.float_info.max
        if not _is_a(value, hint) or (isinstance(value, int | float) and (value < 0 or value > most)):  # NaN: not known
            raise TypeError(f"{name} of the report is {value!r:.60}")
    return report


def _is_a(value: Any, hint: Any) -> bool:
    """Whether ``value`` has the type ``hint``: a plain type, or a tuple, dictionary or union of plain types. An integer
    is a float, and a bool is neither."""
    kind, parts = get_origin(hint), get_args(hint)
    if kind in (tuple, dict):
        members = value.values() if isinstance(value, dict) else value
        return type(value) is kind and all(_is_a(each, parts[1 if kind is dict else 0]) for each in members)
    kinds = parts or (hint,)
    return type(value) in kinds or (float in kinds and type(value) is int)


def _check_graph(curve: dict[str, Any]) -> None:
    """Raise a ValueError unless the curve has the components and cycles that its report says, and each edge once."""
    edges, report = np.sort(curve["edges"], axis=1), curve["report"]
    if (edges[:, 0] == edges[:, 1]).any() or len(np.unique(edges, axis=0)) < len(edges):
        raise ValueError("it has an edge twice, or from a node to itself")
    components, cycles = graphs.cycle_count(len(curve["vertices"]), edges)
    if (components, cycles) != (report.components, report.cycles):
        raise ValueError(f"it has {components} components and {cycles} cycles, which its report does not say")


def plain_json(skeleton: "Skeleton") -> str:
    """All of a skeleton but its surface, by name, as JSON."""
    arrays = {name: getattr(skeleton, name).tolist() for name in ("vertices", "edges", "radii", "mesh_map")}
    others = {name: getattr(skeleton, name) for name in ("roots", "openings", "radius_of", "units")}
    kind = {"format": f"msf_jax {KIND}", "version": FORMAT_VERSION}
    return json.dumps({**kind, **arrays, **others, "report": skeleton.report.to_dict()}) + "\n"


def read_json(name: str, text: str) -> dict[str, Any]:
    """The attributes of a `Skeleton` that `plain_json` wrote; a ConfigError for anything else."""
    try:
        content = json.loads(text)
        if content["format"] != f"msf_jax {KIND}" or content["version"] != FORMAT_VERSION:
            raise ValueError(f"it is a {content['format']!r} of version {content['version']!r}")
        for key in ("vertices", "edges", "radii", "mesh_map", "roots", "openings"):
            if bool in map(type, np.array(content.get(key, ()), dtype=object).ravel()):
                raise TypeError(f"{key} are true or false: expected numbers")  # NumPy takes them for 1 and 0
        # Whole numbers are coordinates, too. Asked for numbers, NumPy would take a text for one.
        floats = {key: np.array(content[key]) + 0.0 for key in ("vertices", "radii")}
        curve = checked_curve(content | floats)
        curve["report"] = checked_report(content["report"])
        _check_graph(curve)
        return curve
    except (ValueError, KeyError, TypeError, AttributeError, OverflowError, RecursionError, MemoryError) as error:
        raise ConfigError(
            f"{name!r} has no curve ({type(error).__name__}: {error}): expected a file of msf_jax"
        ) from error
