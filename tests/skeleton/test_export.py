"""Files read back by hand or by another library, and never left by halves."""

import json
import warnings
from itertools import pairwise

import networkx as nx
import numpy as np
import pytest
import trimesh

import msf_jax
from msf_jax import ConfigError, MeshError, Report, Skeleton, shapes
from msf_jax.base import writing
from msf_jax.topology import graphs


def skeleton_of(vertices, edges):
    vertices = np.array(vertices, dtype=float)
    edges = np.array(edges).reshape(-1, 2)
    components, cycles = graphs.cycle_count(len(vertices), edges)
    report = Report(components, 1, 0, cycles, 1.0, True, "no volume left", 3, 0, 4, 1e-5, 0, 30)
    radii = np.linspace(0.1, 0.2, len(vertices))
    return Skeleton(vertices, edges, radii, np.zeros(5, dtype=int), report)


@pytest.fixture
def lollipop():
    """A stick (0-1), a loop (1-2-3-4), and a lone node (5)."""
    return skeleton_of(
        [[0, 0, 0], [1, 0, 0], [2, 1, 0], [3, 0, 0], [2, -1, 1 / 3], [9, 9, 9]],
        [[0, 1], [1, 2], [2, 3], [3, 4], [1, 4]],
    )


def test_swc_is_a_tree_with_the_loop_listed(lollipop, tmp_path):
    lollipop.save(tmp_path / "a.swc")
    lines = (tmp_path / "a.swc").read_text().splitlines()
    rows = [line.split() for line in lines if not line.startswith("#")]
    cut = [tuple(map(int, line.split()[-2:])) for line in lines if line.startswith("# cut edge")]
    ids = [int(row[0]) for row in rows]
    parents = [int(row[6]) for row in rows]
    assert ids == list(range(1, 7))
    assert all(parent == -1 or parent < number for number, parent in zip(ids, parents, strict=True))
    graph = nx.Graph([(a, b) for a, b in zip(ids, parents, strict=True) if b != -1] + cut)
    graph.add_nodes_from(ids)
    positions = {int(row[0]): tuple(map(float, row[2:5])) for row in rows}
    radii = {int(row[0]): float(row[5]) for row in rows}
    found = {frozenset((positions[a], positions[b])) for a, b in graph.edges}
    vertices = [tuple(v) for v in lollipop.vertices.tolist()]
    assert found == {frozenset((vertices[a], vertices[b])) for a, b in lollipop.edges}
    assert {positions[n]: radii[n] for n in ids} == dict(zip(vertices, lollipop.radii.tolist(), strict=True))
    assert len(cut) == 1
    assert parents.count(-1) == 2


def test_obj_lines_are_read_by_trimesh(lollipop, tmp_path):
    lollipop.save(tmp_path / "a.obj")
    text = (tmp_path / "a.obj").read_text().splitlines()
    vertices = np.array([line.split()[1:] for line in text if line.startswith("v ")], dtype=float)
    lines = np.array([line.split()[1:] for line in text if line.startswith("l ")], dtype=int) - 1
    assert np.array_equal(vertices, lollipop.vertices)
    assert np.array_equal(lines, lollipop.edges)


def test_polylines_cover_every_edge_once(lollipop, tmp_path):
    lollipop.save(tmp_path / "a.polylines.txt")
    vertices = {tuple(v): k for k, v in enumerate(lollipop.vertices.tolist())}
    found = []
    for line in (tmp_path / "a.polylines.txt").read_text().splitlines():
        count, *numbers = line.split()
        points = np.array(numbers, dtype=float).reshape(-1, 3)
        assert len(points) == int(count)
        nodes = [vertices[tuple(point)] for point in points.tolist()]
        found += [tuple(sorted(pair)) for pair in pairwise(nodes)]
    assert sorted(found) == sorted(map(tuple, lollipop.edges.tolist()))


def test_networkx_carries_positions_radii_and_lengths(lollipop):
    graph = lollipop.to_networkx()
    assert graph.number_of_nodes() == 6
    assert sorted(map(sorted, graph.edges)) == sorted(lollipop.edges.tolist())
    assert graph.nodes[2]["position"] == (2.0, 1.0, 0.0)
    assert sum(data["length"] for _, _, data in graph.edges(data=True)) == pytest.approx(lollipop.length)


def test_path3d_has_the_same_length(lollipop):
    path = lollipop.to_path3d()
    assert isinstance(path, trimesh.path.Path3D)
    assert path.length == pytest.approx(lollipop.length)


def test_an_unknown_suffix_is_named(lollipop, tmp_path):
    with pytest.raises(ConfigError, match=r"no format for 'a\.inp'.*\.swc.*skeleton\.frame\(\)\.save"):
        lollipop.save(tmp_path / "a.inp")
    with pytest.raises(ConfigError, match=r"no format for 'a\.xyz'.*\.glb$"):
        lollipop.save(tmp_path / "a.xyz")
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

        neuron = navis.read_swc(str(saved(".swc")))
    skeleton, _ = hand
    table = neuron.nodes
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
    lines, at, num_edges = np.asarray(data.lines), 0, 0
    while at < len(lines):
        num_edges += lines[at] - 1
        at += lines[at] + 1
    assert num_edges == len(skeleton.edges)


def test_ply_holds_radii_and_edges(hand, saved):
    plyfile = pytest.importorskip("plyfile")
    skeleton, _ = hand
    data = plyfile.PlyData.read(saved(".ply"))
    np.testing.assert_array_equal(data["vertex"]["radius"], skeleton.radii)
    np.testing.assert_array_equal(data["vertex"]["x"], skeleton.vertices[:, 0])
    edges = np.stack([data["edge"]["vertex1"], data["edge"]["vertex2"]], axis=1)
    np.testing.assert_array_equal(edges, skeleton.edges)


def test_networkx_reads_graphml(hand, saved):
    skeleton, _ = hand
    graph = nx.read_graphml(saved(".graphml"), node_type=int)
    assert {tuple(sorted(edge)) for edge in graph.edges} == set(map(tuple, skeleton.edges.tolist()))
    assert [graph.nodes[node]["radius"] for node in range(len(skeleton.vertices))] == skeleton.radii.tolist()
    assert graph.nodes[3]["y"] == skeleton.vertices[3, 1]


def test_numpy_reads_npz(hand, saved):
    skeleton, _ = hand
    with np.load(saved(".npz")) as file:
        for name in ("vertices", "edges", "radii", "mesh_map"):
            np.testing.assert_array_equal(file[name], getattr(skeleton, name))
        assert json.loads(str(file["report"]))["cycles"] == 1


def test_a_glb_needs_its_mesh(hand, tmp_path):
    skeleton, mesh = hand
    with pytest.raises(ConfigError, match=r"expected save\(path, mesh\)"):
        skeleton.save(tmp_path / "hand.glb")
    with pytest.raises(MeshError, match="expected the same mesh"):
        skeleton.save(tmp_path / "hand.glb", (mesh.vertices[:-1], mesh.faces[:1]))


@pytest.mark.parametrize("suffix", [".obj", ".ply", ".graphml", ".json"])
def test_graphs_are_read_as_they_were_saved(lollipop, tmp_path, suffix):
    """With their nodes' numbers, a lone node and a loop; radii where the format has them."""
    lollipop.save(tmp_path / f"a{suffix}")
    found = msf_jax.read_curve(tmp_path / f"a{suffix}")
    np.testing.assert_array_equal(found.vertices, lollipop.vertices)
    if suffix != ".json":  # others come in ascending order
        np.testing.assert_array_equal(found.edges, np.unique(lollipop.edges, axis=0))
    has_radii = suffix != ".obj"
    np.testing.assert_array_equal(found.radii, lollipop.radii if has_radii else np.zeros(6))
    if suffix == ".json":
        np.testing.assert_array_equal(found.edges, lollipop.edges)
        np.testing.assert_array_equal(found.mesh_map, lollipop.mesh_map)
        assert found.report == lollipop.report


@pytest.mark.parametrize("suffix", [".swc", ".polylines.txt"])
def test_what_was_saved_is_read_again(hand, saved, suffix):
    skeleton, mesh = hand
    found = msf_jax.read_curve(saved(suffix))
    assert (len(found.vertices), len(found.edges)) == (len(skeleton.vertices), len(skeleton.edges))
    assert (found.report.cycles, found.report.components) == (1, 1)
    assert found.length == pytest.approx(skeleton.length)
    if suffix == ".swc":
        np.testing.assert_array_equal(np.sort(found.radii), np.sort(skeleton.radii))
    ours, theirs = (msf_jax.metrics.evaluate(mesh, curve) for curve in (skeleton, found))
    assert theirs == pytest.approx(ours, rel=1e-6, nan_ok=True)


@pytest.mark.parametrize(
    ("name", "content", "says"),
    [
        ("a.swc", "1 0 0 0 0 1", "line 1 of 'a.swc' is '1 0 0 0 0 1': expected id, type"),
        ("a.swc", "# only\n", "has 0 nodes"),
        ("a.swc", "1 0 0 0 0 1 7", "refers to a node 7 that it does not have"),
        ("a.swc", "1 0 nan 0 0 1 -1", "not all finite"),
        ("a.polylines.txt", "3 0 0 0 1 1 1", "line 1 of 'a.polylines.txt' is no polyline"),
        ("a.vtp", "<VTKFile/>", r"cannot read 'a.vtp': expected one of .npz, .json, .swc"),
        ("a.obj", "v 0 0 0\nl 1 2", "has edges to nodes that it does not have: expected ids below 1"),
        ("a.obj", "v 0 0\n", "line 1 of 'a.obj' is 'v 0 0': expected v and three numbers, or l"),
        ("a.ply", "ply\nformat binary_little_endian 1.0\n", "it is binary_little_endian: expected ascii"),
        ("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nend_header\n", "is no PLY of a curve"),
        ("a.graphml", "<graphml/>", "is no GraphML of a curve"),
        ("a.graphml", "<!DOCTYPE a>", "declares entities"),
        ("a.json", '{"format": "other", "version": 1}', "has no curve .*it is a 'other'"),
        ("a.json", "{", "has no curve"),
    ],
)
def test_a_curve_that_cannot_be_read_is_named(tmp_path, name, content, says):
    (tmp_path / name).write_text(content)
    with pytest.raises(ConfigError, match=says):
        msf_jax.read_curve(tmp_path / name)


ODD_SWC = {
    "byte-order mark": "\ufeff1 1 0 0 0 1 -1\n2 1 1 0 0 1 1\n".encode(),
    "another encoding": "# 5 µm, Müller\n1 1 0 0 0 1 -1\n2 1 1 0 0 1 1\n".encode("latin-1"),
    "a comment like ours": b"# cut edge effects were not corrected\n1 1 0 0 0 1 -1\n2 1 1 0 0 1 1\n",
    "whole numbers as decimals": b"1.0 1 0 0 0 1 -1.0\n2.0 1 1 0 0 1 1.0\n",
    "a comment without a space": b"1 1 0 0 0 1 -1#root\n2 1 1 0 0 1 1\n",
}
WRONG_SWC = {
    "infinite parent": b"1 1 0 0 0 1 -1\n2 1 1 0 0 1 inf\n",
    "broken parent": b"1 1 0 0 0 1 -1\n2 1 1 0 0 1 1.7\n",
    "an id twice": b"1 1 0 0 0 1 -1\n1 1 1 0 0 1 1\n",
    "its own parent": b"1 1 0 0 0 1 -1\n2 1 1 0 0 1 2\n",
}


@pytest.mark.parametrize("name", ODD_SWC)
def test_other_programs_swc_is_read(tmp_path, name):
    (tmp_path / "a.swc").write_bytes(ODD_SWC[name])
    found = msf_jax.read_curve(tmp_path / "a.swc")
    assert found.edges.tolist() == [[0, 1]] and found.vertices.tolist() == [[0, 0, 0], [1, 0, 0]]
    found.save(tmp_path / "a.json")
    json.loads((tmp_path / "a.json").read_text(), parse_constant=pytest.fail)  # no NaN: browsers do not read it


@pytest.mark.parametrize("name", WRONG_SWC)
def test_wrong_swc_is_an_error_that_names_the_line(tmp_path, name):
    (tmp_path / "a.swc").write_bytes(WRONG_SWC[name])
    with pytest.raises(ConfigError, match="line 2"):
        msf_jax.read_curve(tmp_path / "a.swc")


@pytest.mark.parametrize("suffix", [".swc", ".ply", ".graphml", ".json", ".npz"])
@pytest.mark.parametrize(("value", "says"), [(-5.0, "negative radius, -5"), (1e308, "choose another unit")])
def test_a_radius_that_is_none_is_refused_in_every_format(lollipop, tmp_path, suffix, value, says):
    lollipop.radii[3] = value
    lollipop.save(tmp_path / f"a{suffix}")
    with pytest.raises(ConfigError, match=says):
        msf_jax.read_curve(tmp_path / f"a{suffix}")


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("a.obj", f"v 0 0 0\nv 1 0 0\nl 1 {2**70}\n"),
        ("a.obj", "v 0 0 0\nv 1e308 0 0\nl 1 2\n"),
        ("a.swc", "1 1 0 0 0 1 -1\n2 1 -1e308 0 0 1 1\n"),
        ("a.polylines.txt", f"{2**70} 0 0 0 1 1 1\n"),
        ("a.ply", "ply\nformat ascii 1.0\nelement vertex 99999999999999999999\nproperty float x\nend_header\n"),
        ("a.json", "[" * 100_000),
    ],
)
def test_numbers_that_are_too_large_are_errors(tmp_path, name, content):
    (tmp_path / name).write_text(content)
    with pytest.raises(ConfigError, match=f"'{name}'"):
        msf_jax.read_curve(tmp_path / name)


@pytest.mark.parametrize("between", ["\u0085", "\u2028", "\u2029", "\x1c", "\x0b", "\x0c"])
@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "latin-1"])
def test_what_splits_lines_only_in_python_may_be_in_a_comment(tmp_path, between, encoding):
    text = f"# a{between}comment\n1 1 0 0 0 1 -1\r\n2 1 1 0 0 1 1\r3 1 2 0 0 1 2\n"
    (tmp_path / "a.swc").write_bytes(text.encode(encoding, "replace"))
    assert msf_jax.read_curve(tmp_path / "a.swc").edges.tolist() == [[0, 1], [1, 2]]
