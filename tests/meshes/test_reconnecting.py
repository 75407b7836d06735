"""Other diagonals in flat places: the same surface, in better triangles."""

import numpy as np
import pytest
import trimesh
from scipy.sparse import linalg

from msf_jax.limbs import ends
from msf_jax.meshes import reconnecting
from msf_jax.meshes.reconnecting import reconnected
from msf_jax.solid.geometry import triangle_areas


def codes(faces: np.ndarray) -> np.ndarray:
    """The half-edges of ``faces``, as numbers in order."""
    return np.sort(faces.ravel() * 10**6 + np.roll(faces, -1, axis=1).ravel())


def opposite(points: np.ndarray, faces: np.ndarray) -> dict[tuple[int, ...], float]:
    """The sum of the angles, in degrees, opposite to each edge between two triangles."""
    sums: dict[tuple[int, ...], list[float]] = {}
    for face, angles in zip(faces.tolist(), trimesh.triangles.angles(points[faces]), strict=True):
        for k in range(3):
            sums.setdefault(tuple(sorted((face[k], face[(k + 1) % 3]))), []).append(float(angles[(k + 2) % 3]))
    return {edge: float(np.degrees(sum(pair))) for edge, pair in sums.items() if len(pair) == 2}


def test_needles_on_a_plane_become_the_delaunay_triangulation():
    """The meshes of the net are parallelograms, 30 times as long as high, with corners that are not in lines."""
    rng = np.random.default_rng(3)
    i, j = np.meshgrid(np.arange(12), np.arange(12), indexing="ij")
    points = np.stack([i * 30.0 + 11 * j, j * 1.0, 0 * i], axis=-1).reshape(-1, 3) + rng.normal(0, 0.05, (144, 3))
    points[:, 2] = 0.0
    first = (12 * i + j)[:-1, :-1].ravel()
    faces = np.concatenate([first[:, None] + [0, 12, 13], first[:, None] + [0, 13, 1]])
    found = reconnected(points, faces)
    assert max(opposite(points, faces).values()) > 300 and max(opposite(points, found).values()) < 180.1
    assert triangle_areas(points[found]).sum() == pytest.approx(triangle_areas(points[faces]).sum(), rel=1e-12)
    normal = np.cross(points[found[:, 1]] - points[found[:, 0]], points[found[:, 2]] - points[found[:, 0]])
    assert (normal[:, 2] > 0).all() and len(np.unique(codes(found))) == 3 * len(found)


def sheared_tube(around: int, along: int, shear: int) -> tuple[np.ndarray, np.ndarray]:
    """A tube of length 2 and radius 0.1, whose triangles join vertices of neighbouring lines, ``shear`` rows apart."""
    angle, z = np.arange(around) * 2 * np.pi / around, np.linspace(-1, 1, along)
    lines = np.repeat(0.1 * np.stack([np.cos(angle), np.sin(angle)], axis=1), along, axis=0)
    faces = []
    for left in range(around):
        one, other, i, j = left * along, (left + 1) % around * along, 0, 0
        while i + j < 2 * (along - 1):
            if j < min(i + shear, along - 1) or i == along - 1:
                faces.append([one + i, other + j, other + j + 1])
                j += 1
            else:
                faces.append([one + i, other + j, one + i + 1])
                i += 1
    return np.column_stack([lines, np.tile(z, around)]), np.array(faces)


def test_a_solution_on_a_tube_of_needles_is_that_on_even_triangles():
    """-u'' = 1 along a tube of length 2 between two bases: 1/2 in the middle. On the needles it is less than half."""
    points, faces = sheared_tube(12, 41, 20)
    inner = np.flatnonzero(np.abs(points[:, 2]) < 1 - 1e-9)

    def solved(corners: np.ndarray) -> np.ndarray:
        matrix, share = ends.laplacian(points, corners)
        return linalg.spsolve(matrix[inner][:, inner].tocsc(), share[inner])

    assert solved(faces).max() < 0.25
    np.testing.assert_allclose(solved(reconnected(points, faces)), (1 - points[inner, 2] ** 2) / 2, atol=0.01)


def test_edges_stay_where_a_surface_is_bent():
    """`LEAST_BEND`: two long triangles that meet at 1 degree, though the angles opposite to their edge are obtuse. Nor
    does a ball get other edges, or a box, whose diagonals are as good as others."""
    for degrees, is_kept in ((0.0, False), (0.01, False), (0.2, True), (1.0, True), (90.0, True)):
        y, z = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
        points = np.array([[-9.0, 0, 0], [9, 0, 0], [0, 1, 0], [0, -y, z]])
        faces = np.array([[0, 1, 2], [1, 0, 3]])
        assert np.array_equal(codes(reconnected(points, faces)), codes(faces)) == is_kept, degrees
    for mesh in (trimesh.creation.icosphere(3), trimesh.creation.box((4, 1, 1))):
        np.testing.assert_array_equal(reconnected(np.array(mesh.vertices), mesh.faces), mesh.faces)
    # An angle of coordinates in single precision is no bend: `ROUNDED`.
    points = np.array([[-9.0, 0, 0], [9, 0, 0], [0, 1e-5, 0], [0, -1, 1e-4]])
    assert not np.array_equal(codes(reconnected(points, faces)), codes(faces))


def test_a_fold_and_an_edge_that_exists_stay():
    points = np.array([[-9.0, 0, 0], [9, 0, 0], [0, 1, 0], [0, 2, 0]])
    faces = np.array([[0, 1, 2], [1, 0, 3]])  # both above the edge
    np.testing.assert_array_equal(reconnected(points, faces), faces)
    points = np.array([[-9.0, 0, 0], [9, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 30]])
    faces = np.array([[0, 1, 2], [1, 0, 3], [2, 3, 4]])  # 2 and 3 are joined by another triangle
    np.testing.assert_array_equal(reconnected(points, faces), faces)


def test_a_sliver_in_a_line_gets_an_area():
    """A lid's edge has a vertex in its middle on one side only, and a triangle without area between."""
    points = np.array([[0.0, 0, 0], [1, 0, 0], [0.5, 1, 0], [0.5, 0, 0]])
    found = reconnected(points, np.array([[0, 1, 2], [1, 0, 3]]))
    np.testing.assert_allclose(triangle_areas(points[found]), 0.25)


def test_the_rounds_of_flips_are_bounded(monkeypatch):
    points, faces = sheared_tube(12, 41, 20)
    monkeypatch.setattr(reconnecting, "MOST_ROUNDS", 2)
    few = reconnected(points, faces)
    monkeypatch.setattr(reconnecting, "MOST_ROUNDS", 100)
    assert max(opposite(points, few).values()) > 200 > max(opposite(points, reconnected(points, faces)).values())
    assert triangle_areas(points[few]).sum() == pytest.approx(triangle_areas(points[faces]).sum(), rel=1e-9)
