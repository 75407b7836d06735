"""The implicit smoothing step against a dense solve, and a whole iteration against the same steps in NumPy."""

import jax.numpy as jnp
import numpy as np
import pytest
from device_cases import (
    TIGHT,
    Case,
    build,
    case_with_everything,
    dense_contract,
    dense_smooth,
    jitted_smooth,
    one_level,
    pebble,
    quick_jit,
    reference_laplacian,
    ring_areas,
)

from msf_jax.base.options import Config, FlowOptions, SolverOptions, Weights
from msf_jax.device.iteration import move
from msf_jax.device.laplacian import LARGEST_ENTRY


@pytest.fixture(scope="module")
def case() -> Case:
    return case_with_everything(1, layout=one_level(128, 8))


@pytest.fixture(scope="module")
def free_case() -> Case:
    return build(*pebble(2, 120), layout=one_level(128, 8))


def smoothed(case, strength, **options):
    return case.to_vertices(jitted_smooth(case.buffers, strength, case.layout, **options)[0])


def expected(case, strength, kind="mean_value"):
    return dense_smooth(reference_laplacian(kind, case.vertices, case.faces), case.vertices, case.is_fixed, strength)


@pytest.mark.parametrize("strength", [0.001, 0.1, 3.0])
def test_it_solves_the_implicit_step(case, strength):
    moved = smoothed(case, strength)
    np.testing.assert_allclose(moved, expected(case, strength), atol=1e-8)
    assert np.abs(moved - case.vertices).max() > 1e-5


def test_every_coordinate_stays_between_those_it_had(free_case):
    """Positive weights: nothing leaves the box of the surface, and a large step fills little of it."""
    start, moved = free_case.vertices, smoothed(free_case, 20.0)
    assert (moved.min(axis=0) > start.min(axis=0)).all()
    assert (moved.max(axis=0) < start.max(axis=0)).all()
    assert np.ptp(moved, axis=0).max() < 0.5 * np.ptp(start, axis=0).max()


# A whole iteration


def near_coincident(case):
    """``case`` with one edge a thousandth as long: its weights are beyond the limit."""
    a, b, _ = case.faces[7]
    vertices = case.vertices.copy()
    vertices[b] = vertices[a] + 1e-3 * (vertices[b] - vertices[a])
    return build(
        vertices, case.faces, is_fixed=case.is_fixed, poles=case.poles, has_pole=case.has_pole, layout=case.layout
    )


@pytest.mark.parametrize("follows_area", [pytest.param(False, marks=pytest.mark.slow), True])
def test_iteration_contracts_and_then_smooths_with_fresh_rows(case, follows_area):
    case = near_coincident(case)
    config = Config(
        solver=SolverOptions(tolerance=TIGHT, max_steps=20000),
        flow=FlowOptions(w_H_follows_area=follows_area, edit_connectivity=not follows_area),
    )
    w_L, w_H, w_M, strength = 0.8, 0.15, 0.3, 0.05
    first_area = ring_areas(*pebble(1))
    buffers = case.buffers._replace(area=jnp.asarray(case.to_rows(first_area, fill=1.0)))
    moved = quick_jit(move, static_argnames=("settings", "layout"))(
        buffers, Weights(w_L, w_H, w_M, strength), settings=config.on_device, layout=case.layout
    )

    L = reference_laplacian("mean_value", case.vertices, case.faces)
    assert L.max() > 2 * LARGEST_ENTRY
    L = reference_laplacian("mean_value", case.vertices, case.faces, LARGEST_ENTRY)
    w_H = w_H * np.sqrt(first_area / ring_areas(case.vertices, case.faces)) if follows_area else w_H
    middle = dense_contract(L, case.vertices, case.poles, case.is_fixed, w_L, w_H, w_M * case.has_pole)
    L = reference_laplacian("mean_value", middle, case.faces, LARGEST_ENTRY)
    end = dense_smooth(L, middle, case.is_fixed, strength)
    assert np.abs(end - middle).max() > 1e-3
    np.testing.assert_allclose(case.to_vertices(moved.positions), end, atol=1e-8)
    np.testing.assert_array_equal(case.to_vertices(moved.positions)[case.is_fixed], case.vertices[case.is_fixed])
    assert (np.asarray(moved.solves.residual) <= TIGHT).all()
