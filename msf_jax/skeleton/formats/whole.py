"""Formats for all of a skeleton, with its report: NumPy arrays (``.npz``) and JSON."""

import json
import os
from types import NoneType, UnionType
from typing import TYPE_CHECKING, Any, get_args, get_origin, get_type_hints

import numpy as np

from msf_jax.base import archive
from msf_jax.base.errors import ConfigError
from msf_jax.host.solid.solid import Solid
from msf_jax.skeleton.report import Report
from msf_jax.skeleton.source import Source

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton


KIND = "skeleton"  # of the file, see `archive`
VERSION = 2  # of the format
WITHOUT_DIGEST = 1  # older version of the format that can be read, too


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
    return archive.packed(KIND, VERSION, {}, arrays, compress=True)


def read_npz(path: str | os.PathLike[str]) -> "tuple[dict[str, Any], Report, Source | None]":
    """The arrays of a curve that `npz` wrote, its report, and its source without the stages of the flow.

    Raises:
        ConfigError: the file is of another kind, is damaged, or was written by another version.
    """
    advice = "save the skeleton anew"
    with archive.reading(path, KIND, VERSION, advice, without_digest=WITHOUT_DIGEST) as (_, held):
        curve: dict[str, Any] = {name: held[name] for name in ("vertices", "edges", "radii", "mesh_map")}
        num, (_, edges, radii, mesh_map) = len(curve["vertices"]), curve.values()
        is_right = curve["vertices"].shape == (num, 3) and radii.shape == (num,) and edges.shape[1:] == (2,)
        is_right &= all(((index >= 0) & (index < num)).all() for index in (edges, mesh_map)) and mesh_map.ndim == 1
        is_right &= all(index.dtype.kind in "iu" for index in (edges, mesh_map))
        is_right &= all(value.dtype.kind == "f" for value in (curve["vertices"], radii)) and bool((radii >= 0).all())
        if not (num and is_right and all(np.isfinite(value).all() for value in curve.values())):
            raise ValueError("arrays do not fit together")
        curve |= {name: np.array(curve[name], dtype=np.float64) for name in ("vertices", "radii")}
        curve |= {name: np.array(curve[name], dtype=np.int64) for name in ("edges", "mesh_map")}
        for name in ("roots", "openings"):  # files of version 0.3.0 have no openings
            numbers = held.get(name, np.empty(0, dtype=np.int64))
            if numbers.ndim != 1 or numbers.dtype.kind not in "iu" or not ((numbers >= 0) & (numbers < num)).all():
                raise ValueError(f"the {name} are not ids of nodes")
            curve[name] = tuple(numbers.tolist())
        curve["radius_of"], curve["units"] = (str(held.get(*pair)) for pair in (("radius_of", "ball"), ("units", "")))
        if curve["radius_of"] not in ("ball", "section"):
            raise ValueError("the radii are of nothing that is known")
        report = checked_report(json.loads(str(held["report"])))
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


def checked_report(values: Any) -> Report:
    """The report from ``values`` of `Report.to_dict`; raises a KeyError, a TypeError or a ValueError for others."""
    if not isinstance(values, dict) or not isinstance(values["figures"], dict):
        raise TypeError("no report")
    report = Report.from_dict(values)
    for name, hint in get_type_hints(Report).items():
        if not _is_a(getattr(report, name), hint):
            raise TypeError(f"{name} of the report is {getattr(report, name)!r:.60}")
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


def plain_json(skeleton: "Skeleton") -> str:
    """All of a skeleton but its surface, by name, as JSON."""
    content = {
        "format": f"msf_jax {KIND}",
        "version": VERSION,
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
        if content["format"] != f"msf_jax {KIND}" or content["version"] != VERSION:
            raise ValueError(f"it is a {content['format']!r} of version {content['version']!r}")
        whole = {key: np.array(content[key], dtype=np.int64) for key in ("edges", "mesh_map")}
        curve: dict[str, Any] = {key: np.array(content[key], dtype=np.float64) for key in ("vertices", "radii")} | whole
        curve["edges"] = curve["edges"].reshape(-1, 2)
        num = len(curve["vertices"])
        is_right = curve["vertices"].shape == (num, 3) and curve["radii"].shape == (num,) and num > 0
        for key in ("roots", "openings"):
            curve[key] = tuple(int(node) for node in content.get(key, ()))
        nodes = (curve["edges"].ravel(), curve["mesh_map"].ravel(), np.array(curve["roots"] + curve["openings"]))
        is_right &= all(((index >= 0) & (index < num)).all() for index in nodes)
        if not (is_right and np.isfinite(curve["vertices"]).all() and np.isfinite(curve["radii"]).all()):
            raise ValueError("arrays do not fit together")
        curve["radius_of"], curve["units"] = str(content.get("radius_of", "ball")), str(content.get("units", ""))
        if curve["radius_of"] not in ("ball", "section"):
            raise ValueError("the radii are of nothing that is known")
        return curve, Report.from_dict(content["report"])
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise ConfigError(
            f"{name!r} has no curve ({type(error).__name__}: {error}): expected a file of msf_jax"
        ) from error
