"""Losses of followed curves: known values, blind to padding, slopes of central differences, no unit."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from device_cases import strict

import msf_jax
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
        jnp.concatenate([jnp.asarray(nodes), jnp.full((rest, 3), junk)]),
        jnp.concatenate([jnp.asarray(radii), jnp.full(rest, junk)]),
    )


TARGET = LINE[[0, 2, 3]] + [0.1, 0.2, -0.3]
WANTED = np.array([2.5, 1.0, 1.0, 0, 0, 0, 0])
JITTED = {name: jax.jit(getattr(losses, name)) for name in ("radii", "lengths", "smoothness", "clearance", "markers")}
near = jax.jit(losses.near, static_argnames="samples")
ALL = {
    "near": lambda found, binding: near(found, binding, TARGET),
    "radii": lambda found, binding: JITTED["radii"](found, binding, 0.25),
    "lengths": lambda found, binding: JITTED["lengths"](found, binding, WANTED),
    "smoothness": JITTED["smoothness"],
    "clearance": lambda found, binding: JITTED["clearance"](found, binding, 0.25),
    "markers": lambda found, binding: JITTED["markers"](found, binding, np.array([0, 3]), TARGET[1:]),
}
UNEVEN = np.random.default_rng(1).normal(0, 0.1, LINE.shape)


def test_near_is_the_mean_of_squares_both_directions():
    """One edge along x from 0 to 1, a sample in its middle: 0.5 beside a point, 1.5 beside another."""
    edge = bound(edges=np.array([[0, 1]]))
    found = filled([[0, 0, 0], [1.0, 0, 0]], [0, 0])
    target = np.array([[0.5, 0.5, 0], [0.5, 0, 1.5], [9, 9, 9]])
    there, back = 0.5**2, (0.5**2 + 1.5**2) / 2
    value = near(found, edge, target, np.array([True, True, False]), samples=1)
    assert value == pytest.approx((there + back) / 2 / DIAGONAL**2)
    assert near(filled(), bound(), LINE) < near(filled(), bound(), LINE + 0.5)
    along = LINE[EDGES[:, 0], None] + np.linspace(0, 1, 100)[:, None] * (LINE[EDGES[:, 1]] - LINE[EDGES[:, 0]])[:, None]
    assert near(filled(), bound(), along.reshape(-1, 3), samples=50) < 1e-4


def test_near_weighs_samples_by_the_length_that_they_stand_for():
    """A short edge that is far off counts little."""
    pair = bound(edges=np.array([[0, 1], [1, 2]]))
    found = filled([[0, 0, 0], [3.0, 0, 0], [3.0, 1.0, 0]], [0, 0, 0])
    target = np.array([[1.5, 0, 0.0]])
    there = (3 * 0 + 1 * (1.5**2 + 0.5**2)) / 4
    assert near(found, pair, target, samples=1) == pytest.approx(there / 2 / DIAGONAL**2)


def test_near_knows_nodes_without_an_edge():
    """Of a lone node, the distance to the point at hand; beside an edge, points of the target find it, too."""
    target = np.array([[0.0, 3.0, 4.0]])
    lone = bound()._replace(live=bound().live._replace(nodes=1, edges=0))
    assert near(filled(), lone, target) == pytest.approx(25 / DIAGONAL**2)
    pair = bound(edges=np.array([[0, 1]]))
    pair = pair._replace(live=pair.live._replace(nodes=3))
    found = filled([[0, 0, 0], [1.0, 0, 0], [0, 3.0, 4.0]], [0, 0, 0])
    assert near(found, pair, target, samples=1) == pytest.approx((25 + 0.25) / 2 / DIAGONAL**2)


def test_values_that_are_known():
    found, binding = filled(), bound()
    np.testing.assert_allclose(losses.branch_lengths(found, binding), [2, 1, 2, 0, 0, 0, 0])
    assert JITTED["lengths"](found, binding, WANTED) == pytest.approx((0.5**2 + 0 + 1) / 3 / DIAGONAL**2)
    assert JITTED["radii"](found, binding, RADII.mean()) == pytest.approx(RADII.var() / DIAGONAL**2)
    assert JITTED["clearance"](found, binding, 0.25) == pytest.approx((0.15**2 + 0.05**2 + 0.35**2) / 5 / DIAGONAL**2)
    assert JITTED["clearance"](found, binding, -1.0) == 0
    assert JITTED["smoothness"](found, binding) == pytest.approx(0, abs=1e-12)
    bent = LINE.copy()
    bent[0] = [1.0, 1.0, 0]  # the one node with two neighbours turns by a right angle
    assert JITTED["smoothness"](filled(bent), binding) == pytest.approx(1)
    ends, where = np.array([0, 3, 4]), LINE[[0, 3, 4]] + [[0, 0, 1.0], [0, 2.0, 0], [9, 9, 9]]
    value = JITTED["markers"](found, binding, ends, where, np.array([True, True, False]))
    assert value == pytest.approx((1 + 4) / 2 / DIAGONAL**2)
    assert JITTED["markers"](found, binding, ends, where, np.zeros(3, bool)) == 0


@pytest.mark.parametrize("name", ALL)
def test_padding_does_not_show(name):
    """Whatever is in it; nor is there a slope."""
    value_and_slope = jax.jit(jax.value_and_grad(lambda found: ALL[name](found, bound())))
    values, slopes = zip(
        *(value_and_slope(filled(LINE + UNEVEN, junk=junk)) for junk in (0.0, 3.0, -1e3)),
        strict=True,
    )
    assert values[0] == values[1] == values[2] > 0
    for slope in slopes:
        assert all(np.isfinite(part).all() and not np.asarray(part)[len(LINE) :].any() for part in slope)


@pytest.mark.parametrize("name", ALL)
def test_they_work_in_the_strict_modes_of_jax(name):
    with strict():
        assert jax.eval_shape(jax.grad(lambda found: ALL[name](found, bound())), filled()) is not None


@pytest.mark.parametrize("name", ALL)
def test_slopes_are_those_of_central_differences(name):
    value = jax.jit(lambda nodes, radii: ALL[name](filled(nodes, radii), bound()))
    at = LINE + UNEVEN, RADII
    slope = jax.jit(jax.grad(value, argnums=(0, 1)))(*at)
    step, random = 1e-6, np.random.default_rng(2)
    for _ in range(3):
        direction = [random.normal(size=part.shape) for part in at]
        ahead, behind = (value(*(p + sign * step * w for p, w in zip(at, direction, strict=True))) for sign in (1, -1))
        expected = sum(float((s * w).sum()) for s, w in zip(slope, direction, strict=True))
        assert (ahead - behind) / (2 * step) == pytest.approx(expected, rel=1e-6, abs=1e-9)
    assert max(np.abs(part).max() for part in slope) > 1e-3


@pytest.mark.parametrize("name", ALL)
def test_no_unit(name, monkeypatch):
    """A mesh that is ten times as large, and so all that is asked of it."""
    one = ALL[name](filled(LINE + UNEVEN), bound())
    monkeypatch.setitem(globals(), "TARGET", 10 * TARGET)
    larger = filled(10 * (LINE + UNEVEN), 10 * RADII), bound(10 * DIAGONAL)
    if name in ("radii", "clearance", "lengths"):
        ask = 10 * WANTED if name == "lengths" else 2.5
        assert JITTED[name](*larger, ask) == pytest.approx(float(one))
    else:
        assert ALL[name](*larger) == pytest.approx(float(one))


def test_where_points_coincide_slopes_are_finite():
    found = filled(np.zeros_like(LINE), np.zeros_like(RADII))
    for name, loss in ALL.items():
        slope = jax.jit(jax.grad(lambda found, loss=loss: loss(found, bound())))(found)
        assert all(np.isfinite(part).all() for part in slope), name


def test_a_curve_without_a_target_adds_nothing():
    """In a batch some may have none."""
    value, slope = jax.jit(jax.value_and_grad(near))(filled(), bound(), TARGET, np.zeros(3, bool))
    assert value == 0 and not any(np.asarray(part).any() for part in slope)


@pytest.mark.parametrize("name", ALL)
def test_rows_that_are_not_the_bindings_are_refused(name):
    """Of a curve that was followed without padding, and of a batch where `jax.vmap` was forgotten."""
    both = jax.tree.map(lambda part: jnp.stack([part, part]), (filled(), bound()))
    for found, binding in ((Followed(LINE, RADII), bound()), both):
        with pytest.raises(ConfigError, match=r"expected \(8, 3\), .* jax.vmap"):
            ALL[name](found, binding)


@pytest.mark.parametrize(
    ("misuse", "says"),
    [
        (
            lambda f, b: losses.radii(f, b, f.radii[:, None]),
            r"target has shape \(8, 1\) and type float64: expected a number, \(5,\) or \(8,\), one for each node, "
            "without or with padding",
        ),
        (lambda f, b: losses.clearance(f, b, jnp.full((8, 1), 0.4)), r"least has shape \(8, 1\) .* \(5,\) or \(8,\)"),
        (lambda f, b: losses.radii(f, b, RADII[:4]), r"target has shape \(4,\)"),
        (lambda f, b: losses.radii(f, b, b.node_mask), "target has shape .* and type bool: expected a number"),
        (lambda f, b: losses.radii(f, b, b), "target is a Binding: expected a number"),
        (
            lambda f, b: losses.lengths(f, b, 1.0),
            r"target has shape \(\).*: expected \(3,\) or \(7,\), one for each bra",
        ),
        (lambda f, b: losses.lengths(f, b, [1.0, 2.0]), r"target has shape \(2,\)"),
        (lambda f, b: losses.near(f, b, b.node_mask), r"target has shape .*: expected points \(P, 3\)"),
        (lambda f, b: losses.near(f, b, f), r"target is a Followed: expected points \(P, 3\)"),
        (lambda f, b: losses.near(f, b, LINE, b.node_mask), r"mask has shape \(8,\) .*: expected \(5,\) bool"),
        (lambda f, b: losses.near(f, b, LINE, RADII), "mask has shape .* type float64: expected .* bool"),
        (lambda f, b: losses.clearance(f, 0.4, b), r"binding a float: expected what .*, such as skeleton\.binding"),
        (lambda f, b: losses.markers(f, b, LINE, np.arange(5)), r"node has shape \(5, 3\) .*: expected ids \(M,\)"),
        (lambda f, b: losses.markers(f, b, RADII, LINE), "node has shape .* type float64: expected ids"),
        (lambda f, b: losses.markers(f, b, [0, 1], LINE[:1]), r"target has shape \(1, 3\) .*: expected \(2, 3\)"),
        (
            lambda f, b: losses.markers(f, b, [0, 1], LINE[:2], [True]),
            r"mask has shape \(1,\) .*: expected \(2,\) bool",
        ),
        (lambda f, b: losses.markers(f, b, jnp.array([5]), LINE[:1]), "node has 5: expected ids of nodes, from 0 to 4"),
        (lambda f, b: losses.markers(f, b, [0, -1], LINE[:2]), "node has -1: expected ids of nodes, from 0 to 4"),
    ],
)
def test_misuse_is_told_what_to_do(misuse, says):
    with pytest.raises(ConfigError, match=says):
        misuse(filled(), bound())


def test_more_than_the_rows_is_refused_of_a_traced_binding_too():
    with pytest.raises(ConfigError, match=r"target has shape \(9,\) .* \(n,\) or \(8,\)"):
        JITTED["radii"](filled(), bound(), np.ones(9))


@pytest.mark.parametrize("name", ["radii", "clearance", "lengths"])
def test_a_target_may_end_before_the_padding(name):
    """The same value and slopes, whether the binding is known or traced."""
    short = WANTED[:3] if name == "lengths" else RADII + [0.1, 0.2, -0.3, 0.3, 0.1]
    whole = WANTED if name == "lengths" else np.append(short, np.full(3, 9.0))
    run = jax.value_and_grad(lambda *given: getattr(losses, name)(*given), argnums=(0, 2))
    traced = jax.jit(run)
    known = jax.jit(lambda found, _, target: run(found, bound(), target))
    expected = traced(filled(), bound(), jnp.asarray(whole))
    assert expected[0] > 0
    for each in (known, traced):
        value, (slope, of_target) = each(filled(junk=7.0), bound(), jnp.asarray(short))
        assert value == pytest.approx(float(expected[0]), rel=1e-12)
        jax.tree.map(np.testing.assert_allclose, slope, expected[1][0])
        np.testing.assert_allclose(of_target, expected[1][1][: len(short)])


@pytest.mark.slow  # outside of a trace it is refused, above
def test_what_is_missing_in_a_trace_is_nan():
    """A target for too few nodes, and ids that are no nodes, unless the mask leaves them out: then slopes are sound."""
    for name in ("radii", "clearance"):
        assert np.isnan(JITTED[name](filled(), bound(), RADII[:4] + 1))
    at, run = LINE[:2] + 1, jax.jit(jax.value_and_grad(losses.markers, argnums=(0, 3)))
    for node in (-1, -8, 5, 8, 500):
        ids = np.array([0, node])
        assert np.isnan(run(filled(), bound(), ids, at)[0])
        value, slopes = run(filled(), bound(), ids, at, np.array([True, False]))
        assert value == pytest.approx(3 / DIAGONAL**2)
        assert all(np.isfinite(part).all() for part in jax.tree.leaves(slopes))
        assert losses.markers(filled(), bound(), ids, at, [True, False]) == pytest.approx(float(value))


def test_a_batch_of_them():
    """Each curve with its own target, as each alone."""
    targets = np.stack([TARGET, TARGET[::-1] - 0.4])
    every = jax.tree.map(lambda *parts: jnp.stack(parts), filled(), filled(LINE + UNEVEN))
    both = jax.tree.map(lambda *parts: jnp.stack(parts), bound(), bound(3.0))
    found = jax.jit(jax.vmap(near))(every, both, targets)
    alone = [near(filled(), bound(), targets[0]), near(filled(LINE + UNEVEN), bound(3.0), targets[1])]
    np.testing.assert_allclose(found, alone, rtol=1e-12)
    assert msf_jax.losses is losses


@pytest.mark.parametrize("count", [1, 31, 32, 100])
def test_near_in_blocks_is_that_of_all_pairs(count):
    """Value and slopes, to rounding."""
    random = np.random.default_rng(count)
    one, other, counts = random.normal(size=(count, 3)), random.normal(size=(57, 3)), random.random(57) < 0.5

    def pairs(one, other):
        return jnp.where(counts, ((one[:, None] - other) ** 2).sum(-1), jnp.inf).min(axis=1).sum()

    def blocks(one, other):
        return losses._to_nearest(one, other, counts).sum()

    both = [jax.tree.leaves(jax.jit(jax.value_and_grad(f, (0, 1)))(one, other)) for f in (blocks, pairs)]
    for found, expected in zip(*both, strict=True):
        np.testing.assert_allclose(found, expected, rtol=1e-14, atol=1e-14)
