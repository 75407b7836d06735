"""Weights as a function of the surface: log w = log w_0 + F theta, with features F of each vertex, for any mesh.

The features have no unit, and do not depend on the mesh's position, turn or scale, nor on the signs of eigenvectors.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from msf_jax.base.options import Weights
from msf_jax.host.mesh import checking
from msf_jax.host.mesh.checking import Component, Surface
from msf_jax.host.meso import ring_tables
from msf_jax.host.poles import voronoi
from msf_jax.host.reconstruction import spectral_basis
from msf_jax.host.solid.geometry import unit, vertex_normals

NAMES = (
    "one",
    "radius",
    "relative radius",
    "edge",
    "curvature",
    "confidence",
    "first eigenvector",
    "second eigenvector",
)
MIDDLE = -2.5  # logarithm of a radius in diagonals, about that of a limb: the feature is 0 there
MOST = 3.0  # features are cut at this size, so that a vertex at a spike gets no extreme weight


@dataclass(frozen=True, eq=False)
class FeatureWeights:
    """Weights that depend on the surface, as `tune` finds them for several meshes.

    Attributes:
        weights: w_0, numbers.
        theta: for each weight that depends on the surface a factor of each of the features ``NAMES``, (8,).
        bounds: for each of these the lowest and the highest weight.
    """

    weights: Weights
    theta: dict[str, np.ndarray]
    bounds: dict[str, tuple[float, float]]

    def of(self, mesh: Any) -> Weights:
        """The weights for ``mesh``, as `skeletonize` takes it: w_L and smoothing are numbers, others are (V,).

        Raises:
            MeshError, FlowError: see `msf_jax.voronoi_poles`.
        """
        features, held = features_of(checking.prepare(mesh)), vars(self.weights)
        found = {name: held[name] * np.exp(features @ theta) for name, theta in self.theta.items()}
        return Weights(**(held | {name: np.clip(weight, *self.bounds[name]) for name, weight in found.items()}))


def features_of(surface: Surface) -> np.ndarray:
    """(V, 8) the features ``NAMES`` of every vertex of the caller's mesh; only the first is not 0 for a vertex of no
    component's outer surface.

    "radius" is that of the ball at the vertex's Voronoi pole, in diagonals, "relative radius" over the median, "edge"
    the mean length of the vertex's edges over that radius, all three as logarithms. "curvature" is the mean curvature
    times the radius, and "confidence" the trust in the pole, as in `Config.pole_confidence`. The modes are the
    first eigenvectors of the graph Laplacian, squared, over their mean: they are large at the ends of the shape.
    """
    found = np.zeros((len(surface.vertices), len(NAMES)))
    for component, member in zip(surface.components, surface.members, strict=True):
        found[member, 1:] = np.clip(_of_component(component), -MOST, MOST)
    rows = np.where((surface.vertex_of_input < 0)[:, None], 0.0, found[surface.vertex_of_input])
    rows[:, 0] = 1.0
    return rows


def _of_component(component: Component) -> np.ndarray:
    """(V, 7) all features but the first."""
    low, high = component.vertices.min(axis=0), component.vertices.max(axis=0)
    vertices, faces = (component.vertices - (low + high) / 2) / np.linalg.norm(high - low), component.faces
    poles = voronoi.voronoi_poles(vertices, faces)
    radius = np.linalg.norm(poles.position - vertices, axis=1)
    radius = np.maximum(np.where(poles.is_found, radius, np.median(radius[poles.is_found])), 1e-6)
    a, b = ring_tables.edges_from_rings(ring_tables.rings_from_faces(faces, len(vertices)))
    ends, along = np.concatenate([a, b]), np.concatenate([vertices[b] - vertices[a], vertices[a] - vertices[b]])
    degree = np.maximum(np.bincount(ends, minlength=len(vertices)), 1)

    def mean(values: np.ndarray) -> np.ndarray:
        return np.bincount(ends, weights=values, minlength=len(vertices)) / degree

    length2 = np.maximum((along * along).sum(axis=1), 1e-24)
    bend = -2 * (along * unit(vertex_normals(vertices, faces))[ends]).sum(axis=1) / length2  # curvature along an edge
    trust = (1 - np.cos(voronoi.spoke_angles(poles, vertices))) / 2
    slow = spectral_basis(faces, len(vertices), 3)[:, 1:] ** 2 * len(vertices) - 1
    logarithms = np.log(radius) - MIDDLE, np.log(radius / np.median(radius)), np.log(mean(np.sqrt(length2)) / radius)
    return np.column_stack([*logarithms, mean(bend) * radius - 0.5, 2 * trust - 1, slow])
