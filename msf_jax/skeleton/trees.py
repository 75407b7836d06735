"""Curves as trees, as in neuroscience: cutting loops, joining pieces, choosing a root, finding the soma."""

import numbers
from dataclasses import replace
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from scipy import spatial

from msf_jax.base.errors import ConfigError
from msf_jax.curve import branches, finishing
from msf_jax.skeleton import changes
from msf_jax.topology import graphs

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton

SOMA_REACH = 4.0  # radii of the thickest ball: nodes within this distance may belong to the soma
STANDS_OUT = 1.5  # least ratio of a soma's radius to the largest radius farther away
THICK = 4.0  # least ratio of a soma's radius to the median radius


class Soma(NamedTuple):
    """The thickest place of a curve. node, radius: its node and radius. contrast: its radius over the largest radius
    farther away. is_sure: whether it stands out enough to be a soma; some meshes have no soma, or only its fibre."""

    node: int
    radius: float
    contrast: float
    is_sure: bool


def soma_of(vertices: np.ndarray, balls: np.ndarray) -> Soma:
    """The soma of a curve with nodes ``vertices`` (N, 3) and ``balls`` (N,), the radii of inscribed balls."""
    node = int(balls.argmax())
    is_elsewhere = np.linalg.norm(vertices - vertices[node], axis=1) > SOMA_REACH * balls[node]
    radius, elsewhere = float(balls[node]), float(balls[is_elsewhere].max(initial=0.0))
    contrast = radius / elsewhere if elsewhere > 0 else np.inf
    is_sure = bool(elsewhere > 0 and contrast >= STANDS_OUT and radius >= THICK * np.median(balls))
    return Soma(node, radius, contrast, is_sure)


def tree_of(skeleton: "Skeleton", root: Any) -> "Skeleton":
    """See `Skeleton.to_tree`."""
    num, why = len(skeleton.vertices), ""
    if isinstance(root, str) and root == "soma":
        soma = skeleton.soma()
        root = soma.node
        stands = f"{soma.contrast:.3g} times as thick as the thickest elsewhere"
        why = f" (the soma: {stands})" if soma.is_sure else f" (the thickest; NOT SURE to be the soma: {stands})"
    if np.shape(root) == (3,) and np.asarray(root).dtype.kind in "fiu" and np.isfinite(root).all():
        root = int(np.linalg.norm(skeleton.vertices - np.asarray(root), axis=1).argmin())
    is_node = isinstance(root, numbers.Integral) and not isinstance(root, bool) and 0 <= int(root) < num
    if root is not None and not is_node:
        raise ConfigError(
            f'root is {root!r}: expected a node from 0 to {num - 1}, "soma", or None for the thickest node, or '
            "a point (x, y, z)"
        )
    stays = branches.cut_loops(num, skeleton.edges, skeleton.radii)
    edges, gone = skeleton.edges[stays], skeleton.radii[skeleton.edges[~stays]].min(axis=1)
    roots = branches.roots_of(num, edges, skeleton.radii, None if root is None else int(root))
    where = f", at radii of {gone.min():.3g} to {gone.max():.3g}" if len(gone) else ""
    loops = f"{len(gone)} {'loop' if len(gone) == 1 else 'loops'}"
    place = f"root at node {roots[0]}, of radius {skeleton.radii[roots[0]]:.3g}{why}"
    report = replace(
        skeleton.report,
        cycles=0,
        loops=None if skeleton.report.loops is None else 0,
        cut=skeleton.report.cut + len(gone),
        is_tree=True,
        inside=changes.inside_of(skeleton, skeleton.vertices, edges, skeleton.radii),
        notes=(*skeleton.report.notes, f"a tree: {loops} cut where thinnest{where}; {place}"),
        figures={},
    )
    return replace(skeleton, edges=edges, report=report, roots=roots)


def healed(skeleton: "Skeleton", reach: float) -> "Skeleton":
    """See `Skeleton.heal`."""
    if not (isinstance(reach, numbers.Real) and not isinstance(reach, bool) and float(reach) > 0):
        raise ConfigError(f"reach is {reach!r}: expected a length above 0")
    links = _links(skeleton.vertices, skeleton.edges, float(reach))
    if not len(links):
        return skeleton
    edges = finishing.in_order(np.concatenate([skeleton.edges, links]))
    gap = np.linalg.norm(skeleton.vertices[links[:, 0]] - skeleton.vertices[links[:, 1]], axis=1)
    components, cycles = graphs.cycle_count(len(skeleton.vertices), edges)
    count = f"{len(links)} {'piece was' if len(links) == 1 else 'pieces were'} joined to the rest"
    report = replace(
        skeleton.report,
        components=components,
        mesh_components=max(skeleton.report.mesh_components - len(links), 1),
        cycles=cycles,
        inside=changes.inside_of(skeleton, skeleton.vertices, edges, skeleton.radii),
        notes=(*skeleton.report.notes, f"healed: {count}, over gaps of up to {gap.max():.3g}, outside the mesh"),
        figures={},
    )
    return replace(skeleton, edges=edges, report=report, roots=skeleton.roots[:1])


def _links(vertices: np.ndarray, edges: np.ndarray, reach: float) -> np.ndarray:
    """(K, 2) shortest edges that join pieces within ``reach`` of each other, by Prim's algorithm from the piece with
    most nodes."""
    num = len(vertices)
    label = graphs.labels(num, *edges.T)
    left = np.ones(label.max() + 1, dtype=bool)
    away, nearest = np.full(num, np.inf), np.full(num, -1)
    links, piece = [], int(np.bincount(label).argmax())
    while True:
        left[piece] = False
        outside = np.flatnonzero(left[label])
        if not len(outside):
            break
        mine = np.flatnonzero(label == piece)
        distance, k = map(np.asarray, spatial.KDTree(vertices[mine]).query(vertices[outside]))
        is_nearer = distance < away[outside]
        away[outside[is_nearer]], nearest[outside[is_nearer]] = distance[is_nearer], mine[k[is_nearer]]
        node = outside[away[outside].argmin()]
        if away[node] <= reach:
            links.append((nearest[node], node))
            piece = int(label[node])
        else:  # the remaining pieces may still be near each other
            piece = int(np.bincount(label[outside]).argmax())
            away[:] = np.inf
    return np.sort(np.array(links, dtype=np.int64).reshape(-1, 2), axis=1)
