"""Closed meshes made in code, for the demo, the notebooks and the tests: solids around known curves."""

import numpy as np
import trimesh


def solid_around(
    points: np.ndarray, edges: np.ndarray, radii: np.ndarray, spacing: float, *, blend: float = 0.0
) -> trimesh.Trimesh:
    """The closed surface around a curve: the union of a round cone along each edge.

    Args:
        points: (N, 3) nodes of the curve.
        edges: (E, 2) its edges.
        radii: (N,) radius at each node; it is interpolated along the edges.
        spacing: edge length of the sampling grid, and about that of the triangles.
        blend: width of the fillet where cones meet, 0 for none; it thickens joints by up to a quarter of this width.
    """
    margin = float(radii.max()) + 2 * spacing + blend
    low, high = points.min(axis=0) - margin, points.max(axis=0) + margin
    axes = [np.arange(low[k], high[k] + spacing, spacing) for k in range(3)]
    grid = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)
    nearest = np.full(grid.shape[:3], np.inf)
    for a, b in edges:
        along = points[b] - points[a]
        t = np.clip((grid - points[a]) @ along / (along @ along), 0.0, 1.0)
        distance = np.linalg.norm(grid - points[a] - t[..., None] * along, axis=-1)
        layer = distance - (radii[a] + t * (radii[b] - radii[a]))
        overlap = np.maximum(blend - np.abs(layer - nearest), 0.0)
        nearest = np.minimum(nearest, layer) - (overlap**2 / (4 * blend) if blend else 0.0)
    return level_set(nearest, low, spacing)


def level_set(field: np.ndarray, low: np.ndarray, spacing: float) -> trimesh.Trimesh:
    """The closed surface where ``field`` (X, Y, Z), sampled from ``low`` by ``spacing``, is 0; it is negative inside.

    By marching tetrahedra: each cube is cut into six tetrahedra around its diagonal, which share their faces with their
    neighbours, so that the surface is a closed manifold for all values.
    """
    shape = np.array(field.shape)
    corner = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]])
    tetrahedra = np.array([[0, 1, 2, 6], [0, 2, 3, 6], [0, 3, 7, 6], [0, 7, 4, 6], [0, 4, 5, 6], [0, 5, 1, 6]])
    cube = np.stack(np.meshgrid(*(np.arange(n - 1) for n in shape), indexing="ij"), axis=-1).reshape(-1, 3)
    number = np.ravel_multi_index(tuple((cube[:, None] + corner).reshape(-1, 3).T), tuple(shape)).reshape(-1, 8)
    value = field.ravel()
    is_mixed = (value[number] < 0).any(axis=1) & (value[number] >= 0).any(axis=1)
    corners = number[is_mixed][:, tetrahedra].reshape(-1, 4)
    is_in = value[corners] < 0
    count = is_in.sum(axis=1)
    order = np.argsort(~is_in, axis=1, kind="stable")  # the inside corners to the front
    corners = np.take_along_axis(corners, order, axis=1)
    one_in, three_in = [[[0, 1], [0, 2], [0, 3]]], [[[0, 3], [2, 3], [1, 3]]]
    two_in = [[[0, 2], [0, 3], [1, 3]], [[0, 2], [1, 3], [1, 2]]]
    cuts = []
    for inside, triangles in ((1, one_in), (2, two_in), (3, three_in)):
        chosen = corners[count == inside]
        cuts += [(chosen[:, triangle], chosen[:, :inside], chosen[:, inside:]) for triangle in triangles]
    ends = np.sort(np.concatenate([cut for cut, _, _ in cuts]).reshape(-1, 2), axis=1)
    edge, inverse = np.unique(ends, axis=0, return_inverse=True)
    faces = inverse.reshape(-1, 3)

    def place(corner: np.ndarray) -> np.ndarray:
        # Not np.unravel_index: NumPy 2.4.6 returns wrong places for more than 8,192 rows of one column.
        return np.stack([corner // (shape[1] * shape[2]), corner // shape[2] % shape[1], corner % shape[2]], axis=-1)

    a, b = value[edge[:, 0]], value[edge[:, 1]]
    t = np.clip(a / (a - b), 0.02, 0.98)[:, None]
    vertices = (1 - t) * place(edge[:, 0]) + t * place(edge[:, 1])
    # A triangle's orientation does not depend on where it cuts the edges; at their middles it is well conditioned.
    outwards = np.concatenate([place(out).mean(axis=1) - place(into).mean(axis=1) for _, into, out in cuts])
    middle = (place(edge[:, 0]) + place(edge[:, 1])) / 2
    normal = np.cross(middle[faces[:, 1]] - middle[faces[:, 0]], middle[faces[:, 2]] - middle[faces[:, 0]])
    is_inward = (normal * outwards).sum(axis=1) < 0
    faces[is_inward] = faces[is_inward][:, ::-1]
    return trimesh.Trimesh(low + spacing * vertices, faces, process=False)


def hand(spacing: float = 0.05) -> trimesh.Trimesh:
    """A hand with five fingers and a handle at the wrist: five tips, a forearm, and one loop (genus 1); ``spacing`` is
    that of the sampling grid, at most 0.1: on a coarser grid fingers merge, or separate from the hand."""
    points, edges, radii = hand_curve()
    return solid_around(points, edges, radii, spacing, blend=0.12)


def hand_curve() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The curve that `hand` is built around: points (N, 3), edges (E, 2), radii (N,)."""
    points = [(0.0, 0.0, -1.1), (0.0, 0.0, -0.55), (0.0, 0.0, 0.0)]
    radii = [0.17, 0.18, 0.22]
    edges = [(0, 1), (1, 2)]
    fingers = (-62, 0.62, 0.1), (-31, 0.92, 0.085), (-9, 1.05, 0.085), (13, 0.98, 0.085), (35, 0.8, 0.075)
    for angle, length, radius in fingers:
        direction = np.array([np.sin(np.radians(angle)), 0.0, np.cos(np.radians(angle))])
        bend = np.array([0.0, -0.12, 0.0])
        for fraction, follows in ((0.35, 2), (0.7, None), (1.0, None)):
            points.append(tuple(direction * length * (0.15 + fraction) + bend * fraction**2))
            radii.append(radius * (1.25 - 0.25 * fraction))
            edges.append((2 if follows == 2 else len(points) - 2, len(points) - 1))
    start = len(points)
    for angle in np.linspace(-60, 60, 5):  # the handle, a bow from the wrist to the forearm's end
        points.append((0.0, 0.2 + 0.35 * np.cos(np.radians(angle)), -0.62 + 0.36 * np.sin(np.radians(angle))))
        radii.append(0.06)
    edges += [(0, start), *((k, k + 1) for k in range(start, start + 4)), (start + 4, 2)]
    points[start] = (0.0, 0.32, -1.0)
    return np.array(points, dtype=float), np.array(edges), np.array(radii)
