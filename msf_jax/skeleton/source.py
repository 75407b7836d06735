"""`Source`, the data that a curve was made from: the solid, areas, pins, and stages of the contraction."""

from typing import NamedTuple

import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.recording.following import BoundSurface
from msf_jax.solid.solid import Solid


class Stage(NamedTuple):
    """The surface after some iterations of the flow, in the caller's units, for pictures.

    iteration: their number. vertices: (n, 3). faces: (m, 3) int32. is_fixed: (n,).
    """

    iteration: int
    vertices: np.ndarray
    faces: np.ndarray
    is_fixed: np.ndarray


class Source(NamedTuple):
    """The data that a curve was made from.

    areas: (V,) share of the surface's area that belongs to each input vertex. pins: (k,) input vertices held in place;
    the first of several welded vertices. stages: a few surfaces of the contraction, from first to last.
    input_of_vertex: (v,) the input vertex of each vertex of the solid.
    """

    solid: Solid
    areas: np.ndarray
    pins: np.ndarray
    stages: tuple[Stage, ...] = ()
    input_of_vertex: np.ndarray | None = None


def known(source: Source | None) -> Source:
    """The ``source`` of a skeleton; a `ConfigError` if it has none."""
    if source is None:
        raise ConfigError(
            "the skeleton does not know the mesh that it was made from: expected one from skeletonize, or from an .npz "
            "file; save it as .npz, because other files do not contain the mesh"
        )
    return source


def bound(source: Source | None, mesh_map: np.ndarray) -> BoundSurface:
    """The checked mesh, with the input vertex and the node of each of its vertices.

    Raises:
        ConfigError: the surface is not known, or repair has added vertices to it.
    """
    vertex = known(source).input_of_vertex
    if vertex is None:
        raise ConfigError(
            "repair has added vertices to the mesh that the skeleton was made from: expected only the mesh's own "
            'vertices; run skeletonize without repair="join" or extruded rims'
        )
    return BoundSurface(known(source).solid, vertex, mesh_map[vertex])
