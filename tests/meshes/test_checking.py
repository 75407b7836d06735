"""Validation: what it takes, what it repairs and says so, what it refuses and how it words that."""

from pathlib import Path

import numpy as np
import pytest
import trimesh
from conftest import blob, torus

from msf_jax.base.errors import MeshError
from msf_jax.meshes import checking

OCTAHEDRON = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], dtype=float)
OCTAHEDRON_FACES = np.array([[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]])


def pair(mesh: trimesh.Trimesh) -> tuple[np.ndarray, np.ndarray]:
    """Plain arrays of a Trimesh."""
    return np.array(mesh.vertices), np.array(mesh.faces)


def volume(vertices: np.ndarray, faces: np.ndarray) -> float:
    """Signed volume by the divergence theorem, as a sum of 3 x 3 determinants."""
    return float(np.linalg.det(vertices[faces]).sum() / 6)


def assert_closed_and_oriented(faces: np.ndarray, num_vertices: int) -> None:
    """Every directed edge once, with its reverse; every vertex used, its faces one fan."""
    directed = {(u, v) for face in faces.tolist() for u, v in zip(face, face[1:] + face[:1], strict=True)}
    assert len(directed) == 3 * len(faces)
    assert all((v, u) in directed for u, v in directed)
    follows: list[dict[int, int]] = [{} for _ in range(num_vertices)]
    for a, b, c in faces.tolist():
        follows[a][b], follows[b][c], follows[c][a] = c, a, b
    for step in follows:
        assert len(step) >= 3
        start = at = next(iter(step))
        round_trip = 0
        while round_trip == 0 or at != start:
            at, round_trip = step[at], round_trip + 1
        assert round_trip == len(step)


def refusal(mesh) -> str:
    """The message with which ``mesh`` is refused."""
    with pytest.raises(MeshError) as caught:
        checking.prepare(mesh)
    return str(caught.value)


def assert_says(message: str, *phrases: str) -> None:
    """All of ``phrases`` stand in ``message``."""
    for phrase in phrases:
        assert phrase in message, f"{phrase!r} not in {message!r}"


# What it takes


def test_a_sound_pair_passes_as_it_is():
    vertices, faces = pair(torus())
    checked = checking.prepare((vertices, faces))
    assert checked.repairs == ()
    np.testing.assert_array_equal(checked.vertices, vertices)
    np.testing.assert_array_equal(checked.faces, faces)
    np.testing.assert_array_equal(checked.vertex_of_input, np.arange(len(vertices)))
    assert checked.strays.shape == (0, 3)
    assert [component.genus for component in checked.components] == [1]
    np.testing.assert_array_equal(checked.members[0], np.arange(len(vertices)))


def test_lists_float32_and_whole_float_faces_are_taken():
    vertices, faces = pair(blob(1, 1))
    whole = checking.prepare((vertices, faces))
    for given in (
        [vertices.tolist(), faces.tolist()],
        (vertices.astype(np.float32), faces.astype(np.uint32)),
        (vertices, faces.astype(float)),
    ):
        checked = checking.prepare(given)
        assert checked.vertices.dtype == np.float64 and checked.faces.dtype == np.int64
        np.testing.assert_array_equal(checked.faces, whole.faces)
        np.testing.assert_allclose(checked.vertices, vertices, rtol=1e-6, atol=1e-7)


def test_a_trimesh_is_taken_and_not_changed():
    mesh = blob(2, 2)
    mesh.invert()  # so that there is something to repair
    before = mesh.vertices.copy(), mesh.faces.copy(), mesh.volume
    checked = checking.prepare(mesh)
    assert checked.repairs
    checked.vertices[:] = 7.0
    checked.faces[:] = 0
    np.testing.assert_array_equal(mesh.vertices, before[0])
    np.testing.assert_array_equal(mesh.faces, before[1])
    assert mesh.volume == before[2] < 0


@pytest.mark.parametrize("damage", ["none", "inverted", "soup", "stray", "pinched"])
def test_the_callers_arrays_are_read_only_safe(damage):
    """Every repair works on arrays that cannot be written, and leaves them as they were."""
    vertices, faces = pair(blob(3, 2))
    if damage == "inverted":
        faces = faces[:, ::-1].copy()
    elif damage == "soup":
        vertices, faces = vertices[faces].reshape(-1, 3), np.arange(faces.size).reshape(-1, 3)
    elif damage == "stray":
        vertices, faces = np.concatenate([[[9.0, 9, 9]], vertices]), faces + 1
    elif damage == "pinched":
        vertices, faces = touching_octahedra()
    vertices.setflags(write=False)
    faces.setflags(write=False)
    checked = checking.prepare((vertices, faces))
    assert bool(checked.repairs) == (damage != "none")
    assert not np.shares_memory(checked.vertices, vertices)
    assert not np.shares_memory(checked.faces, faces)
    assert not any(np.shares_memory(component.vertices, vertices) for component in checked.components)


@pytest.mark.parametrize("suffix", ["off", "ply", "obj", "stl", "glb"])
@pytest.mark.parametrize("as_text", [False, True])
def test_a_path_is_read(tmp_path: Path, suffix, as_text):
    """All common suffixes; stl stores a soup, which is welded back to the vertices that there were."""
    mesh = torus(around=10, across=6)
    path = tmp_path / f"mesh.{suffix}"
    mesh.export(path)
    checked = checking.prepare(str(path) if as_text else path)
    assert len(checked.vertices) == 60 and len(checked.faces) == 120
    assert [component.genus for component in checked.components] == [1]
    assert volume(checked.vertices, checked.faces) == pytest.approx(mesh.volume, rel=1e-5)
    assert checked.repairs == ()


def test_a_scene_file_is_read_with_all_its_parts(tmp_path: Path):
    parts = [trimesh.creation.box(), trimesh.creation.icosphere(1).apply_translation([5, 0, 0])]
    trimesh.Scene(parts).export(tmp_path / "scene.glb")
    checked = checking.prepare(tmp_path / "scene.glb")
    assert sorted(len(component.vertices) for component in checked.components) == [8, 42]


@pytest.mark.parametrize("scale", [1e-30, 1e-9, 1e-3, 1e3, 1e9, 1e30])
def test_scale_and_place_do_not_matter(scale):
    vertices, faces = pair(torus())
    checked = checking.prepare(((vertices + np.array([30.0, -20, 10])) * scale, faces))
    assert checked.repairs == () and checked.components[0].genus == 1


# What it refuses: things that are no mesh


@pytest.mark.parametrize("thing", [None, 3.5, "", b"mesh.off", (1, 2, 3), trimesh.PointCloud(OCTAHEDRON)])
def test_something_else_than_a_mesh_is_refused(thing):
    message = refusal(thing)
    assert ("expected a path" in message and type(thing).__name__ in message) or "is no file" in message


def test_a_missing_file_and_a_folder_are_named(tmp_path: Path):
    assert_says(refusal("/nowhere/at all/horse.off"), "'/nowhere/at all/horse.off' is no file", "check the path")
    assert_says(refusal(tmp_path), str(tmp_path), "is no file")


@pytest.mark.parametrize(
    "content", [b"", b"not a mesh", b"OFF\n9999 4 0\n1 2 3\n", b"OFF\n1 1 0\nx y z\n3 0 0 0\n", bytes(range(256)) * 4]
)
def test_garbage_with_a_known_suffix_is_refused_by_name(tmp_path: Path, content):
    path = tmp_path / "garbage.off"
    path.write_bytes(content)
    assert_says(refusal(path), "'garbage.off'")


# What it refuses: arrays that are no mesh


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
def test_vertices_that_are_not_finite_are_counted_and_located(value):
    vertices, faces = pair(torus())
    vertices[5, 1] = value
    assert_says(refusal((vertices, faces)), "1 vertex (5) is not finite")
    vertices[10:20] = value
    assert_says(refusal((vertices, faces)), "11 vertices (5, 10, 11, 12, 13, ...) are not finite")


def test_vertices_of_the_wrong_shape_or_kind_are_refused():
    assert_says(refusal((OCTAHEDRON[:, :2], OCTAHEDRON_FACES)), "vertices have shape (6, 2)", "expected (V, 3)")
    assert_says(refusal((OCTAHEDRON.ravel(), OCTAHEDRON_FACES)), "vertices have shape (18,)")
    assert_says(refusal(([["a", "b", "c"]], OCTAHEDRON_FACES)), "vertices are no array of numbers")


def test_an_empty_mesh_is_refused():
    assert_says(refusal((np.empty((0, 3)), np.empty((0, 3), int))), "empty", "no vertices")
    assert_says(refusal((OCTAHEDRON, np.empty((0, 3), int))), "no faces", "expected a closed triangle mesh")
    assert_says(refusal(trimesh.Trimesh()), "empty")


def test_quads_are_refused():
    quads = np.array([[0, 2, 1, 3], [0, 4, 1, 5]])
    assert_says(refusal((OCTAHEDRON, quads)), "(2, 4)", "expected (F, 3)", "triangulate")
    assert_says(refusal((OCTAHEDRON, [[0, 2, 4], [0, 4, 1, 5]])), "different numbers of corners", "triangulate")


def test_faces_that_are_no_whole_numbers_are_refused():
    faces = OCTAHEDRON_FACES.astype(float)
    faces[2, 1] += 0.5
    assert_says(refusal((OCTAHEDRON, faces)), "float64", "not whole numbers", "expected vertex indices from 0")
    faces[2, 1] = np.nan
    assert_says(refusal((OCTAHEDRON, faces)), "not whole numbers")
    assert_says(refusal((OCTAHEDRON, OCTAHEDRON_FACES > 2)), "bool")


def test_an_index_out_of_range_is_counted_and_located():
    for value in (6, -1, 10**12):
        faces = OCTAHEDRON_FACES.copy()
        faces[[1, 4], [2, 0]] = value
        message = refusal((OCTAHEDRON, faces))
        assert_says(message, "2 faces (1, 4) are out of range", "expected vertex indices from 0 to 5")
        assert "counted from 1" not in message
    assert_says(refusal((OCTAHEDRON, OCTAHEDRON_FACES + 1)), "out of range", "are they counted from 1?")


def test_a_face_with_a_corner_twice_is_refused():
    faces = np.concatenate([OCTAHEDRON_FACES, [[3, 3, 4]]])
    assert_says(refusal((OCTAHEDRON, faces)), "1 face (8) is degenerate", "a corner occurs twice", "remove")


# What it refuses: surfaces that are no solid


def test_an_open_mesh_is_refused_with_the_edges_of_its_hole():
    message = refusal((OCTAHEDRON, OCTAHEDRON_FACES[1:]))  # without the face 0 2 4
    assert_says(message, "open", "3 edges (0-2, 0-4, 2-4) with only one face", "close its holes")


def test_a_crowded_edge_is_refused():
    """Two tetrahedra on one edge: four faces meet at it, two at each of the others."""
    apex = np.array([[0, 0, 0], [0, 0, 1], [1, 0, 0.5], [0.7, 0.7, 0.5], [-1, 0, 0.5], [-0.7, -0.7, 0.5]])
    tetrahedra = [(0, 1, 2, 3), (0, 1, 4, 5)]
    faces = np.array([f for a, b, c, d in tetrahedra for f in ((a, c, b), (a, b, d), (b, c, d), (a, d, c))])
    assert_says(refusal((apex, faces)), "not manifold", "1 edge (0-1) with more than two faces", "separate the sheets")


def test_a_face_given_twice_is_refused():
    faces = np.concatenate([OCTAHEDRON_FACES, OCTAHEDRON_FACES[:1]])
    assert_says(refusal((OCTAHEDRON, faces)), "not manifold: 3 edges (0-2, 0-4, 2-4)")


def test_one_turned_face_is_refused_with_its_edges():
    faces = OCTAHEDRON_FACES.copy()
    faces[0] = faces[0][::-1]
    assert_says(refusal((OCTAHEDRON, faces)), "not consistently oriented: 3 edges (0-2, 0-4, 2-4)", "fix_winding")


def test_a_half_turned_mesh_is_refused_with_as_many_edges_as_lie_between():
    """Turn the faces above the torus's plane of symmetry: the edges between both kinds are at fault."""
    mesh = torus()
    vertices, faces = pair(mesh)
    is_turned = mesh.triangles_center[:, 2] > 0
    num_between = int((is_turned[mesh.face_adjacency[:, 0]] != is_turned[mesh.face_adjacency[:, 1]]).sum())
    faces[is_turned] = faces[is_turned][:, ::-1]
    assert_says(refusal((vertices, faces)), f"not consistently oriented: {num_between} edges")


def test_a_tetrahedron_is_refused():
    mesh = trimesh.Trimesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
    assert_says(refusal(mesh), "the mesh is a tetrahedron", "at least 5", "subdivide")
    assert checking.prepare(mesh.subdivide()).repairs == ()  # what the message advises


def test_a_small_component_is_named_among_many():
    tetrahedron = trimesh.Trimesh(
        [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]
    )
    both = trimesh.util.concatenate([torus().apply_translation([9, 0, 0]), tetrahedron])
    assert_says(refusal(both), "component 1 (the one with vertex 288) is a tetrahedron")


@pytest.mark.parametrize("tilt", [0.0, 0.7])
def test_a_closed_flat_sheet_is_refused(tilt):
    mesh = torus().apply_transform(np.diag([1.0, 1, 0, 1]))
    mesh.apply_transform(trimesh.transformations.rotation_matrix(tilt, [1, 2, 3], [5, 5, 5]))
    assert_says(refusal(pair(mesh)), "encloses no volume", "expected a solid")


# What it repairs


def test_a_soup_is_welded():
    """Every triangle with corners of its own, as in an STL file; half of the zeros are negative zeros."""
    mesh = trimesh.creation.icosphere(2)
    soup = np.array(mesh.triangles).reshape(-1, 3)
    zeros = np.flatnonzero(soup == 0)
    soup.ravel()[zeros[::2]] = -0.0
    checked = checking.prepare((soup, np.arange(len(soup)).reshape(-1, 3)))
    assert len(zeros) > 100
    assert len(checked.vertices) == len(mesh.vertices) and len(checked.faces) == len(mesh.faces)
    assert checked.repairs == (f"welded {len(soup) - len(mesh.vertices)} duplicate vertices",)
    np.testing.assert_array_equal(checked.vertices[checked.vertex_of_input], soup)
    assert_closed_and_oriented(checked.faces, len(checked.vertices))
    assert volume(checked.vertices, checked.faces) == pytest.approx(mesh.volume)


def test_welding_drops_the_faces_that_it_crushes():
    """A slit whose sides coincide: the two slivers across it vanish with it."""
    vertices = np.concatenate([OCTAHEDRON, OCTAHEDRON[4:5]])
    faces = OCTAHEDRON_FACES.copy()
    faces[0] = [0, 2, 6]  # one corner of one face is a copy of vertex 4
    checked = checking.prepare((vertices, np.concatenate([faces, [[0, 6, 4]]])))
    assert checked.repairs == ("welded 1 duplicate vertex",)
    assert len(checked.faces) == 8
    assert_closed_and_oriented(checked.faces, 6)
    np.testing.assert_array_equal(checked.vertex_of_input, [0, 1, 2, 3, 4, 5, 4])


def test_nearly_coincident_vertices_are_not_welded():
    """A weld that needs a tolerance would need a guess: the mesh stays open and is refused."""
    vertices = np.concatenate([OCTAHEDRON, OCTAHEDRON[4:5] + 1e-12])
    faces = OCTAHEDRON_FACES.copy()
    faces[0] = [0, 2, 6]
    assert_says(refusal((vertices, faces)), "open: 4 edges (0-4, 0-6, 2-4, 2-6)")


def test_closed_parts_that_touch_are_not_welded():
    """A closed mesh has nothing to weld, even if vertices of its parts coincide."""
    vertices = np.concatenate([OCTAHEDRON, OCTAHEDRON + np.array([2.0, 0, 0])])
    checked = checking.prepare((vertices, np.concatenate([OCTAHEDRON_FACES, OCTAHEDRON_FACES + 6])))
    assert checked.repairs == () and len(checked.vertices) == 12 and len(checked.components) == 2


def test_an_inside_out_mesh_is_flipped():
    mesh = blob(4, 2)
    mesh.invert()
    checked = checking.prepare(mesh)
    assert checked.repairs == ("flipped the mesh, which was inside out",)
    np.testing.assert_array_equal(checked.vertices, mesh.vertices)
    assert volume(checked.vertices, checked.faces) == pytest.approx(-mesh.volume) and mesh.volume < 0
    component = checked.components[0]
    assert volume(component.vertices, component.faces) == pytest.approx(-mesh.volume)


def test_only_the_component_that_is_inside_out_is_flipped():
    parts = [torus(), trimesh.creation.icosphere(1).apply_translation([4, 0, 0]), torus().apply_translation([9, 0, 0])]
    parts[1].invert()
    checked = checking.prepare(trimesh.util.concatenate(parts))
    assert checked.repairs == ("flipped component 1 (the one with vertex 288), which was inside out",)
    for component, part in zip(checked.components, parts, strict=True):
        assert volume(component.vertices, component.faces) == pytest.approx(abs(part.volume))
    assert volume(checked.vertices, checked.faces) == pytest.approx(sum(abs(part.volume) for part in parts))


def touching_octahedra() -> tuple[np.ndarray, np.ndarray]:
    """Two octahedra that share the vertex (1, 0, 0), number 0: 11 vertices, 16 faces."""
    number = np.array([6, 0, 7, 8, 9, 10])  # the second's (-1, 0, 0) is the first's (1, 0, 0)
    others = np.delete(OCTAHEDRON, 1, axis=0) + np.array([2.0, 0, 0])
    return np.concatenate([OCTAHEDRON, others]), np.concatenate([OCTAHEDRON_FACES, number[OCTAHEDRON_FACES]])


def test_a_vertex_where_two_solids_touch_is_split():
    vertices, faces = touching_octahedra()
    checked = checking.prepare((vertices, faces))
    assert checked.repairs == ("split 1 pinched vertex into one per fan",)
    assert len(checked.vertices) == 12
    np.testing.assert_array_equal(checked.vertices[:11], vertices)
    np.testing.assert_array_equal(checked.vertices[11], vertices[0])
    np.testing.assert_array_equal(checked.vertices[checked.faces], vertices[faces])  # nothing has moved
    np.testing.assert_array_equal(checked.vertex_of_input, np.arange(11))
    assert [len(component.vertices) for component in checked.components] == [6, 6]
    assert [component.genus for component in checked.components] == [0, 0]
    assert_closed_and_oriented(checked.faces, 12)


def test_a_surface_that_touches_itself_is_split_and_keeps_its_genus():
    """Three pairs of a sphere's vertices made one: still a sphere once split."""
    vertices, faces = pair(trimesh.creation.icosphere(3))
    partner = {}
    for angle in (0, 120, 240):  # far enough apart to share no edge
        target = [0.5 * np.cos(np.radians(angle)), 0.5 * np.sin(np.radians(angle)), 0.8]
        top = int(np.argmin(np.linalg.norm(vertices - target, axis=1)))
        bottom = int(np.argmin(np.linalg.norm(vertices - vertices[top] * [1, 1, -1], axis=1)))
        vertices[top] *= [1, 1, 0.02]
        partner[bottom] = top
    number = np.arange(len(vertices))
    number[list(partner)] = list(partner.values())
    used = np.unique(number)
    vertices, faces = vertices[used], np.searchsorted(used, number)[faces]
    checked = checking.prepare((vertices, faces))
    assert checked.repairs == ("split 3 pinched vertices into one per fan",)
    assert len(checked.vertices) == len(vertices) + 3
    np.testing.assert_array_equal(checked.vertices[checked.faces], vertices[faces])
    assert [component.genus for component in checked.components] == [0]
    assert_closed_and_oriented(checked.faces, len(checked.vertices))


def test_vertices_without_a_face_are_dropped_and_remembered():
    mesh = torus(around=8, across=5)
    strays = np.array([[7.0, 0, 0], [8, 0, 0], [9, 0, 0]])
    vertices = np.concatenate([strays[:1], mesh.vertices[:20], strays[1:2], mesh.vertices[20:], strays[2:]])
    place = np.concatenate([np.arange(1, 21), np.arange(22, 42)])
    checked = checking.prepare((vertices, place[mesh.faces]))
    assert len(checked.repairs) == 1
    assert_says(checked.repairs[0], "left out vertices that no face uses: 3")
    np.testing.assert_array_equal(checked.vertices, mesh.vertices)
    np.testing.assert_array_equal(checked.faces, mesh.faces)
    np.testing.assert_array_equal(checked.strays, strays)
    expected = np.full(len(vertices), -1)
    expected[place] = np.arange(40)
    np.testing.assert_array_equal(checked.vertex_of_input, expected)


def test_all_repairs_at_once():
    """A soup of two octahedra that touch, one inside out, with strays: every input vertex is accounted for."""
    vertices, faces = touching_octahedra()
    faces[8:] = faces[8:, ::-1]
    soup = np.concatenate([[[5.0, 5, 5]], vertices[faces].reshape(-1, 3), [[6.0, 6, 6]]])
    checked = checking.prepare((soup, 1 + np.arange(faces.size).reshape(-1, 3)))
    said = "; ".join(checked.repairs)
    assert_says(
        said, "welded 37", "no face uses: 2", "split 1 pinched vertex", "flipped component 1 (the one with vertex 25)"
    )
    assert len(checked.vertices) == 12 and len(checked.components) == 2
    assert_closed_and_oriented(checked.faces, 12)
    assert volume(checked.vertices, checked.faces) == pytest.approx(8 / 3)  # an octahedron holds 4/3
    is_used = checked.vertex_of_input >= 0
    np.testing.assert_array_equal(checked.vertices[checked.vertex_of_input[is_used]], soup[is_used])
    np.testing.assert_array_equal(checked.strays, soup[~is_used])
    np.testing.assert_array_equal(np.flatnonzero(~is_used), [0, len(soup) - 1])


def test_components_are_told_apart():
    """Genus, vertices and faces of each part, in the caller's order, even when their vertices are interleaved."""
    parts = [blob(5, 2), torus().apply_translation([5, 0, 0]), trimesh.creation.box().apply_translation([9, 0, 0])]
    joined = trimesh.util.concatenate(parts)
    shuffle = np.random.default_rng(0).permutation(len(joined.vertices))
    vertices, faces = joined.vertices[shuffle], np.argsort(shuffle)[joined.faces]
    checked = checking.prepare((vertices, faces))
    assert checked.repairs == ()
    found = {
        (
            len(component.vertices),
            len(component.faces),
            component.genus,
            round(volume(component.vertices, component.faces), 9),
        )
        for component in checked.components
    }
    genus = (0, 1, 0)
    expected = {(len(p.vertices), len(p.faces), g, round(p.volume, 9)) for p, g in zip(parts, genus, strict=True)}
    assert found == expected
    for component, member in zip(checked.components, checked.members, strict=True):
        np.testing.assert_array_equal(component.vertices, vertices[member])
    np.testing.assert_array_equal(np.sort(np.concatenate(checked.members)), np.arange(len(vertices)))


# The research meshes


@pytest.mark.parametrize("name", ["cow-pinched", "camel-pinched"])
def test_pinched_research_meshes_are_repaired(research_mesh, name):
    vertices, faces = research_mesh(name)
    checked = checking.prepare((vertices, faces))
    assert any("pinched" in repair for repair in checked.repairs)
    assert len(checked.vertices) > len(vertices)
    assert len(checked.vertices) - len(checked.faces) // 2 == sum(2 - 2 * part.genus for part in checked.components)
    assert_closed_and_oriented(checked.faces, len(checked.vertices))


@pytest.mark.parametrize(("name", "genus"), [("three-holes", 3), ("homer", 0), ("indorelax", 2), ("bunny", 0)])
def test_sound_research_meshes_pass_with_their_genus(research_mesh, name, genus):
    checked = checking.prepare(research_mesh(name))
    assert checked.repairs == ()
    assert [component.genus for component in checked.components] == [genus]


def test_a_cavity_is_named_as_one():
    outer, inner = trimesh.creation.icosphere(2), trimesh.creation.icosphere(2, radius=0.5)
    inner.invert()
    (repair,) = checking.prepare(trimesh.util.concatenate([outer, inner])).repairs
    assert "component 1" in repair and "cavity" in repair
    (repair,) = checking.prepare(trimesh.util.concatenate([outer, inner.apply_translation([5, 0, 0])])).repairs
    assert "inside out" in repair
