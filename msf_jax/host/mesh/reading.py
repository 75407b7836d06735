"""Read a mesh from a path, an object or arrays: triangles, or an error that says what was found.

A file goes through trimesh, but for OFF, whose polygons it does not always see. A scene is all its meshes, each where
the scene has it, in one list of triangles.
"""

import logging
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import trimesh

from msf_jax.base.errors import MeshError
from msf_jax.host.mesh import off, unpacking

SMALLEST = 1e-150  # extent, and the largest coordinate is one over it: squares must be numbers
ARCHIVES = {"zip", "bz2", "gz", "tar", "tar.gz", "tar.bz2", "tgz"}  # a small one can unpack to more than memory
MOST_SHOWN, MOST_FACES = 50_000, 20_000_000  # meshes that a scene shows, and faces of all of them
OR_REPAIR = ", or ask for repair=True (--repair)"


def read(mesh: Any, *, finite: bool = True) -> tuple[np.ndarray, np.ndarray]:
    """Vertices (V, 3) float64 and faces (F, 3) int64 of a path, a `trimesh.Trimesh` or a pair; always copies.

    Vertices must be ``finite``, unless that is for `repair` to mend.

    Raises:
        MeshError: there is no such file, it holds no triangle mesh, or the arrays have the wrong shape or values.
    """
    if isinstance(mesh, str | os.PathLike):
        mesh = _load(Path(mesh))
    if hasattr(mesh, "vertices") and hasattr(mesh, "faces"):
        vertices, faces = mesh.vertices, mesh.faces
    elif isinstance(mesh, tuple | list) and len(mesh) == 2:
        vertices, faces = mesh
    else:
        raise MeshError(
            f"cannot take a mesh from {type(mesh).__name__}: expected a path, an object with vertices and faces "
            "(a trimesh.Trimesh), or a pair (vertices, faces)"
        )
    return _as_vertices(vertices, finite), _as_faces(faces, len(vertices))


def readable_suffixes() -> list[str]:
    """Of the mesh files that can be read, without their dot."""
    return sorted(set(trimesh.available_formats()) - ARCHIVES)


def _load(path: Path) -> Any:
    if not path.exists():
        raise MeshError(f"no file {str(path)!r}: check the path")
    if path.is_dir():
        raise MeshError(f"{str(path)!r} is a folder: expected one mesh file")
    if not path.is_file():  # a pipe would be waited for, a device may have no end
        raise MeshError(f"{str(path)!r} is a pipe or a device: expected a mesh file")
    known = readable_suffixes()
    suffix = path.suffix.lower().lstrip(".")
    if suffix not in known:
        raise MeshError(
            f"cannot read {path.name!r}: unknown suffix {path.suffix!r}, expected one of {', '.join(known)}; "
            "export it to one of these"
        )
    try:
        if suffix == "off":
            vertices, faces = off.parsed(path.read_text(encoding="utf-8", errors="replace"))
            return trimesh.Trimesh(vertices, faces, process=False)
        if suffix in unpacking.IN_XML:
            unpacking.check(path)
        with _quiet_loader():
            loaded = trimesh.load(path, process=False, maintain_order=True)
            if isinstance(loaded, trimesh.Scene):
                loaded = _shown(loaded)
    except MemoryError as error:
        raise MeshError(f"{path.name!r} asks for more memory than there is: it is damaged or too large") from error
    except Exception as error:  # trimesh's readers raise whatever a damaged file provokes
        reason = str(error).strip().splitlines()[0] if str(error).strip() else type(error).__name__
        raise MeshError(
            f"cannot read {path.name!r} as {suffix}: it is damaged, or its suffix is wrong ({reason[:200]})"
        ) from error
    if not isinstance(loaded, trimesh.Trimesh):
        raise MeshError(f"{path.name!r} holds a {type(loaded).__name__} without triangles: expected a triangle mesh")
    return loaded


def _shown(scene: trimesh.Scene) -> Any:
    """All meshes of a scene, each where the scene has it; the scene itself if there is none."""
    size = {name: len(mesh.faces) for name, mesh in scene.geometry.items() if isinstance(mesh, trimesh.Trimesh)}
    shown = scene.graph.nodes_geometry
    if len(shown) > MOST_SHOWN or sum(size.get(scene.graph[node][1], 0) for node in shown) > MOST_FACES:
        raise ValueError(f"its scene shows {len(shown)} meshes, with too many triangles in all")
    parts = [part for part in scene.dump() if isinstance(part, trimesh.Trimesh)]
    return trimesh.util.concatenate(parts) if parts else scene


def check_map(mesh_map: np.ndarray, num_vertices: int) -> None:
    """Raise a `MeshError` unless ``mesh_map`` speaks of a mesh of so many vertices."""
    if len(mesh_map) != num_vertices:
        raise MeshError(
            f"the mesh has {num_vertices} vertices, and the skeleton was made from one of {len(mesh_map)}: expected "
            "the same mesh, its vertices in the same order"
        )


@contextmanager
def _quiet_loader() -> Iterator[None]:
    """Keep trimesh from printing tracebacks of what it could not read, where the caller has set up no logging."""
    handler = logging.NullHandler()
    trimesh.util.log.addHandler(handler)
    try:
        yield
    finally:
        trimesh.util.log.removeHandler(handler)


def _as_vertices(vertices: Any, finite: bool) -> np.ndarray:
    try:
        is_complex = np.iscomplexobj(vertices)
        array = np.empty((0, 3)) if is_complex else np.array(vertices, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise MeshError(f"the vertices are no table of numbers: {error}") from error
    if is_complex:
        raise MeshError("the vertices are complex numbers: expected real coordinates")
    if array.ndim != 2 or array.shape[1] != 3:
        raise MeshError(f"the vertices have shape {array.shape}: expected (V, 3)")
    if len(array) == 0:
        raise MeshError("the mesh is empty: it has no vertices")
    bad = np.flatnonzero(~np.isfinite(array).all(axis=1))
    if len(bad) and finite:
        raise MeshError(f"{count(bad, 'vertex', 'vertices')} not finite (NaN or infinite): correct them{OR_REPAIR}")
    sound = array[np.isfinite(array).all(axis=1)]
    extent, largest = (
        float(values.max(initial=0.0))
        for values in (sound.max(axis=0, initial=-np.inf) - sound.min(axis=0, initial=np.inf), np.abs(sound))
    )
    if 0 < extent < SMALLEST or largest > 1 / SMALLEST:
        raise MeshError(
            f"the mesh extends over {extent:.3g}, to {largest:.3g}: expected an extent of {SMALLEST:g} or more, and "
            f"no coordinate over {1 / SMALLEST:g}; choose another unit"
        )
    return array


def _as_faces(faces: Any, num_vertices: int) -> np.ndarray:
    try:
        array = np.array(faces)
    except ValueError as error:
        raise MeshError("the faces have different numbers of corners: triangulate the mesh") from error
    if array.size == 0:
        raise MeshError("the mesh has no faces: expected a closed triangle mesh, not a point cloud or a set of lines")
    if array.ndim != 2 or array.shape[1] != 3:
        raise MeshError(f"the faces have shape {array.shape}: expected (F, 3): triangulate the mesh")
    if not (np.issubdtype(array.dtype, np.integer) or _is_whole(array)):
        raise MeshError(f"the faces are {array.dtype}, not whole numbers: expected vertex indices from 0")
    array = array.astype(np.int64)
    bad = np.flatnonzero(((array < 0) | (array >= num_vertices)).any(axis=1))
    if len(bad):
        raise MeshError(
            f"{count(bad, 'face', 'faces')} out of range: expected vertex indices from 0 to {num_vertices - 1}"
            + (" (are they counted from 1?)" if array.min() == 1 and array.max() == num_vertices else "")
        )
    return array


def _is_whole(array: np.ndarray) -> bool:
    return np.issubdtype(array.dtype, np.floating) and bool((np.isfinite(array) & (array == np.round(array))).all())


def count(found: np.ndarray, one: str, many: str) -> str:
    first = ", ".join(map(str, found[:5].tolist()))
    more = ", ..." if len(found) > 5 else ""
    return f"{len(found)} {one if len(found) == 1 else many} ({first}{more}) {'is' if len(found) == 1 else 'are'}"
