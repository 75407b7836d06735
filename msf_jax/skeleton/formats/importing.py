"""Reading of curves and reports from files, of this program and of others; nothing in a file is trusted.

Curves of all formats go through `checked_curve`: types, shapes, ranges and indices.
"""

import json
import os
import re
from collections.abc import Callable, Mapping
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from msf_jax.base import archive
from msf_jax.base.errors import ConfigError
from msf_jax.base.writing import plain
from msf_jax.curve import finishing
from msf_jax.meshes import formats
from msf_jax.skeleton.formats.writers import CUT, FORMAT_VERSION, KIND, REPORT, UNITS
from msf_jax.skeleton.report import Report
from msf_jax.skeleton.skeleton import Skeleton, Source, curve_of
from msf_jax.solid.solid import Solid
from msf_jax.topology import graphs

Curve = dict[str, Any]  # attributes of a skeleton by name


def read_curve(path: str | os.PathLike[str]) -> Skeleton:
    """The curve in a file that `Skeleton.save` or another program wrote: ``.npz``, ``.swc``, ``.json`` or
    ``.polylines.txt``.

    That of an ``.npz`` has all but the stages of the flow. Others have an empty map, and a report with counts only. SWC
    has radii and roots, and our files the units; edges that were cut are joined again, without a root. JSON
    has these, too, and openings. In polylines radii are 0, and coincident ends become one node.

    Raises:
        ConfigError: the suffix is unknown, the file is not of the format (the message says where, and what was
            expected), or an ``.npz`` is damaged or of another kind.
        OSError: the file cannot be read.
    """
    name = Path(path).name
    if name.lower().endswith(".npz"):
        with archive.reading(path, KIND, FORMAT_VERSION, "save the skeleton anew") as arrays:
            return Skeleton(**_of_arrays(arrays))
    suffix = next((suffix for suffix in READERS if name.lower().endswith(suffix)), None)
    if suffix is None:
        raise ConfigError(f"cannot read {name!r}: expected one of {', '.join(['.npz', *READERS])}")
    lines, (read, expected) = _lines_of(path), READERS[suffix]
    try:
        curve = checked_curve(read(lines))
    except Exception as error:  # for a damaged file, parsers raise exceptions of many types
        kind = "" if isinstance(error, ValueError) else f"{type(error).__name__}: "
        raise ConfigError(f"{name!r} has no curve ({kind}{str(error)[:300]}): expected {expected}") from error
    given = {name: curve[name] for name in ("units", "roots", "openings", "radius_of")}
    return replace(curve_of(curve["vertices"], curve["edges"], curve["radii"]), **given)


def report_lines(path: str | os.PathLike[str]) -> list[str]:
    """The lines of the report of the curve in a file that `Skeleton.save` wrote, safe to print: all of it from NPZ,
    from SWC what stands in the comments.

    Raises:
        ConfigError: files of this format have no report, this file has none, or its curve is damaged.
        OSError: the file cannot be read.
    """
    name, suffix = Path(path).name, Path(path).suffix.lower()
    if suffix not in (".npz", ".swc"):
        raise ConfigError(f"{name!r} has no report: expected an .npz or .swc file that msf_jax has written")
    lines = str(read_curve(path).report).splitlines()  # also of SWC: a damaged curve has no report
    if suffix == ".swc":
        lines = [line.removeprefix(REPORT).strip() for line in _lines_of(path) if line.startswith(REPORT)]
    if not lines:
        raise ConfigError(f"{name!r} has no report: expected a file that msf_jax wrote after a run")
    return [plain(line) for line in lines]


def _lines_of(path: str | os.PathLike[str]) -> list[str]:
    if Path(path).exists() and not Path(path).is_file():  # opening a pipe would block
        raise ConfigError(f"{Path(path).name!r} is no file: expected one of a curve")
    try:
        return formats.lines_of(Path(path).read_bytes())
    except ValueError as error:
        raise ConfigError(f"{Path(path).name!r} is no text: expected a file of a curve as text ({error})") from None


def _parse(lines: list[str], parse: Callable[[list[str]], Any]) -> None:
    """Call ``parse`` with the words of each line, without its comment; a ValueError names the line."""
    for number, line in enumerate(lines, 1):
        try:
            if words := line.split("#")[0].split():
                parse(words)
        except (ValueError, IndexError, OverflowError) as error:
            raise ValueError(f"line {number} is {line[:60]!r}") from error


def _read_swc(lines: list[str]) -> Curve:
    """Edges that were cut, to have a tree, are joined again."""
    rows: dict[float, list[float]] = {}

    def parse(words: list[str]) -> None:
        key, parent = float(words[0]), float(words[6])  # some programs write 1.0
        if key in rows or parent == key or not (key.is_integer() and parent.is_integer()):
            raise ValueError
        rows[key] = [*map(float, words[2:6]), parent]

    _parse(lines, parse)
    cuts = [map(int, ours.groups()) for line in lines if (ours := re.match(CUT + r" (\d+) (\d+)\b", line))]
    pairs = [*((key, row[4]) for key, row in rows.items() if row[4] >= 0), *cuts]
    place = {key: number for number, key in enumerate(rows)}
    edges = [[place.get(key, -1) for key in pair] for pair in pairs]
    table = np.array(list(rows.values())).reshape(-1, 5)
    roots = np.flatnonzero(table[:, 4] < 0).tolist()
    if all(min(pair) >= 0 for pair in edges):
        components = graphs.cycle_count(len(rows), np.reshape(edges[: len(rows) - len(roots)], (-1, 2)))[0]
        if components != len(roots):
            raise ValueError("some are their own ancestors")
    units = next((line.removeprefix(UNITS).strip() for line in lines if line.startswith(UNITS)), "")
    curve: Curve = {"vertices": table[:, :3], "edges": edges, "radii": table[:, 3]}
    return curve | {"units": units, "roots": () if cuts else roots}


def _read_json(lines: list[str]) -> Curve:
    content = json.loads("\n".join(lines))
    numbers = {name: np.array(content[name]) + 0.0 for name in ("vertices", "radii")}  # whole ones are coordinates, too
    return content | numbers


def _read_polylines(lines: list[str]) -> Curve:
    """Coincident ends become one node, in the order of the file."""
    number: dict[tuple[float, ...], int] = {}
    edges: list[tuple[int, int]] = []

    def parse(words: list[str]) -> None:
        path = np.array(words[1:], dtype=np.float64).reshape(max(int(words[0]), 0), 3).tolist()
        edges.extend(pairwise([number.setdefault(tuple(point), len(number)) for point in path]))

    _parse(lines, parse)
    return {"vertices": np.array(list(number)).reshape(-1, 3), "edges": edges, "radii": np.zeros(len(number))}


READERS: dict[str, tuple[Callable[[list[str]], Curve], str]] = {  # and what they expect
    ".swc": (_read_swc, "id, type, x, y, z, radius, parent in each line, each id once, and -1 for no parent"),
    ".json": (_read_json, "an object with vertices, radii and edges"),
    ".polylines.txt": (_read_polylines, "a count, and as many points of three numbers in each line"),
}


def _of_arrays(arrays: Mapping[str, Any]) -> Curve:
    """The attributes of a `Skeleton` from the arrays of an ``.npz``; its source has no stages of the flow."""
    curve = checked_curve({**arrays, **{name: str(arrays[name]) for name in ("radius_of", "units") if name in arrays}})
    curve["report"] = checked_report(json.loads(str(arrays["report"])), curve)
    if "surface_vertices" in arrays:
        vertices = checked("surface_vertices", arrays["surface_vertices"], (-1, 3))
        faces = checked("surface_faces", arrays["surface_faces"], (-1, 3), below=len(vertices))
        areas = checked("areas", arrays["areas"], curve["mesh_map"].shape)
        pins = checked("pins", arrays["pins"], (-1,), below=len(areas))
        lids = checked("lids", arrays.get("lids", np.empty(0, dtype=np.int64)), (-1,), below=len(faces))
        if (origin := arrays.get("input_of_vertex")) is not None:
            origin = checked("input_of_vertex", origin, (len(vertices),), below=len(areas))
        if not len(faces) or not np.ptp(vertices, axis=0).any() or (areas < 0).any():
            raise ValueError("the surface has no faces, no extent, or a negative area")
        curve["source"] = Source(Solid(vertices, faces, lids), areas, pins, (), origin)
    return curve


def checked(name: str, values: Any, shape: tuple[int, ...], below: int | None = None) -> np.ndarray:
    """``values`` as float64 if they are finite numbers of that ``shape``, in which -1 is any length; or as int64, if
    ``below`` is given, and they are whole, below that, and not negative. Else raises a ValueError."""
    array, kind = np.asarray(values), "float" if below is None else "int"
    if not array.size:  # of any type, and in a text without its second side
        array = np.empty((0, *shape[1:]), dtype=kind)
    fits = array.ndim == len(shape) and all(want in (-1, have) for want, have in zip(shape, array.shape, strict=True))
    if not fits or array.dtype.kind not in ("f" if below is None else "iu"):
        raise ValueError(f"the {name} are {array.dtype} of shape {array.shape}: expected {kind}, {shape}")
    if below is None and not np.isfinite(array).all():
        raise ValueError(f"the {name} are not all finite: expected numbers")
    if below is not None and array.size and not (array.min() >= 0 and array.max() < below):
        raise ValueError(f"it has {name} to nodes that it does not have: expected ids below {below}")
    return array.astype(np.float64 if below is None else np.int64)


def checked_curve(values: Mapping[str, Any]) -> Curve:
    """The attributes of a `Skeleton` but its report and source, from arrays by name. Files of other programs, and old
    ones, have no more than vertices, radii and edges. If these are no curve, it raises an exception that says why."""
    curve: Curve = {"vertices": checked("vertices", values["vertices"], (-1, 3))}
    num = len(curve["vertices"])
    curve["radii"] = checked("radii", values["radii"], (num,))
    if not num:
        raise ValueError("it has 0 nodes: expected at least one")
    largest = max(float(np.abs(curve[name]).max()) for name in ("vertices", "radii"))
    if largest > (limit := float(np.finfo(np.float32).max)):  # some formats have no larger ones
        raise ValueError(f"it has numbers up to {largest:.3g}, not under {limit:.3g}: choose another unit")
    if (least := curve["radii"].min()) < 0:
        raise ValueError(f"node {curve['radii'].argmin()} has a negative radius, {least:.6g}: expected 0 or more")
    pairs = finishing.in_order(checked("edges", values["edges"], (-1, 2), below=num))
    curve["edges"] = pairs[pairs[:, 0] != pairs[:, 1]]
    curve["mesh_map"] = checked("mesh_map", values.get("mesh_map", ()), (-1,), below=num)
    for name in ("roots", "openings"):
        curve[name] = tuple(checked(name, values.get(name, ()), (-1,), below=num).tolist())
    curve |= {name: values.get(name, other) for name, other in (("radius_of", "ball"), ("units", ""))}
    if curve["radius_of"] not in ("ball", "section"):
        raise ValueError(f"the radii are of {curve['radius_of']!r:.60}: expected ball or section")
    if not isinstance(curve["units"], str) or curve["units"].encode(errors="replace").decode() != curve["units"]:
        raise ValueError("the units are no text")
    return curve


def checked_report(values: Any, curve: Curve) -> Report:
    """The report from ``values`` of `Report.to_dict`, as JSON has them; raises an exception for others that cannot be
    printed, and for those of a curve with other counts."""
    known: Any = {key: tuple(value) if isinstance(value, list) else value for key, value in values.items()}
    report = Report(**known)
    "".join([str(report), *report.not_limbs])  # raises for values of other types
    if (counts := graphs.cycle_count(len(curve["vertices"]), curve["edges"])) != (report.components, report.cycles):
        raise ValueError(f"it has {counts[0]} components and {counts[1]} cycles, which its report does not say")
    return report
