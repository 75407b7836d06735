"""The mirror images of a surface in itself, if it is symmetric.

A plane of symmetry holds the middle of the surface, and lies across one of the principal axes of its moments. It is one
if the mirror images of the vertices are on the surface. A body with equal moments, such as a table with four equal
legs, has principal axes by chance, and may have no image.
"""

import numpy as np

from msf_jax.solid.enclosure import Enclosure

FARTHEST_IMAGE = 0.0025  # diagonals: mirror images from the surface (root mean square by area); see `images`


def images(shape: Enclosure, share: np.ndarray, component: np.ndarray) -> list[np.ndarray]:
    """The vertex (V,) at the mirror image of each vertex of ``shape``, one array for each plane of symmetry of each
    ``component`` (V,), and for each image in one plane of an image in another; -1 in other components.

    ``share`` (V,) is the area around each vertex. Images are up to 0.0015 diagonals from the surface for characters
    that were modelled in halves, 0.002 with noise of 0.1 %, and 0.0035 or more for others.
    """
    every = []
    for number in range(component.max() + 1):
        member, found = np.flatnonzero(component == number), []
        faces = np.searchsorted(member, shape.faces[component[shape.faces[:, 0]] == number])
        own = shape if len(member) == len(component) else Enclosure(shape.vertices[member], faces)
        x, weight = own.vertices, share[member] / share[member].sum()
        from_middle, diagonal = x - weight @ x, float(np.linalg.norm(np.ptp(x, axis=0)))
        for axis in np.linalg.eigh(from_middle.T @ (weight[:, None] * from_middle))[1].T:
            image = x - 2 * np.outer(from_middle @ axis, axis)
            away, triangle = own.approximate_closest(image)
            if np.sqrt(weight @ away**2) <= FARTHEST_IMAGE * diagonal:
                corner = own.faces[triangle]
                nearest = np.linalg.norm(x[corner] - image[:, None], axis=2).argmin(axis=1)
                near = corner[np.arange(len(x)), nearest]
                found += [near, *(near[other] for other in found)]
        for near in found:
            every.append(np.full(len(component), -1))
            every[-1][member] = member[near]
    return every
