"""Files as found: scenes with transforms, VTK's formats, damaged ones; each is read, or the reason is true."""

from pathlib import Path

import numpy as np
import pytest
import trimesh
from file_cases import obj_of, prism, volume, written

import msf_jax
from msf_jax.base.errors import MeshError
from msf_jax.meshes import checking, reading


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


def test_a_format_that_is_not_read_says_what_to_do(tmp_path: Path):
    (tmp_path / "part.step").write_text("ISO-10303-21;")
    with pytest.raises(MeshError, match=r"unknown suffix '.step', expected one of .*3mf.*; export it to one of these"):
        reading.read(tmp_path / "part.step")


@pytest.mark.parametrize("suffix", ["vtp", "vtk"])
def test_vtk_files_and_pyvista_objects_are_meshes(tmp_path: Path, suffix):
    """Quads become triangles; the points keep their numbers."""
    pyvista = pytest.importorskip("pyvista")
    box = pyvista.Box((0, 1, 0, 2, 0, 3))  # six quads, each with corners of its own
    box.save(tmp_path / f"box.{suffix}")
    for mesh in (box, tmp_path / f"box.{suffix}"):
        vertices, faces = reading.read(mesh)
        np.testing.assert_allclose(vertices, box.points)
        assert faces.shape == (12, 3) and volume(vertices, faces) == pytest.approx(6.0)


def test_a_grid_is_its_boundary(tmp_path: Path):
    pyvista = pytest.importorskip("pyvista")
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


CUBE = trimesh.creation.box([1.0, 2.0, 3.0])


@pytest.mark.parametrize(
    ("name", "content", "says"),
    [
        ("a.obj", obj_of(*prism()).replace("f 6", "f 0"), "line 13 has index 0: OBJ counts from 1"),
        ("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -4\n", "line 4 has index -4, out of range: 3 are before it"),
        ("a.obj", "v 0 0 0\nv 1 0 0\nf -1 -2 3\n", "index 3, out of range: expected 1 to 2"),
        ("a.obj", "v 0 0 0\nv 1 0\n", "line 2 is 'v 1 0': expected at least three after v"),
        ("a.obj", "v 0 0 0\n".encode("utf-16-le"), "UTF-16 without a byte-order mark: save it as UTF-8"),
        ("a.stl", trimesh.creation.box().export(file_type="stl_ascii")[:900], "cut off: a solid has no endsolid"),
        ("a.stl", 2 * CUBE.export(file_type="stl_ascii")[:-60] + "\n", "cut off: a solid has no endsolid"),
        (
            "a.stl",
            trimesh.creation.box().export(file_type="stl")[:-9],
            "cut off, or no STL: 12 triangles need 684 bytes",
        ),
        ("a.ply", CUBE.export(file_type="ply", encoding="ascii").replace(b"\n3 1 3 0", b"\n4 1 3 0"), "a list|cut off"),
        ("a.ply", CUBE.export(file_type="ply", encoding="ascii").replace(b"\n3 1 3 0", b"\n3 1 3.5 0"), "whole number"),
        (
            "a.ply",
            CUBE.export(file_type="ply", encoding="ascii").replace(b"\n3 1 3 0", b"\n3 1 3 1e300"),
            "whole number",
        ),
    ],
)
def test_a_file_that_would_be_read_as_another_mesh_is_refused(tmp_path: Path, name, content, says):
    (tmp_path / name).write_bytes(content if isinstance(content, bytes) else content.encode())
    with pytest.raises(MeshError, match=says):
        reading.read(tmp_path / name)


HUGE = [(1e308, 0, 0), (-1e308, 1e308, 0), (0, 0, 1e308), (0, 0, -1e308), (1e308, 1e308, 0)]


PENTAGONS = [[0, 1, 2, 3, 4], [4, 3, 2, 1, 0], [0, 1, 2, 3]]


@pytest.mark.parametrize("suffix", ["off", "obj", "ply", "stl"])
def test_coordinates_whose_squares_overflow_are_refused(tmp_path: Path, suffix):
    """Also in polygons, which are cut before coordinates are checked."""
    rows = [" ".join(map(str, row)) for row in [*HUGE, *([len(face), *face] for face in PENTAGONS)]]
    header = "ply\nformat ascii 1.0\nelement vertex 5\nproperty double x\nproperty double y\nproperty double z\n"
    header += "element face 3\nproperty list uchar int vertex_index\nend_header\n"
    text = {
        "off": "\n".join(["OFF", "5 3 0", *rows]),
        "obj": obj_of(HUGE, PENTAGONS),
        "ply": header + "\n".join(rows),
        "stl": trimesh.creation.box().export(file_type="stl_ascii").replace("0.5", "1e308"),
    }
    (tmp_path / f"a.{suffix}").write_text(text[suffix])
    for finite in (True, False):
        with pytest.raises(MeshError, match=r"choose another unit|cannot be cut"):
            reading.read(tmp_path / f"a.{suffix}", finite=finite)
