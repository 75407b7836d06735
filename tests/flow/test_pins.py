"""Vertices that a caller pins: they stay, and the curve goes through them."""

import numpy as np
import pytest
from conftest import torus

import msf_jax


def test_pins_hold_vertices_in_place_and_the_curve_goes_through_them():
    mesh = torus(minor=0.3)
    pins = [3, 100, 205]
    flow = msf_jax.contract(mesh, pins=pins)
    for skeleton in (flow.curve, flow.skeleton):
        for pin in pins:
            at_pin = np.flatnonzero((skeleton.vertices == mesh.vertices[pin]).all(axis=1))
            assert len(at_pin) == 1
            assert skeleton.mesh_map[pin] == at_pin[0]
    assert flow.skeleton.report.loops == flow.skeleton.report.cycles == 1
    assert flow.skeleton.report.components == 1
    assert flow.is_fixed.sum() >= 3


@pytest.mark.parametrize("pins", [[-1], [10_000], [0.5], [[1, 2]], ["a"]])
def test_a_pin_that_is_no_vertex_is_refused(pins):
    with pytest.raises(msf_jax.ConfigError, match="expected vertex numbers from 0 to 639"):
        msf_jax.skeletonize(torus(minor=0.3, around=40, across=16), pins=pins)


def test_a_pin_that_no_face_uses_is_refused():
    mesh = torus(minor=0.3, around=40, across=16)
    vertices = np.concatenate([mesh.vertices, [[5.0, 5, 5]]])
    with pytest.raises(msf_jax.ConfigError, match="vertex 640, which no face uses"):
        msf_jax.skeletonize((vertices, mesh.faces), pins=[640])
