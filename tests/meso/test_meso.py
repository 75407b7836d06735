"""The surface while it is edited: compaction, and all edits in turn."""

import numpy as np
import pytest
from conftest import blob
from meso_cases import OBTUSE, case, manifold_euler, meso_of, turned, typical_length, watch_rounds

from msf_jax.meso import collapse, fixing, ring_tables, split


def test_compaction_renumbers_everything():
    mesh = blob(7)
    meso = meso_of(np.array(mesh.vertices), np.array(mesh.faces))
    collapse.collapse_short_edges(meso, 2 * typical_length(meso))
    small = meso.compacted()
    live = np.flatnonzero(meso.degree)
    assert small.num_rows == small.num_live == len(live) < meso.num_rows
    assert turned(live[small.faces()]) == turned(meso.faces())
    for name in ("positions", "poles", "has_pole", "is_fixed"):
        np.testing.assert_array_equal(getattr(small, name), getattr(meso, name)[live])
    np.testing.assert_array_equal(live[small.node_of_input], meso.node_of_input)
    assert small.volume() == pytest.approx(meso.volume(), rel=1e-12)
    ring_tables.check_closed_manifold(small.rings, 2)


@pytest.mark.parametrize("name", ["torus", "blob", pytest.param("bunny", marks=pytest.mark.slow)])
def test_a_few_iterations_of_all_edits(research_mesh, monkeypatch, name):
    """Squeeze, collapse, split, fix, again and again, as the flow does: closed and of the same genus throughout."""
    meso = case(name, research_mesh)
    euler = manifold_euler(meso.faces())
    seen = watch_rounds(monkeypatch)
    t_c = 0.6 * typical_length(meso)
    rounds = 0
    for _ in range(6):
        meso.positions = np.where(meso.is_fixed[:, None], meso.positions, meso.positions * [0.95, 0.7, 0.5])
        rounds += len(collapse.collapse_short_edges(meso, t_c, check=True))
        rounds += len(split.split_obtuse_edges(meso, OBTUSE, t_c / 10, 10**6, check=True)[0])
        fixing.fix_degenerate_vertices(meso, t_c / 10)
        meso = meso.compacted()
        t_c *= 1.3
    assert seen == [euler] * rounds and rounds > 10
    assert np.isfinite(meso.positions).all()
    assert set(meso.node_of_input.tolist()) <= set(range(meso.num_rows))
