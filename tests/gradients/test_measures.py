"""Measures of followed curves: closed forms of a taper, a bent tube and a fork, and slopes beside differences."""

import functools

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from device_cases import central_difference
from run_cases import flow_of

import msf_jax
from msf_jax import ConfigError, Followed, measures
from tests.benchmarks import ground_truth

STEPS = (1e-4, 1e-5, 1e-6)
TURN = 1.2  # radians from end to end of a bent tube


@functools.cache
def tube():
    """A straight tube, its vertices turned and moved so that its curve is along z, and the ends of that."""
    skeleton, mesh = flow_of("straight_coarse").skeleton, ground_truth.make("straight_coarse").mesh
    ends = skeleton.vertices[np.array(skeleton.branches[0].nodes)[[0, -1]]]
    turn = np.linalg.svd((ends[1] - ends[0])[None])[2][[1, 2, 0]]
    turn *= np.sign(np.linalg.det(turn))
    place = (np.array(mesh.vertices) - ends.mean(axis=0)) @ turn.T
    return skeleton, place, np.linalg.norm(ends[1] - ends[0])


def rows_of(binding, points):
    return jnp.zeros((binding.capacity.vertices, 3)).at[: len(points)].set(points)


def bent(points, curvature):
    """To an arc of circle about y, without stretching the axis."""
    x, y, z = points.T
    angle, away = curvature * z, 1 / curvature - x
    return np.stack([1 / curvature - away * np.cos(angle), y, away * np.sin(angle)], axis=1)


def test_a_taper_has_the_integrals_of_its_sections():
    skeleton, place, length = tube()
    binding, slope = skeleton.binding, 1.0 / length  # half as wide at one end, three halves at the other
    plain = np.asarray(measures.areas(skeleton, place))
    wide = place * (1 + slope * place[:, 2:] * [1, 1, 0])
    nodes = np.asarray(msf_jax.follow(skeleton, wide).nodes)
    factor = 1 + slope * nodes[:, 2]
    np.testing.assert_allclose(measures.areas(skeleton, wide), plain * factor**2, rtol=0.01)  # at the ends, too
    found = msf_jax.follow(binding, rows_of(binding, wide))
    assert measures.lengths(found, binding)[0] == pytest.approx(length, rel=1e-3)
    rows = np.pad(factor, (0, len(binding.rest) - len(factor)), constant_values=1.0)
    a, b = 0.5, 1.5
    for power, exact in ((1, (a + b) / 2), (-4, (a**-3 - b**-3) / 3 / (b - a))):
        assert measures.means(found, binding, rows**power)[0] == pytest.approx(exact, rel=5e-3)
        assert measures.integrals(found, binding, rows**power)[0] == pytest.approx(length * exact, rel=5e-3)


def test_a_bent_tube_keeps_length_and_area_and_a_sheared_one_has_oblique_cuts():
    skeleton, place, length = tube()
    binding, curvature = skeleton.binding, TURN / length
    plain = np.asarray(measures.areas(skeleton, place))
    arc = bent(place, curvature)
    found = msf_jax.follow(binding, rows_of(binding, arc))
    assert measures.lengths(found, binding)[0] == pytest.approx(length, rel=5e-3)
    assert measures.chords(found, binding)[0] == pytest.approx(2 / curvature * np.sin(TURN / 2), rel=5e-3)
    np.testing.assert_allclose(measures.areas(skeleton, arc), plain, rtol=0.03)
    oblique = place + np.outer(place[:, 2], [0.75, 0, 0])  # the angle between curve and cuts has the cosine 0.8
    np.testing.assert_allclose(measures.areas(skeleton, oblique), 0.8 * plain, rtol=0.01)


def test_branches_of_a_fork_have_their_angles_in_a_batch_too():
    """Three straight limbs, as their ends say; of the second mesh of a batch."""
    skeleton = flow_of("y_coarse").skeleton
    batch = msf_jax.stack([tube()[0], skeleton])
    first = int(batch.live.edges[0])  # the row of its first branch
    found = msf_jax.follow(batch, batch.vertices)
    pairs = np.array([[0, 1], [1, 2], [2, 0]])
    angles = np.asarray(measures.angles(found, batch, *(first + pairs.T)))
    hub = np.bincount(skeleton.edges.ravel()).argmax()
    tips = [next(b.nodes[k] for k in (0, -1) if b.nodes[k] != hub) for b in skeleton.branches]
    way = skeleton.vertices[tips] - skeleton.vertices[hub]
    way /= np.linalg.norm(way, axis=1)[:, None]
    np.testing.assert_allclose(
        np.degrees(angles), np.degrees(np.arccos((way[pairs[:, 0]] * way[pairs[:, 1]]).sum(1))), atol=2
    )
    assert np.isnan(measures.angles(found, batch, np.array([0, first + 3]), first + np.array([0, 4]))).all()
    own = msf_jax.follow(skeleton.binding, skeleton.binding.vertices)
    alone = np.asarray(measures.lengths(own, skeleton.binding))
    np.testing.assert_allclose(alone[:3], [branch.length for branch in skeleton.branches], rtol=1e-9)
    lengths = batch.split(measures.lengths(found, batch), "edges")[1]
    np.testing.assert_allclose(lengths, alone[: len(lengths)], rtol=1e-12)


MEASURES = {
    "lengths": lambda found, b, v: measures.lengths(found, b),
    "chords": lambda found, b, v: measures.chords(found, b),
    "resistance": lambda found, b, v: measures.integrals(
        found, b, jnp.where(b.node_mask, (0.1 + found.radii) ** -4, 0)
    ),
    "area": lambda found, b, v: measures.means(found, b, measures.areas(b, v)),
    "angles": lambda found, b, v: measures.angles(found, b, jnp.array([0, 1, 2]), jnp.array([1, 2, 0])),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", MEASURES)
def test_slopes_are_those_of_differences(name):
    """At three steps, of the vertices of a fork; and the second derivative."""
    binding = flow_of("y_coarse").skeleton.binding

    @jax.jit
    def value(vertices):
        rows = MEASURES[name](msf_jax.follow(binding, vertices), binding, vertices)
        return (jnp.arange(1.0, 4) * rows[:3]).sum()

    at = binding.vertices + 0.05 * np.sin(2 * binding.vertices[:, [1, 2, 0]])
    along = np.random.default_rng(0).normal(size=at.shape) / np.sqrt(at.size)
    slope = jax.jit(jax.grad(value))
    expected = float((slope(at) * along).sum())
    measured = np.array([central_difference(value, at, along, step) for step in STEPS])
    assert abs(expected) > 1e-6 and np.abs(measured - expected).min() < 1e-5 * np.linalg.norm(slope(at))
    second = jax.jit(lambda v: jax.jvp(slope, (v,), (along,))[1])(at)
    measured = [(slope(at + step * along) - slope(at - step * along)) / 2 / step for step in STEPS]
    assert min(np.linalg.norm(each - second) for each in measured) < 1e-4 * np.linalg.norm(second)


def test_values_that_do_not_fit_are_refused():
    binding = tube()[0].binding
    found = msf_jax.follow(binding, binding.vertices)
    with pytest.raises(ConfigError, match=r"values has shape \(3,\): expected"):
        measures.means(found, binding, np.ones(3))
    with pytest.raises(ConfigError, match="found has nodes of shape"):
        measures.lengths(Followed(np.zeros((2, 3)), np.zeros(2)), binding)
