"""The classes of paths through a solid, against linking numbers known by hand, and what must not change them."""

from itertools import pairwise

import numpy as np
import pytest
import trimesh
from conftest import torus
from loop_cases import RING, circle, shape_of, theta, torus_knot, windings

from msf_jax.solid import handles as handles_module
from msf_jax.solid.handles import Handles, surface_loops


@pytest.mark.parametrize("across", [-3, -1, 1, 2, 5])
@pytest.mark.parametrize("along", [1, 2, 3])
def test_a_torus_knot_goes_around_as_often_as_it_goes_along(along, across):
    once = windings(RING, circle(1.0))
    knot = torus_knot(along, across)
    found = windings(RING, knot)
    np.testing.assert_array_equal(found, along * once)
    assert np.gcd.reduce(once) == 1


@pytest.mark.parametrize("scale", [1e-100, 1e-30, 1e30, 1e100])
def test_units_do_not_matter(scale):
    vertices, faces, points, edges = theta()
    plain, scaled = (Handles(factor * vertices, faces) for factor in (1.0, scale))
    ends = [points[edges[:, k]] for k in (0, 1)]
    np.testing.assert_array_equal(scaled.linking(*(scale * end for end in ends)), plain.linking(*ends))


@pytest.mark.parametrize("seed", range(6))
def test_classes_add_up_along_any_path(seed):
    """Of segments that are cut into pieces, through the solid or not; and there and back they cancel."""
    random, handles = np.random.default_rng(seed), RING.handles
    a, b = random.uniform(-1.5, 1.5, (2, 200, 3))
    stops = np.sort(np.concatenate([[0.0], random.uniform(size=5), [1.0]]))
    places = [(1 - stop) * a + stop * b for stop in stops]
    places[0], places[-1] = a, b
    pieces = sum(handles.classes(*piece) for piece in pairwise(places))
    np.testing.assert_array_equal(pieces, handles.classes(a, b))
    np.testing.assert_array_equal(handles.classes(b, a), -handles.classes(a, b))
    assert handles.classes(a, b).any() and not handles.classes(a, a).any()


def test_crossings_with_curtains_are_those_of_all_pairs():
    """Against every pair of a segment and an edge, also of segments beyond the solid."""
    vertices, faces, _, _ = theta()
    handles, random = Handles(vertices, faces), np.random.default_rng(3)
    middle, extent = vertices.mean(axis=0), np.ptp(vertices, axis=0).max()
    a, b = middle + extent * random.uniform(-1, 1, (2, 900, 3))
    outside = vertices + 1e-9 * extent * trimesh.Trimesh(vertices, faces, process=False).vertex_normals
    loops = [outside[loop] for loop in handles.surface.loops]
    expected = np.zeros((900, len(loops)), dtype=int)
    for number, line in enumerate(loops):
        p, p_end, q, q_end = (ends @ handles_module.TURN.T for ends in (a, b, line, np.roll(line, -1, axis=0)))
        # p + s (p_end - p) is above q + t (q_end - q): solved by Cramer's rule.
        (one, other), away = ((p_end - p)[:, None], (q_end - q)[None]), q[None] - p[:, None]
        area = one[..., 0] * other[..., 1] - one[..., 1] * other[..., 0]
        s = (away[..., 0] * other[..., 1] - away[..., 1] * other[..., 0]) / area
        t = (away[..., 0] * one[..., 1] - away[..., 1] * one[..., 0]) / area
        height = s * one[..., 2] - t * other[..., 2] - away[..., 2]
        is_crossed = (s > 0) & (s < 1) & (t > 0) & (t < 1) & (height > 0)
        expected[:, number] = (np.sign(area) * is_crossed).sum(axis=1)
    found = handles.linking(a, b)
    assert np.abs(expected).sum() > 100 and (np.array_equal(found, expected) or np.array_equal(found, -expected))
    path = random.integers(0, 20, 900)
    summed = [found[path == k].sum(axis=0) for k in range(20)]
    np.testing.assert_array_equal(handles.linking(a, b, path), summed)
    assert handles.linking(a[:0], b[:0]).shape == (0, 4) and handles.classes(a[:0], b[:0]).shape == (0,)


def test_classes_of_paths_inside_are_those_of_the_surface_beside_them():
    """A path over the surface, pushed in a little, has the class that the flow gives its edges, but for one sign."""
    vertices, faces, _, _ = theta()
    handles = Handles(vertices, faces)
    values, (edges, _, lines, _) = handles.half_edge_classes(), handles.surface
    normals = trimesh.Trimesh(vertices, faces, process=False).vertex_normals
    inner = vertices - 1e-4 * normals
    number = dict(zip(zip(edges.origin.tolist(), edges.target.tolist(), strict=True), values.tolist(), strict=True))
    ratio = set()
    for line in lines:
        onward = np.roll(line, -1)
        flow = sum(number[edge] for edge in zip(line, onward.tolist(), strict=True))
        ratio.add((flow, int(handles.classes(inner[line], inner[onward]).sum())))
    assert len(lines) == 4 and sum(flow != 0 for flow, _ in ratio) >= 2
    signs = {np.sign(flow) * np.sign(own) for flow, own in ratio if flow}
    assert len(signs) == 1 and all(flow == own * int(next(iter(signs))) for flow, own in ratio)


def test_a_path_that_touches_the_surface_at_a_vertex_of_a_loop_is_none():
    """A pinned node is there: a triangle from it into the solid goes around nothing."""
    mesh = torus(minor=0.3)
    handles, random = RING.handles, np.random.default_rng(1)
    on_loops = np.unique(np.concatenate(surface_loops(np.array(mesh.faces)).loops))
    at = mesh.vertices[on_loops]
    inward = at - 0.15 * mesh.vertex_normals[on_loops]
    a, b = (inward + random.uniform(-0.03, 0.03, inward.shape) for _ in range(2))
    around = handles.linking(at, a) + handles.linking(a, b) + handles.linking(b, at)
    assert not around.any()


@pytest.mark.parametrize("gap", [0, 3])
def test_a_surface_has_loops_only_if_a_component_has_handles(gap):
    """Its genus is counted first; ``gap`` vertices between the components are of no face."""
    ball, ring = (shape_of(mesh) for mesh in (trimesh.creation.icosphere(2), trimesh.creation.torus(1, 0.3)))
    for parts, genus in (([ball], 0), ([ring], 1), ([ball, ball], 0), ([ball, ring], 1), ([ring, ball, ring], 2)):
        faces, vertices = [], []
        for number, part in enumerate(parts):
            faces.append(part.faces + sum(map(len, vertices)))
            vertices.append(np.concatenate([part.vertices + [4.0 * number, 0, 0], np.zeros((gap, 3))]))
        found = Handles(np.concatenate(vertices), np.concatenate(faces))
        assert found.genus == genus == len(surface_loops(np.concatenate(faces)).loops) // 2
