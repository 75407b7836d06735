"""Voronoi poles and the spectral reconstruction that goes before them."""

import numpy as np
import pytest
import trimesh
from conftest import MESHES, blob, torus
from scipy import spatial
from scipy.spatial.transform import Rotation

from msf_jax.base.errors import ConfigError, FlowError
from msf_jax.inside import preprocessing, voronoi
from msf_jax.numerics import reconstruction
from msf_jax.solid.geometry import vertex_normals


def arrays(mesh: trimesh.Trimesh) -> tuple[np.ndarray, np.ndarray]:
    """Plain arrays of a Trimesh."""
    return np.array(mesh.vertices), np.array(mesh.faces)


def outward_normals(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Sum of the unit normals of the faces at each vertex times their angle there, one corner at a time."""
    normals = np.zeros_like(vertices)
    for face in faces:
        for k in range(3):
            corner, one, other = vertices[np.roll(face, -k)]
            one, other = one - corner, other - corner
            normal = np.cross(one, other)
            cosine = one @ other / np.linalg.norm(one) / np.linalg.norm(other)
            normals[face[k]] += np.arccos(np.clip(cosine, -1, 1)) * normal / np.linalg.norm(normal)
    return normals


SHAPES = {"blob": lambda: blob(11), "slab": lambda: jittered(torus(), [3.0, 1, 0.3]), "torus": torus}


def jittered(mesh: trimesh.Trimesh, scale) -> trimesh.Trimesh:
    """The mesh scaled, and shaken out of general symmetry."""
    noise = 1e-3 * np.random.default_rng(4).normal(size=mesh.vertices.shape)
    return trimesh.Trimesh((mesh.vertices + noise) * scale, mesh.faces, process=False)


# Poles


def test_circumcentres_are_equidistant_from_their_corners():
    vertices = np.random.default_rng(0).normal(size=(400, 3))
    diagram = spatial.Delaunay(vertices)
    centre = voronoi.circumcentres(diagram)
    distance = np.linalg.norm(vertices[diagram.simplices] - centre[:, None], axis=2)
    is_small = distance.mean(axis=1) < 10
    assert is_small.mean() > 0.9
    assert np.ptp(distance, axis=1)[is_small].max() < 1e-9


def test_the_circumcentres_of_a_box_are_its_centre():
    """Eight cospherical corners: flat tetrahedra among them have the same centre."""
    box = np.array(trimesh.creation.box((4, 6, 10)).vertices) + [3, 5, 8]
    centre = voronoi.circumcentres(spatial.Delaunay(box))
    np.testing.assert_allclose(centre, np.broadcast_to([3, 5, 8], centre.shape))


def test_vertex_normals_weigh_faces_by_their_angle():
    vertices, faces = arrays(blob(12, 2))
    np.testing.assert_allclose(vertex_normals(vertices, faces), outward_normals(vertices, faces), atol=1e-12)


@pytest.mark.parametrize("name", SHAPES)
def test_poles_keep_their_promises(name):
    """Behind the surface, in the bounding box, the centre of an empty ball through the vertex and its tetrahedron."""
    vertices, faces = arrays(SHAPES[name]())
    found = voronoi.voronoi_poles(vertices, faces)
    has = found.is_found
    diagonal = np.linalg.norm(np.ptp(vertices, axis=0))
    assert has.mean() > 0.9
    position, site = found.position[has], vertices[has]
    assert (np.einsum("ij,ij->i", outward_normals(vertices, faces)[has], position - site) < 0).all()
    assert (position >= vertices.min(axis=0)).all() and (position <= vertices.max(axis=0)).all()
    np.testing.assert_allclose(found.radius[has], np.linalg.norm(position - site, axis=1), rtol=1e-12)
    nearest = np.linalg.norm(position[:, None] - vertices[None], axis=2).min(axis=1)
    np.testing.assert_allclose(nearest, found.radius[has], rtol=0, atol=1e-6 * diagonal)
    corners = vertices[found.tetrahedron[has]]
    np.testing.assert_allclose(
        np.linalg.norm(corners - position[:, None], axis=2),
        np.tile(found.radius[has][:, None], 4),
        rtol=0,
        atol=1e-6 * diagonal,
    )
    assert (found.tetrahedron[has] == np.flatnonzero(has)[:, None]).any(axis=1).all()  # one corner is the vertex


@pytest.mark.parametrize("name", ["blob", "slab"])
def test_poles_equal_those_read_off_scipys_voronoi_diagram(name):
    """Of each cell's corners inside the box, the one with the most negative <n, w - v>; none where all are positive."""
    vertices, faces = arrays(jittered(SHAPES[name](), 1.0))
    diagram = spatial.Voronoi(vertices)
    normals = outward_normals(vertices, faces)
    corners = diagram.vertices
    is_in_box = ((corners >= vertices.min(axis=0)) & (corners <= vertices.max(axis=0))).all(axis=1)
    found = voronoi.voronoi_poles(vertices, faces)
    num_without = 0
    for site, region in enumerate(diagram.point_region):
        cell = [corner for corner in diagram.regions[region] if corner >= 0 and is_in_box[corner]]
        depth = (corners[cell] - vertices[site]) @ normals[site]
        if len(cell) == 0 or depth.min() >= 0:
            assert not found.is_found[site]
            num_without += 1
        else:
            np.testing.assert_allclose(found.position[site], corners[cell][depth.argmin()], rtol=0, atol=1e-6)
    assert num_without < len(vertices) // 4


def test_a_vertex_without_a_pole_is_its_own():
    """A sphere turned inside out: nothing of any cell lies behind the surface."""
    vertices, faces = arrays(trimesh.creation.icosphere(1))
    found = voronoi.voronoi_poles(vertices, faces[:, ::-1])
    assert not found.is_found.any()
    np.testing.assert_array_equal(found.position, vertices)
    assert (found.radius == 0).all() and (found.tetrahedron == -1).all()


def test_the_poles_of_a_sphere_are_its_centre():
    mesh = trimesh.creation.icosphere(3, radius=2.0)
    vertices, faces = arrays(mesh.apply_translation([5, -3, 1]))
    found = voronoi.voronoi_poles(vertices, faces)
    assert found.is_found.all()
    assert np.linalg.norm(found.position - [5, -3, 1], axis=1).max() < 1e-3
    np.testing.assert_allclose(found.radius, 2.0, atol=1e-3)


def test_poles_follow_when_the_shape_is_moved_turned_and_scaled():
    mesh = jittered(blob(13), 1.0)
    turn = trimesh.transformations.random_rotation_matrix(np.array([0.2, 0.5, 0.8]))[:3, :3]
    vertices, faces = arrays(mesh)
    # The bounding box does not turn with the shape, so only poles well inside both boxes are compared.
    here = voronoi.voronoi_poles(vertices, faces)
    there = voronoi.voronoi_poles(vertices @ turn.T * 3 + [1, 2, 3], faces)
    is_same = np.linalg.norm(here.position @ turn.T * 3 + [1, 2, 3] - there.position, axis=1) < 1e-7
    assert is_same.mean() > 0.99
    scaled = voronoi.voronoi_poles(vertices * 0.25 + [8, 0, 0], faces)
    np.testing.assert_allclose(scaled.position, here.position * 0.25 + [8, 0, 0], atol=1e-9)


def test_vertices_that_span_no_volume_have_no_diagram():
    vertices, faces = arrays(trimesh.creation.icosphere(1))
    with pytest.raises(FlowError, match=r"no Voronoi diagram of 42 vertices.*span a volume"):
        voronoi.voronoi_poles(vertices * [1, 1, 0], faces)
    vertices[0] = np.nan
    with pytest.raises(FlowError, match="no Voronoi diagram"):
        voronoi.voronoi_poles(vertices, faces)


def test_the_public_call_gives_one_pole_a_vertex_in_the_callers_units():
    """Two spheres far from the origin: each one's poles are at its own centre; the input stays as it is."""
    centres = np.array([[100.0, 0, 0], [0, 50, 0]])
    parts = [trimesh.creation.icosphere(3, radius=r).apply_translation(c) for r, c in zip((1, 5), centres, strict=True)]
    mesh = trimesh.util.concatenate(parts)
    before = mesh.vertices.copy()
    found = preprocessing.voronoi_poles(mesh)
    assert found.shape == (1284, 3)
    np.testing.assert_allclose(found, np.repeat(centres, 642, axis=0), atol=1e-2)
    np.testing.assert_array_equal(mesh.vertices, before)


def test_the_public_call_says_nan_where_there_is_no_pole():
    vertices, faces = arrays(SHAPES["slab"]())
    has = voronoi.voronoi_poles(vertices, faces).is_found
    found = preprocessing.voronoi_poles((vertices, faces))
    np.testing.assert_array_equal(np.isnan(found).all(axis=1), ~has)
    assert np.isfinite(found[has]).all()


# Spectral reconstruction


def dense_laplacian(faces: np.ndarray, num_vertices: int) -> np.ndarray:
    """D - A, one entry at a time."""
    laplacian = np.zeros((num_vertices, num_vertices))
    for a, b in {tuple(sorted(pair)) for face in faces.tolist() for pair in (face[:2], face[1:], face[::2])}:
        laplacian[[a, b], [a, b]] += 1
        laplacian[[a, b], [b, a]] -= 1
    return laplacian


def test_the_graph_laplacian_is_that_of_the_edges():
    for mesh in (blob(1, 1), torus(around=7, across=5)):
        _, faces = arrays(mesh)
        found = reconstruction.graph_laplacian(faces, len(mesh.vertices)).toarray()
        np.testing.assert_array_equal(found, dense_laplacian(faces, len(mesh.vertices)))


def test_the_spectrum_of_a_known_torus_grid():
    """On the triangulated n x m torus the eigenvalues are 6 - 2 cos(s) - 2 cos(t) - 2 cos(s + t), in closed form."""
    around, across = 15, 9
    _, faces = arrays(torus(around=around, across=across))
    s, t = np.meshgrid(2 * np.pi * np.arange(around) / around, 2 * np.pi * np.arange(across) / across)
    expected = np.sort((6 - 2 * np.cos(s) - 2 * np.cos(t) - 2 * np.cos(s + t)).ravel())
    laplacian = reconstruction.graph_laplacian(faces, around * across)
    for k in (7, 40, 60):  # below and above the switch to the dense solver
        basis = reconstruction.spectral_basis(faces, around * across, k)
        np.testing.assert_allclose(np.linalg.eigvalsh(basis.T @ (laplacian @ basis)), expected[:k], atol=1e-9)


@pytest.mark.parametrize("k", [5, 40, 150, 300])
def test_the_basis_is_orthonormal(k):
    _, faces = arrays(blob(14))
    basis = reconstruction.spectral_basis(faces, 642, k)
    assert basis.shape == (642, k)
    assert np.abs(basis.T @ basis - np.eye(k)).max() < 1e-10


def uneven(seed: int) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """A sphere meshed without symmetry, so that eigenvalues are apart: vertices, faces, eigenvalues, eigenvectors."""
    points = np.random.default_rng(seed).normal(size=(220, 3))
    mesh = trimesh.convex.convex_hull(points / np.linalg.norm(points, axis=1)[:, None])
    vertices, faces = arrays(mesh)
    vertices = vertices * [3, 1, 1] + 0.1 * np.sin(7 * vertices[:, [1, 2, 0]])
    return vertices, faces, *np.linalg.eigh(dense_laplacian(faces, len(vertices)))


@pytest.mark.parametrize(("low", "high"), [(4, 12), (20, 60), (90, 130)])
def test_reconstruction_equals_the_dense_projection(low, high):
    """At the widest gap between eigenvalues in a range, where the subspace is well defined."""
    vertices, faces, values, vectors = uneven(3)
    k = low + int(np.argmax(np.diff(values)[low - 1 : high - 1]))
    assert values[k] - values[k - 1] > 1e-3
    basis = vectors[:, :k]
    expected = basis @ (basis.T @ vertices)
    assert np.abs(expected - vertices).max() > 1e-2
    np.testing.assert_allclose(reconstruction.reconstruct(vertices, faces, k), expected, atol=1e-8)


@pytest.mark.parametrize("k", [20, 100])
def test_reconstruction_is_a_linear_projection(k):
    """Twice is once; sums and multiples pass through; a constant shift, the first eigenvector, is kept."""
    vertices, faces, values, _ = uneven(5)
    k += int(np.argmax(np.diff(values)[k - 1 : k + 9]))
    other = np.random.default_rng(6).normal(size=vertices.shape)

    def rebuilt(x):
        return reconstruction.reconstruct(x, faces, k)

    once = rebuilt(vertices)
    np.testing.assert_allclose(rebuilt(once), once, atol=1e-9)
    np.testing.assert_allclose(rebuilt(2 * vertices - 3 * other), 2 * once - 3 * rebuilt(other), atol=1e-9)
    np.testing.assert_allclose(rebuilt(vertices + np.array([1, 2, 3])), once + np.array([1, 2, 3]), atol=1e-9)
    assert np.linalg.norm(once - vertices) < np.linalg.norm(vertices - vertices.mean(axis=0))
    # What is lost is orthogonal to what is kept.
    np.testing.assert_allclose(once.T @ (vertices - once), 0, atol=1e-8)


def test_more_eigenvectors_lose_less():
    vertices, faces, *_ = uneven(7)
    lost = [np.linalg.norm(reconstruction.reconstruct(vertices, faces, k) - vertices) for k in (5, 20, 70, 150)]
    assert lost == sorted(lost, reverse=True) and lost[-1] < 0.5 * lost[0]


@pytest.mark.parametrize("k", [42, 43, 1000])
def test_all_eigenvectors_keep_everything(k):
    vertices, faces = arrays(blob(15, 1))
    kept = reconstruction.reconstruct(vertices, faces, k)
    np.testing.assert_array_equal(kept, vertices)
    assert not np.shares_memory(kept, vertices)
    basis = reconstruction.spectral_basis(faces, 42, 42)
    np.testing.assert_allclose(basis @ (basis.T @ vertices), vertices, atol=1e-12)


def test_the_same_basis_twice():
    """The iterative solver starts from a fixed vector: bit for bit the same result."""
    vertices, faces = arrays(blob(16))
    first, second = (reconstruction.reconstruct(vertices, faces, 50) for _ in range(2))
    np.testing.assert_array_equal(first, second)


# The filter that stands for it in the flow


@pytest.mark.parametrize(("name", "k"), [("torus", 60), ("torus", 400), ("blob", 150), ("tube", 60), ("tube", 150)])
def test_the_filter_keeps_about_k_eigenvectors_and_loses_the_others(name, k):
    """Against dense eigenvectors: 1 well below the k-th wave number, 0 well above, and a trace of about k."""
    mesh = {
        "torus": lambda: torus(around=60, across=20),
        "blob": lambda: blob(3),
        "tube": lambda: torus(3.0, 0.1, around=200, across=5),  # long triangles, all waves along it
    }[name]()
    num = len(mesh.vertices)
    laplacian = reconstruction.graph_laplacian(mesh.faces, num).toarray()
    values, vectors = np.linalg.eigh(laplacian)
    matrix = reconstruction.filtered(np.eye(num), mesh.faces, k)
    np.testing.assert_allclose(matrix, matrix.T, atol=1e-10)
    response = (vectors * (matrix @ vectors)).sum(axis=0)
    assert np.abs(matrix @ vectors - vectors * response).max() < 1e-8  # it has the Laplacian's own eigenvectors
    assert abs(response.sum() - k) < 0.15 * k
    wave = np.sqrt(np.maximum(values, 0))
    edge = wave[k - 1]
    assert response[wave < 0.65 * edge].min() > 0.95
    assert np.abs(response[wave > 1.45 * edge]).max(initial=0) < 0.05
    assert response.min() > -1e-3 and response.max() < 1 + 1e-3


def test_the_filter_commutes_with_moving_the_mesh():
    vertices, faces = arrays(blob(4))
    turn = Rotation.from_rotvec([0.3, -1, 0.5]).as_matrix()
    moved = reconstruction.filtered(2.5 * vertices @ turn.T + [3, -1, 0.5], faces, 100)
    expected = 2.5 * reconstruction.filtered(vertices, faces, 100) @ turn.T + [3, -1, 0.5]
    np.testing.assert_allclose(moved, expected, atol=1e-10)


def test_the_filter_keeps_everything_when_asked_for_as_many_eigenvectors_as_vertices():
    vertices, faces = arrays(blob(4, 1))
    kept = reconstruction.filtered(vertices, faces, len(vertices))
    np.testing.assert_array_equal(kept, vertices)
    assert kept is not vertices


def test_poles_of_the_filtered_surface_are_those_of_the_reconstructed_one():
    """On a torus, whose poles are known: on the circle in its middle."""
    mesh = torus(around=120, across=40)
    for rebuild in (reconstruction.filtered, reconstruction.reconstruct):
        sites = rebuild(mesh.vertices, mesh.faces, 200)
        found = voronoi.voronoi_poles(sites, mesh.faces).position
        off = np.hypot(np.hypot(found[:, 0], found[:, 1]) - 1.0, found[:, 2])
        assert np.median(off) < 0.01


def test_the_public_reconstruction_treats_each_component_alone():
    parts = [blob(17, 2), torus().apply_translation([6, 0, 0])]
    joined = trimesh.util.concatenate(parts)
    before = joined.vertices.copy()
    smooth = preprocessing.reconstruct(joined, 30)
    np.testing.assert_array_equal(smooth.faces, joined.faces)
    np.testing.assert_array_equal(joined.vertices, before)
    alone = [preprocessing.reconstruct(part, 30).vertices for part in parts]
    np.testing.assert_allclose(smooth.vertices, np.concatenate(alone), atol=1e-9)
    assert np.abs(smooth.vertices - joined.vertices).max() > 1e-3
    np.testing.assert_allclose(preprocessing.reconstruct(joined, 10**6).vertices, joined.vertices, atol=1e-12)


@pytest.mark.parametrize("k", [3, 0, -5])
def test_too_few_eigenvectors_are_refused(k):
    with pytest.raises(ConfigError, match=f"k is {k}: expected a whole number of at least 4"):
        preprocessing.reconstruct(torus(), k)


def test_the_published_poles_of_sindorelax(research_mesh):
    """All 12,128 poles that Tagliasacchi's own program published, to 1e-5 of the diagonal."""
    vertices, faces = research_mesh("sindorelax")
    published = np.load(MESHES / "sindorelax_poles.npy")
    found = voronoi.voronoi_poles(vertices, faces)
    diagonal = np.linalg.norm(np.ptp(vertices, axis=0))
    assert published.shape[0] == len(vertices) == 12128
    assert found.is_found.all()
    off = np.linalg.norm(found.position - published[:, :3], axis=1)
    assert int((off < 1e-5 * diagonal).sum()) == 12128
    np.testing.assert_allclose(found.radius, published[:, 4], rtol=0, atol=1e-5 * diagonal)


def test_the_poles_of_a_torus_are_on_its_core():
    """Towards the circle of radius 1 where the tube is widest open, never past the tube: about 0.35 away."""
    vertices, faces = arrays(torus(around=96, across=32))
    found = voronoi.voronoi_poles(vertices, faces)
    ring = np.hypot(found.position[:, 0], found.position[:, 1])
    from_core = np.hypot(ring - 1, found.position[:, 2])[found.is_found]
    assert found.is_found.mean() > 0.99
    assert np.median(from_core) < 0.01 and np.quantile(from_core, 0.99) < 0.05


@pytest.mark.parametrize("size", [(24, 12), (96, 32)])
def test_the_ball_of_a_pole_is_empty_on_a_mesh_of_symmetric_quads(size):
    """The corners of each quad of a torus grid are cocircular: flat Delaunay tetrahedra must not make poles."""
    mesh = torus(1.0, 0.35, *size)
    vertices, faces = np.array(mesh.vertices), np.array(mesh.faces)
    found = voronoi.voronoi_poles(vertices, faces)
    nearest = np.linalg.norm(found.position[:, None] - vertices[None], axis=2).min(axis=1)
    np.testing.assert_allclose(nearest, found.radius, rtol=0, atol=1e-6)
