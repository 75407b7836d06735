"""Formats for all of a skeleton, with its report: NumPy arrays (``.npz``) and JSON."""

import json
import os
from typing import TYPE_CHECKING, Any

import numpy as np

from msf_jax.base import archive
from msf_jax.base.errors import ConfigError
from msf_jax.host.solid.solid import Solid
from msf_jax.skeleton.formats.checking import checked_curve, checked_report
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
        texts = {name: str(held[name]) for name in ("radius_of", "units") if name in held}
        curve = checked_curve({**held, **texts})
        mesh_map = curve["mesh_map"]
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
        held = content | {key: _array(content[key], (int, float), np.float64) for key in ("vertices", "radii")}
        held |= {key: _array(held.get(key, []), (int,), np.int64) for key in ("edges", "mesh_map", "roots", "openings")}
        return checked_curve(held), checked_report(content["report"])
    except (ValueError, KeyError, TypeError, AttributeError, OverflowError, RecursionError, MemoryError) as error:
        raise ConfigError(
            f"{name!r} has no curve ({type(error).__name__}: {error}): expected a file of msf_jax"
        ) from error


def _array(values: Any, kinds: tuple[type, ...], dtype: Any) -> np.ndarray:
    """``values`` as an array, if all are of ``kinds``: NumPy would take a boolean for a number."""
    if not set(map(type, np.array(values, dtype=object).ravel().tolist())) <= set(kinds):
        raise TypeError(f"{str(values)[:40]} is no array of numbers")
    return np.array(values, dtype=dtype)
