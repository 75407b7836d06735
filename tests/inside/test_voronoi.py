"""Voronoi poles: their promises, SciPy's own diagram, and shapes whose poles are known."""

import numpy as np
import pytest
import trimesh
from conftest import MESHES, blob, torus
from scipy import spatial
from solid_cases import arrays, outward_normals

from msf_jax.base.errors import FlowError
from msf_jax.inside import balls
from msf_jax.numerics import reconstruction

SHAPES = {"blob": lambda: blob(11), "slab": lambda: jittered(torus(), [3.0, 1, 0.3]), "torus": torus}


def jittered(mesh: trimesh.Trimesh, scale) -> trimesh.Trimesh:
    """The mesh scaled, and shaken out of general symmetry."""
    noise = 1e-3 * np.random.default_rng(4).normal(size=mesh.vertices.shape)
    return trimesh.Trimesh((mesh.vertices + noise) * scale, mesh.faces, process=False)


def test_the_circumcentres_of_a_box_are_its_centre():
    """Eight cospherical corners: flat tetrahedra among them have the same centre."""
    box = np.array(trimesh.creation.box((4, 6, 10)).vertices) + [3, 5, 8]
    centre = balls.circumcentres(spatial.Delaunay(box))
    np.testing.assert_allclose(centre, np.broadcast_to([3, 5, 8], centre.shape))


@pytest.mark.parametrize("name", SHAPES)
def test_poles_keep_their_promises(name):
    """Behind the surface, in the bounding box, the centre of an empty ball through the vertex and its tetrahedron."""
    vertices, faces = arrays(SHAPES[name]())
    found = balls.voronoi_poles(vertices, faces)
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
    found = balls.voronoi_poles(vertices, faces)
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
    found = balls.voronoi_poles(vertices, faces[:, ::-1])
    assert not found.is_found.any()
    np.testing.assert_array_equal(found.position, vertices)
    assert (found.radius == 0).all() and (found.tetrahedron == -1).all()


def test_poles_follow_when_the_shape_is_moved_turned_and_scaled():
    mesh = jittered(blob(13), 1.0)
    turn = trimesh.transformations.random_rotation_matrix(np.array([0.2, 0.5, 0.8]))[:3, :3]
    vertices, faces = arrays(mesh)
    # The bounding box does not turn with the shape, so only poles well inside both boxes are compared.
    here = balls.voronoi_poles(vertices, faces)
    there = balls.voronoi_poles(vertices @ turn.T * 3 + [1, 2, 3], faces)
    is_same = np.linalg.norm(here.position @ turn.T * 3 + [1, 2, 3] - there.position, axis=1) < 1e-7
    assert is_same.mean() > 0.99
    scaled = balls.voronoi_poles(vertices * 0.25 + [8, 0, 0], faces)
    np.testing.assert_allclose(scaled.position, here.position * 0.25 + [8, 0, 0], atol=1e-9)


def test_vertices_that_span_no_volume_have_no_diagram():
    vertices, faces = arrays(trimesh.creation.icosphere(1))
    with pytest.raises(FlowError, match=r"no Voronoi diagram of 42 vertices.*span a volume"):
        balls.voronoi_poles(vertices * [1, 1, 0], faces)
    vertices[0] = np.nan
    with pytest.raises(FlowError, match="no Voronoi diagram"):
        balls.voronoi_poles(vertices, faces)


def test_poles_of_the_filtered_surface_are_those_of_the_reconstructed_one():
    """On a torus, whose poles are known: on the circle in its middle."""
    mesh = torus(around=60, across=20)
    for exact in (False, True):
        kept = reconstruction.low_pass(mesh.faces, len(mesh.vertices), 200, exact=exact)
        sites = reconstruction.apply(kept, mesh.vertices, mesh.faces)
        found = balls.voronoi_poles(sites, mesh.faces).position
        off = np.hypot(np.hypot(found[:, 0], found[:, 1]) - 1.0, found[:, 2])
        assert np.median(off) < 0.01


def test_the_published_poles_of_sindorelax(research_mesh):
    """All 12,128 poles that Tagliasacchi's own program published, to 1e-5 of the diagonal."""
    vertices, faces = research_mesh("sindorelax")
    published = np.load(MESHES / "sindorelax_poles.npy")
    found = balls.voronoi_poles(vertices, faces)
    diagonal = np.linalg.norm(np.ptp(vertices, axis=0))
    assert published.shape[0] == len(vertices) == 12128
    assert found.is_found.all()
    off = np.linalg.norm(found.position - published[:, :3], axis=1)
    assert int((off < 1e-5 * diagonal).sum()) == 12128
    np.testing.assert_allclose(found.radius, published[:, 4], rtol=0, atol=1e-5 * diagonal)


@pytest.mark.parametrize("size", [(24, 12), pytest.param((96, 32), marks=pytest.mark.slow)])
def test_the_ball_of_a_pole_is_empty_on_a_mesh_of_symmetric_quads(size):
    """The corners of each quad of a torus grid are cocircular: flat Delaunay tetrahedra must not make poles."""
    mesh = torus(1.0, 0.35, *size)
    vertices, faces = np.array(mesh.vertices), np.array(mesh.faces)
    found = balls.voronoi_poles(vertices, faces)
    nearest = np.linalg.norm(found.position[:, None] - vertices[None], axis=2).min(axis=1)
    np.testing.assert_allclose(nearest, found.radius, rtol=0, atol=1e-6)
