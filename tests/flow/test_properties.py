"""What holds for every closed mesh, over generated ones: topology, maps, finite numbers, scale and order.

`MSF_JAX_EXAMPLES` meshes are tried, 2 if it is not set.
"""

import os

import numpy as np
import pytest
import trimesh
from conftest import torus
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import msf_jax
from msf_jax import shapes
from tests.benchmarks import ground_truth

EXAMPLES = int(os.environ.get("MSF_JAX_EXAMPLES", "2"))


def limb(random: np.random.Generator) -> trimesh.Trimesh:
    """A tube along a random smooth curve, thicker here and thinner there."""
    stops = np.cumsum(random.normal(0, 1, (4, 3)) + [1.5, 0, 0], axis=0)
    points = trimesh.path.simplify.resample_spline(stops, count=60)
    radii = 0.25 + 0.1 * np.sin(np.linspace(0, random.uniform(3, 9), len(points)))
    return ground_truth.swept_tube(points, radii, int(random.integers(6, 14)), "round")


def bumpy(random: np.random.Generator) -> trimesh.Trimesh:
    """A sphere with smooth bumps."""
    mesh = trimesh.creation.icosphere(3)
    bumps = sum(0.12 * np.cos(mesh.vertices @ random.normal(0, 3, 3) + random.uniform(0, 6)) for _ in range(4))
    return trimesh.Trimesh(mesh.vertices * (1 + bumps[:, None]), mesh.faces, process=False)


def net(random: np.random.Generator, *, crossing: bool = False) -> trimesh.Trimesh:
    """Rods along the edges of a random graph: any genus, in one piece.

    Rods that cross beside each other leave holes of a few triangles.
    """
    corners = np.array([[x, y, z] for x in range(3) for y in range(2) for z in range(2)], dtype=float)
    nodes = corners + random.uniform(-0.15, 0.15, corners.shape)
    apart = np.linalg.norm((nodes if crossing else corners)[:, None] - (nodes if crossing else corners), axis=2)
    steps = [(a, b) for a in range(12) for b in range(a) if apart[a, b] < (1.4 if crossing else 1.1)]
    order = random.permutation(len(steps))
    tree, edges = list(range(12)), []
    for number in order:
        a, b = steps[number]
        if tree[a] != tree[b] or random.random() < 0.2:
            edges.append((a, b))
            tree = [tree[a] if part == tree[b] else part for part in tree]
    return shapes.solid_around(nodes, np.array(edges), np.full(12, 0.16), 0.12)


def two(random: np.random.Generator) -> trimesh.Trimesh:
    """Two pieces, one with a handle: not a symmetric one, whose frame its vertices' order would decide."""
    ring = torus(around=int(random.integers(12, 30)), across=int(random.integers(6, 14)))
    ring.vertices *= 1 + random.normal(0, 0.005, (len(ring.vertices), 1))
    return trimesh.util.concatenate([ring, trimesh.Trimesh(bumpy(random).vertices + [4, 0, 0], bumpy(random).faces)])


MAKERS = {"limb": limb, "bumpy": bumpy, "net": net, "two": two}


@st.composite
def meshes(draw: st.DrawFn) -> tuple[np.ndarray, np.ndarray, int]:
    """Vertices, faces and a seed: a generated solid, in any order, perhaps noisy or stretched."""
    seed = draw(st.integers(0, 2**31))
    random = np.random.default_rng(seed)
    mesh = MAKERS[draw(st.sampled_from(sorted(MAKERS)))](random)
    vertices, faces = np.array(mesh.vertices), np.array(mesh.faces)
    vertices *= draw(st.sampled_from([[1, 1, 1], [1, 1, 3], [0.5, 1, 1]]))
    noise = draw(st.sampled_from([0.0, 0.002]))
    vertices += random.normal(0, noise, vertices.shape) * np.ptp(vertices, axis=0).max()
    order = random.permutation(len(vertices))
    faces = np.argsort(order)[faces[random.permutation(len(faces))]]
    faces = faces[np.arange(len(faces))[:, None], (np.arange(3) + random.integers(3, size=len(faces))[:, None]) % 3]
    return vertices[order], faces, seed


@pytest.mark.slow  # each of these has a quick test of one mesh in test_flow
@settings(max_examples=EXAMPLES, deadline=None, suppress_health_check=list(HealthCheck))
@given(meshes())
def test_every_closed_mesh_becomes_a_whole_curve(drawn):
    vertices, faces, seed = drawn
    run = msf_jax.contract((vertices, faces))
    skeleton, report = run.skeleton, run.skeleton.report
    euler = trimesh.Trimesh(vertices, faces, process=False).euler_number
    parts = trimesh.graph.connected_components(trimesh.Trimesh(vertices, faces, process=False).face_adjacency)
    assert report.genus == (2 * len(parts) - euler) // 2
    assert (report.cycles, report.loops, report.components) == (report.genus, report.genus, len(parts))
    for curve in (run.curve, skeleton):
        assert np.isfinite(curve.vertices).all() and np.isfinite(curve.radii).all() and (curve.radii >= 0).all()
        assert curve.mesh_map.shape == (len(vertices),)
        assert ((curve.mesh_map >= 0) & (curve.mesh_map < len(curve.vertices))).all()
    assert report.inside > 0.9
    for number in range(len(run.history)):
        if len(parts) == 1:  # then the history is that of one surface, and the genus is the same throughout
            stage = run.surface(number)
            surface = trimesh.Trimesh(stage.vertices, stage.faces, process=False)
            assert surface.is_watertight and surface.is_winding_consistent and surface.euler_number == euler
    # The same solid, larger or smaller by a power of two, which changes no digit, its vertices in another order.
    random = np.random.default_rng(seed)
    scale, order = 2.0 ** random.integers(-20, 20), random.permutation(len(vertices))
    other = msf_jax.contract((scale * vertices[order], np.argsort(order)[faces][::-1]))
    diagonal = np.linalg.norm(np.ptp(vertices, axis=0))
    for one, two in ((run.curve, other.curve), (skeleton, other.skeleton)):
        assert two.vertices.shape == one.vertices.shape
        expected = one.vertices[one.mesh_map][order]  # by vertex of the mesh: parts may come in another order
        assert np.abs(two.vertices[two.mesh_map] / scale - expected).max() < 1e-9 * diagonal


@pytest.mark.slow  # loops of a sound surface are in test_flow, of one that crosses itself in test_hollow
@pytest.mark.parametrize(
    ("seed", "crossing"),
    [(1541, False), (136825292, True)],
)
def test_slivers_and_noise_lose_no_handle(seed, crossing):
    """The surface crosses itself here and there, so that linking numbers are wrong until it is smoothed."""
    random = np.random.default_rng(seed)
    mesh = net(random, crossing=crossing)
    vertices = mesh.vertices + random.normal(0, 0.002, mesh.vertices.shape) * np.ptp(mesh.vertices, axis=0).max()
    report = msf_jax.skeletonize((vertices, mesh.faces)).report
    assert report.loops == report.cycles == report.genus == (2 - mesh.euler_number) // 2 > 1
