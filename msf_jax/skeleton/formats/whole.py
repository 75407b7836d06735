"""Everything that a skeleton holds, the report included: NumPy arrays, JSON."""

import io
import json
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton


def npz(skeleton: "Skeleton") -> bytes:
    """The arrays by their names, and the report as JSON."""
    buffer = io.BytesIO()
    arrays: dict[str, Any] = {name: getattr(skeleton, name) for name in ("vertices", "edges", "radii", "mesh_map")}
    np.savez_compressed(buffer, **arrays, report=np.array(json.dumps(skeleton.report.to_dict())))
    return buffer.getvalue()


def plain_json(skeleton: "Skeleton") -> str:
    """Everything by its name, for whatever reads JSON."""
    content = {
        "format": "msf_jax skeleton",
        "version": 1,
        "vertices": skeleton.vertices.tolist(),
        "edges": skeleton.edges.tolist(),
        "radii": skeleton.radii.tolist(),
        "mesh_map": skeleton.mesh_map.tolist(),
        "report": skeleton.report.to_dict(),
    }
    return json.dumps(content) + "\n"
