"""Branches that run beside each other in one limb become one."""

import itertools

import numpy as np

from msf_jax.curve import branches
from msf_jax.curve.branches import zip_strands
from msf_jax.topology.graphs import cycle_count, trace


def chain(*points, step=0.2):
    """Points about ``step`` apart along a polyline."""
    found = [np.array(points[:1], dtype=float)]
    for a, b in itertools.pairwise(points):
        num = round(np.linalg.norm(np.subtract(b, a)) / step)
        found.append(a + np.linspace(0, 1, num + 1)[1:, None] * np.subtract(b, a))
    return np.concatenate(found)


def joined(first, *chains):
    """A curve of chains that all begin at the point ``first``."""
    x, edges = [np.array([first], dtype=float)], []
    for each in chains:
        ids = [0, *range(sum(map(len, x)), sum(map(len, x)) + len(each) - 1)]
        x.append(each[1:])
        edges += itertools.pairwise(ids)
    return np.concatenate(x), np.array(edges)


def test_a_stem_does_not_run_out_along_its_lateral_and_back():
    """The junction is out on the lateral: both halves of the stem come to it along the lateral."""
    out = (0, 2, 0)
    x, edges = joined(
        out, chain(out, (0, 0.05, 0), (5, 0, 0)), chain(out, (0.02, 0, 0.02), (-5, 0, 0)), chain(out, (0, 5, 0))
    )
    stays, target, found = zip_strands(x, edges, np.full(len(x), 0.5), np.zeros(len(x), dtype=bool))
    assert cycle_count(int(stays.sum()), (np.cumsum(stays) - 1)[found]) == (1, 0)
    degree = np.bincount(found.ravel(), minlength=len(x))
    (junction,) = np.flatnonzero(degree == 3)
    assert np.linalg.norm(x[junction]) < 0.5 and (degree[stays] == 1).sum() == 3
    length = np.linalg.norm(x[found[:, 0]] - x[found[:, 1]], axis=1).sum()
    assert 14.5 < length < 15.5  # it was 19
    assert stays[target].all() and (np.linalg.norm(x[target] - x, axis=1) < 0.5).all()


def test_branches_that_part_at_once_stay():
    """`STRAND`: of a fork of 40 degrees, too, and those that a held node is on."""
    way = [(5 * np.cos(a), 5 * np.sin(a), 0) for a in np.radians([0, 40, 180])]
    x, edges = joined((0, 0, 0), *(chain((0, 0, 0), each) for each in way))
    stays, _, found = zip_strands(x, edges, np.full(len(x), 0.5), np.zeros(len(x), dtype=bool))
    assert stays.all() and len(trace(len(x), found)) == 3
    x, edges = joined(
        (0, 0, 0), chain((0, 0, 0), (5, 0, 0)), chain((0, 0, 0), (5, 0.1, 0)), chain((0, 0, 0), (-5, 0, 0))
    )
    held = np.ones(len(x), dtype=bool)
    assert zip_strands(x, edges, np.full(len(x), 0.5), held)[0].all()
    assert not zip_strands(x, edges, np.full(len(x), 0.5), ~held)[0].all()


def test_two_branches_are_compared_once(monkeypatch):
    """Of several places where strands become one, each is a round; branches that it does not change are known."""
    x, edges, asked = np.empty((0, 3)), [], []
    for number in range(4):
        at, up = (20.0 * number, 0, 0), (20.0 * number + 4, 0, 0)
        places, pairs = joined(at, chain(at, up), chain(at, (up[0], 0.1, 0)), chain(at, (at[0] - 4, 0, 0)))
        edges.append(pairs + len(x))
        x = np.concatenate([x, places])

    def counted(vertices, radii, one, other):
        asked.append((one.tobytes(), other.tobytes()))
        return beside(vertices, radii, one, other)

    beside = branches._beside
    monkeypatch.setattr(branches, "_beside", counted)
    stays, _, _ = zip_strands(x, np.concatenate(edges), np.full(len(x), 0.5), np.zeros(len(x), dtype=bool))
    assert not stays.all() and len(asked) == len(set(asked)) == 4 * 6


def test_a_loop_of_two_strands_in_one_limb_is_removed():
    """They meet again at a second junction: no edge leads from it to itself, and the other branches stay."""
    a, b = (0, 0, 0), (4, 0, 0)
    x, edges = joined(a, chain(a, (2, 0.1, 0), b), chain(a, (-3, 1, 0)), chain(a, (-3, -1, 0)))
    last = 20  # the node at b
    assert np.allclose(x[last], b)
    strand = np.insert(chain(a, (2, -0.1, 0), b)[1:-1], 19, (3.95, 0, 0), axis=0)  # its last node is nearest to b
    more = [strand, chain(b, (7, 1, 0))[1:], chain(b, (7, -1, 0))[1:]]
    for points, ends in zip(more, ((0, last), (last,), (last,)), strict=True):
        ids = [ends[0], *range(len(x), len(x) + len(points)), *ends[1:]]
        x, edges = np.concatenate([x, points]), np.concatenate([edges, list(itertools.pairwise(ids))])
    assert cycle_count(len(x), edges) == (1, 1)
    stays, _, found = zip_strands(x, edges, np.full(len(x), 0.5), np.zeros(len(x), dtype=bool))
    assert (found[:, 0] != found[:, 1]).all()
    assert cycle_count(int(stays.sum()), (np.cumsum(stays) - 1)[found]) == (1, 0)
    assert (np.bincount(found.ravel(), minlength=len(x))[stays] == 1).sum() == 4
