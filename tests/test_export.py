"""Files read back by hand or by another library, and never left by halves."""

import json
from itertools import pairwise

import networkx as nx
import numpy as np
import pytest
import trimesh

from msf_jax import ConfigError, Report, Skeleton, export


def skeleton_of(vertices, edges):
    vertices = np.array(vertices, dtype=float)
    report = Report(1, 1, 0, 0, 1.0, True, "no volume left", 3, 0, 4, 1e-5, 0, 30)
    radii = np.linspace(0.1, 0.2, len(vertices))
    return Skeleton(vertices, np.array(edges).reshape(-1, 2), radii, np.zeros(5, dtype=int), report)


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


def test_cg_holds_counts_vertices_and_edges(lollipop, tmp_path):
    lollipop.save(tmp_path / "a.cg")
    text = (tmp_path / "a.cg").read_text().splitlines()
    assert text[0] == "# D:3 NV:6 NE:5"
    assert np.array_equal(np.array([line.split()[1:] for line in text if line[0] == "v"], float), lollipop.vertices)
    assert np.array_equal(np.array([line.split()[1:] for line in text if line[0] == "e"], int) - 1, lollipop.edges)


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


def test_a_pure_loop_is_one_closed_branch():
    ring = skeleton_of(np.eye(3), [[0, 1], [1, 2], [0, 2]])
    (branch,) = ring.branches
    assert len(branch.nodes) == 4
    assert branch.nodes[0] == branch.nodes[-1]


def test_json_holds_everything(lollipop, tmp_path):
    lollipop.save(tmp_path / "a.json")
    content = json.loads((tmp_path / "a.json").read_text())
    assert content["vertices"] == lollipop.vertices.tolist()
    assert content["edges"] == lollipop.edges.tolist()
    assert content["mesh_map"] == lollipop.mesh_map.tolist()
    assert content["report"]["reason"] == "no volume left"


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
    with pytest.raises(ConfigError, match=r"no format for 'a\.xyz'.*\.swc"):
        lollipop.save(tmp_path / "a.xyz")
    assert list(tmp_path.iterdir()) == []


def test_a_failed_write_leaves_the_old_file(tmp_path, monkeypatch):
    target = tmp_path / "a.swc"
    target.write_text("old")

    def fail(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(export.os, "replace", fail)
    with pytest.raises(OSError, match="No space"):
        export.write_whole(target, "new")
    assert target.read_text() == "old"
    assert list(tmp_path.iterdir()) == [target]
