"""PLY files: polygons in each encoding, and colours."""

import struct
from pathlib import Path

import numpy as np
import pytest
import trimesh
from file_cases import prism, volume

from msf_jax.meshes import reading


@pytest.mark.parametrize("form", ["ascii", "binary_little_endian", "binary_big_endian"])
def test_polygons_of_a_ply_file_become_triangles(tmp_path: Path, form):
    vertices, faces = prism()
    order = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}[form]
    if order:
        rows = [struct.pack(f"{order}3d", *vertex) for vertex in vertices]
        rows += [struct.pack(f"{order}B{len(face)}i", len(face), *face) for face in faces]
    else:
        rows = [
            " ".join(map(str, row)).encode() + b"\n" for row in [*vertices, *([len(face), *face] for face in faces)]
        ]
    header = ["ply", f"format {form} 1.0", "element vertex 12", *(f"property double {axis}" for axis in "xyz")]
    header += ["element face 8", "property list uchar int vertex_index", "end_header\n"]
    (tmp_path / "a.ply").write_bytes("\n".join(header).encode() + b"".join(rows))
    assert volume(*reading.read(tmp_path / "a.ply")) == pytest.approx(3 * 0.7)


@pytest.mark.parametrize("encoding", ["ascii", "binary"])
def test_colours_of_a_ply_file_are_kept_for_other_formats(tmp_path: Path, encoding):
    box = trimesh.creation.box()
    box.visual.vertex_colors = np.arange(32, dtype=np.uint8).reshape(8, 4)
    (tmp_path / "a.ply").write_bytes(box.export(file_type="ply", encoding=encoding))
    (part,) = reading.parts(tmp_path / "a.ply")
    np.testing.assert_array_equal(part.visual.vertex_colors, box.visual.vertex_colors)
