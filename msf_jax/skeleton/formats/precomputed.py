"""A folder of Neuroglancer's precomputed skeletons.

https://github.com/google/neuroglancer/blob/master/src/datasource/precomputed/skeletons.md. It has ``info``, and a
binary file for each segment: the numbers of vertices and edges (uint32), positions (float32), edges (uint32), and each
attribute of ``info`` in its order. Neuroglancer has nanometres: ``transform`` leads to them from the skeleton's units.
"""

import json
import numbers
import os
from typing import TYPE_CHECKING, Any

import numpy as np

from msf_jax.base.errors import ConfigError
from msf_jax.base.writing import made_folder, write_whole
from msf_jax.skeleton.formats.writers import swc_labels
from msf_jax.topology import graphs

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton

NANOMETRES = {"": 1.0, "nm": 1.0, "um": 1e3, "µm": 1e3, "μm": 1e3, "micron": 1e3, "microns": 1e3, "mm": 1e6, "m": 1e9}
ATTRIBUTES = (("radius", "float32"), ("vertex_types", "uint8"))  # cloud-volume reads both by these names


def save(skeleton: "Skeleton", folder: str | os.PathLike[str], segment: Any) -> None:
    """See `Skeleton.save_precomputed`."""
    if isinstance(segment, bool) or not isinstance(segment, numbers.Integral) or not 0 <= int(segment) < 2**64:
        raise ConfigError(f"segment is {segment!r}: expected the id of a segment, a whole number of 0 or more")
    if (units := skeleton.units) not in NANOMETRES:
        raise ConfigError(f"the units are {units!r}: Neuroglancer has nanometres, expected one of {list(NANOMETRES)}")
    info = {
        "@type": "neuroglancer_skeletons",
        "transform": (NANOMETRES[units] * np.eye(3, 4)).ravel().tolist(),
        "vertex_attributes": [{"id": name, "data_type": kind, "num_components": 1} for name, kind in ATTRIBUTES],
    }
    place = made_folder(folder)
    known = place / "info"
    if known.exists() and json.loads(known.read_text()) != info:
        raise ConfigError(f"{str(known)!r} is of other skeletons, or other units: expected a folder of its own")
    num = len(skeleton.vertices)
    label = swc_labels(skeleton, graphs.tree(num, skeleton.edges, skeleton.roots))
    parts = (
        np.array([num, len(skeleton.edges)], dtype="<u4"),
        skeleton.vertices.astype("<f4"),
        skeleton.edges.astype("<u4"),
        skeleton.radii.astype("<f4"),
        label.astype("u1"),
    )
    write_whole(known, json.dumps(info) + "\n")
    write_whole(place / str(int(segment)), b"".join(part.tobytes() for part in parts))
