"""Objectives on curves and surfaces where their values are known."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest
import trimesh

import msf_jax
from msf_jax import Config, ConfigError, objectives
from msf_jax.tuning.objectives import Objective, Placed

pytestmark = pytest.mark.usefixtures("few_rows")
SPOTS = np.array([[0.0, 0.5, 0.0], [1.0, 0.0, 0.3]])


def replayed(nodes, radii, edges=(), surface=None, node_of_vertex=None) -> Placed:
    """A curve in a surface of equal areas, or in two points, with a diagonal of 2."""
    surface = np.array([[0.0, 0, 0], [1.0, 0, 0]]) if surface is None else surface
    node_of_vertex = np.zeros(len(surface), dtype=int) if node_of_vertex is None else node_of_vertex
    return Placed(
        nodes=jnp.asarray(nodes, float),
        radii=jnp.asarray(radii, float),
        edges=jnp.asarray(np.reshape(edges, (-1, 2)).astype(int)),
        surface=jnp.asarray(surface, float),
        areas=jnp.asarray(np.full(len(surface), 1 / len(surface))),
        node_of_vertex=jnp.asarray(node_of_vertex),
        diagonal=jnp.asarray(2.0),
    )


def compiled(objective):
    return jax.jit(lambda curve: objective(curve))


def sphere() -> np.ndarray:
    return np.array(trimesh.creation.icosphere(3).vertices)


def test_explained():
    """A ball that is the surface explains it; of half its radius, it leaves a quarter of the diagonal."""
    value = compiled(objectives.explained())
    for radius, expected in ((1.0, 0.0), (0.5, 0.25), (2.0, 0.0)):
        curve = replayed([[0, 0, 0]], [radius], surface=sphere())
        assert value(curve) == pytest.approx(expected, abs=1e-12)
    two = replayed([[0, 0, 0], [9, 0, 0]], [0.5, 8.5], surface=[[1, 0, 0], [0, 1, 0]])
    assert value(two) == pytest.approx(0.25 / 2)  # the second ball reaches the first point, past it
    large = np.tile(sphere(), (10, 1))  # of which samples are taken
    assert value(replayed([[0, 0, 0]], [0.5], surface=large)) == pytest.approx(0.25)


def test_centred():
    """0 on a ring's axis, offset over mean distance beside it; a neighbour's surface counts, too."""
    angle = np.arange(64) * 2 * np.pi / 64
    ring = np.stack([np.cos(angle), np.sin(angle), np.zeros(64)], axis=1)
    value = compiled(objectives.centred())
    assert value(replayed([[0, 0, 0]], [1], surface=ring)) == pytest.approx(0.0, abs=1e-9)
    off = np.array([0.3, 0.0, 0.0])
    expected = 0.3 / np.linalg.norm(ring - off, axis=1).mean()
    assert value(replayed([off], [0.7], surface=ring)) == pytest.approx(expected, rel=1e-4)
    halves = (ring[:, 0] > 0).astype(int)
    pair = replayed([[0, 0, 0], [0, 0, 0]], [1, 1], [[0, 1]], ring, halves)
    assert value(pair) == pytest.approx(0.0, abs=1e-9)


def test_inside():
    curve = replayed(np.zeros((4, 3)), [0.5, -0.2, 0.1, -0.4])
    assert objectives.inside()(curve) == pytest.approx((0.1 + 0.2) / 4)
    assert objectives.inside(margin=0.1)(curve) == pytest.approx((0 + 0.2 + 0.05 + 0.3) / 4)


@pytest.mark.parametrize("degrees", [0, 30, 90, 179])
def test_smooth(degrees):
    """One turn among four nodes in a row, the other straight; a junction does not count."""
    turn = np.radians(degrees)
    bent = [[0, 0, 0], [1, 0, 0], [2, 0, 0], [2 + np.cos(turn), np.sin(turn), 0]]
    row = [[0, 1], [1, 2], [2, 3]]
    expected = (1 - np.cos(turn)) / 2
    value = compiled(objectives.smooth())
    assert value(replayed(bent, np.ones(4), row)) == pytest.approx(expected, abs=1e-12)
    forked = replayed([*bent, [2, 5, 0]], np.ones(5), [*row, [2, 4]])
    assert value(forked) == pytest.approx(0.0, abs=1e-12)


def test_near():
    target = np.stack([np.linspace(0, 1, 11), np.zeros(11), np.zeros(11)], axis=1)
    value = compiled(objectives.near(target))
    assert value(replayed(target, np.ones(11))) == pytest.approx(0.0, abs=1e-12)
    assert value(replayed(target + [0, 0.5, 0], np.ones(11))) == pytest.approx(0.25)
    with pytest.raises(ConfigError, match=r"target has shape \(4,\)"):
        objectives.near(np.ones(4))


def test_gradients_are_finite_where_points_coincide():
    """Nodes on each other, on the surface, and on the target; and where nodes are no numbers, so is the value."""
    curve = replayed(np.zeros((3, 3)), np.zeros(3), [[0, 1], [1, 2]])
    total = objectives.explained() + objectives.centred() + objectives.inside() + objectives.smooth()
    total = total + objectives.near(np.zeros((2, 3)))
    value_and_slope = jax.jit(jax.value_and_grad(lambda nodes: total(curve._replace(nodes=nodes))))
    assert np.isfinite(value_and_slope(curve.nodes)[1]).all()
    assert np.isnan(value_and_slope(np.full((3, 3), np.nan))[0])


def test_sums_and_multiples():
    curve = replayed(np.zeros((2, 3)), [-1.0, 1.0])
    total = 2 * objectives.inside() + objectives.inside(1.0) * 3
    assert isinstance(total, Objective) and total.name == "2 * (inside) + 3 * (inside(1))"
    assert total(curve) == pytest.approx(2 * 0.25 + 3 * (1.5 + 0.5) / 2)
    own = objectives.inside() + (lambda nodes, radii: radii.sum())
    assert own(curve) == pytest.approx(0.25)
    with pytest.raises(ConfigError, match="objective is a float"):
        _ = objectives.inside() + 1.0  # pyright: ignore[reportOperatorIssue]
    with pytest.raises(TypeError):
        _ = objectives.inside() * objectives.inside()  # pyright: ignore[reportOperatorIssue]


@pytest.fixture(scope="module")
def run():
    """A curve, and its mesh."""
    mesh = trimesh.creation.icosphere(2)
    mesh.apply_scale([1.0, 0.4, 0.4])
    return msf_jax.skeletonize(mesh, config=Config(max_iterations=2)), mesh


def test_value_of_a_run(run):
    """A function of nodes and radii as it is, and an objective."""
    found = objectives.of_skeleton(lambda nodes, radii: nodes[:, 0].max() + radii.sum(), *run)
    assert found == pytest.approx(run[0].vertices[:, 0].max() + run[0].radii.sum(), abs=1e-8)
    assert 0 < objectives.of_skeleton(objectives.explained(), *run) < 0.1


@pytest.mark.parametrize(
    ("objective", "says"),
    [
        (3.0, "objective is a float, 3.0: expected one of msf_jax.objectives"),
        (lambda nodes, radii: nodes, r"returned float64 of shape \(\d+, 3\): expected one"),
        (lambda nodes, radii: len(nodes), "returned int.*: expected one floating-point number"),
        (lambda nodes: nodes.sum(), r"objective is a function.*: expected one of"),
        (lambda nodes, radii: None, "returned NoneType: expected a number"),
    ],
)
def test_wrong_objectives(run, objective, says):
    with pytest.raises(ConfigError, match=says):
        objectives.of_skeleton(objective, *run)
