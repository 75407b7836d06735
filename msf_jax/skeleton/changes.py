"""Other curves of the same mesh: pruned, with other nodes, smoothed, with radii of another kind; and trees, as in
neuroscience: loops cut, pieces joined, a root chosen, the soma found."""

import numbers
from dataclasses import replace
from itertools import pairwise
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from scipy import spatial

from msf_jax import metrics
from msf_jax.base.errors import ConfigError
from msf_jax.curve import branches, finishing, resampling
from msf_jax.inside import containment
from msf_jax.limbs import one_branch
from msf_jax.limbs.caps import Caps
from msf_jax.skeleton import centrelines
from msf_jax.skeleton.report import assessed
from msf_jax.skeleton.source import known
from msf_jax.topology import graphs

if TYPE_CHECKING:
    from msf_jax.skeleton.skeleton import Skeleton

NEAREST = 16  # nearest old nodes whose balls bound the radius of a new node, if the solid is not known
TRIED = 0.1  # share of the tolerance of `simplified`, within which nodes are tried
MOST_NODES = 10_000_000  # most nodes of a resampled curve; a spacing that gives more is in a wrong unit
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


def changed(skeleton: "Skeleton", vertices: np.ndarray, edges: np.ndarray, node_of_old: np.ndarray) -> "Skeleton":
    """A skeleton of the same mesh with another curve, and an updated report.

    ``node_of_old`` (N,) is the new node for each node of ``skeleton``.
    """
    edges, mesh_map, source = finishing.in_order(edges), node_of_old[skeleton.mesh_map], skeleton.source
    components, cycles = graphs.cycle_count(len(vertices), edges)
    report = replace(skeleton.report, components=components, cycles=cycles, loops=None, figures={})
    if source is not None:
        solid, vertex = source.solid, source.input_of_vertex
        radii = solid.radii(vertices)
        followed = None if vertex is None else mesh_map[vertex]
        report = replace(report, **assessed(solid.shape, solid.enter(vertices), edges, followed, report.wavefronts > 0))
        report = replace(report, inside=_share_inside(skeleton, vertices, edges, radii))
    else:  # radius of the largest ball inside one of the old balls
        nearest = spatial.KDTree(skeleton.vertices).query(vertices, k=min(NEAREST, len(skeleton.radii)))
        away, near = (np.reshape(each, (len(vertices), -1)) for each in nearest)
        radii = np.maximum((skeleton.radii[near] - away).max(axis=1), 0.0)
    roots, openings = (tuple(node_of_old[list(nodes)].tolist()) for nodes in (skeleton.roots, skeleton.openings))
    curve = {"vertices": vertices, "edges": edges, "radii": radii, "mesh_map": mesh_map, "report": report}
    result = replace(skeleton, **curve, roots=roots, openings=openings, radius_of="ball")
    return result if source is None else with_radii(result, skeleton.radius_of, result.radii)


def _share_inside(skeleton: "Skeleton", vertices: np.ndarray, edges: np.ndarray, radii: np.ndarray) -> float:
    """The fraction of a curve's length inside the skeleton's mesh; the report's if the mesh is not known."""
    if skeleton.source is None:
        return skeleton.report.inside
    solid = skeleton.source.solid
    return metrics.inside_fraction(solid.shape, solid.enter(vertices), edges, radii / solid.diagonal)


def _pinned(skeleton: "Skeleton") -> np.ndarray:
    """(N,) True for the node of a pinned vertex of the mesh."""
    is_pinned = np.zeros(len(skeleton.vertices), dtype=bool)
    if skeleton.source is not None:
        is_pinned[skeleton.mesh_map[skeleton.source.pins]] = True
    return is_pinned


def _check_length(name: str, value: Any, most: float = np.inf) -> None:
    if isinstance(value, bool) or not (isinstance(value, numbers.Real) and 0 < float(value) <= most):
        raise ConfigError(f"{name} is {value!r}: expected a length above 0")


def pruned(skeleton: "Skeleton", slenderness: float, detail: float | None) -> "Skeleton":
    """See `Skeleton.prune`."""
    if not (isinstance(slenderness, numbers.Real) and float(slenderness) >= 0):
        raise ConfigError(f"slenderness is {slenderness!r}: expected a number of 0 or more")
    if not (detail is None or (isinstance(detail, numbers.Real) and 0 <= float(detail) <= 1)):
        raise ConfigError(f"detail is {detail!r}: expected a number from 0 to 1")
    x, edges, least, is_pinned = skeleton.vertices, skeleton.edges, float(slenderness), _pinned(skeleton)
    report, num, grown = skeleton.report, len(skeleton.vertices), 0
    if skeleton.source is not None and not report.wavefronts and least:
        solid = skeleton.source.solid
        caps = Caps(solid.outside) if detail is None else Caps(solid.outside, float(detail))
        choice = one_branch.choose(caps, solid.shape, solid.enter(x), edges, is_pinned, least)
        if detail is not None and (grown := choice.leaf.count(-1)):
            new, edges = one_branch.grown(solid.shape, solid.enter(x), edges, choice)
            new, edges = containment.contain(solid.shape, new, edges, np.pad(is_pinned, (0, len(new) - num)))
            x = np.concatenate([x, solid.leave(new[num:])])
        added = 0, len(x) - num
        worth = np.pad(choice.worth, added, constant_values=np.inf)
        stays, target = one_branch.kept(x, edges, worth, np.pad(is_pinned, added))
        note = "the search for limbs ended early; branches that it did not try are kept"
        report = replace(report, notes=report.notes + (note,) * choice.was_hit)
    elif detail is None:
        stays, target = one_branch.prune(num, edges, one_branch.by_balls(x, skeleton.radii), least, is_pinned)
    else:
        raise ConfigError(
            f"detail is {detail!r}, and limbs are not known: expected a skeleton with its mesh, not made by "
            "wavefronts, and a slenderness above 0; leave detail out"
        )
    rank = np.cumsum(stays) - 1
    result = changed(skeleton, x[stays], rank[edges[stays[edges].all(axis=1)]], rank[target][:num])
    gone = skeleton.num_leaves + grown - result.num_leaves
    counts = {"pruned": report.pruned + gone, "grown": report.grown + grown, "notes": report.notes}
    return replace(result, report=replace(result.report, **counts))


def resampled(skeleton: "Skeleton", spacing: float) -> "Skeleton":
    """See `Skeleton.resample`."""
    _check_length("spacing", spacing, np.finfo(float).max)
    if skeleton.length > MOST_NODES * float(spacing):
        raise ConfigError(
            f"spacing is {spacing!r}, and the curve {skeleton.length:.3g} long: expected a spacing that gives at most "
            f"{MOST_NODES} nodes; is it in the mesh's units?"
        )
    solid = None if skeleton.source is None else skeleton.source.solid
    curve = resampling.resample(skeleton.vertices, skeleton.edges, spacing, _pinned(skeleton), solid)
    return changed(skeleton, *curve)


def smoothed(skeleton: "Skeleton", rounds: int) -> "Skeleton":
    """See `Skeleton.smooth`."""
    if isinstance(rounds, bool) or not isinstance(rounds, numbers.Integral) or rounds < 0:
        raise ConfigError(f"rounds is {rounds!r}: expected a whole number of 0 or more")
    solid, curve = None if skeleton.source is None else skeleton.source.solid, (skeleton.vertices, skeleton.edges)
    x, edges = resampling.smooth(*curve, skeleton.radii, int(rounds), _pinned(skeleton), solid)
    return changed(skeleton, x, edges, np.arange(len(x)))


def with_radii(skeleton: "Skeleton", of: str, balls: np.ndarray | None = None) -> "Skeleton":
    """See `Skeleton.with_radii`. ``balls`` (N,) are the radii of the largest inscribed balls, if they are known."""
    if of not in ("ball", "section"):
        raise ConfigError(f'of is {of!r}: expected "ball" or "section"')
    solid = known(skeleton.source).solid
    with_balls = replace(skeleton, radii=solid.radii(skeleton.vertices) if balls is None else balls, radius_of="ball")
    if of == "ball":
        return with_balls
    area = centrelines.node_columns(with_balls)["area"]
    radii = np.where(np.isfinite(area), np.sqrt(np.maximum(area, 0.0) / np.pi), with_balls.radii)
    return replace(with_balls, radii=radii, radius_of=of)


def simplified(skeleton: "Skeleton", tolerance: float) -> "Skeleton":
    """See `Skeleton.simplify`."""
    _check_length("tolerance", tolerance, np.finfo(float).max)
    num = len(skeleton.vertices)
    stays = _pinned(skeleton) | (np.bincount(skeleton.edges.ravel(), minlength=num) != 2)
    stays[list(skeleton.roots) + list(skeleton.openings)] = True
    chains, node_of_old = [np.empty((0, 2), dtype=np.int64)], np.arange(num)
    for path in graphs.trace(num, skeleton.edges):
        nodes = np.array(path)
        is_fixed = stays[nodes]
        is_fixed[[0, -1]] = True
        if nodes[0] == nodes[-1] and is_fixed[1:-1].sum() < 2:  # a loop needs three nodes
            is_fixed[[len(nodes) // 3, 2 * len(nodes) // 3]] = True
        places = _needed(skeleton.vertices[nodes], np.flatnonzero(is_fixed), float(tolerance))
        stays[nodes[places]] = True
        chains.append(np.stack([nodes[places[:-1]], nodes[places[1:]]], axis=1))
        node_of_old[nodes[1:-1]] = nodes[places[resampling.nearest_of(places, np.arange(1, len(nodes) - 1))]]
    rank = np.cumsum(stays) - 1
    return changed(skeleton, skeleton.vertices[stays], rank[np.concatenate(chains)], rank[node_of_old])


def _needed(points: np.ndarray, fixed: np.ndarray, tolerance: float) -> np.ndarray:
    """The places in ``points`` (n, 3) that stay, ascending: those of ``fixed``, and between them the fewest such that
    no point is farther than ``tolerance`` from the line, and of as few the ones nearest to it (Imai and Iri 1988).

    Tried are the points that Douglas and Peucker (1973) keep within a tenth of it.
    """
    chosen = set(fixed.tolist())
    for first, last in pairwise(fixed.tolist()):
        places = [first, *_far(points, first, last, TRIED * tolerance), last]
        best: list[tuple[int, float, int]] = [(0, 0.0, 0)]  # to each place: lines, their distances, the place before
        for k in range(1, len(places)):
            tried = []
            for j in range(k):
                away = _away(points[places[j] : places[k] + 1]).max()
                if away <= tolerance or j == k - 1:
                    tried.append((best[j][0] + 1, best[j][1] + float(away), j))
            best.append(min(tried))
        k = best[-1][2]
        while k > 0:
            chosen.add(places[k])
            k = best[k][2]
    return np.array(sorted(chosen))


def _far(points: np.ndarray, first: int, last: int, tolerance: float) -> list[int]:
    """The points between two that are farthest from the line, until none is farther than ``tolerance``."""
    farthest, stack = [], [(first, last)]
    while stack:
        a, b = stack.pop()
        away = _away(points[a : b + 1])
        if away.max() > tolerance:
            middle = a + int(away.argmax())
            farthest.append(middle)
            stack += [(a, middle), (middle, b)]
    return sorted(farthest)


def _away(points: np.ndarray) -> np.ndarray:
    """(n,) the distance of ``points`` (n, 3) from the segment between the first and the last."""
    along, offset = points[-1] - points[0], points - points[0]
    t = np.clip(offset @ along / max(float(along @ along), 1e-300), 0.0, 1.0)
    return np.linalg.norm(offset - t[:, None] * along, axis=1)


def soma_of(skeleton: "Skeleton") -> Soma:
    """See `Skeleton.soma`."""
    is_known = skeleton.radius_of == "ball" or skeleton.source is None
    balls = (skeleton if is_known else with_radii(skeleton, "ball")).radii
    node = int(balls.argmax())
    is_elsewhere = np.linalg.norm(skeleton.vertices - skeleton.vertices[node], axis=1) > SOMA_REACH * balls[node]
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
        inside=_share_inside(skeleton, skeleton.vertices, edges, skeleton.radii),
        notes=(*skeleton.report.notes, f"a tree: {loops} cut where thinnest{where}; {place}"),
        figures={},
    )
    return replace(skeleton, edges=edges, report=report, roots=roots)


def healed(skeleton: "Skeleton", reach: float) -> "Skeleton":
    """See `Skeleton.heal`."""
    _check_length("reach", reach)
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
        inside=_share_inside(skeleton, skeleton.vertices, edges, skeleton.radii),
        notes=(*skeleton.report.notes, f"healed: {count}, over gaps of up to {gap.max():.3g}, outside the mesh"),
        figures={},
    )
    return replace(skeleton, edges=edges, report=report, roots=skeleton.roots[:1])


def _links(vertices: np.ndarray, edges: np.ndarray, reach: float) -> np.ndarray:
    """(K, 2) shortest edges that join pieces within ``reach`` of each other, by Prim's algorithm from the piece with
    most nodes."""
    num = len(vertices)
    label = graphs.labels(num, *edges.T)
    is_left = np.ones(label.max() + 1, dtype=bool)
    away, nearest = np.full(num, np.inf), np.full(num, -1)
    links, piece = [], int(np.bincount(label).argmax())
    while True:
        is_left[piece] = False
        outside = np.flatnonzero(is_left[label])
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
