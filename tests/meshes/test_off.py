"""OFF files: polygons, colours, rows with more words, and what is refused."""

from pathlib import Path

import numpy as np
import pytest
from file_cases import volume, written

from msf_jax.base.errors import MeshError
from msf_jax.meshes import checking, reading
from msf_jax.meshes.files import off


@pytest.mark.parametrize("between", [" ", "\n", " \n "])
@pytest.mark.parametrize("header", ["OFF", "off"])
def test_polygons_of_an_off_file_become_triangles(tmp_path: Path, between, header):
    vertices, faces = reading.read(written(tmp_path / "prism.off", between, header))
    assert faces.shape == (2 * 4 + 6 * 2, 3)
    assert volume(vertices, faces) == pytest.approx(3 * 0.7)
    area = np.linalg.norm(np.cross(*np.moveaxis(np.diff(vertices[faces], axis=1), 1, 0)), axis=1).sum() / 2
    assert area == pytest.approx(2 * 3 + 8 * 0.7)  # no ear lies outside the L
    assert [part.genus for part in checking.prepare((vertices, faces)).components] == [0]


def test_colours_are_passed_over(tmp_path: Path):
    plain = reading.read(written(tmp_path / "plain.off", " "))
    coloured = reading.read(written(tmp_path / "coloured.off", " ", "COFF", " 0.5 0.5 0.5"))
    np.testing.assert_array_equal(plain[1], coloured[1])


TETRAHEDRON = ["0 0 0", "1 0 0", "0 1 0", "0 0 1"], ["3 0 2 1", "3 0 1 3", "3 1 2 3", "3 0 3 2"]


@pytest.mark.parametrize("counts", ["4 4 6", "4 4"])
@pytest.mark.parametrize("row", [None, 0, 4])
def test_files_of_triangles_are_read_alike_however_much_else_is_in_them(counts, row):
    """A word more in a row, and no count of edges: as many words as in a file without either."""
    rows = [*TETRAHEDRON[0], *TETRAHEDRON[1]]
    if row is not None:
        rows[row] += " 7"
    vertices, faces = off.parsed("\n".join(["OFF", counts, *rows]) + "\n")
    np.testing.assert_array_equal(vertices, np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]))
    np.testing.assert_array_equal(faces, [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])


def test_a_quad_that_is_not_convex_is_not_folded():
    corners = np.array([[0, 0, 0], [4, -1, 0], [1, 0, 0], [4, 1, 0]], dtype=float)  # an arrow: its third corner is in
    for turn in range(4):
        order = np.roll(np.arange(4), turn)
        (a, b) = corners[off.triangulated(corners, [order.tolist()])]
        normals = np.cross(a[1] - a[0], a[2] - a[0]), np.cross(b[1] - b[0], b[2] - b[0])
        assert normals[0] @ normals[1] > 0


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("OFF BINARY\n1 2 3", "binary OFF"),
        ("4OFF\n1 1 0\n0 0 0 0\n", "other than three dimensions"),
        ("OFF\n", "no counts"),
        ("OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n5 0 1 2 3 3\n", "cannot be cut into triangles"),
        ("OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n4 0 1 2 4\n", "out of range: expected 0 to 3"),
        ("OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n", "do not fit what follows"),
        ("PLY\n", "does not begin with OFF"),
    ],
)
def test_an_off_file_is_refused_with_the_reason(tmp_path: Path, text, says):
    (tmp_path / "bad.off").write_text(text)
    with pytest.raises(MeshError, match=f"cannot read 'bad.off' as off: .*{says}"):
        reading.read(tmp_path / "bad.off")
