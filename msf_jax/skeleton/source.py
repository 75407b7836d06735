"""What a curve was made from: the solid, its areas and pins, and the surface as it contracted."""

from typing import NamedTuple

import numpy as np

from msf_jax.host.solid.solid import Solid


class Stage(NamedTuple):
    """The surface at some time of the flow, in the caller's units, to be looked at.

    iteration: after how many. vertices: (n, 3). faces: (m, 3) int32. is_fixed: (n,).
    """

    iteration: int
    vertices: np.ndarray
    faces: np.ndarray
    is_fixed: np.ndarray


class Source(NamedTuple):
    """What a curve was made from.

    areas: (V,) share of the surface's area that belongs to each input vertex. pins: (k,) input vertices held in place,
    of welded ones the first. stages: the surface as it contracted, in a few steps from first to last. input_of_vertex:
    (v,) the input vertex that each of the solid's comes from.
    """

    solid: Solid
    areas: np.ndarray
    pins: np.ndarray
    stages: tuple[Stage, ...] = ()
    input_of_vertex: np.ndarray | None = None
