"""Reading of a mesh from a path, an object or arrays: triangles, or an error that says what was found.

OFF, OBJ, PLY and STL are read in `formats`, 3MF and glTF in `scenes`; VTK's polygons are read by pyvista. Sizes are
checked before memory is allocated. The meshes of a scene become one list of triangles, placed as in the scene. STL has
no indices, so corners that differ only in the last bits of a float32 become one vertex.
"""

import importlib.util
import logging
import os
from pathlib import Path
from typing import Any, Protocol

import numpy as np
import trimesh
from numpy.typing import ArrayLike
from scipy import spatial

from msf_jax.base.errors import ConfigError, MeshError
from msf_jax.base.options import is_traced, traced
from msf_jax.meshes import formats, scenes
from msf_jax.topology import graphs

SMALLEST_EXTENT = 1e-150  # the mesh's units: smallest extent allowed; its inverse is the largest coordinate allowed
SUFFIXES = {"3mf", "glb", "gltf", "obj", "off", "ply", "stl"}
VTK = {"vtp", "vtk"}  # formats that need pyvista
SAME_CORNER = 2.0**-22  # ratio to the largest coordinate: corners within a few of float32's last bits are one vertex
OR_REPAIR = ", or use repair=True (--repair)"  # ends the message of an error that repair can correct

logging.getLogger("trimesh").addHandler(logging.NullHandler())  # without a handler, it prints tracebacks


class HasTriangles(Protocol):
    """Such as a `trimesh.Trimesh`."""

    @property
    def vertices(self) -> Any: ...

    @property
    def faces(self) -> Any: ...


class HasPolygons(Protocol):
    """A `pyvista.PolyData`."""

    def extract_surface(self, *args: Any, **options: Any) -> Any: ...


MeshLike = str | os.PathLike[str] | tuple[ArrayLike, ArrayLike] | HasTriangles | HasPolygons
"""What functions take as a mesh: a path, an object with triangles, or ``(vertices (V, 3), faces (F, 3))``."""


def read(mesh: Any) -> tuple[np.ndarray, np.ndarray]:
    """Vertices (V, 3) float64 and faces (F, 3) int64 of a mesh, as `skeletonize` reads it.

    Args:
        mesh: a path that ends in .obj, .off, .ply, .stl, .glb, .gltf or .3mf, or in .vtp or .vtk where pyvista is
            installed; a `trimesh.Trimesh`, a `pyvista.PolyData`, or a pair (vertices, faces). Polygons are cut into
            triangles. The meshes of a scene become one, placed as in the scene, those with a skin as its joints hold
            them.

    Returns:
        Copies. Ids of vertices, as in ``mesh_map`` and ``pins``, are rows of these vertices.

    Raises:
        MeshError: there is no such file, it has no triangle mesh, or the arrays have the wrong shape or values.
    """
    if isinstance(mesh, str | os.PathLike):
        found = parts(mesh)
        first = np.cumsum([0, *(len(part.vertices) for part in found)])
        vertices = np.concatenate([part.vertices for part in found])
        faces = np.concatenate([part.faces + start for part, start in zip(found, first[:-1], strict=True)])
    elif hasattr(mesh, "extract_surface"):
        vertices, faces = _of_pyvista(mesh)
    elif hasattr(mesh, "vertices") and hasattr(mesh, "faces"):
        vertices, faces = mesh.vertices, mesh.faces
    elif isinstance(mesh, tuple | list) and len(mesh) == 2:
        vertices, faces = mesh
    else:
        raise MeshError(
            f"cannot take a mesh from {type(mesh).__name__}: expected a path, an object with vertices and faces "
            "(a trimesh.Trimesh), a pyvista.PolyData, or a pair (vertices, faces)"
        )
    return _as_vertices(vertices), _as_faces(faces, len(vertices))


read_mesh = read  # its public name


def readable_suffixes() -> list[str]:
    """The suffixes of mesh files that can be read, without the dot."""
    return sorted(SUFFIXES | VTK if importlib.util.find_spec("pyvista") else SUFFIXES)


def meshes_in(folder: str, output: str, *, is_deep: bool = False) -> list[Path]:
    """The mesh files of a folder, and with ``is_deep`` of its subfolders, but those in ``output``; sorted by name.

    Raises:
        ConfigError: there is no such folder, it has no mesh, or ``output`` is that folder.
    """
    given, out = Path(folder), Path(output).resolve()
    if not given.is_dir():
        raise ConfigError(f"no folder {folder!r}: expected one with meshes")
    if out == given.resolve():
        raise ConfigError(f"{output!r} is the folder of the meshes, too: expected another one for the curves")
    known = readable_suffixes()
    files = sorted(given.rglob("*") if is_deep else given.iterdir())
    paths = [path for path in files if path.suffix.lower().lstrip(".") in known and path.is_file()]
    paths = [path for path in paths if out not in path.resolve().parents]
    if not paths:
        raise ConfigError(f"no mesh in {folder!r}: expected files that end in one of {', '.join(known)}")
    return paths


def _of_pyvista(mesh: Any) -> tuple[np.ndarray, np.ndarray]:
    """Points, and polygons cut into triangles."""
    if not hasattr(mesh, "is_all_triangles"):
        raise MeshError(f"{type(mesh).__name__} is a grid: expected pyvista.PolyData; take its extract_surface()")
    surface = mesh.triangulate() if mesh.n_cells else mesh
    return np.asarray(surface.points, dtype=np.float64), np.asarray(surface.faces).reshape(-1, 4)[:, 1:]


def _without_doubles(triangles: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Vertices and faces of ``triangles`` (T, 3, 3), coincident corners merged to one, in the order of the file."""
    corners, faces = triangles.reshape(-1, 3), np.arange(3 * len(triangles)).reshape(-1, 3)
    largest = float(np.abs(corners).max())
    if not largest <= 1 / SMALLEST_EXTENT:  # or not finite
        return corners, faces
    places, first, inverse = np.unique(corners, axis=0, return_index=True, return_inverse=True)
    pairs = spatial.KDTree(places).query_pairs(SAME_CORNER * largest, output_type="ndarray")
    label = graphs.labels(len(places), *pairs.T)
    earliest = np.full(label.max() + 1, len(corners))
    np.minimum.at(earliest, label, first)
    order = np.argsort(earliest)
    return corners[earliest[order]], np.argsort(order)[label[inverse.ravel()]][faces]


def parts(mesh: Any) -> list[trimesh.Trimesh]:
    """The meshes that ``mesh`` consists of, at least one, each where the scene places it. Those of glTF have all
    attributes of the file. Their concatenated vertices and faces are those of `read`. The caller's object is not
    changed."""
    if isinstance(mesh, trimesh.Trimesh):
        return [mesh.copy(include_cache=True)]
    if not isinstance(mesh, str | os.PathLike):
        return [trimesh.Trimesh(*read(mesh), process=False)]
    path = Path(mesh)
    if not path.is_file():  # opening a pipe would block, and a device may have no end
        raise MeshError(f"{str(path)!r} is no file: check the path")
    suffix, known = path.suffix.lower()[1:], readable_suffixes()
    if suffix not in known:
        needs = "VTK's formats need pyvista: pip install pyvista"
        unknown = f"unknown suffix {path.suffix!r}, expected one of {', '.join(known)}; export it to one of these"
        raise MeshError(f"cannot read {path.name!r}: {needs if suffix in VTK else unknown}")
    try:
        found = [part for part in _meshes_of(path, suffix) if len(part.faces)]
    except MeshError:
        raise
    except Exception as error:  # for a damaged file the readers raise exceptions of many types
        reason = str(error).strip().splitlines()[0] if str(error).strip() else type(error).__name__
        raise MeshError(
            f"cannot read {path.name!r} as {suffix}: it is damaged, too large, or its suffix is wrong ({reason[:200]})"
        ) from error
    if not found:
        raise MeshError(f"{path.name!r} has no triangles: expected a triangle mesh")
    return found


def _meshes_of(path: Path, suffix: str) -> list[trimesh.Trimesh]:
    """The meshes in a file of a known format."""
    if suffix in ("glb", "gltf"):
        return scenes.meshes_of_gltf(path)
    if suffix == "3mf":
        found = scenes.meshes_of_3mf(path)
    elif suffix in VTK:
        found = [_of_pyvista(importlib.import_module("pyvista").read(path))]
    elif suffix == "stl":
        found = [_without_doubles(corners) for corners in formats.of_stl(path.read_bytes())]
    else:
        found = [{"ply": formats.of_ply, "off": formats.of_off, "obj": formats.of_obj}[suffix](path.read_bytes())]
    return [trimesh.Trimesh(*mesh, process=False) for mesh in found]


def check_map(mesh_map: np.ndarray, num_vertices: int) -> None:
    """Raise a `MeshError` unless ``mesh_map`` is of a mesh with ``num_vertices`` vertices."""
    if len(mesh_map) != num_vertices:
        raise MeshError(
            f"the mesh has {num_vertices} vertices, but the skeleton was made from one of {len(mesh_map)}: expected "
            "the same mesh, with its vertices in the same order"
        )


def _as_vertices(vertices: Any) -> np.ndarray:
    if is_traced(vertices):
        raise MeshError(traced("vertices", "msf_jax.follow"))
    try:
        is_complex = np.iscomplexobj(vertices)
        array = np.empty((0, 3)) if is_complex else np.array(vertices, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise MeshError(f"the vertices are no array of numbers: {error}") from error
    if is_complex:
        raise MeshError("the vertices are complex numbers: expected real coordinates")
    if array.ndim != 2 or array.shape[1] != 3:
        raise MeshError(f"the vertices have shape {array.shape}: expected (V, 3)")
    if len(array) == 0:
        raise MeshError("the mesh is empty: it has no vertices")
    bad = np.flatnonzero(~np.isfinite(array).all(axis=1))
    if len(bad):
        raise MeshError(f"{count(bad, 'vertex', 'vertices')} not finite (NaN or infinite): correct them")
    with np.errstate(over="ignore"):
        extent, largest = float(np.ptp(array, axis=0).max()), float(np.abs(array).max())
    if 0 < extent < SMALLEST_EXTENT or largest > 1 / SMALLEST_EXTENT:
        raise MeshError(
            f"the mesh has an extent of {extent:.3g}, and coordinates up to {largest:.3g}: expected an extent of "
            f"{SMALLEST_EXTENT:g} or more, and no coordinate over {1 / SMALLEST_EXTENT:g}; choose another unit"
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
    is_whole = np.issubdtype(array.dtype, np.integer)
    if np.issubdtype(array.dtype, np.floating):
        is_whole = bool((np.isfinite(array) & (array == np.round(array))).all())
    if not is_whole:
        raise MeshError(f"the faces are {array.dtype}, not whole numbers: expected vertex indices from 0")
    array = array.astype(np.int64)
    bad = np.flatnonzero(((array < 0) | (array >= num_vertices)).any(axis=1))
    if len(bad):
        raise MeshError(
            f"{count(bad, 'face', 'faces')} out of range: expected vertex indices from 0 to {num_vertices - 1}"
            + (" (are they counted from 1?)" if array.min() == 1 and array.max() == num_vertices else "")
        )
    return array


def count(found: np.ndarray, one: str, many: str) -> str:
    """The number of ids ``found``, the first five, and the verb: "2 faces (3, 8) are"."""
    first = ", ".join(map(str, found[:5].tolist()))
    more = ", ..." if len(found) > 5 else ""
    return f"{len(found)} {one if len(found) == 1 else many} ({first}{more}) {'is' if len(found) == 1 else 'are'}"
