"""Files as found: OFF of quads and polygons, 3MF, scenes with transforms; each is read, or the reason is true."""

from pathlib import Path

import numpy as np
import pytest
import pyvista
import trimesh

import msf_jax
from msf_jax.base.errors import MeshError
from msf_jax.host.mesh import checking, reading
from msf_jax.host.mesh.files import off, unpacking

L_SHAPE = np.array([[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]], dtype=float)


def prism() -> tuple[list[list[float]], list[list[int]]]:
    """A prism over an L: two faces of six corners, not convex, and six quads; its volume is 3 x 0.7."""
    vertices = [[x, y, z] for z in (0.0, 0.7) for x, y in L_SHAPE.tolist()]
    sides = [[k, (k + 1) % 6, (k + 1) % 6 + 6, k + 6] for k in range(6)]
    return vertices, [[5, 4, 3, 2, 1, 0], [6, 7, 8, 9, 10, 11], *sides]


def written(path: Path, between: str, header: str = "OFF", colour: str = "") -> Path:
    """The prism as OFF, with ``between`` the words of a face."""
    vertices, faces = prism()
    rows = [" ".join(map(str, vertex)) for vertex in vertices]
    rows += [between.join(map(str, [len(face), *face])) + colour for face in faces]
    path.write_text("\n".join([header, f"# a prism\n\n{len(vertices)} {len(faces)} 0", *rows]) + "\n")
    return path


def volume(vertices: np.ndarray, faces: np.ndarray) -> float:
    """By the divergence theorem."""
    return float(np.linalg.det(vertices[faces]).sum() / 6)


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


@pytest.mark.parametrize("suffix", ["3mf", "glb"])
def test_a_scene_is_read_with_its_transforms(tmp_path: Path, suffix):
    """One box three times: where it is, moved, and mirrored; each encloses its volume, none is inside out."""
    scene, box = trimesh.Scene(), trimesh.creation.box([1.0, 2.0, 3.0])
    moved, mirrored = np.eye(4), np.eye(4)
    moved[:3, 3], mirrored[:3, 3] = [5, 0, 0], [0, 7, 0]
    mirrored[0, 0] = -1
    for number, transform in enumerate((np.eye(4), moved, mirrored)):
        scene.add_geometry(box, node_name=f"box {number}", transform=transform)
    (tmp_path / f"scene.{suffix}").write_bytes(scene.export(file_type=suffix))
    found = checking.prepare(tmp_path / f"scene.{suffix}")
    assert [volume(part.vertices, part.faces) for part in found.components] == pytest.approx([6.0] * 3)
    assert not any("flipped" in sentence for sentence in found.repairs)
    middles = sorted(tuple(np.round(part.vertices.mean(axis=0), 5) + 0.0) for part in found.components)
    assert middles == [(0, 0, 0), (0, 7, 0), (5, 0, 0)]


def test_an_archive_that_unpacks_to_too_much_is_refused(tmp_path: Path, monkeypatch):
    (tmp_path / "box.3mf").write_bytes(trimesh.creation.box().export(file_type="3mf"))
    assert len(reading.read(tmp_path / "box.3mf")[0]) == 8
    monkeypatch.setattr(unpacking, "LARGEST", 100)
    with pytest.raises(MeshError, match=r"unpacks to \d+ bytes: expected at most 100"):
        reading.read(tmp_path / "box.3mf")


def test_a_format_that_is_not_read_says_what_to_do(tmp_path: Path):
    (tmp_path / "part.step").write_text("ISO-10303-21;")
    with pytest.raises(MeshError, match=r"unknown suffix '.step', expected one of .*3mf.*; export it to one of these"):
        reading.read(tmp_path / "part.step")


@pytest.mark.parametrize("kind", ["stl", "stl_ascii"])
def test_an_stl_has_each_vertex_once_and_asks_for_no_repair(tmp_path: Path, kind):
    """It has no indices; and some programs write the corners of one vertex with other last bits."""
    torus = trimesh.creation.torus(1.0, 0.3, 24, 12)
    shaken = torus.triangles.reshape(-1, 3) * (1 + 2.0**-24 * np.random.default_rng(1).integers(-1, 2, (3 * 576, 3)))
    loose = trimesh.Trimesh(shaken, np.arange(3 * 576).reshape(-1, 3), process=False)
    loose.export(tmp_path / "torus.stl", file_type=kind)
    vertices, faces = reading.read(tmp_path / "torus.stl")
    assert vertices.shape == torus.vertices.shape and faces.shape == torus.faces.shape
    np.testing.assert_allclose(vertices[faces], torus.triangles, atol=1e-6)
    assert checking.prepare(tmp_path / "torus.stl").repairs == ()


@pytest.mark.parametrize("suffix", ["vtp", "vtk"])
def test_vtk_files_and_pyvista_objects_are_meshes(tmp_path: Path, suffix):
    """Quads become triangles; the points keep their numbers."""
    box = pyvista.Box((0, 1, 0, 2, 0, 3))  # six quads, each with corners of its own
    box.save(tmp_path / f"box.{suffix}")
    for mesh in (box, tmp_path / f"box.{suffix}"):
        vertices, faces = reading.read(mesh)
        np.testing.assert_allclose(vertices, box.points)
        assert faces.shape == (12, 3) and volume(vertices, faces) == pytest.approx(6.0)


def test_a_grid_is_its_boundary(tmp_path: Path):
    grid = pyvista.ImageData(dimensions=(4, 4, 4)).cast_to_unstructured_grid()
    grid.save(tmp_path / "grid.vtu")
    for mesh in (grid, tmp_path / "grid.vtu"):
        assert volume(*reading.read(mesh)) == pytest.approx(27.0)
    with pytest.raises(MeshError, match="has no surface"):
        reading.read(pyvista.PolyData())


def test_without_pyvista_a_vtk_file_says_what_it_needs(tmp_path: Path, monkeypatch):
    (tmp_path / "a.vtp").write_text("<VTKFile/>")
    monkeypatch.setattr(reading.importlib.util, "find_spec", lambda name: None)
    with pytest.raises(MeshError, match="VTK's formats need pyvista: pip install"):
        reading.read(tmp_path / "a.vtp")
    assert not set(reading.readable_suffixes()) & reading.VTK


@pytest.mark.parametrize(
    ("name", "text", "says"),
    [
        ("a.ply", "", "'a.ply' is empty: expected a mesh file"),
        ("a.stl", "this is a letter, and no mesh\n", "'a.stl' has no triangles: expected a triangle mesh"),
    ],
)
def test_what_is_no_mesh_is_told_in_plain_words(tmp_path: Path, name, text, says):
    (tmp_path / name).write_text(text)
    with pytest.raises(MeshError, match=says):
        reading.read(tmp_path / name)


def test_read_mesh_is_public_and_reads_as_skeletonize_does(tmp_path: Path):
    path = written(tmp_path / "prism.off", " ")
    for mine, ours in zip(msf_jax.read_mesh(path), reading.read(path), strict=True):
        np.testing.assert_array_equal(mine, ours)
