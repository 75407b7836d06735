"""Losses of followed curves: known values, blind to padding, slopes of central differences, no unit."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from device_cases import strict

from msf_jax import ConfigError, Followed, losses, measures
from msf_jax.base.binding import Binding, Sizes, capacity_for, joined, padded

LINE = np.array([[0.0, 0, 0], [1.0, 0, 0], [2.0, 0, 0], [2.0, 1, 0], [2.0, -2, 0]])  # with two limbs at its end
EDGES = np.array([[0, 1], [1, 2], [2, 3], [2, 4]])
RADII = np.array([0.1, 0.3, 0.4, 0.2, -0.1])
DIAGONAL = 2.0
CAPACITY = Sizes(vertices=4, faces=2, nodes=8, edges=7, sections=2, corners=2, smoothing=2, turning=2)


def bound(diagonal=DIAGONAL, edges=EDGES) -> Binding:
    """What losses need of a binding of the line, with rows of padding."""
    return padded(bare(diagonal, edges), CAPACITY)


def bare(diagonal=DIAGONAL, edges=EDGES) -> Binding:
    nothing, num = np.zeros(0), int(edges.max()) + 1
    sizes = Sizes(vertices=1, faces=1, nodes=num, edges=len(edges), sections=0, corners=0, smoothing=0, turning=0)
    sizes = Sizes(*map(np.asarray, sizes))
    fields = dict.fromkeys(Binding._fields, nothing) | {"live": sizes, "faces": np.zeros((1, 3), int), "edges": edges}
    fields |= {"twin": np.zeros((1, 3), int), "rest": np.zeros((num, 3)), "side": np.ones(num), "centre": np.zeros(3)}
    fields |= {"branch": np.array([0, 0, 1, 2])[: len(edges)], "diagonal": np.float64(diagonal), "unit": np.float64(1)}
    fields |= {"vertices": np.zeros((1, 3))}
    return Binding(**fields)


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
    "lengths": lambda found, binding, size=1: (measures.lengths(found, binding)[:3] ** 2).sum() / size**2,
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
    assert near(filled(LINE[:4], RADII[:4]), three, far, np.array([0, 0, 0, -1])) == pytest.approx(expected)
    assert jax.jit(lambda found: losses.near(found, three, TARGET))(filled(LINE[:4], RADII[:4])) == near(
        filled(LINE[:4], RADII[:4]), three, TARGET
    )
    value, slope = jax.jit(jax.value_and_grad(losses.near))(filled(), bound(), TARGET, np.full(3, -1))
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
    lone = bound()._replace(live=bound().live._replace(nodes=np.array(1), edges=np.array(0)))
    assert near(filled(), lone, target) == pytest.approx(25 / DIAGONAL**2)
    pair = bound(edges=EDGES[:1])
    pair = pair._replace(live=pair.live._replace(nodes=np.array(3)))
    found = filled([[0, 0, 0], [0, 0, 0.0], [0, 3.0, 4.0]], [0, 0, 0])
    assert near(found, pair, target) == pytest.approx(0)  # the edge has no length
    at_edge = near(filled([[0, 0, 0], [1.0, 0, 0], [0, 3.0, 4.0]], [0, 0, 0]), pair, target)
    assert 25 / 2 < at_edge * DIAGONAL**2 < 26 / 2


def test_values_that_are_known():
    found, binding = filled(), bound()
    assert clearance(found, binding, 0.25) == pytest.approx((0.15**2 + 0.05**2 + 0.35**2) / 5 / DIAGONAL**2)
    assert clearance(found, binding, jnp.full(8, 0.25)) == pytest.approx(float(clearance(found, binding, 0.25)))
    assert clearance(found, binding, -1.0) == 0
    assert smoothness(found, binding) == pytest.approx(0, abs=1e-12)
    bent = LINE.copy()
    bent[0] = [1.0, 1.0, 0]  # the one node with two neighbours turns by a right angle
    assert smoothness(filled(bent), binding) == pytest.approx(1)


@pytest.mark.parametrize(
    "name", [pytest.param(each, marks=pytest.mark.slow) if each == "near" else each for each in ALL]
)
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
    with pytest.raises(ConfigError, match=r"expected \(8, 3\), as msf_jax\.follow"):  # without padding
        loss(Followed(LINE, RADII), bound())


def test_of_several_meshes_each_has_its_own_loss():
    """As alone: other nodes, diagonals and numbers of target points, in any order, one mesh without any."""
    curves = [(LINE, RADII, 2.0), (LINE + UNEVEN, 2 * RADII, 3.0), (LINE - UNEVEN, RADII, 5.0)]
    targets = [TARGET, np.concatenate([2 * TARGET, np.random.default_rng(5).normal(size=(200, 3))]), TARGET[:0]]
    union = joined([bare(size) for *_, size in curves])
    union = padded(union, capacity_for(union.live))
    place, rest = np.concatenate([nodes for nodes, *_ in curves]), len(union.rest) - 15
    found = Followed(
        jnp.asarray(np.pad(place, ((0, rest), (0, 0)), constant_values=7.0)),
        jnp.asarray(np.pad(np.concatenate([radii for _, radii, _ in curves]), (0, rest), constant_values=-9.0)),
    )
    mixed = np.random.default_rng(3).permutation(203)
    target, mesh = np.concatenate(targets)[mixed[: len(mixed)]], np.repeat([0, 1], [3, 203])[mixed]
    target = np.concatenate([target, np.concatenate(targets)[203:]])
    mesh = np.r_[mesh, np.ones(3, int)]
    for name, together, alone in (
        ("near", near(found, union, target, mesh), lambda f, b, k: near(f, b, targets[k])),
        ("smoothness", smoothness(found, union), lambda f, b, k: smoothness(f, b)),
        ("clearance", clearance(found, union, 0.25), lambda f, b, k: clearance(f, b, 0.25)),
    ):
        expected = [
            alone(filled(n, r), bound(size), k) for k, (n, r, size) in enumerate(curves) if name != "near" or k < 2
        ]
        np.testing.assert_allclose(together[: len(expected)], expected, rtol=1e-12, atol=1e-15)
        assert together.shape == (3,) and (name != "near" or together[2] == 0)
    slope = jax.grad(lambda f: near(f, union, target, mesh).sum())(found)
    assert np.isfinite(slope.nodes).all() and not np.asarray(slope.nodes)[10:].any()
    vanished = Followed(found.nodes.at[6].set(jnp.nan), found.radii.at[6].set(jnp.nan))

    @jax.jit
    def values(found):  # of a binding that the program holds
        every = losses.near(found, union, target, mesh), losses.smoothness(found, union)
        every = jnp.stack([*every, losses.clearance(found, union, 0.25)])
        kept = jnp.where(jnp.isnan(every), 0, every)
        return kept.sum(), kept

    (_, others), slope = jax.value_and_grad(values, has_aux=True)(vanished)
    np.testing.assert_allclose(others, values(found)[1] * jnp.array([1, 0, 1]), rtol=1e-12)
    assert np.isfinite(slope.nodes).all() and not np.asarray(slope.nodes)[5:10].any()


@pytest.mark.parametrize(
    ("misuse", "says"),
    [
        (lambda f, b: losses.clearance(f, b, jnp.full((8, 1), 0.4)), r"least has shape \(8, 1\).* number, or \(8,\)"),
        (lambda f, b: losses.clearance(f, b, b.node_mask), "least has the type bool: expected real numbers"),
        (lambda f, b: losses.clearance(f, b, b), "least is a Binding: expected an array of real"),
        (lambda f, b: losses.near(f, b, RADII), r"target has shape \(5,\): expected points \(P, 3\)"),
        (lambda f, b: losses.near(f, b, LINE, np.zeros(8, int)), r"mesh has shape \(8,\).*: expected \(5,\) whole"),
        (lambda f, b: losses.near(f, b, LINE, RADII), "mesh has shape .* type float64: expected .* whole"),
        (lambda f, b: losses.near(f, padded(joined([bare()]), CAPACITY), LINE), "mesh is None, and .* has 1 meshes"),
        (lambda f, b: losses.clearance(f, 0.4, b), r"binding a float: expected what .*, such as skeleton\.binding"),
        (lambda f, b: losses.smoothness(b, f), r"found is a Binding, and binding a Followed: expected what msf_jax"),
    ],
)
def test_misuse_is_told_what_to_do(misuse, says):
    with pytest.raises(ConfigError, match=says):
        misuse(filled(), bound())
