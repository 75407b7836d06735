"""Classes by the lengths of loops, where the linking numbers are not at hand."""

import numpy as np
import pytest
from conftest import torus
from meso_cases import check_classes, loop_class

from msf_jax import shapes
from msf_jax.curve import extraction
from msf_jax.meso import short_loops
from msf_jax.meso.meso import Meso
from msf_jax.topology import graphs


@pytest.mark.parametrize("turn", [1, 5, 17])
def test_on_a_thin_surface_short_loops_are_those_that_vanish(turn):
    """Of a ring and of three rings in a row, thin as after a flow, in whatever order the vertices are."""
    mesh = torus(around=24, across=12)
    order = np.random.default_rng(turn).permutation(len(mesh.vertices))
    vertices = np.empty_like(mesh.vertices)
    vertices[order] = mesh.vertices
    meso = Meso.from_mesh(vertices / 10, order[mesh.faces])
    meso.classes = short_loops.short_classes(meso.positions, meso.rings)
    check_classes(meso)
    around, across = order[np.arange(24) * 12], order[np.arange(12)]
    assert loop_class(meso, across) == 0
    assert loop_class(meso, around) != 0


def test_a_chain_of_rings_keeps_its_cycles_by_lengths_alone():
    grid = np.stack(np.meshgrid(*(np.arange(-0.2, stop, 0.05) for stop in (3.2, 1.2, 0.3)), indexing="ij"), axis=-1)
    away = np.min([np.abs(np.hypot(grid[..., 0] - x, grid[..., 1] - 0.5) - 0.4) for x in (0.5, 1.5, 2.5)], axis=0)
    away = np.minimum(away, np.where((grid[..., 0] > 0.8) & (grid[..., 0] < 2.2), np.abs(grid[..., 1] - 0.1), 9))
    mesh = shapes.level_set(np.hypot(away, grid[..., 2]) - 0.09, np.array([-0.2, -0.2, -0.2]), 0.05)
    meso = Meso.from_mesh(np.array(mesh.vertices), np.array(mesh.faces))
    genus = 1 - (len(mesh.vertices) - len(mesh.faces) // 2) // 2
    classes = short_loops.short_classes(meso.positions, meso.rings)
    found = extraction.extract_curve(meso.positions, meso.rings, classes)
    assert graphs.cycle_count(len(found.nodes), found.edges) == (1, genus) and genus >= 3


def crossings_of(handles: int, num_sums: int, seed: int) -> np.ndarray:
    """How ``handles`` pairs of loops cross each other, after one was added to another so many times."""
    rng = np.random.default_rng(seed)
    sums = np.eye(2 * handles, dtype=np.int64)
    for _ in range(num_sums):
        one, other = rng.choice(2 * handles, 2, replace=False)
        sums[one] += rng.choice([-1, 1]) * sums[other]
    return sums @ np.kron(np.eye(handles, dtype=np.int64), [[0, 1], [-1, 0]]) @ sums.T


@pytest.mark.parametrize("seed", range(4))
def test_sums_of_loops_that_cross_often_stay_small_or_are_given_up(seed):
    length = np.random.default_rng(seed).uniform(1, 2, 16)
    crossings = crossings_of(8, 60, seed)
    apart = short_loops._apart(crossings, length)
    assert apart is not None and np.linalg.matrix_rank(apart) == 8 and not (apart @ crossings @ apart.T).any()
    assert short_loops._apart(crossings_of(20, 300, seed), np.tile(length, 3)[:40]) is None
