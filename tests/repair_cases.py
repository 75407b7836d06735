"""A ball to break, and what must hold of it after repair."""

import numpy as np
import trimesh

from msf_jax.meshes import checking

BALL = trimesh.creation.icosphere(3)


VERTICES, FACES = np.array(BALL.vertices), np.array(BALL.faces)


def volumes(found: checking.Surface) -> list[float]:
    """Volume of each component, by the divergence theorem as trimesh has it."""
    return [trimesh.Trimesh(part.vertices, part.faces, process=False).volume for part in found.components]


def assert_sound(found: checking.Surface, num_given: int) -> None:
    """Closed, oriented and manifold by trimesh's account; and each vertex is one of the caller's."""
    mesh = trimesh.Trimesh(found.vertices, found.faces, process=False)
    assert mesh.is_watertight and mesh.is_winding_consistent and min(volumes(found)) > 0
    euler = sum(2 - 2 * part.genus for part in found.components)
    assert len(found.vertices) - len(found.faces) // 2 == euler
    assert len(found.vertex_of_input) == num_given
    assert found.vertex_of_input.max() < len(found.vertices) and found.input_of_vertex.max() < num_given
    np.testing.assert_array_equal(found.given[0][found.input_of_vertex], found.vertices)
