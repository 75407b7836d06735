"""Solids whose right curve is a closed form, as made and changed: inside, loops = genus, ends on axes, and a curve that
belongs to the solid and not to its triangles, place, size, or the order in which they are stored."""

import numpy as np
import pytest
import trimesh
from scipy.spatial.transform import Rotation

import msf_jax
from tests.benchmarks import machined, solids

QUICK = ("bar", "tee", "cylinder-6", "cone", "bar-hole", "hammer")
NAMES = ["bar", "tee", "bolt", "table", "cylinder-6", "cone", "washer", "bar-hole", "hammer", "l-profile", "beam-6"]
NAMES += ["slab", "plate", "tee-square", "nail", "i-beam", "cylinder-3", "cylinder-12", "pencil"]
NAMES += ["frustum-wide", "nut", "torus", "bar-holes-4", "plate-pocket", "cylinder-hole", "bolt-socket", "x-rods"]
NAMES += ["stool-3", "u-channel", "bar-2-bores"]
MIRROR = np.diag([-1.0, 1, 1])


def mirrored(vertices, faces, random):
    return vertices @ MIRROR, faces[:, ::-1], lambda x: x @ MIRROR


def moved(vertices, faces, random):
    """Turned, a thousand times as large, and far away."""
    turn, shift = Rotation.random(rng=random).as_matrix(), random.normal(size=3) * 1e4
    return 1e3 * vertices @ turn.T + shift, faces, lambda x: (x - shift) @ turn / 1e3


def permuted(vertices, faces, random):
    order = random.permutation(len(vertices))
    return vertices[order], np.argsort(order)[faces][random.permutation(len(faces))], lambda x: x


def split(vertices, faces, random):
    """Each triangle into four."""
    return *trimesh.remesh.subdivide(vertices, faces), lambda x: x


CHANGES = (mirrored, moved, permuted, split)


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=() if name in QUICK else pytest.mark.slow) for name in NAMES]
)
def test_a_curve_is_that_of_its_solid(name):
    solid = solids.SOLIDS[name](solids.size_of(name, 0))
    random = np.random.default_rng(len(name))
    mesh = solid.mesh("coarse")
    change = CHANGES[NAMES.index(name) % len(CHANGES)]
    vertices, faces, undone = change(mesh.vertices, mesh.faces, random)
    ends = []
    for given, back in (((mesh.vertices, mesh.faces), lambda x: x), ((vertices, faces), undone)):
        skeleton = msf_jax.skeletonize(given)
        report = skeleton.report
        assert report.inside == 1.0 and report.components == 1
        assert report.loops == report.cycles == report.genus == solid.cycles
        figures = machined.scored(solid, (back(skeleton.vertices), skeleton.edges))
        assert machined.reasons(solid, figures | {"cycles": report.cycles, "inside": report.inside}, has_way=True) == []
        ends.append(back(skeleton.vertices)[np.bincount(skeleton.edges.ravel()) == 1])
    away = np.linalg.norm(ends[0][:, None] - ends[1], axis=2)
    assert len(ends[0]) == len(ends[1])
    assert not len(ends[0]) or away.min(axis=0).max() < 0.15 * solid.width
