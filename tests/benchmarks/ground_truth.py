"""Closed meshes whose curve skeleton is known, because they are built around it. Skeletons are scored with them."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import combinations, pairwise, product
from typing import Literal

import numpy as np
import trimesh
from numpy.typing import ArrayLike
from scipy.spatial.transform import Rotation

from msf_jax import shapes

_TURN = Rotation.from_euler("zyx", [0.4, 0.7, 1.1]).as_matrix()  # limbs must not lie along the sampling grid's axes
CurveArrays = tuple[np.ndarray, np.ndarray, np.ndarray]  # points, edges, radii
Truth = tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray]  # points, edges, radii, tips, tip_radii


@dataclass(frozen=True, eq=False)
class KnownShape:
    """A closed mesh and the curve in its middle.

    The curve goes to the end of every limb, on the surface: to the pole of a rounded end, or the centre of a flat one.

    Attributes:
        name: as `make` takes it.
        mesh: closed, oriented outwards, in one piece.
        points: (N, 3) nodes of the true curve.
        edges: (E, 2) its edges.
        radii: (N,) radius of the limb at each node, smaller near an end, so that the ball stays inside: 0 at the tips.
            At a junction the inscribed ball may be larger.
        tips: (K, 3) ends of limbs, on the surface.
        tip_radii: (K,) radius of the limb at its end, while the node's is 0.
    """

    name: str
    mesh: trimesh.Trimesh
    points: np.ndarray
    edges: np.ndarray
    radii: np.ndarray
    tips: np.ndarray
    tip_radii: np.ndarray

    @property
    def genus(self) -> int:
        """Number of handles."""
        return 1 - int(self.mesh.euler_number) // 2

    @property
    def num_leaves(self) -> int:
        """Number of ends of limbs."""
        return len(self.tips)


def make(name: str) -> KnownShape:
    """The shape of that name in `BUILDERS`, built anew, and identical each time."""
    return replace(BUILDERS[name](), name=name)


def noisy(shape: KnownShape, amount: float, seed: int) -> KnownShape:
    """The shape with each vertex moved along its normal by Gaussian noise; the true curve is the same.

    ``amount`` is its standard deviation in diagonals of the bounding box.
    """
    shift = np.random.default_rng(seed).normal(0, amount * shape.mesh.scale, (len(shape.mesh.vertices), 1))
    mesh = trimesh.Trimesh(shape.mesh.vertices + shift * shape.mesh.vertex_normals, shape.mesh.faces, process=False)
    return replace(shape, name=f"{shape.name}_noisy", mesh=mesh)


def swept_tube(
    points: np.ndarray, radii: np.ndarray, sides: int, ends: Literal["flat", "round"] = "flat", *, closed: bool = False
) -> trimesh.Trimesh:
    """A tube along a smooth polyline, of nearly equilateral triangles; each ring is turned by half a side.

    Args:
        points, radii: (N, 3) and (N,), sampled more densely than the rings; if closed, the first point is not repeated.
        sides: vertices of a ring.
        ends: flat discs at the first and the last point, or half balls beyond them.
        closed: whether the last point is followed by the first, without ends.
    """
    if closed:
        points, radii = np.vstack([points, points[:1]]), np.append(radii, radii[0])
    step = 2 * np.pi / sides  # between vertices of a ring, in radii
    height = step * np.sqrt(3) / 2
    pieces = np.linalg.norm(np.diff(points, axis=0), axis=1) * (1 / radii[1:] + 1 / radii[:-1]) / 2
    pace = np.append(0.0, np.cumsum(pieces))  # length so far, in radii
    stop = np.linspace(0, pace[-1], max(4, round(pace[-1] / height) + 1))
    centres = np.stack([np.interp(stop, pace, points[:, k]) for k in range(3)], axis=1)
    radius = np.interp(stop, pace, radii)
    tangents = np.gradient(centres, axis=0, edge_order=2)
    if closed:
        tangents[[0, -1]] = centres[1] - centres[-2]
    tangents /= np.linalg.norm(tangents, axis=1)[:, None]
    u, v = _frames(tangents, np.cross(tangents[0], np.eye(3)[np.argmin(np.abs(tangents[0]))]))
    turn = np.arange(len(stop)) * step / 2
    if closed:  # the frame returns turned: distribute the angle missing to a whole number of sides over all rings
        surplus = turn[-1] + np.arctan2(u[-1] @ v[0], u[-1] @ u[0])
        shift = round(surplus / step)
        turn += stop / stop[-1] * (shift * step - surplus)
        return _skin(list(_ring(centres, u, v, radius, turn, sides)[:-1]), shift=shift)
    rings = list(_ring(centres, u, v, radius, turn, sides))
    depth = 1.0 if ends == "flat" else np.pi / 2  # from rim to pole along the cap, in radii
    layers = np.linspace(0, depth, max(1, round(depth / height)) + 1)[1:]
    shares, bulges = (1 - layers, 0 * layers) if ends == "flat" else (np.cos(layers), np.sin(layers))
    poles = []
    for end, sign in ((0, -1), (-1, 1)):
        beyond = centres[end] + sign * radius[end] * bulges[:, None] * tangents[end]
        counts = [sides, *(max(5, round(sides * share)) for share in shares[:-1])]
        turns = turn[end] + sign * np.cumsum(np.pi / np.array(counts))
        for k, count in enumerate(counts[1:]):
            ring = _ring(beyond[k], u[end], v[end], radius[end] * shares[k], turns[k], count)
            rings.insert(0 if sign < 0 else len(rings), ring)
        poles.append(beyond[-1])
    return _skin(rings, poles)


def _frames(tangents: np.ndarray, start: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """A rotation-minimising frame: two unit normals (T, 3) to each tangent, the first normal along ``start``."""
    u = np.empty_like(tangents)
    for k, tangent in enumerate(tangents):
        start = start - (start @ tangent) * tangent
        start = u[k] = start / np.linalg.norm(start)
    return u, np.cross(tangents, u)


def _ring(at: np.ndarray, u: np.ndarray, v: np.ndarray, radius: ArrayLike, turn: ArrayLike, num: int) -> np.ndarray:
    """The corners (..., num, 3) of regular polygons around ``at`` (..., 3), from u towards v."""
    angle = np.asarray(turn)[..., None, None] + 2 * np.pi * np.arange(num)[:, None] / num
    spoke = np.cos(angle) * u[..., None, :] + np.sin(angle) * v[..., None, :]
    return at[..., None, :] + np.asarray(radius)[..., None, None] * spoke


def _skin(rings: Sequence[np.ndarray], poles: Sequence[np.ndarray] = (), *, shift: int = 0) -> trimesh.Trimesh:
    """The surface through rings, each half a side ahead of the one before, closed by two poles or by the first ring."""
    start = np.cumsum([0] + [len(ring) for ring in rings])
    numbers = [np.arange(a, b) for a, b in pairwise(start)]
    if poles:
        faces = [_fan(numbers[0][::-1], start[-1]), _fan(numbers[-1], start[-1] + 1)]
    else:
        faces = [_bridge(numbers[-1], np.roll(numbers[0], -shift))]
    faces += [_bridge(a, b) for a, b in pairwise(numbers)]
    return trimesh.Trimesh(np.vstack([*rings, *poles]), np.concatenate(faces), process=False)


def _fan(ring: np.ndarray, pole: int) -> np.ndarray:
    return np.stack([ring, np.roll(ring, -1), np.full(len(ring), pole)], axis=1)


def _bridge(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    """Triangles between two rings of vertices, whose numbers may differ."""
    m, n = len(first), len(second)
    order = np.argsort(np.append((2 * np.arange(m) + 1) * n, 2 * np.arange(1, n + 1) * m), kind="stable")
    is_first = order < m  # advance on the ring that is behind
    i, j = np.cumsum(is_first) - is_first, np.cumsum(~is_first) - ~is_first
    ahead = np.where(is_first, first[(i + 1) % m], second[(j + 1) % n])
    return np.stack([first[i % m], ahead, second[j % n]], axis=1)


_T = np.linspace(0, 1, 401)
_A, _B = 2 * np.pi * _T, 4 * np.pi * _T
_LINES = {  # x, y, z; closed lines return to their first point
    "straight": (2.2 * _T, 0 * _T, 0 * _T),
    "arc": (0.8 * np.cos(3.6 * _T), 0.8 * np.sin(3.6 * _T), 0 * _T),
    "helix": (0.5 * np.cos(13 * _T), 0.5 * np.sin(13 * _T), 1.3 * _T),
    "s_curve": (2.2 * _T, 0.4 * np.sin(_A), 0 * _T),
    "ring": (0.7 * np.cos(_A), 0.7 * np.sin(_A), 0 * _T),
    "trefoil": (0.8 * np.sin(_B) + 0.4 * np.sin(_A), 0.8 * np.cos(_B) - 0.4 * np.cos(_A), 0.4 * np.sin(_A + _B)),
}


def swept(line: str, size: ArrayLike, sides: int, ends: Literal["flat", "round", "none"] = "flat") -> KnownShape:
    """A tube along a line; its radius is one number, or one at each point."""
    closed = ends == "none"
    num = len(_T) - closed
    points, radii = (np.stack(_LINES[line], axis=1) @ _TURN.T)[:num], np.broadcast_to(size, len(_T))[:num]
    edges = np.stack([np.arange(num), np.arange(1, num + 1) % num], axis=1)[: len(_T) - 1]
    mesh = swept_tube(points, radii, sides, "flat" if closed else ends, closed=closed)
    truth = _to_surface((points, edges, radii))
    if ends == "flat":
        to_end = np.linalg.norm(points[:, None] - points[[0, -1]], axis=2).min(axis=1)
        truth = (points, edges, np.minimum(radii, to_end), points[[0, -1]], radii[[0, -1]])
    return KnownShape("", mesh, *truth)


def _to_surface(curve: CurveArrays, leaves: Sequence[int] | None = None) -> Truth:
    """The curve with its leaves (all, or ``leaves``) extended to the poles of their rounded ends."""
    points, edges, radii = curve
    leaf = np.flatnonzero(np.bincount(edges.ravel()) == 1) if leaves is None else np.array(leaves)
    before = np.array([edges[(edges == k).any(axis=1)][0].sum() - k for k in leaf], dtype=int)
    along = points[leaf] - points[before]
    tips = points[leaf] + radii[leaf, None] * along / np.linalg.norm(along, axis=1)[:, None]
    link = np.stack([leaf, len(points) + np.arange(len(leaf))], axis=1)
    nodes, sizes = np.vstack([points, tips]), np.append(radii, np.zeros(len(leaf)))
    return nodes, np.vstack([edges, link]), sizes, tips, radii[leaf]


def graph_of(*paths: ArrayLike) -> CurveArrays:
    """The curve of paths of (x, y, z, radius), which meet where they have a node in common."""
    chains = [np.asarray(path, dtype=float) for path in paths]
    nodes, number = np.unique(np.round(np.concatenate(chains), 9), axis=0, return_inverse=True)
    chains = np.split(number.ravel(), np.cumsum([len(chain) for chain in chains])[:-1])
    edges = np.concatenate([np.stack([chain[:-1], chain[1:]], axis=1) for chain in chains])
    return nodes[:, :3], edges, nodes[:, 3]


def _polar(axial: float, angle: float, z: float, radius: float) -> tuple[float, float, float, float]:
    return (axial * np.cos(angle), axial * np.sin(angle), z, radius)


_THIRDS = 2 * np.pi * np.arange(3) / 3
_CORNERS = list(product((-0.6, 0.6), repeat=3))
_PATHS: dict[str, Sequence[ArrayLike]] = {
    "y": [[(0, 0, -1, 0.14), (0, 0, 0, 0.14), (0.75, 0, 0.75, 0.11)], [(0, 0, 0, 0.14), (-0.65, 0.15, 0.8, 0.11)]],
    "tee": [[(-1, 0, 0, 0.12), (0, 0, 0, 0.12), (1, 0, 0, 0.12)], [(0, 0, 0, 0.12), (0, 0, -1.1, 0.12)]],
    "tree": [
        [(0, 0, -0.9, 0.22), (0, 0, 0, 0.18)],
        *([(0, 0, 0, 0.18), _polar(0.75, a, 0.5, 0.14), _polar(1.22, a + 0.3, 0.7, 0.1)] for a in _THIRDS),
        *([_polar(0.75, a, 0.5, 0.14), _polar(1.24, a - 0.25, 0.95, 0.1)] for a in _THIRDS),
    ],
    "star": [
        [(0, 0, 0, 0.16), (x, y, z, 0.12)]
        for x, y, z in ((1, 0.2, 0), (-0.9, 0, 0.3), (0.1, 1.1, -0.2), (-0.2, -1, 0), (0, 0.1, 1.2), (0.2, -0.2, -1))
    ],
    "comb": [
        [(x, 0, 0, 0.13) for x in (-1.3, -0.9, -0.45, 0, 0.45, 0.9, 1.3)],
        *([(x, 0, 0, 0.13), (x, 0, 0.8, 0.11)] for x in (-0.9, -0.45, 0, 0.45, 0.9)),
    ],
    "theta": [[_polar(0.8 * np.sin(p), a, np.cos(p), 0.14) for p in np.linspace(0, np.pi, 13)] for a in _THIRDS],
    "cube_frame": [[(*a, 0.15), (*b, 0.15)] for a, b in combinations(_CORNERS, 2) if np.equal(a, b).sum() == 2],
}


def _around(paths: str, spacing: float) -> KnownShape:
    """A solid with rounded ends around paths."""
    points, edges, radii = graph_of(*_PATHS[paths])
    points = points @ _TURN.T
    # Triangles are chords of the true surface: with this addition, inscribed balls have about the true radius.
    mesh = shapes.solid_around(points, edges, radii + 0.2 * spacing**2 / radii, spacing)
    return KnownShape("", mesh, *_to_surface((points, edges, radii)))


def _octopus_low() -> KnownShape:
    """A ball with 16 meridians; every other square at its equator is the root of a limb with four sides."""
    x, y, up = _TURN.T
    layers = [(-60.0, 8), (-34.0, 16), (-11.25, 16), (11.25, 16), (34.0, 16), (60.0, 8)]  # latitude, vertices
    rings = [_ring(np.sin(np.radians(a)) * up, x, y, np.cos(np.radians(a)), 0.0, num) for a, num in layers]
    body = _skin(rings, [-up, up])
    parts, faces, paths = [], body.faces, []
    s = np.linspace(0, 1, 12)[:, None]
    for limb in range(8):
        root = 24 + 2 * limb + np.array([0, 1, 17, 16])  # 24 is the first vertex below the equator
        faces = faces[~np.isin(faces, root).all(axis=1)]
        centre = body.vertices[root].mean(axis=0)
        spoke, out = body.vertices[root[0]] - centre, centre / np.linalg.norm(centre)
        curl, tilt = np.radians([(75, -80), (250, -50), (-110, 70), (300, -110)][limb % 4])
        aside = np.cos(tilt) * np.cross(up, out) + np.sin(tilt) * up
        tangents = np.cos(curl * s**1.5) * out + np.sin(curl * s**1.5) * aside
        nodes = centre + 2.6 / 11 * np.cumsum(np.vstack([0 * out, (tangents[1:] + tangents[:-1]) / 2]), axis=0)
        radii = np.linalg.norm(spoke) * (1 - 0.75 * s)
        rings = _ring(nodes, *_frames(tangents, spoke), radii[:, 0], np.arange(12) * np.pi / 4, 4)
        along = nodes[-1] - nodes[-2]
        pole = nodes[-1] + radii[-1] * along / np.linalg.norm(along)  # as `_to_surface` has it
        tube = _skin([body.vertices[root], *rings[1:]], [centre, pole])
        parts.append((tube.vertices, tube.faces[4:]))  # without the lid on its root
        # The body's ball shrinks on its way out until it fits into the root.
        paths.append(np.vstack([[0, 0, 0, 1], [*(1 - radii[0]) * centre, *radii[0]], np.hstack([nodes, radii])]))
    mesh = trimesh.Trimesh(*trimesh.util.append_faces(*zip((body.vertices, faces), *parts, strict=True)), process=False)
    mesh.merge_vertices()
    return KnownShape("", mesh, *_to_surface(graph_of(*paths)))


def _pawn_low() -> KnownShape:
    """A surface of revolution with a broad foot, a collar and a round head; the truth is its axis."""
    u, v, axis = _TURN.T
    head = np.radians(np.linspace(-48, 90, 8))
    stem = [[0, 0.5, 0.5, 0.4, 0.26, 0.18, 0.16, 0.3, 0.3], [0, 0, 0.12, 0.2, 0.4, 0.65, 0.85, 0.9, 0.97]]
    profile = np.hstack([stem, [0.25 * np.cos(head), 1.2 + 0.25 * np.sin(head)]]).T  # radius, height
    edge, rings, turn = 0.097, [], 0.0
    for a, b in pairwise(profile):
        for radius, height in np.linspace(a, b, max(1, round(np.linalg.norm(b - a) / (0.87 * edge))), endpoint=False):
            count = max(6, round(2 * np.pi * radius / edge))
            rings.append(_ring(height * axis, u, v, radius, turn, count))
            turn += np.pi / count
    heights = np.linspace(0, profile[-1, 1], 100)
    points, edges = heights[:, None] * axis, np.stack([np.arange(99), np.arange(1, 100)], axis=1)
    outline = np.concatenate([np.linspace(a, b, 200) for a, b in pairwise(profile)])
    radii = np.linalg.norm(outline - np.stack([0 * heights, heights], axis=1)[:, None], axis=2).min(axis=1)
    mesh = _skin(rings[1:], list(points[[0, -1]]))
    return KnownShape("", mesh, points, edges, radii, points[[0, -1]], np.array([0.5, 0.25]))


def _sheet_and_limb() -> KnownShape:
    """A plate ten times as wide as thick, and a limb out of its edge; the truth is the limb, from that edge on."""
    spacing, radius, limb = 0.045, 0.11, np.array([[0.45, 0.1, 0], [1.3, 0.25, 0.35]])
    axis = np.arange(-1.6, 1.6, spacing)
    grid = np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), axis=-1)
    beyond = np.abs(grid @ _TURN) - (0.5, 0.5, 0.05)
    plate = np.linalg.norm(np.maximum(beyond, 0), axis=-1) + np.minimum(beyond.max(axis=-1), 0)
    along, offset = limb[1] - limb[0], grid @ _TURN - limb[0]
    t = np.clip(offset @ along / (along @ along), 0, 1)
    field = np.minimum(plate, np.linalg.norm(offset - t[..., None] * along, axis=-1) - radius)
    truth = _to_surface((limb @ _TURN.T, np.array([[0, 1]]), np.full(2, radius)), leaves=[1])
    return KnownShape("", shapes.level_set(field, grid[0, 0, 0], spacing), *truth)


BUILDERS: dict[str, Callable[[], KnownShape]] = {
    "straight": partial(swept, "straight", 0.12, 24),
    "arc": partial(swept, "arc", 0.12, 24),
    "helix": partial(swept, "helix", 0.1, 20),
    "s_curve": partial(swept, "s_curve", 0.12, 24),
    "straight_round": partial(swept, "straight", 0.12, 24, "round"),
    "taper": partial(swept, "straight", 0.21 - 0.14 * _T, 24, "round"),
    "wavy_radius": partial(swept, "straight", 0.13 + 0.03 * np.sin(2.5 * _A), 24, "round"),
    "ring": partial(swept, "ring", 0.14, 24, "none"),
    "trefoil": partial(swept, "trefoil", 0.14, 16, "none"),
    "y": partial(_around, "y", 0.05),
    "tee": partial(_around, "tee", 0.05),
    "tree": partial(_around, "tree", 0.072),
    "star": partial(_around, "star", 0.065),
    "comb": partial(_around, "comb", 0.065),
    "theta": partial(_around, "theta", 0.078),
    # The same hand as in the demo. The forearm's end is no leaf, because the handle starts there.
    "hand": lambda: KnownShape("", shapes.hand(), *_to_surface(shapes.hand_curve())),
    "cube_frame": partial(_around, "cube_frame", 0.096),
    "straight_coarse": partial(swept, "straight", 0.12, 6),
    "arc_coarse": partial(swept, "arc", 0.12, 6),
    "helix_coarse": partial(swept, "helix", 0.1, 6),
    "y_coarse": partial(_around, "y", 0.12),
    "tree_coarse": partial(_around, "tree", 0.11),
    "arc_fine": partial(swept, "arc", 0.12, 72),
    "y_fine": partial(_around, "y", 0.022),
    "straight_noisy": lambda: noisy(make("straight"), 0.005, 1),
    "y_noisy": lambda: noisy(make("y"), 0.0025, 2),  # more noise would fold its many short edges
    "ring_noisy": lambda: noisy(make("ring"), 0.005, 3),
    "octopus_low": _octopus_low,
    "pawn_low": _pawn_low,
    "sheet_and_limb": _sheet_and_limb,
}
