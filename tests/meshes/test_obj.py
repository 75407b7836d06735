"""OBJ files, however their lines are written."""

from pathlib import Path

import numpy as np
import pytest
from file_cases import obj_of, prism, volume

from msf_jax.meshes import reading


def relative(text: str, num: int) -> str:
    """With the same corners counted back from where they are, and a cube after them that moves no index."""
    lines = text.splitlines()
    for row, line in enumerate(lines):
        if line[0] == "f":
            lines[row] = "f " + " ".join(str(int(word) - 1 - num) for word in line.split()[1:])
    return "\n".join([*lines, *(f"v 9 9 {k}" for k in range(5))]) + "\n"


TEXT = obj_of(*prism())


ODD_OBJ = {
    "byte-order mark": TEXT.encode("utf-8-sig"),
    "UTF-16": TEXT.encode("utf-16"),
    "carriage returns": TEXT.replace("\n", "\r\n").encode(),
    "tabs": TEXT.replace(" ", "\t").encode(),
    "indented": TEXT.replace("\n", "\n  ").encode(),
    "continued": TEXT.replace("f 6 5", "f 6 \\\n5").encode(),
    "comments": TEXT.replace("\n", " # 0\n").encode(),
    "counted back": relative(TEXT, 12).encode(),
}


@pytest.mark.parametrize("name", ODD_OBJ)
def test_an_obj_is_read_as_it_is_meant(tmp_path: Path, name):
    """And its faces of six corners, an L, are cut as those of an OFF file are."""
    (tmp_path / "a.obj").write_bytes(ODD_OBJ[name])
    vertices, faces = reading.read(tmp_path / "a.obj")
    np.testing.assert_array_equal(vertices[:12], prism()[0])
    assert faces.shape == (20, 3) and volume(vertices, faces) == pytest.approx(3 * 0.7)
    area = np.linalg.norm(np.cross(*np.moveaxis(np.diff(vertices[faces], axis=1), 1, 0)), axis=1).sum() / 2
    assert area == pytest.approx(2 * 3 + 8 * 0.7)


def test_materials_of_an_obj_with_odd_lines_are_kept(tmp_path: Path):
    (tmp_path / "a.mtl").write_text("newmtl red\nKd 1 0 0\n")
    (tmp_path / "a.obj").write_text("mtllib a.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf -3/1 -2/1 -1/1\n")
    (part,) = reading.parts(tmp_path / "a.obj")
    assert part.visual.material.main_color.tolist()[:3] == [255, 0, 0]
