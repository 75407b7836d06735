"""Files as found, however they are written: each is read as it is meant, or the reason for its refusal is true."""

import base64
import struct
from pathlib import Path

import numpy as np
import pytest
import trimesh
from file_cases import glb, obj_of, prism, volume, written

from msf_jax.base.errors import MeshError
from msf_jax.meshes import checking, formats, reading


def assert_prism(vertices: np.ndarray, faces: np.ndarray) -> None:
    """The polygons became triangles, and no ear lies outside the L."""
    assert faces.shape == (2 * 4 + 6 * 2, 3) and volume(vertices, faces) == pytest.approx(3 * 0.7)
    area = np.linalg.norm(np.cross(*np.moveaxis(np.diff(vertices[faces], axis=1), 1, 0)), axis=1).sum() / 2
    assert area == pytest.approx(2 * 3 + 8 * 0.7)
    assert [part.genus for part in checking.prepare((vertices, faces)).components] == [0]


@pytest.mark.parametrize(
    ("between", "header", "colour"),
    [(" ", "OFF", ""), ("\n", "off", ""), (" \n ", "OFF", ""), (" ", "COFF", " 0.5 0.5 0.5")],
)
def test_polygons_of_an_off_file_become_triangles(tmp_path: Path, between, header, colour):
    assert_prism(*reading.read(written(tmp_path / "prism.off", between, header, colour)))


@pytest.mark.parametrize("counts", ["4 4 6", "4 4"])
@pytest.mark.parametrize("row", [None, 0, 4])
def test_files_of_triangles_are_read_alike_however_much_else_is_in_them(counts, row):
    """A word more in a row, and no count of edges: as many words as in a file without either."""
    rows = ["0 0 0", "1 0 0", "0 1 0", "0 0 1", "3 0 2 1", "3 0 1 3", "3 1 2 3", "3 0 3 2"]
    if row is not None:
        rows[row] += " 7"
    vertices, faces = formats.of_off("\n".join(["OFF", counts, *rows]).encode())
    np.testing.assert_array_equal(vertices, np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]))
    np.testing.assert_array_equal(faces, [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])


def test_a_quad_that_is_not_convex_is_not_folded():
    corners = np.array([[0, 0, 0], [4, -1, 0], [1, 0, 0], [4, 1, 0]], dtype=float)  # an arrow: its third corner is in
    for turn in range(4):
        order = np.roll(np.arange(4), turn)
        (a, b) = corners[formats.triangulated(corners, [order.tolist()])]
        normals = np.cross(a[1] - a[0], a[2] - a[0]), np.cross(b[1] - b[0], b[2] - b[0])
        assert normals[0] @ normals[1] > 0


def relative(content: str, num: int) -> str:
    """With the same corners counted back from where they are, and points after them that move no index."""
    lines = content.splitlines()
    for row, line in enumerate(lines):
        if line[0] == "f":
            lines[row] = "f " + " ".join(str(int(word) - 1 - num) for word in line.split()[1:])
    return "\n".join([*lines, *(f"v 9 9 {k}" for k in range(5))]) + "\n"


OBJ = obj_of(*prism())
ODD_OBJ = {
    "byte-order mark": OBJ.encode("utf-8-sig"),
    "carriage returns": OBJ.replace("\n", "\r\n").encode(),
    "tabs": OBJ.replace(" ", "\t").encode(),
    "indented": OBJ.replace("\n", "\n  ").encode(),
    "continued": OBJ.replace("f 6 5", "f 6 \\\n5").encode(),
    "comments and lines": OBJ.replace("\n", " # 0\n").encode() + b"l 1 2\n",
    "counted back": relative(OBJ, 12).encode(),
    "materials": OBJ.replace("f 6", "usemtl red\nf 6/1/2").replace("f 7", "usemtl blue\nf 7//3").encode(),
}


@pytest.mark.parametrize("name", ODD_OBJ)
def test_an_obj_is_read_as_it_is_meant(tmp_path: Path, name):
    """Vertices and faces in the order of the file."""
    (tmp_path / "a.obj").write_bytes(ODD_OBJ[name])
    vertices, faces = reading.read(tmp_path / "a.obj")
    np.testing.assert_array_equal(vertices[:12], prism()[0])
    assert_prism(vertices[:12], faces)


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
    assert_prism(*reading.read(tmp_path / "a.ply"))


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


@pytest.mark.parametrize("suffix", ["vtp", "vtk"])
def test_vtk_files_and_pyvista_objects_are_meshes(tmp_path: Path, suffix):
    """Quads become triangles; the points keep their numbers. A grid's boundary is to be taken by its owner."""
    pyvista = pytest.importorskip("pyvista")
    box = pyvista.Box((0, 1, 0, 2, 0, 3))  # six quads, each with corners of its own
    box.save(tmp_path / f"box.{suffix}")
    for mesh in (box, tmp_path / f"box.{suffix}"):
        vertices, faces = reading.read(mesh)
        np.testing.assert_allclose(vertices, box.points)
        assert faces.shape == (12, 3) and volume(vertices, faces) == pytest.approx(6.0)
    grid = pyvista.ImageData(dimensions=(4, 4, 4)).cast_to_unstructured_grid()
    with pytest.raises(MeshError, match=r"is a grid: .*extract_surface"):
        reading.read(grid)
    assert volume(*reading.read(grid.extract_surface(algorithm=None))) == pytest.approx(27.0)
    with pytest.raises(MeshError, match="the mesh is empty"):
        reading.read(pyvista.PolyData())


def test_without_pyvista_a_vtk_file_says_what_it_needs(tmp_path: Path, monkeypatch):
    (tmp_path / "a.vtp").write_text("<VTKFile/>")
    monkeypatch.setattr(reading.importlib.util, "find_spec", lambda name: None)
    with pytest.raises(MeshError, match="VTK's formats need pyvista: pip install"):
        reading.read(tmp_path / "a.vtp")
    assert not set(reading.readable_suffixes()) & reading.VTK


CUBE = trimesh.creation.box([1.0, 2.0, 3.0])
TEXT_CUBE = CUBE.export(file_type="ply", encoding="ascii")


@pytest.mark.parametrize(
    ("name", "content", "says"),
    [
        ("a.step", "ISO-10303-21;", r"unknown suffix '.step', expected one of .*3mf.*; export it to one of these"),
        ("a.stl", "this is a letter, and no mesh\n", "'a.stl' has no triangles: expected a triangle mesh"),
        ("a.ply", trimesh.PointCloud(CUBE.vertices).export(file_type="ply"), "'a.ply' has no triangles"),
        ("a.off", "OFF BINARY\n1 2 3", "expected OFF, as text"),
        ("a.off", "4OFF\n1 1 0\n0 0 0 0\n", "expected OFF, as text, with three coordinates"),
        ("a.off", "OFF\n", "no counts"),
        ("a.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n5 0 1 2 3 3\n", "cannot be cut into triangles"),
        ("a.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n4 0 1 2 4\n", "out of range: expected 0 to 3"),
        ("a.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n", "do not fit what follows"),
        ("a.obj", OBJ.replace("f 6", "f 0"), "line 13 has index 0: OBJ counts from 1"),
        ("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -4\n", "line 4 has index -4, out of range: 3 are before it"),
        ("a.obj", "v 0 0 0\nv 1 0 0\nf -1 -2 3\n", "index 3, out of range: expected 1 to 2"),
        ("a.obj", "v 0 0 0\nv 1 0\n", "line 2 is 'v 1 0': expected at least three after v"),
        ("a.obj", OBJ.encode("utf-16"), "no text, or UTF-16: save it as UTF-8"),
        ("a.stl", CUBE.export(file_type="stl_ascii")[:900], "cut off: a solid has no endsolid"),
        ("a.stl", 2 * CUBE.export(file_type="stl_ascii")[:-60] + "\n", "cut off: a solid has no endsolid"),
        ("a.stl", CUBE.export(file_type="stl")[:-9], "cut off, or no STL: 12 triangles need 684 bytes"),
        ("a.ply", TEXT_CUBE.replace(b"\n3 1 3 0", b"\n4 1 3 0"), "a list|cut off"),
        ("a.ply", TEXT_CUBE.replace(b"\n3 1 3 0", b"\n3 1 3.5 0"), "whole number"),
        ("a.ply", TEXT_CUBE.replace(b"\n3 1 3 0", b"\n3 1 3 1e300"), "whole number"),
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
    content = {
        "off": "\n".join(["OFF", "5 3 0", *rows]),
        "obj": obj_of(HUGE, PENTAGONS),
        "ply": header + "\n".join(rows),
        "stl": trimesh.creation.box().export(file_type="stl_ascii").replace("0.5", "1e308"),
    }
    (tmp_path / f"a.{suffix}").write_text(content[suffix])
    with pytest.raises(MeshError, match=r"choose another unit|cannot be cut"):
        reading.read(tmp_path / f"a.{suffix}")


def primitive(document):
    return document["meshes"][0]["primitives"][0]


def accessor(document, name="POSITION"):
    found = primitive(document)
    return document["accessors"][found["attributes"].get(name, found["indices"])]


def instanced(document):
    node = next(node for node in document["nodes"] if "mesh" in node)
    node["extensions"] = {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 0}}}


NOT_READ = {
    "a sparse accessor": lambda d: accessor(d).update(sparse={"count": 1}),
    "its indices is a sparse accessor": lambda d: accessor(d, "indices").update(sparse={"count": 1}),
    "needs EXT_mesh_gpu_instancing": instanced,
    "needs KHR_draco_mesh_compression": lambda d: d.update(extensionsRequired=["KHR_draco_mesh_compression"]),
    "needs EXT_meshopt_compression": lambda d: d.update(extensionsRequired=["EXT_meshopt_compression"]),
    "needs ACME_bend, which is not supported": lambda d: d.update(extensionsRequired=["ACME_bend"]),
    "morph targets": lambda d: (primitive(d).update(targets=[{"POSITION": 0}]), d["meshes"][0].update(weights=[0.5])),
    "triangle fan": lambda d: primitive(d).update(mode=6),
    "its POSITION has components of type 5123": lambda d: accessor(d).update(componentType=5123),
    "its indices has components of type 5126": lambda d: accessor(d, "indices").update(componentType=5126),
    "normalized integers": lambda d: accessor(d).update(normalized=True),
}


@pytest.mark.parametrize("says", NOT_READ)
def test_what_is_not_supported_in_gltf_is_refused_by_its_name(tmp_path: Path, says):
    assert len(reading.read(glb(tmp_path / "a.glb"))[1]) == 80
    with pytest.raises(MeshError, match=says):
        reading.read(glb(tmp_path / "a.glb", NOT_READ[says]))


def test_morph_targets_without_weights_do_not_move_the_mesh(tmp_path: Path):
    path = glb(tmp_path / "a.glb", lambda d: primitive(d).update(targets=[{"POSITION": 0}]))
    assert len(reading.read(path)[1]) == 80


def test_a_mesh_with_a_skin_is_where_its_joints_hold_it(tmp_path: Path):
    """Its own node, of ten times the size, does not matter. Weights are whole numbers; the second joint is twice as
    large as the first, below which it is, and one vertex has no weight, which gives it to the first of its joints."""
    num, own = 42, np.eye(4, dtype=np.float32)
    weights, binds = np.tile(np.array([3, 1, 0, 0], dtype=np.uint8), (num, 1)), np.stack([own, 2 * own])
    weights[0], binds[1, 3] = 0, [0, 0, 5, 1]  # the format's matrices are transposed
    content = np.tile(np.array([0, 1, 0, 0], dtype=np.uint8), (num, 1)).tobytes() + weights.tobytes() + binds.tobytes()

    def bind(document):
        document["buffers"].append({"uri": f"data:;base64,{base64.b64encode(content).decode()}", "byteLength": 464})
        for place, size, kind, component, count in [
            (0, 168, "VEC4", 5121, num),
            (168, 168, "VEC4", 5121, num),
            (336, 128, "MAT4", 5126, 2),
        ]:
            view = {"buffer": len(document["buffers"]) - 1, "byteOffset": place, "byteLength": size}
            document["bufferViews"].append(view)
            accessor = {"bufferView": len(document["bufferViews"]) - 1, "componentType": component, "count": count}
            document["accessors"].append(accessor | {"type": kind})
        first = len(document["accessors"]) - 3
        given = primitive(document)["attributes"]
        given |= {"JOINTS_0": first, "WEIGHTS_0": first + 1, "NORMAL": given["POSITION"]}  # the ball has radius 1
        document["skins"] = [{"joints": [1, 2], "inverseBindMatrices": first + 2}]
        document["nodes"] = [
            {"mesh": 0, "skin": 0, "scale": [10, 10, 10]},
            {"translation": [1, 0, 0], "children": [2]},
            {"translation": [0, 1, 0]},
        ]
        document["scenes"] = [{"nodes": [0, 1]}]

    rest, held = reading.parts(glb(tmp_path / "a.glb"))[0], reading.parts(glb(tmp_path / "b.glb", bind))[0]
    x = np.asarray(rest.vertices)
    by_both = 0.75 * (x + [1, 0, 0]) + 0.25 * (2 * x + [1, 1, 5])
    by_both[0] = x[0] + [1, 0, 0]
    np.testing.assert_allclose(held.vertices, by_both, atol=1e-6)
    np.testing.assert_allclose(held.vertex_normals, x, atol=1e-6)
