"""Files read back by hand, by another library and by this project, and never left by halves."""

import json
import warnings
from itertools import pairwise

import numpy as np
import pytest
import trimesh

import msf_jax
from msf_jax import ConfigError, MeshError, Report, Skeleton, shapes
from msf_jax.base import writing
from msf_jax.topology import graphs


@pytest.fixture
def lollipop():
    """A stick (0-1), a loop (1-2-3-4), and a lone node (5)."""
    vertices = np.array([[0, 0, 0], [1, 0, 0], [2, 1, 0], [3, 0, 0], [2, -1, 1 / 3], [9, 9, 9]])
    edges = np.array([[0, 1], [1, 2], [2, 3], [3, 4], [1, 4]])
    components, cycles = graphs.cycle_count(len(vertices), edges)
    report = Report(components, 1, 0, cycles, 1.0, True, "no volume left", 3, 0, 4, 1e-5, 0, 30)
    return Skeleton(vertices, edges, np.linspace(0.1, 0.2, 6), np.zeros(5, dtype=int), report)


def test_swc_is_a_tree_with_the_loop_listed(lollipop, tmp_path):
    lollipop.save(tmp_path / "a.swc")
    lines = (tmp_path / "a.swc").read_text().splitlines()
    rows = [line.split() for line in lines if not line.startswith("#")]
    cut = [tuple(map(int, line.split()[-2:])) for line in lines if line.startswith("# cut edge")]
    parent_of = {int(row[0]): int(row[6]) for row in rows}
    assert list(parent_of) == list(range(1, 7)) and len(cut) == 1
    assert all(parent == -1 or parent < number for number, parent in parent_of.items())
    place = {int(row[0]): tuple(map(float, row[2:6])) for row in rows}
    found = {frozenset((place[a], place[b])) for a, b in [*parent_of.items(), *cut] if b != -1}
    nodes = [tuple(node) for node in np.column_stack([lollipop.vertices, lollipop.radii]).tolist()]
    assert set(place.values()) == set(nodes) and found == {frozenset((nodes[a], nodes[b])) for a, b in lollipop.edges}


def test_obj_and_polylines_by_hand(lollipop, tmp_path):
    lollipop.save(tmp_path / "a.obj")
    text = (tmp_path / "a.obj").read_text().splitlines()
    vertices = np.array([line.split()[1:] for line in text if line.startswith("v ")], dtype=float)
    lines = np.array([line.split()[1:] for line in text if line.startswith("l ")], dtype=int) - 1
    assert np.array_equal(vertices, lollipop.vertices) and np.array_equal(lines, lollipop.edges)
    lollipop.save(tmp_path / "a.polylines.txt")
    number = {tuple(v): k for k, v in enumerate(lollipop.vertices.tolist())}
    found = []
    for line in (tmp_path / "a.polylines.txt").read_text().splitlines():
        points = np.array(line.split()[1:], dtype=float).reshape(int(line.split()[0]), 3)
        found += [tuple(sorted(pair)) for pair in pairwise(number[tuple(point)] for point in points.tolist())]
    assert sorted(found) == sorted(map(tuple, lollipop.edges.tolist()))


def test_an_unknown_suffix_is_named(lollipop, tmp_path):
    with pytest.raises(ConfigError, match=r"no format for 'a\.inp'.*\.swc.*skeleton\.frame\(\)\.save"):
        lollipop.save(tmp_path / "a.inp")
    assert list(tmp_path.iterdir()) == []


def test_a_failed_write_leaves_the_old_file(tmp_path, monkeypatch):
    target = tmp_path / "a.swc"
    target.write_text("old")

    def fail(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(writing.os, "replace", fail)
    with pytest.raises(OSError, match="No space"):
        writing.write_whole(target, "new")
    assert target.read_text() == "old"
    assert list(tmp_path.iterdir()) == [target]


@pytest.fixture(scope="module")
def hand():
    """A real curve with a loop and five ends, and its mesh."""
    mesh = shapes.hand(0.1)
    return msf_jax.skeletonize(mesh), mesh


@pytest.fixture
def saved(hand, tmp_path):
    """A function from a suffix to the path of the hand's curve in that format."""

    def save(suffix):
        skeleton, mesh = hand
        path = tmp_path / f"hand{suffix}"
        skeleton.save(path, mesh)
        return path

    return save


@pytest.mark.slow  # this project's own reader is quick
def test_navis_reads_swc(hand, saved):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # navis announces what it has not
        import navis

        table = navis.read_swc(str(saved(".swc"))).nodes
    skeleton, _ = hand
    assert len(table) == len(skeleton.vertices)
    assert (table.parent_id >= 0).sum() == len(skeleton.edges) - skeleton.report.cycles
    np.testing.assert_allclose(np.sort(table.radius), np.sort(skeleton.radii), rtol=1e-6)


@pytest.mark.slow  # nor is VTK
def test_vtk_reads_polydata(hand, saved):
    pyvista = pytest.importorskip("pyvista")
    skeleton, _ = hand
    data = pyvista.read(saved(".vtp"))
    np.testing.assert_array_equal(data.points, skeleton.vertices)
    np.testing.assert_array_equal(data["radius"], skeleton.radii)
    num_nodes = len(data.lines) - data.n_lines
    assert num_nodes - data.n_lines == len(skeleton.edges)


def test_numpy_reads_npz(hand, saved):
    skeleton, _ = hand
    with np.load(saved(".npz")) as file:
        for name in ("vertices", "edges", "radii", "mesh_map"):
            np.testing.assert_array_equal(file[name], getattr(skeleton, name))


def test_json_has_no_nan_and_swc_its_root(hand, saved):
    """Browsers do not read NaN."""
    skeleton, _ = hand
    content = json.loads(saved(".json").read_text(), parse_constant=pytest.fail)
    np.testing.assert_array_equal(content["mesh_map"], skeleton.mesh_map)
    np.testing.assert_array_equal(msf_jax.read_curve(saved(".json")).radii, skeleton.radii)
    tree, path = skeleton.to_tree(5), saved(".swc")
    tree.save(path, label=3)
    found = msf_jax.read_curve(path)
    np.testing.assert_array_equal(found.vertices[list(found.roots)], tree.vertices[list(tree.roots)])
    for label in (-1, 2.5, True, "3"):
        with pytest.raises(ConfigError, match="expected a whole number"):
            tree.save(path, label=label)


def test_other_libraries_read_ply(hand, saved):
    plyfile = pytest.importorskip("plyfile")
    skeleton, _ = hand
    data = plyfile.PlyData.read(saved(".ply"))
    np.testing.assert_array_equal(data["vertex"]["radius"], skeleton.radii)
    edges = np.stack([data["edge"]["vertex1"], data["edge"]["vertex2"]], axis=1)
    np.testing.assert_array_equal(edges, skeleton.edges)


def test_a_glb_needs_its_mesh(hand, tmp_path):
    skeleton, mesh = hand
    with pytest.raises(ConfigError, match=r"expected save\(path, mesh\)"):
        skeleton.save(tmp_path / "hand.glb")
    with pytest.raises(MeshError, match="expected the same mesh"):
        skeleton.save(tmp_path / "hand.glb", (mesh.vertices[:-1], mesh.faces[:1]))


def test_a_mesh_without_normals_is_smooth_in_a_glb_also_across_seams(tmp_path):
    """A capsule whose faces share no vertices: normals are those of the whole."""
    mesh = trimesh.creation.capsule(3.0, 0.5, count=[12, 12])
    apart = trimesh.Trimesh(mesh.triangles.reshape(-1, 3), np.arange(3 * len(mesh.faces)).reshape(-1, 3), process=False)
    msf_jax.skeletonize(apart).save(tmp_path / "apart.glb", apart)
    (part,) = trimesh.load(tmp_path / "apart.glb", process=False).geometry.values()
    expected = mesh.vertex_normals[mesh.faces].reshape(-1, 3)
    np.testing.assert_allclose(part.vertex_normals[part.faces].reshape(-1, 3), expected, atol=1e-5)


def test_a_graph_is_read_as_it_was_saved(lollipop, tmp_path):
    """With its nodes' numbers, a lone node and a loop."""
    lollipop.save(tmp_path / "a.npz")
    found = msf_jax.read_curve(tmp_path / "a.npz")
    np.testing.assert_array_equal(found.vertices, lollipop.vertices)
    np.testing.assert_array_equal(found.radii, lollipop.radii)
    np.testing.assert_array_equal(found.mesh_map, lollipop.mesh_map)
    assert found.report == lollipop.report
    np.testing.assert_array_equal(found.edges, np.unique(lollipop.edges, axis=0))  # in ascending order


@pytest.mark.parametrize("suffix", [".swc", ".polylines.txt"])
def test_what_was_saved_is_read_again(hand, saved, suffix):
    skeleton, _ = hand
    found = msf_jax.read_curve(saved(suffix))
    assert (len(found.vertices), len(found.edges)) == (len(skeleton.vertices), len(skeleton.edges))
    assert (found.report.cycles, found.report.components) == (1, 1)
    if suffix == ".swc":
        np.testing.assert_array_equal(np.sort(found.radii), np.sort(skeleton.radii))
    np.testing.assert_array_equal(np.unique(found.vertices, axis=0), np.unique(skeleton.vertices, axis=0))
    assert found.length == pytest.approx(skeleton.length)


ROOT = "1 1 0 0 0 1 -1\n"


@pytest.mark.parametrize(
    ("name", "content", "says"),
    [
        ("a.swc", "1 0 0 0 0 1", "line 1 is '1 0 0 0 0 1'.*expected id, type"),
        ("a.swc", "# only\n", "has 0 nodes"),
        ("a.swc", "1 0 0 0 0 1 7", "edges to nodes that it does not have"),
        ("a.swc", "1 0 nan 0 0 1 -1", "not all finite"),
        ("a.swc", ROOT + "2 1 1 0 0 1 inf\n", "line 2"),
        ("a.swc", ROOT + "2 1 1 0 0 1 1.7\n", "line 2"),
        ("a.swc", ROOT + ROOT, "line 2"),
        ("a.swc", ROOT + "2 1 1 0 0 1 2\n", "line 2"),  # its own parent
        ("a.swc", ROOT + "2 1 1 0 0 1 3\n3 1 1 1 0 1 2\n", "their own ancestors"),
        ("a.json", "{", "has no curve"),
        ("a.json", "[" * 100_000, "has no curve"),
        ("a.swc", ROOT + "2 1 -1e308 0 0 1 1\n", "choose another unit"),
        ("a.polylines.txt", "3 0 0 0 1 1 1", "line 1 is"),
        ("a.polylines.txt", f"{2**70} 0 0 0 1 1 1\n", "line 1 is"),
        ("a.vtp", "<VTKFile/>", r"cannot read 'a.vtp': expected one of .npz, .swc, .json"),
        ("a.obj", "v 0 0 0\n", r"cannot read 'a.obj'"),
    ],
)
def test_a_curve_that_cannot_be_read_is_named(tmp_path, name, content, says):
    (tmp_path / name).write_text(content)
    with pytest.raises(ConfigError, match=f"'{name}'") as caught:
        msf_jax.read_curve(tmp_path / name)
    assert caught.match(says)


ODD_SWC = {
    "byte-order mark": "\ufeff1 1 0 0 0 1 -1\n2 1 1 0 0 1 1\n".encode(),
    "another encoding": "# 5 µm, Müller\n1 1 0 0 0 1 -1\n2 1 1 0 0 1 1\n".encode("latin-1"),
    "a comment like ours": b"# cut edge effects were not corrected\n1 1 0 0 0 1 -1\n2 1 1 0 0 1 1\n",
    "whole numbers as decimals": b"1.0 1 0 0 0 1 -1.0\n2.0 1 1 0 0 1 1.0\n",
    "a comment without a space": b"1 1 0 0 0 1 -1#root\n2 1 1 0 0 1 1\n",
    "lines of old systems": "# a\u2028comment\r1 1 0 0 0 1 -1\r\n2 1 1 0 0 1 1\r".encode(),
}


@pytest.mark.parametrize("name", ODD_SWC)
def test_other_programs_swc_is_read(tmp_path, name):
    (tmp_path / "a.swc").write_bytes(ODD_SWC[name])
    found = msf_jax.read_curve(tmp_path / "a.swc")
    assert found.edges.tolist() == [[0, 1]] and found.vertices.tolist() == [[0, 0, 0], [1, 0, 0]]


@pytest.mark.parametrize("suffix", [".swc", ".json", ".npz"])
@pytest.mark.parametrize(("value", "says"), [(-5.0, "negative radius, -5"), (1e308, "choose another unit")])
def test_a_radius_that_is_none_is_refused_in_every_format(lollipop, tmp_path, suffix, value, says):
    lollipop.radii[3] = value
    lollipop.save(tmp_path / f"a{suffix}")
    with pytest.raises(ConfigError, match=says):
        msf_jax.read_curve(tmp_path / f"a{suffix}")
