"""`to_tree`: loops cut where they are thinnest, the root that was asked for, and SWC that begins with it."""

from dataclasses import replace

import numpy as np
import pytest
from conftest import torus

import msf_jax
from msf_jax import Config, ConfigError
from msf_jax.skeleton.skeleton import curve_of
from msf_jax.topology import graphs


def ring_with_a_tail() -> msf_jax.Skeleton:
    """Ten nodes in a ring, thinnest between 3 and 4, a tail from node 0, and an edge of its own."""
    angle = np.arange(10) * 2 * np.pi / 10
    ring = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    vertices = np.concatenate([ring, [[2, 0, 0], [3, 0, 0], [9, 0, 0], [9, 1, 0]]])
    edges = np.array([[k, (k + 1) % 10] for k in range(10)] + [[0, 10], [10, 11], [12, 13]])
    radii = np.array([0.5, 0.4, 0.3, 0.1, 0.1, 0.3, 0.3, 0.3, 0.4, 0.4, 0.6, 0.2, 0.1, 0.2])
    return curve_of(vertices, np.unique(np.sort(edges, axis=1), axis=0), radii)


def test_a_branch_to_an_opening_stays():
    """However short it is: the same rule as for pins, in every curve made from another."""
    curve = ring_with_a_tail()
    assert curve.prune(100).num_leaves == 2  # of the edge of its own
    kept = replace(curve, openings=(11, 12)).prune(100).resample(3.0).simplify(0.5)
    assert kept.num_leaves == 3
    np.testing.assert_array_equal(kept.vertices[list(kept.openings)], curve.vertices[[11, 12]])


def test_a_loop_is_cut_where_it_is_thinnest():
    tree = ring_with_a_tail().to_tree()
    lost = {(0, 1), (3, 4)} - set(map(tuple, tree.edges.tolist()))
    assert lost == {(3, 4)} and len(tree.edges) == 12
    assert tree.roots == (10, 13)
    assert (tree.report.cycles, tree.report.cut, tree.report.components) == (0, 1, 2)
    assert tree.report.notes[-1] == (
        "a tree: 1 loop cut where thinnest, at radii of 0.1 to 0.1; root at node 10, of radius 0.6"
    )
    assert graphs.cycle_count(len(tree.vertices), tree.edges) == (2, 0)


@pytest.mark.parametrize("root", [None, 7, 12])
def test_the_root_is_the_first_row(tmp_path, root):
    curve = ring_with_a_tail()
    tree = curve.to_tree(root)
    tree.save(tmp_path / "tree.swc")
    rows = [line.split() for line in (tmp_path / "tree.swc").read_text().splitlines() if line[0] != "#"]
    assert rows[0][6] == "-1"
    expected = curve.vertices[10 if root is None else root]
    np.testing.assert_allclose([float(word) for word in rows[0][2:5]], expected, atol=1e-12)
    assert [row[6] for row in rows].count("-1") == 2
    assert all(int(row[6]) < int(row[0]) for row in rows)


@pytest.mark.parametrize("root", [-1, 14, 1.5, True, "axon"])
def test_a_root_that_is_no_node_is_refused(root):
    with pytest.raises(ConfigError, match='expected a node from 0 to 13, "soma", or None for the thickest'):
        ring_with_a_tail().to_tree(root)


def test_a_tree_of_a_run_stays_sound_and_keeps_its_root():
    curve = msf_jax.skeletonize(torus(), config=Config(least_slenderness=0.0))
    tree = curve.to_tree()
    assert curve.report.cycles == tree.report.cut == 1 and tree.report.is_sound
    assert "0 cycles for genus 1, 1 more cut" in str(tree.report)
    np.testing.assert_array_equal(tree.mesh_map, curve.mesh_map)
    after = tree.resample(0.3)
    np.testing.assert_allclose(after.vertices[after.roots[0]], tree.vertices[tree.roots[0]], atol=0.3)
    assert not replace(tree.report, cut=0).is_sound
