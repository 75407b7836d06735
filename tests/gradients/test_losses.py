"""Losses of followed curves: known values, blind to padding, slopes of central differences, no unit."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from device_cases import strict

from msf_jax import ConfigError, Followed, losses
from msf_jax.base.binding import Binding, Sizes, padded

LINE = np.array([[0.0, 0, 0], [1.0, 0, 0], [2.0, 0, 0], [2.0, 1, 0], [2.0, -2, 0]])  # with two limbs at its end
EDGES = np.array([[0, 1], [1, 2], [2, 3], [2, 4]])
RADII = np.array([0.1, 0.3, 0.4, 0.2, -0.1])
DIAGONAL = 2.0
CAPACITY = Sizes(vertices=4, faces=2, nodes=8, edges=7, sections=2, corners=2, smoothing=2, turning=2)


def bound(diagonal=DIAGONAL, edges=EDGES) -> Binding:
    """What losses need of a binding of the line, with rows of padding."""
    nothing, num = np.zeros(0), int(edges.max()) + 1
    sizes = Sizes(vertices=1, faces=1, nodes=num, edges=len(edges), sections=0, corners=0, smoothing=0, turning=0)
    fields = dict.fromkeys(Binding._fields, nothing) | {"live": sizes, "faces": np.zeros((1, 3), int), "edges": edges}
    fields |= {"twin": np.zeros((1, 3), int), "rest": np.zeros((num, 3)), "side": np.ones(num), "centre": np.zeros(3)}
    fields |= {"branch": np.array([0, 0, 1, 2])[: len(edges)], "diagonal": np.float64(diagonal), "unit": np.float64(1)}
    return padded(Binding(**fields), CAPACITY)


def filled(nodes=LINE, radii=RADII, junk=0.0) -> Followed:
    """In rows of a binding; ``junk`` is what rows of padding hold."""
    rest = CAPACITY.nodes - len(nodes)
    return Followed(
        jnp.asarray(np.concatenate([nodes, np.full((rest, 3), junk)])),
        jnp.asarray(np.concatenate([radii, np.full(rest, junk)])),
    )


TARGET = LINE[[0, 2, 3]] + [0.1, 0.2, -0.3]
UNEVEN = np.random.default_rng(1).normal(0, 0.1, LINE.shape)
near, smoothness, clearance = map(jax.jit, (losses.near, losses.smoothness, losses.clearance))
ALL = {  # of a curve and its binding; ``size`` scales what is asked
    "near": lambda found, binding, size=1: near(found, binding, size * TARGET),
    "lengths": lambda found, binding, size=1: (losses.branch_lengths(found, binding)[:3] ** 2).sum() / size**2,
    "smoothness": lambda found, binding, size=1: smoothness(found, binding),
    "clearance": lambda found, binding, size=1: clearance(found, binding, size * 0.25),
}


def nearest(points, others):
    """Mean squared distance to the nearest of ``others``, in squared diagonals."""
    return (np.linalg.norm(np.asarray(points)[:, None] - others, axis=2).min(axis=1) ** 2).mean() / DIAGONAL**2


def test_near_is_the_mean_of_squares_in_both_directions(monkeypatch):
    """Beside all pairs of points, evenly spread by length; points that do not count are nowhere."""
    share = (np.arange(losses.SAMPLES) + 0.5) / losses.SAMPLES
    a, b = LINE[EDGES[:3, 0], None], LINE[EDGES[:3, 1], None]  # these edges have one length
    points = (a + share[:, None] * (b - a)).reshape(-1, 3)
    three = bound(edges=EDGES[:3])
    expected = (nearest(points, TARGET) + nearest(TARGET, points)) / 2
    assert near(filled(LINE[:4], RADII[:4]), three, TARGET) == pytest.approx(expected)
    far = np.concatenate([TARGET, [[9.0, 9, 9]]])
    assert near(filled(LINE[:4], RADII[:4]), three, far, np.arange(4) < 3) == pytest.approx(expected)
    value, slope = jax.jit(jax.value_and_grad(losses.near))(filled(), bound(), TARGET, np.zeros(3, bool))
    assert value == 0 and not any(np.asarray(part).any() for part in slope)
    # A short edge that is far off counts little.
    pair, found = bound(edges=EDGES[:2]), filled([[0, 0, 0], [3.0, 0, 0], [3.0, 1.0, 0]], [0, 0, 0])
    away = ((3 * share - 1.5) ** 2).mean(), (1.5**2 + share**2).mean()
    back = ((3 * share - 1.5) ** 2).min()
    there = (3 * away[0] + 1 * away[1]) / 4
    assert near(found, pair, np.array([[1.5, 0, 0.0]])) == pytest.approx((there + back) / 2 / DIAGONAL**2)


def test_near_knows_nodes_without_an_edge():
    """Of a lone node, the distance to the point at hand; beside an edge, points of the target find it, too."""
    target = np.array([[0.0, 3.0, 4.0]])
    lone = bound()._replace(live=bound().live._replace(nodes=1, edges=0))
    assert near(filled(), lone, target) == pytest.approx(25 / DIAGONAL**2)
    pair = bound(edges=EDGES[:1])
    pair = pair._replace(live=pair.live._replace(nodes=3))
    found = filled([[0, 0, 0], [0, 0, 0.0], [0, 3.0, 4.0]], [0, 0, 0])
    assert near(found, pair, target) == pytest.approx(0)  # the edge has no length
    at_edge = near(filled([[0, 0, 0], [1.0, 0, 0], [0, 3.0, 4.0]], [0, 0, 0]), pair, target)
    assert 25 / 2 < at_edge * DIAGONAL**2 < 26 / 2


def test_values_that_are_known():
    found, binding = filled(), bound()
    np.testing.assert_allclose(losses.branch_lengths(found, binding), [2, 1, 2, 0, 0, 0, 0])
    assert clearance(found, binding, 0.25) == pytest.approx((0.15**2 + 0.05**2 + 0.35**2) / 5 / DIAGONAL**2)
    assert clearance(found, binding, jnp.full(8, 0.25)) == pytest.approx(float(clearance(found, binding, 0.25)))
    assert clearance(found, binding, -1.0) == 0
    assert smoothness(found, binding) == pytest.approx(0, abs=1e-12)
    bent = LINE.copy()
    bent[0] = [1.0, 1.0, 0]  # the one node with two neighbours turns by a right angle
    assert smoothness(filled(bent), binding) == pytest.approx(1)


@pytest.mark.parametrize("name", ALL)
def test_a_loss_is_blind_to_padding_and_units_and_has_the_slopes_of_differences(name):
    """Also where points coincide, in JAX's strict modes, and in a batch."""
    loss = ALL[name]
    value_and_slope = jax.jit(jax.value_and_grad(lambda found: loss(found, bound())))
    at = LINE + UNEVEN
    values, slopes = zip(*(value_and_slope(filled(at, junk=junk)) for junk in (0.0, 3.0, -1e3)), strict=True)
    assert values[0] == values[1] == values[2] > 0
    for slope in slopes:
        assert all(np.isfinite(part).all() and not np.asarray(part)[len(LINE) :].any() for part in slope)
    assert max(np.abs(part).max() for part in slopes[0]) > 1e-3
    step, random = 1e-6, np.random.default_rng(2)
    for _ in range(3):
        along = filled(random.normal(size=LINE.shape), random.normal(size=RADII.shape))
        moved = [jax.tree.map(lambda p, w, s=s: p + s * step * w, filled(at), along) for s in (1, -1)]
        measured = (value_and_slope(moved[0])[0] - value_and_slope(moved[1])[0]) / (2 * step)
        expected = sum(float((s * w).sum()) for s, w in zip(slopes[0], along, strict=True))
        assert measured == pytest.approx(expected, rel=1e-6, abs=1e-9)
    larger = loss(filled(10 * at, 10 * RADII), bound(10 * DIAGONAL), size=10)
    assert larger == pytest.approx(float(values[0]))
    meeting = value_and_slope(filled(np.zeros_like(LINE), np.zeros_like(RADII)))[1]
    assert all(np.isfinite(part).all() for part in meeting)
    with strict():
        assert jax.eval_shape(jax.grad(lambda found: loss(found, bound())), filled()) is not None
    every, two = (
        jax.tree.map(lambda *parts: jnp.stack(parts), *pair) for pair in ((filled(), filled(at)), (bound(), bound(3.0)))
    )
    alone = [loss(filled(), bound()), loss(filled(at), bound(3.0))]
    np.testing.assert_allclose(jax.jit(jax.vmap(loss))(every, two), alone, rtol=1e-12, atol=1e-15)
    for found, binding in ((Followed(LINE, RADII), bound()), (every, two)):  # without padding, and without vmap
        with pytest.raises(ConfigError, match=r"expected \(8, 3\), .* jax.vmap"):
            loss(found, binding)


@pytest.mark.parametrize(
    ("misuse", "says"),
    [
        (lambda f, b: losses.clearance(f, b, jnp.full((8, 1), 0.4)), r"least has shape \(8, 1\).* number, or \(8,\)"),
        (lambda f, b: losses.clearance(f, b, b.node_mask), "least has the type bool: expected real numbers"),
        (lambda f, b: losses.clearance(f, b, b), "least is a Binding: expected an array of real"),
        (lambda f, b: losses.near(f, b, RADII), r"target has shape \(5,\): expected points \(P, 3\)"),
        (lambda f, b: losses.near(f, b, LINE, b.node_mask), r"mask has shape \(8,\).*: expected \(5,\) bool"),
        (lambda f, b: losses.near(f, b, LINE, RADII), "mask has shape .* type float64: expected .* bool"),
        (lambda f, b: losses.clearance(f, 0.4, b), r"binding a float: expected what .*, such as skeleton\.binding"),
        (lambda f, b: losses.smoothness(b, f), r"found is a Binding, and binding a Followed: expected what msf_jax"),
    ],
)
def test_misuse_is_told_what_to_do(misuse, says):
    with pytest.raises(ConfigError, match=says):
        misuse(filled(), bound())
