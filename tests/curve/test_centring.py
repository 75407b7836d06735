"""Nodes that go to the middle of the solid, and no further along the curve."""

import manifold3d
import numpy as np
import pytest
import trimesh
from curve_cases import bow, none_held, path, tube, turns_of, unit_shape

import msf_jax
from msf_jax.curve import centring
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import unit


@pytest.mark.slow  # plates with holes are in test_handle_loops
def test_centring_takes_no_edge_out_of_a_plate_with_holes(monkeypatch):
    """So that the finished curve, which must be inside, is not led back there over kinks."""
    plate = manifold3d.Manifold.cube([3, 2, 0.05], True)
    for x in (-1, 0, 1):
        plate -= manifold3d.Manifold.cylinder(1, 0.45, circular_segments=16, center=True).translate([x, 0, 0])
    found = plate.to_mesh()
    mesh = trimesh.Trimesh(found.vert_properties[:, :3].astype(float), found.tri_verts)
    seen = []

    def watched(shape, x, edges, *others, **options):
        y = centre(shape, x, edges, *others, **options)
        seen.append([shape.holds(z[edges[:, 0]], z[edges[:, 1]]).all() for z in (x, y)])
        return y

    centre = centring.centre
    monkeypatch.setattr(centring, "centre", watched)
    curve = msf_jax.skeletonize(mesh)
    assert np.array(seen).shape == (2, 2) and np.array(seen).all()
    assert curve.report.loops == curve.report.cycles == 3 and (turns_of(curve.vertices, curve.edges) > 45).sum() <= 2


def test_a_shifted_axis_goes_back_to_the_middle():
    line = np.stack([np.linspace(-1, 1, 41), np.zeros(41), np.zeros(41)], axis=1)
    shape, scale = unit_shape(tube(line, 0.2))
    wavy = scale * (line[4:-4] + np.array([0, 0.1, 0.05]) * np.cos(7 * line[4:-4, :1]))
    x = centring.centre(shape, *path(wavy), none_held(wavy))
    assert np.linalg.norm(x[:, 1:], axis=1).max() < 0.01 * 0.2 * scale
    held = np.arange(len(wavy)) == 10
    x = centring.centre(shape, *path(wavy), held)
    np.testing.assert_array_equal(x[10], wavy[10])
    assert np.linalg.norm(x[:, 1:], axis=1)[20:].max() < 0.02 * 0.2 * scale


def test_centring_comes_to_an_end():
    """A further round moves no node, and nodes stay where they were along the curve."""
    shape, scale = unit_shape(tube(bow(0.3)))
    curve, edges = path(scale * (bow(0.3)[4:-4] + 0.05 * np.cos(9 * bow(0.3)[4:-4, 1:2])))
    held = np.isin(np.arange(len(curve)), [0, len(curve) - 1])
    x = centring.centre(shape, curve, edges, held)
    again = centring.centre(shape, x, edges, held, rounds=1, is_far=False)
    assert np.linalg.norm(again - x, axis=1).max() < 1e-3 * 0.15 * scale
    assert np.linalg.norm(x - curve, axis=1).max() > 0.1 * 0.15 * scale
    share = [np.cumsum(np.linalg.norm(np.diff(y, axis=0), axis=1)) for y in (curve, x)]
    np.testing.assert_allclose(share[0] / share[0][-1], share[1] / share[1][-1], atol=2e-3)


def test_centring_turns_with_the_solid():
    line = bow(0.3)
    mesh = tube(line)
    turn = trimesh.transformations.random_rotation_matrix(np.array([0.1, 0.7, 0.4]))[:3, :3]
    shape, scale = unit_shape(mesh)
    turned = Enclosure(shape.vertices @ turn.T, shape.faces)
    wavy = scale * (line[5:-5] + 0.05 * np.sin(9 * line[5:-5, :1]))
    x = centring.centre(shape, *path(wavy), none_held(wavy))
    y = centring.centre(turned, *path(wavy @ turn.T), none_held(wavy))
    assert np.abs(y - x @ turn.T).max() < 1e-7


@pytest.mark.parametrize(("num", "held"), [(48, []), (200, []), (200, [100])])
def test_the_nodes_of_a_ring_do_not_go_round(num, held):
    """However unevenly they are spaced: a ring has no end that would hold them. Nor does it fold back on itself."""
    shape, scale = unit_shape(trimesh.creation.torus(1.0, 0.2, major_sections=64, minor_sections=24))
    angle = 2 * np.pi * np.linspace(0, 1, num, endpoint=False) ** 1.3
    nodes = scale * np.stack([1.05 * np.cos(angle), 1.05 * np.sin(angle), 0.03 * np.cos(5 * angle)], axis=1)
    edges = np.stack([np.arange(num), np.roll(np.arange(num), -1)], axis=1)
    x = centring.centre(shape, nodes, edges, np.isin(np.arange(num), held))
    ahead = unit(np.roll(x, -1, axis=0) - x)
    assert np.einsum("ni,ni->n", ahead, np.roll(ahead, 1, axis=0)).min() > (0.5 if held else 0.97)
    if not held:
        assert np.abs(np.linalg.norm(x[:, :2], axis=1) / scale - 1).max() < 0.01
        assert np.abs(x[:, 2]).max() < 0.01 * scale
        assert np.abs(np.angle((x[:, 0] + 1j * x[:, 1]) * np.exp(-1j * angle))).max() < 0.01
