"""The half-edges of a surface: each has its twin in the face next door."""

import numpy as np
import pytest
from solid_cases import SHAPES, arrays

from msf_jax.solid.enclosure import Enclosure
from msf_jax.topology.graphs import half_edges


@pytest.fixture(scope="module", params=SHAPES)
def shape(request) -> Enclosure:
    return Enclosure(*arrays(SHAPES[request.param]()))


def turned(faces: np.ndarray) -> np.ndarray:
    """The same faces in another order, each from another corner on."""
    random = np.random.default_rng(8)
    turn = (np.arange(3) + random.integers(3, size=(len(faces), 1))) % 3
    return np.take_along_axis(faces, turn, axis=1)[random.permutation(len(faces))]


@pytest.mark.parametrize("order", ["as built", "shuffled"])
def test_the_twin_of_an_edge_is_in_the_face_next_door(shape, order):
    faces = shape.faces if order == "as built" else turned(shape.faces)
    twins = half_edges(faces).twin
    tail, head = faces.ravel(), np.roll(faces, -1, axis=1).ravel()
    np.testing.assert_array_equal(np.sort(twins), np.arange(len(tail)))
    np.testing.assert_array_equal(tail[twins], head)  # it runs the other ray in the face next door
    np.testing.assert_array_equal(head[twins], tail)
    assert (twins // 3 != np.arange(len(tail)) // 3).all()
