"""Where pictures are seen from: what stands is not drawn from above, and nothing lies on its head."""

from typing import Any, cast

import numpy as np
import pytest
import trimesh
from mpl_toolkits.mplot3d import proj3d
from scipy.spatial.transform import Rotation

from msf_jax import shapes, view
from msf_jax.skeleton.pictures.camera import looking

FIGURE = (3.0, 0.6, 6.0)  # wide, deep, high, as a person is
ANIMAL = (0.8, 4.0, 3.0)


def box(extents) -> trimesh.Trimesh:
    return trimesh.creation.box(extents).subdivide().subdivide()


@pytest.mark.parametrize(
    ("extents", "axis", "up"),
    [
        (FIGURE, 1, (0, 0, 1)),  # z up
        ((3.0, 6.0, 0.6), 2, (0, 1, 0)),  # y up
        ((0.6, 3.0, 6.0), 0, (0, 0, 1)),  # facing along x
        ((0.6, 6.0, 3.0), 0, (0, 1, 0)),
        (ANIMAL, 0, (0, 0, 1)),
        ((0.8, 3.0, 4.0), 0, (0, 1, 0)),
        ((6.0, 3.0, 0.6), 2, (0, 1, 0)),  # on the table
        ((2, 2, 2), 1, (0, 0, 1)),  # no axis is the shortest
    ],
)
def test_a_thing_is_seen_along_its_shortest_axis_and_the_right_way_up(extents, axis, up):
    mesh = box(extents)
    seen = looking(mesh.vertices + [100, -50, 3], mesh.faces)
    assert np.abs(seen.towards[axis]) > 0.9
    assert seen.up @ up > 0.98
    assert seen.towards @ [0.5, -1, 0] > 0 if up[2] else seen.towards @ [0.5, 0, 1] > 0  # the front of such files


def test_what_lies_askew_is_seen_along_its_shortest_axis():
    for turn in Rotation.random(20, random_state=0):
        mesh = box(FIGURE)
        mesh.vertices = turn.apply(mesh.vertices)
        seen = looking(mesh.vertices, mesh.faces)
        assert abs(seen.towards @ turn.apply([0, 1, 0])) > 0.9
        assert seen.up @ seen.towards == pytest.approx(0, abs=1e-9)


def test_how_densely_a_surface_is_sampled_does_not_matter():
    coarse = box(FIGURE)
    fine = coarse.submesh([np.flatnonzero(coarse.triangles_center[:, 2] > 2.9)], append=True).subdivide().subdivide()
    both = trimesh.util.concatenate([coarse, fine, fine, fine])
    assert abs(looking(both.vertices, both.faces).towards[1]) > 0.92


def test_a_picture_shows_it_so():
    """What is up, and what is right, in the picture that matplotlib makes, whichever way the camera rolls."""
    for turn in Rotation.random(5, random_state=1):
        mesh = trimesh.Trimesh(turn.apply(shapes.hand(0.1).vertices), shapes.hand(0.1).faces, process=False)
        seen = looking(mesh.vertices, mesh.faces)
        axes = cast(Any, view.panels([view.Panel(mesh=mesh)]).axes[0])
        middle = mesh.vertices.mean(axis=0)
        points = middle + 0.1 * np.stack([0 * seen.up, seen.up, seen.right, seen.towards])
        x, y, depth = proj3d.proj_transform(*points.T, axes.get_proj())
        assert y[1] > y[0] and abs(x[1] - x[0]) < 0.05 * (y[1] - y[0])
        assert x[2] > x[0] and abs(y[2] - y[0]) < 0.05 * (x[2] - x[0])
        assert abs(x[3] - x[0]) + abs(y[3] - y[0]) < 0.2 * (x[2] - x[0]) and depth[3] != depth[0]


def test_nothing_much_to_see_has_a_camera_too():
    for points in (np.zeros((1, 3)), np.full((3, 3), 1e200), np.array([[0, 0, 0], [0, 0, 1.0]])):
        seen = looking(points)
        assert np.isfinite(seen.towards).all() and np.isfinite(seen.angles()).all()
        assert np.linalg.norm(seen.up) == pytest.approx(1)
