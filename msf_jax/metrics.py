"""Figures of a curve in its mesh: `evaluate`, for this project's curves and anybody's.

Lengths are fractions of the mesh's bounding-box diagonal, so that figures of different meshes can be put side by side.
"""

from typing import Any

import numpy as np

from msf_jax.base.errors import MeshError
from msf_jax.host.curve import branches
from msf_jax.host.mesh import checking
from msf_jax.host.solid import sections
from msf_jax.host.solid.enclosure import Enclosure
from msf_jax.host.solid.geometry import arc_length, at, unit
from msf_jax.host.solid.solid import Solid

SAMPLES_PER_EDGE = 16
SURFACE_SAMPLES = 20_000  # at least so many, spread by area
LOPSIDED = 3.0  # a section so many times as wide as the inscribed ball is not that of a limb
STRIDE = 0.01  # diagonals, between the points of a branch at which its turning is measured
PAIRS_AT_ONCE = 4_000_000


def evaluate(mesh: Any, skeleton: Any, truth: Any = None) -> dict[str, float]:
    """Score a curve in its mesh.

    Args:
        mesh: as `skeletonize` takes it.
        skeleton: a `Skeleton`, anything with its ``vertices`` and ``edges``, or ``(vertices (N, 3), edges (E, 2))`` of
            any program, in the mesh's units.
        truth: another curve to measure the distance from and to, in either form; none if not given.

    Returns:
        A dictionary. Lengths are fractions of the mesh's bounding-box diagonal.

        - ``components``, ``cycles``, ``leaves``, ``mesh_components``, ``genus``: counts. A curve of the right topology
          has as many components as the mesh, and as many independent cycles as the sum of the genera.
        - ``inside``: fraction of the curve's length where the generalised winding number of the mesh is positive
          (Jacobson et al. 2013). Edges that the inscribed balls of their ends do not cover are sampled at the middles
          of 16 equal parts. 1 is best.
        - ``boundedness``: fraction of the nodes that are inside (Wen et al. 2025). 1 is best.
        - ``off_centre``: distance of an edge's middle from the centroid of the cross-section there, over the section's
          mean radius; the mean over edges, by length. A section more than three times as wide as the largest ball
          around its centroid is not one of a limb, and does not count; NaN if none does. 0 is best (centredness, Cornea
          et al. 2007).
        - ``missed_95``, ``missed_max``: distance from a point of the surface to the union of the nodes' inscribed
          balls: 95th percentile by area, and the largest. 0 is best (reconstruction, Cornea et al. 2007).
        - ``smoothness``: mean cosine of the angle by which a branch turns from one hundredth of the diagonal to the
          next. 1 is best (Wen et al. 2025, who take it over neighbouring points).
        - ``tip_gap``: distance from a leaf onward to the surface, over the inscribed radius one such radius back: 1 for
          a curve that ends in the middle of a round end, 8 for any gap that is longer. The mean over the leaves that
          are inside, NaN if there is none.
        - ``length``: of the curve.
        - with ``truth``: ``to_truth_mean``, ``to_truth_max``, ``from_truth_mean``, ``from_truth_max``: distance from
          the curve to the truth and back, by length.

    Raises:
        MeshError: the mesh is refused at the front door, or the curve is not one.
    """
    checked = checking.prepare(mesh)
    solid = Solid(checked.vertices, checked.faces)
    vertices, edges = _curve_of(skeleton)
    figures = {
        "mesh_components": len(checked.components),
        "genus": sum(component.genus for component in checked.components),
    }
    figures |= figures_of(solid.shape, solid.enter(vertices), edges)
    if truth is not None:
        other, other_edges = _curve_of(truth)
        ours, theirs = (solid.enter(vertices), edges), (solid.enter(other), other_edges)
        for name, (start, end) in {"to_truth": (ours, theirs), "from_truth": (theirs, ours)}.items():
            points, weight = sample_curve(*start, 0.001)
            distance = curve_distance(points, *end)
            figures[f"{name}_mean"] = float((distance * weight).sum() / weight.sum())
            figures[f"{name}_max"] = float(distance.max())
    return figures


def figures_of(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray) -> dict[str, float]:
    """`evaluate` of a curve in a surface of diagonal 1, but for what only the mesh or a truth can tell."""
    is_inside = shape.contains(vertices)
    radii = np.where(is_inside, shape.distances(vertices), 0.0)
    components, cycles = branches.cycle_count(len(vertices), edges)
    missed, area = _missed(shape, vertices, radii)
    order = np.argsort(missed)
    rank = np.searchsorted(np.cumsum(area[order]), 0.95 * area.sum())
    ways = branches.trace(len(vertices), edges)
    length = np.linalg.norm(vertices[edges[:, 0]] - vertices[edges[:, 1]], axis=1)
    return {
        "components": components,
        "cycles": cycles,
        "leaves": int((np.bincount(edges.ravel(), minlength=len(vertices)) == 1).sum()),
        "inside": inside_fraction(shape, vertices, edges, radii),
        "boundedness": float(is_inside.mean()),
        "off_centre": _off_centre(shape, vertices, edges),
        "missed_95": float(missed[order[min(rank, len(order) - 1)]]),
        "missed_max": float(missed.max()),
        "smoothness": _smoothness(vertices, ways),
        "tip_gap": _tip_gap(shape, vertices, edges, ways),
        "length": float(length.sum()),
    }


def inside_fraction(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray, radii: np.ndarray) -> float:
    """Fraction of the length of the curve ``(vertices (N, 3), edges (E, 2))`` that is inside the surface ``shape``.

    A point is inside where the winding number is positive. An edge is inside where the balls of ``radii`` (N,) around
    its ends, which are, cover it; any other is sampled at the middles of 16 equal parts. A curve without length counts
    its nodes.
    """
    a, b = vertices[edges[:, 0]], vertices[edges[:, 1]]
    length = np.linalg.norm(b - a, axis=1)
    if length.sum() == 0:
        return float(shape.contains(vertices).mean())
    share = np.ones(len(edges))
    is_open = length >= radii[edges].sum(axis=1)
    t = (np.arange(SAMPLES_PER_EDGE) + 0.5) / SAMPLES_PER_EDGE
    points = a[is_open, None] + t[None, :, None] * (b - a)[is_open, None]
    share[is_open] = shape.contains(points.reshape(-1, 3)).reshape(-1, SAMPLES_PER_EDGE).mean(axis=1)
    return float((share * length).sum() / length.sum())


def sample_curve(vertices: np.ndarray, edges: np.ndarray, spacing: float) -> tuple[np.ndarray, np.ndarray]:
    """Points (P, 3) on the edges, in the middles of parts of at most ``spacing``, and the length of each part (P,)."""
    a, b = vertices[edges[:, 0]], vertices[edges[:, 1]]
    length = np.linalg.norm(b - a, axis=1)
    if not length.sum() > 0:  # a curve without length is its nodes
        return vertices, np.ones(len(vertices))
    count = np.maximum(1, np.ceil(length / spacing)).astype(np.int64)
    edge = np.repeat(np.arange(len(edges)), count)
    t = (np.arange(len(edge)) - np.repeat(np.cumsum(count) - count, count) + 0.5) / count[edge]
    return a[edge] + t[:, None] * (b - a)[edge], length[edge] / count[edge]


def curve_distance(points: np.ndarray, vertices: np.ndarray, edges: np.ndarray) -> np.ndarray:
    """Distance (P,) from each point to the nearest edge of a curve; to the nearest node of one without edges."""
    if not len(edges):
        edges = np.repeat(np.arange(len(vertices))[:, None], 2, axis=1)
    a, b = vertices[edges[:, 0]], vertices[edges[:, 1]]
    along = b - a
    length2 = np.maximum((along**2).sum(axis=1), 1e-300)
    best = np.empty(len(points))
    stride = max(1, PAIRS_AT_ONCE // len(edges))
    for start in range(0, len(points), stride):
        offset = points[start : start + stride, None] - a
        t = np.clip(np.einsum("pei,ei->pe", offset, along) / length2, 0, 1)
        best[start : start + stride] = np.linalg.norm(offset - t[..., None] * along, axis=2).min(axis=1)
    return best


def _curve_of(skeleton: Any) -> tuple[np.ndarray, np.ndarray]:
    is_whole = hasattr(skeleton, "vertices") and hasattr(skeleton, "edges")
    try:
        vertices, edges = (skeleton.vertices, skeleton.edges) if is_whole else skeleton
        vertices, edges = np.asarray(vertices, dtype=np.float64), np.asarray(edges)
        edges = edges.reshape(0, 2) if edges.size == 0 else edges
    except (TypeError, ValueError):
        raise MeshError(f"{type(skeleton).__name__} is no curve: expected a Skeleton or (vertices, edges)") from None
    if edges.ndim != 2 or edges.shape[1] != 2:
        raise MeshError(f"edges of the curve have shape {edges.shape}: expected (E, 2)")
    if vertices.ndim != 2 or vertices.shape[1] != 3 or not len(vertices) or not np.isfinite(vertices).all():
        raise MeshError(f"vertices of the curve have shape {vertices.shape}: expected (N, 3) finite numbers, N > 0")
    if len(edges) and (edges.dtype.kind not in "iu" or edges.min() < 0 or edges.max() >= len(vertices)):
        raise MeshError(f"edges of the curve: expected whole numbers from 0 to {len(vertices) - 1}")
    edges = np.sort(edges.astype(np.int64), axis=1)
    return vertices, np.unique(edges[edges[:, 0] < edges[:, 1]], axis=0).reshape(-1, 2)


def _off_centre(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray) -> float:
    a, b = vertices[edges[:, 0]], vertices[edges[:, 1]]
    length = np.linalg.norm(b - a, axis=1)
    a, b, length = a[length > 0], b[length > 0], length[length > 0]
    if not len(length):
        return float("nan")
    middle = (a + b) / 2
    found = sections.cut(shape, middle, unit(b - a), shape.distances(middle))
    is_found = found.is_found & (found.radius > 0) & (found.radius < LOPSIDED * shape.distances(found.centroid))
    if not is_found.any():
        return float("nan")
    off = np.linalg.norm(found.centroid - middle, axis=1)[is_found] / found.radius[is_found]
    return float((off * length[is_found]).sum() / max(length[is_found].sum(), 1e-300))


def _missed(shape: Enclosure, vertices: np.ndarray, radii: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Distance from points of the surface to the nearest ball, and the area that each point stands for."""
    a, b, c = np.moveaxis(shape.triangles, 1, 0)
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
    count = np.maximum(1, np.round(SURFACE_SAMPLES * area / area.sum())).astype(np.int64)
    face = np.repeat(np.arange(len(area)), count)
    number = np.arange(len(face)) - np.repeat(np.cumsum(count) - count, count)
    # An even spread over the triangle: the plastic number's sequence (Roberts 2018), folded over the diagonal.
    s, t = (1 / 3 + 0.7548776662466927 * number) % 1, (1 / 3 + 0.5698402909980532 * number) % 1
    s, t = np.where(s + t > 1, 1 - s, s)[:, None], np.where(s + t > 1, 1 - t, t)[:, None]
    points = (1 - s - t) * a[face] + s * b[face] + t * c[face]
    missed = np.empty(len(points))
    stride = max(1, PAIRS_AT_ONCE // len(vertices))
    for start in range(0, len(points), stride):
        away = np.linalg.norm(points[start : start + stride, None] - vertices, axis=2) - radii
        missed[start : start + stride] = np.maximum(away.min(axis=1), 0)
    return missed, area[face] / count[face]


def _smoothness(vertices: np.ndarray, ways: list[list[int]]) -> float:
    cosines = []
    for way in ways:
        along = arc_length(vertices[way])
        points = at(vertices[way], along, np.linspace(0, along[-1], max(2, round(along[-1] / STRIDE) + 1)))
        steps = unit(np.diff(points, axis=0))
        cosines.append(np.einsum("ij,ij->i", steps[1:], steps[:-1]))
    turns = np.concatenate(cosines)
    return float(turns.mean()) if len(turns) else 1.0


def _tip_gap(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray, ways: list[list[int]]) -> float:
    degree = np.bincount(edges.ravel(), minlength=len(vertices))
    tips, backs, limbs = [], [], []
    for way in ways:
        for nodes in (way, way[::-1]):
            if degree[nodes[0]] == 1:
                points = vertices[nodes]
                along = arc_length(points)
                back = np.linspace(0, along[-1], 65)
                fits = shape.distances(at(points, along, back)) <= back  # once it does, it does farther on
                back = back[fits.argmax()] if fits.any() else along[-1]
                inner = at(points, along, np.array([back]))
                tips.append(points[0])
                backs.append(inner[0])
                limbs.append(max(float(shape.distances(inner)[0]), 1e-9))
    is_inside = shape.contains(np.array(tips).reshape(-1, 3))
    if not is_inside.any():
        return float("nan")
    start, radius = np.array(tips), np.array(limbs)
    ahead = shape.ray_lengths(start, unit(start - np.array(backs)), 8 * radius)
    return float((ahead / radius)[is_inside].mean())
