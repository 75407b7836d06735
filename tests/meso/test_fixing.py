"""Vertices that are fixed as no edge of theirs can collapse, counted the slow way."""

import numpy as np
import pytest
from conftest import torus
from meso_cases import case, is_tetrahedron, neighbours_of, typical_length

from msf_jax.meso import collapse, fixing
from msf_jax.meso.meso import Meso


def test_a_thread_is_fixed():
    """A tube of triangles around a ring: no edge across can go, so every vertex has two, and all become fixed."""
    mesh = torus(1.0, 0.01, 24, 3)
    meso = Meso.from_mesh(np.array(mesh.vertices), np.array(mesh.faces))
    across = 2 * 0.01 * np.sin(np.pi / 3)
    assert fixing.fix_degenerate_vertices(meso, 0.99 * across) == 0
    assert fixing.fix_degenerate_vertices(meso, 1.01 * across) == 72
    assert meso.is_fixed.all()
    assert fixing.fix_degenerate_vertices(meso, 1.01 * across) == 0


def test_one_short_edge_is_not_enough_to_be_fixed():
    """The same tube flattened: each ring of three has one short edge, and none of its vertices has two."""
    mesh = torus(1.0, 0.01, 24, 3)
    meso = Meso.from_mesh(mesh.vertices * [1, 1, 0.5], np.array(mesh.faces))
    assert fixing.fix_degenerate_vertices(meso, 0.01) == 0  # one edge of 0.00866 and two of 0.0156
    assert not meso.is_fixed.any()
    assert fixing.fix_degenerate_vertices(meso, 0.016) == 72


@pytest.mark.parametrize("name", ["torus", "blob", "three-holes"])
def test_fixing_follows_its_rule(research_mesh, name):
    """Fixed are just the vertices with two or more short edges that cannot collapse, counted the slow way."""
    meso = case(name, research_mesh, fixed=0.05)
    meso.positions = meso.positions * [1.0, 0.3, 0.05]
    collapse.collapse_short_edges(meso, 3 * typical_length(meso))
    meso = meso.compacted()
    t_f = 1.2 * typical_length(meso)
    around = neighbours_of(meso.faces())
    stuck = np.zeros(meso.num_rows, dtype=int)
    for a in around:
        for b in around[a]:
            is_short = np.linalg.norm(meso.positions[a] - meso.positions[b]) < t_f
            if is_short and (len(around[a] & around[b]) > 2 or is_tetrahedron(around, a)):
                stuck[a] += 1
    was_fixed = meso.is_fixed.copy()
    fresh = fixing.fix_degenerate_vertices(meso, t_f)
    np.testing.assert_array_equal(meso.is_fixed, was_fixed | (stuck >= 2))
    assert fresh == int(((stuck >= 2) & ~was_fixed).sum())
    assert (stuck == 1).any() or (stuck >= 2).any()


def test_the_saw_tooth():
    """It rises step by step and falls back once it would pass the top; t_f is a tenth of it."""
    seen = [fixing.threshold(k, 0.002, 0.0001, 0.016) for k in range(300)]
    assert seen[0] == 0.002
    assert max(seen) == pytest.approx(0.016, abs=1e-12)  # (0.016 - 0.002) / 0.0001 = 140 steps take it to the top
    assert [k for k in range(1, 300) if seen[k] < seen[k - 1]] == [141, 282]
    assert fixing.threshold(7, 0.002, 0.0, 0.016) == 0.002
    assert fixing.degenerate_length(0.016) == pytest.approx(0.0016)
