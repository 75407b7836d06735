"""What is no simple solid: cavities, parts that cross themselves or are inside of others, walls."""

import numpy as np
import pytest
import trimesh

import msf_jax
from msf_jax import Config, ConfigError, metrics
from msf_jax.meshes import checking
from msf_jax.skeleton.report import assessed
from msf_jax.solid import solid
from msf_jax.solid.enclosure import Enclosure
from tests.benchmarks.faults import hollow, inverted, knotted, together

SEEDS = [1, pytest.param(0, marks=pytest.mark.slow)]


def shell(inner: float = 0.5) -> trimesh.Trimesh:
    """A ball with a ball-shaped cavity."""
    return together(trimesh.creation.icosphere(2), inverted(trimesh.creation.icosphere(2, inner)))


def enclosure(mesh: trimesh.Trimesh) -> Enclosure:
    return Enclosure(np.array(mesh.vertices), np.array(mesh.faces))


def share_inside(mesh: trimesh.Trimesh, skeleton: msf_jax.Skeleton) -> float:
    """Of the curve's length, by points on it and the winding number of the mesh as it was given."""
    a, b = skeleton.vertices[skeleton.edges[:, 0]], skeleton.vertices[skeleton.edges[:, 1]]
    t = (np.arange(20) + 0.5)[:, None, None] / 20
    is_in = enclosure(mesh).contains(((1 - t) * a + t * b).reshape(-1, 3)).reshape(20, -1)
    return float(np.average(is_in.mean(axis=0), weights=np.linalg.norm(b - a, axis=1) + 1e-12))


@pytest.mark.parametrize("seed", SEEDS)
def test_no_curve_is_in_a_cavity(seed):
    """The curve goes around it, and has a loop through every ring-shaped one."""
    mesh, num_rings = hollow(seed)
    skeleton = msf_jax.skeletonize(mesh)
    report = skeleton.report
    assert share_inside(mesh, skeleton) == report.inside == 1.0
    assert report.components == report.mesh_components == 1 and report.genus == num_rings
    assert report.loops == report.cycles == num_rings
    assert len(skeleton.mesh_map) == len(mesh.vertices) and skeleton.mesh_map.min() >= 0


@pytest.mark.slow  # that a part keeps its vertices is below
@pytest.mark.parametrize("seed", [1])
def test_a_part_that_crosses_itself_is_doubted_or_resolved(seed):
    mesh, genus, radius, axis = knotted(seed)
    first = msf_jax.skeletonize(mesh)
    (doubt,) = [each for each in first.report.doubts if "crosses itself" in each]
    assert "radii count walls" in doubt and 'repair="join"' in doubt
    skeleton = msf_jax.skeletonize(mesh, repair="join")
    assert skeleton.report.cycles == skeleton.report.loops == genus and skeleton.report.is_sound
    assert share_inside(mesh, skeleton) == 1.0
    # No ball is smaller than in its own strand of the tube; at bends, strips of the surface cut a little off that.
    loop = np.stack([np.arange(96), (np.arange(96) + 1) % 96], axis=1)
    away = metrics.curve_distance(skeleton.vertices, axis, loop)
    assert (skeleton.radii >= 0.98 * radius - away).all()
    assert (first.radii < 0.98 * radius - metrics.curve_distance(first.vertices, axis, loop)).any()


def test_a_part_that_crosses_itself_keeps_its_vertices():
    mesh, genus, _, _ = knotted(0)
    found = checking.prepare(mesh, "join")
    own = ~found.is_made
    assert own.mean() > 0.8 and [part.genus for part in found.components] == [genus]
    np.testing.assert_array_equal(found.vertices[own], mesh.vertices[found.input_of_vertex[own]])
    (line,) = found.repairs
    assert line.startswith("resolved ") and line.endswith("where a part crossed itself")
    assert not enclosure(trimesh.Trimesh(found.vertices, found.faces, process=False)).crossed.pairs.size


def test_cavities_are_known_by_nesting_and_winding():
    """Also in a file that is inside out as a whole, and with a solid in the cavity."""
    for mesh in (shell(), inverted(shell()), together(shell(), trimesh.creation.icosphere(1, 0.2))):
        found = checking.prepare(mesh)
        volumes = [np.linalg.det(part.vertices[part.faces]).sum() for part in found.components]
        assert min(volumes) > 0 and len(found.components) == len(mesh.split()) - 1
        assert len(found.linings[0]) == 162 and found.components[0].cavities is not None
        bodies = solid.bodies(Enclosure(found.vertices, found.faces))
        assert len(bodies[0].vertices) == 324 and not any(body.is_within for body in bodies)


@pytest.mark.slow  # what is within another is in the test above
def test_a_solid_that_is_wound_outwards_in_another_is_doubted():
    mesh = together(trimesh.creation.icosphere(2), trimesh.creation.icosphere(2, 0.5))
    report = msf_jax.skeletonize(mesh, config=Config(max_iterations=1)).report
    assert report.mesh_components == 2
    assert any("inside another" in doubt and "a cavity is wound inwards" in doubt for doubt in report.doubts)


def test_joining_leaves_cavities_and_solids_in_them():
    found = checking.prepare(together(shell(), trimesh.creation.icosphere(2, 0.2)), "join")
    volume = np.linalg.det(found.vertices[found.faces]).sum() / 6
    ball = trimesh.creation.icosphere(2).volume
    assert volume == pytest.approx(ball * (1 - 0.5**3 + 0.2**3), rel=1e-3)
    assert len(found.components) == 2


def test_a_cavity_has_no_pins():
    with pytest.raises(ConfigError, match="vertex 200 of a cavity"):
        msf_jax.skeletonize(shell(), pins=[3, 200])


@pytest.mark.parametrize("size", [None, 0.3])
def test_the_wall_of_a_pipe_is_a_sheet_whatever_its_triangles(size):
    """A closed pipe, and one with open ends: a curve that is anywhere in the wall is in a sheet."""
    pipe = trimesh.creation.annulus(0.9, 1.0, 4.0, sections=24)
    inner = inverted(trimesh.creation.cylinder(0.85, 4.7, sections=24))
    for mesh in (pipe, together(trimesh.creation.cylinder(1.0, 5.0, sections=24), inner)):
        shape = enclosure(mesh if size is None else mesh.subdivide_to_size(size))
        angle = 0.3 + 0.02 * np.arange(200)
        x = np.stack([0.93 * np.cos(angle), 0.93 * np.sin(angle), 0.01 * np.arange(200) - 1.0], axis=1)
        about = assessed(shape, x, np.stack([np.arange(199), np.arange(1, 200)], axis=1))
        assert about["in_sheets"] == 1.0
        assert "100% of the curve's length is in sheets, where its path is arbitrary" in about["doubts"]
