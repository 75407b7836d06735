"""Scores of a curve in its mesh (`evaluate`), for curves of any program, and of two curves (`compare`).

Lengths are fractions of the mesh's bounding-box diagonal, so that scores of different meshes can be compared.
"""

from typing import Any

import numpy as np

from msf_jax.base.errors import MeshError
from msf_jax.curve import handle_loops
from msf_jax.meshes import checking
from msf_jax.meshes.reading import MeshLike
from msf_jax.solid import sections
from msf_jax.solid.enclosure import Enclosure
from msf_jax.solid.geometry import arc_length, at, repeated, triangle_areas, unit
from msf_jax.solid.solid import Solid
from msf_jax.topology import graphs

SAMPLES_PER_EDGE = 16  # sample points on an edge that inscribed balls do not cover
SURFACE_SAMPLES = 20_000  # sample points on the surface, about; by area, and at least one on each face
LOPSIDED = 3.0  # ratio of a section's mean radius to the inscribed ball's, above which it is not that of a limb
STRIDE = 0.01  # diagonals: distance between the points of a branch at which its turning is measured
ALONG = 0.5  # least ratio of the distance from the foot to the point's own curve to that from the foot to the point
SAME = 1e-9  # diagonals: tolerance of these distances
PAIRS_AT_ONCE = 4_000_000  # pairs of a point and an edge or a node in memory at a time


def evaluate(mesh: "MeshLike", skeleton: Any, truth: Any = None) -> dict[str, float]:
    """Score a curve in its mesh.

    Args:
        mesh: as `skeletonize` takes it.
        skeleton: a `Skeleton`, anything with its ``vertices`` and ``edges``, or ``(vertices (N, 3), edges (E, 2))`` of
            any program, in the mesh's units.
        truth: another curve to measure the distance from and to, in either form; none if not given.

    Returns:
        A dictionary. Lengths are fractions of the mesh's bounding-box diagonal.

        - ``components``, ``cycles``, ``loops``, ``leaves``, ``mesh_components``, ``genus``: counts. A curve of the
          right topology has as many components as the mesh, and as many independent cycles as the sum of the genera.
          ``loops`` is the number of handles that the cycles go around; it should equal the genus, too.
        - ``inside``: fraction of the curve's length where the generalised winding number of the mesh is positive
          (Jacobson et al. 2013). Edges that the inscribed balls of their ends do not cover are sampled at the middles
          of 16 equal parts. 1 is best.
        - ``boundedness``: fraction of the nodes that are inside (Wen et al. 2025). 1 is best.
        - ``off_centre``: distance of an edge's middle from the centroid of the cross-section there, over the section's
          mean radius; the mean over edges, by length. A section more than three times as wide as the inscribed ball at
          its centroid is not that of a limb, and does not count; NaN if none counts. 0 is best (centredness, Cornea et
          al. 2007).
        - ``missed_95``, ``missed_max``: distance from a point of the surface to the union of the nodes' inscribed
          balls: the 95th percentile by area, and the maximum. 0 is best (reconstruction, Cornea et al. 2007).
        - ``smoothness``: mean cosine of the angle between successive steps of one hundredth of the diagonal along a
          branch. 1 is best (Wen et al. 2025, who use neighbouring points).
        - ``tip_gap``: distance from a leaf straight on to the surface, over the inscribed radius one such radius back:
          1 for a curve that ends at the centre of a round end; at most 8. The mean over the leaves that are inside; NaN
          without such leaves.
        - ``length``: of the curve.
        - with ``truth``: ``to_truth_mean``, ``to_truth_max``, ``from_truth_mean``, ``from_truth_max``: distance from
          the curve to the truth and back, by length.

    Raises:
        MeshError: the mesh is refused at validation, or ``skeleton`` is no valid curve.
    """
    checked = checking.prepare(mesh)
    solid = Solid(checked.vertices, checked.faces)
    vertices, edges = _curve_of(skeleton)
    figures = {"mesh_components": len(checked.components), "genus": checked.genus}
    figures |= figures_of(solid.shape, solid.enter(vertices), edges)
    if truth is not None:
        other, other_edges = _curve_of(truth)
        ours, theirs = (solid.enter(vertices), edges), (solid.enter(other), other_edges)
        for name, (start, end) in {"to_truth": (ours, theirs), "from_truth": (theirs, ours)}.items():
            points, weight, _ = sample_curve(*start, 0.001)  # diagonals
            distance = curve_distance(points, *end)
            figures[f"{name}_mean"] = float((distance * weight).sum() / weight.sum())
            figures[f"{name}_max"] = float(distance.max())
    return figures


def compare(mesh: "MeshLike", skeleton: Any, other: Any) -> dict[str, float]:
    """Score two curves of a mesh on the part that both cover, so that missing branches improve no score.

    A point of a curve is common if its foot, the nearest point on the other curve, is within the larger of the
    inscribed balls at both, and if the foot is not much nearer to another part of the point's own curve. So a side
    branch that only one curve has is not common. A point of the surface is common if the node with the nearest
    inscribed ball is common, in both curves.

    Args:
        mesh: as `skeletonize` takes it.
        skeleton, other: two curves, in any form that `evaluate` takes.

    Returns:
        A dictionary, with the figures of ``other`` under the same names with ``other_`` before them.

        - ``common``: fraction of the curve's length that is common.
        - ``off_centre``: as in `evaluate`, over the common part, with a section every hundredth of the diagonal.
        - ``missed_95``: as in `evaluate`, over the common part of the surface.

        Figures are NaN if nothing is common, or nothing of it can be measured.

    Raises:
        MeshError: the mesh is refused at validation, or a curve is not valid.
    """
    checked = checking.prepare(mesh)
    solid = Solid(checked.vertices, checked.faces)
    shape = solid.shape
    one, two = ((solid.enter(vertices), edges) for vertices, edges in (_curve_of(skeleton), _curve_of(other)))
    figures, missed, is_common = {}, {}, np.array(True)
    for name, own, its in (("", one, two), ("other_", two, one)):
        points, length, along = sample_curve(*own, STRIDE)
        runs = _runs_along(shape, points, own, its)
        figures[f"{name}common"] = float(length[runs].sum() / length.sum())
        is_measured = runs & along.any(axis=1)
        figures[f"{name}off_centre"] = _off_centre(shape, points[is_measured], along[is_measured], length[is_measured])
        radii = np.where(shape.contains(own[0]), shape.distances(own[0]), 0.0)
        missed[name], node, area = _missed(shape, own[0], radii)
        is_common = is_common & _runs_along(shape, own[0], own, its)[node]
        figures[f"{name}missed_95"] = np.nan
    for name in missed if is_common.any() else ():
        figures[f"{name}missed_95"] = _by_area(missed[name][is_common], area[is_common])
    return figures


def figures_of(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray) -> dict[str, float]:
    """The figures of `evaluate` that need only the curve and a surface of diagonal 1."""
    is_inside = shape.contains(vertices)
    radii = np.where(is_inside, shape.distances(vertices), 0.0)
    components, cycles = graphs.cycle_count(len(vertices), edges)
    missed, _, area = _missed(shape, vertices, radii)
    proof = handle_loops.proof(shape, vertices, edges)
    paths = graphs.trace(len(vertices), edges)
    middles, parts, along = sample_curve(vertices, edges, np.inf)  # a part for each edge
    is_long = along.any(axis=1)
    return {
        "components": components,
        "cycles": cycles,
        "loops": np.nan if proof.unproved else proof.rank,
        "leaves": int((np.bincount(edges.ravel(), minlength=len(vertices)) == 1).sum()),
        "inside": inside_fraction(shape, vertices, edges, radii),
        "boundedness": float(is_inside.mean()),
        "off_centre": _off_centre(shape, middles[is_long], along[is_long], parts[is_long]),
        "missed_95": _by_area(missed, area),
        "missed_max": float(missed.max()),
        "smoothness": _smoothness(vertices, paths),
        "tip_gap": _tip_gap(shape, vertices, edges, paths),
        "length": float(parts[is_long].sum()),
    }


def inside_fraction(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray, radii: np.ndarray) -> float:
    """Fraction of the length of the curve ``(vertices (N, 3), edges (E, 2))`` that is inside the surface ``shape``; of
    the nodes, if it has no length. An edge that the balls of ``radii`` (N,) around its ends cover is inside; other
    edges are sampled at the middles of 16 equal parts, inside where the winding number is positive."""
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


def sample_curve(vertices: np.ndarray, edges: np.ndarray, spacing: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Points (P, 3) on the edges, in the middles of parts of at most ``spacing``; the length (P,) of each part, and its
    direction (P, 3), 0 where it has no length."""
    a, b = vertices[edges[:, 0]], vertices[edges[:, 1]]
    length = np.linalg.norm(b - a, axis=1)
    if not length.sum() > 0:  # a curve without length is sampled at its nodes
        return vertices, np.ones(len(vertices)), np.zeros_like(vertices)
    count = np.maximum(1, np.ceil(length / spacing)).astype(np.int64)
    edge, number = repeated(count)
    t = (number + 0.5) / count[edge]
    return a[edge] + t[:, None] * (b - a)[edge], length[edge] / count[edge], unit(b - a)[edge]


def curve_distance(points: np.ndarray, vertices: np.ndarray, edges: np.ndarray) -> np.ndarray:
    """Distance (P,) from each point to the nearest edge of a curve, or to the nearest node if it has no edges."""
    return np.linalg.norm(points - _feet(points, vertices, edges), axis=1)


def _feet(points: np.ndarray, vertices: np.ndarray, edges: np.ndarray) -> np.ndarray:
    """The nearest point (P, 3) on a curve for each of ``points``."""
    if not len(edges):
        edges = np.repeat(np.arange(len(vertices))[:, None], 2, axis=1)
    a, b = vertices[edges[:, 0]], vertices[edges[:, 1]]
    along = b - a
    length2 = np.maximum((along**2).sum(axis=1), 1e-300)
    found = np.empty_like(points)
    stride = max(1, PAIRS_AT_ONCE // len(edges))
    for start in range(0, len(points), stride):
        offset = points[start : start + stride, None] - a
        t = np.clip(np.einsum("pei,ei->pe", offset, along) / length2, 0, 1)
        nearest = np.linalg.norm(offset - t[..., None] * along, axis=2).argmin(axis=1)
        share = t[np.arange(len(nearest)), nearest]
        found[start : start + stride] = a[nearest] + share[:, None] * along[nearest]
    return found


def _runs_along(
    shape: Enclosure, points: np.ndarray, own: tuple[np.ndarray, np.ndarray], other: tuple[np.ndarray, np.ndarray]
) -> np.ndarray:
    """(P,) whether each point of a curve is common with the other curve, see `compare`."""
    foot = _feet(points, *other)
    away = np.linalg.norm(points - foot, axis=1)
    clearance = np.maximum(*(np.where(shape.contains(place), shape.distances(place), 0.0) for place in (points, foot)))
    return (away <= clearance + SAME) & (curve_distance(foot, *own) >= ALONG * away - SAME)


def _curve_of(skeleton: Any) -> tuple[np.ndarray, np.ndarray]:
    try:
        vertices, edges = (skeleton.vertices, skeleton.edges) if hasattr(skeleton, "edges") else skeleton
        vertices, edges = np.asarray(vertices, dtype=np.float64), np.asarray(edges)
        edges = edges.reshape(0, 2) if edges.size == 0 else edges
    except (AttributeError, TypeError, ValueError):
        raise MeshError(f"{type(skeleton).__name__} is no curve: expected a Skeleton or (vertices, edges)") from None
    if edges.ndim != 2 or edges.shape[1] != 2:
        raise MeshError(f"edges of the curve have shape {edges.shape}: expected (E, 2)")
    if vertices.ndim != 2 or vertices.shape[1] != 3 or not len(vertices) or not np.isfinite(vertices).all():
        raise MeshError(f"vertices of the curve have shape {vertices.shape}: expected (N, 3) finite numbers, N > 0")
    if len(edges) and (edges.dtype.kind not in "iu" or edges.min() < 0 or edges.max() >= len(vertices)):
        raise MeshError(f"edges of the curve are no ids of nodes: expected whole numbers from 0 to {len(vertices) - 1}")
    edges = np.sort(edges.astype(np.int64), axis=1)
    return vertices, np.unique(edges[edges[:, 0] < edges[:, 1]], axis=0).reshape(-1, 2)


def _off_centre(shape: Enclosure, points: np.ndarray, along: np.ndarray, length: np.ndarray) -> float:
    """``off_centre`` of ``points`` (P, 3) on a curve with directions ``along`` (P, 3), weighted by ``length`` (P,)."""
    if not len(points):
        return float("nan")
    found = sections.cut(shape, points, along, shape.distances(points))
    is_found = found.is_found & (found.radius > 0) & (found.radius < LOPSIDED * shape.distances(found.centroid))
    if not is_found.any():
        return float("nan")
    off = np.linalg.norm(found.centroid - points, axis=1)[is_found] / found.radius[is_found]
    return float((off * length[is_found]).sum() / max(length[is_found].sum(), 1e-300))


def _by_area(missed: np.ndarray, area: np.ndarray) -> float:
    """The 95th percentile by area: few points, such as corners, do not decide."""
    return float(np.quantile(missed, 0.95, weights=area, method="inverted_cdf"))


def _missed(shape: Enclosure, vertices: np.ndarray, radii: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """For sample points (S,) of the surface: distance to the nearest ball, its node, and the area of the point."""
    (a, b, c), area = np.moveaxis(shape.triangles, 1, 0), triangle_areas(shape.triangles)
    count = np.maximum(1, np.round(SURFACE_SAMPLES * area / area.sum())).astype(np.int64)
    face, number = repeated(count)
    # Evenly spread points in a triangle: the plastic number's sequence (Roberts 2018), folded over the diagonal.
    s, t = (1 / 3 + 0.7548776662466927 * number) % 1, (1 / 3 + 0.5698402909980532 * number) % 1
    s, t = np.where(s + t > 1, 1 - s, s)[:, None], np.where(s + t > 1, 1 - t, t)[:, None]
    points = (1 - s - t) * a[face] + s * b[face] + t * c[face]
    missed, node = np.empty(len(points)), np.empty(len(points), dtype=np.int64)
    stride = max(1, PAIRS_AT_ONCE // len(vertices))
    for start in range(0, len(points), stride):
        away = np.linalg.norm(points[start : start + stride, None] - vertices, axis=2) - radii
        node[start : start + stride] = away.argmin(axis=1)
        missed[start : start + stride] = np.maximum(away.min(axis=1), 0)
    return missed, node, area[face] / count[face]


def _smoothness(vertices: np.ndarray, paths: list[list[int]]) -> float:
    cosines = []
    for path in paths:
        along = arc_length(vertices[path])
        points = at(vertices[path], along, np.linspace(0, along[-1], max(2, round(along[-1] / STRIDE) + 1)))
        steps = unit(np.diff(points, axis=0))
        cosines.append(np.einsum("ij,ij->i", steps[1:], steps[:-1]))
    turns = np.concatenate(cosines)
    return float(turns.mean()) if len(turns) else 1.0


def _tip_gap(shape: Enclosure, vertices: np.ndarray, edges: np.ndarray, paths: list[list[int]]) -> float:
    degree = np.bincount(edges.ravel(), minlength=len(vertices))
    tips, backs, limbs = [], [], []
    for path in paths:
        for nodes in (path, path[::-1]):
            if degree[nodes[0]] == 1:
                points = vertices[nodes]
                along = arc_length(points)
                back = np.linspace(0, along[-1], 65)
                fits = shape.distances(at(points, along, back)) <= back  # True from the first such point on
                back = back[fits.argmax()] if fits.any() else along[-1]
                inner = at(points, along, np.array([back]))
                tips.append(points[0])
                backs.append(inner[0])
                limbs.append(max(float(shape.distances(inner)[0]), 1e-9))  # diagonals: it is divided by
    is_inside = shape.contains(np.array(tips).reshape(-1, 3))
    if not is_inside.any():
        return float("nan")
    start, radius = np.array(tips), np.array(limbs)
    ahead = shape.ray_lengths(start, unit(start - np.array(backs)), 8 * radius)
    return float((ahead / radius)[is_inside].mean())
