"""Pictures: what is drawn is what was given, where it is."""

from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest
import trimesh
from mpl_toolkits.mplot3d import proj3d
from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection

from msf_jax import view
from msf_jax.base.errors import ConfigError
from msf_jax.view import Panel

BALL = trimesh.creation.icosphere(1)
LINE = SimpleNamespace(
    vertices=np.array([[0, 0, 0], [0, 0, 2], [0, 0, 3.0]]), edges=np.array([[0, 1], [1, 2]]), radii=np.ones(3)
)
DOT = SimpleNamespace(vertices=np.zeros((1, 3)), edges=np.empty((0, 2), int), radii=np.ones(1))


def test_all_pictures_are_in_the_same_box_and_show_what_they_were_given():
    figure = view.panels(
        [
            Panel("surface", BALL),
            Panel("opaque", BALL, is_solid=True),
            Panel("curve", BALL, {"a": LINE}),
            Panel("curves", None, {"a": LINE, "b": LINE}),
            Panel("points", points=np.eye(3)),
            Panel("a single node", curves={"c": DOT}),
        ],
        columns=4,
    )
    *axes, bar = cast(list[Any], figure.axes)
    assert [one.get_title() for one in axes] == ["surface", "opaque", "curve", "curves", "points", "a single node"]
    for one in axes:
        assert one.get_zlim() == pytest.approx((-1, 3))
        assert one.get_xlim() == pytest.approx((-1, 1))
    kinds = [[type(drawn) for drawn in one.collections] for one in axes]
    assert kinds[0] == kinds[1] == [Poly3DCollection]
    assert kinds[2] == [Poly3DCollection, Line3DCollection]
    assert kinds[3] == [Line3DCollection, Line3DCollection]
    assert [text.get_text() for text in axes[3].get_legend().get_texts()] == ["a", "b"]
    assert len(kinds[4]) == len(kinds[5]) == 1
    assert bar.get_ylabel() == "radius"
    opacity = [one.collections[0].get_facecolor()[0, 3] for one in axes[:2]]
    assert opacity[0] < 0.2 and opacity[1] == 1


def test_nothing_to_show_is_told():
    for shown, columns in (([], 4), ([Panel("empty")], 4), ([Panel(mesh=BALL)], 0)):
        with pytest.raises(ConfigError, match="expected"):
            view.panels(shown, columns=columns)


@pytest.mark.parametrize("stretch", [(1, 1, 1), (8, 1, 1), (1, 8, 1), (1, 1, 8), (1, 1, 0)])
def test_what_is_shown_fills_its_picture_and_is_not_cut_off(stretch):
    points = BALL.vertices * stretch
    axes = cast(Any, view.panels([Panel(points=points), Panel()]).axes[0])
    seen = np.stack(proj3d.proj_transform(*points.T, axes.get_proj())[:2], axis=1)
    assert 0.45 < np.abs(axes.transLimits.transform(seen) - 0.5).max() < 0.49


def test_angles_that_are_given_are_those_of_the_mesh_with_the_others_as_usual():
    for given, seen in (({"azimuth": 150}, (8, 150, 0)), ({"elevation": 40}, (40, -72, 0))):
        axes = cast(Any, view.panels([Panel("surface", BALL)], **given).axes[0])
        assert (axes.elev, axes.azim, axes.roll) == seen
